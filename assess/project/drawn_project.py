"""A project file from a building that was read from its model: bodies, loads, and a table for each mechanism found.

What only a survey can tell stands in one block at the end, commented out, with the densities. Until it is filled in,
what needs it is not answered.
"""

from __future__ import annotations

import json
import re
import shutil
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import degrees
from pathlib import Path
from typing import Any

from assess.codes.checklists import CHECKLISTS
from assess.errors import GeometryError, ProjectError
from assess.examples import name_schema
from assess.examples.surfaces import ClosedSurface, ply
from assess.geometry.formats.mesh_file import Up
from assess.geometry.formats.readers import WITHOUT_UNIT
from assess.geometry.solid import Solid
from assess.loads.load import BodyLoad, OverburdenLoad
from assess.mechanisms.four_hinge import FourHinge, RadialJoints
from assess.mechanisms.mechanism import BlockMechanism, CutAngle
from assess.mechanisms.two_block import TwoBlock
from assess.mechanisms.wedged_block import Wedge, WedgedBlock
from assess.messages.message import first_names
from assess.model.candidates import CLASSES, Candidate, Candidates, OpenEntry, texts_of
from assess.model.churches import is_church
from assess.model.moving_parts import BuildingType
from assess.model.structure import COVERINGS, Part, Structure
from assess.model.structure_reading import read_structure
from assess.outputs.writing import new_folder
from assess.project.values import length_of_unit

MESHES, PROJECT = "meshes", "project.toml"


@dataclass(frozen=True)
class DrawnProject:
    """A project drawn from a model.

    text : of its project.toml
    meshes : bodies that the model does not hold as they are, by the path of the file each is written to
    """

    text: str
    meshes: Mapping[str, Solid]


def draw_project(
    structure: Structure, candidates: Candidates, *, title: str, unit: str | None = None, up: Up | None = None
) -> DrawnProject:
    """Write the project file of a building with the mechanisms that were found on it.

    Parameters
    ----------
    structure : the building; its model files lie beside the project file
    candidates : its mechanisms
    title : of the project
    unit, up : of the model files, as project files write them; the files' own where None
    """
    names = _body_names(structure.parts)
    likely: BuildingType = "church" if is_church(structure) else "house"
    building_type = None if structure.is_one_shell else likely
    stated = [each for each in candidates if is_stated(each)]
    meshes = {_mesh_path(names[part.name]): part.solid for part in structure.parts if not _is_element(part, structure)}
    lines = [
        *_comment(f"Drawn from {', '.join(structure.files)} by `assess new --from`."),
        *(line for each in structure.warnings for line in _comment(f"- Warning: {each}.")),
        *(line for each in structure.left_out_texts for line in _comment(f"- Left out: {each}.")),
        "# What only a survey can tell is to be filled in at the end; until then, what needs it is not answered.",
        "",
        f"title = {_text(title)}",
        "",
        *_building(structure),
        *_report(candidates, stated, building_type),
        "[bodies]",
        *(_body(part, names, structure, unit=unit, up=up) for part in structure.parts),
        "",
    ]
    for each in stated:
        lines += mechanism_lines(each, names, building_type)
    lines += _unstated(candidates, stated)
    lines += _survey(structure, stated, likely)
    return DrawnProject("\n".join(lines) + "\n", meshes)


def remarks_of_model(text: str) -> tuple[str, ...]:
    """Return what the reading of the model warned of and left out, as the file that was drawn from it says."""
    head = re.sub(r"\n#   +", " ", text.partition("\n\n")[0])
    return tuple(re.findall(r"^# - ((?:Warning|Left out): .*)$", head, re.MULTILINE))


def is_stated(candidate: Candidate) -> bool:
    """Return whether a project file can state a mechanism, and it stands as it is drawn."""
    return candidate.definition is not None and candidate.multiplier is not None and candidate.multiplier > 0.0


