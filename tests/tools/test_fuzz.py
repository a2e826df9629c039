"""A slice of the fuzzer in every run of the tests, and that it sees what it is for."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Callable
from dataclasses import replace
from itertools import islice
from pathlib import Path

import pytest

from tools.fuzz.__main__ import fuzz, planned, report, reproduce
from tools.fuzz.answer import Answer, answer
from tools.fuzz.findings import Findings
from tools.fuzz.fuzz_input import Edit, FuzzInput, reopened, saved
from tools.fuzz.judgement import (
    BUG,
    HANG,
    MEMORY,
    NOISE,
    REFUSED,
    RIGHT,
    SAME,
    SILENT,
    TRACEBACK,
    WARNED,
    Judged,
    judged,
)
from tools.fuzz.mutations import SIZE, Batch, cases_of, schedule
from tools.fuzz.rightly import rightly
from tools.fuzz.seeds import SHARES, seeds
from tools.fuzz.workers import Worker, judge_batches

QUICK = [group for group, share in SHARES.items() if share > 1]
IN_C = ("wall.step", "wall.ifc", "wall.3dm")  # readers that can take the process with them
USUAL = Answer(0, '{"p": 1.6, "warnings": ["a"]}')


def test_a_slice_ends_with_results_and_refusals_alone(tmp_path: Path) -> None:
    found = Findings(tmp_path)
    fuzz(found, answer, groups=QUICK, seed=20, inputs=150, without=IN_C)
    assert not found.broken, found.listed(silent=False)
    assert sum(found.counts.values()) == 150
    assert {outcome for _, outcome in found.counts} >= {SAME, REFUSED, RIGHT, SILENT}


@pytest.mark.parametrize("group", QUICK)
def test_the_same_seed_gives_the_same_inputs(group: str) -> None:
    whole = seeds(group)[0]
    first, second = (list(cases_of(Batch(group, whole.name, 3), whole, seed=1)) for _ in range(2))
    assert first == second
    assert first != list(cases_of(Batch(group, whole.name, 3), whole, seed=2))
    assert first != list(cases_of(Batch(group, whole.name, 4), whole, seed=1))
    assert all(case != whole for case in first)


def test_several_processes_judge_the_same_inputs_as_one(tmp_path: Path) -> None:
    alone, together = Findings(tmp_path / "1"), Findings(tmp_path / "2")
    batches = list(islice(planned(["record"], seed=5), 4))
    fuzz(alone, answer, groups=["record"], seed=5, inputs=sum(batch.size for batch in batches))
    judge_batches(iter(batches), together.take, seed=5, jobs=2, until=float("inf"))
    assert alone.counts == together.counts
    assert alone.groups.keys() == together.groups.keys()


def test_a_process_that_hangs_or_dies_is_replaced_and_goes_on_after_the_input(tmp_path: Path) -> None:
    heard: list[tuple[FuzzInput, Judged, FuzzInput]] = []
    worker = Worker(1, hangs_after=0.0)
    try:
        batch = Batch("flatfile", "spectrum", 1)
        worker.give(batch)
        worker.watch(lambda *told: heard.append(told))
        assert [(found.outcome, bool(case.files)) for _, found, case in heard] == [(HANG, True)]
        assert worker.at == 1
        worker.process.kill()
        worker.process.join()
        assert worker.hear(lambda *told: heard.append(told))
        assert (heard[-1][1].outcome, worker.at) == (MEMORY, 2)
        while worker.hear(lambda *told: heard.append(told)):
            pass
        assert len(heard) == batch.size
    finally:
        worker.stop()


def test_classes_take_turns_by_their_shares() -> None:
    cases = {group: seeds(group) for group in ("flatfile", "record")}
    inputs = Counter[str]()
    for batch in islice(schedule(cases, shares={"flatfile": 1, "record": 3}, seed=1), 200):
        inputs[batch.group] += batch.size
    assert inputs["record"] == pytest.approx(3 * inputs["flatfile"], abs=4 * SIZE)


@pytest.mark.parametrize("group", QUICK)
def test_the_unmutated_inputs_are_accepted(group: str) -> None:
    for case in seeds(group):
        got = answer(case)
        assert got.code in (0, 1, 3), (case.name, got.err)  # 1, 3: a verdict of fail, incomplete
        assert judged(got, got).outcome == SAME


@pytest.mark.parametrize(
    ("found", "outcome"),
    [
        (Answer(0, '{"p": 1.6000000001, "warnings": ["a"]}'), SAME),
        (Answer(0, '{"p": 1.60000001, "warnings": ["a"]}'), SILENT),
        (Answer(0, '{"p": null, "warnings": ["a"]}'), SILENT),
        (Answer(0, '{"p": 3.2, "warnings": ["a", "b"]}'), WARNED),
        (Answer(0, '{"p": 3.2, "warnings": ["a"]}', "assess: warning: b\n"), WARNED),
        (Answer(0, USUAL.out, "x.py:1: RuntimeWarning: overflow\n"), NOISE),
        (Answer(0, USUAL.out, "Traceback (most recent call last):\n"), TRACEBACK),
        (Answer(2, "", "assess: error: a.toml: p: no\n"), REFUSED),
        (Answer(2, "", "assess: error: a.toml\nassess: error: p\n"), BUG),
        (Answer(2, "", ""), BUG),
        (Answer(70, "", "assess: internal error: x\n", "KeyError: 1"), BUG),
        (Answer(70, "", "assess: internal error: x\n", "MemoryError"), MEMORY),
        (Answer(-1, "", "", "ValueError"), BUG),
        (Answer(None, told=HANG), HANG),
        (Answer(None, told="killed, code -11"), BUG),
    ],
)
def test_outcomes(found: Answer, outcome: str) -> None:
    assert judged(found, USUAL).outcome == outcome


def planted(fault: Callable[[FuzzInput], Answer]) -> Callable[[FuzzInput], Answer]:
    """A program that answers USUAL but for mutated inputs, which meet the fault."""
    return lambda case: fault(case) if case.edits else USUAL


def test_a_planted_fault_is_counted_saved_and_fails(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    found = Findings(tmp_path)
    crash = Answer(70, "", "assess: internal error\n", 'File "/x/assess/a.py", line 1, in f\nKeyError: 1')
    fuzz(found, planted(lambda case: crash), groups=["project"], seed=1, inputs=20)
    assert report(found, 1.0) == 1
    assert capsys.readouterr().out.startswith("project | bug | KeyError in assess/a.py:f | 20\n")
    (path,) = tmp_path.glob("project-bug-*.json")
    case = reopened(path)
    assert case.edits
    assert json.loads(path.read_text())["signature"] == "KeyError in assess/a.py:f"
    assert reproduce(path) == 0  # the program itself does not have the fault


def test_a_finding_is_the_least_of_its_edits(tmp_path: Path) -> None:
    wrong = Answer(0, '{"p": 3.2, "warnings": ["a"]}')
    found = Findings(tmp_path)
    fuzz(found, planted(lambda case: wrong), groups=["record"], seed=3, inputs=60)
    assert found.counts["record", SILENT] == 60
    assert all(len(reopened(path).edits) == 1 for path in tmp_path.glob("*.json"))


def edited(name: str, old: bytes, new: bytes) -> tuple[FuzzInput, FuzzInput]:
    """A record and the same with one word replaced, as the tests' own writers make it."""
    whole = next(case for case in seeds("record") if case.name == name)
    assert whole.data.count(old) == 1
    return whole, whole.edited((Edit(whole.data.index(old), len(old), new, "", ""),))


