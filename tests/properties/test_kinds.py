"""Every kind of mechanism is known wherever kinds are told apart by a table: what a new one still lacks, by file."""

from __future__ import annotations

from dataclasses import fields
from pathlib import Path

import pytest

import assess
from assess.mechanisms.kinds import MECHANISM_KINDS
from assess.mechanisms.mechanism import BlockMechanism
from assess.project.sections.mechanisms import FILE_KEYS, MECHANISM_TABLES
from reports.chapters.mechanism_page import KINDS as NAMES
from tests.properties.test_mechanisms import CASES

ROOT = Path(__file__).parents[2]
BY_PARAMETERS = {"equivalent-block"}  # by values, not of blocks

every_kind = pytest.mark.parametrize("kind", MECHANISM_KINDS)


@every_kind
def test_tables_by_kind(kind: str) -> None:
    tables = (
        ("FILE_KEYS of assess/project/sections/mechanisms.py", FILE_KEYS),
        ("KINDS of reports/chapters/mechanism_page.py", NAMES),
    )
    missing = [where for where, table in tables if kind not in table]
    assert not missing, f'add "{kind}" to {"; ".join(missing)}'


@every_kind
def test_the_table_of_a_kind_has_the_keys_of_its_definition(kind: str) -> None:
    definition, table = MECHANISM_KINDS[kind].definition, MECHANISM_TABLES[kind]
    assert {field.name for field in fields(definition)} <= table.model_fields.keys()
    assert kind in BY_PARAMETERS or issubclass(definition, BlockMechanism), (
        "what an engineer states of a mechanism of blocks is a BlockMechanism"
    )


def test_every_kind_offers_the_rule_of_the_thesis() -> None:
    assert all(
        "thesis" in kind.impacts.two_sided and "thesis" in kind.impacts.one_sided for kind in MECHANISM_KINDS.values()
    )


@every_kind
def test_python_has_a_verb_for_it(kind: str) -> None:
    verb = kind.replace("-", "_")
    assert verb in assess.__all__, f"add {verb}, of assess/study/block.py, to __all__ and _HOMES of assess/__init__.py"
    assert callable(getattr(assess, verb))


def test_every_kind_of_blocks_is_a_case_of_what_must_hold() -> None:
    cases = {case.mechanism().kind for case in CASES.values()}
    assert set(MECHANISM_KINDS) - cases == BY_PARAMETERS, "add a Case to tests/properties/test_mechanisms.py"


@every_kind
@pytest.mark.parametrize("page", ["docs/mechanisms.md", "docs/overview.md"])
def test_the_documents_name_it(kind: str, page: str) -> None:
    assert kind in (ROOT / page).read_text(encoding="utf-8"), f"describe {kind} in {page}"