def _body_names(parts: Sequence[Part]) -> dict[str, str]:
    """Return a name of each part that needs no quotes in a project file."""
    found: dict[str, str] = {}
    for part in parts:
        stem = re.sub(r"[^A-Za-z0-9]+", "-", part.name).strip("-").lower() or part.kind
        name = next(each for each in (stem, *(f"{stem}-{i}" for i in range(2, 10_000))) if each not in found.values())
        found[part.name] = name
    return found


def _is_element(part: Part, structure: Structure) -> bool:
    """Return whether an element of a model file is the part and nothing else."""
    alike = [each for each in structure.parts if (each.file, each.element) == (part.file, part.element)]
    return part.whole and bool(part.file) and len(alike) == 1


def _mesh_path(name: str) -> str:
    return f"{MESHES}/{name}.ply"


LISTED = 4  # parts of a model in which nothing stands


def _building(structure: Structure) -> Iterator[str]:
    tops = [part.top for part in structure.parts if part.kind not in (*COVERINGS, "chimney", "pinnacle", "tie")]
    yield "[building]"
    yield f'height = "{max(tops) - structure.lowest:.6g} m"'
    if (storeys := number_of_storeys(structure)) is not None:
        yield f"storeys = {storeys}"
    yield f'ground_elevation = "{structure.lowest + 0.0:.6g} m"'
    yield ""


LEAST_STOREY, HIGHEST_STOREY = 1.8, 4.5  # m: a lower one is a loft; a higher one may be two, whose floor is not drawn


def number_of_storeys(structure: Structure) -> int | None:
    """Return the levels above the ground where floors and the roof bear; None where the drawing does not tell them."""
    tops = [part.top if part.eaves is None else part.eaves for part in structure.walls]
    if not structure.storeys or not tops:
        return None
    last = structure.storeys[-1]
    heights = [each.height for each in structure.storeys if each.height is not None]
    heights += [above] if (above := max(tops) - last.elevation) > LEAST_STOREY else []
    return len(heights) if heights and max(heights) <= HIGHEST_STOREY else None


def _body(part: Part, names: Mapping[str, str], structure: Structure, *, unit: str | None, up: Up | None) -> str:
    keys: dict[str, Any] = {"material": _material(part)}
    if _is_element(part, structure):
        keys |= {"mesh": part.file} | ({"element": part.element} if part.element else {})
        keys |= ({"mesh_unit": unit} if unit else {}) | ({"mesh_up": up} if up else {})
    else:
        keys |= {"mesh": _mesh_path(names[part.name])}
    return f"{names[part.name]} = {_table(keys)}"


def _material(part: Part) -> str:
    """Return the name of a part's material: that of the model, or what it is."""
    stem = re.sub(r"[^A-Za-z0-9]+", "-", part.material).strip("-").lower()
    return stem or (part.kind if part.kind in COVERINGS else "masonry")


def mechanism_lines(
    candidate: Candidate,
    names: Mapping[str, str],
    building_type: BuildingType | None,
    open_entries: Mapping[str, OpenEntry] | None = None,
) -> Iterator[str]:
    """Yield the lines of the tables of a mechanism, with why it can form as a comment.

    Parameters
    ----------
    candidate : that a project file can state
    names : of the bodies, by the names of the parts
    building_type : whose list of mechanisms the report goes through; None where it goes through none
    open_entries : of that list, which the file does not name as not examined, so that no table answers them
    """
    definition = candidate.definition
    assert definition is not None  # as it is stated
    yield from _comment(
        f"{candidate.reason}. Least static multiplier {candidate.multiplier:.3g}{_runners_up(candidate)}."
    )
    yield f"[mechanisms.{candidate.name}]"
    yield f"label = {_text(str(candidate.title))}"
    yield f'kind = "{definition.kind}"'
    blocks = [[names[body] for body in block] for block in definition.blocks]
    yield f"blocks = {_value([block if len(block) > 1 else block[0] for block in blocks])}"
    yield from (f"{key} = {_value(value)}" for key, value in _keys(definition, names))
    entry = "" if building_type is None else candidate.examines.get(building_type, "")
    if entry in (open_entries or {}):
        yield from _comment(f"{entry}: not examined in full: {reason_of_entry((open_entries or {})[entry])}.")
        yield "examines = []"
    elif building_type is not None:
        yield f"examines = {_value(entry or [])}"
    loads = [load for load in definition.loads if isinstance(load, BodyLoad | OverburdenLoad)]  # all that they have
    rows = [_table(dict(_load_keys(load, names))) for load in loads]
    if len(rows) == 1:
        yield f"loads = [{rows[0]}]"
    elif rows:
        yield from ("loads = [", *(f"    {row}," for row in rows), "]")
    yield ""


