"""The list of mechanisms that a building can have: what is examined, absent, and possible but not examined."""

from __future__ import annotations

from pathlib import Path

import pytest

from assess.codes.checklists import CHECKLISTS, item_name, possible_mechanism
from assess.errors import ProjectError
from assess.project.sections.content import checklist
from assess.results import ChecklistItem
from tests.support.projects import load_project

WALL = """
[materials.stone]
density = 2000
[bodies.wall]
material = "stone"
box = { thickness = 0.6, length = 4, height = 3 }
[mechanisms.topple]
kind = "single-block"
blocks = ["wall"]
"""
BENDING = '[mechanisms.bend]\nkind = "two-block"\nblocks = ["wall"]\n'
TABLE = '[mechanisms.spire]\nkind = "equivalent-block"\np = 1.6\nuplift = 0.14\nradius = 2.8\n'
HOUSE = '[report]\nbuilding_type = "house"\n'
CHURCH = '[report]\nbuilding_type = "church"\n'


def items(folder: Path, text: str) -> dict[str, ChecklistItem]:
    content = load_project(folder, text).content
    return {each.key: each for each in checklist(content.report, content.mechanisms)}


def test_a_church_has_the_28_mechanisms_of_the_form_in_order_and_names_are_unique():
    assert [each.number for each in CHECKLISTS["church"]] == list(range(1, 29))
    for listed in CHECKLISTS.values():
        assert len({each.key for each in listed}) == len({each.name for each in listed}) == len(listed)
    assert [each.number for each in CHECKLISTS["church"] if each.in_plane] == [3, 6, 11, 17, 23]


def test_an_item_is_found_by_its_key_or_its_number():
    arch = possible_mechanism("church", "triumphal-arch")
    assert arch is not None
    assert arch is possible_mechanism("church", 13) is possible_mechanism("church", "13")
    assert possible_mechanism("house", "13") is None
    assert possible_mechanism("house", "None") is None
    assert item_name("church", "triumphal-arch") == "triumphal arch"
    assert item_name("house", "of a later version") == "of a later version"


def test_without_a_type_of_building_there_is_no_list(tmp_path):
    assert items(tmp_path, WALL) == {}


def test_the_kind_of_a_mechanism_tells_what_it_examines_in_a_house(tmp_path):
    found = items(tmp_path, WALL + BENDING + TABLE + HOUSE)
    assert found["simple-overturning"] == ChecklistItem("simple-overturning", None, "examined", ("topple",))
    assert found["vertical-bending"] == ChecklistItem("vertical-bending", None, "examined", ("bend",))
    assert [key for key, each in found.items() if each.outcome == "examined"] == [
        "simple-overturning",
        "vertical-bending",
    ]
    assert found["gable"] == ChecklistItem("gable", None, "not-examined", spoken_for=False)


@pytest.mark.parametrize(
    "crack", ['cut = { point = [0, 0, 0.3], angle = "30 deg" }', 'blocks = [["wall", "wall2"]]', "examines = []"]
)
def test_an_inclined_crack_joined_bodies_and_an_empty_list_tell_nothing(tmp_path, crack):
    wall = WALL.replace('blocks = ["wall"]\n', "") if crack.startswith("blocks") else WALL
    second = '[bodies.wall2]\nmaterial = "stone"\nbox = { thickness = 0.6, length = 4, height = 3, base = [1, 0, 0] }\n'
    found = items(tmp_path, wall + crack + "\n" + second + HOUSE)
    assert not any(each.outcome == "examined" for each in found.values())


def test_nothing_is_guessed_in_a_church(tmp_path):
    assert all(not each.spoken_for for each in items(tmp_path, WALL + BENDING + CHURCH).values())


def test_what_is_named_counts_in_place_of_the_kind(tmp_path):
    found = items(tmp_path, WALL + 'examines = "gable"\n' + HOUSE)
    assert found["gable"].mechanisms == ("topple",)
    assert not found["simple-overturning"].spoken_for


def test_numbers_of_the_form_count_for_churches(tmp_path):
    text = WALL + "examines = [1, 'facade-top']\n" + CHURCH + 'absent = [4, "28"]\nnot_examined = { 13 = "scaffold" }\n'
    found = items(tmp_path, text)
    assert found["facade"].mechanisms == found["facade-top"].mechanisms == ("topple",)
    assert found["porch"].outcome == found["bell-cell"].outcome == "absent"
    assert found["triumphal-arch"] == ChecklistItem("triumphal-arch", 13, "not-examined", (), "scaffold")


def test_an_item_examined_in_part_counts_as_not_examined_with_its_mechanisms_and_the_reason(tmp_path):
    found = items(tmp_path, WALL + HOUSE + 'not_examined = { simple-overturning = "no access to the north wall" }\n')
    assert found["simple-overturning"] == ChecklistItem(
        "simple-overturning", None, "not-examined", ("topple",), "no access to the north wall"
    )


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (
            'examines = "gabel"\n' + HOUSE,
            'mechanisms.topple.examines: "gabel": "gabel" is none of the list for a house',
        ),
        ('examines = "gabel"\n' + HOUSE, 'did you mean "gable"?'),
        ('examines = "gable"\n', 'mechanisms.topple.examines: "gable": names items of no list; write building_type'),
        ("examines = 29\n" + CHURCH, "mechanisms.topple.examines: 29: "),
        ("examines = true\n" + CHURCH, "mechanisms.topple.examines"),
        ('examines = ["gable", "gable"]\n' + HOUSE, "the same item stands there twice"),
        ("examines = [1, 'facade']\n" + CHURCH, '"facade" stands there twice, by number and by key'),
        ('examines = "in-plane"\n' + HOUSE, "no mechanism here is of damage in the plane of walls"),
        (
            HOUSE + 'absent = ["simple-overturning"]\n',
            'report.absent: ["simple-overturning"]: "simple-overturning" is what',
        ),
        (HOUSE + 'absent = ["corner"]\nnot_examined = { corner = "no access" }\n', "stands in `absent` too"),
        (HOUSE + 'not_examined = { corner = " " }\n', "report.not_examined.corner: "),
        (CHURCH + 'not_examined = { 16 = "a", apse = "b" }\n', "by number and by key"),
        ('[report]\nabsent = ["corner"]\n', "report.absent: "),
        ('[report]\nnot_examined = { corner = "x" }\n', "report.not_examined: "),
        ('[report]\nbuilding_type = "barn"\n', 'report.building_type: "barn": not allowed; write "house" or "church"'),
    ],
)
def test_what_does_not_fit_the_list_is_an_error_with_key_and_remedy(tmp_path, text, said):
    with pytest.raises(ProjectError) as caught:
        items(tmp_path, WALL + text)
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)
