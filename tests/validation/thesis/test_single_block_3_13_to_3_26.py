"""Thesis eqs. 3.13-3.26: the single block, plain and with added masses and forces.

Two of the printed constants are not exact, and the program's differ from them:
3.21 leaves the horizontal inertia of masses that are not bearing out of I, though 3.23 has them in B;
3.23 is M_c* R_c*, where the generalised excitation at phi_cr = alpha_c is M_c* R_c* cos(alpha_c* - alpha_c).
"""

from __future__ import annotations

from math import atan2, cos, hypot, pi, sin, sqrt, tan

import numpy as np
import pytest
from scipy.constants import g

from assess.geometry.planar import planar_body_from_values
from assess.loads.load import Force, PointMass
from assess.mechanisms.branch_table import rigid_branch
from assess.mechanisms.chain import Chain, RigidBlock, virtual_work
from assess.mechanisms.single_block import single_block
from assess.oscillator import multiplier
from tests.support.projects import block, mechanism_of, project_toml

TABLE = 1e-8  # K is the slope of the branch's table


def test_plain_block_3_13_to_3_16_for_a_spire_given_as_a_mesh(tmp_path):
    """Closed forms of a pyramid: centroid at h/4, M R^2 (2 + cos(2 pi/n)) / 20 + 3 M h^2 / 80 about it."""
    n, radius, height = 8, 1.5, 9.0
    corners = [(radius * cos(pi * (2 * k + 1) / n), radius * sin(pi * (2 * k + 1) / n)) for k in range(n)]
    mesh = [f"v {1000 * x!r} {1000 * y!r} 2000" for x, y in corners]
    mesh += ["v 0 0 2000", f"v 0 0 {1000 * (2.0 + height)!r}"]
    for k, following in zip(range(1, n + 1), (*range(2, n + 1), 1), strict=True):
        mesh += [f"f {following} {k} {n + 1}", f"f {k} {following} {n + 2}"]
    (tmp_path / "spire.obj").write_text("\n".join(mesh) + "\n")
    body = {"material": "brick", "mesh": "spire.obj", "mesh_unit": "mm"}
    own = block("spire", direction=[1, 0, 0])
    text = project_toml(site=None, bodies={"spire": body}, mechanisms={"spire": own})
    mechanism = mechanism_of(tmp_path, text)
    edge = radius * cos(pi / n)
    M = 1800 * height / 3 * n / 2 * radius**2 * sin(2 * pi / n)
    R, alpha = hypot(edge, height / 4), atan2(edge, height / 4)
    I_O = M * (radius**2 * (2 + cos(2 * pi / n)) / 20 + 3 * height**2 / 80 + R**2)
    form, mass = mechanism.oscillator.positive.linearised, mechanism.oscillator.mass
    assert mass == pytest.approx(M, rel=1e-12)
    assert form.inertia == pytest.approx(I_O, rel=1e-12)  # 3.13
    assert form.stiffness == pytest.approx(g * M * R, rel=TABLE)  # 3.14
    assert form.excitation == pytest.approx(M * R, rel=TABLE)  # 3.15
    assert (form.critical, form.overturning) == pytest.approx((alpha, alpha), rel=1e-12)  # 3.16
    assert form.p == pytest.approx(sqrt(g * M * R / I_O), rel=TABLE)  # 3.10
    assert form.multiplier == pytest.approx(alpha, rel=TABLE)  # 3.11, where statics gives tan(alpha)
    assert multiplier(mechanism.oscillator.positive)[0] == pytest.approx(tan(alpha), rel=1e-12)


# A wall of 4.75 t, a floor and a beam that it bears, a roof of 0.4 t at 4.8 m that rests elsewhere, two thrusts.
T, H, M = 0.5, 5.0, 4750.0
WALL = RigidBlock(M, (0.0, H / 2), M * (T**2 + H**2) / 12)
HINGE = (T / 2, 0.0)
FLOOR, BEAM = PointMass("floor", 650.0, (0.1, 4.7), True), PointMass("beam", 400.0, (-0.12, 4.6), True)
ROOF = PointMass("roof", 400.0, (-0.023, 4.8), False)
THRUSTS = (Force("vault", (900.0, 0.0), (-0.25, 3.0)), Force("roof thrust", (500.0, 0.0), (-0.2, 4.6)))


def polar(*points):
    """Total of masses or forces at points, and distance and angle from hinge O of their centre."""
    total = sum(size for size, _ in points)
    x, z = (sum(size * at[i] for size, at in points) / total for i in (0, 1))
    return total, hypot(HINGE[0] - x, z - HINGE[1]), atan2(HINGE[0] - x, z - HINGE[1])


OWN = (M, WALL.centroid)
M_C, R_C, ALPHA_C = polar(OWN, (FLOOR.mass, FLOOR.at), (BEAM.mass, BEAM.at))
M_ALL, R_ALL, ALPHA_ALL = polar(OWN, (FLOOR.mass, FLOOR.at), (BEAM.mass, BEAM.at), (ROOF.mass, ROOF.at))
F, R_F, ALPHA_F = polar(*((thrust.force[0], thrust.at) for thrust in THRUSTS))
CHAIN = Chain((WALL,), (HINGE,), (FLOOR, BEAM, ROOF, *THRUSTS))
BEARING = sum(load.mass * polar((1.0, load.at))[1] ** 2 for load in (FLOOR, BEAM))
I_PRINTED = WALL.inertia + M * hypot(T / 2, H / 2) ** 2 + BEARING


