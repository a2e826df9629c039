"""What `assess run`, `assess envelope` and `assess fragility` print.

A run prints the verdict, the deciding answer for each mechanism, the conditions, and how likely each answer fails.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from textwrap import wrap

from assess.cli.tables import TextField, messages_text, on_one_line, table_of, text_table
from assess.cli.tables.units import in_units_of_project
from assess.codes.histories import interval_figures, margin_figures
from assess.codes.question import Missing, toml_lines
from assess.codes.verdict import (
    Answer,
    Decision,
    MechanismVerdict,
    Verdict,
    action_text,
    building_index_text,
    named_index_text,
    number_text,
    outcome_text,
    relevant_warnings,
    target_text,
)
from assess.messages.message import UNITS, Message, Quantity, Severity, Value, count_noun, escape_text, locate, message
from assess.portfolio.tasks import EXIT_CODES
from assess.project.same_building import DRAWN_HERE, works_shown
from assess.results import CriticalResult, EnvelopeResult, ReportMatter, Results
from assess.results.fragility import (
    CurveName,
    FragilityCurve,
    FragilityResults,
    LognormalResult,
    MeasureResult,
    MechanismFragility,
    RiskResult,
    StateResult,
)
from assess.results.run import UncertainAnswer, UncertaintyResult
from reports.render.table_text import csv_lines

PROVISIONAL = "with all of this given, and with safe values where they exist, the verdict would be: "
VERDICT_HEADER = ("verdict", "state", "decided by", "index", "holds up to")
LINE_WIDTH, LEAST_NAME = 100, 16  # characters of a line, and of the name of a mechanism
SHOWN_FREQUENCIES = 8  # frequencies in the table for reading
CURVE_HEADER = ["mechanism", "state", "measure", "median", "95 %", "dispersion", "95 %"]
RISK_OUTCOMES = {None: "", "pass": "within", "fail": "more", "incomplete": "not known"}
RiskOf = tuple[MechanismFragility, RiskResult]
RISK_FIELDS: tuple[TextField[RiskOf], ...] = (
    ("mechanism", lambda of: of[0].name),
    ("state", lambda of: _state_name(of[1].state)),
    ("curve", lambda of: of[1].curve),
    ("rate [1/year]", lambda of: f"{of[1].annual_rate:.2g}"),
    ("at most", lambda of: "no bound" if of[1].at_most is None else f"{of[1].at_most:.2g}"),
    ("in 50 years", lambda of: f"{100.0 * of[1].probability_50_years:.2g} %"),
    ("with epistemic", lambda of: "not given" if of[1].with_epistemic is None else f"{of[1].with_epistemic:.2g}"),
    ("target", lambda of: "" if of[1].target_rate is None else f"{of[1].target_rate:.3g}"),
    ("outcome", lambda of: RISK_OUTCOMES[of[1].outcome]),
)


def exit_code(results: Results) -> int:
    """Return the exit code of a run; a run without a verdict counts as incomplete."""
    return EXIT_CODES[Decision.INCOMPLETE if results.verdict is None else results.verdict.outcome]


def run_text(results: Results, *, verbose: bool = False) -> str:
    """Write the verdict, a line for each mechanism and limit state, why they do not pass, and what it rests on.

    Notes, which bear on nothing that decides, are counted, and written where `verbose` asks for them.
    """
    results = in_units_of_project(results)
    found = results.verdict
    if found is None:
        return "no verdict\n"
    pairs = [(one, answer) for one in found.mechanisms for answer in one.answers]
    notes = [each for each in results.warnings if each.severity == Severity.NOTE]
    lines = [
        *_reasons(found),
        *(f"rests on: {each.message.text}" for each in found.overrides),
        *(f"condition: {each.text}" for each in found.conditions),
        *_grouped("warning", [*relevant_warnings(results.warnings), *_remarks(results)]),
        *uncertainty_lines(results.uncertainty),
        *(_grouped("note", notes) if verbose else _count_of(notes)),
        *_missing(found),
    ]
    return (
        "".join(map(_wrap, (*_verdict(found, results.report), *_before(results))))
        + _answers_table(found, pairs)
        + "".join(map(_wrap, lines))
        + "".join(f"{line}\n" for line in _toml(found, results))
    )


def uncertainty_lines(found: UncertaintyResult | None) -> Iterator[str]:
    """Yield the number of samples, a line for each answer that decides, and the notes; nothing without samples."""
    if found is None:
        return
    groups = count_noun(len({each.group for each in found.inputs}), "group")
    numbers = count_noun(len(found.inputs), "uncertain number")
    yield f"uncertainty: {found.samples} samples of {numbers} in {groups}"
    yield from (_uncertain_answer(each) for each in found.answers if each.role == "deciding")
    yield from (f"note: {each.where or 'uncertainty'}: {each.text}" for each in found.notes)


def envelopes_table(results: Results) -> str:
    """Write the critical mechanism by frequency band, and the lower bounds of all mechanisms at some frequencies."""
    if results.critical is None:
        return "the project has no mechanisms\n"
    bands = text_table(["critical mechanism", "from [Hz]", "to [Hz]"], _bands(results.critical))
    return f"{bands}\n{_bounds(results)}{messages_text(results.warnings)}"


def envelopes_csv(results: Results) -> str:
    """Write a line for each frequency: the critical mechanism, then the least pulse of each [g], empty if none."""
    mapped = [(each.name, each.envelope) for each in results.mechanisms if each.envelope is not None]
    rows: list[list[str | float | None]] = [
        ["frequency [Hz]", "critical", "least [g]", *(f"{name} [g]" for name, _ in mapped)]
    ]
    if results.critical is not None:
        for k, frequency in enumerate(results.critical.frequency_hz):
            head = [frequency, results.critical.mechanism[k], results.critical.lower_bound_g[k]]
            rows.append([*head, *(one.lower_bound_g[k] for _, one in mapped)])
    return csv_lines(rows)


def fragility_table(results: FragilityResults) -> str:
    """Write median and dispersion of each curve, the rates where the hazard is known, and the messages."""
    rows = [_curve_row(each, curve) for each in results.mechanisms for curve in each.curves]
    risks = [(each, risk) for each in results.mechanisms for risk in each.risks]
    tables = [text_table(CURVE_HEADER, rows)] if rows else ["no mechanism has a fragility curve\n"]
    if risks:
        tables.append(table_of(RISK_FIELDS, risks))
    notes = (each for mechanism in results.mechanisms for each in mechanism.notes)
    of_curves = (note for each in results.mechanisms for note in _fragility_notes(each))
    return "\n".join(tables) + messages_text((*results.warnings, *notes, *of_curves))


def measure_name(measure: MeasureResult) -> str:
    """Return a measure as the project names it, with the place where that is not the ground."""
    periods = f"({measure.periods_s[0]:g} s)" if measure.key == "sa" else ""
    return f"{measure.key}{periods}" + (" at the base" if measure.at == "base" else "")


def fragility_csv(results: FragilityResults) -> str:
    """Write a line for each curve, at full precision: its lognormals with their intervals, and its rates."""
    header: list[str | float | None] = ["mechanism", "state", "share", "measure", "at", "period [s]", "unit"]
    header += ["records", "events", "censored", "median", "median low", "median high", "dispersion"]
    header += ["dispersion low", "dispersion high", "first median", "first dispersion"]
    kinds = ("rate", "lognormal rate", "first rate")
    header += [f"{kind}{which} [1/year]" for which in ("", " with epistemic") for kind in kinds]
    rows = [_curve_csv_row(each, curve) for each in results.mechanisms for curve in each.curves]
    return csv_lines([header, *rows])


def _remarks(results: Results) -> Iterator[Message]:
    """Yield what is remarked on the checks that decide, such as a failure at a lower level than the site's."""
    for one in results.mechanisms:
        for check in one.checks:
            if check.role == "deciding":
                yield from (replace(each, where=f"mechanisms.{one.name}") for each in check.remarks)


