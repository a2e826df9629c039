"""A JSON Schema whose faults lie at the key that is wrong.

Of an alternative of tables, `oneOf`, a validator says no more than that none of them fits, so that an editor underlines
the whole table. Where their keys tell the tables apart, the schema asks for them instead and has the faults of the one
that is meant.
"""

from __future__ import annotations

from typing import Any

_REFERENCE = "#/$defs/"


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
    signs = _signs(tables, [key for key in tables[0]["properties"] if all(_words(each, key) for each in tables)])
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
            sign["properties"] = {key: {"enum": _words(table, key)} for key in kinds}
            sign["required"] = [key for key in kinds if key in required]
        others = [*tables[:number], *tables[number + 1 :]] if not kinds else tables[number + 1 :]
        rivals = [each for each in others if all(set(_words(table, key)) & set(_words(each, key)) for key in kinds)]
        own = [key for key in properties if not any(key in each["properties"] for each in rivals)]
        if rivals and not set(own) & set(required):
            return None
        signs.append({**sign, "anyOf": [{"required": [key]} for key in own]} if rivals else sign)
    if not kinds:
        return [*signs, {"anyOf": list(signs)}]
    every = {key: {"enum": sorted({word for table in tables for word in _words(table, key)})} for key in kinds}
    return [*signs, {"properties": every, "required": kinds}]


def _words(table: dict[str, Any], key: str) -> list[str]:
    """Return the words that a key of a table takes; none for a key of another type."""
    found = table["properties"].get(key, {})
    return [found["const"]] if "const" in found else list(found.get("enum", ()))
