"""The patterns of quantities in the JSON Schema, so that an editor shows a wrong unit while the file is written.

They are made of the parts that `units` reads with and of pint's names. A pattern accepts whatever is read: what it
cannot judge, the product of several units or signs beyond a keyboard's, it leaves to the reader. Only constructions
that Python and ECMA 262 read alike are used.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from functools import cache
from typing import Any, Literal

from assess.project.quantity_text import NUMBER
from assess.project.units import (
    KINDS,
    SIGNS,
    Kind,
    has_dimension,
    name_pattern,
    prefixes_and_names,
    reads_unit,
    unit_pattern,
)
from assess.project.usual_units import AMBIGUOUS, USUAL

Form = Literal["quantity", "quantity or infinite", "change", "unit"]
MARK = "pattern of"
"""Stands in the schema of a marked key, with its kind and form, until `with_quantity_patterns` has replaced it."""
OF_ACCELERATION = ("g", "gal")
INFINITE = ("inf", "infinite")
SHARES = ("", "%", "percent", "permille")
"""The units of a change that is a share of a number, and no amount."""
_LETTER = "[A-Za-z]"
_PLAIN = re.compile(rf"{name_pattern(_LETTER)}|[{SIGNS}]")
_BEYOND_A_KEYBOARD = "[^ -~¹²³⁴⁻·°‰]"


@cache
def quantity_pattern(kind: str, form: Form = "quantity") -> str:
    """Return the pattern of a quantity of a kind in KINDS, of one that may be infinite, of a share or an amount by
    which it changes, or of its unit alone.
    """
    unit = _unit(KINDS[kind])
    if form == "unit":
        read = rf"\s*{unit}"
    elif KINDS[kind].unit == "dimensionless":
        read = rf"\s*{NUMBER}\s*(?:{unit})?"
    else:
        read = rf"\s*{NUMBER}\s*{unit}"
    either = [rf"{read}\s*", f".*{_BEYOND_A_KEYBOARD}.*"]
    if form == "quantity or infinite":
        either.append(rf"\s*{_any_case(INFINITE)}\s*")
    elif form == "change":
        either.append(rf"\s*{NUMBER}\s*{_any_of(SHARES)}\s*")
    return f"^(?:{'|'.join(either)})$"


def _unit(kind: Kind) -> str:
    """Return the pattern of a unit: a name of the kind, or a product, unless it is known as of another kind."""
    plain = rf"(?:{name_pattern(_LETTER)}|[{SIGNS}])\s*$"
    return rf"(?!{_any_of(_refused(kind))}\s*$)(?:{_names(kind)}|(?!{plain}){unit_pattern(_LETTER)})"


def _names(kind: Kind) -> str:
    """Return the pattern of the kind's names, with prefix and plural, and signs."""
    prefixes, names = (list(filter(str.isascii, each)) for each in prefixes_and_names(kind))
    single = [each for each in (*SIGNS, *USUAL.get(kind.name, {}), *OF_ACCELERATION) if _is_plain(each)]
    alone = dict.fromkeys(each for each in single if each not in names and reads_unit(each, kind))
    with_prefix = f"{_any_of(prefixes)}?{_any_of(names)}s?" if names else ""
    return "|".join(filter(None, (_any_of(alone) if alone else "", with_prefix)))


def _refused(kind: Kind) -> Iterator[str]:
    """Yield units that a pattern of the kind might take for one of it: usual ones of other kinds, ambiguous ones."""
    yield from (unit for unit in (*AMBIGUOUS, *OF_ACCELERATION) if not reads_unit(unit, kind))
    usual = dict.fromkeys(unit for units in USUAL.values() for unit in units)
    yield from (unit for unit in usual if not has_dimension(unit, kind))


def _is_plain(unit: str) -> bool:
    return _PLAIN.fullmatch(unit) is not None


def _any_of(texts: Iterable[str]) -> str:
    """Return the pattern of any of the texts; `re.escape` escapes signs that ECMA 262 does not allow to be escaped."""
    return "(?:" + "|".join(re.sub(r"([$()*+./?^{|}])", r"\\\1", text) for text in texts) + ")"


def _any_case(words: Iterable[str]) -> str:
    return "(?:" + "|".join("".join(f"[{c.lower()}{c.upper()}]" for c in word) for word in words) + ")"


def with_quantity_patterns(schema: dict[str, Any]) -> dict[str, Any]:
    """Return a JSON Schema in which every marked key refers to the definition of its quantity."""
    defined: dict[str, Any] = {}

    def refer(node: Any) -> Any:
        if isinstance(node, list):
            return [refer(each) for each in node]
        if not isinstance(node, dict):
            return node
        plain = {key: refer(each) for key, each in node.items() if key != MARK}
        if MARK not in node:
            return plain
        kind, form = node[MARK]
        name = f"{form} of {kind}".replace(" ", "-")
        defined[name] = {"type": plain.pop("type"), "pattern": quantity_pattern(kind, form)}
        return {"$ref": f"#/$defs/{name}", **plain}

    found = refer(schema)
    return {**found, "$defs": {**found["$defs"], **dict(sorted(defined.items()))}}
