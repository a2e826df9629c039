"""The table [analysis]: levels, envelopes, parametric studies, sensitivity, uncertainty, fragility and risk."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from itertools import pairwise
from typing import Annotated, Any, Literal, NamedTuple

from pydantic import (
    AfterValidator,
    BeforeValidator,
    Discriminator,
    Field,
    StrictBool,
    StrictStr,
    Tag,
    WithJsonSchema,
    model_validator,
)

from assess.declaration import (
    FREE,
    Angle,
    Evidence,
    Name,
    Number,
    PositiveAcceleration,
    PositiveFrequency,
    PositiveRatio,
    PositiveYears,
    Several,
)
from assess.project.key_errors import error_at, quote_names
from assess.project.section import SCATTER, OrValue, ProjectSection
from assess.project.sections.procedures import ProcedureNames
from assess.project.units import KINDS, SHARE_UNITS, QuantityError, key_value, number_and_unit
from assess.project.values import PATTERN_MARK, WRITTEN_QUANTITY_SCHEMA, InputFile, number_or_text
from spectra.gravity import g

MOST_PULSES = 1000  # frequencies or amplitudes
WITH_GAMMA = "mavroeidis-papageorgiou"


class Frequencies(ProjectSection):
    """The frequencies of the pulses: { from, to, count }."""

    evidence = FREE

    start: PositiveFrequency = Field(0.2, alias="from")
    """the first"""
    to: PositiveFrequency = 10.0
    """the last"""
    count: Annotated[int, Number(least=2, most=MOST_PULSES)] = 100
    """how many, with both ends"""
    spacing: Literal["linear", "log"] = "linear"
    """"linear", or "log" for a constant ratio"""

    @model_validator(mode="after")
    def _rise(self) -> Frequencies:
        if not self.to > self.start:
            raise error_at("to", f"{self.to:g} Hz, not above from, {self.start:g} Hz; frequencies rise")
        return self


class Amplitudes(ProjectSection):
    """The peak accelerations of the pulses: { from, to, count }."""

    evidence = FREE

    start: Annotated[float, Number("acceleration", least=0)] = Field(0.0, alias="from")
    """the first"""
    to: Annotated[float, Number("acceleration", above=0)] = 3 * g
    """the last, up to which the least pulse that overturns is sought"""
    count: Annotated[int, Number(least=2, most=MOST_PULSES)] = 100
    """how many, with both ends"""

    @model_validator(mode="after")
    def _rise(self) -> Amplitudes:
        if not self.to > self.start:
            raise error_at("to", f"{self.to / g:g} g, not above from, {self.start / g:g} g; amplitudes rise")
        return self


class Pulses(ProjectSection):
    """Overturning envelopes: pulses of the ground by frequency and amplitude; without this table `run` makes none."""

    evidence = FREE

    shape: Literal["sine", "cosine", "half-sine", "ricker", "ricker-antisymmetric", "mavroeidis-papageorgiou"] = "sine"
    """shape of the acceleration"""
    frequency: Frequencies = Field(default_factory=Frequencies)
    """{ from, to, count } of the frequencies"""
    amplitude: Amplitudes = Field(default_factory=Amplitudes)
    """{ from, to, count } of the peak ground accelerations"""
    gamma: Annotated[float, Number("ratio", above=1, most=50)] | None = None
    """of a mavroeidis-papageorgiou pulse: more is longer; 2 if absent"""
    nu: Angle | None = None
    """of a mavroeidis-papageorgiou pulse: phase of its carrier; 0 if absent"""

    @model_validator(mode="after")
    def _only_one_shape_has_parameters(self) -> Pulses:
        for key in ("gamma", "nu"):
            if getattr(self, key) is not None and self.shape != WITH_GAMMA:
                raise error_at(key, f'not of a pulse "{self.shape}"; only "{WITH_GAMMA}" has it, remove it')
        return self


MOST_CASES = 1000  # cases of one sweep


SweptQuantity = Annotated[
    int | float | str, number_or_text("write one as at the key that is swept"), WRITTEN_QUANTITY_SCHEMA
]


class SweepSection(ProjectSection):
    """A parametric study: the mechanisms that one number of the project changes, for each of several values of it."""

    evidence = Evidence(
        "chosen",
        "either",
        "the value typed at the key counts beside the cases, and the worst of all decides",
        judged="the worst of the cases decides",
    )

    key: StrictStr
    """a number of this file by its key: "mechanisms.spire.cut.angle"; loads.0 or loads[1] is the first of a list"""
    values: Annotated[tuple[SweptQuantity, ...], Several(1, MOST_CASES, unlike="value")] = ()
    """its values, like ["45 deg", "60 deg"]; or give from, to and count"""
    start: SweptQuantity | None = Field(None, alias="from")
    """the first of evenly spaced values"""
    to: SweptQuantity | None = None
    """the last of them"""
    count: Annotated[int, Number(least=2, most=MOST_CASES)] | None = None
    """how many, with both ends"""

    @model_validator(mode="after")
    def _values_or_range(self) -> SweepSection:
        given = {"from": self.start, "to": self.to, "count": self.count}
        absent = [key for key, value in given.items() if value is None]
        if self.values and len(absent) < len(given):
            raise error_at("values", "beside from, to or count; give either the values or a range")
        if not self.values and absent:
            raise error_at(absent[0], "missing; give values = [ … ], or from, to and count")
        return self


def _sweeps_tag(value: Any) -> str:
    return "<several>" if isinstance(value, list | tuple) else "<one>"


Sweeps = Annotated[
    Annotated[SweepSection, Tag("<one>")] | Annotated[tuple[SweepSection, ...], Tag("<several>")],
    Discriminator(_sweeps_tag),
]
SHARE = "share"
DEFAULT_SHARES: Mapping[str, float] = {
    "thickness": 0.05,
    "density": 0.10,
    "compressive_strength": 0.30,
    "stiffness": 0.50,
    "friction": 0.20,
    "restitution": 0.05,
    "tie_force": 0.20,
    "loads": 0.20,
    "uplift": 0.05,
    "p": 0.05,
}
"""By how much each parameter is varied where the project does not say it: judgement, not taken from a standard."""
VaryingShare = Annotated[float, Number("ratio", least=0, below=1)]


class Change(NamedTuple):
    """By how much a number is varied to either side: by a share of it, or by an amount in the SI unit `of`."""

    by: float
    of: str = SHARE


def _change(kind: str) -> Callable[[Any], Any]:
    """Return a reader of one change: a share, an amount with the unit of `kind`, or false for none."""

    def read(value: Any) -> Any:
        if value is False or value is None or isinstance(value, Change):
            return value or None
        try:
            absolute = isinstance(value, str) and number_and_unit(value)[1] not in SHARE_UNITS
            found = Change(key_value(value, KINDS[kind]), KINDS[kind].symbol) if absolute else _share(value)
        except QuantityError:
            raise ValueError(f'not a change; write a share like 0.05 or "5 %"{_or_amount(kind)}, or false') from None
        if found.by < 0:
            raise ValueError("must be 0 or more; it counts to both sides")
        return found

    return read


def _share(value: Any) -> Change:
    share = key_value(value, KINDS["ratio"])
    if share >= 1:
        raise ValueError("must be less than 1; a share of 1 leaves nothing of the number")
    return Change(share)


def _or_amount(kind: str) -> str:
    """Say what may be written besides a share."""
    return "" if kind == "ratio" else f', or an amount like "{KINDS[kind].example}"'


def _change_schema(kind: str) -> WithJsonSchema:
    words = f"a share like 0.05{_or_amount(kind)}; false: not varied"
    return WithJsonSchema(
        {"type": ["number", "string", "boolean"], "description": words, PATTERN_MARK: [kind, "change"]}
    )


def _default_share(parameter: str) -> Any:
    def share(values: dict[str, Any]) -> Change:
        everywhere = values.get("vary")
        return Change(DEFAULT_SHARES[parameter] if everywhere is None else everywhere)

    return Field(default_factory=share)


LengthChange = Annotated[Change | None, BeforeValidator(_change("length")), _change_schema("length")]
DensityChange = Annotated[Change | None, BeforeValidator(_change("density")), _change_schema("density")]
StressChange = Annotated[Change | None, BeforeValidator(_change("stress")), _change_schema("stress")]
ShareChange = Annotated[Change | None, BeforeValidator(_change("ratio")), _change_schema("ratio")]
ForceChange = Annotated[Change | None, BeforeValidator(_change("force")), _change_schema("force")]


class Sensitivity(ProjectSection):
    """How the verdicts move with numbers that are not well known, each varied alone to either side; `true` for all."""

    evidence = FREE

    vary: VaryingShare | None = None
    """share by which everything below is varied that has none of its own; each its own default if absent"""
    thickness: LengthChange = _default_share("thickness")
    """size of the blocks along the direction of motion, about the middle of their base: 0.05, or "2 cm\""""
    density: DensityChange = _default_share("density")
    """of each material that the mechanism has"""
    compressive_strength: StressChange = _default_share("compressive_strength")
    """of joints that crush"""
    stiffness: ShareChange = _default_share("stiffness")
    """of joints that give way, and Young's modulus where something follows from it"""
    friction: ShareChange = _default_share("friction")
    """of each material that gives one"""
    restitution: ShareChange = _default_share("restitution")
    """of both branches, at most to 1"""
    tie_force: ForceChange = _default_share("tie_force")
    """pretension of each tie"""
    loads: ShareChange = _default_share("loads")
    """masses, forces and overburden that are given as numbers"""
    uplift: ShareChange = _default_share("uplift")
    """multiplier of an equivalent-block"""
    p: ShareChange = _default_share("p")
    """frequency parameter of an equivalent-block"""


