"""The page on what each key of the project file rests on, docs/evidence.md: made from the declarations of the keys."""

from __future__ import annotations

import json
from itertools import groupby
from types import NoneType
from typing import Annotated, Any, Literal, get_args, get_origin

from assess.declaration import Evidence
from assess.project.evidence import Key, every_key
from docs.ext.key_page import TITLES
from docs.ext.key_values import BOUNDS, PLAIN, default_words
from docs.ext.markdown import cell, escape
from docs.ext.schema_tables import is_table

HEAD = """# What each key rests on

Every value of a [project file](project-file.md) has a class, which says by whom it comes about, and a sense, which way
more of it makes the wall look safer: up, down, either way, or none. Of a choice whose values can be ordered all stand
here, from the one that helps least to the one that helps most. The class says what becomes of a value that helps and
that no source in `[report.sources]` vouches for ([the two states](verdict.md#the-two-states)).

| class | what it holds | rule |
|---|---|---|
| defines | sizes, materials, hazard, class of use | the case itself, as it is stated |
| drawn | places, heights, supports | compared with the bodies |
| chosen | basis, limit state, methods, works | other lawful choices that can be computed stand beside it |
| loads | what rests on the wall or pushes it | a variable load counts only where it hurts |
| code | factors that a code gives | the code's own value, with its outcome |
| measured | what a test, a survey or a manufacturer knows | a source, and a plausible range |
| action | the records, how they are chosen and scaled | as the rules of suites have it |
| clamped | steps, tolerances, samples | finer than the default |
| free | labels, texts, figures, studies beside the verdict | changes no outcome |

The tables below are made from the declarations of the keys. NAME is a name that you choose, `[]` each item of a list;
in brackets stand the forms of a table that have the key, where not all do. KEY is any number that may be given as
`{ mean, cov }`. What a key is, its choices and its unit are in the [reference of keys](reference/keys.md).
"""
COLUMNS = (
    "| key | value | default | class | helps | what stands in its place without a source |\n|---|---|---|---|---|---|"
)


def text() -> str:
    """Return the page as Markdown."""
    parts = [HEAD]
    for name, keys in groupby(every_key(), key=lambda key: key.path.split(".")[0] if "." in key.path else ""):
        heading = {"": TITLES["project"], "KEY": "A number that scatters"}.get(name, f"`[{name}]`")
        listed = list(keys)
        rows = [_row(key, above=before) for before, key in zip((None, *listed), listed, strict=False)]
        parts.append("\n".join([f"## {heading}", "", COLUMNS, *rows, ""]))
    return "\n".join(parts)


def _row(key: Key, *, above: Key | None) -> str:
    """Return the row of a key; why it is judged as it is, is not said again where the key above has the same."""
    evidence = key.evidence
    forms = f" ({', '.join(key.forms)})" if key.forms else ""
    said = ["–"] * 3
    if evidence is not None:
        judged = "as above" if above is not None and above.evidence == evidence else evidence.judged
        why = f" (judged: {judged})" if evidence.judged else ""
        said = [evidence.kind, _helps(evidence), escape(evidence.instead + why)]
    cells = (f"`{key.path}`{forms}", _value(key), default_words(key.field), *said)
    return "| " + " | ".join(map(cell, cells)) + " |"


def _helps(evidence: Evidence) -> str:
    """Return the sense of a key, or the values of a choice in their order."""
    if isinstance(evidence.helps, str):
        return evidence.helps
    return ", ".join(f"`{json.dumps(each)}`" for each in evidence.helps)


def _value(key: Key) -> str:
    bounds = [f"{BOUNDS[name]} {bound:.6g}" for name, bound in key.bounds.items()]
    words = {"": " or ".join(dict.fromkeys(_words(key.field.annotation))), "ratio": "number"}
    return ", ".join((words.get(key.dimension, key.dimension), *bounds))


def _words(annotation: Any) -> list[str]:
    """Return what a key may hold, in the shortest words."""
    origin, parts = get_origin(annotation), get_args(annotation)
    if origin is Annotated:
        return _words(parts[0])
    if origin is Literal:
        return ["a choice"]
    if parts:
        return [word for part in (parts[1:] if origin is dict else parts) for word in _words(part)]
    if annotation in (NoneType, Ellipsis):
        return []
    return ["table" if is_table(annotation) else PLAIN.get(annotation, "value").split(",")[0]]
