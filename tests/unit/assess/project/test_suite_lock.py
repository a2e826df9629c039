"""`assess records select --lock` and [records] lock: the same suite whatever becomes of the mechanisms, or an error."""

import hashlib
import json
import re
from pathlib import Path
from unittest.mock import Mock

import numpy as np
import pytest

from assess.errors import AssessError, OutputError, ProjectError
from assess.project import record_set, suites
from assess.project.suite_lock import LOCK_NAME, is_sealed
from assess.results.diff import differences
from assess.results.json import dumps, loads
from assess.study.suites import motions_of, suite_faults
from records.processing import at2_text
from records.record import make_record
from reports.chapters import suite
from reports.chapters.suite import suite_sentences
from tests.support.command import ended
from tests.support.letters import letters
from tests.support.places import PEER, needs_real_records
from tests.support.projects import ASCE7, Table, published, results_of, study_of, tables_toml, write_project

SELECT = 'files = ["motions/*.AT2"]\nselect = { count = 3, scale_limits = [0.001, 1000.0] }\nfactor = 1.1'
LOCKED = f'lock = "{LOCK_NAME}"\n{SELECT}'
SLOW, QUICK, SLUGGISH = published(), published(3.36, 0.34, 0.62), published(0.9, 0.14, 9.0)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A project's folder with records of eight earthquakes, of different colour."""
    (tmp_path / "motions").mkdir()
    rng = np.random.default_rng(5)
    for number in range(8):
        shake = rng.normal(0.0, 1.0, 1500) * np.hanning(1500)
        smooth = np.convolve(shake, np.hanning(5 + 9 * number), mode="same")
        record = make_record("x", 0.3 * smooth, 0.02, event=f"Quake {number}", station="S", component="000")
        (tmp_path / "motions" / f"RSN{100 + number}_Q_000.AT2").write_text(at2_text(record))
    return tmp_path


def project(records: str, *, site: Table | None = None, **mechanisms: Table) -> str:
    return tables_toml(
        site=site or {"spectrum": ASCE7},
        mechanisms=mechanisms or {"slow": SLOW, "quick": QUICK},
        records=records,
        analysis={"procedures": ["asce43-05-history"]},
        verdict={"basis": "asce43-05"},
    )


def lock(folder: Path, records: str = SELECT, **mechanisms: Table) -> Path:
    write_project(folder, project(records, **mechanisms))
    return suites.lock_project(folder)[1]


def test_a_locked_suite_gives_the_results_that_it_was_locked_from(folder: Path) -> None:
    before = results_of(folder, project(SELECT))
    path = lock(folder)
    after = results_of(folder, project(LOCKED))
    assert [(one.id, one.path) for one in after.records] == [(one.id, one.path) for one in before.records]
    assert [one.scale_factor for one in after.records] == [one.scale_factor for one in before.records]
    assert [one.histories for one in after.mechanisms] == [one.histories for one in before.mechanisms]
    assert after.ground_motion is not None
    assert before.ground_motion is not None
    assert after.ground_motion.selection == before.ground_motion.selection
    assert after.ground_motion.lock == LOCK_NAME
    inputs = {one.path: one.sha256 for one in after.inputs}
    assert inputs[LOCK_NAME] == hashlib.sha256(path.read_bytes()).hexdigest()
    assert {one.path for one in after.records} <= set(inputs)
    assert not any("lock" in one.what for one in differences(before, before))
    assert loads(dumps(after)) == after


TABLE = "id,site.spectrum.s_d1\na,\nb,0.09 g\nc,0.09 g\nd,nonsense\ne,0.12 g\n"


@pytest.mark.parametrize("records", [SELECT, 'synthetic = { count = 2, duration = "20 s" }'])
def test_a_lock_of_a_table_has_a_suite_for_each_target_of_its_rows(folder: Path, records: str) -> None:
    """Each is the suite that the row alone would find; a row that cannot be read is left to its batch."""
    (folder / "t.csv").write_text(TABLE)
    path = write_project(folder, project(records))
    assert ended("records", "select", path, "--lock", "--table", folder / "t.csv") == 0
    text = (folder / LOCK_NAME).read_text()
    assert is_sealed(text)
    assert text.count("[others.target]") == 2
    usual = project(records)
    assert usual.count(f's_d1 = "{ASCE7["s_d1"]}"') == 1
    for s_d1 in (ASCE7["s_d1"], "0.09 g", "0.12 g"):
        before, after = (
            results_of(folder, text.replace(f's_d1 = "{ASCE7["s_d1"]}"', f's_d1 = "{s_d1}"'))
            for text in (usual, project(f'lock = "{LOCK_NAME}"\n{records}'))
        )
        assert [one.scale_factor for one in after.records] == [one.scale_factor for one in before.records]
        assert [one.spectrum for one in after.records] == [one.spectrum for one in before.records]
        assert [one.histories for one in after.mechanisms] == [one.histories for one in before.mechanisms]
    with pytest.raises(ProjectError, match=r"made for another target \(.*, .*, .*\) than the site's spectrum"):
        study_of(folder, project(LOCKED).replace(f's_d1 = "{ASCE7["s_d1"]}"', 's_d1 = "0.15 g"'))


