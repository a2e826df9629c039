"""`assess verify`: lines, files, exit codes, the annex of a project and what its report says of it."""

from __future__ import annotations

import hashlib
import json
import tomllib
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import dataclass, replace
from io import StringIO

import pytest

from assess.cli.verify import verification_text, verify_project
from assess.errors import ProjectError
from assess.examples import EXAMPLES, copy_example
from assess.project.build import build, uses_of_project
from assess.project.project_file import load
from assess.project.report import uses_of
from assess.results.json import dumps_verification, read_verification
from assess.results.verification import USES, exercised_by_case
from assess.study.run import run_study
from assess.verification import case_files
from assess.verification.case_files import cases_for, read_cases
from reports.assessment import assessment
from reports.document import Table
from tests.support.command import ended
from tests.support.examples import example_study
from tests.support.projects import project_toml, study_of

KEY = "own_arithmetic/tie"


@dataclass(frozen=True)
class Done:
    """What a command printed, and its exit code."""

    returncode: int
    stdout: str
    stderr: str


def assess(*arguments):
    out, err = StringIO(), StringIO()
    with redirect_stdout(out), redirect_stderr(err):
        code = ended(*arguments)
    return Done(code, out.getvalue(), err.getvalue())


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    folder = tmp_path_factory.mktemp("verify")
    done = assess("verify", KEY, "-o", str(folder / "out"), "--jobs", "1")
    return done, folder / "out"


def test_case_that_passes_ends_with_0_and_a_line(written):
    done, _ = written
    assert done.returncode == 0
    assert done.stdout.startswith(f"pass  {KEY}")
    assert "1 case, 1 quantity, 2 values, 0 misprints, 0 failed" in done.stdout


def test_files_are_written_with_their_inputs(written):
    _, folder = written
    results = read_verification(folder / "verification.json")
    assert dumps_verification(results).encode() == (folder / "verification.json").read_bytes()
    assert (folder / "verification.pdf").read_bytes().startswith(b"%PDF")
    assert "SHA-256" in (folder / "verification.html").read_text(encoding="utf-8")
    for each in results.cases[0].inputs:
        assert hashlib.sha256((folder / "cases" / each.path).read_bytes()).hexdigest() == each.sha256


def test_written_cases_run_again_and_a_wrong_value_ends_with_1(written, tmp_path):
    _, folder = written
    file = folder / "cases" / f"{KEY}.toml"
    assert tomllib.loads(file.read_text(encoding="utf-8"))["solver"] == "project"
    for name in ("tie.toml", "tie_project.toml"):
        text = (file.parent / name).read_text(encoding="utf-8")
        (tmp_path / name).write_text(text.replace("free = 0.1 ", "free = 0.2 "), encoding="utf-8")
    done = assess("verify", "--cases", str(tmp_path), "--json", "--jobs", "1")
    assert done.returncode == 1
    (case,) = json.loads(done.stdout)["cases"]
    assert [each["outcome"] for each in case["quantities"][0]["values"]] == ["pass", "fail"]


def test_line_of_a_case_that_fails_is_not_exact_and_shows_the_difference(written):
    _, folder = written
    results = read_verification(folder / "verification.json")
    (case,) = results.cases
    (quantity,) = case.quantities
    wrong = replace(quantity.values[0], expected=0.1, found=0.1 + 1e-9, outcome="fail")
    exact = replace(quantity, tolerance=replace(quantity.tolerance, absolute=0.0, relative=0.0), values=(wrong,))
    text = verification_text(replace(results, cases=(replace(case, quantities=(exact,)),)), seconds=1.0)
    assert "exact" not in text
    assert "0.1 expected, 0.100000001 found" in text


def test_unknown_case_is_one_line(written):
    done = assess("verify", "own_arithmetic/tye")
    assert done.returncode == 2
    assert 'did you mean "own_arithmetic/tie"' in done.stderr


