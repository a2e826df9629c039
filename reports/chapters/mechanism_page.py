"""The page of one mechanism: what it is and how it moves, its parameters and answers, and what governs them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import partial
from math import atan2, degrees

from assess.codes.bases import IndexKind
from assess.codes.check import NEEDED, Check, Outcome
from assess.codes.histories import margin_figures, ratio_figures, side_figures
from assess.codes.verdict import Answer, Decision, MechanismVerdict, Verdict
from assess.messages.message import DIMENSIONS, Message, Severity
from assess.results import MechanismResult, OscillatorResult, Results
from reports import governing, joints
from reports.chapters import verdict_texts
from reports.chapters.cells import (
    ALLOWABLE,
    BRANCHES,
    CAPACITY_PGA,
    DEMAND,
    FIGURES,
    METHOD,
    NONE,
    OUTCOME,
    RATIO,
    ROLES,
    capacity_cell,
    capacity_pga_cell,
    comparison_clause,
    demand_cell,
    demand_or_rest,
    outcome_cell,
    ratio_cell,
    swept_value,
)
from reports.chapters.verdict_texts import (
    capacity_pga_text,
    has_reduced_target,
    index_text,
    outcome_text,
    state_text,
    target_text,
)
from reports.document import Block, BulletList, Cell, Column, Facts, Figure, FigureRow, Prose, Section, Table, nonempty
from reports.figures import capacity, comparison, key_plan, sketch
from reports.figures.key_plan import BuildingScene
from reports.language.texts import (
    Listing,
    Paragraph,
    Phrase,
    Term,
    Text,
    Verbatim,
    count,
    listing,
    names,
    quantity,
    say,
    say_count,
)
from reports.project_values import split_key
from reports.titles import check_title, mechanism_number, mechanism_title, procedure_title

ALONG_X = 1.0 - 1e-9  # cosine of a direction that is the x axis of the model


def sections(
    results: Results, mechanism: MechanismResult, stem: str, building: BuildingScene | None = None
) -> list[Section]:
    """Return the page of a mechanism.

    stem : beginning of the names of its figures and tables
    building : the bodies of all mechanisms, None where its place among them is not drawn
    """
    beside = tuple(represented_case(results, mechanism))
    answers = answers_table(results, mechanism, name=f"{stem}-answers")
    warnings = mechanism_warnings(results, mechanism)
    pairs = _in_pairs([*_shape_figures(mechanism, stem, building), *_curve_figures(mechanism, stem)])
    blocks: list[Block] = [
        Prose((description(mechanism), *beside)),
        *verdict_summary(results, mechanism),
        *pairs[:1],
        branch_parameters_table(results, mechanism, name=f"{stem}-page-parameters"),
        *pairs[1:],
        *nonempty(answers),
        Prose(tuple(_findings(results, mechanism))),
    ]
    if warnings:
        blocks += [Prose((say("Remarks on this mechanism:"),)), BulletList(warnings)]
    title, mark = Verbatim(mechanism_title(mechanism)), mechanism_number(results, mechanism.name)
    return [Section(title, 0, tuple(block for block in blocks if block != Prose(())), starts_page=True, mark=mark)]


def _in_pairs(figures: list[Figure]) -> list[Block]:
    """Return figures two by two; a last one has the width of the page."""
    pairs = (figures[start : start + 2] for start in range(0, len(figures), 2))
    return [FigureRow(tuple(pair)) if len(pair) > 1 else pair[0] for pair in pairs]


def _shape_figures(mechanism: MechanismResult, stem: str, building: BuildingScene | None) -> Iterator[Figure]:
    yield Figure(f"{stem}-sketch", sketch_caption(mechanism), partial(sketch.draw_sketch, mechanism))
    if building is not None and mechanism.name in building.mechanisms:
        caption = say("Its place in the building; the arrow is the direction of motion.")
        yield Figure(f"{stem}-place", caption, partial(key_plan.draw_place, building, mechanism.name))


def sketch_caption(mechanism: MechanismResult) -> Text:
    """Return the caption of the drawing of a mechanism, whose x may be another than the axis of the model."""
    shape = _shape_caption(mechanism)
    if mechanism.direction is None or mechanism.direction[0] > ALONG_X:
        return shape
    return Paragraph((shape, say("This x is not the axis of the model.")))


def _shape_caption(mechanism: MechanismResult) -> Text:
    turned = quantity(mechanism.drawing.displaced.rotation_rad, "rotation", 2)
    if mechanism.drawing.displaced_negative is None:
        return say(
            "At rest, and turned by φ = {rotation}; x along the motion. Circles: hinges; crosses: centroids.",
            rotation=turned,
        )
    return say(
        "At rest, and turned by φ = {rotation} to its positive side (dashed: to its negative side); x along the "
        "motion. Circles: hinges; crosses: centroids.",
        rotation=turned,
    )


def _curve_figures(mechanism: MechanismResult, stem: str) -> Iterator[Figure]:
    caption = say("Capacity curve: restoring moment over rotation, with the rotation φₒᵥ that overturns.")
    yield Figure(f"{stem}-capacity", caption, partial(capacity.draw_capacity, mechanism))
    if mechanism.checks:
        caption = say("Largest rotation over peak ground acceleration by each method; large markers: allowable.")
        yield Figure(f"{stem}-pga-rotation", caption, partial(comparison.draw_pga_rotation, mechanism))


def _findings(results: Results, mechanism: MechanismResult) -> Iterator[Text]:
    yield from verdict_sentences(results, mechanism)
    worst = governing.worst_per_procedure(governing.checks_at_site(results, mechanism))
    silent = [check.procedure for check in worst if check.verdict == Outcome.NOT_APPLICABLE]
    yield from unanswered_methods(results, mechanism)
    if silent:
        methods = listing(procedure_title(name) for name in dict.fromkeys(silent))
        yield say("Methods that do not apply to this mechanism: {methods}.", methods=methods)


KINDS: Mapping[str, Phrase] = {
    "single-block": say("A single block"),
    "two-block": say("A wall held at its top and bottom, cracked between them into two blocks,"),
    "four-hinge": say("A chain of three blocks with four hinges"),
    "equivalent-block": say("An equivalent block, given by its rocking parameters instead of a geometry,"),
}

AMPLIFICATIONS: Mapping[str, Text] = {
    "modal-filter": say("filtered by the first mode"),
    "srss": say("thesis eq. 3.48"),
    "srss-relative": say("thesis eq. 3.48, for pulses 3.47"),
    "ec8": say("EN 1998-1, 4.3.5.2, for a rigid part"),
    "ec8-resonance": say("EN 1998-1, 4.3.5.2, at resonance"),
    "ec8-printed": say("thesis eq. 3.49"),
    "nzs1170.5": say("NZS 1170.5, 8.3"),
}
"""How the motion of the ground is carried up a building, by the methods of the project file."""
AXES: Mapping[int, str] = {0: "+x", 90: "+y", 180: "−x", -180: "−x", -90: "−y"}
ON_GROUND = 0.005  # height of a base that is on the ground [m]
HINGE_NOTES = ("hinges-found-positive", "hinges-found-negative")  # notes that belong on the page

MAX_NAMED_LOADS = 5
"""Loads that are named in a sentence; of more only the number is given."""


def description(mechanism: MechanismResult) -> Paragraph:
    """Describe what the mechanism is and how it moves, where it stands, its joints and its loads."""
    return Paragraph((_motion(mechanism), *_base(mechanism), _joints(mechanism), *_loads(mechanism)))


def _motion(mechanism: MechanismResult) -> Text:
    kind = KINDS.get(mechanism.kind, Verbatim(mechanism.kind))
    way = motion_direction(mechanism)
    if way is None:
        if mechanism.sides == "two":
            return say("{kind} that rocks to both sides.", kind=kind)
        return say("{kind} that rocks to one side only.", kind=kind)
    if mechanism.sides == "two":
        return say("{kind} that rocks to both sides, positive towards {direction}.", kind=kind, direction=way)
    return say("{kind} that rocks to one side only, towards {direction}.", kind=kind, direction=way)


def motion_direction(mechanism: MechanismResult) -> Text | None:
    """Return the direction of positive rotation: an axis, or its angle; None for an equivalent block."""
    if mechanism.direction is None:
        return None
    along, across, _ = mechanism.direction
    angle = round(degrees(atan2(across, along)), 3)
    if angle in AXES:
        return Verbatim(AXES[int(angle)])
    return say("{angle} from +x towards +y", angle=quantity(atan2(across, along), "angle", 3))


def _base(mechanism: MechanismResult) -> Iterator[Text]:
    height, carried = mechanism.base_elevation_m, mechanism.amplification
    if height is not None and not mechanism.above_ground:
        yield say("Its base is on the ground.")
    elif height is not None and abs(height) < ON_GROUND and mechanism.input_height_m is not None:
        yield say(
            "Its base is on the ground, and it is held above: the input acts at the mean height of its supports, "
            "{height}.",
            height=quantity(mechanism.input_height_m, "length", 3),
        )
    elif height is not None:
        yield say("Its base is {height} above the ground.", height=quantity(height, "length", 3))
    if carried.height_m is not None:
        yield say(
            "In the time histories the ground motion is amplified up to it ({method}).",
            method=AMPLIFICATIONS.get(carried.method, Verbatim(carried.method)),
        )
    elif mechanism.above_ground and mechanism.histories:
        yield say("The time histories apply the ground motion to it unamplified.")
    if mechanism.direction_sweep is not None:
        yield say_count(
            "The direction is the only one tried.",
            "The direction is the weakest of {number} around the circle.",
            len(mechanism.direction_sweep.angle_deg),
        )


def _joints(mechanism: MechanismResult) -> Text:
    return say(
        "Joints: {model}; coefficient of restitution: {source}.",
        model=listing(joints.JOINT_MODELS.get(model, Verbatim(model)) for model in joints.model_names(mechanism)),
        source=Listing(mechanism.restitution_said or (Term(mechanism.restitution_source),), ""),
    )


def _loads(mechanism: MechanismResult) -> Iterator[Text]:
    loads = mechanism.loads
    if len(loads) > MAX_NAMED_LOADS:
        yield say_count("It carries {number} load.", "It carries {number} loads.", len(loads))
    elif loads:
        yield say("Loads: {names}.", names=names(load.name for load in loads))


def represented_case(results: Results, mechanism: MechanismResult) -> Iterator[Text]:
    """State the case that represents a mechanism that was swept."""
    for sweep in results.sweeps:
        if sweep.mechanism == mechanism.name and sweep.governs:
            yield say_count(
                "One value of {key} was studied; this page shows it: {value}.",
                "{number} values of {key} were studied; this page shows the most critical one: {value}.",
                len(sweep.value),
                key=Verbatim(sweep.key),
                value=swept_value(sweep.value[sweep.controlling], sweep.unit),
            )


def mechanism_warnings(results: Results, mechanism: MechanismResult) -> tuple[Message, ...]:
    """Return the warnings that concern the mechanism by its name, each once, and how its hinges were found."""
    found = (each for each in results.warnings if each.severity != Severity.NOTE or each.key in HINGE_NOTES)
    own = {each.text: each for each in found if split_key(results, each.where)[0] == mechanism.name}
    return tuple(own.values())


def verdict_sentences(results: Results, mechanism: MechanismResult) -> Iterator[Text]:
    """Yield what governs, up to which action the mechanism holds, and what would make it pass or complete."""
    found, own = results.verdict, governing.verdict_of(results, mechanism)
    if found is None or own is None:
        return
    if not found.basis:
        yield say("No code is named that decides: the results of all methods are for comparison only.")
        return
    for answer in own.answers:
        yield _governing_sentence(governing.checks_at_site(results, mechanism), answer)
        yield from _floor_motion(governing_check(governing.checks_at_site(results, mechanism), answer))
        yield from _numerical_spread(governing_check(governing.checks_at_site(results, mechanism), answer))
    yield from _failing_within_ratio(own)
    yield from _passing_by_target(own, found)
    yield from _margin_or_lack(own, found)
    if own.at_the_limit:
        yield say(
            "The answer is at the limit: within 5 % of it, or within what the tolerance of the survey or the numerical "
            "spread of histories changes."
        )
    if own.conditions:
        yield say("The answer depends on the conditions listed with the verdict.")


def _failing_within_ratio(own: MechanismVerdict) -> Iterator[Text]:
    """Yield why an answer fails whose ratio is within 1, as by histories."""
    for answer in own.answers:
        if answer.outcome == Decision.FAIL and answer.ratio is not None and answer.ratio <= 1.0:
            yield say("It fails although this ratio is not above 1: {reason}.", reason=answer.reason)


def _passing_by_target(own: MechanismVerdict, found: Verdict) -> Iterator[Text]:
    """Yield why a ratio above 1 passes, where the target is less than full safety."""
    above = any(answer.ratio is not None and answer.ratio > 1.0 for answer in own.answers)
    target = target_text(found)
    if own.outcome == Decision.PASS and has_reduced_target(found) and above and target is not None:
        yield say("It passes, as the target is less than full safety: {target}.", target=target)


def verdict_summary(results: Results, mechanism: MechanismResult) -> list[Facts]:
    """Return the verdict of the mechanism with its indices; none without a verdict."""
    own = governing.verdict_of(results, mechanism)
    if own is None:
        return []
    outcome = outcome_text(own.outcome, near=own.at_the_limit)
    found = [(answer.limit_state, index_text(answer.index)) for answer in own.answers if answer.index is not None]
    indices = [
        say("{index} at {state}", index=index, state=state_text(state)) if len(found) > 1 else index
        for state, index in found
    ]
    text = say("{outcome}, {index}", outcome=outcome, index=listing(indices)) if indices else outcome
    known = verdict_texts.mechanism_knowledge(results, mechanism)
    if known is not None:
        text = say("{verdict}; knowledge level: {knowledge}", verdict=text, knowledge=verdict_texts.factor_text(*known))
    return [Facts(((say("Verdict"), text),))]


def unanswered_methods(results: Results, mechanism: MechanismResult) -> Iterator[Text]:
    """Yield why methods of codes, besides the one that governs, gave no answer; those with one reason together."""
    own = governing.verdict_of(results, mechanism)
    governs = () if own is None else tuple(answer.procedure for answer in own.answers)
    checks = governing.worst_per_procedure(governing.code_checks(governing.checks_at_site(results, mechanism)))
    silent = [each for each in checks if each.verdict == Outcome.NOT_ANSWERED and each.procedure not in governs]
    for reason in {check.reason.text: check.reason for check in silent}.values():
        same = dict.fromkeys(check.procedure for check in silent if check.reason.text == reason.text)
        yield say("No answer by {methods}: {reason}.", methods=listing(map(procedure_title, same)), reason=reason)


def governing_check(checks: tuple[Check, ...], answer: Answer) -> Check | None:
    """Return the check behind an answer, of those at the site's own action; None where no method was asked."""
    own = tuple(check for check in governing.code_checks(checks) if check.procedure == answer.procedure)
    of_state = tuple(check for check in own if check.limit_state == answer.limit_state)
    return governing.worst_check(of_state or own)


