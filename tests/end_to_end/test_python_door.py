"""The same wall by plain data in Python and by a project file: the same numbers, to the last bit."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import assess
from assess.errors import AssessError, GeometryError, MechanismError, ProcedureError
from records.errors import RecordError
from spectra.errors import SpectrumError
from tests.support.motions import noise

PROJECT = """
format = 1
[site.spectrum]
code = "ec8"
a_g = "0.25 g"
ground_type = "C"
[building]
ground_elevation = "0 m"
[materials.stone]
density = "2000 kg/m^3"
[bodies.wall]
material = "stone"
box = { thickness = "0.6 m", length = "4.0 m", height = "4.5 m" }
[mechanisms.W1]
kind = "single-block"
blocks = ["wall"]
[records]
files = ["motion.csv"]
scale_to = "none"
[analysis]
procedures = ["ntc2018-nonlinear", "nzsee2017-face-loaded", "asce43-05-sliding"]
[procedures.ntc2018]
knowledge_level = "LC1"
"""


WALL = assess.box(thickness=0.6, length=4.0, height=4.5, density=2000.0)
RAISED = assess.box(thickness=0.6, length=4.0, height=4.5, density=2000.0, base=(0.0, 0.0, 30.0))
PUBLISHED = {"p": 1.5, "uplift": 0.1, "radius": 3.0}
FLOOR = assess.box(thickness=4.0, length=4.0, height=0.3, density=2500.0, base=(2.2, 0.0, 4.5), name="floor")


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A project of one wall with one record, a decaying sine of 1 Hz."""
    place = tmp_path_factory.mktemp("door")
    (place / "project.toml").write_text(PROJECT)
    time = 0.01 * np.arange(800)
    motion = 3.0 * np.sin(2 * np.pi * time) * np.exp(-0.3 * time)
    rows = "\n".join(f"{t:.2f},{a!r}" for t, a in zip(time, motion.tolist(), strict=True))
    (place / "motion.csv").write_text("time [s],acceleration [m/s2]\n" + rows + "\n")
    return place


@pytest.fixture(scope="module")
def block():
    return assess.single_block(WALL, direction="weakest")


@pytest.fixture(scope="module")
def run(folder):
    heard = []
    found = assess.run(assess.load(folder / "project.toml"), progress=lambda *step: heard.append(step))
    assert heard
    return found


def test_parameters_are_those_of_a_run(block, run):
    (row,) = run.table("parameters").query("branch == 'positive'").to_dict("records")
    assert block.oscillator.p == row["p_eq_per_s"]
    assert block.oscillator.slenderness == row["slenderness_rad"]
    assert block.oscillator.multiplier == row["uplift_multiplier"]
    assert block.oscillator_negative.overturning == run.results.mechanisms[0].oscillator_negative.overturning_rad
    # by hand: alpha = atan(b/h), p = sqrt(3 g / (4 R))
    assert block.oscillator.slenderness == pytest.approx(np.arctan(0.6 / 4.5), rel=1e-12)
    assert block.oscillator.p == pytest.approx(np.sqrt(0.75 * assess.g / np.hypot(0.3, 2.25)), rel=1e-12)


def test_motion_is_that_of_a_run(block, run, folder):
    record = assess.read_record(folder / "motion.csv")
    told = run.results.mechanisms[0].histories[0]
    motion = assess.respond(block, record, scale=told.polarity * told.scale_factor)
    assert not motion.overturned
    assert (motion.max_rotation, motion.time_of_max) == (told.max_rotation_rad, told.time_of_max_s)
    assert (motion.max_ratio, motion.impacts) == (told.max_rotation_ratio, told.impacts)
    assert motion.time.shape == motion.rotation.shape
    assert "\n" not in repr(motion)
    assert len(repr(motion)) < 250


def test_motion_that_overturns_says_so(block, folder):
    record = assess.read_record(folder / "motion.csv")
    motion = assess.respond(block, record, scale=4.0)
    assert motion.overturned
    assert motion.overturning_time < 8.0


def test_several_records_have_the_motions_of_each_and_a_table(block, folder):
    record = assess.read_record(folder / "motion.csv")
    records = [record, replace(record, id="strong", acceleration=4.0 * record.acceleration)]
    motions = assess.respond(block, records)
    frame = motions.table()
    for place, alone in enumerate(assess.respond(block, each) for each in records):
        assert np.array_equal(motions[place].rotation, alone.rotation)
        row = frame.iloc[place]
        assert (row.id, row.overturned, row.impacts) == (records[place].id, alone.overturned, alone.impacts)
        assert row.max_ratio == alone.max_ratio or (alone.overturned and np.isnan(row.max_ratio))
    assert frame.overturned.tolist() == [False, True]
    assert frame.describe().loc["max", "max_ratio"] == motions[0].max_ratio  # a warning of pandas would be an error
    assert len(motions) == len(motions[:2]) == 2
    assert repr(motions) == "Motions('block', 2 records, 1 overturned)"
    assert "<table" in motions._repr_html_()


