"""Options of every command at hostile numbers: a result or one line of refusal, and none is passed over in silence."""

from __future__ import annotations

import re
import shutil
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any, get_args

import numpy as np
import pytest
import trimesh
import typer

from assess.cli import main
from assess.cli.app import app
from records.processing import at2_text
from records.record import make_record
from tests.support.command import ended_with
from tests.support.projects import NTC, block, project_toml, published, tables_toml, wall

VALUES = ("nan", "inf", "-1", "0", "1e300")
PROJECT = tables_toml(
    mechanisms={"parapet": published(2.4, 0.2, 1.2)},
    analysis={
        "pulses": {
            "frequency": {"from": "1 Hz", "to": "2 Hz", "count": 2},
            "amplitude": {"from": "0 g", "to": "4 g", "count": 2},
        }
    },
)
RECORDS = ("{at2}",), ("{bare}", "--unit", "g", "--step", "0.01")
"""A file that says all, and one that says nothing: what is wrong is refused with both."""
USES: dict[str, Sequence[tuple[str, ...]]] = {
    "run": [("{project}", "-o", "{out}")],
    "envelope": [("{project}",)],
    "fragility": [("{project}",)],
    "batch": [("{portfolio}", "-o", "{out}-batch", "--rows-only")],
    "mechanisms": [("{walls}",)],
    "new": [("{out}-drawn", "--from", "{mesh}")],
    "retrofit": [
        (
            "{judged}",
            "--target",
            "index",
            "--reach",
            "0.1",
            "--vary",
            "bodies.wall.box.thickness=0.5, 0.6 m",
            "--price",
            "bodies.wall.box.thickness=900",
        ),
    ],
    "diff": [("{results}", "{results}")],
    "verify": [("housner_1963", "--quick", "-o", "{out}-annex")],
    "records list": RECORDS,
    "records convert": [(*files, "-o", "{out}.csv") for files in (*RECORDS, ("{at2}", "{east}", "--azimuth", "30"))],
    "records spectra": [*RECORDS, ("{folder}",)],
    "records index": [("{folder}",)],
    "records scale": [(*RECORDS[0], *more, "--target", "{target}") for more in ((), ("--to", "pga"), ("--at", "1"))],
    "records select": [("{folder}", "--target", "{target}", "--count", "1", "--jobs", "1")],
}
SPECTRA: dict[str, dict[str, str]] = {
    "asce7-16 s_s": {"s_s": "0.5", "s_1": "0.2", "site_class": "B", "t_l": "6"},
    "asce7-16 s_ds": {"s_ds": "3", "s_d1": "1", "t_l": "6"},
    "ec8": {"a_g": "2", "ground_type": "B", "type": "1", "importance_factor": "1", "pga": "2", "damping": "0.05"},
    "nzs1170.5": {"subsoil": "C", "z": "0.3", "r": "1", "near_fault_distance": "10"},
    "nzs1170.5 return": {"subsoil": "C", "z": "0.3", "return_period": "500"},
    "ntc2018": {
        "a_g": "2",
        "f_0": "2.4",
        "t_c_star": "0.3",
        "soil": "B",
        "topography": "T2",
        "relief_position": "0.5",
    },
}
MAY_BE_ZERO = {"near_fault_distance", "relief_position"}
WORDS = {"site_class", "ground_type", "subsoil", "soil", "topography", "type"}


def commands(command: Any, name: str = "") -> Iterator[tuple[str, Any]]:
    """Every command by its name."""
    if not hasattr(command, "commands"):
        yield name, command
        return
    for each, inner in command.commands.items():
        yield from commands(inner, f"{name} {each}".strip())


