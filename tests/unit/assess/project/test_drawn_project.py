"""Projects drawn from a model: they state what was found, run once filled in, and are written whole or not at all."""

import tomllib
from dataclasses import replace
from math import cos, pi, radians, sin

import pytest

from assess.codes.checklists import CHECKLISTS
from assess.errors import GeometryError, ProjectError
from assess.examples import house as example_house
from assess.examples.surfaces import ClosedSurface, ply
from assess.geometry.solid import profile
from assess.mechanisms.chain import uplift_multiplier
from assess.model.structure import Structure
from assess.project.build import build
from assess.project.drawn_project import draw_project, is_stated, remarks_of_model, write_project
from assess.project.project_file import load
from assess.project.sections.content import checklist
from assess.verbs import run
from tests.support.buildings import STONE, block, house, part_of, touching
from tests.support.command import ended, ended_with
from tests.support.drawings import fill_in, obj_of


@pytest.fixture(scope="module")
def drawn(tmp_path_factory: pytest.TempPathFactory):
    place = tmp_path_factory.mktemp("drawn")
    (place / "house.obj").write_text(obj_of(house(caps=True).parts))
    structure, candidates = write_project([place / "house.obj"], place / "new")
    return place / "new", structure, candidates


def multipliers(folder):
    study = build(load(folder))
    return {each.name: min(map(uplift_multiplier, each.chains)) for each in study.mechanisms}


def test_a_project_states_what_was_found(drawn) -> None:
    folder, _, candidates = drawn
    found = {each.name: each.multiplier for each in candidates if is_stated(each)}
    assert multipliers(folder) == pytest.approx(found, rel=2e-3)
    assert {"front-1-overturning-of-storeys", "gable-gable", "chimney-chimney", "front-2-bending"} <= set(found)


def test_floors_alone_are_no_building(tmp_path) -> None:
    parts = [part_of(f"Slab {z}", block((0, 9), (0, 7), (z, z + 0.3)), "floor", normal=(0, 1)) for z in (0, 3)]
    (tmp_path / "slabs.obj").write_text(obj_of(parts))
    with pytest.raises(GeometryError, match=r"nothing in it stands, .* of 2 parts it has Slab_0 \(floor\), Slab_3"):
        write_project([tmp_path / "slabs.obj"], tmp_path / "new")
    assert not (tmp_path / "new").exists()


def test_what_reading_the_model_warned_of_stands_at_the_top(drawn) -> None:
    folder, structure, _ = drawn
    head = (folder / "project.toml").read_text(encoding="utf-8").split("title =")[0]
    assert structure.warnings
    assert all(str(each).split(":")[0] in head for each in structure.warnings)
    said = remarks_of_model((folder / "project.toml").read_text(encoding="utf-8"))
    assert said == (
        *(f"Warning: {each}." for each in structure.warnings),
        *(f"Left out: {each}." for each in structure.left_out_texts),
    )


def test_a_roof_that_hovers_over_its_walls_is_named(tmp_path) -> None:
    parts = [
        part_of("Wall", block((0, 0.5), (0, 6), (0, 3))),
        part_of("Roof", block((0, 4), (0, 6), (3.1, 3.3)), "roof", normal=(0, 1)),
    ]
    (tmp_path / "house.obj").write_text(obj_of(parts))
    structure, _ = write_project([tmp_path / "house.obj"], tmp_path / "new")
    (found,) = [str(each) for each in structure.warnings if "bear on no wall" in str(each)]
    assert "1 (Roof)" in found


def test_shares_that_the_drawing_leaves_open_are_stated_with_a_source_to_fill_in(tmp_path) -> None:
    """A flat roof on all four walls: each mechanism has the half that its walls may carry, as it is worse."""
    walls = house(storeys=1).parts[:4]
    roof = part_of("Roof", block((0, 9), (0, 7), (3, 3.3), density=400.0), "roof", normal=(0, 1))
    (tmp_path / "house.obj").write_text(obj_of((*walls, roof)))
    _, candidates = write_project([tmp_path / "house.obj"], tmp_path / "new")
    text = (tmp_path / "new" / "project.toml").read_text(encoding="utf-8")
    assert text.count("share = 0.5 }") == 4
    assert '# "mechanisms.front-1-overturning.loads[1].share" = ' in text
    found = {each.name: each.multiplier for each in candidates if is_stated(each)}
    assert multipliers(tmp_path / "new") == pytest.approx(found, rel=2e-3)


