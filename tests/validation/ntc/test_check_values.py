"""NTC 2018, Circolare 7/2019, C8.7.1.2: worked values of a wall at the ground, at height, and with a toothed crack.

Site of soil B, flat, V_R 50 years. FC 1.35, rigid joints, exact rotations. a_g,LS are on rock. Worked by hand and by an
independent program from the formulas of the circular; tolerance 0.5 %.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from math import pi, sqrt

import numpy as np
import pytest
from scipy.constants import g

from assess.codes import ntc2018
from assess.codes.context import Building, Context, SiteHazard, StatedFirstMode
from assess.codes.italian_limit_states import ItalianOptions
from assess.codes.ntc2018_clauses import floor_demand, ultimate_modes
from assess.codes.toothing import TOOTHING_LEVER, toothing_friction
from assess.errors import ProcedureError
from assess.geometry.planar import planar_body
from assess.geometry.solid import box
from assess.loads.load import Force
from assess.mechanisms.single_block import single_block
from assess.oscillator import multiplier
from spectra import ntc
from tests.support.answered import step_values
from tests.support.bodies import free_wall

TOLERANCE = 5e-3
ROWS = {"SLD": (0.104, 2.332, 0.281), "SLV": (0.261, 2.364, 0.347), "SLC": (0.334, 2.400, 0.364)}
CORNERS = [  # T_1', xi_1, a_Z, A, S_eZ(T_SLV), demand, its lower bound, a_g,SLV / g, zeta_E
    (0.42, 0.10, 4.98009, 3.05085, 1.60178, 0.157567, 0.082145, 0.198773, 0.7616),
    (0.56, 0.10, 4.19474, 3.05085, 2.03783, 0.200461, 0.123006, 0.156240, 0.5986),
    (0.42, 0.20, 4.07404, 2.15728, 1.51840, 0.149364, 0.047518, 0.209689, 0.8034),
    (0.56, 0.20, 3.43157, 2.15728, 1.86028, 0.182994, 0.071154, 0.171153, 0.6558),
]


@cache
def spectrum(state):
    a_g, f_0, t_c_star = ROWS[state]
    return ntc.elastic_spectrum(ntc.Hazard(a_g * g, f_0, t_c_star), place=ntc.SoilAndTopography("B"))


def site(**more):
    spectra = {state: spectrum(state) for state in ROWS}
    hazard = SiteHazard(spectra, (50.3, 474.6, 974.8), tuple(each.pga for each in spectra.values()))
    return Context(spectra["SLV"], (spectra["SLV"].pga,), 0.0, 0.0, None, hazard=hazard, **more)


def raised(modes=None, *, T1=0.28):
    """On z = 6 m of a building of 9 m and three storeys: gamma psi = 9/7 2/3."""
    return replace(site(), elevation=6.0, building=Building(9.0, 3, T1, 0.05, modes or {}))


def on_rock(check):
    return check.capacity_pga_g / spectrum(check.limit_state).parameters["s"]


def close(*values):
    return pytest.approx(values, rel=TOLERANCE)


def test_soil_factors():
    assert tuple(spectrum(state).parameters["s"] for state in ROWS) == close(1.2000, 1.1532, 1.0794)


def test_a_linear_at_the_ground():
    damage, life = ntc2018.assess_linear(free_wall(), site(), options=ItalianOptions(limit_states=("SLD", "SLV")))
    assert (damage.capacity, life.capacity) == close(0.72642, 0.72642)
    assert (damage.demand, on_rock(damage), damage.safety_index) == close(1.22387, 0.061728, 0.5935)
    assert (life.demand, on_rock(life), life.safety_index) == close(1.47583, 0.128467, 0.4922)


@pytest.mark.parametrize(
    ("state", "d", "a", "T", "demand", "ratio", "a_g", "zeta"),
    [
        ("SLV", 0.120, 0.43446, 2.7738, 0.19333, 1.6111, 0.16200, 0.6207),
        ("SLC", 0.180, 0.28936, 3.8654, 0.25251, 1.4028, 0.23810, 0.7129),
    ],
    ids=["SLV", "SLC"],
)
def test_b_nonlinear_at_the_ground(state, d, a, T, demand, ratio, a_g, zeta):
    (check,) = ntc2018.assess_nonlinear(free_wall(), site(), options=ItalianOptions(limit_states=(state,)))
    found = step_values(check)
    assert (found["d0*"], found[f"d_{state}"], found[f"a(d_{state})"], found[f"T_{state}"]) == close(0.300, d, a, T)
    assert (check.demand, check.ratio, on_rock(check), check.safety_index) == close(demand, ratio, a_g, zeta)
    assert check.verdict == "fail"


@pytest.mark.parametrize(("T1", "xi", "a_Z", "A", "S_eZ", "demand", "least", "a_g", "zeta"), CORNERS)
def test_c_nonlinear_at_height_of_each_corner(T1, xi, a_Z, A, S_eZ, demand, least, a_g, zeta):
    at = raised({"SLV": StatedFirstMode(T1, xi, "one corner of the range")})
    (check,) = ntc2018.assess_nonlinear(free_wall(height=3.0, base=6.0), at, options=ItalianOptions())
    found = step_values(check)
    assert (found["γψ"], found["T1'"]) == close(0.857143, T1)
    assert (found["a(d_SLV)"], found["T_SLV"]) == close(0.86075, 1.97065)
    assert (found["a_Z(T1')"], found["A"], found["S_eZ(T_SLV)"]) == close(a_Z, A, S_eZ)
    assert (check.demand, found["d(b T1', Z)"], on_rock(check), check.safety_index) == close(demand, least, a_g, zeta)


def test_c_the_softest_building_decides_and_20_per_cent_is_printed():
    (check,) = ntc2018.assess_nonlinear(free_wall(height=3.0, base=6.0), raised(), options=ItalianOptions())
    assert (step_values(check)["T1'"], check.demand, check.safety_index) == close(0.56, 0.200461, 0.5986)
    assert step_values(check)["d(20 %)"] == pytest.approx(0.182994, rel=TOLERANCE)


def test_c_of_an_elastic_building_the_ground_governs():
    """The floor's own spectrum is below the ground's, which C7.2.5 keeps: 0.8328."""
    at = raised({"SLV": StatedFirstMode(0.28, 0.05, "elastic")})
    (check,) = ntc2018.assess_nonlinear(free_wall(height=3.0, base=6.0), at, options=ItalianOptions())
    assert (check.demand, check.safety_index) == close(0.144095, 0.8328)


def test_a_peak_inside_the_range_asks_nine_per_cent_more_than_its_worst_corner():
    """T_1 0.6 s, T_LS 1.21 s at the top: the peak lies by T_1' = T_LS / 1.1 = 1.1 s, between the corners 0.9 and 1.2 s.

    All lie beyond T_C, so that S_e, and a_Z with it, goes as 1 / T_1'. At 1.1 s and at 1.2 s the mechanism is on the
    plateau A a_Z: the peak asks 1.2 / 1.1 times what that corner does. At 0.9 s it is beyond b T_1' = 0.99 s:
    1.2 / 0.9 / (1 + (A - 1) (1.21 / 0.99 - 1)^1.2) = 0.997 of it. The falling branch begins without a slope, so the
    very top lies a little below 1.1 s: at 1.088 s 1.1 / 1.088 / (1 + (A - 1) (1.21 / 1.1968 - 1)^1.2) = 1.002.
    """
    top = replace(raised(T1=0.6), elevation=9.0)
    found = floor_demand(top, ultimate_modes(top, "SLV"), T0=0.0, T=1.21, damping=0.08)
    ends = [replace(raised({"SLV": StatedFirstMode(T, 0.1, "corner")}), elevation=9.0) for T in (0.9, 1.2)]
    corners = [floor_demand(at, ultimate_modes(at, "SLV"), T0=0.0, T=1.21, damping=0.08).largest for at in ends]
    A = 1.1 / sqrt(0.1) * sqrt(10 / 13)

    def over_plateau(first):
        return 1.1 / first / (1 + (A - 1) * max(1.21 / (1.1 * first) - 1, 0.0) ** 1.2)

    peak = float(top.spectrum.acceleration(1.1, damping=0.1)) * 9 / 7 * sqrt(1 + 0.0004 * 10**2)
    best = max(over_plateau(first) for first in np.linspace(0.9, 1.2, 30001))
    assert found.first == pytest.approx(1.088, abs=1e-3)
    assert found.largest == pytest.approx(best * A * peak * (1.21 / (2 * pi)) ** 2, rel=1e-6)
    assert corners[0] / corners[1] == pytest.approx(over_plateau(0.9) / over_plateau(1.2), rel=1e-9)
    assert found.largest / max(corners) == pytest.approx(1.2 / 1.1, rel=3e-3)


def test_d_toothed_crack():
    F = toothing_friction(height=6.0, unit_height=0.25, overlap=0.15, thickness=0.5, unit_weight=19e3)
    assert pytest.approx(49.334e3, rel=TOLERANCE) == F
    body = box(thickness=0.5, length=5.0, height=6.0, base=(0, 0, 0), density=19e3 / g, name="wall")
    plain = planar_body(body, direction=(1, 0, 0))
    friction = Force("cross walls", (-2.0 * F, 0.0), (0.0, TOOTHING_LEVER * 6.0))
    alone, held = (
        float(multiplier(single_block("wall", plain, loads=loads, sides="one").oscillator.positive)[0])
        for loads in ((), (friction,))
    )
    assert (alone, held) == close(0.08333, 0.31414)


def test_a_toothed_crack_has_at_least_one_course():
    with pytest.raises(ProcedureError, match=r"C8\.7\.1\.2 needs at least one course"):
        toothing_friction(height=0.2, unit_height=0.25, overlap=0.15, thickness=0.5, unit_weight=19e3)
