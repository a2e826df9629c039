"""Where values come from: what `[report.sources]` says of a key."""

from __future__ import annotations

from assess.project import sections

ASSUMED = "assumed"


def source_of(content: sections.Content, key: str) -> str:
    """Return the source of a key, or of a table that holds it, if it is not an assumption; else an empty text."""
    given = (text for start, text in content.report.sources.items() if f"{key}.".startswith(f"{start}."))
    return next((text for text in given if text.partition(":")[0].strip() != ASSUMED), "")
