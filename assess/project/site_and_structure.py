"""The tables [bodies], [materials], [mechanisms], [building] and [site] as plain data: one translator for each.

The site's spectrum is described by the table [site.spectrum], or by options of a command with the same keys.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from contextlib import nullcontext, suppress
from dataclasses import replace
from math import inf
from pathlib import Path
from typing import Any, cast

from pydantic import ValidationError

from assess.codes.context import SiteHazard
from assess.codes.italian_limit_states import FACTORS_BY_LEVEL, LARGEST_FACTOR
from assess.codes.procedures import KNOWLEDGE_CODES
from assess.errors import AssessError, Faults, ProjectError, locate_errors
from assess.geometry import mesh
from assess.geometry.formats.mesh_file import Element
from assess.geometry.mesh import MeshesBySelection, read_selected_meshes
from assess.geometry.solid import Solid, Solids, box, profile
from assess.loads.far_wall import SiteAction
from assess.loads.load import BodyLoad, TieLoad
from assess.mechanisms.kinds import Definition
from assess.mechanisms.mechanism import BlockMechanism, Mechanism
from assess.messages.message import Message
from assess.model.bodies import Bodies, Body, Material, PointValues
from assess.model.part_kinds import TIE_WORDS, is_tie
from assess.model.part_shapes import shape_of
from assess.project import sections
from assess.project.keys import error_line
from assess.project.project_file import bare_number_messages, load
from assess.project.question import PROVISIONAL_CLASS, limit_state_of, use_class_of
from assess.project.section import fill
from assess.project.sections.bodies_and_loads import ProfileBody
from assess.project.sections.ground_motion import SiteSection
from assess.study.amplification import (
    AmplificationChoice,
    GroundLevel,
    HeightAboveGround,
    Structure,
    find_height,
    lowest_body_elevation,
)
from spectra.design_spectra import TableSpectrum
from spectra.errors import SpectrumError
from spectra.gravity import g
from spectra.registry import horizontal_spectrum, vertical_spectrum
from spectra.spectrum import Spectrum


def definitions_of(content: sections.Content) -> dict[str, Definition]:
    """Return the definition of each mechanism of a project, with the evidence of its loads by [report.sources]."""
    found = {name: _with_evidence(each.plain, name, content) for name, each in content.mechanisms.items()}
    plated = any(
        isinstance(load, TieLoad) and load.plate for each in found.values() for load in getattr(each, "loads", ())
    )
    action = _action_on_far_walls(content) if plated else None
    around = dict(found)  # bars and floors are there too where a mechanism that they hold or load cannot occur
    for name, section in content.struck_out.items():
        with suppress(AssessError):
            around |= {} if section is None else {name: _with_evidence(section.plain, name, content)}
    return {name: _with_what_is_around(name, each, around, action) for name, each in found.items()}


def _action_on_far_walls(content: sections.Content) -> SiteAction | None:
    """Return what shakes the far walls of ties: the site's own PGA; None where there is no site, or it is faulty."""
    building = content.building
    with suppress(AssessError, SpectrumError):
        site = site_in(content)
        if site is not None:
            ground, height = (None, None) if building is None else (building.ground_elevation, building.height)
            return SiteAction(spectrum_of(site).pga / g, ground, height)
    return None


def _with_what_is_around(name: str, definition: Any, found: Mapping[str, Any], action: SiteAction | None) -> Any:
    """Return a definition whose ties know the plates of other mechanisms on the same bodies, floors, and the site."""
    if not any(isinstance(load, TieLoad) and load.plate for load in getattr(definition, "loads", ())):
        return definition
    others = [each for key, each in found.items() if key != name and isinstance(each, BlockMechanism)]
    ties: tuple[list[TieLoad], list[TieLoad]] = [], []
    for each in others:
        is_near = bool({*each.bodies} & {*definition.bodies})
        ties[is_near].extend(load for load in each.loads if isinstance(load, TieLoad) and load.plate)
    far, near = map(tuple, ties)
    floors = tuple(load for each in others for load in each.loads if isinstance(load, BodyLoad))
    loads = tuple(
        replace(load, others=near, neighbours=far, floors=floors, site=action)
        if isinstance(load, TieLoad) and load.plate
        else load
        for load in definition.loads
    )
    return replace(definition, loads=loads)


def _with_evidence(definition: Any, name: str, content: sections.Content) -> Any:
    """Return a definition whose loads that may end say where it is shown that they last; plates have their FC."""
    if not isinstance(definition, BlockMechanism):
        return definition
    confidence = _confidence(name, content)
    lasting = (
        replace(cast(Any, load), evidence=content.report.source_of(f"mechanisms.{name}.loads.{place}.until"))
        if hasattr(load, "evidence")
        else load
        for place, load in enumerate(definition.loads)
    )
    loads = (
        replace(load, plate=replace(load.plate, confidence=confidence))
        if isinstance(load, TieLoad) and load.plate is not None
        else load
        for load in lasting
    )
    return replace(definition, loads=tuple(loads))


