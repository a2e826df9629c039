"""The front matter says what is given, where it is given, and leaves out what is not."""

from __future__ import annotations

from dataclasses import replace

from assess.results import Picture, ReportMatter, ResolvedValue, Results, Revision
from reports.chapters import front_matter
from reports.language.locale import Locale
from tests.support.letters import letters

FULL = ReportMatter(
    client="The Trustees",
    address="Via Roma 1\n41012 Carpi",
    coordinates=(44.78, 10.88),
    author="A. Author",
    office="Rocking & Co.",
    licence_number="1234",
    checker="B. Checker",
    date="12 May 2026",
    status="for approval",
    engineer="E. Engineer",
    reference="GH-07",
    revisions=(Revision("0", "1 May 2026", "first issue", "A"), Revision("1", "12 May 2026", "north face", "A")),
    seismic_zone="3",
)
PICTURE = Picture("logo.png", "", "image/png", 200, 80, "aGVsbG8=")


def facts(results: Results) -> dict[str, str]:
    return {letters(label): letters(text) for label, text in front_matter.facts(results)}


def test_all_that_is_given_is_said_once(results: Results) -> None:
    said = facts(replace(results, report=FULL, stamp="2e39-f77f"))
    assert said["Client"] == "The Trustees"
    assert said["Coordinates"] == "latitude 44.78°, longitude 10.88°"
    assert said["Author"] == "A. Author, Rocking & Co., licence number 1234"
    assert said["Engineer"] == "E. Engineer"
    assert said["Latest revision"] == "1, 12 May 2026, north face"
    assert said["Stamp of these results"] == "2e39-f77f"


def test_what_is_not_given_has_no_line(results: Results) -> None:
    assert set(facts(replace(results, project={}, report=ReportMatter()))) == {"Program"}


def test_results_of_older_versions_take_it_from_the_project(results: Results) -> None:
    said = facts(results)
    assert (said["Client"], said["Author"], said["Reference"]) == ("The Trustees", "A. Builder, CEng", "GH-07")
    assert "Engineer" not in said


def test_italian_sites_have_class_and_reference_life(results: Results) -> None:
    assert results.spectrum is not None
    spectrum = replace(
        results.spectrum,
        code="ntc2018",
        parameters={"nominal_life": 50.0, "use_coefficient": 1.5, "reference_life": 75.0},
    )
    project = {**results.project, "site.spectrum.use_class": ResolvedValue("III", True)}
    said = facts(replace(results, spectrum=spectrum, project=project))
    assert said["Class of use"] == "III, C_U = 1.5"
    assert (said["Nominal life V_N"], said["Reference life V_R"]) == ("50 years", "75 years")


def test_a_report_without_a_title_says_what_it_is(results: Results) -> None:
    assert letters(front_matter.title(replace(results, project={}))) == "Seismic assessment of masonry"


def test_each_page_has_reference_revision_and_status(results: Results) -> None:
    running = [letters(text) for text in front_matter.running_head(replace(results, report=FULL))]
    assert running == ["GH-07", "revision 1", "for approval"]
    assert front_matter.running_head(replace(results, project={}, report=ReportMatter())) == ()


def test_the_logo_is_a_photograph(results: Results) -> None:
    made = front_matter.logo(replace(results, report=ReportMatter(logo=PICTURE)))
    assert made is not None
    assert (made.width, made.height, made.data) == (200, 80, "aGVsbG8=")
    assert front_matter.logo(results) is None


def test_italian_writes_the_coordinates_with_a_comma(results: Results) -> None:
    label, given = front_matter.facts(replace(results, report=FULL))[2]
    assert letters(label) == "Coordinates"
    assert "44,78" in Locale("it").text(given)