def test_answers_are_the_checks_of_a_run(block, run):
    target = assess.spectrum("ec8", a_g=0.25 * assess.g, ground_type="C")
    asked = ["ntc2018-nonlinear", "nzsee2017-face-loaded", "asce43-05-sliding"]
    found = assess.answers(block, target, procedures=asked, knowledge_level="LC1")
    checks = {(each.procedure, each.branch, each.limit_state): each for each in run.results.mechanisms[0].checks}
    compared = 0
    for answer in found:
        check = checks.get((answer.procedure, answer.branch, answer.limit_state))
        if check is not None:
            assert (answer.demand, answer.capacity, answer.ratio) == (check.demand, check.capacity, check.ratio)
            compared += 1
    assert compared >= 2


def test_envelope_holds_the_motion_it_maps(block):
    frequency, amplitude = np.linspace(0.5, 3.0, 6), np.linspace(0.5, 12.0, 24)
    found = assess.envelope(block, "sine", frequency=frequency, amplitude=amplitude)
    reached = np.flatnonzero(np.isfinite(found.lower_bound))
    assert reached.size
    time = 0.002 * np.arange(4000)
    for place in reached[:2]:
        f, least = frequency[place], found.lower_bound[place]
        for factor, overturns in ((0.9, False), (1.1, True)):
            pulse = np.where(time <= 1.0 / f, factor * least * np.sin(2 * np.pi * f * time), 0.0)
            record = assess.Record(id="pulse", acceleration=pulse, dt=0.002)
            assert any(assess.respond(block, record, scale=way).overturned for way in (1.0, -1.0)) is overturns


def test_fifty_records_to_a_plotted_fragility_in_eight_lines():
    wall = assess.box(thickness=0.6, length=4.0, height=4.5, density=2000.0)
    block = assess.single_block(wall, direction=(1.0, 0.0, 0.0))
    target = assess.spectrum("ec8", a_g=0.25 * assess.g, ground_type="C")
    records = assess.artificial_records(target, count=50, duration=10.0)
    table = assess.respond(block, records).table()
    table.describe()
    found = assess.fragility(block, records, measures=["pga"])
    figure = assess.plot(found)
    assert len(figure.axes) == len(found.mechanisms) == 1
    assert table["max_ratio"].isna().sum() == table["overturned"].sum()
    rocks = next(each for each in found.mechanisms[0].curves if each.state.name == "rocking")
    assert rocks.records == 50
    for point in rocks.empirical:  # all rock from the PGA on that is the multiplier, b / h
        assert point.share == (point.intensity > 0.6 / 4.5)


def test_fragility_with_a_spectrum_states_and_a_hazard_is_that_of_their_project(tmp_path):
    asked = "[analysis.fragility]\nmeasures = ['pga']\nstates = ['overturning', 0.3]\n[analysis.risk]\n"
    asked += "hazard = [{ rate = 0.1, pga = '0.05 g' }, { rate = 2e-3, pga = '0.2 g' }, { rate = 1e-4, pga = '0.9 g' }]"
    (tmp_path / "project.toml").write_text(
        PROJECT.replace('files = ["motion.csv"]', "synthetic = { count = 7 }") + asked
    )
    (one,) = assess.fragility(tmp_path / "project.toml", jobs=1).mechanisms
    hazard = [(0.05 * assess.g, 0.1), (0.2 * assess.g, 2e-3), (0.9 * assess.g, 1e-4)]
    target = assess.spectrum("ec8", a_g=0.25 * assess.g, ground_type="C")
    states, block = ["overturning", 0.3], assess.single_block(WALL, name="W1")
    found = assess.fragility(block, spectrum=target, measures=["pga"], states=states, hazard=hazard, jobs=1)
    (other,) = found.mechanisms
    assert (one.curves, one.runs, one.risks) == (other.curves, other.runs, other.risks)
    assert len(other.risks) == 6  # of two states by three curves


def test_fragility_of_mechanisms_is_that_of_their_project(tmp_path):
    records = [noise(seed, peak=3.0, npts=300) for seed in range(4)]
    files = []
    for place, each in enumerate(records):
        files.append(f"motion{place}.csv")
        rows = "\n".join(f"{each.dt * k!r},{a!r}" for k, a in enumerate(each.acceleration.tolist()))
        (tmp_path / files[-1]).write_text(f"time [s],acceleration [m/s2]\n{rows}\n")
    (tmp_path / "project.toml").write_text(
        PROJECT.replace('["motion.csv"]', str(files)) + "[analysis.fragility]\nmeasures = ['pga']\n"
    )
    of_project = assess.fragility(tmp_path / "project.toml", jobs=1)
    block = assess.single_block(WALL, name="W1")
    read = [assess.read_records(tmp_path / name)[0] for name in files]
    of_block = assess.fragility([block], read, measures=["pga"], jobs=1)
    (one,), (other,) = of_project.mechanisms, of_block.mechanisms
    assert (one.curves, one.runs, one.comparison) == (other.curves, other.runs, other.comparison)
    assert assess.plot(of_block).axes[0].lines


