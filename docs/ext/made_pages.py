"""Pages that are made from the program before the manual is read, into docs/made, which no commit holds.

A page is written only if it has changed, so that a second build reads only what is new.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from sphinx.application import Sphinx

from docs.ext import command_pages, gallery, key_pages, name_pages

MADE = "made"
MAKERS: dict[str, Callable[[], dict[str, str]]] = {
    "keys": key_pages.pages,
    "commands": command_pages.pages,
    "names": name_pages.pages,
    "gallery": gallery.pages,
}


def setup(app: Sphinx) -> dict[str, bool]:
    """Make the pages before Sphinx looks for them."""
    app.connect("builder-inited", lambda app: write_pages(Path(app.srcdir) / MADE))
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def write_pages(folder: Path) -> None:
    """Write every page into a folder, and remove what earlier builds left there."""
    made = {folder / name: text for make in MAKERS.values() for name, text in make().items()}
    for path, text in made.items():
        path.parent.mkdir(parents=True, exist_ok=True)
        if not path.exists() or path.read_text(encoding="utf-8") != text:
            path.write_text(text, encoding="utf-8")
    for old in {path for path in folder.rglob("*.*") if path.is_file()} - set(made):
        old.unlink()
