"""Readers by ending, and what is said where a reader's package is not installed."""

import sys
from pathlib import Path

import pytest

from assess.errors import GeometryError
from assess.geometry.formats.mesh_file import Element, select_elements
from assess.geometry.formats.readers import read_mesh_file


@pytest.mark.parametrize(
    ("ending", "package", "extra"),
    [
        ("step", "cascadio", "step"),
        ("stp", "cascadio", "step"),
        ("3dm", "rhino3dm", "rhino"),
        ("ifc", "ifcopenshell", "ifc"),
    ],
)
def test_a_missing_package_is_one_line_that_says_what_to_install(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, ending: str, package: str, extra: str
) -> None:
    monkeypatch.setitem(sys.modules, package, None)
    (tmp_path / f"wall.{ending}").write_text("anything")
    with pytest.raises(GeometryError) as caught:
        read_mesh_file(tmp_path / f"wall.{ending}", where='body "wall": mesh')
    assert str(caught.value) == (
        f'body "wall": mesh: {ending.upper()} files need the package "{package}", the extra "{extra}" of this program; '
        f'install it with that: pipx install --force ".[{extra}]" or pip install "rocking-assess[{extra}]"'
    )


def test_cad_packages_are_imported_only_for_their_files() -> None:
    import subprocess

    packages = "{'cascadio', 'rhino3dm', 'ifcopenshell', 'trimesh'}"
    program = f"import sys, assess.geometry.mesh; print(sorted({packages} & set(sys.modules)))"
    found = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert found.stdout.strip() == "[]"


def test_names_of_a_file_that_no_line_should_hold_are_shown_safely() -> None:
    hostile = [Element(("\x1b[31mred\nline " + "a" * 99,))] * 20
    with pytest.raises(GeometryError) as caught:
        select_elements(hostile, "tower", where="mesh")
    assert str(caught.value).isprintable()
    assert len(str(caught.value)) < 200
