"""Design spectra by the name of their code, with the keys of the table [site.spectrum] of a project file."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import MISSING, asdict, fields, replace
from typing import Any

import numpy as np

from assess.declaration import PositiveAcceleration, annotations_of, meanings_of, unknown_key
from assess.faults import declared_problems, text_of_value, value_fault
from spectra import ntc
from spectra.design_spectra import SPECTRA, DesignSpectrum, HazardRow, PointsSpectrum, spectrum_class
from spectra.errors import SpectrumError
from spectra.spectrum import Spectrum, plausibility_warnings, scale_to_pga


def spectrum(code: str, *, damping: float = 0.05, pga: float | None = None, **parameters: Any) -> Spectrum:
    """Return the horizontal design spectrum of a code.

    Parameters
    ----------
    code : a key of `SPECTRA`: "asce7-05", "ibc2009", "asce7-10", "asce7-16", "asce7-22", "ec8", "nzs1170.5",
        "ts1170.5", "ntc2008", "ntc2018" or "table"
    damping : damping ratio [-]
    pga : peak ground acceleration [m/s2] that the ordinates are scaled to, corner periods fixed; None leaves them
    parameters : in SI, named as in the table [site.spectrum] of a project file.
        asce7: s_ds, s_d1 [m/s2], t_l [s], or s_s, s_1 [m/s2], site_class, t_l; hazard ("design" or "mce").
        asce7-22: file, a reply of the USGS; hazard.
        ec8: a_g [m/s2], ground_type, type (1 or 2), importance_factor; s, t_b, t_c, t_d [s] of a national annex.
        ts1170.5: pga_site, s_as [m/s2], t_c, t_d [s], or file, location, site_class, return_period [years].
        nzs1170.5: subsoil, z, r or return_period [years], near_fault_distance [m].
        ntc: a_g [m/s2], f_0, t_c_star [s], soil, topography, relief_position; in place of the first three `hazard`,
        rows with return_period [years], a_g, f_0, t_c_star, or grid, latitude, longitude; with nominal_life [years],
        use_class and limit_state.
        table: file (CSV of two columns with units), or period [n] [s] and acceleration [n] [m/s2].

    Returns
    -------
    Spectrum

    Raises
    ------
    SpectrumError : the code or a parameter is unknown (those known are listed), missing, or outside its clause
    """
    if not isinstance(code, str) or code not in SPECTRA:
        raise SpectrumError(f'spectrum "{code}" is not known; choose one of {", ".join(SPECTRA)}')
    where = f"{code} spectrum: "
    given = {"damping": damping, "code": code, **parameters}
    if isinstance(rows := given.get("hazard"), list | tuple):
        given["hazard"] = tuple(_row(row, f"{where}hazard[{number}].") for number, row in enumerate(rows, start=1))
    way = _make(_class_from_python(code, parameters), given, where)
    if reason := value_fault(pga, PositiveAcceleration | None):
        raise SpectrumError(f"{where}pga = {text_of_value(pga)}: {reason}")
    if problem := next(declared_problems(way, where), ""):
        raise SpectrumError(problem)
    return horizontal_spectrum(way, pga=pga)


def horizontal_spectrum(way: DesignSpectrum, *, pga: float | None = None) -> Spectrum:
    """Return the horizontal spectrum at its damping.

    Parameters
    ----------
    way : to give it
    pga : peak ground acceleration that the ordinates are scaled to [m/s2]; None leaves them
    """
    found = replace(way.horizontal(pga=pga), damping=way.damping)
    if pga is None:
        return found
    return scale_to_pga(replace(found, warnings=(*found.warnings, *plausibility_warnings(pga=pga))), pga)


def vertical_spectrum(way: DesignSpectrum, *, pga: float | None = None) -> Spectrum:
    """Return the vertical spectrum at its damping, with the factor by which `pga` scales the horizontal one.

    Parameters
    ----------
    way : to give both
    pga : peak ground acceleration of the horizontal spectrum [m/s2]; None leaves both

    Raises SpectrumError for codes without one here.
    """
    found = replace(way.vertical(), damping=way.damping)
    return replace(found, factor=horizontal_spectrum(way, pga=pga).factor)


def _class_from_python(code: str, keys: Collection[str]) -> type[DesignSpectrum]:
    points = code == "table" and any(key in keys for key in PointsSpectrum.own_keys)
    return PointsSpectrum if points else spectrum_class(code, keys)


def _make(kind: type, given: Mapping[str, Any], where: str) -> Any:
    """Return data of a kind, made of what is given by its keys; where: what stands before them in an error."""
    known = annotations_of(kind)
    for key, value in given.items():
        if key not in known:
            reason = getattr(kind, "other_keys", {}).get(key) or unknown_key(key, known)
            raise SpectrumError(f"{where}{key} = {text_of_value(value)}: {reason}")
    for field in fields(kind):
        if field.default is MISSING and field.name not in given:
            raise SpectrumError(f"{where}{field.name}: missing; {meanings_of(kind)[field.name]}")
    return kind(**{key: value.item() if isinstance(value, np.generic) else value for key, value in given.items()})


def _row(row: Any, where: str) -> Any:
    """Return a row of a hazard over return periods; what is none is left as it is."""
    given = asdict(row) if isinstance(row, ntc.Hazard) else row
    return _make(HazardRow, given, where) if isinstance(given, Mapping) else row
