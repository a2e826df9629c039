"""Project files of tests: a plain wall under an American spectrum, and what a test has in place of it or beside it."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping, Sequence
from datetime import date
from pathlib import Path
from typing import Any

import pytest

from assess.errors import AssessError
from assess.mechanisms.mechanism import Mechanism
from assess.project.build import build
from assess.project.project_file import Project, load
from assess.results import MechanismResult, Results
from assess.study.mechanism_results import parameters
from assess.study.run import run_study
from assess.study.study import Study
from tests.support.motions import write_noise

Table = dict[str, Any]

ASCE7: Table = {"code": "asce7-16", "s_ds": "0.5 g", "s_d1": "0.2 g", "t_l": "6 s"}
EC8: Table = {"code": "ec8", "a_g": "0.25 g", "ground_type": "B"}
NTC: Table = {"code": "ntc2018", "a_g": "0.15 g", "f_0": 2.4, "t_c_star": "0.3 s", "soil": "A"}
OF_VALUES = ("site", "building", "verdict", "records", "analysis", "report")
OF_TABLES = ("materials", "bodies", "mechanisms", "procedures")


def wall(thickness: Any = 0.6, length: Any = 3.0, height: Any = 4.0, *, material: str = "brick", **box: Any) -> Table:
    """Return a body: a box, with its `base` where that is not the origin."""
    return {"material": material, "box": {"thickness": thickness, "length": length, "height": height, **box}}


def block(*bodies: Any, kind: str = "single-block", **more: Any) -> Table:
    """Return a mechanism of these bodies, of the wall if none is named."""
    return {"kind": kind, "blocks": list(bodies or ("wall",)), **more}


def published(p: Any = 1.6, uplift: Any = 0.14, radius: Any = 2.84, **more: Any) -> Table:
    """Return a mechanism by its numbers alone, those of Wall 0a of the thesis."""
    return {"kind": "equivalent-block", "p": p, "uplift": uplift, "radius": radius, **more}


def project_toml(*more: str, **tables: Any) -> str:
    """Return the text of a project file: a plain wall, with `tables` in place of its own or beside them.

    Parameters
    ----------
    more : TOML that follows the tables as it is
    tables : by their names at the top of the file; None leaves one of the wall's out. A text stands for what is
        written in a table: `mechanisms={"wall": 'kind = "single-block"'}`
    """
    plain = {
        "site": {"spectrum": ASCE7},
        "materials": {"brick": {"density": 1800}},
        "bodies": {"wall": wall()},
        "mechanisms": {"wall": block()},
    }
    return tables_toml(*more, **{name: table for name, table in (plain | tables).items() if table is not None})


def tables_toml(*more: str, **tables: Any) -> str:
    """Return a project file, or a part of one, of these `tables` alone; arguments are those of `project_toml`."""
    heads = [f"{name} = {toml(value)}" for name, value in tables.items() if not _is_table(name, value)]
    bodies = [line for name, value in tables.items() if _is_table(name, value) for line in _section(name, value)]
    return "\n".join([*heads, *bodies, *more, ""])


def lines(table: Mapping[str, Any], more: str = "") -> str:
    """Return what is written in a table, followed by `more` TOML."""
    return "\n".join([*(f"{_key(key)} = {toml(value)}" for key, value in table.items()), more])


def body_toml(name: str, form: str, *, material: str = "m") -> str:
    """Return the table of a body, its form as TOML."""
    return f'[bodies.{name}]\nmaterial = "{material}"\n{form}\n'


def box_toml(name: str, size: Sequence[float], base: Sequence[float] = (0, 0, 0), *, material: str = "m") -> str:
    """Return the table of a body that is a box: thickness, length and height, and the middle of its foot."""
    return tables_toml(bodies={name: wall(*size, material=material, base=list(base))})


def mechanism_toml(more: str = "", *, kind: str = "single-block", name: str = "m", blocks: Any = ("wall",)) -> str:
    """Return the table of a mechanism of these blocks, and `more` TOML in it."""
    return f"[mechanisms.{name}]\n{lines({'kind': kind, 'blocks': list(blocks)}, more)}\n"


def write_project(folder: Path, *texts: str | bytes, name: str = "project.toml") -> Path:
    """Write a project file of these texts, one behind the other."""
    (folder / name).write_bytes(b"".join(text if isinstance(text, bytes) else text.encode() for text in texts))
    return folder / name


def load_project(folder: Path, *texts: str | bytes) -> Project:
    """Return the project of these texts, which are written into `folder`."""
    return load(write_project(folder, *texts))


def study_of(folder: Path, *texts: str) -> Study:
    """Return the study of a project file of these texts, which is written into `folder`."""
    return build(load_project(folder, *texts))


def write_blocks(folder: Path, *, records: int, mechanisms: int = 1, **analysis: Any) -> Path:
    """Write a project with so many published blocks and records of 6 s, judged by ASCE 43-05 at 0.2 g."""
    (folder / "records").mkdir(parents=True)
    for seed in range(records):
        write_noise(folder / "records" / f"r{seed:03d}.csv", duration=6.0, seed=seed, amplitude=2.0)
    text = tables_toml(
        site={"spectrum": ASCE7, "pga": "0.2 g"},
        verdict={"basis": "asce43-05"},
        mechanisms={f"m{number}": published(2.0 + 0.01 * number, 0.1) for number in range(mechanisms)},
        records={"files": ["records/*.csv"]},
        analysis={"procedures": ["asce43-05-spectrum", "asce43-05-history"], **analysis},
    )
    return write_project(folder, text)


def replace_once(text: str, old: str, new: str) -> str:
    """Return a text with `new` where `old` stands, which it does once."""
    assert text.count(old) == 1, old
    return text.replace(old, new)


def mechanism_of(folder: Path, *texts: str) -> Mechanism:
    """Return the only mechanism of such a project."""
    (mechanism,) = study_of(folder, *texts).mechanisms
    return mechanism


def parameters_of(folder: Path, *texts: str) -> MechanismResult:
    """Return the parameters of the only mechanism of such a project."""
    (result,) = parameters(study_of(folder, *texts))
    return result


def results_of(folder: Path, *texts: str, jobs: int = 0) -> Results:
    """Return the results of such a project."""
    return run_study(study_of(folder, *texts), jobs=jobs)


def refusal_of(folder: Path, *texts: str) -> str:
    """Return the one line in which such a project is refused."""
    with pytest.raises(AssessError) as caught:
        study_of(folder, *texts)
    assert "\n" not in str(caught.value)
    return str(caught.value)


def toml(value: Any) -> str:
    """Return a value as TOML in one line."""
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{_key(name)} = {toml(each)}" for name, each in value.items()) + " }"
    if isinstance(value, list | tuple):
        return "[" + ", ".join(map(toml, value)) + "]"
    return json.dumps(value, ensure_ascii=False) if isinstance(value, str | bool) else repr(value)


def _section(name: str, table: Mapping[str, Any] | str) -> Iterator[str]:
    """Yield the lines of a table under its header, then those of the tables in it."""
    if isinstance(table, str):
        yield from (f"[{name}]", table)
        return
    inner = {key: value for key, value in table.items() if "." not in name and _is_inner(name, key, value)}
    if name not in OF_TABLES and len(inner) < len(table):
        yield from (f"[{name}]", lines({key: value for key, value in table.items() if key not in inner}))
    for key, value in inner.items():
        yield from _section(f"{name}.{_key(key)}", value)


def _is_table(name: str, value: Any) -> bool:
    return isinstance(value, Mapping) or (isinstance(value, str) and name in (*OF_VALUES, *OF_TABLES))


def _is_inner(name: str, key: str, value: Any) -> bool:
    return isinstance(value, Mapping) or (isinstance(value, str) and (name in OF_TABLES or key == "spectrum"))


def _key(name: str) -> str:
    return name if re.fullmatch(r"[\w-]+", name, re.ASCII) else json.dumps(name)


def as_editors_see(value: Any) -> Any:
    """Return tables of TOML as JSON holds them: a date is a text."""
    if isinstance(value, dict):
        return {key: as_editors_see(each) for key, each in value.items()}
    if isinstance(value, list):
        return [as_editors_see(each) for each in value]
    return value.isoformat() if isinstance(value, date) else value
