"""Calculation sheets of contacts: each line redone, and its numbers against closed forms and quadrature."""

from __future__ import annotations

from math import pi, sin, sqrt
from pathlib import Path

import pytest
from scipy.constants import g
from scipy.integrate import quad

from assess.codes.calculation_sheet import Step, substitute
from assess.interfaces.section import annulus, hollow_rectangle, rectangle, stress_integrals
from tests.languages.fixed_terms import fixed_terms
from tests.support.projects import parameters_of
from tests.support.sheet_faults import of_formula
from tests.unit.assess.model.test_joints import ARCH, LEGS, SINGLE, STONE

W, B, L = 1800 * 12 * g, 1.0, 2.0  # N, m, m: of the wall of STONE
SHAPES = {
    "rectangle": "",
    "hollow": "shape = { hollow_rectangle = [1, 2, 0.6, 1.4] }",
    "circle": "shape = { circle = 1 }",
    "annulus": "shape = { annulus = [1, 0.6] }",
    "trapezium": "shape = { polygon = [[-0.5, -1], [0.5, -0.4], [0.5, 0.4], [-0.5, 1]] }",
}


def joint(model: str = "flexible", *, stiffness: str = "0.2 GPa/m", strength: str = "1.5 MPa", shape: str = "") -> str:
    parts = [f'model = "{model}"', f'strength = "{strength}"' if strength else "", SHAPES.get(shape, "")]
    parts += [f'stiffness = "{stiffness}"'] if model != "rigid" else []
    return f"interface = {{ {', '.join(part for part in parts if part)} }}\n"


def sheet(folder: Path, lines: str, *, text: str = STONE + SINGLE, hinge: str = "A") -> dict[str, Step]:
    """The lines of one joint by their symbols."""
    (found,) = (each for each in parameters_of(folder, text + lines).contact_sheets if each.hinge == hinge)
    return {step.symbol: step for step in found.steps}


# ----------------------------------------------------------------------------------------------- every line, redone


CASES = [
    *((STONE + SINGLE, joint(shape=shape, stiffness=k, strength=f))
      for shape in SHAPES for k, f in (("0.2 GPa/m", "1.5 MPa"), ("50 GPa/m", "0.5 MPa"))),
    (STONE + SINGLE, joint(strength="0.15 MPa")),
    (STONE + SINGLE, joint(strength="0.25 MPa", shape="hollow")),
    (STONE + SINGLE, joint("rigid")),
    (STONE + SINGLE, joint("rigid", shape="circle")),
    (STONE + LEGS, joint("semi-flexible")),
    (STONE + LEGS, joint(strength="0.15 MPa")),
    (ARCH, joint(stiffness="5 GPa/m")),
]  # fmt: skip


@pytest.fixture(scope="module", params=CASES)
def sheets(request, tmp_path_factory):
    """The contact sheets of a case."""
    text, lines = request.param
    return parameters_of(tmp_path_factory.mktemp("case"), text + lines).contact_sheets


def test_every_line_comes_out_again_from_its_printed_digits(sheets):
    assert sheets
    wrong = [(each.hinge, step.symbol, fault) for each in sheets for step in each.steps if step.inputs
             for fault in of_formula(step)]  # fmt: skip
    assert not wrong
    assert {step.symbol for each in sheets for step in each.steps if step.value is None} == set()
    balances = [step for each in sheets for step in each.steps if "check of equilibrium" in step.description]
    assert len(balances) >= len(sheets)
    assert [step.value for step in balances] == pytest.approx([1.0] * len(balances), rel=1e-9)


def test_its_words_are_found_in_the_source(sheets):
    steps = [step for each in sheets for step in each.steps]
    said = {part for step in steps for part in (step.description, step.clause, step.remark)}
    said |= {step.formula for step in steps if not step.inputs}
    assert said - {""} <= set(fixed_terms())


# ------------------------------------------------------------------------------------------------------ closed forms