def _grouped(severity: str, messages: Iterable[Message]) -> Iterator[str]:
    """Yield each text once, with all the places that it is about."""
    places: dict[str, dict[str, None]] = {}
    for each in messages:
        places.setdefault(each.text, {})[each.where] = None
    yield from (f"{severity}: {', '.join(where)}: {text}" for text, where in places.items())


def _count_of(notes: Sequence[Message]) -> Iterator[str]:
    if notes:
        yield f"{count_noun(len(notes), 'note')} on what decides nothing: assess run -v"


def _answers_table(found: Verdict, pairs: list[tuple[MechanismVerdict, Answer]]) -> str:
    """Write the deciding answers within the line width; names get the width that the numbers leave."""
    rows = [_answer_row(one, answer, found) for one, answer in pairs]
    taken = sum(max(len(row[place]) for row in (VERDICT_HEADER, *rows)) + 2 for place in range(len(VERDICT_HEADER)))
    room = max(LEAST_NAME, LINE_WIDTH - taken)
    names = [on_one_line(escape_text(one.mechanism), room) for one, _ in pairs]
    return text_table(["mechanism", *VERDICT_HEADER], [[name, *row] for name, row in zip(names, rows, strict=True)])


def _answer_row(one: MechanismVerdict, answer: Answer, found: Verdict) -> tuple[str, ...]:
    capacity = "" if one.margin is None else _capacity_text(one.margin, one.margin_most, found.action.pga_g)
    outcome = answer.outcome if len(one.answers) > 1 else one.outcome
    verdict = _emphasise(outcome_text(outcome, near=answer.at_the_limit))
    return (
        verdict,
        answer.limit_state,
        answer.procedure,
        named_index_text(answer.index).replace(", grade", ""),
        capacity,
    )


