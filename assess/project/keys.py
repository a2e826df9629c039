"""The numbers of a project file by their keys: found, given other values by a sweep, given with their scatter.

A sweep, [analysis.sweep], is one whole project file for each of its values: the value is put at its key in what the
file says and the whole is read through the schema again, so a case is checked like any project. Of a number given as
{ mean, cov } the schema sees the mean alone, so that whatever does not ask for the scatter uses that. What pydantic
finds becomes one line for the engineer: key, value, what is wrong and the remedy.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from functools import cache, reduce
from math import inf, isclose, isfinite, sqrt
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from pydantic import ValidationError
from pydantic.fields import FieldInfo
from pydantic_core import ErrorDetails

from assess.declaration import BOUNDS, Number, OfWorks, Safe, Scatters, marks_of
from assess.errors import Faults, ProjectError, one_of_several
from assess.loads.load import bodies_of as loading_bodies
from assess.messages.message import escape_text
from assess.project.bars import same_bar, with_bars
from assess.project.key_errors import KeyPath, key_text, look_up, value_text
from assess.project.section import JUDGED, ProjectSection, UncertainNumber, field_marks
from assess.project.sections.analysis import SweepSection
from assess.project.sections.content import Content
from assess.project.sections.mechanisms import RestitutionSection
from assess.project.units import KINDS, QuantityError, QuantityKind, key_value, number_and_unit
from assess.results.provenance import count_from_0
from assess.results.run import Distribution, UncertainInput
from spectra.arrays import is_number

_NOT_SWEPT = (("analysis", "sweep"), ("analysis", "sensitivity"), ("analysis", "uncertainty"), ("format",), ("report",))
WrittenNumber = int | float | str
Marks = tuple[QuantityKind | None, Scatters | None, OfWorks | None, Number | None]
NO_MARKS: Marks = (None, None, None, None)
Setting = Mapping[KeyPath, Any]
"""Other values of numbers of a project, by their keys."""

WITHOUT_UNCERTAIN_NUMBERS = ("analysis", "report", "format")
"""Tables without numbers that may scatter."""


class KeyedValue(NamedTuple):
    """What stands at a key: the value as it was read, and what is known of it.

    kind : what it measures; uncertain : set where it may scatter; of_works : where works may change it
    number : its bounds
    """

    path: KeyPath
    value: Any
    kind: QuantityKind | None
    uncertain: Scatters | None = None
    of_works: OfWorks | None = None
    number: Number | None = None

    @property
    def is_number(self) -> bool:
        """Whether the key holds a number or could."""
        return self.kind is not None or is_number(self.value)


def keyed_values(content: Content) -> dict[str, KeyedValue]:
    """Return every key of the project, with dots and items of lists counted from 0, defaults included."""
    return {".".join(map(str, entry.path)): entry for entry in _keyed_values_below((), content, NO_MARKS)}


def stated_values(content: Content) -> Iterator[KeyedValue]:
    """Yield what stands at the keys that the file gives, and no default."""
    return _keyed_values_below((), content, NO_MARKS, stated=True)


def swept_value(key: str, by_key: Mapping[str, KeyedValue], *, where: str, others: Collection[str] = ()) -> KeyedValue:
    """Return what stands at the key that a sweep names; raise ProjectError if it does not exist or holds no number.

    Parameters
    ----------
    key : as it was typed
    by_key : every key of the project
    where : what an error begins with
    others : keys that might have been meant besides
    """
    entry = by_key.get(key) or by_key.get(count_from_0(key))
    if entry is not None and (entry.is_number or isinstance(entry.value, ProjectSection)):
        return entry
    what = "unknown key" if entry is None else "holds no number"
    raise ProjectError(f"{where}.key: {value_text(key)}: {what}; {_remedy(key, by_key, others)}")


def with_value(node: Any, path: Sequence[str | int], value: Any, resolved: Any) -> Any:
    """Return a copy of `node` with `value` at `path`; tables absent from the file are filled in from `resolved`."""
    if not path:
        return value
    step, *rest = path
    if isinstance(resolved, tuple):
        items = list(node) if isinstance(node, list) else list(_as_written(resolved))
        items[int(step)] = with_value(items[int(step)], rest, value, resolved[int(step)])
        return items
    table = dict(node) if isinstance(node, Mapping) else {} if node is None else dict(_as_written(resolved))
    table[str(step)] = with_value(table.get(str(step)), rest, value, _resolved_below(resolved, step))
    return table


def with_values(raw: Mapping[str, Any], setting: Setting, resolved: Content) -> Mapping[str, Any]:
    """Return what the file says with other values at some keys, and without those whose value is `Safe.ABSENT`.

    Parameters
    ----------
    raw : what the file says
    setting : the values by their keys
    resolved : the project as read, from which tables that the file leaves out are filled in
    """
    removed = [path for path, value in setting.items() if value is Safe.ABSENT]
    for path, value in setting.items():
        if value is not Safe.ABSENT and not any(path[: len(other)] == other for other in removed):
            raw = with_value(raw, path, value, resolved)
    outermost = [path for path in removed if not any(path[: len(other)] == other != path for other in removed)]
    for path in sorted(outermost, key=_places, reverse=True):
        raw = _without(raw, path)  # of a list the last first, so that the others keep their places
        sources = look_up(raw, ("report", "sources"))[1]
        if isinstance(sources, Mapping):
            raw = with_value(raw, ("report", "sources"), _sources_without(sources, path), resolved)
    return raw


def _places(path: KeyPath) -> tuple[int, ...]:
    return tuple(step for step in path if isinstance(step, int))


def _without(node: Any, path: Sequence[str | int]) -> Any:
    """Return a copy of `node` without what stands at `path`; the same where nothing does."""
    step, *rest = path
    if isinstance(node, list):
        place = int(step)
        return [*node[:place], *([_without(node[place], rest)] if rest else []), *node[place + 1 :]]
    if not isinstance(node, Mapping) or step not in node:
        return node
    below = {step: _without(node[str(step)], rest)} if rest else {}
    return {key: below.get(key, value) for key, value in node.items() if rest or key != step}


def _sources_without(sources: Mapping[str, str], path: KeyPath) -> dict[str, str]:
    """Return the sources of what is left without a key or entry: entries behind it in its list move up by one."""
    gone, before = ".".join(map(str, path)), "".join(f"{step}." for step in path[:-1])
    found = {}
    for given, text in sources.items():
        key = count_from_0(given)
        place, dot, rest = key.removeprefix(before).partition(".")
        if f"{key}.".startswith(f"{gone}."):
            continue
        if isinstance(path[-1], int) and key.startswith(before) and place.isdigit() and int(place) > path[-1]:
            given = f"{before[:-1]}[{place}]{dot}{rest}"
        found[given] = text
    return found


def value_at(content: Content, path: KeyPath) -> Any:
    """Return the validated value at a key."""
    return reduce(_step_down, path, content)


def dependents(
    content: Content, path: KeyPath, *, touching: Mapping[str, tuple[str, ...]] | None = None
) -> tuple[str, ...]:
    """Return the mechanisms that the value at `path` changes: those that use the body, material or bar, or all of them.

    Parameters
    ----------
    content : of the project
    path : of a key or a table
    touching : by mechanism, the bodies that touch it and so affect its direction and sides
    """
    bodies_touching = touching or {}
    table, *names = path
    if table == "mechanisms":
        stating = {names[0], *(other[1] for other in same_bar(tuple(path), content))}
        return tuple(name for name in content.mechanisms if name in stating)
    used = {name: _bodies_of_mechanism(mechanism, content) for name, mechanism in content.mechanisms.items()}
    if table == "bodies":
        return tuple(
            name
            for name, bodies in used.items()
            if names[0] in (*bodies, *bodies_touching.get(name, ())) or _carries_bodies(content.mechanisms[name])
        )
    if table == "materials":
        of = {name for name, body in content.bodies.items() if getattr(body, "material", None) == names[0]}
        return tuple(name for name, bodies in used.items() if bodies & of)
    return tuple(content.mechanisms)


@dataclass(frozen=True)
class ProjectVariant:
    """The project file with one value of a sweep: the number typed, the case named for errors, and what it says."""

    value: float
    name: str
    content: Content


@dataclass(frozen=True)
class KeySweep:
    """One sweep.

    where : the table, for errors; key : what is swept, as the user wrote it; path : its steps
    unit : of the values, as the user wrote it, or SI where they are plain numbers; "-" for none
    variants : one for each value, in the user's order
    has_typed : whether one of the values is that of the file itself
    """

    where: str
    key: str
    path: KeyPath
    unit: str
    variants: tuple[ProjectVariant, ...]
    has_typed: bool


def key_sweeps(content: Content, raw: Mapping[str, Any], folder: Path) -> tuple[KeySweep, ...]:
    """Return every sweep of the project, with the `content` read from the `raw` file in `folder`.

    Raises ProjectError for keys that are unknown or not a number, and of each sweep for the first case that breaks the
    schema.
    """
    sweeps = content.analysis.sweeps
    if not sweeps:
        return ()
    by_key = keyed_values(content)
    single = isinstance(content.analysis.sweep, SweepSection)
    names = ["analysis.sweep"] if single else [f"analysis.sweep[{i}]" for i in range(1, len(sweeps) + 1)]
    found, faults = [], Faults()
    for sweep, where in zip(sweeps, names, strict=True):
        if content.is_struck_out(sweep.key):
            continue
        with faults.gather():
            entry = swept_value(sweep.key, by_key, where=where)
            found.append(_key_sweep(sweep, entry, content, raw, folder, where=where))
    faults.raise_all()
    return tuple(found)


def read_case(setting: Setting, content: Content, raw: Mapping[str, Any], folder: Path, *, name: str = "") -> Content:
    """Read a project again with other values at some keys.

    content : as read from the `raw` file in `folder`
    name : of a case of one number, for errors; these say key and value if it is empty

    Raises ProjectError if the schema refuses the values.
    """
    raw = with_values(raw, setting, content)
    try:
        return Content.model_validate(raw, context={"folder": folder})
    except ValidationError as error:
        line = error_line(error, raw=raw)
        if name:
            path, value = next(iter(setting.items()))
            line = f"{name}: {line.removeprefix(f'{key_text(path)}: {value_text(value)}: ')}"
        raise ProjectError(line) from None


@dataclass(frozen=True)
class UncertainValue:
    """A number of the project that scatters.

    path : its key; given : its mean, scatter and group in SI; least, most : physical limits of its values over the mean
    """

    path: KeyPath
    given: UncertainInput
    least: float
    most: float


StatedUncertainNumbers = tuple[tuple[KeyPath, UncertainNumber], ...]


def take_means(raw: Mapping[str, Any], folder: Path, faults: Faults) -> tuple[dict[str, Any], StatedUncertainNumbers]:
    """Return what the file says with the mean in place of each uncertain number, and these numbers.

    A table with a mean that is none of an uncertain number is among the faults.
    """
    found: list[tuple[KeyPath, UncertainNumber]] = []

    def plain(value: Any, path: KeyPath) -> Any:
        if isinstance(value, list):
            return [plain(item, (*path, index)) for index, item in enumerate(value)]
        if not isinstance(value, Mapping):
            return value
        if not _is_uncertain(value):
            return {name: plain(item, (*path, name)) for name, item in value.items()}
        with faults.gather():
            found.append((path, _uncertain_number(value, path, raw, folder)))
        if "mean" not in value:
            faults.raise_all()  # there is nothing to read in its place
        return value["mean"]

    means = {name: table if name in WITHOUT_UNCERTAIN_NUMBERS else plain(table, (name,)) for name, table in raw.items()}
    return means, tuple(found)


def uncertain_values(content: Content, stated: StatedUncertainNumbers) -> tuple[UncertainValue, ...]:
    """Return the uncertain numbers of a project in SI.

    Raises ProjectError for a key whose number may not scatter, and for a scatter without meaning.
    """
    if not stated:
        return ()
    by_key, found, faults = keyed_values(content), [], Faults()
    for path, number in stated:
        with faults.gather():
            found.append(_uncertain_value(path, number, by_key, content))
    faults.raise_all()
    return tuple(found)


def covs_of(values: tuple[UncertainValue, ...]) -> dict[str, float]:
    """Return the coefficient of variation of each uncertain number, by its key written with dots."""
    return {".".join(map(str, value.path)): value.given.cov for value in values}


def error_line(error: ValidationError, *, raw: Mapping[str, Any]) -> str:
    """Return the first error as "key: value: what is wrong; remedy", and how many more the `raw` content has."""
    return str(one_of_several(ProjectError, list(_fault_lines(error, raw).values())))


def read_content(raw: Mapping[str, Any], folder: Path) -> Content:
    """Read all tables of a project; raise ProjectError with every fault of the `raw` file that shows beside others.

    A table with unknown or missing keys shows its wrong values when it is read again without the unknown ones. What
    must agree between bodies and mechanisms shows beside faults elsewhere when it is read without these tables.

    Parameters
    ----------
    raw : what the file says
    folder : of the file, to which its paths are relative
    """
    context: dict[str, Any] = {"folder": folder}
    try:
        return Content.model_validate(raw, context=context)
    except ValidationError as error:
        first = error
    lines = _fault_lines(first, raw)
    rest, judged, latest = raw, set[KeyPath](), first
    while keys := _tables_judged(latest, rest) - judged:
        rest = reduce(_without, (key for key in _unknown_keys(latest, rest)), rest)
        judged |= keys
        try:
            Content.model_validate(rest, context=context | {JUDGED: _identities(rest, judged)})
        except ValidationError as error:
            latest = error
        else:
            break
        lines |= {key: line for key, line in _fault_lines(latest, rest, judged).items() if key not in lines}
    if not any(key[0] in BUILT_OF for key in lines):
        alone = {name: table for name, table in rest.items() if name not in {key[0] for key in lines}}
        try:
            Content.model_validate(alone, context=context | {JUDGED: _identities(alone, judged)})
        except ValidationError as error:
            found = _fault_lines(error, alone, judged)
            lines |= {key: line for key, line in found.items() if key[0] in BUILT_OF and key[-1] != "examines"}
    raise one_of_several(ProjectError, list(lines.values()))


BUILT_OF = ("materials", "bodies", "mechanisms")
"""The tables that must agree with one another, and with no other but the list that [report] names."""


def _fault_lines(
    error: ValidationError, raw: Mapping[str, Any], judged: Collection[KeyPath] = ()
) -> dict[KeyPath, str]:
    """Return a line for each key with a fault: key, value, what is wrong and the remedy.

    judged : tables whose missing keys are known already
    """
    by_key: dict[KeyPath, ErrorDetails] = {}
    for found in error.errors(include_url=False):
        for each in (found, *_more_of_table(found)):
            key = _key_in_file(each, raw)
            told = each["type"] == "missing" and key[:-1] in judged
            if each["type"] != "default_factory_not_called" and not told:
                by_key.setdefault(key, each)
    lines = {}
    for key, first in by_key.items():
        if not any(_is_below(other, key) for other in by_key):
            known, value = look_up(raw, key)
            parts = [key_text(key), *([value_text(value)] if known else []), _sentence(first, known=known)]
            lines[key] = ": ".join(parts)
    return lines


def _more_of_table(error: ErrorDetails) -> Iterator[ErrorDetails]:
    for key, reason in error.get("ctx", {}).get("more", ()):
        yield {**error, "ctx": {"key": key, "reason": reason}}


def _tables_judged(error: ValidationError, raw: Mapping[str, Any]) -> set[KeyPath]:
    """Return the tables of which unknown and missing keys are among the faults of an error."""
    every = error.errors(include_url=False)
    return {_key_in_file(each, raw)[:-1] for each in every if "unknown" in each.get("ctx", {})}


def _unknown_keys(error: ValidationError, raw: Mapping[str, Any]) -> Iterator[KeyPath]:
    for each in error.errors(include_url=False):
        for key in each.get("ctx", {}).get("unknown", ()):
            yield (*_key_in_file(each, raw)[:-1], key)


def _identities(raw: Mapping[str, Any], tables: Iterable[KeyPath]) -> frozenset[int]:
    return frozenset(id(look_up(raw, table)[1]) for table in tables)


def _one_number(value: Any) -> bool:
    """Whether a key holds a number, or a table that spreads one number over its keys, like restitution."""
    if isinstance(value, ProjectSection):
        return all(is_number(item) for _, item in value)
    return is_number(value)


def _keyed_values_below(path: KeyPath, value: Any, marks: Marks, *, stated: bool = False) -> Iterator[KeyedValue]:
    """Yield every key below `path` that may be swept; stated: no default."""
    if path in _NOT_SWEPT:
        return
    if path:
        yield KeyedValue(path, value, *marks)
    if isinstance(value, ProjectSection):
        given = value.model_fields_set
        for name, key, below in _marks_of(type(value)):
            if not stated or name in given:
                yield from _keyed_values_below((*path, key), getattr(value, name), below, stated=stated)
    elif isinstance(value, dict):
        for name, item in value.items():
            yield from _keyed_values_below((*path, name), item, NO_MARKS, stated=stated)
    elif isinstance(value, tuple):
        for index, item in enumerate(value):
            yield from _keyed_values_below((*path, index), item, marks, stated=stated)


@cache
def _marks_of(table: type[ProjectSection]) -> tuple[tuple[str, str, Marks], ...]:
    """Return each field of a table with its key and the marks of that, which follow from its class."""
    keys = table.table_keys()
    return tuple((name, key, _marks(keys[key])) for name, key in table.names_and_keys())


def _marks(field: FieldInfo) -> Marks:
    """Return what a key says of itself by its type: its quantity, None if that is not unique, and further marks."""
    found = (*field.metadata, *marks_of(field.annotation))
    kinds = {each for each in found if isinstance(each, QuantityKind)}
    uncertain = next((each for each in found if isinstance(each, Scatters)), None)
    of_works = next((each for each in found if isinstance(each, OfWorks)), None)
    number = next((each for each in found if isinstance(each, Number)), None)
    return (kinds.pop() if len(kinds) == 1 else None), uncertain, of_works, number


def _remedy(key: str, by_key: Mapping[str, KeyedValue], others: Collection[str]) -> str:
    """Say what to write instead of a key that does not exist or holds no number."""
    table, _, last = key.rpartition(".")
    above = by_key.get(table)
    if last == "angle" and table.endswith(".cut") and above is not None and isinstance(above.value, float):
        return f'its cut is level: write cut = {{ point = [0, 0, {above.value:.6g}], angle = "0 deg" }} first'
    near = get_close_matches(key, [*(name for name, entry in by_key.items() if entry.is_number), *others], n=1)
    remedy = f'did you mean "{escape_text(near[0])}"?' if near else 'name one like "bodies.NAME.box.height"'
    return remedy + (" (loads.0 or loads[1] is the first of a list)" if ".loads" in key else "")


def _step_down(value: Any, step: str | int) -> Any:
    """Take one step down into validated content."""
    return value.entries()[str(step)] if isinstance(value, ProjectSection) else value[step]


def _resolved_below(value: Any, step: str | int) -> Any:
    """Take one step down into tables of validated content; None below what the project does not have yet."""
    tables = value.entries() if isinstance(value, ProjectSection) else value
    return tables.get(str(step)) if isinstance(tables, Mapping) else None


def _as_written(value: Any) -> Any:
    """Write validated content as a file would hold it."""
    if isinstance(value, ProjectSection):
        return {key: _as_written(item) for key, item in value.entries().items() if item is not None}
    if isinstance(value, Mapping):
        return {key: _as_written(item) for key, item in value.items()}
    return [_as_written(item) for item in value] if isinstance(value, tuple) else value


def _bodies_of_mechanism(mechanism: ProjectSection, content: Content) -> set[str]:
    """Return the bodies named anywhere in the table of a mechanism: as blocks, floors, overburden.

    With the plate of a tie all bodies: its far wall is the one in which the anchor lies, and others may hold it.
    """
    if any(getattr(load, "plate", None) is not None for load in getattr(mechanism, "loads", ())):
        return set(content.bodies)
    return set(_texts_in(mechanism)) & set(content.bodies)


def _carries_bodies(mechanism: ProjectSection) -> bool:
    """Whether bodies load the mechanism: what they rest on besides may be any other body of the project."""
    return any(map(loading_bodies, getattr(mechanism, "loads", ())))


def _texts_in(value: Any) -> Iterator[str]:
    if isinstance(value, str):
        yield value
    elif isinstance(value, ProjectSection | Mapping | tuple):
        table = value.entries() if isinstance(value, ProjectSection) else value
        for item in table.values() if isinstance(table, Mapping) else table:
            yield from _texts_in(item)


def _key_sweep(
    sweep: SweepSection, entry: KeyedValue, content: Content, raw: Mapping[str, Any], folder: Path, *, where: str
) -> KeySweep:
    variants, units = [], []
    for given in sweep.values or _values_in_range(sweep, where=where):
        name = f"{where}: {sweep.key} = {value_text(given)}"
        read = read_case(with_bars({entry.path: given}, content), content, raw, folder, name=name)
        if not _one_number(value_at(read, entry.path)):
            raise ProjectError(f"{name}: not a number; only numbers can be swept")
        number, unit = _number_and_unit_of(given, where=name)
        units.append(unit)
        if unit != units[0]:
            raise ProjectError(f"{name}: not in the unit of the first value; write all in one unit")
        variants.append(ProjectVariant(number, name, read))
    symbol = "-" if entry.kind is None else entry.kind.symbol.replace("no unit", "-")
    cases = tuple(variants)
    return KeySweep(where, sweep.key, entry.path, units[0] or symbol, cases, _has_typed(entry, cases))


def _has_typed(entry: KeyedValue, cases: Sequence[ProjectVariant]) -> bool:
    """Return whether one of the cases has the value of the file itself; a range is written to 12 figures."""
    swept = [value_at(case.content, entry.path) for case in cases]
    if is_number(entry.value):
        return any(is_number(each) and isclose(each, entry.value, rel_tol=1e-11) for each in swept)
    return entry.value in swept


def _values_in_range(sweep: SweepSection, *, where: str) -> tuple[WrittenNumber, ...]:
    """Return evenly spaced values in the unit of both ends."""
    assert sweep.start is not None  # the schema asks for all three
    assert sweep.to is not None
    assert sweep.count is not None
    low, unit = _number_and_unit_of(sweep.start, where=f"{where}.from: {value_text(sweep.start)}")
    high, other = _number_and_unit_of(sweep.to, where=f"{where}.to: {value_text(sweep.to)}")
    if unit != other:
        raise ProjectError(f"{where}.to: {value_text(sweep.to)}: not in the unit of from; write both in one unit")
    if low == high:
        raise ProjectError(f"{where}.to: {value_text(sweep.to)}: the same as from; give another, or values = [ … ]")
    numbers = [float(f"{number:.12g}") for number in np.linspace(low, high, sweep.count).tolist()]
    if isinstance(sweep.start, int) and isinstance(sweep.to, int) and all(map(float.is_integer, numbers)):
        return tuple(map(int, numbers))
    return tuple(f"{number:.12g} {unit}" if unit else number for number in numbers)


def _number_and_unit_of(value: WrittenNumber, *, where: str) -> tuple[float, str]:
    """Return the number and the unit that the user wrote."""
    if not isinstance(value, str):
        return float(value), ""
    try:
        number, unit = number_and_unit(value)
    except QuantityError as error:
        remedy = "" if "; write " in str(error) else "; write a number, or one with its unit"
        raise ProjectError(f"{where}: {error}{remedy}") from None
    return float(number), unit


def _is_uncertain(table: Mapping[str, Any]) -> bool:
    """Whether a table is meant as a number with its scatter; tables named "mean" are not."""
    return any(key in table and not isinstance(table[key], Mapping) for key in ("mean", "cov"))


def _uncertain_number(table: Mapping[str, Any], path: KeyPath, raw: Mapping[str, Any], folder: Path) -> UncertainNumber:
    try:
        return UncertainNumber.model_validate(table, context={"folder": folder})
    except ValidationError as error:
        line = error_line(error, raw=table)
        raise ProjectError(f"{key_text(path)}.{line}") from None


def _uncertain_value(
    path: KeyPath, number: UncertainNumber, by_key: Mapping[str, KeyedValue], content: Content
) -> UncertainValue:
    key, entry = key_text(path), by_key.get(".".join(map(str, path)))
    if entry is None or entry.uncertain is None:
        raise ProjectError(f"{key}: must be one number; only these may be {{ mean, cov }}: {_uncertain_keys()}")
    mean = _si_mean(content, path)
    if not isinstance(mean, float) or mean == 0.0 or not isfinite(mean):
        raise ProjectError(f"{key}.mean: {value_text(number.mean)}: no number to scatter about; write it without cov")
    kind = entry.kind or KINDS["ratio"]
    limits = entry.uncertain
    cov = number.cov if number.cov is not None else _cov_of_deviation(number, mean, kind, key)
    distribution: Distribution = number.distribution or ("normal" if limits.crosses_zero else "lognormal")
    if not limits.crosses_zero:
        _check_positive(distribution, cov, key)
    unit = kind.symbol.replace("no unit", "-")
    given = UncertainInput(key, unit, mean, cov, distribution, number.group or key)
    return UncertainValue(path, given, -inf if limits.crosses_zero else 0.0, limits.most / abs(mean))


def _uncertain_keys() -> str:
    """Write the keys whose numbers may scatter, by the innermost table that holds them."""
    from assess.project.evidence import every_key

    names: dict[str, dict[str, None]] = {}
    for key in every_key():
        if any(isinstance(mark, Scatters) for mark in field_marks(key.field)):
            *tables, name = [step.removesuffix("[]") for step in key.path.split(".") if step != "NAME"]
            names.setdefault(tables[-1], {})[name] = None
    return "; ".join(f"{', '.join(each)} of {table}" for table, each in names.items())


def _si_mean(content: Content, path: KeyPath) -> Any:
    """Return the number at a key [SI]; of a restitution that of both directions."""
    value = value_at(content, path)
    return value.positive if isinstance(value, RestitutionSection) else value


def _cov_of_deviation(number: UncertainNumber, mean: float, kind: QuantityKind, key: str) -> float:
    """Return the coefficient of variation of a number given by its standard deviation."""
    try:
        deviation = key_value(number.sd, kind)
    except QuantityError as error:
        raise ProjectError(f"{key}.sd: {value_text(number.sd)}: {error}") from None
    if not 0.0 < deviation < inf:
        raise ProjectError(f"{key}.sd: {value_text(number.sd)}: must be greater than 0; write the number without it")
    return deviation / abs(mean)


def _check_positive(distribution: Distribution, cov: float, key: str) -> None:
    """Refuse a scatter too large for a number that keeps its sign."""
    if cov >= 1.0:
        raise ProjectError(
            f"{key}.sd: {cov:.4g} times the mean: must be less than the mean of a number that keeps its sign"
        )
    if distribution == "uniform" and cov >= 1.0 / sqrt(3.0):
        remedy = "write less than 0.577, or another distribution"
        raise ProjectError(f"{key}.cov: {cov:.4g}: its lower bound, mean (1 - √3 cov), is beyond zero; {remedy}")


_SENTENCES: dict[str, Callable[[Mapping[str, Any]], str]] = {
    "literal_error": lambda c: "not allowed; write " + c["expected"].replace("'", '"'),
    "string_type": lambda c: "not a text; write it in quotes",
    "bool_type": lambda c: "not a truth value; write true or false",
    "int_type": lambda c: "not a whole number; write one without decimal point",
    "greater_than": lambda c: BOUNDS["above"][1].format(c["gt"]),
    "greater_than_equal": lambda c: BOUNDS["least"][1].format(c["ge"]),
    "less_than": lambda c: BOUNDS["below"][1].format(c["lt"]),
    "less_than_equal": lambda c: BOUNDS["most"][1].format(c["le"]),
    "model_type": lambda c: "not a table; write [KEY] with its keys below, or { key = value }",
    "dict_type": lambda c: "not a table; write [KEY.NAME] with its keys below",
    "tuple_type": lambda c: "not a list; write [ … ]",
    "too_short": lambda c: f"too few; give at least {c['min_length']}",
    "too_long": lambda c: f"too many; give at most {c['max_length']}",
    "missing": lambda c: "missing; the list is too short",
}


def _key_in_file(error: ErrorDetails, raw: Mapping[str, Any]) -> KeyPath:
    """Return the key of the error in the file, without the tags of pydantic's unions."""
    below = tuple(error.get("ctx", {}).get("key", ()))
    key: list[str | int] = []
    for step in error["loc"]:
        known, value = look_up(raw, tuple(key))
        if not (isinstance(value, Mapping | Sequence) and not isinstance(value, str)) and known:
            break
        is_tag = isinstance(step, str) and step.startswith("<") and step.endswith(">")
        if not is_tag or (isinstance(value, Mapping) and step in value):
            key.append(step)
    return (*(step for step in key if step != "[key]"), *below)


def _is_below(key: KeyPath, table: KeyPath) -> bool:
    """Whether a key lies within another, of which a fault is then the consequence: a list too short, say."""
    return len(key) > len(table) and key[: len(table)] == table


def _sentence(error: ErrorDetails, *, known: bool) -> str:
    context = error.get("ctx", {})
    if error["type"] == "choice":
        return f"{'not supported' if known else 'missing'}; write one of {context['names']}"
    if error["type"] == "project":
        return str(context["reason"])
    if error["type"] == "value_error":
        return str(context["error"])
    sentence = _SENTENCES.get(error["type"])
    return sentence(context) if sentence else f"{error['msg'][:1].lower()}{error['msg'][1:]}"
