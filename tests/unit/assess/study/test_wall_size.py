"""The wall that a mechanism is of: its size from the geometry, and which procedures a site brings with it."""

from pathlib import Path

import pytest
from scipy.constants import g

from assess.codes.context import Wall
from assess.errors import ProjectError
from assess.study.checks import carries_floors, wall_of
from assess.study.run import run_study
from tests.support.projects import block, project_toml, published, results_of, study_of, wall

AMERICA = 'code = "asce7-16"\ns_ds = "1 g"\ns_d1 = "0.45 g"\nt_l = "6 s"'
ZEALAND = 'code = "nzs1170.5"\nsubsoil = "C"\nz = 0.3\nr = 1.0'
EUROPE = 'code = "ec8"\na_g = "0.2 g"\nground_type = "B"'


def text_of(site: str, *, sides: str = "two") -> str:
    """A wall that spans, the wall above a cut, one by its numbers and a table."""
    return project_toml(
        site={"spectrum": site},
        building={"height": 8, "storeys": 2},
        materials={"stone": {"density": 2000}},
        bodies={
            "wall": wall(0.4, 2.0, 4.0, material="stone", base=[0, 0, 0]),
            "values": {"mass": 1000, "centroid": [0.0, 1.0], "inertia": 400},
        },
        mechanisms={
            "spanning": block(kind="two-block", direction=[1, 0, 0], crack=2.5, sides=sides),
            "free": block(direction=[1, 0, 0], cut=1.0, sides=sides),
            "values": block("values", hinges={"A": [0.2, 0.0]}, sides="one"),
            "block": published(),
        },
        records={"synthetic": {"count": 1, "duration": 8}},
    )


@pytest.mark.parametrize("sides", ["one", "two"])
def test_size_by_the_geometry(tmp_path: Path, sides: str) -> None:
    """The wall of 0.4 x 4 m; what lies above the cut at 1 m is 3 m high."""
    walls = {m.name: wall_of(m) for m in study_of(tmp_path, text_of(AMERICA, sides=sides)).mechanisms}
    assert walls["values"] is walls["block"] is None
    for name, height in (("spanning", 4.0), ("free", 3.0)):
        wall = walls[name]
        assert isinstance(wall, Wall)
        assert (wall.height, wall.thickness) == pytest.approx((height, 0.4), rel=1e-9)


@pytest.mark.parametrize(
    ("site", "name", "mechanisms"),
    [
        (AMERICA, "asce41-13-ht", {"spanning"}),
        (ZEALAND, "nzsee2017-face-loaded", {"spanning", "free", "values", "block"}),
        (EUROPE, "ec8-element", {"spanning", "free", "values", "block"}),
    ],
)
def test_a_site_brings_the_procedures_that_decide_there(
    tmp_path: Path, site: str, name: str, mechanisms: set[str]
) -> None:
    results = results_of(tmp_path, text_of(site), jobs=1)
    checks = {m.name: [c for c in m.checks if c.procedure == name] for m in results.mechanisms}
    assert {key for key, found in checks.items() if found} == mechanisms
    roles = {check.role for found in checks.values() for check in found}
    assert roles == {"comparison" if site == AMERICA else "deciding"}  # on asce7 spectra the basis must be named
    assert (name in results.project["analysis.procedures"].value) == bool(mechanisms)


def test_asked_for_by_name_every_mechanism_is_answered(tmp_path: Path) -> None:
    rest = '[analysis]\nprocedures = ["asce41-13-ht"]\n[procedures.asce41-13]\nposition = "top-storey"'
    results = results_of(tmp_path, text_of(AMERICA), rest, jobs=1)
    checks = {m.name: m.checks[0] for m in results.mechanisms}
    assert {name for name, check in checks.items() if check.verdict == "not-applicable"} == {"values", "block", "free"}
    assert checks["spanning"].ratio == pytest.approx(4.0 / 0.4 / 9.0, rel=1e-9)  # S_X1 = 0.45 g > 0.37 g
    assert checks["spanning"].capacity_pga_g == pytest.approx(0.37 * 0.4 / 0.45, rel=1e-9)


