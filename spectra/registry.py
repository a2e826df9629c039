"""Design spectra by the name of their code, with the parameters of the table [site.spectrum] of a project file."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from inspect import Parameter, signature
from pathlib import Path
from typing import Any

from spectra import asce7, ec8, ntc, nzs1170_5
from spectra.arrays import is_number
from spectra.asce7 import EDITIONS
from spectra.damping import check_damping
from spectra.errors import SpectrumError
from spectra.spectrum import Spectrum, check_positive, scale_to_pga
from spectra.table import read_table, table_spectrum

TEXTS = frozenset({"site_class", "ground_type", "subsoil", "soil", "topography", "use_class", "limit_state", "file"})
COMMON = ("damping", "pga")  # of every spectrum


@dataclass(frozen=True)
class SpectrumForm:
    """One way to give a code's spectrum: a function of keyword arguments, and parameters that tell it from others."""

    make: Callable[..., Spectrum]
    distinguishing: tuple[str, ...] = ()

    @property
    def parameters(self) -> tuple[str, ...]:
        """Names of its own parameters."""
        return tuple(name for name in signature(self.make).parameters if name not in ("code", *COMMON))

    @property
    def required(self) -> tuple[str, ...]:
        """Names of those without a default."""
        arguments = signature(self.make).parameters.values()
        return tuple(each.name for each in arguments if each.default is Parameter.empty and each.name not in COMMON)


def spectrum(code: str, *, damping: float = 0.05, pga: float | None = None, **parameters: Any) -> Spectrum:
    """Return the horizontal design spectrum of a code.

    Parameters
    ----------
    code : "asce7-05", "ibc2009", "asce7-10", "asce7-16", "ec8", "nzs1170.5", "ntc2008", "ntc2018" or "table"
    damping : damping ratio [-]
    pga : peak ground acceleration [m/s2] that the ordinates are scaled to, corner periods fixed; None leaves them
    parameters : in SI, named as in the table [site.spectrum] of a project file.
        asce7: s_ds, s_d1 [m/s2], t_l [s], or s_s, s_1 [m/s2], site_class, t_l; hazard ("design" or "mce").
        ec8: a_g [m/s2], ground_type, type (1 or 2), importance_factor.
        nzs1170.5: subsoil, z, r or return_period [years], near_fault_distance [m].
        ntc: a_g [m/s2], f_0, t_c_star [s], soil, topography, relief_position; in place of the first three `hazard`,
        rows with return_period [years], a_g, f_0, t_c_star, with nominal_life [years], use_class and limit_state.
        table: file (CSV of two columns with units), or period [n] [s] and acceleration [n] [m/s2].

    Returns
    -------
    Spectrum

    Raises
    ------
    SpectrumError : the code or a parameter is unknown (those known are listed), missing, or outside its clause
    """
    if code not in SPECTRA:
        raise SpectrumError(f'spectrum "{code}" is not known; choose one of {", ".join(SPECTRA)}')
    if is_number(damping) and damping >= 1.0:
        raise SpectrumError(f"{code} spectrum: damping = {damping}; it must be less than 1 (0.05 is 5 % of critical)")
    form = _form(SPECTRA[code], parameters)
    _check_names(code, form, parameters)
    if form.make in (_from_file, table_spectrum):
        spectrum = form.make(**parameters, damping=damping, pga=pga)
    else:
        spectrum = replace(form.make(**parameters), damping=check_damping(damping))
    if pga is None:
        return spectrum
    check_positive(code, pga=pga)
    return scale_to_pga(spectrum, pga)


def _form(forms: tuple[SpectrumForm, ...], parameters: Mapping[str, Any]) -> SpectrumForm:
    """Return the form whose distinguishing parameters are among the parameters; else the first."""
    return next((form for form in forms if any(name in parameters for name in form.distinguishing)), forms[0])


def _check_names(code: str, form: SpectrumForm, parameters: Mapping[str, Any]) -> None:
    """Refuse parameters that are unknown, missing, or text where a number in SI belongs."""
    known, needed = form.parameters, form.required
    unknown = [name for name in parameters if name not in known]
    if unknown:
        every = ", ".join((*known, *COMMON))
        raise SpectrumError(f"{code} spectrum: {unknown[0]} is not one of its parameters; known are {every}")
    missing = [name for name in needed if name not in parameters]
    if missing:
        raise SpectrumError(f"{code} spectrum: {missing[0]} is missing; needed are {', '.join(needed)}")
    for name, value in parameters.items():
        if name in TEXTS and not isinstance(value, Hashable):
            raise SpectrumError(f"{code} spectrum: {name} = {value}; give one text")
        if name == "file" and not isinstance(value, str | Path):
            raise SpectrumError(f"{code} spectrum: file = {value}; give the path of a CSV file")
        if isinstance(value, str) and name not in TEXTS and not (name == "hazard" and code in EDITIONS):
            raise SpectrumError(f'{code} spectrum: {name} = "{value}"; give a number in SI units')


