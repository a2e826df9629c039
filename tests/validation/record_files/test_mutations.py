"""Real files of every format with one value changed or bytes lost: refused, doubted, or the same record.

The files are not part of the project; what is changed is written into a temporary folder.
"""

import random
import re
from pathlib import Path

import numpy as np
import pytest

from records.errors import RecordError
from records.plausibility import record_warning
from records.reading import read_records
from tests.support.files import write_file
from tests.support.places import REAL_RECORDS, needs_real_records

pytestmark = needs_real_records

TWICE = {  # file: where its step or rate stands; another place says it again
    "knet/AOM0041801241951.EW": r"Sampling Freq\(Hz\) (\d+)",
    "esm/HI.ARS1..HNE.D.20190728.160908.C.ACC.ASC": r"SAMPLING_INTERVAL_S: ([\d.]+)",
    "cosmos/Cosmos12TimeSeriesTest.v1": r"\n  -999\.000000    (10\.0)00000    70",
    "csmip/ce36456p_CE36456.V2": r"ACCEL DATA EQUALLY SPACED AT\s+([\d.]+) SEC",
    "csmip/CE89146.V1": r"points at (\d+) pts",
    "geonet_v2a/20180212_211557_WPWS_20.V2A": r"corrected data at ([\d.]+) sec",
    "smc/0111a.smc": r"E\+39  (0\.2000000E\+03)",
    "plain/elCentro.at2": r"DT=\s*([\d.]+)",
}
ONCE = {  # only what the motion, its filter and its clock allow speaks against a step ten times too long
    "peer_at2/RSN6_IMPVALL.I_I-ELC180.AT2": r"DT=\s*([\d.]+)",
    "peer_at2/NIS090.AT2": r"4096\s+([\d.]+)",
    "itaca_cor_acc/16839_H1.cor.acc": r"Time Increment \(s\)\s+: ([\d.]+)",
    "afad_txt/20170720223109_4819.txt": r"SAMPLING INTERVAL \(sec\) : ([\d.]+)",
    "esm/20101114230825_3104_ap_RawAcc_E.asc": r"SAMPLING_INTERVAL_S: ([\d.]+)",
}
FILES = {**TWICE, **ONCE}
NUMBERS = re.compile(r"[\s0-9.eE+-]+")


def with_step(name: str, factor: float) -> str:
    text = (REAL_RECORDS / name).read_text("latin-1")
    found = re.search(FILES[name], text)
    assert found is not None
    printed = f"{float(found[1]) * factor:.7E}" if "E" in found[1] else f"{float(found[1]) * factor:.6g}"
    return text[: found.start(1)] + printed + text[found.end(1) :]


@pytest.mark.parametrize("factor", [0.1, 0.5, 2.0, 10.0])
@pytest.mark.parametrize("name", TWICE)
def test_another_step_is_refused_where_something_repeats_it(tmp_path: Path, name: str, factor: float) -> None:
    with pytest.raises(RecordError) as caught:
        read_records(write_file(tmp_path / Path(name).name, with_step(name, factor), encoding="latin-1"))
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("name", ONCE)
def test_a_step_ten_times_too_long_is_doubted_where_it_stands_once(tmp_path: Path, name: str) -> None:
    assert all(
        "check the step" in record_warning(record)
        for record in read_records(write_file(tmp_path / Path(name).name, with_step(name, 10.0), encoding="latin-1"))
    )


@pytest.mark.parametrize("name", FILES)
def test_lines_that_lost_bytes_are_refused_or_doubted(tmp_path: Path, name: str) -> None:
    """But for minus signs of ESM's single column, which is aligned on the left."""
    lines = (REAL_RECORDS / name).read_text("latin-1").split("\n")
    chance = random.Random(name)
    numbers = [i for i, line in enumerate(lines) if line.strip() and NUMBERS.fullmatch(line)]
    first = next(i for i in numbers if all(j in numbers for j in range(i, i + 60)))
    for _ in range(6):
        at, lost = chance.randrange(first + 40, first + 60), chance.randrange(1, 9)
        start = chance.randrange(max(1, len(lines[at].rstrip()) - lost))
        if name.startswith("esm") and start == 0:
            continue
        damaged = lines[at][:start] + lines[at][start + lost :]
        try:
            found = read_records(
                write_file(
                    tmp_path / Path(name).name, "\n".join([*lines[:at], damaged, *lines[at + 1 :]]), encoding="latin-1"
                )
            )
        except RecordError:
            continue
        assert any(record_warning(record) for record in found), (at + 1, damaged)


@pytest.mark.parametrize("name", [name for name in TWICE if not name.startswith("plain")])
def test_no_digit_of_a_header_changes_step_size_peak_or_direction_unsaid(tmp_path: Path, name: str) -> None:
    """To a thousandth: a step that differs by less is within the rounding of what repeats it."""
    text, chance = (REAL_RECORDS / name).read_text("latin-1"), random.Random(name)
    whole = read_records(REAL_RECORDS / name)
    end = re.search(r"(?:^[-+ 0-9.eE\r]+\n){30}", text, re.MULTILINE)  # where samples begin
    assert end is not None
    digits = [i for i in range(end.start()) if text[i].isdigit()]
    for at in chance.sample(digits, 12):
        other = chance.choice([each for each in "0123456789" if each != text[at]])
        try:
            found = read_records(
                write_file(tmp_path / Path(name).name, text[:at] + other + text[at + 1 :], encoding="latin-1")
            )
        except RecordError:
            continue
        for record, before in zip(found, whole, strict=True):
            same = (
                record.npts == before.npts
                and record.azimuth == before.azimuth
                and np.isclose(record.dt, before.dt, rtol=1e-3)
                and np.isclose(record.pga, before.pga, rtol=1e-3)
            )
            assert same or record_warning(record), text[max(0, at - 30) : at + 10]
