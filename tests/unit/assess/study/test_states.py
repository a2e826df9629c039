"""The worse of two states decides: the project as typed, and without the values that no source vouches for."""

import copy
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from assess.codes.verdict import SAME_MARGIN, Decision, MechanismOutcome, State, Verdict
from assess.errors import ProjectError
from assess.project.build import build, build_to_decide
from assess.project.project_file import load, load_tree
from assess.study import states
from assess.study.run import find_verdict, run_study
from assess.study.study import Replaceable, Study
from tests.support.projects import NTC, block, lines, project_toml, wall
from tools.adversary.projects import HISTORIES, ITALY, PROJECTS
from tools.adversary.trials import answer

BUILDING = {"storeys": 2, "ground_elevation": 0.0, "use_class": "II"}
HEIGHT = 7.4  # of the top of the wall, which is the highest body
THIN = 0.16  # of a wall that needs a tie
PULLED = "measured: pull-out tests of two anchors"


def verdict_of(
    folder: Path,
    *,
    height: float = HEIGHT,
    thickness: float = 0.3,
    tie: str = "",
    sources: dict[str, str] | None = None,
) -> Verdict:
    """Return the verdict on a wall on the upper floor."""
    text = project_toml(
        site={"spectrum": NTC, "limit_state": "SLV"},
        building={**BUILDING, "height": height},
        materials={"m": {"density": 1800, "disintegration": "excluded"}},
        report={"sources": {"materials.m.disintegration": "measured: survey", **(sources or {})}},
        analysis={"procedures": ["ntc2018-nonlinear"], "scan": False},
        records={"synthetic": {"count": 1, "duration": "25 s"}},
        bodies={"wall": wall(thickness, 3.0, 3.0, material="m", base=[0.0, 0.0, HEIGHT - 3.0])},
        mechanisms={"wall": lines(block(direction=[1, 0, 0], sides="one"), f"loads = [{tie}]")},
    )
    (folder / "project.toml").write_text(text, encoding="utf-8")
    found = run_study(build(load(folder)), jobs=1).verdict
    assert found is not None
    return found


def by_seed(folder: Path, seed: int | None, *, sourced: bool = False) -> Verdict:
    """Return the verdict by histories on a wall that seven artificial records shake."""
    text = project_toml(
        site={"spectrum": {"code": "asce7-16", "s_ds": "0.5 g", "s_d1": "0.2 g", "t_l": "8 s"}, "limit_state": "DBE"},
        verdict={"basis": "asce43-05", "procedures": ["asce43-05-history"]},
        report={"sources": {"records.synthetic.seed": "measured: prescribed by the client"}} if sourced else None,
        analysis={"procedures": ["asce43-05-history"], "levels": ["0.3 g", "0.4 g"]},
        records={"synthetic": {"count": 7, "duration": "20 s", **({} if seed is None else {"seed": seed})}},
        bodies={"wall": wall(0.6, 3.0, 2.0)},
        mechanisms={"wall": lines(block(direction=[1, 0, 0]))},
    )
    (folder / "project.toml").write_text(text, encoding="utf-8")
    found = run_study(build(load(folder)), jobs=1).verdict
    assert found is not None
    return found


def test_of_a_typed_seed_both_suites_run_and_the_worse_decides(tmp_path: Path) -> None:
    (untyped,) = by_seed(tmp_path, None).mechanisms
    for seed in (1, 2):
        (typed,) = by_seed(tmp_path, seed, sourced=True).mechanisms
        both = by_seed(tmp_path, seed)
        (decides,) = both.mechanisms
        assert None not in (untyped.margin, typed.margin, decides.margin)
        assert typed.margin != untyped.margin
        assert both.other_state is not None
        assert decides.margin <= min(typed.margin, untyped.margin) * 1.01  # type: ignore[operator, type-var]


def tie(**more: Any) -> str:
    """Return a tie at the top of the wall that lasts up to collapse."""
    given = {
        "force": "15 kN",
        "strength": "40 kN",
        "length": "6 m",
        "fracture_strain": 0.1,
        "until": "collapse",
        **more,
    }
    place = "at = [-0.15, 7.3], anchor = [-6.0, 7.3]"
    rest = ", ".join(
        f'{key} = "{value}"' if isinstance(value, str) else f"{key} = {value}" for key, value in given.items()
    )
    return f'{{ kind = "tie", {place}, {rest} }}'


@pytest.mark.parametrize("typed", [9.0, 300.0])
def test_a_building_typed_higher_than_it_is_drawn_is_as_high_as_drawn(tmp_path: Path, typed: float) -> None:
    drawn, found = verdict_of(tmp_path), verdict_of(tmp_path, height=typed)
    (line,) = found.overrides
    assert (found.state, line.key, line.source) == (State.REPLACED, "building.height", "")
    assert found.mechanisms == drawn.mechanisms
    assert found.other_state is not None
    assert found.other_state.mechanisms[0].margin > drawn.mechanisms[0].margin


def test_a_building_within_ten_per_cent_of_the_highest_body_is_as_typed(tmp_path: Path) -> None:
    found = verdict_of(tmp_path, height=1.09 * HEIGHT)
    assert (found.state, found.overrides, found.other_state) == (State.AS_TYPED, (), None)


def test_a_source_lets_the_height_stand_and_its_worth_be_seen(tmp_path: Path) -> None:
    drawn = verdict_of(tmp_path)
    found = verdict_of(tmp_path, height=9.0, sources={"building.height": "measured: survey of the roof"})
    (line,) = found.overrides
    assert (found.state, line.margin_instead) == (State.AS_TYPED, drawn.mechanisms[0].margin)
    assert found.mechanisms[0].margin > drawn.mechanisms[0].margin


