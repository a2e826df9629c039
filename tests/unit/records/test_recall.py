"""Records that this process has read are not read again, and a file that has changed is."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from records import reading
from records.errors import RecordError
from records.formats.header import NO_OVERRIDES, HeaderOverrides
from records.reading import read_with_overrides, recall_records
from records.record import make_record
from records.response import response_spectrum
from tests.support.motions import write_noise


def test_file_is_read_once_until_it_changes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    read: list[Path] = []
    monkeypatch.setattr(
        reading, "read_with_overrides", lambda path, given: read.append(path) or read_with_overrides(path, given)
    )
    path = tmp_path / "a.csv"
    write_noise(path)
    first = recall_records(path, NO_OVERRIDES)
    assert recall_records(path, NO_OVERRIDES) is first
    assert len(read) == 1
    write_noise(path, amplitude=2.0)
    assert recall_records(path, NO_OVERRIDES)[0].pga == pytest.approx(2.0 * first[0].pga, rel=1e-5)
    with pytest.raises(RecordError, match="unit"):
        recall_records(path, HeaderOverrides(unit="parsec"))
    path.unlink()
    with pytest.raises(RecordError, match="cannot be read"):
        recall_records(path, NO_OVERRIDES)


def test_kept_spectra_are_those_of_the_record_asked_for() -> None:
    wave = np.sin(np.linspace(0.0, 60.0, 2000))
    one, double = make_record("a", wave, 0.01), make_record("a", 2.0 * wave, 0.01)
    periods = np.array([0.0, 0.3, 1.0])
    first = response_spectrum(one, periods)
    assert response_spectrum(double, periods) == pytest.approx(2.0 * first)
    assert response_spectrum(make_record("a", wave, 0.02), periods) != pytest.approx(first)
    assert response_spectrum(one, periods, damping=0.02) != pytest.approx(first)
    first[:] = 0.0
    assert response_spectrum(one, periods)[2] > 0.0
