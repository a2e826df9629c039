"""Sensitivity: closed forms, invariants, and that a case is the project with that number in it."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import trimesh
from scipy.constants import g

from assess.errors import ProjectError
from assess.project.project_file import json_schema, load
from assess.results import ResolvedValue, Results, SensitivityResult
from assess.results.json import dumps, loads
from assess.study.run import run_study
from assess.study.study import UnvariedNumber, Variable
from tests.support.motions import write_noise
from tests.support.projects import project_toml, study_of, wall

PROJECT = project_toml(
    materials={"stone": {"density": 2000}},
    bodies={"wall": wall(length=4.0, height=4.5, material="stone")},
    mechanisms={"wall": {"kind": "single-block", "direction": [1, 0, 0], "blocks": ["wall"]}},
    records={"files": ["a.csv"]},
    analysis={"levels": ["0.1 g", "0.25 g"], "procedures": ["asce43-05-spectrum", "dmi2008-linear"]},
)
RATIO, CAPACITY = "demand_capacity", "capacity_pga_g"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    write_noise(tmp_path / "a.csv", duration=8.0)
    return tmp_path


def with_sensitivity(table: str, *, project: str = PROJECT) -> str:
    return f"{project}sensitivity = {table}\n"


def rows_of(results: Results, parameter: str, quantity: str, procedure: str) -> list[SensitivityResult]:
    wanted = (parameter, quantity, procedure)
    return [row for row in results.sensitivity if (row.parameter, row.quantity, row.procedure) == wanted]


def only(table: str, **shares: object) -> str:
    """A table with all parameters left out but those of `table`."""
    names = ("thickness", "density", "restitution", "stiffness", "compressive_strength", "tie_force", "loads")
    given = table.strip("{} ")
    off = ", ".join(f"{name} = false" for name in names if f"{name} =" not in given)
    return f"{{ {given}{', ' if given else ''}{off} }}"


def test_without_the_table_nothing_is_varied(folder: Path) -> None:
    assert study_of(folder, PROJECT).variables == ()
    assert study_of(folder, with_sensitivity("false")).variables == ()
    assert run_study(study_of(folder, PROJECT)).sensitivity == ()


def test_capacity_of_a_plain_block_is_proportional_to_thickness_and_free_of_density(folder: Path) -> None:
    """The linear check compares with lambda = t / h, whatever the density: a closed form."""
    results = run_study(study_of(folder, with_sensitivity('{ thickness = "3 cm", density = 0.2 }')))
    (thick,) = rows_of(results, "thickness", CAPACITY, "dmi2008-linear")
    assert (thick.unit, thick.base, thick.level_pga_g) == ("m", pytest.approx(0.6, rel=1e-12), None)
    assert thick.at_base is not None
    np.testing.assert_allclose([thick.low, thick.high], [0.57, 0.63], rtol=1e-12)  # type: ignore[list-item]
    np.testing.assert_allclose(
        np.array([thick.at_low, thick.at_high]) / thick.at_base, [0.57 / 0.6, 0.63 / 0.6], rtol=1e-9
    )
    for procedure in ("asce43-05-spectrum", "dmi2008-linear"):
        (dense,) = rows_of(results, "density", CAPACITY, procedure)
        np.testing.assert_allclose([dense.at_low, dense.at_high], dense.at_base, rtol=1e-9)  # type: ignore[arg-type]
        (thick,) = rows_of(results, "thickness", CAPACITY, procedure)
        assert thick.at_low < thick.at_base < thick.at_high  # type: ignore[operator]
        for row in rows_of(results, "thickness", RATIO, procedure):
            assert row.at_low >= row.at_base >= row.at_high  # type: ignore[operator]
    assert [row.level_pga_g for row in rows_of(results, "density", RATIO, "dmi2008-linear")] == [0.1, 0.2, 0.25]


def test_what_decides_is_told_by_its_index(folder: Path) -> None:
    """Demand over capacity of the approximate method at the site's own PGA; without a basis there is none."""
    assert not rows_of(
        run_study(study_of(folder, with_sensitivity("true"))), "thickness", "index", "asce43-05-spectrum"
    )
    basis = '[verdict]\nbasis = "asce43-05"\nprocedures = ["asce43-05-spectrum"]\n[site]\nlimit_state = "DBE"\n'
    results = run_study(study_of(folder, with_sensitivity('{ thickness = "3 cm" }', project=basis + PROJECT)))
    (index,) = rows_of(results, "thickness", "index", "asce43-05-spectrum")
    ratio = next(row for row in rows_of(results, "thickness", RATIO, "asce43-05-spectrum") if row.role == "deciding")
    assert (index.index, index.level_pga_g) == ("D/C", 0.2)
    assert (index.at_base, index.at_low, index.at_high) == (ratio.at_base, ratio.at_low, ratio.at_high)
    assert results.verdict is not None
    assert results.verdict.mechanisms[0].answers[0].index.value == index.at_base  # type: ignore[union-attr]
    others = [row.role for row in results.sensitivity if row.procedure == "dmi2008-linear"]
    assert set(others) == {"comparison"}