@pytest.mark.parametrize(
    ("code", "line"),
    [
        ("nzsee2017", "risk_factor = 0.5"),
        ("ec8", "behaviour_factor = 3"),
        ("ec8", "importance_factor = 0.5"),
    ],
)
def test_factors_that_no_table_has_are_refused(tmp_path: Path, code: str, line: str) -> None:
    """NZS 1170.5 Table 8.1 begins with 0.9, EN 1998-1 Table 4.4 ends with 2, gamma_a is no less than 1 (4.3.5.3)."""
    with pytest.raises(ProjectError, match=line.split(" ")[0]):
        study_of(tmp_path, text_of(ZEALAND), f"[procedures.{code}]\n{line}")


def test_options_reach_the_clause(tmp_path: Path) -> None:
    asked = '[analysis]\nprocedures = ["nzsee2017-face-loaded", "ec8-element"]\n'
    rest = (
        asked
        + "[procedures.nzsee2017]\nusable = 0.5\nstorey_slope = 0\n"
        + "[procedures.ec8]\nbehaviour_factor = 1.5\nimportance_factor = 1.2"
    )
    study = study_of(tmp_path, text_of(ZEALAND), rest)
    assert (study.options.nzsee2017.usable, study.options.ec8.behaviour_factor) == (0.5, 1.5)
    spanning = run_study(study, jobs=1).mechanisms[0].checks
    halved = 0.5  # b of C8B, case 0 over case 1: nothing is drawn below the wall
    assert spanning[0].capacity_rotation_ratio == pytest.approx(0.5 * 0.975 * halved, rel=5e-4)  # t_eff without load
    site = study.spectrum
    assert site is not None
    resonant = 3 * (1 + 2.0 / 8.0) - 0.5  # T_a may be longer than T_1
    assert spanning[1].demand == pytest.approx(site.pga / g * resonant * 1.2 / 1.5, rel=1e-9)


@pytest.mark.parametrize(
    ("load", "carries", "ratio"),
    [
        ("", False, 0.0),
        ('loads = [{ kind = "force", force = ["-500 N", "0 N"], at = [0.2, 0, 4] }]', False, 0.0),
        ('loads = [{ kind = "force", force = ["-500 N", "-3200 g*kg"], at = [0.2, 0, 4], block = 1 }]', True, 0.5),
        ('loads = [{ kind = "mass", mass = 3200, at = [0.2, 0, 4], bearing = true, block = 1 }]', True, 0.5),
        ('loads = [{ kind = "mass", mass = 3200, at = [0.2, 0, 4], bearing = false, block = 1 }]', True, 0.0),
    ],
)
def test_what_presses_on_a_wall(tmp_path: Path, load: str, carries: bool, ratio: float) -> None:
    """The wall is of 6400 kg; a floor that only pushes is a floor, and does not press."""
    load = load.replace("-3200 g*kg", f"{-3200.0 * g} N")
    text = text_of(AMERICA, sides="one").replace("crack = 2.5", f"crack = 2.5\n{load}")
    wall = next(m for m in study_of(tmp_path, text).mechanisms if m.name == "spanning")
    assert carries_floors(wall) is carries
    found = wall_of(wall)
    assert found is not None
    assert found.gravity["positive"].overburden_ratio == pytest.approx(ratio, rel=1e-9)


@pytest.mark.parametrize("thick", ["lower", "upper"])
def test_a_wall_that_spans_is_as_thick_as_the_thinner_of_base_and_crack(tmp_path: Path, thick: str) -> None:
    """Of two bodies one may be thicker: what it is slender by is the other."""
    sizes = {"lower": 0.4, "upper": 0.4} | {thick: 1.0}
    bodies = {name: wall(sizes[name], 2.0, 2.0, base=[0, 0, foot]) for name, foot in (("lower", 0), ("upper", 2))}
    text = project_toml(
        site={"spectrum": AMERICA},
        building={"height": 8, "storeys": 2},
        bodies=bodies,
        mechanisms={"m": {"kind": "two-block", "blocks": ["lower", "upper"], "direction": [1, 0, 0]}},
        records={"synthetic": {"count": 1, "duration": 8}},
    )
    (mechanism,) = study_of(tmp_path, text).mechanisms
    size = wall_of(mechanism)
    assert size is not None
    assert (size.height, size.thickness) == pytest.approx((4.0, 0.4), rel=1e-9)