def test_quick_run_of_slow_cases_alone_is_refused(tmp_path):
    slow = next(each.key for each in read_cases() if not each.case.quick)
    done = assess("verify", slow, "--quick", "-o", str(tmp_path / "out"))
    assert done.returncode == 2
    assert "these cases take long; leave out --quick" in done.stderr
    assert not (tmp_path / "out").exists()


def test_list_has_a_line_for_each_case_without_control_characters(written, tmp_path):
    _, folder = written
    for name in ("tie.toml", "tie_project.toml"):
        text = (folder / "cases" / "own_arithmetic" / name).read_text(encoding="utf-8")
        (tmp_path / name).write_text(text.replace('title = "', r'title = "\u001b[31m\n', 1), encoding="utf-8")
    done = assess("verify", "--cases", str(tmp_path), "--list")
    assert len(done.stdout.splitlines()) == 1
    assert "\x1b" not in done.stdout


@pytest.mark.parametrize(
    "name", [name for name in EXAMPLES if name not in ("san_leonardo_spire", "casa_grande", "casa_grande_flexible")]
)
def test_what_an_example_uses_is_in_the_table(name, tmp_path):
    if EXAMPLES[name].models():
        pytest.importorskip("ifcopenshell", reason="the extra 'ifc' is not installed")
    project = load(copy_example(name, tmp_path / name))
    uses = uses_of(project.content, example_study(name))
    assert name != "single_wall" or uses == uses_of_project(project)
    assert uses == tuple(word for word in USES if word in uses)
    assert {"rigid"} <= set(uses)


def test_run_names_the_annex_and_what_has_no_case(written, tmp_path):
    _, folder = written
    project = tmp_path / "wall.toml"
    project.write_text(project_toml(), encoding="utf-8")
    assert build(load(project)).annex is None
    place = tmp_path / "wall-verification"
    place.mkdir()
    for name in ("verification.json", "verification.pdf"):
        (place / name).write_bytes((folder / name).read_bytes())
    study = build(load(project))
    annex = study.annex
    assert annex is not None
    assert (annex.path, annex.cases, annex.failures) == ("wall-verification/verification.json", 1, 0)
    assert annex.sha256 == hashlib.sha256((place / "verification.json").read_bytes()).hexdigest()
    assert "asce7-16" in annex.uncovered
    assert not {"single-block", "rigid", "box"} & set(annex.uncovered)
    assert {"wall-verification/verification.json", "wall-verification/verification.pdf"} < {
        e.path for e in study.inputs
    }
    (message,) = [each for each in study.messages if each.key == "annex-uncovered"]
    assert "spectrum of ASCE 7-16" in message.text
    assert "asce7-16" not in message.text


def test_run_verifies_first_and_its_report_ends_with_the_solved_cases(tmp_path, monkeypatch):
    project = tmp_path / "wall.toml"
    project.write_text(project_toml(report={"detail": "main"}), encoding="utf-8")
    quick = tuple(each for each in read_cases() if each.key == KEY)
    monkeypatch.setattr(case_files, "read_cases", lambda: quick)
    monkeypatch.setattr(case_files, "cases_for", lambda cases, _: tuple(cases))
    verify_project(load(project), jobs=1)
    results = run_study(build(load(project)))
    (case,) = read_verification(tmp_path / "wall-verification" / "verification.json").cases
    assert results.verification.solved == (case.line,)
    document = assessment(results)
    assert document.sections[-1].mark == "F"
    (table,) = [each for each in document.sections[-1].blocks if isinstance(each, Table)]
    assert table.rows[0][3] == len(case.values)
    assert assessment(replace(results, verification=None)).sections[-1].mark != "F"


def test_run_refuses_to_verify_into_a_file_of_another_name(tmp_path):
    (tmp_path / "v.json").write_text("{}", encoding="utf-8")
    project = tmp_path / "wall.toml"
    project.write_text(project_toml(report={"verification": "v.json"}), encoding="utf-8")
    with pytest.raises(ProjectError, match="is not what --verify writes"):
        verify_project(load(project), jobs=1)


