"""Geometry files by their endings. Readers of CAD formats import packages of their own, only when such a file comes."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

from assess.errors import GeometryError
from assess.geometry.formats import binary, by_trimesh
from assess.geometry.formats.ifc import read_ifc
from assess.geometry.formats.parts import MeshFile, Part
from assess.geometry.formats.rhino import read_3dm
from assess.geometry.formats.step import read_step

Reader = Callable[[Path], MeshFile]

READERS: Mapping[str, Reader] = {
    ".stl": binary.read_stl,
    ".obj": by_trimesh.read_obj,
    ".ply": binary.read_ply,
    ".off": by_trimesh.read_off,
    ".glb": by_trimesh.read_glb,
    ".gltf": by_trimesh.read_gltf,
    ".3mf": by_trimesh.read_3mf,
    ".step": read_step,
    ".stp": read_step,
    ".3dm": read_3dm,
    ".ifc": read_ifc,
}
WITHOUT_UNIT = (".stl", ".obj", ".ply", ".off")  # formats that do not say theirs
EXTRAS = {".step": "step", ".stp": "step", ".3dm": "rhino", ".ifc": "ifc"}  # of this package, that installs the reader
LONGEST = 40  # letters of such a name
LISTED = 8  # names of a file's parts that an error lists


def read(file: Path, *, where: str) -> MeshFile:
    """All meshes of a geometry file, in its own unit and axes.

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
        raise GeometryError(f"{where}: {problem.strerror or problem} ({file}); check the path") from None
    try:
        return READERS[ending](file)
    except ModuleNotFoundError as missing:
        raise GeometryError(_install(ending, missing, where=where)) from None
    except RecursionError:
        raise GeometryError(f"{where}: it is nested too deeply to be read; export it again") from None
    except Exception as problem:  # the readers raise whatever a broken file leads them to
        reason = f" ({problem})" if str(problem) else ""
        text = f"{where}: it cannot be read as {ending[1:].upper()}{reason:.120}; export it again as STL, OBJ or PLY"
        raise GeometryError(" ".join(text.split())) from None


def chosen(content: MeshFile, element: str | None, *, where: str) -> tuple[Part, ...]:
    """The parts of a file called `element`; all where none is asked for.

    Raises
    ------
    GeometryError : no part is called so, or a part is a surface without its mesh
    """
    found = tuple(each for each in content.parts if element is None or element in each.names)
    bare = [_shown((*each.names, "one without name")[0]) for each in found if not len(each.triangles)]
    if bare:
        raise GeometryError(
            f"{where}: {len(bare)} of its surfaces have no mesh ({', '.join(bare[:LISTED])}); save the file in a "
            "shaded view, or mesh them there"
        )
    if element is not None and not found:
        names = list(dict.fromkeys(_shown(each.names[0]) for each in content.parts if each.names))
        more = f" and {len(names) - LISTED} more" if len(names) > LISTED else ""
        known = f"known: {', '.join(names[:LISTED])}{more}" if names else "its parts have no names; remove the key"
        raise GeometryError(f'{where}: it has no element "{element}"; {known}')
    return found


def _shown(name: str) -> str:
    """A name that came with a file, fit for one line."""
    return "".join(letter for letter in name if letter.isprintable())[:LONGEST]


def _install(ending: str, missing: ModuleNotFoundError, *, where: str) -> str:
    """The line that says what to install."""
    extra = EXTRAS.get(ending)
    if extra is None:
        return f'{where}: the package "{missing.name}" is not installed; install it again: pip install "rocking-assess"'
    return (
        f'{where}: {ending[1:].upper()} files need the package "{missing.name}"; '
        f'install it: pip install "rocking-assess[{extra}]"'
    )
