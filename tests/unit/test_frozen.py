"""Data of all packages are frozen: a result that has been checked cannot be changed on its way to the report."""

from __future__ import annotations

import dataclasses
import importlib
import pkgutil

import pytest

PACKAGES = ("spectra", "records", "assess.oscillator", "assess.mechanisms", "assess.interfaces", "assess.loads",
            "assess.geometry", "assess.dynamics", "assess.amplification", "assess.codes", "assess.risk")  # fmt: skip
CHANGED_WHILE_MADE = {"assess.geometry.formats.threemf.PackageObject", "assess.geometry.formats.threemf.ModelPart"}
"""Classes that are filled step by step by one function, and given to no other."""


@pytest.mark.parametrize("package", PACKAGES)
def test_data_are_frozen(package: str) -> None:
    module = importlib.import_module(package)
    names = [each.name for each in pkgutil.walk_packages(getattr(module, "__path__", []), f"{package}.")]
    modules = [module, *map(importlib.import_module, names)]
    found = {each for module in modules for each in vars(module).values() if isinstance(each, type)}
    own = [each for each in found if dataclasses.is_dataclass(each) and each.__module__.startswith(package)]
    open_ones = {f"{each.__module__}.{each.__name__}" for each in own if not each.__dataclass_params__.frozen}
    assert own
    assert open_ones <= CHANGED_WHILE_MADE
