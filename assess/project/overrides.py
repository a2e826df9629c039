"""The values of a project file that may help a wall, and what a run takes where no source vouches for them.

What stands in place of a value is declared beside its key (`assess.declaration.Evidence.safe`); here it is looked up
for each key that the file gives. Whether the value helps is found by assessing the wall with both.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache, partial
from itertools import islice

import numpy as np

from assess.codes.context import default_period
from assess.codes.ntc2018_clauses import FreeElement, free_period
from assess.codes.procedures import PROCEDURES
from assess.codes.question import methods_of
from assess.codes.verdict import SAME_MARGIN
from assess.declaration import Drawn, Evidence, Range, Safe
from assess.errors import AssessError
from assess.geometry.solid import Solids
from assess.project import sections
from assess.project.key_errors import KeyPath, key_text, look_up, value_text
from assess.project.keys import Setting, dependents, value_at, with_values
from assess.project.project_file import Project, load_tree
from assess.project.question import basis_of
from assess.project.section import ProjectSection, field_marks, plain_data
from assess.project.units import QuantityKind
from assess.study.states import STRUCK_OUT
from assess.study.study import Replaceable, Study, follows_motion
from spectra.errors import SpectrumError

SAME_MULTIPLIER = 1.0 - 1.0 / 1.1  # of a direction or crack: no more than 10 % above that of the weakest
NEAR_TOP = 0.98  # of the height of a wall: its crack where nothing presses on it
StudyAt = Callable[[Setting], Callable[[str], Study]]
RIGID = 33.0  # Hz: above it a structure moves as the ground (ASCE 4), and no more is tried
ONE_MODE = 2.0 / 3.0  # of the height: the resultant of a linear mode of even mass (Circolare 7/2019, C7.2.10)


def replaceables_of(project: Project, solids: Solids, study: Study, *, study_at: StudyAt) -> tuple[Replaceable, ...]:
    """Return every value of a project that something stands for, in the order of the file.

    Parameters
    ----------
    project : as read
    solids : its bodies by name, None without geometry
    study : of the project
    study_at : returns what builds the study of each mechanism with other values at some keys
    """
    content = project.content
    touching = {each.name: each.adjacent_bodies for each in study.mechanisms}
    methods = methods_of(study.question)
    found = []
    for path, (evidence, symbol) in _keys_as_written(project).items():
        if not _bears_on(path, methods, content, study):
            continue
        source = content.report.source_of(".".join(map(str, path)))
        own = path[:2] if path[0] == "mechanisms" else path  # another that states the same bar has values of its own
        changed = dependents(content, own, touching=touching)
        first = 1 if source else None  # of a range that is all that is tried beside a value with a source
        for each in islice(_substitutes(path, evidence, symbol, content, solids, study, study_at), first):
            found.append(
                Replaceable(
                    key=key_text(path),
                    value=value_text(look_up(project.raw, path)[1]),
                    instead=each.words,
                    source=source,
                    is_value=each.is_value,
                    either_way=evidence.helps == "either",
                    of_range=isinstance(evidence.safe, Range),
                    same=SAME_MULTIPLIER if evidence.safe is Safe.WEAKEST else SAME_MARGIN,
                    mechanisms=changed,
                    place=next(iter(each.setting)),
                    setting=each.setting,
                    study_at=_built_once(partial(study_at, each.setting)),
                )
            )
    return (*found, *_struck_out(project, study_at))


def _struck_out(project: Project, study_at: StudyAt) -> Iterator[Replaceable]:
    """Yield each mechanism of the file that is struck out, by its reason: its outcome if examined is listed."""
    for name, reason in project.content.report.struck_out.items():
        path: KeyPath = (*STRUCK_OUT, name)
        setting = {path: Safe.ABSENT}
        if name in project.raw["mechanisms"]:
            yield Replaceable(
                key=key_text(path),
                value="struck out",
                instead="examined",
                source=reason,
                is_value=False,
                either_way=False,
                of_range=False,
                same=SAME_MARGIN,
                mechanisms=(name,),
                place=path,
                setting=setting,
                study_at=_built_once(partial(study_at, setting)),
            )


def _keys_as_written(project: Project) -> Mapping[KeyPath, tuple[Evidence, str]]:
    """Return each key that the file gives, as it stands there, with the symbol of its unit in SI, which may be empty.

    One number may stand for both directions.
    """
    found: dict[KeyPath, tuple[Evidence, str]] = {}
    for path, evidence, symbol in given_keys(project.content, ()):
        written = path
        while not look_up(project.raw, written)[0]:
            written = written[:-1]
        found.setdefault(written, (evidence, symbol))
    return found


def replace_values(project: Project, values: Sequence[Replaceable]) -> Project:
    """Return the project as a file says it that has other values at these keys; what is replaced is not uncertain."""
    rising = sorted(
        values, key=lambda each: len(each.setting)
    )  # what a load that is left out brings with it comes last
    setting = {place: value for each in rising for place, value in each.setting.items()}
    uncertain = tuple(
        each for each in project.uncertain if not any(each.path[: len(place)] == place for place in setting)
    )
    sampled = project.content.analysis.uncertainty
    if project.uncertain and not uncertain and sampled is not None and sampled.thickness is None:
        setting[("analysis", "uncertainty")] = Safe.ABSENT
    raw = dict(with_values(project.raw, setting, project.content))
    found = load_tree(raw, project.path, sha256=project.sha256)
    return replace(found, uncertain=uncertain, messages=project.messages)


def given_keys(table: ProjectSection, path: KeyPath) -> Iterator[tuple[KeyPath, Evidence, str]]:
    """Yield each key that the file gives in a table or below it: who vouches for its value, its unit's SI symbol."""
    for name, field, evidence, symbol in _declared_keys(type(table)):
        if field not in table.model_fields_set:
            continue
        value = getattr(table, field)
        if evidence is not None:
            entries = tuple((entry,) for entry in value) if isinstance(value, Mapping) else ((),)
            yield from (((*path, name, *entry), evidence, symbol) for entry in entries)
        yield from _below((*path, name), value)


