"""The procedures asked in Python of one mechanism answer as they do on a project of that mechanism."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from assess.codes.check import Check, Outcome
from assess.codes.context import Building
from assess.codes.procedures import PROCEDURES
from assess.errors import ProcedureError
from assess.project.build import build
from assess.project.project_file import load
from assess.study.block_answers import answers
from assess.study.run import run_study
from assess.study.study import Study
from tests.support import projects
from tests.support.command import ended
from tests.support.motions import write_record
from tests.support.projects import EC8, block, project_toml, wall

BUILDING = Building(height=9.0, storeys=3, period=0.4, damping=0.05)
PROCEDURES_OF_WALLS = [name for name in PROCEDURES if "sliding" not in name]
HISTORIES = ["asce43-05-history", "dmi2008-history", "ntc2018-history"]


def write_project(
    folder: Path, *, base: float = 0.0, level: str = "LC1", records: int = 0, building: bool = False
) -> Path:
    """A box wall of stone that crushes, on noise of a fixed seed as its records."""
    for number in range(records):
        noise = np.random.default_rng(number).normal(size=800) * np.hanning(800)
        write_record(folder / f"noise-{number}.csv", 0.01 * np.arange(800), noise)
    knowledge = {"knowledge_level": level} if level else {}
    structure = {"height": BUILDING.height, "storeys": BUILDING.storeys, "period": BUILDING.period} if building else {}
    suite = {"files": ["noise-*.csv"]} if records else {"synthetic": {"count": 1, "seed": 1, "duration": "20 s"}}
    text = project_toml(
        site={"spectrum": EC8 | {"ground_type": "C"}},
        building={"ground_elevation": 0.0, **structure},
        materials={"stone": {"density": 2000, "compressive_strength": "1 MPa"}},
        bodies={"wall": wall(0.6, 4.0, 4.5, material="stone", base=[0.0, 0.0, base])},
        mechanisms={"wall": block(interface={"model": "rigid", "strength": "1 MPa"})},
        records={"scale_to": "none", **suite},
        analysis={"procedures": [name for name in PROCEDURES_OF_WALLS if records or name not in HISTORIES]},
        procedures={"dmi2008": knowledge, "ntc2018": knowledge},
    )
    return projects.write_project(folder, text)


def compare(file: Path, procedures: list[str], **given: object) -> tuple[list[Check], list[Check], Study]:
    """The checks of the run of a project, unmarked, and those of the same procedures in Python."""
    study = build(load(file))
    (result,), (mechanism,) = run_study(study, jobs=1).mechanisms, study.mechanisms
    wanted = [replace(check, role="comparison") for check in result.checks if check.procedure in procedures]
    assert study.spectrum is not None
    return wanted, list(answers(mechanism, study.spectrum, procedures=procedures, **given)), study  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("base", "building"), [(0.0, False), (4.5, False), (4.5, True)], ids=["ground", "height", "height in a building"]
)
@pytest.mark.parametrize("level", ["LC1", "LC3", ""])
def test_every_spectral_procedure_answers_as_in_a_run(tmp_path: Path, base: float, building: bool, level: str) -> None:
    file = write_project(tmp_path, base=base, level=level, building=building)
    procedures = [name for name in PROCEDURES_OF_WALLS if name not in HISTORIES]
    run_checks, ours, _ = compare(
        file,
        procedures,
        knowledge_level=level or None,
        base_elevation=base,
        building=BUILDING if building else None,
    )
    assert {check.procedure for check in run_checks} == set(procedures)
    assert ours == run_checks


def test_time_histories_answer_as_in_a_run(tmp_path: Path) -> None:
    file = write_project(tmp_path, records=7)
    study = build(load(file))
    run_checks, ours, _ = compare(file, HISTORIES, knowledge_level="LC1", records=study.records)
    assert len(run_checks) == 3
    assert all((check.demand or 0.0) > 0.0 for check in run_checks)
    assert ours == run_checks


def test_the_command_line_writes_the_same_numbers(tmp_path: Path) -> None:
    file = write_project(tmp_path)
    assert ended("run", file, "-o", tmp_path / "out", "--no-report") in (0, 1, 3)
    (mechanism,) = json.loads((tmp_path / "out" / "results.json").read_text())["mechanisms"]
    study = build(load(file))
    assert study.spectrum is not None
    names = ["ntc2018-nonlinear", "asce43-05-spectrum"]
    ours = answers(study.mechanisms[0], study.spectrum, procedures=names, knowledge_level="LC1")
    for check in ours:
        (same,) = (each for each in mechanism["checks"] if each["procedure"] == check.procedure)
        assert [same[key] for key in ("demand", "capacity", "ratio", "verdict", "capacity_pga_g")] == [
            check.demand, check.capacity, check.ratio, check.verdict, check.capacity_pga_g,
        ]  # fmt: skip


def test_histories_without_records_are_not_answered_and_ask_for_them(tmp_path: Path) -> None:
    study = build(load(write_project(tmp_path)))
    assert study.spectrum is not None
    checks = answers(study.mechanisms[0], study.spectrum, procedures=HISTORIES, knowledge_level="LC1")
    assert [check.procedure for check in checks] == HISTORIES
    for check in checks:
        assert (check.verdict, check.reason.key, check.demand) == (Outcome.NOT_ANSWERED, "too-few-records", None)
        assert ("suite-empty", "records.files") in [(each.key, each.where) for each in check.remarks]


def test_without_a_level_of_knowledge_crushing_is_not_answered(tmp_path: Path) -> None:
    study = build(load(write_project(tmp_path)))
    assert study.spectrum is not None
    (check,) = answers(study.mechanisms[0], study.spectrum, procedures=["ntc2018-nonlinear"])
    assert (check.verdict, check.reason.key) == (Outcome.NOT_ANSWERED, "knowledge-unknown")


@pytest.mark.parametrize(
    ("given", "text"),
    [
        ({"procedures": []}, "name one at least"),
        ({"procedures": ["ntc2019"]}, 'procedure "ntc2019" is not known; known are: asce43-05-spectrum'),
        ({"procedures": ["ntc2018-linear"], "knowledge_level": "LC4"}, '"LC4" is not known; known are: LC1, LC2, LC3'),
    ],
)
def test_unknown_names_list_the_known_ones(tmp_path: Path, given: dict[str, object], text: str) -> None:
    study = build(load(write_project(tmp_path)))
    assert study.spectrum is not None
    with pytest.raises(ProcedureError, match=text):
        answers(study.mechanisms[0], study.spectrum, **given)  # type: ignore[arg-type]
