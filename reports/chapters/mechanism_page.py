"""The page of one mechanism: what it is and how it moves, its parameters and answers, and what governs them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import partial
from math import atan2, degrees

from assess.codes.check import Check, Outcome
from assess.codes.histories import ratio_figures
from assess.messages.message import Message, Severity
from assess.results import MechanismResult, OscillatorResult, Results
from reports import document as doc
from reports import governing
from reports.chapters import cells
from reports.chapters.kinds import FALLING, KINDS
from reports.chapters.mechanism_verdict import governing_steps, unanswered_methods, verdict_sentences, verdict_summary
from reports.figures import capacity, comparison, key_plan, sketch
from reports.figures.key_plan import BuildingScene
from reports.language.texts import Listing, Paragraph, Term, Text, Verbatim, listing, names, quantity, say, say_count
from reports.language.value_names import key_words
from reports.mechanisms import (
    JOINT_MODELS,
    check_title,
    mechanism_list,
    mechanism_number,
    mechanism_title,
    model_names,
    procedure_title,
)
from reports.project_values import split_key

ALONG_X = 1.0 - 1e-9  # cosine of a direction that is the x axis of the model


def sections(
    results: Results, mechanism: MechanismResult, stem: str, building: BuildingScene | None = None
) -> list[doc.Section]:
    """Return the page of a mechanism.

    stem : beginning of the names of its figures and tables
    building : the bodies of all mechanisms, None where its place among them is not drawn
    """
    case = tuple(represented_case(results, mechanism))
    warnings, compact = _remarks(results, mechanism), has_compact_pages(results)
    curves, parameters, answers = _curves_and_answers(results, mechanism, stem)
    pairs = _in_pairs([*_shape_figures(mechanism, stem, building), *(() if compact else curves)])
    blocks: list[doc.Block] = [
        doc.Prose((description(mechanism), *case)),
        *verdict_summary(results, mechanism),
        *pairs[:1],
        *(() if compact else (parameters, *pairs[1:], *doc.nonempty(answers))),
        *governing_steps(results, mechanism),
        doc.Prose(tuple(_findings(results, mechanism))),
    ]
    if warnings:
        blocks += [doc.Prose((say("Remarks on this mechanism:"),)), doc.BulletList(warnings)]
    title, mark = Verbatim(mechanism_title(mechanism)), mechanism_number(results, mechanism.name)
    shown = tuple(block for block in blocks if block != doc.Prose(()))
    return [doc.Section(title, 0, shown, starts_page=True, mark=mark, shares_page=compact)]


MOST_WITH_CURVES = 8
"""Mechanisms up to which each has a page of its own, with parameters, curves and answers; of more annex A has them."""


def has_compact_pages(results: Results) -> bool:
    """Return whether two mechanisms may share a page, each drawn, with its steps to the number that decides."""
    return len(results.mechanisms) > MOST_WITH_CURVES


def left_for_annex(results: Results, mechanism: MechanismResult, stem: str) -> list[doc.Block]:
    """Return the curves and answers of a mechanism whose page has no room for them; none of another."""
    curves, _, answers = _curves_and_answers(results, mechanism, stem)
    return [*_in_pairs(curves), *doc.nonempty(answers)] if has_compact_pages(results) else []


def _curves_and_answers(
    results: Results, mechanism: MechanismResult, stem: str
) -> tuple[list[doc.Figure], doc.Table, doc.Table]:
    """Return capacity curve and rotations over PGA, the parameters, and the answers of all methods."""
    parameters = branch_parameters_table(results, mechanism, name=f"{stem}-page-parameters")
    answers = answers_table(results, mechanism, name=f"{stem}-answers")
    return list(_curve_figures(mechanism, stem)), parameters, answers


def sketch_caption(mechanism: MechanismResult) -> Text:
    """Return the caption of the drawing of a mechanism, whose x may be another than the axis of the model."""
    said = [_shape_caption(mechanism)]
    if mechanism.hinge_forces:
        said.append(say("Forces: weights and loads at rest; reactions of the hinges as motion starts."))
    if mechanism.direction is not None and mechanism.direction[0] <= ALONG_X:
        said.append(say("This x is not the axis of the model."))
    return Paragraph(tuple(said))


AMPLIFICATIONS: Mapping[str, Text] = {
    "modal-filter": say("filtered by the first mode"),
    "srss": say("Mehrotra eq. 3.48"),
    "srss-relative": say("Mehrotra eq. 3.48, for pulses 3.47"),
    "ec8": say("EN 1998-1, 4.3.5.2, for a rigid part"),
    "ec8-resonance": say("EN 1998-1, 4.3.5.2, at resonance"),
    "ec8-printed": say("Mehrotra eq. 3.49"),
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


def represented_case(results: Results, mechanism: MechanismResult) -> Iterator[Text]:
    """State the case that represents a mechanism that was swept."""
    for sweep in results.sweeps:
        if sweep.mechanism == mechanism.name and sweep.governs:
            yield say_count(
                "{key}: one value was studied, which this page shows: {value}.",
                "{key}: {number} values were studied; this page shows the most critical one: {value}.",
                len(sweep.value),
                key=key_words(sweep.key),
                value=cells.swept_value(sweep.value[sweep.controlling], sweep.unit),
            )


def mechanism_warnings(results: Results, mechanism: MechanismResult) -> tuple[Message, ...]:
    """Return the warnings that concern the mechanism by its name, each once, and how its hinges were found."""
    found = (each for each in results.warnings if each.severity != Severity.NOTE or each.key in HINGE_NOTES)
    own = {each.text: each for each in found if split_key(results, each.where)[0] == mechanism.name}
    return tuple(own.values())


def _remarks(results: Results, mechanism: MechanismResult) -> tuple[Text, ...]:
    """Return the warnings of a page; what several mechanisms share stands with the first of them, with all numbers."""
    shown: list[Text] = []
    earlier: list[str] = []
    for each in mechanism_warnings(results, mechanism):
        owners = [
            one.name
            for one in results.mechanisms
            if any(other.text == each.text for other in mechanism_warnings(results, one))
        ]
        if len(owners) == 1:
            shown.append(each)
        elif owners[0] == mechanism.name:
            shown.append(say("{places}: {message}", places=mechanism_list(results, owners), message=each))
        else:
            earlier.append(owners[0])
    if earlier:
        shown.append(say("see also the remarks on {mechanisms}", mechanisms=mechanism_list(results, earlier)))
    return tuple(shown)


def branch_parameters_table(results: Results, mechanism: MechanismResult, *, name: str) -> doc.Table:
    """Tabulate the parameters, a row for each branch; one row where both are alike."""
    shown = _page_parameters(results, mechanism)
    rows: list[tuple[doc.Cell, ...]] = []
    for title, branch in (("positive", mechanism.oscillator), ("negative", mechanism.oscillator_negative)):
        if branch is not None:
            rows.append((cells.BRANCHES[title], *(value(branch) for _, value in shown)))
    if len(rows) == 2 and rows[0][1:] == rows[1][1:]:
        rows = [(say("both"), *rows[0][1:])]
    caption = say("Rocking parameters of each branch, that is, direction of rotation.")
    columns = (doc.Column(say("Branch")), *(column for column, _ in shown))
    return doc.Table(name, caption, columns, tuple(rows), small=True)


def shown_checks(results: Results, mechanism: MechanismResult) -> tuple[Check, ...]:
    """Return the worst check of each method and limit state at the site's own action, those that decide first."""
    worst = governing.worst_per_procedure(governing.checks_at_site(results, mechanism))
    applicable = (check for check in worst if check.verdict != Outcome.NOT_APPLICABLE)
    return tuple(sorted(applicable, key=lambda check: (check.reading == "thesis", check.role != "deciding")))


