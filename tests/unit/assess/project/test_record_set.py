"""[records.select] in a project: what is chosen, how it is scaled, what the results and the report say of it."""

from pathlib import Path

import numpy as np
import pytest
from scipy.constants import g

from assess.errors import AssessError, ProjectError
from assess.project.build import build
from assess.project.project_file import load
from assess.results import Results
from assess.results.json import dumps, loads
from assess.study.run import run_study
from assess.study.suites import equivalent_periods
from records.catalogue import NAME
from records.errors import RecordError
from records.processing import at2_text
from records.record import make_record
from records.response import response_spectrum
from reports.assessment import assessment
from reports.language.texts import Quantity
from tests.support.letters import letters, rows
from tests.support.projects import ASCE7, published, results_of, study_of, tables_toml

SELECT = 'files = ["motions"]\nselect = { count = 3, scale_limits = [0.01, 100.0] }'


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A project's folder with two components each of six recordings, a vertical one and a text."""
    place = tmp_path_factory.mktemp("project")
    (place / "motions").mkdir()
    rng = np.random.default_rng(5)
    for number in range(6):
        for component in ("000", "090"):
            shake = rng.normal(0.0, 1.0, 1500) * np.hanning(1500)
            smooth = np.convolve(shake, np.hanning(9 + 6 * number), mode="same")
            write(place, number, component, 0.3 * smooth)
    write(place, 0, "UP", rng.normal(0.0, 1.0, 1500))
    (place / "motions" / "README").write_text("no record")
    return place


def write(place: Path, number: int, component: str, acceleration: np.ndarray) -> None:
    record = make_record(
        "x", acceleration, 0.02, event=f"Quake {number}", station=f"Station {number}", component=component
    )
    (place / "motions" / f"RSN{100 + number}_Q_{component}.AT2").write_text(at2_text(record))


def project(records: str = SELECT) -> str:
    return tables_toml(
        site={"spectrum": ASCE7},
        mechanisms={"slow": published(), "quick": published(3.36, 0.34, 0.62)},
        records=records,
        analysis={"levels": ["0.1 g"], "procedures": ["asce43-05-spectrum"]},
    )


@pytest.fixture(scope="module")
def results(folder: Path) -> Results:
    return results_of(folder, project())


def equal_work(alpha: float, p: float) -> float:
    """T [s] of a block at theta = alpha/2: I omega^2 theta^2 / 2 = M g R (cos(alpha - theta) - cos alpha)."""
    theta = alpha / 2
    return 2 * np.pi * theta / np.sqrt(2 * p**2 * (np.cos(alpha - theta) - np.cos(alpha)))


def test_periods_of_the_mechanisms_are_the_range(folder: Path) -> None:
    built = study_of(folder, project())
    found = equivalent_periods(built.mechanisms)
    assert found["slow"] == pytest.approx([equal_work(0.14, 1.6)] * 2, rel=1e-6)
    assert found["quick"] == pytest.approx([equal_work(0.34, 3.36)] * 2, rel=1e-6)
    least, largest = found["quick"][0], found["slow"][1]
    low, high = built.fitting.band.ends
    step = 10 ** (1 / 40)
    assert 0.2 * least <= low <= 0.2 * least * step
    assert 1.2 * largest / step <= high <= 1.2 * largest


def test_the_suite_is_of_different_earthquakes_horizontal_and_scaled_to_the_target(results: Results) -> None:
    assert len({record.event for record in results.records}) == 3
    assert not any(record.component == "UP" for record in results.records)
    assert [record.path.split("/")[0] for record in results.records] == ["motions"] * 3
    assert [100 + int(record.event[-1]) for record in results.records] == [record.nga for record in results.records]
    motion = results.ground_motion
    assert motion is not None
    assert motion.selection is not None
    remaining = [(one.step, one.number) for one in motion.selection.remaining]
    assert remaining[:2] == [("components", 13), ("horizontal at the free surface", 12)]
    assert motion.misfit == pytest.approx(motion.selection.misfit, rel=1e-9)
    assert motion.selection.greedy_misfit is not None
    assert motion.misfit <= motion.selection.greedy_misfit * (1 + 1e-9)


def test_the_factor_is_that_of_least_squares_over_the_range(results: Results, folder: Path) -> None:
    motion = results.ground_motion
    assert motion is not None
    band = study_of(folder, project()).fitting.band.period
    built = {record.id: record for record in study_of(folder, project()).records}
    target = np.interp(band, motion.period_s, motion.target_g) * g
    for record in results.records:
        ratio = np.log(target / response_spectrum(built[record.id], band))
        assert record.scale_factor == pytest.approx(np.exp(ratio.mean()), rel=1e-2)  # the target is interpolated
        assert record.mse == pytest.approx(ratio.var(), rel=5e-2)


