"""Sweeps in the project file: keys, values, and one line for what is wrong."""

from pathlib import Path

import numpy as np
import pytest

from assess.errors import ProjectError
from assess.project.keys import KeySweep, dependents
from assess.project.project_file import json_schema, load, resolve
from tests.support.projects import block, load_project, project_toml, published, refusal_of, wall, write_project

PROJECT = project_toml(
    materials={"stone": {"density": "2000 kg/m^3"}, "brick": {"density": "1800 kg/m^3"}},
    bodies={"wall": wall(length=4.0, height="4.5 m", material="stone"), "tower no. 1": wall(3, 3, 12)},
    mechanisms={
        "wall": block(restitution=0.9, loads=[{"kind": "mass", "mass": 100, "at": [0, 0, 4]}]),
        "spire": block("tower no. 1", cut={"point": [0, 0, 6], "angle": "10 deg"}),
        "published": published(),
    },
)


def one(folder: Path, key: str, values: str) -> KeySweep:
    (variation,) = load_project(folder, PROJECT, f"[analysis.sweep]\nkey = '{key}'\n{values}\n").sweeps
    return variation


def refused(folder: Path, sweep: str) -> str:
    line = refusal_of(folder, PROJECT, sweep)
    assert line.startswith(f"{folder / 'project.toml'}: analysis.sweep")
    assert line.isprintable()
    assert len(line) < 400
    return line


def test_values_keep_the_users_unit_and_the_content_is_si(tmp_path: Path) -> None:
    found = one(tmp_path, "mechanisms.spire.cut.angle", 'values = ["45 deg", "30 deg"]')
    assert (found.unit, [variant.value for variant in found.variants]) == ("deg", [45.0, 30.0])
    angles = [variant.content.mechanisms["spire"].cut.angle for variant in found.variants]  # type: ignore[union-attr]
    np.testing.assert_allclose(angles, np.radians([45, 30]), rtol=1e-15)


@pytest.mark.parametrize(
    ("key", "unit"),
    [
        ("materials.stone.density", "kg/m^3"),
        ("bodies.wall.box.base.2", "m"),
        ("mechanisms.wall.restitution", "-"),
        ("mechanisms.wall.loads.0.mass", "kg"),
        ("mechanisms.wall.loads.0.at.2", "m"),
        ("mechanisms.published.p", "1/s"),
        ("procedures.dmi2008.confidence_factor", "-"),
        ("records.synthetic.count", "-"),
        ("building.height", ""),
    ],
)
def test_plain_numbers_are_si_and_the_unit_is_told(tmp_path: Path, key: str, unit: str) -> None:
    if key == "building.height":  # there is no such table to put a number in
        assert "unknown key" in refused(tmp_path, f'[analysis.sweep]\nkey = "{key}"\nvalues = [9]')
        return
    values = "values = [0.7, 0.9]" if key.endswith("restitution") else "values = [2, 3]"
    assert one(tmp_path, key, values).unit == unit


def test_what_the_file_leaves_out_can_be_swept(tmp_path: Path) -> None:
    base = one(tmp_path, "bodies.wall.box.base.2", 'from = "1 m"\nto = "2 m"\ncount = 3')
    assert [v.content.bodies["wall"].box.base for v in base.variants] == [  # type: ignore[union-attr]
        (0.0, 0.0, 1.0),
        (0.0, 0.0, 1.5),
        (0.0, 0.0, 2.0),
    ]
    cut = one(tmp_path, "mechanisms.wall.cut", "values = [1, 2.5]")
    assert [v.content.mechanisms["wall"].cut for v in cut.variants] == [1.0, 2.5]  # type: ignore[union-attr]
    assert cut.unit == "m"


def test_half_of_a_value_given_for_both_directions_keeps_the_other(tmp_path: Path) -> None:
    found = one(tmp_path, "mechanisms.wall.restitution.positive", "values = [0.5]")
    restitution = found.variants[0].content.mechanisms["wall"].restitution
    assert (restitution.positive, restitution.negative) == (0.5, 0.9)


def test_a_range_is_even_in_its_unit(tmp_path: Path) -> None:
    found = one(tmp_path, "bodies.wall.box.height", 'from = "300 cm"\nto = "420 cm"\ncount = 4')
    assert [variant.value for variant in found.variants] == [300.0, 340.0, 380.0, 420.0]
    assert found.variants[1].name == 'analysis.sweep: bodies.wall.box.height = "340 cm"'
    whole = one(tmp_path, "records.synthetic.count", "from = 2\nto = 6\ncount = 3")
    assert [variant.content.records.synthetic.count for variant in whole.variants] == [2, 4, 6]  # type: ignore[union-attr]