def test_a_share_of_nothing_changes_nothing(folder: Path) -> None:
    """At share 0 both sides are the mechanism as assessed: to the last digit at keys, to rounding for the thickness."""
    project = PROJECT.replace('["asce43-05-spectrum", "dmi2008-linear"]', '["asce43-05-history", "dmi2008-linear"]')
    joint = 'blocks = ["wall"]\ninterface = { model = "flexible", stiffness = "1 GPa/m", strength = "1 MPa" }'
    results = run_study(
        study_of(folder, with_sensitivity("{ vary = 0 }", project=project.replace('blocks = ["wall"]', joint)))
    )
    found = {row.parameter for row in results.sensitivity}
    assert found == {"thickness", "density", "compressive_strength", "stiffness", "restitution"}
    for row in results.sensitivity:
        assert row.low == row.high == row.base
        rtol = 1e-9 if row.parameter == "thickness" else 0.0
        if row.at_base is None or (rtol and row.procedure.endswith("history")):  # histories amplify rounding
            continue
        np.testing.assert_allclose([row.at_low, row.at_high], row.at_base, rtol=rtol)  # type: ignore[arg-type]
        assert row.verdict_low == row.verdict_high == row.verdict_base


def test_a_tie_holds_in_proportion_to_its_force(folder: Path) -> None:
    """Moments about the edge: lambda = (W t/2 + F z) / (W h/2), F constant and horizontal at elevation z."""
    loads_ = 'loads = [{ kind = "tie", force = "20 kN", at = [0, 4], direction = [-1, 0] }]'
    tie = f'blocks = ["wall"]\nsides = "one"\n{loads_}'
    results = run_study(
        study_of(
            folder, with_sensitivity(only("{ tie_force = 0.25 }"), project=PROJECT.replace('blocks = ["wall"]', tie))
        )
    )
    (row,) = rows_of(results, "tie_force", CAPACITY, "dmi2008-linear")
    assert (row.key, row.unit, row.base) == ("mechanisms.wall.loads[1].force", "N", 20e3)
    weight = 2000 * 0.6 * 4.0 * 4.5 * g
    held = weight * 0.3 + np.array([15e3, 20e3, 25e3]) * 4.0
    np.testing.assert_allclose([row.at_low, row.at_base, row.at_high], held / held[1] * row.at_base, rtol=1e-9)  # type: ignore[operator, arg-type]


def test_a_case_is_the_project_with_that_number(folder: Path) -> None:
    project = PROJECT.replace('["asce43-05-spectrum", "dmi2008-linear"]', '["asce43-05-history", "dmi2008-linear"]')
    results = run_study(study_of(folder, with_sensitivity("{ thickness = 0.1, restitution = 0.02 }", project=project)))
    thick = run_study(study_of(folder, project.replace("thickness = 0.6", "thickness = 0.66")))
    row = rows_of(results, "thickness", RATIO, "dmi2008-linear")[-1]
    assert row.at_high == pytest.approx(thick.mechanisms[0].checks[-1].ratio, rel=1e-9)
    row = rows_of(results, "restitution", RATIO, "asce43-05-history")[-1]
    lossy = run_study(
        study_of(folder, project.replace('blocks = ["wall"]', f'blocks = ["wall"]\nrestitution = {row.low!r}'))
    )
    assert row.at_low == next(c for c in lossy.mechanisms[0].checks[::-1] if c.procedure == row.procedure).ratio
    assert rows_of(results, "restitution", CAPACITY, "asce43-05-history") == []  # no scan


