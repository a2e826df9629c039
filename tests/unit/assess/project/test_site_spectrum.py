"""[site.spectrum] of every code: from the project file to the ordinates, and one line for what is wrong."""

import re
from pathlib import Path

import pytest
from scipy.constants import g

from assess.codes.context import StatedFirstMode
from assess.errors import ProjectError
from assess.project.build import build
from assess.project.project_file import resolve
from assess.project.question import conditions_of_works, facts_of, question_of
from assess.project.site_and_structure import site_in, site_of, spectrum_of, vertical_of
from assess.study.ground_motion import spectrum_result
from spectra.errors import SpectrumError
from tests.support.projects import ASCE7, EC8, NTC, load_project, project_toml, published, replace_once, tables_toml

ROWS = """hazard = [
  { return_period = 30, a_g = "0.05 g", f_0 = 2.4, t_c_star = "0.28 s" },
  { return_period = 475, a_g = "0.16 g", f_0 = 2.45, t_c_star = "0.33 s" },
  { return_period = "2475 years", a_g = "0.3 g", f_0 = 2.5, t_c_star = "0.36 s" },
]"""
CODES = {
    "asce7-16": 'code = "asce7-16"\ns_s = "1.5 g"\ns_1 = "0.6 g"\nsite_class = "D"\nt_l = "8 s"',
    "ec8": 'code = "ec8"\na_g = "0.25 g"\nground_type = "B"',
    "nzs1170.5": 'code = "nzs1170.5"\nsubsoil = "C"\nz = 0.4\nr = 1.0\nnear_fault_distance = "5 km"',
    "ntc2018": 'code = "ntc2018"\na_g = "0.261 g"\nf_0 = 2.364\nt_c_star = "0.347 s"\nsoil = "B"',
    "hazard": f'code = "ntc2008"\nnominal_life = 50\nuse_class = "II"\nsoil = "A"\n{ROWS}',
}
PGA = {"asce7-16": 0.4, "ec8": 0.30, "nzs1170.5": 0.532, "ntc2018": 0.3010, "hazard": 0.15994}


def loaded(folder: Path, table: str, *, site: str = "", rest: str = ""):
    wall = tables_toml(mechanisms={"wall": published()})
    return load_project(folder, f"[site]\n{site}\n[site.spectrum]\n{table}\n{wall}{rest}")


def spectrum(folder: Path, table: str, *, site: str = ""):
    section = site_in(loaded(folder, table, site=site).content)
    assert section is not None
    return spectrum_of(section)


@pytest.mark.parametrize("code", list(CODES))
def test_peak_ground_acceleration_of_each_code(code: str, tmp_path: Path) -> None:
    """Hand-worked: 0.4 S_DS, a_g S, C(0), a_g S, and 0.05 (0.16 / 0.05)^x at 474.6 years; tolerance: the last digit."""
    assert spectrum(tmp_path, CODES[code]).pga / g == pytest.approx(PGA[code], abs=6e-5)


@pytest.mark.parametrize("code", list(CODES))
def test_pga_scales_the_ordinates_and_keeps_the_corners(code: str, tmp_path: Path) -> None:
    scaled = spectrum(tmp_path, CODES[code], site='pga = "0.1 g"')
    own = spectrum(tmp_path, CODES[code])
    assert scaled.pga == pytest.approx(0.1 * g, rel=1e-12)
    assert scaled.acceleration([0.2, 1.0, 5.0]) / scaled.pga == pytest.approx(
        own.acceleration([0.2, 1.0, 5.0]) / own.pga, rel=1e-12
    )


@pytest.mark.parametrize("code", list(CODES))
def test_damping_and_parameters_reach_the_results(code: str, tmp_path: Path) -> None:
    result = spectrum_result(spectrum(tmp_path, f"{CODES[code]}\ndamping = 0.08"))
    assert result.damping == 0.08
    assert result.acceleration_g[0] == pytest.approx(result.pga_g, rel=1e-12)
    given = [line.split(" = ")[0] for line in CODES[code].split("hazard")[0].splitlines()]
    assert set(given) - {"code"} <= set(result.parameters)


def test_limit_states_ask_for_their_own_return_period(tmp_path: Path) -> None:
    tables = [f'{CODES["hazard"]}\nlimit_state = "{name}"' for name in ("SLO", "SLD", "SLV", "SLC")]
    found = [spectrum(tmp_path, table).parameters["return_period"] for table in tables]
    assert found == pytest.approx([30.1, 50.3, 474.6, 974.8], abs=0.06)


