"""Which elements of a file a name, an identifier, a class or a pattern means."""

from __future__ import annotations

from collections.abc import Sequence
from difflib import get_close_matches
from fnmatch import fnmatchcase

from assess.errors import GeometryError
from assess.geometry.formats.parts import Element

LONGEST = 40  # letters of a name that came with a file
LISTED = 8  # names that a sentence lists
WILD = "*?["  # letters that make a pattern


def places_of(elements: Sequence[Element], wanted: str | None, *, where: str) -> tuple[int, ...]:
    """Where in `elements` those stand that are meant; all where nothing is asked for.

    The first of these that fits: the identifier of one; the name of one; their class or one above it, as
    "IfcWall", or what they are parts of; a pattern, as "Wand-*" (`*` any letters, `?` one letter, `[ab]` one of these).

    Raises
    ------
    GeometryError : nothing fits, or several elements with identifiers of their own have exactly this name
    """
    if wanted is None:
        return tuple(range(len(elements)))
    named = _those(elements, [wanted in each.names for each in elements])
    for found in (
        _those(elements, [wanted == each.identifier for each in elements]),
        _only(elements, named, wanted, where=where),
        _those(elements, [wanted in (*each.within, *each.kinds) for each in elements]),
        _those(elements, [_fits(each, wanted) for each in elements]),
    ):
        if found:
            return found
    raise GeometryError(f'{where}: it has no element "{shown(wanted)}"; {_known(elements, wanted)}')


def shown(name: str) -> str:
    """A name that came with a file, fit for one line."""
    return "".join(letter for letter in name if letter.isprintable())[:LONGEST]


def listed(names: Sequence[str]) -> str:
    """The first of many names for a sentence."""
    more = f" and {len(names) - LISTED} more" if len(names) > LISTED else ""
    return ", ".join(shown(name) for name in names[:LISTED]) + more


def _those(elements: Sequence[Element], fit: Sequence[bool]) -> tuple[int, ...]:
    return tuple(i for i in range(len(elements)) if fit[i])


def _fits(element: Element, wanted: str) -> bool:
    """Whether a pattern fits a name of the element, or of what it is a part of."""
    names = (*element.names, *element.within)
    return any(letter in wanted for letter in WILD) and any(fnmatchcase(name, wanted) for name in names)


def _only(elements: Sequence[Element], named: tuple[int, ...], wanted: str, *, where: str) -> tuple[int, ...]:
    """The elements of a name, refused where they are several and can be told apart."""
    identifiers = [elements[i].identifier for i in named]
    if len(named) > 1 and all(identifiers):
        raise GeometryError(
            f'{where}: {len(named)} elements are called "{shown(wanted)}": {listed(identifiers)}; give the identifier '
            f'(GlobalId) of one, or a pattern as "{shown(wanted)}*" for all of them'
        )
    return named


def _known(elements: Sequence[Element], wanted: str) -> str:
    """What there is to choose from, what looks like the word asked for before the others."""
    known = list(dict.fromkeys(each.shown for each in elements if each.names or each.within or each.identifier))
    if not known:
        return "its parts have no names; remove the key"
    words = dict.fromkeys(word for each in elements for word in (*each.names, *each.within, *each.kinds))
    near = get_close_matches(wanted, words, n=LISTED)
    return f"did you mean {listed(near)}?" if near else f"known: {listed(known)}"
