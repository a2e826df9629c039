"""The multi-period spectrum of ASCE 7-22, from the reply of the web service of the USGS saved as a file.

The form of the reply is that of its documentation (earthquake.usgs.gov/ws/designmaps/asce7-22.html) and of an example
that the USGS published with its source; §21.4 is as the documentation of a public package (newmark, on CRAN) has it.
The standard itself was not read: there is no spectrum beyond the reply's last period, and none from typed values.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from assess.messages.message import warning
from spectra.arrays import FloatArray, is_number
from spectra.damping import asce7_b_factor
from spectra.errors import SpectrumError
from spectra.gravity import g
from spectra.spectrum import Spectrum, in_g
from spectra.table import table_spectrum

CODE, DOCUMENT = "asce7-22", "ASCE7-22"
CURVES: Mapping[str, str] = {"design": "multiPeriodDesignSpectrum", "mce": "multiPeriodMCErSpectrum"}
KEYS: Mapping[str, tuple[str, str]] = {"design": ("sds", "sd1"), "mce": ("sms", "sm1")}
STIFF = ("A", "B", "BC", "C")  # site classes with V_s30 above 442 m/s
SHARE = 0.9  # of the largest ordinate, §21.4
SHORT, STIFF_RANGE, SOFT_RANGE = (0.2, 5.0), (1.0, 2.0), (1.0, 5.0)  # s
LIKE = 0.03  # the reply has two or three figures
LARGEST_FILE = 5_000_000  # bytes
DAMPING_RULE = (
    "ASCE 7-22 Table 18.7-1, taken as that of 7-16: ordinates from the largest on divided by B, zero-period ordinate "
    "kept; not checked against the printed standard"
)


def multi_period_spectrum(file: Path, *, hazard: str = "design") -> Spectrum:
    """Return the spectrum of a reply, linear between its periods, with S_DS, S_D1 and S_X1 derived from it.

    The PGA is its ordinate at T = 0; PGA_M of the reply is among the parameters, for print alone.

    Parameters
    ----------
    file : the reply, JSON
    hazard : "design", or "mce", the risk-targeted maximum

    Raises
    ------
    SpectrumError : names the file, and what is no such reply

    Source: ASCE 7-22 §11.4.5.1 and §21.4.
    """
    data, site_class = _reply(file)
    period, ordinate = _curve(data, CURVES[hazard], file)
    try:
        found = table_spectrum(period, ordinate * g, reduction=lambda damping: 1.0 / asce7_b_factor(damping))
    except SpectrumError as error:
        raise SpectrumError(f"{file}: {CURVES[hazard]}: {error}") from None
    if period[0] > 0.0 or period[-1] < SOFT_RANGE[1]:
        raise SpectrumError(
            f"{file}: {CURVES[hazard]} has periods from {period[0]:g} to {period[-1]:g} s, not 0 to 5 s"
        )
    short, second = site_ordinates(period, ordinate, site_class=site_class)
    names = ("s_ds", "s_d1") if hazard == "design" else ("s_ms", "s_m1")
    warnings = [
        warning("reply-differs", name=key, value=in_g(stated * g), derived=in_g(own * g))
        for key, own in zip(KEYS[hazard], (short, second), strict=True)
        if is_number(stated := data.get(key)) and abs(stated - own) > LIKE * own
    ]
    pga_m = data.get("pgam")
    return replace(
        found,
        code=CODE,
        parameters={
            "site_class": site_class,
            "hazard": hazard,
            "period_max": float(period[-1]),
            "pga": found.pga,
            **({"pga_m": float(pga_m) * g} if is_number(pga_m) else {}),
            **dict(zip(names, (short * g, second * g), strict=True)),
            "s_x1": second * g,
        },
        damping_rule=DAMPING_RULE,
        clause="ASCE 7-22 §11.4.5.1",
        warnings=(*found.warnings, *warnings),
    )


def site_ordinates(period: FloatArray, ordinate: FloatArray, *, site_class: str) -> tuple[float, float]:
    """Return the ordinates at short periods and at 1 s, in the unit of `ordinate`.

        S_S' = 0.9 max S_a, 0.2 to 5 s    S_1' = max(0.9 max T S_a, S_a(1 s)), 1 to 2 s (V_s30 > 442 m/s) or 1 to 5 s

    Parameters
    ----------
    period, ordinate : of the spectrum [n] [s]
    site_class : "A" to "E", or "Default", which takes the longer range

    Source: ASCE 7-22 §21.4.
    """

    def within(ends: tuple[float, float]) -> Any:
        return (period >= ends[0]) & (period <= ends[1])

    velocity = within(STIFF_RANGE if site_class in STIFF else SOFT_RANGE)
    at_1 = float(np.interp(1.0, period, ordinate))
    return (
        SHARE * float(np.max(ordinate[within(SHORT)])),
        max(SHARE * float(np.max((period * ordinate)[velocity])), at_1),
    )


def _reply(file: Path) -> tuple[Mapping[str, Any], str]:
    """Return the data of a reply, and the site class that it was asked for."""
    try:
        if file.stat().st_size > LARGEST_FILE:
            raise SpectrumError(f"{file}: larger than any reply of the service; give the JSON that it answers with")
        content = json.loads(file.read_bytes())
        request, data = content["request"], content["response"]["data"]
        document, status, site_class = (
            request["referenceDocument"],
            request["status"],
            request["parameters"]["siteClass"],
        )
    except OSError as error:
        raise SpectrumError(f"{file}: the file cannot be read: {error.strerror}") from None
    except (ValueError, RecursionError, LookupError, TypeError):
        raise SpectrumError(
            f"{file}: not a reply of the design-maps service of the USGS; save what "
            "earthquake.usgs.gov/ws/designmaps/asce7-22.json answers with"
        ) from None
    if document != DOCUMENT or status != "success" or not isinstance(data, Mapping) or not isinstance(site_class, str):
        raise SpectrumError(
            f"{file}: a reply for {str(document)[:30]} with status {str(status)[:30]}; give one for {DOCUMENT} with "
            "success"
        )
    return data, site_class


def _curve(data: Mapping[str, Any], name: str, file: Path) -> tuple[FloatArray, FloatArray]:
    """Return periods [n] [s] and ordinates [n] [g] of a curve of the reply."""
    curve = data.get(name)
    try:
        columns = [curve[column] for column in ("periods", "ordinates")]  # type: ignore[index]
        if (
            all(isinstance(c, list) and all(is_number(v) for v in c) for c in columns)
            and len({*map(len, columns)}) == 1
        ):
            return np.array(columns[0], dtype=np.float64), np.array(columns[1], dtype=np.float64)
    except (LookupError, TypeError):
        pass
    raise SpectrumError(f"{file}: {name}: no periods and as many ordinates, in numbers; is the reply whole?")