def _table_or_none(value: Any) -> Any:
    """Replace `true` by the table of defaults and `false` by none."""
    return {} if value is True else None if value is False else value


SensitivityOrSwitch = Annotated[Sensitivity | None, BeforeValidator(_table_or_none), OrValue(bool, {"type": "boolean"})]
FEWEST_SAMPLES, MOST_SAMPLES = 16, 65536  # samples


def _power_of_two(number: int) -> int:
    if number & (number - 1):
        below = 1 << (number.bit_length() - 1)
        raise ValueError(f"not a power of two, which Sobol's sequences need; write {below} or {2 * below}")
    return number


SAMPLING = Evidence(
    "clamped", "none", "the default", judged="the verdict takes the means; their scatter stands beside it"
)


class Uncertainty(ProjectSection):
    """How the answers spread when the numbers given as { mean, cov } vary together; a table, empty for the defaults."""

    evidence = SAMPLING

    samples: Annotated[int, Number(least=FEWEST_SAMPLES, most=MOST_SAMPLES), AfterValidator(_power_of_two)] = 128
    """values of each number, a power of two"""
    seed: Annotated[int, Number(least=0, below=2**32)] = 1
    """of the scrambled Sobol sequence"""
    thickness: Annotated[float, Number("ratio", above=0, below=1), SCATTER] | None = None
    """coefficient of variation of the size of all blocks along their direction, like 0.05, lognormal: of bodies whose
    thickness is no number of this file, as meshes"""