@pytest.mark.parametrize(
    ("use_class", "C_U", "V_R"), [("I", 0.7, 35.0), ("II", 1.0, 50.0), ("III", 1.5, 75.0), ("IV", 2.0, 100.0)]
)
def test_life_class_and_coefficient_of_use_reach_the_results(
    use_class: str, C_U: float, V_R: float, tmp_path: Path
) -> None:
    """NTC 2018, Tab. 2.4.II and (2.4.1); V_R of class I is the least, 35 years."""
    table = CODES["hazard"].replace('"II"', f'"{use_class}"')
    found = spectrum_result(spectrum(tmp_path, table)).parameters
    assert (found["nominal_life"], found["use_class"]) == (50.0, use_class)
    assert (found["use_coefficient"], found["reference_life"]) == (C_U, V_R)


def test_limit_state_of_the_site_s_own_action(tmp_path: Path) -> None:
    """[site] limit_state, its old spelling, [verdict] limit_state, else SLV; each at its own return period."""
    years = {"SLD": 50.3, "SLV": 474.6, "SLC": 974.8}
    hazard = CODES["hazard"].replace("ntc2008", "ntc2018")
    for site, rest, state in (
        ("", "", "SLV"),
        ('limit_state = "SLC"', "", "SLC"),
        ("", '[verdict]\nlimit_state = "SLC"', "SLC"),
        ('limit_state = "SLD"', '[verdict]\nlimit_state = "SLC"', "SLD"),
    ):
        study = build(loaded(tmp_path, hazard, site=site, rest=rest))
        assert study.spectrum is not None
        assert study.hazard is not None
        assert study.spectrum.parameters["return_period"] == pytest.approx(years[state], abs=0.06)
        assert study.spectrum.pga == pytest.approx(study.hazard.spectra[state].pga, rel=1e-12)
        assert (study.question.action.limit_state, study.question.action.over_periods) == (state, True)
        assert study.question.action.return_period_years == pytest.approx(years[state], abs=0.06)


def test_a_pga_below_that_of_the_hazard_decides_nothing(tmp_path: Path) -> None:
    hazard = CODES["hazard"].replace("ntc2008", "ntc2018")
    own = build(loaded(tmp_path, hazard)).spectrum
    assert own is not None
    for share, missing in ((0.1, ["site.pga"]), (0.99, ["site.pga"]), (0.999, []), (1.5, [])):
        study = build(loaded(tmp_path, hazard, site=f"pga = {share * own.pga}"))
        assert [each.key for each in study.question.missing] == missing


def test_two_limit_states_of_the_site_must_agree(tmp_path: Path) -> None:
    table = CODES["hazard"] + '\nlimit_state = "SLV"'
    assert spectrum(tmp_path, table, site='limit_state = "SLV"').parameters["limit_state"] == "SLV"
    with pytest.raises(ProjectError, match=r'site\.limit_state: "SLC": site\.spectrum\.limit_state, its old spelling'):
        loaded(tmp_path, table, site='limit_state = "SLC"')
    with pytest.raises(ProjectError, match=r"site\.limit_state: .*not one of the hazard over return periods"):
        loaded(tmp_path, CODES["hazard"], site='limit_state = "ULS"')
    with pytest.raises(ProjectError, match=r"limit_state: .*write it in \[site\]"):
        loaded(tmp_path, CODES["ntc2018"] + '\nlimit_state = "SLV"')


def test_class_of_use_of_the_site_or_of_the_building(tmp_path: Path) -> None:
    bare = CODES["hazard"].replace('use_class = "II"\n', "")
    in_building = build(loaded(tmp_path, bare, rest='[building]\nuse_class = "III"'))
    assert in_building.spectrum is not None
    assert in_building.spectrum.parameters["return_period"] == pytest.approx(1.5 * 474.6, abs=0.1)
    without = build(loaded(tmp_path, bare))
    assert [(each.key, each.toml) for each in without.question.provisional] == [
        ("building.use_class", 'use_class = "II"')
    ]
    assert without.spectrum is not None
    assert without.spectrum.parameters["return_period"] == pytest.approx(2.0 * 474.6, abs=0.1)  # C_U of class IV
    assert without.question.action.return_period_years == pytest.approx(2.0 * 474.6, abs=0.1)
    with pytest.raises(ProjectError, match=r"site\.spectrum\.use_class: missing"):
        site_of(loaded(tmp_path, bare).path)  # a command that prints the spectrum alone has no verdict
    with pytest.raises(ProjectError, match=r'building\.use_class: "III" beside site\.spectrum\.use_class "II"'):
        build(loaded(tmp_path, CODES["hazard"], rest='[building]\nuse_class = "III"'))