@cache
def _declared_keys(kind: type[ProjectSection]) -> tuple[tuple[str, str, Evidence | None, str], ...]:
    """Return each key of a kind of table: the name of its field, who vouches for its value, its unit's SI symbol."""
    evidence = kind.evidence_of_keys()
    found = []
    for name, field in kind.model_fields.items():
        symbols = {mark.symbol for mark in field_marks(field) if isinstance(mark, QuantityKind)}
        key = field.alias or name
        found.append((key, name, evidence.get(key), symbols.pop() if len(symbols) == 1 else ""))
    return tuple(found)


def _built_once(build: Callable[[], Callable[[str], Study]]) -> Callable[[str], Study]:
    """Return what builds the study of each mechanism by content that is read at the first of them."""
    read = cache(build)
    return lambda mechanism: read()(mechanism)


def _bears_on(path: KeyPath, methods: Sequence[str], content: sections.Content, study: Study) -> bool:
    """Return whether a key can bear on the methods that decide.

    Records bear on histories, options of a code on its own methods, modulus and strength of a masonry where joints have
    their stiffness or strength by it, the modulus also where the motion passes a first mode that it gives.
    """
    if path[0] == "records":
        return any(map(follows_motion, methods))
    if path[-1] in ("young_modulus", "compressive_strength"):
        chains = (each for each in content.mechanisms.values() if isinstance(each, sections.ChainSection))
        joints = [joint for each in chains for joint in (each.interface, *each.interfaces.values())]
        if path[-1] == "young_modulus":
            of_mode = any(map(follows_motion, methods)) and any(each.by_stiffness for each in study.amplified.values())
            return of_mode or any(joint.course_thickness is not None for joint in joints)
        return any(joint.model != "rigid" and joint.strength is None for joint in joints)
    if path[0] != "procedures":
        return True
    options = {PROCEDURES[name].options.replace("_", "-") for name in methods}
    return path[1] in options


def _below(path: KeyPath, value: object) -> Iterator[tuple[KeyPath, Evidence, str]]:
    if isinstance(value, ProjectSection):
        yield from given_keys(value, path)
    elif isinstance(value, Mapping):
        for name, each in value.items():
            yield from _below((*path, name), each)
    elif isinstance(value, tuple):
        for place, each in enumerate(value):
            yield from _below((*path, place), each)


@dataclass(frozen=True)
class _Substitute:
    """What the file says in place of a value, first at the place that is changed; and in words."""

    setting: Setting
    words: str

    @property
    def is_value(self) -> bool:
        """Whether the words are a value."""
        return not isinstance(next(iter(self.setting.values())), Safe)


def _substitutes(
    path: KeyPath,
    evidence: Evidence,
    symbol: str,
    content: sections.Content,
    solids: Solids,
    study: Study,
    study_at: StudyAt,
) -> Iterator[_Substitute]:
    """Yield what stands in place of a value: several of a range; none where the value does not help."""
    if isinstance(evidence.safe, Range):
        yield from _values_of_range(path, evidence.safe, content, study_at)
    elif setting := _setting(path, evidence, content, solids, study):
        value = next(iter(setting.values()))
        yield _Substitute(setting, evidence.instead if isinstance(value, Safe) else _value_text(value, symbol))


