"""The automatic controls: met by what is right, and not met by a wrong mass, a wrong table or a coarse one."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.constants import g

from assess.dynamics.history import peaks, product, trace_with_events
from assess.dynamics.packing import Equation
from assess.loads.load import Force, PointMass, Tie
from assess.mechanisms.four_hinge import four_hinge
from assess.mechanisms.hinge_forces import hinge_forces
from assess.mechanisms.mechanism import Face, Mechanism
from assess.mechanisms.single_block import single_block
from assess.mechanisms.two_block import two_block
from assess.oscillator import Branch, Oscillator, linear_multiplier
from assess.results import HistoryResult, Results
from assess.results.json import dumps
from assess.study.controls import (
    CONTROL_TOLERANCE,
    control_warnings,
    equilibrium_controls,
    moment_multiplier,
    multiplier_control,
)
from assess.study.history_controls import (
    EnergyBalance,
    GoverningHistory,
    branch_energies,
    convergence_control,
    energy_balance,
    energy_control,
    every_second,
    sampled_finely,
)
from assess.study.run import run_study
from tests.support import blocks
from tests.support.bodies import body_at
from tests.support.motions import noise, write_noise
from tests.support.projects import ASCE7, block, project_toml, published, study_of

LOADS = (
    PointMass("floor", 300.0, (-0.2, 3.0), bearing=True),
    PointMass("beside", 150.0, (0.0, 3.5), bearing=False),
    Force("thrust", (120.0, -400.0), (0.1, 2.5), until="collapse", evidence="measured"),
    Tie(
        "tie", 200.0, (0.0, 3.0), direction=(-1.0, 0.0), until="collapse", evidence="seen", strength=500.0, length=5.0,
        fracture_strain=0.5,
    ),
)  # fmt: skip
FACES = ((Face(),) * 4, (Face(),) * 4)


def single(mass: float = 1000.0, *loads, sides="two") -> Mechanism:
    found = single_block(
        "m", body_at(mass, 0.0, 2.0), hinge=(0.4, 0.0), hinge_negative=None if sides == "one" else (-0.4, 0.0),
        loads=loads or LOADS, sides=sides, restitution=(0.9, None if sides == "one" else 0.9),
    )  # fmt: skip
    return replace(found, faces=tuple((Face(),) for _ in (found.positive, found.negative) if _))


def spanning(mass: float = 1000.0) -> Mechanism:
    top = (PointMass("roof", 200.0, (0.0, 4.0), bearing=True, block=1),)
    found = two_block(
        "m", body_at(1000.0, 0.0, 1.0), body_at(mass, 0.0, 3.0), hinges=((0.2, 0.0), (-0.2, 2.0), (0.2, 4.0)),
        sides="one", loads=top, restitution=(0.8, None),
    )  # fmt: skip
    return replace(found, faces=((Face(), Face(), Face(normal=(0.0, -1.0))),))


def portal(mass: float = 800.0) -> Mechanism:
    found = four_hinge(
        "m", (body_at(1000.0, 0.2, 1.2), body_at(mass, 2.0, 3.2), body_at(1000.0, 3.8, 1.2)),
        hinges=((0.4, 0.0), (0.0, 3.0), (3.6, 3.0), (4.0, 0.0)), sides="one", restitution=(0.8, None),
    )  # fmt: skip
    return replace(found, faces=((Face(),) * 4,))


MOTION = noise(7, npts=900, dt=0.01, peak=5.0, smooth=31, bell=1.0)
KINDS = {"single": single, "one-sided": lambda: single(sides="one"), "two-block": spanning, "four-hinge": portal}
SCALES = {"single": 0.45, "one-sided": 0.45, "two-block": 1.2, "four-hinge": 0.45}  # each rocks and does not overturn
HEAVIER = {"single": lambda: single(1010.0), "two-block": lambda: spanning(1010.0), "four-hinge": lambda: portal(808.0)}


def of_table(mechanism: Mechanism, factor: float = 1.001) -> Oscillator:
    """The oscillator with restoring moments that are wrong."""
    found = mechanism.oscillator
    positive, *negative = (replace(branch, restoring=factor * branch.restoring) for branch in found.branches)
    return replace(found, positive=positive, negative=negative[0] if negative else None)


def governing(oscillator: Oscillator, *, scale: float, equation: Equation = "exact") -> GoverningHistory:
    found = peaks([oscillator], [MOTION], product(1, 1, [scale]), equation=equation, threads=1)
    over = bool(found.overturned[0])
    history = HistoryResult(
        "noise", 1, 0.3, scale, 1.0, None if over else float(found.max_rotation[0]),
        None if over else float(found.max_ratio[0]), None, int(found.impacts[0]), over,
        float(found.overturning_time[0]) if over else None, None, "positive",
    )  # fmt: skip
    return GoverningHistory(history, oscillator, MOTION, scale, equation)


@pytest.mark.parametrize("kind", KINDS)
def test_reactions_balance_weights_loads_and_inertia(kind: str) -> None:
    mechanism = KINDS[kind]()
    vertical, horizontal = equilibrium_controls(mechanism, mechanism.oscillator)
    assert vertical.met
    assert horizontal.met
    assert (vertical.difference or 0.0) < 1e-12
    assert horizontal.value == pytest.approx(horizontal.reference, rel=1e-9)


def test_the_weight_on_the_hinge_of_a_block_is_that_of_its_bearing_masses_and_loads() -> None:
    found = single(1000.0, LOADS[0])
    (vertical, horizontal) = equilibrium_controls(found, found.oscillator)
    assert vertical.reference == pytest.approx(1300.0 * g)
    assert horizontal.reference == pytest.approx(-(1000 * 0.4 + 300 * 0.2) / (1000 * 2.0 + 300 * 3.0) * 1300.0 * g)


@pytest.mark.parametrize("kind", HEAVIER)
def test_a_wrong_mass_shows_in_equilibrium_and_multiplier(kind: str) -> None:
    """The oscillator is that of a body one per cent lighter than the one that stands on the hinges."""
    heavier, oscillator = HEAVIER[kind](), KINDS[kind]().oscillator
    assert equilibrium_controls(heavier, oscillator)[1].met is False
    assert multiplier_control(heavier, oscillator).met is False


@pytest.mark.parametrize("kind", KINDS)
def test_a_wrong_table_shows_in_equilibrium_multiplier_and_energy(kind: str) -> None:
    mechanism = KINDS[kind]()
    wrong = of_table(mechanism)
    assert equilibrium_controls(mechanism, wrong)[1].met is False
    assert multiplier_control(mechanism, wrong).met is False
    spoilt = replace(mechanism)
    spoilt.__dict__["oscillator"] = of_table(mechanism, 1.01)
    assert energy_control(spoilt, None, equation="exact").met is False
    assert energy_control(spoilt, governing(spoilt.oscillator, scale=SCALES[kind]), equation="exact").met is False


@pytest.mark.parametrize("kind", KINDS)
def test_the_multiplier_by_moments_is_that_of_virtual_work(kind: str) -> None:
    mechanism = KINDS[kind]()
    found = multiplier_control(mechanism, mechanism.oscillator)
    assert found.met
    assert found.value == pytest.approx(found.reference, rel=1e-12)


def test_controls_are_of_the_sense_in_which_the_body_begins_to_move_first() -> None:
    """A weight of 10 kN at 0.1 m beyond mid-thickness: less is needed to turn a wall over the nearer hinge."""
    outer = Force("f", (0.0, -1e4), (0.1, 2.0), 0, until="collapse", evidence="test")
    for at in (0.1, -0.1):
        mechanism = single(1000.0, replace(outer, at=(at, 2.0)))
        least = min(linear_multiplier(branch) for branch in mechanism.oscillator.branches)
        assert linear_multiplier(mechanism.oscillator.positive) != linear_multiplier(mechanism.oscillator.negative)
        assert multiplier_control(mechanism, mechanism.oscillator).value == pytest.approx(least, rel=1e-12)


def test_the_multiplier_of_a_wall_cracked_at_half_its_height_is_four_times_its_slenderness() -> None:
    """Thickness t, height h, held at its top, without load: lambda = 4 t / h."""
    found = two_block(
        "m",
        body_at(1000.0, 0.0, 1.0),
        body_at(1000.0, 0.0, 3.0),
        hinges=((0.2, 0.0), (-0.2, 2.0), (0.2, 4.0)),
        sides="one",
    )
    assert moment_multiplier(found.positive) == pytest.approx(4 * 0.4 / 4.0, rel=1e-12)


@pytest.mark.parametrize("overturns", [False, True])
@pytest.mark.parametrize("kind", KINDS)
def test_the_energy_of_a_history_is_balanced(kind: str, overturns: bool) -> None:
    mechanism = KINDS[kind]()
    history = governing(mechanism.oscillator, scale=20.0 if overturns else SCALES[kind])
    assert history.history.overturned == overturns
    found = energy_control(mechanism, history, equation="exact")
    assert found.met
    assert found.difference == pytest.approx(0.0, abs=2e-7)
    assert "masses" in found.note.text


@pytest.mark.parametrize("kind", KINDS)
def test_the_energy_of_a_linearised_history_is_balanced(kind: str) -> None:
    mechanism = KINDS[kind]()
    history = governing(mechanism.oscillator, scale=SCALES[kind], equation="linearised")
    found = energy_control(mechanism, history, equation="linearised")
    assert found.difference == pytest.approx(0.0, abs=2e-7)
    assert convergence_control(mechanism, history).met is None


def test_a_wrong_mass_and_a_wrong_restitution_show_in_the_energy() -> None:
    mechanism, heavier = single(), single(1010.0)
    history = governing(mechanism.oscillator, scale=0.45)
    heavier.__dict__["oscillator"] = mechanism.oscillator
    assert energy_control(heavier, history, equation="exact").met is False
    path, events = trace_with_events(mechanism.oscillator, MOTION, scale=0.45, equation="exact")
    side = replace(mechanism.oscillator.positive, restitution=0.89)
    bouncy = replace(mechanism.oscillator, positive=side, negative=side)
    sides = branch_energies(mechanism, mechanism.oscillator, "exact")
    right = energy_balance(path, events, mechanism.oscillator, sides, MOTION, scale=0.45)
    wrong = energy_balance(path, events, bouncy, sides, MOTION, scale=0.45)
    assert off(right) < 1e-7
    assert off(wrong) > 10 * CONTROL_TOLERANCE["energy"]


def off(found: EnergyBalance) -> float:
    worst = found.worst
    return float(abs(found.energy + found.lost - found.work)[worst] / found.energy.max())


def test_free_rocking_gives_back_what_was_lifted() -> None:
    mechanism = single()
    found = energy_control(mechanism, None, equation="exact")
    assert found.met
    assert found.difference == pytest.approx(0.0, abs=1e-8)
    heavier = single(1010.0)
    heavier.__dict__["oscillator"] = mechanism.oscillator
    assert energy_control(heavier, None, equation="exact").met is False


def test_a_vibration_is_followed_at_more_samples_of_the_same_motion() -> None:
    phi = np.linspace(0.0, 0.3, 301)
    stiff = Branch(
        phi, np.full_like(phi, 10.0), 4e6 * phi * (0.2 - phi), *(np.ones((3, phi.size))), restitution=0.9,
        overturning=0.2, critical=0.2, overturning_flexible=0.2,
    )  # fmt: skip
    fine = sampled_finely(MOTION, Oscillator(stiff, stiff, 1.0))  # 45 Hz at 100 Hz: 2.8 rad from sample to sample
    parts = round(MOTION.dt / fine.dt)
    assert parts == 12
    assert fine.acceleration[::parts] == pytest.approx(MOTION.acceleration, abs=1e-12)
    assert fine.acceleration[parts // 2 :: parts] == pytest.approx(
        0.5 * (MOTION.acceleration[:-1] + MOTION.acceleration[1:])
    )
    assert sampled_finely(MOTION, single().oscillator) is MOTION


def wavy(nodes: int) -> Oscillator:
    """A block whose restoring moment has waves, on a table of some nodes."""
    phi = np.linspace(0.0, 0.3, nodes)
    one = np.ones_like(phi)
    waves = 1.0 + 0.3 * np.sin(80.0 * phi)
    return blocks.block(nodes=nodes, inertia=4.0 * one, restoring=g * (0.2 - phi) * waves, excitation=one)


def test_a_coarse_table_does_not_converge_and_a_fine_one_does() -> None:
    mechanism = single()
    fine, coarse = (convergence_control(mechanism, governing(wavy(n), scale=0.6)) for n in (513, 17))
    assert fine.quantity == coarse.quantity == "largest rotation over that of overturning"
    assert fine.met
    assert coarse.met is False
    assert coarse.difference is not None
    assert coarse.difference > 0.01
    falling = convergence_control(mechanism, governing(wavy(513), scale=20.0))
    assert (falling.quantity, falling.dimension, falling.met) == ("time of overturning", "time", True)


def test_without_a_history_the_overturning_rotation_is_found_on_a_coarser_table() -> None:
    mechanism = single()
    assert convergence_control(mechanism, None).met
    falls_later = replace(wavy(257).positive, overturning=0.21)  # the table falls to zero at 0.2 rad
    wrong = Oscillator(falls_later, falls_later, 1.0)
    mechanism.__dict__["variants"] = replace(mechanism.variants, starting=wrong, collapse=wrong)
    found = convergence_control(mechanism, None)
    assert (found.quantity, found.met) == ("overturning rotation", False)


def test_every_second_node_is_kept_and_jumps_stay() -> None:
    assert every_second(np.array([0.0, 1.0, 2.0, 3.0, 3.0, 4.0, 5.0])).tolist() == [0, 2, 3, 4, 6]


def results_of(folder: Path, *, jobs: int = 1, **tables) -> Results:
    write_noise(folder / "a.csv", amplitude=4.0)
    given = {"records": {"files": ["a.csv"]}, "site": {"limit_state": "DBE", "spectrum": ASCE7}} | tables
    return run_study(study_of(folder, project_toml(**given)), jobs=jobs)


MECHANISMS = {
    "wall": block(),
    "soft": block(interface={"model": "flexible", "stiffness": "2 GPa/m", "strength": "1 MPa"}),
    "tied": block(
        loads=[{"kind": "tie", "at": [0.0, 3.9], "force": "2 kN", "direction": [-1, 0]}],
        sides="one",
        direction=[1, 0, 0],
    ),
    "breaking": block(
        loads=[
            {
                "kind": "tie",
                "at": [0.0, 3.9],
                "force": "3 kN",
                "direction": [-1, 0],
                "until": "20 mm",
                "strength": "9 kN",
                "length": "4 m",
                "fracture_strain": 0.2,
            }
        ],
        sides="one",
        direction=[1, 0, 0],
        restitution=0.9,
    ),
    "table": published(),
}
BAR = {"kind": "tie", "at": [0.0, 3.9], "anchor": [-4.0, 3.9], "force": "2 kN", "area": "113 mm^2"}
BAR |= {"young_modulus": "210 GPa", "yield_stress": "235 MPa", "length": "4 m", "fracture_strain": 0.1}


@pytest.mark.parametrize(("sides", "force"), [("one", "2 kN"), ("one", "25 kN"), ("two", "2 kN")])
def test_the_controls_of_a_wall_with_a_tie_that_stretches_hold(tmp_path: Path, sides: str, force: str) -> None:
    """Where it rocks, and where its pretension holds it still."""
    wall = block(
        loads=[{**BAR, "force": force, "strength": "60 kN"}], sides=sides, direction=[1, 0, 0], restitution=0.9
    )
    sources = {"report": {"sources": {"mechanisms.wall.loads[1]": "measured: tests"}}}
    results = results_of(tmp_path, mechanisms={"wall": wall}, **sources)
    assert [each.quantity for each in results.controls if each.met is False] == []
    assert sum(each.met is True for each in results.controls) >= 4


def test_a_wrong_multiplier_of_moved_hinges_shows_in_their_reactions(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """On joints the multiplier is not that of the forces, which a fault in their equilibrium would carry along."""
    (soft,) = study_of(tmp_path, project_toml(mechanisms={"soft": MECHANISMS["soft"]})).mechanisms
    assert all(each.met for each in equilibrium_controls(soft, soft.oscillator))
    monkeypatch.setattr(
        "assess.study.controls.hinge_forces",
        lambda mechanism: tuple(
            replace(each, acceleration=1.001 * each.acceleration, horizontal=1.001 * each.horizontal)
            for each in hinge_forces(mechanism)
        ),
    )
    vertical, horizontal = equilibrium_controls(soft, soft.oscillator)
    assert (vertical.met, horizontal.met) == (True, False)


def test_a_run_controls_every_mechanism_whatever_the_number_of_jobs(tmp_path: Path) -> None:
    found = results_of(tmp_path, mechanisms=MECHANISMS)
    expected = {
        "wall": [True] * 5,
        "soft": [True, True, True, None, True],
        "tied": [True] * 5,
        "breaking": [True] * 5,
        "table": [None, None, True, True, None],  # by the linearised equation
    }
    order = ["equilibrium", "equilibrium", "energy", "hand-multiplier", "convergence"]
    for name, met in expected.items():
        assert [(each.kind, each.met) for each in found.controls if each.mechanism == name] == list(
            zip(order, met, strict=True)
        ), name
    assert [each.mechanism for each in found.controls] == [name for name in MECHANISMS for _ in order]
    assert not [each for each in found.warnings if each.key in ("control-energy-lost", "control-not-in-equilibrium")]
    assert dumps(results_of(tmp_path, mechanisms=MECHANISMS, jobs=2)) == dumps(found)


def test_a_swept_mechanism_is_controlled_in_its_controlling_case(tmp_path: Path) -> None:
    sweep = {"key": "bodies.wall.box.height", "values": ["3 m", "4.5 m"]}
    found = results_of(tmp_path, analysis={"sweep": sweep})
    multiplier = next(each for each in found.controls if each.kind == "hand-multiplier")
    assert multiplier.value == found.mechanisms[0].oscillator.uplift_multiplier
    assert all(each.met for each in found.controls)


def test_a_control_that_fails_warns(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(CONTROL_TOLERANCE, "energy", -1.0)  # type: ignore[misc]
    found = results_of(tmp_path)
    (said,) = [each for each in found.warnings if each.key.startswith("control-")]
    assert (said.key, said.where, said.severity) == ("control-energy-lost", "wall", "warning")
    assert control_warnings(found.controls) == (said,)
