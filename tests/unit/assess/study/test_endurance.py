"""Ties, forces and seats of a project file: how long they are there, what is told, and what is then not answered."""

from __future__ import annotations

from dataclasses import replace
from math import asin

import pytest

from assess.cli.tables.project import duration_text
from assess.codes.check import Family, Outcome
from assess.codes.procedures import PROCEDURES
from assess.errors import AssessError
from assess.study.assessment import checks_without_twins
from assess.study.checks import context_of
from assess.study.envelopes import run_envelopes
from assess.study.mechanism_results import parameters
from assess.study.run import run_study
from tests.support import projects
from tests.support.projects import NTC, block, lines, project_toml, wall

TIE = '{{ kind = "tie", force = "{force}", at = [0.4, 0, 4.5], direction = [-1, 0, 0]{more} }}'
PROOF = ', until = "collapse", strength = "30 kN", length = "8 m", fracture_strain = 0.2'
SOURCE = '[report.sources]\n"mechanisms.wall.loads[1]" = "measured: pull-out tests"'
THRUST = '{ kind = "force", force = ["25 kN", 0], at = [0.4, 4.5] }'


def tie(more="", *, force="20 kN"):
    return TIE.format(force=force, more=more)


def study_of(folder, *loads, top="", sides="two"):
    mechanism = block(direction=[1, 0, 0], sides=sides)
    text = project_toml(
        site={"limit_state": "SLV", "spectrum": NTC | {"a_g": "0.1 g", "soil": "B", "topography": "T1"}},
        building={"ground_elevation": 0, "height": "9 m", "storeys": 3},
        materials={"m": {"density": 1900}},
        bodies={"wall": wall(0.8, 2.0, 5.0, material="m")},
        mechanisms={"wall": lines(mechanism, f"loads = [{', '.join(loads)}]")},
        records={"synthetic": {"count": 3, "seed": 1, "duration": "10 s"}},
        analysis={"procedures": [f"ntc2018-{each}" for each in ("linear", "nonlinear", "history")]
                  + ["asce43-05-spectrum", "asce43-05-history"]},
    )  # fmt: skip
    return projects.study_of(folder, f"{top}\n{text}")


def test_a_tie_with_all_its_proofs_lasts_and_holds_the_wall_at_its_height(tmp_path):
    study = study_of(tmp_path, tie(PROOF, force="5 kN"), top=SOURCE)
    (found,) = parameters(study)[0].loads
    assert (found.lasting, found.missing) == ("to collapse", ())
    assert found.end_rad == pytest.approx(asin(0.2 * 8.0 / 4.5), rel=1e-12)  # by its fracture strain, beyond collapse
    assert "lasts to collapse" in duration_text(found)
    assert not any(notice.key == "not-lasting" for notice in study.messages)
    context = context_of(study, study.spectrum, study.mechanisms[0], (), ())
    assert context.rise == 4.5
    assert context.support_height == 2.25
    assert context.starting is context.breaking


@pytest.mark.parametrize(
    ("more", "top", "missing"),
    [
        ("", SOURCE, ("until", "strength", "length", "fracture_strain")),
        (PROOF, "", ("source",)),
        (PROOF, '[report.sources]\n"mechanisms.wall.restitution" = "measured: x"', ("source",)),
        (PROOF.replace(', strength = "30 kN"', ""), SOURCE, ("strength",)),
        (PROOF.replace(', length = "8 m"', ""), SOURCE, ("length",)),
        (PROOF.replace(", fracture_strain = 0.2", ""), '[report.sources]\n"mechanisms.wall.loads.0" = "measured: x"',
         ("fracture_strain",)),
        (PROOF, '[report.sources]\n"mechanisms.wall.loads" = "measured: all of them"', ("source",)),
        (PROOF, '[report.sources]\n"mechanisms.wall" = "measured: all of it"', ("source",)),
        (PROOF, '[report.sources]\n"mechanisms.wall.loads[1]" = "assumed: it looks sound"', ("source",)),
    ],
)  # fmt: skip
def test_what_a_tie_lacks_is_told(tmp_path, more, top, missing):
    study = study_of(tmp_path, tie(more), top=top)
    (found,) = parameters(study)[0].loads
    assert (found.lasting, found.missing) == ("not shown", missing)
    (told,) = [notice for notice in study.messages if notice.key == "not-lasting"]
    assert f"give {', '.join(missing)} (" in told.text
    assert all(key in duration_text(found) for key in missing)
    context = context_of(study, study.spectrum, study.mechanisms[0], (), ())
    assert context.rise == 0.0


@pytest.mark.parametrize(("force", "told"), [("29 kN", False), ("30 kN", False), ("31 kN", True)])
def test_a_pretension_above_the_strength_gets_a_warning(tmp_path, force, told):
    found = [
        each for each in study_of(tmp_path, tie(PROOF, force=force), top=SOURCE).messages if "strength" in each.key
    ]
    assert [each.key for each in found] == ["pretension-above-strength"] * told
    assert all((each.values["force"].value, each.values["strength"].value) == (31e3, 30e3) for each in found)


def test_a_tie_with_an_end_gives_a_local_limit_where_its_point_has_moved_so_far(tmp_path):
    study = study_of(tmp_path, tie(', until = "0.15 m"'))
    (found,), at = parameters(study)[0].loads, 2 * asin(0.15 / (2 * 4.5))
    assert (found.lasting, found.end_m) == ("to its end", pytest.approx(0.15, rel=1e-12))
    assert found.end_rad == pytest.approx(at, rel=1e-12)
    context = context_of(study, study.spectrum, study.mechanisms[0], (), ())
    (limit,) = context.limits
    assert (limit.kind, limit.what, limit.branch) == ("break", "tie 1", "positive")
    assert limit.rotation == pytest.approx(at, rel=1e-12)
    assert context.starting is not context.breaking