def _confidence(name: str, content: sections.Content) -> float:
    """Return the largest FC of the levels of knowledge that are given for a mechanism; without one that of LC1."""
    tables = [getattr(content.procedures, code) for code in KNOWLEDGE_CODES]
    levels = [each.knowledge_levels.get(name, each.knowledge_level) for each in tables]
    return max((FACTORS_BY_LEVEL[level] for level in levels if level is not None), default=LARGEST_FACTOR)


def element_of(body: sections.BodySection, models: MeshesBySelection) -> Element:
    """Return what the model says of the element that a body is: its class, and whether it is called a tie.

    Parameters
    ----------
    body : of the project
    models : what the bodies take from model files
    """
    meshes = models[body.mesh, body.element].meshes if isinstance(body, sections.MeshBody) else ()
    if len(meshes) != 1:
        return Element()
    found = meshes[0].element
    names = tuple(name for name in found.names if TIE_WORDS.search(name))
    return Element(names=names, kinds=found.kinds, within=found.within, predefined=found.predefined)


def is_drawn_tie(name: str, body: sections.BodySection, solid: Solid, models: MeshesBySelection) -> bool:
    """Return whether a body of a project is a tie: by the class or name in its model, or as a thin long bar.

    Parameters
    ----------
    name : of the body
    body : as the project has it
    solid : its geometry
    models : what the bodies take from model files
    """
    element = element_of(body, models)
    return is_tie(replace(element, names=(name, *element.names)), shape_of(solid))


def models_of(
    bodies: Mapping[str, sections.BodySection], *, known: MeshesBySelection, faults: Faults | None = None
) -> MeshesBySelection:
    """Read what the bodies take from model files, each file once; `known` has been read already.

    faults : gathers those of all files; the first is raised if None
    """
    choices = {name: (body.mesh, body.element) for name, body in bodies.items() if isinstance(body, sections.MeshBody)}
    unread = {name: one for name, one in choices.items() if one not in known}
    return {**known, **read_selected_meshes(unread, faults=faults)}


def solid_of(
    name: str, body: sections.BodySection, materials: Mapping[str, sections.MaterialSection], models: MeshesBySelection
) -> Solid | None:
    """Return the solid of a body; None if it has direct values."""
    if isinstance(body, sections.DirectBody):
        return None
    density = density_of(body, materials)
    if isinstance(body, sections.MeshBody):
        model = models[body.mesh, body.element]
        return mesh.solid_from_meshes(model, density=density, name=name, scale=body.mesh_unit, up=body.mesh_up)
    if isinstance(body, sections.BoxBody):
        return box(**body.box.model_dump(), density=density, name=name)
    return profile(body.profile, length=body.length, density=density, name=name)


def density_of(
    body: sections.MeshBody | sections.BoxBody | ProfileBody, materials: Mapping[str, sections.MaterialSection]
) -> float:
    """Return the mass per volume of a body with geometry [kg/m3]."""
    density: float = materials[body.material].density
    return density


def bodies_of(content: sections.Content, solids: Mapping[str, Solid | None]) -> Bodies:
    """Return the bodies of a project, each with its solid and its material."""
    return {name: _body(name, body, content, solids[name]) for name, body in content.bodies.items()}


def _body(name: str, body: sections.BodySection, content: sections.Content, solid: Solid | None) -> Body:
    if isinstance(body, sections.DirectBody):
        return Body(name=name, solid=solid, values=fill(PointValues, body))
    material = fill(Material, content.materials[body.material], name=body.material)
    return Body(name=name, solid=solid, material=material)


def ground_of(
    building: sections.BuildingSection | None, definitions: Mapping[str, Definition], solids: Solids
) -> GroundLevel:
    """Return what the project says of the ground; raise ProjectError for one above all that is drawn."""
    lowest = lowest_body_elevation(definitions, solids)
    if building is None:
        return GroundLevel(lowest=lowest)
    highest = max((float(solid.vertices[:, 2].max()) for solid in solids.values() if solid is not None), default=inf)
    if building.ground_elevation is not None and building.ground_elevation > highest:
        raise ProjectError(
            f"building.ground_elevation = {building.ground_elevation:g} m: all bodies end below it, the highest at "
            f"{highest:g} m; give the elevation of the ground in the coordinates of the bodies"
        )
    return GroundLevel(building.ground_elevation, lowest, building.height or 0.0)


def base_elevation_of(section: sections.MechanismSection) -> float | None:
    """Return the elevation of the base above the ground [m] that the table of a mechanism gives for it alone."""
    return section.base_elevation if isinstance(section, sections.ChainSection) else None


def ground_mechanism(
    section: sections.MechanismSection, mechanism: Mechanism, ground: GroundLevel
) -> HeightAboveGround:
    """Return where a mechanism stands over the ground."""
    by_table = section.kind == "equivalent-block" and section.has_key("elevation")
    return find_height(ground, mechanism, base_elevation=base_elevation_of(section), by_table=by_table)