def _keys(definition: BlockMechanism, names: Mapping[str, str]) -> Iterator[tuple[str, Any]]:
    """Yield the keys of a mechanism beside its blocks and loads."""
    if definition.neighbours:
        yield "between", [names[body] for body in definition.neighbours]
    if isinstance(definition, WedgedBlock):
        yield "wedges", [_wedge_keys(each, names) for each in definition.wedges]
    yield "direction", [round(each, 9) + 0.0 for each in definition.towards]
    if definition.sides is not None:
        yield "sides", definition.sides
    if isinstance(definition.cut, CutAngle):
        yield "cut", {"point": list(definition.cut.point), "angle": f"{degrees(definition.cut.angle):.6g} deg"}
    elif isinstance(definition.cut, float):
        yield "cut", f"{definition.cut:.6g} m"
    if isinstance(definition, TwoBlock) and definition.crack is not None:
        yield "crack", definition.crack
    if isinstance(definition, FourHinge):
        for key, hinges in (("hinges", definition.hinges), ("hinges_negative", definition.hinges_negative)):
            if isinstance(hinges, str):
                yield key, hinges
            elif hinges is not None:
                yield key, {letter: list(at) for letter, at in zip("ABCD", hinges, strict=True)}
        if isinstance(joints := definition.joints, RadialJoints):
            ends = {"first": f"{degrees(joints.first):.8g} deg", "last": f"{degrees(joints.last):.8g} deg"}
            yield "joints", {"centre": list(joints.centre), **ends, "count": joints.count}


def _wedge_keys(wedge: Wedge, names: Mapping[str, str]) -> Mapping[str, Any]:
    keys: dict[str, Any] = {"walls": [names[wall] for wall in wedge.walls], "angle": f"{degrees(wedge.angle):.6g} deg"}
    return keys if wedge.reach is None else keys | {"reach": f"{wedge.reach:.4g} m"}


def _load_keys(load: BodyLoad | OverburdenLoad, names: Mapping[str, str]) -> Iterator[tuple[str, Any]]:
    yield "kind", load.kind
    if isinstance(load, OverburdenLoad):
        yield "bodies", [names[body] for body in load.bodies]
        return
    yield "body", names[load.body]
    if load.role != "floor":
        yield "role", load.role
    if load.tolerance != BodyLoad.tolerance:
        yield "tolerance", f"{load.tolerance:.4g} m"
    if load.share is not None:
        yield "share", load.share
    if load.tied:
        yield "tied", True


LISTED_TIES = 2  # directions in which a mechanism is as weak


def _runners_up(candidate: Candidate) -> str:
    """Say how the same parts fail at a multiplier as low, as far as statics tell."""
    ties = [
        f"{each.multiplier:.3g} towards {_value([round(x, 3) + 0.0 for x in each.direction])}"
        for each in candidate.ties[:LISTED_TIES]
    ]
    ties += [f"and {more} more"] if (more := len(candidate.ties) - LISTED_TIES) > 0 else []
    return f"; as weak: {', '.join(ties)}" if ties else ""