def test_items_of_lists_are_counted_as_errors_print_them_too(tmp_path: Path) -> None:
    for key in ("mechanisms.wall.loads.0.mass", "mechanisms.wall.loads[1].mass"):
        found = one(tmp_path, key, "values = [100, 200]")
        assert (found.key, found.path) == (key, ("mechanisms", "wall", "loads", 0, "mass"))
    for key in ("mechanisms.wall.loads[0].mass", "mechanisms.wall.loads.1.mass", "mechanisms.wall.loads[2].mass"):
        told = refused(tmp_path, f'[analysis.sweep]\nkey = "{key}"\nvalues = [100, 200]')
        assert "loads.0 or loads[1] is the first of a list" in told


def test_an_angle_of_a_level_cut_says_how_to_write_one(tmp_path: Path) -> None:
    sweep = '[analysis.sweep]\nkey = "mechanisms.wall.cut.angle"\nvalues = [1]'
    (tmp_path / "project.toml").write_text(PROJECT.replace("restitution = 0.9", 'cut = "2 m"') + sweep)
    with pytest.raises(ProjectError, match=r'write cut = \{ point = \[0, 0, 2\], angle = "0 deg" \} first'):
        load(tmp_path)


def test_names_with_dots_are_written_as_they_are(tmp_path: Path) -> None:
    found = one(tmp_path, "bodies.tower no. 1.box.height", "values = [10]")
    assert found.path == ("bodies", "tower no. 1", "box", "height")


def test_several_sweeps_stand_side_by_side(tmp_path: Path) -> None:
    sweeps = (
        '[[analysis.sweep]]\nkey = "bodies.wall.box.height"\nvalues = [3, 4]\n'
        '[[analysis.sweep]]\nkey = "materials.stone.density"\nvalues = [1800]\n'
    )
    found = load_project(tmp_path, PROJECT, sweeps).sweeps
    assert [(v.where, len(v.variants)) for v in found] == [("analysis.sweep[1]", 2), ("analysis.sweep[2]", 1)]


@pytest.mark.parametrize(
    ("key", "names"),
    [
        ("materials.stone.density", ("wall",)),
        ("bodies.tower no. 1.box.height", ("spire",)),
        ("mechanisms.published.p", ("published",)),
        ("site.spectrum.s_ds", ("wall", "spire", "published")),
    ],
)
def test_only_what_depends_on_the_key_is_swept(tmp_path: Path, key: str, names: tuple[str, ...]) -> None:
    found = one(tmp_path, key, "values = [2]")
    assert dependents(load(tmp_path).content, found.path) == names


@pytest.mark.parametrize(
    ("key", "words"),
    [
        ("__class__", "unknown key"),
        ("../x", "unknown key"),
        ("", "unknown key"),
        ("a" * 10_000, "unknown key"),
        ("mechanisms", "holds no number"),
        ("mechanisms.spire.__dict__", "unknown key"),
        ("mechanisms.spire.cut.angel", 'did you mean "mechanisms.spire.cut.angle"?'),
        ("mechanisms.spyre.cut.angle", 'did you mean "mechanisms.spire.cut.angle"?'),
        ("bodies.wall.box.base.7", 'did you mean "bodies.wall.box.base.'),
        ("bodies.wall.material", "holds no number"),
        ("mechanisms.wall.loads.0.bearing", "holds no number"),
        ("analysis.sweep.count", "unknown key"),
        ("format", "unknown key"),
        ("title", "holds no number"),
        ("bodies.wall", "not one geometry"),
        ("bodies.wall.box", "not a table"),
    ],
)
def test_a_key_that_is_no_number_is_refused(tmp_path: Path, key: str, words: str) -> None:
    assert words in refused(tmp_path, f'[analysis.sweep]\nkey = "{key}"\nvalues = [1, 2]\n')


