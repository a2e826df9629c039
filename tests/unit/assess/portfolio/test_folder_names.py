"""Folders of projects: a name on every system, never that of another key."""

from __future__ import annotations

import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from assess.portfolio.tasks import folder_name

NAME = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_-]*")
DEVICES = ("con", "prn", "aux", "nul", "com1", "lpt9")
HOSTILE = (
    "",
    ".",
    "..",
    "../../etc/passwd",
    "/abs",
    "C:\\x",
    "a\0b",
    "CON",
    "nul",
    "a/b",
    "é",
    "\ud800",
    "x" * 5000,
    "-o",
)


@pytest.mark.parametrize("key", ["wall-1", "a", "12", "via_roma"])
def test_a_plain_key_is_its_own_name(key: str) -> None:
    assert folder_name(key) == key


@given(st.text() | st.sampled_from(HOSTILE))
def test_a_name_is_one_on_every_system(key: str) -> None:
    name = folder_name(key)
    assert NAME.fullmatch(name)
    assert len(name) < 64
    assert name.lower() not in (*DEVICES, "logs")


@given(st.lists(st.text() | st.sampled_from((*HOSTILE, "A", "a", "Wall", "wall", "wall ", "a-b", "a b")), unique=True))
def test_two_keys_never_share_a_folder_even_where_case_is_ignored(keys: list[str]) -> None:
    assert len({folder_name(key).lower() for key in keys}) == len(keys)


def test_a_key_that_looks_like_a_made_name_gets_another() -> None:
    made = folder_name("Wall").lower()
    assert folder_name(made) != made
