"""Who judges cases: it asks for answers, keeps those of the unmutated cases, and makes findings small."""

from __future__ import annotations

from collections.abc import Callable

from tools.fuzz.answer import Answer
from tools.fuzz.fuzz_input import FuzzInput
from tools.fuzz.judgement import RIGHT, SAME, SILENT, WARNED, Judged, judged, shown
from tools.fuzz.rightly import rightly

Ask = Callable[[FuzzInput], Answer]


class Judge:
    """Judges mutated cases beside the answers of their unmutated ones."""

    def __init__(self, ask: Ask) -> None:
        self.ask = ask
        self.usual: dict[tuple[str, str], Answer] = {}

    def judge(self, case: FuzzInput, whole: FuzzInput) -> Judged:
        """The outcome of a case; whole: the same without edits."""
        if (whole.group, whole.name) not in self.usual:
            self.usual[whole.group, whole.name] = self.ask(whole)
        got, usual = self.ask(case), self.usual[whole.group, whole.name]
        result = judged(got, usual)
        if case.arguments[0] == "diff" and case.target and result.outcome in (SAME, WARNED, SILENT):
            result = shown(got, *(each.data.decode("utf-8", "replace") for each in (whole, case)))
        right = result.outcome == SILENT and rightly(case, got, usual)
        return Judged(RIGHT, detail=result.detail) if right else result

    def smallest(self, case: FuzzInput, whole: FuzzInput, found: Judged) -> FuzzInput:
        """The case with one of its edits where that alone gives the same."""
        for edit in case.edits if len(case.edits) > 1 else ():
            one = whole.edited((edit,))
            other = self.judge(one, whole)
            if (other.outcome, other.signature) == (found.outcome, found.signature):
                return one
        return case