def test_a_folder_has_a_catalogue_afterwards_and_a_pattern_has_none(folder: Path, tmp_path: Path) -> None:
    study_of(folder, project())
    assert (folder / "motions" / NAME).is_file()
    (folder / "motions" / NAME).unlink()
    with_pattern = study_of(folder, project(SELECT.replace("motions", "motions/*.AT2")))
    assert not (folder / "motions" / NAME).exists()
    assert {record.id for record in with_pattern.records} == {
        record.id for record in study_of(folder, project()).records
    }


def test_what_cannot_be_read_in_a_folder_is_told_and_in_a_list_refused(folder: Path) -> None:
    (notice,) = (one for one in study_of(folder, project()).messages if one.where == "records.files")
    assert notice.key == "file-not-read"
    assert "README" in notice.text
    with pytest.raises(RecordError, match="README"):
        study_of(folder, project(SELECT.replace('"motions"', '"motions/README"')))


def test_components_kept_together_share_their_factor(folder: Path) -> None:
    found = run_study(study_of(folder, project(SELECT.replace("count = 3", 'count = 3, components = "together"'))))
    assert len(found.records) == 6
    factors: dict[str, set[float]] = {}
    for record in found.records:
        factors.setdefault(record.event, set()).add(record.scale_factor)
    assert [len(each) for each in factors.values()] == [1, 1, 1]
    assert found.ground_motion is not None


def test_the_same_project_gives_the_same_bytes(folder: Path, results: Results) -> None:
    text = dumps(results)
    assert dumps(results_of(folder, project())) == text
    assert loads(text) == results


def test_the_inputs_are_the_records_chosen(results: Results) -> None:
    assert {each.path for each in results.inputs} == {"project.toml", *(record.path for record in results.records)}


@pytest.mark.parametrize(
    ("records", "error", "said"),
    [
        ('files = ["motions"]', ProjectError, "is a folder; add `select`"),
        ("select = { count = 3 }", ProjectError, "records.select: .*add files"),
        (
            SELECT.replace("count = 3", "count = 7"),
            ProjectError,
            "records.select: 7 records wanted; there are 13 components",
        ),
        (SELECT.replace("count = 3", "count = 0"), ProjectError, "count"),
        (SELECT.replace("count = 3", 'count = 3, periods = ["2 s", "1 s"]'), ProjectError, "larger than the second"),
        (SELECT.replace("count = 3", 'count = 3, periods = ["20 s", "30 s"]'), ProjectError, "records.select.*between"),
        (SELECT.replace("count = 3", 'count = 3, periods = ["1 m", "2 m"]'), ProjectError, "periods"),
        (SELECT.replace("count = 3", 'count = 3, fit = "best"'), ProjectError, "fit"),
        (SELECT.replace("count = 3", "count = 3, cuont = 3"), ProjectError, 'did you mean "count"'),
        (SELECT.replace("count = 3", "count = 3, magnitude = [5, 7]"), ProjectError, "0 that pass the filters"),
        (SELECT + '\nflatfile = "motions/README"', RecordError, "Record Sequence Number"),
        (SELECT + '\nflatfile = "none.csv"', ProjectError, "no such file"),
    ],
)
def test_bad_input_is_one_line_that_names_the_key(
    folder: Path, records: str, error: type[Exception], said: str
) -> None:
    with pytest.raises(error, match=said) as caught:
        study_of(folder, project(records))
    assert "\n" not in str(caught.value)


def test_a_sweep_cannot_vary_the_selection(folder: Path) -> None:
    (folder / "project.toml").write_text(
        project() + '[analysis.sweep]\nkey = "records.select.count"\nvalues = [2, 3]\n'
    )
    with pytest.raises(AssessError, match="sweep"):
        build(load(folder))


def test_the_report_has_the_suite_beside_target_and_codes(results: Results) -> None:
    document = assessment(results, detail="full")
    tables = {table.name: table for table in document.tables}
    assert {"suite-records", "selection", "equivalent-periods", "requirements"} <= set(tables)
    assert [row[0] for row in rows(tables["suite-records"])] == [record.id for record in results.records]
    motion = results.ground_motion
    assert motion is not None
    column = [letters(each.label) for each in tables["requirements"].columns].index("Found")
    found = [row[column] for row in tables["requirements"].rows]
    assert [each and each.value for each in found if each is None or isinstance(each, Quantity)] == [
        one.value for one in motion.requirements
    ]
    (figure,) = (each for each in document.figures if each.name == "suite")
    lines = {line.get_label(): line for line in figure.draw(document.locale).axes[0].lines}
    shown = np.asarray(lines["mean"].get_ydata())
    np.testing.assert_allclose(shown, motion.mean_g[-len(shown) :], rtol=1e-15)


def test_artificial_records_have_a_ground_motion_without_a_selection(folder: Path) -> None:
    found = run_study(study_of(folder, project("synthetic = { count = 3, duration = 8 }"))).ground_motion
    assert found is not None
    assert found.selection is None
    assert (found.from_s, found.to_s) == pytest.approx((0.1, 2.0))
    clause = [one for one in found.requirements if one.code == "NTC 2018" and one.from_s is not None]
    assert [one.from_s for one in clause] == [0.15]
