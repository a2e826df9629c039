"""Quantities in sentences, captions and the letters of figures, in US customary units."""

from __future__ import annotations

import re
from dataclasses import replace
from functools import partial

from reports.customary import KNOWN, customary
from reports.document import Block, Document, Section, Sheet
from reports.numerals import numeral
from reports.verbatim import masks
from reports.wording import reworded

LEAST, MOST = 3, 6  # significant figures, also where a quantity is written with fewer or more
_SUPERSCRIPT = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
_NUMBER = r"\d{1,17}(?:\.\d{1,17})?(?:e[+-]?\d{1,2}|×10⁻?[⁰¹²³⁴⁵⁶⁷⁸⁹]{1,2})?"
_SIGN = r"[-+−]?"
_SPELT = "|".join(re.escape(spelling) for unit in KNOWN for spelling in dict.fromkeys(
    (unit, unit.replace("²", "2").replace("³", "3"), unit.replace("²", "^2").replace("³", "^3"))
))  # fmt: skip
_QUANTITY = re.compile(
    r"(?P<quoted>\"[^\"]{0,400}\"|`[^`]{0,400}`|“[^”]{0,400}”)"
    rf"|(?<![\w.,])(?<!\w[-−])(?P<numbers>{_NUMBER}(?: (?:×|x|to|a) {_SIGN}{_NUMBER}){{0,5}}"
    rf"|\({_SIGN}{_NUMBER}(?:, {_SIGN}{_NUMBER}){{1,5}}\)|\[[-+−\d.,e \[\]]{{1,2000}}\])"
    rf"(?P<space>\s)(?P<unit>{_SPELT})(?![\w²³^/*·°-]|\.\w)"
)


def in_us_words(document: Document) -> Document:
    """The document with the quantities of its texts in US units, each to the figures it was written with.

    Left as they are: the user's own texts (`document.verbatim`), what stands between quotation marks, and calculation
    sheets. Works in any language that writes numbers with a point.
    """
    kept = masks(document.verbatim, spared=" ".join(KNOWN))
    changed = reworded(document, partial(kept.around, in_words))
    pairs = zip(document.sections, changed.sections, strict=True)
    return replace(changed, sections=tuple(_with_sheets(new, old) for old, new in pairs))


def _with_sheets(new: Section, old: Section) -> Section:
    pairs = zip(old.blocks, new.blocks, strict=True)
    blocks: tuple[Block, ...] = tuple(before if isinstance(before, Sheet) else after for before, after in pairs)
    return replace(new, blocks=blocks)


def in_words(text: str) -> str:
    """A text with its quantities in US units: "4.77 m above" as "15.6 ft above"."""
    return _QUANTITY.sub(_converted, text)


def _converted(found: re.Match[str]) -> str:
    if found["quoted"] is not None:
        return found[0]
    unit = customary(found["unit"])
    assert unit is not None  # the pattern knows no others
    numbers = re.sub(_NUMBER, lambda number: _number(number[0], unit.factor), found["numbers"])
    return f"{numbers}{found['space']}{unit.unit}"


def _number(text: str, factor: float) -> str:
    mantissa, _, power = text.replace("×10", "e").translate(_SUPERSCRIPT).partition("e")
    digits = len(mantissa.replace(".", "").lstrip("0"))
    return numeral(float(f"{mantissa}e{power or 0}") * factor, digits=min(max(LEAST, digits), MOST))
