"""The page of one mechanism: what it is, how it moves, its answers, and what governs them."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

from assess.codes.check import Outcome
from assess.results import MechanismResult, Results
from reports import governing
from reports.chapters import governing_words, mechanism_tables, mechanism_words
from reports.document import Block, Figure, Items, Prose, Row, Section, nonempty
from reports.figures import capacity, pga_rotation, place, sketch
from reports.figures.building import Building
from reports.language.texts import Paragraph, Text, Verbatim, listing, quantity, say
from reports.titles import mechanism_number, mechanism_title, procedure_title

ALONG_X = 1.0 - 1e-9  # cosine of a direction that is the x axis of the model


def sections(
    results: Results, mechanism: MechanismResult, stem: str, building: Building | None = None
) -> list[Section]:
    """Return the page of a mechanism.

    stem : beginning of the names of its figures and tables
    building : the bodies of all mechanisms, None where its place among them is not drawn
    """
    beside = tuple(mechanism_words.representation(results, mechanism))
    answers = mechanism_tables.answers(results, mechanism, name=f"{stem}-answers")
    warnings = mechanism_words.warnings(results, mechanism)
    pairs = _in_pairs([*_shape(mechanism, stem, building), *_curves(mechanism, stem)])
    blocks: list[Block] = [
        Prose((mechanism_words.description(mechanism), *beside)),
        *governing_words.summary(results, mechanism),
        *pairs[:1],
        mechanism_tables.parameters(results, mechanism, name=f"{stem}-page-parameters"),
        *pairs[1:],
        *nonempty(answers),
        Prose(tuple(_findings(results, mechanism))),
    ]
    if warnings:
        blocks += [Prose((say("Remarks on this mechanism:"),)), Items(warnings)]
    title, mark = Verbatim(mechanism_title(mechanism)), mechanism_number(results, mechanism.name)
    return [Section(title, 0, tuple(block for block in blocks if block != Prose(())), starts_page=True, mark=mark)]


def _in_pairs(figures: list[Figure]) -> list[Block]:
    """Return figures two by two; a last one has the width of the page."""
    pairs = (figures[start : start + 2] for start in range(0, len(figures), 2))
    return [Row(tuple(pair)) if len(pair) > 1 else pair[0] for pair in pairs]


def _shape(mechanism: MechanismResult, stem: str, building: Building | None) -> Iterator[Figure]:
    yield Figure(f"{stem}-sketch", sketch_caption(mechanism), partial(sketch.draw, mechanism))
    if building is not None and mechanism.name in building.mechanisms:
        caption = say("Its place in the building; the arrow is the direction of motion.")
        yield Figure(f"{stem}-place", caption, partial(place.draw, building, mechanism.name))


def sketch_caption(mechanism: MechanismResult) -> Text:
    """Return the caption of the drawing of a mechanism, whose x may be another than the axis of the model."""
    shape = _shape_caption(mechanism)
    if mechanism.direction is None or mechanism.direction[0] > ALONG_X:
        return shape
    return Paragraph((shape, say("This x is not the axis of the model.")))


def _shape_caption(mechanism: MechanismResult) -> Text:
    turned = quantity(mechanism.drawing.displaced.rotation_rad, "rotation", 2)
    if mechanism.drawing.displaced_negative is None:
        return say(
            "At rest, and turned by φ = {rotation}; x along the motion. Circles: hinges; crosses: centroids.",
            rotation=turned,
        )
    return say(
        "At rest, and turned by φ = {rotation} to its positive side (dashed: to its negative side); x along the "
        "motion. Circles: hinges; crosses: centroids.",
        rotation=turned,
    )


def _curves(mechanism: MechanismResult, stem: str) -> Iterator[Figure]:
    caption = say("Capacity curve: restoring moment over rotation, with the rotation φₒᵥ that overturns.")
    yield Figure(f"{stem}-capacity", caption, partial(capacity.draw, mechanism))
    if mechanism.checks:
        caption = say("Largest rotation over peak ground acceleration by each method; large markers: allowable.")
        yield Figure(f"{stem}-pga-rotation", caption, partial(pga_rotation.draw, mechanism))


def _findings(results: Results, mechanism: MechanismResult) -> Iterator[Text]:
    yield from governing_words.sentences(results, mechanism)
    worst = governing.worst_per_procedure(governing.at_site(results, mechanism))
    silent = [check.procedure for check in worst if check.verdict == Outcome.NOT_APPLICABLE]
    yield from governing_words.silent_methods(results, mechanism)
    if silent:
        methods = listing(procedure_title(name) for name in dict.fromkeys(silent))
        yield say("Methods that do not apply to this mechanism: {methods}.", methods=methods)
