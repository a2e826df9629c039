"""What contradicts itself in a record file is refused or doubted. Real files are in tests/validation/record_files."""

import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.constants import g

from assess.messages.message import note
from records.errors import RecordError
from records.formats.header import check_duration, check_integral, check_peak, check_time_of_peak, filter_warning
from records.formats.samples import check_layout
from records.plausibility import record_warning, warnings_among
from records.reading import read_records
from records.record import Earthquake, Record, StationSite, make_record
from tests.support import record_files
from tests.support.files import write_file
from tests.support.record_files import PEER_TITLE, columns

PATH = Path("a.rec")
RANDOM = np.random.default_rng(3)
NOISE = RANDOM.normal(size=400)
COUNTS = np.round(NOISE * 1000).astype(int) + 4321


def at2(folder: Path, *, name: str = "a.AT2", line: str | None = None, component: str = "21") -> Path:
    title = PEER_TITLE.removesuffix("21") + component
    return write_file(folder / name, record_files.at2(0.1 * NOISE, title=title, line=line))


@pytest.mark.parametrize(
    ("name", "direction", "component", "level"),
    [
        ("A.NS1", "1", "NS1", True),
        ("A.EW1", "2", "EW1", True),
        ("A.UD1", "3", "UD1", False),
        ("A.NS2", "4", "NS2", True),
        ("A.EW2", "5", "EW2", True),
        ("A.UD2", "6", "UD2", False),
        ("A.UD", "U-D", "U-D", False),
        ("renamed.txt", "3", "UD1", False),
    ],
)
def test_directions_of_nied_are_three_in_the_borehole_and_three_above_it(
    tmp_path: Path, name: str, direction: str, component: str, level: bool
) -> None:
    """NIED: "1:NS 2:EW 3:UD" of the borehole, 4 to 6 at the surface (kyoshin.bosai.go.jp, KiK-net ASCII format)."""
    (record,) = read_records(write_file(tmp_path / name, record_files.knet(COUNTS, {"Dir.": direction})))
    assert (record.component, record.azimuth is not None) == (component, level)
    assert record.site.place == ("borehole" if component.endswith("1") else "")


@pytest.mark.parametrize(
    ("name", "direction", "words"),
    [
        ("A.EW1", "3", 'Dir. = "3" is UD1, the file is named as EW1'),
        ("A.UD1", "1", 'Dir. = "1" is NS1, the file is named as UD1'),
        ("A.NS2", "1", 'Dir. = "1" is NS1, the file is named as NS2'),
        ("A.UD", "N-S", 'Dir. = "N-S" is N-S, the file is named as U-D'),
        ("a.txt", "7", 'Dir. = "7"; it must be N-S, E-W, U-D or 1 to 6'),
    ],
)
def test_a_direction_that_the_files_name_contradicts_is_refused(
    tmp_path: Path, name: str, direction: str, words: str
) -> None:
    path = write_file(tmp_path / name, record_files.knet(COUNTS, {"Dir.": direction}))
    with pytest.raises(RecordError, match=re.escape(words)):
        read_records(path)


@pytest.mark.parametrize("form", ["15.7E", "10.5f"])
@pytest.mark.parametrize("lost", range(1, 9))
def test_every_line_that_lost_bytes_is_refused_or_doubted(form: str, lost: int) -> None:
    lines = columns(NOISE, 5, form).splitlines()
    assert check_layout(lines, first=1, path=PATH) is None
    for at in range(len(lines[10]) - lost + 1):
        damaged = lines[10][:at] + lines[10][at + lost :]
        try:
            doubt = check_layout([*lines[:10], damaged, *lines[11:]], first=1, path=PATH)
        except RecordError as error:
            assert "line 11:" in str(error)  # noqa: PT017
            continue
        assert "line 11 " in str(doubt)


def test_a_number_that_lost_characters_is_named_with_its_line(tmp_path: Path) -> None:
    path = at2(tmp_path)
    lines = path.read_text().split("\n")
    field = lines[17].split()[2]
    lines[17] = lines[17].replace(field, field[:-4], 1)
    path.write_text("\n".join(lines))
    with pytest.raises(RecordError, match=rf'line 18: "{re.escape(field[:-4])}.* get the file again'):
        read_records(path)


def test_columns_that_are_shifted_are_doubted(tmp_path: Path) -> None:
    path = at2(tmp_path)
    lines = path.read_text().split("\n")
    lines[17] = lines[17][1:]
    path.write_text("\n".join(lines))
    assert "the columns of line 18 are not those of the others" in record_warning(read_records(path)[0])


