"""MiniSEED and SAC, in files that obspy writes."""

from pathlib import Path

import numpy as np
import pytest

from records.errors import RecordError
from records.formats.by_obspy import looks_like_miniseed, looks_like_sac
from records.reading import read_records

obspy = pytest.importorskip("obspy", exc_type=ImportError)

N, RATE, SENSITIVITY = 4000, 100.0, 2.0e5  # samples, 1/s, counts per m/s2
TIME = np.arange(N) / RATE
MOTION = np.exp(-(((TIME - 20.0) / 4.0) ** 2)) * np.sin(2 * np.pi * 3.0 * TIME)  # m/s2
COUNTS = np.round(SENSITIVITY * MOTION).astype(np.int32)


def trace(**more: object) -> object:
    header = {"network": "XX", "station": "ABC", "location": "00", "channel": "HNE", "sampling_rate": RATE}
    return obspy.Trace(COUNTS.copy(), header={**header, "starttime": obspy.UTCDateTime(2020, 1, 1), **more})


def miniseed(folder: Path, *traces: object) -> Path:
    path = folder / "quake.mseed"
    obspy.Stream(list(traces)).write(str(path), format="MSEED")
    return path


def station_xml(folder: Path, *, channel: str = "HNE") -> Path:
    """A response that is flat in acceleration."""
    from obspy.core.inventory import Channel, Inventory, Network, Response, Station

    response = Response.from_paz(
        zeros=[], poles=[], stage_gain=SENSITIVITY, input_units="M/S**2", output_units="COUNTS"
    )
    made = Channel(channel, "00", 40.0, 20.0, 0.0, 0.0, sample_rate=RATE, response=response)
    station = Station("ABC", 40.0, 20.0, 0.0, channels=[made])
    path = folder / "station.xml"
    Inventory([Network("XX", stations=[station])], source="made up").write(str(path), format="STATIONXML")
    return path


def test_counts_by_their_unit(tmp_path: Path) -> None:
    (record,) = read_records(miniseed(tmp_path, trace()), unit="mm/s2")
    np.testing.assert_allclose(record.acceleration, COUNTS * 1e-3, rtol=1e-12)
    assert (record.npts, record.dt, record.station, record.component) == (N, 0.01, "XX.ABC", "HNE")


def test_a_flat_response_divides_by_the_sensitivity(tmp_path: Path) -> None:
    (record,) = read_records(miniseed(tmp_path, trace()), response=station_xml(tmp_path))
    np.testing.assert_allclose(record.acceleration, MOTION, rtol=0, atol=2e-5)  # half a count, and the mean
    assert [str(step) for step in record.processing_history] == [
        "read from MiniSEED, response of station.xml",
        "mean taken off",
    ]
    assert record.azimuth == pytest.approx(np.pi / 2)


def test_sac_says_more(tmp_path: Path) -> None:
    path = tmp_path / "quake.sac"
    floating = trace(sac={"stla": 41.5, "stlo": 20.5, "evla": 42.0, "evlo": 21.0, "mag": 6.1, "dist": 70.0,
                          "cmpaz": 45.0, "cmpinc": 90.0, "kevnm": "SOMEWHERE"})  # fmt: skip
    floating.data = MOTION.astype(np.float32)
    floating.write(str(path), format="SAC")
    (record,) = read_records(path, unit="m/s2")
    np.testing.assert_allclose(record.acceleration, MOTION, rtol=1e-6, atol=1e-7)
    assert (record.event, record.site.latitude, record.distance) == ("SOMEWHERE", 41.5, 70e3)
    assert record.earthquake.magnitude == pytest.approx(6.1, rel=1e-6)
    assert record.azimuth == pytest.approx(np.pi / 4)


def test_without_unit_or_response_it_is_refused(tmp_path: Path) -> None:
    with pytest.raises(
        RecordError, match=r"MiniSEED does not state the unit of its samples; give unit \(--unit g .*\), or response"
    ):
        read_records(miniseed(tmp_path, trace()))


