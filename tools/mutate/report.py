"""The report of a run: numbers by package, and every survivor with its change."""

from __future__ import annotations

import os
import platform
import sys
from collections import Counter
from collections.abc import Sequence
from datetime import date

from tools.mutate.equivalent import entry, reason
from tools.mutate.trial import KILLED, TIMEOUT, Trial

COLUMNS = ("mutants", "killed", "timeout", "equivalent", "survived", "score")
EQUIVALENT, SURVIVED = "equivalent", "survived"


def outcome(trial: Trial) -> str:
    """Killed, timeout, equivalent or survived."""
    if trial.outcome in (KILLED, TIMEOUT):
        return trial.outcome
    return EQUIVALENT if reason(trial.mutant) is not None else SURVIVED


def score(counts: Counter[str]) -> float:
    """Killed, with those out of time, over all that are not equivalent; 1 where there is none."""
    killed, all_of = counts[KILLED] + counts[TIMEOUT], counts.total() - counts[EQUIVALENT]
    return killed / all_of if all_of else 1.0


def report(trials: Sequence[Trial], *, seed: int, minutes: float) -> str:
    """Markdown: the table, survivors, and equivalents with their reasons."""
    machine = f"{platform.system()} {platform.machine()}, {os.cpu_count()} cores, Python {sys.version.split()[0]}"
    head = f"# Mutants, seed {seed}\n\n{date.today()}, {minutes:.0f} minutes, {machine}\n"
    left = [trial for trial in trials if outcome(trial) == SURVIVED]
    same = [
        f"- {trial.mutant.site.path}, {trial.mutant.site.function}: {reason(trial.mutant)}\n{_diff(trial)}"
        for trial in trials
        if outcome(trial) == EQUIVALENT
    ]
    parts = [
        head,
        table(trials),
        f"## Survivors ({len(left)})\n",
        *map(_survivor, left),
        f"## Equivalents ({len(same)})\n",
        *same,
    ]
    return "\n".join(parts) + "\n"


def table(trials: Sequence[Trial]) -> str:
    """One row a package, and their sum."""
    packages = dict[str, Counter[str]]()
    for trial in trials:
        packages.setdefault(trial.mutant.package, Counter())[outcome(trial)] += 1
    rows = [*sorted(packages.items()), ("all", sum(packages.values(), Counter[str]()))]
    lines = [f"| package | {' | '.join(COLUMNS)} |", "|---" * (len(COLUMNS) + 1) + "|"]
    for name, counts in rows:
        cells = [counts.total(), *(counts[each] for each in COLUMNS[1:-1])]
        lines.append(f"| {name} | {' | '.join(map(str, cells))} | {100 * score(counts):.0f} % |")
    return "\n".join(lines) + "\n"


def _survivor(trial: Trial) -> str:
    site = trial.mutant.site
    where = f"### {site.path}:{site.place[0][0]} {site.function}\n\n{trial.mutant.operator}; {trial.by}\n"
    return f"{where}\n{_diff(trial)}\n```toml\n{entry(trial.mutant)}```\n"


def _diff(trial: Trial) -> str:
    return f"```diff\n{trial.mutant.diff}\n```\n"
