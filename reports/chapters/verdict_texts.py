"""What several chapters say of a verdict: outcome, index, margin and target, what it depends on, and what it lacks."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from assess.codes.bases import BASES
from assess.codes.check import Check
from assess.codes.histories import margin_figures
from assess.codes.question import Action, Missing, toml_lines
from assess.codes.verdict import Decision, Index, MechanismVerdict, Verdict
from assess.results import MechanismResult, Results
from reports import governing
from reports.chapters.cells import pga_interval
from reports.document import Block, Cell, FileLines, Prose
from reports.language.texts import Listing, Phrase, Term, Text, Verbatim, listing, names, quantity, say
from reports.project_values import project_text, split_key
from reports.titles import mechanism_list

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


def building_index_text(found: Verdict) -> Text | None:
    """Return the index of the building, which local mechanisms can only bound; None where it is not known."""
    if found.index is None:
        return None
    if found.index.name == DEMAND_CAPACITY:
        return say("at least {index}", index=index_text(found.index))
    return say("at most {index}", index=index_text(found.index))


def target_text(found: Verdict) -> Text | None:
    """Return what the index is compared with; None where that is not known."""
    if found.target is None:
        return None
    value, name = quantity(found.target, figures=3), index_name(found)
    if name == PERCENT_NBS:
        return say("at least {value} %NBS", value=value)
    if name == DEMAND_CAPACITY:
        return say("{index} of at most {value}", index=index_symbol(name), value=value)
    return say("{index} of at least {value}", index=index_symbol(name), value=value) if name else value


def has_reduced_target(found: Verdict) -> bool:
    """Return whether the target is less than what is asked of a new building."""
    return found.target is not None and found.target < (100.0 if index_name(found) == PERCENT_NBS else 1.0)


def index_name(found: Verdict) -> str:
    """Return the name of the index of a verdict, known from its code where no mechanism has a value; else empty."""
    if found.index is not None:
        return found.index.name
    return BASES[found.basis].index.value if found.basis in BASES else ""


def least_margin(found: Verdict) -> MechanismVerdict | None:
    """Return the mechanism that holds up to the lowest action; None where no margin is known."""
    known = [one for one in found.mechanisms if one.margin is not None]
    return min(known, key=lambda one: one.margin or 0.0, default=None)


def margin_text(one: MechanismVerdict, action: Action) -> Text | None:
    """Return up to which PGA a mechanism passes: "0.18 g, 2.7 × the site’s"; None where it is not known."""
    if one.margin is None:
        return None
    margin = quantity(one.margin, figures=margin_figures(one.margin, one.margin_most))
    return say("{pga}, {margin} × the site’s", pga=capacity_pga_text(one, one.margin, action), margin=margin)


def capacity_pga_text(one: MechanismVerdict, margin: float, action: Action) -> Text:
    """Return the PGA up to which a mechanism holds; both ends of what the numerical spread of histories leaves.

    Parameters
    ----------
    one : verdict of the mechanism
    margin : its own, which is known
    action : of the site
    """
    if one.margin_most is not None:
        return pga_interval(margin * action.pga_g, one.margin_most * action.pga_g, limit=action.pga_g)
    return quantity(margin * action.pga_g, "ground acceleration", margin_figures(margin, None))


def margin_cell(one: MechanismVerdict) -> Cell:
    """Return the factor on the site's own action up to which a mechanism holds, to the figures that stand."""
    return None if one.margin is None else quantity(one.margin, figures=margin_figures(one.margin, one.margin_most))


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


def _knowledge_level(results: Results, check: Check, mechanism: str) -> str:
    table = f"procedures.{check.procedure.partition('-')[0]}"
    own = results.project.get(f"{table}.knowledge_levels")
    levels = own.value if own is not None and isinstance(own.value, dict) else {}
    given = levels.get(mechanism) or project_text(results, f"{table}.knowledge_levels.{mechanism}")
    return str(given or project_text(results, f"{table}.knowledge_level"))


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


def _with_lasting_load(results: Results, lasting: str) -> list[str]:
    """Return the mechanisms with a load that is stated to last so long."""
    return [each.name for each in results.mechanisms if any(load.lasting == lasting for load in each.loads)]


MAX_LINES = 12  # lines to paste that page 1 holds


def missing_texts(results: Results, found: Verdict) -> list[Text]:
    """Return the keys that are missing and why; one that several mechanisms lack for one reason is said once."""
    groups: dict[tuple[str, str], list[Missing]] = {}
    for each in found.missing:
        _, key = split_key(results, each.key)
        groups.setdefault((key, each.text), []).append(each)
    return [_missing_text(results, key, group) for (key, _), group in groups.items()]


def _missing_text(results: Results, key: str, group: Sequence[Missing]) -> Text:
    first = group[0]
    why = listing(first.why or first.reasons, "") if first.why or first.reasons else Term(first.text)
    owners = [owner for owner in (split_key(results, each.key)[0] for each in group) if owner]
    if len(group) == 1 or not owners:
        return say("{key}: {why}", key=Verbatim(first.key), why=why)
    return say("{key} of {mechanisms}: {why}", key=Verbatim(key), mechanisms=mechanism_list(results, owners), why=why)


def lines_to_paste(results: Results, found: Verdict) -> tuple[str, ...]:
    """Return the missing keys as lines of a project file."""
    return toml_lines(found.missing, [key for key, each in results.project.items() if each.given])


def blocks_to_paste(results: Results, found: Verdict) -> list[Block]:
    """Return the lines to paste under their title; nothing where no line is known."""
    lines = lines_to_paste(results, found)
    if not lines:
        return []
    title = say("To complete the verdict, add these lines to the project file with your own values:")
    return [Prose((title,)), FileLines(lines)]


def fits_page_1(results: Results, found: Verdict) -> bool:
    """Return whether the lines to paste are few enough for page 1; else they stand with the recommendations."""
    return len(lines_to_paste(results, found)) <= MAX_LINES


def provisional_outcome(found: Verdict) -> list[Block]:
    """Return what the verdict would be with the safe values."""
    if found.provisional == Decision.PASS:
        return [Prose((say("With the safe value of all that is missing, the verdict would be: pass."),))]
    if found.provisional == Decision.FAIL:
        return [Prose((say("With the safe value of all that is missing, the verdict would be: fail."),))]
    return []