@pytest.mark.parametrize(
    ("name", "old", "new", "right"),
    [
        ("k-net.dat", b"Depth. (km)       30", b"Depth. (km)       31", True),  # said once
        ("k-net.dat", b"2000(gal)/2000000", b"2000(gal)/2000040", False),  # every sample
        ("k-net.dat", b"    -7349", b"    -7319", True),  # one sample, and by the mean the peak
        ("csv.dat", b"\n0.05,", b"\n0.056,", None),  # refused: an uneven step
        ("smc.dat", b"component=    360", b"component=    353", False),  # of two directions
    ],
)
def test_what_an_edit_says_itself_is_right(name: str, old: bytes, new: bytes, right: bool | None) -> None:
    whole, case = edited(name, old, new)
    got, usual = answer(case), answer(whole)
    if right is None:
        assert judged(got, usual).outcome == REFUSED
        return
    assert judged(got, usual).outcome == SILENT
    assert rightly(case, got, usual) is right


def test_one_sample_is_right_and_two_for_one_are_not() -> None:
    whole, case = edited("k-net.dat", b"Depth. (km)       30", b"Depth. (km)       31")
    usual = answer(whole)
    ((step, samples),) = usual.samples
    for many, right in ((1, True), (2, True), (3, False)):
        other = samples.copy()
        other[5 : 5 + many] += 1.0
        assert rightly(case, replace(usual, samples=((step, other),)), usual) is right
    assert not rightly(case, replace(usual, samples=((2.0 * step, samples),)), usual)


def test_a_case_is_saved_and_reopened_whole(tmp_path: Path) -> None:
    whole = seeds("mesh")[0]
    case = next(cases_of(Batch("mesh", whole.name, 1), whole, seed=1))
    assert whole.edited(case.edits) == case
    assert reopened(saved(case, tmp_path / "a" / "case.json")) == case
