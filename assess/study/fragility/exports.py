"""Fragility in the formats of other programs, by their names in `--export`.

Curves are those of the motion of the ground. Formats with one dispersion get that of the records alone.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial

import numpy as np

from assess.messages.message import Message, Term, note
from assess.results.fragility import FragilityCurve, FragilityResults, LognormalResult, MechanismFragility
from assess.risk.exports.csv import csv_text
from assess.risk.exports.curve import Export, ExportedCurve, ExportedState, LeftOut, Reason, Unit
from assess.risk.exports.nrml import nrml_text
from assess.risk.exports.pelicun import pelicun_text
from assess.risk.lognormal import Lognormal

Write = Callable[[Sequence[ExportedCurve]], Export]
FORMATS: Mapping[str, Mapping[str, Write]] = {
    "nrml": {
        "fragility_continuous.xml": partial(nrml_text, format="continuous"),
        "fragility_discrete.xml": partial(nrml_text, format="discrete"),
    },
    "pelicun": {"fragility_pelicun.csv": pelicun_text},
    "csv": {"fragility_curves.csv": csv_text},
}
"""The files of each format."""
UNITS: Mapping[str, Unit] = {"ground acceleration": "g", "velocity": "m/s", "ratio": "-"}
_REASONS: Mapping[Reason, Term] = {
    "no-name-of-measure": Term("the format has no name for this measure"),
    "state-without-curve": Term("its severest state has no curve"),
    "state-left-out": Term("a state that it has no curve for is left out of the file"),
    "curves-cross": Term("curves of two states cross, which some programs cannot use; it is in the file"),
}


def export(results: FragilityResults, formats: Sequence[str]) -> tuple[dict[str, str], tuple[Message, ...]]:
    """Return the files of some formats, by name, and notes on what they leave out.

    Parameters
    ----------
    results : of `assess fragility`
    formats : of `FORMATS`
    """
    curves = [each for mechanism in results.mechanisms for each in curves_of(mechanism)]
    made = {name: write(curves) for format in formats for name, write in FORMATS[format].items()}
    said = [_left_out(name, one) for name, file in made.items() for one in file.left_out]
    return {name: file.text for name, file in made.items()}, tuple(dict.fromkeys(said))


def _left_out(file: str, one: LeftOut) -> Message:
    """Return the note on what a file leaves out."""
    why = _REASONS[one.reason]
    if one.state:
        return note("fragility-state-left-out", file, mechanism=one.name, measure=one.measure, state=one.state, why=why)
    return note("fragility-left-out", file, mechanism=one.name, measure=one.measure, why=why)


def curves_of(mechanism: MechanismFragility) -> list[ExportedCurve]:
    """Return the curves of a mechanism by each measure of the motion of the ground, the mildest state first."""
    found = []
    for measure in (each for each in mechanism.measures if each.at == "ground"):
        own = sorted((each for each in mechanism.curves if each.measure == measure), key=_severity)
        if own:
            period = measure.periods_s[0] if measure.key == "sa" else None
            states = tuple(map(_state, own))
            found.append(ExportedCurve(mechanism.name, measure.key, period, UNITS[measure.dimension], states))
    return found


def _severity(curve: FragilityCurve) -> float:
    return {"rocking": 0.0, "overturning": 1.0}.get(curve.state.name, curve.state.share or 0.0)


def _state(curve: FragilityCurve) -> ExportedState:
    share = curve.state.share
    points = curve.empirical
    return ExportedState(
        name=curve.state.name if share is None else f"{curve.state.name}-{share:g}",
        lognormal=_lognormal(curve.lognormal),
        intensity=np.array([each.intensity for each in points]),
        records=np.array([each.records for each in points], dtype=np.int64),
        reached=np.array([each.reached for each in points], dtype=np.int64),
        low=np.array([each.low for each in points]),
        high=np.array([each.high for each in points]),
    )


def _lognormal(fitted: LognormalResult | None) -> Lognormal | None:
    return None if fitted is None else Lognormal(fitted.median, fitted.dispersion)
