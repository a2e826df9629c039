"""Every kind of mechanism is known wherever kinds are told apart by a table: what a new one still lacks, by file."""

from __future__ import annotations

from pathlib import Path
from typing import get_args

import pytest

import assess
from assess.mechanisms.kinds import MECHANISM_KINDS
from assess.mechanisms.mechanism import BlockMechanism
from assess.project import sections
from assess.project.sections.mechanisms import MECHANISMS, MechanismSection
from reports.chapters.mechanism_page import KINDS as NAMES
from tests.properties.test_mechanisms import CASES

ROOT = Path(__file__).parents[2]
TAGGED, _ = get_args(MechanismSection)
SECTIONS = {
    kind: section
    for section in (get_args(tagged)[0] for tagged in get_args(TAGGED))
    for kind in get_args(section.model_fields["kind"].annotation)
}
BY_PARAMETERS = {"equivalent-block"}  # by values, not of blocks

every_kind = pytest.mark.parametrize("kind", MECHANISMS)


@every_kind
def test_tables_by_kind(kind: str) -> None:
    tables = (
        ("MECHANISM_KINDS of assess/mechanisms/kinds.py", MECHANISM_KINDS),
        ("the unions at the end of assess/project/sections/mechanisms.py", SECTIONS),
        ("KINDS of reports/chapters/mechanism_page.py", NAMES),
    )
    missing = [where for where, table in tables if kind not in table]
    assert not missing, f'add "{kind}" to {"; ".join(missing)}'


@every_kind
def test_section_and_definition_have_one_name(kind: str) -> None:
    assert kind in SECTIONS, (
        "write its section in assess/project/sections/mechanisms.py, and name it in the unions there"
    )
    section = SECTIONS[kind]
    assert getattr(sections, section.__name__, None) is section, "add it to assess/project/sections/__init__.py"
    definition = MECHANISM_KINDS[kind].definition
    assert section.__name__ == f"{definition.__name__}Section", "the section is called after what it states"
    if kind in BY_PARAMETERS:
        return
    assert issubclass(definition, BlockMechanism), (
        "what an engineer states of a mechanism of blocks is a BlockMechanism"
    )
    same = definition.number_of_blocks == section.number_of_blocks
    assert same, "as many blocks move by the section as by the definition: `number_of_blocks`"
    assert {"hinges", "hinges_negative"} <= section.model_fields.keys(), "sections of blocks have both keys"


def test_every_kind_offers_the_rule_of_the_thesis_and_has_a_section() -> None:
    assert all(
        "thesis" in kind.impacts.two_sided and "thesis" in kind.impacts.one_sided for kind in MECHANISM_KINDS.values()
    )
    assert set(MECHANISM_KINDS) == set(MECHANISMS), (
        "MECHANISM_KINDS of assess/mechanisms/kinds.py and MECHANISMS differ"
    )
    assert set(SECTIONS) == set(MECHANISMS), "MECHANISMS and the unions of assess/project/sections/mechanisms.py differ"


@every_kind
def test_python_has_a_verb_for_it(kind: str) -> None:
    verb = kind.replace("-", "_")
    assert verb in assess.__all__, f"add {verb}, of assess/study/block.py, to __all__ and _HOMES of assess/__init__.py"
    assert callable(getattr(assess, verb))


def test_every_kind_of_blocks_is_a_case_of_what_must_hold() -> None:
    cases = {case.mechanism().kind for case in CASES.values()}
    assert set(MECHANISMS) - cases == BY_PARAMETERS, "add a Case to tests/properties/test_mechanisms.py"


@every_kind
@pytest.mark.parametrize("page", ["docs/mechanisms.md", "docs/overview.md"])
def test_the_documents_name_it(kind: str, page: str) -> None:
    assert kind in (ROOT / page).read_text(encoding="utf-8"), f"describe {kind} in {page}"
