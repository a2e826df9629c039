"""Exports read again: NRML by the published formula, pelicun's table by its columns, and text of users."""

from __future__ import annotations

import csv
import io
from xml.etree import ElementTree as ET

import numpy as np
import pytest
from scipy.stats import lognorm

from assess.risk.estimates import Lognormal, wilson_interval
from assess.risk.exports import ExportedCurve, ExportedState, csv_text, nrml_text, pelicun_text

NAME = '{http://openquake.org/xmlns/nrml/0.5}'  # fmt: skip
HOSTILE = "=cmd|'/c calc'!A1 <wall> & \"6\"\x07"
MILD, SEVERE = Lognormal(0.15, 0.30), Lognormal(0.40, 0.45)


def state(name, lognormal, reached=(0, 0, 3, 6, 9)):
    intensity, records = np.array([0.05, 0.1, 0.2, 0.3, 0.5]), np.full(5, 10)
    low, high = wilson_interval(reached, records)
    return ExportedState(name, lognormal, intensity, records, np.array(reached), low, high)


def curve(name="wall", measure="pga", period=None, unit="g", severe=SEVERE):
    states = (state("rotation-0.5", MILD, (0, 2, 6, 9, 10)), state("overturning", severe, (0, 0, 1, 3, 2)))
    return ExportedCurve(name, measure, period, unit, states)


def functions(export):
    return ET.fromstring(export.text.encode()).findall(f"{NAME}fragilityModel/{NAME}fragilityFunction")


@pytest.mark.parametrize(("measure", "period", "unit", "imt", "factor"), [
    ("pga", None, "g", "PGA", 1.0), ("sa", 0.5, "g", "SA(0.5)", 1.0), ("pgv", None, "m/s", "PGV", 100.0),
])  # fmt: skip
def test_continuous_model_gives_medians_and_dispersions_back(measure, period, unit, imt, factor):
    """OpenQuake manual: mean and stddev of the intensity; beta^2 = ln(1 + (s / mu)^2), median mu exp(-beta^2 / 2)."""
    (function,) = functions(nrml_text([curve(measure=measure, period=period, unit=unit)], format="continuous"))
    assert (function.get("format"), function.get("shape")) == ("continuous", "logncdf")
    assert function.find(f"{NAME}imls").get("imt") == imt
    rows = function.findall(f"{NAME}params")
    assert [row.get("ls") for row in rows] == ["rotation_0_5", "overturning"]
    for row, truth in zip(rows, (MILD, SEVERE), strict=True):
        mean, stddev = float(row.get("mean")), float(row.get("stddev"))
        beta = np.sqrt(np.log1p((stddev / mean) ** 2))
        median = mean * np.exp(-0.5 * beta**2)
        assert median == pytest.approx(factor * truth.median, rel=1e-9)
        assert beta == pytest.approx(truth.dispersion, rel=1e-9)
        oracle = lognorm(s=truth.dispersion, scale=factor * truth.median)
        np.testing.assert_allclose([mean, stddev], [oracle.mean(), oracle.std()], rtol=1e-9)


@pytest.mark.parametrize(("median", "dispersion", "expected"), [(0.40, 0.45, 0.2613), (0.15, 0.30, 0.9896)])
def test_probabilities_at_three_tenths_of_g(median, dispersion, expected):
    (function,) = functions(nrml_text([curve(severe=Lognormal(median, dispersion))], format="continuous"))
    row = function.findall(f"{NAME}params")[1]
    mean, stddev = float(row.get("mean")), float(row.get("stddev"))
    sigma = np.sqrt(np.log(1 + (stddev / mean) ** 2))
    assert lognorm.cdf(0.3, sigma, scale=mean**2 / np.hypot(mean, stddev)) == pytest.approx(expected, abs=5e-5)


