"""Which procedures are asked at which site, and the options of the Italian ones."""

from __future__ import annotations

from pathlib import Path

import pytest
from scipy.constants import g

from assess.errors import ProjectError
from assess.project.build import build
from assess.project.project_file import load
from assess.study.assessment import checks_without_twins
from assess.study.run import run_study
from assess.study.suites import motions_of
from tests.support import projects
from tests.support.projects import block, project_toml, wall

ROWS = """hazard = [
    { return_period = 30, a_g = "0.08 g", f_0 = 2.4, t_c_star = 0.27 },
    { return_period = 475, a_g = "0.26 g", f_0 = 2.36, t_c_star = 0.35 },
    { return_period = 975, a_g = "0.33 g", f_0 = 2.40, t_c_star = 0.36 },
]
nominal_life = 50
use_class = "II"
"""
NTC = 'soil = "B"\na_g = "0.26 g"\nf_0 = 2.4\nt_c_star = 0.35'
ASCE = "s_ds = 5\ns_d1 = 2\nt_l = 6"
ASCE43 = {"asce43-05-spectrum", "asce43-05-spectrum-thesis", "asce43-05-history"}
DMI2008 = {"dmi2008-linear", "dmi2008-nonlinear", "dmi2008-nonlinear-thesis"}
NTC2018 = {"ntc2018-linear", "ntc2018-nonlinear", "ntc2018-history"}


def study_of(folder: Path, *, code="ntc2018", spectrum=NTC, tail="", count=1, **mechanism):
    text = project_toml(
        tail,
        site={"spectrum": f'code = "{code}"\n{spectrum}'},
        materials={"m": {"density": 2000}},
        bodies={"w": wall(0.6, 4.0, 4.5, material="m")},
        mechanisms={"w": block("w", **mechanism)},
        records={"synthetic": {"count": count, "duration": "10 s"}},
    )
    return projects.study_of(folder, text)


@pytest.mark.parametrize(
    ("code", "spectrum", "asked"),
    [
        ("asce7-16", ASCE, ASCE43 | DMI2008 | {"asce41-13-ht"}),
        ("ntc2008", NTC, ASCE43 | DMI2008 | {"dmi2008-history"}),
        ("ntc2018", NTC, ASCE43 | NTC2018),
    ],
    ids=["asce7-16", "ntc2008", "ntc2018"],
)
def test_edition_of_the_site_decides_what_is_asked(tmp_path, code, spectrum, asked):
    study = study_of(tmp_path, code=code, spectrum=spectrum)
    assert set(study.procedures) == asked
    assert study.resolved["analysis.procedures"].value == list(study.procedures)
    assert not study.resolved["analysis.procedures"].given


def test_options_of_codes_that_are_not_asked_are_no_assumption_unless_given(tmp_path):
    plain = {key.split(".")[1] for key in study_of(tmp_path).resolved if key.startswith("procedures.")}
    assert plain == {"asce43-05", "ntc2018"}
    given = study_of(tmp_path, tail="[procedures.dmi2008]\nconfidence_factor = 1.2").resolved
    assert [key for key in given if key.startswith("procedures.dmi")] == ["procedures.dmi2008.confidence_factor"]


def test_procedures_that_have_no_limit_state_asked_for_are_left_out_or_refused(tmp_path):
    damage = '[procedures.ntc2018]\nlimit_states = ["SLD"]'
    decides = {"ntc2018-nonlinear"}  # runs whatever else is asked
    assert set(study_of(tmp_path, tail=damage).procedures) == ASCE43 | {"ntc2018-linear"} | decides
    named = f'[analysis]\nprocedures = ["ntc2018-nonlinear"]\n{damage}'
    with pytest.raises(ProjectError, match=r"ntc2018\.limit_states: SLD: ntc2018-nonlinear checks SLV, SLC; add one"):
        study_of(tmp_path, tail=named)


def test_knowledge_level_is_of_the_project_or_of_one_mechanism(tmp_path):
    assert study_of(tmp_path).knowledge == {"w": {}}
    study = study_of(tmp_path, tail='[procedures.ntc2018]\nknowledge_level = "LC2"')
    assert study.knowledge == {"w": {"ntc2018": "LC2"}}
    both = '[procedures.ntc2018]\nknowledge_level = "LC2"\nknowledge_levels = { w = "LC3" }\nconfidence_factor = 1.0'
    study = study_of(tmp_path, tail=both)
    assert study.knowledge == {"w": {"ntc2018": "LC3"}}
    assert study.options.ntc2018.confidence_factor == 1.0
    with pytest.raises(ProjectError, match=r'ntc2018\.knowledge_levels: "x": no such mechanism; known: w'):
        study_of(tmp_path, tail='[procedures.ntc2018]\nknowledge_levels = { x = "LC3" }')


