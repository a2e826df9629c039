"""The JSON Schema of the project file, by which an editor shows a wrong unit or key while the file is written.

The patterns of quantities are made of the parts that `units` reads with and of pint's names. A pattern accepts whatever
is read: what it cannot judge, the product of several units or signs beyond a keyboard's, it leaves to the reader. Only
constructions that Python and ECMA 262 read alike are used.

Faults lie at the key that is wrong. Of an alternative of tables, `oneOf`, a validator says no more than that none of
them fits, so that an editor underlines the whole table. Where their keys tell the tables apart, the schema asks for
them instead and has the faults of the one that is meant.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator
from functools import cache
from typing import Any

from assess.project.sections.content import Content
from assess.project.units import (
    AMBIGUOUS,
    KINDS,
    NUMBER,
    SIGNS,
    USUAL,
    Kind,
    has_dimension,
    name_pattern,
    prefixes_and_names,
    reads_unit,
    unit_pattern,
)
from assess.project.values import (
    INFINITE,
    PATTERN_MARK,
    SHARE_UNITS,
    UNCERTAIN_MARK,
    QuantityForm,
    UncertainNumber,
    quantity_schema,
)

TITLE = "Project file of assess"
"""Title of the schema, by which its file is known."""
_REFERENCE = "#/$defs/"
OF_ACCELERATION = ("g", "gal")
_LETTER = "[A-Za-z]"
_PLAIN = re.compile(rf"{name_pattern(_LETTER)}|[{SIGNS}]")
_BEYOND_A_KEYBOARD = "[^ -~¹²³⁴⁻·°‰]"


def schema_text() -> str:
    """Return the JSON Schema of the project file as the text of a file."""
    return json.dumps(json_schema(), indent=2, ensure_ascii=False) + "\n"


def json_schema() -> dict[str, Any]:
    """Return the JSON Schema (draft 2020-12) of the project file."""
    head = {"$schema": "https://json-schema.org/draft/2020-12/schema", "title": TITLE}
    found = with_quantity_patterns(with_uncertain_numbers(Content.model_json_schema()))
    return {**with_located_faults(found), **head}


def with_uncertain_numbers(schema: dict[str, Any]) -> dict[str, Any]:
    """Return the JSON Schema of a project file with { mean, cov } allowed at every key that is marked."""
    defined: dict[str, Any] = {}

    def allow(node: Any) -> Any:
        if isinstance(node, list):
            return [allow(each) for each in node]
        if not isinstance(node, dict):
            return node
        plain = {key: allow(each) for key, each in node.items() if key != UNCERTAIN_MARK}
        if UNCERTAIN_MARK not in node:
            return plain
        kept = {key: plain.pop(key) for key in ("description", "title", "default") if key in plain}
        kind = _quantity_kind(plain)
        name = f"{UncertainNumber.__name__}-of-{kind}".replace(" ", "-")
        defined[name] = _uncertain_number_schema(kind)
        return {"anyOf": [plain, {"$ref": f"#/$defs/{name}"}], **kept} if plain else kept

    found = allow(schema)
    return {**found, "$defs": {**found["$defs"], **dict(sorted(defined.items()))}}


def _quantity_kind(node: dict[str, Any]) -> str:
    """Return the kind of quantity that a key holds, a ratio where it has no unit, as a restitution."""
    marks = (each[PATTERN_MARK] for each in (node, *node.get("anyOf", ())) if PATTERN_MARK in each)
    kind: str = next(marks, ("ratio",))[0]
    return kind


def _uncertain_number_schema(kind: str) -> dict[str, Any]:
    """Return the schema of an uncertain number of a kind of quantity."""
    schema = UncertainNumber.model_json_schema()
    mean, sd = (schema["properties"][key] for key in ("mean", "sd"))
    mean.update(quantity_schema(kind))
    sd["anyOf"][0].update(quantity_schema(kind))
    return schema


def with_quantity_patterns(schema: dict[str, Any]) -> dict[str, Any]:
    """Return a JSON Schema in which every marked key refers to the definition of its quantity."""
    defined: dict[str, Any] = {}

    def refer(node: Any) -> Any:
        if isinstance(node, list):
            return [refer(each) for each in node]
        if not isinstance(node, dict):
            return node
        plain = {key: refer(each) for key, each in node.items() if key != PATTERN_MARK}
        if PATTERN_MARK not in node:
            return plain
        kind, form = node[PATTERN_MARK]
        name = f"{form} of {kind}".replace(" ", "-")
        defined[name] = {"type": plain.pop("type"), "pattern": quantity_pattern(kind, form)}
        return {"$ref": f"#/$defs/{name}", **plain}

    found = refer(schema)
    return {**found, "$defs": {**found["$defs"], **dict(sorted(defined.items()))}}


@cache
def quantity_pattern(kind: str, form: QuantityForm = "quantity") -> str:
    """Return the pattern of a quantity of a kind in KINDS, of one that may be infinite, of a share or an amount by
    which it changes, or of its unit alone.
    """
    unit = _unit_pattern(KINDS[kind])
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
        either.append(rf"\s*{NUMBER}\s*{_any_of(SHARE_UNITS)}\s*")
    return f"^(?:{'|'.join(either)})$"


def _unit_pattern(kind: Kind) -> str:
    """Return the pattern of a unit: a name of the kind, or a product, unless it is known as of another kind."""
    plain = rf"(?:{name_pattern(_LETTER)}|[{SIGNS}])\s*$"
    return rf"(?!{_any_of(_refused_units(kind))}\s*$)(?:{_names_pattern(kind)}|(?!{plain}){unit_pattern(_LETTER)})"


def _names_pattern(kind: Kind) -> str:
    """Return the pattern of the kind's names, with prefix and plural, and signs."""
    prefixes, names = (list(filter(str.isascii, each)) for each in prefixes_and_names(kind))
    single = [each for each in (*SIGNS, *USUAL.get(kind.name, {}), *OF_ACCELERATION) if _is_plain(each)]
    alone = dict.fromkeys(each for each in single if each not in names and reads_unit(each, kind))
    with_prefix = f"{_any_of(prefixes)}?{_any_of(names)}s?" if names else ""
    return "|".join(filter(None, (_any_of(alone) if alone else "", with_prefix)))