def test_bodies_are_elements_of_the_model(drawn) -> None:
    folder, _, _ = drawn
    text = (folder / "project.toml").read_text(encoding="utf-8")
    assert 'front-1 = { material = "masonry", mesh = "house.obj", element = "Front_1" }' in text
    assert not (folder / "meshes").exists()
    assert 'height = "8 m"' in text


def test_corners_and_wedges_are_stated_and_tick_the_list(drawn) -> None:
    folder, _, candidates = drawn
    text = (folder / "project.toml").read_text(encoding="utf-8")
    assert "# - Front_1: overturning of a corner" not in text
    content = load(folder).content
    assert "vertical-bending" not in content.report.not_examined
    assert all(map(is_stated, candidates))
    examined = {mechanism.kind: mechanism.examines for mechanism in content.mechanisms.values()}
    assert examined["corner"] == ("corner",)
    (one,) = (each for each in candidates if each.name == "front-1-corner")
    stated = content.mechanisms["front-1-corner"]
    assert [wedge.walls for wedge in stated.wedges] == [("front-1", "front-2"), ("left-1", "left-2", "gable")]
    assert [wedge.angle for wedge in stated.wedges] == pytest.approx(
        [wedge.angle for wedge in one.definition.wedges], abs=1e-6
    )


@pytest.mark.parametrize("kind", ["house", "church"])
def test_every_entry_of_the_list_is_examined_or_says_why_not(tmp_path, kind) -> None:
    """None is left unnamed: what no drawing shows, and what no mechanism here is for, is open too."""
    parts = house(caps=True).parts
    if kind == "church":
        parts = (*parts, part_of("Tower", block((20, 24), (0, 4), (0, 14)), "tower"))
    (tmp_path / "house.obj").write_text(obj_of(parts))
    write_project([tmp_path / "house.obj"], tmp_path / "new")
    content = load(tmp_path / "new").content
    assert content.report.building_type == kind
    items = checklist(content.report, content.mechanisms)
    assert len(items) == len(CHECKLISTS[kind])
    assert all(item.spoken_for for item in items)
    reasons = content.report.not_examined
    if kind == "house":
        assert "nothing of the kind" in reasons["parapet"]
        assert "chimney" not in reasons
        assert "only a survey can tell" in reasons["outer-leaf"]
        assert "no masonry of the wall lies beyond" in reasons["horizontal-bending"]
    else:
        assert "not looked for" in reasons["dome"]


def test_a_bay_is_stated_between_its_cross_walls(tmp_path) -> None:
    facade = part_of("Facade", block((0, 0.5), (0, 16), (0, 3)), normal=(-1, 0), outward=True)
    cross = [part_of(f"Cross {y}", block((0.5, 5), (y, y + 0.5), (0, 3)), normal=(0, 1)) for y in (4.0, 11.5)]
    (tmp_path / "house.obj").write_text(obj_of([facade, *cross]))
    _, candidates = write_project([tmp_path / "house.obj"], tmp_path / "new")
    (bay,) = (each for each in candidates if each.kind == "bay")
    stated = load(tmp_path / "new").content.mechanisms[bay.name]
    assert stated.kind == "horizontal-arch"
    assert set(stated.between) == {"cross-4-0", "cross-11-5"}
    assert stated.examines == ("horizontal-bending",)


def test_before_the_survey_the_run_names_what_is_missing(drawn) -> None:
    folder, _, _ = drawn
    with pytest.raises(ProjectError, match=r"site\.spectrum: missing"):
        run(folder)


def test_once_filled_in_it_runs(drawn, tmp_path) -> None:
    folder, _, candidates = drawn
    again = tmp_path / "again"
    write_project([folder / "house.obj"], again)
    assert fill_in(again / "project.toml") <= 15
    assert '\n"mechanisms.front-1-corner.wedges" = "measured: two openings' in (again / "project.toml").read_text(
        "utf-8"
    )
    results = run(again, jobs=1).results
    assert len(results.mechanisms) == sum(map(is_stated, candidates))
    assert results.verdict is not None
    assert results.verdict.basis == "ntc2018"
    assert any(each.outcome.value == "pass" for each in results.verdict.mechanisms)
    said = [str(each) for mechanism in results.verdict.mechanisms for each in mechanism.conditions]
    assert not any("wedges[1]" in each for each in said)  # one line vouches for both cracks of a corner
    spanning = [each for each in results.verdict.mechanisms if "bending" in each.mechanism]
    assert spanning
    assert all(any("is held at its top and at its foot" in str(said) for said in each.conditions) for each in spanning)