def answers_table(results: Results, mechanism: MechanismResult, *, name: str) -> doc.Table:
    """Tabulate the answers at the site's own action, a row for each method and limit state."""
    shown, mechanism_verdict = shown_checks(results, mechanism), governing.verdict_of(results, mechanism)
    fields: tuple[doc.Field[Check], ...] = (
        (cells.METHOD, lambda check: check_title(check, shown)),
        (cells.ROLE, lambda check: cells.ROLES[check.role]),
        (doc.Column(say("Demand")), _demand_cell),
        (doc.Column(say("Allowable")), lambda check: cells.value_cell(check.capacity, check.unit)),
        (cells.RATIO, cells.ratio_cell),
        (cells.CAPACITY_PGA, cells.capacity_pga_cell),
        (
            cells.OUTCOME,
            lambda check: cells.outcome_cell(check, () if mechanism_verdict is None else mechanism_verdict.answers),
        ),
    )
    caption = _answers_caption(results)
    return doc.tabulate(name, caption, fields, shown, muted=cells.is_thesis_reading, small=True)


def _in_pairs(figures: list[doc.Figure]) -> list[doc.Block]:
    """Return figures two by two; a last one has the width of the page."""
    pairs = (figures[start : start + 2] for start in range(0, len(figures), 2))
    return [doc.FigureRow(tuple(pair)) if len(pair) > 1 else pair[0] for pair in pairs]


def _shape_figures(mechanism: MechanismResult, stem: str, building: BuildingScene | None) -> Iterator[doc.Figure]:
    yield doc.Figure(f"{stem}-sketch", sketch_caption(mechanism), partial(sketch.draw_sketch, mechanism))
    if building is not None and mechanism.name in building.mechanisms:
        caption = say("Its place in the building; the arrow is the direction of motion.")
        yield doc.Figure(f"{stem}-place", caption, partial(key_plan.draw_place, building, mechanism.name))


def _curve_figures(mechanism: MechanismResult, stem: str) -> Iterator[doc.Figure]:
    caption = say("Capacity curve: restoring moment over rotation, with the rotation φₒᵥ that overturns.")
    yield doc.Figure(f"{stem}-capacity", caption, partial(capacity.draw_capacity, mechanism))
    if mechanism.checks:
        caption = say("Largest rotation over peak ground acceleration by each method; large markers: allowable.")
        yield doc.Figure(f"{stem}-pga-rotation", caption, partial(comparison.draw_pga_rotation, mechanism))


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


