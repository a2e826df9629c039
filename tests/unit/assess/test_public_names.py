"""The public names of `import assess`: listed, loaded late, and none that a submodule takes."""

from __future__ import annotations

import pkgutil
import subprocess
import sys

import pytest

import assess

HEAVY = (
    "numpy",
    "scipy",
    "pandas",
    "numba",
    "trimesh",
    "shapely",
    "obspy",
    "matplotlib",
    "reportlab",
    "pydantic",
    "pint",
)


def test_names_are_sorted_and_none_is_listed_twice():
    assert sorted(assess.__all__) == assess.__all__
    assert len(set(assess.__all__)) == len(assess.__all__)


@pytest.mark.parametrize("name", assess.__all__)
def test_name_is_there_and_known_to_dir(name):
    assert getattr(assess, name) is getattr(assess, name)
    assert name in dir(assess)


def test_names_of_the_interface_are_public():
    listed = {
        "g", "box", "mesh", "profile", "single_block", "two_block", "four_hinge", "equivalent_block", "read_record",
        "respond", "envelope", "fragility", "spectrum", "answers", "load", "run", "write_report",
    }  # fmt: skip
    assert listed <= set(assess.__all__)


def test_no_public_name_is_that_of_a_submodule():
    submodules = {module.name for module in pkgutil.iter_modules(assess.__path__)}
    assert not submodules & set(assess.__all__)


def test_unknown_name_lists_the_public_ones():
    with pytest.raises(AttributeError, match=r"no attribute 'boxx'; the public names are: .*single_block"):
        assess.boxx  # noqa: B018


def test_import_loads_nothing_heavy():
    code = f"import assess, sys; print([name for name in {HEAVY} if name in sys.modules])"
    found = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True).stdout
    assert found.strip() == "[]"


def test_rooms_are_reached_without_an_import_of_their_own():
    code = "import assess; print(assess.loads.arch_thrust(50e3, lever=1.0, rise=2.0))"
    found = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True).stdout
    assert float(found) == 25e3