def _setting(
    path: KeyPath, evidence: Evidence, content: sections.Content, solids: Solids, study: Study
) -> Setting | None:
    """Return what stands in place of a value; None where nothing does, or where the value does not help."""
    safe = evidence.safe
    if safe is Safe.STATED:
        return None
    if safe is Safe.WEAKEST:
        weakest = _weakest(path, content, study)
        return (
            None
            if weakest is None
            else {path: weakest, **_side_walls_behind(path, content), **_crack_ahead(path, study)}
        )
    if safe is Safe.WITHOUT:
        return {path[:-1]: Safe.ABSENT, **_crack_without(path, content, solids)}
    given = value_at(content, path)
    if isinstance(safe, Drawn):
        find, same = DRAWN[safe.name]
        drawn = find(content, solids)
        helps = drawn is not None and (given > same * drawn if evidence.helps == "up" else given < same * drawn)
        return {path: drawn} if helps else None
    if isinstance(safe, float):
        helps = given > safe if evidence.helps == "up" else given < safe
        return {path: safe} if helps else None
    if safe is Safe.FIRST:
        least = evidence.helps[0]
        return None if given == least else {path: least}
    return {path: safe}


def _values_of_range(path: KeyPath, safe: Range, content: sections.Content, study_at: StudyAt) -> Iterator[_Substitute]:
    """Yield the values of a range but the one stated, and what lies between that and its far end.

    These are even in ratio where there is one, else in difference.
    """
    given = value_at(content, path)
    for each in safe.values:
        if each.value != given:
            beside = {(*path[:-1], key): value for key, value in each.beside}
            yield _Substitute({path: each.value, **beside}, each.words or _value_text(each.value))
    if not safe.up_to:
        return
    find, unit, has_end = FAR_ENDS[safe.up_to]
    size, end = _size_of(given), find(path, content, study_at)
    if unit == "Hz" and size is not None and end is not None:
        size, end = min(size, RIGID), min(end, RIGID)
    if size is not None and end is not None and size != end:
        spaced = np.geomspace if size > 0.0 and end > 0.0 else np.linspace
        for value in map(float, spaced(size, end, safe.between + 2)[1 : None if has_end else -1]):
            yield _Substitute({path: value}, f"{value:.4g} {unit}".strip())


def _size_of(given: object) -> float | None:
    """Return the number that stands at a key: a period as its element has it, a restitution as of one direction."""
    if isinstance(element := plain_data(given), FreeElement):
        return free_period(element).value
    one_of_two = getattr(given, "positive", given)
    return float(one_of_two) if isinstance(one_of_two, int | float) else None


def _crack_without(path: KeyPath, content: sections.Content, solids: Solids) -> Setting:
    """Return the crack of a wall without one of its loads: the weakest, near the very top where no load is left.

    Without load or tension eq. 3.27 and the least multiplier both put the crack at the top (`assess.model.walls`).
    """
    if path[0] != "mechanisms":
        return {}
    section = content.mechanisms[str(path[1])]
    by_formula = section.kind == "two-block" and section.hinges is None and len(section.blocks) == 1
    if not by_formula or isinstance(section.crack, float):
        return {}
    wall = solids[section.blocks[0][0]]
    if len(section.loads) > 1 or wall is None:
        return {(*path[:2], "crack"): "minimum"}
    low, high = (float(level) for level in (wall.vertices[:, 2].min(), wall.vertices[:, 2].max()))
    return {(*path[:2], "crack"): low + NEAR_TOP * (high - low)}


def _side_walls_behind(path: KeyPath, content: sections.Content) -> Setting:
    """Leave out the side walls of a wall whose direction changes: they stand behind it as seen along the stated one."""
    section = content.mechanisms[str(path[1])]
    there = path[-1] == "direction" and getattr(section, "side_walls", None) is not None
    return {(*path[:2], "side_walls"): Safe.ABSENT} if there else {}


def _crack_ahead(path: KeyPath, study: Study) -> Setting:
    """Let an inclined crack begin ahead in the direction that is weaker, at the height that it is stated at."""
    found = (each.weaker_crack for each in study.mechanisms if path[-1] == "direction" and each.name == path[1])
    begins = next(found, None)
    return {} if begins is None else {(*path[:2], "cut", "point"): list(begins)}


def _weakest(path: KeyPath, content: sections.Content, study: Study) -> list[float] | str | None:
    """Return the direction or the crack of least multiplier; None where the stated one may stand."""
    if path[-1] == "direction":
        weaker = next((each.weaker for each in study.mechanisms if each.name == path[1]), None)
        return None if weaker is None else list(weaker)
    return "minimum" if isinstance(value_at(content, path), float) else None


PREFIXES = (("G", 1e9), ("M", 1e6), ("k", 1e3), ("", 0.0))