def test_a_first_mode_of_the_building_at_a_limit_state_reaches_the_study(tmp_path: Path) -> None:
    mode = 'limit_states = { SLV = { period = "0.5 s", damping = 0.12, reason = "pushover" } }'
    study = build(loaded(tmp_path, CODES["ntc2018"], rest=f'[building]\nheight = "9 m"\n{mode}'))
    assert study.building is not None
    assert study.building.limit_states == {"SLV": StatedFirstMode(0.5, 0.12, "pushover")}
    with pytest.raises(ProjectError, match=r"building\.limit_states"):
        loaded(tmp_path, CODES["ntc2018"], rest=f'[building]\nheight = "9 m"\n{mode.replace("SLV", "SLD")}')


def test_return_period_in_place_of_r(tmp_path: Path) -> None:
    table = CODES["nzs1170.5"].replace("r = 1.0", 'return_period = "1000 yr"')
    assert spectrum(tmp_path, table).parameters["r"] == pytest.approx(1.3, rel=1e-12)


@pytest.mark.parametrize(("code", "ratio"), [("ec8", 0.9 / 1.2), ("nzs1170.5", 0.7)])
def test_vertical_spectra_follow_the_scale_of_the_horizontal(code: str, ratio: float, tmp_path: Path) -> None:
    site = loaded(tmp_path, CODES[code], site='pga = "0.2 g"').content.site
    assert site is not None
    assert vertical_of(site).pga == pytest.approx(0.2 * g * ratio, rel=1e-12)


def test_codes_without_a_vertical_spectrum_say_so(tmp_path: Path) -> None:
    site = loaded(tmp_path, CODES["asce7-16"]).content.site
    assert site is not None
    with pytest.raises(SpectrumError, match=r"asce7-16 has no vertical spectrum here; ec8, nzs1170\.5"):
        vertical_of(site)


def test_a_site_that_needs_a_study_is_warned_of(tmp_path: Path) -> None:
    notices = [
        notice for notice in build(loaded(tmp_path, CODES["asce7-16"])).messages if notice.where == "site.spectrum"
    ]
    assert [notice.where for notice in notices] == ["site.spectrum"]
    assert "§11.4.8" in notices[0].text


DOUBTFUL = {  # hand-worked: Z R = 0.4 x 1.8 = 0.72
    "nzs1170.5": (("r = 1.0", "r = 1.8"), "", "Z R = 0.4 × 1.8 = 0.72 is taken as 0.7"),
    "ec8": (('"0.25 g"', '"25 m/s^2"'), 'pga = "0.2 g"', ""),
    "ec8, far": (('"0.25 g"', '"25 g"'), "", "a_g = 25 g is beyond any plausible site"),
    "ntc2018": (('"0.261 g"', '"3.1 g"'), "", "a_g = 3.1 g is beyond"),
    "asce7-16": (('"1.5 g"', '"150 m/s^2"'), "", "s_s = 15.3 g is beyond"),
    "hazard": (("use_class", "use_class"), 'pga = "10 g"', "pga = 10 g is beyond"),
}


@pytest.mark.parametrize("case", list(DOUBTFUL))
def test_values_that_no_site_has_are_doubted(case: str, tmp_path: Path) -> None:
    (old, new), site, words = DOUBTFUL[case]
    found = spectrum(tmp_path, CODES[case.split(",")[0]].replace(old, new), site=site).warnings
    assert any(words in each.text for each in found) if words else found == ()


def test_a_table_in_another_unit_is_doubted(tmp_path: Path) -> None:
    (tmp_path / "table.csv").write_text("period [s],acceleration [g]\n0,9.81\n1,9.81\n", encoding="utf-8")
    (told,) = spectrum(tmp_path, 'code = "table"\nfile = "table.csv"').warnings
    assert "S_a(0) = 9.81 g" in told.text