def test_a_tie_with_its_source_is_one_line_with_the_outcome_without_it(tmp_path: Path) -> None:
    without = verdict_of(tmp_path, thickness=THIN)
    found = verdict_of(tmp_path, thickness=THIN, tie=tie(), sources={"mechanisms.wall.loads[1]": PULLED})
    (line,) = found.overrides
    assert (found.state, found.outcome, without.outcome) == (State.AS_TYPED, Decision.PASS, Decision.FAIL)
    assert (line.key, line.source) == ("mechanisms.wall.loads[1].force", PULLED)
    assert (line.outcome_instead, line.margin_instead) == (Decision.FAIL, without.mechanisms[0].margin)


def test_a_source_for_the_mechanism_or_all_its_loads_vouches_for_no_tie(tmp_path: Path) -> None:
    without = verdict_of(tmp_path, thickness=THIN)
    for key in ("mechanisms.wall", "mechanisms.wall.loads"):
        found = verdict_of(tmp_path, thickness=THIN, tie=tie(), sources={key: PULLED})
        assert found.outcome == without.outcome == Decision.FAIL


def test_a_source_that_vouches_for_no_value_is_told() -> None:
    tables = copy.deepcopy(PROJECTS["ntc-joint"])
    too_much = ("mechanisms", "mechanisms.wall", "bodies", "materials")
    tables["report"]["sources"] |= dict.fromkeys((*too_much, "bodies.wall.box", "mechanisms.wall.direction"), TESTED)
    study = build_to_decide(load_tree(tables, Path("project.toml"), sha256=""))
    told = [str(each.values["key"]) for each in study.messages if each.key == "source-of-too-much"]
    assert told == list(too_much)


def test_a_tie_behind_one_that_is_left_out_keeps_its_source(tmp_path: Path) -> None:
    """Of two ties the first has no source: in the state without it the second stays, and its source is its own."""
    alone = verdict_of(tmp_path, thickness=THIN, tie=tie(), sources={"mechanisms.wall.loads[1]": PULLED})
    both = f"{tie(force='5 kN')}, {tie()}"
    found = verdict_of(tmp_path, thickness=THIN, tie=both, sources={"mechanisms.wall.loads[2]": PULLED})
    assert found.other_state is not None
    assert found.other_state.mechanisms[0].margin == pytest.approx(alone.mechanisms[0].margin, rel=1e-12)


def weakest_against(folder: Path, mechanism: dict[str, Any], *, sources: dict[str, str] | None = None) -> Verdict:
    """Return the verdict on a thin wall on the ground, with a mechanism of it."""
    text = project_toml(
        site={"spectrum": NTC | {"a_g": "0.25 g"}, "limit_state": "SLV"},
        building={**BUILDING, "height": 4.5},
        materials={"m": {"density": 1800, "disintegration": "excluded"}},
        report={"sources": {"materials.m.disintegration": "measured: survey", **(sources or {})}},
        analysis={"procedures": ["ntc2018-nonlinear"], "scan": False},
        bodies={"wall": wall(0.2, 3.0, 4.5, material="m")},
        mechanisms={"wall": block(**mechanism)},
    )
    (folder / "project.toml").write_text(text, encoding="utf-8")
    return find_verdict(build(load(folder)))


LOADED = {"loads": [{"kind": "overburden", "force": "10 kN"}]}
SURVEYED = "measured: the crack that was surveyed"


@pytest.mark.parametrize(
    ("key", "typed", "weakest"),
    [
        ("direction", {"direction": [0, 1, 0]}, {"direction": [1, 0, 0]}),
        ("direction", {"direction": [1, 3, 0], "loads": [{"kind": "mass", "mass": 10, "at": [0.0, 4.5]}]}, None),
        ("crack", {"kind": "two-block", "crack": 0.05, **LOADED}, {"kind": "two-block", "crack": "minimum", **LOADED}),
    ],
)
def test_the_weakest_is_examined_with_a_choice_that_is_stronger_unless_that_has_a_source(
    tmp_path: Path, key: str, typed: dict[str, Any], weakest: dict[str, Any] | None
) -> None:
    """A wall examined along its length, or cracked next to the floor, is that which falls across its thickness."""
    of_load = {"mechanisms.wall.loads[1]": "measured: survey"} if "loads" in typed else {}
    found = weakest_against(tmp_path, typed, sources=of_load)
    shown = weakest_against(tmp_path, typed, sources={f"mechanisms.wall.{key}": SURVEYED, **of_load})
    assert (found.state, shown.state) == (State.REPLACED, State.AS_TYPED)
    assert found.mechanisms[0].margin < 0.9 * shown.mechanisms[0].margin
    if weakest is not None:
        expected = weakest_against(tmp_path, weakest, sources=of_load)
        assert found.mechanisms[0].margin == pytest.approx(expected.mechanisms[0].margin, rel=1e-9)


def test_between_a_period_without_a_source_and_the_codes_the_worst_decides(tmp_path: Path) -> None:
    """The floor's spectrum peaks between them: both ends hold where a period in between fails."""
    stated, code = 3.0, 0.05 * HEIGHT**0.75
    margins = [mode_of(tmp_path, period, shown=True).mechanisms[0].margin for period in np.geomspace(stated, code, 5)]
    found = mode_of(tmp_path, stated, shown=False)
    assert found.mechanisms[0].margin == pytest.approx(min(margins), rel=1e-9)
    assert min(margins) < 0.99 * min(margins[0], margins[-1])


