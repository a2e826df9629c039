"""The project file: what is read, and one clear line for what is wrong."""

import hashlib
from functools import partial
from pathlib import Path
from typing import Any

import pytest
from scipy.constants import g

from assess.errors import ProjectError, other_faults
from assess.project.project_file import json_schema, load, resolve
from assess.project.sections.bodies_and_loads import BoxBody, DirectBody, MeshBody, ProfileBody
from tests.support.projects import load_project, replace_once, write_project

PROJECT = """
title = "A wall"
[site]
pga = "0.1 g"
[site.spectrum]
code = "asce7-05"
s_ds = "0.5 g"
s_d1 = "0.25 g"
t_l = "6 s"
[building]
height = "16 m"
[materials.brick]
density = "1800 kg/m^3"
[bodies.wall]
material = "brick"
box = { thickness = "60 cm", length = 3.0, height = "4 m" }
[mechanisms.wall]
kind = "single-block"
blocks = ["wall"]
restitution = 0.9
[mechanisms.other]
kind = "equivalent-block"
p = "1.60 1/s"
uplift = 0.14
radius = "2.84 m"
[analysis]
levels = ["0.1 g", "0.2 g"]
"""
changed = partial(replace_once, PROJECT)


def test_quantities_are_si(tmp_path: Path) -> None:
    content = load_project(tmp_path, PROJECT).content
    assert content.site is not None
    assert content.site.pga == pytest.approx(0.1 * g, rel=1e-15)
    wall = content.bodies["wall"]
    assert isinstance(wall, BoxBody)
    assert (wall.box.thickness, wall.box.length, wall.box.height) == (0.6, 3.0, 4.0)
    assert content.analysis.levels == pytest.approx((0.1 * g, 0.2 * g), rel=1e-15)
    other = content.mechanisms["other"]
    assert other.kind == "equivalent-block"
    assert (other.p, other.uplift, other.radius, other.mass, other.elevation) == (1.6, 0.14, 2.84, 1.0, 0.0)


def test_defaults(tmp_path: Path) -> None:
    content = load_project(tmp_path, PROJECT).content
    wall = content.mechanisms["wall"]
    assert wall.kind == "single-block"
    assert (wall.blocks, wall.direction, wall.sides, wall.hinges) == ((("wall",),), None, None, None)
    assert (wall.restitution.positive, wall.restitution.negative) == (0.9, 0.9)
    assert content.mechanisms["other"].restitution.positive is None
    assert content.building is not None
    assert content.building.period == pytest.approx(0.05 * 8.0)  # 0.05 H^0.75, 16^0.75 = 8
    assert content.records.synthetic is not None
    assert content.records.synthetic.count == 7


def test_the_four_forms_of_a_body(tmp_path: Path) -> None:
    (tmp_path / "wall.stl").write_text("solid wall\nendsolid wall\n")
    forms = """
    [bodies.a]
    material = "brick"
    mesh = "wall.stl"
    mesh_unit = "mm"
    [bodies.b]
    material = "brick"
    profile = [[0, 0], ["1 ft", 0], [0, 1]]
    length = 2
    [bodies.c]
    mass = "2 t"
    centroid = [0, "150 cm"]
    inertia = "3000 kg m^2"
    """
    bodies = load_project(tmp_path, PROJECT + forms).content.bodies
    mesh, profile, direct = bodies["a"], bodies["b"], bodies["c"]
    assert isinstance(mesh, MeshBody)
    assert (mesh.mesh, mesh.mesh_unit) == (tmp_path / "wall.stl", 0.001)
    assert isinstance(profile, ProfileBody)
    assert profile.profile[1] == (0.3048, 0.0)
    assert isinstance(direct, DirectBody)
    assert (direct.mass, direct.centroid, direct.inertia) == (2000.0, (0.0, 1.5), 3000.0)


def test_records_are_found_sorted_and_once(tmp_path: Path) -> None:
    (tmp_path / "r").mkdir()
    for name in ("b.AT2", "a.AT2", "c [x].AT2"):
        (tmp_path / "r" / name).write_text("")
    files = PROJECT + '[records]\nfiles = ["r/c [x].AT2", "r/*.AT2"]\n'
    records = load_project(tmp_path, files).content.records
    assert [path.name for path in records.files] == ["c [x].AT2", "a.AT2", "b.AT2"]
    assert records.synthetic is None


