"""The procedures of all codes by name, and whether each may be applied to a mechanism.

A procedure may answer; or only fail, where the motion of the ground replaces that of a floor; or it is not answered,
because an input is missing that could be given; or the clause does not cover such a mechanism. That is decided here,
before its numbers count. The numbers are worked out all the same where they can be, and are kept in the check as
`provisional`. A check by an Italian procedure may also lack a level of knowledge, a seat, or the action of its limit
state.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from enum import StrEnum
from functools import partial

from assess.codes.asce41_13 import ASCE41_13_SLENDERNESS, Asce41Options
from assess.codes.asce43_05 import ASCE43_05_SPECTRUM, ASCE43_05_SPECTRUM_THESIS, Asce4305Options
from assess.codes.asce43_05_history import ASCE43_05_HISTORY
from assess.codes.check import Check, CodeProcedure, Family, Outcome, Premise, Reason, reason_message
from assess.codes.context import Context
from assess.codes.dmi2008 import (
    DMI2008_HISTORY,
    DMI2008_LINEAR,
    DMI2008_NONLINEAR,
    DMI2008_NONLINEAR_THESIS,
    Dmi2008Options,
)
from assess.codes.en1998_1 import EC8_ELEMENT, Ec8Options
from assess.codes.histories import SuiteRule
from assess.codes.italian_limit_states import floor_of
from assess.codes.ntc2018 import NTC2018_HISTORY, NTC2018_LINEAR, NTC2018_NONLINEAR, Ntc2018Options
from assess.codes.nzsee2017 import NZSEE2017_FACE_LOADED, Nzsee2017Options
from assess.codes.sliding import ASCE43_05_SLIDING, SLIDING, sliding_pga
from assess.codes.toothing import counted_moment
from assess.errors import ProcedureError
from assess.messages.message import Message, Quantity, Severity, Term, Value, message
from assess.oscillator import Oscillator
from spectra.gravity import g

Assess = Callable[[Oscillator, Context], tuple[Check, ...]]

PROCEDURES: dict[str, CodeProcedure] = {
    each.name: each
    for each in (
        ASCE43_05_SPECTRUM,
        ASCE43_05_SPECTRUM_THESIS,
        ASCE43_05_HISTORY,
        DMI2008_LINEAR,
        DMI2008_NONLINEAR,
        DMI2008_NONLINEAR_THESIS,
        NZSEE2017_FACE_LOADED,
        ASCE41_13_SLENDERNESS,
        EC8_ELEMENT,
        DMI2008_HISTORY,
        NTC2018_LINEAR,
        NTC2018_NONLINEAR,
        NTC2018_HISTORY,
        ASCE43_05_SLIDING,
        SLIDING,
    )
}
THESIS_READINGS = tuple(name for name, each in PROCEDURES.items() if each.reading == "thesis")
KNOWLEDGE_CODES = tuple(dict.fromkeys(each.knowledge_code for each in PROCEDURES.values() if each.knowledge_code))
"""The codes whose procedures go by levels of knowledge: fields of `CodeOptions`."""


@dataclass(frozen=True)
class CodeOptions:
    """The options of every code."""

    asce43_05: Asce4305Options = field(default_factory=Asce4305Options)
    dmi2008: Dmi2008Options = field(default_factory=Dmi2008Options)
    ntc2018: Ntc2018Options = field(default_factory=Ntc2018Options)
    nzsee2017: Nzsee2017Options = field(default_factory=Nzsee2017Options)
    asce41_13: Asce41Options = field(default_factory=Asce41Options)
    ec8: Ec8Options = field(default_factory=Ec8Options)


def with_options(name: str, options: CodeOptions) -> Assess:
    """Return a procedure with the options of its code, which makes checks.

    Parameters
    ----------
    name : one of `PROCEDURES`
    options : of every code

    Returns
    -------
    Takes an oscillator and a context, returns checks.

    Raises
    ------
    ProcedureError : for an unknown name; it lists the known ones
    """
    if name not in PROCEDURES:
        raise ProcedureError(f'procedure "{name}" is not known; known are: {", ".join(PROCEDURES)}')
    found = PROCEDURES[name]
    return partial(found.assess, options=getattr(options, found.options)) if found.options else found.assess


def family_of(name: str) -> Family | None:
    """Return the kind of comparison that a procedure makes; None for an unknown name."""
    return PROCEDURES[name].family if name in PROCEDURES else None


def uses_histories(name: str) -> bool:
    """Return whether a procedure uses time histories; False for an unknown name."""
    return family_of(name) == Family.HISTORY


def default_procedures(spectrum_code: str, *, has_friction: bool) -> tuple[str, ...]:
    """Return the procedures that run where the project names none, in the order of `PROCEDURES`.

    Parameters
    ----------
    spectrum_code : of the site's spectrum; "" without a site
    has_friction : whether a material has friction
    """
    return tuple(
        name
        for name, each in PROCEDURES.items()
        if each.default_run is not None and each.default_run.applies(spectrum_code, has_friction=has_friction)
    )


def procedures_of_site(spectrum_code: str) -> tuple[str, ...]:
    """Return those of `default_procedures` that are written for such spectra alone, of which this is one."""
    every = default_procedures(spectrum_code, has_friction=True)
    return tuple(name for name in every if spectrum_code in PROCEDURES[name].spectra)


def pga_rules(options: CodeOptions) -> dict[str, Callable[..., tuple[float, ...]]]:
    """Return, by procedure, what gives the PGA of the suites of its own: for those that need such suites."""
    return {
        name: partial(each.required_pga, options=getattr(options, each.options))
        for name, each in PROCEDURES.items()
        if each.required_pga is not None
    }


FOLLOWING_MOTION = (Family.DISPLACEMENT, Family.HISTORY, Family.ENERGY, Family.PART, Family.ELEMENT)
"""Comparisons that follow a mechanism as it moves, and so need actions that last."""

ROCKING = (*FOLLOWING_MOTION, Family.LINEAR)
"""Comparisons that presume that the mechanism rocks and does not slide."""

FLOOR_CLAUSES: dict[Family, Term] = {
    Family.LINEAR: Term("give [building] height and storeys"),
    Family.DISPLACEMENT: Term("give [building] height and storeys"),
    Family.ELEMENT: Term("give [building] height"),
    Family.HISTORY: Term('the motion at that height is needed: amplification = { method = "modal-filter" }'),
    Family.ENERGY: Term('the motion at that height is needed: amplification = { method = "modal-filter" }'),
    Family.FRICTION: Term("give the mechanism an amplification, up to that height"),
    Family.SLIDING: Term("the clause has no floor motion"),
}


class Allowed(StrEnum):
    """What a procedure may answer for a mechanism."""

    ANSWER = "answer"
    ONLY_FAIL = "only fail"
    NOT_ANSWER = "not answer"
    NOT_APPLY = "not apply"


@dataclass(frozen=True)
class Applicability:
    """What a procedure may answer, and the reason where that is restricted.

    safe : whether the numbers were worked out with the safe value of what is missing, so that they may be shown
    void : whether the numbers are of another mechanism than the one in question, so that they may not be shown
    others : further reasons of the same kind, each with its remedy
    """

    may: Allowed
    reason: Message | None = None
    safe: bool = False
    void: bool = False
    others: tuple[Message, ...] = ()


APPLICABLE = Applicability(Allowed.ANSWER)


@dataclass(frozen=True)
class Application:
    """A procedure applied to a mechanism, in the context that is known of it."""

    procedure: CodeProcedure
    oscillator: Oscillator
    context: Context


def find_applicability(procedure: str, oscillator: Oscillator, context: Context) -> Applicability:
    """Find whether a procedure may be applied: the first rule that objects decides, the strictest rule first.

    What the other rules object to is added, so that all that is missing is listed at once.

    Parameters
    ----------
    procedure : its name
    oscillator : the mechanism
    context : what is known of it

    Returns
    -------
    Applicability
    """
    application = Application(PROCEDURES[procedure], oscillator, context)
    rules = (
        _clause_objection,
        _rocking_objection,
        _unheld_objection,
        _impossible_objection,
        _histories_objection,
        _height_objection,
    )
    objections = (rule(application) for rule in rules)
    found = [each for each in objections if each is not None]
    if not found or found[0].may == Allowed.NOT_APPLY:
        return found[0] if found else APPLICABLE
    first, *rest = found
    others = (reason for each in rest for reason in (each.reason, *each.others) if reason is not None)
    safe, void = all(each.safe for each in found), any(each.void for each in found)
    return replace(first, safe=safe, void=void, others=(*first.others, *others))


def apply_procedure(
    procedure: str, assess: Callable[[Oscillator, Context], tuple[Check, ...]], oscillator: Oscillator, context: Context
) -> tuple[Check, ...]:
    """Return the checks of a procedure, restricted as its applicability asks.

    Parameters
    ----------
    procedure : its name
    assess : makes the checks of an oscillator in a context
    oscillator : the mechanism
    context : what is known of it

    Returns
    -------
    tuple of Check
    """
    given = find_applicability(procedure, oscillator, context)
    context = _context_where(given, context)
    found = (
        _restricted_check(check, _with_missing_inputs(given, missing_inputs(procedure, check.limit_state, context)))
        for check in assess(oscillator, context)
    )
    premises = premise_conditions(procedure, context)
    return tuple(_condition_on_sliding(_with_conditions(check, premises), context) for check in found)


def history_rules(
    procedure: str, options: CodeOptions, oscillator: Oscillator, context: Context
) -> tuple[SuiteRule, ...]:
    """Return the rules that a procedure holds suites of histories to, in the context that it is applied in.

    Parameters
    ----------
    procedure : its name
    options : of every code
    oscillator : the mechanism
    context : what is known of it

    Returns
    -------
    One for each limit state requested; none of a procedure without histories.
    """
    found = PROCEDURES[procedure]
    if found.history_rules is None:
        return ()
    context = _context_where(find_applicability(procedure, oscillator, context), context)
    return found.history_rules(oscillator, context, options=getattr(options, found.options))


def _context_where(given: Applicability, context: Context) -> Context:
    """Return the context of a procedure; no number of a void one is kept, and what breaks may fall before it stands."""
    return replace(context, starting=None, breaking=None, limits=(), toothing=None) if given.void else context


def premise_conditions(procedure: str, context: Context) -> tuple[Message, ...]:
    """Return the premises of a procedure that cannot be verified here, as conditions of a pass of such a wall.

    What stands free has no floors that could hold its top: above the ground the building holds it at its foot, and on
    the ground nothing need. Sound masonry is an input (`assess.project.question`).

    Parameters
    ----------
    procedure : its name
    context : what is known of the mechanism

    Returns
    -------
    tuple of Message
    """
    keys = {
        Premise.SOUND_MASONRY: "",
        Premise.ANCHORAGE: "premise-anchorage",
        Premise.COLLAR_JOINTS: "premise-collar-joints",
        Premise.NO_FLOORS: "premise-no-floors",
    }
    if context.support == "free":
        keys[Premise.ANCHORAGE] = "premise-anchorage-foot" if context.above_ground else ""
    found = [keys[each] for each in PROCEDURES[procedure].premises]
    rubs = context.toothing is not None and not context.linearised and counted_moment(context.toothing) > 0.0
    if rubs and uses_histories(procedure):
        found.append("side-walls-hold")
    return tuple(message(key, severity=Severity.WARNING) for key in found if key)


def _with_conditions(check: Check, conditions: tuple[Message, ...]) -> Check:
    if not conditions or check.verdict == Outcome.NOT_APPLICABLE:
        return check
    return replace(check, conditions=(*conditions, *check.conditions))


def _condition_on_sliding(check: Check, context: Context) -> Check:
    """Return the check; a pass by rocking of what slides first depends on its being kept from sliding.

    What slides at less than starts to rock does not rest: that its demand does not start the rocking is not why it
    passes.
    """
    may_pass = check.verdict in (Outcome.PASS, Outcome.FAIL)  # what fails may pass a lower target
    if not may_pass or PROCEDURES[check.procedure].family not in ROCKING:
        return check
    slides_at = sliding_pga(context)
    if slides_at is None or check.level_pga_g * g <= slides_at:
        return check
    pga = Quantity(slides_at / g, "ground acceleration", 3)
    held = message("held-from-sliding", {"pga": pga}, severity=Severity.WARNING)
    still = check.reason.key == Reason.NO_ROCKING
    reason = reason_message(Reason.SLIDES_INSTEAD, pga=pga) if still else check.reason
    return replace(check, conditions=(*check.conditions, held), reason=reason)


def _with_missing_inputs(given: Applicability, missing: tuple[MissingInput, ...]) -> Applicability:
    """Return the applicability of a procedure together with the inputs that one of its limit states lacks."""
    if not missing or given.may in (Allowed.NOT_APPLY, Allowed.NOT_ANSWER):
        return replace(given, others=(*given.others, *(each.reason for each in missing)))
    reasons = [each.reason for each in missing]
    if given.reason is None:
        return Applicability(
            Allowed.NOT_ANSWER, reasons[0], all(each.safe for each in missing), others=tuple(reasons[1:])
        )
    return replace(given, may=Allowed.NOT_ANSWER, others=tuple(reasons))


def _restricted_check(check: Check, given: Applicability) -> Check:
    if given.reason is None or check.verdict == Outcome.NOT_APPLICABLE:
        return check
    if given.may == Allowed.NOT_APPLY:
        return replace(check, verdict=Outcome.NOT_APPLICABLE, reason=given.reason)
    if given.void:
        return without_numbers(check, given.reason, given.others)
    if check.verdict == Outcome.NOT_ANSWERED:
        return replace(check, remarks=(*check.remarks, given.reason, *given.others))
    if given.may == Allowed.ONLY_FAIL and check.verdict == Outcome.FAIL:
        return replace(check, may_pass=False, remarks=(*check.remarks, given.reason))
    own = () if check.reason.key in (Reason.WITHIN, Reason.BEYOND) else (check.reason,)
    return replace(
        check,
        verdict=Outcome.NOT_ANSWERED,
        provisional=check.verdict if given.safe else None,
        may_pass=False,
        reason=given.reason,
        remarks=(*check.remarks, *given.others, *own),
    )


def without_numbers(check: Check, reason: Message, others: tuple[Message, ...] = ()) -> Check:
    """Return a check that is not answered, without any number.

    Parameters
    ----------
    check : of which procedure, branch and level are kept
    reason : why it is not answered
    others : further reasons

    Returns
    -------
    Check
    """
    return Check(
        procedure=check.procedure,
        edition=check.edition,
        reading=check.reading,
        branch=check.branch,
        limit_state=check.limit_state,
        level_pga_g=check.level_pga_g,
        input_at=check.input_at,
        damping=None,
        quantity=check.quantity,
        unit=check.unit,
        verdict=Outcome.NOT_ANSWERED,
        reason=reason,
        caveat=check.caveat,
        caveats=check.caveats,
        may_pass=False,
        remarks=others,
    )


def _clause_objection(application: Application) -> Applicability | None:
    """Return the objection of the clause: mechanisms that it does not cover."""
    procedure, oscillator, context = application.procedure, application.oscillator, application.context
    if procedure.damped_by_impacts and oscillator.negative is None:
        return Applicability(Allowed.NOT_APPLY, reason_message(Reason.ONE_SIDED))
    if procedure.damped_by_impacts and min(branch.restitution for branch in oscillator.branches) == 0.0:
        return Applicability(Allowed.NOT_APPLY, reason_message(Reason.NO_REBOUND))
    if procedure.family == Family.PART and context.support == "hinged":
        return Applicability(Allowed.NOT_APPLY, reason_message(Reason.NOT_A_WALL, clause="NZSEE 2017 C8.8.5"))
    if procedure.family == Family.ELEMENT and context.carries_floors:
        return Applicability(Allowed.NOT_ANSWER, reason_message(Reason.CARRIES_FLOORS))
    return None


def _rocking_objection(application: Application) -> Applicability | None:
    """Return the objection to all but multiplier and curve where what the impacts leave is not known."""
    if application.context.rocks or application.procedure.family in (Family.LINEAR, Family.DISPLACEMENT):
        return None
    return Applicability(Allowed.NOT_ANSWER, reason_message(Reason.HISTORIES_UNKNOWN), void=True)


def _impossible_objection(application: Application) -> Applicability | None:
    """Return the objection to any answer, as where the elevation of the ground is not known."""
    reasons = application.context.impossible
    return Applicability(Allowed.NOT_ANSWER, reasons[0]) if reasons else None


def _unheld_objection(application: Application) -> Applicability | None:
    """Return the objection to displacements and histories where only actions not shown to last hold it."""
    context = application.context
    if application.procedure.family not in FOLLOWING_MOTION or not context.not_lasting:
        return None
    return Applicability(Allowed.NOT_ANSWER, context.not_lasting[0], void=True, others=context.impossible)


def _histories_objection(application: Application) -> Applicability | None:
    """Return the objection to histories: an impact without rebound, or a suite that misses its code's rules."""
    procedure, context = application.procedure, application.context
    if procedure.family != Family.HISTORY:
        return None
    faults = (*context.impossible_by_histories, *context.suite_faults.get(procedure.suite_rules, ()))
    return Applicability(Allowed.NOT_ANSWER, faults[0], others=tuple(faults[1:])) if faults else None