def test_gaps_are_refused(tmp_path: Path) -> None:
    late = trace(starttime=obspy.UTCDateTime(2020, 1, 2))
    with pytest.raises(RecordError, match=r"channel XX.ABC.00.HNE has gaps"):
        read_records(miniseed(tmp_path, trace(), late), unit="mm/s2")


@pytest.mark.parametrize("form", ["MSEED", "SAC"])
def test_a_file_cut_short_is_refused(tmp_path: Path, form: str) -> None:
    path = tmp_path / "quake"
    trace().write(str(path), format=form)
    path.write_bytes(path.read_bytes()[:-100])
    with pytest.raises(RecordError, match=r"cut short|obspy cannot read it"):
        read_records(path, unit="mm/s2")


def test_velocity_in_sac_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "quake.sac"
    trace(sac={"idep": 7}).write(str(path), format="SAC")
    with pytest.raises(RecordError, match="holds velocity; give the file of the acceleration"):
        read_records(path, unit="m/s2")


def test_a_response_of_another_channel_or_none_is_one_line(tmp_path: Path) -> None:
    path = miniseed(tmp_path, trace())
    other, junk = station_xml(tmp_path, channel="HNN"), tmp_path / "junk.xml"
    junk.write_text("<no response>")
    for response, words in ((other, "no response fits"), (junk, "response"), (tmp_path / "absent.xml", "response")):
        with pytest.raises(RecordError, match=words) as caught:
            read_records(path, response=response)
        assert "\n" not in str(caught.value)


def test_spoilt_files_are_records_of_as_many_samples_or_record_errors(tmp_path: Path) -> None:
    chance = np.random.default_rng(3)
    path = miniseed(tmp_path, trace())
    data = path.read_bytes()
    for _ in range(60):
        spoilt = bytearray(data[: chance.integers(1, len(data))] if chance.random() < 0.3 else data)
        for at in chance.integers(0, len(spoilt), size=4):
            spoilt[at] = chance.integers(0, 256)
        path.write_bytes(bytes(spoilt))
        try:
            found = read_records(path, unit="mm/s2")
        except RecordError as error:
            assert "\n" not in str(error)  # noqa: PT017
            continue
        assert all(record.npts <= 10 * N for record in found)


def test_other_files_do_not_look_like_them() -> None:
    for head in (b"", b"000001 text", b"\0" * 700, b"MS", b"PEER NGA STRONG MOTION\n" * 40):
        assert not looks_like_miniseed(head)
        assert not looks_like_sac(head)


def flipped(path: Path, at: int, bit: int = 0) -> Path:
    data = bytearray(path.read_bytes())
    data[at] ^= 1 << bit
    path.write_bytes(data)
    return path


@pytest.mark.parametrize("at", [100, 200, 1001, 3000, 4300, 5000])
def test_miniseed_whose_samples_do_not_end_as_its_blocks_say_is_refused(tmp_path: Path, at: int) -> None:
    with pytest.raises(RecordError, match=r"quake\.mseed: (damaged: .*(integrity|skip).*; get the file again|obspy)"):
        read_records(flipped(miniseed(tmp_path, trace()), at), unit="mm/s2")


@pytest.mark.parametrize(
    ("at", "bit", "said"), [(1, 7, "E"), (6, 6, "DEPMIN"), (10, 6, "DEPMAX"), (226, 6, "DEPMEN"), (26, 6, "E")]
)
def test_sac_whose_header_contradicts_its_samples_is_refused(tmp_path: Path, at: int, bit: int, said: str) -> None:
    path = tmp_path / "quake.sac"
    made = trace()
    made.data = np.append(MOTION, 2.0 * MOTION.min()).astype(np.float32)
    made.write(str(path), format="SAC")
    assert len(read_records(path, unit="m/s2")) == 1
    with pytest.raises(RecordError, match=rf"quake\.sac: {said} of the header is .*, its samples give"):
        read_records(flipped(path, at, bit), unit="m/s2")