@pytest.mark.parametrize(
    "lines",
    [
        [f"{value:g}" for value in NOISE],  # shortest form, every number its own decimals
        [f"{a:.3f}, {b:g}" for a, b in NOISE.reshape(-1, 2)],
        [f"{value:.6f}" for value in NOISE],  # aligned on the left
        ["0.0", "0.0", "1"],
    ],
)
def test_numbers_that_no_one_format_printed_are_not_doubted(lines: list[str]) -> None:
    assert check_layout(lines, first=1, path=PATH) is None


def test_peaks_are_refused_beyond_two_percent_and_doubted_beyond_their_rounding() -> None:
    samples = np.array([0.0, -100.0, 50.0])
    assert check_peak(100.04, samples, unit="gal", digits=0.001, path=PATH) is None
    assert "stated peak is 101, but its largest sample is 100" in str(
        check_peak(101.0, samples, unit="gal", digits=0.001, path=PATH)
    )
    with pytest.raises(RecordError, match="states a peak of 103 gal, the samples have 100"):
        check_peak(103.0, samples, unit="gal", digits=0.001, path=PATH)


@pytest.mark.parametrize("factor", [0.1, 0.5, 2.0, 10.0])
def test_a_step_that_the_duration_the_peaks_time_or_the_velocities_contradict_is_refused(factor: float) -> None:
    dt = 0.01
    velocity = np.concatenate(([0.0], np.cumsum(0.5 * dt * (NOISE[1:] + NOISE[:-1]))))
    when = dt * float(np.argmax(np.abs(NOISE)))
    check_duration("DURATION", 4.0, size=400, dt=dt, slack=0.006, path=PATH)
    check_duration("DURATION", 3.99, size=400, dt=dt, slack=0.006, path=PATH)
    check_time_of_peak(when, NOISE, dt, slack=0.006, path=PATH)
    assert check_integral(velocity, NOISE, dt, path=PATH, name="N") is None
    with pytest.raises(RecordError, match="DURATION is 4 s; the step or the duration is damaged"):
        check_duration("DURATION", 4.0, size=400, dt=factor * dt, slack=0.006, path=PATH)
    with pytest.raises(RecordError, match="has the peak at"):
        check_time_of_peak(when, NOISE, factor * dt, slack=0.006, path=PATH)
    with pytest.raises(RecordError, match=r"by the velocities below the accelerations the step is 0\.01 s"):
        check_integral(velocity, NOISE, factor * dt, path=PATH, name="N")


def test_a_sample_that_the_velocities_do_not_hold_is_doubted() -> None:
    velocity = np.concatenate(([0.0], np.cumsum(0.005 * (NOISE[1:] + NOISE[:-1]))))
    spoilt = NOISE.copy()
    spoilt[200] += 0.8 * np.abs(NOISE).max()
    assert "velocities of N are not the integral" in str(check_integral(velocity, spoilt, 0.01, path=PATH, name="N"))


def band(low: float, high: float, dt: float, size: int = 4000) -> np.ndarray:
    """Noise with nothing outside a band [Hz]."""
    f = np.fft.rfftfreq(size, dt)
    inside = (f > low) & (f < high)
    noise = np.fft.irfft(np.where(inside, np.fft.rfft(RANDOM.normal(size=size)), 0.0), size)
    return np.asarray(noise * np.sin(np.linspace(0.0, np.pi, size)) ** 2)  # it grows from rest and ends at rest


def test_a_filter_that_ends_where_the_motion_does_not_doubts_the_step() -> None:
    motion = band(0.2, 25.0, 0.01)
    assert filter_warning(motion, 0.01, low=0.2, high=25.0) is None
    assert filter_warning(motion, 0.01, low=None, high=None) is None
    assert "holds 5 Hz at most" in str(filter_warning(motion, 0.1, low=0.2, high=25.0))
    assert "ends at 25 Hz, but its motion does not" in str(filter_warning(motion, 0.001, low=0.2, high=25.0))
    assert "begins at 0.2 Hz" in str(filter_warning(motion, 0.02, low=0.2, high=None))


def recorded(motion: np.ndarray, dt: float, form: str = "PEER AT2") -> Record:
    history = (note("read-from", format=form, unit="g"),)
    return make_record("a", motion / np.abs(motion).max(), dt, processing_history=history)


def test_a_motion_slower_or_faster_than_earthquakes_doubts_the_step() -> None:
    motion = band(0.2, 15.0, 0.01)
    assert record_warning(recorded(motion, 0.01)) == ""
    assert record_warning(recorded(motion, 0.02)) == ""  # cannot be told from the motion
    assert "slower than earthquakes; check the step" in record_warning(recorded(motion, 0.1))
    assert "faster than earthquakes; check the step" in record_warning(recorded(motion, 0.001))
    assert record_warning(recorded(motion, 0.01, "ITACA cor.acc")) == ""
    assert "faster than earthquakes" in record_warning(
        recorded(motion, 0.0005, "MiniSEED")
    )  # which no network resamples
    assert "finer than instruments" in record_warning(recorded(motion, 0.0005, "ITACA cor.acc"))
    assert record_warning(recorded(motion, 0.1, "CSV")) == ""  # which prints a time with every sample