def _capacity_text(margin: float, most: float | None, pga_g: float) -> str:
    """Write up to which PGA a mechanism holds: of histories whose numerical spread leaves a range, both ends."""
    if most is None:
        shown = margin_figures(margin, None)
        return f"{number_text(margin * pga_g, shown)} g = {number_text(margin, shown)} x"
    shown = interval_figures(margin * pga_g, most * pga_g, limit=pga_g)
    return f"{number_text(margin * pga_g, shown)} to {number_text(most * pga_g, shown)} g"


def _emphasise(outcome: str) -> str:
    """Return an outcome with its failure in capitals."""
    return outcome.replace("fail", "FAIL")


def _reasons(found: Verdict) -> Iterator[str]:
    """Yield why mechanisms do not pass, each reason once with its mechanisms and the range of its quantities."""
    groups: dict[tuple[object, ...], dict[str, list[Message]]] = {}
    for one in found.mechanisms:
        for answer in one.answers:
            if answer.outcome != Decision.PASS:
                reason = answer.reason
                same = tuple(each for each in reason.values.items() if not isinstance(each[1], Quantity))
                names = groups.setdefault((reason.key, str(same)), {})
                names.setdefault(on_one_line(one.mechanism, 40), []).append(reason)
    for names in groups.values():
        reasons = [reason for each in names.values() for reason in each]
        yield f"{', '.join(names)}: {_text_of_all(reasons)}"


def _text_of_all(reasons: Sequence[Message]) -> str:
    """Return the text of reasons that differ in their quantities alone, each given from least to largest."""
    first = reasons[0]
    if all(each.text == first.text for each in reasons):
        return first.text
    ranges: dict[str, Value] = {}
    for name, value in first.values.items():
        every = [found for each in reasons if isinstance(found := each.values.get(name), Quantity)]
        ends = sorted(every, key=lambda quantity: quantity.value)
        ranges[name] = f"{ends[0]} to {ends[-1]}" if ends and str(ends[0]) != str(ends[-1]) else value
    return message(first.key, ranges).text


def _verdict(found: Verdict, report: ReportMatter) -> Iterator[str]:
    states = ", ".join(found.limit_states) or "no limit state"
    yield f"verdict: {_emphasise(outcome_text(found.outcome, near=found.at_the_limit))}"
    yield f"basis: {found.edition or 'none'}; {states}; site's own action: {action_text(found.action)}"
    if index := building_index_text(found):
        yield f"index: {index}, target {target_text(found) or 'not known'}; local mechanisms only{_unexamined(report)}"


