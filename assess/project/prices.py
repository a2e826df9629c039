"""Prices of works: of steel, of a tie with its plates, and of what is varied; those of the command before the file's.

A price is a number, for a kg, a tie, or the unit of the range; or a text with its currency and unit, like "4 EUR/kg",
"300 EUR" or "0.9 EUR/mm^2".
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from assess.errors import ProjectError
from assess.project.key_errors import value_text
from assess.project.ranges import unit_size
from assess.project.sections.content import Content
from assess.project.units import KINDS, NUMBER, QuantityError, QuantityKind
from assess.project.works import Axis, may_vary

PER_STEEL, PER_TIE = "steel", "tie"
MOST = 1e12
_PRICE = re.compile(rf"({NUMBER})\s*([^\s/\d]*)\s*(?:/\s*(\S.*?))?\s*")
IN_FILE = "analysis.retrofit.prices"


@dataclass(frozen=True)
class Prices:
    """What works cost.

    by_key : for each kg of "steel", each "tie", and each unit of change of a varied key; empty where steel counts
    currency : "" where none is named
    """

    by_key: Mapping[str, float]
    currency: str = ""

    def cost_of(self, axes: Sequence[Axis], values: Sequence[float], *, steel: float, ties: int) -> float | None:
        """Return the cost of a layout; None without prices.

        Parameters
        ----------
        axes, values : what is varied, and the values of the layout in their units
        steel : of its ties [kg]
        ties : their number
        """
        if not self.by_key:
            return None
        changes = {axis.key: abs(value - (axis.present or 0.0)) for axis, value in zip(axes, values, strict=True)}
        amounts = {PER_STEEL: steel, PER_TIE: float(ties), **changes}
        return sum(price * amounts[key] for key, price in self.by_key.items())


def prices_of(given: Mapping[str, float | str] | None, axes: Sequence[Axis], content: Content) -> Prices:
    """Return the prices of works.

    Parameters
    ----------
    given : with the command, each in place of that of the file; None for no prices, whatever the file has
    axes : what is varied
    content : of the project

    Raises
    ------
    ProjectError : a price of something else, of another unit, or in a second currency
    """
    if given is None:
        return Prices({})
    stated = {} if content.analysis.retrofit is None else content.analysis.retrofit.prices
    units = {PER_STEEL: ("kg", KINDS["mass"]), PER_TIE: ("", KINDS["ratio"])}
    units |= {axis.key: (axis.unit, axis.kind) for axis in axes}
    found: dict[str, float] = {}
    currencies: dict[str, str] = {}
    written = [(f"{IN_FILE}.{key}", key, price) for key, price in stated.items() if key not in given]
    for where, key, price in [*written, *((f"price {value_text(key)}", key, price) for key, price in given.items())]:
        number, currency, per = read_price(price, where=where)
        if key not in units:
            if where.startswith(IN_FILE) and may_vary(key, content):
                continue  # of works that are not asked for here
            raise ProjectError(f"{where} = {value_text(price)}: write a price of one of {', '.join(units)}")
        unit, kind = units[key]
        if per == "tie" and key == PER_TIE:
            per = ""
        found[key] = number * _share(per, unit, kind, where=f"{where} = {value_text(price)}")
        if currency:
            currencies.setdefault(currency, where)
    if len(currencies) > 1:
        (first, _), (second, where) = list(currencies.items())[:2]
        raise ProjectError(f"{where}: in {second}, where others are in {first}; write all in one currency")
    return Prices(found, next(iter(currencies), ""))


def read_price(price: float | str, *, where: str) -> tuple[float, str, str]:
    """Return the number of a price, its currency and the unit that it is for, "" where none is written.

    Raises
    ------
    ProjectError : it is no price from 0
    """
    match = _PRICE.fullmatch(price.strip()) if isinstance(price, str) else None
    number, currency, per = (match[1], match[2], match[3] or "") if match else (price, "", "")
    if (isinstance(number, str) and not match) or not 0.0 <= float(number) < MOST:
        raise ProjectError(f'{where} = {value_text(price)}: write a price from 0, such as 4 or "4 EUR/kg"')
    return float(number), currency, per


def _share(per: str, unit: str, kind: QuantityKind, *, where: str) -> float:
    """Return the size of one unit in another of a kind; `per` is that of a price, `unit` that of what it is for."""
    if not per or per == unit:
        return 1.0
    try:
        return unit_size(unit, kind) / unit_size(per, kind)
    except QuantityError:
        like = f"for each {unit}" if unit else "without a unit"
        raise ProjectError(f"{where}: {value_text(per)} does not measure that; write the price {like}") from None
