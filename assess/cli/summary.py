"""What `assess run` prints: the verdict of each mechanism at each level, by each procedure that decides."""

from __future__ import annotations

from assess.cli.description import warned
from assess.cli.text_table import text_table
from assess.codes.check import Check
from assess.project.messages import printable
from assess.results import MechanismResult, Results
from reports.governing import of_all, of_code, reasons, unanswered

_WORDS = {"pass": "pass", "fail": "FAIL", "not-applicable": "n/a"}


def some_check_fails(results: Results) -> bool:
    """Whether a check that decides fails; informative readings never decide."""
    return any(check.verdict == "fail" for check in of_all(results))


def summary(results: Results) -> str:
    """A table of verdicts with demand over capacity, the warnings, and the verdict of all."""
    procedures = list(dict.fromkeys(check.procedure for check in of_all(results)))
    rows = [row for mechanism in results.mechanisms for row in _rows(mechanism, procedures)]
    warnings = warned(results.warnings)
    if not rows:
        return f"{warnings}no check applies\n"
    not_answered = "".join(f"not answered: {printable(reason)}\n" for reason in reasons(of_all(results)))
    return text_table(["mechanism", "PGA [g]", *procedures], rows) + warnings + not_answered + f"{_verdict(results)}\n"


def _verdict(results: Results) -> str:
    checks = of_all(results)
    missing = unanswered(checks)
    if some_check_fails(results):
        return "some check fails" + (f"; {missing}" if missing else "")
    if not missing:
        return "all checks pass"
    none = all(check.verdict == "not-applicable" for check in checks)
    return "no check gave a verdict" if none else f"incomplete: {missing}; no check fails"


def _rows(mechanism: MechanismResult, procedures: list[str]) -> list[list[str]]:
    checks = of_code(mechanism.checks)
    levels = sorted({check.level_pga_g for check in checks})
    return [
        [mechanism.name, f"{level:.3g}", *(_cell(checks, procedure, level) for procedure in procedures)]
        for level in levels
    ]


def _cell(checks: tuple[Check, ...], procedure: str, level: float) -> str:
    """Verdict and ratio of the check that governs among those of one procedure at one level."""
    found = [check for check in checks if check.procedure == procedure and check.level_pga_g == level]
    if not found:
        return ""
    worst = max(found, key=_severity)
    ratio = "" if worst.ratio is None else f" {worst.ratio:.2f}"
    return _WORDS[worst.verdict] + ratio


def _severity(check: Check) -> tuple[int, float]:
    rank = {"pass": 0, "not-applicable": 1, "fail": 2}[check.verdict]
    return rank, float("inf") if check.ratio is None else check.ratio
