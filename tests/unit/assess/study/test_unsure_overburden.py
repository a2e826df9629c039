"""A floor on a wall that bends, of which the drawing leaves open how much presses there."""

import pytest

from assess.project.project_file import load
from assess.verbs import run
from tests.support.command import ended
from tests.support.projects import NTC, project_toml

SITE = {"spectrum": NTC, "limit_state": "SLV"}
WALL = 'material = "m"\nbox = { thickness = 0.5, length = 4, height = %s, base = [%s, 0, 0] }'
SLAB = 'material = "m"\nbox = { thickness = 5.5, length = 4, height = 0.2, base = [2.5, 0, 3] }'
BEND = (
    'kind = "two-block"\nblocks = ["wall"]\ndirection = [-1, 0, 0]\nsides = "one"\n'
    'loads = [{ kind = "overburden", bodies = ["slab"] }]'
)
THIN = 'kind = "single-block"\nblocks = ["thin"]\ndirection = [1, 0, 0]'


@pytest.fixture
def project(tmp_path):
    """A slab on two walls, over a third whose top is 15 mm below it; a fourth, 0.1 m thick, fails."""
    bodies = {
        "wall": WALL % (3, 0),
        "far": WALL % (3, 5),
        "near": WALL % (2.985, 1.5),
        "slab": SLAB,
        "thin": (WALL % (4, 9)).replace("thickness = 0.5", "thickness = 0.1"),
    }
    file = tmp_path / "project.toml"
    file.write_text(
        project_toml(
            site=SITE, materials={"m": {"density": 1800}}, bodies=bodies, mechanisms={"bend": BEND, "thin": THIN}
        )
    )
    return file


def test_its_remedy_is_a_key_of_an_overburden(project) -> None:
    found = run(project, jobs=1).results.verdict
    (bend,) = (each for each in found.mechanisms if each.mechanism == "bend")
    (missing,) = (each for each in bend.missing if each.key == "mechanisms.bend.loads")
    assert "give force, what presses on the wall, in place of bodies" in missing.text
    text = project.read_text().replace('bodies = ["slab"]', 'force = "30 kN"')
    project.write_text(text)
    load(project)


def test_it_is_printed_where_another_mechanism_fails(project, capsys) -> None:
    assert ended("run", project, "--no-report", "--jobs", 1) == 1
    said = " ".join(capsys.readouterr().out.split())
    assert "missing: mechanisms.bend.loads: overburden" in said