def _governing_sentence(checks: tuple[Check, ...], answer: Answer) -> Text:
    """Return the governing check with its numbers and clause, or why there is none."""
    check = governing_check(checks, answer)
    if check is None or answer.outcome == Decision.INCOMPLETE:
        return _unanswered(answer)
    method, state, by = (
        procedure_title(check.procedure),
        state_text(answer.limit_state),
        Term(comparison_clause(check) or check.edition),
    )
    if not check.demand or check.capacity is None or check.ratio is None:
        return say(
            "{method} governs at {state}: {reason} ({clause}).",
            method=method,
            state=state,
            reason=check.reason,
            clause=by,
        )
    figures = ratio_figures(check, most=FIGURES)
    return say(
        "{method} governs at {state}: {quantity} {demand} against an allowable {allowable}, a ratio of {ratio} "
        "({clause}).",
        method=method,
        state=state,
        quantity=Term(check.quantity),
        demand=quantity(check.demand, DIMENSIONS.get(check.unit, "ratio"), figures),
        allowable=quantity(check.capacity, DIMENSIONS.get(check.unit, "ratio"), FIGURES),
        ratio=quantity(check.ratio, "ratio", figures),
        clause=by,
    )


def _floor_motion(check: Check | None) -> Iterator[Text]:
    """Yield which motion of the building a check takes, where it takes that of a floor."""
    steps = {} if check is None else {step.symbol: step for step in check.steps}
    share, period = steps.get("γψ"), steps.get("T1")
    height = next((each.value for each in share.inputs if each.symbol == "Z"), None) if share else None
    if share is None or share.value is None or period is None or period.value is None or height is None:
        return
    yield say(
        "Its demand takes the motion of the building at {height} above the ground: first-mode factor γψ = {share} "
        "({clause}), elastic first period {period}.",
        height=quantity(height, "length", FIGURES),
        share=quantity(share.value, figures=FIGURES),
        clause=Term(share.clause),
        period=quantity(period.value, "time", FIGURES),
    )


