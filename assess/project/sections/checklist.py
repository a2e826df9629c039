"""The list of mechanisms that a building of its type can have: examined, absent, or possible and not examined."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from difflib import get_close_matches

from assess.codes.checklists import CHECKLISTS, BuildingType, PossibleMechanism, possible_mechanism
from assess.project.section import wrong
from assess.project.sections.cuts import CutAngle, CutPlane
from assess.project.sections.mechanisms import Mechanism, SingleBlock, TwoBlock
from assess.project.sections.report import Report
from assess.results import ChecklistItem

Key = tuple[str | int, ...]


def checklist(report: Report, mechanisms: Mapping[str, Mechanism]) -> tuple[ChecklistItem, ...]:
    """Return every item of the list of the building's type, with what became of it; empty without a type.

    An item that some mechanisms examine and `not_examined` names too is examined in part: it counts as not examined.

    Parameters
    ----------
    report : the section of the project file
    mechanisms : of the project, by name

    Raises
    ------
    ProjectError
        An item is not in the list, is named twice, or is absent and yet examined.
    """
    building_type = report.building_type
    if building_type is None:
        _no_items(report, mechanisms)
        return ()
    examined = _examined(building_type, mechanisms)
    absent = _absent(report, building_type, examined)
    reasons = _reasons(report, building_type, absent)
    return tuple(_item(each, examined, absent, reasons) for each in CHECKLISTS[building_type])


def _item(
    item: PossibleMechanism, examined: Mapping[str, Sequence[str]], absent: Sequence[str], reasons: Mapping[str, str]
) -> ChecklistItem:
    names = tuple(examined.get(item.key, ()))
    if item.key in reasons:
        return ChecklistItem(item.key, item.number, "not-examined", names, reasons[item.key])
    if names:
        return ChecklistItem(item.key, item.number, "examined", names)
    if item.key in absent:
        return ChecklistItem(item.key, item.number, "absent")
    return ChecklistItem(item.key, item.number, "not-examined", spoken_for=False)


def _no_items(report: Report, mechanisms: Mapping[str, Mechanism]) -> None:
    """Refuse items of a list where the file does not say which list."""
    named: dict[Key, object] = {("report", "absent"): report.absent, ("report", "not_examined"): report.not_examined}
    named |= {("mechanisms", name, "examines"): each.examines for name, each in mechanisms.items()}
    for key, items in named.items():
        if items:
            raise wrong(key, 'names items of no list; write building_type = "house" or "church" in [report]')


def _examined(building_type: BuildingType, mechanisms: Mapping[str, Mechanism]) -> dict[str, list[str]]:
    """Return the names of the mechanisms that examine each item."""
    found: dict[str, list[str]] = {}
    for name, mechanism in mechanisms.items():
        given = mechanism.examines
        for key in _by_kind(building_type, mechanism) if given is None else given:
            where: Key = ("mechanisms", name, "examines")
            item = _known(building_type, key, where)
            if item.in_plane:
                raise wrong(where, f'"{item.key}": no mechanism here is of damage in the plane of walls; remove it')
            if name in found.setdefault(item.key, []):
                raise wrong(where, f'"{item.key}" stands there twice, by number and by key; remove one')
            found[item.key].append(name)
    return found


def _by_kind(building_type: BuildingType, mechanism: Mechanism) -> tuple[str, ...]:
    """Return the item that the kind of a mechanism tells: of houses, for one wall above a level crack or its base."""
    if building_type != "house":
        return ()
    if isinstance(mechanism, TwoBlock):
        return ("vertical-bending",)
    inclined = isinstance(mechanism, SingleBlock) and isinstance(mechanism.cut, CutPlane | CutAngle)
    if isinstance(mechanism, SingleBlock) and len(mechanism.blocks[0]) == 1 and not inclined:
        return ("simple-overturning",)
    return ()


def _absent(report: Report, building_type: BuildingType, examined: Mapping[str, Sequence[str]]) -> list[str]:
    where: Key = ("report", "absent")
    keys = [_known(building_type, key, where).key for key in report.absent]
    for place, key in enumerate(keys):
        if key in keys[:place]:
            raise wrong(where, f'"{key}" stands there twice, by number and by key; remove one')
        if key in examined:
            of = f"mechanisms.{examined[key][0]}"
            raise wrong(where, f'"{key}" is what {of} examines; remove it, or give {of} other items in `examines`')
    return keys


def _reasons(report: Report, building_type: BuildingType, absent: Sequence[str]) -> dict[str, str]:
    """Return why items are not examined, by their keys."""
    found: dict[str, str] = {}
    for written, reason in report.not_examined.items():
        where: Key = ("report", "not_examined", written)
        key = _known(building_type, written, where).key
        if not reason.strip():
            raise wrong(where, 'no reason; write why it was not examined, like "no access"')
        if key in found:
            raise wrong(where, f'"{key}" stands there twice, by number and by key; remove one')
        if key in absent:
            raise wrong(where, f'"{key}" stands in `absent` too; remove it there or here')
        found[key] = reason
    return found


def _known(building_type: BuildingType, key: str, where: Key) -> PossibleMechanism:
    found = possible_mechanism(building_type, key)
    if found is None:
        raise wrong(where, f'"{key}" is none of the list for a {building_type}; {_remedy(building_type, key)}')
    return found


def _remedy(building_type: BuildingType, key: str) -> str:
    near = get_close_matches(key, list(_keys(building_type)), n=1)
    if near:
        return f'did you mean "{near[0]}"?'
    numbers = ", or a number from 1 to 28" if building_type == "church" else ""
    return f"known: {', '.join(_keys(building_type))}{numbers}"


def _keys(building_type: BuildingType) -> Iterator[str]:
    yield from (each.key for each in CHECKLISTS[building_type])
