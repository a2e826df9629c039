"""The limits of the method, against results changed by hand."""

from __future__ import annotations

from dataclasses import replace

from reports.mechanism_title import mechanism_title

from assess.codes.check import Outcome
from assess.messages.message import message
from assess.messages.texts import TEXTS
from assess.results import Results
from reports.chapters import limits


def test_limits_name_what_is_judged_at_height_by_the_motion_of_the_ground(results: Results) -> None:
    text = TEXTS["ground-motion"]
    assert not any(text in said for said in limits.limits(results))
    first, *others = results.mechanisms
    checks = (replace(first.checks[0], remarks=(message("ground-motion"),)), *first.checks[1:])
    raised = replace(results, mechanisms=(replace(first, checks=checks), *others))
    (said,) = (said for said in limits.limits(raised) if text in said)
    assert said.startswith(f"{first.checks[0].procedure}, for {mechanism_title(first)}: ")


def test_limits_name_what_is_uncompared_of_the_thesis_and_linearised(results: Results) -> None:
    text = " ".join(limits.limits(results))
    for words in (
        "asce43-05-spectrum-thesis: reading of the thesis",
        "dmi2008-linear and dmi2008-nonlinear: the table of procedures says what could not be compared",
        "Basis asce43-05: the methods were read in the thesis",
        "histories of parapet",
        "Judge by the suite",
        "input at the ground and others",
    ):
        assert words in text


def test_limits_say_where_sliding_was_checked_and_where_not(results: Results) -> None:
    assert "friction at the hinges is assumed to be sufficient" in " ".join(limits.limits(results))
    first, second = results.mechanisms
    asked = replace(first.checks[0], procedure="sliding", verdict=Outcome.PASS)
    silent = replace(asked, verdict=Outcome.NOT_APPLICABLE)
    both = tuple(replace(one, checks=(check,)) for one, check in ((first, asked), (second, silent)))
    text = limits.sliding_limit(replace(results, mechanisms=both))
    assert text.startswith("Sliding was checked by equilibrium, at every hinge")
    assert "For parapet it was not checked" in text
    assert "it was not checked" not in limits.sliding_limit(replace(results, mechanisms=both[:1]))