def test_stripes_with_records_of_their_own_are_those_of_a_project(tmp_path):
    records, files = [noise(seed, peak=3.0, npts=300) for seed in range(9)], []
    for place, each in enumerate(records):
        files.append(f"motion{place}.csv")
        rows = "\n".join(f"{each.dt * k!r},{a!r}" for k, a in enumerate(each.acceleration.tolist()))
        (tmp_path / files[-1]).write_text(f"time [s],acceleration [m/s2]\n{rows}\n")
    levels = {0.3: files[:3], 0.5: files[3:6], 0.8: [*files[6:], files[0]]}
    stripes = ", ".join(f"{{ intensity = '{im} g', records = {names} }}" for im, names in levels.items())
    (tmp_path / "project.toml").write_text(
        PROJECT.replace('["motion.csv"]', str(files))
        + f"[analysis.fragility]\nmeasures = ['pga']\nmethod = 'stripes'\nstripes = [{stripes}]\n"
    )
    (one,) = assess.fragility(tmp_path / "project.toml", jobs=1).mechanisms
    read = {name: assess.read_records(tmp_path / name)[0] for name in files}
    own = {im * assess.g: [read[name] for name in names] for im, names in levels.items()}
    (other,) = assess.fragility(assess.single_block(WALL, name="W1"), own, measures=["pga"], jobs=1).mechanisms
    assert (one.curves, one.runs) == (other.curves, other.runs)
    assert [len(run.scale) for run in one.runs] == [1] * 10
    assert [point.records for point in one.curves[0].empirical] == [3, 3, 4]


@pytest.mark.parametrize(
    ("given", "said"),
    [
        (("project.toml", [noise(1)]), "a project has its own"),
        (("project.toml", noise(1)), "a project has its own"),
        (((), [noise(1)]), "tuple given; give a mechanism"),
    ],
)
def test_fragility_of_what_is_none_is_refused(given, said):
    with pytest.raises(AssessError, match=said):
        assess.fragility(*given)


def test_fragility_needs_records_names_and_known_measures(block):
    with pytest.raises(RecordError, match="records: none; give"):
        assess.fragility(block)
    with pytest.raises(MechanismError, match="several mechanisms are called block"):
        assess.fragility([block, block], [noise(1)])
    for given, said in (
        ({"measures": ["pgx"]}, "not a measure of intensity"),
        ({"states": [1.5]}, "not a state; write one of"),
        ({"hazard": [(1.0, 0.1), (0.5, 0.2)]}, "rows rise in pga and fall in rate"),
    ):
        with pytest.raises(AssessError, match=said):
            assess.fragility(block, [noise(1)], **given)
    with pytest.raises(ProcedureError, match="give a spectrum"):
        assess.fragility(block, spectrum="ec8")


def test_report_of_a_run_stands_whole_in_its_folder(run, tmp_path):
    pdf = assess.write_report(run, tmp_path / "out")
    assert pdf.read_bytes().startswith(b"%PDF")
    assert {path.name for path in (tmp_path / "out").iterdir()} >= {"results.json", "report.html", "tables.xlsx"}


def test_figures_and_tables_of_a_run(run):
    figure = run.figure("capacity", mechanism="W1")
    assert figure.axes
    assert len(run.table("checks")) == len(run.results.mechanisms[0].checks)
    with pytest.raises(AssessError, match="checks"):
        run.table("chekcs")


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"restitution": 1.5}, r"restitution.positive = 1.5: outside \[0, 1\]"),
        ({"restitution": "houser"}, "housner"),
        ({"direction": (0.0, 0.0, 1.0)}, "not horizontal"),
        ({"direction": (float("nan"), 0.0, 0.0)}, "finite"),
        ({"loads": [assess.MassLoad(mass=-3.0, at=(0.0, 1.0))]}, r"loads\[1\].mass = -3: must be greater than 0"),
        ({"loads": [assess.BodyLoad(body="floor")]}, 'no such body; known: "box"; give it in `around`'),
        ({"loads": [assess.MassLoad(mass=3.0, at=(0.0, 1.0), block=1)]}, "block = 1"),
        ({"interface": assess.Interface(model="flexible")}, "stiffness or course_thickness"),
        ({"sides": "three"}, 'write "one" or "two"'),
        ({"cut": 9.0}, "the cut at z = 9 m misses"),
        ({"cut": "3 m"}, "give an elevation"),
        ({"restitution": (0.9, 0.9, 0.9)}, "one for each of two impacts"),
        ({"hinge": (0.3,)}, "hinges.A"),
        ({"loads": [assess.ForceLoad(force=-5e3, at=(0.0, 4.0), direction=(1.0, 0.0))]}, "force = -5000"),
        ({"loads": [assess.ForceLoad(force=5e3, at=(0.0, 4.0), direction=(0.0, 0.0))]}, "no direction; write"),
        ({"loads": [assess.TieLoad(force=-3e4, at=(0.0, 4.0), direction=(-1.0, 0.0))]}, "force = -30000"),
        ({"loads": [assess.TieLoad(force=3e4, at=(0.0, 4.0), anchor=(9.0, 4.0), until=-0.1)]}, "until = -0.1"),
        ({"loads": [assess.MassLoad(mass=3.0, at=(0.0, 4.0), bearing=False, seat=0.1)]}, "only what bears"),
        ({"loads": [assess.MassLoad(mass=3.0, at=[4.0])]}, r"at = \(4.0,\): not a point; write \[x, y, z\]"),
        ({"loads": [assess.BodyLoad(body="floor", share=1.5)], "around": [FLOOR]}, "share = 1.5: must be 1 or less"),
        (
            {"loads": [assess.BodyLoad(body="floor", role="rooof")], "around": [FLOOR]},
            'not allowed; write "floor", "roof" or "vault"',
        ),
        (
            {"loads": [assess.BodyLoad(body="floor", thrust=1e4)], "around": [FLOOR]},
            "only a roof or a vault has a thrust",
        ),
        ({"loads": [assess.OverburdenLoad(force=1e4)]}, "for two-block mechanisms"),
    ],
)
def test_values_no_mechanism_has_are_refused(given, said):
    wall = assess.box(thickness=0.6, length=4.0, height=4.5, density=2000.0)
    with pytest.raises(AssessError, match=said):
        assess.single_block(wall, **given)


