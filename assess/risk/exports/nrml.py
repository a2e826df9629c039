"""Fragility models of OpenQuake, NRML 0.5, discrete and continuous.

`mean` and `stddev` of a continuous function are those of the intensity itself, not of its logarithm: m exp(beta^2 / 2)
and mean sqrt(exp(beta^2) - 1) (OpenQuake manual, "Fragility models"). All functions of a model have the same limit
states, from the mildest on, whose names are words.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Literal
from xml.etree import ElementTree as ET

import numpy as np

from assess.risk.empirical import Empirical
from assess.risk.exports.curve import Export, ExportedCurve, ExportedState, LeftOut, common_states
from spectra.arrays import FloatArray

Format = Literal["continuous", "discrete"]
NAMESPACE = "http://openquake.org/xmlns/nrml/0.5"
WIDTH = 4.0  # standard deviations beyond the outermost medians to which a continuous function reaches
SLIGHT = 1e-3  # of the first intensity: where discrete functions begin that are above zero there
CROSSING = 1e-3  # of probability: curves that cross in their far tails do not count
CM = 100.0  # in a metre: OpenQuake's PGV is in cm/s


def nrml_text(curves: Sequence[ExportedCurve], *, format: Format, description: str = "") -> Export:
    """Return a fragility model of all curves whose measure has a name in OpenQuake: PGA, PGV, SA(T).

    The taxonomy of a function is the name of its mechanism, with the measure behind it where a mechanism has several.

    Parameters
    ----------
    curves : with the same states each
    format : "continuous": lognormal curves; "discrete": the empirical ones
    description : of the model; text of the user
    """
    inside, left_out = _choose(curves, format)
    states = [] if not inside else [word_of(each.name) for each in inside[0].states]
    root = ET.Element("nrml", xmlns=NAMESPACE)
    model = ET.SubElement(root, "fragilityModel", id="rocking", assetCategory="buildings", lossCategory="structural")
    ET.SubElement(model, "description").text = printable(description) or "Rocking of masonry mechanisms"
    ET.SubElement(model, "limitStates").text = " ".join(states)
    for taxonomy, each in zip(_taxonomies(inside), inside, strict=True):
        function = ET.SubElement(model, "fragilityFunction", id=taxonomy, format=format)
        (_continuous if format == "continuous" else _discrete)(function, each)
    ET.indent(root)
    return Export(f'<?xml version="1.0" encoding="UTF-8"?>\n{ET.tostring(root, encoding="unicode")}\n', left_out)


def imt_of(curve: ExportedCurve) -> str | None:
    """Return the name of a curve's measure in OpenQuake; None where it has none."""
    if curve.measure == "sa" and curve.period is not None:
        return f"SA({curve.period:g})"
    return {"pga": "PGA", "pgv": "PGV"}.get(curve.measure)


def word_of(name: str) -> str:
    """Return a name as OpenQuake takes it for limit states: letters, digits and underscores, a letter first."""
    word = re.sub(r"[^A-Za-z0-9_]", "_", name)
    return word if re.match(r"[A-Za-z_]", word) else f"_{word}"


def printable(text: str) -> str:
    """Return a text without the characters that XML 1.0 has no place for."""
    return re.sub(r"[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]", "", text)


def _taxonomies(curves: Sequence[ExportedCurve]) -> list[str]:
    """Return names that differ, without the characters that OpenQuake refuses in them."""
    names, found = [each.name for each in curves], list[str]()
    for each in curves:
        text = each.name if names.count(each.name) == 1 else f"{each.name} {imt_of(each)}"
        word = re.sub("[#'\"]", "_", printable(text))
        alike = sum(other == word or other.startswith(f"{word} ..") for other in found)
        found.append(f"{word} ..{alike + 1}" if alike else word)
    return found


def _choose(curves: Sequence[ExportedCurve], format: Format) -> tuple[list[ExportedCurve], tuple[LeftOut, ...]]:
    """Return the curves that the model has a place for, and what is to be said of the others."""
    unnamed = [each for each in curves if imt_of(each) is None]
    left_out = [LeftOut(each.name, each.measure, each.period, "no-name-of-measure") for each in unnamed]
    named = [each for each in curves if imt_of(each) is not None]
    inside, lacking = common_states(named, fitted=format == "continuous")
    crossing = ((each, _crossing(each, format)) for each in inside)
    crossed = [
        LeftOut(each.name, each.measure, each.period, "curves-cross", state.name) for each, state in crossing if state
    ]
    return inside, (*left_out, *lacking, *crossed)


def _crossing(curve: ExportedCurve, format: Format) -> ExportedState | None:
    """Return the first state that is somewhere more likely than the milder one before it; None where there is none."""
    at = _range(curve) if format == "continuous" else _intensities(curve)
    before = np.ones_like(at)
    for state in curve.states:
        here = state.lognormal.probability(at) if format == "continuous" and state.lognormal else _shares(state, at)
        if (here > before + CROSSING).any():
            return state
        before = here
    return None


def _continuous(function: ET.Element, curve: ExportedCurve) -> None:
    function.set("shape", "logncdf")
    factor, at = _factor(curve), _range(curve)
    imls = ET.SubElement(function, "imls", imt=str(imt_of(curve)), noDamageLimit=_text(factor * at[0]))
    imls.set("minIML", _text(factor * at[0]))
    imls.set("maxIML", _text(factor * at[-1]))
    for state in curve.states:
        if state.lognormal is not None:
            mean, stddev = factor * state.lognormal.mean, factor * state.lognormal.standard_deviation
            ET.SubElement(function, "params", ls=word_of(state.name), mean=_text(mean), stddev=_text(stddev))


def _discrete(function: ET.Element, curve: ExportedCurve) -> None:
    factor, at = _factor(curve), _intensities(curve)
    shares = [_shares(state, at) for state in curve.states]
    zero = np.all([share == 0.0 for share in shares], axis=0)
    leading = int(np.argmin(zero)) if not zero.all() else zero.size
    limit = at[leading - 1] if leading else SLIGHT * at[0]
    imls = ET.SubElement(function, "imls", imt=str(imt_of(curve)), noDamageLimit=_text(factor * limit))
    imls.text = " ".join(_text(factor * each) for each in at)
    for state, share in zip(curve.states, shares, strict=True):
        ET.SubElement(function, "poes", ls=word_of(state.name)).text = " ".join(_text(each) for each in share)


def _range(curve: ExportedCurve) -> FloatArray:
    """Return intensities over which the lognormal curves of a mechanism rise [200]."""
    fits = [each.lognormal for each in curve.states if each.lognormal is not None]
    low = min(float(np.log(each.median)) - WIDTH * each.dispersion for each in fits)
    high = max(float(np.log(each.median)) + WIDTH * each.dispersion for each in fits)
    return np.asarray(np.exp(np.linspace(low, high, 200)))


def _intensities(curve: ExportedCurve) -> FloatArray:
    """Return all intensities at which some state of a mechanism has an empirical point, rising."""
    return np.unique(np.concatenate([each.intensity for each in curve.states]))


def _shares(state: ExportedState, at: FloatArray) -> FloatArray:
    return Empirical(state.intensity, state.share).probability(at)


def _factor(curve: ExportedCurve) -> float:
    return CM if curve.unit == "m/s" else 1.0


def _text(value: float) -> str:
    """Return a number with all its digits."""
    return repr(float(value))
