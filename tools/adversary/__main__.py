"""Type every value at every key of projects that fail: `make adversary`. Prints what improved, and what did in silence.

Ends with 1 where a value improves an outcome and neither an override nor a condition names it.
"""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from concurrent.futures import ProcessPoolExecutor

from tools.adversary.trials import SILENT, geometry, histories, outcome_of, pairs, sample, trials


def main() -> int:
    """Run the trials and return the exit code."""
    parser = argparse.ArgumentParser(prog="python -m tools.adversary", description=__doc__)
    parser.add_argument("--sample", type=int, help="so many trials, drawn by --seed; all if absent")
    parser.add_argument("--pairs", type=int, default=5000, help="pairs of values at two keys of one table, drawn")
    parser.add_argument("--histories", type=int, default=200, help="values at keys that bear on histories, drawn")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--key", default="", help="only keys that contain this text")
    given = parser.parse_args()
    singles = list(trials())
    of_histories = sample(list(histories()), given.histories, seed=given.seed)
    every = [*singles, *geometry(), *pairs(singles, given.pairs, seed=given.seed), *of_histories]
    chosen = [each for each in every if given.key in str(each)]
    chosen = sample(chosen, given.sample, seed=given.seed) if given.sample else chosen
    counts: Counter[str] = Counter()
    with ProcessPoolExecutor(given.jobs) as pool:
        for trial, (word, change) in zip(chosen, pool.map(outcome_of, chosen, chunksize=20), strict=True):
            counts[word] += 1
            if change:
                sys.stdout.write(f"{word:6}  {trial}: {change}\n")
                sys.stdout.flush()
    sys.stdout.write(f"{len(chosen)} trials: {', '.join(f'{count} {word}' for word, count in counts.most_common())}\n")
    return 1 if counts[SILENT] else 0


if __name__ == "__main__":
    sys.exit(main())