@pytest.mark.parametrize(
    ("table", "words"),
    [
        ('key = "\\u0007\\n"\nvalues = [1]', r'key: "\u0007\n": unknown key'),
        ("key = 5\nvalues = [1]", "key: 5: not a text"),
        ('key = "bodies.wall.box.height"', "from: missing; give values"),
        ('key = "bodies.wall.box.height"\nvalues = []', "values: []: too few"),
        ('key = "bodies.wall.box.height"\nvalues = [1]\nto = 2', "beside from, to or count"),
        ('key = "bodies.wall.box.height"\nfrom = 1\nto = 2', "count: missing"),
        ('key = "bodies.wall.box.height"\nfrom = 1\nto = 2\ncount = 1', "must be 2 or more"),
        ('key = "bodies.wall.box.height"\nfrom = 1\nto = 2\ncount = 100000', "must be 1000 or less"),
        ('key = "bodies.wall.box.height"\nfrom = 1\nto = 1\ncount = 2', "the same as from"),
        ('key = "bodies.wall.box.height"\nfrom = "1 m"\nto = "2 cm"\ncount = 2', "in one unit"),
        ('key = "bodies.wall.box.height"\nfrom = "high"\nto = "2 cm"\ncount = 2', "not a number with a unit"),
        ('key = "bodies.wall.box.height"\nvalues = ["1 m", "90 cm"]', "in one unit"),
        ('key = "bodies.wall.box.height"\nvalues = [1, 1]', "stands there twice"),
        ('key = "bodies.wall.box.height"\nvalues = [1, true]', "values[2]: true: not a number"),
        ('key = "bodies.wall.box.height"\nvalues = [1, nan]', "not a finite number"),
        ('key = "bodies.wall.box.height"\nvalues = ["1 s"]', "not a unit of length"),
        ('key = "mechanisms.wall.restitution"\nvalues = ["housner"]', "not a number"),
        ('key = "bodies.wall.box.height"\nvalue = [1]', 'did you mean "values"?'),
    ],
)
def test_a_table_that_is_wrong_is_refused(tmp_path: Path, table: str, words: str) -> None:
    assert words in refused(tmp_path, f"[analysis.sweep]\n{table}\n")


@pytest.mark.parametrize(
    ("key", "values", "words"),
    [
        ("mechanisms.spire.cut.angle", '["45 deg", "95 deg"]', 'angle = "95 deg": not between -90 deg and 90 deg'),
        ("bodies.wall.box.height", "[4, -1]", "height = -1: must be greater than 0"),
        ("mechanisms.wall.restitution", "[0.5, 1.5]", "restitution = 1.5: outside [0, 1]"),
        (
            "mechanisms.wall.cut",
            '["1 m", "5 m"]',
            'mechanisms.wall.cut = "5 m": mechanisms.wall.cut: the cut at z = 5 m',
        ),
    ],
)
def test_the_case_that_is_impossible_is_named(tmp_path: Path, key: str, values: str, words: str) -> None:
    line = refused(tmp_path, f'[analysis.sweep]\nkey = "{key}"\nvalues = {values}\n')
    assert words in line
    assert line.count(f"{key} = ") == 1


def test_a_key_that_no_mechanism_uses_is_refused(tmp_path: Path) -> None:
    sweep = '[materials.spare]\ndensity = 1000\n[analysis.sweep]\nkey = "materials.spare.density"\nvalues = [1, 2]\n'
    assert "no mechanism depends on it" in refused(tmp_path, sweep)


def test_the_sweep_is_resolved_as_it_was_written(tmp_path: Path) -> None:
    one(tmp_path, "bodies.wall.box.height", "from = 3\nto = 4\ncount = 2")
    found = resolve(load(tmp_path))
    assert found["analysis.sweep.from"].value == 3
    assert found["analysis.sweep.from"].given
    assert not found["analysis.sweep.values"].given
    write_project(tmp_path, PROJECT, '[[analysis.sweep]]\nkey = "bodies.wall.box.height"\nvalues = [3]\n')
    assert resolve(load(tmp_path))["analysis.sweep"].value[0]["key"] == "bodies.wall.box.height"


def test_the_schema_for_editors_knows_the_keys() -> None:
    assert {"key", "values", "from", "to", "count"} == set(json_schema()["$defs"]["SweepSection"]["properties"])


def test_a_project_without_sweeps_has_no_variations(tmp_path: Path) -> None:
    assert load_project(tmp_path, PROJECT).sweeps == ()
    with pytest.raises(ProjectError, match="key: missing"):
        load_project(tmp_path, PROJECT, "[analysis.sweep]\nvalues = [1]\n")