def test_constants_3_22_and_3_24_to_3_26_with_several_masses_and_thrusts():
    form = rigid_branch(CHAIN, restitution=0.9, name="w").linearised
    K = g * M_C * R_C + F * R_F * sin(ALPHA_F - ALPHA_C)
    moment = F * R_F * cos(ALPHA_F - ALPHA_C)
    assert form.stiffness == pytest.approx(K, rel=TABLE)  # 3.22
    assert form.moment == pytest.approx(moment, rel=TABLE)  # 3.24
    assert form.critical == pytest.approx(ALPHA_C, rel=1e-12)  # 3.25
    assert form.overturning == pytest.approx(ALPHA_C - moment / K, rel=TABLE)  # 3.26


def test_linear_overturning_rotation_3_26_beside_the_exact_one():
    """The zero of the whole restoring moment is a little farther: 3.26 is one step of Newton from alpha_c."""
    exact, form = (
        rigid_branch(CHAIN, restitution=0.9, name="w"),
        rigid_branch(CHAIN, restitution=0.9, name="w").linearised,
    )
    phi = exact.overturning
    moments = M_C * g * R_C * sin(ALPHA_C - phi), F * R_F * cos(ALPHA_F - phi)
    assert moments[0] == pytest.approx(moments[1], rel=1e-9)
    assert 1e-5 < phi / form.overturning - 1 < 1e-3


def test_horizontal_thrusts_act_as_their_resultant_at_their_weighted_mean():
    x, z = HINGE[0] - R_F * sin(ALPHA_F), R_F * cos(ALPHA_F)
    one = Chain((WALL,), (HINGE,), (FLOOR, BEAM, ROOF, Force("resultant", (F, 0.0), (x, z))))
    phi = np.linspace(0.0, 1.0, 11)
    np.testing.assert_allclose(virtual_work(one, phi).moment, virtual_work(CHAIN, phi).moment, rtol=1e-13)


def test_inertia_3_21_without_masses_that_do_not_bear():
    bearing = Chain((WALL,), (HINGE,), (FLOOR, BEAM))
    np.testing.assert_allclose(virtual_work(bearing, np.array([0.0, ALPHA_C])).inertia, I_PRINTED, rtol=1e-13)


def test_inertia_3_21_omits_the_mass_that_does_not_bear_by_15_percent():
    """400 kg at 4.8 m on 4.75 t: M_j x_j'^2 with x_j' = R_j cos(alpha_j - phi) is in I of the equation of motion."""
    own = virtual_work(CHAIN, np.array([ALPHA_C])).inertia[0]
    _, R_j, alpha_j = polar((1.0, ROOF.at))
    assert own == pytest.approx(I_PRINTED + ROOF.mass * (R_j * cos(alpha_j - ALPHA_C)) ** 2, rel=1e-13)
    assert own / I_PRINTED - 1 == pytest.approx(0.147, abs=5e-4)


def test_excitation_3_23_is_a_few_millionths_too_large():
    own = virtual_work(CHAIN, np.array([ALPHA_C])).excitation[0]
    assert own == pytest.approx(M_ALL * R_ALL * cos(ALPHA_ALL - ALPHA_C), rel=1e-13)
    assert M_ALL * R_ALL / own == pytest.approx(1.0000042, abs=2e-7)


def test_excitation_3_23_is_exact_without_masses_that_do_not_bear():
    own = virtual_work(Chain((WALL,), (HINGE,), (FLOOR, BEAM, *THRUSTS)), np.array([ALPHA_C]))
    assert own.excitation[0] == pytest.approx(M_C * R_C, rel=1e-13)
    assert abs(own.weight[0]) < 1e-12 * M_C * g * R_C  # 3.2: alpha_c is where the potential is greatest


def test_a_project_file_gives_the_same_constants(tmp_path):
    mechanism = mechanism_of(
        tmp_path,
        f"""
[materials.m]
density = 1900
[bodies.w]
material = "m"
box = {{ thickness = {T}, length = 1.0, height = {H} }}
[mechanisms.w]
kind = "single-block"
direction = [1, 0, 0]
blocks = ["w"]
loads = [
    {{ kind = "mass", mass = "650 kg", at = [0.1, 0.3, 4.7] }},
    {{ kind = "mass", mass = "400 kg", at = [-0.12, 4.6] }},
    {{ kind = "mass", mass = "0.4 t", at = ["-23 mm", 0, 4.8], bearing = false }},
    {{ kind = "force", force = ["0.9 kN", 0], at = [-0.25, 3.0] }},
    {{ kind = "force", force = "500 N", direction = [2, 0, 0], at = [-0.2, 4.6] }},
]
""",
    )
    ours, theirs = (each.linearised for each in (mechanism.oscillator.positive,
                                                 rigid_branch(CHAIN, restitution=0.9, name="w")))  # fmt: skip
    for name in ("inertia", "stiffness", "excitation", "moment", "critical"):
        assert getattr(ours, name) == pytest.approx(getattr(theirs, name), rel=1e-9)


def test_thrusts_overturn_one_way_and_hold_the_other():
    body = planar_body_from_values(mass=M, centroid=WALL.centroid, inertia=WALL.inertia, name="w")
    mechanism = single_block("w", body, hinge=HINGE, hinge_negative=(-T / 2, 0.0), loads=THRUSTS)
    rocker = mechanism.oscillator
    moment = sum(thrust.force[0] * thrust.at[1] for thrust in THRUSTS)
    for side, sign in ((rocker.positive, 1.0), (rocker.negative, -1.0)):
        assert side.restoring[0] == pytest.approx(M * g * T / 2 - sign * moment, rel=1e-12)
