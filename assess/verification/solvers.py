"""What solves the cases: functions of a case's folder and given values that return a tree of numbers.

Each calls the program by the functions that a run calls; it computes nothing of its own.
"""

from __future__ import annotations

import csv
import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from math import inf, pi, sin
from os.path import relpath
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from assess.examples import copy_example
from assess.oscillator import Oscillator, RockingBlock, plain_branch, restoring_moment
from spectra.gravity import g

Solver = Callable[[Path, Mapping[str, Any]], Mapping[str, Any]]
QUANTILES = (0.1, 0.25, 0.5, 0.75, 0.9)


@contextmanager
def project_file(folder: Path, given: Mapping[str, Any]) -> Iterator[Path]:
    """Yield the project file of a case; an example is copied for as long as it is needed."""
    if "example" not in given:
        yield folder / given["file"]
        return
    with TemporaryDirectory() as temporary:
        yield copy_example(given["example"], Path(temporary) / given["example"])


def solve_joints(folder: Path, given: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return what a joint does, by its name in `given`.

    Parameters
    ----------
    folder : of the case, not read
    given : by joint `shape`, a function of `assess.interfaces.section`, its `sizes` [m], across them `inner` ones if it
        is hollow; `stiffness` [Pa/m] and `strength` [Pa], either absent if infinite; `force` [N]; `rotations`, one at
        least [rad]

    Returns
    -------
    `opening` and `crushing`, rotations at which it opens and starts to crush [rad]; `fixed`, place of the fixed hinge
    of the semi-flexible model from the compressed edge [m]; by rotation `resultant`, `depth` and `crushed`, places of
    the force and depths of contact and of crushing from that edge [m].
    """
    return {name: _solve_joint(each) for name, each in given.items()}


def _solve_project(folder: Path, given: Mapping[str, Any]) -> Mapping[str, Any]:
    """Run a project, and return what stands in its results.json.

    Parameters
    ----------
    folder : of the case
    given : `file`, a project file beside the case, or `example`, the name of a shipped example
    """
    from assess.project.build import build
    from assess.project.project_file import load
    from assess.results.json import dumps
    from assess.study.run import run_study

    with project_file(folder, given) as file:
        tree: dict[str, Any] = json.loads(dumps(run_study(build(load(file)), jobs=1)))
    return tree


def _solve_parameters(folder: Path, given: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return the mechanisms of a project, and of every case of its sweeps, as they stand in results.json.

    Parameters
    ----------
    folder : of the case
    given : `file` or `example` as for a project; `rotations` [rad], at which moments are given

    Returns
    -------
    `inputs`, the files read; `mechanisms` by name; `moments`, restoring moments [N m] of positive rotation by mechanism
    and rotation, and their `largest`.
    """

    from assess.project.build import build
    from assess.project.project_file import load
    from assess.results.json import dumps_mechanisms
    from assess.study.mechanism_results import case_parameters, parameters

    with project_file(folder, given) as file:
        study = build(load(file))
    rotations = np.array(given.get("rotations", []), dtype=float)
    moments = {}
    for mechanism in study.mechanisms:
        branch = mechanism.oscillator.positive
        found = zip(rotations, restoring_moment(branch, rotations), strict=True)
        moments[mechanism.name] = {f"{at:g}": float(moment) for at, moment in found}
        moments[mechanism.name]["largest"] = float(branch.restoring.max())
    mechanisms = json.loads(dumps_mechanisms((*parameters(study), *case_parameters(study))))
    inputs = [{"path": each.path, "sha256": each.sha256} for each in study.inputs]
    return {"inputs": inputs, "mechanisms": mechanisms, "moments": moments}


def _solve_spectra(folder: Path, given: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return parameters and ordinates of spectra.

    Parameters
    ----------
    folder : of the case
    given : `spectra`, by name the keys of a table [site.spectrum]; `periods` [s] of the ordinates; `vertical`, whether
        of the vertical spectra

    Returns
    -------
    `parameters`, by name, as in results.json; `acceleration_g` [g] and `displacement_m` [m], by name and period, such
    as "B, 0.5 s".
    """

    from assess.project.sections import SiteSection
    from assess.project.site_and_structure import spectrum_of, vertical_of

    make = vertical_of if given.get("vertical", False) else spectrum_of
    tree: dict[str, dict[str, Any]] = {"parameters": {}, "acceleration_g": {}, "displacement_m": {}}
    for name, table in given["spectra"].items():
        spectrum = make(SiteSection.model_validate({"spectrum": table}, context={"folder": folder}))
        tree["parameters"][name] = dict(spectrum.parameters)
        for T in given["periods"]:
            row = f"{name}, {T:g} s"
            tree["acceleration_g"][row] = float(spectrum.acceleration(T)) / g
            tree["displacement_m"][row] = float(spectrum.displacement(T))
    return tree


def _solve_free_rocking(folder: Path, given: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return times of impacts times p, and amplitudes, of free rocking.

    Parameters
    ----------
    folder : of the case, not read
    given : `thickness`, `height` [m] of a block of uniform density; `tilts`, initial rotations over the overturning
        rotation; `equation`; `duration` [s]; `restitution` if not Housner's

    Returns
    -------
    By tilt: `first_p` and `period_p`, the time of the first impact and that between the first and the third times p of
    the equation [-]. `amplitude` of the last tilt, by number of impacts: the peak after it over the overturning
    rotation [-].
    """

    from assess.dynamics.history import free_rocking
    from assess.model.bodies import box
    from assess.study.block import single_block

    wall = box(thickness=given["thickness"], length=1.0, height=given["height"], density=2000.0)
    rocking = single_block(wall, direction=(1.0, 0.0, 0.0)).rocking
    if "restitution" in given:
        branch = replace(rocking.positive, restitution=given["restitution"])
        rocking = replace(rocking, positive=branch, negative=branch)
    side = rocking.positive
    p = side.linearised.p
    tree: dict[str, dict[str, Any]] = {"first_p": {}, "period_p": {}, "amplitude": {}}
    for tilt in given["tilts"]:
        rotation = tilt * side.linearised.overturning
        found = free_rocking(rocking, rotation=rotation, duration=given["duration"], equation=given["equation"])
        row = f"{tilt:g}"
        tree["first_p"][row] = p * float(found.impact_time[0])
        tree["period_p"][row] = p * float(found.impact_time[2] - found.impact_time[0])
        peaks = abs(found.peak_rotation) / side.linearised.overturning
        tree["amplitude"] = {str(number): float(peak) for number, peak in enumerate(peaks[:20], 1)}
    return tree


def _solve_motion(folder: Path, given: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return the largest response of plain blocks, and the response spectrum of the motion.

    Parameters
    ----------
    folder : of the case, not read
    given : `blocks`, by name `p` [1/s], `slenderness` [rad], `restitution` [-] and `scale` of the motion [-];
        `equation`; `step` [s] of the motion; `samples` [m/s2], or `duration` [s] and `sines` of which the samples are
        taken, each with amplitude [m/s2], frequency [Hz] and phase [rad]; `periods` [s] of the spectrum

    Returns
    -------
    By name of a block `max_ratio` (|θ|/α), `impacts` and `overturned` (0 or 1); `spectrum_g`, pseudo-acceleration [g]
    at 5 % of damping by period, such as "0.3 s".
    """

    from assess.dynamics.history import peaks, product
    from records.record import make_record
    from records.response import response_spectrum

    step = given["step"]
    motion = make_record("given", np.array(given["samples"] if "samples" in given else _sum_of_sines(given)), step)
    periods = given.get("periods", [])
    spectrum = response_spectrum(motion, periods) / g
    tree: dict[str, Any] = {"spectrum_g": {f"{T:g} s": float(a) for T, a in zip(periods, spectrum, strict=True)}}
    for name, block in given.get("blocks", {}).items():
        side = plain_branch(_plain_block(block), restitution=block["restitution"])
        job = product(1, 1, [block["scale"]])
        found = peaks([Oscillator(side, side, 1.0)], [motion], job, equation=given["equation"])
        tree[name] = {
            "max_ratio": float(found.max_ratio[0]),
            "impacts": int(found.impacts[0]),
            "overturned": int(found.overturned[0]),
        }
    return tree


def _plain_block(given: Mapping[str, Any]) -> RockingBlock:
    """Return a block of unit mass and radius by its `p` [1/s] and `slenderness` [rad]."""

    return RockingBlock(1.0, 1.0, given["slenderness"], g / given["p"] ** 2)


def _sum_of_sines(given: Mapping[str, Any]) -> Sequence[float]:
    """Return the samples of a sum of sines."""

    times = [step * given["step"] for step in range(round(given["duration"] / given["step"]) + 1)]
    return [sum(a * sin(2 * pi * f * t + phase) for a, f, phase in given["sines"]) for t in times]


def _solve_shake_table(folder: Path, given: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return quantiles of the largest |θ|/α measured and computed, and how far their distributions are apart.

    Parameters
    ----------
    folder : of the case, with the motions
    given : `file`, a table of tests as CSV with the columns `motion`, a record file by its path from the case, `scale`
        of it [-] and `max_ratio`, the largest |θ|/α measured, 1 or more where the block overturned; `block` with `p`
        [1/s], `slenderness` [rad], `restitution` [-]; `equation`

    Returns
    -------
    `inputs`, the table and the motions; `measured` and `computed`: `tests`, `overturned` as a share [-] and `quantiles`
    of min(|θ|/α, 1) by percentage; `apart`: `distance`, the largest of their distribution functions (Kolmogorov and
    Smirnov), and `probability` of one as large from equal distributions.
    """

    from scipy.stats import ks_2samp

    from assess.dynamics.history import Jobs, peaks
    from assess.results.provenance import file_sha256
    from records.reading import read_records

    with (folder / given["file"]).open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    names = sorted({row["motion"] for row in rows})
    motions = [read_records(folder / name)[0] for name in names]
    block = given["block"]
    side = plain_branch(_plain_block(block), restitution=block["restitution"])
    which = np.array([names.index(row["motion"]) for row in rows], dtype=np.int64)
    jobs = Jobs(np.zeros_like(which), which, np.array([float(row["scale"]) for row in rows]))
    found = peaks([Oscillator(side, side, 1.0)], motions, jobs, equation=given["equation"])
    measured = np.minimum([float(row["max_ratio"]) for row in rows], 1.0)
    computed = np.where(found.overturned, 1.0, np.minimum(found.max_ratio, 1.0))
    apart = ks_2samp(measured, computed)
    table = folder / given["file"]
    files = [(Path(relpath(each, table.parent)), each) for each in (table, *(folder / name for name in names))]
    return {
        "inputs": [{"path": path.as_posix(), "sha256": file_sha256(each)} for path, each in files],
        "measured": _distribution_of(measured),
        "computed": _distribution_of(computed),
        "apart": {"distance": float(apart.statistic), "probability": float(apart.pvalue)},
    }


def _distribution_of(ratios: Any) -> Mapping[str, Any]:

    quantiles = {f"{100 * share:g} %": float(np.quantile(ratios, share)) for share in QUANTILES}
    return {"tests": len(ratios), "overturned": float(np.mean(ratios >= 1.0)), "quantiles": quantiles}


def _solve_pulses(folder: Path, given: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return overturning amplitudes A = a_p / (g tan α), or a_p / (g λ) of the linearised block, by Ω = ω_p / p.

    Parameters
    ----------
    folder : of the case, not read
    given : `frequencies`, Ω [-]; `p` [1/s], `slenderness` [rad] and `restitution` [-] of a plain block; `highest` A of
        the envelope

    Returns
    -------
    `without_impact` and `half_sine`: closed forms; `first` and `last`: A between which a block overturns after one
    impact; `envelope.linearised` and `envelope.exact`: the least A that overturns under a sine, by integration.
    """
    from assess.dynamics import sine_branches

    restitution = given["restitution"]
    tree: dict[str, dict[str, Any]] = {key: {} for key in ("without_impact", "half_sine", "first", "last", "envelope")}
    for omega in given["frequencies"]:
        row = f"{omega:g}"
        tree["without_impact"][row] = sine_branches.without_impact(omega)
        tree["half_sine"][row] = sine_branches.half_sine(omega)
        impacts = (
            *sine_branches.impact_in_pulse(omega, restitution),
            *sine_branches.impact_after_pulse(omega, restitution),
        )
        if impacts:
            tree["first"][row], tree["last"][row] = min(impacts), max(impacts)
    tree["envelope"] = {equation: _overturning_amplitudes(given, equation) for equation in ("linearised", "exact")}
    return tree


def _overturning_amplitudes(given: Mapping[str, Any], equation: Any) -> Mapping[str, float]:

    from assess.dynamics.pulses import envelope, uplift_acceleration
    from records.pulses import PULSE_SHAPES

    side = plain_branch(_plain_block(given), restitution=given["restitution"], end=4.0)
    body = Oscillator(side, side, 1.0)
    unit, p = uplift_acceleration(body, equation), side.linearised.p if equation == "linearised" else given["p"]
    omegas = np.array(given["frequencies"])
    amplitudes = np.array([0.0, given["highest"]]) * unit
    found = envelope(body, PULSE_SHAPES["sine"], omegas * p / (2 * pi), amplitudes, equation=equation, threads=1)
    return {f"{omega:g}": float(a) / unit for omega, a in zip(omegas, found.lower_bound, strict=True)}


def _solve_joint(given: Mapping[str, Any]) -> Mapping[str, Any]:

    from assess.interfaces import section as sections
    from assess.interfaces.contact import JointLaw, contact, semi_flexible_shift, thresholds

    inner = {"inner": given["inner"]} if "inner" in given else {}
    section = getattr(sections, given["shape"])(*given["sizes"], **inner)
    law, force = JointLaw(given.get("stiffness", inf), given.get("strength", inf)), given["force"]
    rotations = given["rotations"]
    found = contact(section, law, normal_force=force, rotation=rotations)
    by_rotation = {"resultant": found.resultant, "depth": found.depth, "crushed": found.crushed_depth}
    tree: dict[str, Any] = {
        key: {f"{at:g}": float(value) for at, value in zip(rotations, values, strict=True)}
        for key, values in by_rotation.items()
    }
    if "stiffness" in given:
        tree["opening"], tree["crushing"] = thresholds(section, law, normal_force=force)
        tree["fixed"] = semi_flexible_shift(section, law, normal_force=force)
    return tree


def _solve_risk(folder: Path, given: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return lognormal fits and annual rates.

    Parameters
    ----------
    folder : of the case, not read
    given : `counts`, by name `intensity` of stripes, how many records `reached` a state there, of how many `records`;
        `curves`, by name a `median` and `dispersion`, or `intensity` and `share` of an empirical curve; `hazards`, of
        the same names, the rows `intensity` and `rate` [1/year]; `epistemic`, a dispersion that widens the curves

    Returns
    -------
    By name of counts `median` and `dispersion`, `low` and `high` of Wilson's interval of the first stripe; by name of
    curves `rate` and `widened` [1/year], and `in_50_years`, the probability.
    """
    counts = {name: _fit_counts(each) for name, each in given.get("counts", {}).items()}
    curves = given.get("curves", {})
    rates = {name: _rates(each, given["hazards"][name], given["epistemic"]) for name, each in curves.items()}
    return {**counts, **rates}


def _fit_counts(given: Mapping[str, Any]) -> Mapping[str, float]:
    from assess.risk.estimates import fit_lognormal, wilson_interval

    low, high = wilson_interval(given["reached"], given["records"])
    found = fit_lognormal(given["intensity"], given["reached"], given["records"])
    interval = {"low": float(low[0]), "high": float(high[0])}
    return interval if found is None else {"median": found.median, "dispersion": found.dispersion, **interval}


def _rates(curve: Mapping[str, Any], hazard: Mapping[str, Any], epistemic: float) -> Mapping[str, float]:

    from assess.risk.estimates import EmpiricalCurve, Lognormal
    from assess.risk.hazard import HazardCurve, probability_of, rate

    kinks = np.array(curve.get("intensity", ()), dtype=float)
    drawn = (
        EmpiricalCurve(kinks, np.array(curve["share"]))
        if kinks.size
        else Lognormal(curve["median"], curve["dispersion"])
    )
    rows = HazardCurve(np.array(hazard["intensity"]), np.array(hazard["rate"]))
    found = rate(drawn.probability, rows, breaks=kinks).annual_rate
    widened = rate(drawn.convolve(epistemic).probability, rows, breaks=kinks).annual_rate
    return {"rate": found, "widened": widened, "in_50_years": probability_of(found)}


SOLVERS: dict[str, Solver] = {
    "free-rocking": _solve_free_rocking,
    "joints": solve_joints,
    "motion": _solve_motion,
    "parameters": _solve_parameters,
    "project": _solve_project,
    "pulses": _solve_pulses,
    "risk": _solve_risk,
    "shake-table": _solve_shake_table,
    "spectra": _solve_spectra,
}
