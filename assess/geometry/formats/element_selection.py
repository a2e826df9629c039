"""Selection of a file's elements by name, identifier, class or pattern."""

from __future__ import annotations

from collections.abc import Sequence
from difflib import get_close_matches
from fnmatch import fnmatchcase

from assess.errors import GeometryError
from assess.geometry.formats.mesh_file import Element

LONGEST = 40  # letters of a name that came with a file
MAX_LISTED = 8  # names that a sentence lists
WILDCARDS = "*?["  # letters that make a pattern
PREFIX = "ifc"  # of the names of classes


def select_elements(elements: Sequence[Element], wanted: str | None, *, where: str) -> tuple[int, ...]:
    """Return the indices of the elements that a selection means; all where none is given.

    The first of these that matches counts: the identifier of one element; its name; its class or a superclass, such as
    "IfcWall", or what it is part of; a pattern such as "Wand-*" (`*` any letters, `?` one letter, `[ab]` one of these).

    Raises
    ------
    GeometryError : nothing matches, or several elements with identifiers of their own have exactly this name
    """
    if wanted is None:
        return tuple(range(len(elements)))
    wanted = one_line(wanted)
    named = _indices(elements, [wanted in map(one_line, each.names) for each in elements])
    for found in (
        _indices(elements, [wanted == each.identifier for each in elements]),
        _refuse_ambiguous(elements, named, wanted, where=where),
        _indices(elements, [wanted in map(one_line, (*each.within, *each.kinds)) for each in elements]),
        _indices(elements, [_fits(each, wanted) for each in elements]),
    ):
        if found:
            return found
    raise GeometryError(f'{where}: it has no element "{short_name(wanted)}"; {_known(elements, wanted)}')


def one_line(name: str) -> str:
    """Collapse line breaks and other white space of a name to single spaces, as tables show it."""
    return " ".join("".join(letter if letter.isprintable() else " " for letter in name).split())


def short_name(name: str) -> str:
    """Return a file's name for an element on one line, shortened to fit a sentence."""
    line = one_line(name)
    return line if len(line) <= LONGEST else f"{line[: LONGEST - 1]}…"


def list_names(names: Sequence[str]) -> str:
    """List the first names of many for a sentence."""
    more = f" and {len(names) - MAX_LISTED} more" if len(names) > MAX_LISTED else ""
    return ", ".join(short_name(name) for name in names[:MAX_LISTED]) + more


def _indices(elements: Sequence[Element], fit: Sequence[bool]) -> tuple[int, ...]:
    return tuple(i for i in range(len(elements)) if fit[i])


def _fits(element: Element, wanted: str) -> bool:
    """Return whether a pattern matches a name of the element, or of what it is part of."""
    names = map(one_line, (*element.names, *element.within))
    return any(letter in wanted for letter in WILDCARDS) and any(fnmatchcase(name, wanted) for name in names)


def _refuse_ambiguous(
    elements: Sequence[Element], named: tuple[int, ...], wanted: str, *, where: str
) -> tuple[int, ...]:
    """Return the elements of a name; raise where there are several that can be told apart."""
    identifiers = [elements[i].identifier for i in named]
    if len(named) > 1 and all(identifiers):
        raise GeometryError(
            f'{where}: {len(named)} elements are called "{short_name(wanted)}": {list_names(identifiers)}; '
            f'give the identifier (GlobalId) of one, or a pattern as "{short_name(wanted)}*" for all of them'
        )
    return named


def _known(elements: Sequence[Element], wanted: str) -> str:
    """Describe the available names, those similar to the one given first."""
    known = list(dict.fromkeys(each.shown for each in elements if each.names or each.within or each.identifier))
    if not known:
        return "its parts have no names; remove the key"
    if any(each.kinds for each in elements) and wanted.lower().startswith(PREFIX):
        return _known_classes(elements, wanted)
    words = dict.fromkeys(word for each in elements for word in (*each.names, *each.within))
    near = get_close_matches(wanted, words, n=MAX_LISTED)
    return f"did you mean {list_names(near)}?" if near else f"known: {list_names(known)}"


def _known_classes(elements: Sequence[Element], wanted: str) -> str:
    """Describe the available classes, those spelt similarly to the one given first."""
    short = {kind[len(PREFIX) :].lower(): kind for each in elements for kind in each.kinds}
    near = get_close_matches(wanted[len(PREFIX) :].lower(), short, n=MAX_LISTED, cutoff=0.75)
    classes = sorted({each.kinds[0] for each in elements if each.kinds})
    return (
        f"did you mean {list_names([short[word] for word in near])}?"
        if near
        else f"its classes are {list_names(classes)}"
    )