def test_annex_of_other_sources_is_told(written, tmp_path):
    _, folder = written
    results = read_verification(folder / "verification.json")
    other = replace(results, program=replace(results.program, sha256="0" * 64))
    assert "annex-other-sources" in annex_message_keys(tmp_path, dumps_verification(other))


def annex_message_keys(folder, text, pdf=b""):
    """Keys of what a run says of an annex of this text, with this PDF beside it."""
    (folder / "v.json").write_text(text, encoding="utf-8")
    if pdf:
        (folder / "v.pdf").write_bytes(pdf)
    return {each.key for each in study_of(folder, project_toml(report={"verification": "v.json"})).messages}


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ('"expected": 0.1', '"expected": 0.2'),
        ('"outcome": "pass"', '"outcome": "fail"'),
        ('"quick": false', '"quick": true'),
    ],
)
def test_annex_edited_by_hand_is_refused(written, tmp_path, old, new):
    _, folder = written
    text = (folder / "verification.json").read_text(encoding="utf-8")
    assert old in text
    with pytest.raises(ProjectError, match="was changed since it was written"):
        annex_message_keys(tmp_path, text.replace(old, new))


def test_annex_without_cases_is_refused(written, tmp_path):
    _, folder = written
    results = replace(read_verification(folder / "verification.json"), cases=())
    with pytest.raises(ProjectError, match="has no cases"):
        annex_message_keys(tmp_path, dumps_verification(results))


@pytest.mark.parametrize(
    ("damage", "why"),
    [
        (lambda text: text.replace('"schema_version": 1', '"schema_version": 0', 1), "schema_version: 0"),
        (lambda text: text.replace('"expected": 0.1', '"expected": 0.2'), "was changed since it was written"),
        (lambda text: "\udcff", "not a text file"),
        (lambda text: text[:99], "not JSON"),
    ],
)
def test_damaged_annex_is_left_aside_in_the_default_place_and_refused_where_it_is_named(written, tmp_path, damage, why):
    _, folder = written
    text = damage((folder / "verification.json").read_text(encoding="utf-8")).encode(errors="surrogateescape")
    place = tmp_path / "wall-verification" / "verification.json"
    place.parent.mkdir()
    place.write_bytes(text)
    project = tmp_path / "wall.toml"
    project.write_text(project_toml(), encoding="utf-8")
    study = build(load(project))
    assert study.annex is None
    assert [each.path for each in study.inputs if "verification" in each.path] == []
    (message,) = [each.text for each in study.messages if each.key == "annex-left-aside"]
    assert why in message
    assert message.endswith("; run `assess verify` again")
    project.write_text(project_toml(report={"verification": "wall-verification/verification.json"}), encoding="utf-8")
    with pytest.raises(ProjectError, match=f"{why}.*; run `assess verify` again$"):
        build(load(project))


def test_annex_of_another_project_leaves_out_cases_of_this_one(written, tmp_path):
    _, folder = written
    results = replace(read_verification(folder / "verification.json"), left_out=())
    (tmp_path / "v.json").write_text(dumps_verification(results), encoding="utf-8")
    project = tmp_path / "wall.toml"
    project.write_text(project_toml(report={"verification": "v.json"}), encoding="utf-8")
    study, loaded = build(load(project)), load(project)
    left_out = {each.key for each in cases_for(read_cases(), uses_of_project(loaded))} - {KEY}
    assert len(left_out) > 10
    assert study.annex.left_out == len(left_out)


def test_words_of_cases_are_those_that_the_cases_give():
    assert exercised_by_case() == {each.key: frozenset(each.case.uses) for each in read_cases()}


