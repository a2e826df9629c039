"""The pages of the manual that are made from the program: committed, so that they read without a build.

make pages        writes them again, as the program is now
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from docs.ext import command_page, evidence_page, key_page, name_page

DOCS = Path(__file__).resolve().parents[1]
PAGES: dict[Path, Callable[[], str]] = {
    DOCS / "evidence.md": evidence_page.text,
    DOCS / "reference" / "keys.md": key_page.text,
    DOCS / "reference" / "commands.md": command_page.text,
    DOCS / "reference" / "names.md": name_page.text,
}
"""Each page with the function that makes its text."""


if __name__ == "__main__":
    for path, make in PAGES.items():
        path.write_text(make(), encoding="utf-8", newline="\n")
