"""The files that a project names: each model is read once a run, and all that is wrong with them is told at once."""

import hashlib
import json
from pathlib import Path

import pytest
from scipy.spatial.transform import Rotation

from assess.errors import AssessError, other_faults
from assess.examples import copy_example
from assess.geometry import mesh
from assess.geometry.formats.mesh_file import MeshFile
from assess.geometry.solid import box
from assess.project.build import build, build_to_decide
from assess.project.project_file import load
from assess.study.run import find_verdict
from tests.support.mesh_files import gltf
from tests.support.projects import block, project_toml


@pytest.fixture(scope="module")
def house(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The example whose bodies are five elements of one IFC file."""
    folder = tmp_path_factory.mktemp("models") / "house"
    copy_example("house", folder)
    return folder


def test_a_model_is_read_once_though_two_states_are_assessed(house: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A tie without a source is replaced, so that the project is read a second time with another value."""
    text = (house / "project.toml").read_text(encoding="utf-8")
    (house / "unsourced.toml").write_text(
        text.replace('"mechanisms.gable.loads[1]" =', '"bodies.front" ='), encoding="utf-8"
    )
    read: list[Path] = []
    read_mesh_file = mesh.read_mesh_file
    monkeypatch.setattr(
        mesh, "read_mesh_file", lambda file, *, where: (read.append(file), read_mesh_file(file, where=where))[1]
    )
    study = build(load(house / "unsourced.toml"))
    assert find_verdict(study).other_state is not None
    assert [file.name for file in read] == ["house.ifc"]


def test_a_model_that_changes_while_it_is_read_is_refused(house: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """ifcopenshell, cascadio and rhino3dm open the path themselves: what they read may not be what is hashed."""
    read_mesh_file, ifc = mesh.read_mesh_file, house / "house.ifc"
    whole = ifc.read_bytes()

    def read_while_it_is_saved(file: Path, *, where: str) -> MeshFile:
        found = read_mesh_file(file, where=where)
        file.write_bytes(whole + b"\n")
        return found

    monkeypatch.setattr(mesh, "read_mesh_file", read_while_it_is_saved)
    for build_it in (build, build_to_decide):
        ifc.write_bytes(whole)
        with pytest.raises(AssessError, match=r"house\.ifc: changed while it was read; run again"):
            build_it(load(house))
    ifc.write_bytes(whole)


def test_the_files_that_a_gltf_names_are_inputs(tmp_path: Path) -> None:
    """Another buffer is another stamp; the digest is that of the bytes."""
    wall = box(thickness=0.5, length=2.0, height=4.0, base=(0.0, 0.0, 0.0), density=2000.0, name="wall")
    turned = wall.vertices @ Rotation.from_euler("x", -90, degrees=True).as_matrix().T
    header, content = gltf(turned, wall.triangles, [{"mesh": 0, "name": "wall"}])
    header["buffers"][0]["uri"] = "m.bin"
    (tmp_path / "m.gltf").write_text(json.dumps(header))
    (tmp_path / "m.bin").write_bytes(content)
    bodies = {"wall": {"material": "brick", "mesh": "m.gltf"}}
    (tmp_path / "project.toml").write_text(project_toml(bodies=bodies, mechanisms={"wall": block()}))
    inputs = {each.path: each.sha256 for each in build(load(tmp_path)).inputs}
    assert list(inputs) == ["project.toml", "m.gltf", "m.bin"]
    assert inputs["m.bin"] == hashlib.sha256(content).hexdigest()


def test_faults_of_bodies_and_mechanisms_are_told_at_once(house: Path) -> None:
    text = (house / "project.toml").read_text(encoding="utf-8")
    for right, wrong in (
        ('element = "Upper floor"', 'element = "Uper floor"'),
        ('element = "Roof"', 'element = "Rof"'),
        ('cut = "5.95 m"', 'cut = "59.5 m"'),
    ):
        assert right in text
        text = text.replace(right, wrong)
    (house / "wrong.toml").write_text(text, encoding="utf-8")
    project = load(house / "wrong.toml")
    with pytest.raises(AssessError) as refused:
        build(project)
    lines = (str(refused.value), *other_faults(refused.value))
    assert [line.removeprefix(f"{project.path}: ").split(":")[0] for line in lines] == [
        'body "floor"',
        'body "roof"',
        "mechanisms.gable.cut",
    ]
    assert lines[0].endswith("did you mean Upper floor? (and 2 more)")
