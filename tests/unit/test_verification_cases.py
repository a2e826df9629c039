"""Files of cases: read strictly, with the words of one table."""

from __future__ import annotations

import pytest

from assess.errors import AssessError
from assess.results.verification import USES
from assess.verification.case_files import choose_cases, read_cases
from assess.verification.verify import compare_case

CASE = """
title = "A title"
theory = "An equation."
field = "Where it holds."
uses = ["single-block"]
solver = "free-rocking"
given = { thickness = 0.2 }

[source]
citation = "Somebody (1963)"
standing = "published"
place = "page 3, read in the paper"

[[quantities]]
name = "period"
path = "period_p.{row}"
tolerance = { relative = 1e-6, reason = "seven digits are printed" }
values = { a = 1.0, b = 2.0 }
"""
FAULTS = {
    "an unknown key": ('title = "A title"', 'title = "A title"\ntitel = ""', "titel: "),
    "an unknown key of a table": ("relative = 1e-6", "relativ = 1e-6", "tolerance.relativ: "),
    "a text for a number": ("a = 1.0", 'a = "1.0"', "values.a: "),
    "no finite number": ("a = 1.0", "a = nan", "values.a: "),
    "a standing": ('"published"', '"remembered"', "source.standing: "),
    "no place of reading": ("page 3, read in the paper", "page 3", "was read somewhere"),
    "no reason": ("seven digits are printed", "rounding", "say in a sentence"),
    "a word that is in no table": ('["single-block"]', '["single-blok"]', 'did you mean "single-block"'),
    "a word twice": ('["single-block"]', '["rigid", "rigid"]', "each word once"),
    "a solver": ('"free-rocking"', '"free-roking"', "solver: "),
    "a path without rows": ("period_p.{row}", "period_p", "several rows need {row}"),
    "a negative tolerance": ("relative = 1e-6", "relative = -1e-6", "negative"),
    "a misprint of no value": (
        "values =",
        'misprints = { c = { reading = 1.0, reason = "b" } }\nvalues =',
        "misprints",
    ),
    "a key twice": ("a = 1.0", "a = 1.0, a = 2.0", "line"),
    "a value too large": ("a = 1.0", "a = 1.7e308", "1.7e+308 is too large or too small"),
    "a tolerance too small": ("relative = 1e-6", "absolute = 1e-320", "is too large or too small"),
    "a factor too large": ('path = "period_p.{row}"', 'path = "period_p.{row}"\nfactor = 1e308', "1e+308 is too large"),
    "an example that is not shipped": ("thickness = 0.2", 'example = "casa_grand"', 'did you mean "casa_grande"'),
    "an example that is no name": ("thickness = 0.2", "example = [1]", "given.example: "),
    "files that are no names": ("thickness = 0.2", "files = 3", "given.files: "),
    "a file that is no name": ("thickness = 0.2", "file = 3", "given.file: "),
    "no quantity": ("[[quantities]]", "[[quantity]]", "quantities: Field required"),
}


@pytest.mark.parametrize(("old", "new", "said"), FAULTS.values(), ids=FAULTS)
def test_fault_of_a_file_is_named(tmp_path, old, new, said):
    assert old in CASE
    (tmp_path / "case.toml").write_text(CASE.replace(old, new), encoding="utf-8")
    with pytest.raises(AssessError) as raised:
        read_cases(tmp_path)
    assert "case.toml" in str(raised.value)
    assert said in str(raised.value)


def test_file_that_is_no_utf8_and_folder_named_as_a_file_are_refused(tmp_path):
    file = tmp_path / "case.toml"
    file.write_bytes(CASE.replace("A title", "Größe").encode("latin-1"))
    with pytest.raises(AssessError, match=r"case\.toml: not UTF-8"):
        read_cases(tmp_path)
    file.unlink()
    file.mkdir()
    with pytest.raises(AssessError, match=r"case\.toml: "):
        read_cases(tmp_path)


def test_value_too_large_for_a_number_is_none_found(tmp_path):
    text = CASE.replace('path = "period_p.{row}"', 'path = "period_p.{row}"\nfactor = 1e100')
    (tmp_path / "case.toml").write_text(text, encoding="utf-8")
    (case,) = read_cases(tmp_path)
    result = compare_case(case, {"period_p": {"a": 1e300, "b": 1e-100}})
    assert [each.found for each in result.quantities[0].values] == [None, pytest.approx(1.0)]
    assert result.outcome == "fail"


def test_whole_case_is_read_and_a_project_beside_it_is_none(tmp_path):
    (tmp_path / "case.toml").write_text(CASE, encoding="utf-8")
    (tmp_path / "project.toml").write_text('title = "a project"\n[mechanisms.wall]\n', encoding="utf-8")
    (only,) = read_cases(tmp_path)
    assert only.key == "case"
    assert only.case.quantities[0].values == {"a": 1.0, "b": 2.0}


def test_cases_are_chosen_by_key_and_by_source():
    cases = read_cases()
    housner = choose_cases(cases, ["housner_1963"])
    assert housner
    assert all(each.key.startswith("housner_1963/") for each in housner)
    assert [each.key for each in choose_cases(cases, [housner[0].key])] == [housner[0].key]
    assert choose_cases(cases, []) == cases
    with pytest.raises(AssessError, match='did you mean "housner_1963"'):
        choose_cases(cases, ["housner_1936"])


def test_shipped_cases_use_the_words_of_the_table_alone():
    assert {word for each in read_cases() for word in each.case.uses} <= set(USES)
