"""The cases of `assess verify` on the terminal: a line for each, and what they come to."""

from __future__ import annotations

from collections.abc import Iterator

from assess.cli.tables.text_table import on_one_line
from assess.messages.message import count_noun
from assess.results.verification import USES, CaseResult, Spread, ValueResult, VerificationResults

WIDEST = 160  # characters of a line
MOST_FAILURES = 5  # values that fail, of one case
DIGITS, MOST_DIGITS = 6, 17  # of a value; with the latter every number differs from every other


def verification_text(results: VerificationResults, *, seconds: float) -> str:
    """Write a line for each case, what is wrong with those that fail, and the totals.

    Parameters
    ----------
    results : of `assess verify`
    seconds : that it took
    """
    return "".join(f"{on_one_line(line, WIDEST)}\n" for line in (*_cases(results), *_totals(results, seconds)))


def _cases(results: VerificationResults) -> Iterator[str]:
    width = max((len(each.key) for each in results.cases), default=0)
    for case in results.cases:
        parts = [count_noun(len(case.values), "value")]
        if case.shares:
            parts.append(f"worst {max(case.shares):.2g} of the tolerance")
        elif case.outcome == "pass":
            parts.append("exact")
        if case.misprints:
            parts.append(count_noun(case.misprints, "misprint"))
        if case.is_indicative:
            parts.append("indicative only")
        said = case.fault or ", ".join(parts)
        word = "FAIL" if case.outcome == "fail" else "pass"
        yield f"{word}  {case.key:<{width}}  {said}"
        if case.outcome == "fail" and not case.fault:
            yield from _failures(case)


def _failures(case: CaseResult) -> Iterator[str]:
    wrong = [(each.name, value) for each in case.quantities for value in each.values if value.outcome == "fail"]
    for name, value in wrong[:MOST_FAILURES]:
        yield f"      {name}{f', {value.row}' if value.row else ''}: {_compared(value)}"
    if len(wrong) > MOST_FAILURES:
        yield f"      and {len(wrong) - MOST_FAILURES} more"


def _compared(value: ValueResult) -> str:
    """Write both numbers, with so many digits that they differ."""
    if value.found is None:
        return f"{value.reference:.{DIGITS}g} expected, none found"
    pairs = ((f"{value.reference:.{n}g}", f"{value.found:.{n}g}") for n in range(DIGITS, MOST_DIGITS + 1))
    expected, found = next((each for each in pairs if each[0] != each[1]), (repr(value.reference), repr(value.found)))
    return f"{expected} expected, {found} found"


def _totals(results: VerificationResults, seconds: float) -> Iterator[str]:
    values = sum(len(each.values) for each in results.quantities)
    parts = (
        count_noun(len(results.cases), "case"),
        count_noun(len(results.quantities), "quantity", "quantities"),
        count_noun(values, "value"),
        count_noun(sum(each.misprints for each in results.cases), "misprint"),
        f"{len(results.failures)} failed",
    )
    yield f"{', '.join(parts)}, in {seconds:.0f} s{' (quick cases only)' if results.quick else ''}"
    if results.shares.worst is not None:
        yield f"difference over tolerance: {_spread(results.shares)}"
    if results.relative.worst is not None:
        yield f"over the largest value of its quantity: {_spread(results.relative)} ({', '.join(results.farthest)})"
    indicative = len(results.cases) - len(results.evidence)
    if indicative:
        yield f"{count_noun(indicative, 'case')} indicative only: no evidence, not among these differences"
    if results.foreign:
        yield f"{count_noun(len(results.foreign), 'case')} not as with the program: {', '.join(results.foreign)}"
    bare = [str(USES[each.use]) for each in results.coverage if each.use not in results.passed_uses]
    if bare:
        yield f"used by the project, without a case that passes and is evidence: {'; '.join(bare)}"


def _spread(spread: Spread) -> str:
    if spread.median is None or spread.worst is None:
        return "none"
    return f"median {spread.median:.2g}, worst {spread.worst:.2g}"