def test_a_hazard_factor_in_per_cent_is_refused(tmp_path: Path) -> None:
    with pytest.raises(SpectrumError, match=r"z = 40; the hazard factor is at most 0\.6"):
        spectrum(tmp_path, CODES["nzs1170.5"].replace("z = 0.4", "z = 40"))


def test_bare_accelerations_of_every_code_are_told(tmp_path: Path) -> None:
    table = CODES["hazard"].replace('"0.05 g"', "0.05").replace('"0.16 g"', "0.16")
    messages = loaded(tmp_path, table).messages
    assert [message.where for message in messages] == ["site.spectrum.hazard[1].a_g", "site.spectrum.hazard[2].a_g"]


def test_a_parameter_can_be_swept(tmp_path: Path) -> None:
    rest = '[analysis.sweep]\nkey = "site.spectrum.a_g"\nvalues = ["0.1 g", "0.2 g"]\n'
    study = build(loaded(tmp_path, CODES["ec8"], rest=rest))
    accelerations = [case.study.spectrum.pga / g for case in study.sweeps[0].cases if case.study.spectrum]
    assert accelerations == pytest.approx([0.12, 0.24], rel=1e-12)


def test_defaults_are_told_apart(tmp_path: Path) -> None:
    found = resolve(loaded(tmp_path, CODES["ec8"]))
    assert (found["site.spectrum.type"].value, found["site.spectrum.type"].given) == (1, False)
    assert found["site.spectrum.a_g"].given


WRONG = {
    "both forms of asce7": (CODES["asce7-16"] + '\ns_ds = "1 g"', 's_ds: "1 g": follows from s_s, s_1 and site_class'),
    "half a map": (
        replace_once(CODES["asce7-16"], 's_1 = "0.6 g"\n', ""),
        "s_1: missing; mapped spectral acceleration at 1 s",
    ),
    "neither form": ('code = "asce7-16"\nt_l = 6', "s_ds: missing; design spectral acceleration at short periods"),
    "site class": (replace_once(CODES["asce7-16"], '"D"', '"G"'), 'site_class: "G": not allowed; write "A", "B"'),
    "ground": (replace_once(CODES["ec8"], '"B"', '"b"'), 'ground_type: "b": not allowed; write "A", "B"'),
    "type": (CODES["ec8"] + "\ntype = 3", "type: 3: not allowed; write 1 or 2"),
    "importance": (CODES["ec8"] + "\nimportance_factor = 0", "importance_factor: 0: must be greater than 0"),
    "key of another code": (CODES["ec8"] + '\nsoil = "B"', 'soil: "B": unknown key'),
    "a length for an acceleration": (
        replace_once(CODES["ec8"], '"0.25 g"', '"0.25 m"'),
        'a_g: "0.25 m": "m" is not a unit of',
    ),
    "r twice": (CODES["nzs1170.5"] + "\nreturn_period = 500", "r: 1.0: give either r"),
    "no r": (
        replace_once(CODES["nzs1170.5"], "r = 1.0\n", ""),
        "r: give either r, the return period factor, or return_period",
    ),
    "seconds for years": (
        replace_once(CODES["nzs1170.5"], "r = 1.0", 'return_period = "500 s"'),
        'return_period: "500 s": "s" is not a unit of duration; write a duration like "50 years", or a number in years',
    ),
    "hazard of one row": (
        'code = "ntc2018"\nnominal_life = 50\nuse_class = "II"\nsoil = "A"\nhazard = [{ return_period = 475 }]',
        "hazard",
    ),
    "life without hazard": (CODES["ntc2018"] + "\nnominal_life = 50", "nominal_life: 50: goes with hazard = ["),
    "a_g beside hazard": (CODES["hazard"] + '\na_g = "0.1 g"', 'a_g: "0.1 g": stands in the rows of hazard'),
    "row without f_0": (
        replace_once(CODES["hazard"], "f_0 = 2.4, ", ""),
        "hazard[1].f_0: missing; largest amplification",
    ),
    "limit state": (CODES["hazard"] + '\nlimit_state = "SLU"', 'limit_state: "SLU": not allowed; write "SLO"'),
    "relief": (CODES["ntc2018"] + "\nrelief_position = 1.2", "relief_position: 1.2: must be 1 or less"),
    "hazard of words": (replace_once(CODES["hazard"], ROWS, 'hazard = "big"'), 'hazard: "big": not a list'),
}


