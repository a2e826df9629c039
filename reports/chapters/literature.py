"""The references of a report: the sources of its procedures and models."""

from __future__ import annotations

from collections.abc import Iterator

from assess.results import Results
from reports.document import Items, Section

ALWAYS = (
    "Housner, G. W. (1963). The behavior of inverted pendulum structures during earthquakes. Bulletin of the "
    "Seismological Society of America 53(2), 403–417.",
    "Mehrotra, A. A. A computational tool for seismic collapse assessment of masonry structures. PhD thesis, "
    "University of Cambridge; the source of equations, tables and figures cited as “thesis”.",
)
OF_PROCEDURE = {
    "asce43-05": "ASCE/SEI 43-05. Seismic design criteria for structures, systems, and components in nuclear "
    "facilities. American Society of Civil Engineers, 2005.",
    "asce41-13": "ASCE/SEI 41-13. Seismic evaluation and retrofit of existing buildings. American Society of Civil "
    "Engineers, 2014.",
    "dmi2008": "D.M. 14 gennaio 2008, Norme tecniche per le costruzioni, and Circolare 2 febbraio 2009 n. 617, C8A.4.",
    "ntc2018": "D.M. 17 gennaio 2018, Norme tecniche per le costruzioni, and Circolare 21 gennaio 2019 n. 7, C7.2.3 "
    "and C8.7.1.2.",
    "nzsee2017": "NZSEE, SESOC, NZGS, MBIE and EQC (2017). The seismic assessment of existing buildings, part C8: "
    "Unreinforced masonry buildings.",
    "ec8": "EN 1998-1:2004. Eurocode 8: Design of structures for earthquake resistance, part 1. CEN.",
}
OF_SPECTRUM = {
    "asce7-05": "ASCE/SEI 7-05. Minimum design loads for buildings and other structures. 2005.",
    "asce7-10": "ASCE/SEI 7-10. Minimum design loads for buildings and other structures. 2010.",
    "asce7-16": "ASCE/SEI 7-16. Minimum design loads and associated criteria for buildings and other structures. 2016.",
    "ec8": OF_PROCEDURE["ec8"],
    "nzs1170.5": "NZS 1170.5:2004. Structural design actions, part 5: Earthquake actions – New Zealand.",
    "ntc2008": OF_PROCEDURE["dmi2008"],
    "ntc2018": OF_PROCEDURE["ntc2018"],
}
PULSES = (
    "Zhang, J. and Makris, N. (2001). Rocking response of free-standing blocks under cycloidal pulses. Journal of "
    "Engineering Mechanics 127(5), 473–483."
)


def section(results: Results) -> Section:
    """Return the references as a list, each once."""
    return Section("References", 0, (Items(tuple(dict.fromkeys(_cited(results)))),))


def _cited(results: Results) -> Iterator[str]:
    if results.spectrum is not None and results.spectrum.code in OF_SPECTRUM:
        yield OF_SPECTRUM[results.spectrum.code]
    procedures = dict.fromkeys(check.procedure for mechanism in results.mechanisms for check in mechanism.checks)
    for procedure in procedures:
        yield from (text for start, text in OF_PROCEDURE.items() if procedure.startswith(start))
    yield from ALWAYS
    if any(mechanism.envelope is not None for mechanism in results.mechanisms):
        yield PULSES