def test_limits_hold_all_but_the_far_tails():
    (function,) = functions(nrml_text([curve()], format="continuous"))
    imls = function.find(f"{NAME}imls")
    assert MILD.probability(float(imls.get("minIML"))) < 1e-4
    assert SEVERE.probability(float(imls.get("maxIML"))) > 1 - 1e-4
    assert 0.0 < float(imls.get("noDamageLimit")) <= float(imls.get("minIML"))
    least, most = (np.log(each.median) + way * each.dispersion for each, way in ((MILD, -4.0), (SEVERE, 4.0)))
    assert float(imls.get("minIML")) == pytest.approx(np.exp(least), rel=1e-6)
    assert float(imls.get("maxIML")) == pytest.approx(np.exp(most), rel=1e-6)


def test_discrete_model_has_the_empirical_points():
    (function,) = functions(nrml_text([curve()], format="discrete"))
    imls = function.find(f"{NAME}imls")
    assert imls.text == "0.05 0.1 0.2 0.3 0.5"
    assert float(imls.get("noDamageLimit")) == 0.05
    assert [row.text for row in function.findall(f"{NAME}poes")] == ["0.0 0.2 0.6 0.9 1.0", "0.0 0.0 0.1 0.3 0.2"]


def test_discrete_model_above_zero_at_its_first_intensity_begins_below_it():
    first = ExportedCurve("wall", "pga", None, "g", (state("overturning", SEVERE, (1, 2, 3, 4, 5)),))
    (function,) = functions(nrml_text([first], format="discrete"))
    assert 0.0 < float(function.find(f"{NAME}imls").get("noDamageLimit")) < 0.05


@pytest.mark.parametrize(("measure", "period", "unit"), [
    ("sa-average", None, "g"), ("pga/(g tan alpha)", None, "-"), ("p pgv/(g tan alpha)", None, "-"),
])  # fmt: skip
def test_measure_without_a_name_is_left_out_and_told(measure, period, unit):
    curves = [curve("other", measure, period, unit), curve()]
    for export in (nrml_text(curves, format="continuous"), nrml_text(curves, format="discrete"), pelicun_text(curves)):
        assert [(each.name, each.measure, each.reason) for each in export.left_out] == [
            ("other", measure, "no-name-of-measure")
        ]
        assert "other" not in export.text
    assert csv_text(curves).left_out == ()
    assert "other" in csv_text(curves).text


def test_state_without_a_lognormal_is_told_and_still_discrete():
    lacking = curve(severe=None)
    for export in (nrml_text([lacking, curve("b")], format="continuous"), pelicun_text([lacking, curve("b")])):
        (left_out,) = export.left_out
        assert (left_out.name, left_out.reason, left_out.state) == ("wall", "state-without-curve", "overturning")
    assert nrml_text([lacking], format="discrete").left_out == ()


def test_curves_that_cross_are_told():
    """A severer state with a wide dispersion is more likely than the milder one at small intensities."""
    (left_out,) = nrml_text([curve(severe=Lognormal(0.2, 0.9))], format="continuous").left_out
    assert (left_out.reason, left_out.state) == ("curves-cross", "overturning")


def test_mechanism_with_two_measures_has_two_taxonomies():
    export = nrml_text([curve(), curve(measure="sa", period=1.0)], format="continuous")
    assert [each.get("id") for each in functions(export)] == ["wall PGA", "wall SA(1)"]


def test_text_of_users_is_text():
    for export in (nrml_text([curve(HOSTILE)], format="continuous", description="<!-- & ]]>"),
                   nrml_text([curve(HOSTILE)], format="discrete", description=HOSTILE)):  # fmt: skip
        (function,) = functions(export)
        assert function.get("id") == "=cmd|_/c calc_!A1 <wall> & _6_"  # OpenQuake refuses quotes and #
    for text in (csv_text([curve(HOSTILE)]).text, pelicun_text([curve(HOSTILE)]).text):
        cells = [row[0] for row in csv.reader(io.StringIO(text))][1:]
        assert not any(cell.startswith(("=", "+", "-", "@")) for cell in cells)


