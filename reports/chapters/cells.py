"""Cells that several chapters share: outcomes, rotations, numbers that may be words."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

from assess.codes.bases import BASES, IndexKind
from assess.codes.check import Check, Family, Outcome, Reason
from assess.codes.histories import interval_figures, margin_figures, ratio_figures, side_figures
from assess.codes.procedures import PROCEDURES, family_of
from assess.codes.question import Action, Missing, toml_lines
from assess.codes.verdict import Answer, Decision, Index, MechanismVerdict, Override, Verdict
from assess.messages.message import DIMENSIONS, Message, Quantity, with_values
from assess.results import MechanismResult, Results
from reports import document, governing
from reports.document import Block, Cell, Column, FileLines, OutcomeCell, Prose
from reports.language.client_texts import CLIENT_TEXTS
from reports.language.locale import Locale
from reports.language.texts import Listing, Phrase, Term, Text, Verbatim, listing, names, quantity, say
from reports.language.value_names import LOAD_KEY, LOAD_TITLES, key_words, value_word
from reports.mechanisms import mechanism_list, mechanism_number
from reports.project_values import project_text, split_key, starred_key

NUMBER = re.compile(r"-?[0-9]+(?:\.[0-9]+)?")
OVERTURNED, BEYOND = say("overturns"), say("beyond the spectrum")
NO_ROCKING, NO_LASTING, NONE = say("does not rock"), say("no lasting rotation"), say("none")
SLIDES = say("slides first")
AT_REST = (NO_ROCKING, NO_LASTING, SLIDES)  # in place of a rotation

OUTCOMES: Mapping[str, Phrase] = {
    "pass": say("pass"),
    "fail": say("fail"),
    "incomplete": say("incomplete"),
    "not-answered": say("not answered"),
    "not-applicable": say("not applicable"),
}
ROLES: Mapping[str, Phrase] = {"deciding": say("decides"), "comparison": say("for comparison")}
READINGS: Mapping[str, Phrase] = {"letter": say("clause"), "thesis": say("reading by Mehrotra")}

INPUTS: Mapping[str, Phrase] = {
    "ground": say("ground"),
    "mechanism base": say("base of the mechanism"),
    "missing": say("missing"),
}
BRANCHES: Mapping[str, Phrase] = {"positive": say("positive"), "negative": say("negative")}
_COLOURS: Mapping[str, document.OutcomeColour] = {"pass": "pass", "fail": "fail", "incomplete": "incomplete"}
_NO_LASTING_ROTATION = (Reason.NO_LASTING, Reason.ON_JOINTS)
MECHANISM, LEVEL = Column(say("Mechanism")), Column(say("PGA"), "ground acceleration")
METHOD, LIMIT_STATE, OUTCOME = Column(say("Method")), Column(say("Limit state")), Column(say("Outcome"))
PROCEDURE, ROLE = Column(say("Procedure")), Column(say("Role"))
QUANTITY, UNIT, CLAUSE = Column(say("Quantity")), Column(say("Unit")), Column(say("Clause"))
FIGURES = 3
YEARS = 6  # figures of a whole number of years

RATIO = Column(say("D/C"), "ratio", FIGURES)
CAPACITY_PGA = Column(say("PGA at capacity"), "ground acceleration", FIGURES)


def outcome_cell(check: Check, answers: Sequence[Answer] = ()) -> OutcomeCell:
    """Return the outcome of a check, coloured where it decides. answers : of the mechanism, where they count."""
    outcome = _decided_outcome(check, answers)
    colour = _COLOURS.get(outcome, "incomplete") if check.role == "deciding" else "comparison"
    return OutcomeCell(colour, OUTCOMES[outcome])


def is_thesis_reading(check: Check) -> bool:
    """Return whether a check is a reading by Mehrotra, which is for information."""
    return check.reading == "thesis"


def unbounded_text(check: Check) -> Phrase | None:
    """Return why a check fails without a finite demand; None where it has one."""
    return {"overturned": OVERTURNED, "beyond the spectrum": BEYOND}.get(check.unbounded)


def value_cell(value: float | None, unit: str, *, figures: int = 4) -> Quantity | None:
    """Return a number of the results with its unit; `unit` is a value of `assess.messages.message.UNITS`."""
    return None if value is None else Quantity(value, DIMENSIONS.get(unit, "ratio"), figures)


def rocking_cell(rotation: float | None) -> Cell:
    """Return a rotation; words for a body that does not move."""
    return NO_ROCKING if rotation == 0 else rotation


def rotation_cell(check: Check) -> Cell:
    """Return the rotation of a check; a body that lifts off without a lasting rotation is not at rest."""
    if check.unbounded:
        return unbounded_text(check)
    if check.reason.key == Reason.SLIDES_INSTEAD:
        return SLIDES
    return NO_LASTING if check.reason.key in _NO_LASTING_ROTATION else rocking_cell(check.rotation_ratio)


def uplift_cell(at: float | None) -> Cell:
    """Return the multiplier or PGA at uplift; "none" where joints have no threshold of uplift."""
    return NONE if at is None else at


def ratio_cell(check: Check) -> Text | float | None:
    """Return demand over capacity, to the figures that stand, or why there is no finite one."""
    ratio = standing_cell(check.ratio, ratio_figures(check, most=FIGURES), FIGURES)
    return counted_cell(check, unbounded_text(check) or ratio, "ratio")


def counted_cell(check: Check, cell: Text | float | None, dimension: str) -> Text | float | None:
    """Return a number of a check that is answered; of one that is not, marked provisional, or none if not even that.

    cell : a number of this dimension [SI], or words
    """
    if check.verdict != Outcome.NOT_ANSWERED or cell is None:
        return cell
    if check.provisional is None:
        return None
    if isinstance(cell, float):
        cell = Quantity(cell, dimension, FIGURES)
    return say("{number} (provisional)", number=cell) if isinstance(cell, Quantity) else cell


def standing_cell(value: float | None, figures: int, most: int) -> Text | float | None:
    """Return a number of a column of `most` figures, written with fewer where fewer stand."""
    return value if value is None or figures == most else Quantity(value, "ratio", figures)


def capacity_pga_cell(check: Check) -> Text | float | None:
    """Return the PGA at capacity [g]; where numerical spread leaves a range, from 84 to 16 % of the draws."""
    low = None if check.numerical is None else check.numerical.capacity_16_pga_g
    if check.capacity_pga_g is None or low is None or low <= check.capacity_pga_g:
        return counted_cell(check, check.capacity_pga_g, "ground acceleration")
    return counted_cell(check, _pga_interval(check.capacity_pga_g, low, limit=check.level_pga_g), "ground acceleration")


def swept_value(value: float, unit: str) -> Text:
    """Return a value of a study in the unit in which the user wrote it."""
    shown = quantity(value, figures=10)
    return shown if unit == "-" else say("{value} {unit}", value=shown, unit=Verbatim(unit))


INDEX_SYMBOLS: Mapping[str, str] = {"zeta_E": "ζ_E"}
OWN_BASIS = "own"  # basis that the engineer states, and its limit state
PERCENT_NBS = "%NBS"
DEMAND_CAPACITY = "D/C"

OUTCOME_WORDS: Mapping[Decision, tuple[Phrase, Phrase]] = {
    Decision.PASS: (say("pass"), say("pass at the limit")),
    Decision.FAIL: (say("fail"), say("fail at the limit")),
    Decision.INCOMPLETE: (say("incomplete"), say("incomplete")),
}
"""Each outcome in words, and where it is at the limit."""


def outcome_text(outcome: Decision, *, near: bool = False) -> Text:
    """Return an outcome in words. near: whether it is at the limit."""
    return OUTCOME_WORDS[outcome][near]


def index_text(index: Index) -> Text:
    """Return an index with its name and its grade: "ζ_E = 0.83", "45 %NBS, grade C"."""
    value = quantity(index.value, figures=index.figures)
    if index.name != PERCENT_NBS:
        return say("{index} = {value}", index=index_symbol(index.name), value=value)
    if not index.grade:
        return say("{value} %NBS", value=value)
    return say("{value} %NBS, grade {grade}", value=value, grade=Verbatim(index.grade))


def state_text(limit_state: str) -> Text:
    """Return a limit state; a basis that the engineer states has one without a name."""
    return say("the stated limit state") if limit_state == OWN_BASIS else Verbatim(limit_state)


def index_symbol(name: str) -> Verbatim:
    """Return the symbol of an index."""
    return Verbatim(INDEX_SYMBOLS.get(name, name))


def building_index_text(verdict: Verdict) -> Text | None:
    """Return the index of the building, which local mechanisms can only bound; None where it is not known."""
    if verdict.index is None:
        return None
    if verdict.index.name == DEMAND_CAPACITY:
        return say("at least {index}", index=index_text(verdict.index))
    return say("at most {index}", index=index_text(verdict.index))


def target_text(verdict: Verdict) -> Text | None:
    """Return what the index is compared with; None where that is not known."""
    if verdict.target is None:
        return None
    value, name = quantity(verdict.target, figures=3), index_name(verdict)
    if name == PERCENT_NBS:
        return say("at least {value} %NBS", value=value)
    if name == DEMAND_CAPACITY:
        return say("{index} of at most {value}", index=index_symbol(name), value=value)
    return say("{index} of at least {value}", index=index_symbol(name), value=value) if name else value


WORKS: Mapping[str, Phrase] = {
    "local": say("local works"),
    "repair": say("local works"),
    "improvement": say("improvement"),
    "upgrading": say("upgrading"),
}


def works_text(results: Results) -> Text | None:
    """Return the kind of works; None where there are none."""
    return WORKS.get(project_text(results, "verdict.works"))


def return_period_text(years: float | None, bound: str) -> Text:
    """Return the return period of a capacity [years]: a bound beyond the rows of the hazard, or that it is not known.

    Parameters
    ----------
    years : of the capacity
    bound : "<=" or ">=" where that is a bound
    """
    if years is None:
        return say("not known")
    shown = quantity(float(round(years)), "return period", YEARS)
    if not bound:
        return shown
    return say("{years} or less", years=shown) if bound == "<=" else say("{years} or more", years=shown)


def has_reduced_target(verdict: Verdict) -> bool:
    """Return whether the target is less than what is asked of a new building."""
    return verdict.target is not None and verdict.target < (100.0 if index_name(verdict) == PERCENT_NBS else 1.0)


def index_name(verdict: Verdict) -> str:
    """Return the name of the index of a verdict, known from its code where no mechanism has a value; else empty."""
    if verdict.index is not None:
        return verdict.index.name
    return BASES[verdict.basis].index.value if verdict.basis in BASES else ""


def least_margin(verdict: Verdict) -> MechanismVerdict | None:
    """Return the mechanism that holds up to the lowest action; None where no margin is known."""
    known = [one for one in verdict.mechanisms if one.margin is not None]
    return min(known, key=lambda one: one.margin or 0.0, default=None)


def margin_text(mechanism_verdict: MechanismVerdict, action: Action) -> Text | None:
    """Return up to which PGA a mechanism passes: "0.18 g, 2.7 × the site’s"; None where it is not known."""
    if mechanism_verdict.margin is None:
        return None
    margin = quantity(
        mechanism_verdict.margin, figures=margin_figures(mechanism_verdict.margin, mechanism_verdict.margin_most)
    )
    return say(
        "{pga}, {margin} × the site’s",
        pga=capacity_pga_text(mechanism_verdict, mechanism_verdict.margin, action),
        margin=margin,
    )


def capacity_pga_text(mechanism_verdict: MechanismVerdict, margin: float, action: Action) -> Text:
    """Return the PGA up to which a mechanism holds; both ends of what the numerical spread of histories leaves.

    Parameters
    ----------
    mechanism_verdict : verdict of the mechanism
    margin : its own, which is known
    action : of the site
    """
    if mechanism_verdict.margin_most is not None:
        return _pga_interval(margin * action.pga_g, mechanism_verdict.margin_most * action.pga_g, limit=action.pga_g)
    return quantity(margin * action.pga_g, "ground acceleration", margin_figures(margin, None))


def required_increase(mechanism_verdict: MechanismVerdict, verdict: Verdict) -> float | None:
    """Return by how much the resistance of a failing mechanism must grow; None where the numbers do not tell.

    It is the target over the index of the basis, where it has one as a share of the action; else the inverse of the
    margin; else the ratio of demand to capacity, but not of a slenderness to the one of a table.
    """
    failing = [answer for answer in mechanism_verdict.answers if answer.outcome == Decision.FAIL]
    shares = [a.index.value for a in failing if a.index is not None and a.index.name != IndexKind.DEMAND_CAPACITY]
    if shares and verdict.target is not None and min(shares) > 0.0:
        return verdict.target / min(shares)
    if mechanism_verdict.margin is not None and 0.0 < mechanism_verdict.margin < 1.0:
        return 1.0 / mechanism_verdict.margin
    by_resistance = [answer for answer in failing if family_of(answer.procedure) != Family.TABLE]
    return max((answer.ratio for answer in by_resistance if answer.ratio is not None), default=None)


def required_increase_figures(mechanism_verdict: MechanismVerdict, factor: float) -> int:
    """Return to how many figures that factor stands, as the indices and the margin that it comes from."""
    stand = [
        each.index.figures
        for each in mechanism_verdict.answers
        if each.outcome == Decision.FAIL and each.index is not None
    ]
    stand += (
        [margin_figures(mechanism_verdict.margin, mechanism_verdict.margin_most)] if mechanism_verdict.margin else []
    )
    return side_figures(factor, min(FIGURES, *stand))


def margin_cell(mechanism_verdict: MechanismVerdict) -> Cell:
    """Return the factor on the site's own action up to which a mechanism holds, to the figures that stand."""
    return (
        None
        if mechanism_verdict.margin is None
        else quantity(
            mechanism_verdict.margin, figures=margin_figures(mechanism_verdict.margin, mechanism_verdict.margin_most)
        )
    )