def test_what_a_wall_of_two_blocks_would_ignore_is_refused():
    lower = assess.box(thickness=0.6, length=4.0, height=2.0, density=2000.0, name="lower")
    upper = assess.box(thickness=0.6, length=4.0, height=2.0, density=2000.0, base=(0.0, 0.0, 2.0), name="upper")
    with pytest.raises(MechanismError, match="crack = 1: is for one body"):
        assess.two_block([lower, upper], crack=1.0)
    with pytest.raises(MechanismError, match='remove eccentricity, or write "fixed"'):
        assess.two_block(lower, loads=[assess.OverburdenLoad(force=1e4, eccentricity=0.1, through="joint")])
    with pytest.raises(MechanismError, match="give A, B, C"):
        assess.two_block(lower, direction=(1.0, 0.0, 0.0), hinges=((0.3, 0.0), (0.3, 1.0)))


def test_whole_numbers_are_floats():
    wall = assess.box(thickness=0.6, length=4.0, height=4.0, density=2000.0)
    load = {"mass": 1000.0, "at": (0.0, 4.0)}
    for whole, floats in (
        (assess.two_block(wall, crack=2), assess.two_block(wall, crack=2.0)),
        (
            assess.single_block(wall, direction=(1, 0, 0), cut=1, loads=[assess.MassLoad(mass=1000, at=(0, 4))]),
            assess.single_block(wall, direction=(1.0, 0.0, 0.0), cut=1.0, loads=[assess.MassLoad(**load)]),
        ),
    ):
        assert whole.definition == floats.definition
        assert whole.oscillator == floats.oscillator
    assert assess.two_block(wall, crack=2).mechanism.positive.hinges[1][1] == 2.0
    assert assess.model.crack(wall, direction=(1, 0, 0), method=2).elevation == 2.0


NTC = assess.spectrum("ntc2018", a_g=0.188 * assess.g, f_0=2.36, t_c_star=0.33, soil="B", topography="T1")
PORTAL = ((1.0, 0.0), (0.0, 3.0), (4.0, 3.0), (5.0, 0.0))


@pytest.mark.parametrize(
    ("given", "text"),
    [
        ({"hinges": PORTAL}, "hinges_negative: missing"),
        ({"hinges": PORTAL, "hinges_negative": PORTAL, "sides": "one"}, "beside one-sided rocking"),
        ({"hinges": PORTAL[:3], "sides": "one"}, "give A, B, C, D"),
        ({"hinges": "minimun", "sides": "one"}, "give A, B, C, D"),
        ({"hinges": "minimum"}, "needs one arch"),
    ],
)
def test_hinges_that_do_not_make_a_frame_are_refused(given, text):
    post = [(0.0, 0.0), (1.0, 0.0), (1.0, 3.0), (0.0, 3.0)]
    parts = {
        "left": post,
        "beam": [(0.0, 3.0), (5.0, 3.0), (5.0, 3.5), (0.0, 3.5)],
        "right": [(x + 4, z) for x, z in post],
    }
    bodies = [assess.profile(each, length=1.0, density=2000.0, name=name) for name, each in parts.items()]
    assert assess.four_hinge(bodies, hinges=PORTAL, sides="one").oscillator.multiplier > 0.0
    with pytest.raises(MechanismError, match=text):
        assess.four_hinge(bodies, **given)