PLAIN_MEASURES = ("pga", "pgv", "sa-average", "pga/(g tan alpha)", "p pgv/(g tan alpha)")
KIND_OF = {"pga": "acceleration", "sa": "acceleration", "sa-average": "acceleration", "pgv": "speed"}
"""The kind of quantity of a measure's intensities; the others are ratios."""
STATE_NAMES = ("rocking", "overturning")
_SPECTRAL_MEASURE = re.compile(r"(sa|sa-average)\((.+)\)")
_MEASURE_REMEDY = f'write one of {quote_names(PLAIN_MEASURES)}, or "sa(0.5 s)", "sa-average(0.2 s, 0.5 s, 1 s)"'


def measure_of(text: Any) -> tuple[str, tuple[float, ...]]:
    """Return the key of a measure and its periods [s]; raise ValueError for what is none.

    Parameters
    ----------
    text : such as "pga" or "sa(0.5 s)"
    """
    if text in PLAIN_MEASURES:
        return str(text), ()
    found = _SPECTRAL_MEASURE.fullmatch(text) if isinstance(text, str) else None
    if found is None:
        raise ValueError(f"not a measure of intensity; {_MEASURE_REMEDY}")
    periods = tuple(key_value(each.strip(), KINDS["time"]) for each in found[2].split(","))
    if any(not 0.0 < period <= 10.0 for period in periods):
        raise ValueError(f"a period is not above 0 and up to 10 s; {_MEASURE_REMEDY}")
    if (found[1] == "sa") != (len(periods) == 1):
        raise ValueError(f"sa has one period, and sa-average several; {_MEASURE_REMEDY}")
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


