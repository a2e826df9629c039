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
from reports.language.texts import Phrase, say
from reports.render.elements import Elements, markup
from reports.render.frame_words import CONTENTS, origin
from reports.render.svg import Picture

SCRIPTS = (  # in the order they need each other
    "gestures.js",
    "picture.js",
    "model.js",
    "viewer.js",
    "tables.js",
    "sifting.js",
    "sideways.js",
    "contents.js",
)
FRAME: Mapping[str, Phrase] = {  # words of the frame of the page
    "to_report": say("To the report"),
    "contents_word": CONTENTS,
    "enlarge": say("Enlarge"),
    "turn": say("Turn in 3D"),
    "enlarged": say("Figure, enlarged"),
    "hint_shift": say("Drag to shift, wheel or pinch to enlarge, double click to start again; keys: arrows, +, −, 0."),
    "hint_turn": say(
        "Drag to turn, with Shift or two fingers to shift, wheel or pinch to enlarge; keys: arrows, +, −, 0."
    ),
    "outcome_word": say("Outcome"),
    "all_outcomes": say("all"),
    "words": say("With the words"),
    "every_row": say("show more than 1,000 rows"),
    "rows_found": say("Rows found:"),
    "larger": say("Larger"),
    "smaller": say("Smaller"),
    "reset": say("Reset"),
    "close": say("Close"),
    "stage": say("Figure, to be moved by the arrow keys"),
}
_LONGEST_TITLE, _LONGEST_HEADING = 120, 180


def write_html(document: Document, path: Path, *, pictures: Mapping[str, Picture]) -> Path:
    """Write the document to `path`; the path written. pictures: its figures by name."""
    elements = Elements(document, pictures)
    style, script = resource("report.css"), "\n".join(map(resource, SCRIPTS))
    opening, *rest = [_section(*each, elements) for each in enumerate(document.sections)] or [""]
    page = Template(resource("page.html")).substitute(
        **{name: elements.text(text) for name, text in FRAME.items()},
        language=markup(document.locale.language),
        policy=policy(style=style, script=script),
        program=elements.text(origin(document)),
        title=_short(elements.locale.text(document.title), _LONGEST_TITLE),
        subject=elements.text(document.subject),
        running=" · ".join(map(elements.text, document.running)),
        style=style,
        script=script,
        definitions="\n".join(_definitions(pictures).values()),
        logo="" if document.logo is None else elements.image(document.logo),
        facts=elements.facts(document.facts),
        contents=_contents(document.sections, elements),
        opening=opening,
        sections="\n".join(rest),
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


def _contents(sections: tuple[Section, ...], elements: Elements) -> str:
    """Return the headings as links, those of parts below their chapter's."""
    made, depth = [], -1
    for place, section in enumerate(sections):
        made += ["<ul>"] * (section.level - depth) if section.level > depth else []
        made += ["</li></ul>"] * (depth - section.level) + ["</li>"] if section.level <= depth else []
        made.append(f'<li><a href="#section-{place}">{_title(section, elements)}</a>')
        depth = section.level
    return "\n".join([*made, *["</li></ul>"] * (depth + 1)])


def _section(place: int, section: Section, elements: Elements) -> str:
    rank = section.level + 2
    blocks = "\n".join(map(elements.of, section.blocks))
    return f'<section><h{rank} id="section-{place}">{_title(section, elements)}</h{rank}>\n{blocks}</section>'


def _title(section: Section, elements: Elements) -> str:
    title = _short(elements.locale.text(section.title), _LONGEST_HEADING)
    return f'<span class="mark">{markup(section.mark)}</span> {title}' if section.mark else title


def _short(text: str, limit: int) -> str:
    return markup(truncate(text, limit))
