"""The unmutated cases of whole studies: runs, portfolios, locks, uncertain numbers, fragility, readers of results."""

from __future__ import annotations

import contextlib
import io
import tempfile
from collections.abc import Iterator
from functools import cache
from pathlib import Path

from assess.cli import main
from records.processing import at2_text
from tools.fuzz import projects
from tools.fuzz.fuzz_input import FuzzInput
from tools.fuzz.motions import motion

PROJECT = "project.toml"
RESULTS = "out/results.json"
RUN = ("run", "{}", "--no-report", "--jobs", "1", "-o", "{}/out")
FRAGILITY = ("fragility", "{}", "--json", "--jobs", "1")
BATCH = ("batch", "{}/table.csv", "--template", "{}/template.toml", "--rows-only", "--jobs", "1", "-o", "{}/out")
TABLE = (
    "id,title,site.spectrum.a_g [g],bodies.wall.box.thickness [cm],mechanisms.wall.loads.0.force [kN]\n"
    "A1,First,0.15,60,5\nA2,Second,0.25,0.5 m,\nA3,Third,,55,20 kN\n"
)
CURVES = (
    "#,,,\"generated_by='OpenQuake engine 3.16', investigation_time=50.0, imt='PGA'\"\n"
    "lon,lat,depth,poe-0.05,poe-0.1,poe-0.2,poe-0.4\n"
    "13.40,42.35,0.0,6.0E-01,3.0E-01,9.0E-02,1.5E-02\n13.90,42.10,0.0,5.0E-01,2.0E-01,5.0E-02,8.0E-03\n"
)
ROWS = "pga [g], return_period [years]\n0.05, 30\n0.16, 475\n0.30, 2475\n"
SITE = 'curve = "hazard.csv"\nsite = { longitude = 13.4, latitude = 42.35 }\n'


def runs() -> Iterator[FuzzInput]:
    """Whole assessments, which take tenths of a second."""
    for name, text in (("run", projects.RUN), ("verdict", projects.VERDICT)):
        yield FuzzInput("run", name, {PROJECT: text.encode()}, PROJECT, RUN, shows=RESULTS)


def uncertain() -> Iterator[FuzzInput]:
    """A run with uncertain numbers."""
    yield FuzzInput("uncertain", "run", {PROJECT: projects.UNCERTAIN.encode()}, PROJECT, RUN, shows=RESULTS)


def portfolios() -> Iterator[FuzzInput]:
    """A table of three walls, and its template."""
    files = {"table.csv": TABLE.encode(), "template.toml": projects.WALL.encode()}
    for target in files:
        yield FuzzInput("portfolio", target, files, target, BATCH, shows="out/ranked.csv")


def ledgers() -> Iterator[FuzzInput]:
    """The ledger of that portfolio, all of whose rows are done."""
    files = {"table.csv": TABLE.encode(), "template.toml": projects.WALL.encode()}
    ledger = {"out/ledger.sqlite": made(files, *BATCH)["out/ledger.sqlite"]}
    resume = (*BATCH, "--resume")
    yield FuzzInput("ledger", "resume", {**files, **ledger}, "out/ledger.sqlite", resume, shows="out/ranked.csv")


def locks() -> Iterator[FuzzInput]:
    """A run whose records are locked."""
    yield FuzzInput("lock", "run", locked(), "records.lock.toml", RUN, shows=RESULTS)


def fragilities() -> Iterator[FuzzInput]:
    """Fragility with hazards in the project, in two columns, and from OpenQuake."""
    for name, (hazard, target, files) in {
        "project": (projects.HAZARD, PROJECT, {}),
        "rows": ('curve = "hazard.csv"\n', "hazard.csv", {"hazard.csv": ROWS.encode()}),
        "openquake": (SITE, "hazard.csv", {"hazard.csv": CURVES.encode()}),
    }.items():
        project = (projects.FRAGILITY % hazard).encode()
        yield FuzzInput("fragility", name, {**_motions(), PROJECT: project, **files}, target, FRAGILITY)


def summaries() -> Iterator[FuzzInput]:
    """The row of a run, from its results."""
    yield FuzzInput("summary", "run", {"b.json": results_file()}, "b.json", ("summary", "{}/b.json", "--json"))


def annexes() -> Iterator[FuzzInput]:
    """A run whose report names an annex of verification."""
    named = projects.RUN + '[report]\nverification = "annex/verification.json"\n'
    files = {PROJECT: named.encode(), "annex/verification.json": annex_file()}
    yield FuzzInput("annex", "run", files, "annex/verification.json", RUN, shows=RESULTS)


def reports() -> Iterator[FuzzInput]:
    """Reports again, which take seconds: for the class "report"."""
    for name, data in (("results", results_file()), ("fragility", fragility_file())):
        yield FuzzInput(
            "report", name, {f"{name}.json": data}, f"{name}.json", ("report", f"{{}}/{name}.json", "-o", "{}/out")
        )


@cache
def results_file() -> bytes:
    """results.json of a small run."""
    return made({PROJECT: projects.RUN.encode()}, *RUN)[RESULTS]


@cache
def fragility_file() -> bytes:
    """fragility.json of a small study."""
    project = (projects.FRAGILITY % projects.HAZARD).encode()
    with contextlib.redirect_stdout(io.StringIO()) as printed:
        made({**_motions(), PROJECT: project}, *FRAGILITY)
    return printed.getvalue().encode()


@cache
def annex_file() -> bytes:
    """verification.json of some quick cases, as `assess verify` writes it."""
    with contextlib.redirect_stdout(io.StringIO()) as printed:
        made({}, "verify", "--quick", "--json", "--jobs", "1", "housner_1963")
    return printed.getvalue().encode()


@cache
def locked() -> dict[str, bytes]:
    """A project, its records and their lock."""
    files = {**_motions(), PROJECT: projects.LOCKED.encode()}
    lock = made(files, "records", "select", f"{{}}/{PROJECT}", "--lock", "--jobs", "1")["records.lock.toml"]
    return {**files, PROJECT: (projects.LOCKED + 'lock = "records.lock.toml"\n').encode(), "records.lock.toml": lock}


@cache
def _motions() -> dict[str, bytes]:
    return {f"records/RSN{100 + number}_Q.AT2": at2_text(motion(number)).encode() for number in range(3)}


def made(files: dict[str, bytes], *arguments: str) -> dict[str, bytes]:
    """What a folder holds after a command; {} in its arguments is the folder."""
    with tempfile.TemporaryDirectory() as folder:
        for name, data in files.items():
            (Path(folder) / name).parent.mkdir(parents=True, exist_ok=True)
            (Path(folder) / name).write_bytes(data)
        with contextlib.nullcontext() if "--json" in arguments else contextlib.redirect_stdout(io.StringIO()):
            _end([each.replace("{}", folder) for each in arguments])
        return {
            path.relative_to(folder).as_posix(): path.read_bytes()
            for path in sorted(Path(folder).rglob("*"))
            if path.is_file()
        }


def _end(arguments: list[str]) -> None:
    with contextlib.redirect_stderr(io.StringIO()) as errors:
        try:
            main(arguments)
        except SystemExit as end:
            if end.code not in (0, 1, 3):
                raise RuntimeError(errors.getvalue()) from None
