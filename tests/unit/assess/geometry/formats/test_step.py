"""STEP files, written here as faceted solids by ISO 10303-214."""

from pathlib import Path

import numpy as np
import pytest

from assess.errors import GeometryError
from assess.geometry.mesh import load_solid
from tests.support.mesh_files import CUBE, QUADS

pytest.importorskip("cascadio", reason="the extra 'step' is not installed")

SIZES, CORNER = np.array([1.25, 3.0, 8.5]), np.array([0.1, 0.2, 0.3])
HEAD = """ISO-10303-21;
HEADER;
FILE_DESCRIPTION((''),'2;1');
FILE_NAME('','2020-01-01T00:00:00',(''),(''),'','','');
FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));
ENDSEC;
DATA;
#1=APPLICATION_CONTEXT('automotive design');
#2=APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,#1);
#3=PRODUCT_CONTEXT('',#1,'mechanical');
#4=PRODUCT('wall','wall','',(#3));
#5=PRODUCT_DEFINITION_FORMATION('','',#4);
#6=PRODUCT_DEFINITION_CONTEXT('part definition',#1,'design');
#7=PRODUCT_DEFINITION('design','',#5,#6);
#8=PRODUCT_DEFINITION_SHAPE('','',#7);
#9=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT({prefix},.METRE.));
#10=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));
#11=(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT());
#12=UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-05),#9,'distance_accuracy_value','');
#13=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#12))
GLOBAL_UNIT_ASSIGNED_CONTEXT((#9,#10,#11))REPRESENTATION_CONTEXT('',''));
#14=CARTESIAN_POINT('',(0.,0.,0.));
#15=AXIS2_PLACEMENT_3D('',#14,$,$);
"""
TAIL = "ENDSEC;\nEND-ISO-10303-21;\n"


def triple(values: np.ndarray) -> str:
    return "(" + ",".join(repr(float(value)) for value in values) + ")"


def step(vertices: np.ndarray, *, prefix: str) -> str:
    """A box, its vertices in the unit of the prefix."""
    lines: list[str] = []

    def put(text: str) -> str:
        lines.append(f"#{16 + len(lines)}={text};\n")
        return f"#{15 + len(lines)}"

    points = [put(f"CARTESIAN_POINT('',{triple(vertex)})") for vertex in vertices]
    faces = []
    for corners in QUADS:
        a, b, c = (vertices[i] for i in corners[:3])
        along, normal = (b - a) / np.linalg.norm(b - a), np.cross(b - a, c - b)
        upright = put(f"DIRECTION('',{triple(normal / np.linalg.norm(normal))})")
        level = put(f"DIRECTION('',{triple(along)})")
        frame = put(f"AXIS2_PLACEMENT_3D('',{points[corners[0]]},{upright},{level})")
        plane = put(f"PLANE('',{frame})")
        loop = put(f"POLY_LOOP('',({','.join(points[i] for i in corners)}))")
        bound = put(f"FACE_OUTER_BOUND('',{loop},.T.)")
        faces.append(put(f"FACE_SURFACE('',({bound}),{plane},.T.)"))
    shell = put(f"CLOSED_SHELL('',({','.join(faces)}))")
    solid = put(f"FACETED_BREP('',{shell})")
    shape = put(f"FACETED_BREP_SHAPE_REPRESENTATION('',({solid},#15),#13)")
    put(f"SHAPE_DEFINITION_REPRESENTATION(#8,{shape})")
    return HEAD.format(prefix=prefix) + "".join(lines) + TAIL


@pytest.mark.parametrize(
    ("prefix", "unit", "ending"), [(".MILLI.", 1e-3, "step"), (".CENTI.", 1e-2, "stp"), ("$", 1.0, "STEP")]
)
def test_a_step_solid_comes_in_metres_with_z_up(tmp_path: Path, prefix: str, unit: float, ending: str) -> None:
    file = tmp_path / f"wall.{ending}"
    file.write_text(step((CUBE * SIZES + CORNER) / unit, prefix=prefix))
    found = load_solid(file, density=1.0, name="wall")
    assert found.mass == pytest.approx(float(np.prod(SIZES)), rel=1e-6)  # single precision on the way
    np.testing.assert_allclose(found.vertices.min(axis=0), CORNER, rtol=0.0, atol=1e-6)
    np.testing.assert_allclose(found.vertices.max(axis=0), CORNER + SIZES, rtol=0.0, atol=1e-6)
    assert found.history == ()


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("REPRESENTATION_CONTEXT('','')", "REPRESENTATIOM_CONTEXT('','')"),
        ("\nGLOBAL_UNIT_ASSIGNED_CONTEXT((#9,#10,#11))", "\n"),
        ("((#9,#10,#11))", "((#8,#10,#11))"),
        ("LENGTH_UNIT()", "LENGTHxUNIT()"),
        (",#15),#13)", ",#15),#12)"),
    ],
)
def test_a_step_file_that_lost_its_unit_is_not_taken_for_millimetres(tmp_path: Path, old: str, new: str) -> None:
    content = step((CUBE * SIZES + CORNER) * 100.0, prefix=".CENTI.")
    assert content.count(old) == 1
    file = tmp_path / "wall.step"
    file.write_text(content.replace(old, new))
    with pytest.raises(GeometryError, match=r'body "wall": mesh wall.step: the file states no unit; give mesh_unit'):
        load_solid(file, density=1.0, name="wall")


