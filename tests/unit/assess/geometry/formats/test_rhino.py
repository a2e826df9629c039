"""Rhino files made with rhino3dm."""

import ctypes
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from assess.errors import GeometryError
from assess.geometry.mesh import load_solid
from tests.support.mesh_files import CUBE, QUADS

rhino3dm: Any = pytest.importorskip("rhino3dm", reason="the extra 'rhino' is not installed")


def mesh(vertices: np.ndarray, faces: list[tuple[int, ...]] | None = None) -> Any:
    shape = rhino3dm.Mesh()
    for vertex in vertices.tolist():
        shape.Vertices.Add(*vertex)
    for face in QUADS if faces is None else faces:
        shape.Faces.AddFace(*face)
    ctypes.pythonapi.Py_IncRef(ctypes.py_object(shape))  # SetMesh hands over its memory, which Python must not free too
    return shape


def called(name: str) -> Any:
    attributes = rhino3dm.ObjectAttributes()
    attributes.Name = name
    return attributes


def written(folder: Path, model: Any) -> Path:
    file = folder / "wall.3dm"
    model.Write(str(file), 7)
    return file


def model_in(unit: str) -> Any:
    model = rhino3dm.File3dm()
    model.Settings.ModelUnitSystem = getattr(rhino3dm.UnitSystem, unit)
    return model


@pytest.mark.parametrize(
    ("unit", "size"), [("Millimeters", 1e-3), ("Meters", 1.0), ("Feet", 0.3048), ("Inches", 0.0254)]
)
def test_a_mesh_in_the_unit_of_the_file(tmp_path: Path, unit: str, size: float) -> None:
    model = model_in(unit)
    model.Objects.AddMesh(mesh(CUBE * [1.25, 3.0, 8.5] / size), called("wall"))
    found = load_solid(written(tmp_path, model), density=1.0, name="wall")
    assert found.mass == pytest.approx(31.875, rel=1e-6)  # single precision
    np.testing.assert_allclose(found.vertices.max(axis=0), [1.25, 3.0, 8.5], rtol=1e-6, atol=0.0)
    assert found.history == ()


def test_objects_are_chosen_by_name(tmp_path: Path) -> None:
    model = model_in("Meters")
    model.Objects.AddMesh(mesh(CUBE), called("pier"))
    model.Objects.AddMesh(mesh(CUBE * 2.0 + [5.0, 0.0, 0.0]), called("buttress"))
    model.Objects.AddPoint(rhino3dm.Point3d(99.0, 0.0, 0.0))
    file = written(tmp_path, model)
    for element, volume in ((None, 9.0), ("pier", 1.0), ("buttress", 8.0)):
        assert load_solid(file, density=1.0, name="wall", element=element).mass == pytest.approx(volume, rel=1e-6)
    with pytest.raises(GeometryError, match='it has no element "tower"; known: pier, buttress'):
        load_solid(file, density=1.0, name="wall", element="tower")


def test_a_polysurface_and_an_extrusion_by_their_render_meshes(tmp_path: Path) -> None:
    model = model_in("Meters")
    box = rhino3dm.Brep.CreateFromBox(
        rhino3dm.Box(rhino3dm.BoundingBox(rhino3dm.Point3d(0, 0, 0), rhino3dm.Point3d(1, 1, 1)))
    )
    for i, quad in enumerate(QUADS):
        box.Faces[i].SetMesh(mesh(CUBE[list(quad)], [(0, 1, 2, 3)]), rhino3dm.MeshType.Render)
    model.Objects.AddBrep(box, called("surface"))
    far = rhino3dm.BoundingBox(rhino3dm.Point3d(5, 0, 0), rhino3dm.Point3d(7, 2, 2))
    pier = rhino3dm.Extrusion.CreateBoxExtrusion(rhino3dm.Box(far), True)
    pier.SetMesh(mesh(CUBE * 2.0 + [5.0, 0.0, 0.0]), rhino3dm.MeshType.Render)
    model.Objects.AddExtrusion(pier, called("pier"))
    file = written(tmp_path, model)
    for element, volume in (("surface", 1.0), ("pier", 8.0), (None, 9.0)):
        assert load_solid(file, density=1.0, name="wall", element=element).mass == pytest.approx(volume, rel=1e-6)


