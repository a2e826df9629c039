"""The tables [analysis.fragility] and [analysis.risk]: how likely mechanisms overturn, and how often."""

from __future__ import annotations

import re
from itertools import pairwise
from typing import Annotated, Any, Literal

from pydantic import AfterValidator, BeforeValidator, Field, StrictInt, WithJsonSchema, model_validator

from assess.project.quantities import (
    InputFile,
    Name,
    PositiveAcceleration,
    PositiveRatio,
    PositiveYears,
    Ratio,
    unique,
)
from assess.project.section import Section, quote_names, wrong
from assess.project.units import KINDS, key_value

PLAIN_MEASURES = ("pga", "pgv", "sa-average", "pga/(g tan alpha)", "p pgv/(g tan alpha)")
KIND_OF = {"pga": "acceleration", "sa": "acceleration", "sa-average": "acceleration", "pgv": "speed"}
"""The kind of quantity of a measure's intensities; the others are ratios."""
STATE_NAMES = ("rocking", "overturning")
_SA = re.compile(r"(sa|sa-average)\((.+)\)")
_WRITE = f'write one of {quote_names(PLAIN_MEASURES)}, or "sa(0.5 s)", "sa-average(0.2 s, 0.5 s, 1 s)"'


def measure_of(text: Any) -> tuple[str, tuple[float, ...]]:
    """Return the key of a measure and its periods [s]; raise ValueError for what is none.

    Parameters
    ----------
    text : such as "pga" or "sa(0.5 s)"
    """
    if text in PLAIN_MEASURES:
        return str(text), ()
    found = _SA.fullmatch(text) if isinstance(text, str) else None
    if found is None:
        raise ValueError(f"not a measure of intensity; {_WRITE}")
    periods = tuple(key_value(each.strip(), KINDS["time"]) for each in found[2].split(","))
    if any(not 0.0 < period <= 10.0 for period in periods):
        raise ValueError(f"a period is not above 0 and up to 10 s; {_WRITE}")
    if (found[1] == "sa") != (len(periods) == 1):
        raise ValueError(f"sa has one period, and sa-average several; {_WRITE}")
    return found[1], tuple(sorted(periods))


def _a_measure(text: Any) -> Any:
    measure_of(text)
    return text


def _a_state(value: Any) -> Any:
    if value in STATE_NAMES:
        return value
    if isinstance(value, bool) or not isinstance(value, int | float) or not 0.0 < value < 1.0:
        raise ValueError(
            f"not a state; write one of {quote_names(STATE_NAMES)}, or a share of the overturning rotation like 0.5"
        )
    return float(value)


Measure = Annotated[str, BeforeValidator(_a_measure)]
State = Annotated[
    str | float,
    BeforeValidator(_a_state),
    WithJsonSchema({"anyOf": [{"enum": list(STATE_NAMES)}, {"type": "number"}]}),
]