def test_shells_of_one_object_become_meshes_of_their_own(tmp_path) -> None:
    (tmp_path / "merged.obj").write_text(obj_of(house(storeys=1).parts, named=False))
    structure, candidates = write_project([tmp_path / "merged.obj"], tmp_path / "new")
    assert len(list((tmp_path / "new" / "meshes").glob("*.ply"))) == len(structure.parts) == 5
    found = {each.name: each.multiplier for each in candidates if is_stated(each)}
    assert multipliers(tmp_path / "new") == pytest.approx(found, rel=2e-3)


def placed(text: str, *, angle: float = 0.0, at=(0.0, 0.0), unit: float = 1.0) -> str:
    """Return an OBJ file turned about the vertical, moved, and in another unit."""
    lines = []
    for line in text.split("\n"):
        if line.startswith("v "):
            x, y, z = map(float, line.split()[1:])
            turned = (x * cos(angle) - y * sin(angle) + at[0], x * sin(angle) + y * cos(angle) + at[1], z)
            line = "v " + " ".join(f"{each / unit:.9g}" for each in turned)
        lines.append(line)
    return "\n".join(lines)


def test_a_model_turned_moved_and_in_millimetres_has_the_same_mechanisms(drawn, tmp_path) -> None:
    _, _, candidates = drawn
    text = placed(obj_of(house(caps=True).parts), angle=radians(33.0), at=(100.0, -50.0), unit=1e-3)
    (tmp_path / "house.obj").write_text(text)
    _, again = write_project([tmp_path / "house.obj"], tmp_path / "new", unit="mm")
    assert 'mesh_unit = "mm"' in (tmp_path / "new" / "project.toml").read_text(encoding="utf-8")
    assert {each.name: each.multiplier for each in again} == pytest.approx(
        {each.name: each.multiplier for each in candidates}, rel=1e-3
    )
    found = {each.name: each.multiplier for each in again if is_stated(each)}
    assert multipliers(tmp_path / "new") == pytest.approx(found, rel=2e-3)


def test_the_command_says_what_it_found(tmp_path, capsys) -> None:
    walls, floors = obj_of(house(storeys=1).parts[:4]), obj_of(house(storeys=1).parts[4:])
    (tmp_path / "walls.obj").write_text(walls)
    (tmp_path / "floors.obj").write_text(floors)
    assert ended("new", tmp_path / "new", "--from", tmp_path / "walls.obj", tmp_path / "floors.obj") == 0
    said = capsys.readouterr()
    assert str(tmp_path / "new" / "project.toml") in said.out
    assert "parts: 5; mechanisms: " in said.out
    assert "densit" in said.err
    assert ended_with(capsys, "new", tmp_path / "other", tmp_path / "walls.obj")[0] == 2
    code, line = ended_with(
        capsys, "new", tmp_path / "other", "--from", tmp_path / "walls.obj", "--example", "single_wall"
    )
    assert (code, "give one of them" in line) == (2, True)


def test_nothing_is_half_written(tmp_path) -> None:
    (tmp_path / "house.obj").write_text(obj_of(house(storeys=1).parts))
    (tmp_path / "full").mkdir()
    (tmp_path / "full" / "mine").write_text("mine")
    with pytest.raises(ProjectError, match="is not empty"):
        write_project([tmp_path / "house.obj"], tmp_path / "full")
    with pytest.raises(ProjectError, match="rename one"):
        write_project([tmp_path / "house.obj", tmp_path / "full" / "house.obj"], tmp_path / "new")
    with pytest.raises(GeometryError):
        write_project([tmp_path / "none.obj"], tmp_path / "new")
    thin = profile([(0, 0), (1e-3, 0), (1e-3, 1e-3)], length=0.01, density=1.0, name="thin")
    (tmp_path / "dust.obj").write_text(
        "o dust\n" + "".join(f"v {x} {y} {z}\n" for x, y, z in thin.vertices.tolist()) + "f 1 2 3\n"
    )
    with pytest.raises(GeometryError):
        write_project([tmp_path / "dust.obj"], tmp_path / "new")
    assert sorted(each.name for each in tmp_path.iterdir()) == ["dust.obj", "full", "house.obj"]