def test_loads_of_an_arch_that_would_not_count_are_refused():
    turn = np.linspace(np.pi, 0.0, 21)
    ring = [(r * np.cos(at), r * np.sin(at)) for r, way in ((3.3, 1), (2.7, -1)) for at in turn[::way]]
    arch = assess.profile(ring, length=1.0, density=2000.0, name="arch")
    joints = assess.RadialJoints(centre=(0.0, 0.0), first=np.radians(168.75), last=np.radians(11.25), count=14)
    with pytest.raises(MechanismError, match="loads: not with hinges"):
        assess.four_hinge(arch, hinges="minimum", joints=joints, loads=[assess.MassLoad(mass=1e5, at=(0.0, 3.0))])
    with pytest.raises(MechanismError, match="hinges_negative: are looked for too"):
        assess.four_hinge(arch, hinges="minimum", joints=joints, hinges_negative=PORTAL)


@pytest.mark.parametrize(
    ("given", "text"),
    [
        ({"uplift": 3.0}, "uplift = 3: must be less than 1.5708"),
        ({"p": 1e4}, "p = 10000: outside 0.001 to 1000"),
        ({"radius": -1.0}, "greater than 0"),
    ],
)
def test_parameters_no_mechanism_has_are_refused(given, text):
    with pytest.raises(MechanismError, match=text):
        assess.equivalent_block(**{"p": 1.5, "uplift": 0.1, "radius": 3.0, **given})


def test_masonry_that_no_body_has_is_refused():
    stone = assess.Material(name="stone", density=2000.0, compressive_strength=-1e6)
    with pytest.raises(GeometryError, match=r'body "box": compressive_strength = -1e\+06: must be greater than 0'):
        assess.box(thickness=0.6, length=4.0, height=4.5, density=stone)


@pytest.mark.parametrize(
    "grid",
    [
        {"frequency": [3.0, 1.0]},
        {"frequency": [0.0, 1.0]},
        {"amplitude": [-5.0, 2.0]},
        {"amplitude": [np.nan]},
        {"amplitude": []},
    ],
)
def test_grids_of_pulses_that_do_not_rise_are_refused(block, grid):
    with pytest.raises(RecordError, match="give"):
        assess.envelope(block, "sine", **{"frequency": [1.0, 2.0], "amplitude": [1.0, 2.0], **grid})


def test_two_bodies_of_one_name_are_refused():
    one = assess.box(thickness=0.6, length=4.0, height=4.5, density=2000.0)
    with pytest.raises(MechanismError, match="several bodies are called box"):
        assess.single_block([one, one])


def test_unknown_procedure_lists_the_known(block):
    target = assess.spectrum("ec8", a_g=2.0, ground_type="A")
    with pytest.raises(ProcedureError, match="ntc2018-nonlinear"):
        assess.answers(block, target, procedures=["ntc2018"])


@pytest.mark.parametrize(
    ("target", "records", "asked"),
    [
        (assess.spectrum("ec8", a_g=2.0, ground_type="A"), [], {"ec8-element"}),
        (NTC, [], {"ntc2018-linear", "ntc2018-nonlinear"}),
    ],
)
def test_procedures_by_default_are_those_of_the_code_of_the_spectrum(block, target, records, asked):
    found = assess.answers(block, target, records=records)
    assert {each.procedure for each in found} == asked
    assert found == assess.answers(block, target, procedures=[each.procedure for each in found])


def test_spectrum_without_a_basis_needs_procedures(block):
    table = assess.spectrum("asce7-16", s_ds=8.0, s_d1=4.0, t_l=8.0)
    with pytest.raises(ProcedureError, match=r"a spectrum of asce7-16 has no default; known are: .*ntc2018-nonlinear"):
        assess.answers(block, table)


@pytest.mark.parametrize(
    ("record", "said"),
    [
        ([], "records: none; give one record or several"),
        ([assess.Record(id="r", acceleration=np.ones(9), dt=0.01), "motion.csv"], "str given; give one record"),
        (assess.Record(id="r", acceleration=np.array([0.0, np.nan, 0.0]), dt=0.01), "finite"),
        (assess.Record(id="r", acceleration=np.zeros(3), dt=0.0), "time step"),
        (assess.Record(id="r", acceleration=np.zeros(0), dt=0.01), "samples"),
    ],
)
def test_no_record_is_no_motion(block, record, said):
    with pytest.raises(RecordError, match=said):
        assess.respond(block, record)


def test_structure_below_by_its_height():
    assert assess.building(height=16.0).period == pytest.approx(0.05 * 8.0, rel=1e-12)  # 16^0.75 = 8
    with pytest.raises(ProcedureError, match="height = -1"):
        assess.building(height=-1.0)


def test_answers_above_the_ground_need_the_building(block):
    target = assess.spectrum("ec8", a_g=0.02 * assess.g, ground_type="C")
    asked = {"procedures": ["ntc2018-linear"], "knowledge_level": "LC1", "base_elevation": 6.0}
    (without,) = assess.answers(block, target, **asked)
    (within,) = assess.answers(block, target, building=assess.building(height=9.0, storeys=3), **asked)
    assert without.verdict.value == "not-answered"  # it could only fail by the motion of the ground
    assert within.verdict.value == "pass"