class Fragility(Section):
    """Fragility curves of `assess fragility`: measures of intensity, states, and how records are run."""

    measures: Annotated[tuple[Measure, ...], Field(min_length=1), AfterValidator(unique("measure"))] | None = None
    """measures of intensity, the one that records are scaled by first: "pga", "pgv", "sa(0.5 s)", "sa-average",
    "sa-average(0.2 s, 0.5 s, 1 s)", "pga/(g tan alpha)", "p pgv/(g tan alpha)"; all that apply if absent"""
    states: Annotated[tuple[State, ...], Field(min_length=1), AfterValidator(unique("state"))] = (
        "rocking",
        0.5,
        "overturning",
    )
    """states to be reached: "rocking", shares of the overturning rotation like 0.5, "overturning\""""
    method: Literal["ida", "stripes", "cloud"] = "ida"
    """"ida": every record at many rising scales; "stripes": all records at few intensities; "cloud": every record once,
    as it is, times [records] factor"""
    samples: Annotated[StrictInt, Field(ge=3, le=1000)] | None = None
    """intensities at which each record is run; 50 by ida and 10 by stripes if absent"""
    largest: float | str | None = None
    """largest intensity of the first measure, like "1.5 g"; if absent up to where every record overturns, twice in a
    row"""
    largest_factor: Annotated[Ratio, Field(ge=1, le=1000)] = 10.0
    """largest scale factor on a record; above 4 they are marked"""
    seed: Annotated[StrictInt, Field(ge=0)] = 1
    """of the bootstrap: the same seed gives the same intervals"""
    draws: Annotated[StrictInt, Field(ge=100, le=10_000)] = 500
    """draws of the bootstrap, by earthquake"""
    epistemic: dict[Name, Annotated[Ratio, Field(ge=0, le=2)]] = Field(default_factory=dict)
    """dispersions of what is not known, by name, like { model = 0.2 }; kept apart from that of the records. A target is
    met only with them: without any, no rate is shown to be within it"""

    @model_validator(mode="before")
    @classmethod
    def _largest_is_of_the_first_measure(cls, values: Any) -> Any:
        """Read the largest intensity in the unit of the measure that it belongs to."""
        if not isinstance(values, dict) or values.get("largest") is None:
            return values
        if values.get("method") == "cloud":
            raise wrong("largest", "a cloud runs every record once, as it is; remove it")
        measures = values.get("measures")
        first = measures[0] if isinstance(measures, list | tuple) and measures else "pga"
        try:
            number = key_value(values["largest"], KINDS[KIND_OF.get(measure_of(first)[0], "ratio")])
        except ValueError as error:
            raise wrong("largest", str(error)) from None
        if not number > 0.0:
            raise wrong("largest", f"{number:g}: must be above 0")
        return values | {"largest": number}

    @model_validator(mode="after")
    def _cloud_has_no_levels(self) -> Fragility:
        if self.method == "cloud" and self.samples is not None:
            raise wrong("samples", "a cloud runs every record once, as it is; remove it")
        return self


class HazardPoint(Section):
    """One row of the hazard of the site."""

    pga: PositiveAcceleration
    """peak ground acceleration, like "0.2 g\""""
    return_period: PositiveYears | None = None
    """mean return period, like 475; or give rate"""
    rate: PositiveRatio | None = None
    """annual rate of exceedance; or give return_period"""

    @model_validator(mode="after")
    def _one_of_both(self) -> HazardPoint:
        if (self.return_period is None) == (self.rate is None):
            raise wrong("return_period", "give either return_period or rate")
        return self

    @property
    def annual_rate(self) -> float:
        """Annual rate of exceedance [1/year]."""
        if self.rate is not None:
            return self.rate
        assert self.return_period is not None  # one of the two is given
        return 1.0 / self.return_period


class Place(Section):
    """A place on the earth."""

    longitude: Annotated[Ratio, Field(ge=-180, le=360)]
    """degrees east, like 13.40"""
    latitude: Annotated[Ratio, Field(ge=-90, le=90)]
    """degrees north, like 42.35"""


class Risk(Section):
    """Hazard of the site, which fragility makes a rate of: rows, a file, or the rows of an Italian site if absent."""

    hazard: Annotated[tuple[HazardPoint, ...], Field(min_length=2)] | None = None
    """rows [{ return_period | rate, pga }, …], of falling rate; those of [site.spectrum] if absent"""
    curve: InputFile | None = None
    """hazard curves of OpenQuake as CSV, like "hazard_curve-mean-PGA.csv", in place of hazard"""
    site: Place | None = None
    """{ longitude, latitude } in degrees: which site of `curve`, the nearest, at most 50 km away; needed where it holds
    several"""
    target: PositiveRatio | None = None
    """annual rate that the risk is compared with, like 2e-4"""

    @model_validator(mode="after")
    def _one_source(self) -> Risk:
        if self.hazard is not None and self.curve is not None:
            raise wrong("curve", "beside hazard; give one of them")
        if self.site is not None and self.curve is None:
            raise wrong("site", "only of curve; remove it")
        rows = self.hazard or ()
        for place, (low, high) in enumerate(pairwise(rows), start=1):
            if not (high.pga > low.pga and high.annual_rate < low.annual_rate):
                raise wrong(("hazard", place), "rows rise in pga and fall in rate; sort them")
        return self
