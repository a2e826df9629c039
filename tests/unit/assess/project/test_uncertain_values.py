"""Numbers given as { mean, cov }: what may be, what is refused, and that whatever does not sample uses the mean."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from assess.errors import ProjectError
from assess.project.build import build
from assess.project.project_file import json_schema, resolve
from assess.study.run import run_study
from tests.support.projects import block, load_project, project_toml, wall

MEAN = {"mean": "0.60 m", "cov": 0.05}


def test_means_are_read_in_the_unit_of_the_key(tmp_path: Path) -> None:
    text = project_toml(
        building={"height": "9 m", "period": {"mean": "0.4 s", "cov": "20 %", "distribution": "uniform"}},
        materials={"brick": {"density": {"mean": "18 kN/m^3", "cov": 0.1}, "friction": {"mean": 0.5, "cov": 0.2}}},
        bodies={"wall": wall({**MEAN, "group": "walls"})},
        mechanisms={
            "wall": block(
                direction=[1, 0, 0],
                hinges={"A": [{"mean": "28 cm", "sd": "2 cm"}, 0]},
                restitution={"mean": 0.9, "cov": 0.03},
                interface={"model": "flexible", "stiffness": {"mean": "1 GPa/m", "cov": 0.4}},
                loads=[{"kind": "force", "force": ["8 kN", {"mean": "-3 kN", "cov": 0.2}], "at": [0, 2]}],
            )
        },
    )
    project = load_project(tmp_path, text)
    given = {value.given.key: value.given for value in project.uncertain}
    density, thickness = given["materials.brick.density"], given["bodies.wall.box.thickness"]
    assert (density.mean, density.unit) == (pytest.approx(18000 / 9.80665, rel=1e-12), "kg/m^3")
    assert (thickness.mean, thickness.cov, thickness.unit, thickness.group) == (0.6, 0.05, "m", "walls")
    assert (thickness.distribution, density.group) == ("lognormal", "materials.brick.density")
    hinge = given["mechanisms.wall.hinges.A[1]"]
    assert (hinge.mean, hinge.cov, hinge.distribution) == (0.28, pytest.approx(0.02 / 0.28, rel=1e-12), "normal")
    assert (given["building.period"].cov, given["building.period"].distribution) == (0.2, "uniform")
    force = given["mechanisms.wall.loads[1].force[2]"]
    assert (force.mean, force.unit) == (-3000.0, "N")
    assert given["mechanisms.wall.restitution"].mean == 0.9
    assert set(given) >= {"mechanisms.wall.interface.stiffness", "materials.brick.friction"}


def test_resolved_values_are_the_means_and_say_so(tmp_path: Path) -> None:
    loads = [{"kind": "mass", "mass": {"mean": "1 t", "cov": 0.2}, "at": [0, 3]}]
    tables = {
        "bodies": {"wall": wall(MEAN)},
        "mechanisms": {"wall": block(loads=loads, direction=[1, 0, 0], restitution={"mean": 0.9, "cov": 0.02})},
    }
    found = resolve(load_project(tmp_path, project_toml(**tables)))
    assert (found["bodies.wall.box.thickness"].value, found["bodies.wall.box.thickness"].cov) == (0.6, {"": 0.05})
    assert found["bodies.wall.box.height"].cov == {}
    assert (found["mechanisms.wall.loads"].value[0]["mass"], found["mechanisms.wall.loads"].cov) == (
        1000.0,
        {"0.mass": 0.2},
    )
    for side in ("positive", "negative"):
        assert (
            found[f"mechanisms.wall.restitution.{side}"].value,
            found[f"mechanisms.wall.restitution.{side}"].cov,
        ) == (
            0.9,
            {"": 0.02},
        )


def test_a_run_without_the_section_is_that_of_the_means(tmp_path: Path) -> None:
    ask = {
        "records": {"synthetic": {"count": 1, "duration": "8 s"}},
        "analysis": {"procedures": ["asce43-05-spectrum"]},
    }
    plain = run_study(build(load_project(tmp_path, project_toml(bodies={"wall": wall("0.60 m")}, **ask))))
    project = load_project(tmp_path, project_toml(bodies={"wall": wall(MEAN)}, **ask))
    found = run_study(build(project))
    assert found.uncertainty is None
    assert [each.checks for each in found.mechanisms] == [each.checks for each in plain.mechanisms]
    (told,) = [each for each in found.warnings if each.key == "uncertainty-means"]
    assert "bodies.wall.box.thickness" in told.text
    assert project.content == load_project(tmp_path, project_toml(bodies={"wall": wall("0.60 m")}, **ask)).content


@pytest.mark.parametrize(
    ("thickness", "said"),
    [
        ({"mean": "0.60 m"}, "bodies.wall.box.thickness.cov: give either cov"),
        ({"cov": 0.1}, "bodies.wall.box.thickness.mean: missing"),
        ({"mean": "0.60 m", "cov": 0.1, "sd": "2 cm"}, "thickness.cov: 0.1: give either cov"),
        ({"mean": "0.60 m", "cov": 0}, "thickness.cov: 0: must be greater than 0"),
        ({"mean": "0.60 m", "cov": 1}, "thickness.cov: 1: must be less than 1"),
        ({"mean": "0.60 m", "cov": -0.1}, "thickness.cov: -0.1: must be greater than 0"),
        ({"mean": "0.60 m", "cov": "much"}, 'thickness.cov: "much": '),
        ({"mean": "0.60 m", "cov": True}, "thickness.cov: true: not a number"),
        ({"mean": "0.60 m", "cov": float("nan")}, "not a finite number"),
        ({"mean": float("nan"), "cov": 0.1}, "not a finite number"),
        ({"mean": "0.60", "cov": 0.1}, "no unit"),
        ({"mean": "0.60 kg", "cov": 0.1}, '"kg" is not a unit of length'),
        ({"mean": [0.6], "cov": 0.1}, "thickness.mean: [0.6]: not a number or a quantity"),
        ({"mean": "-0.60 m", "cov": 0.1}, "must be greater than 0"),
        ({"mean": "0.60 m", "sd": "5 kg"}, '"kg" is not a unit of length'),
        ({"mean": "0.60 m", "sd": "-2 cm"}, "must be greater than 0"),
        ({"mean": "0.60 m", "sd": "70 cm"}, "must be less than the mean"),
        ({"mean": "0.60 m", "cov": 0.6, "distribution": "uniform"}, "its lower bound"),
        ({"mean": "0.60 m", "cov": 0.1, "distribution": "weibull"}, 'distribution: "weibull": not allowed'),
        ({"mean": "0.60 m", "cov": 0.1, "group": ""}, 'thickness.group: "": an empty name'),
        ({"mean": "0.60 m", "cov": 0.1, "grup": "a"}, 'unknown key; did you mean "group"?'),
    ],
)
def test_what_is_no_scatter_is_refused_in_one_line(tmp_path: Path, thickness: Any, said: str) -> None:
    with pytest.raises(ProjectError) as error:
        load_project(tmp_path, project_toml(bodies={"wall": wall(thickness)}))
    assert said in str(error.value)
    assert "\n" not in str(error.value)


SPECTRUM = {"code": "asce7-16", "s_ds": {"mean": "0.5 g", "cov": 0.1}, "s_d1": "0.2 g", "t_l": "6 s"}
RULE = {"mean": "housner", "cov": 0.1}


@pytest.mark.parametrize(
    ("tables", "key"),
    [
        ({"site": {"spectrum": SPECTRUM}}, "site.spectrum.s_ds"),
        ({"mechanisms": {"wall": block(cut={"mean": "1 m", "cov": 0.1})}}, "mechanisms.wall.cut"),
        ({"building": {"height": {"mean": "9 m", "cov": 0.1}}}, "building.height"),
        ({"mechanisms": {"wall": block(restitution=RULE)}}, "mechanisms.wall.restitution.mean"),
    ],
)
def test_keys_without_scatter_are_refused_by_name(tmp_path: Path, tables: Any, key: str) -> None:
    with pytest.raises(ProjectError, match=rf": {key}: ") as error:
        load_project(tmp_path, project_toml(**tables))
    assert "\n" not in str(error.value)


def test_a_material_may_be_called_mean(tmp_path: Path) -> None:
    materials = {"mean": {"density": 1800}, "cov": {"density": 2000}}
    project = load_project(tmp_path, project_toml(materials=materials, bodies={"wall": wall(material="mean")}))
    assert project.uncertain == ()


@pytest.mark.parametrize(
    ("table", "said"),
    [
        ({"samples": 100}, "analysis.uncertainty.samples: 100: not a power of two, which Sobol's sequences need"),
        ({"samples": 8}, "analysis.uncertainty.samples: 8: must be 16 or more"),
        ({"seed": -1}, "analysis.uncertainty.seed: -1: must be 0 or more"),
        ({"thickness": 1.0}, "analysis.uncertainty.thickness: 1.0: must be less than 1"),
        ({"samples": 16}, "analysis.uncertainty: no number of the project is uncertain"),
    ],
)
def test_the_section_is_checked(tmp_path: Path, table: Any, said: str) -> None:
    with pytest.raises(ProjectError) as error:
        build(load_project(tmp_path, project_toml(analysis={"uncertainty": table})))
    assert said in str(error.value)


def test_hinges_that_stay_while_faces_move_are_told(tmp_path: Path) -> None:
    mechanisms = {"wall": block(direction=[1, 0, 0], hinges={"A": [0.3, 0]})}
    project = load_project(
        tmp_path,
        project_toml(bodies={"wall": wall(MEAN)}, mechanisms=mechanisms, analysis={"uncertainty": {"seed": 3}}),
    )
    (told,) = [each for each in build(project).messages if each.key == "uncertainty-hinges-stay"]
    assert told.where == "mechanisms.wall.hinges"


def test_the_json_schema_takes_a_scatter_where_the_program_does() -> None:
    schema = json_schema()
    definitions = schema["$defs"]
    for kind, section, key in (
        ("density", "MaterialSection", "density"),
        ("length", "HingesSection", "A"),
        ("ratio", "SingleBlockSection", "restitution"),
    ):
        value = definitions[section]["properties"][key]
        assert {"$ref": f"#/$defs/UncertainNumber-of-{kind}"} in value.get("items", value)["anyOf"]
        assert definitions[f"UncertainNumber-of-{kind}"]["required"] == ["mean"]
    assert "anyOf" not in definitions["BodyLoadSection"]["properties"]["tolerance"]
    assert "or { mean, cov }" not in str(schema)