@pytest.mark.parametrize(
    ("block", "given", "outcome"),
    [
        (assess.single_block(WALL), {}, "pass"),
        (assess.single_block(WALL, cut=3.0), {}, "not-answered"),
        (assess.single_block(WALL, cut=3.0), {"base_elevation": 3.0}, "not-answered"),
        (assess.single_block(WALL, cut=3.0), {"base_elevation": 0.0}, "not-answered"),  # as drawn its base is at 3 m
        (assess.single_block(RAISED), {}, "pass"),  # the lowest body stands on the ground
        (assess.single_block(RAISED), {"base_elevation": 6.0}, "not-answered"),
        (assess.equivalent_block(**PUBLISHED), {}, "pass"),
        (assess.equivalent_block(**PUBLISHED, elevation=9.0), {}, "not-answered"),
    ],
)
def test_what_is_drawn_above_the_ground_is_not_answered_as_if_it_stood_on_it(block, given, outcome):
    target = assess.spectrum("ec8", a_g=0.02 * assess.g, ground_type="C")
    (check,) = assess.answers(block, target, procedures=["ntc2018-linear"], **given)
    assert check.verdict.value == outcome


@pytest.mark.parametrize(
    ("given", "error"),
    [
        ({"procedures": "ntc2018-linear"}, ProcedureError),
        ({"base_elevation": float("nan")}, ProcedureError),
        ({"records": ["motion.csv"]}, RecordError),
        ({"records": [assess.Record(id="r", acceleration=np.array([0.0, np.nan, 0.0]), dt=0.01)]}, RecordError),
    ],
)
def test_inputs_that_are_none_are_refused(block, given, error):
    target = assess.spectrum("ec8", a_g=2.0, ground_type="A")
    with pytest.raises(error):
        assess.answers(block, target, **{"procedures": ["ntc2018-linear"], **given})


def test_every_result_has_a_repr_of_one_line(block, run, folder):
    shown = (
        assess.load(folder / "project.toml"),
        run,
        run.results,
        block,
        FLOOR,
        FLOOR.solid,
        assess.read_record(folder / "motion.csv"),
    )
    for each in shown:
        assert "\n" not in repr(each)
        assert len(repr(each)) < 250, type(each)


WALL = assess.box(thickness=0.6, length=4.0, height=4.5, density=2000.0)
SIZES = {"thickness": 0.6, "length": 4.0, "height": 4.5, "density": 2000.0}


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"cut": "2"}, "cut = '2': give an elevation"),
        ({"cut": True}, "cut = True: give an elevation"),
        ({"cut": assess.CutAngle("a", 0.1)}, "cut.point = 'a': not \\(number, number, number\\)"),
        ({"direction": 1}, r"direction = 1: not a direction"),
        ({"direction": ("a", "b", "c")}, r"not a direction"),
        ({"loads": assess.MassLoad(mass=1.0, at=(0.0, 1.0))}, "give a list of loads"),
        ({"loads": ["tie"]}, "a MassLoad or"),
        ({"loads": [assess.MassLoad(mass="3", at=(0.0, 1.0))]}, r"loads\[1\].mass = '3': not a number"),
        ({"loads": [assess.MassLoad(mass=3.0, at=5.0)]}, r"loads\[1\].at = 5: not a point; write \[x, y, z\]"),
        ({"loads": [assess.MassLoad(mass=3.0, at=(0.0, 1.0), bearing="yes")]}, "not a truth value; give True or False"),
        ({"around": WALL}, "give a list of bodies"),
        ({"interface": "flexible"}, "interface = 'flexible': not an Interface"),
        ({"interface": assess.Interface(model="flexible", stiffness="10 GPa/m")}, "not a number"),
        ({"interface": assess.Interface(model="flexible", stiffness=1e10, shape="round")}, 'write "outline", or'),
        ({"restitution": {"positive": 0.9}}, "write a number"),
        ({"restitution": True}, "write a number"),
        ({"name": 3}, "give a text"),
    ],
)
def test_values_of_another_kind_are_refused(given, said):
    with pytest.raises(AssessError, match=said):
        assess.single_block(WALL, **given)


@pytest.mark.parametrize("body", [None, 3, "box", [3], []])
def test_what_is_no_body_is_refused(body):
    with pytest.raises(MechanismError, match=r"bodies|body"):
        assess.single_block(body)


@pytest.mark.parametrize("key", ["thickness", "length", "height", "density"])
@pytest.mark.parametrize("value", ["0.6", "0.6 m", None, [1.0], True, np.array([1.0, 2.0]), 1j])
def test_sizes_that_are_no_numbers_are_refused(key, value):
    with pytest.raises(AssessError, match=key):
        assess.box(**{**SIZES, key: value})


