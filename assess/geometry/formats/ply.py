"""PLY files, text and binary of either byte order: vertices, faces, and triangle strips.

What a header announces is compared with the size of the file before any of it is read.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from assess.geometry.formats.mesh_file import (
    POINT_CLOUD,
    Element,
    MeshFile,
    fan_triangles,
    file_from_meshes,
    make_element_mesh,
)
from assess.geometry.formats.text_blocks import parse_words, rows_by_length
from spectra.arrays import BoolArray, FloatArray, IntArray

SHORT = {"char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4"}
SIZED = {"int8": "i1", "uint8": "u1", "int16": "i2", "uint16": "u2", "int32": "i4", "uint32": "u4"}
TYPES = {**SHORT, **SIZED, "float": "f4", "double": "f8", "float32": "f4", "float64": "f8"}
ORDERS = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}
CORNERS = ("vertex_indices", "vertex_index")
RESTART = -1  # index that ends a strip
LONGEST = 1 << 20  # bytes of a header
LEAST = 3  # corners of a face


@dataclass(frozen=True)
class Property:
    """One property of an element; counted: type of the number of values of a list, None for one value."""

    name: str
    kind: str
    counted: str | None = None


@dataclass(frozen=True)
class ElementTable:
    """An element of the header: so many records of these properties."""

    name: str
    count: int
    properties: tuple[Property, ...]


@dataclass(frozen=True)
class Ragged:
    """The values of a list property, record after record, and how many each record has [n]."""

    values: IntArray
    sizes: IntArray


PlyColumns = Mapping[str, NDArray[Any] | Ragged]
TableReader = Callable[
    [ElementTable, int], tuple[PlyColumns, int]
]  # the values of a table that begins at a place, and where it ends


def read_ply(file: Path) -> MeshFile:
    """Read the mesh of a PLY file: its faces and its triangle strips.

    Raises
    ------
    ValueError : it is no PLY file, or ends before it has what its header announces
    """
    data = file.read_bytes()
    order, tables, start = _header(data[:LONGEST])
    words = np.empty(0) if order else parse_words(data, start)
    take: TableReader = partial(_binary, data, order) if order else partial(_text, words)
    found: dict[str, PlyColumns] = {}
    at = start if order else 0
    for table in tables:
        if table.count and table.properties:
            found[table.name], at = take(table, at)
    if len(data[at:].strip(b"\0 \t\r\n")) if order else at < len(words):
        raise ValueError("it goes on behind what its header announces")
    vertices = _vertices(found.get("vertex", {}))
    triangles = [*_faces(found.get("face", {})), *_strips(found.get("tristrips", {}))]
    if len(vertices) and not any(len(each) for each in triangles):
        raise ValueError(POINT_CLOUD.format(count=len(vertices)))
    nothing = np.empty((0, 3), dtype=np.int64)
    return file_from_meshes([make_element_mesh(Element(), vertices, np.concatenate([nothing, *triangles]))])


def _header(data: bytes) -> tuple[str, tuple[ElementTable, ...], int]:
    """Return the byte order (empty for text), the elements, and where their data begin."""
    end = data.find(b"end_header")
    stop = data.find(b"\n", end) + 1
    if not data.startswith(b"ply") or end < 0 or not stop:
        raise ValueError("it has no header of a PLY file")
    words = [line.split() for line in data[:end].decode("latin-1").splitlines()]
    order, tables = None, []
    for line in (line for line in words[1:] if line):
        match line:
            case ["format", form, *_] if form in ORDERS:
                order = ORDERS[form]
            case ["element", name, count] if count.isascii() and count.isdigit():
                tables.append(ElementTable(name, int(count), ()))
            case ["property", "list", counted, kind, name] if tables and {counted, kind} <= set(TYPES):
                tables[-1] = _add_property(tables[-1], Property(name, TYPES[kind], TYPES[counted]))
            case ["property", kind, name] if tables and kind in TYPES:
                tables[-1] = _add_property(tables[-1], Property(name, TYPES[kind]))
            case ["comment" | "obj_info", *_]:
                pass
            case _:
                raise ValueError(f'its header has the line "{" ".join(line)[:40]}"')
    if order is None:
        raise ValueError("its header does not say the format")
    return order, tuple(tables), stop


def _add_property(table: ElementTable, one: Property) -> ElementTable:
    return ElementTable(table.name, table.count, (*table.properties, one))


def _text(words: FloatArray, table: ElementTable, at: int) -> tuple[PlyColumns, int]:
    """Return the columns of a text table, whose words are numbers."""
    if all(one.counted is None for one in table.properties):
        width = len(table.properties)
        end = _end_of_table(table, at, width, len(words))
        rows = words[at:end].reshape(-1, width)
        return {one.name: rows[:, k] for k, one in enumerate(table.properties)}, end
    _end_of_table(table, at, len(table.properties), len(words))
    return _text_lists(words, table, at)


def _text_lists(words: FloatArray, table: ElementTable, at: int) -> tuple[PlyColumns, int]:
    """Return the lists of a text table, all at once where every record is as long as the first."""
    width, place = 0, {}
    for one in table.properties:
        place[one.name] = width
        width += 1 if one.counted is None else 1 + _text_size(words, at + width)
    end = at + table.count * width
    lists = [one.name for one in table.properties if one.counted is not None]
    if end <= len(words):
        rows = words[at:end].reshape(-1, width)
        if all((rows[:, place[name]] == rows[0, place[name]]).all() for name in lists):
            return {
                name: Ragged(
                    rows[:, place[name] + 1 : place[name] + 1 + int(rows[0, place[name]])].astype(np.int64).reshape(-1),
                    rows[:, place[name]].astype(np.int64),
                )
                for name in lists
            }, end
    return _text_records(words, table, at)


def _text_records(words: FloatArray, table: ElementTable, at: int) -> tuple[PlyColumns, int]:
    """Return the lists of a text table, record by record."""
    lists = [one.name for one in table.properties if one.counted is not None]
    kept: dict[str, BoolArray] = {name: np.zeros(len(words), dtype=np.bool_) for name in lists}
    sizes: dict[str, list[int]] = {name: [] for name in lists}
    for _ in range(table.count):
        for one in table.properties:
            size = 0 if one.counted is None else _text_size(words, at)
            if one.counted is not None:
                kept[one.name][at + 1 : at + 1 + size] = True
                sizes[one.name].append(size)
            at += 1 + size
            if at > len(words):
                raise ValueError(_truncated(table))
    found = {name: Ragged(words[kept[name]].astype(np.int64), np.array(sizes[name], dtype=np.int64)) for name in lists}
    return found, at


def _text_size(words: FloatArray, at: int) -> int:
    """Return the length of a text list."""
    size = words[at] if at < len(words) else 0.0
    if not 0.0 <= size < len(words) or size != int(size):
        raise ValueError(f"a list of {size:g} values")
    return int(size)


def _binary(data: bytes, order: str, table: ElementTable, at: int) -> tuple[PlyColumns, int]:
    """Return the columns of a binary table, all at once where every record is as long as the first."""
    fields: list[Any] = []
    place = at
    for k, one in enumerate(table.properties):
        if one.counted is None:
            fields.append((f"{k}", order + one.kind))
        else:
            size = _binary_size(data, order + one.counted, place, table)
            fields += [(f"size {k}", order + one.counted), (f"{k}", order + one.kind, (size,))]
        place = at + np.dtype(fields).itemsize
    record = np.dtype(fields)
    least = sum(np.dtype(one.counted or one.kind).itemsize for one in table.properties)
    _end_of_table(table, at, least, len(data))
    end = at + table.count * record.itemsize
    lists = {k: one.name for k, one in enumerate(table.properties) if one.counted is not None}
    rows = np.frombuffer(data, record, count=table.count, offset=at) if end <= len(data) else None
    if rows is None or any((rows[f"size {k}"] != rows[f"size {k}"][0]).any() for k in lists):
        if not lists:
            raise ValueError(_truncated(table))
        return _binary_records(data, order, table, at)
    return {
        one.name: Ragged(rows[f"{k}"].astype(np.int64).reshape(-1), rows[f"size {k}"].astype(np.int64))
        if k in lists
        else rows[f"{k}"]
        for k, one in enumerate(table.properties)
    }, end


def _binary_records(data: bytes, order: str, table: ElementTable, at: int) -> tuple[PlyColumns, int]:
    """Return the lists of a binary table, record by record."""
    kinds = [(one.name, one.counted, np.dtype(one.kind).itemsize) for one in table.properties]
    values: dict[str, bytearray] = {name: bytearray() for name, counted, _ in kinds if counted is not None}
    sizes: dict[str, list[int]] = {name: [] for name in values}
    for _ in range(table.count):
        for name, counted, width in kinds:
            if counted is None:
                at += width
                continue
            size = _binary_size(data, order + counted, at, table)
            at += int(counted[1])
            values[name] += data[at : at + size * width]
            sizes[name].append(size)
            at += size * width
        if at > len(data):
            raise ValueError(_truncated(table))
    kind = {one.name: order + one.kind for one in table.properties}
    return {
        name: Ragged(np.frombuffer(bytes(values[name]), kind[name]).astype(np.int64), np.array(sizes[name], np.int64))
        for name in values
    }, at


def _binary_size(data: bytes, kind: str, at: int, table: ElementTable) -> int:
    """Return the length of a binary list."""
    if at + int(kind[2]) > len(data):
        raise ValueError(_truncated(table))
    size = int(np.frombuffer(data, kind, count=1, offset=at)[0])
    if not 0 <= size <= len(data) - at:
        raise ValueError(_truncated(table))
    return size


def _end_of_table(table: ElementTable, at: int, width: int, available: int) -> int:
    """Return where a table of records of at least this width ends; raise ValueError beyond the file's end."""
    end = at + table.count * width
    if end > available:
        raise ValueError(_truncated(table))
    return end


