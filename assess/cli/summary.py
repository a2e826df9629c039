"""What `assess run` prints: the verdict of each mechanism at each level, by each procedure that decides."""

from __future__ import annotations

from assess.cli.description import warned
from assess.cli.text_table import text_table
from assess.codes.check import Check
from assess.results import MechanismResult, Results

_WORDS = {"pass": "pass", "fail": "FAIL", "not-applicable": "n/a"}


def some_check_fails(results: Results) -> bool:
    """Whether a check that decides fails; informative readings never decide."""
    return any(check.verdict == "fail" for mechanism in results.mechanisms for check in _deciding(mechanism))


def summary(results: Results) -> str:
    """A table of verdicts with demand over capacity, the warnings, and the verdict of all."""
    procedures = list(dict.fromkeys(c.procedure for m in results.mechanisms for c in _deciding(m)))
    rows = [row for mechanism in results.mechanisms for row in _rows(mechanism, procedures)]
    verdict = _verdict(results)
    warnings = warned(results.warnings)
    if not rows:
        return f"{warnings}no check applies\n"
    return text_table(["mechanism", "PGA [g]", *procedures], rows) + warnings + f"{verdict}\n"


def _verdict(results: Results) -> str:
    verdicts = {check.verdict for mechanism in results.mechanisms for check in _deciding(mechanism)}
    if "fail" in verdicts:
        return "some check fails"
    if "not-applicable" in verdicts:
        return "no check fails, but some could not be answered" if "pass" in verdicts else "no check gave a verdict"
    return "all checks pass"


def _deciding(mechanism: MechanismResult) -> tuple[Check, ...]:
    return tuple(check for check in mechanism.checks if check.role == "code")


def _rows(mechanism: MechanismResult, procedures: list[str]) -> list[list[str]]:
    checks = _deciding(mechanism)
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
    rank = {"not-applicable": 0, "pass": 1, "fail": 2}[check.verdict]
    return rank, float("inf") if check.ratio is None else check.ratio
