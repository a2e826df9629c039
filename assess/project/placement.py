"""Loads placed at the top of a wall, or by a share of its height, where the rows of a table change that height."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from assess.errors import ProjectError
from assess.project.units import KINDS, QuantityError, key_value


def elevation_at(tables: Mapping[str, Any], mechanism: str, share: float) -> float:
    """Return the elevation [m] at a share of the height of a mechanism's bodies, from the lowest foot to the top.

    Parameters
    ----------
    tables : of the project
    mechanism : its name
    share : 0 at the foot, 1 at the top [-]

    Raises
    ------
    ProjectError : a body is given by neither a box nor a profile, or a length of it cannot be read
    """
    ends = [end for name in _names(tables["mechanisms"][mechanism].get("blocks")) for end in _ends(tables, name)]
    if not ends:
        raise ProjectError(f'mechanisms.{mechanism}: no bodies; a share of the height needs "blocks"')
    return min(ends) + share * (max(ends) - min(ends))


def _names(blocks: Any) -> Iterator[str]:
    """Yield the names of bodies, some of them in rows that move as one."""
    for each in blocks if isinstance(blocks, list) else ():
        yield from _names(each) if isinstance(each, list) else (str(each),)


def _ends(tables: Mapping[str, Any], name: str) -> tuple[float, ...]:
    """Return elevations of a body, those of its foot and top among them [m]."""
    body = tables.get("bodies", {}).get(name)
    length = KINDS["length"]
    try:
        match body:
            case {"box": {"height": height, **rest}}:
                base: Any = rest.get("base", [0.0, 0.0, 0.0])
                foot = key_value(base[-1], length)
                return foot, foot + key_value(height, length)
            case {"profile": [*corners]}:
                return tuple(key_value(corner[1], length) for corner in corners)
    except (QuantityError, LookupError, TypeError) as error:
        raise ProjectError(f"bodies.{name}: {error}") from None
    raise ProjectError(
        f"bodies.{name}: a load by a share of the height needs its bodies as box or profile; give numbers"
    )