@pytest.mark.parametrize("case", WRONG)
def test_what_is_wrong_is_one_line(case: str, tmp_path: Path) -> None:
    table, expected = WRONG[case]
    with pytest.raises(ProjectError) as caught:
        loaded(tmp_path, table)
    assert f": site.spectrum.{expected}" in str(caught.value)
    assert str(caught.value).isprintable()


REFUSED = {
    "class F": (
        replace_once(CODES["asce7-16"], '"D"', '"F"'),
        "site_class = F: ASCE 7-16 §11.4.8 asks for a site response",
    ),
    "class of another edition": (
        CODES["asce7-16"].replace("asce7-16", "asce7-10").replace('"D"', '"D-default"'),
        "site_class = D-default; ASCE 7-10 Table 11.4-1 has A, B, C, D, E",
    ),
    "special ground": (
        replace_once(CODES["ec8"], '"B"', '"S1"'),
        r"ground_type = S1: EN 1998-1, 3.1.2(4)P asks for a special study",
    ),
    "special soil": (replace_once(CODES["ntc2018"], '"B"', '"S2"'), "soil = S2: §3.2.2 asks for a special analysis"),
    "f_0": (replace_once(CODES["ntc2018"], "2.364", "2.0"), "f_0 = 2; NTC 2018 §3.2.3.2 has at least 2.2"),
    "unsorted hazard": (replace_once(CODES["hazard"], "= 475", "= 3000"), "the return periods of its rows do not rise"),
    "short hazard": (
        replace_once(CODES["hazard"], '"2475 years"', "500") + '\nlimit_state = "SLC"',
        "the return period asked for, 974.8 years, is outside its rows, 30 to 500 years; add rows",
    ),
}


@pytest.mark.parametrize("case", REFUSED)
def test_what_the_code_refuses_is_one_line(case: str, tmp_path: Path) -> None:
    table, expected = REFUSED[case]
    project = loaded(tmp_path, table)
    with pytest.raises(SpectrumError) as caught:
        build(project)
    text = str(caught.value)
    assert text.startswith(f"{project.path}: site.spectrum: ")
    assert expected in text
    assert text.isprintable()


@pytest.mark.parametrize(
    ("more", "words"),
    [
        ({"effective_height": 12.5}, "effective_height: 12.5: above the building, height = 9 m"),
        (
            {"period": 0.5, "limit_states": {"SLV": {"period": 0.4, "damping": 0.1, "reason": "test"}}},
            "limit_states.SLV.period: 0.4: shorter than that of the elastic building, 0.5 s",
        ),
        ({"damping": 0.35}, "damping: 0.35: must be greater than 0 and 0.3 or less"),
    ],
)
def test_a_building_that_cannot_be_is_refused_with_both_numbers(tmp_path, more, words):
    text = project_toml(site={"spectrum": NTC}, building={"height": 9.0, **more})
    with pytest.raises(ProjectError, match=re.escape(words)):
        load_project(tmp_path, text)


@pytest.mark.parametrize(
    ("life", "phase", "accepted"), [(5, "works", True), (9.9, "works", True), (9.9, "use", False), (10, "use", True)]
)
def test_a_nominal_life_of_five_to_ten_years_is_of_a_phase_of_works(tmp_path, life, phase, accepted):
    """NTC 2018, 2.4.1."""
    hazard = [{"return_period": years, "a_g": 1.0, "f_0": 2.5, "t_c_star": 0.3} for years in (30, 2475)]
    spectrum = {"code": "ntc2018", "hazard": hazard, "nominal_life": life, "soil": "A", "use_class": "II"}
    text = project_toml(site={"spectrum": {**spectrum, "phase": phase}})
    if not accepted:
        with pytest.raises(ProjectError, match=re.escape("nominal_life: 9.9: below 10 years only")):
            load_project(tmp_path, text)
        return
    of = load_project(tmp_path, text).content
    keys = [each.key for each in conditions_of_works(of, question_of(of, site_pga=1.0))]
    assert keys == (["phase-of-works"] if phase == "works" else [])


@pytest.mark.parametrize("works", ["none", "local", "improvement", "upgrading"])
def test_works_on_the_whole_building_pass_on_condition_of_the_global_check(tmp_path, works):
    """NTC 2018, 8.4.2 and 8.4.3."""
    of = load_project(tmp_path, project_toml(site={"spectrum": NTC}, verdict={"works": works})).content
    keys = [each.key for each in conditions_of_works(of, question_of(of, site_pga=1.0))]
    assert keys == (["global-check"] if works in ("improvement", "upgrading") else [])