def _ec8(*, a_g: float, ground_type: str, type: int = 1, importance_factor: float = 1.0) -> Spectrum:
    """Name the type of the spectrum as the project file does."""
    return ec8.elastic_spectrum(
        a_g=a_g, ground_type=ground_type, spectrum_type=type, importance_factor=importance_factor
    )


def _nzs1170_5(
    *,
    subsoil: str,
    z: float,
    r: float | None = None,
    return_period: float | None = None,
    near_fault_distance: float | None = None,
) -> Spectrum:
    """Take the return period factor, or the return period [years] that it follows from."""
    if (r is None) == (return_period is None):
        raise SpectrumError("nzs1170.5 spectrum: give either r, the return period factor, or return_period [years]")
    factor = r if return_period is None else nzs1170_5.return_period_factor(return_period)
    assert factor is not None  # one of the two is given
    return nzs1170_5.site_spectrum(subsoil=subsoil, z=z, r=factor, near_fault_distance=near_fault_distance)


def _ntc(
    *,
    code: str,
    a_g: float,
    f_0: float,
    t_c_star: float,
    soil: str,
    topography: str = "T1",
    relief_position: float = 1.0,
) -> Spectrum:
    """Take the hazard at one return period."""
    place = ntc.SoilAndTopography(soil, topography, relief_position)
    return ntc.elastic_spectrum(ntc.Hazard(a_g, f_0, t_c_star), place=place, code=code)


def _ntc_limit_state(
    *,
    code: str,
    hazard: Sequence[Mapping[str, float] | ntc.Hazard],
    nominal_life: float,
    use_class: str,
    soil: str,
    limit_state: str = "SLV",
    topography: str = "T1",
    relief_position: float = 1.0,
) -> Spectrum:
    """Take the hazard over return periods, and the limit state of the spectrum."""
    try:
        rows = [row if isinstance(row, ntc.Hazard) else ntc.Hazard(**row) for row in hazard]
    except TypeError:
        raise SpectrumError(
            f"{code} spectrum: hazard: give rows of return_period, a_g, f_0 and t_c_star, rising in return period"
        ) from None
    parameters: dict[str, float | str] = {
        "limit_state": limit_state,
        "nominal_life": nominal_life,
        "use_class": use_class,
    }
    hazard_on_rock = ntc.limit_state_hazard(
        rows, limit_state=limit_state, nominal_life=nominal_life, use_class=use_class
    )
    spectrum = ntc.elastic_spectrum(
        hazard_on_rock, place=ntc.SoilAndTopography(soil, topography, relief_position), code=code
    )
    return replace(spectrum, parameters={**parameters, **spectrum.parameters})


def _from_file(*, file: str | Path, damping: float, pga: float | None) -> Spectrum:
    """Read a table from a file."""
    return read_table(Path(file), damping=damping, pga=pga)


def _asce7_forms(code: str) -> tuple[SpectrumForm, ...]:
    design, mapped = asce7.design_spectrum, asce7.mapped_spectrum
    return (
        SpectrumForm(partial(design, code=code)),
        SpectrumForm(partial(mapped, code=code), ("s_s", "s_1", "site_class")),
    )


def _ntc_forms(code: str) -> tuple[SpectrumForm, ...]:
    return (SpectrumForm(partial(_ntc, code=code)), SpectrumForm(partial(_ntc_limit_state, code=code), ("hazard",)))


SPECTRA: Mapping[str, tuple[SpectrumForm, ...]] = {
    **{code: _asce7_forms(code) for code in EDITIONS},
    "ec8": (SpectrumForm(_ec8),),
    "nzs1170.5": (SpectrumForm(_nzs1170_5),),
    **{code: _ntc_forms(code) for code in ntc.CLAUSES},
    "table": (SpectrumForm(_from_file), SpectrumForm(table_spectrum, ("period", "acceleration"))),
}
"""The ways to give each code's spectrum, the usual one first."""