def test_a_mesh_is_made_thicker_as_a_box_is(folder: Path) -> None:
    wall = trimesh.creation.box(extents=(0.6, 4.0, 4.5))
    wall.apply_translation((7.0, 0.0, 2.25))
    wall.export(folder / "wall.stl")
    mesh = PROJECT.replace("box = { thickness = 0.6, length = 4.0, height = 4.5 }", 'mesh = "wall.stl"')
    found = [
        run_study(study_of(folder, with_sensitivity(only("{ thickness = 0.05 }"), project=text)))
        for text in (PROJECT, mesh)
    ]
    for one, other in zip(*(results.sensitivity for results in found), strict=True):
        wanted = (one.low, one.high, one.at_low, one.at_base, one.at_high)
        np.testing.assert_allclose(
            (other.low, other.high, other.at_low, other.at_base, other.at_high),
            wanted,
            rtol=1e-5,
        )  # type: ignore[arg-type] # single precision of STL


def test_a_cut_is_thickened_about_its_own_middle(folder: Path) -> None:
    profile = "profile = [[0, 0], [1.2, 0], [0.6, 4.5], [0, 4.5]]\nlength = 4.0"
    text = PROJECT.replace("box = { thickness = 0.6, length = 4.0, height = 4.5 }", profile)
    text = text.replace('blocks = ["wall"]', 'blocks = ["wall"]\ncut = 1.5')
    (variable,) = study_of(folder, with_sensitivity(only("{ thickness = 0.1 }"), project=text)).variables
    assert isinstance(variable, Variable)
    assert variable.base == pytest.approx(1.0, rel=1e-9)  # half-way up a third of the taper
    (mechanism,) = variable.study_at(variable.high).mechanisms
    assert mechanism.negative is not None
    edges = -mechanism.negative.hinges[0][0], mechanism.positive.hinges[0][0]
    np.testing.assert_allclose(edges, (0.5 - 0.55, 0.5 + 0.55), rtol=0.0, atol=1e-9)


def test_where_joints_and_loads_stand_their_keys_are_varied(folder: Path) -> None:
    table = (
        'blocks = ["wall"]\n'
        'interface = { model = "flexible", course_thickness = 0.3 }\n'
        'loads = [{ kind = "mass", mass = 500, at = [0, 0, 4] }, { kind = "force", force = [-100, 0], at = [0, 4] }]'
    )
    stone = 'density = 2000\nyoung_modulus = "1 GPa"\ncompressive_strength = "2 MPa"\nfriction = 0.6'
    text = PROJECT.replace('blocks = ["wall"]', table).replace("density = 2000", stone)
    found = {each.parameter: each.key for each in study_of(folder, with_sensitivity("true", project=text)).variables}  # type: ignore[union-attr]
    assert found == {
        "thickness": "thickness of wall",
        "density": "materials.stone.density",
        "compressive_strength": "materials.stone.compressive_strength",
        "stiffness": "materials.stone.young_modulus",
        "friction": "materials.stone.friction",
        "loads": "mechanisms.wall.loads[2].force[1]",
        "restitution": "mechanisms.wall.restitution",
    }
    inner = text.replace("course_thickness = 0.3", 'stiffness = "1 GPa/m", strength = "1 MPa"')
    keys = [
        each.key
        for each in study_of(folder, with_sensitivity("true", project=inner)).variables
        if isinstance(each, Variable)
    ]
    assert "mechanisms.wall.interface.stiffness" in keys
    assert "mechanisms.wall.interface.strength" in keys


