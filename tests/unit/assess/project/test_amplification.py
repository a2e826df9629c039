"""The key `amplification`: where its numbers come from, what is refused, and what the histories then are."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.constants import g

from assess.amplification import (
    FirstMode,
    FloorFactor,
    ModalFilter,
    Srss,
    floor_motion,
    pulse_factor,
    rayleigh_mode,
    slice_cantilever,
)
from assess.errors import ProjectError
from assess.geometry.solid import box
from assess.study.assessment import building_states
from assess.study.envelopes import run_envelopes
from assess.study.run import run_study
from assess.study.study import Study
from tests.support import projects
from tests.support.motions import write_noise
from tests.support.projects import project_toml, wall

WALL = box(thickness=0.6, length=4.0, height=8.0, base=[0, 0, 0], density=2000.0, name="w")
METHODS = {"srss": Srss, "modal-filter": ModalFilter}
CUT = 'kind = "single-block"\nblocks = ["w"]\ncut = "5 m"\n'
BLOCK = 'kind = "equivalent-block"\np = 2.26\nuplift = 0.21\nradius = 1.46\nelevation = 5\n'
HOUSE = '[building]\nheight = "9 m"\n'


MATERIALS = {"m": {"density": 2000, "young_modulus": "3 GPa"}, "soft": {"density": 2000}}
BODIES = {
    "w": wall(0.6, 4.0, 8.0, material="m"),
    "high": wall(0.6, 4.0, 3.0, material="m", base=[0, 0, 5]),
    "soft": wall(0.6, 4.0, 8.0, material="soft"),
    "direct": {"mass": 1000, "centroid": [0, 1], "inertia": 500},
}


def study_of(folder: Path, mechanism: str, *, building: str = "", analysis: str = "") -> Study:
    write_noise(folder / "a.csv", duration=6.0)
    text = project_toml(
        analysis,
        building,
        materials=MATERIALS,
        bodies=BODIES,
        mechanisms={"m": mechanism},
        records={"files": ["a.csv"]},
        analysis={"levels": ["0.3 g"], "procedures": ["asce43-05-history", "asce43-05-spectrum"]},
    )
    return projects.study_of(folder, text)


def amplification(method: str, **keys: str) -> str:
    given = "".join(f', {key} = "{value}"' for key, value in keys.items())
    return f'amplification = {{ method = "{method}"{given} }}\n'


def mode_of(study: Study) -> tuple[float, float, float, float]:
    """Frequency, effective height, damping, height of the mechanism."""
    found = study.amplified["m"].amplification
    assert isinstance(found, Srss | ModalFilter)
    return (found.mode.frequency, found.mode.effective_height, found.mode.damping, found.height)


def test_what_is_given_goes_before_the_building_and_the_building_before_rayleigh(tmp_path):
    own = amplification("srss", natural_frequency="2.5 Hz", effective_height="6.01 m", height="4.77 m")
    whole = HOUSE + 'natural_frequency = "3 Hz"\neffective_height = "5 m"\ndamping = 0.03\n'
    by_rayleigh = rayleigh_mode(slice_cantilever([WALL], [3e9], direction=[1, 0, 0]))
    expected = (by_rayleigh.frequency, by_rayleigh.effective_height, 0.05, 5.0)
    assert mode_of(study_of(tmp_path, CUT + own, building=whole)) == (2.5, 6.01, 0.03, 4.77)
    assert mode_of(study_of(tmp_path, CUT + amplification("modal-filter"), building=whole)) == (3.0, 5.0, 0.03, 5.0)
    assert mode_of(study_of(tmp_path, CUT + amplification("srss"))) == pytest.approx(expected, rel=1e-9)
    assert mode_of(study_of(tmp_path, CUT + amplification("srss"), building=HOUSE)) == pytest.approx(expected, rel=1e-9)


def test_a_period_that_is_given_is_the_first_mode_s(tmp_path):
    frequency, *_ = mode_of(study_of(tmp_path, CUT + amplification("srss"), building=HOUSE + "period = 0.4\n"))
    assert frequency == pytest.approx(2.5, rel=1e-12)


@pytest.mark.parametrize(
    ("building", "effective"),
    [
        (HOUSE + "storeys = 3\n", 9.0 * 7.0 / 9.0),  # gamma_1 = 9/7: 9 m / (9/7) = 7 m
        (HOUSE + "storeys = 1\n", 9.0),  # gamma_1 = 1: the mass of one storey is at the top
        (HOUSE, 6.0),  # many storeys: gamma_1 = 3/2
        ("", 8.0 * 2.0 / 3.0),  # the highest body ends at 8 m
    ],
)
def test_without_an_effective_height_a_linear_mode_is_provisional(tmp_path, building, effective):
    """C7.2.10, by hand: gamma_1 = 3 n / (2 n + 1), and gamma_1 h / H = h / h_e."""
    study = study_of(tmp_path, BLOCK + amplification("modal-filter", natural_frequency="2 Hz"), building=building)
    assert mode_of(study)[:2] == pytest.approx((2.0, effective), rel=1e-12)
    (missing,) = study.amplified["m"].missing
    assert missing.key == "building.effective_height"
    assert missing.toml == f'effective_height = "{effective:.3g} m"'
    given = BLOCK + amplification("modal-filter", natural_frequency="2 Hz", effective_height="6 m")
    assert study_of(tmp_path, given, building=building).amplified["m"].missing == ()


def test_rayleigh_bends_the_wall_in_its_direction(tmp_path):
    along, *_ = mode_of(study_of(tmp_path, CUT + "direction = [0, 1, 0]\n" + amplification("srss")))
    found = rayleigh_mode(slice_cantilever([WALL], [3e9], direction=[0, 1, 0]))
    assert along == pytest.approx(found.frequency, rel=1e-9)
    study = study_of(tmp_path, CUT + amplification("srss"))
    assumed = [notice.text for notice in study.messages if notice.where == "mechanisms.m"]
    assert len(assumed) == 1
    assert "G = 0.4 E" in assumed[0]


@pytest.mark.parametrize(
    ("method", "factor"),
    [("ec8", 1.5 * (1 + 5 / 9) - 0.5), ("ec8-resonance", 3 * (1 + 5 / 9) - 0.5), ("nzs1170.5", 1 + 5 / 6)],
)
def test_a_code_s_factor_takes_height_and_building(tmp_path, method, factor):
    found = study_of(tmp_path, BLOCK + amplification(method), building=HOUSE).amplified["m"]
    assert isinstance(found.amplification, FloorFactor)
    assert found.amplification.factor == pytest.approx(factor, rel=1e-12)
    above = study_of(tmp_path, BLOCK + amplification(method), building=HOUSE + "ground_elevation = 5\n").amplified["m"]
    assert above.height == 0.0


def test_the_printed_ec8_takes_its_soil(tmp_path):
    given = 'amplification = { method = "ec8-printed", soil_factor = 1.15, height = 3 }\n'
    found = study_of(tmp_path, BLOCK + given, building=HOUSE).amplified["m"].amplification
    assert isinstance(found, FloorFactor)
    assert found.factor == pytest.approx(1.15 * 3.5, rel=1e-12)


@pytest.mark.parametrize(
    ("mechanism", "building", "words"),
    [
        (BLOCK + amplification("srss"), "", "effective_height: not both given, and only a single-block"),
        (BLOCK + amplification("srss", effective_height="6 m"), HOUSE, "not both given"),
        (BLOCK + amplification("ec8"), "", r'"ec8" needs the height of the building; add a table \[building\]'),
        (BLOCK + amplification("ec8", height="9.5 m"), HOUSE, r"height 9.5 m in a building of 9 m; EN 1998-1, 4.3.5.2"),
        (BLOCK + amplification("srss"), HOUSE + "ground_elevation = 6\n", "begins 1 m below the ground; give height"),
        (CUT.replace('"w"', '"soft"') + amplification("srss"), "", "materials.soft has no young_modulus"),
        (
            'kind = "single-block"\nblocks = ["high"]\n' + amplification("srss"),
            "",
            "its bodies begin at z = 5 m, the ground is at 0 m",
        ),
        (
            'kind = "single-block"\nblocks = ["direct"]\nhinges = { A = [0.4, 0] }\n'
            "hinges_negative = { A = [-0.4, 0] }\n" + amplification("modal-filter"),
            "",
            "only a single-block of bodies",
        ),
    ],
)
def test_what_is_missing_is_named(tmp_path, mechanism, building, words):
    with pytest.raises(ProjectError, match=words) as refused:
        study_of(tmp_path, mechanism, building=building)
    assert "mechanisms.m.amplification" in str(refused.value)
    assert "\n" not in str(refused.value)


def test_two_first_modes_of_one_building_are_told(tmp_path):
    whole = HOUSE + 'natural_frequency = "2.5 Hz"\neffective_height = "6 m"\n'
    messages = study_of(tmp_path, CUT + amplification("srss"), building=whole).messages
    told = [each for each in messages if each.where == "building"]
    assert len(told) == 1
    assert "give period = 0.4" in told[0].text
    same = study_of(tmp_path, CUT + amplification("srss"), building=whole + "period = 0.4\n")
    assert not [n for n in same.messages if n.where == "building"]


def test_only_what_is_not_amplified_is_warned_of(tmp_path):
    for text, warned in ((CUT, 1), (CUT + amplification("ec8"), 0)):
        messages = study_of(tmp_path, text, building=HOUSE).messages
        assert [each.where for each in messages].count("mechanisms") == warned


def test_a_factor_is_a_stronger_ground(tmp_path):
    """Histories at 0.3 g times the factor, by a mechanism that is not amplified."""
    amplified = run_study(study_of(tmp_path, CUT + amplification("nzs1170.5"), building=HOUSE)).mechanisms[0]
    factor = 1 + 5 / 6
    plain = run_study(replace(study_of(tmp_path, CUT, building=HOUSE), levels=(0.3 * factor * g,))).mechanisms[0]
    other = plain.histories[0]
    one = next(each for each in amplified.histories if each.level_pga_g == pytest.approx(0.3, rel=1e-9))
    assert one.max_rotation_rad == pytest.approx(other.max_rotation_rad, rel=1e-9)
    assert (one.amplification, other.amplification) == (pytest.approx(factor), 1.0)
    assert one.scale_factor == pytest.approx(other.scale_factor / factor, rel=1e-12)
    base, ground = one.trace.base_acceleration_g, one.trace.ground_acceleration_g
    np.testing.assert_allclose(base, factor * np.array(ground), rtol=1e-9)
    assert plain.histories[0].trace.base_acceleration_g is None


def test_a_filtered_motion_is_the_floor_s(tmp_path):
    """The same history as of a mechanism on the ground under the floor's motion."""
    study = study_of(tmp_path, CUT + amplification("modal-filter"))
    frequency, effective_height, damping, height = mode_of(study)
    found = run_study(study)
    shown = found.mechanisms[0].amplification
    floor = floor_motion(
        study.records[0],
        frequency=frequency / shown.building_period_ratio,
        shape=height / effective_height,
        damping=shown.building_damping or damping,
        fastest=max(frequency / state.period_ratio for state in building_states(study, found.mechanisms[0].name)),
    )
    ground = replace(study_of(tmp_path, CUT), records=(floor,), scale_to="none")
    site = found.spectrum.pga_g
    level = (site * g * 0.3 / site * found.records[0].scale_factor,)  # the floor's motion is not scaled to the target
    beside = run_study(replace(ground, levels=level)).mechanisms[0].histories[0]
    one = next(each for each in found.mechanisms[0].histories if each.level_pga_g == pytest.approx(0.3, rel=1e-9))
    assert one.max_rotation_rad == pytest.approx(beside.max_rotation_rad, rel=1e-9)
    assert abs(one.max_rotation_rad) > 1e-3
    assert one.amplification == pytest.approx(floor.pga / study.records[0].pga, rel=1e-12)
    motion = found.mechanisms[0].amplification.motion
    scale = found.records[0].scale_factor / g
    np.testing.assert_allclose(motion.base_acceleration_g, scale * floor.acceleration, rtol=1e-12)


