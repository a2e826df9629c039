"""Where values come from: what `[report.sources]` says of a key."""

from __future__ import annotations

from assess.project import sections

ASSUMED = "assumed"


def source_of(content: sections.Content, key: str) -> str:
    """The source of a key, or of a table that holds it, other than an assumption; empty where there is none."""
    given = (text for start, text in content.report.sources.items() if f"{key}.".startswith(f"{start}."))
    return next((text for text in given if text.partition(":")[0].strip() != ASSUMED), "")
