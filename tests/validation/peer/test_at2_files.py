"""Real PEER AT2 files against an index made by an independent parser. The files are not part of the project."""

from pathlib import Path

import pytest
from scipy.constants import g

from records.reading import read_records
from tests.support.places import REAL_RECORDS, index_rows, needs_real_records

pytestmark = needs_real_records

ROWS = [row for row in index_rows() if row["format"] == "PEER AT2"]
NUMBERED = {"14383980": "Chino Hills 2008 (ev 14383980)"}  # titled by the number of the event


def test_the_index_lists_sixty_two_files() -> None:
    assert len(ROWS) == 62


@pytest.mark.parametrize("row", ROWS, ids=lambda row: Path(row["file"]).name)
def test_a_file_is_as_the_index_says(row: dict[str, str]) -> None:
    (record,) = read_records(REAL_RECORDS / row["file"])
    assert record.npts == int(row["npts"])
    assert record.dt == float(row["dt_s"])
    assert record.pga / g == pytest.approx(float(row["pga_g"]), rel=5e-6)  # six printed digits
    assert NUMBERED.get(record.event, record.event) == row["event"]
    assert (record.station, record.component) == (row["station"], row["component"])
