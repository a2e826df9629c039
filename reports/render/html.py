"""The document as one page of HTML that needs nothing else: figures to enlarge, bodies to turn, tables to sort.

The page's frame, look and behaviour are in the folder web.
"""

from __future__ import annotations

import base64
import hashlib
from collections.abc import Mapping
from functools import cache
from importlib.resources import files
from pathlib import Path
from string import Template

from reports.document import Document, Section
from reports.language.lettering import truncate
from reports.render.elements import Elements, markup
from reports.render.svg import Picture

SCRIPTS = ("gestures.js", "picture.js", "model.js", "viewer.js", "tables.js")  # in the order they need each other
FRAME = {  # words of the frame of the page
    "to_report": "To the report",
    "contents_word": "Contents",
    "enlarge": "Enlarge",
    "turn": "Turn in 3D",
    "enlarged": "Figure, enlarged",
    "hint_shift": "Drag to shift, wheel or pinch to enlarge, double click to start again; keys: arrows, +, −, 0.",
    "hint_turn": "Drag to turn, with Shift or two fingers to shift, wheel or pinch to enlarge; keys: arrows, +, −, 0.",
    "larger": "Larger",
    "smaller": "Smaller",
    "reset": "Reset",
    "close": "Close",
    "stage": "Figure, to be moved by the arrow keys",
}
_LONGEST_TITLE, _LONGEST_HEADING = 120, 180


def write_html(document: Document, path: Path, *, pictures: Mapping[str, Picture]) -> Path:
    """Write the document to `path`; the path written. pictures: its figures by name."""
    elements = Elements(document, pictures)
    style, script = resource("report.css"), "\n".join(map(resource, SCRIPTS))
    page = Template(resource("page.html")).substitute(
        language=markup(document.language),
        **{name: markup(document.translate(text)) for name, text in FRAME.items()},
        policy=policy(style=style, script=script),
        program=markup(document.origin),
        title=markup(truncate(document.title, _LONGEST_TITLE)),
        subject=markup(document.subject),
        style=style,
        script=script,
        definitions="\n".join(_definitions(pictures).values()),
        facts=_facts(document),
        contents=_contents(document.sections),
        sections="\n".join(_section(section, place, elements) for place, section in enumerate(document.sections)),
    )
    path.write_text(page, encoding="utf-8", newline="\n")
    return path


def policy(*, style: str, script: str) -> str:
    """Return the content security policy of a page: this style sheet, this script, and nothing from elsewhere."""
    allowed = f"style-src '{_digest(style)}'; script-src '{_digest(script)}'; img-src data:"
    return f"default-src 'none'; {allowed}; base-uri 'none'; form-action 'none'"


@cache
def resource(name: str) -> str:
    """Return the text of a file of reports/render/web."""
    return files("reports.render").joinpath("web", name).read_text(encoding="utf-8")


def _digest(text: str) -> str:
    return "sha256-" + base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()


def _definitions(pictures: Mapping[str, Picture]) -> dict[str, str]:
    """Return letters and windows of all pictures, each once."""
    return {name: element for picture in pictures.values() for name, element in picture.definitions.items()}


def _facts(document: Document) -> str:
    pairs = "".join(f"<dt>{markup(label)}</dt><dd>{markup(text)}</dd>" for label, text in document.facts)
    return f"<dl>{pairs}</dl>" if pairs else ""


def _contents(sections: tuple[Section, ...]) -> str:
    """Return the headings as links, those of parts below their chapter's."""
    made, depth = [], -1
    for place, section in enumerate(sections):
        made += ["<ul>"] * (section.level - depth) if section.level > depth else []
        made += ["</li></ul>"] * (depth - section.level) + ["</li>"] if section.level <= depth else []
        made.append(f'<li><a href="#section-{place}">{_title(section)}</a>')
        depth = section.level
    return "\n".join([*made, *["</li></ul>"] * (depth + 1)])


def _section(section: Section, place: int, elements: Elements) -> str:
    rank = section.level + 2
    blocks = "\n".join(map(elements.of, section.blocks))
    return f'<section><h{rank} id="section-{place}">{_title(section)}</h{rank}>\n{blocks}</section>'


def _title(section: Section) -> str:
    return markup(truncate(section.title, _LONGEST_HEADING))