def _refused_units(kind: Kind) -> Iterator[str]:
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


def with_located_faults(schema: dict[str, Any]) -> dict[str, Any]:
    """Return a JSON Schema of a TOML file that accepts the same, and whose faults lie as deep as they can.

    TOML has no null: an alternative of one schema and null is that schema, and a default of null is none.
    """
    definitions = schema["$defs"]

    def locate(node: Any) -> Any:
        if isinstance(node, list):
            return [locate(each) for each in node]
        if not isinstance(node, dict):
            return node
        plain = {key: locate(each) for key, each in node.items() if (key, each) != ("default", None)}
        return _without_choice(_without_null(plain), definitions)

    return {key: locate(each) for key, each in schema.items()}


def _without_null(node: dict[str, Any]) -> dict[str, Any]:
    choices = node.get("anyOf")
    if not isinstance(choices, list) or {"type": "null"} not in choices:
        return node
    left = [each for each in choices if each != {"type": "null"}]
    return (
        {**left[0], **{key: node[key] for key in node if key != "anyOf"}} if len(left) == 1 else node | {"anyOf": left}
    )


def _without_choice(node: dict[str, Any], definitions: dict[str, Any]) -> dict[str, Any]:
    """Return `node` with the tables of its `oneOf` told apart by their keys; as it is where these do not tell.

    The tables stand in an `anyOf` that accepts anything beside: editors take the keys they offer from there.
    """
    choices = node.get("oneOf", ())
    if not choices or not all(set(each) == {"$ref"} for each in choices):
        return node
    tables = [definitions[each["$ref"].removeprefix(_REFERENCE)] for each in choices]
    if not all("properties" in table for table in tables):
        return node
    signs = _signs(tables, [key for key in tables[0]["properties"] if all(_words_of_key(each, key) for each in tables)])
    if signs is None:
        return node
    found = signs[-1]
    for sign, choice in reversed(list(zip(signs, choices, strict=False))):
        found = {"if": sign, "then": choice, "else": found}
    return {**{key: node[key] for key in node if key != "oneOf"}, **found, "anyOf": [*choices, {}]}


def _signs(tables: list[dict[str, Any]], kinds: list[str]) -> list[dict[str, Any]] | None:
    """Return for each table a schema that it meets and no later one does; at the end, one for what meets none.

    Parameters
    ----------
    tables : the schemas of tables
    kinds : keys that take one word or a few in each of them, like `kind`

    Returns
    -------
    None where no key tells a table from the later ones
    """
    signs: list[dict[str, Any]] = []
    for number, table in enumerate(tables):
        required, properties = table.get("required", ()), table["properties"]
        sign: dict[str, Any] = {}
        if kinds:
            sign["properties"] = {key: {"enum": _words_of_key(table, key)} for key in kinds}
            sign["required"] = [key for key in kinds if key in required]
        others = [*tables[:number], *tables[number + 1 :]] if not kinds else tables[number + 1 :]
        rivals = [
            each
            for each in others
            if all(set(_words_of_key(table, key)) & set(_words_of_key(each, key)) for key in kinds)
        ]
        own = [key for key in properties if not any(key in each["properties"] for each in rivals)]
        if rivals and not set(own) & set(required):
            return None
        signs.append({**sign, "anyOf": [{"required": [key]} for key in own]} if rivals else sign)
    if not kinds:
        return [*signs, {"anyOf": list(signs)}]
    every = {key: {"enum": sorted({word for table in tables for word in _words_of_key(table, key)})} for key in kinds}
    return [*signs, {"properties": every, "required": kinds}]


def _words_of_key(table: dict[str, Any], key: str) -> list[str]:
    """Return the words that a key of a table takes; none for a key of another type."""
    found = table["properties"].get(key, {})
    return [found["const"]] if "const" in found else list(found.get("enum", ()))