def test_model_without_curves_is_well_formed():
    assert functions(nrml_text([], format="discrete")) == []
    assert pelicun_text([]).text.startswith("ID,Incomplete,Demand-Type")


def test_table_of_pelicun():
    rows = list(
        csv.DictReader(
            io.StringIO(pelicun_text([curve("wall-6"), curve("wall 6"), curve("w", "pgv", None, "m/s")]).text)
        )
    )
    assert [row["ID"] for row in rows] == ["wall_6", "wall_6..2", "w"]
    assert [row["Demand-Type"] for row in rows] == ["Peak Ground Acceleration"] * 2 + ["Peak Ground Velocity"]
    assert [row["Demand-Unit"] for row in rows] == ["g", "g", "mps"]
    fitted = [float(rows[0][f"LS{at}-Theta_{i}"]) for at in (1, 2) for i in (0, 1)]
    assert fitted == [MILD.median, MILD.dispersion, SEVERE.median, SEVERE.dispersion]
    assert {rows[0]["LS1-Family"], rows[0]["LS2-Family"]} == {"lognormal"}
    assert {row["Demand-Directional"] for row in rows} == {"1"}


def test_plain_table_has_every_digit():
    rows = list(csv.DictReader(io.StringIO(csv_text([curve(severe=Lognormal(0.1 + 0.2, 1 / 3))]).text)))
    assert len(rows) == 12
    assert float(rows[-1]["median"]) == 0.1 + 0.2
    assert float(rows[-1]["dispersion"]) == 1 / 3
    assert [int(row["reached"]) for row in rows[6:11]] == [0, 0, 1, 3, 2]


def test_curves_that_cross_in_their_far_tails_are_not_told():
    assert nrml_text([curve(severe=Lognormal(0.6, 0.5))], format="continuous").left_out == ()


def test_names_that_become_alike_stay_apart():
    export = nrml_text([curve("wall'"), curve("wall#"), curve("wall_")], format="continuous")
    assert [each.get("id") for each in functions(export)] == ["wall_", "wall_ ..2", "wall_ ..3"]


def test_a_mild_state_without_a_lognormal_leaves_the_others_in_the_file():
    """A rigid block begins to rock at one PGA, without scatter: its overturning is exported all the same."""
    step = ExportedCurve("wall", "pga", None, "g", (state("rocking", None, (0, 0, 10, 10, 10)), *curve().states))
    full = ExportedCurve("tower", "pga", None, "g", (state("rocking", Lognormal(0.1, 0.2)), *curve().states))
    model = nrml_text([full, step], format="continuous")
    for export in (model, pelicun_text([full, step])):
        assert [(each.name, each.state, each.reason) for each in export.left_out] == [
            ("wall", "rocking", "state-left-out")
        ]
    limits = ET.fromstring(model.text.encode()).find(f"{NAME}fragilityModel/{NAME}limitStates").text.split()
    assert limits == ["rotation_0_5", "overturning"]
    for function in functions(model):
        assert [row.get("ls") for row in function.findall(f"{NAME}params")] == limits


@pytest.mark.parametrize("format", ["continuous", "discrete"])
def test_all_functions_have_the_limit_states_of_the_model(format):
    """A mechanism on joints that deform at once has no state of rocking, and OpenQuake wants the same states in all."""
    rigid = ExportedCurve("rigid", "pga", None, "g", (state("rocking", Lognormal(0.1, 0.2)), *curve().states))
    export = nrml_text([rigid, curve("soft")], format=format)
    row = "params" if format == "continuous" else "poes"
    assert [[each.get("ls") for each in function.findall(f"{NAME}{row}")] for function in functions(export)] == [
        ["rotation_0_5", "overturning"]
    ] * 2
    assert [(each.name, each.state, each.reason) for each in export.left_out] == [("soft", "rocking", "state-left-out")]
