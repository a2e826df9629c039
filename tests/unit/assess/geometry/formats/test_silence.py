"""What packages that read files print, log and warn of does not reach the streams."""

import logging
import os
import sys
import warnings
from pathlib import Path

import pytest

from assess.errors import GeometryError
from assess.geometry.formats.mesh_file import MeshFile, file_from_meshes
from assess.geometry.formats.readers import READERS, read_mesh_file


def loud(file: Path) -> MeshFile:
    sys.stdout.write("printed\n")
    sys.stderr.write("written\n")
    os.write(1, b"by the process\n")
    os.write(2, b"by the process\n")
    warnings.warn("warned of", stacklevel=1)
    try:
        raise ValueError("broken")
    except ValueError:
        logging.getLogger("some.reader").warning("logged", exc_info=True)
    if file.stem == "bad":
        raise ValueError("of no use")
    return file_from_meshes([])


def test_nothing_is_heard_of_a_reader(
    tmp_path: Path, capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(READERS, ".stl", loud)  # type: ignore[arg-type]
    for name in ("good", "bad"):
        (tmp_path / f"{name}.stl").write_bytes(b"")
    assert read_mesh_file(tmp_path / "good.stl", where="mesh").elements == ()
    with pytest.raises(GeometryError, match="of no use"):
        read_mesh_file(tmp_path / "bad.stl", where="mesh")
    assert capfd.readouterr() == ("", "")
    sys.stdout.write("heard\n")
    os.write(2, b"heard")
    assert capfd.readouterr() == ("heard\n", "heard")
