"""What the summary says in words follows from the checks."""

from __future__ import annotations

from dataclasses import replace

import pytest

from assess.codes.registry import PROCEDURES
from assess.results import MechanismResult, Results
from reports import cover, findings, governing


def with_capacities(mechanism: MechanismResult, *, at: float) -> MechanismResult:
    """The mechanism with one PGA at capacity [g] in every check."""
    return replace(mechanism, checks=tuple(replace(check, capacity_pga_g=at) for check in mechanism.checks))


def test_the_critical_mechanism_has_the_least_pga_at_capacity(results: Results) -> None:
    first, second = results.mechanisms
    ranked = replace(results, mechanisms=(with_capacities(first, at=0.30), with_capacities(second, at=0.24)))
    said = findings.findings(ranked)[0]
    assert said.startswith(f"Critical is {findings.named(second)}: it reaches its capacity at the lowest PGA, 0.240 g")
    assert f"{findings.named(first)} at 0.300 g" in said
    assert "1.25 times as much" in said


def test_informative_readings_make_no_mechanism_critical(results: Results) -> None:
    informative = tuple(replace(check, role="informative") for check in results.mechanisms[0].checks)
    muted = replace(results, mechanisms=(replace(results.mechanisms[0], checks=informative),))
    assert findings.ranking(muted) == []


def test_disagreement_names_who_fails_and_who_passes(results: Results) -> None:
    said = " ".join(findings.findings(results))
    assert "At PGA 0.45 g the procedures disagree on" in said
    assert "dmi2008-linear fails" in said
    assert "asce43-05-spectrum and dmi2008-nonlinear pass all of these" in said
    assert "dmi2008-linear judges the acceleration that starts the motion" in said
    assert "dmi2008-nonlinear compares the displacement" in said


def test_nothing_is_said_of_agreement(results: Results) -> None:
    passing = tuple(
        replace(m, checks=tuple(replace(c, verdict="pass", demand=0.0, ratio=0.0) for c in m.checks))
        for m in results.mechanisms
    )
    assert "disagree" not in " ".join(findings.findings(replace(results, mechanisms=passing)))


@pytest.mark.parametrize(
    ("names", "said"),
    [([], ""), (["a"], "a"), (["a", "b"], "a and b"), (list("abcdefghij"), "a, b, c, d, e, f and 4 others")],
)
def test_long_lists_are_shortened(names: list[str], said: str) -> None:
    assert findings.listed(names) == said


def test_the_cover_gives_the_verdict_in_words(results: Results) -> None:
    banner = cover.section(results).blocks[0]
    assert banner == cover.Banner("fail", cover.headline(results))
    assert cover.headline(results) == "2 of 2 mechanisms fail at least one code check at the levels that were asked."


def test_an_unanswered_check_is_no_pass_on_the_cover(results: Results) -> None:
    first = results.mechanisms[0]
    passing = tuple(replace(c, verdict="pass", ratio=0.2, demand=0.1) for c in first.checks[:-1])
    open_ended = replace(first, checks=(*passing, replace(first.checks[-1], verdict="not-applicable", role="code")))
    found = replace(results, mechanisms=(open_ended,))
    assert governing.outcome(found) == "incomplete"
    assert cover.headline(found).endswith(cover.NO_PASS + ".")


def test_a_pass_above_the_pga_at_capacity_is_explained_on_the_cover(results: Results) -> None:
    first = results.mechanisms[0]
    passing = replace(first.checks[0], verdict="pass", role="code", level_pga_g=0.3, capacity_pga_g=0.28)
    assert cover.returning(replace(results, mechanisms=(replace(first, checks=(passing,)),)))[0].startswith("Wall 6")
    below = replace(passing, capacity_pga_g=0.31)
    assert cover.returning(replace(results, mechanisms=(replace(first, checks=(below,)),))) == ()


def test_no_record_overturns_is_not_said_of_procedures_with_a_motion_of_their_own(results: Results) -> None:
    first = results.mechanisms[0]
    check = replace(first.checks[0], procedure="ntc2018-history", limit_state="SLV", verdict="fail", demand=None)
    standing = tuple(replace(suite, overturned=0) for suite in first.suites)
    found = replace(results, mechanisms=(replace(first, suites=standing, checks=(check,)),))
    said = " ".join(findings.findings(found))
    assert "no record overturns a mechanism at the levels that were asked; ntc2018-history" in said


def test_every_procedure_has_a_sentence_on_what_it_measures() -> None:
    assert [name for name in PROCEDURES if not name.endswith("-thesis") and not findings.measured(name)] == []
