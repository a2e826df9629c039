"""References from one block to another."""

from __future__ import annotations

from dataclasses import replace

import pytest
from reports.references import reference, resolve_references

from assess.results import Results
from reports.assessment import assessment
from reports.document import Document, Figure, Section, Text


def with_paragraph(text: str) -> Document:
    figures = tuple(Figure(name, "", draw=lambda: None) for name in ("a", "b"))  # type: ignore[arg-type, return-value]
    sections = (Section("One", 0, (Text((text,)), *figures)),)
    return Document("", "", "", "", "A4", (), sections, ())


def test_a_reference_is_the_title_of_the_block() -> None:
    document = resolve_references(with_paragraph(f"see {reference('Figure', 'b')} and {reference('Figure', 'a')}."))
    assert document.blocks[0] == Text(("see Figure 2 and Figure 1.",))


def test_a_reference_to_no_block_is_an_error() -> None:
    with pytest.raises(KeyError):
        resolve_references(with_paragraph(f"see {reference('Table', 'a')}."))


def test_mechanisms_of_the_same_bodies_show_them_once(results: Results) -> None:
    first = next(each for each in results.mechanisms if each.view is not None)
    key = f"mechanisms.{first.name}."
    again = {f"mechanisms.again.{name[len(key) :]}": value for name, value in results.project.items() if key in name}
    twins = replace(
        results, mechanisms=(*results.mechanisms, replace(first, name="again")), project={**results.project, **again}
    )
    document = assessment(twins)
    (said,) = [
        text for block in document.blocks if isinstance(block, Text) for text in block.paragraphs if "in space" in text
    ]
    figure = next(name for name in (each.name for each in document.figures) if name.endswith("-view"))
    assert said == f"For its bodies in space see {document.titles['Figure', figure]}."
