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
PREFIX = "ifc"  # of the names of classes


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
    wanted = one_line(wanted)
    named = _those(elements, [wanted in map(one_line, each.names) for each in elements])
    for found in (
        _those(elements, [wanted == each.identifier for each in elements]),
        _only(elements, named, wanted, where=where),
        _those(elements, [wanted in map(one_line, (*each.within, *each.kinds)) for each in elements]),
        _those(elements, [_fits(each, wanted) for each in elements]),
    ):
        if found:
            return found
    raise GeometryError(f'{where}: it has no element "{shown(wanted)}"; {_known(elements, wanted)}')


def one_line(name: str) -> str:
    """A name as tables show it and as it may be typed: line breaks and other runs of blanks are one space."""
    return " ".join("".join(letter if letter.isprintable() else " " for letter in name).split())


def shown(name: str) -> str:
    """A name that came with a file, fit for a sentence: one line, cut where it is long."""
    line = one_line(name)
    return line if len(line) <= LONGEST else f"{line[: LONGEST - 1]}…"


def listed(names: Sequence[str]) -> str:
    """The first of many names for a sentence."""
    more = f" and {len(names) - LISTED} more" if len(names) > LISTED else ""
    return ", ".join(shown(name) for name in names[:LISTED]) + more


def _those(elements: Sequence[Element], fit: Sequence[bool]) -> tuple[int, ...]:
    return tuple(i for i in range(len(elements)) if fit[i])


def _fits(element: Element, wanted: str) -> bool:
    """Whether a pattern fits a name of the element, or of what it is a part of."""
    names = map(one_line, (*element.names, *element.within))
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
    if any(each.kinds for each in elements) and wanted.lower().startswith(PREFIX):
        return _known_classes(elements, wanted)
    words = dict.fromkeys(word for each in elements for word in (*each.names, *each.within))
    near = get_close_matches(wanted, words, n=LISTED)
    return f"did you mean {listed(near)}?" if near else f"known: {listed(known)}"


def _known_classes(elements: Sequence[Element], wanted: str) -> str:
    """The classes to choose from, those spelt like the one asked for before the others."""
    short = {kind[len(PREFIX) :].lower(): kind for each in elements for kind in each.kinds}
    near = get_close_matches(wanted[len(PREFIX) :].lower(), short, n=LISTED, cutoff=0.75)
    classes = sorted({each.kinds[0] for each in elements if each.kinds})
    return f"did you mean {listed([short[word] for word in near])}?" if near else f"its classes are {listed(classes)}"
