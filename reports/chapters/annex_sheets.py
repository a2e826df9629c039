"""Annex A: for each mechanism its parameters, loads, joints and hinges, and the sheets of the methods that decide."""

from __future__ import annotations

from functools import partial

from assess.codes.check import Check
from assess.results import MechanismResult, Results
from reports import governing
from reports.chapters import joint_tables, parameter_tables
from reports.chapters.cells import BRANCHES, OUTCOMES
from reports.document import Block, Figure, Prose, Section, Sheet, nonempty
from reports.figures import view
from reports.figures.model import model_of_view
from reports.language.texts import Term, Text, Verbatim, quantity, say
from reports.titles import check_title, file_stem, mechanism_number, mechanism_title

MARK = "A"


def sections(results: Results) -> list[Section]:
    """Return the annex, a part for each mechanism."""
    introduction = Prose(
        (
            say(
                "The sheets are worked in SI units, as the constants of the clauses are printed. Each line gives the "
                "formula, the numbers put into it and the result, in enough digits to redo it by hand."
            ),
        )
    )
    head = Section(say("Calculation sheets"), 0, (introduction,), starts_page=True, mark=MARK)
    parts = [_part(results, each, place) for place, each in enumerate(results.mechanisms, start=1)]
    return [head, *parts]


def _part(results: Results, mechanism: MechanismResult, place: int) -> Section:
    stem = file_stem(mechanism.name, place)
    blocks: list[Block] = [
        *_view(mechanism, stem),
        parameter_tables.parameters(mechanism, name=f"{stem}-parameters"),
        *nonempty(parameter_tables.loads(mechanism, name=f"{stem}-loads")),
        *joint_tables.blocks(mechanism, stem),
        *nonempty(parameter_tables.hinge_forces(mechanism, name=f"{stem}-hinge-forces")),
        *_sheets(results, mechanism, stem),
    ]
    return Section(
        Verbatim(mechanism_title(mechanism)), 1, tuple(blocks), mark=mechanism_number(results, mechanism.name)
    )


def _view(mechanism: MechanismResult, stem: str) -> list[Figure]:
    """Return the bodies of a mechanism in space, which a reader can turn; none without geometry."""
    seen = mechanism.view
    if seen is None:
        return []
    positive = len(mechanism.drawing.displaced.hinges)
    caption = say(
        "The bodies in space, cracks dashed; axes of rotation of the positive side red, of the negative side blue and "
        "dashed; the arrow is the direction of motion."
    )
    return [Figure(f"{stem}-view", caption, partial(view.draw, seen, positive), model_of_view(seen, positive=positive))]


def _sheets(results: Results, mechanism: MechanismResult, stem: str) -> list[Sheet]:
    checks = governing.worst_per_procedure(governing.at_site(results, mechanism))
    shown = [check for check in checks if check.steps and may_decide(results, check)]
    return [_sheet(check, mechanism, f"{stem}-sheet-{place:02d}") for place, check in enumerate(shown, start=1)]


def may_decide(results: Results, check: Check) -> bool:
    """Return whether a check decides or its method is accepted; without a basis, whether it follows a code's letter."""
    accepted = () if results.verdict is None else results.verdict.methods
    return check.role == "deciding" or check.procedure in accepted or (not accepted and check.reading == "letter")


def _sheet(check: Check, mechanism: MechanismResult, name: str) -> Sheet:
    caption = say(
        "{method} ({edition}), {branch} branch, at PGA {pga}: {outcome}.",
        method=check_title(check, mechanism.checks),
        edition=Term(check.edition),
        branch=BRANCHES[check.branch],
        pga=quantity(check.level_pga_g, "ground acceleration"),
        outcome=_outcome(check),
    )
    return Sheet(name, caption, check.steps)


def _outcome(check: Check) -> Text:
    outcome = OUTCOMES[check.verdict.value]
    return say("{outcome}, deciding", outcome=outcome) if check.role == "deciding" else outcome