def test_a_nominal_life_below_five_years_is_refused(tmp_path):
    hazard = [{"return_period": years, "a_g": 1.0, "f_0": 2.5, "t_c_star": 0.3} for years in (30, 2475)]
    spectrum = {"code": "ntc2018", "hazard": hazard, "nominal_life": 4, "soil": "A"}
    with pytest.raises(ProjectError, match="nominal_life: 4: must be 5 years or more"):
        load_project(tmp_path, project_toml(site={"spectrum": spectrum}))


CLASS_KEY, YEARS_KEY = "building.use_class", "site.return_period"
SPECTRUM_OF = {"ntc2018": NTC, "dmi2008": NTC, "ec8": EC8, "asce41-13": ASCE7}


def pass_needs(tmp_path, basis, site, building):
    """Return the keys that a pass of the wall needs of the site's spectrum, and its conditions."""
    text = project_toml(site=site, building={"height": 9.0, **building}, verdict={"basis": basis})
    of = load_project(tmp_path, text).content
    missing, conditions = facts_of(of, question_of(of, site_pga=1.0), ("wall",))["wall"]
    of_site = [each for each in missing if each.key.startswith(("site.", "building."))]
    keys = [each.key for each in of_site]
    assert all(each.enlarges for each in of_site) or site["spectrum"]["code"] == "table", keys  # of which all is known
    return keys, [each.key for each in conditions]


@pytest.mark.parametrize(
    ("basis", "state", "years", "use_class", "missing"),
    [
        # T_R = -V_R / ln(1 - P): 475 years at 10 % in 50, 949 in 100 (class IV), 332 in 35 (class I); 975 at 5 % in 50
        ("ntc2018", "SLV", 475, "II", None),
        ("ntc2018", "SLV", 470, "II", YEARS_KEY),
        ("ntc2018", "SLV", 475, "III", YEARS_KEY),
        ("ntc2018", "SLV", 712, "III", None),
        ("ntc2018", "SLV", 333, "I", None),
        ("ntc2018", "SLC", 475, "II", YEARS_KEY),
        ("ntc2018", "SLC", 975, "II", None),
        ("ntc2018", "SLV", 475, None, CLASS_KEY),
        ("ntc2018", "SLV", 950, None, None),
        ("dmi2008", "SLV", 100, "II", YEARS_KEY),
        ("ec8", "ULS", 95, None, YEARS_KEY),
        ("ec8", "ULS", 475, None, None),
        ("asce41-13", "BSE-2E", 225, None, YEARS_KEY),
        ("asce41-13", "BSE-1E", 225, None, None),
    ],
)
def test_a_stated_return_period_is_held_against_limit_state_and_class(
    tmp_path, basis, state, years, use_class, missing
):
    site = {"limit_state": state, "return_period": years, "spectrum": SPECTRUM_OF[basis]}
    building = {} if use_class is None else {"use_class": use_class}
    conditions = ["premise-importance-class"] if basis == "ec8" else []
    assert pass_needs(tmp_path, basis, site, building) == ([missing] if missing else [], conditions)


@pytest.mark.parametrize(("basis", "state", "told"), [("ntc2018", "SLV", True), ("ec8", "ULS", False)])
def test_a_return_period_that_is_not_stated_is_a_condition_of_the_italian_codes(tmp_path, basis, state, told):
    """EN 1998-1 defines a_gR at 475 years; a_g, F_0 and T_C* of the NTC may be those of any."""
    site = {"limit_state": state, "spectrum": SPECTRUM_OF[basis]}
    assert pass_needs(tmp_path, basis, site, {"use_class": "II"}) == ([], ["return-period-unstated"] if told else [])


