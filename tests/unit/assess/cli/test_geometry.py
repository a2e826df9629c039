"""`assess geometry`: the parts of model files as a table, CSV and JSON."""

import csv
import io
import json
from math import cos, degrees, radians, sin
from pathlib import Path

import numpy as np
import pytest

from tests.support import mesh_files
from tests.support.command import ended
from tests.support.mesh_files import CUBE, QUADS


def obj(folder: Path, **boxes: tuple[tuple[float, float, float], tuple[float, float, float], float]) -> Path:
    """Boxes by name: size, corner, turn about z [deg]."""
    content = b""
    for count, (name, (size, corner, turn)) in enumerate(boxes.items()):
        c, s = cos(radians(turn)), sin(radians(turn))
        places = CUBE * size @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]]) + corner
        content += mesh_files.obj(places, QUADS, name=name, before=8 * count)
    (folder / "house.obj").write_bytes(content)
    return folder / "house.obj"


def listed(capsys: pytest.CaptureFixture[str], *arguments: str | Path) -> list[dict[str, object]]:
    assert ended("geometry", *arguments, "--json") == 0
    return list(json.loads(capsys.readouterr().out))


@pytest.mark.parametrize("turn", [0.0, 30.0, 90.0, 150.0, -20.0])
def test_a_wall_has_its_sizes_and_its_thin_direction_however_it_stands(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], turn: float
) -> None:
    (row,) = listed(capsys, obj(tmp_path, wall=((0.6, 4.0, 3.0), (10.0, 20.0, 1.5), turn)))
    assert row["size_m"] == pytest.approx([0.6, 4.0, 3.0], rel=1e-9)
    assert row["volume_m3"] == pytest.approx(7.2, rel=1e-9)
    assert row["closed"] is True
    thin = row["thin_direction"]
    assert isinstance(thin, list)
    across = thin[0] * -sin(radians(turn)) + thin[1] * cos(radians(turn))
    assert (across, thin[2]) == (pytest.approx(0.0, abs=1e-9), 0.0)
    assert row["thin_direction_deg"] == pytest.approx(degrees(np.arctan2(thin[1], thin[0])), abs=1e-9)
    low = (
        CUBE[:4, :2]
        * [0.6, 4.0]
        @ np.array([[cos(radians(turn)), sin(radians(turn))], [-sin(radians(turn)), cos(radians(turn))]])
    )
    middle = (low.min(axis=0) + low.max(axis=0)) / 2.0 + [10.0, 20.0]
    assert row["place_m"] == pytest.approx([*middle, 1.5], rel=1e-9)


def test_buttresses_do_not_turn_the_thin_direction_and_a_tower_has_none(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    from assess.geometry.mesh import thin_direction
    from assess.geometry.solid import box, join

    wall = box(thickness=0.5, length=6.0, height=4.0, base=(0, 0, 0), density=1.0, name="")
    pier = box(thickness=1.5, length=0.8, height=4.0, base=(1.0, 2.6, 0), density=1.0, name="")
    whole = join([wall, pier], name="")
    assert thin_direction(whole.vertices, whole.triangles) == pytest.approx([1.0, 0.0], abs=1e-12)
    (row,) = listed(capsys, obj(tmp_path, tower=((3.0, 3.0, 20.0), (0, 0, 0), 30.0)))
    assert (row["thin_direction"], row["thin_direction_deg"]) == (None, None)
    assert row["size_m"] == pytest.approx([3.0, 3.0, 20.0], rel=1e-6)


def test_a_broken_part_and_a_broken_file_have_their_rows(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    good = obj(tmp_path, wall=((0.6, 4.0, 3.0), (0, 0, 0), 0.0))
    half = tmp_path / "half.obj"
    half.write_text("\n".join(good.read_text().splitlines()[:-3]) + "\n")
    junk = tmp_path / "junk.glb"
    junk.write_bytes(b"glTF")
    assert ended("geometry", half, junk, good, "--csv") == 0
    rows = list(csv.DictReader(io.StringIO(capsys.readouterr().out)))
    assert [row["closed"] for row in rows] == ["false", "false", "true"]
    assert "it is open" in rows[0]["why_not"]
    assert rows[0]["height_m"] == "3.0"
    assert "cannot be read as GLB" in rows[1]["why_not"]
    assert ended("geometry", half, junk, good) == 0
    text = capsys.readouterr().out
    assert "cannot be read as GLB" in text
    assert "0.6 x 4 x 3" in text


def test_files_of_which_none_can_be_listed_end_with_2(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert ended("geometry", tmp_path / "no.stl") == 2
    assert capsys.readouterr().err.startswith("assess: error: ")
    assert ended("geometry", tmp_path / "no.stl", tmp_path / "neither.ply", "--csv") == 2
    assert len(capsys.readouterr().out.splitlines()) == 3


def test_a_missing_file_is_named_once(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert ended("geometry", tmp_path / "no.stl") == 2
    assert (
        capsys.readouterr().err == f"assess: error: {tmp_path / 'no.stl'}: No such file or directory; check the path\n"
    )


def test_units_axes_and_elements_as_in_the_project_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = obj(tmp_path, **{"wall-1": ((600, 3000, 4000), (0, 0, 0), 0.0), "pier": ((1, 1, 1), (9, 9, 9), 0.0)})
    (row,) = listed(capsys, file, "--unit", "mm", "--up", "y", "--element", "wall-?")
    assert row["name"] == "wall-1"
    assert row["size_m"] == pytest.approx([0.6, 4.0, 3.0], rel=1e-9)
    for unit in ("kg", "nan", "9**9 m", "-1 m"):
        assert ended("geometry", file, "--unit", unit) == 2
        assert "--unit" in capsys.readouterr().err
    assert ended("geometry", file, "--element", "wall-9") == 2
    assert 'it has no element "wall-9"; did you mean wall-1?' in capsys.readouterr().err


def test_no_spreadsheet_runs_the_name_of_a_part(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = obj(tmp_path, **{"=1+1": ((0.6, 4.0, 3.0), (0, 0, 0), 0.0)})
    assert ended("geometry", file, "--csv") == 0
    (row,) = csv.DictReader(io.StringIO(capsys.readouterr().out))
    assert row["name"] == "'=1+1"