MeasureText = Annotated[str, BeforeValidator(_a_measure)]
StateValue = Annotated[
    str | float,
    BeforeValidator(_a_state),
    WithJsonSchema({"anyOf": [{"enum": list(STATE_NAMES)}, {"type": "number"}]}),
]


ON_RATES = "no verdict hangs on it, but the annual rate that a target is compared with does"
RUNS_OF_CURVES = Evidence("clamped", "either", "the default", judged=ON_RATES)
FORM_OF_CURVES = Evidence("chosen", "either", "the default", judged=ON_RATES)
EPISTEMIC = Evidence(
    "measured",
    "down",
    "absent: no rate is shown to be within its target",
    judged="the wider a curve, the larger its rate",
)


Dispersion = Annotated[float, Number("ratio", least=0, most=2)]


class StripeSection(ProjectSection):
    """An intensity of [analysis.fragility] with records of its own."""

    evidence = RUNS_OF_CURVES

    intensity: float | str
    """of the first measure, like "0.3 g", to which its records are scaled"""
    records: Annotated[tuple[str, ...], Several(1, unlike="record")]
    """names of records, or patterns of names and paths, like ["level3/*.AT2"]"""


class Fragility(ProjectSection):
    """Fragility curves of `assess fragility`: measures of intensity, states, and how records are run."""

    evidence = RUNS_OF_CURVES

    measures: Annotated[tuple[MeasureText, ...], Several(1, unlike="measure"), FORM_OF_CURVES] | None = None
    """measures of intensity, the one that records are scaled by first: "pga", "pgv", "sa(0.5 s)", "sa-average",
    "sa-average(0.2 s, 0.5 s, 1 s)", "pga/(g tan alpha)", "p pgv/(g tan alpha)"; all that apply if absent"""
    states: Annotated[tuple[StateValue, ...], Several(1, unlike="state"), FORM_OF_CURVES] = (
        "rocking",
        0.5,
        "overturning",
    )
    """states to be reached: "rocking", shares of the overturning rotation like 0.5, "overturning\""""
    method: Annotated[Literal["ida", "stripes", "cloud"], FORM_OF_CURVES] = "ida"
    """"ida": every record at many rising scales; "stripes": all records at few intensities; "cloud": every record once,
    as it is, times [records] factor"""
    samples: Annotated[int, Number(least=3, most=1000)] | None = None
    """intensities at which each record is run; 50 by ida and 10 by stripes if absent"""
    largest: float | str | None = None
    """largest intensity of the first measure, like "1.5 g"; if absent up to where every record overturns, twice in a
    row"""
    largest_factor: Annotated[float, Number("ratio", least=1, most=1000)] = 10.0
    """largest scale factor on a record; above 4 they are marked"""
    uncertain: Annotated[StrictBool, FORM_OF_CURVES] = False
    """whether each record meets a wall of its own, with the numbers given as { mean, cov } sampled as
    [analysis.uncertainty] says; false: all meet the wall at the means"""
    stripes: Annotated[tuple[StripeSection, ...], Several(2)] | None = None
    """[{ intensity, records }, …] of method "stripes": intensities, rising, each with records of its own, as they are
    selected for the hazard at each; all of [records] at the same intensities if absent"""
    seed: Annotated[int, Number(least=0)] = 1
    """of the bootstrap: the same seed gives the same intervals"""
    draws: Annotated[int, Number(least=100, most=10_000)] = 500
    """draws of the bootstrap, by earthquake"""
    epistemic: Annotated[dict[Name, Dispersion], EPISTEMIC] = Field(default_factory=dict)
    """dispersions of what is not known, by name, like { model = 0.2 }; kept apart from that of the records. A target is
    met only with them: without any, no rate is shown to be within it"""

    @model_validator(mode="before")
    @classmethod
    def _intensities_are_of_the_first_measure(cls, values: Any) -> Any:
        """Read the largest intensity and those of stripes in the unit of the measure that they belong to."""
        if not isinstance(values, dict):
            return values
        if values.get("method") == "cloud" and values.get("largest") is not None:
            raise error_at("largest", "a cloud runs every record once, as it is; remove it")
        measures = values.get("measures")
        first = measures[0] if isinstance(measures, list | tuple) and measures else "pga"

        def read(given: Any, *key: str | int) -> float:
            try:
                number = key_value(given, KINDS[KIND_OF.get(measure_of(first)[0], "ratio")])
            except ValueError as error:
                raise error_at(key, str(error)) from None
            if not number > 0.0:
                raise error_at(key, f"{number:g}: must be above 0")
            return number

        found = values if values.get("largest") is None else values | {"largest": read(values["largest"], "largest")}
        stripes = values.get("stripes")
        if isinstance(stripes, list | tuple) and all(
            isinstance(each, dict) and "intensity" in each for each in stripes
        ):
            rows = [
                each | {"intensity": read(each["intensity"], "stripes", place, "intensity")}
                for place, each in enumerate(stripes)
            ]
            found = found | {"stripes": rows}
        return found

    @model_validator(mode="after")
    def _cloud_has_no_levels(self) -> Fragility:
        if self.method == "cloud" and self.samples is not None:
            raise error_at("samples", "a cloud runs every record once, as it is; remove it")
        return self

    @model_validator(mode="after")
    def _stripes_rise_and_stand_alone(self) -> Fragility:
        if self.stripes is None:
            return self
        if self.method != "stripes":
            raise error_at("stripes", f'of method "stripes", and this is "{self.method}"; add method = "stripes"')
        for key in ("samples", "largest"):
            if getattr(self, key) is not None:
                raise error_at(key, "the intensities are those of `stripes`; remove it")
        for place, (low, high) in enumerate(pairwise(self.stripes), start=1):
            if not float(high.intensity) > float(low.intensity):
                raise error_at(("stripes", place), "intensities do not rise; sort them")
        return self


