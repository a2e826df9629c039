"""The sentences of the report in other languages: one gettext file for each, by its English sentences.

`catalogues/CODE.po` is read by Babel. A sentence without an entry stays English, which a test of the catalogues does
not let happen.
"""

from __future__ import annotations

from functools import cache
from gettext import GNUTranslations, NullTranslations
from io import BytesIO
from pathlib import Path

FOLDER = Path(__file__).parent / "catalogues"
ENGLISH = "en"


def languages() -> tuple[str, ...]:
    """Return the codes of all languages that a report can be written in, English first."""
    return (ENGLISH, *sorted(path.stem for path in FOLDER.glob("*.po")))


@cache
def read_catalogue(language: str) -> NullTranslations:
    """Return the entries of a language; raises ValueError where there is no file of it."""
    if language not in languages():
        raise ValueError(f'report.language: "{language}" has no catalogue; known are {", ".join(languages())}')
    if language == ENGLISH:
        return NullTranslations()
    from babel.messages.mofile import write_mo
    from babel.messages.pofile import read_po

    compiled = BytesIO()
    with (FOLDER / f"{language}.po").open("rb") as file:
        write_mo(compiled, read_po(file, locale=language))
    compiled.seek(0)
    return GNUTranslations(compiled)


@cache
def decimal_point(language: str) -> str:
    """Return the decimal sign of a language."""
    if language == ENGLISH:
        return "."
    from babel.numbers import get_decimal_symbol

    return get_decimal_symbol(language)