def test_an_equivalent_block_has_its_own_parameters(folder: Path) -> None:
    block = (
        '[mechanisms.published]\nkind = "equivalent-block"\np = 1.6\nuplift = 0.14\nradius = 2.84\nrestitution = 0.97\n'
    )
    text = PROJECT.replace("[records]", f"{block}[records]")
    results = run_study(study_of(folder, with_sensitivity("{ vary = 0.1 }", project=text)))
    own = [row for row in results.sensitivity if row.mechanism == "published"]
    assert {row.parameter for row in own} == {"uplift", "p", "restitution"}
    (row,) = (
        each
        for each in own
        if (each.parameter, each.quantity, each.procedure) == ("uplift", CAPACITY, "dmi2008-linear")
    )
    np.testing.assert_allclose(
        [row.at_low, row.at_high], np.tan([0.126, 0.154]) / np.tan(0.14) * row.at_base, rtol=1e-9
    )  # type: ignore[operator, arg-type]
    row = next(each for each in own if each.parameter == "restitution")
    assert (row.low, row.high) == (pytest.approx(0.873), 1.0)
    assert "at most 1" in row.remark


def test_what_cannot_be_varied_says_why(folder: Path) -> None:
    wall = 'blocks = ["wall"]'
    direct = "mass = 1000\ncentroid = [0, 2]\ninertia = 2000"
    solid = 'material = "stone"\nbox = { thickness = 0.6, length = 4.0, height = 4.5 }'
    hinged = f"{wall}\nhinges = {{ A = [0.2, 0] }}\nhinges_negative = {{ A = [-0.2, 0] }}"
    shape = f'{wall}\ninterface = {{ model = "flexible", stiffness = 1e9, shape = {{ rectangle = [0.6, 4.0] }} }}'
    sweep = '[analysis.sweep]\nkey = "bodies.wall.box.height"\nvalues = [4, 5]\n'
    for text, why in (
        (PROJECT.replace(wall, f"{wall}\nhinges = {{ A = [0.2, 0] }}"), "given as points"),
        (PROJECT.replace(solid, direct).replace(wall, hinged), "no geometry"),
        (PROJECT.replace(wall, shape), "by its sizes"),
    ):
        variables = study_of(folder, with_sensitivity("true", project=text)).variables
        assert why in next(each.why for each in variables if each.parameter == "thickness")
    (none,) = study_of(folder, with_sensitivity("true"), sweep).variables
    assert "parametric study" in none.why
    results = run_study(study_of(folder, with_sensitivity("true") + sweep))
    assert [(row.quantity, row.base, row.procedure) for row in results.sensitivity] == [("", None, "")]
    assert results.sensitivity[0].remark.startswith("not varied: a parametric study")
    (large,) = study_of(folder, with_sensitivity(only('{ thickness = "1 m" }'))).variables
    assert isinstance(large, UnvariedNumber)
    assert "leaves nothing" in large.why


def test_a_case_that_cannot_be_assessed_is_told_and_the_others_stand(folder: Path) -> None:
    """A thrust that a wall a tenth lighter does not hold: already falling."""
    weight = 2000 * 0.6 * 4.0 * 4.5 * g
    thrust = 0.95 * weight * 0.3 / 4.0
    loads_ = f'blocks = ["wall"]\nsides = "one"\nloads = [{{ kind = "force", force = [{thrust}, 0], at = [0, 4] }}]'
    text = with_sensitivity(only("{ density = 0.1 }"), project=PROJECT.replace('blocks = ["wall"]', loads_))
    rows = run_study(study_of(folder, text)).sensitivity
    assert {row.verdict_low for row in rows} == {None}
    assert all("not assessed at the low value, 1800: " in row.remark and "\n" not in row.remark for row in rows)
    assert all(row.at_high is not None for row in rows if row.quantity == CAPACITY)


def test_a_sought_direction_is_kept(folder: Path) -> None:
    swept, plain = PROJECT.replace("direction = [1, 0, 0]", 'direction = "sweep"'), PROJECT
    found = [
        run_study(study_of(folder, with_sensitivity(only("{ thickness = 0.05 }"), project=text)))
        for text in (swept, plain)
    ]
    assert found[0].mechanisms[0].direction_sweep is not None
    assert found[0].sensitivity == found[1].sensitivity