def _findings(results: Results, mechanism: MechanismResult) -> Iterator[Text]:
    yield from verdict_sentences(results, mechanism)
    worst = governing.worst_per_procedure(governing.checks_at_site(results, mechanism))
    not_applicable = [check.procedure for check in worst if check.verdict == Outcome.NOT_APPLICABLE]
    yield from unanswered_methods(results, mechanism)
    if not_applicable:
        methods = listing(procedure_title(name) for name in dict.fromkeys(not_applicable))
        yield say("Methods that do not apply to this mechanism: {methods}.", methods=methods)


def _motion(mechanism: MechanismResult) -> Text:
    kind = KINDS.get(mechanism.kind, Verbatim(mechanism.kind))
    direction = _motion_direction(mechanism)
    if direction is None:
        if mechanism.sides == "two":
            return say("{kind} that rocks to both sides.", kind=kind)
        return say("{kind} that rocks to one side only.", kind=kind)
    if mechanism.kind in FALLING:
        return say("{kind} that falls outwards, towards {direction}.", kind=kind, direction=direction)
    if mechanism.sides == "two":
        return say("{kind} that rocks to both sides, positive towards {direction}.", kind=kind, direction=direction)
    return say("{kind} that rocks to one side only, towards {direction}.", kind=kind, direction=direction)


def _motion_direction(mechanism: MechanismResult) -> Text | None:
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
        model=listing(JOINT_MODELS.get(model, Verbatim(model)) for model in model_names(mechanism)),
        source=Listing(mechanism.restitution_said or (Term(mechanism.restitution_source),), ""),
    )


def _loads(mechanism: MechanismResult) -> Iterator[Text]:
    loads = mechanism.loads
    if len(loads) > MAX_NAMED_LOADS:
        yield say_count("It carries {number} load.", "It carries {number} loads.", len(loads))
    elif loads:
        yield say("Loads: {names}.", names=names(load.name for load in loads))


def _page_parameters(results: Results, mechanism: MechanismResult) -> list[doc.Field[OscillatorResult]]:
    """Return the eight parameters that an engineer checks by hand."""
    uplift: doc.Field[OscillatorResult] = (
        doc.Column(say("Multiplier at uplift λ"), "ratio"),
        lambda branch: cells.uplift_cell(branch.uplift_multiplier),
    )
    on_joints: doc.Field[OscillatorResult] = (
        doc.Column(say("Overturning on its joints"), "rotation"),
        lambda branch: branch.overturning_flexible_rad,
    )
    return [
        (doc.Column(say("Mass M"), "mass"), lambda branch: branch.mass_kg if _has_mass(results, mechanism) else None),
        (doc.Column(say("Radius R"), "length"), lambda branch: branch.radius_m),
        (doc.Column(say("Slenderness α"), "rotation"), lambda branch: branch.slenderness_rad),
        (doc.Column(say("Frequency parameter p"), "angular frequency"), lambda branch: branch.p_eq_per_s),
        uplift if mechanism.oscillator.overturning_flexible_rad is None else on_joints,
        (doc.Column(say("Overturning φₒᵥ"), "rotation"), lambda branch: branch.overturning_rad),
        (doc.Column(say("Restitution η"), "ratio"), lambda branch: branch.restitution),
        *_mass_share_or_period(results, mechanism),
    ]


def _has_mass(results: Results, mechanism: MechanismResult) -> bool:
    """Return whether the mass is known: that of an equivalent block is a unit mass unless the project gives it."""
    given = results.project.get(f"mechanisms.{mechanism.name}.mass")
    return mechanism.kind != "equivalent-block" or (given is not None and given.given)


def _mass_share_or_period(results: Results, mechanism: MechanismResult) -> list[doc.Field[OscillatorResult]]:
    """Return the fraction of participating mass, or the longest equivalent period where no analysis has that."""
    steps = (step for check in mechanism.checks for step in check.steps)
    share = next((step.value for step in steps if step.symbol == "e*"), None)
    if share is not None:
        return [(doc.Column(say("Participating share e*"), "ratio"), lambda _: share)]
    periods = () if results.ground_motion is None else results.ground_motion.equivalent_periods
    longest = next((one.longest_s for one in periods if one.mechanism == mechanism.name), None)
    return [] if longest is None else [(doc.Column(say("Equivalent period"), "time"), lambda _: longest)]


def _demand_cell(check: Check) -> doc.Cell:
    """Return the demand of a check with its unit, or words: it overturns, does not rock, or comes to rest again."""
    words = cells.rotation_cell(check)
    if check.rotation_ratio is not None and words in cells.AT_REST:
        return words
    value = cells.value_cell(check.demand, check.unit, figures=ratio_figures(check))
    return cells.counted_cell(check, cells.unbounded_text(check) or value, "ratio")


def _answers_caption(results: Results) -> Text:
    if governing.site_pga(results) is None:
        return say("The worst answer of each method; D/C: demand over capacity.")
    return say(
        "Answers at the site’s own action; D/C: demand over capacity. Only a method that decides counts in the verdict."
    )
