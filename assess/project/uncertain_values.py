"""Numbers of the project file given as { mean, cov }: found in the file, replaced by their means, checked.

The schema sees the means alone, so that whatever does not ask for the scatter uses them.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import inf, isfinite, sqrt
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from assess.errors import ProjectError
from assess.project.key_text import error_line, key_text, value_text
from assess.project.keys import Key, Place, places_of, value_at
from assess.project.quantity_text import QuantityError
from assess.project.sections.content import Content
from assess.project.sections.restitution import Restitution
from assess.project.sections.uncertain_number import UncertainNumber
from assess.project.units import KINDS, Kind, key_value
from assess.results.uncertainty import Distribution, UncertainInput

LISTED = (
    "sizes of boxes, lengths of profiles, hinges, densities, moduli and strengths of materials, friction, stiffness, "
    "strength and sizes of joints, masses and forces of loads and ties, restitution, p and uplift of equivalent "
    "blocks, and the building's period"
)
APART = ("analysis", "report", "format")
"""Tables without numbers that may scatter."""


@dataclass(frozen=True)
class UncertainValue:
    """A number of the project that scatters.

    path : its key; given : its mean, scatter and group in SI; least, most : physical limits of its values over the mean
    """

    path: Key
    given: UncertainInput
    least: float
    most: float


Stated = tuple[tuple[Key, UncertainNumber], ...]


def take_means(raw: Mapping[str, Any], folder: Path) -> tuple[dict[str, Any], Stated]:
    """Return what the file says with the mean in place of each uncertain number, and these numbers.

    Raises ProjectError for a table with a mean that is none of an uncertain number.
    """
    found: list[tuple[Key, UncertainNumber]] = []

    def plain(value: Any, path: Key) -> Any:
        if isinstance(value, list):
            return [plain(item, (*path, place)) for place, item in enumerate(value)]
        if not isinstance(value, Mapping):
            return value
        if not _is_uncertain(value):
            return {name: plain(item, (*path, name)) for name, item in value.items()}
        found.append((path, _read(value, path, raw, folder)))
        return value["mean"]

    means = {name: table if name in APART else plain(table, (name,)) for name, table in raw.items()}
    return means, tuple(found)


def _is_uncertain(table: Mapping[str, Any]) -> bool:
    """Whether a table is meant as a number with its scatter; tables named "mean" are not."""
    return any(key in table and not isinstance(table[key], Mapping) for key in ("mean", "cov"))


def _read(table: Mapping[str, Any], path: Key, raw: Mapping[str, Any], folder: Path) -> UncertainNumber:
    try:
        return UncertainNumber.model_validate(table, context={"folder": folder})
    except ValidationError as error:
        said = error_line(error, raw=table)
        raise ProjectError(f"{key_text(path)}.{said}") from None


def uncertain_values(content: Content, stated: Stated) -> tuple[UncertainValue, ...]:
    """Return the uncertain numbers of a project in SI.

    Raises ProjectError for a key whose number may not scatter, and for a scatter without meaning.
    """
    if not stated:
        return ()
    places = places_of(content)
    return tuple(_value(path, number, places, content) for path, number in stated)


def _value(path: Key, number: UncertainNumber, places: Mapping[str, Place], content: Content) -> UncertainValue:
    key, place = key_text(path), places.get(".".join(map(str, path)))
    if place is None or place.uncertain is None:
        raise ProjectError(f"{key}: must be one number; only these may be {{ mean, cov }}: {LISTED}")
    mean = si_mean(content, path)
    if not isinstance(mean, float) or mean == 0.0 or not isfinite(mean):
        raise ProjectError(f"{key}.mean: {value_text(number.mean)}: no number to scatter about; write it without cov")
    kind = place.kind or KINDS["ratio"]
    limits = place.uncertain
    cov = number.cov if number.cov is not None else _share(number, mean, kind, key)
    distribution: Distribution = number.distribution or ("normal" if limits.crosses_zero else "lognormal")
    if not limits.crosses_zero:
        _check_positive(distribution, cov, key)
    unit = kind.symbol.replace("no unit", "-")
    given = UncertainInput(key, unit, mean, cov, distribution, number.group or key)
    return UncertainValue(path, given, -inf if limits.crosses_zero else 0.0, limits.most / abs(mean))


def si_mean(content: Content, path: Key) -> Any:
    """Return the number at a key [SI]; of a restitution that of both directions."""
    value = value_at(content, path)
    return value.positive if isinstance(value, Restitution) else value


def _share(number: UncertainNumber, mean: float, kind: Kind, key: str) -> float:
    """Return the coefficient of variation of a number given by its standard deviation."""
    try:
        deviation = key_value(number.sd, kind)
    except QuantityError as error:
        raise ProjectError(f"{key}.sd: {value_text(number.sd)}: {error}") from None
    if not 0.0 < deviation < inf:
        raise ProjectError(f"{key}.sd: {value_text(number.sd)}: must be greater than 0; write the number without it")
    return deviation / abs(mean)


def _check_positive(distribution: Distribution, cov: float, key: str) -> None:
    """Refuse a scatter too large for a number that keeps its sign."""
    if cov >= 1.0:
        raise ProjectError(
            f"{key}.sd: {cov:.4g} times the mean: must be less than the mean of a number that keeps its sign"
        )
    if distribution == "uniform" and cov >= 1.0 / sqrt(3.0):
        remedy = "write less than 0.577, or another distribution"
        raise ProjectError(f"{key}.cov: {cov:.4g}: its lower bound, mean (1 - √3 cov), is beyond zero; {remedy}")


def covs_of(values: tuple[UncertainValue, ...]) -> dict[str, float]:
    """Return the coefficient of variation of each uncertain number, by its key written with dots."""
    return {".".join(map(str, value.path)): value.given.cov for value in values}
