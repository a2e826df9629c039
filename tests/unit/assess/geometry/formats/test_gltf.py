"""OFF, glTF and 3MF files written here by their specifications, and read into the same box."""

import base64
import json
import struct
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from assess.errors import GeometryError
from assess.geometry.formats.gltf import companions
from assess.geometry.formats.readers import read_mesh_file as read_file
from assess.geometry.mesh import load_solid
from assess.geometry.solid import Solid, box
from tests.support.files import write_file
from tests.support.mesh_files import glb, gltf, mf3, off
from tests.support.solids import assert_same_mass

DENSITY = 2000.0
WALL = box(thickness=1.25, length=3.0, height=8.5, base=[0.5, 0.25, 2.0], density=DENSITY, name="wall")
TO_Y_UP = Rotation.from_euler("x", -90, degrees=True).as_matrix()  # z goes to y


def read(folder: Path, file: str, content: bytes, **options) -> Solid:
    return load_solid(write_file(folder / file, content), density=DENSITY, name="wall", **options)


def test_off(tmp_path: Path) -> None:
    assert_same_mass(read(tmp_path, "wall.off", off(WALL.vertices, WALL.triangles)), WALL, rtol=1e-12)


def test_gltf_is_turned_from_y_up_to_z_up(tmp_path: Path) -> None:
    header, content = gltf(WALL.vertices @ TO_Y_UP.T, WALL.triangles, [{"mesh": 0, "name": "wall"}])
    assert_same_mass(read(tmp_path, "wall.glb", glb(header, content)), WALL, rtol=1e-12)
    header["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64.b64encode(content).decode()
    assert_same_mass(read(tmp_path, "wall.gltf", json.dumps(header).encode()), WALL, rtol=1e-12)
    header["buffers"][0]["uri"] = "wall.bin"
    (tmp_path / "wall.bin").write_bytes(content)
    assert_same_mass(read(tmp_path, "beside.gltf", json.dumps(header).encode()), WALL, rtol=1e-12)


def test_companions_are_the_files_that_hold_the_buffers(tmp_path: Path) -> None:
    header, _ = gltf(WALL.vertices, WALL.triangles, [{"mesh": 0}])
    within = {"byteLength": 1, "uri": "data:application/octet-stream;base64,AA=="}
    header["buffers"] = [{"byteLength": 9, "uri": "my%20wall.bin"}, within, {"byteLength": 1}, {"uri": "b/c.bin"}]
    path = write_file(tmp_path / "wall.gltf", json.dumps(header).encode())
    assert companions(path) == (tmp_path / "my wall.bin", tmp_path / "b" / "c.bin")
    for damaged in (b"", b"[]", b"{", b'{"buffers": 7}', b'{"buffers": [7]}', b"\xff", b"glTF",
                    b'{"buffers": [{"uri": "a%00b"}, {"uri": "\\ud800"}]}'):  # fmt: skip
        assert companions(write_file(path, damaged)) == ()
    assert companions(tmp_path / "absent.gltf") == ()


def test_gltf_that_has_z_up_against_its_standard(tmp_path: Path) -> None:
    content = glb(*gltf(WALL.vertices, WALL.triangles, [{"mesh": 0}]))
    assert_same_mass(read(tmp_path, "wall.glb", content, up="z"), WALL, rtol=1e-12)


def test_gltf_vertices_reach_as_far_as_their_accessor_says(tmp_path: Path) -> None:
    """A header that rounds is believed; one byte of a vertex, or of the header, is not."""
    places = WALL.vertices @ TO_Y_UP.T
    header, content = gltf(places, WALL.triangles, [{"mesh": 0, "name": "wall"}])
    low, high = places.min(axis=0).tolist(), places.max(axis=0).tolist()
    header["accessors"][0] |= {"min": [float(f"{x:.6g}") for x in low], "max": [float(f"{x:.6g}") for x in high]}
    assert_same_mass(read(tmp_path, "wall.glb", glb(header, content)), WALL, rtol=1e-12)
    flipped = bytearray(content)
    flipped[0:4] = struct.pack("<f", struct.unpack("<f", content[0:4])[0] - 0.25)
    for other in (bytes(flipped), content):
        with pytest.raises(GeometryError, match="and no accessor's min and max say so"):
            read(tmp_path, "wall.glb", glb(header, other))
        header["accessors"][0]["max"] = [high[0] + 0.25, *high[1:]]


def test_instances_of_a_scene_stand_in_their_places(tmp_path: Path) -> None:
    """A unit cube four times: moved; scaled in a moved and turned parent; mirrored."""
    cube = box(thickness=1.0, length=1.0, height=1.0, base=[0.0, 0.0, -0.5], density=DENSITY, name="cube")
    half = float(np.sqrt(0.5))
    nodes = [
        {"mesh": 0, "name": "moved", "translation": [3.0, 0.0, 0.0]},
        {"name": "parent", "translation": [0.0, 0.0, 10.0], "rotation": [0.0, half, 0.0, half], "children": [2]},
        {"mesh": 0, "name": "scaled", "translation": [5.0, 0.0, 0.0], "scale": [2.0, 1.0, 1.0]},
        {"mesh": 0, "name": "mirrored", "matrix": [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -7, 0, 0, 1]},
    ]
    content = glb(*gltf(cube.vertices, cube.triangles, nodes, roots=[0, 1, 3]))
    whole = read(tmp_path, "scene.glb", content)
    assert whole.mass == pytest.approx((1.0 + 2.0 + 1.0) * DENSITY, rel=1e-6)
    assert [told.key for told in whole.history] == ["read-with-y-up"]
    assert read(tmp_path, "scene.glb", content, up="y").history == ()
    # a quarter turn about y takes x to -z, z to x: the scaled cube is 2 m along z at y-up (0, 0, 10 - 5)
    for name, centre, sizes in (
        ("moved", (3, 0, 0), (1, 1, 1)),
        ("scaled", (0, -5, 0), (1, 2, 1)),
        ("mirrored", (-7, 0, 0), (1, 1, 1)),
    ):
        one = read(tmp_path, "scene.glb", content, element=name)
        np.testing.assert_allclose(one.centroid, centre, rtol=0.0, atol=1e-6)
        np.testing.assert_allclose(np.ptp(one.vertices, axis=0), sizes, rtol=0.0, atol=1e-6)
    with pytest.raises(GeometryError, match='it has no element "tower"; known: mirrored, scaled, moved'):
        read(tmp_path, "scene.glb", content, element="tower")


@pytest.mark.parametrize(
    ("unit", "size"),
    [("millimeter", 1e-3), ("centimeter", 1e-2), ("inch", 0.0254), ("foot", 0.3048), ("meter", 1.0), (None, 1e-3)],
)
def test_3mf_is_in_the_unit_it_states(tmp_path: Path, unit: str | None, size: float) -> None:
    content = mf3(WALL.vertices / size, WALL.triangles, unit=unit, items='<item objectid="1"/>')
    found = read(tmp_path, "wall.3mf", content)
    assert_same_mass(found, WALL, rtol=1e-12)
    assert found.history == ()
    assert_same_mass(read(tmp_path, "wall.3mf", content, scale=size), WALL, rtol=1e-12)


def test_a_unit_that_contradicts_the_file_is_used_and_told(tmp_path: Path) -> None:
    content = mf3(WALL.vertices * 100.0, WALL.triangles, unit="millimeter", items='<item objectid="1"/>')
    found = read(tmp_path, "wall.3mf", content, scale=0.01)
    assert_same_mass(found, WALL, rtol=1e-12)
    assert [told.text for told in found.history] == [
        "read in units of 0.01 m, as the project states, although the file states 0.001 m"
    ]


def test_components_and_items_of_3mf_stand_in_their_places(tmp_path: Path) -> None:
    pair = (
        '<object id="2" name="pair" type="model"><components><component objectid="1"/>'
        '<component objectid="1" transform="1 0 0 0 1 0 0 0 1 0 10 0"/></components></object>'
    )
    items = '<item objectid="2"/><item objectid="2" transform="0 1 0 -1 0 0 0 0 1 40 0 0"/>'
    whole = read(tmp_path, "piers.3mf", mf3(WALL.vertices, WALL.triangles, unit="meter", items=items, resources=pair))
    assert whole.mass == pytest.approx(4.0 * WALL.mass, rel=1e-12)
    # rows times the transform: (x, y) goes to (-y, x) + (40, 0)
    places = [(0.5, 0.25), (0.5, 10.25), (39.75, 0.5), (29.75, 0.5)]
    np.testing.assert_allclose(whole.centroid, [*np.mean(places, axis=0), 6.25], rtol=1e-12, atol=0.0)


JUNK = bytes(np.random.default_rng(0).integers(0, 256, 3000, dtype=np.uint8))
GOOD = {
    "off": off(WALL.vertices, WALL.triangles),
    "glb": glb(*gltf(WALL.vertices, WALL.triangles, [{"mesh": 0}])),
    "gltf": json.dumps(gltf(WALL.vertices, WALL.triangles, [{"mesh": 0}])[0]).encode(),  # its buffer is nowhere
    "3mf": mf3(WALL.vertices, WALL.triangles, unit="meter", items='<item objectid="1"/>'),
}


@pytest.mark.parametrize("ending", GOOD)
@pytest.mark.parametrize("part", [0.0, 0.3, 0.6, 0.95, JUNK, b"hello\nworld\n", b"{}", b"[1]", b"OFF\n-1 4 0\n"])
def test_broken_files_are_refused_in_one_line(tmp_path: Path, ending: str, part: float | bytes) -> None:
    content = part if isinstance(part, bytes) else GOOD[ending][: int(part * len(GOOD[ending]))]
    with pytest.raises(
        GeometryError, match=rf'body "wall": mesh wall.{ending}: (no triangles|it cannot be read as)'
    ) as caught:
        read(tmp_path, f"wall.{ending}", content)
    assert "\n" not in str(caught.value)


def test_scenes_without_geometry_are_refused(tmp_path: Path) -> None:
    empty = glb(
        {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"name": "nothing"}]}, b""
    )
    nothing_built = mf3(WALL.vertices, WALL.triangles, unit="meter", items="")
    for file, content in (("scene.glb", empty), ("scene.3mf", nothing_built), ("scene.off", b"OFF\n0 0 0\n")):
        with pytest.raises(GeometryError, match=r"no triangles found|cannot be read"):
            read(tmp_path, file, content)