CONFIDENCE_FACTOR = "FC"  # symbol of the step that states the confidence factor
DISINTEGRATION = ".disintegration"


def knowledge_text(results: Results) -> Text | None:
    """Return knowledge levels and confidence factors of the deciding checks; None where no code asks for them."""
    found: dict[tuple[str, float], list[str]] = {}
    for mechanism in results.mechanisms:
        stated = mechanism_knowledge(results, mechanism)
        if stated is not None:
            found.setdefault(stated, []).append(mechanism.name)
    texts = [
        say(
            "{factor} for {mechanisms}",
            factor=factor_text(level, factor),
            mechanisms=mechanism_list(results, owners),
        )
        for (level, factor), owners in found.items()
    ]
    return Listing(tuple(texts), "") if texts else None


def mechanism_knowledge(results: Results, mechanism: MechanismResult) -> tuple[str, float] | None:
    """Return knowledge level, "" if none is given, and confidence factor of the deciding check of a mechanism."""
    deciding = (check for check in governing.checks_at_site(results, mechanism) if check.role == "deciding")
    for check in deciding:
        factors = [step.value for step in check.steps if step.symbol == CONFIDENCE_FACTOR]
        if factors and isinstance(factors[0], float):
            return _knowledge_level(results, check, mechanism.name), factors[0]
    return None