@pytest.mark.parametrize(("dt", "doubted"), [(0.01, False), (0.001, True), (0.1, True)])
def test_a_peak_before_or_long_after_waves_can_come_doubts_the_step(dt: float, doubted: bool) -> None:
    motion = band(0.2, 15.0, 0.01)
    motion[3900] = 3.0 * np.abs(motion).max()
    quake = Earthquake("2017-07-20T22:31:09Z", depth=19e3)
    record = replace(recorded(motion, dt), earthquake=quake, start="2017-07-20T22:30:59Z", distance=150e3)
    assert ("waves" in record_warning(record) or "origin" in record_warning(record)) == doubted


def test_components_of_one_recording_with_two_steps_are_doubted(tmp_path: Path) -> None:
    one = read_records(at2(tmp_path, name="H1.AT2"))[0]
    two = read_records(at2(tmp_path, name="H2.AT2", component="111"))[0]
    assert list(warnings_among([one, two])) == []
    other = read_records(at2(tmp_path, name="H2.AT2", component="111", line="NPTS= 400, DT= .02 SEC"))[0]
    (told,) = warnings_among([one, other])
    assert "its step is 0.01 s, that of H2, of the same station and earthquake, 0.02 s" in told.text


def test_velocities_of_the_same_name_with_another_step_refuse_the_accelerations(tmp_path: Path) -> None:
    path = at2(tmp_path)
    beside = write_file(tmp_path / "a.VT2", record_files.at2("", line="NPTS= 400, DT= .01 SEC"))
    assert read_records(path)[0].dt == 0.01
    write_file(beside, record_files.at2("", line="NPTS= 400, DT= .005 SEC"))
    with pytest.raises(RecordError, match=r"line 4: DT is 0.01, that of a.VT2 0.005"):
        read_records(path)


def test_a_name_of_peer_with_another_direction_is_doubted(tmp_path: Path) -> None:
    same = read_records(at2(tmp_path, name="RSN1_QUAKE_ABC021.AT2"))[0]
    other = read_records(at2(tmp_path, name="RSN1_QUAKE_ABC111.AT2"))[0]
    assert same.warnings == ()
    (told,) = other.warnings
    assert told.text == "its component is 21, but its file's name is 111; one of them may be damaged"
    assert read_records(at2(tmp_path, name="kobe111.AT2"))[0].warnings == ()  # a user's name


@pytest.mark.parametrize(
    ("words", "damaged"),
    [
        ("the longitude of the epicentre is 639.2°", {"earthquake": Earthquake(longitude=639.2)}),
        ("the latitude of the epicentre is -91°", {"earthquake": Earthquake(latitude=-91.0)}),
        ("the magnitude is 72 in its header", {"earthquake": Earthquake(magnitude=72.0)}),
        ("the depth of the earthquake is 3000000 m", {"earthquake": Earthquake(depth=3e6)}),
        ("the longitude of the station is -1e\\+300°", {"site": StationSite(longitude=-1e300)}),
        ("vs30 is 0.3 m/s in its header, which cannot be", {"site": StationSite(vs30=0.3)}),
        ("the distance is -3000 m", {"distance": -3000.0}),
        ("", {"earthquake": Earthquake(latitude=-90.0, longitude=181.0, magnitude=-1.0, depth=-300.0)}),
    ],
)
def test_places_and_sizes_that_cannot_be_are_doubted(words: str, damaged: dict[str, Any]) -> None:
    found = record_warning(make_record("a", 0.1 * NOISE, 0.01, **damaged))
    assert re.search(words, found) if words else not found


def test_numbers_that_no_format_printed_are_read_whatever_the_last_is(tmp_path: Path) -> None:
    """As Python writes them, the last with fewer places; and a first zero without decimals."""
    values = [0.0, *np.round(np.sin(0.1 * np.arange(400.0)), 4).tolist(), 0.0512, 0.05]
    (tmp_path / "python.txt").write_text("".join(f"{value!r}\n" for value in values))
    (tmp_path / "zero.txt").write_text("0\n" + "".join(f"{value:.6f}\n" for value in values[1:]))
    for name in ("python.txt", "zero.txt"):
        (found,) = read_records(tmp_path / name, unit="g", step=0.01)
        np.testing.assert_allclose(found.acceleration / g, values, rtol=0.0, atol=1e-12)
    (tmp_path / "last.txt").write_text("".join(f"{value:.6f}\n" for value in values[1:]) + "0\n")
    with pytest.raises(RecordError, match='"0" is not printed like the others'):
        read_records(tmp_path / "last.txt", unit="g", step=0.01)
