"""A spectrum that a project file refuses is refused from Python too, at the same key for the same reason."""

from __future__ import annotations

from pathlib import Path
from typing import Any, get_args

import pytest

import assess
from assess.declaration import Evidence, NotAKey, annotations_of, marks_of, meanings_of
from assess.errors import ProjectError
from assess.project.project_file import load
from spectra.design_spectra import SPECTRA, HazardRow, NtcHazardSpectrum
from spectra.errors import SpectrumError
from tests.support.projects import project_toml, write_project

DESIGN = {"code": "asce7-16", "s_ds": 5.0, "s_d1": 2.0, "t_l": 6.0}
MAPPED = {"code": "asce7-16", "s_s": 6.0, "s_1": 1.5, "site_class": "C", "t_l": 6.0}
EC8 = {"code": "ec8", "a_g": 2.5, "ground_type": "B"}
NZS = {"code": "nzs1170.5", "subsoil": "D", "z": 0.4, "r": 1.3}
TS = {"code": "ts1170.5", "pga_site": 1.8, "s_as": 3.8, "t_c": 0.52, "t_d": 2.8}
NTC = {"code": "ntc2018", "a_g": 1.5, "f_0": 2.4, "t_c_star": 0.3, "soil": "A"}
ROW = {"return_period": 30.0, "a_g": 0.5, "f_0": 2.4, "t_c_star": 0.3}
LAST = ROW | {"return_period": 2475.0, "a_g": 3.0}
HAZARD = {"code": "ntc2018", "hazard": [ROW, LAST], "nominal_life": 50.0, "use_class": "II", "soil": "A"}
TABLE = {"code": "table"}
ABOVE_0 = "must be greater than 0"
ONE_R = "give either r, the return period factor, or return_period"
IN_ROWS = "stands in the rows of hazard; remove it here, or hazard"
OF_ROWS = "goes with hazard = [{ return_period, a_g, f_0, t_c_star }, …]; remove it, or a_g, f_0 and t_c_star"

FAULTS: list[tuple[dict[str, Any], dict[str, Any], str, str]] = [
    # bounds
    (EC8, {"a_g": -1.0}, "a_g", ABOVE_0),
    (EC8, {"damping": 0.0}, "damping", ABOVE_0),
    (EC8, {"damping": 1.0}, "damping", "must be less than 1"),
    (EC8, {"importance_factor": 0.0}, "importance_factor", ABOVE_0),
    (NZS, {"near_fault_distance": -1.0}, "near_fault_distance", "must be 0 or more"),
    (NTC, {"relief_position": 1.2}, "relief_position", "must be 1 or less"),
    (HAZARD, {"hazard": [ROW]}, "hazard", "too few; give at least 2"),
    (HAZARD, {"hazard": [ROW, LAST | {"f_0": 0.0}]}, "hazard[2].f_0", ABOVE_0),
    # words
    (DESIGN, {"hazard": "max"}, "hazard", 'not allowed; write "design" or "mce"'),
    (EC8, {"type": 3}, "type", "not allowed; write 1 or 2"),
    (EC8, {"type": 1.0}, "type", "not allowed; write 1 or 2"),
    (EC8, {"type": True}, "type", "not allowed; write 1 or 2"),
    (NTC, {"topography": "T5"}, "topography", 'not allowed; write "T1", "T2", "T3" or "T4"'),
    (HAZARD, {"use_class": "V"}, "use_class", 'not allowed; write "I", "II", "III" or "IV"'),
    # keys that are unknown, of another way, missing, or exclude each other
    (EC8, {"importance": 1.2}, "importance", 'unknown key; did you mean "importance_factor"?'),
    (EC8, {"soil": "B"}, "soil", "unknown key; known here: damping, code, a_g, ground_type, type, importance_factor"),
    (MAPPED, {"s_ds": 5.0}, "s_ds", "follows from s_s, s_1 and site_class; remove it, or those three"),
    (NTC, {"nominal_life": 50.0}, "nominal_life", OF_ROWS),
    (HAZARD, {"a_g": 1.5}, "a_g", IN_ROWS),
    (HAZARD, {"hazard": [ROW, LAST | {"years": 475.0}]}, "hazard[2].years", "unknown key; known here: "),
    (HAZARD, {"hazard": [ROW, {}]}, "hazard[2].return_period", "missing; return period, like 475: in years"),
    (DESIGN, {"t_l": None}, "t_l", 'missing; long-period transition period, like "6 s"'),
    (TABLE, {}, "file", "missing; CSV of period and acceleration, with units in the header"),
    (NZS, {"return_period": 500.0}, "r", ONE_R),
    (NZS, {"r": None}, "r", ONE_R),
]
OUTSIDE_ITS_CLAUSE: list[tuple[dict[str, Any], dict[str, Any], str]] = [
    (MAPPED, {"site_class": "F"}, "site_class = F: ASCE 7-16 §11.4.8 asks for a site response analysis"),
    (EC8, {"ground_type": "S1"}, "EN 1998-1, 3.1.2(4)P asks for a special study"),
    (TS, {"t_d": 0.5}, "0.1 s < T_c < T_d is needed"),
    (NTC, {"f_0": 2.0}, "f_0 = 2; NTC 2018 §3.2.3.2 has at least 2.2"),
    (HAZARD, {"hazard": [LAST, ROW]}, "the return periods of its rows do not rise"),
]