def factor_text(level: str, factor: float) -> Text:
    """Return a confidence factor with its knowledge level."""
    if not level:
        return say("confidence factor FC = {factor}", factor=quantity(factor, figures=3))
    return say(
        "{level}, confidence factor FC = {factor}",
        level=Verbatim(level),
        factor=quantity(factor, figures=3),
    )


def stated_premises(results: Results) -> Iterator[Text]:
    """Yield what the user vouches for and the deciding answers count on."""
    sound = [
        key for key in results.project if key.endswith(DISINTEGRATION) and project_text(results, key) == "excluded"
    ]
    if sound and any(mechanism_knowledge(results, mechanism) for mechanism in results.mechanisms):
        yield say(
            "the masonry does not disintegrate, as the project states for {masonry}",
            masonry=names(key.removesuffix(DISINTEGRATION).partition(".")[2] for key in sound),
        )
    tied = _with_lasting_load(results, "to collapse")
    if tied:
        yield say(
            "ties and forces of {mechanisms} last up to collapse, as the project states",
            mechanisms=mechanism_list(results, tied),
        )
    seated = [each.name for each in results.mechanisms if any(load.seat_m is not None for load in each.loads)]
    if seated:
        yield say(
            "the loads that rest on {mechanisms} have the seats that the project gives",
            mechanisms=mechanism_list(results, seated),
        )


