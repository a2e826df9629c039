"""The IFC model of the example `house` is read whole: its parts, their volumes and what touches what."""

from __future__ import annotations

from pathlib import Path

import pytest

from assess.examples import house
from assess.geometry.mesh import load_solid

pytest.importorskip("ifcopenshell", reason="the extra 'ifc' is not installed")

FRONT = 9.0 * 0.5 * 6.0 - 0.5 * (1.2 * 2.2 + 4 * 1.0 * 1.3) - 8.0 * 0.25 * 0.25  # less door, windows and slot
GABLE = 0.5 * 6.0 * (5.95 + 0.5 * (7.15 - 5.95))
VOLUMES = {
    "Street front": FRONT,
    "Back wall": 27.0 - 0.5 * 6 * 1.3 - 0.5,
    "Side wall left": GABLE,
    "Side wall right": GABLE,
    "Upper floor": 8.0 * 6.5 * 0.25,
    "Roof": 9.0 * (0.5 * 7.0 * (6.3 + 7.5) - 0.5 * 6.0 * (6.0 + 7.2) - 6.0),
}


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("house") / "house.ifc"
    path.write_text(house.model(), encoding="utf-8")
    return path


@pytest.mark.parametrize("name", VOLUMES)
def test_a_part_is_a_closed_body_of_its_volume(file: Path, name: str) -> None:
    body = load_solid(file, density=1.0, name="part", element=name)
    assert body.mass == pytest.approx(VOLUMES[name], rel=1e-9)
    assert body.history == ()


def test_every_part_is_named_once_with_an_identifier_of_its_own() -> None:
    assert {part.name for part in house.elements()} == set(VOLUMES)
    identifiers = [line.split("'")[1] for line in house.model().splitlines() if "('" in line and line[0] == "#"]
    assert len(set(identifiers)) == len(identifiers)
    assert all(len(each) == 22 for each in identifiers)


def test_the_schema_finds_no_fault(file: Path) -> None:
    import ifcopenshell
    import ifcopenshell.validate as validate

    faults = validate.json_logger()
    validate.validate(ifcopenshell.open(str(file)), faults)
    assert faults.statements == []