def test_a_rectangle_is_that_of_the_thesis(tmp_path):
    """Thesis 6.2 to 6.7 by hand."""
    found, k, f = sheet(tmp_path, joint()), 0.2e9, 1.5e6
    assert found["N"].value == pytest.approx(W, rel=1e-12)
    assert found["σ_0"].value == pytest.approx(W / (B * L), rel=1e-12)
    assert found["φ_o"].value == pytest.approx(2 * W / (k * L * B**2), rel=1e-12)
    assert found["φ_c"].value == pytest.approx(f**2 * L / (2 * k * W), rel=1e-9)
    assert found["a_SF"].value == pytest.approx(2 * W / (3 * f * L), rel=1e-9)
    largest, fallen = (sin(found[symbol].value) for symbol in ("ψ_m", "ψ_u"))
    assert found["a_fm"].value == pytest.approx(sqrt(2 * W / (k * L * largest)) / 3, rel=1e-9)
    crushed = (W / (f * L) + f**3 * L / (12 * W * k**2 * fallen**2)) / 2
    assert found["a_fu"].value == pytest.approx(crushed, rel=1e-9)


def test_more_than_half_of_what_it_bears_crushes_before_it_opens(tmp_path):
    found, k, f = sheet(tmp_path, joint(strength="0.15 MPa")), 0.2e9, 0.15e6
    assert found["φ_c"].value == pytest.approx(2 * (f - W / (B * L)) / (k * B), rel=1e-9)
    assert found["φ_o"].value == pytest.approx(f / (2 * k * (B - W / (f * L))), rel=1e-9)
    far = 2 * W / (B * L) - f
    assert found["a_SF"].value == pytest.approx(B * (f + 2 * far) / (3 * (f + far)), rel=1e-9)


def test_a_joint_without_limit_of_strength_keeps_its_hinge_at_the_edge(tmp_path):
    text = (STONE + SINGLE).replace('compressive_strength = "1.5 MPa"\n', "")
    found = sheet(tmp_path, joint(strength=""), text=text)
    assert found["a_SF"].value == 0.0
    assert "φ_c" not in found


def test_a_rigid_joint_with_a_strength_has_a_plastic_block(tmp_path):
    found = sheet(tmp_path, joint("rigid"))
    assert found["a_2p"].value == pytest.approx(W / (1.5e6 * L), rel=1e-9)
    assert found["a_fp"].value == pytest.approx(W / (2 * 1.5e6 * L), rel=1e-9)
    assert not {"φ_o", "a_SF", "φ_u"} & found.keys()  # its force does not change


@pytest.mark.parametrize("inner", [0.0, 0.6])
def test_a_circle_by_quadrature(tmp_path, inner):
    found, k, f = sheet(tmp_path, joint(shape="annulus" if inner else "circle")), 0.2e9, 1.5e6

    def width(x: float) -> float:
        hole = (inner / 2) ** 2 - (0.5 - x) ** 2
        return 2 * sqrt(x * (1 - x)) - 2 * sqrt(max(hole, 0.0))

    def integral(power: int, stress, end: float) -> float:
        edges = [x for x in (0.5 - inner / 2, 0.5 + inner / 2) if 0 < x < end]
        return quad(lambda x: stress(x) * width(x) * x**power, 0, end, points=edges, epsabs=1e-6, limit=400)[0]

    a, slope, a_u = (found[name].value for name in ("a_c", "s_u", "a_u"))
    assert found["A"].value == pytest.approx(pi * (1 - inner**2) / 4, rel=1e-12)
    first = [integral(power, lambda x: f * (1 - x / a), a) for power in (0, 1)]
    assert first[0] == pytest.approx(W, rel=1e-6)
    assert found["a_SF"].value == pytest.approx(first[1] / first[0], rel=1e-6)
    last = [integral(power, lambda x: min(f, k * slope * (a_u - x)), a_u) for power in (0, 1)]
    assert last[0] == pytest.approx(W, rel=1e-6)
    assert found["a_fu"].value == pytest.approx(last[1] / last[0], rel=1e-6)