def missing_texts(results: Results, verdict: Verdict) -> list[Text]:
    """Return the keys that are missing and why; one that several mechanisms lack for one reason is said once."""
    groups: dict[tuple[str, str], list[Missing]] = {}
    for each in verdict.missing:
        _, key = split_key(results, each.key)
        groups.setdefault((key, each.text), []).append(each)
    return [_missing_text(results, key, group) for (key, _), group in groups.items()]


def blocks_to_paste(results: Results, verdict: Verdict) -> list[Block]:
    """Return the lines to paste under their title; nothing where no line is known."""
    lines = toml_lines(verdict.missing, [key for key, each in results.project.items() if each.given])
    if not lines:
        return []
    title = say("To complete the verdict, add these lines to the project file with your own values:")
    return [Prose((title,)), FileLines(lines)]


def value_name(results: Results, key: str) -> Text:
    """Return what a value of the project is called, with its mechanism; its key where it has no words."""
    owner, rest = starred_key(results, key)
    mechanism = next((each for each in results.mechanisms if each.name == owner), None)
    item = LOAD_KEY.fullmatch(rest)
    name = key_words(rest)
    if item and mechanism is not None and item[2] in LOAD_TITLES and int(item[1]) <= len(mechanism.loads):
        load = mechanism.loads[int(item[1]) - 1].name
        name = say("{quantity} of {load}", quantity=LOAD_TITLES[item[2]], load=Verbatim(load))
    return say("{value} ({mechanisms})", value=name, mechanisms=mechanism_list(results, [owner])) if owner else name


