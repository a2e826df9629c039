"""What the report says of each kind of mechanism: what it calls it, its equation, and where that holds."""

from __future__ import annotations

from collections.abc import Mapping

from reports.language.texts import Phrase, say

KINDS: Mapping[str, Phrase] = {
    "single-block": say("A single block"),
    "two-block": say("A wall held at its top and bottom, cracked between them into two blocks,"),
    "four-hinge": say("A chain of three blocks with four hinges"),
    "facade-with-wedges": say("A wall with wedges of the walls behind it"),
    "corner": say("The corner of two walls"),
    "horizontal-arch": say("A panel between two cross walls, an arch in plan"),
    "equivalent-block": say("An equivalent block, given by its rocking parameters instead of a geometry,"),
}
"""What it is, as the subject of a sentence."""
FALLING = frozenset({"facade-with-wedges", "corner", "horizontal-arch"})
"""Those that fall outwards, and of which no history is answered."""
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
    "facade-with-wedges": (
        say("One rigid block in front of the cracks, which turns about the outer edge of its foot, by virtual work."),
        say("Multiplier and capacity curve, without friction along the cracks; histories are not answered."),
    ),
    "corner": (
        say("One rigid block in front of two cracks, which turns about the outermost point of its foot."),
        say("Multiplier and capacity curve, without friction along the cracks; histories are not answered."),
    ),
    "horizontal-arch": (
        say("Two rigid blocks on upright hinges, at the cross walls and in the middle; the ends yield at a thrust H."),
        say("Multiplier 8 H r / (W L) and capacity curve to the vanishing of the rise r; histories are not answered."),
    ),
    "equivalent-block": (
        say(
            "φ'' = p² (φ ∓ α − ü / g), the linearised equation of a block with frequency parameter p and slenderness α."
        ),
        say("Slender mechanisms given by published parameters."),
    ),
    "one-sided": (
        say("The body rocks in one direction and rebounds from the structure behind it (Mehrotra 3.45)."),
        say("Façades and other bodies that lean against a building which does not move."),
    ),
    "flexible": (
        say("Springs without tension up to their strength; resultant and moment of the joint follow at each rotation."),
        say("Bodies on mortar joints or soft beds; plane sections of the joint, no memory of crushing."),
    ),
}
"""Equations and field of use of each word that has them."""