def _numerical_spread(check: Check | None) -> Iterator[Text]:
    """Yield in how many draws among the runs of histories the rule holds; that is no scatter of earthquakes."""
    if check is None or check.numerical is None or check.verdict not in (Outcome.PASS, Outcome.FAIL):
        return
    yield say(
        "Numerical spread: the rule holds in {share} of {draws} draws among the {runs} runs of each record; a pass "
        "needs {least}. The scatter from record to record is something else, and belongs to the suite.",
        share=quantity(100.0 * check.numerical.holds, "percent", FIGURES),
        draws=count(check.numerical.draws),
        runs=count(check.numerical.runs),
        least=quantity(100.0 * NEEDED, "percent", 2),
    )


def _unanswered(answer: Answer) -> Text:
    """Return why a limit state has no answer, with what it would be."""
    if answer.provisional is None:
        return say(
            "There is no answer for {state}: {reason}.", state=state_text(answer.limit_state), reason=answer.reason
        )
    if answer.provisional == Decision.PASS:
        return say(
            "There is no answer for {state}: {reason}. With the safe value of what is missing it would pass.",
            state=state_text(answer.limit_state),
            reason=answer.reason,
        )
    return say(
        "There is no answer for {state}: {reason}. With the safe value of what is missing it would fail.",
        state=state_text(answer.limit_state),
        reason=answer.reason,
    )