def test_a_lock_of_a_table_names_each_site_that_has_no_suite_in_it(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """It was left out without a word. Of two rows of one site the first is named, none whose site has one."""
    rows = ("a,0.09 g,0.14", "b,0.09 g,-1", "c,nonsense,0.14", "d,0.2 g,-1", "e,0.2 g,-2")
    (folder / "t.csv").write_text("\n".join(("id,site.spectrum.s_d1,mechanisms.slow.uplift", *rows)))
    path = write_project(folder, project('synthetic = { count = 2, duration = "20 s" }'))
    assert ended("records", "select", path, "--lock", "--table", folder / "t.csv") == 0
    told = [line for line in capsys.readouterr().err.splitlines() if "the lock has no suite for its site" in line]
    assert [line.partition("t.csv: ")[2].partition(": column")[0] for line in told] == ['line 4 ("c")', 'line 5 ("d")']


def test_a_project_without_a_table_of_records_locks_the_artificial_ones(tmp_path: Path) -> None:
    """The seven of the default, which the lock is then named for."""
    tables = {"site": {"spectrum": ASCE7}, "mechanisms": {"slow": SLOW}, "verdict": {"basis": "asce43-05"}}
    write_project(tmp_path, tables_toml(**tables, analysis={"procedures": ["asce43-05-history"]}))
    found, file, left_out = suites.lock_project(tmp_path)
    assert len(found.records) == 7
    assert is_sealed(file.read_text())
    assert left_out == ()


def test_a_table_goes_with_a_lock_of_its_template(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = write_project(folder, project(SELECT))
    for more in (("--table", "t.csv"), ("--table", "t.csv", "--lock", "--target", folder)):
        assert ended("records", "select", path, *more) == 2
        assert "--table goes with --lock" in capsys.readouterr().err


def test_one_wall_edited_changes_the_earthquakes_of_another_only_without_the_lock(folder: Path) -> None:
    lock(folder)
    for records, same in ((SELECT, False), (LOCKED, True)):
        before = results_of(folder, project(records, slow=SLOW, quick=QUICK))
        after = results_of(folder, project(records, slow=SLOW, quick=SLUGGISH))
        factors = [{one.path: one.scale_factor for one in each.records} for each in (before, after)]
        histories = [each.mechanisms[0].histories for each in (before, after)]
        assert (factors[0] == factors[1]) is same
        assert (histories[0] == histories[1]) is same
        assert any(one.kind == "suite" for one in differences(before, after)) is not same


def test_the_lock_is_the_same_bytes_and_replaces_only_one_as_it_was_written(folder: Path) -> None:
    path = lock(folder)
    first = path.read_text()
    assert is_sealed(first)
    assert lock(folder, LOCKED).read_text() == first
    assert lock(folder, LOCKED.replace("count = 3", "count = 4")).read_text().count("[[records]]") == 4
    edited = path.read_text().replace("scale_factor = ", "scale_factor = 1")
    for text, said in ((edited, "the lock was edited since it was written"), ("mine", "not written by")):
        path.write_text(text)
        with pytest.raises(
            OutputError, match=rf"records\.lock\.toml: {said}.*; move it away, and a new one is written$"
        ):
            lock(folder, LOCKED)
        assert path.read_text() == text


def test_a_lock_changed_by_hand_is_used_and_told(folder: Path) -> None:
    path = lock(folder)
    assert {one.key for one in results_of(folder, project(LOCKED)).warnings if one.where == "records.lock"} == {
        "suite-locked"
    }
    path.write_text(re.sub("scale_factor = .*", "scale_factor = 2.5", path.read_text()))
    found = results_of(folder, project(LOCKED))
    assert {one.scale_factor for one in found.records} == {2.5}
    assert {one.key for one in found.warnings if one.where == "records.lock"} == {"suite-locked", "lock-edited"}


def test_a_record_that_changed_or_is_gone_is_an_error_with_its_remedy(folder: Path) -> None:
    lock(folder)
    file = folder / results_of(folder, project(LOCKED)).records[0].path
    content = file.read_text()
    file.write_text(content + "\n")
    with pytest.raises(ProjectError, match=rf"{file.name} has changed since .*records select PROJECT --lock` again"):
        study_of(folder, project(LOCKED))
    file.unlink()
    with pytest.raises(
        ProjectError, match=rf"{file.name}, which cannot be read .*records select PROJECT --lock` again"
    ):
        study_of(folder, project(LOCKED))
    file.write_text(content)
    assert study_of(folder, project(LOCKED)).records


@pytest.mark.parametrize(
    "site", [{"pga": "0.3 g", "spectrum": ASCE7}, {"spectrum": ASCE7 | {"s_d1": "0.3 g"}}], ids=["pga", "shape"]
)
def test_a_lock_of_another_spectrum_is_an_error(folder: Path, site: Table) -> None:
    lock(folder)
    with pytest.raises(
        ProjectError, match=r"made for another target .*run `assess records select PROJECT --lock` again"
    ):
        study_of(folder, project(LOCKED, site=site))


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (None, "no such file; make it"),
        ("[records", "not valid TOML"),
        ("format = 1", "target: missing"),
        ("format = 2", "target: missing"),
    ],
)
def test_what_is_no_lock_is_one_line(folder: Path, text: str | None, said: str) -> None:
    if text is not None:
        (folder / LOCK_NAME).write_text(text)
    with pytest.raises(ProjectError, match=said) as caught:
        study_of(folder, project(LOCKED))
    assert "\n" not in str(caught.value)


