"""What a client reads in place of messages and terms that speak of the project file: what is so, not what to type.

The terminal, results.json and the lines to paste have the keys.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

from assess.codes.procedures import PROCEDURES
from reports.language.texts import Phrase, Text, listing, say
from reports.language.value_names import VALUE_WORDS, key_words

CLIENT_TEXTS: Mapping[str, Phrase] = {
    "above-building": say("the supports of the mechanism are {height} above the ground, higher than the building"),
    "class-not-given": say(
        "a pass is valid for use classes I to III; class IV also requires {states}; the class of use is not given"
    ),
    "dbe-by-asce7": say(
        "a pass is valid only if the spectrum of the site by ASCE 7 is no less than the design basis earthquake of "
        "ASCE/SEI 43-05"
    ),
    "direction-weaker": say(
        "the mechanism is clearly weaker towards {direction} than in the direction given: multiplier {weaker} and d0* "
        "{weaker_d0}, against {given} and {given_d0}"
    ),
    "floor-spectrum-unnamed": say(
        "the floor spectrum is that of another country’s code, Circolare 7/2019, C7.2.5, and the project does not "
        "choose it"
    ),
    "fragility-cloud-separated": say(
        "every record that reaches this state is stronger than every one that does not: the cloud shows no scatter, "
        "and no lognormal curve can be fitted; more records are needed, or another method"
    ),
    "fragility-ground-motion": say(
        "above the ground, but shaken by the motion of the ground unamplified: rates may be too small, and no target "
        "is shown to be met"
    ),
    "fragility-no-hazard-measure": say(
        "the hazard is in {measure}, which is not among the measures of the fragility: no rate"
    ),
    "fragility-scalar-motion": say(
        "above the ground, where one factor on the motion of the ground leaves out resonance with the building: rates "
        "may be too small, and no target is shown to be met"
    ),
    "fragility-stripes-one-measure": say(
        "by stripes fragility is found for the measure that records are scaled by, {measure}, alone"
    ),
    "ground-contradicted": say(
        "the elevation given for the base is {given}, but the base is modelled {drawn} above the ground"
    ),
    "ground-unknown": say("the lowest body is {height} from elevation 0, and the level of the ground is not given"),
    "load-across-crack": say(
        "load “{load}” at x = {x}, z = {z} acts on block {block}, yet the crack is at z = {crack}"
    ),
    "load-all-taken": say("load “{load}”: nothing else in the project carries it, so its whole weight is on the block"),
    "load-half-taken": say(
        "load “{load}”: nothing else in the project carries it; half of it is taken, since its other foot must stand "
        "on something"
    ),
    "load-part-left-out": say("load “{load}”: it bears on block {block} too, and no load puts that part of it there"),
    "load-share-unsure": say(
        "load “{load}”: {share} of its weight is on the block as drawn, yet {least} to {most} by how the drawing is "
        "read: bodies up to {apart} apart touch or do not, and a slope that meets an edge bears over little or much of "
        "it; its share is to be surveyed"
    ),
    "load-through-top": say(
        "interface C: the load on the middle of the top comes through the joint there, so its resultant moves to the "
        "edge as the wall turns, and is at hinge C in the rigid mechanism beside it; a load off the middle stays in "
        "its place"
    ),
    "missing-importance-factor": say(
        "importance class {class} asks for γ_I = {needed} (EN 1998-1, 4.2.5); the spectrum has {given}, by its "
        "importance factor or return period"
    ),
    "missing-own-pga": say("it scales the hazard to {share} of what the rows give, which decides nothing"),
    "missing-source": say("how it was found that this is excluded (survey, quality index, test): {key}"),
    "never-crushes": say("interface {interface}: no strength is known, so its joint never crushes"),
    "no-allowable-sliding": say("for information: no allowable sliding displacement is given"),
    "no-vertical-on-floor": say(
        "a pass is valid without vertical motion: histories have none, and that of the floor is not given"
    ),
    "not-amplified": say(
        "above the ground, but shaken by the ground motion unamplified in {procedures}, which may fail and cannot "
        "pass: {mechanisms}"
    ),
    "not-drawn": say(
        "a pass is valid only if these are as stated, as no body is drawn that shows them and no source vouches for "
        "them: {keys}"
    ),
    "not-lasting": say(
        "load “{load}” is not shown to last: where it resists, it counts only in the multiplier, not in displacements "
        "and histories"
    ),
    "tie-not-lasting": say(
        "tie “{load}” is not shown to last: it counts only in the multiplier, with its pretension of {force}, not in "
        "displacements and histories"
    ),
    "tie-brittle": say(
        "tie “{load}”: {link} at {strength}, where the bar yields at {yielding}; the tie is gone when its ends have "
        "moved apart by {elongation}"
    ),
    "far-wall-less": say(
        "tie “{load}”: the wall “{body}” at its far end turns inwards above {crack} at {strength}, under {action} g of "
        "its own: less than the {stated} that is stated for the far end or the anchorage, and the lesser counts"
    ),
    "far-wall-falls": say(
        "tie “{load}”: the wall “{body}” at its far end turns inwards above {crack} by itself at {multiplier} g, and "
        "is to hold the tie at {action} g: the tie has next to nothing to hold on to, and counts for nothing"
    ),
    "not-scanned": say("a pass by histories is valid only if no lower PGA is worse, which was not looked at"),
    "not-sought": say(
        "a pass is valid only for the mechanism as stated, as no weaker one is sought and no source vouches for it: "
        "{keys}"
    ),
    "one-of-several": say(
        "a pass is by the first of {procedures} that is answered: by another one of them the same mechanism may fail"
    ),
    "ordinate-not-by-name": say("{clause} needs {symbol}, which a table of ordinates does not state"),
    "override-sourced": say("{key}: {value} ({source}); {without}: {outcome}, up to {margin} times the action"),
    "override-sourced-falls": say("{key}: {value} ({source}); {without}, what it bears on falls under its own loads"),
    "override-sourced-unknown": say("{key}: {value} ({source}); {without}: {outcome}"),
    "override-unsourced": say(
        "{key}: {value}, without a source; {without}: {outcome}, up to {margin} times the action"
    ),
    "override-unsourced-falls": say(
        "{key}: {value}, without a source; {without}, what it bears on falls under its own loads"
    ),
    "override-unsourced-unknown": say("{key}: {value}, without a source; {without}: {outcome}"),
    "pga-lowered": say(
        "a pass is valid for a PGA of the site of {given}, which replaces {own} from the parameters of the spectrum"
    ),
    "premise-coursed": say("a pass is valid for coursed masonry, not for rubble, and which it is was not stated"),
    "premise-importance-class": say(
        "a pass is valid only for a building of importance class {class} or lower (EN 1998-1, 4.2.5), for which "
        "γ_I = {given}; the class is not stated"
    ),
    "return-period-unstated": say(
        "a pass is valid only if the spectrum of the site is that of {state} with a return period of {years} (class of "
        "use {class}, nominal life of 50 years), which the project does not state"
    ),
    "size-in-unit": say(
        "body “{body}” measures {size} at its longest; is its unit right? With the unit {unit} it would measure {other}"
    ),
    "size-thick-in-unit": say(
        "body “{body}” measures {size} at its longest and is about {thickness} thick; is its unit right? With the unit "
        "{unit} it would measure {other}"
    ),
    "source-of-too-much": say(
        "the source of this vouches for no value in it, since a source is for one value, body, material or load: {key}"
    ),
    "storey-unknown": say(
        "passes by the mildest row of {clause} but not by the strictest, and the storey of the wall is not given"
    ),
    "study-of-classes-d-and-e": say(
        "ASCE 7-16 §11.4.8 asks for a ground motion hazard analysis for site classes D and E with S_1 >= 0.2 g; the "
        "spectrum by Table 11.4-2 can be low at long periods (Supplement 3 raises S_M1 of class D by half)"
    ),
    "suite-not-named": say(
        "artificial records may decide only if the project names {procedure} among the methods that decide: {remedy}"
    ),
    "sweep-left-out": say("not swept in the envelopes, which use the values in the file: {keys}"),
    "two-first-modes": say(
        "histories use a first mode of {frequency}, the floor clauses of the codes a period of {period}: they do not "
        "refer to the same building"
    ),
    "uncertainty-means": say("numbers with a scatter are used at their means: {keys}"),
    "unheld": say(
        "the mechanism is stable only because of {loads}, not shown to last to collapse, so its displacements and "
        "histories cannot be evaluated"
    ),
    "vertical-motion-unknown": say(
        "the vertical motion of the floor is not known: the vertical over the horizontal spectral acceleration is "
        "needed, by the vertical floor spectrum"
    ),
}
"""By the key of the message."""

_MOTION = 'the motion at that height is needed: amplification = { method = "modal-filter" }'
CLIENT_TERMS: Mapping[str, Phrase] = {
    _MOTION: say("the motion at that height is needed"),
    "[building] period": say("the period given for the building"),
    "by building.ground_elevation": say("by the elevation of the ground"),
    "by its base_elevation": say("by the elevation given for its base"),
    "give [building] height": say("the height of the building is needed"),
    "give [building] height and storeys": say("the height of the building and its number of storeys are needed"),
    "not known where the ground is: give building.ground_elevation, or its base_elevation": say(
        "not known where the ground is: its elevation is needed"
    ),
    "row not known: the strictest; give [building] height and storeys, or the position": say(
        "row not known: the strictest, since the position of the wall in the building is not known"
    ),
}
"""By their English words."""

_KEY = re.compile(
    r"(?:site|verdict|building|records|mechanisms|materials|bodies|analysis|procedures|report)(?:[.\[][^,;]+)?"
)


def client_value(text: str) -> Text | None:
    """Return the words for a value to choose from, for keys of the project file or methods; None for another text."""
    if text in VALUE_WORDS:
        return VALUE_WORDS[text]
    items = text.split(", ")
    if all(each in PROCEDURES for each in items):
        return listing(PROCEDURES[each].title for each in items)
    if all(_KEY.fullmatch(each) for each in items):
        return listing(dict.fromkeys(map(key_words, items)))
    return None
