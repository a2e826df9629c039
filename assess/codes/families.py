"""What each procedure compares, the code it belongs to, and the site spectra it is written for."""

from __future__ import annotations

from collections.abc import Mapping

from assess.codes.check import Family
from assess.messages.message import Message, message

AMERICAN = ("asce7-05", "ibc2009", "asce7-10", "asce7-16")
EUROPEAN = ("ec8", "ntc2008", "ntc2018")
NEW_ZEALAND = ("nzs1170.5",)
TABLE_SPECTRUM = "table"  # the engineer's own spectrum, for any code

FAMILIES: Mapping[str, Family] = {
    "asce43-05-spectrum": Family.ENERGY,
    "asce43-05-spectrum-thesis": Family.ENERGY,
    "asce43-05-history": Family.HISTORY,
    "dmi2008-linear": Family.LINEAR,
    "dmi2008-nonlinear": Family.DISPLACEMENT,
    "dmi2008-nonlinear-thesis": Family.DISPLACEMENT,
    "dmi2008-history": Family.HISTORY,
    "ntc2018-linear": Family.LINEAR,
    "ntc2018-nonlinear": Family.DISPLACEMENT,
    "ntc2018-history": Family.HISTORY,
    "nzsee2017-face-loaded": Family.PART,
    "asce41-13-ht": Family.TABLE,
    "ec8-element": Family.ELEMENT,
    "asce43-05-sliding": Family.SLIDING,
    "sliding": Family.FRICTION,
}
SUITE_CODES: Mapping[str, str] = {  # whose rules for suites a procedure by histories goes by
    "asce43-05-history": "asce43-05",
    "dmi2008-history": "ntc2018",
    "ntc2018-history": "ntc2018",
}
ITALIAN: Mapping[str, str] = {  # the code whose knowledge levels and limit states a procedure goes by
    "dmi2008-linear": "dmi2008",
    "dmi2008-nonlinear": "dmi2008",
    "dmi2008-history": "dmi2008",
    "ntc2018-linear": "ntc2018",
    "ntc2018-nonlinear": "ntc2018",
    "ntc2018-history": "ntc2018",
}
THESIS_READINGS = (
    "asce43-05-spectrum-thesis",
    "dmi2008-nonlinear-thesis",
)  # of the thesis: shown, and they never decide

WRITTEN_FOR: Mapping[str, tuple[str, ...]] = {
    "asce41-13-ht": AMERICAN,
    "ec8-element": EUROPEAN,
    "nzsee2017-face-loaded": NEW_ZEALAND,
}
ONLY_ON_REQUEST = ("ec8-element",)  # whether a mechanism is a non-structural element, the engineer must say


def uses_histories(procedure: str) -> bool:
    """Return whether a procedure uses time histories."""
    return FAMILIES.get(procedure) == Family.HISTORY


def is_written_for(procedure: str, spectrum_code: str) -> bool:
    """Return whether a procedure is written for a spectrum of this code; True where it is for any."""
    return procedure not in WRITTEN_FOR or spectrum_code in (*WRITTEN_FOR[procedure], TABLE_SPECTRUM)


def other_spectrum(procedure: str, spectrum_code: str) -> tuple[Message, ...]:
    """Return the caveat where the spectrum is of a code the procedure is not written for; else none."""
    if is_written_for(procedure, spectrum_code):
        return ()
    return (message("other-spectrum", {"codes": ", ".join(WRITTEN_FOR[procedure]), "code": spectrum_code}),)


def procedures_of_site(spectrum_code: str) -> tuple[str, ...]:
    """Return the procedures that are added for a spectrum of this code without being requested."""
    return tuple(name for name, codes in WRITTEN_FOR.items() if spectrum_code in codes and name not in ONLY_ON_REQUEST)