def test_artificial_records_are_made_again_and_compared(folder: Path) -> None:
    records = 'synthetic = { count = 2, seed = 3, duration = "20 s" }'
    before = results_of(folder, project(records))
    path = lock(folder, records)
    locked = f'lock = "{LOCK_NAME}"'
    slower = published(0.5, 0.14, 29.0)
    after = results_of(folder, project(locked, slow=SLOW, quick=slower))
    moved = results_of(folder, project(records, slow=SLOW, quick=slower))
    shaken = [[(one.scale_factor, one.spectrum) for one in each.records] for each in (before, after, moved)]
    assert shaken[0] == shaken[1]
    assert shaken[0] != shaken[2]
    with pytest.raises(AssessError, match=r"records\.files: missing"):
        lock(folder, locked)
    path.write_text(path.read_text().replace("seed = 3", "seed = 4"))
    with pytest.raises(ProjectError, match="not those that were locked"):
        study_of(folder, project(locked))


def test_the_lock_of_artificial_records_has_the_seed_that_followed_from_the_target(folder: Path) -> None:
    records = 'synthetic = { count = 2, duration = "20 s" }'
    before = results_of(folder, project(records))
    path = lock(folder, records)
    (seed,) = re.findall(r"^seed = (\d+)$", path.read_text(), re.MULTILINE)
    assert f"seed {seed}, number 1" in str(before.records[0].processing[0])
    after = results_of(folder, project(f'lock = "{LOCK_NAME}"'))
    assert [one.spectrum for one in after.records] == [one.spectrum for one in before.records]


