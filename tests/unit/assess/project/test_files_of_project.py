"""The files that a project names: each model is read once a run, and all that is wrong with them is told at once."""

from pathlib import Path

import pytest

from assess.errors import AssessError, other_faults
from assess.examples import copy_example
from assess.geometry import mesh
from assess.project.build import build
from assess.project.project_file import load
from assess.study.run import find_verdict


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
        'mechanism "gable"',
    ]
    assert lines[0].endswith("did you mean Upper floor? (and 2 more)")