def mode_of(folder: Path, period: float, *, shown: bool) -> Verdict:
    """Return the verdict on a wall on the upper floor of a building of a first period."""
    text = project_toml(
        site={"spectrum": NTC, "limit_state": "SLV"},
        building={**BUILDING, "height": HEIGHT, "period": float(period)},
        materials={"m": {"density": 1800, "disintegration": "excluded"}},
        report={
            "sources": {"materials.m.disintegration": "measured: survey"}
            | ({"building.period": "measured: ambient vibrations"} if shown else {})
        },
        analysis={"procedures": ["ntc2018-nonlinear"], "scan": False},
        bodies={"wall": wall(0.3, 3.0, 3.0, material="m", base=[0.0, 0.0, HEIGHT - 3.0])},
        mechanisms={"wall": block(direction=[1, 0, 0], sides="one")},
    )
    (folder / "project.toml").write_text(text, encoding="utf-8")
    return find_verdict(build(load(folder)))


WALLS = {"low": (0.12, 1.0), "middling": (0.3, 2.0), "high": (0.3, 3.0)}  # m: thickness, height up to the top


@pytest.mark.parametrize("swept", [False, True])
def test_every_mechanism_counts_by_the_worst_of_the_range_for_itself(tmp_path: Path, swept: bool) -> None:
    """Leaving out a source improves no mechanism, though the worst period of one is not that of another."""
    code, stated = 0.05 * HEIGHT**0.75, 3.0
    tried = [periods_of(tmp_path, period, shown=True, swept=swept) for period in np.geomspace(stated, code, 5)]
    unknown = periods_of(tmp_path, stated, shown=False, swept=swept)
    assert len({int(np.argmin([each[name] for each in tried])) for name in WALLS}) > 1
    for name in WALLS:
        assert unknown[name] == pytest.approx(min(each[name] for each in tried), rel=1e-9), name


def periods_of(folder: Path, period: float, *, shown: bool, swept: bool) -> dict[str, float]:
    """Return the margin of each of three walls on the upper floor of a building of a first period."""
    text = project_toml(
        site={"spectrum": NTC, "limit_state": "SLV"},
        building={**BUILDING, "height": HEIGHT, "period": float(period)},
        materials={"m": {"density": 1800, "disintegration": "excluded"}},
        report={
            "sources": {"materials.m.disintegration": "measured: survey"}
            | ({"building.period": "measured: ambient vibrations"} if shown else {})
        },
        analysis={"procedures": ["ntc2018-nonlinear"], "scan": False}
        | ({"sweep": {"key": "mechanisms.high.cut", "values": [HEIGHT - 2.9, HEIGHT - 2.0]}} if swept else {}),
        bodies={
            name: wall(thickness, 3.0, height, material="m", base=[0.0, 0.0, HEIGHT - height])
            for name, (thickness, height) in WALLS.items()
        },
        mechanisms={
            name: lines(
                block(name, direction=[1, 0, 0], sides="one"),
                f"cut = {HEIGHT - 1.0}" if swept and name == "high" else "",
            )
            for name in WALLS
        },
    )
    (folder / "project.toml").write_text(text, encoding="utf-8")
    study = build(load(folder))
    found = find_verdict(study) if shown else run_study(study, jobs=1).verdict
    assert found is not None
    margins = {each.mechanism: each.margin for each in found.mechanisms}
    known = {name: margin for name, margin in margins.items() if margin is not None}
    assert len(known) == len(WALLS)
    assert shown or find_verdict(study).mechanisms == found.mechanisms
    return known


