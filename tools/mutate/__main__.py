"""`python -m tools.mutate --mutants 150 --seed 1`: draw mutants, run the tests that reach them, and count survivors."""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections import Counter
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path
from queue import SimpleQueue

from tools.mutate.covering import Covering
from tools.mutate.equivalent import reason
from tools.mutate.kept import find_again, keep
from tools.mutate.mutant import Mutant, draw
from tools.mutate.report import outcome, report, score, table
from tools.mutate.site import ROOT
from tools.mutate.trial import Trial, collect, copy_tree, failing, try_mutant

FOLDER = ROOT / "build/mutate"


def main() -> int:
    """Return 1 where fewer than the share asked for are killed."""
    asked = _parser().parse_args()
    if asked.keep is not None:
        keep(draw(asked.mutants, seed=asked.seed), asked.keep)
        return 0
    started = time.monotonic()
    covering = Covering(FOLDER)
    covering.measure()
    below, again = tuple(asked.path or [""]), _survivors(asked.seed) if asked.again else None
    drawn = [
        each
        for each in (_found_again(asked.kept) if asked.kept else draw(asked.mutants, seed=asked.seed))
        if each.site.path.startswith(below) and (again is None or (_name(each) in again and reason(each) is None))
    ]
    trials = dict[Mutant, Trial]()
    trees = [copy_tree(FOLDER / f"tree-{number}") for number in range(asked.processes)]
    covering.collected = collect(trees[0])
    while drawn:
        for trial in _trials(drawn, covering, trees):  # the report of a run that is interrupted is of use
            trials[trial.mutant] = trial
            minutes = (time.monotonic() - started) / 60
            written = report(list(trials.values()), seed=asked.seed, minutes=minutes)
            FOLDER.joinpath("report.md").write_text(written, encoding="utf-8")
        killers = {trial.killer for trial in trials.values()} & set(covering.collected)
        unsound = failing(sorted(killers), trees[0])
        drawn = [mutant for mutant, trial in trials.items() if trial.killer in unsound]
        covering.leave_out(unsound)
    left = [_name(trial.mutant) for trial in trials.values() if outcome(trial) == "survived"]
    if not asked.path:
        _survivors_file(asked.seed).write_text(json.dumps(left))
    minutes = (time.monotonic() - started) / 60
    sys.stdout.write(f"{table(list(trials.values()))}{minutes:.0f} minutes; {FOLDER / 'report.md'}\n")
    return int(100 * score(Counter(map(outcome, trials.values()))) < asked.least)


def _found_again(file: Path) -> list[Mutant]:
    """Return the mutants of a file, and print those that are lost."""
    found, lost = find_again(file)
    for each in lost:
        sys.stdout.write(f"not found again: {each.path} {each.function}: {each.before}\n")
    return found


def _trials(mutants: Sequence[Mutant], covering: Covering, copies: Sequence[Path]) -> Iterator[Trial]:
    """Try mutants, each process in its own copy of the tree, and say what became of each."""
    trees: SimpleQueue[Path] = SimpleQueue()
    for tree in copies:
        trees.put(tree)

    def one(mutant: Mutant) -> Trial:
        tree = trees.get()
        try:
            return try_mutant(mutant, covering, tree)
        finally:
            trees.put(tree)

    with ThreadPoolExecutor(len(copies)) as pool:
        tried = as_completed([pool.submit(one, mutant) for mutant in mutants])
        for number, trial in enumerate((each.result() for each in tried), 1):
            site = trial.mutant.site
            where = f"{site.path}:{site.place[0][0]} {trial.mutant.operator}"
            sys.stdout.write(
                f"{number}/{len(mutants)} {outcome(trial)} {trial.seconds:.0f} s {where}: {trial.by[:150]}\n"
            )
            sys.stdout.flush()
            yield trial


def _name(mutant: Mutant) -> str:
    return "\n".join((mutant.site.path, mutant.site.function, *mutant.lines))


def _survivors(seed: int) -> set[str]:
    file = _survivors_file(seed)
    if not file.is_file():
        raise SystemExit(f"no run with seed {seed} has ended here; leave out --again")
    return set(json.loads(file.read_text()))


def _survivors_file(seed: int) -> Path:
    return FOLDER / f"survivors-{seed}.json"


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m tools.mutate", description=__doc__)
    parser.add_argument("--mutants", type=int, default=150)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--processes", type=int, default=2)
    parser.add_argument("--least", type=float, default=95.0, help="per cent to be killed of those not equivalent")
    parser.add_argument("--path", action="append", default=[], help="only mutants below it; repeat it; all if absent")
    parser.add_argument("--keep", type=Path, metavar="FILE", help="write those drawn to FILE as text, and try none")
    parser.add_argument("--kept", type=Path, metavar="FILE", help="those of FILE, found again by their text")
    parser.add_argument("--again", action="store_true", help="only what survived the last run with the seed")
    return parser


if __name__ == "__main__":
    sys.exit(main())
