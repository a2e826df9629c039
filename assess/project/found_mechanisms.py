"""The mechanisms that the bodies of a project can have beside those that it states, and the tables that add them."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace
from hashlib import sha256
from math import dist, radians
from typing import TYPE_CHECKING

import numpy as np

from assess.errors import OutputError, ProjectError
from assess.geometry.formats.mesh_file import Element
from assess.geometry.solid import scale_density
from assess.loads.load import BodyLoad
from assess.mechanisms.kinds import Definition
from assess.mechanisms.mechanism import BlockMechanism, CutAngle, CutPlane
from assess.model.candidates import Candidate, Candidates, OpenEntry
from assess.model.moving_parts import BuildingType
from assess.model.part_bodies import DrawnBody, DrawnModel
from assess.model.structure import Structure
from assess.model.structure_reading import structure_of_models
from assess.outputs.writing import replace_file
from assess.project.build import build_to_decide
from assess.project.drawn_project import is_stated, mechanism_lines, unexamined_entries
from assess.project.keys import read_content, with_values
from assess.project.project_file import Project, load_tree, parse_toml
from assess.project.sections import Content
from assess.project.sections.content import checklist
from assess.project.site_and_structure import bodies_of, definitions_of, element_of, models_of, solid_of
from assess.study.ranking import median_overturning_pga
from assess.study.run import find_outcome
from assess.study.states import STRUCK_OUT
from assess.study.study import Study

if TYPE_CHECKING:
    from pandas import DataFrame

SAME_CUT = 0.1  # m: cuts of a wall this near each other are one
SAME_ANGLE = radians(2.5)  # cuts inclined this alike are one
SAME_WAY = 0.999  # cosine: directions within 2.5 degrees are one
CLASS_OF_ROLE: Mapping[str, str] = {"floor": "IfcSlab", "roof": "IfcRoof", "vault": "IfcSlab"}
"""The class of a body that the project loads a mechanism with, by the role that it states."""


@dataclass(frozen=True)
class FoundMechanisms:
    """What was found on the bodies of a project.

    structure : the bodies as a building
    candidates : its mechanisms, the weakest first
    in_file : by the name of a candidate, the mechanism of the project that is the same
    bodies : names of the project's bodies; parts into which one was split have others
    not_examined : why, by the entries of the list of the report that nothing in the file speaks of
    struck_out : names of the candidates that the project strikes out, by these or as mechanisms of the file
    """

    structure: Structure
    candidates: Candidates
    in_file: Mapping[str, str]
    bodies: frozenset[str]
    not_examined: Mapping[str, str]
    struck_out: frozenset[str] = frozenset()

    @property
    def new(self) -> tuple[Candidate, ...]:
        """The candidates that the project can state and does not, nor strikes out."""
        known = [each for each in self.candidates if each.name not in self.in_file.keys() | self.struck_out]
        return tuple(each for each in known if is_stated(each) and self.bodies.issuperset(each.parts))

    def open_entries(self, building_type: BuildingType) -> Mapping[str, OpenEntry]:
        """Return the entries of a list that stay open once the file has what is new."""
        stated = {each.name for each in self.new} | set(self.in_file)
        return self.candidates.open_entries(building_type, stated=stated)

    def table(
        self, margins: Mapping[str, float] | None = None, overturning: Mapping[str, float | None] | None = None
    ) -> DataFrame:
        """Return a row for each mechanism, the weakest first, with that of the project that is the same.

        Parameters
        ----------
        margins : PGA at capacity over the site's, by candidate; those that have one come first then
        overturning : PGA at which the suite overturns half of its runs [g], by candidate; likewise
        """
        table = self.candidates.table()
        stated = {**dict.fromkeys(self.struck_out, "(struck out)"), **self.in_file}
        table.insert(1, "in_file", [stated.get(each.name, "") for each in self.candidates])
        if overturning is not None:
            table.insert(5, "overturning_pga_g", [overturning.get(each.name) for each in self.candidates])
            return table.sort_values("overturning_pga_g", kind="stable")
        if margins is None:
            return table
        table.insert(5, "margin", [margins.get(each.name) for each in self.candidates])
        return table.sort_values("margin", kind="stable")


def find_mechanisms(project: Project) -> FoundMechanisms:
    """Find the mechanisms that the bodies of a project can have.

    Bodies that load a mechanism are what it says they are; others are what their element of a model is, or else what
    they look like and touch.

    Raises
    ------
    GeometryError : a model cannot be read, or nothing in the project is masonry
    """
    content = project.content
    definitions = definitions_of(content)
    models = models_of(content.bodies, known={})
    solids = {name: solid_of(name, body, content.materials, models) for name, body in content.bodies.items()}
    loads = [load for each in definitions.values() if isinstance(each, BlockMechanism) for load in each.loads]
    roles = {load.body: load.role for load in loads if isinstance(load, BodyLoad)}
    drawn = []
    for name, body in bodies_of(content, solids).items():
        if body.solid is None or body.material is None:
            continue
        density = body.material.density
        if name in roles:
            element = Element(kinds=(CLASS_OF_ROLE[roles[name]],), density=density)
        else:
            element = replace(element_of(content.bodies[name], models), density=density)
        drawn.append(DrawnBody(name, scale_density(body.solid, 1.0 / density), element, project.path.name))
    structure = structure_of_models([DrawnModel(tuple(drawn), (), ())], files=[project.path.name])
    candidates = structure.mechanisms()
    in_file = _in_file(candidates, definitions, structure)
    unnamed = _unnamed_entries(content, candidates, stated=in_file)
    struck = _struck_out(project, candidates, structure)
    return FoundMechanisms(structure, candidates, in_file, frozenset(solids), unnamed, struck)


def _struck_out(project: Project, candidates: Candidates, structure: Structure) -> frozenset[str]:
    """Return the candidates that a project strikes out, by their names or as mechanisms of the file."""
    struck = project.content.report.struck_out
    if not struck:
        return frozenset()
    whole = read_content(with_values(project.raw, {STRUCK_OUT: {}}, project.content), project.folder)
    in_file = _in_file(candidates, definitions_of(whole), structure)
    return frozenset(each.name for each in candidates if each.name in struck or in_file.get(each.name) in struck)


def _unnamed_entries(content: Content, candidates: Candidates, *, stated: Collection[str]) -> dict[str, str]:
    """Return why the entries of the list of the report that nothing in a file speaks of are not examined."""
    if content.report.building_type is None:
        return {}
    open_entries = unexamined_entries(candidates, content.report.building_type, stated=stated)
    unnamed = {item.key for item in checklist(content.report, content.mechanisms) if not item.spoken_for}
    return {entry: why for entry, why in open_entries.items() if entry in unnamed}


def _in_file(candidates: Candidates, definitions: Mapping[str, Definition], structure: Structure) -> dict[str, str]:
    """Return the mechanism of a project that moves the same bodies in the same way, by the name of each candidate."""
    found = {}
    for each in candidates:
        for name, stated in definitions.items():
            if _is_same(each, stated, structure):
                found[each.name] = name
                break
    return found


def _is_same(candidate: Candidate, other: Definition, structure: Structure) -> bool:
    """Return whether a mechanism of a project is a candidate, in its direction or in one in which it is as weak."""
    one = candidate.definition
    if one is None or not isinstance(other, BlockMechanism) or other.kind != one.kind or other.direction == "sweep":
        return False
    if set(one.bodies) != set(other.bodies) or set(one.neighbours) != set(other.neighbours):
        return False
    ways = [one.towards, *(each.direction for each in candidate.ties)]
    same_way = other.direction is None or max(float(np.array(way) @ other.along) for way in ways) >= SAME_WAY
    base = min(structure.part(body).base for body in one.bodies)
    cuts = [base if each.cut is None else each.cut for each in (one, other)]
    return same_way and _is_same_cut(cuts[0], cuts[1], turned=float(np.array(one.towards) @ other.along) < SAME_WAY)


Cut = float | CutPlane | CutAngle


def _is_same_cut(one: Cut, other: Cut, *, turned: bool) -> bool:
    """Return whether two cuts lie near each other, as project files state them rounded.

    turned : towards another side, where a crack begins at the same height
    """
    if isinstance(one, CutAngle) and isinstance(other, CutAngle):
        apart = abs(one.point[2] - other.point[2]) if turned else dist(one.point, other.point)
        return apart <= SAME_CUT and abs(one.angle - other.angle) <= SAME_ANGLE
    if isinstance(one, float) and isinstance(other, float):
        return abs(one - other) <= SAME_CUT
    return one == other


def find_margins(project: Project, found: FoundMechanisms, *, jobs: int = 0) -> dict[str, float]:
    """Return the PGA at capacity over the site's of each mechanism that the basis of a project answers, by candidate.

    Those that the file does not state are examined as `add_mechanisms` would add them.

    Parameters
    ----------
    project : with a site
    found : on its bodies
    jobs : threads, 0 for all cores

    Raises
    ------
    AssessError : the project cannot be run, as one without a site
    """
    study, stated = _study_with_all(project, found)
    verdict = find_outcome(study, jobs=jobs)
    margins = {each.mechanism: each.margin for each in verdict.mechanisms if each.margin is not None}
    return {candidate: margins[name] for candidate, name in stated.items() if name in margins}


def find_overturning_pga(project: Project, found: FoundMechanisms, *, jobs: int = 0) -> dict[str, float | None]:
    """Return the PGA [g] at which a project's suite overturns each mechanism in half of its runs, by candidate.

    None where it never does, or no history is answered. Those that the file does not state are examined as
    `add_mechanisms` would add them.

    Parameters
    ----------
    project : with a site, and records or what makes them
    found : on its bodies
    jobs : threads, 0 for all cores

    Raises
    ------
    AssessError : the project cannot be run, as one without a site or a suite
    """
    study, stated = _study_with_all(project, found)
    overturning = median_overturning_pga(study, jobs=jobs)
    return {candidate: overturning[name] for candidate, name in stated.items() if name in overturning}


def _study_with_all(project: Project, found: FoundMechanisms) -> tuple[Study, dict[str, str]]:
    """Return the study of a project with all that was found, and the name in it of each candidate that it states."""
    after, names = _with_tables(project, found, project.path.read_bytes())
    study = build_to_decide(load_tree(parse_toml(after.removeprefix("\ufeff")), project.path, sha256=""))
    return study, dict(zip((each.name for each in found.new), names, strict=True)) | dict(found.in_file)


def add_mechanisms(project: Project, found: FoundMechanisms) -> tuple[str, ...]:
    """Add tables of what is new at the end of a project file, whose text stays as it is; return their names.

    They answer no entry of the list of the report that stays open, unless the file names it as not examined.

    Parameters
    ----------
    project : as it was read
    found : on its bodies

    Raises
    ------
    ProjectError : the file has changed since it was read, or no longer reads with the tables; nothing is written
    """
    before = project.path.read_bytes()
    changed = f"{project.path}: has changed since it was read; nothing was written: run the command again"
    if sha256(before).hexdigest() != project.sha256:
        raise ProjectError(changed)
    after, names = _with_tables(project, found, before)
    try:
        load_tree(parse_toml(after.removeprefix("\ufeff")), project.path, sha256="")
    except ProjectError as error:
        raise ProjectError(f"the tables of the mechanisms cannot be added, and nothing was written: {error}") from None
    try:
        with replace_file(
            project.path, command="assess mechanisms", is_replaceable=lambda path: path.read_bytes() == before
        ) as made:
            made.write_bytes(after.encode("utf-8"))
    except OutputError:
        if project.path.exists() and project.path.read_bytes() != before:
            raise ProjectError(changed) from None
        raise
    return names


def _with_tables(project: Project, found: FoundMechanisms, before: bytes) -> tuple[str, tuple[str, ...]]:
    """Return the text of a project file with tables of what is new at its end, and their names."""
    taken, lines, names = set(project.content.mechanisms), [""], []
    report = project.content.report
    left_open = {} if report.building_type is None else found.open_entries(report.building_type)
    unnamed = {entry: each for entry, each in left_open.items() if entry not in report.not_examined}
    for each in found.new:
        name = next(one for one in (each.name, *(f"{each.name}-{i}" for i in range(2, 1000))) if one not in taken)
        taken.add(name)
        names.append(name)
        bodies = {body: body for body in project.content.bodies}
        lines += mechanism_lines(replace(each, name=name), bodies, report.building_type, unnamed)
    text = before.decode("utf-8")
    return text + "\n" * (not text.endswith("\n")) + "\n".join(lines), tuple(names)