class HazardPoint(ProjectSection):
    """One row of the hazard of the site."""

    pga: Annotated[PositiveAcceleration, Evidence("defines", "down", "as stated")]
    """peak ground acceleration, like "0.2 g\""""
    return_period: Annotated[PositiveYears | None, Evidence("defines", "up", "as stated")] = None
    """mean return period, like 475; or give rate"""
    rate: Annotated[PositiveRatio | None, Evidence("defines", "down", "as stated")] = None
    """annual rate of exceedance; or give return_period"""

    @model_validator(mode="after")
    def _one_of_both(self) -> HazardPoint:
        if (self.return_period is None) == (self.rate is None):
            raise error_at("return_period", "give either return_period or rate")
        return self

    @property
    def annual_rate(self) -> float:
        """Annual rate of exceedance [1/year]."""
        if self.rate is not None:
            return self.rate
        assert self.return_period is not None  # one of the two is given
        return 1.0 / self.return_period


class PlaceSection(ProjectSection):
    """A place on the earth."""

    evidence = Evidence("defines", "either", "as stated")

    longitude: Annotated[float, Number("ratio", least=-180, most=360)]
    """degrees east, like 13.40"""
    latitude: Annotated[float, Number("ratio", least=-90, most=90)]
    """degrees north, like 42.35"""


WrittenPrice = Annotated[
    int | float | str, number_or_text('write a price, such as 4 or "4 EUR/kg"'), WRITTEN_QUANTITY_SCHEMA
]


class Retrofit(ProjectSection):
    """What `assess retrofit` reckons with."""

    evidence = FREE

    prices: dict[StrictStr, WrittenPrice] = Field(default_factory=dict)
    """for the least cost in place of the least steel: of "steel" for each kg, of a "tie" with its plates, of a varied
    key for each unit of change: numbers, or texts like "4 EUR/kg"; those of `--price` stand before them"""