def _truncated(table: ElementTable) -> str:
    return f'it announces {table.count} of "{table.name[:20]}" and ends before them'


def _vertices(found: PlyColumns) -> FloatArray:
    """Return the positions [n, 3]."""
    axes = [found.get(axis) for axis in "xyz"]
    columns = [axis for axis in axes if isinstance(axis, np.ndarray)]
    if len(columns) < len(axes):
        raise ValueError("its vertices have no x, y and z")
    points = np.empty((len(columns[0]), 3))
    for k, column in enumerate(columns):
        points[:, k] = column
    return points


def _corners(found: PlyColumns) -> Ragged | None:
    """Return the list of corners of faces or strips."""
    lists = [each for name in CORNERS if isinstance(each := found.get(name), Ragged)]
    return lists[0] if lists else None


def _faces(found: PlyColumns) -> Iterator[IntArray]:
    """Return the triangles of the faces."""
    corners = _corners(found)
    if corners is not None:
        for _, rows in rows_by_length(corners.values, corners.sizes):
            if rows.shape[1] >= LEAST:
                yield fan_triangles(rows)


def _strips(found: PlyColumns) -> Iterator[IntArray]:
    """Return the triangles of strips: each corner from the third on closes one, every other one reversed."""
    corners = _corners(found)
    if corners is None:
        return
    ends = np.cumsum(corners.sizes)
    indices = np.insert(corners.values, ends, RESTART)  # a record ends a strip too
    places = np.arange(len(indices))
    since = places - np.maximum.accumulate(np.where(indices == RESTART, places, -1))  # 1 at the start of a strip
    last = np.flatnonzero(since >= LEAST)
    a, b, c = indices[last - 2], indices[last - 1], indices[last]
    odd = since[last] % 2 == 0
    yield np.column_stack([np.where(odd, b, a), np.where(odd, a, b), c])