def test_a_scene_that_goes_round_in_a_circle_is_refused(tmp_path: Path) -> None:
    nodes = [{"name": "a", "children": [1]}, {"name": "b", "children": [0], "mesh": 0}]
    with pytest.raises(GeometryError, match=r"cannot be read as GLB .its scene has no way"):
        read(tmp_path, "round.glb", glb(*gltf(WALL.vertices, WALL.triangles, nodes, roots=[0])))


@pytest.mark.parametrize("value", ["nan", "inf", "1e999"])
def test_numbers_that_are_not_finite_are_refused(tmp_path: Path, value: str) -> None:
    content = GOOD["off"].replace(b"8.5", value.encode()).replace(b"10.5", value.encode())
    with pytest.raises(GeometryError, match=r"not finite|cannot be read"):
        read(tmp_path, "wall.off", content)


def test_the_primitives_of_a_node_are_one_element_of_its_own_name(tmp_path: Path) -> None:
    """Exporters part a mesh by materials; trimesh calls its pieces otherwise in each run."""
    cube = box(thickness=1.0, length=1.0, height=1.0, base=(0.0, 0.0, 0.0), density=1.0, name="cube")
    header, content = gltf(cube.vertices, cube.triangles, [{"mesh": 0, "name": "pier"}, {"mesh": 0, "name": "post"}])
    header["nodes"][0]["children"] = [len(header["nodes"])]
    header["nodes"] += [{"mesh": 0, "name": "pier_abcdef", "translation": [0.0, 0.0, 9.0]}]
    header["scenes"][0]["nodes"] = [0, 1]
    half = 4 * 3 * (len(cube.triangles) // 2)
    view = header["bufferViews"][1]
    header["bufferViews"] += [view | {"byteOffset": view["byteOffset"] + half, "byteLength": view["byteLength"] - half}]
    view["byteLength"] = half
    header["accessors"][1]["count"] = half // 4
    header["accessors"] += [header["accessors"][1] | {"bufferView": 2, "count": cube.triangles.size - half // 4}]
    header["meshes"][0]["primitives"] += [{"attributes": {"POSITION": 0}, "indices": 2}]
    file = tmp_path / "scene.glb"
    file.write_bytes(glb(header, content))
    found = read_file(file, where="mesh").meshes
    assert sorted(part.element.names for part in found) == [("pier",), ("pier_abcdef",), ("post",)]
    assert read(tmp_path, "scene.glb", glb(header, content), element="pier").mass == pytest.approx(DENSITY, rel=1e-6)


def test_nodes_of_one_name_are_all_meant_by_it_and_numbered(tmp_path: Path) -> None:
    cube = box(thickness=1.0, length=1.0, height=1.0, base=(0.0, 0.0, 0.0), density=1.0, name="cube")
    nodes = [{"mesh": 0, "name": "pier", "translation": [3.0 * k, 0.0, 0.0]} for k in range(3)]
    content = glb(*gltf(cube.vertices, cube.triangles, nodes))
    whole = read(tmp_path, "scene.glb", content, element="pier")
    assert whole.mass == pytest.approx(3.0 * DENSITY, rel=1e-6)
    assert "elements joined into one body: 3" in str(whole.history[0])
    for name, x in (("pier_0", 0.0), ("pier_1", 3.0), ("pier_2", 6.0)):
        one = read(tmp_path, "scene.glb", content, element=name)
        np.testing.assert_allclose(one.centroid[0], x, rtol=0.0, atol=1e-6)