def refusals(table: dict[str, Any], folder: Path) -> tuple[str, str]:
    """Return what the project file and what Python say of a spectrum; empty where they take it."""
    from assess.project.site_and_structure import site_in, spectrum_of

    stated = {key: value for key, value in table.items() if value is not None}
    by_file = by_python = ""
    try:
        site = site_in(load(write_project(folder, project_toml(site={"spectrum": stated}))).content)
        assert site is not None
        spectrum_of(site)
    except (ProjectError, SpectrumError) as error:
        by_file = str(error).removeprefix(f"{folder / 'project.toml'}: ").removeprefix("site.spectrum")
    try:
        assess.spectrum(**stated)
    except SpectrumError as error:
        by_python = str(error).removeprefix(f"{table['code']} spectrum")
    return by_file, by_python


@pytest.mark.parametrize(("sound", "fault", "key", "said"), FAULTS)
def test_a_spectrum_is_refused_for_one_reason(sound, fault, key, said, tmp_path):
    for refusal in refusals(sound | fault, tmp_path):
        assert refusal.lstrip(".: ").startswith(key)
        assert f": {said}" in refusal


@pytest.mark.parametrize(("sound", "fault", "said"), OUTSIDE_ITS_CLAUSE)
def test_a_spectrum_outside_its_clause_is_refused_by_both(sound, fault, said, tmp_path):
    assert all(said in refusal for refusal in refusals(sound | fault, tmp_path))


@pytest.mark.parametrize("sound", [DESIGN, MAPPED, EC8, NZS, TS, NTC, HAZARD])
def test_what_is_right_is_taken_by_both(sound, tmp_path):
    assert refusals(sound, tmp_path) == ("", "")


def test_a_class_of_use_is_missing_from_python_and_provisional_in_a_project(tmp_path):
    by_file, by_python = refusals(HAZARD | {"use_class": None}, tmp_path)
    assert by_file == ""
    assert by_python == ': use_class: missing; class of use "I" to "IV"'


@pytest.mark.parametrize("way", [*{way: None for ways in SPECTRA.values() for way in ways}, HazardRow])
def test_every_key_of_a_spectrum_says_what_it_is_and_who_vouches_for_it(way):
    sentences = meanings_of(way)
    for key, annotation in annotations_of(way).items():
        marks = [type(mark) for mark in marks_of(annotation)]
        assert sentences.get(key), f"{way.__name__}.{key}: write a sentence below it"
        assert marks.count(Evidence) == (NotAKey not in marks), f"{way.__name__}.{key}: one Evidence in its annotation"


def test_codes_are_those_that_their_ways_declare():
    for code, ways in SPECTRA.items():
        assert all(code in get_args(get_args(annotations_of(way)["code"])[0]) for way in ways)


def test_limit_states_are_those_of_the_italian_code():
    from spectra import ntc

    (states, _) = get_args(get_args(annotations_of(NtcHazardSpectrum)["limit_state"])[0])
    assert set(get_args(states)) == set(ntc.EXCEEDANCE)
