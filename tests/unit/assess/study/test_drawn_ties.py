"""Ties of a building in space: each once, with what becomes of it, against the geometry of the façade by hand."""

from __future__ import annotations

from functools import cache
from math import cos, hypot, sin
from types import SimpleNamespace

import pytest

import assess
from assess.results import Results
from assess.results.before import governing_check
from assess.results.json import dumps, loads
from assess.study.drawn_ties import _state_of
from tests.support.facade import variant, with_ties

AREA, MODULUS, YIELD, LENGTH, PRETENSION = 314e-6, 210e9, 235e6, 9.0, 10e3
AT = 6.2  # m above the hinge, in whose face the ties are
SOURCES = [f'"mechanisms.{name}.loads[{n}]" = "measured: test"\n' for name in ("upper",) for n in (1, 2)]
BARS = """
[bodies.bar]
material = "stone"
box = { thickness = 0.02, length = 9.0, height = 0.02, base = [-2.0, 4.25, 6.19] }

[bodies.old-bar]
material = "stone"
box = { thickness = 0.03, length = 9.0, height = 0.03, base = [0.0, 4.25, 3.0] }

[mechanisms.gable]"""


@cache
def brittle() -> Results:
    """The façade with anchorages of 40 kN, its ties on the upper part too, a bar along one, and one that is none."""
    tie = (
        '{{ kind = "tie", force = "10 kN", at = [{x}, -0.25, 6.2], anchor = [{x}, 8.75, 6.2], area = "314 mm^2", '
        'young_modulus = "210 GPa", yield_stress = "235 MPa", length = "9 m", fracture_strain = 0.10, '
        'strength = "40 kN" }},\n'
    )
    upper = (
        '\n[mechanisms.upper]\nkind = "single-block"\nblocks = ["facade"]\ndirection = [0, -1, 0]\nsides = "one"\n'
        f'cut = "3.0 m"\nloads = [\n{tie.format(x=-2.0)}{tie.format(x=2.01)}]\n\n[report]\n'
    )
    words = {
        'strength = "95 kN"': 'strength = "40 kN"',
        "\n[mechanisms.gable]": BARS,
        "\n[report]\n": upper,
        "[report.sources]\n": "[report.sources]\n" + "".join(SOURCES),
        'before = "project-results/results.json"': "index_before = 0.5",
    }
    return assess.run(variant("brittle", **words)).results


def elongation(rotation: float) -> float:
    """Of a level tie of LENGTH that holds the face AT above its edge [m]."""
    return hypot(LENGTH + AT * sin(rotation), AT * (1.0 - cos(rotation))) - LENGTH


def test_what_a_tie_has_stretched_and_yielded_at_the_demand_is_that_of_geometry():
    results = with_ties()
    facade = results.mechanisms[0]
    check = governing_check(facade.checks, pga_g=results.verdict.action.pga_g)
    over = (facade.deciding_overturning_rad or (facade.oscillator.overturning_rad,))[0]
    e = elongation(check.rotation_ratio * over)
    first, second = results.ties
    (held,) = first.held
    assert held.elongation_m == pytest.approx(e, rel=1e-9)
    free = LENGTH / (1.0 + PRETENSION / (MODULUS * AREA))
    assert held.plastic_m == pytest.approx(e - (AREA * YIELD - PRETENSION) * free / (MODULUS * AREA), rel=1e-9)
    assert (first.outcome, held.mechanism, held.load) == ("yields", "facade", "tie 1")
    assert first.ends == ((-2.0, -0.25, 6.2), (-2.0, 8.75, 6.2))
    assert second.ends[0][0] == 2.0


def test_a_tie_that_holds_two_mechanisms_is_one_tie():
    """Two centimetres apart are one place; a drawn bar along it is the same tie too."""
    first, second, lone = brittle().ties
    assert [each.mechanism for each in first.held] == ["facade", "upper"]
    assert [each.mechanism for each in second.held] == ["facade", "upper"]
    assert (first.body, second.body) == ("bar", "")
    assert (lone.body, lone.held, lone.outcome) == ("old-bar", (), "not counted")


def test_an_anchorage_that_tears_out_leaves_no_tie():
    facade, _ = brittle().ties[0].held
    assert facade.elongation_m > (40e3 - PRETENSION) * LENGTH / (MODULUS * AREA)
    assert (facade.outcome, brittle().ties[0].outcome) == ("gone", "gone")


def test_ties_without_a_source_are_drawn_and_do_not_count():
    words = {"[report.sources]": '[report.sources]\n"verdict.before" = "measured: none"'}
    text = {f'"mechanisms.facade.loads[{n}]"': f'#"mechanisms.facade.loads[{n}]"' for n in (1, 2)}
    results = assess.run(variant("unsourced", **words, **text)).results
    assert [each.outcome for each in results.ties] == ["not counted", "not counted"]
    assert [each.ends for each in results.ties] == [each.ends for each in with_ties().ties]


def test_ties_are_read_back_as_they_were_written():
    assert loads(dumps(brittle())).ties == brittle().ties


def test_of_histories_the_side_that_stretches_a_tie_counts_though_the_other_is_the_largest():
    """A wall that leans 0.03 rad away from its anchor, with 0.02 rad towards it in another record, has stretched it."""
    bar = {"area": AREA, "young_modulus": MODULUS, "yield_stress": YIELD, "fracture_strain": 0.1, "strength": 1e6}
    ends = {"at": [0, 0, AT], "anchor": [-LENGTH, 0, AT], "length": LENGTH}
    tie = assess.TieLoad(force=PRETENSION, evidence="test", **ends, **bar)
    wall = assess.box(thickness=0.6, length=4.0, height=8.0, density=2000.0)
    mechanism = assess.single_block(wall, direction=[1, 0, 0], loads=[tie]).mechanism
    used = SimpleNamespace(name="tie 1", lasting="to its end", end_rad=None)
    state = _state_of(mechanism, used, {"positive": 0.02, "negative": 0.03})
    assert state.outcome == "yields"
    assert state.elongation == pytest.approx(hypot(LENGTH + AT * sin(0.02), 0.6e-3) - LENGTH, rel=0.01)
    leaning = _state_of(mechanism, used, {"positive": 0.02}, {"positive": 0.001})
    far, near = (_state_of(mechanism, used, {"positive": rotation}).elongation for rotation in (0.021, 0.001))
    assert far is not None
    assert near is not None
    assert leaning.elongation == pytest.approx(far - near, rel=1e-9)
    assert _state_of(mechanism, used, {"positive": None, "negative": 0.03}).outcome == "not known"
    assert _state_of(mechanism, used, {"negative": 0.03}).outcome == "slack"


def test_each_link_of_a_tie_has_its_ratio_of_demand_to_capacity():
    """The bar yields at 73.8 kN: 1.05 of its design strength, 73.8 / 95 = 0.777 of the stated anchorage."""
    (held,) = with_ties().ties[0].held
    assert held.pull_n == pytest.approx(AREA * YIELD, rel=1e-12)
    assert {link.name: link.ratio for link in held.links} == {
        "bar": pytest.approx(1.05, rel=1e-12),
        "anchorage": pytest.approx(AREA * YIELD / 95e3, rel=1e-12),
    }
    assert held.governing is not None
    assert held.governing.name == "bar"


def test_a_torn_anchorage_has_a_ratio_of_one():
    facade, _ = brittle().ties[0].held
    assert facade.governing is not None
    assert (facade.governing.name, facade.governing.ratio) == ("anchorage", pytest.approx(1.0))