def test_a_step_file_without_a_unit_takes_the_one_given(tmp_path: Path) -> None:
    file = tmp_path / "wall.step"
    file.write_text(step((CUBE * SIZES + CORNER) * 100.0, prefix=".CENTI.").replace("LENGTH_UNIT()", "LENGTHxUNIT()"))
    assert load_solid(file, density=1.0, name="wall", scale=0.01).mass == pytest.approx(float(np.prod(SIZES)), rel=1e-6)


def test_a_damaged_unit_of_a_step_file_is_refused(tmp_path: Path) -> None:
    (tmp_path / "wall.step").write_text(step(CUBE * 100.0, prefix=".CENTX."))
    with pytest.raises(GeometryError, match="its unit of length is no metre with a prefix"):
        load_solid(tmp_path / "wall.step", density=1.0, name="wall", scale=0.01)


def test_strings_and_comments_of_a_step_file_hide_no_unit(tmp_path: Path) -> None:
    content = step((CUBE * SIZES + CORNER) * 1000.0, prefix=".MILLI.")
    content = content.replace("REPRESENTATION_CONTEXT('','')", "REPRESENTATION_CONTEXT ('it''s; one)','') /* ; */")
    (tmp_path / "wall.step").write_text(content)
    assert load_solid(tmp_path / "wall.step", density=1.0, name="wall").mass == pytest.approx(
        float(np.prod(SIZES)), rel=1e-6
    )


@pytest.mark.parametrize("part", [0.0, 0.5, 0.98])
def test_a_step_file_cut_short_is_refused(tmp_path: Path, part: float, capfd: pytest.CaptureFixture[str]) -> None:
    content = step(CUBE, prefix="$")
    (tmp_path / "wall.step").write_text(content[: int(part * len(content))])
    with pytest.raises(GeometryError, match=r'body "wall": mesh wall.step: it cannot be read as STEP .it does not end'):
        load_solid(tmp_path / "wall.step", density=1.0, name="wall")
    assert capfd.readouterr().out == ""


def test_a_step_file_of_no_shape_is_refused(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "wall.step").write_text(HEAD.format(prefix="$") + TAIL)
    with pytest.raises(GeometryError, match=r"cannot be read as STEP .Open CASCADE finds no shape|no triangles"):
        load_solid(tmp_path / "wall.step", density=1.0, name="wall")
    assert capfd.readouterr().out == ""


def test_a_damaged_step_file_cannot_take_the_program_with_it(tmp_path: Path) -> None:
    content = step(CUBE, prefix="$")
    old, new = "POLY_LOOP('',(#16,#19,#18,#17))", "POLY_LOOP('',(#15,#19,#18,#17))"
    assert old in content
    (tmp_path / "wall.step").write_text(content.replace(old, new))
    with pytest.raises(GeometryError, match=r"cannot be read as STEP \(Open CASCADE crashed on it"):
        load_solid(tmp_path / "wall.step", density=1.0, name="wall")


def test_a_step_file_that_is_never_meshed_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("assess.geometry.formats.step.MESH", "import time; time.sleep(60)  # {} {}")
    for limit, value in {"MIN_TIME": 0.1, "CLOCK_FACTOR": 1.5}.items():
        monkeypatch.setattr(f"assess.geometry.formats.isolation.{limit}", value)
    (tmp_path / "wall.step").write_text(step(CUBE, prefix="$"))
    with pytest.raises(GeometryError, match=r"has not read it after \d s; is it damaged"):
        load_solid(tmp_path / "wall.step", density=1.0, name="wall")
