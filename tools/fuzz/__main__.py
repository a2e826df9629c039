"""`python -m tools.fuzz --seconds 60 --seed 1 --class record`; `--reproduce FILE` runs one finding again."""

from __future__ import annotations

import argparse
import signal
import sys
import time
from collections.abc import Iterator, Sequence
from itertools import islice
from pathlib import Path

from assess.workers import available_cores
from tools.fuzz.answer import answer
from tools.fuzz.findings import Findings
from tools.fuzz.fuzz_input import reopened
from tools.fuzz.judge import Ask, Judge
from tools.fuzz.judgement import BROKEN, SILENT
from tools.fuzz.mutations import Batch, cases_of, schedule
from tools.fuzz.seeds import GROUPS, SHARES, seed_case, seeds

FOLDER = Path("build/fuzz")


def main(arguments: Sequence[str] | None = None) -> int:
    """Run what the command line asks for; 1 where something broke."""
    asked = _parser().parse_args(arguments)
    if asked.reproduce:
        return reproduce(asked.reproduce)
    from tools.fuzz.workers import judge_batches

    started = time.monotonic()
    found = Findings(asked.out)
    for number in (signal.SIGINT, signal.SIGTERM):  # also where it runs in the background; what was found is reported
        signal.signal(number, signal.default_int_handler)
    batches = limited(planned(asked.group or list(GROUPS), seed=asked.seed), asked.inputs)
    try:
        judge_batches(batches, found.take, seed=asked.seed, jobs=asked.jobs, until=started + asked.seconds)
    except KeyboardInterrupt:
        sys.stderr.write("interrupted\n")
    return report(found, time.monotonic() - started)


def planned(groups: Sequence[str], *, seed: int, without: Sequence[str] = ()) -> Iterator[Batch]:
    """Batches of classes by their shares; without: names of seeds."""
    shares = {group: SHARES[group] if len(groups) > 1 else 1 for group in groups}
    return schedule({group: seeds(group) for group in groups}, shares=shares, seed=seed, without=without)


def limited(batches: Iterator[Batch], inputs: int | None) -> Iterator[Batch]:
    """Yield the batches that make at least `inputs` inputs, or all."""
    total = 0
    for batch in batches:
        if inputs is not None and total >= inputs:
            return
        total += batch.size
        yield batch


def fuzz(
    found: Findings, ask: Ask, *, groups: Sequence[str], seed: int, inputs: int, without: Sequence[str] = ()
) -> None:
    """Judge mutated cases of the classes in turn in this process; without: names of seeds."""
    judge = Judge(ask)
    cases = (
        (case, seed_case(batch.group, batch.name))
        for batch in planned(groups, seed=seed, without=without)
        for case in cases_of(batch, seed_case(batch.group, batch.name), seed=seed)
    )
    for case, whole in islice(cases, inputs):
        result = judge.judge(case, whole)
        read = result.outcome in BROKEN or result.outcome == SILENT
        found.take(case, result, judge.smallest(case, whole, result) if read else case)


def report(found: Findings, seconds: float) -> int:
    """Print the lists and the table; 1 where something broke."""
    found.folder.mkdir(parents=True, exist_ok=True)
    (found.folder / "silent.txt").write_text(found.listed(silent=True), encoding="utf-8")
    sys.stdout.write(found.listed(silent=False) + found.table())
    total = sum(found.counts.values())
    speed = f"{total} inputs in {seconds:.0f} s, {total / seconds:.1f} a second"
    sys.stdout.write(f"{speed}; other and silent: {found.folder}/silent.txt\n")
    return 1 if found.broken else 0


def reproduce(path: Path) -> int:
    """Run a saved case again, print what it gives, and end with 1 where it breaks."""
    case = reopened(path)
    whole = next((each for each in seeds(case.group) if each.name == case.name), case)
    got, result = answer(case), Judge(answer).judge(case, whole)
    for edit in case.edits:
        sys.stdout.write(f"{case.target} byte {edit.offset}, {edit.where}: {edit.what}\n")
    sys.stdout.write(f"assess {' '.join(case.arguments)}\n{got.err}{got.told}\n{result.outcome}: {result.detail}\n")
    return 1 if result.outcome in BROKEN else 0


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m tools.fuzz", description=__doc__)
    parser.add_argument("--seconds", type=float, default=60.0)
    parser.add_argument("--inputs", type=int, help="at most so many")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--class", dest="group", action="append", choices=list(GROUPS), help="repeat it; all if absent")
    parser.add_argument("--jobs", type=int, default=available_cores(), help="processes; all cores if absent")
    parser.add_argument("--out", type=Path, default=FOLDER)
    parser.add_argument("--reproduce", type=Path, metavar="FILE")
    return parser


if __name__ == "__main__":
    sys.exit(main())