def test_arches_portals_and_inclined_cracks_are_stated(tmp_path) -> None:
    turn = [pi * i / 32 for i in range(33)]
    ring = [(2.5 * cos(t), 2.5 * sin(t)) for t in turn] + [(2.0 * cos(t), 2.0 * sin(t)) for t in turn[::-1]]
    parts = (
        part_of("Arch", profile(ring, length=0.8, density=STONE, name="arch"), "arch", normal=(0, 1)),
        *(part_of(f"Pier {y}", block((20, 20.6), (y, y + 0.8), (0, 3)), "pier", normal=(1, 0)) for y in (0.0, 3.0)),
        part_of("Lintel", block((20, 20.6), (0, 3.8), (3, 3.5)), "spandrel", normal=(1, 0)),
        part_of("Tower", block((40, 43), (0, 3.5), (0, 14)), "tower"),
    )
    structure = Structure(parts=parts, contacts=touching(parts), files=("church.ifc",))
    candidates = structure.mechanisms()
    drawn = draw_project(structure, candidates, title="church")
    for path, solid in drawn.meshes.items():
        (tmp_path / path).parent.mkdir(exist_ok=True)
        (tmp_path / path).write_bytes(ply(ClosedSurface(solid.vertices, solid.triangles)))
    (tmp_path / "project.toml").write_text(drawn.text, encoding="utf-8")
    found = {each.name: each.multiplier for each in candidates if is_stated(each)}
    assert {"arch-arch", "pier-0-0-portal", "tower-tower"} <= set(found)
    assert multipliers(tmp_path) == pytest.approx(found, rel=5e-3)
    assert 'building_type = "church"' in drawn.text


def test_names_of_models_hold_anything(drawn) -> None:
    _, structure, candidates = drawn
    renamed = replace(structure, files=('a"\n[site]\nx = \x01\x7f',))
    text = draw_project(renamed, candidates, title='a"\x7f\n[site]').text
    assert tomllib.loads(text)["title"] == 'a"\x7f\n[site]'
    assert "site" not in tomllib.loads(text)


@pytest.mark.parametrize(("name", "asked"), [("Wall_B", True), ("Wardrobe", False)])
@pytest.mark.parametrize("how", ["open", "half within"])
def test_what_is_left_out_and_may_be_a_wall_keeps_the_list_open(tmp_path, name, asked, how) -> None:
    """A wall without its top, or 0.4 m thick of which 0.2 m lie in another: the head names it, and why."""
    wall = part_of("Wall A", block((0, 0.4), (0, 4), (0, 3)))
    other = part_of(name, block((9, 9.4), (0, 4), (0, 3)) if how == "open" else block((0.19, 0.59), (0, 4), (0, 3)))
    text = obj_of((wall, other))
    lines = text.rstrip().split("\n")
    (tmp_path / "m.obj").write_text("\n".join(lines[:-2] if how == "open" else lines) + "\n")
    write_project([tmp_path / "m.obj"], tmp_path / "new")
    text = (tmp_path / "new" / "project.toml").read_text(encoding="utf-8")
    assert f"# - Left out: {name}:" in text.split("title =")[0]
    report = tomllib.loads(text)["report"].get("not_examined", {})
    assert ("simple-overturning" in report and f"{name}: " in report["simple-overturning"]) is asked


def test_the_share_of_what_is_drawn_twice_is_named(tmp_path) -> None:
    parts = [part_of(name, block((x, x + 0.4), (0, 4), (0, 3))) for name, x in (("A", 0.0), ("B", 0.18))]
    (tmp_path / "m.obj").write_text(obj_of(parts))
    structure, _ = write_project([tmp_path / "m.obj"], tmp_path / "new")
    (text,) = structure.left_out_texts
    assert "55 % of its volume lies in other parts" in text