def _before(results: Results) -> Iterator[str]:
    """Yield what the building held before the works, and which mechanism was the weakest."""
    before = results.before
    if before is not None:
        index = "" if before.index is None else f", at most {named_index_text(before.index)}"
        weakest = f"; weakest: {on_one_line(escape_text(before.weakest), 40)}" if before.weakest else ""
        yield f"before: {before.outcome.value}{index}{weakest}"
        drawn = [each.where for each in before.differences if each.key == DRAWN_HERE]
        for heading, found in (("works", list(works_shown(before.differences))), ("drawn only after", drawn)):
            if found:
                more = f" and {len(found) - 3} more" if len(found) > 3 else ""
                yield escape_text(f"{heading}: {', '.join(found[:3])}{more}")


def _unexamined(report: ReportMatter) -> str:
    """Say what else bounds the index: how many mechanisms the building can have that were not examined."""
    if not report.building_type:
        struck = len(report.struck_out)
        return "; possible mechanisms not listed (report.building_type)" + (f", {struck} struck out" if struck else "")
    number = report.number_left_out
    return f"; {number} possible mechanism{'' if number == 1 else 's'} not examined" if number else ""


def _missing(found: Verdict) -> Iterator[str]:
    """Yield what is missing and has no line to paste, and the verdict that the safe values would give.

    Where another mechanism fails, no line to paste is printed, and all is told that those without an answer lack.
    """
    if found.outcome != Decision.INCOMPLETE:
        lacking = {key.key for one in found.mechanisms if one.outcome == Decision.INCOMPLETE for key in one.missing}
        yield from (f"missing: {each.key}: {each.text}" for each in found.missing if each.key in lacking)
        return
    yield from (f"missing: {each.key}: {each.text}" for each in found.missing if not each.toml)
    if found.provisional in (Decision.PASS, Decision.FAIL):
        yield f"{PROVISIONAL}{_emphasise(found.provisional.value)}"


def _toml(found: Verdict, results: Results) -> list[str]:
    """Return the TOML lines that complete the verdict, with why each is needed where no mechanism's reason says it."""
    given = [key for key, each in results.project.items() if each.given]
    told = {answer.reason.text for one in found.mechanisms for answer in one.answers}
    missing = [each if {reason.text for reason in each.reasons} & told else _commented(each) for each in found.missing]
    lines = toml_lines(missing, given) if found.outcome == Decision.INCOMPLETE else ()
    return (
        ["to complete it, add the following to the project file with your own values:", *map(escape_text, lines)]
        if lines
        else []
    )


def _commented(missing: Missing) -> Missing:
    """Return a missing key whose line to paste stands below a comment that says why."""
    why = wrap(escape_text(missing.text), LINE_WIDTH, initial_indent="# ", subsequent_indent="# ")
    return replace(missing, toml="\n".join((*why, missing.toml))) if missing.toml else missing


def _wrap(line: str) -> str:
    """Wrap a line to the width of the terminal."""
    return "\n".join(wrap(escape_text(line), LINE_WIDTH, subsequent_indent="  ") or [""]) + "\n"


def _uncertain_answer(answer: UncertainAnswer) -> str:
    name = on_one_line(escape_text(answer.mechanism), 40)
    check = f"{name}: {answer.procedure} {answer.limit_state}".strip()
    if answer.probability is None or answer.interval is None:
        return f"{check}: not answered in any sample"
    low, high = (f"{100.0 * each:.3g}" for each in answer.interval)
    without = f", {answer.unanswered} not answered" if answer.unanswered else ""
    share = f"{check}: fails in {100.0 * answer.probability:.3g} % of samples ({low} to {high} %)"
    return f"{share}{without}{_main_influence(answer)}"


def _main_influence(answer: UncertainAnswer) -> str:
    """Name the group that explains most of the ratio; empty where none explains any."""
    known = [(each.share, each.group) for each in answer.influences if each.share is not None]
    if not known:
        return ""
    share, group = max(known)
    return f"; most by {on_one_line(escape_text(group), 40)} (share {share:.2g})"