def _report(candidates: Candidates, stated: Sequence[Candidate], building_type: BuildingType | None) -> Iterator[str]:
    """Yield whose list the report goes through, and what it says of mechanisms that no table here examines."""
    if building_type is None:
        return
    yield from ("[report]", f'building_type = "{building_type}"', "")
    yield "[report.not_examined]"
    found = unexamined_entries(candidates, building_type, stated={each.name for each in stated})
    yield from (f"{entry} = {_text(why)}" for entry, why in found.items())
    yield ""


def unexamined_entries(
    candidates: Candidates, building_type: BuildingType, *, stated: Collection[str]
) -> dict[str, str]:
    """Return why entries of the list of a type of building are not examined, or not in full, in the order of the list.

    What no class of mechanisms is for, and what the drawing does not show, is not examined either.

    Parameters
    ----------
    candidates : of the building
    building_type : whose list it is
    stated : names of the candidates that are examined
    """
    left_open = candidates.open_entries(building_type, stated=stated)
    sought = {row.examines.get(building_type) for row in CLASSES} | set(OTHER_ENTRIES)
    found: dict[str, str] = {}
    for item in CHECKLISTS[building_type]:
        if item.key in left_open:
            found[item.key] = reason_of_entry(left_open[item.key])
        elif not any(each.examines.get(building_type) == item.key for each in candidates if each.name in stated):
            known = NOT_SHOWN if item.key in sought else IN_PLANE if item.in_plane else NO_CLASS
            found[item.key] = NOT_SOUGHT.get(item.key, known)
    return found


NOT_SHOWN = "nothing of the kind is found on the drawing; where the building has none, name it under absent in [report]"
IN_PLANE = "damage of walls in their plane is no rocking mechanism, and is not looked for"
NO_CLASS = "not looked for: to be judged on the building; where it has none, name it under absent in [report]"
NOT_SOUGHT: Mapping[str, str] = {
    "two-way-bending": "not looked for: walls held on three or four sides break along inclined cracks, which no "
    "mechanism here has",
    "outer-leaf": "not looked for: whether leaves may part only a survey can tell",
}
"""Why an entry that no class of mechanisms is for is not looked for."""
OTHER_ENTRIES = ("facade", "nave-transverse", "transept-end")
"""Entries of the list of churches that walls answer, by which wall they are."""
LISTED_GAPS = 2  # of an entry; the comments at the end of the file list all of them


def reason_of_entry(entry: OpenEntry) -> str:
    """Say why an entry of the list of the report is not examined in full."""
    said = []
    if entry.found:
        values = [each.multiplier for each in entry.found if each.multiplier is not None]
        least = f", least static multiplier {min(values):.3g}" if values else ""
        said.append(f"found on the drawing ({len(entry.found)}){least}; to be assessed apart")
    gaps = texts_of(entry.gaps)
    said += [*gaps[:LISTED_GAPS], *([f"and {len(gaps) - LISTED_GAPS} more"] if len(gaps) > LISTED_GAPS else [])]
    return "; ".join(said)


def _unstated(candidates: Candidates, stated: Sequence[Candidate]) -> Iterator[str]:
    """Yield comments on what is found and has no table here, what is not looked for, and parts without a mechanism."""
    others = [each for each in candidates if each not in stated]
    if others:
        yield "# Found, to be assessed by formula or by a drawing of its own: no table of this file states it."
    for each in others:
        number = f"least static multiplier {each.multiplier:.3g}" if each.multiplier is not None else each.found.why_not
        where = ", ".join(f"{name} {value}" for name, value in each.found.parameters.items())
        yield from _comment(f"- {each.title}: {number}{f' ({where})' if where else ''}.")
    for heading, gaps in (("Possible, and not looked for", candidates.gaps), ("Ruled out", candidates.ruled_out)):
        yield from [f"# {heading}:"] if gaps else []
        yield from (line for text in texts_of(gaps) for line in _comment(f"- {text}."))
    if candidates.without:
        yield "# Without a mechanism:"
    for message in candidates.without.values():
        yield from _comment(f"- {message}.")
    yield ""


