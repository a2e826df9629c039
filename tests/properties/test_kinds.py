"""Kinds of mechanism, load and quantity are known wherever a table tells them apart: what a new one lacks, by file."""

from __future__ import annotations

from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any, ClassVar, cast

import pytest

import assess
from assess.declaration import Number, Scatters, annotations_of, marks_of
from assess.loads.load import LOADS
from assess.mechanisms.assembly import MechanismKind
from assess.mechanisms.kinds import MECHANISM_KINDS
from assess.mechanisms.mechanism import BlockMechanism
from assess.mechanisms.restitution import ImpactRules
from assess.project.sections.analysis import Sensitivity
from assess.project.sections.mechanisms import MECHANISM_TABLES, table_of_kind
from assess.project.units import KINDS as QUANTITIES
from assess.results.verification import KINDS as VERIFIED_KINDS
from assess.results.verification import USES
from reports.chapters.kinds import FALLING as NOT_ROCKING
from reports.chapters.kinds import KINDS as NAMES
from reports.chapters.kinds import THEORY
from reports.language.locale import UNITS
from reports.project_values import KIND_DIMENSIONS
from tests.properties.test_mechanisms import CASES

ROOT = Path(__file__).parents[2]
BY_PARAMETERS = {"equivalent-block"}  # by values, not of blocks
FALLING = {name for name, kind in MECHANISM_KINDS.items() if not kind.rocks}  # of which no history is answered

every_load = pytest.mark.parametrize("kind", LOADS)
every_kind = pytest.mark.parametrize("kind", MECHANISM_KINDS)


@every_kind
def test_tables_by_kind(kind: str) -> None:
    tables = (
        ("KINDS of reports/chapters/kinds.py", NAMES),
        ("THEORY of reports/chapters/kinds.py", THEORY),
        ("USES of assess/results/verification.py", USES),
        ("KINDS of assess/results/verification.py", VERIFIED_KINDS),
    )
    missing = [where for where, table in tables if kind not in table]
    assert not missing, f'add "{kind}" to {"; ".join(missing)}'


@dataclass(frozen=True, kw_only=True)
class Stated:
    """A mechanism that is not of blocks."""

    kind: ClassVar[str] = "stated"


def test_a_kind_without_blocks_says_what_a_file_writes() -> None:
    kind = MechanismKind(definition=Stated, build=dict, impacts=ImpactRules({}, {}), support="free")
    with pytest.raises(LookupError, match="stated: not a mechanism of blocks; add its keys to FILE_KEYS"):
        table_of_kind(kind)


@every_load
def test_a_load_says_which_of_its_numbers_is_varied(kind: str) -> None:
    key, parameter = LOADS[kind].varied
    marks = list(marks_of(annotations_of(cast(Any, LOADS[kind]))[key]))
    assert any(isinstance(mark, Scatters) for mark in marks), f"{key} of {kind} must be UNCERTAIN"
    assert any(isinstance(mark, Number) and mark.dimension for mark in marks)
    assert parameter in Sensitivity.model_fields


@every_load
@pytest.mark.parametrize("page", ["docs/reference/keys.md", "docs/overview.md"])
def test_the_documents_name_the_load(kind: str, page: str) -> None:
    assert kind in (ROOT / page).read_text(encoding="utf-8"), f"describe {kind} in {page}"


def test_reports_show_every_kind_of_quantity() -> None:
    assert {kind.name for kind in QUANTITIES.values()} == set(KIND_DIMENSIONS)
    assert set(KIND_DIMENSIONS.values()) <= set(UNITS["SI"])


@every_kind
def test_the_table_of_a_kind_has_the_keys_of_its_definition(kind: str) -> None:
    definition, table = MECHANISM_KINDS[kind].definition, MECHANISM_TABLES[kind]
    assert {field.name for field in fields(definition)} <= table.model_fields.keys()
    assert kind in BY_PARAMETERS or issubclass(definition, BlockMechanism), (
        "what an engineer states of a mechanism of blocks is a BlockMechanism"
    )


def test_every_kind_offers_the_rule_of_the_thesis() -> None:
    assert all(
        "thesis" in kind.impacts.one_sided and (name in FALLING or "thesis" in kind.impacts.two_sided)
        for name, kind in MECHANISM_KINDS.items()
    )


def test_reports_know_which_kinds_have_no_histories() -> None:
    assert FALLING == NOT_ROCKING


@every_kind
def test_python_has_a_verb_for_it(kind: str) -> None:
    verb = kind.replace("-", "_")
    assert verb in assess.__all__, f"add {verb}, of assess/study/block.py, to __all__ and _HOMES of assess/__init__.py"
    assert callable(getattr(assess, verb))


def test_every_kind_of_blocks_is_a_case_of_what_must_hold() -> None:
    cases = {case.mechanism().kind for case in CASES.values()}
    assert set(MECHANISM_KINDS) - cases == BY_PARAMETERS | FALLING, "add a Case to tests/properties/test_mechanisms.py"


@every_kind
@pytest.mark.parametrize("page", ["docs/mechanisms.md", "docs/overview.md"])
def test_the_documents_name_it(kind: str, page: str) -> None:
    assert kind in (ROOT / page).read_text(encoding="utf-8"), f"describe {kind} in {page}"
