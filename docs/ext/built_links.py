"""Links of the manual as built: those within it lead to a file and an anchor that exist; those outside are listed.

Usage: python -m docs.ext.built_links FOLDER        the folder of HTML
"""

from __future__ import annotations

import sys
from collections import defaultdict
from dataclasses import dataclass, field
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urldefrag

ADDRESSES = {"a": "href", "img": "src", "link": "href", "script": "src"}


@dataclass
class Page(HTMLParser):
    """The anchors of a page, and where its links lead."""

    anchors: set[str] = field(default_factory=set)
    links: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        super().__init__()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Take the anchor and the link of an element."""
        given = dict(attrs)
        self.anchors |= {value for key in ("id", "name") if (value := given.get(key))}
        if (address := given.get(ADDRESSES.get(tag, ""))) is not None:
            self.links.append(address)


def read_pages(folder: Path) -> dict[Path, Page]:
    """Return every page of a folder by its path."""
    found = {}
    for path in sorted(folder.rglob("*.html")):
        found[path.resolve()] = page = Page()
        page.feed(path.read_text(encoding="utf-8"))
    return found


def is_external(address: str) -> bool:
    """Return whether an address is none of this manual's files."""
    return address.startswith(("http:", "https:", "mailto:", "data:", "//"))


def broken_links(pages: dict[Path, Page]) -> list[str]:
    """Return the links within the manual that lead nowhere, each with its page."""
    return [
        f"{path.name}: {address}"
        for path, page in pages.items()
        for address in page.links
        if not is_external(address) and not _is_there(path, address, pages)
    ]


def _is_there(path: Path, address: str, pages: dict[Path, Page]) -> bool:
    file, anchor = urldefrag(address)
    target = (path.parent / unquote(file.partition("?")[0])).resolve() if file else path
    if not target.exists():
        return False
    return not anchor or target not in pages or unquote(anchor) in pages[target].anchors


def external_links(pages: dict[Path, Page]) -> dict[str, list[str]]:
    """Return the addresses outside the manual, each with the pages that name it."""
    found: dict[str, list[str]] = defaultdict(list)
    for path, page in pages.items():
        for address in dict.fromkeys(page.links):
            if address.startswith(("http:", "https:", "//")):
                found[address].append(path.stem)
    return dict(sorted(found.items()))


def main(folder: Path) -> int:
    """Print external links and broken ones; return the exit code."""
    pages = read_pages(folder)
    for address, names in external_links(pages).items():
        print(f"outside: {address} ({len(names)} pages)")
    broken = broken_links(pages)
    print(
        "\n".join(f"broken: {each}" for each in broken) or f"{len(pages)} pages, every link within them leads somewhere"
    )
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
