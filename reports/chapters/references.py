"""The sources of the procedures and models of a report."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from assess.results import Results
from reports.language.texts import Text, Verbatim, say

HOUSNER = Verbatim(
    "Housner, G. W. (1963). The behavior of inverted pendulum structures during earthquakes. Bulletin of the "
    "Seismological Society of America 53(2), 403–417."
)
THESIS = say(
    "{work}: cited as “thesis”.",
    work=Verbatim(
        "Mehrotra, A. A. A computational tool for seismic collapse assessment of masonry structures. PhD thesis, "
        "University of Cambridge"
    ),
)
PULSES = Verbatim(
    "Zhang, J. and Makris, N. (2001). Rocking response of free-standing blocks under cycloidal pulses. Journal of "
    "Engineering Mechanics 127(5), 473–483."
)
ONE_SIDED = Verbatim(
    "Sorrentino, L., AlShawa, O. and Decanini, L. D. (2011). The relevance of energy damping in unreinforced masonry "
    "rocking mechanisms. Experimental and analytic investigations. Bulletin of Earthquake Engineering 9(5), 1617–1642."
)
OF_PROCEDURE: Mapping[str, Verbatim] = {
    "asce43-05": Verbatim(
        "ASCE/SEI 43-05. Seismic design criteria for structures, systems, and components in nuclear facilities. "
        "American Society of Civil Engineers, 2005."
    ),
    "asce41-13": Verbatim(
        "ASCE/SEI 41-13. Seismic evaluation and retrofit of existing buildings. American Society of Civil Engineers, "
        "2014."
    ),
    "dmi2008": Verbatim(
        "D.M. 14 gennaio 2008, Norme tecniche per le costruzioni; Circolare 2 febbraio 2009 n. 617, C8A.4."
    ),
    "ntc2018": Verbatim(
        "D.M. 17 gennaio 2018, Norme tecniche per le costruzioni; Circolare 21 gennaio 2019 n. 7, C7.2.3, C8.7.1.2."
    ),
    "nzsee2017": Verbatim(
        "NZSEE, SESOC, NZGS, MBIE and EQC (2017). The seismic assessment of existing buildings, part C8: Unreinforced "
        "masonry buildings."
    ),
    "ec8": Verbatim("EN 1998-1:2004. Eurocode 8: Design of structures for earthquake resistance, part 1. CEN."),
}
"""Of procedures, by how their names begin."""
OF_SPECTRUM: Mapping[str, Verbatim] = {
    "asce7-05": Verbatim("ASCE/SEI 7-05. Minimum design loads for buildings and other structures. 2005."),
    "ibc2009": Verbatim("ASCE/SEI 7-05. Minimum design loads for buildings and other structures. 2005."),
    "asce7-10": Verbatim("ASCE/SEI 7-10. Minimum design loads for buildings and other structures. 2010."),
    "asce7-16": Verbatim(
        "ASCE/SEI 7-16. Minimum design loads and associated criteria for buildings and other structures. 2016."
    ),
    "ec8": OF_PROCEDURE["ec8"],
    "nzs1170.5": Verbatim("NZS 1170.5:2004. Structural design actions, part 5: Earthquake actions – New Zealand."),
    "ntc2008": OF_PROCEDURE["dmi2008"],
    "ntc2018": OF_PROCEDURE["ntc2018"],
}
"""Of spectra, by the code of the site."""


def cited_works(results: Results) -> tuple[Text, ...]:
    """Return the references of these results, each once."""
    found: list[Text] = []
    for each in _works(results):
        if each not in found:
            found.append(each)
    return tuple(found)


def _works(results: Results) -> Iterator[Text]:
    if results.spectrum is not None and results.spectrum.code in OF_SPECTRUM:
        yield OF_SPECTRUM[results.spectrum.code]
    for procedure in (check.procedure for mechanism in results.mechanisms for check in mechanism.checks):
        yield from (text for start, text in OF_PROCEDURE.items() if procedure.startswith(start))
    yield HOUSNER
    yield THESIS
    if any("Sorrentino et al. 2011" in mechanism.restitution_source for mechanism in results.mechanisms):
        yield ONE_SIDED
    if any(mechanism.envelope is not None for mechanism in results.mechanisms):
        yield PULSES
