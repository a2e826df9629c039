"""`python -m tests.fuzz --seconds 60 --seed 1 --class record`; `--reproduce FILE` runs one finding again."""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from itertools import islice
from pathlib import Path

from tests.fuzz.answer import Answer, answer
from tests.fuzz.case import Case, reopened
from tests.fuzz.findings import Findings, keep
from tests.fuzz.judgement import BROKEN, RIGHT, SAME, SILENT, WARNED, Judged, judged, shown
from tests.fuzz.mutations import mutations
from tests.fuzz.rightly import rightly
from tests.fuzz.seeds import GROUPS, SHARES, seeds

FOLDER = Path("build/fuzz")
Ask = Callable[[Case], Answer]


def main(arguments: Sequence[str] | None = None) -> int:
    """Run what the command line asks for; 1 where something broke."""
    asked = _parser().parse_args(arguments)
    if asked.reproduce:
        return reproduce(asked.reproduce)
    from tests.fuzz.workers import Worker

    worker = Worker()
    started = time.monotonic()
    found = Findings(asked.out)
    try:
        fuzz(
            found,
            worker.ask,
            groups=asked.group or list(GROUPS),
            seed=asked.seed,
            inputs=asked.inputs,
            until=started + asked.seconds,
        )
    except KeyboardInterrupt:
        sys.stderr.write("interrupted\n")
    finally:
        worker.stop()
    return report(found, time.monotonic() - started)


def fuzz(
    found: Findings,
    ask: Ask,
    *,
    groups: Sequence[str],
    seed: int,
    inputs: int | None,
    until: float = float("inf"),
    without: Sequence[str] = (),
) -> None:
    """Take mutated cases of the classes in turn until the time or the inputs are spent; without: names of seeds."""
    usual: dict[tuple[str, str], Answer] = {}

    def judge(case: Case, whole: Case) -> Judged:
        if (whole.group, whole.name) not in usual:
            usual[whole.group, whole.name] = ask(whole)
        got = ask(case)
        result = judged(got, usual[whole.group, whole.name])
        if case.group == "results" and result.outcome in (SAME, WARNED, SILENT):
            result = shown(got, *(each.data.decode("utf-8", "replace") for each in (whole, case)))
        right = result.outcome == SILENT and rightly(case, got, usual[whole.group, whole.name])
        return Judged(RIGHT, detail=result.detail) if right else result

    for case, whole in islice(_in_turn(groups, seed=seed, without=without), inputs):
        if time.monotonic() > until:
            return
        found.take(case, judge(case, whole), again=lambda other, whole=whole: judge(other, whole))  # type: ignore[misc]


def _in_turn(groups: Sequence[str], *, seed: int, without: Sequence[str]) -> Iterator[tuple[Case, Case]]:
    """Mutated and unmutated cases, the classes by their shares."""
    streams = {}
    for group in groups:
        cases = tuple(case for case in seeds(group) if case.name not in without)
        keep(cases)
        streams[group] = mutations(cases, seed=seed)
    shares = {group: SHARES[group] if len(groups) > 1 else 1 for group in groups}
    while True:
        for group, stream in streams.items():
            for _ in range(shares[group]):
                whole, case = next(stream)
                yield case, whole


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
    got = answer(case)
    whole = next((each for each in seeds(case.group) if each.name == case.name), case)
    result = judged(got, answer(whole))
    for edit in case.edits:
        sys.stdout.write(f"{case.target} byte {edit.offset}, {edit.where}: {edit.what}\n")
    sys.stdout.write(f"assess {' '.join(case.arguments)}\n{got.err}{got.told}\n{result.outcome}: {result.detail}\n")
    return 1 if result.outcome in BROKEN else 0


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m tests.fuzz", description=__doc__)
    parser.add_argument("--seconds", type=float, default=60.0)
    parser.add_argument("--inputs", type=int, help="at most so many")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--class", dest="group", action="append", choices=list(GROUPS), help="repeat it; all if absent")
    parser.add_argument("--out", type=Path, default=FOLDER)
    parser.add_argument("--reproduce", type=Path, metavar="FILE")
    return parser


if __name__ == "__main__":
    sys.exit(main())
