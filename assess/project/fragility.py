"""From [analysis.fragility] and [analysis.risk] to what is asked of the fragility of a study."""

from __future__ import annotations

from pathlib import Path

from scipy.constants import g

from assess.codes.context import Hazard
from assess.errors import locate_errors
from assess.project import sections
from assess.results.fragility import HazardResult, StateResult
from assess.risk.hazard_files import read_hazard
from assess.study.fragility.measures import measure
from assess.study.fragility.question import FragilityQuestion
from records.paths import relative_path


def fragility_question(content: sections.Content, hazard: Hazard | None, *, folder: Path) -> FragilityQuestion:
    """Return what is asked of fragility; `hazard`: of an Italian site, used where the project gives no other."""
    asked = content.analysis.fragility or sections.Fragility()
    risk = content.analysis.risk or sections.Risk()
    measures = tuple(measure(*sections.measure_of(text)) for text in asked.measures or ())
    in_g = not measures or measures[0].dimension == "ground acceleration"
    return FragilityQuestion(
        measures=measures,
        states=tuple(map(_state, asked.states)),
        method=asked.method,
        samples=asked.samples,
        largest=None if asked.largest is None else float(asked.largest) / (g if in_g else 1.0),
        largest_factor=asked.largest_factor,
        seed=asked.seed,
        draws=asked.draws,
        epistemic=dict(asked.epistemic),
        hazard=_hazard(risk, hazard, folder),
        target_rate=risk.target,
    )


def hazard_files(content: sections.Content) -> list[Path]:
    """Return the file of the hazard, if one is named."""
    risk = content.analysis.risk
    return [] if risk is None or risk.curve is None else [risk.curve]


def _state(value: str | float) -> StateResult:
    if isinstance(value, str):
        return StateResult("rocking") if value == "rocking" else StateResult("overturning")
    return StateResult("rotation", value)


def _hazard(risk: sections.Risk, site: Hazard | None, folder: Path) -> HazardResult | None:
    """Return the hazard: rows of the project, or a file, or the rows of an Italian site."""
    if risk.hazard is not None:
        pga = tuple(row.pga / g for row in risk.hazard)
        return HazardResult(measure("pga"), "analysis.risk.hazard", pga, tuple(row.annual_rate for row in risk.hazard))
    if risk.curve is not None:
        place = risk.site
        longitude, latitude = (None, None) if place is None else (place.longitude, place.latitude)
        with locate_errors("analysis.risk.curve"):
            found = read_hazard(risk.curve, longitude=longitude, latitude=latitude)
        intensity, annual_rate = (tuple(each.tolist()) for each in (found.curve.intensity, found.curve.annual_rate))
        own = measure(found.measure, () if found.period is None else (found.period,))
        return HazardResult(own, relative_path(risk.curve, folder), intensity, annual_rate, found.distance)
    if site is None:
        return None
    rates = tuple(1.0 / years for years in site.return_period)
    return HazardResult(measure("pga"), "site.spectrum.hazard", tuple(pga / g for pga in site.pga), rates)