def test_without_crushing_the_factor_of_lc1_decides_and_a_lower_one_informs(tmp_path):
    tail = '[analysis]\nprocedures = ["ntc2018-linear"]\n[procedures.ntc2018]\nconfidence_factor = 1.0'
    checks = [
        c for c in run_study(study_of(tmp_path, tail=tail)).mechanisms[0].checks if c.procedure == "ntc2018-linear"
    ]
    factors = {c.informs: next(s.value for s in c.steps if s.symbol == "FC") for c in checks if c.limit_state == "SLV"}
    assert factors == {False: 1.35, True: 1.0}
    assert {c.role for c in checks if c.informs} == {"comparison"}


def test_crushing_without_a_knowledge_level_is_not_answered_and_names_the_key(tmp_path):
    verdict = run_study(study_of(tmp_path, interface={"strength": "2 MPa"})).verdict
    assert "procedures.ntc2018.knowledge_level" in [each.key for each in verdict.missing]


def test_free_period_is_given_or_follows_from_the_wall(tmp_path):
    table = '{ length = "2 m", thickness = "30 cm", young_modulus = "0.8 GPa", density = 1800 }'
    for given, period in (('"0.2 s"', 0.2), (table, 0.124)):
        study = study_of(tmp_path, tail=f"[procedures.ntc2018]\nfree_periods = {{ w = {given} }}")
        assert study.free_periods["w"].value == pytest.approx(period, rel=1e-3)
    with pytest.raises(ProjectError, match='free_periods: "x": no such mechanism; known: w'):
        study_of(tmp_path, tail='[procedures.ntc2018]\nfree_periods = { x = "0.2 s" }')


def test_hazard_gives_each_limit_state_its_pga_and_pga_of_the_site_scales_all(tmp_path):
    spectrum = f'soil = "A"\n{ROWS}'
    study = study_of(tmp_path, spectrum=spectrum)
    assert study.hazard.return_period == (30.0, 475.0, 975.0)
    assert study.hazard.pga == pytest.approx((0.08 * g, 0.26 * g, 0.33 * g), rel=1e-12)
    assert study.hazard.spectra["SLV"].pga == pytest.approx(study.spectrum.pga, rel=1e-12)
    assert set(study.hazard.spectra) == {"SLO", "SLD", "SLV", "SLC"}
    text = (tmp_path / "project.toml").read_text()
    (tmp_path / "project.toml").write_text(text.replace("[site.spectrum]", '[site]\npga = "0.13 g"\n[site.spectrum]'))
    scaled = build(load(tmp_path))
    factor = 0.13 * g / study.spectrum.pga
    assert scaled.hazard.pga == pytest.approx([factor * pga for pga in study.hazard.pga], rel=1e-12)
    for state, before in study.hazard.spectra.items():
        assert scaled.hazard.spectra[state].pga == pytest.approx(factor * before.pga, rel=1e-12)


def test_limit_state_beyond_the_rows_is_checked_at_the_level(tmp_path):
    short = "\n".join(line for line in ROWS.splitlines() if "975" not in line)
    study = study_of(tmp_path, spectrum=f'soil = "A"\n{short}')
    assert set(study.hazard.spectra) == {"SLO", "SLD", "SLV"}


def test_histories_are_run_at_the_pga_of_each_limit_state_times_the_confidence_factor(tmp_path):
    tail = """[analysis]
    procedures = ["ntc2018-history", "ntc2018-linear"]
    [procedures.ntc2018]
    limit_states = ["SLV", "SLC"]
    """
    study = study_of(tmp_path, spectrum=f'soil = "A"\n{ROWS}', tail=tail, count=3)
    (wall,) = run_study(study).mechanisms
    found = {(check.procedure, check.limit_state): check for check in wall.checks}
    asked = {key for key in found if key[0] in ("ntc2018-history", "ntc2018-linear")}
    assert asked - {("ntc2018-linear", "SLD")} == {
        ("ntc2018-history", "SLV"),
        ("ntc2018-history", "SLC"),
        ("ntc2018-linear", "SLV"),
    }
    for state in ("SLV", "SLC"):
        steps = {step.symbol: step.value for step in found["ntc2018-history", state].steps}
        assert steps["FC · PGA"] == pytest.approx(1.35 * study.hazard.spectra[state].pga, rel=1e-12)
        assert found["ntc2018-history", state].level_pga_g == pytest.approx(study.spectrum.pga / g, rel=1e-12)
    assert {history.level_pga_g for history in wall.histories} == {study.spectrum.pga / g}
    rated = found["ntc2018-linear", "SLV"]
    assert rated.safety_index == pytest.approx(1 / rated.ratio, rel=1e-12)
    assert 30.0 <= rated.return_period_years <= 975.0


def test_cases_of_the_sensitivity_run_the_same_suites(tmp_path):
    tail = '[analysis]\nprocedures = ["ntc2018-history"]\n[procedures.ntc2018]\nlimit_states = ["SLV", "SLC"]'
    study = study_of(tmp_path, spectrum=f'soil = "A"\n{ROWS}', tail=tail, count=3)
    whole = {check.limit_state: check.ratio for check in run_study(study).mechanisms[0].checks}
    case = checks_without_twins(study, study.spectrum, motions_of(study, study.spectrum), jobs=1)
    assert {check.limit_state: check.ratio for check in case} == whole
    assert set(whole) == {"SLV", "SLC"}