def test_project_remembers_its_file(tmp_path: Path) -> None:
    path = write_project(tmp_path, PROJECT)
    project = load(tmp_path)
    assert (project.path, project.folder) == (path, tmp_path)
    assert project.sha256 == hashlib.sha256(path.read_bytes()).hexdigest()


def test_byte_order_mark_is_accepted(tmp_path: Path) -> None:
    assert load_project(tmp_path, b"\xef\xbb\xbf" + PROJECT.encode()).content.title == "A wall"


def test_a_cut_is_an_elevation_or_a_plane(tmp_path: Path) -> None:
    assert resolve(load_project(tmp_path, PROJECT))["mechanisms.wall.cut"].value is None
    at = resolve(load_project(tmp_path, changed("restitution = 0.9", 'cut = "477 cm"')))
    assert (at["mechanisms.wall.cut"].value, at["mechanisms.wall.cut"].given) == (4.77, True)
    plane = changed("restitution = 0.9", 'cut = { point = [0, 0, "1 ft"], normal = [0.3, 0, 1] }')
    values = resolve(load_project(tmp_path, plane))
    assert values["mechanisms.wall.cut.point"].value == [0.0, 0.0, 0.3048]
    assert values["mechanisms.wall.cut.normal"].value == [0.3, 0.0, 1.0]


def test_resolved_tells_given_from_default(tmp_path: Path) -> None:
    values = resolve(load_project(tmp_path, PROJECT))
    pairs = {key: (value.value, value.given) for key, value in values.items()}
    assert pairs["bodies.wall.box.thickness"] == (0.6, True)
    assert pairs["bodies.wall.box.base"] == ([0.0, 0.0, 0.0], False)
    assert pairs["mechanisms.wall.restitution.negative"] == (0.9, True)
    assert pairs["mechanisms.other.restitution.negative"] == (None, False)
    assert pairs["building.period"] == (pytest.approx(0.4), False)
    assert pairs["records.synthetic.seed"] == (None, False)
    assert pairs["analysis.levels"] == ([pytest.approx(0.1 * g), pytest.approx(0.2 * g)], True)


def test_many_mechanisms_are_read(tmp_path: Path) -> None:
    walls = "".join(
        f'[mechanisms.w{i}]\nkind = "equivalent-block"\np = "{i + 1} 1/s"\nuplift = "0.1"\nradius = "{i + 1} m"\n'
        for i in range(25)
    )
    assert len(load_project(tmp_path, PROJECT + walls).content.mechanisms) == 27


