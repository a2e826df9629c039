"""The readers of geometry files by file extension; CAD readers import their packages only when needed."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path

from assess.errors import GeometryError
from assess.geometry.formats import gltf, stl
from assess.geometry.formats.ifc import read_ifc
from assess.geometry.formats.isolation import silence_output
from assess.geometry.formats.mesh_file import ElementMesh, MeshFile
from assess.geometry.formats.obj import read_obj
from assess.geometry.formats.off import read_off
from assess.geometry.formats.ply import read_ply
from assess.geometry.formats.rhino import read_3dm
from assess.geometry.formats.step import read_step
from assess.geometry.formats.threemf import read_3mf

Reader = Callable[[Path], MeshFile]

READERS: Mapping[str, Reader] = {
    ".stl": stl.read_stl,
    ".obj": read_obj,
    ".ply": read_ply,
    ".off": read_off,
    ".glb": gltf.read_glb,
    ".gltf": gltf.read_gltf,
    ".3mf": read_3mf,
    ".step": read_step,
    ".stp": read_step,
    ".3dm": read_3dm,
    ".ifc": read_ifc,
}
WITHOUT_UNIT = (".stl", ".obj", ".ply", ".off")  # formats that do not say theirs


def read_mesh_file(file: Path, *, where: str) -> MeshFile:
    """Read the elements of a geometry file, in its own unit and axes.

    Parameters
    ----------
    file : its extension gives the format
    where : named in errors

    Raises
    ------
    GeometryError : the file is missing, of another kind or unreadable, or its reader's package is not installed
    """
    ending = file.suffix.lower()
    if ending not in READERS:
        raise GeometryError(
            f'{where}: files of kind "{file.suffix}" are not read; export it as one of {", ".join(READERS)}'
        )
    try:
        with file.open("rb"):
            pass
    except OSError as problem:
        place = "" if str(file) == where else f" ({file})"
        raise GeometryError(f"{where}: {problem.strerror or problem}{place}; check the path") from None
    with _one_line_errors(ending, where=where):
        return READERS[ending](file)


def mesh_elements(content: MeshFile, places: Sequence[int], *, file: Path, where: str) -> tuple[ElementMesh, ...]:
    """Mesh the elements of a file.

    Parameters
    ----------
    content : of the file
    places : indices of the elements
    file : which was read
    where : named in errors

    Raises
    ------
    GeometryError : nothing of the file can be meshed
    """
    with _one_line_errors(file.suffix.lower(), where=where):
        return content.mesh(places)


@contextmanager
def _one_line_errors(ending: str, *, where: str) -> Iterator[None]:
    """Turn whatever a reader raises into one line, and suppress what it prints."""
    try:
        with silence_output():
            yield
    except ModuleNotFoundError as missing:
        raise GeometryError(_missing_package(ending, missing, where=where)) from None
    except RecursionError:
        raise GeometryError(f"{where}: it is nested too deeply to be read; export it again") from None
    except MemoryError:
        raise GeometryError(f"{where}: there is not memory enough to read it; simplify it") from None
    except Exception as problem:  # the readers raise whatever a broken file leads them to
        reason = f" ({problem})" if str(problem) else ""
        text = f"{where}: it cannot be read as {ending[1:].upper()}{reason:.160}; export it again as STL, OBJ or PLY"
        raise GeometryError(" ".join(text.split())) from None


def _missing_package(ending: str, missing: ModuleNotFoundError, *, where: str) -> str:
    """Return the line that says what to install."""
    package = str(missing.name).partition(".")[0]
    extra = EXTRAS.get(package, package)
    need = f'{where}: {ending[1:].upper()} files need the package "{package}", the extra "{extra}" of this program'
    return f'{need}; install it with that: pipx install --force ".[{extra}]" or pip install "rocking-assess[{extra}]"'


EXTRAS = {"cascadio": "step", "rhino3dm": "rhino", "ifcopenshell": "ifc"}
"""The extra of this program that brings each package."""
