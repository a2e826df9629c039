"""The calculation sheets: every step of a procedure, as it computed it."""

from __future__ import annotations

from assess.codes.check import Check
from reports.document import Line, Sheet
from reports.language.numerals import with_bound


def calculation_sheet(check: Check, *, name: str, mechanism: str) -> Sheet:
    """Return the steps of one check at its level."""
    lines = tuple(
        Line(s.symbol, s.description, s.clause, s.formula, s.substituted, with_bound(s.value, s.bound), s.unit)
        for s in check.steps
    )
    state = f", limit state {check.limit_state}" if check.limit_state else ""
    role = ", deciding" * (check.role == "deciding") + ", reading of the thesis" * (check.reading == "thesis")
    what = f"{check.procedure} ({check.edition}){state}, {check.branch} branch"
    return Sheet(name, f"{mechanism}: {what}, at PGA {check.level_pga_g:.3g} g: {check.verdict}{role}.", lines)
