"""What was found: counts by class and outcome, faults by their signature, silent differences by their place."""

from __future__ import annotations

import hashlib
import re
from collections import Counter
from dataclasses import dataclass, field, replace
from pathlib import Path

from tools.fuzz.fuzz_input import FuzzInput, saved
from tools.fuzz.judgement import BROKEN, OUTCOMES, SILENT, Judged

SHOWN = 400  # groups of silent differences in the list


@dataclass
class Findings:
    """Counts, and an example of each fault and of each group of silent differences."""

    folder: Path
    counts: Counter[tuple[str, str]] = field(default_factory=Counter)
    groups: dict[tuple[str, ...], list[tuple[FuzzInput, Judged]]] = field(default_factory=dict)
    paths: dict[tuple[str, ...], Path] = field(default_factory=dict)

    def take(self, case: FuzzInput, found: Judged, smallest: FuzzInput) -> None:
        """Count one; of a fault or a silent difference that is new, `smallest` is saved."""
        self.counts[case.group, found.outcome] += 1
        if found.outcome not in (*BROKEN, SILENT) or (found.outcome == SILENT and case.group == "options"):
            return
        key = group_of(case, found)
        if key not in self.groups:
            name = f"{case.group}-{found.outcome.replace(', ', '-')}-{_short('|'.join(key))}.json"
            self.groups[key] = []
            told = {"outcome": found.outcome, "signature": found.signature, "detail": found.detail}
            self.paths[key] = saved(smallest, self.folder / name, **told)
        self.groups[key].append((replace(case, files={}), found))

    @property
    def broken(self) -> int:
        """How many inputs ended as none may."""
        return sum(count for (_, outcome), count in self.counts.items() if outcome in BROKEN)

    def table(self) -> str:
        """Inputs by class and outcome."""
        names = list(dict.fromkeys(group for group, _ in self.counts))
        rows = [["class", "inputs", *OUTCOMES]]
        for name in (*names, "all"):
            of = [
                sum(self.counts[each, outcome] for each in (names if name == "all" else [name])) for outcome in OUTCOMES
            ]
            rows.append([name, str(sum(of)), *map(str, of)])
        widths = [max(len(row[at]) for row in rows) for at in range(len(rows[0]))]
        lines = ("| " + " | ".join(cell.ljust(w) for cell, w in zip(row, widths, strict=True)) + " |" for row in rows)
        head, *rest = lines
        return "\n".join((head, "|" + "|".join("-" * (width + 2) for width in widths) + "|", *rest)) + "\n"

    def listed(self, silent: bool) -> str:
        """Faults, or silent differences: of each group how many, an example, and where it is saved."""
        wanted = [key for key in self.groups if (key[1] == SILENT) is silent]
        lines = []
        for key in sorted(wanted, key=lambda each: (each[0], -len(self.groups[each])))[:SHOWN]:
            (case, found), number = self.groups[key][0], len(self.groups[key])
            what = "; ".join(edit.what for edit in case.edits) or " ".join(case.arguments)
            detail = found.detail if silent else found.signature
            lines.append(
                f"{' | '.join(key)} | {number}\n    {_line(what)}\n    {_line(detail)}\n    {self.paths[key]}\n"
            )
        return "".join(lines)


def group_of(case: FuzzInput, found: Judged) -> tuple[str, ...]:
    """Cases of one group are one fault to a reader."""
    if found.outcome != SILENT:
        return (case.group, found.outcome, found.signature)
    where = " + ".join(edit.where for edit in case.edits)
    kind = " + ".join(edit.what.split(":")[0].split(" at ")[0] for edit in case.edits)
    return (case.group, found.outcome, case.name, re.sub(r"\[\d+\]|\.\d+", ".#", where), kind)


def _short(text: str) -> str:
    return hashlib.sha256(text.encode("utf-8", "surrogatepass")).hexdigest()[:10]


def _line(text: str) -> str:
    return "".join(mark if mark.isprintable() else ascii(mark)[1:-1] for mark in text)[:300]
