"""Least works on real records and on the church of the examples; too long for every change."""

from __future__ import annotations

import json
import re
from itertools import product
from pathlib import Path

import pytest

import assess
from assess.examples import copy_example
from assess.project.build import build_with_cases
from assess.project.project_file import load
from assess.project.retrofit import RetrofitQuestion, _designs
from assess.results.retrofit import Target
from assess.study.retrofit import AS_DRAWN, measure_index
from tests.support.places import REAL_RECORDS, index_rows, needs_real_records
from tests.unit.assess.project.test_retrofit import AREA, COUNT, FACADE

pytestmark = [pytest.mark.study, pytest.mark.usefixtures("all_twins")]
OTHERS = (
    "kiknet/ISKH012401011610.EW2",
    "kiknet/ISKH012401011610.NS2",
    "afad_txt/20170720223109_4819.txt",
    "cosmos/Cosmos12TimeSeriesTest.v1",
)


@needs_real_records
def test_a_facade_under_67_records_is_proved_on_those_that_the_search_did_not_see(tmp_path: Path) -> None:
    """What suffices under the records of the search falls short with tolerances or others: the proof takes more."""
    files = [*sorted(row["file"] for row in index_rows() if row["format"] == "PEER AT2"), *OTHERS]
    named = json.dumps([str(REAL_RECORDS / file) for file in files])
    (tmp_path / "project.toml").write_text(FACADE.replace('["records/*.csv"]', named), encoding="utf-8")
    vary = {AREA: "80..400 mm^2 by 40", COUNT: "3..6"}
    found = assess.retrofit(tmp_path, target="probability", reach=0.1, vary=vary, search_records=33).results
    assert len(found.search_records) + len(found.proof_records) == 67
    assert abs(len(found.search_records) - 33) <= 1
    assert found.best is not None
    assert found.failed
    assert found.most == 5  # 0.16 / 0.9^34: so many could show it with no record that overturns
    assert len(found.proofs) == 25
    assert all(each.reached.overturned == 0 for each in found.proofs)
    least = min(each.steel for each in found.layouts if each.reached and found.target.may_hold(each.reached))
    assert found.best.steel > least


def church(folder: Path) -> Path:
    """The church with bars that stretch in the place of its tie of constant force."""
    path = copy_example("chiesa", folder)
    text = path.read_text(encoding="utf-8")
    bars = 'area = "314 mm^2", young_modulus = "210 GPa", yield_stress = "235 MPa",'
    text, number = re.subn(r'(kind = "tie", .*?)until = "collapse",', rf"\1{bars}", text)
    assert number == 1
    path.write_text(text, encoding="utf-8")
    return path


def test_on_the_church_three_starts_find_what_the_whole_grid_has(tmp_path: Path) -> None:
    path, name = church(tmp_path / "church"), "mechanisms.facade.ties"
    vary = {f"{name}.count": "3..8", f"{name}.area": "100..800 mm^2 by 20", f"{name}.height": "5..7 m by 0.5"}
    found = assess.retrofit(path, target="index", reach=1.0, vary=vary, spacing=4.0).results
    assert not found.whole
    assert found.best is not None
    designs = _designs(build_with_cases(load(path)), RetrofitQuestion("index", 1.0, vary, spacing=4.0))
    target, least = Target("index", 1.0, rising=True), float("inf")
    for place in product(*map(range, designs.sizes)):
        design = designs.design(place)
        layout = design.layout
        if layout.refused is None and layout.objective < least:
            (reached,) = measure_index([design.study(AS_DRAWN)])
            least = layout.objective if target.holds(reached) else least
    searched = min(each.objective for each in found.layouts if each.reached and target.holds(each.reached))
    assert least <= searched <= 1.01 * least
