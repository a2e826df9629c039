"""Links to pages at the root of the repository, which the manual includes: they lead to the page that includes them.

`[…](../CHANGELOG.md)` works on the repository's web view as it stands; in the manual it becomes `changes.md`.
"""

from __future__ import annotations

import re

from sphinx.application import Sphinx

PAGES = {"CHANGELOG.md": "changes.md", "CONTRIBUTING.md": "contributing.md", "README.md": "index.md"}
LINK = re.compile(r"\]\(((?:\.\./)+)(" + "|".join(map(re.escape, PAGES)) + r")(#[\w-]+)?\)")


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the change of every page's source."""
    app.connect("source-read", change_page)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def change_page(app: Sphinx, name: str, source: list[str]) -> None:
    """Change the source of a page, as Sphinx reads it."""
    source[0] = manual_links(source[0], depth=name.count("/"))


def manual_links(text: str, *, depth: int) -> str:
    """Return the text of a page that lies `depth` folders below docs/, with links to the root led into the manual."""

    def change(match: re.Match[str]) -> str:
        up, page, heading = match.groups()
        if len(up) // 3 != depth + 1:
            return match[0]
        return f"]({up[3:]}{PAGES[page]}{heading or ''})"

    return LINK.sub(change, text)