WRONG: dict[str, tuple[str | bytes, str]] = {
    "unknown key": (changed("title =", "titel ="), 'titel: "A wall": unknown key; did you mean "title"?'),
    "unknown key in a body": (
        changed("thickness", "thicknes"),
        'wall.box.thicknes: "60 cm": unknown key; did you mean',
    ),
    "key of a later version": (changed("[analysis]", "[records]\nselect = {}\n[analysis]"), "records.select: "),
    "amplification of no method": (
        changed("restitution = 0.9", "amplification = {}"),
        "mechanisms.wall.amplification.method: missing; write one of",
    ),
    "amplification of another method": (
        changed("restitution = 0.9", 'amplification = { method = "abs" }'),
        'mechanisms.wall.amplification.method: "abs": not supported; write one of "none", "srss", "srss-relative"',
    ),
    "natural frequency of a code's factor": (
        changed("restitution = 0.9", 'amplification = { method = "ec8", natural_frequency = "2 Hz" }'),
        "mechanisms.wall.amplification.natural_frequency: ",
    ),
    "natural frequency in seconds": (
        changed("restitution = 0.9", 'amplification = { method = "srss", natural_frequency = "2 s" }'),
        'amplification.natural_frequency: "2 s": "s" is not a unit of frequency; write a frequency like "2.5 Hz"',
    ),
    "height below the ground": (
        changed("restitution = 0.9", 'amplification = { method = "srss", height = -1 }'),
        "mechanisms.wall.amplification.height: -1: ",
    ),
    "printed factor without soil": (
        changed("restitution = 0.9", 'amplification = { method = "ec8-printed" }'),
        "mechanisms.wall.amplification.soil_factor: missing; soil factor S",
    ),
    "cut of no length": (
        changed("restitution = 0.9", 'cut = "4 kg"'),
        'mechanisms.wall.cut: "4 kg": "kg" is not a unit of length',
    ),
    "cut of a list": (changed("restitution = 0.9", "cut = [0, 0, 1]"), "mechanisms.wall.cut: [0, 0, 1]: not a number"),
    "cut without normal": (
        changed("restitution = 0.9", "cut = { point = [0, 0, 1] }"),
        "mechanisms.wall.cut.normal: missing; square to the plane",
    ),
    "cut with half a point": (
        changed("restitution = 0.9", "cut = { point = [0, 1], normal = [0, 0, 1] }"),
        "mechanisms.wall.cut.point",
    ),
    "wrong dimension": (changed('"4 m"', '"4 s"'), 'bodies.wall.box.height: "4 s": "s" is not a unit of length'),
    "power bomb": (changed('"4 m"', '"9**9**9 m"'), "bodies.wall.box.height: "),
    "nan": (changed('"4 m"', "nan"), "bodies.wall.box.height: NaN: not a finite number"),
    "infinity": (changed('"4 m"', "inf"), "bodies.wall.box.height: Infinity: not a finite number"),
    "true for a number": (changed('"4 m"', "true"), "bodies.wall.box.height: true: not a number"),
    "negative thickness": (changed('"60 cm"', '"-60 cm"'), 'box.thickness: "-60 cm": must be greater than 0'),
    "table twice": (PROJECT + "[bodies.wall]", "bodies.wall stands there twice; give each its own name"),
    "key twice": (changed('blocks = ["wall"]', "sides = 1\nsides = 2"), "line 20, column 10: sides stands there twice"),
    "key twice in a row": (
        changed('blocks = ["wall"]', "loads = [{ mass = 1, mass = 2 }]"),
        ": mass stands there twice",
    ),
    "not TOML": ("title = 1\nthis is prose", "line 2, column 6: not valid TOML"),
    "unknown code": (changed("asce7-05", "ec9"), 'site.spectrum.code: "ec9": not supported; write one of "asce7-05"'),
    "no code": (changed('code = "asce7-05"', ""), "site.spectrum.code: missing; write one of"),
    "unknown kind": (changed("single-block", "three-block"), 'mechanisms.wall.kind: "three-block": not supported'),
    "unknown procedure": (PROJECT + 'procedures = ["ntc2028-linear"]', 'analysis.procedures[1]: "ntc2028-linear": '),
    "unknown material": (
        changed('"brick"', '"stone"'),
        'bodies.wall.material: "stone": no such material; known: "brick"',
    ),
    "unknown body": (
        changed('["wall"]', '["walls"]'),
        'mechanisms.wall.blocks: ["walls"]: no such body; known: "wall"',
    ),
    "two geometries": (changed('"brick"', '"brick"\nmass = 1'), "bodies.wall: "),
    "restitution above 1": (changed("0.9", "1.1"), "mechanisms.wall.restitution: 1.1: outside [0, 1]"),
    "restitution of no name": (
        changed("0.9", '"bouncy"'),
        'mechanisms.wall.restitution: "bouncy": not a known restitution',
    ),
    "level twice": (changed('"0.2 g"', '"0.1 g"'), "analysis.levels: "),
    "no levels": (changed('"0.1 g", "0.2 g"', ""), "analysis.levels: []: too few"),
    "missing key": (changed('t_l = "6 s"', ""), "site.spectrum.t_l: missing; long-period transition period"),
    "no mechanisms": ('title = "x"', "mechanisms: missing; add a table [mechanisms.NAME]"),
    "missing mesh": (changed("box = {", 'mesh = "no.stl" #'), 'bodies.wall.mesh: "no.stl": no such file'),
    "pattern without files": (PROJECT + '[records]\nfiles = ["*.AT2"]', '"*.AT2" matches no file'),
    "no files": (PROJECT + "[records]\nfiles = []", "records.files: []: not a list of files"),
    "direction in words": (
        changed("restitution = 0.9", 'direction = "east"'),
        'direction: "east": not a direction; write [1, 0, 0] for +x, [0, -1, 0] for -y, or "sweep"',
    ),
    "vertical direction": (
        changed("restitution = 0.9", "direction = [0, 0, 1]"),
        "direction: [0, 0, 1]: not horizontal",
    ),
    "newer format": ("format = 2\n" + PROJECT, "format: 2: newer than this program"),
    "format of words": ("format = 'one'\n" + PROJECT, 'format: "one": not a format number'),
    "empty file": ("  \n", "empty; start from an example"),
    "binary junk": (bytes(range(256)), "is not UTF-8"),
    "null bytes": (b"\0" * 100, "not valid TOML"),
    "deep nesting": ("a = " + "[" * 5000, "nested too deeply"),
    "number of 5000 digits": ("a = " + "9" * 5000, "a number of thousands of digits"),
    "line break in a name": (PROJECT + '[materials."a\\nb\\u001b"]\ndensity = -3', r"materials.a\nb\x1b.density: -3"),
    "imperial units": (
        PROJECT + '[report]\nunits = "imperial"',
        'report.units: "imperial": not allowed; write "SI" or "US"',
    ),
}