def override_texts(results: Results, verdict: Verdict) -> list[Text]:
    """Return what the verdict hangs on, with values in words; what is the same for several mechanisms is said once."""
    groups: dict[str, tuple[Phrase, list[Override]]] = {}
    for each in verdict.overrides:
        said = each.message
        values = {
            name: _stated_value(value) if isinstance(value, str) else value for name, value in said.values.items()
        }
        key = key_words(each.key)
        phrase = Phrase(CLIENT_TEXTS[said.key].english, {**values, "key": key})
        groups.setdefault(Locale().text(phrase), (phrase, []))[1].append(each)
    return [
        replace(phrase, values={**phrase.values, "key": _shared_name(results, same)})
        for phrase, same in groups.values()
    ]


def _stated_value(text: str) -> Text:
    """Return a value as the project states it: a number, one of the words to choose from, or its letters."""
    bare = text.strip('"')
    return quantity(float(bare)) if NUMBER.fullmatch(bare) else value_word(Verbatim(bare))


def _shared_name(results: Results, same: Sequence[Override]) -> Text:
    """Return what a value is called, with all mechanisms that have it alike."""
    owners = [starred_key(results, each.key)[0] for each in same]
    if len(same) == 1 or not all(owners):
        return value_name(results, same[0].key)
    return say("{value} ({mechanisms})", value=key_words(same[0].key), mechanisms=mechanism_list(results, owners))


