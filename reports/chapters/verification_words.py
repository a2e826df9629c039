"""Sentences of the annex of verification: how to read a case, the theory by mechanism, and what cases cannot show."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from assess.results.verification import VerificationResults
from reports.document import Block, Column, Prose, Table, nonempty
from reports.language.texts import Phrase, Verbatim, say

READING = (
    say(
        "Each case has its source, the equations that it shows and where they hold, the files to run it again, and "
        "every value beside that of the program. Titles, theory and reasons are quoted from the files of the cases."
    ),
    say(
        "Published: the value was read where the case says. Derived: no source prints the value. The authors of the "
        "program computed it from formulas by another computation than the program’s; the formulas are those of the "
        "source, and where the source itself could not be read, the case says so. Own arithmetic: the value was "
        "computed by hand or by independent code, and no source prints it."
    ),
    say(
        "Indicative: the value was read in the source, but sizes of the body, or the reading of a procedure, were "
        "chosen here to suit such values. The case shows that the program gives values of that size; it is no evidence "
        "that the program is right, and nothing counts as covered by it."
    ),
    say(
        "“Printed and not reproduced” names values beside those of a case that the source prints and the program does "
        "not give. They are in no table."
    ),
)
RELIABILITY = (
    say(
        "Reliability: each case goes through the functions that an assessment calls. The expected values and their "
        "tolerances stand in files of data that no computation of the program writes."
    ),
)
AGAIN = (
    say(
        "The folder cases beside this annex has every input file. These commands run all cases of the program, all "
        "cases of that folder, one case, and a project of a case as any other project:"
    ),
)
LIMITS = (
    say(
        "A case that passes shows that the program solves the equations of its source. It does not show that these "
        "equations suit a building: survey, geometry, materials, restraints and the choice of mechanisms are the "
        "engineer’s."
    ),
    say(
        "Not verified by solved cases: three-dimensional rocking, sliding and rocking at once, masonry that falls "
        "apart, and interaction with the soil; the program does not model them."
    ),
)
JUDGEMENT = say(
    "NTC 2018, 10.2, asks the designer to examine the documentation of the program and to judge beforehand whether it "
    "is reliable and suits the case at hand. The designer does so here, having run the cases again or examined them."
)
THEORY: Mapping[str, tuple[Phrase, Phrase]] = {
    "single-block": (
        say("I φ'' + M g R sin(α − φ) = −M R cos(α − φ) ü; an impact keeps the angular momentum about the new hinge."),
        say("A rigid body that rocks about two edges or one without sliding."),
    ),
    "two-block": (
        say("Two blocks between base, crack and top as a chain of one degree of freedom, by virtual work."),
        say("Walls held at base and top that open at one crack; the top slides freely upwards."),
    ),
    "four-hinge": (
        say("Three blocks between two fixed hinges as a chain of one degree of freedom, by virtual work."),
        say("Portals, frames, side-aisle vaults and belfries without sliding at the hinges."),
    ),
    "arch": (
        say("The four hinges at which the multiplier of the arch is least, then as three blocks."),
        say("Arches of rigid voussoirs without tension and without sliding."),
    ),
    "equivalent-block": (
        say(
            "φ'' = p² (φ ∓ α − ü / g), the linearised equation of a block with frequency parameter p and slenderness α."
        ),
        say("Slender mechanisms given by published parameters."),
    ),
    "one-sided": (
        say("The body rocks in one direction and rebounds from the structure behind it (thesis 3.45)."),
        say("Façades and other bodies that lean against a building which does not move."),
    ),
    "flexible": (
        say("Springs without tension up to their strength; resultant and moment of the joint follow at each rotation."),
        say("Bodies on mortar joints or soft beds; plane sections of the joint, no memory of crushing."),
    ),
}
"""Equations and field of use of each word that has them."""


def theory(results: VerificationResults) -> Iterator[Block]:
    """Yield the theory that all mechanisms share, then a table by mechanism with the cases that show it."""
    yield Prose(
        (
            say(
                "Every mechanism has one degree of freedom, the rotation φ of its leading block, and obeys I(φ) φ'' + "
                "½ I'(φ) φ'² + restoring(φ) = −B(φ) ü − C(φ) ẅ, where ü and ẅ are the horizontal and the vertical "
                "acceleration of the ground. Virtual work over the chain of blocks gives the inertia I, the "
                "restoring moment, the excitation B and the lift C. The equation is integrated from event to event, "
                "with a loss of velocity at each impact."
            ),
            say(
                "Procedures of codes read the same tables: the multiplier that starts the motion, the capacity curve, "
                "and the rotation that overturns. Spectra, scaling and the motion at height follow their clauses."
            ),
        )
    )
    yield from nonempty(_by_mechanism(results))


def _by_mechanism(results: VerificationResults) -> Table:
    columns = (
        Column(say("Mechanism"), share=0.13),
        Column(say("Theory")),
        Column(say("Field of use")),
        Column(say("Number of cases"), "ratio"),
    )
    rows = tuple(
        (Verbatim(word), equations, suits, number)
        for word, (equations, suits) in THEORY.items()
        if (number := sum(word in each.uses for each in results.cases))
    )
    caption = say("Theory and field of use by mechanism; the page of each case says which it exercises.")
    return Table("theory", caption, columns, rows, small=True)


def short(citation: str) -> str:
    """Return author and year of a citation, as far as the year in brackets; the citation if it has none."""
    found = re.match(r".*?\((?:19|20)\d\d[a-z]?\)", citation)
    return found[0] if found else citation