CORNERS = ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))
FACES = ((0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2))
TETRAHEDRON = "solid w\n{}endsolid w\n".format(
    "".join(
        "facet normal 0 0 0\nouter loop\n{}endloop\nendfacet\n".format(
            "".join("vertex {} {} {}\n".format(*CORNERS[corner]) for corner in face)
        )
        for face in FACES
    )
)


def test_a_mesh_is_read_from_its_file(tmp_path):
    (tmp_path / "w.stl").write_text(TETRAHEDRON)
    assert assess.mesh(tmp_path / "w.stl", density=2000.0).mass == pytest.approx(2000.0 / 6.0, rel=1e-12)


@pytest.mark.parametrize(
    "given", [{"path": None}, {"path": b"w.stl"}, {"unit": "mm"}, {"up": "x"}, {"element": 3}, {"name": ""}]
)
def test_what_no_mesh_takes_is_refused(given, tmp_path):
    (tmp_path / "w.stl").write_text(TETRAHEDRON)
    with pytest.raises(AssessError, match=r"give|write"):
        assess.mesh(**{"path": tmp_path / "w.stl", "density": 2000.0, **given})


def test_joints_of_an_arch_that_are_none_are_refused():
    ring = [(-2.5, 0), (-1.8, 1.8), (0, 2.5), (1.8, 1.8), (2.5, 0), (2, 0), (1.4, 1.4), (0, 2), (-1.4, 1.4), (-2, 0)]
    arch = assess.profile(ring, length=1.0, density=2200.0)
    for joints in (3, (1, 2, 3, 4), assess.RadialJoints("a", 3.0, 0.1, 8), assess.RadialJoints((0, 0), 3.0, 0.1, 8.5)):
        with pytest.raises(MechanismError, match="joints"):
            assess.four_hinge(arch, hinges="minimum", joints=joints)


@pytest.mark.parametrize("p", ["1.6", None, [1.6], 1e300, 1e-300, 0.0, -1.0])
def test_frequency_parameters_that_are_none_are_refused(p):
    with pytest.raises(MechanismError, match="p = "):
        assess.equivalent_block(p=p, uplift=0.1, radius=2.0)


def test_lists_and_arrays_are_places_as_tuples_are():
    tie = {"force": 2e3, "at": (-0.25, 0.0, 3.8), "anchor": (-3.0, 0.0, 3.8)}
    one = assess.single_block(WALL, direction=(1.0, 0.0, 0.0), loads=[assess.TieLoad(**tie)])
    lists = {key: list(value) if isinstance(value, tuple) else value for key, value in tie.items()}
    other = assess.single_block(WALL, direction=np.array([1.0, 0.0, 0.0]), loads=[assess.TieLoad(**lists)])
    assert one.oscillator == other.oscillator


def test_a_hinge_has_its_own_joint():
    soft = assess.Interface(model="flexible", stiffness=1e10)
    load = assess.OverburdenLoad(force=4e4, eccentricity=0.0)
    whole = assess.two_block(WALL, direction=(1.0, 0.0, 0.0), crack=2.4, loads=[load], interface=soft)
    single = assess.two_block(
        WALL, direction=(1.0, 0.0, 0.0), crack=2.4, loads=[load], interfaces=dict.fromkeys("ABC", soft)
    )
    assert whole.oscillator == single.oscillator
    with pytest.raises(MechanismError, match="interfaces"):
        assess.two_block(WALL, crack=2.4, interfaces={"A": "flexible"})


def test_what_is_no_mechanism_moves_nowhere(block, folder):
    record = assess.read_record(folder / "motion.csv")
    target = assess.spectrum("ec8", a_g=2.0, ground_type="A")
    for other in (None, WALL, block.mechanism):
        with pytest.raises(MechanismError, match="give a mechanism"):
            assess.respond(other, record)
        with pytest.raises(MechanismError, match="give a mechanism"):
            assess.envelope(other, "sine", frequency=[1.0], amplitude=[1.0])
        with pytest.raises(MechanismError, match="give a mechanism"):
            assess.answers(other, target, procedures=["ntc2018-linear"])


@pytest.mark.parametrize("given", [{"scale": "2"}, {"scale": None}, {"scale": 1e300}, {"equation": "x"}])
def test_motions_that_cannot_be_solved_are_refused(block, folder, given):
    with pytest.raises((RecordError, AssessError), match=r"scale|equation"):
        assess.respond(block, assess.read_record(folder / "motion.csv"), **given)


@pytest.mark.parametrize("samples", ["a", [1.0, 2.0], np.zeros((3, 3)), np.ones(3) * 1j, np.array(["a", "b"]), None])
def test_samples_that_are_no_row_of_numbers_are_refused(block, samples):
    with pytest.raises(RecordError, match="array of numbers"):
        assess.respond(block, assess.Record(id="r", acceleration=samples, dt=0.01))


