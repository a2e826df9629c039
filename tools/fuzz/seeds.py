"""The unmutated cases of each class: made by the tests' own writers, and public records where they are present."""

from __future__ import annotations

import importlib.util
import json
import tempfile
from collections.abc import Callable, Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from records.processing import at2_text, csv_text
from tests.support.places import REAL_RECORDS
from tools.fuzz import projects, studies
from tools.fuzz.fuzz_input import FuzzInput
from tools.fuzz.motions import motion
from tools.fuzz.studies import fragility_file, made, results_file

UNIT = Path(__file__).parents[2] / "tests" / "unit"
LARGEST = 140_000  # bytes of a public record that is used: others cost time and show no more
OF_EACH = 3  # public records of each folder
PROJECT = "project.toml"
TARGET = "period [s],acceleration [g]\n0,0.2\n0.1,0.5\n0.5,0.5\n1,0.25\n4,0.0625\n"
FLATFILE = (
    "Record Sequence Number,Earthquake Name,YEAR,Station Name,Earthquake Magnitude,ClstD (km),Vs30 (m/s),"
    "File Name (Horizontal 1)\n"
    "100,Quake A,1980,Here,6.5,20,400,RSN100_Q.AT2\n101,Quake B,1981,There,7.0,40,300,RSN101_Q.AT2\n"
    "102,Quake C,1982,Elsewhere,5.5,12.5,760,RSN102_Q.AT2\n"
)


@cache
def seeds(group: str) -> tuple[FuzzInput, ...]:
    """The cases of a class."""
    return tuple(GROUPS[group]())


def seed_case(group: str, name: str) -> FuzzInput:
    """One of them by its name."""
    return next(case for case in seeds(group) if case.name == name)


def _projects() -> Iterator[FuzzInput]:
    for name in ("ONE", "TWO", "FOUR", "NTC"):
        files = {PROJECT: getattr(projects, name).encode()}
        yield FuzzInput("project", name.lower(), files, PROJECT, ("parameters", "{}", "--json"))
        yield FuzzInput("project", f"{name.lower()} checked", files, PROJECT, ("check", "{}"))
    files = {PROJECT: projects.NTC.encode()}
    yield FuzzInput("project", "spectrum", files, PROJECT, ("spectrum", "{}", "--json"))
    yield FuzzInput(
        "project", "envelope", {PROJECT: projects.RUN.encode()}, PROJECT, ("envelope", "{}", "--json", "--jobs", "1")
    )


def _meshes() -> Iterator[FuzzInput]:
    for name, data in _mesh_files().items():
        ending = name.rpartition(".")[2].lower()
        more = 'element = "south"' if ending == "ifc" else ""
        project = (projects.MESH % (name, more)).encode()
        yield FuzzInput("mesh", name, {PROJECT: project, name: data}, name, ("parameters", "{}", "--json"))


def _geometries() -> Iterator[FuzzInput]:
    for name, data in _mesh_files().items():
        yield FuzzInput("geometry", name, {name: data}, name, ("geometry", f"{{}}/{name}", "--json"))