def test_seats_are_local_limits_and_printed(tmp_path):
    masses = (
        '{ kind = "mass", mass = 800, at = [0.4, 4.0], seat = "0.12 m" }',
        '{ kind = "mass", mass = 9, at = [0, 3] }',
    )
    study = study_of(tmp_path, *masses)
    context = context_of(study, study.spectrum, study.mechanisms[0], (), ())
    first = context.limits[0]
    assert (first.kind, first.what, first.branch) == ("seat", "mass 1", "positive")
    assert first.rotation == pytest.approx(asin(0.12 / 4.0), rel=1e-12)
    assert [duration_text(each) for each in parameters(study)[0].loads] == ["; seat 0.12 m", "; seat not given"]


@pytest.mark.parametrize(("seat", "told"), [("2.0 m", False), ("2.1 m", True), ("20", True)])
def test_a_seat_wider_than_a_wall_gets_a_warning(tmp_path, seat, told):
    study = study_of(
        tmp_path, f'{{ kind = "mass", mass = 800, at = [0.4, 4.0], seat = "{seat} m" }}'.replace("m m", "m")
    )
    found = [each for each in study.messages if each.key == "seat-wide"]
    assert [each.values["seat"].value for each in found] == [float(seat.split()[0])] * told


@pytest.mark.parametrize(
    ("entry", "words"),
    [
        ('{ kind = "mass", mass = 9, at = [0, 3], bearing = false, seat = 0.1 }', "only what bears"),
        (tie(", until = 0"), "greater than 0"),
        (tie(', until = "overturning"'), "until"),
        (tie(", strength = -5"), "strength"),
    ],
)
def test_ends_that_cannot_be_are_refused(tmp_path, entry, words):
    with pytest.raises(AssessError, match=words):
        study_of(tmp_path, entry)


def test_results_start_with_every_action_and_decide_with_what_lasts(tmp_path):
    tied, plain = study_of(tmp_path, tie(force="5 kN")), study_of(tmp_path)
    found, bare = parameters(tied)[0], parameters(plain)[0]
    assert found.oscillator.uplift_multiplier > 1.3 * bare.oscillator.uplift_multiplier
    assert found.deciding_curve.positive == bare.curve.positive
    assert found.deciding_overturning_rad == (bare.oscillator.overturning_rad,) * 2
    assert bare.deciding_curve is None


@pytest.mark.parametrize("method", ["ntc2018-nonlinear", "dmi2008-nonlinear"])
def test_a_tie_that_nobody_vouches_for_does_not_keep_a_wall_from_rocking_at_slv(tmp_path, method):
    """Its force is in the multiplier of the linear check, and in no bound of the non-linear one (verdict.md 1.8)."""

    def index(*loads):
        study = replace(study_of(tmp_path, *loads, sides="one"), procedures=(method,))
        check = checks_without_twins(study, study.spectrum, (), jobs=1)[0]
        return check.safety_index, [each.key for each in check.conditions]

    bare = index()
    assert index(tie(force="60 kN")) == index(tie(PROOF, force="60 kN")) == bare
    assert index(tie(', until = "1 mm"', force="60 kN"))[1] == ["holds-to-its-end"]


@pytest.fixture(scope="module")
def standing_by_its_tie(tmp_path_factory):
    """A thrust that the wall cannot take, with a tie nobody vouches for."""
    study = study_of(tmp_path_factory.mktemp("unheld"), THRUST, tie())
    return study, run_study(study, jobs=1)


def test_a_wall_that_stands_by_its_tie_alone_is_not_answered_by_displacements(standing_by_its_tie):
    study, results = standing_by_its_tie
    (mechanism,) = results.mechanisms
    answers = {check.procedure: check for check in mechanism.checks}
    asked = {"ntc2018-nonlinear", "asce43-05-spectrum", "ntc2018-history", "asce43-05-history"}
    for name in asked & set(answers):
        check = answers[name]
        assert (check.verdict, check.reason.key) == (Outcome.NOT_ANSWERED, "unheld"), name
        assert "tie 2" in check.reason.text
        assert (check.ratio, check.capacity_pga_g, check.steps) == (None, None, ())
    assert {"ntc2018-nonlinear", "asce43-05-spectrum", "asce43-05-history"} <= set(answers)
    linear = answers["ntc2018-linear"]
    assert PROCEDURES["ntc2018-linear"].family == Family.LINEAR
    assert linear.verdict in (Outcome.PASS, Outcome.FAIL)
    assert (results.verdict.outcome, results.verdict.state) == ("fail", "unsourced-replaced")  # it falls
    assert results.verdict.other_state.outcome == "incomplete"
    assert mechanism.histories == ()
    assert any(notice.key == "unheld" for notice in study.messages)


def test_the_rest_of_it_is_printed(standing_by_its_tie):
    study, results = standing_by_its_tie
    (mechanism,) = results.mechanisms
    assert mechanism.oscillator.uplift_multiplier > 0.0
    assert mechanism.deciding_curve is None
    assert study.mechanisms[0].variants.depends_on == ("tie 2",)
    assert run_envelopes(study, jobs=1).mechanisms[0].envelope is None