@pytest.mark.parametrize(
    "given", [{"pulse": 3}, {"frequency": ["a"]}, {"amplitude": "a"}, {"jobs": -1}, {"jobs": "a"}, {"equation": "x"}]
)
def test_envelopes_of_what_is_no_pulse_are_refused(block, given):
    with pytest.raises((RecordError, AssessError)):
        assess.envelope(block, **{"pulse": "sine", "frequency": [1.0, 2.0], "amplitude": [1.0, 2.0], **given})


@pytest.mark.parametrize(
    "given",
    [{"procedures": 3}, {"records": None}, {"base_elevation": "6 m"}, {"building": {"height": 9.0}}, {"target": "ec8"}],
)
def test_answers_on_what_is_no_site_are_refused(block, given):
    target = assess.spectrum("ec8", a_g=2.0, ground_type="A")
    with pytest.raises((RecordError, AssessError), match="give"):
        assess.answers(block, **{"target": target, "procedures": ["ntc2018-linear"], **given})


@pytest.mark.parametrize(
    "given",
    [
        {"height": "9"},
        {"height": None},
        {"storeys": 2.5},
        {"storeys": "3"},
        {"storeys": True},
        {"damping": "5 %"},
        {"damping": 5.0},
    ],
)
def test_structures_that_are_none_are_refused(given):
    with pytest.raises(ProcedureError, match=next(iter(given))):
        assess.building(**{"height": 9.0, **given})


@pytest.mark.parametrize(
    "given",
    [
        {"a_g": None},
        {"a_g": [1.0]},
        {"ground_type": ["C"]},
        {"damping": "5 %"},
        {"damping": 5.0},
        {"pga": "0.2 g"},
        {"importance_factor": None},
    ],
)
def test_spectra_of_what_is_no_number_are_refused(given):
    with pytest.raises(SpectrumError, match=next(iter(given))):
        assess.spectrum("ec8", **{"a_g": 2.5, "ground_type": "C", **given})


def test_tables_that_cannot_be_read_are_refused(tmp_path):
    for given in ({"file": tmp_path / "none.csv"}, {"file": tmp_path}, {"file": 3}):
        with pytest.raises(SpectrumError, match="file"):
            assess.spectrum("table", **given)
    with pytest.raises(SpectrumError, match="rows of numbers"):
        assess.spectrum("table", period=["a", "b"], acceleration=[1.0, 2.0])


@pytest.mark.parametrize("path", [None, 3, b"x", ["a"], "\0"])
def test_what_is_no_path_is_refused(path):
    with pytest.raises(AssessError, match="path"):
        assess.load(path)
    with pytest.raises(RecordError, match="path"):
        assess.read_record(path)
    with pytest.raises(AssessError, match="path"):
        assess.run(path)


def test_reports_that_cannot_be_written_are_refused(run, tmp_path):
    (tmp_path / "file").write_text("x")
    for given in ({"folder": None}, {"folder": "\0"}, {"language": "xx"}, {"jobs": -1}, {"folder": tmp_path / "file"}):
        with pytest.raises(AssessError, match=r"give|choose"):
            assess.write_report(run, **{"folder": tmp_path / "out", **given})
    with pytest.raises(AssessError, match=r"what assess.run returns"):
        assess.write_report(run.results, tmp_path / "out")
    assert not (tmp_path / "out").exists()


ONE_SIDED = """
[mechanisms.W2]
kind = "single-block"
blocks = ["wall"]
direction = [1, 0, 0]
sides = "one"
"""


def test_one_sided_motion_is_that_of_a_run(folder):
    file = folder / "one-sided.toml"
    file.write_text(PROJECT + ONE_SIDED)
    told = assess.run(file).results.mechanisms[1].histories[0]
    block = assess.single_block(WALL, direction=(1.0, 0.0, 0.0), sides="one")
    record = assess.read_record(folder / "motion.csv")
    motion = assess.respond(block, record, scale=told.polarity * told.scale_factor)
    assert motion.rebound == told.rebound
    assert motion.overturned == told.overturned
    assert (motion.max_rotation, motion.impacts) == (told.max_rotation_rad, told.impacts)
    assert motion.overturning_time == told.overturning_time_s


def test_vertical_motion_rocks_nothing(block, folder):
    upward = replace(assess.read_record(folder / "motion.csv"), component="UP")
    with pytest.raises(RecordError, match="vertical"):
        assess.respond(block, upward)
    target = assess.spectrum("ec8", a_g=2.0, ground_type="A")
    with pytest.raises(AssessError, match="vertical"):
        assess.answers(block, target, procedures=["ntc2018-history"], records=[upward])


def test_what_a_run_and_its_parts_show_of_themselves(run, folder):
    assert repr(run).startswith("Run('project.toml', 1 mechanism, ")
    assert repr(assess.load(folder / "project.toml")).endswith("project.toml', mechanisms: W1)")
    assert repr(WALL) == "Body('box', 21600 kg, 'box', 2000 kg/m3)"


def test_progress_that_cannot_be_called_is_refused(folder):
    with pytest.raises(AssessError, match="progress = 3"):
        assess.run(folder / "project.toml", progress=3)
