"""The commands on small projects: what they print, where they write, how they end."""

import csv
import json
import tomllib
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any
from unittest.mock import Mock

import pytest
from scipy.constants import g

from assess.cli.tables.analysis import run_text
from assess.codes.bases import BASES
from assess.codes.check import Check, Reason, reason_message
from assess.codes.question import Action, MechanismChecks, Missing, Question
from assess.codes.verdict import verdict
from assess.messages.message import Message, Quantity, Severity, note, warning
from assess.outputs.manifest import MANIFEST
from assess.project.build import build
from assess.project.project_file import load
from assess.results import ChecklistItem, Program, ReportMatter, ResolvedValue, Results
from assess.results.json import dumps
from assess.study.mechanism_results import parameters
from tests.support.answered import rotation_check
from tests.support.command import ended
from tests.support.projects import block, project_toml, published, write_project

PROJECT = project_toml(
    title="<b>&",
    site=None,
    mechanisms={
        "=wall, 1": block(sides="one", direction=[1, 0, 0], restitution=0.5),
        "published": published(),
    },
)


@pytest.fixture
def project(tmp_path: Path) -> Path:
    return write_project(tmp_path, PROJECT, name="walls.toml")


rated = partial(rotation_check, rated=True)
SPECTRUM, HISTORY = "asce43-05-spectrum", "asce43-05-history"


def results_of(path: Path, *checks: Check, missing: tuple[Missing, ...] = ()) -> Results:
    """The first mechanism of the project with these checks, judged by ASCE 43-05 at 0.1 g."""
    mechanisms = parameters(build(load(path)))
    first = replace(mechanisms[0], checks=checks)
    warnings = (
        Message("fc", Severity.WARNING, "procedures.dmi2008", "FC is 1.00"),
        Message("mesh", Severity.NOTE, "bodies.wall", "one hole filled"),
    )
    question = Question(BASES["asce43-05"], Action(0.1, "DBE"), procedures=(HISTORY, SPECTRUM))
    found = verdict(question, [MechanismChecks(first.name, checks, missing)])
    project = {"materials.brick.density": ResolvedValue(1800.0, True)}
    return Results(
        2, Program("assess", "0"), (), warnings, project, None, (), (first, *mechanisms[1:]), None, (), (), found
    )  # fmt: skip


@pytest.fixture
def faked(project: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., None]:
    """Put given checks in place of the analysis, and a small file in place of the report."""

    def fake(*checks: Check) -> None:
        results = results_of(project, *checks)

        def run(study: object, *, jobs: int, progress: Callable[[str, int, int], None]) -> Results:
            progress("histories", jobs, jobs)
            return results

        monkeypatch.setattr("assess.study.run.run_study", run)
        monkeypatch.setattr("reports.assessment.write_all", small_report)

    return fake


def small_report(results: Results, folder: Path, *, progress: Callable[[str], None], **_: Any) -> Path:
    progress("report")
    (folder / "report.pdf").write_text(results.mechanisms[0].name)
    return folder / "report.pdf"


