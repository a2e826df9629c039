"""Numbers that no wall and no site has get a warning; those at the limit get none."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.support.projects import NTC, block, lines, project_toml, study_of, wall


@pytest.mark.parametrize(
    ("density", "friction", "level", "corner", "keys"),
    [
        ("3500 kg/m^3", 2.0, "3 g", "1 s", set()),
        ("100 kg/m^3", 2.0, "3 g", "1 s", set()),
        ("9000 kg/m^3", 2.0, "3 g", "1 s", {"density-odd"}),
        ("20 kg/m^3", 2.0, "3 g", "1 s", {"density-odd"}),
        ("1900 kg/m^3", 9.5, "3 g", "1 s", {"friction-large"}),
        ("1900 kg/m^3", 0.5, "98.1 g", "1 s", {"level-large"}),
        ("1900 kg/m^3", 0.5, "0.1 g", "9.3 s", {"corner-long"}),
        ("1900 kg/m^3", 0.5, "0.1 g", "0.1 s", set()),
        ("1900 kg/m^3", 0.5, "0.1 g", "0.03 s", {"corner-short"}),
    ],
)
def test_implausible_numbers_get_a_warning(
    tmp_path: Path, density: str, friction: float, level: str, corner: str, keys: set[str]
) -> None:
    text = project_toml(
        site={"limit_state": "SLV", "spectrum": NTC | {"t_c_star": corner}},
        materials={"m": {"density": density, "friction": friction}},
        bodies={"wall": wall(0.8, height=5.0, material="m")},
        mechanisms={"wall": block("wall")},
        analysis={"levels": [level]},
    )
    found = {each.key for each in study_of(tmp_path, text).messages}
    assert found & {"density-odd", "friction-large", "level-large", "corner-long", "corner-short"} == keys


def test_a_row_of_the_hazard_with_an_implausible_corner_is_named(tmp_path: Path) -> None:
    rows = [{"return_period": years, "a_g": "0.1 g", "f_0": 2.4, "t_c_star": corner} for years, corner in ROWS]
    plain = {key: value for key, value in NTC.items() if key not in ("a_g", "f_0", "t_c_star")}
    text = project_toml(
        site={"spectrum": plain | {"hazard": rows, "nominal_life": 50, "use_class": "II"}},
        bodies={"wall": wall(0.8, height=5.0)},
        mechanisms={"wall": block("wall")},
    )
    found = [each.where for each in study_of(tmp_path, text).messages if each.key == "corner-short"]
    assert found == ["site.spectrum.hazard[2].t_c_star"]


ROWS = ((30, "0.25 s"), (475, "0.03 s"), (2475, "0.35 s"))


@pytest.mark.parametrize(("area", "told"), [("80 mm^2", []), ("800 mm^2", ["area"])])
def test_one_bar_of_two_mechanisms_with_two_sections_is_told(tmp_path: Path, area: str, told: list[str]) -> None:
    tie = (
        'loads = [{{ kind = "tie", at = [0, 0, 2.5], anchor = [-9, 0, 2.5], area = "{}", young_modulus = "210 GPa", '
        'yield_stress = "235 MPa", length = "9 m", fracture_strain = 0.1, strength = "90 kN" }}]'
    )
    whole = lines(block(direction=[1, 0, 0], sides="one"), tie.format("80 mm^2"))
    upper = lines(block(direction=[1, 0, 0], sides="one", cut="1 m"), tie.format(area))
    made = study_of(
        tmp_path, project_toml(bodies={"wall": wall(0.5, 4.0, 3.0)}, mechanisms={"whole": whole, "upper": upper})
    )
    found = [each for each in made.messages if each.key == "one-bar-twice"]
    assert [each.where for each in found] == ["mechanisms.upper.loads[1]" for _ in told]
    assert ["area" in str(each) for each in found] == [True for _ in told]
