"""`assess geometry --doctor`: boxes that are broken in one way each, with the volume that mending them moves."""

import csv
import io
import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from assess.geometry import mesh, repair, shells
from assess.geometry.doctor import DEFECTS, LEFT
from tests.support import mesh_files
from tests.support.command import ended
from tests.support.mesh_files import CUBE, QUADS

Q = np.array(QUADS)
TOP = [i for i, quad in enumerate(Q) if (CUBE[quad][:, 2] == 1.0).all()]
BOX = (0.5, 4.0, 3.0)
SICK: dict[str, tuple[Any, Any]] = {
    "sound": (CUBE * BOX, Q),
    "holed": (CUBE * BOX, np.delete(Q, TOP, axis=0)),
    "inside out": (CUBE * BOX, Q[:, ::-1]),
    "flipped": (CUBE * BOX, np.concatenate([Q[:1, ::-1], Q[1:]])),
    "overlapping": (np.concatenate([CUBE * BOX, CUBE * BOX + [0.0, 3.0, 0.0]]), np.concatenate([Q, Q + 8])),
    "open": (CUBE * BOX, Q[:3]),
}


@pytest.fixture
def model(tmp_path: Path) -> Path:
    content, before = b"", 0
    for number, (name, (places, quads)) in enumerate(SICK.items()):
        content += mesh_files.obj(places + np.array([10.0 * number, 0.0, 0.0]), quads, name=name, before=before)
        before += len(places)
    (tmp_path / "sick.obj").write_bytes(content)
    return tmp_path / "sick.obj"


def test_each_defect_has_its_line_with_its_cure_and_the_volume_that_moved(
    model: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert ended("geometry", model, "--doctor", "--json") == 0
    found = {row["element"]: row for row in json.loads(capsys.readouterr().out)}
    assert list(found) == [name for name in SICK if name != "sound"]
    moved = {name: row["volume_moved_m3"] for name, row in found.items()}
    assert moved.pop("overlapping") == pytest.approx(-0.5 * 1.0 * 3.0, rel=1e-9)
    assert moved.pop("holed") == pytest.approx(0.5 * 4.0 * 3.0 / 6.0, rel=1e-9)  # the cone to the middle, over the top
    assert moved == {"inside out": 0.0, "flipped": 0.0, "open": None}
    assert found["holed"]["mended"] == "closed by planes"
    assert found["open"]["mended"] is None
    assert found["open"]["defect"].startswith("it is open: ")
    assert found["open"]["cure"] == "close the surface"
    assert ended("geometry", model, "--doctor", "--csv") == 0
    rows = list(csv.DictReader(io.StringIO(capsys.readouterr().out)))
    assert [row["element"] for row in rows] == list(found)


def test_the_table_counts_the_parts_and_a_file_that_cannot_be_read_is_its_own_patient(
    model: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "junk.glb").write_bytes(b"glTF")
    assert ended("geometry", model, tmp_path / "junk.glb", "--doctor") == 0
    text = capsys.readouterr().out
    assert "6 parts, 1 not usable (open), 4 mended, which moved 2.5 m3, 0 overlaps\n" in text
    assert "1 part, 1 not usable (junk.glb), 0 mended, 0 overlaps\n" in text
    assert re.search(r"junk.glb +not usable +- +it cannot be read as GLB .* export it again as STL, OBJ or PLY\n", text)
    assert "sound" not in text


def test_each_pair_of_parts_that_are_drawn_over_one_another_has_its_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Two walls over one another at a corner, 0.5 by 0.5 by 3 m, and a third that touches one of them."""
    walls = {"front": ((0, 0, 0), (6, 0.5, 3)), "side": ((0, 0, 0), (0.5, 4, 3)), "back": ((0, 4, 0), (6, 0.5, 3))}
    content = b""
    for number, (name, (at, sizes)) in enumerate(walls.items()):
        content += mesh_files.obj(CUBE * sizes + at, Q, name=name, before=8 * number)
    (tmp_path / "walls.obj").write_bytes(content)
    assert ended("geometry", tmp_path / "walls.obj", "--doctor", "--json") == 0
    (row,) = json.loads(capsys.readouterr().out)
    assert (row["element"], row["mended"], row["volume_moved_m3"]) == ("front, side", None, None)
    assert row["defect"] == "they share 0.75 m3, 12.5 % of the smaller one"
    assert ended("geometry", tmp_path / "walls.obj", "--doctor") == 0
    assert "3 parts, 0 not usable, 0 mended, 1 overlap of 0.75 m3\n" in capsys.readouterr().out


def test_two_walls_that_overlap_along_their_length_are_no_corner(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Two leaves 0.1 m into one another, and a wall that crosses both."""
    walls = {"outer": ((0, 0, 0), (6, 0.5, 3)), "inner": ((0, 0.4, 0), (6, 0.5, 3)), "side": ((0, 0, 0), (0.5, 4, 3))}
    content = b""
    for number, (name, (at, sizes)) in enumerate(walls.items()):
        content += mesh_files.obj(CUBE * sizes + at, Q, name=name, before=8 * number)
    (tmp_path / "walls.obj").write_bytes(content)
    assert ended("geometry", tmp_path / "walls.obj", "--doctor", "--json") == 0
    cures = {row["element"]: row["cure"] for row in json.loads(capsys.readouterr().out)}
    assert "draw two leaves face to face" in cures["outer, inner"]
    assert all("end one at the face of the other" in cures[f"{name}, side"] for name in ("outer", "inner"))


def test_a_file_of_which_no_part_is_usable_ends_with_2(tmp_path: Path) -> None:
    lines = mesh_files.obj(CUBE * (6, 0.5, 3), Q, name="wall").decode().splitlines()
    (tmp_path / "open.obj").write_text("\n".join(lines[:-3]) + "\n")
    assert ended("geometry", tmp_path / "open.obj", "--doctor") == 2


def test_every_message_on_a_mesh_has_a_cure_or_tells_of_no_defect() -> None:
    """What a file is read as, and what is joined, is no defect."""
    sources = "".join(Path(str(module.__file__)).read_text(encoding="utf-8") for module in (mesh, repair, shells))
    keys = set(re.findall(r'(?:note|warning)\(\s*f?"([a-z-]+)', sources))
    known = {*DEFECTS, *LEFT, "read-with-y-up", "read-in-units", "elements-joined", "several-classes"}
    assert keys - known == set()
    assert DEFECTS.keys() <= keys