@pytest.mark.parametrize(
    ("basis", "more", "damping", "building", "keys"),
    [
        ("ntc2018", {}, {}, {"use_class": "II"}, [YEARS_KEY, "site.spectrum.damping"]),
        ("ntc2018", {"return_period": 475}, {}, {"use_class": "II"}, ["site.spectrum.damping"]),
        ("ntc2018", {"return_period": 475}, {"damping": 0.05}, {"use_class": "II"}, []),
        ("ntc2018", {"return_period": 475}, {"damping": 0.05}, {"use_class": "IV"}, [YEARS_KEY]),
        ("asce43-05", {}, {"damping": 0.05}, {}, [YEARS_KEY]),
        ("nzsee2017", {"return_period": 500}, {"damping": 0.05}, {"importance_level": 3}, [YEARS_KEY]),
        ("nzsee2017", {"return_period": 1000}, {"damping": 0.05}, {"importance_level": 3}, []),
    ],
)
def test_a_table_says_its_return_period_and_damping(tmp_path, basis, more, damping, building, keys):
    state = {"ntc2018": "SLV", "asce43-05": "DBE", "nzsee2017": "ULS"}[basis]
    (tmp_path / "s.csv").write_text("period [s],acceleration [g]\n0,0.2\n4,0.2\n")
    site = {"limit_state": state, **more, "spectrum": {"code": "table", "file": "s.csv", **damping}}
    assert pass_needs(tmp_path, basis, site, building)[0] == keys


@pytest.mark.parametrize(
    ("spectrum", "why"),
    [
        ({"code": "nzs1170.5", "z": 0.1, "r": 1.0, "subsoil": "C"}, 'of code = "nzs1170.5" it stands in'),
        (
            {
                "code": "ntc2018",
                "hazard": [{"return_period": years, "a_g": 1.0, "f_0": 2.5, "t_c_star": 0.3} for years in (30, 2475)],
                "nominal_life": 50,
                "soil": "A",
            },
            "of a hazard over return periods the limit state gives it",
        ),
    ],
)
def test_a_spectrum_that_has_its_return_period_takes_no_second_one(tmp_path, spectrum, why):
    text = project_toml(site={"return_period": 475, "spectrum": spectrum})
    with pytest.raises(ProjectError, match=f"site.return_period: 475: {why}"):
        load_project(tmp_path, text)


FACTOR_KEY = "site.spectrum.importance_factor"


@pytest.mark.parametrize(
    ("use_class", "given", "missing", "conditions"),
    [
        # gamma_I of 4.2.5(5); a_g of 475 x 1.2^3 = 821 years is that of class III without it, 475 x 1.4^3 of class IV
        ("III", {}, [FACTOR_KEY], []),
        ("IV", {"importance_factor": 1.2}, [FACTOR_KEY], []),
        ("IV", {"importance_factor": 1.4}, [], []),
        ("III", {"return_period": 821}, [], []),
        ("IV", {"return_period": 821}, [FACTOR_KEY], []),
        ("II", {}, [], []),
        ("I", {}, [], []),
        (None, {}, [], ["premise-importance-class"]),
        (None, {"importance_factor": 1.2}, [], ["premise-importance-class"]),
    ],
)
def test_the_importance_class_of_en1998_is_held_against_the_spectrum(tmp_path, use_class, given, missing, conditions):
    years = {key: value for key, value in given.items() if key == "return_period"}
    factor = {key: value for key, value in given.items() if key == "importance_factor"}
    site = {"limit_state": "ULS", "spectrum": EC8 | factor, **years}
    building = {} if use_class is None else {"use_class": use_class}
    assert pass_needs(tmp_path, "ec8", site, building) == (missing, conditions)


def test_an_importance_level_is_the_importance_class_of_that_rank_where_no_class_of_use_is_given(tmp_path):
    """Of the two the class of use counts, as it is what EN 1998-1 is asked by."""
    site = {"limit_state": "ULS", "spectrum": EC8 | {"importance_factor": 1.2}}
    for building, missing in (
        ({"importance_level": 4}, [FACTOR_KEY]),
        ({"importance_level": 3}, []),
        ({"importance_level": 4, "use_class": "III"}, []),
    ):
        assert pass_needs(tmp_path, "ec8", site, building) == (missing, [])


@pytest.mark.parametrize("hazard", ["design", "mce"])
def test_a_spectrum_by_asce_7_that_is_declared_the_design_basis_earthquake_has_that_as_condition(tmp_path, hazard):
    site = {"limit_state": "DBE", "spectrum": ASCE7 | {"hazard": hazard}}
    assert pass_needs(tmp_path, "asce43-05", site, {}) == ([], ["dbe-by-asce7"])
    assert pass_needs(tmp_path, "asce41-13", site | {"limit_state": "BSE-1E"}, {}) == ([], [])
