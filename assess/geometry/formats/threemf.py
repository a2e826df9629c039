"""3MF packages (3MF Core Specification 1.3, and the paths of its Production Extension): every instance of every mesh.

Unpacked within limits: what a package announces is checked before any of it is made. Parsed with Python's own XML
parser, because trimesh loses some instances of components within components.
"""

from __future__ import annotations

import zlib
from array import array
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from xml.parsers import expat
from zipfile import BadZipFile, ZipFile, ZipInfo

import numpy as np

from assess.geometry.formats.mesh_file import (
    MAX_INSTANCES,
    MAX_TRIANGLES,
    Element,
    ElementMesh,
    MeshFile,
    file_from_meshes,
    transform,
)
from spectra.arrays import FloatArray, IntArray, plain_float, plain_int

UNITS = {  # 3MF Core Specification 1.3, 3.4: the attribute unit of <model> [m]
    "micron": 1e-6,
    "millimeter": 1e-3,
    "centimeter": 1e-2,
    "inch": 0.0254,
    "foot": 0.3048,
    "meter": 1.0,
}
ROOT = "3d/3dmodel.model"  # where the model is, if the package does not say otherwise
ObjectKey = tuple[str, str]  # the part of the package in which an object stands, and its id


@dataclass(frozen=True)
class PlacedObject:
    """A placed object: an item of the build, or a component of another object."""

    key: ObjectKey
    matrix: FloatArray


@dataclass
class PackageObject:
    """An object while it is read."""

    name: str
    corners: array[float] = field(default_factory=lambda: array("d"))
    triangles: array[int] = field(default_factory=lambda: array("q"))
    components: list[PlacedObject] = field(default_factory=list)

    @property
    def vertices(self) -> FloatArray:
        return np.frombuffer(self.corners, dtype=np.float64).reshape(-1, 3) if self.corners else np.empty((0, 3))

    @property
    def faces(self) -> IntArray:
        nothing = np.empty((0, 3), dtype=np.int64)
        return np.frombuffer(self.triangles, dtype=np.int64).reshape(-1, 3) if self.triangles else nothing


@dataclass
class ModelPart:
    """A model part of a package while it is read."""

    unit: str = "millimeter"
    objects: dict[ObjectKey, PackageObject] = field(default_factory=dict)
    items: list[PlacedObject] = field(default_factory=list)


def read_3mf(file: Path) -> MeshFile:
    """Read the items of a package's build, z up, in the unit it states or else millimetres."""
    models = {name.lstrip("/").lower(): _parse_model_part(name, data) for name, data in unpack_3mf(file).items()}
    root = models.get(ROOT) or next(iter(models.values()), None)
    if root is None:
        raise ValueError("it holds no 3D model")
    if root.unit not in UNITS:
        raise ValueError(f"its unit {root.unit!r:.30} is none of {', '.join(UNITS)}")
    objects = {key: each for model in models.values() for key, each in model.objects.items()}
    _refuse_many(root.items, objects)
    found = [mesh for item in root.items for mesh in _instances(item, objects, within=())]
    return file_from_meshes(tuple(_number_names(found)), unit=UNITS[root.unit], up="z")


def _refuse_many(items: Sequence[PlacedObject], objects: Mapping[ObjectKey, PackageObject]) -> None:
    """Raise where nested components produce too much, or one contains itself or a missing object."""
    known: dict[ObjectKey, tuple[int, int]] = {}

    def made(key: ObjectKey, within: tuple[ObjectKey, ...]) -> tuple[int, int]:
        """Return the instances and triangles that an object produces."""
        if key in within:
            raise ValueError(f"its object {key[1][:20]} is a component of itself")
        if key not in objects:
            raise ValueError(f"it uses the object {key[1][:20]}, which is not in it")
        if key not in known:
            one = objects[key]
            below = [made(each.key, (*within, key)) for each in one.components]
            known[key] = 1 + sum(n for n, _ in below), len(one.triangles) // 3 + sum(m for _, m in below)
        return known[key]

    instances, triangles = np.sum([(0, 0), *(made(item.key, ()) for item in items)], axis=0, dtype=object)
    if instances > MAX_INSTANCES or triangles > MAX_TRIANGLES:
        raise ValueError(f"its components make more than {MAX_INSTANCES} instances or {MAX_TRIANGLES} triangles")


def _instances(
    use: PlacedObject, objects: Mapping[ObjectKey, PackageObject], *, within: tuple[ObjectKey, ...]
) -> Iterator[ElementMesh]:
    """Yield the meshes of an object where it is used, and of its components."""
    one = objects[use.key]
    if one.triangles:
        owners = tuple(objects[key].name for key in within)
        yield transform(ElementMesh(Element((one.name,), within=owners), one.vertices, one.faces), use.matrix)
    for component in one.components:
        placed = PlacedObject(component.key, use.matrix @ component.matrix)
        yield from _instances(placed, objects, within=(*within, use.key))