def _height_objection(application: Application) -> Applicability | None:
    """Return the objection to the motion of the ground at height: it may fail a check and cannot pass it."""
    procedure, family, context = application.procedure, application.procedure.family, application.context
    if family == Family.TABLE:
        return _table_objection(context)
    if not context.above_ground or (family not in FLOOR_CLAUSES and family != Family.PART):
        return None
    height = Quantity(context.support_height, "length")
    if context.above_building and family in (Family.LINEAR, Family.DISPLACEMENT, Family.ELEMENT, Family.PART):
        return Applicability(Allowed.ONLY_FAIL, reason_message(Reason.ABOVE_BUILDING, height=height))
    if procedure.reading != "thesis" and _has_floor_input(family, context):
        return None
    faults = context.suite_faults.get(procedure.floor_suite_rules, ())
    if faults and context.transfer == "by a filter":
        return Applicability(Allowed.ONLY_FAIL, faults[0], others=tuple(faults[1:]))
    why = (
        Reason.SCALAR_MOTION if family == Family.HISTORY and context.transfer == "by a factor" else Reason.GROUND_MOTION
    )
    return Applicability(Allowed.ONLY_FAIL, reason_message(why, height=height, remedy=FLOOR_CLAUSES[family]))


def _table_objection(context: Context) -> Applicability | None:
    """Return the objection to a table of slenderness where nothing of the building is there to hold the wall."""
    if context.building is None or context.top_support <= context.building.height * (1.0 + 1e-9):
        return None
    height = Quantity(context.top_support, "length")
    return Applicability(Allowed.NOT_ANSWER, reason_message(Reason.ABOVE_BUILDING, height=height))