def test_the_bytes_do_not_depend_on_jobs_and_are_read_back(folder: Path) -> None:
    study = study_of(folder, with_sensitivity("{ thickness = 0.05, restitution = 0.02 }"))
    stages: list[tuple[str, int, int]] = []
    one, two = (run_study(study, jobs=n, progress=lambda *stage: stages.append(stage)) for n in (1, 2))
    assert dumps(one) == dumps(two)
    assert loads(dumps(one)).sensitivity == one.sensitivity
    assert ("sensitivity", 0, 3) in stages
    plain = run_study(study_of(folder, PROJECT))
    assert plain.stamp != one.stamp
    assert replace(one, sensitivity=()) == replace(plain, project=one.project, inputs=one.inputs, stamp=one.stamp)


@pytest.mark.parametrize(
    ("table", "told"),
    [
        ("{ thicknes = 0.1 }", 'sensitivity.thicknes: 0.1: unknown key; did you mean "thickness"?'),
        ("{ vary = 1.5 }", "sensitivity.vary: 1.5: must be less than 1"),
        ("{ density = -0.1 }", "sensitivity.density: -0.1: must be 0 or more"),
        ('{ thickness = "2 kg" }', 'sensitivity.thickness: "2 kg": not a change; write a share like 0.05'),
        (
            '{ stiffness = "2 m" }',
            'sensitivity.stiffness: "2 m": not a change; write a share like 0.05 or "5 %", or false',
        ),
        ("{ loads = 1.0 }", "sensitivity.loads: 1.0: must be less than 1"),
        ("3", "sensitivity: 3: not a table"),
    ],
)
def test_what_is_wrong_in_the_table_is_one_line(folder: Path, table: str, told: str) -> None:
    (folder / "project.toml").write_text(with_sensitivity(table))
    with pytest.raises(ProjectError) as caught:
        load(folder)
    assert told.replace("sensitivity", "analysis.sensitivity", 1) in str(caught.value)
    assert "\n" not in str(caught.value)


def test_the_changes_stand_among_the_values_of_the_project(folder: Path) -> None:
    study = study_of(folder, with_sensitivity('{ vary = 0.2, thickness = "2 cm", density = false }'))
    found = {key: each for key, each in study.resolved.items() if key.startswith("analysis.sensitivity.")}
    assert found["analysis.sensitivity.thickness"] == ResolvedValue([0.02, "m"], True)
    assert found["analysis.sensitivity.density"] == ResolvedValue(None, True)
    assert found["analysis.sensitivity.friction"] == ResolvedValue([0.2, "share"], False)
    percent = study_of(folder, with_sensitivity('{ thickness = "2 %" }')).resolved
    assert percent["analysis.sensitivity.thickness"].value == [0.02, "share"]


def test_the_schema_knows_the_table() -> None:
    schema = json_schema()
    assert {"$ref": "#/$defs/Sensitivity"} in schema["$defs"]["Analysis"]["properties"]["sensitivity"]["anyOf"]
    assert "thickness" in schema["$defs"]["Sensitivity"]["properties"]


def test_a_case_that_the_floor_governs_stands_beside_one_that_the_ground_governs(folder: Path) -> None:
    """DM 2008 at 4 m: with 19 kN of a strut the floor demands more than the ground, with 10 kN it does not."""
    strut = '{ kind = "force", force = "10 kN", at = [0, 8], direction = [-1, 0], until = "collapse" }'
    text = PROJECT.replace("height = 4.5 }", "height = 4.5, base = [0, 0, 4] }").replace(
        'blocks = ["wall"]', f'blocks = ["wall"]\nsides = "one"\nloads = [{strut}]'
    )
    text = text.replace('["asce43-05-spectrum", "dmi2008-linear"]', '["dmi2008-nonlinear"]')
    sources = '[report.sources]\n"mechanisms.wall.loads[1]" = "measured: it stays"'
    text = f"{sources}\n[building]\nheight = 8\nstoreys = 2\nperiod = 0.62\n{text}"
    ends = [
        run_study(study_of(folder, text.replace("10 kN", force))).mechanisms[0].checks[-1]
        for force in ("10 kN", "19 kN")
    ]
    assert [check.input_at for check in ends] == ["ground", "mechanism base"]
    results = run_study(study_of(folder, with_sensitivity(only("{ loads = 0.9 }"), project=text)))
    row = rows_of(results, "loads", RATIO, "dmi2008-nonlinear")[-1]
    assert (row.at_base, row.at_high) == tuple(pytest.approx(check.ratio, rel=1e-9) for check in ends)