def test_a_surface_without_its_mesh_is_refused_by_name(tmp_path: Path) -> None:
    model = model_in("Meters")
    corners = rhino3dm.BoundingBox(rhino3dm.Point3d(0, 0, 0), rhino3dm.Point3d(1, 1, 1))
    model.Objects.AddBrep(rhino3dm.Brep.CreateFromBox(rhino3dm.Box(corners)), called("vault"))
    model.Objects.AddMesh(mesh(CUBE), called("pier"))
    file = written(tmp_path, model)
    with pytest.raises(
        GeometryError, match=r'element "vault" .*: it is a polysurface .Brep. saved without its render mesh'
    ):
        load_solid(file, density=1.0, name="wall")
    assert load_solid(file, density=1.0, name="wall", element="pier").mass == pytest.approx(1.0, rel=1e-6)


def test_block_instances_stand_in_their_places(tmp_path: Path) -> None:
    model = model_in("Meters")
    origin = rhino3dm.Point3d(0, 0, 0)
    index = model.InstanceDefinitions.Add("drum", "", "", "", origin, (mesh(CUBE),), (called("stone"),))
    drum = model.InstanceDefinitions.FindIndex(index).Id
    for height in (0.0, 1.0, 2.0):
        place = rhino3dm.Transform.Translation(4.0, 0.0, height)
        model.Objects.AddInstanceObject(rhino3dm.InstanceReference(drum, place), called(f"drum at {height:g}"))
    file = written(tmp_path, model)
    whole = load_solid(file, density=1.0, name="wall")
    assert whole.mass == pytest.approx(3.0, rel=1e-6)
    np.testing.assert_allclose(whole.centroid, [4.5, 0.5, 1.5], rtol=1e-6, atol=0.0)
    one = load_solid(file, density=1.0, name="wall", element="drum at 2")
    np.testing.assert_allclose(one.centroid, [4.5, 0.5, 2.5], rtol=1e-6, atol=0.0)


@pytest.mark.parametrize("content", [b"", b"hello\nworld\n", b"3D Geometry File Format "])
def test_what_is_no_rhino_file_is_refused(tmp_path: Path, content: bytes) -> None:
    (tmp_path / "wall.3dm").write_bytes(content)
    with pytest.raises(GeometryError, match=r'body "wall": mesh wall.3dm: (it cannot be read as 3DM|no triangles)'):
        load_solid(tmp_path / "wall.3dm", density=1.0, name="wall")


def test_a_rhino_file_cut_short_is_refused(tmp_path: Path) -> None:
    model = model_in("Meters")
    model.Objects.AddMesh(mesh(CUBE), called("pier"))
    content = written(tmp_path, model).read_bytes()
    for part in (0.3, 0.6, 0.9):
        (tmp_path / "short.3dm").write_bytes(content[: int(part * len(content))])
        with pytest.raises(GeometryError, match=r'body "wall": mesh short.3dm'):
            load_solid(tmp_path / "short.3dm", density=1.0, name="wall")


def test_what_its_own_process_refuses_is_not_read_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """OpenNURBS takes half a minute to refuse some damaged files."""
    (tmp_path / "wall.3dm").write_bytes(b"hello")
    monkeypatch.setattr(rhino3dm, "File3dm", None)
    with pytest.raises(GeometryError, match="not a Rhino file"):
        load_solid(tmp_path / "wall.3dm", density=1.0, name="wall")


def test_a_damaged_rhino_file_cannot_keep_the_program(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("assess.geometry.formats.rhino.READ", "import time; time.sleep(60)")
    for limit, value in {"MIN_TIME": 0.1, "SPEED": 1e9, "CLOCK_FACTOR": 1.5}.items():
        monkeypatch.setattr(f"assess.geometry.formats.isolation.{limit}", value)
    model = model_in("Meters")
    model.Objects.AddMesh(mesh(CUBE), called("wall"))
    with pytest.raises(GeometryError, match=r"openNURBS has not read it after \d s; is it damaged"):
        load_solid(written(tmp_path, model), density=1.0, name="wall")