def _margin_or_lack(own: MechanismVerdict, found: Verdict) -> Iterator[Text]:
    """Yield the margin of a pass, the factor that a failure lacks, or what is missing."""
    held = None if own.margin is None else capacity_pga_text(own, own.margin, found.action)
    if own.outcome == Decision.INCOMPLETE:
        if own.missing:
            yield say("An answer needs {keys}.", keys=names(each.key for each in own.missing))
    elif own.outcome == Decision.PASS and own.margin is not None and held is not None and own.margin_most is not None:
        yield say(
            "It holds up to a peak ground acceleration of {pga}, the numerical spread of the histories; the lower end "
            "counts, {margin} times the site’s own.",
            pga=held,
            margin=quantity(own.margin, "ratio", margin_figures(own.margin, own.margin_most)),
        )
    elif own.outcome == Decision.PASS and own.margin is not None and held is not None:
        yield say(
            "It holds up to a peak ground acceleration of {pga}, {margin} times the site’s own.",
            pga=held,
            margin=quantity(own.margin, "ratio", margin_figures(own.margin, own.margin_most)),
        )
    elif own.outcome == Decision.FAIL:
        yield from _lacking(own, found, held)


def _lacking(own: MechanismVerdict, found: Verdict, held: Text | None) -> Iterator[Text]:
    """Yield by how much a mechanism that fails would have to resist more."""
    factor = required_increase(own, found)
    if factor is None:
        return
    shown = quantity(factor, "ratio", required_increase_figures(own, factor))
    if held is None:
        yield say("To pass, its resistance must be {factor} times as large.", factor=shown)
    else:
        yield say(
            "It holds up to a peak ground acceleration of {pga}; to pass, this must be {factor} times as large.",
            pga=held,
            factor=shown,
        )