def test_the_force_of_a_portal_is_worked_by_moments(tmp_path):
    """Its beam of 5.2 m x 1 m x 0.7 m rests half on each column, at B and C."""
    beam, column = 1800 * 5.2 * 0.7 * g, 1800 * 0.6 * 3 * g
    mechanism = parameters_of(tmp_path, STONE + LEGS + joint())
    forces = {each.hinge: {step.symbol: step.value for step in each.steps} for each in mechanism.contact_sheets}
    assert [forces[hinge]["N"] for hinge in "ABCD"] == pytest.approx(
        [column + beam / 2, beam / 2, beam / 2, column + beam / 2], rel=1e-9
    )
    assert forces["A"]["M_2"] == pytest.approx(beam * 2.3, rel=1e-9)
    assert [forces[hinge]["V_C"] for hinge in "BC"] == pytest.approx([-beam / 2, beam / 2], rel=1e-9)


def test_an_arch_presses_square_to_its_inclined_joints(tmp_path):
    """Without horizontal loads the thrust is the same in all joints; A and D carry the whole weight."""
    mechanism = parameters_of(tmp_path, ARCH + joint(stiffness="5 GPa/m"))
    lines = {each.hinge: {step.symbol: step for step in each.steps} for each in mechanism.contact_sheets}
    thrust = [abs(lines[hinge]["H"].value) for hinge in "ABCD"]
    assert thrust == pytest.approx([thrust[0]] * 4, rel=1e-9)
    assert lines["A"]["H"].formula.startswith("(M_2 (x_C − x_D) − M_3 (x_B − x_C)) / ")
    weight = sum(lines[hinge][f"W_{block}"].value for hinge, block in (("A", 1), ("A", 2), ("D", 3)))
    assert lines["A"]["V"].value + lines["D"]["V"].value == pytest.approx(weight, rel=1e-9)
    for each, interface in zip(mechanism.contact_sheets, mechanism.interfaces, strict=True):
        assert each.hinge == interface["hinge"]
        assert lines[each.hinge]["N"].value == pytest.approx(interface["normal_force_n"], rel=1e-9)


def test_loads_are_summed_under_their_own_names(tmp_path):
    lines = """loads = [
        { kind = "mass", mass = 2000, at = [0, 0, 5], bearing = true },
        { kind = "force", force = [100, -3000], at = [0, 0, 5] },
    ]
    """
    found = sheet(tmp_path, joint() + lines)
    assert found["N"].value == pytest.approx(W + 2000 * g + 3000, rel=1e-12)
    assert [found[part].value for part in ("P_1", "P_2")] == pytest.approx([2000 * g, 3000.0])
    assert [found[part].subject for part in ("P_1", "P_2")] == ["mass 1", "force 2"]


# --------------------------------------------------------------------------------------------------------- integrals


@pytest.mark.parametrize(
    "section",
    [
        rectangle(1.0, 2.0),
        hollow_rectangle(1.0, 2.0, inner=(0.6, 1.4)),
        hollow_rectangle(1.0, 2.0, inner=(0.6, 1.4), direction=(0.8, 0.6)),
        annulus(1.0, inner=0.6),
    ],
)
def test_a_uniform_stress_on_all_of_a_section_is_its_area_and_centroid(section):
    force, moment = stress_integrals(section, start=0.0, end=section.depth, stress=(2.0, 2.0))
    assert force == pytest.approx(2.0 * section.area, rel=1e-12)
    assert moment == pytest.approx(2.0 * section.area * section.centroid, rel=1e-12)


def test_an_outline_of_many_pieces_is_integrated_over_whole_zones(tmp_path):
    rounded = [[round(0.5 - 0.002 * i, 4), round(0.5 + 0.1 * sqrt(i), 4)] for i in range(12)]
    outline = [*rounded, [-0.5, 0.5], [-0.5, -0.5], [0.5, -0.5]]
    shape = f'interface = {{ model = "flexible", stiffness = "1 GPa/m", shape = {{ polygon = {outline} }} }}\n'
    found = sheet(tmp_path, shape)
    assert (found["A"].formula, found["R_c"].formula) == ("∫ w dx", "∫ σ w dx")
    assert found["R_c / N"].value == pytest.approx(1.0, rel=1e-9)
    assert found["R_u / N_u"].value == pytest.approx(1.0, rel=1e-9)


def test_powers_of_ten_are_multiplied_with_a_sign(tmp_path):
    step = sheet(tmp_path, joint())["σ_1m"]
    assert substitute(step.formula, step.inputs, lambda x: "2×10⁸").count("2×10⁸ · 2×10⁸") == 1
