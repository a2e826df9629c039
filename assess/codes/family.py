"""Which site spectra a procedure is written for: on another code's spectrum its answer is information."""

from __future__ import annotations

from collections.abc import Mapping

from assess.codes.check import Role

AMERICAN = ("asce7-05", "ibc2009", "asce7-10", "asce7-16")
EUROPEAN = ("ec8", "ntc2008", "ntc2018")
NEW_ZEALAND = ("nzs1170.5",)
GIVEN = "table"  # the engineer's own spectrum, for any code

HOMES: Mapping[str, tuple[str, ...]] = {
    "asce41-13-ht": AMERICAN,
    "ec8-element": EUROPEAN,
    "nzsee2017-face-loaded": NEW_ZEALAND,
}
ONLY_ASKED = ("ec8-element",)  # whether a mechanism is a non-structural element, the engineer must say


def at_home(procedure: str, spectrum_code: str) -> bool:
    """Whether a site of this spectrum is one that the procedure is written for; True for those without a family."""
    return procedure not in HOMES or spectrum_code in (*HOMES[procedure], GIVEN)


def role_on(procedure: str, spectrum_code: str) -> Role:
    """What an answer counts for on a spectrum."""
    return "code" if at_home(procedure, spectrum_code) else "informative"


def foreign(procedure: str, spectrum_code: str) -> str:
    """A sentence for the caveat where the spectrum is of another family; else empty."""
    if at_home(procedure, spectrum_code):
        return ""
    return f"; written for spectra of {', '.join(HOMES[procedure])}, here on one of {spectrum_code}: for information"


def offered(spectrum_code: str) -> tuple[str, ...]:
    """The procedures that a site of this spectrum brings with it, unasked."""
    return tuple(name for name, codes in HOMES.items() if spectrum_code in codes and name not in ONLY_ASKED)