@pytest.mark.parametrize("case", WRONG)
def test_what_is_wrong_is_one_line(case: str, tmp_path: Path) -> None:
    content, expected = WRONG[case]
    path = write_project(tmp_path, content)
    with pytest.raises(ProjectError) as caught:
        load(path)
    text = str(caught.value)
    assert text.startswith(f"{path}: ")
    assert expected in text
    assert text.isprintable()


def faults_of(folder: Path, text: str) -> list[str]:
    """Return where the faults of a project file are, in the order in which they are told."""
    with pytest.raises(ProjectError) as refused:
        load_project(folder, text)
    lines = (str(refused.value), *other_faults(refused.value))
    assert all(line.startswith(f"{folder / 'project.toml'}: ") and line.isprintable() for line in lines)
    assert str(refused.value).endswith(f" (and {len(lines) - 1} more)") or len(lines) == 1
    return [line.split(": ")[1] for line in lines]


def test_every_fault_is_told_in_one_round(tmp_path: Path) -> None:
    three = changed('"4 m"', '"4 s"').replace('"2.84 m"', '"2.84 kg"').replace('p = "1.60 1/s"', "p = 0")
    assert sorted(faults_of(tmp_path, three)) == [
        "bodies.wall.box.height",
        "mechanisms.other.p",
        "mechanisms.other.radius",
    ]


def test_unknown_and_missing_keys_hide_no_wrong_value_beside_them(tmp_path: Path) -> None:
    text = changed('p = "1.60 1/s"', "q = 1").replace('"2.84 m"', '"2.84 kg"')
    text = text.replace('density = "1800 kg/m^3"', 'densty = 1\nfriction = "a"').replace('"4 m"', '"4 s", colour = 1')
    assert sorted(faults_of(tmp_path, text)) == [
        "bodies.wall.box.colour",
        "bodies.wall.box.height",
        "materials.brick.densty",  # and not that density is missing: it is the key that was meant
        "materials.brick.friction",
        "mechanisms.other.p",
        "mechanisms.other.q",
        "mechanisms.other.radius",
    ]


def test_names_that_no_table_has_are_told_beside_faults_elsewhere(tmp_path: Path) -> None:
    text = changed('blocks = ["wall"]', 'blocks = ["wal"]').replace('material = "brick"', 'material = "stone"')
    names = ["bodies.wall.material", "mechanisms.wall.blocks"]
    assert faults_of(tmp_path, text) == names
    assert sorted(faults_of(tmp_path, text.replace('t_l = "6 s"', "t_1 = 6"))) == [*names, "site.spectrum.t_1"]
    scattering = text.replace('"2.84 m"', '{ mean = "2.84 m", cov = 2 }')
    assert sorted(faults_of(tmp_path, scattering)) == sorted([*names, "mechanisms.other.radius.cov"])


def test_every_source_of_no_key_is_told(tmp_path: Path) -> None:
    sources = '[report.sources]\n"bodies.a" = "measured: x"\n"materials.b" = "measured: x"\n'
    sweep = '[analysis.sweep]\nkey = "bodies.wall.box.depth"\nvalues = [1]\n'
    plain = PROJECT.replace("[analysis]", sources + "[analysis]")
    assert faults_of(tmp_path, plain) == ["report.sources", "report.sources"]
    assert faults_of(tmp_path, plain + sweep) == ["analysis.sweep.key", "report.sources", "report.sources"]


def test_what_follows_from_a_fault_is_no_second_one(tmp_path: Path) -> None:
    with pytest.raises(ProjectError, match=r'analysis\.levels\[1\]: "x": .* or a number in m/s\^2$'):
        load_project(tmp_path, changed('["0.1 g", "0.2 g"]', '["x"]'))  # that none is left is no second fault