RETURN_PERIODS = (
    '{ return_period = 50, a_g = "0.077 g", f_0 = 2.38, t_c_star = 0.28 }',
    '{ return_period = 475, a_g = "0.188 g", f_0 = 2.36, t_c_star = 0.33 }',
    '{ return_period = 975, a_g = "0.240 g", f_0 = 2.39, t_c_star = 0.34 }',
)
SURVEY = f"""\
# ---- To fill in from the survey: remove the # and write what was found -------------------------------------------
# The site, by its hazard; or peak_acceleration, f_0 and t_c_star of one limit state.
# [site.spectrum]
# code = "ntc2018"
# nominal_life = 50
# use_class = "II"
# soil = "B"             # and topography where it is not T1
# hazard = [{", ".join(RETURN_PERIODS)}]
# [procedures.ntc2018]
# knowledge_level = "LC1"
# A tie, and a bond of the side walls that was seen, go into the table of their mechanism:
#     loads = [{{ kind = "tie", force = "30 kN", at = [0, 0, 6], anchor = [0, 7, 6] }}]
#     side_walls = {{ bond = "toothed", course = "0.25 m", overlap = "0.12 m", thickness = "0.5 m" }}"""
WHO_SAYS = """\
# Who says that the masonry does not fall apart, what carries and ties roofs, and where walls crack; when, by what test.
# [report.sources]"""
SOURCE = '"measured: …, by whom and when"'


def _survey(structure: Structure, stated: Sequence[Candidate], likely: BuildingType) -> Iterator[str]:
    """Yield the block to be filled in, and the materials, which end it."""
    seen: dict[str, Part] = {}
    for part in structure.parts:
        seen.setdefault(_material(part), part)
    yield SURVEY
    if number_of_storeys(structure) is None:
        yield "# The storeys above the ground, which the drawing does not tell, go into [building]:"
        yield "#     storeys = 2"
    if structure.is_one_shell:
        yield "# The kind of building, which one shell does not tell: house or church. Its list is open then: say what"
        yield '# each mechanism examines with examines = "…" in its table.'
        yield "# [report]"
        yield f'# building_type = "{likely}"'
    yield from _to_be_seen(stated)
    yield WHO_SAYS
    masonry = [name for name, part in seen.items() if part.kind not in COVERINGS]
    yield from (f'# "materials.{name}.disintegration" = {SOURCE}' for name in masonry)
    for each in stated:
        loads = each.definition.loads if each.definition is not None else ()
        keys = ["wedges"] if isinstance(each.definition, WedgedBlock) else []
        for number, load in enumerate(loads, start=1):
            known = [key for key in ("tied", "share") if isinstance(load, BodyLoad) and getattr(load, key) is not None]
            keys += [f"loads[{number}].{key}" for key in known]
        yield from (f'# "mechanisms.{each.name}.{key}" = {SOURCE}' for key in keys)
    yield "# The masonry: its density where it is assumed, and whether it may fall apart."
    for name, part in seen.items():
        yield f"[materials.{name}]"
        yield f'density = "{part.density:.6g} kg/m^3"{"" if part.density_stated else "  # assumed"}'
        if part.kind not in COVERINGS:
            yield '# disintegration = "excluded"'
        yield ""


def _to_be_seen(stated: Sequence[Candidate]) -> Iterator[str]:
    """Yield what of cracks and levels only a survey can tell, where mechanisms hang on it."""
    wedged = [each.name for each in stated if isinstance(each.definition, WedgedBlock)]
    if wedged:
        yield "# The cracks of wedges, 0 to 30 deg from the vertical as is weakest here: as they were seen, in"
        yield f"#     wedges of {first_names(wedged, LISTED_NAMES)}"
    inclined = [each for each in stated if each.kind == "apse"]
    for each in inclined:
        yield "# The direction in which an apse falls, the weakest here, and its crack: as they were seen, in"
        yield f"#     direction and cut of {each.name}"
    if any(each.kind == "overturning" for each in stated):
        yield "# Storeys whose floors are not drawn: a wall may crack at each level, so add what turns above it,"
        yield '#     cut = "3.1 m" in a table as those above'


