"""A project in US units reads so on the terminal."""

from __future__ import annotations

from pathlib import Path

import pytest

from assess.cli import main

WALL = """
[report]
units = "US"

[materials.stone]
density = "2000 kg/m^3"

[bodies.wall]
material = "stone"
box = { thickness = "0.3048 m", length = "3.048 m", height = "3.048 m" }

[mechanisms.wall]
kind = "single-block"
blocks = ["wall"]
direction = [1, 0, 0]
sides = "one"
loads = [{ kind = "force", force = "444.8222 N", direction = [-1, 0, 0], at = [0, 0, 3.048] }]
"""


@pytest.mark.parametrize(
    ("command", "words"),
    [
        ("check", ("A at x = 0.5 ft, z = 0 ft", "force -0.1 kip along the direction", "R [ft]", "mass [lb]")),
        ("parameters", ("R [ft]", "I [lb ft²]", "M [kip ft]", "H [kip]", "lambda [-]")),
    ],
)
def test_check_and_parameters_are_in_the_units_of_the_report(
    command: str, words: tuple[str, ...], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "project.toml").write_text(WALL)
    with pytest.raises(SystemExit):
        main([command, str(tmp_path)])
    printed = capsys.readouterr().out
    assert all(word in printed for word in words)
    assert " m," not in printed
    assert "kN" not in printed