OPTIONS = [
    (name, one.opts[-1], one.nargs)
    for name, command in commands(typer.main.get_command(app))
    if name not in ("spectrum", "serve")  # the one has a test of its own below, the other runs until it is stopped
    for one in command.params
    for annotation in [one.type_descriptor.annotation]
    if one.opts[-1].startswith("--")  # an option that takes numbers, or the unit of numbers
    and (({annotation, *get_args(annotation)} & {int, float}) or one.opts[-1] in ("--unit", "--to-unit"))
]


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """What the commands need, by its name in USES."""
    root = tmp_path_factory.mktemp("options")
    (root / "motions").mkdir()
    time = 0.01 * np.arange(600)
    shake = np.sin(np.pi * time / 6) ** 2 * np.sin(12 * time)
    for name, component in (("n", "0"), ("e", "90")):
        made = make_record("x", shake * (1.0 if name == "n" else 0.7), 0.01, event="Q", component=component)
        (root / f"{name}.AT2").write_text(at2_text(made))
        (root / "motions" / f"{name}.AT2").write_text(at2_text(made))
    (root / "bare.txt").write_text("\n".join(f"{a:.9f}" for a in shake))
    (root / "target.csv").write_text("period [s],acceleration [g]\n0,0.1\n0.1,0.25\n0.5,0.25\n4,0.02\n")
    (root / "walls.toml").write_text(PROJECT)
    (root / "portfolio" / "one").mkdir(parents=True)
    (root / "portfolio" / "one" / "project.toml").write_text(PROJECT)
    trimesh.creation.box((4.0, 0.5, 3.0)).export(root / "wall.stl")
    boxes = {"wall": {"material": "m", "box": {"thickness": 0.5, "length": 4.0, "height": 3.0}}}
    (root / "boxes.toml").write_text(tables_toml(materials={"m": {"density": 1800}}, bodies=boxes))
    (root / "judged.toml").write_text(
        project_toml(
            site={"spectrum": {**NTC, "a_g": "0.13 g"}, "limit_state": "SLV"},
            verdict={"basis": "ntc2018", "procedures": ["ntc2018-linear"]},
            bodies={"wall": wall(0.5, 4.0, 6.0)},
            mechanisms={"wall": block(direction=[1, 0, 0], sides="one")},
        )
    )
    with pytest.raises(SystemExit):
        main(["envelope", str(root / "walls.toml"), "-o", str(root / "results"), "--jobs", "1"])
    paths = {"at2": "n.AT2", "east": "e.AT2", "bare": "bare.txt", "folder": "motions", "target": "target.csv"}
    paths |= {"mesh": "wall.stl", "walls": "boxes.toml", "judged": "judged.toml"}
    more = {"project": "walls.toml", "results": "results/envelopes.json", "portfolio": "portfolio", "out": "out"}
    return {key: str(root / path) for key, path in (paths | more).items()}


@pytest.mark.parametrize(("command", "option", "count"), OPTIONS)
def test_hostile_numbers(
    command: str, option: str, count: int, files: dict[str, str], capsys: pytest.CaptureFixture[str]
) -> None:
    for value in VALUES:
        codes = set()
        for use in USES[command]:
            Path(f"{files['out']}.csv").unlink(missing_ok=True)  # what is there is not written over
            shutil.rmtree(f"{files['out']}-drawn", ignore_errors=True)
            typed = [*(part.format(**files) for part in use), option, *[value] * count]
            code, line = ended_with(capsys, *command.split(), *typed)
            assert code in (0, 2) or (code, command) == (1, "retrofit"), (typed, line)  # 1: nothing reaches it
            assert code < 2 or re.match(r"assess: error: \S", line), line
            codes.add(code)
        assert value != "nan" or codes == {2}, typed
        assert len(codes) == 1 or option in ("--azimuth", "--rotd", "--damping", "--at"), (value, typed)


@pytest.mark.parametrize(
    ("use", "key"), [(use, key) for use, keys in SPECTRA.items() for key in keys if key not in WORDS]
)
def test_hostile_numbers_of_spectra(use: str, key: str, capsys: pytest.CaptureFixture[str]) -> None:
    given = SPECTRA[use]
    base = ("spectrum", "--code", use.split()[0], "--csv")
    usual = ended_with(
        capsys, *base, *(part for name, text in given.items() for part in (f"--{name.replace('_', '-')}", text))
    )
    assert usual[0] == 0, usual
    for value in VALUES:
        typed = given | {key: value}
        code, line = ended_with(
            capsys, *base, *(part for name, text in typed.items() for part in (f"--{name.replace('_', '-')}", text))
        )
        assert code == 2 or (code == 0 and value == "0" and key in MAY_BE_ZERO), (typed, line)
        assert code == 0 or line.startswith("assess: error: "), line


def test_every_command_with_numbers_is_used_here() -> None:
    assert {name for name, *_ in OPTIONS} == USES.keys()
    assert len(OPTIONS) > 30
