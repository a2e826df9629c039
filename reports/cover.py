"""The first page: the verdict at a glance, and one line for each mechanism."""

from __future__ import annotations

from hashlib import sha256

from assess.codes.check import Check
from assess.plural import counted
from assess.results import MechanismResult, Results
from reports import findings, governing
from reports.document import Banner, Cell, Column, Section, Table, Text
from reports.tables import name_of

NO_PASS = "what could not be answered is no pass"


def section(results: Results) -> Section:
    """The verdict, and what decides each mechanism."""
    found = governing.outcome(results)
    said = Text((asked(results), *returning(results)))
    return Section("Verdict", 0, (Banner(found, headline(results)), said, glance(results)))


def headline(results: Results) -> str:
    """What the verdict means, in one sentence."""
    found = governing.outcome(results)
    judged = [m for m in results.mechanisms if governing.verdict(m.checks) != "not-applicable"]
    failing = sum(governing.verdict(mechanism.checks) == "fail" for mechanism in judged)
    if found == "fail":
        return f"{failing} of {len(judged)} mechanisms fail at least one code check at the levels that were asked."
    if found == "pass":
        return f"Every code check passes at every level, for {counted(len(judged), 'mechanism')}."
    silent = governing.unanswered(governing.of_all(results)) or "no code procedure gave a verdict"
    return f"{silent[0].upper()}{silent[1:]}: {NO_PASS}."


def asked(results: Results) -> str:
    """At which levels, by which procedures."""
    checks = governing.of_all(results)
    levels = ", ".join(f"{level:.3g}" for level in governing.levels(checks))
    names = ", ".join(dict.fromkeys(check.procedure for check in checks))
    return f"Peak ground accelerations asked [g]: {levels or 'none'}. Code procedures: {names or 'none'}."


def returning(results: Results) -> tuple[str, ...]:
    """Which mechanisms pass at a level above their PGA at capacity, and why that is no slip."""
    names = [findings.named(m) for m in results.mechanisms if any(map(_passes_beyond, governing.of_code(m.checks)))]
    if not names:
        return ()
    return (
        f"{findings.listed(names)}: records that overturn, or turn too far, at one PGA can be survived at a "
        "higher one. The PGA at capacity is the last before the suite first fails; a level above it that passes is no "
        "reserve.",
    )


def _passes_beyond(check: Check) -> bool:
    capacity = check.capacity_pga_g
    return check.verdict == "pass" and capacity is not None and check.level_pga_g > 1.000001 * capacity


def glance(results: Results) -> Table:
    """One line for each mechanism: its verdict, the check that governs it, and what it stands up to."""
    columns = (
        Column("Mechanism"),
        Column("Verdict", kind="verdict"),
        Column("Governing procedure"),
        Column("at PGA", "g", "number"),
        Column("Demand / capacity", "-", "number"),
        Column("Least PGA at capacity", "g", "number"),
        Column("by"),
    )
    caption = (
        "Verdict of each mechanism, the check that governs it, and the lowest peak ground acceleration at which a code "
        "procedure has it reach its capacity."
    )
    return Table("verdict", caption, columns, tuple(_line(mechanism) for mechanism in results.mechanisms))


def _line(mechanism: MechanismResult) -> tuple[Cell, ...]:
    checks = governing.of_code(mechanism.checks)
    worst, weakest = governing.worst(checks), governing.weakest(checks)
    deciding = (None, None, None) if worst is None else _deciding(worst)
    least = (None, None) if weakest is None else (weakest.capacity_pga_g, weakest.procedure)
    return (name_of(mechanism), governing.verdict(mechanism.checks), *deciding, *least)


def _deciding(worst: Check) -> tuple[Cell, Cell, Cell]:
    return worst.procedure, worst.level_pga_g, worst.unbounded or worst.ratio


def fingerprint(results: Results) -> str:
    """One SHA-256 over those of all files read, and how many they are: which inputs this report is of."""
    joined = "".join(each.sha256 for each in results.inputs).encode("ascii", "replace")
    return f"{counted(len(results.inputs), 'file')}, together SHA-256 {sha256(joined).hexdigest()}"