def amplification_method_of(section: sections.MechanismSection) -> AmplificationChoice | None:
    """Return the key `amplification` of a mechanism; None for the ground's motion as it is."""
    method = section.amplification
    return None if isinstance(method, sections.NoAmplification) else fill(AmplificationChoice, method)


def structure_of(building: sections.BuildingSection | None) -> Structure:
    """Return what the table [building] says of the structure below a mechanism; its period only where it is given."""
    if building is None:
        return Structure()
    return fill(Structure, building, period=building.period if building.has_key("period") else None)


def site_of(path: Path) -> sections.SiteSection:
    """Read the site of the project at `path`; raise ProjectError if it has none, or lacks the class of use."""
    project = load(path)
    site = site_in(project.content)
    if site is None:
        raise ProjectError(f"{project.path}: site.spectrum: missing; add a table [site.spectrum]")
    if site.hazard is not None and use_class_of(project.content) is None:
        reason = 'missing; class of use "I" to "IV", here or in [building]'
        raise ProjectError(f"{project.path}: site.spectrum.use_class: {reason}")
    return site


def site_in(content: sections.Content) -> sections.SiteSection | None:
    """Return the site of a project; hazard over return periods gets its limit state and class of use.

    Where the class is not given it is the severest, with which the verdict is provisional (`question_of`). Raises
    ProjectError if it is given twice with different values.
    """
    site = content.site
    if site is None or site.hazard is None:
        return site
    given = {"limit_state": limit_state_of(content), "use_class": use_class_of(content) or PROVISIONAL_CLASS}
    return site.model_copy(update={"spectrum": site.spectrum.model_copy(update=given)})


def spectrum_of(site: sections.SiteSection) -> Spectrum:
    """Return the site's horizontal spectrum at its damping, scaled to the PGA given."""
    way = site.spectrum.plain
    with nullcontext() if isinstance(way, TableSpectrum) else locate_errors("site.spectrum"):  # its file is named
        return horizontal_spectrum(way, pga=site.pga)


def vertical_of(site: sections.SiteSection) -> Spectrum:
    """Return the site's vertical spectrum, with the factor by which `pga` scales the horizontal one.

    Raises SpectrumError for codes without one here.
    """
    with locate_errors("site.spectrum"):
        return vertical_spectrum(site.spectrum.plain, pga=site.pga)


def hazard_over_periods(site: sections.SiteSection) -> SiteHazard | None:
    """Return the spectra of the limit states and the PGA of each row, scaled as the site's spectrum; None without rows.

    A limit state whose return period lies outside the rows has no spectrum.
    """
    hazard = site.hazard
    if hazard is None:
        return None
    factor = spectrum_of(site).factor
    with locate_errors("site.spectrum"):
        at_states = hazard.at_limit_states()
    return SiteHazard(
        spectra={state: replace(at, factor=factor, damping=hazard.damping) for state, at in at_states.items()},
        return_period=hazard.years,
        pga=hazard.surface_pgas(factor=factor),
    )


NUMBER = re.compile(r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]{1,3})?")


def read_site_options(options: Mapping[str, str], *, folder: Path) -> SiteSection:
    """Read a site from options of the command line, with the keys of [site.spectrum] and `pga`.

    Parameters
    ----------
    options : text of each option, by key
    folder : paths are relative to it

    Raises
    ------
    ProjectError : a project file would be refused for it; one line that names the option
    """
    raw = _site_table(options)
    try:
        return SiteSection.model_validate(raw, context={"folder": folder})
    except ValidationError as error:
        raise ProjectError(_as_option(error_line(error, raw=raw))) from None


def site_option_messages(options: Mapping[str, str]) -> tuple[Message, ...]:
    """Warn of accelerations written without a unit that look as if g had been meant."""
    found = bare_number_messages({"site": _site_table(options)})
    return tuple(replace(each, where=_as_option(each.where.removeprefix("site."))) for each in found)


def _site_table(options: Mapping[str, str]) -> dict[str, Any]:
    """Return the options as the table [site] of a project file."""
    table = {key: value if key == "file" else _number_or_text(value) for key, value in options.items() if key != "pga"}
    raw: dict[str, Any] = {"spectrum": table}
    if "pga" in options:
        raw["pga"] = _number_or_text(options["pga"])
    return raw


def _number_or_text(text: str) -> float | int | str:
    """Return a number if the text is one, as TOML would have it without quotes, else the text."""
    if NUMBER.fullmatch(text) is None:
        return text
    return int(text) if re.fullmatch(r"[+-]?[0-9]+", text) else float(text)


def _as_option(line: str) -> str:
    """Write the key in front of an error as the option."""
    return re.sub(r"^(?:spectrum\.)?(\w+)", lambda found: f"--{found[1].replace('_', '-')}", line)
