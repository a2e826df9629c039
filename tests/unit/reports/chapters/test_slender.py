"""A wall that fails by a table of slenderness is told the h/t to reach: a table states no resistance."""

from __future__ import annotations

import pytest

from assess.project.build import build
from assess.project.project_file import load
from assess.study.run import run_study
from reports.chapters import cells
from reports.chapters.mechanism_verdict import verdict_sentences
from tests.support.letters import letters

PROJECT = """
[analysis]
procedures = ["asce41-13-ht"]
[site]
limit_state = "BSE-1E"
spectrum = { code = "asce7-16", s_ds = "1.0 g", s_d1 = "0.45 g", t_l = "6 s" }
[verdict]
basis = "asce41-13"
[building]
height = "8.4 m"
storeys = 2
ground_elevation = 0.0
[materials.m]
density = 1800
[bodies.below]
material = "m"
box = { thickness = "0.3 m", length = "3 m", height = "8.4 m" }
[bodies.wall]
material = "m"
box = { thickness = "0.3 m", length = "3 m", height = "1.92 m", base = [0, 0, 8.4] }
[mechanisms.parapet]
kind = "single-block"
blocks = ["wall"]
direction = [1, 0, 0]
"""


def test_a_parapet_that_is_too_slender_is_told_the_limit_of_the_table(tmp_path):
    """1.92 m on 0.30 m is h/t 6.4, and Table 11-5's checklist allows 1.5: a ratio of 4.27, which is no resistance."""
    file = tmp_path / "project.toml"
    file.write_text(PROJECT, encoding="utf-8")
    results = run_study(build(load(file)), jobs=1)
    (decided,) = results.verdict.mechanisms
    assert decided.answers[0].ratio == pytest.approx(1.92 / 0.3 / 1.5, rel=1e-12)
    assert cells.required_increase(decided, results.verdict) is None
    said = [letters(each) for each in verdict_sentences(results, results.mechanisms[0])]
    assert "To pass, its slenderness h/t of 6.4 must not exceed 1.5." in said
    assert not [each for each in said if "resistance" in each or "times as large" in each]