def building(*floors: float, top: float) -> Structure:
    """Walls up to an elevation, with a slab 0.2 m thick whose top lies at each of some elevations [m]."""
    slabs = [part_of(f"Floor {z}", block((0, 6), (0, 6), (z - 0.2, z)), "floor", normal=(0, 1)) for z in floors]
    return Structure(parts=(part_of("Wall", block((0, 0.5), (0, 6), (0, top))), *slabs))


@pytest.mark.parametrize(
    ("floors", "top", "storeys"),
    [((), 3.0, 1), ((3.2,), 6.2, 2), ((3.2, 6.2), 6.2, 2), ((3.2,), 4.2, 1), ((), 6.2, None), ((3.2,), 9.2, None)],
)
def test_storeys_are_the_levels_where_floors_and_the_roof_bear(tmp_path, floors, top, storeys) -> None:
    """Two floors, one of them the roof's, are two storeys; a wall of 6 m without a floor may be one or two."""
    (tmp_path / "m.obj").write_text(obj_of(building(*floors, top=top).parts))
    write_project([tmp_path / "m.obj"], tmp_path / "new")
    text = (tmp_path / "new" / "project.toml").read_text(encoding="utf-8")
    assert tomllib.loads(text)["building"].get("storeys") == storeys
    assert ("#     storeys = 2" in text) is (storeys is None)


def test_one_shell_leaves_the_kind_of_building_to_the_survey(tmp_path) -> None:
    """The walls of a room as one closed ring: four walls are read, and whether it was a tower nobody knows."""
    ring = [(0, 0), (5, 0), (5, 5), (0, 5)], [(0.6, 0.6), (4.4, 0.6), (4.4, 4.4), (0.6, 4.4)]
    (tmp_path / "m.obj").write_text(ring_obj(*ring, height=4.0))
    structure, _ = write_project([tmp_path / "m.obj"], tmp_path / "new")
    assert len(structure.walls) == 4
    assert "one-shell" in {each.key for each in structure.warnings}
    file = tmp_path / "new" / "project.toml"
    text = file.read_text(encoding="utf-8")
    assert "report" not in tomllib.loads(text)
    assert not any("examines" in each for each in tomllib.loads(text)["mechanisms"].values())
    fill_in(file)
    report = load(file).content.report
    assert report.building_type == "house"


def ring_obj(outer, inner, *, height: float) -> str:
    """A closed ring of walls between two squares of four corners [m] as an OBJ file of one shell."""
    corners = [(x, y, z) for z in (0.0, height) for x, y in (*outer, *inner)]
    faces = []
    for i in range(4):
        j = (i + 1) % 4
        faces += [
            (i, j, j + 8, i + 8),
            (j + 4, i + 4, i + 12, j + 12),
            (j, i, i + 4, j + 4),
            (i + 8, j + 8, j + 12, i + 12),
        ]
    lines = [f"v {x} {y} {z}" for x, y, z in corners]
    return "\n".join([*lines, *("f " + " ".join(str(each + 1) for each in face) for face in faces)]) + "\n"


def test_a_house_in_a_unit_that_is_ten_times_too_large_is_asked_about(tmp_path, drawn) -> None:
    """Walls of 90 m that are 5 m thick; as they are meant, of 9 m and 0.5 m, nothing is asked."""
    _, as_meant, _ = drawn
    (tmp_path / "house.obj").write_text(placed(obj_of(house(caps=True).parts), unit=1e-3))
    structure, _ = write_project([tmp_path / "house.obj"], tmp_path / "new", unit="cm")
    told = [str(each) for each in structure.warnings if each.key.startswith("size")]
    assert told
    assert all("is its unit right?" in each for each in told)
    assert not [each for each in as_meant.warnings if each.key.startswith("size")]


def test_a_house_on_its_side_is_an_error_about_the_axis_that_is_up(tmp_path) -> None:
    model = tmp_path / "house.ifc"
    model.write_text(example_house.model())
    with pytest.raises(GeometryError, match=r"check which axis points up \(--up y is stated\)"):
        write_project([model], tmp_path / "new", up="y")
    assert not (tmp_path / "new").exists()


def test_a_model_in_place_of_a_project_file_is_told_what_reads_it(drawn) -> None:
    folder, _, _ = drawn
    with pytest.raises(ProjectError, match=r"a model, and no project file; `assess new DIR --from .*house\.obj`"):
        load(folder / "house.obj")