@pytest.mark.parametrize("path", ["missing.toml", "", "/dev/zero", "a\0b"])
def test_no_such_project(path: str, tmp_path: Path) -> None:
    with pytest.raises(ProjectError) as caught:
        load(tmp_path / path)
    assert str(caught.value).isprintable()


def references(schema: Any) -> list[str]:
    if isinstance(schema, dict):
        own = [schema["$ref"]] if "$ref" in schema else []
        return own + [ref for value in schema.values() for ref in references(value)]
    return [ref for item in schema for ref in references(item)] if isinstance(schema, list) else []


def test_json_schema_is_closed_and_strict() -> None:
    schema = json_schema()
    definitions = schema["$defs"]
    assert schema["$schema"].endswith("2020-12/schema")
    assert {ref.removeprefix("#/$defs/") for ref in references(schema)} == set(definitions)
    assert schema["required"] == ["mechanisms"]
    for table in (schema, *(each for each in definitions.values() if "pattern" not in each)):
        assert table["type"] == "object"
        assert table["additionalProperties"] is False
        assert set(table.get("required", [])) <= set(table["properties"])
        assert [key for key in table.get("required", []) if not table["properties"][key].get("description")] == []
    thickness = definitions["BoxSection"]["properties"]["thickness"]
    length = {"$ref": "#/$defs/quantity-of-length", "exclusiveMinimum": 0}
    assert thickness["anyOf"] == [length, {"$ref": "#/$defs/UncertainNumber-of-length"}]
    assert thickness["description"] == 'size along x, like "1.25 m"'


def test_a_bare_number_that_is_hardly_an_earthquake_is_told(tmp_path: Path) -> None:
    slip = changed('levels = ["0.1 g", "0.2 g"]', 'levels = [0.1, 1.3, "0.01 g"]').replace('"0.25 g"', "0.15")
    messages = load_project(tmp_path, slip).messages
    assert [(message.key, message.where, message.text) for message in messages] == [
        ("unit", "site.spectrum.s_d1", '0.15 m/s2 is 0.0153 g; write "0.15 g" if that was meant'),
        ("unit", "analysis.levels[1]", '0.1 m/s2 is 0.0102 g; write "0.1 g" if that was meant'),
    ]
    assert load_project(tmp_path, PROJECT).messages == ()


def test_a_bare_size_that_is_hardly_a_wall_is_told(tmp_path: Path) -> None:
    thick = "[bodies.thick]\nmaterial = 'brick'\nbox = { thickness = 350, length = 2, height = 3 }\n"
    (message,) = load_project(tmp_path, f"{PROJECT}\n{thick}").messages
    assert (message.key, message.where) == ("box-size", "bodies.thick.box.thickness")
    assert (
        message.text == 'a number without a unit is in m, so this is 350 m; if another unit was meant, write "350 mm"'
    )


@pytest.mark.parametrize(
    ("sources", "said"),
    [
        ('"materials.stonne" = "measured: cores"', "report.sources"),
        ('"materials" = "cores"', "begin with"),
    ],
)
def test_a_source_belongs_to_a_key_and_says_its_kind(tmp_path: Path, sources: str, said: str) -> None:
    path = write_project(tmp_path, f"{PROJECT}\n[report.sources]\n{sources}\n")
    with pytest.raises(ProjectError, match=said):
        load(path)


@pytest.mark.parametrize(
    "key", ["bodies.wall.box.height", "bodies.wall.box", "analysis.levels[2]", "site.spectrum.s_ds", "mechanisms"]
)
def test_a_source_may_belong_to_a_value_a_table_or_an_item(tmp_path: Path, key: str) -> None:
    assert (
        key in load_project(tmp_path, f'{PROJECT}\n[report.sources]\n"{key}" = "measured: x"\n').content.report.sources
    )


@pytest.mark.parametrize(
    "key", ["bodies.wall.box.heigth", "analysis.levels[3]", "bodies.wal", "bodies.wall.box.height.x"]
)
def test_a_source_of_what_is_no_key_names_the_nearest(tmp_path: Path, key: str) -> None:
    with pytest.raises(ProjectError, match="not a key of this file; do you mean"):
        load_project(tmp_path, f'{PROJECT}\n[report.sources]\n"{key}" = "measured: x"\n')
