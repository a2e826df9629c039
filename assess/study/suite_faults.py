"""The rules of a code that a suite of records does not meet, each with a change of the project that would meet it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from assess.codes.families import SUITE_CODES
from assess.codes.verdict import methods_of
from assess.messages.message import Message, Quantity, Severity, Term, Value, message, whole_number
from assess.study.motions import ScaledRecord
from assess.study.study import Study
from assess.study.suite_remedies import FILES, REMEDIES, Remedy, SuiteReview
from assess.study.suite_rules import RULES, spectrum_of_rules
from records.compliance.requirement import Requirement, Rule
from records.compliance.suite import Suite, suite_of
from spectra.spectrum import Spectrum

WHOLE = (Rule.COUNT, Rule.RUN_BELOW)
DIMENSIONS: Mapping[str, str] = {"s": "time", "-": "ratio"}


def suite_faults(
    study: Study, spectrum: Spectrum, motions: Sequence[ScaledRecord]
) -> Mapping[str, tuple[Message, ...]]:
    """Find the rules for suites that the records do not meet, by code.

    Codes whose histories are not requested are included: a floor spectrum is made of the same suite.

    Parameters
    ----------
    study : Study
        The study, with its question.
    spectrum : Spectrum
        The site's elastic spectrum.
    motions : sequence of ScaledRecord
        The suite.

    Returns
    -------
    mapping of str to tuple of Message
        By code; an empty tuple where all rules are met.
    """
    return {code: tuple(_faults(code, study, spectrum, motions)) for code in RULES}


def _faults(code: str, study: Study, spectrum: Spectrum, motions: Sequence[ScaledRecord]) -> Iterator[Message]:
    if not motions:
        yield _message("suite-empty", {}, Remedy("records.files", Term("give records"), FILES))
        return
    rules, target = RULES[code], spectrum_of_rules(code, study, spectrum)
    suite = suite_on(motions, spectrum, target)
    shortest, longest = rules.periods(study)
    review = SuiteReview(study, suite, rules.requirements(suite, shortest=shortest, longest=longest))
    yield from _not_named(code, review)
    yield from (_unmet_message(one, REMEDIES[one.rule](one, review)) for one in review.unmet)
    yield from (_out_of_reach(one, review) for one in review.found if one.verdict == "not answered")


def suite_on(motions: Sequence[ScaledRecord], spectrum: Spectrum, target: Spectrum) -> Suite:
    """Return the suite as run for the limit state of `target`: at the PGA of `target`, not at the site's."""
    share = target.pga / spectrum.pga
    return suite_of([m.record for m in motions], [m.scaling.factor * share for m in motions], target)


def _not_named(code: str, review: SuiteReview) -> Iterator[Message]:
    """Yield a message if artificial records would decide without the project naming the method."""
    question = review.study.question
    deciding = [name for name in methods_of(question) if SUITE_CODES.get(name) == code]
    silent = [name for name in deciding if name not in (question.procedures or ())]
    if review.suite.artificial.any() and silent:
        line = f'procedures = ["{silent[0]}"]'
        remedy = Remedy("verdict.procedures", Term("name it there"), line)
        yield _message("suite-not-named", {"procedure": silent[0]}, remedy)


def _unmet_message(one: Requirement, remedy: Remedy) -> Message:
    """Return the message on a rule that is not met."""
    low, high = one.periods or (0.0, 0.0)
    values: dict[str, Value] = {
        "code": one.code,
        "clause": one.clause,
        "found": _number(one, one.value or 0.0),
        "limit": _number(one, one.limit),
        "low": Quantity(low, "time", 3),
        "high": Quantity(high, "time", 3),
    }
    return _message(f"suite-{one.rule}", values, remedy)


def _out_of_reach(one: Requirement, review: SuiteReview) -> Message:
    """Return the message on a rule over periods beyond the target or the records."""
    assert one.periods is not None
    low, high = (Quantity(period, "time", 3) for period in one.periods)
    ends = Quantity(review.suite.period_range[1], "time", 3)
    values: dict[str, Value] = {"code": one.code, "clause": one.clause, "low": low, "high": high, "end": ends}
    return _message("suite-out-of-reach", values, Remedy("site.spectrum", Term("extend its table")))


def _message(key: str, values: Mapping[str, Value], remedy: Remedy) -> Message:
    said: dict[str, Value] = {**values, "remedy": remedy.text, "toml": remedy.toml}
    return message(key, said, severity=Severity.WARNING, where=remedy.key)


def _number(one: Requirement, value: float) -> Quantity:
    return whole_number(round(value)) if one.rule in WHOLE else Quantity(value, DIMENSIONS[one.unit], 3)