LISTED_NAMES = 3  # mechanisms in a comment of the survey


def _comment(text: str, width: int = 116) -> Iterator[str]:
    """Yield a text as lines of comment, without what TOML allows in none: names of models hold anything."""
    line = ""
    for word in "".join(letter if letter.isprintable() else " " for letter in text).split():
        if line and len(line) + len(word) + 1 > width:
            yield f"# {line}"
            line = "  " * text.startswith("- ")
        line = f"{line} {word}" if line.strip() else line + word
    yield f"# {line}"


def _text(text: str) -> str:
    """Write a text as TOML does, which quotes as JSON does, and DEL too."""
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def _table(values: Mapping[str, Any]) -> str:
    return "{ " + ", ".join(f"{key} = {_value(value)}" for key, value in values.items()) + " }"


def _value(value: Any) -> str:
    """Write a value as TOML does."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return _text(value)
    if isinstance(value, Mapping):
        return _table(value)
    if isinstance(value, Sequence):
        return "[" + ", ".join(map(_value, value)) + "]"
    return repr(value) if isinstance(value, int) else f"{value:.10g}"


def write_project(
    models: Sequence[Path], folder: Path, *, unit: str | None = None, up: Up | None = None
) -> tuple[Structure, Candidates]:
    """Read a building and write its project into a new folder, completely or not at all, with copies of its models.

    Parameters
    ----------
    models : files of one building
    folder : to create
    unit, up : of the files, as project files write them; the files' own where None

    Returns
    -------
    The building and its mechanisms

    Raises
    ------
    GeometryError : a model cannot be read, or nothing in it is masonry
    ProjectError : the folder is not empty, or two models have one name
    """
    if len({model.name for model in models}) < len(models):
        raise ProjectError(f"{models[-1]}: another model has its name, and both are copied into {folder}; rename one")
    with new_folder(folder, command="assess new") as made:
        structure = read_structure(models, unit=None if unit is None else length_of_unit(unit), up=up)
        if all(part.kind in (*COVERINGS, "tie") for part in structure.parts):
            found = ", ".join(f"{part.name} ({part.kind})" for part in structure.parts[:LISTED])
            raise GeometryError(
                f"{models[0]}: nothing in it stands, as a wall, a pier, an arch or a tower does: of "
                f"{len(structure.parts)} parts it has {found}; give the model of the masonry"
            )
        candidates = _mechanisms_of(structure, models[0], up)
        drawn = draw_project(structure, candidates, title=models[0].stem, unit=unit, up=up)
        for path, solid in drawn.meshes.items():
            (made / path).parent.mkdir(exist_ok=True)
            (made / path).write_bytes(ply(ClosedSurface(solid.vertices, solid.triangles)))
        for model in models:
            shutil.copyfile(model, made / model.name)
        (made / PROJECT).write_text(drawn.text, encoding="utf-8", newline="\n")
        name_schema(made, PROJECT)
    return structure, candidates


def _mechanisms_of(structure: Structure, model: Path, up: Up | None) -> Candidates:
    """Return the mechanisms of a building; where it cannot be cut as buildings are, it may lie on its side."""
    try:
        return structure.mechanisms()
    except GeometryError as error:
        stated = f"--up {up} is stated" if up else "--up is not stated"
        unit = " and the unit (--unit)" if model.suffix.lower() in WITHOUT_UNIT else ""
        cure = f"check which axis points up ({stated}){unit}"
        raise GeometryError(f"{model}: its parts do not stand as those of a building do ({error}); {cure}") from None
