"""Texts of made-up record files, a function for each format: how they are laid out; what they state is given.

Lines, integers and reals of a header are given by their number, from 1, as the descriptions of the formats count them.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

Lines = Mapping[int, str]
PEER_TITLE = "Somewhere, 7/21/1952, Some School, 21"


def columns(values: np.ndarray, per_line: int, form: str) -> str:
    """Return numbers in lines of fixed columns."""
    fields = [format(value, form) for value in values]
    return "".join("".join(fields[i : i + per_line]) + "\n" for i in range(0, len(fields), per_line))


def keyed(header: Mapping[str, str], form: str) -> str:
    """Return the lines of a header, each a key and its value as `form` sets them."""
    return "".join(form.format(key, value) + "\n" for key, value in header.items())


def head(count: int, lines: Lines, *, fill: str = "text") -> str:
    """Return so many lines of text, of which some are given."""
    return "".join(lines.get(number, fill) + "\n" for number in range(1, count + 1))


def header_numbers(count: int, stated: Mapping[int, float], *, unknown: float) -> np.ndarray:
    """Return so many numbers, of which some are stated; whole ones where `unknown` is one."""
    return np.array([stated.get(number, unknown) for number in range(1, count + 1)], dtype=type(unknown))


def knet(counts: np.ndarray, header: Mapping[str, str]) -> str:
    """Return a file of K-NET or KiK-net of counts of 0.001 gal at 100 Hz, with `header` in place of its lines."""
    whole = {
        "Origin Time": "2018/01/24 19:51:00",
        "Lat.": "41.0",
        "Long.": "142.5",
        "Depth. (km)": "30",
        "Mag.": "6.2",
        "Station Code": "XYZ001",
        "Station Lat.": "41.4",
        "Station Long.": "141.4",
        "Station Height(m)": "30",
        "Record Time": "2018/01/24 19:51:37",
        "Sampling Freq(Hz)": "100Hz",
        "Duration Time(s)": f"{counts.size / 100:g}",
        "Dir.": "E-W",
        "Scale Factor": "2000(gal)/2000000",
        "Max. Acc. (gal)": f"{np.abs(counts - counts.mean()).max() * 0.001:.3f}",
        "Last Correction": "2018/01/24 19:51:37",
        "Memo.": "",
        **header,
    }
    return keyed(whole, "{:18}{}") + columns(counts, 8, "9d")


def itaca(values: np.ndarray, header: Mapping[str, str]) -> str:
    """Return a file of ITACA of m/s2."""
    whole = {**header, "Number of Data": f"{values.size}", "PGA (m/s/s)": f"{np.abs(values).max():.7E}"}
    return keyed(whole, "{:30}: {}") + "Accelaration time series in m/s/s\n" + columns(values, 5, "14.7E")


def afad(values: np.ndarray, header: Mapping[str, str]) -> str:
    """Return a file of AFAD of gal at 100 Hz; values by sample and component [n, 3]."""
    peaks = "(N-S) {:.6f} (E-W) {:.6f} (U-D) {:.6f}".format(*np.abs(values).max(axis=0))
    last = {"NUMBER OF DATA": f"{len(values)}", "SAMPLING INTERVAL (sec)": "0.01", "RAW PGA VALUES (gal)": peaks}
    return (
        "STRONG GROUND MOTION RECORDS OF TURKIYE\n"
        + keyed({**header, **last}, "{:24}: {}")
        + "       N-S          E-W          U-D\n"
        + columns(values.ravel(), 3, "13.6f")
    )


def cosmos(values: np.ndarray, text: Lines, *, azimuth: int, reals: Mapping[int, float]) -> str:
    """Return a file of COSMOS of cm/s2 at 100 Hz: 13 lines of text, 100 integers, 100 reals."""
    first = "Corrected acceleration    (Format v01.20 with 13 text lines)"
    return (
        head(13, {1: first, **text})
        + " 100 Integer-header values follow on  10 lines, Format= (10I8)\n"
        + columns(header_numbers(100, {54: azimuth}, unknown=-999), 10, "8d")
        + " 100 Real-header values follow on  17 lines, Format= (6F13.6)\n"
        + columns(header_numbers(100, reals, unknown=-999.0), 6, "13.6f")
        + '   1 Comment line(s) follow, each starting with a "|":\n| made up\n'
        + f"   {values.size} acceleration pts, approx {values.size / 100:4.0f} secs, "
        + "units=cm/sec2(04),Format=(8F10.5)\n"
        + columns(values, 8, "10.5f")
        + "End-of-data for Chan  1 acceleration\n"
    )


def csmip_2(text: Lines, *motions: np.ndarray, number: int, step: float) -> str:
    """Return a channel of volume 2 of CSMIP, of accelerations [cm/s2] and what follows of velocities and so on."""
    kinds = (("ACCEL", "CM/SEC/SEC"), ("VELOC", "CM/SEC"), ("DISPL", "CM"))
    blocks = [
        f"{motion.size} POINTS OF {kind} DATA EQUALLY SPACED AT  {f'{step:.3f}'[1:]} SEC.  (UNITS: {unit})\n"
        + columns(motion, 8, "10.3f")
        for motion, (kind, unit) in zip(motions, kinds, strict=False)
    ]
    return head(25, text) + "".join(blocks) + f"/&  ----------  END OF DATA FOR CHANNEL  {number}  ----------\n"


def v2a(text: Lines, *motions: np.ndarray) -> str:
    """Return a component of GeoNet's V2A: 16 lines of text, 100 numbers, then each motion [mm/s2, mm/s, mm]."""
    return head(16, text) + "".join(
        [columns(np.zeros(100), 10, "8.1f"), *(columns(motion, 10, "8.3f") for motion in motions)]
    )


def smc(values: np.ndarray, text: Lines, *, integers: Mapping[int, float], reals: Mapping[int, float]) -> str:
    """Return a file of SMC of cm/s2: 11 lines of text, 48 integers, 50 reals, as many comments as integer 16 says."""
    return (
        head(11, {1: "2 CORRECTED ACCELEROGRAM", **text}, fill="*")
        + columns(header_numbers(48, {**integers, 17: values.size}, unknown=-32768), 8, "10d")
        + columns(header_numbers(50, reals, unknown=1.7e38), 5, "15.7E")
        + "|made up\n" * int(integers[16])
        + columns(values, 8, "10.3E").replace("E+0", "E+").replace("E-0", "E-")
    )


def at2(
    values: np.ndarray | str,
    *,
    title: str = PEER_TITLE,
    units: str = "ACCELERATION TIME SERIES IN UNITS OF G",
    line: str | None = None,
) -> str:
    """Return a file of PEER of g, or of another quantity in its `units`; a text stands for the lines of its samples.

    Parameters
    ----------
    line : the fourth; that of values at 100 Hz if none is given
    """
    data = values if isinstance(values, str) else columns(values, 5, "15.7E")
    fourth = f"NPTS= {len(values)}, DT= .01 SEC" if line is None else line
    return f"PEER NGA STRONG MOTION DATABASE RECORD\n{title}\n{units}\n{fourth}\n{data}"
