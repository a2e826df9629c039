"""Tests on a shake table beside histories: only distributions count."""

from __future__ import annotations

import csv
import hashlib
import shutil

import numpy as np
import pytest

from assess.verification.case_files import read_cases, write_cases
from assess.verification.solvers import SOLVERS
from assess.verification.verify import run_case

BLOCK = {"p": 2.0, "slenderness": 0.2, "restitution": 0.9}
COUNT, STEP = 40, 0.02


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Forty motions of three sines with random phases, as files; nothing measured yet."""
    found = tmp_path_factory.mktemp("tests")
    rng, times = np.random.default_rng(3), np.arange(400) * STEP
    for number in range(COUNT):
        phases = rng.uniform(0, 2 * np.pi, 3)
        a = sum(0.1 * np.sin(2 * np.pi * f * times + at) for f, at in zip((0.9, 1.7, 3.1), phases, strict=True))
        body = "\n".join(" ".join(f"{value: .7E}" for value in row) for row in a.reshape(-1, 5))
        head = f"PEER NGA STRONG MOTION DATABASE RECORD\nTest, 1/1/2000, Table, {number}\nACCELERATION TIME SERIES"
        text = f"{head} IN UNITS OF G\nNPTS= {times.size:6d}, DT= {STEP:.4f} SEC\n{body}\n"
        (found / f"motion_{number:02d}.AT2").write_text(text)
    measured(found, np.zeros(COUNT))
    return found


def measured(folder, ratios):
    with (folder / "tests.csv").open("w", newline="") as file:
        table = csv.writer(file)
        table.writerow(["motion", "scale", "max_ratio"])
        scales = 2.0 + 0.05 * np.arange(COUNT)
        table.writerows([f"motion_{k:02d}.AT2", f"{scales[k]:.3f}", repr(float(ratios[k]))] for k in range(COUNT))


def solved(folder):
    return SOLVERS["shake-table"](folder, {"file": "tests.csv", "block": BLOCK, "equation": "exact"})


def histories(folder):
    """The largest of each motion, one at a time."""
    ratios = []
    for k in range(COUNT):
        text = f"motion,scale,max_ratio\nmotion_{k:02d}.AT2,{2.0 + 0.05 * k:.3f},0\n"
        (folder / "tests.csv").write_text(text)
        ratios.append(solved(folder)["computed"]["quantiles"]["50 %"])
    return np.array(ratios)


def test_distributions_are_compared_and_not_single_tests(folder):
    ratios = histories(folder)
    assert 0.0 < np.mean(ratios >= 1.0) < 1.0
    assert np.ptp(ratios) > 0.3
    measured(folder, ratios)
    same = solved(folder)
    assert same["apart"]["distance"] == 0.0
    assert same["measured"] == same["computed"]
    measured(folder, np.random.default_rng(5).permutation(ratios))
    shuffled = solved(folder)
    assert {**shuffled, "inputs": same["inputs"]} == same  # which test gave which maximum does not matter
    measured(folder, 0.4 * ratios)
    weaker = solved(folder)
    assert weaker["apart"]["distance"] > 1.36 * (2 / COUNT) ** 0.5
    assert weaker["measured"]["overturned"] == 0.0


def test_quantiles_are_those_of_the_table(folder):
    measured(folder, np.linspace(0.0, 1.2, COUNT))
    found = solved(folder)["measured"]
    assert found["tests"] == COUNT
    assert found["overturned"] == pytest.approx(np.mean(np.linspace(0.0, 1.2, COUNT) >= 1.0))
    assert found["quantiles"]["50 %"] == pytest.approx(0.6)
    assert found["quantiles"]["90 %"] == 1.0  # what overturned counts as 1


CASE = """
title = "Tests of a block on a shake table"
theory = "Distribution of the largest |θ|/α over many motions, exact equation."
field = "One block in a plane."
uses = ["single-block", "rigid", "exact", "records"]
solver = "shake-table"
given = { file = "tests.csv", block = { p = 2.0, slenderness = 0.2, restitution = 0.9 }, equation = "exact" }
[source]
citation = "Tests of our own"
standing = "published"
place = "the data files of the tests, read on 1 May"
[[quantities]]
name = "distance of the distributions"
path = "apart.distance"
tolerance = { absolute = 0.3, reason = "Kolmogorov and Smirnov, 5 %, 40 tests" }
values = { "" = 0.0 }
"""


def test_a_case_of_one_s_own_tests(folder):
    """As the manual shows it: the case stands beside the table and the motions."""
    measured(folder, histories(folder))
    (folder / "case.toml").write_text(CASE, encoding="utf-8")
    (case,) = read_cases(folder)
    assert run_case(case).outcome == "pass"


@pytest.mark.parametrize(("case", "table"), [("case.toml", "tests.csv"), ("own/case.toml", "data/tests.csv")])
def test_written_case_has_its_table_and_motions_and_runs_again(folder, tmp_path, case, table):
    measured(folder, np.linspace(0.0, 1.0, COUNT))
    place, file = tmp_path / "cases", tmp_path / "cases" / case
    (file.parent / table).parent.mkdir(parents=True)
    shutil.copyfile(folder / "tests.csv", file.parent / table)
    for motion in folder.glob("*.AT2"):
        shutil.copyfile(motion, file.parent / motion.name)
    file.write_text(CASE.replace("tests.csv", table), encoding="utf-8")
    cases = read_cases(place)
    results = [run_case(each) for each in cases]
    assert len(results[0].inputs) == 2 + COUNT
    write_cases(cases, results, tmp_path / "written")
    (again,) = map(run_case, read_cases(tmp_path / "written"))
    assert again == results[0]
    assert not again.fault
    for each in again.inputs:
        assert hashlib.sha256((tmp_path / "written" / each.path).read_bytes()).hexdigest() == each.sha256