def test_check_tells_at_which_rotation_of_its_own_a_joint_opens(
    project: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Thesis 6.2: 2 W / (k l b^2). It never crushes without a strength."""
    joint = 'blocks = ["wall"]\ninterface = { model = "flexible", stiffness = 2e8, strength = "inf" }\n'
    project.write_text(PROJECT.replace('blocks = ["wall"]\n', joint))
    assert ended("check", project) == 0
    opening = 2 * 1800 * 0.6 * 3.0 * 4.0 * g / (2e8 * 3.0 * 0.6**2)
    told = f"by rotation of the joint itself it opens at {opening:.3g} rad, crushes never"
    assert told in capsys.readouterr().out


def test_check_prints_what_was_understood(project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert ended("check", project) == 0
    out = capsys.readouterr().out
    assert "=wall, 1: single-block, one-sided" in out
    assert "A at x = 0.3 m, z = 0 m" in out
    assert "centroid    x = 0 m, z = 2 m" in out
    assert "loads       none" in out
    assert "interface   rigid" in out
    assert "12960" in out  # mass: 1800 * 0.6 * 3 * 4


def test_check_tells_what_the_sensitivity_varies(project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    project.write_text(f"{PROJECT}[analysis]\nsensitivity = {{ thickness = 0.1, restitution = false }}\n")
    assert ended("check", project) == 0
    told = capsys.readouterr().out
    assert "sensitivity of =wall, 1: thickness 0.54 to 0.66 m; density of brick 1620 to 1980 kg/m^3\n" in told
    assert "sensitivity of published: uplift 0.133 to 0.147; p 1.52 to 1.68 1/s\n" in told


def test_parameters_as_table_json_and_csv_agree(project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert ended("parameters", project) == 0
    table = capsys.readouterr().out
    assert ended("parameters", project, "--json") == 0
    mechanisms = json.loads(capsys.readouterr().out)
    assert ended("parameters", project, "--csv") == 0
    rows = list(csv.DictReader(capsys.readouterr().out.splitlines()))
    assert [(row["name"], row["branch"]) for row in rows] == [
        ("'=wall, 1", "positive"),
        ("published", "positive"),
        ("published", "negative"),
    ]
    wall = mechanisms[0]
    assert wall["oscillator_negative"] is None
    assert wall["oscillator"]["mass_kg"] == pytest.approx(12960.0)
    assert float(rows[0]["p_eq_per_s"]) == wall["oscillator"]["p_eq_per_s"]
    assert f"{wall['oscillator']['radius_m']:.4f}" in table
    assert mechanisms[1]["oscillator"]["p_eq_per_s"] == pytest.approx(1.6)
    parameters, constants, hinges = table.split("\n\n")
    (forces,) = wall["hinge_forces"]
    assert mechanisms[1]["hinge_forces"] == []
    assert hinges.splitlines()[1].split() == [
        *("=wall,", "1", "A", f"{forces['horizontal_n']:.5g}", f"{forces['vertical_n']:.5g}"),
        *(f"{forces['needed_friction']:.4f}", "not", "given", "-"),
    ]
    assert len(parameters.splitlines()) == len(constants.splitlines()) == 4
    linear = wall["oscillator"]["linearised"]
    assert linear["stiffness_n_m_per_rad"] / linear["inertia_kg_m2"] == pytest.approx(float(rows[0]["p_eq_per_s"]) ** 2)
    assert float(rows[0]["linearised_stiffness_n_m_per_rad"]) == linear["stiffness_n_m_per_rad"]
    assert f"{linear['stiffness_n_m_per_rad']:.5g}" in constants


def test_json_and_csv_exclude_each_other(project: Path) -> None:
    assert ended("parameters", project, "--csv", "--json") == 2


@pytest.mark.parametrize(("outcome", "code"), [("pass", 0), ("fail", 1), ("not-answered", 3), ("not-applicable", 3)])
def test_run_ends_with_the_verdict(
    outcome: str, code: int, project: Path, faked: Callable[..., None], capsys: pytest.CaptureFixture[str]
) -> None:
    """What stands for comparison does not decide, at whatever level."""
    others = (rated("fail", 9.0, procedure="x-thesis"), rated("fail", 9.0, level=0.3))
    faked(rated(outcome, 0.5), *others)
    assert ended("run", project) == code
    captured = capsys.readouterr()
    folder = project.parent / "walls-results"
    assert captured.out.splitlines()[-1] == str(folder / "report.pdf")
    assert captured.err == ""
    assert "thesis" not in captured.out
    assert sorted(path.name for path in folder.iterdir()) == [MANIFEST, "report.pdf", "results.json"]


def test_run_without_report_takes_the_old_one_away(
    project: Path, faked: Callable[..., None], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    faked(rated("pass", 0.5))
    out = tmp_path / "out"
    assert ended("run", project, "-o", out, "--jobs", "1") == 0
    assert ended("run", project, "-o", out, "--no-report") == 0
    assert capsys.readouterr().out.splitlines()[-1] == str(out / "results.json")
    assert sorted(path.name for path in out.iterdir()) == [MANIFEST, "results.json"]


def test_failing_report_leaves_old_outputs(
    project: Path, faked: Callable[..., None], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    faked(rated("pass", 0.5))
    assert ended("run", project, "-o", tmp_path / "out") == 0
    before = {path.name: path.read_bytes() for path in (tmp_path / "out").iterdir()}
    faked(rated("fail", 2.0))
    monkeypatch.setattr("reports.assessment.write_all", failing_report)
    assert ended("run", project, "-o", tmp_path / "out") == 2
    assert {path.name: path.read_bytes() for path in (tmp_path / "out").iterdir()} == before
    assert sorted(path.name for path in tmp_path.iterdir()) == ["out", "walls.toml"]


def failing_report(results: Results, folder: Path, *, jobs: int = 0, progress: Any = None) -> Path:
    (folder / "report.pdf").write_text("half")
    raise OSError(28, "No space left on device")


def test_a_language_without_a_catalogue_is_refused(project: Path, tmp_path: Path) -> None:
    assert ended("report", tmp_path / "results.json", "--language", "tlh") == 2


@pytest.mark.parametrize("said", ["tlh", "../languages/it", "x\n\x1b[31m" + "y" * 10_000, 7])
def test_an_unknown_language_in_results_is_one_line(
    project: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], said: str | int
) -> None:
    results = replace(results_of(project), project={"report.language": ResolvedValue(said, True)})
    path = tmp_path / "results.json"
    path.write_text(dumps(results))
    assert ended("report", path) == 2
    told = capsys.readouterr().err
    assert f"{path}: project.report.language: {json.dumps(str(said))[:40]}" in told
    assert told.endswith('no such language; write "en" or "it", or give --language\n')
    assert told.count("\n") == 1


def test_report_again_needs_no_analysis(
    project: Path, faked: Callable[..., None], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    faked(rated("pass", 0.5))
    out, other = tmp_path / "out", tmp_path / "other"
    assert ended("run", project, "-o", out) == 0
    before = {path.name: path.read_bytes() for path in out.iterdir()}
    monkeypatch.delattr("assess.study.run.run_study")
    assert ended("report", out / "results.json") == 0
    assert {path.name: path.read_bytes() for path in out.iterdir()} == before
    assert ended("report", out / "results.json", "-o", other) == 0
    assert {path.name: path.read_bytes() for path in other.iterdir()} == before


def test_report_is_as_detailed_as_asked(project: Path, faked: Callable[..., None], tmp_path: Path) -> None:
    faked(rated("pass", 0.5))
    out, write = tmp_path / "out", Mock(side_effect=lambda _, folder, **__: folder / "report.pdf")
    assert ended("run", project, "-o", out) == 0
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("reports.assessment.write_all", write)
        for option in ((), ("--detail", "main"), ("--detail", "full")):
            assert ended("report", out / "results.json", *option) == 0
    assert [call.kwargs["detail"] for call in write.call_args_list] == [None, "main", "full"]
    assert ended("report", out / "results.json", "--detail", "most") == 2


def test_summary_tells_the_verdict_and_what_it_rests_on(project: Path) -> None:
    results = results_of(project, rated("fail", 1.25), rated("not-answered", None, procedure=HISTORY))
    assert [line.split() for line in run_text(results).splitlines()] == [
        ["verdict:", "FAIL"],
        [
            "basis:",
            "ASCE/SEI",
            "43-05;",
            "DBE;",
            "site's",
            "own",
            "action:",
            "PGA",
            "0.1",
            "g,",
            "stated",
            "for",
            "DBE",
        ],
        [
            *("index:", "at", "least", "D/C", "1.25,", "target", "1;", "local", "mechanisms", "only;"),
            *("possible", "mechanisms", "not", "listed"),
        ],
        ["(report.building_type)"],
        ["mechanism", "verdict", "state", "decided", "by", "index", "holds", "up", "to"],
        ["=wall,", "1", "FAIL", "DBE", "asce43-05-spectrum", "D/C", "1.25", "0.0800", "g", "=", "0.800", "x"],
        ["=wall,", "1:", "the", "demand", "exceeds", "the", "allowable"],
        ["warning:", "procedures.dmi2008:", "FC", "is", "1.00"],
        ["1", "note", "on", "what", "decides", "nothing:", "assess", "run", "-v"],
    ]
    assert run_text(results, verbose=True).splitlines()[-1] == "note: bodies.wall: one hole filled"


def test_what_is_warned_of_several_mechanisms_is_one_line(project: Path) -> None:
    results = results_of(project, rated("fail", 1.25))
    warned = tuple(warning("artificial-records", f"mechanisms.w{number}") for number in range(3))
    told = " ".join(run_text(replace(results, warnings=warned)).split())
    assert told.count("artificial records match the spectrum") == 1
    assert "warning: mechanisms.w0, mechanisms.w1, mechanisms.w2: artificial records" in told


def test_reasons_that_differ_in_their_numbers_are_one_line_with_the_range(project: Path) -> None:
    results = results_of(project, rated("fail", 1.25))
    assert results.verdict is not None
    (one,) = results.verdict.mechanisms
    mechanisms = []
    for number, height in enumerate((5.95, 2.95, 4.0)):
        reason = reason_message(Reason.ABOVE_BUILDING, height=Quantity(height, "length"))
        answer = replace(one.answers[0], reason=reason)
        mechanisms.append(replace(one, mechanism=f"w{number}", answers=(answer,)))
    told = run_text(replace(results, verdict=replace(results.verdict, mechanisms=tuple(mechanisms))))
    assert "w0, w1, w2: " in told
    assert "2.95 m to 5.95 m" in " ".join(told.split())


def test_the_index_is_bounded_by_the_mechanisms_that_were_not_examined(project: Path) -> None:
    results = results_of(project, rated("fail", 1.25))
    items = (
        ChecklistItem("gable", None, "examined", ("=wall, 1",)),
        ChecklistItem("corner", None, "absent"),
        ChecklistItem("chimney", None, "not-examined", (), "no access"),
        ChecklistItem("in-plane", None, "not-examined", spoken_for=False),
    )
    said = {4: "only; 2 possible mechanisms not", 3: "only; 1 possible mechanism not", 2: "only\n"}
    for number, words in said.items():
        told = run_text(replace(results, report=ReportMatter(building_type="house", checklist=items[:number])))
        assert f"local mechanisms {words}" in told


def test_what_lies_at_the_limit_is_told(project: Path) -> None:
    told = run_text(results_of(project, rated("pass", 0.97)))
    assert told.startswith("verdict: pass at the limit\n")
    assert "verdict: pass\n" in run_text(results_of(project, rated("pass", 0.9)))


def test_an_incomplete_verdict_ends_with_all_that_is_missing(project: Path) -> None:
    """Tables that the project has already are marked; names with other signs than letters are quoted."""
    missing = (
        Missing("materials.brick.disintegration", "nobody\nsays", 'disintegration = "excluded"'),
        Missing("materials.old stone.disintegration", "nobody says", 'disintegration = "excluded"'),
        Missing("site.limit_state", "what the spectrum stands for", 'limit_state = "DBE"'),
    )
    lines = run_text(results_of(project, rated("pass", 0.9), missing=missing)).splitlines()
    start = lines.index("verdict: incomplete")
    assert start == 0
    assert not [line for line in lines if line.startswith("missing: ")]  # each key stands once, in what is to paste
    assert "safe values where they exist, the verdict would be: pass" in " ".join(lines[start:])
    assert lines[-10:] == [
        "to complete it, add the following to the project file with your own values:",
        "[materials.brick]  # in your file already: add below it",
        "# nobody\\nsays",
        'disintegration = "excluded"',
        '[materials."old stone"]',
        "# nobody says",
        'disintegration = "excluded"',
        "[site]",
        "# what the spectrum stands for",
        'limit_state = "DBE"',
    ]
    tomllib.loads("\n".join(lines[-9:]))


def test_hostile_names_stay_on_their_line(project: Path) -> None:
    results = results_of(project, rated("fail", 1.9))
    assert results.verdict is not None
    hostile = (replace(results.verdict.mechanisms[0], mechanism="x\n\x1b[2J" + "y" * 10_000),)
    text = run_text(replace(results, verdict=replace(results.verdict, mechanisms=hostile)))
    assert "\x1b" not in text
    assert max(map(len, text.splitlines())) <= 100


SWEPT = """
[bodies.tower]
material = "brick"
box = { thickness = 4.0, length = 3.0, height = 9.0 }
[mechanisms.tower]
kind = "single-block"
blocks = ["tower"]
direction = "sweep"
[analysis.sweep]
key = "bodies.tower.box.height"
values = ["9 m", "12 m"]
"""


def test_check_and_parameters_list_the_cases_and_the_direction(
    project: Path, capsys: pytest.CaptureFixture[str], one_build: None
) -> None:
    project.write_text(PROJECT + SWEPT)
    assert ended("check", project) == 0
    out = capsys.readouterr().out
    assert "sweep of bodies.tower.box.height: 9, 12 m, of tower" in out
    assert "direction   weakest towards 90 deg from +x, of 72 directions" in out
    assert ended("parameters", project) == 0
    out = capsys.readouterr().out
    assert "tower, tower.box.height = 12 m" in out
    assert out.count("weakest towards") == 1
    assert ended("parameters", project, "--json") == 0
    found = json.loads(capsys.readouterr().out)
    assert [m["name"] for m in found[-2:]] == ["tower, tower.box.height = 9 m", "tower, tower.box.height = 12 m"]
    assert found[2]["direction_sweep"]["weakest_deg"] == 90.0
    assert found[0]["direction_sweep"] is None


def test_a_case_that_cannot_stand_is_one_line(project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    project.write_text(PROJECT + SWEPT.replace('"12 m"', '"-12 m"'))
    assert ended("parameters", project) == 2
    assert 'analysis.sweep: bodies.tower.box.height = "-12 m": must be greater than 0' in capsys.readouterr().err


JOINTS = """
[mechanisms."on joints"]
kind = "single-block"
blocks = ["wall"]
interface = { model = "flexible", stiffness = "0.1 GPa/m", strength = "1 MPa" }
"""


def test_check_says_once_what_two_joints_have_in_common(project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    project.write_text(PROJECT + JOINTS)
    assert ended("check", project) == 0
    out = capsys.readouterr().out
    (line,) = [line for line in out.splitlines() if "GPa/m" in line]
    assert line.startswith(
        "  interfaces  A, A': flexible, 0.1 GPa/m, 1 MPa; 1.8 m2, 0.6 m deep, under 127.1 kN at rest"
    )


def test_parameters_show_where_joints_overturn_beside_rigid_ones(
    project: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert ended("parameters", project) == 0
    assert "on joints" not in capsys.readouterr().out
    project.write_text(PROJECT + JOINTS)
    assert ended("parameters", project, "--json") == 0
    flexible = json.loads(capsys.readouterr().out)[-1]["oscillator"]
    assert ended("parameters", project) == 0
    head, *rows = capsys.readouterr().out.split("\n\n")[0].splitlines()
    place = head.index("on joints [rad]")
    columns = [row[place : place + len("on joints [rad]")].strip() for row in rows]
    assert columns == ["-", "-", "-", *[f"{flexible['overturning_flexible_rad']:.4f}"] * 2]
    assert flexible["overturning_flexible_rad"] < flexible["overturning_rad"]
    assert rows[-1].split()[4] == "none"  # no load multiplier at uplift


@pytest.mark.parametrize("form", [(), ("--json",), ("--csv",)])
def test_what_was_done_to_a_mesh_is_told_on_stderr_whatever_is_printed(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], form: tuple[str, ...]
) -> None:
    """A box that lacks one triangle of its top is closed, and that is told."""
    corners = [(x, y, z) for z in (0, 4) for x, y in ((0, 0), (0.6, 0), (0.6, 3), (0, 3))]
    faces = [(1, 4, 3, 2), (1, 2, 6, 5), (2, 3, 7, 6), (3, 4, 8, 7), (4, 1, 5, 8), (5, 6, 7)]
    lines = [f"v {x} {y} {z}" for x, y, z in corners] + ["f " + " ".join(map(str, face)) for face in faces]
    (tmp_path / "wall.obj").write_text("\n".join(lines) + "\n")
    box = "box = { thickness = 0.6, length = 3.0, height = 4.0 }"
    (tmp_path / "project.toml").write_text(PROJECT.replace(box, 'mesh = "wall.obj"'))
    assert ended("parameters", tmp_path, *form) == 0
    told = capsys.readouterr()
    assert "warning: bodies.wall: wall.obj: holes closed by planes: 1 with 3 edges and an area of 0.9 m2" in told.err
    assert "hole" not in told.out


def test_a_project_in_us_units_gets_them_on_the_terminal(project: Path) -> None:
    """4448.2216152605 N to the kip, 0.3048 m to the foot, exactly."""
    found = results_of(project, rated())
    told = (
        note(
            "top-held", mechanism="wall", force=Quantity(2 * 4448.2216152605, "force"), foot=Quantity(22241.1, "force")
        ),
    )
    warned = (warning("above-building", height=Quantity(3.048, "length")),)
    assert found.verdict is not None
    found = replace(found, verdict=replace(found.verdict, conditions=told), warnings=warned)
    american = replace(found, project={**found.project, "report.units": ResolvedValue("US", True)})
    here, there = (" ".join(run_text(each).split()) for each in (found, american))
    assert "8896 N at the top" in here
    assert "2 kip at the top and 5 kip at the foot" in there
    assert "3.048 m above the ground" in here
    assert "10 ft above the ground" in there