def test_files_are_read_once_in_a_process(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    lock(folder)
    read = Mock(wraps=record_set.read_with_overrides)
    monkeypatch.setattr(record_set, "read_with_overrides", read)
    for _ in range(3):
        study_of(folder, project(LOCKED))
    assert read.call_count == 3


def test_a_sweep_of_the_pga_scales_a_locked_suite_and_one_of_the_shape_is_refused(folder: Path) -> None:
    lock(folder)
    sweep = '[analysis]\nprocedures = ["asce43-05-history"]\nsweep = { key = "%s", values = %s }\n'
    text = project(LOCKED).split("[analysis]")[0]
    rest = "[verdict]\n" + project(LOCKED).split("[verdict]\n")[1]
    swept = results_of(folder, text + sweep % ("site.pga", '["0.2 g", "0.4 g"]') + rest)
    assert swept.sweeps
    with pytest.raises(ProjectError, match="spectrum of another shape"):
        results_of(folder, text + sweep % ("site.spectrum.s_d1", '["0.2 g", "0.3 g"]') + rest)


def test_the_command_writes_beside_the_target_and_the_report_tells(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "project.toml").write_text(project(LOCKED))
    limits = ("--scale-limits", 0.001, 1000, "--count", 3)
    assert ended("records", "select", "--target", folder, folder / "motions", *limits, "--lock") == 0
    assert str(folder / LOCK_NAME) in capsys.readouterr().err
    found = results_of(folder, project(LOCKED))
    assert 'file = "motions/RSN' in (folder / LOCK_NAME).read_text()
    told = [letters(each) for each in suite_sentences(found)]
    assert (
        sum(
            f"The suite is locked: the records and their scale factors are those of {LOCK_NAME}" in each
            for each in told
        )
        == 1
    )
    assert ended("records", "select", folder) == 0
    assert "The suite is locked" in capsys.readouterr().out
    (folder / LOCK_NAME).write_text("mine")
    assert ended("records", "select", "--target", folder, folder / "motions", *limits, "--lock") == 2


FOR = 'files = ["motions/*.AT2"]\nselect = { for = "%s", count = 5, scale_limits = [0.001, 1000.0] }'


@pytest.mark.parametrize("code", ["asce43-05", "ec8"])
def test_a_suite_made_for_a_code_meets_it_and_keeps_its_factors_in_a_lock(folder: Path, code: str) -> None:
    found = results_of(folder, project(FOR % code))
    motion = found.ground_motion
    assert motion is not None
    rules = [one for one in motion.requirements if one.code == motion.made_for]
    assert rules
    assert {one.verdict for one in rules} == {"met"}
    assert motion.selection is not None
    assert motion.selection.misfit == pytest.approx(motion.misfit, rel=1e-9)
    assert "The suite was made to meet the rules of" in letters(suite.selection_sentences(motion)[-1])
    lock(folder, FOR % code)
    after = results_of(folder, project(f'lock = "{LOCK_NAME}"\n{FOR % code}', slow=SLOW, quick=SLUGGISH))
    assert [one.scale_factor for one in after.records] == [one.scale_factor for one in found.records]
    assert after.ground_motion is not None
    assert after.ground_motion.made_for == motion.made_for


def test_a_suite_that_no_code_accepts_and_artificial_records_beside_it_are_errors(folder: Path) -> None:
    with pytest.raises(
        ProjectError, match=r"records\.select: no suite meets ASCE 7-16: 11 records wanted; there are 8"
    ):
        study_of(folder, project(FOR % "asce7-16"))
    with pytest.raises(ProjectError, match=r"records\.synthetic: .*recorded motions; remove one"):
        study_of(folder, project(FOR % "ec8" + "\nsynthetic = { count = 2 }"))
    with pytest.raises(ProjectError, match=r"records\.select\.for: "):
        study_of(folder, project(FOR % "ec9"))


def test_the_command_makes_a_suite_for_a_code(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (folder / "project.toml").write_text(project(SELECT))
    asked = ("records", "select", "--target", folder, folder / "motions", "--scale-limits", 0.001, 1000)
    assert ended(*asked, "--for", "ec8", "--count", 3, "--json", "--lock") == 0
    found = json.loads(capsys.readouterr().out)["ground_motion"]
    rules = [one["verdict"] for one in found["requirements"] if one["code"] == found["made_for"] == "EN 1998-1:2004"]
    assert rules == ["met"] * 3
    assert 'for = "ec8"' in (folder / LOCK_NAME).read_text()
    assert results_of(folder, project(LOCKED)).records
    assert ended(*asked, "--for", "ec9") == 2
    assert ended("records", "select", folder, "--for", "ec8") == 2
    assert "--for needs --target" in capsys.readouterr().err


@needs_real_records
def test_a_suite_made_for_ntc_2018_has_no_fault_at_the_limit_state_that_decides(tmp_path: Path) -> None:
    """SLC decides, whose PGA and periods are not those of the site's own SLV."""
    hazard = [
        {"return_period": years, "a_g": f"{a} g", "f_0": 2.45, "t_c_star": "0.3 s"}
        for years, a in ((30, 0.05), (475, 0.15), (975, 0.2), (2475, 0.28))
    ]
    spectrum = {"code": "ntc2018", "soil": "A", "nominal_life": 50, "use_class": "II", "hazard": hazard}
    text = tables_toml(
        site={"limit_state": "SLV", "spectrum": spectrum},
        mechanisms={"slow": SLOW, "quick": QUICK},
        records=f'files = ["{PEER}/*.AT2"]\nselect = {{ for = "ntc2018", count = 7 }}',
        verdict={"basis": "ntc2018", "limit_state": "SLC", "procedures": ["ntc2018-history"]},
    )
    study = study_of(tmp_path, text)
    assert study.spectrum is not None
    assert suite_faults(study, study.spectrum, motions_of(study, study.spectrum))["ntc2018"] == ()