@cache
def _module(path: str) -> Any:
    """A test module, for its writers; None where what it needs is not installed."""
    import pytest

    spec = importlib.util.spec_from_file_location(Path(path).stem, UNIT / path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    try:
        spec.loader.exec_module(module)
    except pytest.skip.Exception:
        return None
    return module


@cache
def _mesh_files() -> dict[str, bytes]:
    plain, trimesh = _module("assess/geometry/test_mesh.py"), _module("assess/geometry/formats/test_gltf.py")
    wall = plain.WALL.vertices, plain.WALL.triangles
    files = {name.lower(): write(*wall) for name, write in plain.WRITERS.items()}
    header, content = trimesh.gltf(*wall, [{"mesh": 0}])
    files |= {
        "wall.off": trimesh.off(*wall),
        "wall.glb": trimesh.glb(header, content),
        "wall.gltf": _embedded(header, content),
        "wall.3mf": trimesh.mf3(*wall, unit="meter", items='<item objectid="1"/>'),
    }
    return files | dict(_cad_files())


def _embedded(header: dict[str, Any], content: bytes) -> bytes:
    from base64 import b64encode

    uri = "data:application/octet-stream;base64," + b64encode(content).decode()
    buffers = [{"byteLength": len(content), "uri": uri}]
    return json.dumps(header | {"buffers": buffers}, indent=1).encode()


def _cad_files() -> Iterator[tuple[str, bytes]]:
    step, rhino, ifc = (_module(f"assess/geometry/formats/test_{name}.py") for name in ("step", "rhino", "ifc"))
    with tempfile.TemporaryDirectory() as folder:
        if step:
            yield "wall.step", step.step(step.CUBE * step.SIZES, prefix="$").encode()
        if rhino:
            model = rhino.model_in("Meters")
            model.Objects.AddMesh(rhino.mesh(rhino.CUBE * np.array([1.25, 3.0, 8.5])), rhino.called("wall"))
            yield "wall.3dm", rhino.written(Path(folder), model).read_bytes()
        if ifc:
            ifc.building(Path(folder) / "wall.ifc", prefix=None)
            yield "wall.ifc", (Path(folder) / "wall.ifc").read_bytes()


def _records() -> Iterator[FuzzInput]:
    for name, (text, *_) in _module("records/test_formats.py").MADE.items():
        yield _record(f"{name}.dat", text.encode("latin-1"))
    yield _record("own.csv", csv_text(motion(0)).encode())
    for name, data in _waveforms().items():
        yield _record(name, data, "--unit", "mm/s2")
    for folder in sorted(REAL_RECORDS.iterdir()) if REAL_RECORDS.is_dir() else ():
        small = [
            path for path in sorted(folder.glob("[!.]*")) if path.stat().st_size < LARGEST and path.suffix != ".gz"
        ]
        for path in small[:: max(len(small) // OF_EACH, 1)][:OF_EACH]:
            stated = ("--unit", "g", "--step", "0.01") if folder.name == "plain" else ()
            yield _record(path.name, path.read_bytes(), *stated)


def _record(name: str, data: bytes, *more: str) -> FuzzInput:
    plain = name.replace(" ", "_")
    return FuzzInput("record", name, {plain: data}, plain, ("records", "list", f"{{}}/{plain}", "--json", *more))


@cache
def _waveforms() -> dict[str, bytes]:
    obspy = _module("records/test_by_obspy.py")
    with tempfile.TemporaryDirectory() as folder:
        sac = Path(folder) / "quake.sac"
        obspy.trace().write(str(sac), format="SAC")
        return {
            "quake.mseed": obspy.miniseed(Path(folder), obspy.trace()).read_bytes(),
            "quake.sac": sac.read_bytes(),
        }


@cache
def _folder() -> dict[str, bytes]:
    files = {f"motions/RSN{100 + number}_Q.AT2": at2_text(motion(number)).encode() for number in range(3)}
    return files | {"target.csv": TARGET.encode(), "flat.csv": FLATFILE.encode()}


SELECT = ("records", "select", "{}/motions", "--target", "{}/target.csv", "--count", "2", "--jobs", "1")
SELECT += ("--scale-limits", "0.001", "1000", "--json")


def _flatfiles() -> Iterator[FuzzInput]:
    yield FuzzInput("flatfile", "select", _catalogued(), "flat.csv", (*SELECT, "--flatfile", "{}/flat.csv"))
    one = {"target.csv": TARGET.encode()}
    yield FuzzInput(
        "flatfile", "spectrum", one, "target.csv", ("spectrum", "--code", "table", "--file", "{}/target.csv", "--json")
    )


@cache
def _catalogued() -> dict[str, bytes]:
    """The folder with its catalogue, made by `assess records index`."""
    return made(_folder(), "records", "index", "{}/motions", "--jobs", "1")


def _catalogues() -> Iterator[FuzzInput]:
    files = _catalogued()
    (name,) = (name for name in files if name.startswith("motions/") and not name.endswith(".AT2"))
    yield FuzzInput("catalogue", "select", files, name, SELECT)
    yield FuzzInput("catalogue", "index", files, name, ("records", "index", "{}/motions", "--jobs", "1", "--json"))
    yield FuzzInput("catalogue", "spectra", files, name, ("records", "spectra", "{}/motions", "--csv", "--jobs", "1"))


def _results() -> Iterator[FuzzInput]:
    files = {"a.json": results_file(), "b.json": results_file()}
    yield FuzzInput("results", "diff", files, "b.json", ("diff", "{}/a.json", "{}/b.json", "--json"))


def _options() -> Iterator[FuzzInput]:
    files = {
        **_catalogued(),
        PROJECT: projects.ONE.encode(),
        "run.toml": projects.RUN.encode(),
        "a.json": results_file(),
        "fragility.json": fragility_file(),
        "table.csv": studies.TABLE.encode(),
        "template.toml": projects.WALL.encode(),
        **{name: data for name, data in _mesh_files().items() if name == "wall.off"},
        "m.csv": csv_text(motion(1)).encode(),
    }
    one, two = "{}/motions/RSN100_Q.AT2", "{}/m.csv"
    for name, arguments in {
        "check": ("check", "{}"),
        "parameters": ("parameters", "{}"),
        "spectrum": ("spectrum", "{}"),
        "spectrum --code": ("spectrum", "--code", "ec8", "--a-g", "0.2 g", "--ground-type", "B"),
        "diff": ("diff", "{}/a.json", "{}/a.json"),
        "records list": ("records", "list", one, two),
        "records convert": ("records", "convert", one, "-o", "{}/out.csv"),
        "records spectra": ("records", "spectra", one),
        "records scale": ("records", "scale", one, two, "--target", "{}/target.csv"),
        "records select": SELECT[:-1],
        "records index": ("records", "index", "{}/motions", "--jobs", "1"),
        "new": ("new", "{}/made", "--example", "single_wall"),
        "schema": ("schema",),
        "geometry": ("geometry", "{}/wall.off"),
        "envelope": ("envelope", "{}/run.toml", "--jobs", "1"),
        "run": ("run", "{}/run.toml", *studies.RUN[2:]),
        "batch": studies.BATCH,
        "summary": ("summary", "{}/a.json"),
        "verify": ("verify", "housner_1963", "--jobs", "1"),
        "verify --for": ("verify", "--list", "--for", "{}"),
        "report": ("report", "{}/fragility.json", "-o", "{}/out"),
    }.items():
        yield FuzzInput("options", name, files, "", arguments)


GROUPS: Mapping[str, Callable[[], Iterator[FuzzInput]]] = {
    "project": _projects,
    "mesh": _meshes,
    "geometry": _geometries,
    "record": _records,
    "flatfile": _flatfiles,
    "results": _results,
    "summary": studies.summaries,
    "catalogue": _catalogues,
    "options": _options,
    "run": studies.runs,
    "uncertain": studies.uncertain,
    "portfolio": studies.portfolios,
    "ledger": studies.ledgers,
    "lock": studies.locks,
    "fragility": studies.fragilities,
    "annex": studies.annexes,
    "report": studies.reports,
}
SHARES: Mapping[str, int] = {
    "project": 20, "mesh": 12, "geometry": 6, "record": 30, "flatfile": 6, "results": 5, "summary": 4, "catalogue": 6,
    "options": 5, "run": 5, "uncertain": 2, "portfolio": 6, "ledger": 4, "lock": 4, "fragility": 5, "annex": 4,
    "report": 0,
}  # fmt: skip
"""How many of a hundred or so inputs each class has; none of a class that is run only where it is named."""