def condition_texts(results: Results, messages: Iterable[Message]) -> list[Text]:
    """Return messages with numbers for the names of mechanisms; what is the same for several is said once."""
    groups: dict[str, tuple[Message, list[str]]] = {}
    known = {each.name for each in results.mechanisms}
    for each in messages:
        values = {gap: mechanism_number(results, v) if v in known else v for gap, v in each.values.items()}
        said = with_values(each, values)
        texts = [value for value in values.values() if isinstance(value, str)]
        owners = [split_key(results, key)[0] for text in texts for key in text.split(", ")]
        groups.setdefault(Locale().text(said), (said, []))[1].extend(filter(None, owners))
    return [
        say("{places}: {message}", places=mechanism_list(results, owners), message=said) if owners else said
        for said, owners in groups.values()
    ]


def provisional_outcome(verdict: Verdict) -> list[Block]:
    """Return what the verdict would be with the safe values."""
    if verdict.provisional == Decision.PASS:
        return [Prose((say("With the safe value of all that is missing, the verdict would be: pass."),))]
    if verdict.provisional == Decision.FAIL:
        return [Prose((say("With the safe value of all that is missing, the verdict would be: fail."),))]
    return []


def _decided_outcome(check: Check, answers: Sequence[Answer]) -> str:
    """Return the outcome of the answer that a check decides, as the target may be less than full safety; else its own.

    Parameters
    ----------
    check : of a mechanism
    answers : of the verdict of this mechanism
    """
    own = [each for each in answers if each.procedure == check.procedure]
    outcomes = {each.outcome for each in own if each.limit_state == check.limit_state} or {each.outcome for each in own}
    return outcomes.pop().value if check.role == "deciding" and len(outcomes) == 1 else check.verdict.value


def _pga_interval(low: float, high: float, *, limit: float) -> Text:
    """Return two PGA [g] as "0.12 g to 0.14 g", to as many figures as tell them apart, and from the site's own."""
    figures = interval_figures(low, high, limit=limit)
    ends = (Quantity(each, "ground acceleration", figures) for each in (low, high))
    return say("{low} to {high}", **dict(zip(("low", "high"), ends, strict=True)))


def _knowledge_level(results: Results, check: Check, mechanism: str) -> str:
    options = PROCEDURES[check.procedure].options if check.procedure in PROCEDURES else ""
    table = f"procedures.{options}"
    own = results.project.get(f"{table}.knowledge_levels")
    levels = own.value if own is not None and isinstance(own.value, dict) else {}
    given = levels.get(mechanism) or project_text(results, f"{table}.knowledge_levels.{mechanism}")
    return str(given or project_text(results, f"{table}.knowledge_level"))


WEIGHT = "overburden "  # how the names of loads begin that are weights: nobody need state that they last


def _with_lasting_load(results: Results, lasting: str) -> list[str]:
    """Return the mechanisms with a tie or force that is stated to last so long."""
    return [
        each.name
        for each in results.mechanisms
        if any(load.lasting == lasting and not load.name.startswith(WEIGHT) for load in each.loads)
    ]


def _missing_text(results: Results, key: str, group: Sequence[Missing]) -> Text:
    first = group[0]
    why = listing(first.why or first.reasons, "") if first.why or first.reasons else Term(first.text)
    owners = [owner for owner in (split_key(results, each.key)[0] for each in group) if owner]
    if len(group) == 1 or not owners:
        return say("{key}: {why}", key=value_name(results, first.key), why=why)
    name = key_words(f"mechanisms.*.{key}")
    return say("{key} of {mechanisms}: {why}", key=name, mechanisms=mechanism_list(results, owners), why=why)