def _has_floor_input(family: Family, context: Context) -> bool:
    if family in (Family.LINEAR, Family.DISPLACEMENT):
        return floor_of(context) is not None
    if family == Family.ELEMENT:
        return context.building is not None
    if family == Family.HISTORY:
        return context.transfer == "by a filter"
    if family == Family.FRICTION:  # the peak decides, which one factor gives too
        return context.transfer != "not"
    if family == Family.ENERGY:
        return context.floor_spectrum is not None
    return family == Family.PART


ITALIAN_STATES_BY_ACTION = ("SLO", "SLD", "SLV", "SLC")  # by rising action


@dataclass(frozen=True)
class MissingInput:
    """Why a check is not answered, and whether its numbers are those of the safe value of what is missing."""

    reason: Message
    safe: bool


def missing_inputs(procedure: str, state: str, context: Context) -> tuple[MissingInput, ...]:
    """Return everything that a check by an Italian procedure lacks; nothing for any other procedure."""
    code = PROCEDURES[procedure].knowledge_code
    return () if not code else tuple(_missing_inputs_of_code(code, state, context))


def _missing_inputs_of_code(code: str, state: str, context: Context) -> Iterator[MissingInput]:
    if context.crushing and code not in context.knowledge:
        key, toml = f"procedures.{code}.knowledge_level", 'knowledge_level = "LC1"'
        yield MissingInput(_message_of_reason(Reason.KNOWLEDGE_UNKNOWN, {"toml": toml}, where=key), safe=True)
    if state == "SLC" and context.open_seats:
        names = dict.fromkeys(each.what for each in context.open_seats)
        values: dict[str, Value] = {"what": ", ".join(names), "toml": 'seat = "0.12 m"'}
        yield MissingInput(_message_of_reason(Reason.SEAT_UNKNOWN, values), safe=False)
    if context.hazard is not None and state not in context.hazard.spectra:
        yield MissingInput(
            _message_of_reason(Reason.HAZARD_TOO_SHORT, {"state": state}, where="site.spectrum.hazard"), safe=False
        )
    declared = context.limit_state
    if context.hazard is None and declared is not None and declared in ITALIAN_STATES_BY_ACTION and declared != state:
        values = {"state": state, "declared": declared}
        stronger = ITALIAN_STATES_BY_ACTION.index(declared) >= ITALIAN_STATES_BY_ACTION.index(state)
        yield MissingInput(
            _message_of_reason(Reason.OTHER_LIMIT_STATE, values, where="site.spectrum.hazard"), safe=stronger
        )


def _message_of_reason(reason: Reason, values: dict[str, Value], *, where: str = "") -> Message:
    return message(reason, values, where=where)