TARGET = Evidence("chosen", "up", "absent: the rate is compared with nothing", judged="a larger rate is met sooner")


class Risk(ProjectSection):
    """Hazard of the site, which fragility makes a rate of: rows, a file, or the rows of an Italian site if absent."""

    hazard: Annotated[tuple[HazardPoint, ...], Several(2)] | None = None
    """rows [{ return_period | rate, pga }, …], of falling rate; those of [site.spectrum] if absent"""
    curve: Annotated[InputFile | None, Evidence("defines", "either", "as stated")] = None
    """hazard curves of OpenQuake as CSV, like "hazard_curve-mean-PGA.csv", in place of hazard"""
    site: PlaceSection | None = None
    """{ longitude, latitude } in degrees: which site of `curve`, the nearest, at most 50 km away; needed where it holds
    several"""
    target: Annotated[PositiveRatio | None, TARGET] = None
    """annual rate that the risk is compared with, like 2e-4"""

    @model_validator(mode="after")
    def _one_source(self) -> Risk:
        if self.hazard is not None and self.curve is not None:
            raise error_at("curve", "beside hazard; give one of them")
        if self.site is not None and self.curve is None:
            raise error_at("site", "only of curve; remove it")
        rows = self.hazard or ()
        for place, (low, high) in enumerate(pairwise(rows), start=1):
            if not (high.pga > low.pga and high.annual_rate < low.annual_rate):
                raise error_at(("hazard", place), "rows rise in pga and fall in rate; sort them")
        return self


STUDIED_LEVELS = Evidence("free", "none", "nothing", judged="the action of the site decides whatever stands here")
FURTHER_PROCEDURES = Evidence("free", "none", "nothing", judged="the methods that decide run whatever stands here")
EQUATION = Evidence("chosen", "either", '"exact", "linearised" of equivalent blocks; the other stands beside it')
SCAN = Evidence(
    "clamped",
    (True, False),
    "true",
    judged="without it no lower PGA is seen to be worse, which is then a condition of a pass",
)


class Analysis(ProjectSection):
    """What is asked."""

    levels: Annotated[tuple[PositiveAcceleration, ...], Several(1, unlike="level"), STUDIED_LEVELS] | None = None
    """peak ground accelerations at which demands are compared; the site's own if absent"""
    procedures: Annotated[ProcedureNames | None, FURTHER_PROCEDURES] = None
    """code procedures to apply; if absent all that apply at the site"""
    equation: Annotated[Literal["exact", "linearised"] | None, EQUATION] = None
    """equation of motion of the histories; if absent exact, and linearised for equivalent blocks"""
    scan: Annotated[StrictBool, SCAN] = True
    """whether histories are run at rising PGA, up to a hundred levels, for their PGA at capacity; false: at the levels
    asked only, for thousands of walls: procedures by histories have no PGA at capacity then, nor the Italian a ζ_E"""
    pulses: Pulses | None = None
    """overturning envelopes: { shape, frequency = { from, to, count }, amplitude = { from, to, count } }"""
    sweep: Sweeps = ()
    """parametric studies: { key, values } or { key, from, to, count }, one or a list"""
    sensitivity: SensitivityOrSwitch = None
    """true, or { vary, thickness, density, … }: how the verdicts move with numbers that are not well known"""
    fragility: Fragility | None = None
    """a table [analysis.fragility] for `assess fragility`: { measures, states, method, samples, seed, … }"""
    risk: Risk | None = None
    """a table [analysis.risk] for `assess fragility`: the hazard of the site, { hazard | curve, site, target }"""
    retrofit: Retrofit | None = None
    """{ prices } for `assess retrofit`"""
    uncertainty: Uncertainty | None = None
    """{ samples, seed, thickness }: how the answers spread when the numbers given as { mean, cov } vary together"""

    @property
    def sweeps(self) -> tuple[SweepSection, ...]:
        """All sweeps, in order."""
        return self.sweep if isinstance(self.sweep, tuple) else (self.sweep,)