def test_pdf_of_another_annex_is_told(written, tmp_path):
    _, folder = written
    text, pdf = (folder / "verification.json").read_text(encoding="utf-8"), (folder / "verification.pdf").read_bytes()
    assert "annex-pdf" in annex_message_keys(tmp_path, text)
    assert "annex-pdf" in annex_message_keys(tmp_path, text, pdf + b"%")
    assert "annex-pdf" not in annex_message_keys(tmp_path, text, pdf)


def test_failing_quick_and_chosen_cases_are_told(written, tmp_path):
    _, folder = written
    results = read_verification(folder / "verification.json")
    (case,) = results.cases
    assert {"annex-left-out"} <= annex_message_keys(tmp_path, dumps_verification(results))
    worse = replace(results, quick=True, cases=(case, replace(case, key="a/b", fault="no <b>convergence</b>")))
    assert {"annex-quick", "annex-failures"} <= annex_message_keys(tmp_path, dumps_verification(worse))


def test_case_with_a_wider_tolerance_is_not_the_program_s(written, tmp_path):
    _, folder = written
    cases = tmp_path / "cases" / "own_arithmetic"
    cases.mkdir(parents=True)
    for name in ("tie.toml", "tie_project.toml"):
        text = (folder / "cases" / "own_arithmetic" / name).read_text(encoding="utf-8")
        (cases / name).write_text(text.replace("relative = 1e-6", "relative = 0.5"), encoding="utf-8")
    done = assess("verify", "--cases", str(cases.parent), "-o", str(tmp_path / "out"), "--jobs", "1")
    assert done.returncode == 0
    assert "1 case not as with the program: own_arithmetic/tie" in done.stdout
    text = (tmp_path / "out" / "verification.json").read_text(encoding="utf-8")
    assert "annex-foreign" in annex_message_keys(tmp_path, text)


def test_case_of_one_s_own_under_examples_is_not_the_program_s(written, tmp_path):
    _, folder = written
    place = tmp_path / "cases" / "examples"
    place.mkdir(parents=True)
    for name in ("tie.toml", "tie_project.toml"):
        (place / name).write_bytes((folder / "cases" / "own_arithmetic" / name).read_bytes())
    done = assess("verify", "--cases", str(place.parent), "--json", "--jobs", "1")
    assert json.loads(done.stdout)["foreign"] == ["examples/tie"]


def test_example_that_a_case_of_the_program_runs_is_the_program_s():
    key = "mehrotra_2019/table_5_5"
    done = assess("verify", key, "--json", "--jobs", "1")
    found = json.loads(done.stdout)
    assert any(each["path"].startswith("examples/") for each in found["cases"][0]["inputs"])
    assert found["foreign"] == []


def test_case_that_is_indicative_covers_nothing_and_is_not_among_the_differences(written):
    _, folder = written
    results = read_verification(folder / "verification.json")
    (case,) = results.cases
    weaker = replace(case, source=replace(case.source, standing="indicative"))
    assert "tie" in results.passed_uses
    beside = replace(results, cases=(weaker,))
    assert not beside.passed_uses
    assert results.shares.worst is not None
    assert beside.shares.worst is beside.relative.worst is None
    assert beside.farthest == ("", "")


def test_cases_for_a_project_share_what_matters():
    cases = {each.key: set(each.case.uses) for each in read_cases()}
    uses = ("single-block", "box", "rigid", "exact", "ntc2018", "ntc2018-linear")
    chosen = {each.key for each in cases_for(read_cases(), uses)}
    assert {"ntc_2018/wall_at_the_ground", "housner_1963/rectangular_pulse"} <= chosen
    assert not {"livesley_1978/arches", "mehrotra_2019/chapter_7_tower", "own_arithmetic/tie"} & chosen
    assert all(any(use in cases[key] for key in chosen) for use in uses)
    assert len(chosen) < len(cases) / 3


def test_nothing_that_has_a_case_is_left_without():
    cases = read_cases()
    for use in USES:
        having = {each.key for each in cases if use in each.case.uses}
        chosen = {each.key for each in cases_for(cases, (use,))}
        assert chosen == having