def test_no_mechanism_counts_better_than_it_was_seen_with_two_ranges(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of 200 random tables of two mechanisms by two keys, each outcome that the search met is one that is run."""
    random = np.random.default_rng(1)
    values = [
        SimpleNamespace(
            key=key,
            source="",
            either_way=True,
            of_range=True,
            same=0.01,
            mechanisms=("A", "B"),
            place=(key,),
            setting={},
        )
        for key in "ab"
    ]
    monkeypatch.setattr(states, "_override", lambda value, outcomes: None)
    for _ in range(200):
        table = random.uniform(0.5, 1.5, (2, 2, 2))
        seen: dict[str, float] = {}

        def outcomes(replaced: Sequence[Any], table: Any = table, seen: dict[str, float] = seen) -> Any:
            at = tuple(int(value in replaced) for value in values)
            found = {name: float(margin) for name, margin in zip("AB", table[:, at[0], at[1]], strict=True)}
            seen.update({name: min(margin, seen.get(name, margin)) for name, margin in found.items()})
            passes = (Decision.FAIL, Decision.PASS)
            return {name: MechanismOutcome(name, passes[margin >= 1.0], margin) for name, margin in found.items()}

        class Trials:
            def __init__(self, *_: object) -> None:
                self.find = outcomes

            def without(self, value: Any) -> Any:
                return self.find([value])

            def as_typed(self, depth: object) -> Any:
                return self.find([])

            def beside(self, others: Any, standing: Any, each_way: Any) -> Any:
                ways = (
                    (value, self.find([*others, *([] if value is None else [value])])) for value in (None, *each_way)
                )
                return states._Ways(standing, tuple(ways), 0.01)

        monkeypatch.setattr(states, "_Trials", Trials)
        question = SimpleNamespace(basis="any")
        found = states.find_overrides(SimpleNamespace(replaceables=values, question=question), (), jobs=1)  # type: ignore[arg-type]
        met = dict(seen)
        for name in "AB":
            run = [(), found.replaced, *(each for each, names in found.apart if name in names)]
            assert min(outcomes(each)[name].margin for each in run) <= met[name] / (1.0 - SAME_MARGIN)


def test_two_values_that_hide_each_other_are_both_replaced() -> None:
    """The mild row and a weak S_X1 of ASCE 41-13: either alone lets the wall pass, so that neither alone is missed."""
    tables = copy.deepcopy(PROJECTS["asce41-wall"])
    tables["procedures"] = {"asce41-13": {"position": "one-storey", "s_x1": 0.001}}
    found = answer(tables)
    assert found is not None
    assert found.outcome == Decision.FAIL
    assert "procedures.asce41-13.position" in found.named


JOINT = "mechanisms.wall.interface"
TESTED = "measured: a test of the joint"
RANGE = ("0.15 GPa/m", "4 GPa/m", "100 GPa/m")


def on_joint(interface: dict[str, Any], *, source: str = "", modulus: str = "", of_modulus: str = "") -> dict[str, Any]:
    """Return a wall on a joint."""
    tables = copy.deepcopy(PROJECTS["ntc-joint"])
    tables["mechanisms"]["wall"]["interface"] = interface
    if modulus:
        tables["materials"]["stone"]["young_modulus"] = modulus
    given = {JOINT: source, "materials.stone.young_modulus": of_modulus}
    tables["report"] = {"sources": tables["report"]["sources"] | {key: text for key, text in given.items() if text}}
    return tables


def verdict_on(tables: dict[str, Any]) -> Verdict:
    """Return the verdict on a project."""
    return find_verdict(build_to_decide(load_tree(copy.deepcopy(tables), Path("project.toml"), sha256="")))


def substitutes(tables: dict[str, Any], key: str) -> list[Replaceable]:
    """Return what is tried in place of the value at a key."""
    study = build_to_decide(load_tree(copy.deepcopy(tables), Path("project.toml"), sha256=""))
    return [each for each in study.replaceables if each.key == key]


@pytest.mark.parametrize("stiffness", ["2 TPa/m", "10 GPa/m", "0.1 GPa/m"])
def test_of_a_joint_without_a_source_the_worst_stiffness_of_masonry_decides(stiffness: str) -> None:
    """One softer than any of the range is itself the worst."""
    tested = {
        each: verdict_on(on_joint({"model": "flexible", "stiffness": each}, source=TESTED)).mechanisms[0].margin
        for each in (*RANGE, stiffness)
    }
    worst = min(tested, key=lambda each: tested[each] or 0.0)
    found = verdict_on(on_joint({"model": "flexible", "stiffness": stiffness}))
    assert found.mechanisms[0].margin == pytest.approx(tested[worst], rel=1e-9)
    assert [(each.key, each.instead) for each in found.overrides] == (
        [] if worst == stiffness else [(f"{JOINT}.stiffness", worst)]
    )
    assert all(f"with the worst of its range, {each.instead}: fail" in each.message.text for each in found.overrides)


@pytest.mark.parametrize("key", [JOINT, f"{JOINT}.stiffness"])
def test_a_source_for_a_joint_or_its_stiffness_lets_it_stand_with_its_worth(key: str) -> None:
    tables = on_joint({"model": "flexible", "stiffness": "100 GPa/m"})
    tables["report"]["sources"][key] = TESTED
    shown = run_study(build(load_tree(tables, Path("project.toml"), sha256="")), jobs=1).verdict
    soft = verdict_on(on_joint({"model": "flexible", "stiffness": "0.15 GPa/m"}, source=TESTED))
    assert shown is not None
    (line,) = shown.overrides
    assert (shown.state, line.instead, line.source) == (State.AS_TYPED, "0.15 GPa/m", TESTED)
    assert line.margin_instead == pytest.approx(soft.mechanisms[0].margin, rel=1e-9)
    assert shown.mechanisms[0].margin > 1.2 * line.margin_instead  # type: ignore[operator]


def test_the_softest_joint_of_the_range_overturns_where_moments_say() -> None:
    """By hand: N (t/2 - a/3) = N phi h/2 with the contact a = sqrt(2 N / (k phi l)) of a triangle of stress."""
    tables = on_joint({"model": "flexible", "stiffness": "10 GPa/m"})
    (soft,) = (each for each in substitutes(tables, f"{JOINT}.stiffness") if each.instead == "0.15 GPa/m")
    t, h, k, weight = 0.4, 4.5, 0.15e9, 1900 * 9.80665 * 0.4 * 4.5
    phi = 0.08
    for _ in range(50):
        phi = 2 * (t / 2 - (2 * weight / (k * phi)) ** 0.5 / 3) / h
    (mechanism,) = soft.study_at("wall").mechanisms
    assert mechanism.oscillator.positive.unstable == pytest.approx(phi, rel=5e-3)


def test_a_course_or_a_modulus_without_a_source_is_worth_no_more_than_the_range() -> None:
    """0.15 GPa over a course of 0.2 m is 0.75 GPa/m; without a source for the course the joint is as soft as any."""
    course = {"model": "flexible", "course_thickness": "0.2 m"}
    for joint, source, of_modulus, worst in (
        (course, TESTED, "", "0.75 GPa/m"),
        (course, "", TESTED, "0.15 GPa/m"),
        ({"model": "semi-flexible", "stiffness": "20 GPa/m"}, "", "", "0.15 GPa/m"),
    ):
        found = verdict_on(on_joint(joint, source=source, modulus="20 GPa", of_modulus=of_modulus))
        soft = verdict_on(on_joint({"model": "flexible", "stiffness": worst}, source=TESTED))
        margin, expected = found.mechanisms[0].margin, soft.mechanisms[0].margin
        assert margin == pytest.approx(expected, rel=1e-9 if joint is course else 0.01), (joint, source)
    sourced = verdict_on(on_joint(course, source=TESTED, modulus="20 GPa", of_modulus=TESTED))
    assert (sourced.state, sourced.overrides) == (State.AS_TYPED, ())


@pytest.mark.parametrize("sides", ["two", "one"])
@pytest.mark.parametrize("written", [0.3, {"positive": 0.3, "negative": 0.3}])
def test_a_restitution_without_a_source_stands_beside_that_of_the_formula(written: Any, sides: str) -> None:
    """Housner: 1 - 3/2 sin^2 alpha; on one side the rebound of 3.45 with its range, which histories go over."""
    tables = copy.deepcopy(HISTORIES["own-histories"])
    tables["mechanisms"]["wall"] |= {"restitution": written, "sides": sides}
    keys = ("restitution",) if isinstance(written, float) else ("restitution.positive", "restitution.negative")
    housner = 1 - 1.5 * 0.4**2 / (0.4**2 + 4.5**2)
    expected = housner if sides == "two" else housner**2 * (1.5 * 4.5**2 / (0.4**2 + 4.5**2) - 1)
    for number, key in enumerate(keys):
        found, *between = substitutes(tables, f"mechanisms.wall.{key}")
        (mechanism,) = found.study_at("wall").mechanisms
        if number == 0 or sides == "two":
            ((half_way,),) = (each.study_at("wall").mechanisms for each in between)
            assert mechanism.restitution[number] == pytest.approx(expected, rel=1e-9)
            assert half_way.restitution[number] == pytest.approx((0.3 * expected) ** 0.5, rel=1e-9)
            assert mechanism.rebounds == ((1.0,) if sides == "two" else (1.0, 0.5, 1.5))
        assert (found.of_range, found.source) == (True, "")


def test_a_restitution_written_as_one_number_buys_no_pass_by_histories() -> None:
    """Also where a method without histories may decide too, on which it has no bearing."""
    tables = copy.deepcopy(HISTORIES["own-histories"])
    tables["mechanisms"]["wall"]["restitution"] = 0.5
    tables["site"] = {"spectrum": ITALY | {"a_g": "0.12 g"}, "limit_state": "SLV"}
    tables["verdict"] = {"basis": "ntc2018", "procedures": ["ntc2018-history", "ntc2018-nonlinear"]}
    found = verdict_on(tables)
    (line,) = found.overrides
    assert (found.outcome, line.key) == (Decision.FAIL, "mechanisms.wall.restitution")
    assert found.other_state is not None
    assert found.other_state.outcome == Decision.PASS
    tables["report"]["sources"]["mechanisms.wall.restitution"] = TESTED
    assert verdict_on(tables).outcome == Decision.PASS


@pytest.mark.parametrize("table", ["mechanisms.wall.amplification", "building"])
def test_a_mode_typed_higher_than_two_thirds_of_the_drawing_is_as_drawn(table: str) -> None:
    """The motion at a height h is h / h_e of the mode: a higher resultant shakes the wall less, wherever typed."""
    for typed, replaced in ((1.0, False), (1.01, True)):
        tables = copy.deepcopy(HISTORIES["own-histories-upstairs"])
        drawn = 2.0 / 3.0 * tables["building"]["height"]
        amplification = tables["mechanisms"]["wall"]["amplification"]
        (tables["building"] if table == "building" else amplification)["effective_height"] = typed * drawn
        if table == "building":
            del amplification["effective_height"]
        found = substitutes(tables, f"{table}.effective_height")
        assert len(found) == replaced
        for each in found:
            (there,) = each.study_at("wall").amplified.values()
            assert there.amplification.mode.effective_height == pytest.approx(drawn, rel=1e-9)  # type: ignore[union-attr]


def test_an_ordinate_of_no_source_that_helps_a_failing_wall_has_its_line() -> None:
    """ASCE 41-13 permits no such wall at any S_X1, so that margins are 0; h/t over the table's tells them apart."""
    tables = copy.deepcopy(PROJECTS["asce41-wall"])
    tables["bodies"]["wall"]["box"]["thickness"] = "0.2 m"  # h/t = 22.5, above 20 of the mildest row and column
    alone = verdict_on(tables)
    tables["procedures"] = {"asce41-13": {"s_x1": "0.2 g"}}
    found = verdict_on(tables)
    assert alone.mechanisms[0].margin == found.mechanisms[0].margin == 0.0
    assert alone.index is not None
    assert (found.outcome, found.index, found.state) == (Decision.FAIL, alone.index, State.REPLACED)
    (line,) = [each for each in found.overrides if each.key == "procedures.asce41-13.s_x1"]
    assert line.index_instead == alone.index
    assert f"without it: fail, D/C {alone.index.value:.3g}" in line.message.text


def test_a_strength_of_the_masonry_without_a_source_is_the_least_of_the_table_where_joints_crush() -> None:
    """Circolare 7/2019, Table C8.5.I: 1 MPa of disordered rubble; a joint with a strength of its own asks for none."""

    def verdict_of_strength(strength: str, source: str, own: str = "") -> Verdict:
        tables = on_joint(
            {"model": "flexible", "stiffness": "4 GPa/m", **({"strength": own} if own else {})}, source=TESTED
        )
        tables["materials"]["stone"]["compressive_strength"] = strength
        tables["procedures"] = {"ntc2018": {"knowledge_level": "LC1"}}
        tables["report"]["sources"] |= {"materials.stone.compressive_strength": source} if source else {}
        return verdict_on(tables)

    least, strong = (verdict_of_strength(each, TESTED).mechanisms[0].margin for each in ("1 MPa", "20 MPa"))
    found = verdict_of_strength("20 MPa", "")
    assert found.mechanisms[0].margin == pytest.approx(least, rel=1e-9)
    assert strong > 1.02 * least  # type: ignore[operator]
    (line,) = found.overrides
    assert line.key == "materials.stone.compressive_strength"
    assert line.message.text.startswith(f'{line.key} = "20 MPa" has no source; with 1 MPa: fail, up to ')
    assert (
        verdict_of_strength("0.8 MPa", "").overrides == verdict_of_strength("20 MPa", "", own="2 MPa").overrides == ()
    )


def scanned_wall(thickness: str, height: str, a_g: str) -> dict[str, Any]:
    """Return a wall on which histories at rising PGA decide."""
    tables = copy.deepcopy(HISTORIES["own-histories"])
    tables["bodies"]["wall"]["box"] |= {"thickness": thickness, "height": height}
    tables["site"]["spectrum"]["a_g"] = a_g
    tables["procedures"] = {"ntc2018": {"knowledge_level": "LC1"}}
    tables["analysis"]["scan"] = True
    return tables


def test_beside_a_weak_masonry_the_stiffness_that_is_worst_there_decides_also_as_histories_rise() -> None:
    """Alone, 4 GPa/m overturns first; beside 1 MPa, 0.15 GPa/m does, and the suite at the site's PGA shows neither."""

    def margin_of(stiffness: str, strength: str, *keys: str) -> float | None:
        tables = scanned_wall("0.3 m", "2.2 m", "0.06 g")
        tables["mechanisms"]["wall"]["interface"] = {"model": "flexible", "stiffness": stiffness}
        tables["materials"]["stone"]["compressive_strength"] = strength
        tables["report"]["sources"] |= dict.fromkeys(keys, TESTED)
        return verdict_on(tables).mechanisms[0].margin

    keys = (f"{JOINT}.stiffness", "materials.stone.compressive_strength")
    tested = [margin_of(stiffness, "1 MPa", *keys) or 0.0 for stiffness in (*RANGE, "10 GPa/m")]
    assert margin_of("10 GPa/m", "20 MPa", *keys) > 1.1  # type: ignore[operator]
    assert margin_of("10 GPa/m", "20 MPa") == pytest.approx(min(tested), rel=1e-9)
    assert min(tested) < 0.95


@pytest.mark.parametrize("sides", ["two", "one"])
def test_a_restitution_without_a_source_raises_no_pga_at_capacity(sides: str) -> None:
    """At the site's PGA the wall does not lift off, so that nothing tells the two apart there."""
    tables = scanned_wall("0.6 m", "3 m", "0.1 g")
    tables["mechanisms"]["wall"] |= {"sides": sides, "restitution": 0.1}
    found = verdict_on(tables)
    tables["report"]["sources"]["mechanisms.wall.restitution"] = TESTED
    tested = verdict_on(tables)
    del tables["mechanisms"]["wall"]["restitution"]
    by_formula = verdict_on(tables)
    assert [each.key for each in found.overrides] == ["mechanisms.wall.restitution"]
    assert found.mechanisms[0].margin == by_formula.mechanisms[0].margin
    assert tested.mechanisms[0].margin > 1.1 * by_formula.mechanisms[0].margin  # type: ignore[operator]


@pytest.mark.parametrize(
    "typed",
    ["0.4 s", {"length": "2 m", "thickness": "0.3 m", "young_modulus": "0.075 GPa", "density": "1900 kg/m^3"}],
)
def test_of_a_period_before_uplift_without_a_source_the_worst_down_to_0_decides(typed: Any) -> None:
    """The floor shakes most what vibrates as the building does: neither what is rigid nor what is slow."""
    tables = copy.deepcopy(PROJECTS["ntc-upstairs"])
    tables["verdict"]["procedures"] = ["ntc2018-linear"]
    key = "procedures.ntc2018.free_periods.wall"

    def stating(period: Any, source: str) -> dict[str, Any]:
        given = {"procedures": {"ntc2018": {"free_periods": {"wall": period}}}} if period else {}
        sources = {key: source} if period and source else {}
        return {**tables, **given, "report": {"sources": tables["report"]["sources"] | sources}}

    study = study_of_tables(stating(typed, ""))
    slow = study.free_periods["wall"].value
    tried = [each.study_at("wall").free_periods.get("wall") for each in study.replaceables if each.key == key]
    periods = [0.0 if each is None else each.value for each in tried]
    assert periods == pytest.approx([share * slow for share in (0.0, 0.75, 0.5, 0.25)], rel=1e-9)
    margins = [verdict_on(stating(each, TESTED)).mechanisms[0].margin for each in (slow, *periods)]
    assert verdict_on(stating(typed, "")).mechanisms[0].margin == pytest.approx(min(margins), rel=1e-9)  # type: ignore[type-var]
    assert min(margins) < 0.95 * min(margins[:2])  # type: ignore[operator, type-var]


def test_a_level_of_knowledge_of_one_mechanism_needs_its_source_too() -> None:
    """It stood as typed beside the level of all mechanisms, which is replaced."""

    def with_level(options: dict[str, Any], source: str = "") -> Verdict:
        tables = on_joint({"model": "flexible", "stiffness": "4 GPa/m", "strength": "2 MPa"}, source=TESTED)
        tables["procedures"] = {"ntc2018": options}
        tables["report"]["sources"] |= {"procedures.ntc2018.knowledge_levels.wall": source} if source else {}
        return verdict_on(tables)

    least, own = {"knowledge_level": "LC1"}, {"knowledge_level": "LC1", "knowledge_levels": {"wall": "LC3"}}
    found = with_level(own)
    assert found.mechanisms[0].margin == pytest.approx(with_level(least).mechanisms[0].margin, rel=1e-9)
    assert [each.key for each in found.overrides] == ["procedures.ntc2018.knowledge_levels.wall"]
    assert with_level(own, TESTED).mechanisms[0].margin > 1.15 * found.mechanisms[0].margin  # type: ignore[operator]


def test_of_a_mode_typed_in_a_mechanism_what_lies_between_it_and_that_of_the_building_is_tried() -> None:
    """A building of 8 m has 0.05 H^0.75 = 0.238 s; the mode of the mechanism is 1 Hz. Even in ratio."""
    tables = copy.deepcopy(HISTORIES["own-histories-upstairs"])
    tables["mechanisms"]["wall"]["amplification"]["natural_frequency"] = 1.0
    tried = substitutes(tables, "mechanisms.wall.amplification.natural_frequency")
    absent, *tried = tried
    with pytest.raises(ProjectError, match="no young_modulus for Rayleigh's method"):
        absent.study_at("wall")
    found = [each.study_at("wall").amplified["wall"].amplification.mode.frequency for each in tried]  # type: ignore[attr-defined]
    end = 1 / (0.05 * 8.0**0.75)
    assert found == pytest.approx([end**share for share in (0.25, 0.5, 0.75, 1.0)], rel=1e-9)
    tables["mechanisms"]["wall"]["amplification"]["natural_frequency"] = 1e4  # no stiffer than what moves as the ground
    _, stiffest, *_ = substitutes(tables, "mechanisms.wall.amplification.natural_frequency")
    assert stiffest.setting == {stiffest.place: pytest.approx(33.0 * (end / 33.0) ** 0.25, rel=1e-9)}


def test_a_modulus_that_gives_the_first_mode_needs_its_source() -> None:
    """By Rayleigh's method, where neither the building nor the mechanism states a frequency; it stood as typed."""
    tables = copy.deepcopy(HISTORIES["own-histories-upstairs"])
    tables["bodies"]["wall"]["box"] |= {"height": "8 m", "base": [0.0, 0.0, 0.0]}
    tables["materials"]["stone"]["young_modulus"] = "3 GPa"
    tables["mechanisms"]["wall"] |= {"cut": 4.0, "amplification": {"method": "modal-filter"}}
    del tables["building"]["height"]
    tried = substitutes(tables, "materials.stone.young_modulus")
    frequencies = [each.study_at("wall").amplified["wall"].amplification.mode.frequency for each in tried]  # type: ignore[attr-defined]
    assert [each.instead for each in tried] == ["0.15 GPa", "1.5 GPa", "15 GPa"]
    np.testing.assert_allclose(np.array(frequencies) / frequencies[0], np.sqrt([1.0, 10.0, 100.0]), rtol=1e-6)


def study_of_tables(tables: dict[str, Any]) -> Study:
    """Return the study of a project."""
    return build_to_decide(load_tree(copy.deepcopy(tables), Path("project.toml"), sha256=""))


VALUES = {"mass": "8000 kg", "centroid": [0.0, 2.25], "inertia": "14000 kg*m^2", "disintegration": "excluded"}
BY_VALUES: dict[str, Any] = {
    "bodies": {"wall": VALUES},
    "mechanisms": {"wall": {"kind": "single-block", "blocks": ["wall"], "sides": "one", "hinges": {"A": [2.0, 0.0]}}},
    "report": {"sources": {"bodies.wall.disintegration": TESTED}},
}
TABLED: dict[str, Any] = {
    "mechanisms": {
        "wall": {"kind": "equivalent-block", "p": 1.6, "uplift": 0.6, "radius": 2.84, "disintegration": "excluded"}
    },
    "report": {"sources": {"mechanisms.wall.disintegration": TESTED}},
}


@pytest.mark.parametrize(
    ("given", "vouched", "left"),
    [
        (BY_VALUES, (), ["bodies.wall.mass", "bodies.wall.centroid", "bodies.wall.inertia", "mechanisms.wall.hinges"]),
        (BY_VALUES, ("bodies.wall",), ["mechanisms.wall.hinges"]),
        (BY_VALUES, ("bodies.wall", "mechanisms.wall.hinges"), []),
        (TABLED, (), [f"mechanisms.wall.{key}" for key in ("p", "uplift", "radius", "elevation")]),
        (
            TABLED,
            ("mechanisms.wall.p", "mechanisms.wall.uplift", "mechanisms.wall.radius"),
            ["mechanisms.wall.elevation"],
        ),
    ],
)
def test_a_mechanism_by_values_alone_passes_on_the_condition_that_they_are_so(
    given: dict[str, Any], vouched: tuple[str, ...], left: list[str]
) -> None:
    """A hinge 2 m in front of a centroid is held against no outline."""
    tables = copy.deepcopy(PROJECTS["ntc-free"]) | copy.deepcopy(given)
    tables["report"]["sources"] |= dict.fromkeys(vouched, TESTED)
    found = verdict_on(tables)
    assert found.outcome == Decision.PASS
    told = [each.text.partition(": ")[2] for each in found.conditions if each.key == "not-drawn"]
    assert told == ([", ".join(left)] if left else [])


@pytest.mark.parametrize("vouched", [(), ("hinges",), ("hinges", "direction")])
def test_four_hinges_where_they_are_stated_pass_on_the_condition_that_no_others_form(vouched: tuple[str, ...]) -> None:
    """Halfway up the pier the last hinge makes of a frame that fails one that holds; nothing looks for a weaker one."""
    tables = copy.deepcopy(PROJECTS["ntc-portal"])
    assert verdict_on(tables).outcome == Decision.FAIL
    tables["mechanisms"]["wall"]["hinges"]["D"] = [3.2, 3.0]
    tables["report"]["sources"] = {
        key: source for key, source in tables["report"]["sources"].items() if not key.startswith("mechanisms.")
    } | {f"mechanisms.wall.{key}": TESTED for key in vouched}
    found = verdict_on(tables)
    assert found.outcome == Decision.PASS
    left = [f"mechanisms.wall.{key}" for key in ("hinges", "direction") if key not in vouched]
    told = [each.text.rpartition(": ")[2] for each in found.conditions if each.key == "not-sought"]
    assert told == ([", ".join(left)] if left else [])


ARCH_IN_PLAN = {
    "title": "arch",
    "building": {"height": 6.0, "storeys": 2, "ground_elevation": 0.0},
    "site": {
        "spectrum": {"code": "ntc2018", "a_g": "0.10 g", "f_0": 2.4, "t_c_star": 0.3, "soil": "B"},
        "limit_state": "SLV",
    },
    "procedures": {"ntc2018": {"knowledge_level": "LC1"}},
    "materials": {"stone": {"density": 2000, "disintegration": "excluded"}},
    "bodies": {
        "front": {"material": "stone", "box": {"thickness": 0.6, "length": 8, "height": 6, "base": [0.3, 4, 0]}},
        "side": {"material": "stone", "box": {"thickness": 6, "length": 0.5, "height": 6, "base": [3.6, 0.25, 0]}},
        "far": {"material": "stone", "box": {"thickness": 6, "length": 0.5, "height": 6, "base": [3.6, 7.75, 0]}},
    },
    "mechanisms": {
        "bay": {
            "kind": "horizontal-arch",
            "blocks": ["front"],
            "between": ["side", "far"],
            "direction": [-1, 0, 0],
            "ends": ["40 kN", "40 kN"],
        }
    },
}
"""A front that ends with its cross walls: nothing beyond them holds a thrust."""


def test_what_holds_the_ends_of_an_arch_needs_a_source() -> None:
    sources = {"materials.stone.disintegration": "measured: flat jacks, 3 May 2026, R. Rossi"}
    untold = verdict_on({**ARCH_IN_PLAN, "report": {"sources": sources}})
    (line,) = (each for each in untold.overrides if each.key == "mechanisms.bay.ends")
    assert (untold.state, untold.outcome, line.source) == (State.REPLACED, Decision.FAIL, "")
    told = verdict_on(
        {
            **ARCH_IN_PLAN,
            "report": {"sources": {**sources, "mechanisms.bay.ends": "measured: ties, 3 May 2026, R. Rossi"}},
        }
    )
    assert (told.state, told.outcome) == (State.AS_TYPED, Decision.PASS)


def without_substitute(study: Study, value: Replaceable, *, broken: bool) -> Study:
    """Return a study one of whose values no source vouches for; broken : nothing can be built without it."""

    def fails(name: str) -> Study:
        raise ProjectError("without it there is no such wall")

    def none_at_once(values: Any) -> Study:
        raise ProjectError("without it there is no such wall") if values else AssertionError

    changed = replace(value, source="", study_at=fails if broken else value.study_at)
    return replace(study, replaceables=(changed,), replaced=none_at_once if broken else study.replaced)


def test_no_pass_rests_on_a_value_without_a_source_that_nothing_can_stand_for(tmp_path: Path) -> None:
    """What cannot be built without a tie says nothing of the wall without it: a pass asks for a source."""
    tie = '{ kind = "tie", force = "12 kN", at = [0.8, 0, 1.8], direction = [-1, 0, 0] }'
    text = project_toml(
        site={"spectrum": NTC, "limit_state": "SLV"},
        building={**BUILDING, "height": HEIGHT},
        materials={"m": {"density": 1800, "disintegration": "excluded"}},
        report={"sources": {"materials.m.disintegration": "measured: survey"}},
        analysis={"procedures": ["ntc2018-nonlinear"]},
        bodies={"wall": wall(1.6, 3.0, 2.0, material="m")},
        mechanisms={"wall": lines(block(direction=[1, 0, 0], sides="one"), f"loads = [{tie}]")},
    )
    (tmp_path / "project.toml").write_text(text, encoding="utf-8")
    study = build_to_decide(load(tmp_path))
    value = next(each for each in study.replaceables if "loads" in each.key)
    (stands,) = find_verdict(without_substitute(study, value, broken=False), jobs=1).mechanisms
    assert stands.outcome == Decision.PASS, stands.missing
    found = find_verdict(without_substitute(study, value, broken=True), jobs=1)
    assert found.outcome == Decision.INCOMPLETE
    assert found.provisional is None
    (missing,) = (each for each in found.missing if each.key == f"report.sources.{value.key}")
    assert "name who vouches for it in [report.sources]" in missing.text
    with_source = replace(without_substitute(study, value, broken=True).replaceables[0], source="measured: pulled")
    assert find_verdict(replace(study, replaceables=(with_source,)), jobs=1).outcome == Decision.PASS