def _bands(critical: CriticalResult) -> list[list[str]]:
    return [[band.mechanism or "none overturns", f"{band.from_hz:.3g}", f"{band.to_hz:.3g}"] for band in critical.bands]


def _bounds(results: Results) -> str:
    mapped = [(each.name, each.envelope) for each in results.mechanisms if each.envelope is not None]
    frequency = mapped[0][1].frequency_hz
    places = sorted({round(k * (len(frequency) - 1) / (SHOWN_FREQUENCIES - 1)) for k in range(SHOWN_FREQUENCIES)})
    header = ["least pulse [g] at", *(f"{frequency[place]:.3g} Hz" for place in places)]
    return text_table(header, [[name, *(_bound(one, place) for place in places)] for name, one in mapped])


def _bound(one: EnvelopeResult, place: int) -> str:
    bound = one.lower_bound_g[place]
    return f"> {one.amplitude_g[-1]:.3g}" if bound is None else f"{bound:.3g}"


def _fragility_notes(mechanism: MechanismFragility) -> Iterator[Message]:
    """Yield the notes on the curves and on the rates, each once with all measures that it is about."""
    grouped: list[tuple[StateResult, Message, list[str]]] = []
    curves: tuple[FragilityCurve | RiskResult, ...] = (*mechanism.curves, *mechanism.risks)
    for one in curves:
        for note in one.notes:
            measures = next((each[2] for each in grouped if each[:2] == (one.state, note)), None)
            if measures is None:
                grouped.append((one.state, note, measures := []))
            measures.append(measure_name(one.measure))
    for state, note, measures in grouped:
        yield from locate([note], f"mechanisms.{mechanism.name}, {_state_name(state)} by {', '.join(measures)}")


def _curve_row(mechanism: MechanismFragility, curve: FragilityCurve) -> list[str]:
    fitted, unit = curve.lognormal, UNITS[curve.measure.dimension]
    head = [mechanism.name, _state_name(curve.state), measure_name(curve.measure)]
    if fitted is None:
        return [*head, "none", *[""] * 3]
    median = f"{fitted.median:.3g}" + ("" if unit == "-" else f" {unit}")
    return [
        *head,
        median,
        _interval(fitted.median_interval),
        f"{fitted.dispersion:.2f}",
        _interval(fitted.dispersion_interval),
    ]


def _interval(found: tuple[float, float] | None) -> str:
    return "" if found is None else f"{found[0]:.3g} to {found[1]:.3g}"


def _state_name(state: StateResult) -> str:
    """Return a state in words of the project file."""
    return state.name if state.share is None else f"{state.share:g} of overturning"


def _curve_csv_row(mechanism: MechanismFragility, curve: FragilityCurve) -> list[str | float | None]:
    measure = curve.measure
    period = measure.periods_s[0] if measure.key == "sa" else None
    risks = [_risk(mechanism, curve, name) for name in ("empirical", "lognormal", "first")]
    rates = [None if each is None else each.annual_rate for each in risks]
    rates += [None if each is None else each.with_epistemic for each in risks]
    first = (None, None) if curve.first is None else (curve.first.median, curve.first.dispersion)
    head = [mechanism.name, curve.state.name, curve.state.share, measure.key, measure.at, period]
    counts = [curve.records, curve.events, curve.censored]
    return [*head, UNITS[measure.dimension], *counts, *_lognormal_cells(curve.lognormal), *first, *rates]


def _lognormal_cells(fitted: LognormalResult | None) -> list[float | None]:
    if fitted is None:
        return [None] * 6
    median, dispersion = fitted.median_interval or (None, None), fitted.dispersion_interval or (None, None)
    return [fitted.median, *median, fitted.dispersion, *dispersion]


def _risk(mechanism: MechanismFragility, curve: FragilityCurve, name: CurveName) -> RiskResult | None:
    same = (curve.measure, curve.state, name)
    return next((each for each in mechanism.risks if (each.measure, each.state, each.curve) == same), None)
