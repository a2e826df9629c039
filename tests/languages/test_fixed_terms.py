"""The fixed terms found in the source are all that results carry."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from assess.codes.bases import BASES
from assess.codes.check import Check
from assess.codes.procedures import PROCEDURES
from assess.messages.message import Message, Term
from tests.languages.fixed_terms import fixed_terms
from tests.support.subjects import subjects


def terms_of(check: Check) -> Iterator[str]:
    yield from (check.quantity, check.edition, check.limit_state, check.damping_rule)
    for said in (check.reason, *check.conditions, *check.remarks, *check.caveats):
        yield from terms_in(said)
    for step in check.steps:
        yield from (step.description, step.clause, step.remark)
        yield from () if step.inputs else (step.formula,)


def terms_in(said: Term | Message) -> Iterator[str]:
    if isinstance(said, Term):
        yield said.english
        return
    for value in said.values.values():
        yield from terms_in(value) if isinstance(value, Term | Message) else ()


@pytest.mark.parametrize("name", PROCEDURES)
def test_every_term_of_a_check_is_found_in_the_source(name: str) -> None:
    carried = {term for subject in subjects(name) for term in terms_of(subject.check)}
    assert {term for term in carried if any(map(str.isalpha, term))} - set(fixed_terms()) == set()


@pytest.mark.parametrize("name", BASES)
def test_every_term_of_a_basis_is_found_in_the_source(name: str) -> None:
    basis = BASES[name]
    parts = (part for pair in basis.clauses for part in pair)
    terms = {basis.edition, *parts, *basis.uncompared}
    assert {term for term in terms if any(map(str.isalpha, term))} <= set(fixed_terms())


def test_no_term_has_a_gap() -> None:
    assert not [term for term in fixed_terms() if "{" in term.replace("amplification = {", "")]


@pytest.mark.parametrize("term", ["all of it pushes, its weight is carried elsewhere (thesis 3.2.2)",
                                  "Housner 1963, thesis eq. 3.44", "extend its table", "Rayleigh's method",
                                  "NTC 2018 §3.2.3.2.1: eta = √(10 / (5 + ξ)) ≥ 0.55; not checked against the printed "
                                  "decree"])  # fmt: skip
def test_terms_of_loads_restitution_suites_and_spectra_are_found(term: str) -> None:
    assert term in fixed_terms()
