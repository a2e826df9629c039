"""The rules of every basis are known in every language."""

from __future__ import annotations

import pytest
from reports.language.translation import Translator

from assess.codes.bases import BASES
from reports.language.catalogue import catalogue, languages


@pytest.mark.parametrize("language", languages()[1:])
@pytest.mark.parametrize("name", BASES)
def test_rules_clauses_and_reservations_are_known(language: str, name: str) -> None:
    basis, translator = BASES[name], Translator(catalogue(language), frozenset())
    states = [state.name for state in basis.states]
    for text in (*states, *(part for pair in basis.clauses for part in pair), *basis.uncompared):
        translator.translate(text)
    assert not translator.unknown
