"""Design spectra of the codes."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any


def solve_spectra(folder: Path, given: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return parameters and ordinates of spectra.

    Parameters
    ----------
    folder : of the case
    given : `spectra`, by name the keys of a table [site.spectrum]; `periods` [s] of the ordinates; `vertical`, whether
        of the vertical spectra

    Returns
    -------
    Mapping
        `parameters`, by name, as in results.json; `acceleration_g` [g] and `displacement_m` [m], by name and period,
        such as "B, 0.5 s".
    """
    from scipy.constants import g

    from assess.project.sections import Site
    from assess.project.site_spectrum import spectrum_of, vertical_of

    make = vertical_of if given.get("vertical", False) else spectrum_of
    tree: dict[str, dict[str, Any]] = {"parameters": {}, "acceleration_g": {}, "displacement_m": {}}
    for name, table in given["spectra"].items():
        spectrum = make(Site.model_validate({"spectrum": table}, context={"folder": folder}))
        tree["parameters"][name] = dict(spectrum.parameters)
        for T in given["periods"]:
            row = f"{name}, {T:g} s"
            tree["acceleration_g"][row] = float(spectrum.acceleration(T)) / g
            tree["displacement_m"][row] = float(spectrum.displacement(T))
    return tree