def test_each_check_says_where_its_input_acts(tmp_path):
    found = run_study(study_of(tmp_path, CUT + amplification("nzs1170.5"), building=HOUSE)).mechanisms[0]
    plain = run_study(study_of(tmp_path, CUT, building=HOUSE)).mechanisms[0]
    assert {check.procedure: check.input_at for check in found.checks} == {
        "asce43-05-history": "mechanism base",
        "asce43-05-spectrum": "ground",
    }
    assert {check.input_at for check in plain.checks} == {"ground"}
    history, before = (next(c for c in m.checks if c.procedure == "asce43-05-history") for m in (found, plain))
    assert history.uplift_pga_g == pytest.approx(before.uplift_pga_g / (1 + 5 / 6), rel=1e-9)
    own = [c for c in found.checks if c.procedure == "asce43-05-spectrum"]
    assert own == [c for c in plain.checks if c.procedure == "asce43-05-spectrum"]  # clauses keep their own input


def test_the_way_up_may_be_swept(tmp_path):
    sweep = '[analysis.sweep]\nkey = "mechanisms.m.amplification.height"\nvalues = ["1 m", "5 m"]\n'
    study = study_of(tmp_path, CUT + amplification("nzs1170.5", height="2 m"), building=HOUSE, analysis=sweep)
    factors = [case.study.amplified["m"].amplification.factor for case in study.sweeps[0].cases]
    assert factors == pytest.approx([1 + 1 / 6, 1 + 5 / 6], rel=1e-12)


def test_envelopes_are_of_the_ground(tmp_path):
    """The least pulse at the ground is the one at the base divided by the factor at its frequency."""
    pulses = (
        "pulses.frequency = { from = 0.5, to = 2.5, count = 3 }\npulses.amplitude = { from = 0, to = 90, count = 2 }\n"
    )
    given = {"natural_frequency": "2.5 Hz", "effective_height": "6.01 m", "height": "4.77 m"}
    plain = study_of(tmp_path, BLOCK, analysis=pulses)
    for method in ("srss", "modal-filter"):
        found = run_envelopes(study_of(tmp_path, BLOCK + amplification(method, **given), analysis=pulses)).mechanisms[0]
        below = run_envelopes(plain).mechanisms[0].envelope.lower_bound_g
        factor = pulse_factor(METHODS[method](FirstMode(2.5, 6.01), 4.77), [0.5, 1.5, 2.5])
        np.testing.assert_allclose(found.envelope.factor, factor, rtol=1e-12)
        np.testing.assert_allclose(found.envelope.lower_bound_g, below / factor, rtol=0.011)  # a step of the scan