def required_increase(own: MechanismVerdict, found: Verdict) -> float | None:
    """Return by how much the resistance of a failing mechanism must grow; None where the numbers do not tell.

    It is the target over the index of the basis, where it has one as a share of the action; else the inverse of the
    margin; else the ratio of demand to capacity.
    """
    failing = [answer for answer in own.answers if answer.outcome == Decision.FAIL]
    shares = [a.index.value for a in failing if a.index is not None and a.index.name != IndexKind.DEMAND_CAPACITY]
    if shares and found.target is not None and min(shares) > 0.0:
        return found.target / min(shares)
    if own.margin is not None and 0.0 < own.margin < 1.0:
        return 1.0 / own.margin
    return max((answer.ratio for answer in failing if answer.ratio is not None), default=None)


def required_increase_figures(own: MechanismVerdict, factor: float) -> int:
    """Return to how many figures that factor stands, as the indices and the margin that it comes from."""
    stand = [each.index.figures for each in own.answers if each.outcome == Decision.FAIL and each.index is not None]
    stand += [margin_figures(own.margin, own.margin_most)] if own.margin else []
    return side_figures(factor, min(FIGURES, *stand))


ParameterColumn = tuple[Column, Callable[[OscillatorResult], Cell]]


def _share_of_mass(mechanism: MechanismResult) -> float | None:
    """Return the fraction of participating mass e* of the kinematic analyses; None without one."""
    steps = (step for check in mechanism.checks for step in check.steps if step.symbol == "e*")
    return next((step.value for step in steps), None)


