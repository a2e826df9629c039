"""Tables hold what the results hold, and nothing else."""

from __future__ import annotations

from dataclasses import asdict, replace

from reports.chapters.calculation_sheets import calculation_sheet
from reports.render.sheet_table import as_table

from assess.codes.check import Bound, Step
from assess.messages.message import message
from assess.results import Results
from reports.assessment import assessment
from reports.chapters import check_tables
from reports.language.numerals import step_result


def numbers_in(tree: object) -> set[float]:
    if isinstance(tree, bool):
        return set()
    if isinstance(tree, int | float):
        return {float(tree)}
    if isinstance(tree, dict):
        return set().union(*(numbers_in(value) for value in tree.values()))
    if isinstance(tree, list | tuple):
        return set().union(*(numbers_in(value) for value in tree))
    return set()


def test_every_number_of_every_table_stands_in_the_results(results: Results) -> None:
    known = numbers_in(asdict(results))
    assert results.spectrum is not None
    known |= {value / 9.80665 for value in numbers_in(results.spectrum.parameters)}  # accelerations are shown in g
    document = assessment(results)
    everything = (*document.tables, *(as_table(sheet) for sheet in document.sheets))
    cells = [cell for table in everything for row in table.rows for cell in row]
    found = [float(cell) for cell in cells if isinstance(cell, int | float) and not isinstance(cell, bool)]
    assert len(found) > 1000
    assert set(found) <= known


def test_rows_fit_their_columns_and_names_are_unique(results: Results) -> None:
    document = assessment(results)
    for table in document.tables:
        assert {len(row) for row in table.rows} <= {len(table.columns)}
    tables_and_sheets = [table.name for table in document.tables] + [sheet.name for sheet in document.sheets]
    for names in (tables_and_sheets, [figure.name for figure in document.figures]):
        assert len({name.lower() for name in names}) == len(names)
        assert all(name.replace("-", "").isalnum() and name.isascii() for name in names)


def test_a_return_period_beyond_the_hazard_is_shown_as_a_bound(results: Results) -> None:
    one = results.mechanisms[0]
    step = Step("T_R,C", "return period of the capacity", "NTC Annex A", "", "", 2475.0, "years", ">=")
    ends: tuple[tuple[Bound, str], ...] = (("<=", "≤ 30"), (">=", "≥ 30"))
    for bound, shown in ends:
        check = replace(one.checks[0], return_period_years=30.0, return_period_bound=bound, steps=(step,))
        table = check_tables.demands(replace(one, checks=(check,)), name="t")
        assert table.rows[0][[column.label for column in table.columns].index("Return period")] == shown
        made = calculation_sheet(check, name="s", mechanism="m")
        assert step_result(made.lines[0].value, made.lines[0].unit) == "≥ 2475 years"
        assert as_table(made).rows[0][-2:] == ("≥ 2475", "years")


def test_what_checks_say_is_told_at_the_sites_own_action_and_elsewhere_where_they_do_not_pass(
    results: Results,
) -> None:
    parapet = results.mechanisms[1]
    remark, condition = message("fails-below", {"pga": "0.3 g"}), message("premise-anchorage")
    first = replace(parapet.checks[0], remarks=(remark,), conditions=(condition,))
    table = check_tables.answers(replace(parapet, checks=(first, *parapet.checks[1:])), 0.067, name="a")
    heads = [column.label for column in table.columns]
    rows = [dict(zip(heads, row, strict=True)) for row in table.rows]
    assert {row["Outcome"] for row in rows if row["PGA"] != 0.067} == {"fail"}
    assert [row["Procedure"] for row in rows if row["PGA"] == 0.067] == [c.procedure for c in parapet.checks[:5]]
    assert rows[0]["Conditions and remarks"] == f"{condition.text}; {remark.text}"
    assert [row["Procedure"] for row in rows if row["Role"] == "deciding"] == ["asce43-05-history"]
    assert {row["Procedure"] for row in rows if row["Reading"] == "thesis"} == {"asce43-05-spectrum-thesis"}
    assert [row["Reading"] for place, row in enumerate(rows) if place in table.muted] == ["thesis"]
    assert next(row["Why"] for row in rows if row["PGA"] == 0.45).startswith("the demand exceeds")


def test_joints_without_a_threshold_have_no_pga_at_uplift(results: Results) -> None:
    one = results.mechanisms[0]
    soft = replace(one, checks=tuple(replace(check, uplift_pga_g=None) for check in one.checks))
    for mechanism, expected in (
        (one, [check.uplift_pga_g for check in one.checks]),
        (soft, ["none"] * len(one.checks)),
    ):
        table = check_tables.demands(mechanism, name="d")
        column = [each.label for each in table.columns].index("PGA at uplift")
        assert [row[column] for row in table.rows] == expected
        assert ("joints respond to any motion" in table.caption) == (mechanism is soft)


def test_safety_index_and_return_period_stand_only_where_some_check_has_them(results: Results) -> None:
    one = results.mechanisms[0]
    first, *others = one.checks
    rated = replace(first, safety_index=0.8, return_period_years=210.0)
    for checks, expected in ((one.checks, []), ((rated, *others), ["Safety index", "Return period"])):
        table = check_tables.demands(replace(one, checks=tuple(checks)), name="d")
        labels = [column.label for column in table.columns]
        assert [label for label in labels if label in ("Safety index", "Return period")] == expected
        assert all(len(row) == len(labels) for row in table.rows)
        assert [row[-1] for row in table.rows] == [check.verdict for check in checks]
    assert table.rows[0][-3:-1] == (0.8, 210.0)
    assert table.rows[1][-3:-1] == (None, None)