def _number_names(meshes: list[ElementMesh]) -> Iterator[ElementMesh]:
    """Number the meshes that share a name; the name itself then means all of them."""
    names = [mesh.element.names[0] for mesh in meshes]
    many = {name for name in names if names.count(name) > 1} if len(set(names)) < len(names) else set()
    count: dict[str, int] = {}
    for name, mesh in zip(names, meshes, strict=True):
        count[name] = count.get(name, 0) + 1
        within = (*mesh.element.within, name)
        own = Element((f"{name}_{count[name]}",), within=within) if name in many else mesh.element
        yield replace(mesh, element=own)


def _parse_model_part(path: str, data: bytes) -> ModelPart:
    """Parse the objects and the build of one model part."""
    model = ModelPart()
    own = path.lstrip("/").lower()
    current = PackageObject("")

    def begin(tag: str, given: dict[str, str]) -> None:
        nonlocal current
        match tag.rsplit(":", 1)[-1]:
            case "vertex":
                current.corners.extend([plain_float(given[axis]) for axis in "xyz"])
            case "triangle":
                current.triangles.extend([plain_int(given[corner]) for corner in ("v1", "v2", "v3")])
            case "object":
                current = PackageObject(given.get("name") or given["id"])
                model.objects[own, given["id"]] = current
            case "component":
                current.components.append(_parse_placed_object(given, own))
            case "item":
                model.items.append(_parse_placed_object(given, own))
            case "model":
                model.unit = given.get("unit", model.unit).lower()

    parser = expat.ParserCreate()
    parser.StartElementHandler = begin
    try:
        parser.Parse(data, True)
    except KeyError as missing:
        raise ValueError(f"its model lacks the attribute {missing}") from None
    return model


def _parse_placed_object(given: Mapping[str, str], own: str) -> PlacedObject:
    """Parse an item or component; it lies in its own part of the package unless it names another."""
    path = next((value for name, value in given.items() if name.rsplit(":", 1)[-1] == "path"), own)
    numbers = [plain_float(word) for word in given.get("transform", "1 0 0 0 1 0 0 0 1 0 0 0").split()]
    if len(numbers) != 12:
        raise ValueError(f"a transformation has {len(numbers)} numbers, not 12")
    matrix = np.eye(4)
    matrix[:3, :] = np.array(numbers).reshape(4, 3).T
    return PlacedObject((path.lstrip("/").lower(), given["objectid"]), matrix)


MAX_RATIO = 100  # times its own size that an archive may unpack to; mesh text packs to a tenth, at most a thirtieth
ALWAYS_ALLOWED = 100_000_000  # bytes that any archive may unpack to
MAX_UNPACKED = 4_000_000_000  # bytes that none may exceed
BLOCK = 1 << 18  # bytes unpacked at a time
PROLOGUE = 1 << 16  # bytes that hold the document type, if there is one


def unpack_3mf(file: Path) -> dict[str, bytes]:
    """Unpack the model parts of a 3MF package by name; nothing where all of it would be too large.

    Raises
    ------
    ValueError : it is no package, or unpacks to too much; a part declares entities
    """
    with ZipFile(file) as package:
        _refuse_large(sum(each.file_size for each in package.infolist()), packed=file.stat().st_size)
        models = [each for each in package.infolist() if each.filename.lower().endswith(".model")]
        found = {each.filename: _unpack(package, each) for each in models}
    for model in found.values():
        if b"<!DOCTYPE" in model[:PROLOGUE].replace(b"\0", b"").upper():
            raise ValueError("it declares a document type, which 3MF forbids")
    return found


def _unpack(package: ZipFile, member: ZipInfo) -> bytes:
    """Unpack a member in blocks, so that zipfile gives no more than it announces."""
    found = bytearray()
    try:
        with package.open(member) as content:
            while block := content.read(BLOCK):
                found += block
    except (BadZipFile, RuntimeError, NotImplementedError, zlib.error) as problem:
        raise ValueError(str(problem)) from None
    return bytes(found)


def _refuse_large(unpacked: int, *, packed: int) -> None:
    if unpacked > min(MAX_UNPACKED, max(ALWAYS_ALLOWED, MAX_RATIO * packed)):
        raise ValueError(f"its {packed / 1e6:.3g} MB would unpack to {unpacked / 1e6:.4g} MB, which no mesh does")