def _value_text(value: object, symbol: str = "") -> str:
    """Write a value in place of another as the file would, such as "1 MPa"; symbol: of its unit in SI."""
    if not isinstance(value, float):
        return str(value).lower() if isinstance(value, bool) else str(value)
    prefix, size = next(each for each in PREFIXES if abs(value) >= each[1] or not each[1])
    scaled = symbol.startswith(("Pa", "N")) and size > 0.0
    return f"{value / size if scaled else value:.4g} {prefix if scaled else ''}{symbol}".strip()


def _drawn_height(content: sections.Content, solids: Solids) -> float | None:
    """Return the height of the highest body, and of mechanisms drawn alone, above the ground [m]; None if unknown."""
    ground = 0.0 if content.building is None else content.building.ground_elevation or 0.0
    tops = [float(solid.vertices[:, 2].max()) - ground for solid in solids.values() if solid is not None]
    for mechanism in content.mechanisms.values():
        if not isinstance(mechanism, sections.ChainSection):
            tops.append(mechanism.elevation)
        elif mechanism.base_elevation is not None:
            own = [solids[name] for block in mechanism.blocks for name in block]
            levels = [level for solid in own if solid is not None for level in solid.vertices[:, 2]]
            tops.append(mechanism.base_elevation + float(max(levels) - min(levels)) if levels else 0.0)
    return max(tops, default=0.0) or None


def _resultant_height(content: sections.Content, solids: Solids) -> float | None:
    """Return the height of the resultant of a linear first mode [m]; None where no height is known."""
    drawn, stated = _drawn_height(content, solids), None if content.building is None else content.building.height
    known = [each for each in (drawn, stated) if each is not None]
    return ONE_MODE * min(known) if known else None


def _code_period(path: KeyPath, content: sections.Content, study_at: StudyAt) -> float | None:
    """Return the first period of the building by the code [s]; None where its height is not known."""
    height = None if content.building is None else content.building.height
    return None if height is None else default_period(height)


def _code_frequency(path: KeyPath, content: sections.Content, study_at: StudyAt) -> float | None:
    """Return the first frequency of the building by the code [Hz]; None where its height is not known."""
    period = _code_period(path, content, study_at)
    return None if period is None else 1.0 / period


def _own_frequency(path: KeyPath, content: sections.Content, study_at: StudyAt) -> float | None:
    """Return the first frequency that a mechanism has by [building] or Rayleigh's method, else by the code [Hz]."""
    study = _built_without(path, study_at)
    mode = None if study is None else getattr(study.amplified[str(path[1])].amplification, "mode", None)
    return _code_frequency(path, content, study_at) if mode is None else float(mode.frequency)


def _restitution_by_formula(path: KeyPath, content: sections.Content, study_at: StudyAt) -> float | None:
    """Return the restitution of the formula [-], of the positive direction where one number stands for both."""
    study = _built_without(path, study_at)
    return None if study is None else study.mechanisms[0].restitution[path[-1] == "negative"]


def _built_without(path: KeyPath, study_at: StudyAt) -> Study | None:
    """Return the study of a mechanism without one of its keys; None where it cannot be built."""
    try:
        return study_at({path: Safe.ABSENT})(str(path[1]))
    except (AssessError, SpectrumError):
        return None


def _rest(path: KeyPath, content: sections.Content, study_at: StudyAt) -> float:
    """Return the period of what is rigid until it lifts off [s]."""
    return 0.0


FAR_ENDS: Mapping[str, tuple[Callable[[KeyPath, sections.Content, StudyAt], float | None], str, bool]] = {
    "period": (_code_period, "s", False),
    "frequency": (_code_frequency, "Hz", True),
    "own frequency": (_own_frequency, "Hz", True),
    "restitution": (_restitution_by_formula, "", False),
    "rigid": (_rest, "s", False),
}
"""What gives the far end of a range that begins at the stated value, by its name; its unit; whether it is tried itself,
as it is not what stands where the key is absent."""


def _lowest_foot(content: sections.Content, solids: Solids) -> float | None:
    """Return the elevation of the foot of the lowest body [m]; None without geometry."""
    return min((float(solid.vertices[:, 2].min()) for solid in solids.values() if solid is not None), default=None)


def _shortest_records(content: sections.Content, solids: Solids) -> float | None:
    """Return the least duration of artificial records [s]."""
    basis = basis_of(content)
    return 20.0 if basis is not None and basis.name == "asce43-05" else 25.0


DRAWN: Mapping[str, tuple[Callable[[sections.Content, Solids], float | None], float]] = {
    "height": (_drawn_height, 1.1),
    "ground": (_lowest_foot, 1.0),
    "resultant": (_resultant_height, 1.0),
    "duration": (_shortest_records, 1.0),
}
"""What the drawing gives, by its name, and the factor on it up to which a typed value is the same."""