def _page_parameters(results: Results, mechanism: MechanismResult) -> list[ParameterColumn]:
    """Return the eight parameters that an engineer checks by hand."""
    joint = mechanism.oscillator.overturning_flexible_rad is not None
    return [
        (Column(say("Mass M"), "mass"), lambda of: of.mass_kg if _has_mass(results, mechanism) else None),
        (Column(say("Radius R"), "length"), lambda of: of.radius_m),
        (Column(say("Slenderness α"), "rotation"), lambda of: of.slenderness_rad),
        (Column(say("Frequency parameter p"), "angular frequency"), lambda of: of.p_eq_per_s),
        _on_joints() if joint else _at_uplift(),
        (Column(say("Overturning φₒᵥ"), "rotation"), lambda of: of.overturning_rad),
        (Column(say("Restitution η"), "ratio"), lambda of: of.restitution),
        *_mass_share_or_period(results, mechanism),
    ]


def _has_mass(results: Results, mechanism: MechanismResult) -> bool:
    """Return whether the mass is known: that of an equivalent block is a unit mass unless the project gives it."""
    given = results.project.get(f"mechanisms.{mechanism.name}.mass")
    return mechanism.kind != "equivalent-block" or (given is not None and given.given)


def _at_uplift() -> ParameterColumn:
    def multiplier(of: OscillatorResult) -> Cell:
        return NONE if of.uplift_multiplier is None else of.uplift_multiplier

    return Column(say("Multiplier at uplift λ"), "ratio"), multiplier


def _on_joints() -> ParameterColumn:
    return Column(say("Overturning on its joints"), "rotation"), lambda of: of.overturning_flexible_rad


def _mass_share_or_period(results: Results, mechanism: MechanismResult) -> list[ParameterColumn]:
    """Return the fraction of participating mass, or the longest equivalent period where no analysis has that."""
    share, motion = _share_of_mass(mechanism), results.ground_motion
    if share is not None:
        return [(Column(say("Participating share e*"), "ratio"), lambda _: share)]
    periods = () if motion is None else motion.equivalent_periods
    longest = next((one.longest_s for one in periods if one.mechanism == mechanism.name), None)
    return [] if longest is None else [(Column(say("Equivalent period"), "time"), lambda _: longest)]


def branch_parameters_table(results: Results, mechanism: MechanismResult, *, name: str) -> Table:
    """Tabulate the parameters, a row for each branch; one row where both are alike."""
    shown = _page_parameters(results, mechanism)
    rows: list[tuple[Cell, ...]] = []
    for title, branch in (("positive", mechanism.oscillator), ("negative", mechanism.oscillator_negative)):
        if branch is not None:
            rows.append((BRANCHES[title], *(value(branch) for _, value in shown)))
    if len(rows) == 2 and rows[0][1:] == rows[1][1:]:
        rows = [(say("both"), *rows[0][1:])]
    caption = say("Rocking parameters of each branch, that is, direction of rotation.")
    return Table(name, caption, (Column(say("Branch")), *(column for column, _ in shown)), tuple(rows), small=True)


def shown_checks(results: Results, mechanism: MechanismResult) -> tuple[Check, ...]:
    """Return the worst check of each method and limit state at the site's own action, those that decide first."""
    worst = governing.worst_per_procedure(governing.checks_at_site(results, mechanism))
    applicable = (check for check in worst if check.verdict != Outcome.NOT_APPLICABLE)
    return tuple(sorted(applicable, key=lambda check: (check.reading == "thesis", check.role != "deciding")))


def answers_table(results: Results, mechanism: MechanismResult, *, name: str) -> Table:
    """Tabulate the answers at the site's own action, a row for each method and limit state."""
    shown = shown_checks(results, mechanism)
    columns = (METHOD, Column(say("Role")), DEMAND, ALLOWABLE, RATIO, CAPACITY_PGA, OUTCOME)
    own = governing.verdict_of(results, mechanism)
    rows = tuple(_answer_row(check, shown, () if own is None else own.answers) for check in shown)
    muted = frozenset(place for place, check in enumerate(shown) if check.reading == "thesis")
    return Table(name, _answers_caption(results), columns, rows, muted, small=True)


def _answers_caption(results: Results) -> Text:
    if governing.site_pga(results) is None:
        return say("The worst answer of each method; D/C: demand over capacity.")
    return say(
        "Answers at the site’s own action; D/C: demand over capacity. Only a method that decides counts in the verdict."
    )


def _answer_row(check: Check, among: tuple[Check, ...], answers: tuple[Answer, ...]) -> tuple[Cell, ...]:
    return (
        check_title(check, among),
        ROLES[check.role],
        demand_or_rest(check, demand_cell(check)),
        capacity_cell(check),
        ratio_cell(check),
        capacity_pga_cell(check),
        outcome_cell(check, answers),
    )
