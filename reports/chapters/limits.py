"""The limits of the method."""

from __future__ import annotations

from collections.abc import Iterator

from assess.codes.check import Check, Outcome
from assess.messages.texts import TEXTS
from assess.results import Results
from reports.chapters import interfaces
from reports.document import Items, Section
from reports.language.lettering import truncate
from reports.language.lists import join_names
from reports.mechanism_title import mechanism_title

SLIDING = "sliding"
GROUND_AT_HEIGHT = "ground-motion"  # key of a remark


def section(results: Results) -> Section:
    """Return the chapter, a list of limits."""
    return Section("Limits of the method", 0, (Items(limits(results)),))


def limits(results: Results) -> tuple[str, ...]:
    """Return what the engineer must keep in mind before signing."""
    return (
        *_GENERAL,
        sliding_limit(results),
        *interfaces.limits(results.mechanisms),
        *_readings(results),
        *_input_difference(results),
        *_unamplified(results),
        *_linearised(results),
        *_unverified(results),
    )


_GENERAL = (
    "The bodies are rigid and move in one vertical plane. Bending and torsion of the masonry, out-of-plane coupling "
    "and mechanisms that were not described in the project are outside this assessment: finding the mechanisms "
    "that matter remains the engineer’s task.",
    "A single rocking history is not predictable: a small change of the motion or the geometry can turn a large "
    "rotation into collapse or into rest. The statistics of many records are. Judge by the suite, not by one history.",
    "The coefficients of restitution of the literature assume inelastic impact without bouncing, the greatest "
    "dissipation that impact can give, which is slightly unconservative (thesis 3.3). Prefer tested values.",
    "Codes assess rocking with an equivalent linear oscillator. Their allowable rotations and equivalent periods "
    "differ; ratios of different procedures measure different margins.",
    "Crushing and the flexibility of the joints count only where the project gives an interface; a rigid interface of "
    "unlimited strength overestimates the resistance of large walls of weak masonry.",
)


def sliding_limit(results: Results) -> str:
    """State where friction was checked, and where it is only assumed to be sufficient."""
    is_checked = {
        mechanism.name: any(c.procedure == SLIDING and c.verdict != Outcome.NOT_APPLICABLE for c in mechanism.checks)
        for mechanism in results.mechanisms
    }
    assumed = "friction at the hinges is assumed to be sufficient"
    forces = "the tables of forces at the hinges give the friction that rocking needs"
    if not any(is_checked.values()):
        return f"No sliding, no bouncing, no separation other than rocking: {assumed}; {forces}."
    unchecked = dict.fromkeys(truncate(mechanism_title(m), 40) for m in results.mechanisms if not is_checked[m.name])
    others = f" For {join_names(unchecked)} it was not checked: {assumed}." if unchecked else ""
    return (
        "Sliding was checked by equilibrium, at every hinge up to the moment at which the mechanism "
        f"starts to rock (procedure {SLIDING}; horizontal motion only).{others} While it rocks {assumed}: no "
        f"bouncing, no separation other than rocking; {forces}. The support at the top of a wall of two "
        "blocks is assumed to hold."
    )


def _readings(results: Results) -> tuple[str, ...]:
    names = dict.fromkeys(c.procedure for c in _checks(results) if c.reading == "thesis")
    return (
        (f"{join_names(names)}: reading of the thesis, shown for comparison; it never decides a verdict.",)
        if names
        else ()
    )


def _input_difference(results: Results) -> tuple[str, ...]:
    if len({check.input_at for check in _checks(results)}) < 2:
        return ()
    return (
        "Some procedures take their input at the ground and others at the base of the mechanism; each "
        "table says which. Do not compare their ratios line by line.",
    )


def _unamplified(results: Results) -> tuple[str, ...]:
    """Return procedures that check mechanisms at height by the motion of the ground."""
    every = [(m, check) for m in results.mechanisms for check in m.checks]
    unamplified = [(m, check) for m, check in every if GROUND_AT_HEIGHT in {remark.key for remark in check.remarks}]
    if not unamplified:
        return ()
    procedures = dict.fromkeys(check.procedure for _, check in unamplified)
    names = dict.fromkeys(truncate(mechanism_title(mechanism), 40) for mechanism, _ in unamplified)
    return (f"{join_names(procedures)}, for {join_names(names)}: {TEXTS[GROUND_AT_HEIGHT]}.",)


def _linearised(results: Results) -> tuple[str, ...]:
    names = [mechanism.name for mechanism in results.mechanisms if mechanism.equation == "linearised"]
    if not names:
        return ()
    return (
        "The linearised equation of motion is used for the time histories of "
        f"{join_names(dict.fromkeys(truncate(name, 40) for name in names))}. It is accurate for slender bodies and "
        "departs from the exact equation as the slenderness angle grows.",
    )


def _unverified(results: Results) -> Iterator[str]:
    """Yield clauses of the basis and procedures that could not be compared with the printed standard."""
    if results.verdict is not None and results.verdict.uncompared:
        yield f"Basis {results.verdict.basis}: {'; '.join(results.verdict.uncompared)}."
    names = dict.fromkeys(check.procedure for check in _checks(results) if check.caveat)
    if names:
        yield f"{join_names(names)}: the table of procedures says what could not be compared with the printed standard."


def _checks(results: Results) -> list[Check]:
    return [check for mechanism in results.mechanisms for check in mechanism.checks]
