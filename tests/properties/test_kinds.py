"""Every kind of mechanism is known wherever kinds are told apart by a table: what a new one still lacks, by file."""

from __future__ import annotations

from pathlib import Path
from typing import get_args

import pytest

import assess
from assess.mechanisms.kinds import Definition
from assess.mechanisms.restitution import ONE_SIDED, TWO_SIDED
from assess.mechanisms.single_block import EquivalentBlock
from assess.model.assembly import BUILDERS
from assess.project import sections
from assess.project.sections.mechanisms import MECHANISMS, Mechanism
from assess.project.site_and_structure import CHAINED
from assess.study.checks import SUPPORTS
from reports.chapters.mechanism_page import KINDS
from tests.properties.test_mechanisms import CASES

ROOT = Path(__file__).parents[2]
SECTIONS = {
    kind: section for section in get_args(Mechanism) for kind in get_args(section.model_fields["kind"].annotation)
}
BY_PARAMETERS = {"equivalent-block"}  # by values, not of blocks

every_kind = pytest.mark.parametrize("kind", MECHANISMS)


@every_kind
def test_tables_by_kind(kind: str) -> None:
    tables = (
        ("TWO_SIDED of assess/mechanisms/restitution.py", TWO_SIDED),
        ("ONE_SIDED of assess/mechanisms/restitution.py", ONE_SIDED),
        ("SUPPORTS of assess/study/checks.py", SUPPORTS),
        ("the unions at the end of assess/project/sections/mechanisms.py", SECTIONS),
        ("KINDS of reports/chapters/mechanism_page.py", KINDS),
    )
    missing = [where for where, table in tables if kind not in table]
    assert not missing, f'add "{kind}" to {"; ".join(missing)}'


@every_kind
def test_section_and_definition_have_one_name_and_lead_to_a_builder(kind: str) -> None:
    assert kind in SECTIONS, (
        "write its section in assess/project/sections/mechanisms.py, and name it in the unions there"
    )
    section = SECTIONS[kind]
    assert getattr(sections, section.__name__, None) is section, "add it to assess/project/sections/__init__.py"
    if kind in BY_PARAMETERS:
        return
    assert section in CHAINED, f"add {section.__name__} to CHAINED of assess/project/site_and_structure.py"
    definition = CHAINED[section]
    assert definition in get_args(Definition), f"add {definition.__name__} to the unions of assess/mechanisms/kinds.py"
    assert definition in BUILDERS, f"add {definition.__name__} to BUILDERS of assess/model/assembly.py"
    assert definition.moving == section.moving, "as many blocks move by the section as by the definition: `moving`"
    assert {"hinges", "hinges_negative"} <= section.model_fields.keys(), "sections of blocks have both keys"


def test_every_definition_has_its_kind() -> None:
    assert set(get_args(Definition)) == {*CHAINED.values(), EquivalentBlock}
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
