"""The ties of a building in space, each once, with what becomes of it in every mechanism that it holds.

A tie is of the building: loads of several mechanisms that have the same ends, or lie along the same drawn bar, are one.
What becomes of it is read at the rotation that the deciding method demands at the site's own action: of histories the
largest of all records to either side, of which the worse for the tie counts.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from math import inf, isclose, isfinite
from typing import Any

import numpy as np

from assess.codes.procedures import uses_histories
from assess.loads.anchorage import GAMMA_M0
from assess.loads.load import SAME_END, Tie
from assess.mechanisms.branch_table import tie_elongation
from assess.mechanisms.mechanism import Mechanism
from assess.oscillator import BRANCH_NAMES, BranchName
from assess.results import (
    BodyEdges,
    HeldByTie,
    HistoryResult,
    LoadResult,
    MechanismResult,
    Place,
    ResolvedValue,
    TieLink,
    TieLinkName,
    TieOutcome,
    TieResult,
)
from assess.results.before import governing_check
from assess.results.mechanism import WORST_FIRST
from spectra.arrays import FloatArray

ALONG_BAR = 0.3  # m: a load whose end lies no farther from a drawn bar is of that bar
PARALLEL = 0.98  # cosine, of a load and the bar that it is of
DRAWN_LENGTH = 1.0  # m: of a tie of which the direction alone is given
TIE_BODY = "tie"


def ties_in_space(
    resolved: Mapping[str, ResolvedValue],
    mechanisms: Mapping[str, Mechanism],
    results: Sequence[MechanismResult],
    beside: Sequence[BodyEdges],
    *,
    pga_g: float,
) -> tuple[TieResult, ...]:
    """Return the ties that loads state and that bodies draw, each once.

    Parameters
    ----------
    resolved : values of the project, with the loads of its mechanisms
    mechanisms : by name; results : what was found of them
    beside : bodies of no mechanism, ties among them
    pga_g : of the site's own action [g]
    """
    bars = {body.name: _axis(body) for body in beside if body.kind == TIE_BODY and body.edges}
    found: list[TieResult] = []
    for result in results:
        for ends, held in _stated_ties(result, mechanisms[result.name], resolved, pga_g=pga_g):
            bar = next((name for name, axis in bars.items() if _lies_along(ends, axis)), "")
            same = next((k for k, each in enumerate(found) if _is_same(each, ends, bar)), None)
            if same is None:
                found.append(TieResult(_rounded(ends), (held,), bar))
            else:
                found[same] = replace(found[same], held=(*found[same].held, held))
    taken = {each.body for each in found}
    return (*found, *(TieResult(_rounded(axis), (), name) for name, axis in bars.items() if name not in taken))


def left_out_beside(counted: Sequence[TieResult], typed: Sequence[TieResult]) -> tuple[TieResult, ...]:
    """Return the ties of a state in which some have no source, with those of the project as typed that count nowhere.

    Parameters
    ----------
    counted : of the state that decides; typed : of the project as typed
    """
    missing = (each for each in typed if not any(_is_same(one, np.array(each.ends), each.body) for one in counted))
    return (*counted, *(replace(each, held=tuple(map(_uncounted, each.held))) for each in missing))


def held_by_state(
    ties: Sequence[TieResult], other: Sequence[TieResult], names: Collection[str]
) -> tuple[TieResult, ...]:
    """Return ties with what becomes of them in some mechanisms as another state has it.

    Parameters
    ----------
    ties : of the state that decides on the other mechanisms
    other, names : of the state that decides on these mechanisms
    """
    there = {(each.mechanism, each.load): each for tie in other for each in tie.held if each.mechanism in names}
    return tuple(
        replace(tie, held=tuple(there.get((each.mechanism, each.load), each) for each in tie.held)) for tie in ties
    )


def _uncounted(held: HeldByTie) -> HeldByTie:
    return replace(held, outcome="not counted", elongation_m=None, plastic_m=None, pull_n=None, links=())


def _stated_ties(
    result: MechanismResult, mechanism: Mechanism, resolved: Mapping[str, ResolvedValue], *, pga_g: float
) -> Iterator[tuple[FloatArray, HeldByTie]]:
    """Yield the ends [2, 3] of each tie among the loads of a mechanism, with what becomes of it."""
    stated = resolved.get(f"mechanisms.{result.name}.loads")
    demanded = _demanded(result, mechanism, pga_g=pga_g)
    for number, load in enumerate(() if stated is None else stated.value or (), start=1):
        used = next((each for each in result.loads if each.name == f"tie {number}"), None)
        if load.get("kind") != TIE_BODY or used is None or (ends := _ends(load, result)) is None:
            continue
        rests = [
            0.0 if side is None else side.equilibrium_rad for side in (result.oscillator, result.oscillator_negative)
        ]
        state = _state_of(mechanism, used, demanded, dict(zip(BRANCH_NAMES, rests, strict=True)))
        yield (
            ends,
            HeldByTie(result.name, used.name, state.outcome, state.elongation, state.plastic, state.pull, state.links),
        )


UPRIGHT: Mapping[BranchName, float] = {}  # at rest, of joints that do not deform
Demanded = Mapping[BranchName, float | None]
"""Rotations that the deciding method demands [rad], by branch; None where one is not known."""


def _demanded(result: MechanismResult, mechanism: Mechanism, *, pga_g: float) -> Demanded:
    """Return what the deciding method demands of a mechanism."""
    check = governing_check(result.checks, pga_g=pga_g)
    if check is None:
        return {"positive": None}
    if uses_histories(check.procedure):
        own = [each for each in result.histories if isclose(each.level_pga_g, pga_g, rel_tol=1e-9)]
        branches: tuple[BranchName, ...] = ("positive",) if mechanism.negative is None else ("positive", "negative")
        return {branch: _largest([each for each in own if each.branch == branch or each.overturned])
                for branch in branches}  # fmt: skip
    back = check.branch == "negative"
    side = result.oscillator_negative if back else result.oscillator
    deciding = result.deciding_overturning_rad
    over = None if side is None else side.overturning_rad if deciding is None else deciding[back]
    known = over is not None and check.rotation_ratio is not None
    rotation = min(check.rotation_ratio or 0.0, 1.0) * (over or 0.0) if known else None
    return {"negative" if back else "positive": rotation}


def _largest(histories: Sequence[HistoryResult]) -> float | None:
    """Return the largest rotation of histories [rad]; None without any, and where one overturns."""
    found = [each.max_rotation_rad for each in histories]
    known = [abs(each) for each in found if each is not None]
    return max(known) if known and len(known) == len(found) else None


@dataclass(frozen=True)
class _State:
    outcome: TieOutcome
    elongation: float | None = None
    plastic: float | None = None
    pull: float | None = None
    links: tuple[TieLink, ...] = ()


def _state_of(
    mechanism: Mechanism, used: LoadResult, demanded: Demanded, rests: Mapping[BranchName, float] = UPRIGHT
) -> _State:
    """Return the worst of what becomes of a tie as the mechanism turns to either side; rests : phi_e of each [rad]."""
    if used.lasting == "not shown":
        return _State("not counted")
    states = [
        _state_on(mechanism, used, rotation, branch, rests.get(branch, 0.0)) for branch, rotation in demanded.items()
    ]
    return min(states, key=lambda state: (WORST_FIRST.index(state.outcome), -(state.pull or 0.0)))


def _state_on(
    mechanism: Mechanism, used: LoadResult, rotation: float | None, branch: BranchName, rest: float
) -> _State:
    """Return what becomes of a tie as the mechanism turns so far: elongation from rest, and what is left of it [m].

    Rotations count from rest, to which a mechanism on joints that deform leans by phi_e; the tie follows the geometry.
    """
    if rotation is None:
        return _State("not known")
    chain = mechanism.negative if branch == "negative" else mechanism.positive
    actions = () if chain is None else chain.actions
    tie = next((each for each in actions if each.name == used.name and isinstance(each, Tie)), None)
    if chain is None or tie is None:
        return _State("slack")
    e = tie_elongation(chain, tie, rest + rotation) - tie_elongation(chain, tie, rest)
    if tie.stiffness is None:
        if used.end_rad is not None and rotation >= used.end_rad:
            return _State("gone", e)
        return _State("slack" if e < 0.0 and not tie.both else "holds", e)
    end, pull = tie.elongation or 0.0, float(tie.pull_at(np.array([e]))[0])
    links = tuple(_links_at(tie, pull))
    if e >= end:
        return _State("gone", e, None, pull, links)
    elastic = end - (tie.length or 0.0) * (tie.fracture_strain or 0.0) if tie.ductile else end
    if e > elastic:
        return _State("yields", e, e - elastic, pull, links)
    return _State("slack" if pull <= 0.0 else "elastic", e, 0.0, pull, links)


def _links_at(tie: Tie, pull: float) -> Iterator[TieLink]:
    """Yield the links of a tie under a pull [N], the bar by its design strength A f_y / 1.05."""
    strengths: list[tuple[TieLinkName, float | None]]
    if tie.is_spring:
        strengths = [("strength", tie.strength)]
    else:
        strengths = [("bar", (tie.yield_force or 0.0) / GAMMA_M0)]
        if tie.anchorage is not None:
            strengths += [(each.name, each.strength) for each in tie.anchorage.links]
        if tie.anchorage is None or tie.anchorage.stated is not None:
            strengths.append(("anchorage", tie.strength if tie.anchorage is None else tie.anchorage.stated))
    for name, strength in strengths:
        known = strength is not None and isfinite(strength) and strength > 0.0
        yield TieLink(name, strength if known else None, pull / (strength or inf) if known else None)


def _ends(load: Mapping[str, Any], result: MechanismResult) -> FloatArray | None:
    """Return the ends of a tie in space [2, 3] [m]; None where the project gives no place in space."""
    if result.direction is None:
        return None
    at = _in_space(load["at"], result)
    if at is None:
        return None
    if load.get("anchor") is not None:
        far = _in_space(load["anchor"], result)
        return None if far is None else np.array([at, far])
    way = np.asarray(load["direction"], dtype=np.float64)
    if way.size == 2:
        way = way[0] * np.asarray(result.direction) + np.array([0.0, 0.0, way[1]])
    return np.array([at, at + way / np.linalg.norm(way) * (load.get("length") or DRAWN_LENGTH)])


def _in_space(place: Sequence[float], result: MechanismResult) -> FloatArray | None:
    """Return a place of the project in space [3]; one in the plane of motion is drawn in the middle of the bodies."""
    if len(place) == 3:
        return np.asarray(place, dtype=np.float64)
    if result.view is None or not result.view.vertices or result.direction is None:
        return None
    towards = np.asarray(result.direction)
    across = np.array([-towards[1], towards[0], 0.0])
    sideways = np.array(result.view.vertices) @ across
    middle = (float(sideways.min()) + float(sideways.max())) / 2.0
    return np.asarray(place[0] * towards + middle * across + np.array([0.0, 0.0, place[1]]))


def _axis(body: BodyEdges) -> FloatArray:
    """Return the ends [2, 3] [m] of the long axis of a bar: the middles of its corners at either end."""
    points = np.array(body.edges).reshape(-1, 3)
    middle = points.mean(axis=0)
    along = (points - middle) @ np.linalg.svd(points - middle, full_matrices=False)[2][0]
    half = (along.min() + along.max()) / 2.0
    return np.array([points[along < half].mean(axis=0), points[along >= half].mean(axis=0)])


def _lies_along(ends: FloatArray, axis: FloatArray) -> bool:
    """Return whether a tie lies along a drawn bar: it is parallel, and begins beside it."""
    way, bar = ends[1] - ends[0], axis[1] - axis[0]
    length = float(np.linalg.norm(bar))
    cosine = abs(float(way @ bar)) / (float(np.linalg.norm(way)) * length)
    share = float(np.clip((ends[0] - axis[0]) @ bar / length**2, 0.0, 1.0))
    return cosine >= PARALLEL and float(np.linalg.norm(ends[0] - axis[0] - share * bar)) <= ALONG_BAR


def _is_same(tie: TieResult, ends: FloatArray, body: str) -> bool:
    if body and tie.body == body:
        return True
    return bool(np.linalg.norm(np.array(tie.ends) - ends, axis=1).max() <= SAME_END)


def _rounded(ends: FloatArray) -> tuple[Place, Place]:
    first, second = (tuple(float(each) for each in np.round(end, 4) + 0.0) for end in ends)
    return (first[0], first[1], first[2]), (second[0], second[1], second[2])
