"""What a suite misses of its code's rules, rule by rule, each with the line of the project file that would do."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from scipy.constants import g

from assess.messages.message import Message
from assess.project.build import build
from assess.project.project_file import load
from assess.study.run import run_study
from assess.study.study import ScaledRecord, Study
from assess.study.suites import artificial_band, motions_of, raise_artificial, spectrum_of_rules, suite_faults
from records.record import Record
from records.scaling import Scaling
from records.synthetic import artificial_records
from spectra.asce7 import design_spectrum
from tests.support import projects
from tests.support.projects import block, project_toml, wall

ASCE = 'code = "asce7-16"\ns_ds = "0.5 g"\ns_d1 = "0.2 g"\nt_l = "8 s"'
NTC = 'code = "ntc2018"\nsoil = "B"\na_g = "0.26 g"\nf_0 = 2.4\nt_c_star = 0.35'
ASCE43 = 'basis = "asce43-05"\nprocedures = ["asce43-05-history"]'
NTC2018 = 'procedures = ["ntc2018-history"]'


def study_of(folder: Path, *, code="asce43-05", verdict=None, records="", height=3.0, base=0.0, building="") -> Study:
    american = code == "asce43-05"
    text = project_toml(
        site={"limit_state": "DBE" if american else "SLV", "spectrum": ASCE if american else NTC},
        building=f"ground_elevation = 0\n{building}",
        verdict=verdict or (ASCE43 if american else NTC2018),
        materials={"m": {"density": 2000}},
        bodies={"w": wall(0.6, 4.0, height, material="m", base=[0, 0, base])},
        mechanisms={"w": block("w")},
        records=records,
    )
    return projects.study_of(folder, text)


@cache
def made(count: int, duration: float = 25.0) -> tuple[Record, ...]:
    """Records that follow the spectrum of the site of ASCE 7 closely."""
    return artificial_records(
        design_spectrum(s_ds=0.5 * g, s_d1=0.2 * g, t_l=8.0), count=count, seed=1, duration=duration
    )


def moved(records: Sequence[Record], factor: float = 1.0, **change: object) -> tuple[ScaledRecord, ...]:
    return tuple(ScaledRecord(replace(each, **change), Scaling(factor, 0.0)) for each in records)


def natural(records: Sequence[Record], factor: float = 1.0, **change: object) -> tuple[ScaledRecord, ...]:
    """The same motions as if they had been recorded."""
    return moved(records, factor, stationary=None, path="r.AT2", **change)


def faults(study: Study, motions: Sequence[ScaledRecord], code: str = "asce43-05") -> tuple[Message, ...]:
    assert study.spectrum is not None
    return suite_faults(study, study.spectrum, motions)[code]


def only(found: Sequence[Message], key: str) -> Message:
    (one,) = found
    assert one.key == key
    return one


def test_a_suite_that_meets_its_rules_has_no_faults(tmp_path: Path) -> None:
    assert faults(study_of(tmp_path), moved(made(7))) == ()
    assert faults(study_of(tmp_path), natural(made(5), 1.02)) == ()


def test_no_records_at_all_ask_for_files(tmp_path: Path) -> None:
    for code in ("asce43-05", "ntc2018"):
        one = only(faults(study_of(tmp_path, code=code), (), code), "suite-empty")
        assert one.where == "records.files"


@pytest.mark.parametrize(("given", "missing"), [(5, "2 more records"), (6, "1 more record")])
def test_fewer_than_seven_artificial_records_ask_for_more(tmp_path: Path, given: int, missing: str) -> None:
    study = study_of(tmp_path, records=f"synthetic = {{ count = {given} }}")
    one = only(faults(study, moved(made(7)[:given], 1.05)), "suite-count")
    assert missing in one.text
    assert one.where == "records.synthetic"
    assert one.values["toml"] == 'synthetic = { count = 7, duration = "25 s" }'


@pytest.mark.parametrize(("code", "least"), [("asce43-05", 5), ("ntc2018", 3)])
def test_recorded_ones_may_be_fewer(tmp_path: Path, code: str, least: int) -> None:
    study = replace(study_of(tmp_path, code=code), artificial=None)
    assert study.spectrum is not None
    records = artificial_records(study.spectrum, count=least, seed=1)
    assert faults(study, natural(records, 1.05), code) == ()
    few = only(faults(study, natural(records[1:], 1.05), code), "suite-count")
    assert (few.where, few.values["toml"]) == ("records.files", 'files = ["records/*.AT2"]')


@pytest.mark.parametrize("code", ["asce43-05", "ntc2018"])
def test_a_mean_that_is_low_by_a_factor_tells_the_factor(tmp_path: Path, code: str) -> None:
    study = replace(study_of(tmp_path, code=code), artificial=None)
    assert study.spectrum is not None
    records = artificial_records(study.spectrum, count=5, seed=1, band=(0.04, 6.0))
    one = only(faults(study, natural(records, 0.85), code), "suite-mean-low")
    assert one.where == "records.factor"
    factor = float(str(one.values["toml"]).removeprefix("factor = "))
    assert 1.0 < factor < 0.9 / 0.75
    assert faults(study, natural(records, 0.85 * factor), code) == ()
    assert faults(study, natural(records, 0.85 * (factor - 0.002)), code) != ()


def test_the_factor_goes_on_top_of_the_one_the_project_has(tmp_path: Path) -> None:
    study = replace(study_of(tmp_path, records="factor = 1.2"), artificial=None)
    one = only(faults(study, natural(made(5), 0.8)), "suite-mean-low")
    factor = float(str(one.values["toml"]).removeprefix("factor = "))
    assert faults(study, natural(made(5), 0.8 * factor / 1.2)) == ()


def test_recorded_ones_may_not_rise_above_1_30_of_the_target_in_the_italian_code(tmp_path: Path) -> None:
    study = replace(study_of(tmp_path, code="ntc2018"), artificial=None)
    assert study.spectrum is not None
    records = artificial_records(study.spectrum, count=5, seed=1, band=(0.04, 6.0))
    one = only(faults(study, natural(records, 1.4), "ntc2018"), "suite-mean-high")
    assert float(str(one.values["toml"]).removeprefix("factor = ")) < 0.97


def test_a_mean_of_another_shape_has_no_factor_that_does(tmp_path: Path) -> None:
    study = replace(study_of(tmp_path, code="ntc2018"), artificial=None)
    tone = Record("tone", 2.0 * np.sin(2 * np.pi * np.arange(2000) * 0.01), 0.01, path="r.AT2")
    found = faults(study, moved([tone] * 3), "ntc2018")
    assert {one.key for one in found} == {"suite-mean-low", "suite-mean-high"}
    assert {one.where for one in found} == {"records.files"}
    assert all("no one factor does" in one.text for one in found)


@pytest.mark.parametrize(
    ("code", "duration", "keys", "asked"),
    [
        ("asce43-05", 19.0, {"suite-duration"}, "20 s"),
        ("ntc2018", 24.0, {"suite-duration"}, "25 s"),
        ("ntc2018", 16.0, {"suite-duration", "suite-stationary"}, "25 s"),
    ],
)
def test_artificial_records_must_last(tmp_path: Path, code: str, duration: float, keys: set[str], asked: str) -> None:
    study = study_of(tmp_path, code=code, records=f'synthetic = {{ count = 7, duration = "{duration} s" }}')
    assert study.spectrum is not None
    records = artificial_records(study.spectrum, count=7, seed=1, duration=duration, band=(0.04, 5.0))
    found = faults(study, moved(records, 1.05), code)
    assert {one.key for one in found} == keys
    for one in found:
        assert one.where == "records.synthetic"
        assert one.values["toml"] == f'synthetic = {{ count = 7, duration = "{asked}" }}'
    assert f"records must last {asked}" in found[0].text


def test_artificial_records_of_a_coarse_step_are_told(tmp_path: Path) -> None:
    assert only(faults(study_of(tmp_path), moved(made(7), dt=0.0101)), "suite-step").where == "records.files"


def test_records_whose_processing_cut_the_slowest_mechanism_off_are_told(tmp_path: Path) -> None:
    study = replace(study_of(tmp_path), artificial=None)
    one = only(faults(study, natural(made(5), 1.05, longest_period=0.5)), "suite-usable")
    assert "usable up to 0.5 s" in one.text


def test_artificial_records_decide_only_where_the_method_is_named(tmp_path: Path) -> None:
    study = study_of(tmp_path, verdict='basis = "asce43-05"')
    one = only(faults(study, moved(made(7))), "suite-not-named")
    assert (one.where, one.values["toml"]) == ("verdict.procedures", 'procedures = ["asce43-05-history"]')
    assert faults(study, natural(made(7), 1.02)) == ()


def test_histories_that_decide_nothing_need_not_be_named(tmp_path: Path) -> None:
    study = study_of(tmp_path, code="ntc2018", verdict="")
    assert study.spectrum is not None
    made_here = artificial_records(study.spectrum, count=7, seed=1, band=(0.04, 6.0))
    assert suite_faults(study, study.spectrum, moved(made_here, 1.05)) == {"asce43-05": (), "ntc2018": ()}


def test_the_band_reaches_the_slowest_mechanism_and_the_artificial_records_with_it(tmp_path: Path) -> None:
    """A slender wall has a period of 2 pi / (p sqrt(3)) at half of its overturning rotation, one of 50 m 6.7 s.

    The records fit up to the next whole second, so those of a wall that is somewhat lower are the same.
    """
    study = study_of(tmp_path, height=50.0, records='synthetic = { duration = "40 s" }')
    assert study.spectrum is not None
    slow = 2 * np.pi / np.sqrt(3) / np.sqrt(3 * g / 4 / np.hypot(0.3, 25.0))
    assert 6.0 < slow < 7.0
    assert artificial_band(study, study.spectrum, duration=40.0) == (0.04, 7.0)
    lower = study_of(tmp_path, height=48.0, records='synthetic = { duration = "40 s" }')
    pairs = zip(motions_of(study, study.spectrum), motions_of(lower, study.spectrum), strict=True)
    assert all(one.record is other.record for one, other in pairs)
    for low in faults(study, moved(made(7))):
        assert f"{slow:.3g} s" in low.text
        assert low.where == "records.factor"
    assert faults(study, motions_of(study, study.spectrum)) == ()
    short = study_of(tmp_path, height=50.0, records='synthetic = { seed = 1, duration = "16 s" }')
    assert {one.values["toml"] for one in faults(short, motions_of(short, study.spectrum))} == {
        'synthetic = { count = 7, seed = 1, duration = "21 s" }'
    }


def test_the_italian_band_counts_the_building_below_a_mechanism(tmp_path: Path) -> None:
    study = study_of(tmp_path, code="ntc2018", base=6.0, building='height = "9 m"\nperiod = "4 s"')
    assert study.spectrum is not None
    assert artificial_band(study, study.spectrum, duration=40.0) == pytest.approx((0.04, 8.0))


def test_a_range_beyond_the_target_is_told(tmp_path: Path) -> None:
    (tmp_path / "s.csv").write_text("period [s],acceleration [g]\n0,0.2\n0.1,0.5\n0.4,0.5\n1.0,0.2\n")
    study = study_of(tmp_path)
    assert study.spectrum is not None
    short = replace(study.spectrum, longest_period=1.0)
    found = suite_faults(study, short, moved(made(7)))["asce43-05"]
    assert {(one.key, one.where) for one in found} == {("suite-out-of-reach", "site.spectrum")}


@pytest.mark.parametrize("code", ["asce43-05", "ntc2018"])
def test_the_suite_that_the_program_makes_meets_the_rules_and_decides(tmp_path: Path, code: str) -> None:
    study = study_of(tmp_path, code=code)
    results = run_study(study)
    (wall,) = results.mechanisms
    (deciding,) = {check.verdict for check in wall.checks if check.procedure == f"{code}-history"}
    assert deciding in ("pass", "fail")


def test_faults_leave_the_history_checks_unanswered_with_every_remedy_at_once(tmp_path: Path) -> None:
    study = study_of(tmp_path, records='synthetic = { count = 5, duration = "15 s" }')
    results = run_study(study)
    checks = [check for check in results.mechanisms[0].checks if check.procedure == "asce43-05-history"]
    assert {(check.verdict, check.reason.key) for check in checks} == {("not-answered", "suite-count")}
    assert results.verdict is not None
    (missing,) = (each for each in results.verdict.missing if each.key == "records.synthetic")
    assert missing.toml == 'synthetic = { count = 7, duration = "20 s" }'
    assert "2 more records" in missing.text
    assert "records must last 20 s" in missing.text


def test_a_further_factor_multiplies_every_record(tmp_path: Path) -> None:
    plain, more = (study_of(tmp_path, records=each) for each in ("", "factor = 1.1"))
    assert plain.spectrum is not None
    ratio = [
        b.scaling.factor / a.scaling.factor
        for a, b in zip(motions_of(plain, plain.spectrum), motions_of(more, plain.spectrum), strict=True)
    ]
    assert ratio == pytest.approx([1.1] * 7)


def test_a_suite_made_too_low_is_raised_by_the_least_factor_that_does_and_says_so(tmp_path: Path) -> None:
    study = study_of(tmp_path)
    assert study.spectrum is not None
    low = moved(made(7), 0.85)
    lifted = raise_artificial(low, study.spectrum, (0.04, 5.0), fitting=study.fitting)
    factors = {after.scaling.factor / before.scaling.factor for before, after in zip(low, lifted, strict=True)}
    (factor,) = {round(each, 12) for each in factors}
    assert 1.0 < factor < 1.0 / 0.85  # ten points side by side at the target need less than the mean at every one
    assert faults(study, lifted) == ()
    assert faults(study, moved(made(7), 0.85 * (factor - 1e-6))) != ()
    assert all(f"raised by {factor:.6g}" in str(each.record.processing_history[-1]) for each in lifted)
    assert raise_artificial(lifted, study.spectrum, (0.04, 5.0), fitting=study.fitting) == lifted


HAZARD = """code = "ntc2018"
soil = "A"
nominal_life = 50
use_class = "II"
hazard = [
    { return_period = 30, a_g = "0.08 g", f_0 = 2.4, t_c_star = 0.27 },
    { return_period = 475, a_g = "0.26 g", f_0 = 2.36, t_c_star = 0.35 },
    { return_period = 975, a_g = "0.33 g", f_0 = 2.40, t_c_star = 0.50 },
]"""


def test_a_suite_is_held_against_the_spectrum_of_the_limit_state_that_decides(tmp_path: Path) -> None:
    """Records of SLV, at the PGA of SLC, fall short of an SLC whose spectrum has a longer corner period."""
    study_of(tmp_path, code="ntc2018", verdict=f'limit_state = "SLC"\n{NTC2018}', records="synthetic = { count = 7 }")
    file = tmp_path / "project.toml"
    file.write_text(file.read_text().replace(NTC, HAZARD).replace('limit_state = "SLV"\n[site.', "[site."))
    study = build(load(tmp_path))
    assert study.spectrum is not None
    assert study.hazard is not None
    lesser, spectrum = (study.hazard.spectra[state] for state in ("SLV", "SLC"))
    assert spectrum_of_rules("ntc2018", study, lesser).pga == spectrum.pga
    assert suite_faults(study, spectrum, motions_of(study, spectrum))["ntc2018"] == ()
    (low,) = suite_faults(study, lesser, motions_of(study, lesser))["ntc2018"]
    assert low.key == "suite-mean-low"
