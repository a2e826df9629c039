"""What one can do: ask one mechanism for its motions and checks, run a project and write its report, or run many.

`assess run` does what `load`, `run` and `write_report` do, with its own progress and exit code. What is heavy is
imported when a verb is called: the process that gives out the projects of a portfolio needs none of it, and a worker
imports `assess_project` by its name.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Literal, overload

from assess.errors import AssessError, OutputError, ProjectError
from assess.portfolio.tasks import Job, ProjectRow
from records.errors import RecordError
from spectra.errors import SpectrumError

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from pandas import DataFrame

    from assess.codes.check import Check
    from assess.codes.context import Building
    from assess.codes.verdict import Verdict
    from assess.dynamics.packing import Equation
    from assess.dynamics.pulses import Envelope
    from assess.model.structure import Structure
    from assess.outputs.writing import TellMessage
    from assess.portfolio.batch import Portfolio
    from assess.portfolio.projects import KeyColumn, Task
    from assess.portfolio.tasks import Keep
    from assess.project.project_file import Project
    from assess.project.retrofit import Retrofit
    from assess.results import Results
    from assess.results.fragility import FragilityResults
    from assess.study.block import Block
    from assess.study.motions import Motions
    from assess.study.response import RockingResponse
    from assess.study.study import Progress, Study
    from records.pulses import PulseShape
    from records.record import Record
    from spectra.arrays import FloatArray
    from spectra.spectrum import Spectrum


PROBES = ("1", "0.01", "100")
"""Numbers of which one at least is within the range of any key, in a unit of its dimension."""
Tell = Callable[[str], None]
"""Called with a line about what was found."""


@overload
def respond(
    block: Block, records: Record, *, scale: float = 1.0, equation: Equation | None = None
) -> RockingResponse: ...
@overload
def respond(
    block: Block, records: Sequence[Record], *, scale: float = 1.0, equation: Equation | None = None
) -> Motions: ...
def respond(
    block: Block, records: Record | Sequence[Record], *, scale: float = 1.0, equation: Equation | None = None
) -> RockingResponse | Motions:
    """Solve the rocking motion of a mechanism from rest under a record, or under each of several.

    A block that rocks to one side is solved with its rebound, half of it and one and a half, and the worst is returned,
    as in a run.

    Parameters
    ----------
    block : the mechanism
    records : acceleration of the ground at its base [m/s2]: one record, or a list of them
    scale : factor on every record [-]; a negative one reverses its polarity
    equation : "exact" or "linearised"; linearised for equivalent blocks and exact for all others where None

    Returns
    -------
    The motion: `overturned`, `max_ratio` [-], nan where it overturned, and the history `time` [n] [s], `rotation` [n]
    [rad]. Of a list, the motions in its order: `motions[0]` is the first, and `motions.table()` a DataFrame with a row
    for each

    Raises
    ------
    MechanismError : the mechanism stands only by ties or forces that are not shown to last
    RecordError : something is not one horizontal record of finite samples, or the scale is no finite number
    """
    from assess.study.motions import Motions
    from assess.study.response import respond_at_worst_rebound
    from records.errors import RecordError
    from records.record import Record as Known
    from records.record import is_vertical

    _check_block(block)
    alone = not isinstance(records, tuple | list)
    several: Any = [records] if alone else records
    if not several:
        raise RecordError("records: none; give one record or several")
    for each in several:
        if isinstance(each, Known) and is_vertical(each.component):
            raise RecordError(f'record "{each.id}" is vertical; give a horizontal ground motion')
    kind = block.equation if equation is None else equation
    found = tuple(
        respond_at_worst_rebound(block.rocking, each, rebounds=block.mechanism.rebounds, scale=scale, equation=kind)
        for each in several
    )
    return found[0] if alone else Motions(block.name, found)


def envelope(
    block: Block,
    pulse: str | PulseShape,
    *,
    frequency: Sequence[float] | FloatArray,
    amplitude: Sequence[float] | FloatArray,
    equation: Equation | None = None,
    jobs: int = 0,
) -> Envelope:
    """Find which pulses of a grid overturn a mechanism, in the worse polarity.

    Parameters
    ----------
    block : the mechanism
    pulse : name of a pulse of `records.pulses.PULSE_SHAPES`, such as "sine", or a shape made by
        `records.pulses.pulse_shape`
    frequency : rising frequencies of the pulse [n] [Hz]
    amplitude : rising peak accelerations [m] [m/s2]
    equation : as for `respond`
    jobs : threads, 0 for all cores; the result does not depend on it

    Returns
    -------
    The outcome of each pulse [n, m], and at each frequency the least amplitude that overturns [n] [m/s2]
    """
    from assess.study.envelopes import find_envelope as find

    _check_block(block)
    _check_jobs(jobs)
    return find(
        block.rocking,
        pulse,
        frequency=frequency,
        amplitude=amplitude,
        equation=block.equation if equation is None else equation,
        threads=jobs,
    )


def answers(
    block: Block,
    target: Spectrum,
    *,
    procedures: Sequence[str] | None = None,
    knowledge_level: str | None = None,
    records: Record | Sequence[Record] = (),
    base_elevation: float | None = None,
    building: Building | None = None,
    jobs: int = 0,
) -> tuple[Check, ...]:
    """Return what the procedures of the codes say of a mechanism on a spectrum.

    The rules are those of a project: a check that lacks an input is not answered, and its reason names the remedy. The
    records act at the base as they are: above the ground nothing amplifies them, and a pass by them is no answer.

    Parameters
    ----------
    block : the mechanism
    target : elastic spectrum of the site, at its own peak ground acceleration
    procedures : names such as "ntc2018-nonlinear"; where None, those that decide under the code of the spectrum, by
        histories only with records: a spectrum of ntc2018, ntc2008, ec8 or nzs1170.5 has such a default
    knowledge_level : "LC1", "LC2" or "LC3", for the Italian codes
    records : horizontal ground motions, taken unscaled; without any, histories are not answered
    base_elevation : height of the mechanism's base above the ground [m]; as it is drawn over the lowest body where
        None, which stands on the ground
    building : the structure below the mechanism
    jobs : threads that share the time histories, 0 for all cores

    Raises
    ------
    ProcedureError : a procedure or a level of knowledge is not known, none is given and there is no default, or a
        record is vertical; the text lists the procedures
    RecordError : something is no record of finite samples
    """
    from assess.study.block_answers import answers as find

    _check_block(block)
    _check_jobs(jobs)
    _check_site(target, building)
    return find(
        block.mechanism,
        target,
        procedures=procedures,
        knowledge_level=knowledge_level,
        records=records,
        base_elevation=base_elevation,
        lowest=block.lowest,
        building=building,
        threads=jobs,
    )


def read_building(
    *files: str | Path,
    unit: float | None = None,
    up: Literal["y", "z"] | None = None,
    density: float | Mapping[str, float] | None = None,
) -> Structure:
    """Read a building from an IFC model or meshes: its walls, floors and other parts, and how they touch.

    Parameters
    ----------
    files : of one building: IFC, STL, OBJ, PLY, OFF, GLB, glTF, 3MF, STEP or Rhino .3dm
    unit : of the files' coordinates [m]; their own where None, metres where they state none
    up : axis of the files that points up, "y" or "z"; "y" for glTF and "z" for all others where None
    density : of the masonry [kg/m3], or of each material by its name; what the model states where None, or else
        1800 kg/m3 for masonry and 1000 kg/m3 for floors, roofs and vaults, with a warning

    Returns
    -------
    `parts`, `contacts`, `storeys`, `left_out`; `table()` lists the parts

    Raises
    ------
    GeometryError : a file cannot be read, or nothing in it is masonry
    """
    from assess.errors import GeometryError
    from assess.model.structure_reading import read_structure

    if not files or not all(isinstance(file, str | Path) for file in files):
        raise GeometryError(f"files = {files!r:.60}: give the paths of one or more model files")
    if up not in ("y", "z", None):
        raise GeometryError(f'up = {up!r:.60}: write "y" or "z"')
    given = list(density.values()) if isinstance(density, Mapping) else [] if density is None else [density]
    if wrong := [each for each in given if not (isinstance(each, int | float) and 0.0 < each < float("inf"))]:
        raise GeometryError(f"density = {wrong[0]!r:.60}: give a positive number [kg/m3]")
    return read_structure([Path(file) for file in files], unit=unit, up=up, density=density)


def load(path: str | Path, *, before: str | Path | None = None) -> Project:
    """Read a project file.

    Parameters
    ----------
    path : of the project file, or its folder
    before : results.json of the state before the works, in place of that which `[verdict] before` names

    Raises
    ------
    ProjectError : the file cannot be read, or holds an unknown key, a wrong unit or a wrong value
    """
    from assess.errors import ProjectError
    from assess.project.project_file import load as read

    if not isinstance(path, str | Path):
        raise ProjectError(f"{path!r:.60} is no path; give a project file or its folder")
    if not isinstance(before, str | Path | None):
        raise ProjectError(f"before = {before!r:.60}: give the path of a results.json")
    return read(Path(path), before=before)


@dataclass(frozen=True)
class Run:
    """A project that has been assessed.

    results : the frozen tree that results.json holds
    """

    project: Project
    results: Results

    def __repr__(self) -> str:
        verdict = "no verdict" if self.verdict is None else self.verdict.outcome.value
        count = len(self.results.mechanisms)
        return f"Run({self.project.path.name!r}, {count} mechanism{'' if count == 1 else 's'}, {verdict})"

    def _repr_html_(self) -> str:
        return self.results._repr_html_()

    @property
    def verdict(self) -> Verdict | None:
        """What decides, and how."""
        return self.results.verdict

    def table(self, name: str) -> DataFrame:
        """Return a table of the results: "parameters", "checks", "histories", …; an unknown name lists all."""
        from assess.results.table import table

        return table(self.results, name)

    def figure(self, name: str, *, mechanism: str | None = None) -> Figure:
        """Return a figure of the report by its name, such as "capacity"; an unknown name lists all."""
        from reports.assessment import report_figure

        return report_figure(name, self.results, mechanism=mechanism)


def run(project: Project | str | Path, *, jobs: int = 0, progress: Progress | None = None) -> Run:
    """Assess every mechanism of a project.

    Parameters
    ----------
    project : as `load` reads it, or the path of its file
    jobs : threads, 0 for all cores; the results do not depend on it
    progress : is called with (stage, done, total)

    Raises
    ------
    AssessError, RecordError or SpectrumError : something the user can mend; the text is the line of the command line
    """
    from assess.project.build import build
    from assess.project.project_file import Project
    from assess.study.run import run_study as assess

    loaded = project if isinstance(project, Project) else load(project)
    _check_jobs(jobs, progress)
    return Run(loaded, assess(build(loaded), jobs=jobs, progress=progress or _ignore_progress))


def fragility(
    source: Project | str | Path | Block | Sequence[Block],
    records: Record | Sequence[Record] | Mapping[float, Sequence[Record]] = (),
    *,
    spectrum: Spectrum | None = None,
    measures: Sequence[str] = (),
    states: Sequence[str | float] = (),
    hazard: Sequence[tuple[float, float]] | str | Path = (),
    jobs: int = 0,
    progress: Progress | None = None,
) -> FragilityResults:
    """Find how likely mechanisms are to rock and to overturn, and how often where the hazard of a project is known.

    Parameters
    ----------
    source : a project as `load` reads it, or the path of its file; or one mechanism or several
    records : horizontal ground motions of the mechanisms, unscaled; or, for stripes with records of their own, those
        of each intensity of the first measure, PGA where none is named, to which they are scaled [SI]; a project has
        these and what follows as its own
    spectrum : elastic spectrum for which seven artificial records are made where `records` are none, as in a project
    measures : of intensity, the one that records are scaled by first, such as "pga" or "sa(0.5 s)"; all that apply
        where none are named
    states : to be reached: "rocking", shares of the overturning rotation, "overturning"; these with 0.5 where none are
        named
    hazard : of the site: rows of peak ground acceleration [m/s2] and annual rate of exceedance [1/year], or the file of
        a hazard curve
    jobs : threads, 0 for all cores; the results do not depend on it
    progress : is called with (stage, done, total)

    Raises
    ------
    AssessError, RecordError or SpectrumError : something the user can mend; the text is the line of the command line
    """
    from assess.project.build import build
    from assess.project.project_file import Project
    from assess.study.fragility import run_fragility

    _check_jobs(jobs, progress)
    if isinstance(source, Project | str | Path):
        given = {"records": records, "spectrum": spectrum, "measures": measures, "states": states, "hazard": hazard}
        if told := [
            key for key, each in given.items() if not (each is None or (isinstance(each, tuple | list) and not each))
        ]:
            raise ProjectError(f"{', '.join(told)}: a project has its own; give them with mechanisms alone")
        study = build(source if isinstance(source, Project) else load(source))
    else:
        study = _study_of_blocks(source, records, spectrum, measures=measures, states=states, hazard=hazard)
    return run_fragility(study, jobs=jobs, progress=progress or _ignore_progress)


def retrofit(
    project: Project | str | Path,
    *,
    target: str,
    reach: float,
    vary: Mapping[str, str | Sequence[float | str]],
    limit_state: str | None = None,
    price: Mapping[str, float | str] | None = MappingProxyType({}),
    spacing: float | str = 3.0,
    search_records: int | None = None,
    jobs: int = 0,
    progress: Progress | None = None,
) -> Retrofit:
    """Find the least works with which a project reaches a target, proved on records that the search did not see.

    Parameters
    ----------
    project : as `load` reads it, or the path of its file
    target : "index" by which the basis decides, "ratio" of the largest rotation to the one that overturns, or
        "probability", the share of records that overturn at the upper end of its one-sided interval of 84 %
    reach : its value: of an index at least, but at most of a demand over capacity; of the others at most
    vary : ranges by keys of the file, and by `mechanisms.NAME.WORK.PARAMETER` of works: ties (count, area, height,
        force), ring_beam (mass, area), roof (factor), base (width); a range is "100..800 mm^2", "100..800 mm^2 by 50"
        or a list of values
    limit_state : in place of that of [verdict]
    price : by "steel" for each kg, "tie" for each, and varied key for each unit of change, as numbers or like
        "4 EUR/kg", before those of the file; steel counts without any, and where None
    spacing : between anchors, at most [m], or with its unit
    search_records : about how many records are searched on; every second event where None
    jobs : threads, 0 for all cores; the results do not depend on it
    progress : is called with (stage, done, total)

    Returns
    -------
    `results.best` is the least layout, None where none is proved; `results.table()` has all; `write_retrofit` writes
    them with the project that has the works

    Raises
    ------
    AssessError, RecordError or SpectrumError : something the user can mend; the text is the line of the command line
    """
    from assess.project.project_file import Project
    from assess.project.retrofit import RetrofitQuestion, find_retrofit

    loaded = project if isinstance(project, Project) else load(project)
    _check_jobs(jobs, progress)
    question = RetrofitQuestion(target, reach, vary, limit_state, price, spacing, search_records)  # type: ignore[arg-type]
    return find_retrofit(loaded, question, jobs=jobs, progress=progress or _ignore_progress)


def write_retrofit(
    found: Retrofit,
    folder: str | Path,
    *,
    jobs: int = 0,
    tell: TellMessage | None = None,
    progress: Progress | None = None,
) -> Path:
    """Write what a search for works found: the project with the least, report, tables and figures.

    Parameters
    ----------
    found : by `retrofit`
    folder : to write into; files of others are never touched
    jobs : processes, 0 for as many as there are cores
    tell : is called with a message on what is recovered in the folder
    progress : is called with (stage, done, total)

    Returns
    -------
    The path of project.toml, or of the report where no layout is proved

    Raises
    ------
    OutputError : the folder cannot be written, or holds files that may not be replaced
    """
    from assess.outputs.manifest import RETROFIT
    from assess.outputs.writing import output_folder
    from assess.project.project_file import FILE_NAME
    from assess.project.retrofit import Retrofit as Known
    from reports.assessment import write_document
    from reports.retrofit import FILES, retrofit_report

    if not isinstance(found, Known):
        raise OutputError(f"found: {type(found).__name__} given; give what assess.retrofit returns")
    _check_jobs(jobs, progress)
    place, show = _output_place(folder), progress or _ignore_progress
    expected = (FILE_NAME, *FILES)
    with output_folder(
        place, command="assess retrofit", owner=RETROFIT, expected=expected, tell=tell or (lambda _: None)
    ) as stage:
        if found.tables is not None:
            (stage / FILE_NAME).write_text(found.project_text(place), encoding="utf-8", newline="\n")
        report = retrofit_report(found.results)
        pdf = write_document(report, stage, name=FILES[0], jobs=jobs, progress=lambda step: show(step, 0, 1))
        return place / (pdf.relative_to(stage) if found.tables is None else FILE_NAME)


def plot(thing: Any) -> Figure:
    """Make the figure of a thing, in English and SI units; a notebook shows it, `savefig` writes it.

    Parameters
    ----------
    thing : a motion, a record, a spectrum, a mechanism, an envelope, a fragility, that of one mechanism or one of its
        curves, or a building; or a list of motions, records or curves; `run.figure(name)` makes those of a run

    Returns
    -------
    A matplotlib figure

    Raises
    ------
    AssessError : there is no figure of it; the text lists of what there is
    """
    from reports.figures.session import draw_figure
    from reports.language.locale import Locale

    return draw_figure(thing, Locale())


def write_report(
    run: Run, folder: str | Path, *, language: str | None = None, jobs: int = 0, progress: Progress | None = None
) -> Path:
    """Write results.json, report.pdf, report.html, the tables and the figures of a run into a folder.

    All of it stands there afterwards or nothing has changed; files that are not ours are refused.

    Parameters
    ----------
    run : a project that has been assessed
    folder : made where there is none
    language : of the report, "en" or "it"; that of the project where None
    jobs : processes, 0 for as many as there are cores
    progress : is called with (stage, done, total)

    Returns
    -------
    The path of the PDF

    Raises
    ------
    OutputError : the folder cannot be written, or holds files that may not be replaced
    """
    from assess.errors import OutputError
    from assess.outputs.manifest import REPORT, RESULTS
    from assess.outputs.writing import output_folder
    from assess.results.json import dumps
    from reports.assessment import write_all
    from reports.language.locale import languages

    if not isinstance(run, Run):
        raise OutputError(f"run: {type(run).__name__} given; give what assess.run returns")
    if language is not None and language not in languages():
        raise OutputError(f"language = {language!r:.60}: choose one of {', '.join(languages())}")
    _check_jobs(jobs, progress)
    place, show = _output_place(folder), progress or _ignore_progress
    with output_folder(place, command="write_report", expected=(RESULTS, *REPORT)) as stage:
        (stage / RESULTS).write_bytes(dumps(run.results).encode())
        pdf = write_all(run.results, stage, language=language, jobs=jobs, progress=lambda step: show(step, 0, 1))
        return place / pdf.relative_to(stage)


def _ignore_line(line: str) -> None:
    """Drop a line."""


def batch(
    source: str | Path,
    folder: str | Path,
    *,
    template: str | Path | None = None,
    jobs: int = 0,
    resume: bool = False,
    scheduler: str | None = None,
    shard: str = "1/1",
    keep: Keep = "report",
    decimal_comma: bool = False,
    tell: Tell = _ignore_line,
    progress: Progress | None = None,
) -> Portfolio:
    """Assess every project below a folder, or one for each row of a table, and rank them.

    A project that cannot be assessed is a row with its reason, and stops no other. Call it under
    `if __name__ == "__main__":`, as all that starts processes.

    Parameters
    ----------
    source : a folder, or a table as CSV or workbook
    folder : where the ranked table, the ledger and a folder for each project are written
    template : the project file whose values the rows of a table change
    jobs : processes, 0 for as many as there are cores; the rows do not depend on it
    resume : keep the projects that are done, and compute the others
    scheduler : address of a Dask scheduler, whose workers compute in place of processes here
    shard : "i/n" for the i-th of n shares of the projects
    keep : what is written of each project: "report", "results", or "rows" for nothing but its row
    decimal_comma : whether numbers of the table have decimal commas; between semicolons they have them anyway
    tell : is called with a line about what is found in the folder
    progress : is called with (stage, done, total); 0 as the total while the projects are being found

    Raises
    ------
    AssessError : the table or the template cannot be used, the folder cannot be written, or no scheduler answers
    """
    from assess.portfolio.batch import BatchOptions, parse_shard, run_batch
    from assess.portfolio.executors import dask, processes
    from assess.portfolio.projects import find_tasks
    from assess.project.placement import elevation_at
    from reports.portfolio import write_ranking

    _check_jobs(jobs, progress)
    show = progress or _ignore_progress
    options = BatchOptions(Path(folder), keep, parse_shard(shard), resume)
    engine = processes(jobs or None) if scheduler is None else dask(scheduler)
    tasks = find_tasks(
        Path(source),
        None if template is None else Path(template),
        unit_fault,
        place_load=elevation_at,
        decimal_comma=decimal_comma,
        progress=lambda found: show("reading", found, 0),
    )
    return run_batch(
        tasks,
        options,
        runner=assess_project,
        engine=engine,
        write=write_ranking,
        tell=tell,
        progress=lambda done, total: show("projects", done, total),
    )


def assess_project(job: Job) -> ProjectRow:
    """Assess one project of a portfolio in this thread, write the outputs that are kept of it, and return its row.

    Raises
    ------
    AssessError, RecordError or SpectrumError : something the user can mend
    """
    with _locate_in_table(job.task):
        return _assess_task(job)


def unit_fault(path: Path, tables: Mapping[str, Any], column: KeyColumn) -> str:
    """Return why the unit of a table's column cannot stand at its key of the template; "" if it can.

    Parameters
    ----------
    path : of the template
    tables : of the template
    column : with a unit
    """
    from assess.messages.message import format_key
    from assess.portfolio.projects import keys_of, with_row
    from assess.project.project_file import load_tree

    prefix, first = f"{path}: {format_key(keys_of(tables)[column.key])}: ", ""
    for number in PROBES:
        try:
            load_tree(with_row(tables, {column.key: (number, column.unit)}), path, sha256="")
        except ProjectError as error:
            if not str(error).startswith(prefix):
                return ""
            first = first or str(error).removeprefix(prefix).removeprefix(f'"{number} {column.unit}": ')
        else:
            return ""
    return first


def _ignore_progress(stage: str, done: int, total: int) -> None:
    """Show nothing of long work."""


def _study_of_blocks(
    blocks: Block | Sequence[Block], records: Any, spectrum: Spectrum | None, *, hazard: Any, **given: Any
) -> Study:
    """Return the study of the fragility of mechanisms; given : keys of [analysis.fragility], those without are left."""
    from assess.project.question import read_fragility_question
    from assess.study.block_answers import fragility_study
    from assess.study.suites import with_unique_names

    several: Any = blocks if isinstance(blocks, tuple | list) and blocks else (blocks,)
    for each in several:
        _check_block(each)
    if spectrum is not None:
        _check_site(spectrum, None)
    asked: dict[str, Any] = {key: value for key, value in given.items() if not isinstance(value, tuple) or value}
    if isinstance(hazard, str | Path):
        asked["curve"] = str(hazard)
    elif len(hazard):
        asked["hazard"] = [dict(zip(("pga", "rate"), map(float, row), strict=True)) for row in hazard]
    suite = records if isinstance(records, tuple | list) else (records,)
    if isinstance(records, Mapping):
        each_once = {id(record): record for own in records.values() for record in own}
        suite = with_unique_names(tuple(each_once.values()))
        names = {known: record.id for known, record in zip(each_once, suite, strict=True)}
        rows = sorted((float(level), [names[id(record)] for record in own]) for level, own in records.items())
        asked |= {"method": "stripes", "stripes": [{"intensity": level, "records": own} for level, own in rows]}
    return fragility_study(several, suite, read_fragility_question(**asked), spectrum=spectrum)


def _check_block(block: Block) -> None:
    """Raise MechanismError for what is no mechanism."""
    from assess.errors import MechanismError
    from assess.study.block import Block as Known

    if not isinstance(block, Known):
        raise MechanismError(f"block: {type(block).__name__} given; give a mechanism, as single_block returns it")


def _check_jobs(jobs: int, progress: Progress | None = None) -> None:
    """Raise AssessError for what is no number of threads, and for a progress that cannot be called."""
    from assess.errors import AssessError

    if not isinstance(jobs, int) or jobs < 0:
        raise AssessError(f"jobs = {jobs!r:.60}: give a whole number, 0 for all cores")
    if progress is not None and not callable(progress):
        raise AssessError(f"progress = {progress!r:.60}: give a function of (stage, done, total)")


def _output_place(folder: object) -> Path:
    """Return a folder to write to; raise OutputError for what is no path."""
    from assess.errors import OutputError

    if not isinstance(folder, str | Path) or "\0" in str(folder):
        raise OutputError(f"folder = {folder!r:.60}: give the path of a folder")
    return Path(folder)


def _check_site(target: Spectrum, building: Building | None) -> None:
    """Raise ProcedureError for what is no spectrum, and for what is no building."""
    from assess.codes.context import Building as KnownBuilding
    from assess.errors import ProcedureError
    from spectra.spectrum import Spectrum as KnownSpectrum

    if not isinstance(target, KnownSpectrum):
        raise ProcedureError(f"target: {type(target).__name__} given; give a spectrum, as assess.spectrum returns it")
    if building is not None and not isinstance(building, KnownBuilding):
        raise ProcedureError(f"building: {type(building).__name__} given; give what assess.building returns")


def _assess_task(job: Job) -> ProjectRow:
    from assess.outputs.manifest import RESULTS
    from assess.portfolio.tasks import row_of_verdict
    from assess.project.build import build, build_to_decide
    from assess.study.run import find_outcome, run_study

    project = _load_task(job.task)
    if job.keep == "rows":
        study = build_to_decide(project)
        return row_of_verdict(job, find_outcome(study), study.messages)
    study = build(project)
    results = run_study(study, jobs=1)
    report = _write_outputs(job, results)
    on_input = [each for each in study.messages if not each.key.startswith("annex-")]  # which is of the report
    return row_of_verdict(job, results.verdict, on_input, report=report, results=f"{job.folder.name}/{RESULTS}")


@contextmanager
def _locate_in_table(task: Task) -> Iterator[None]:
    """Locate the errors of a project of a table in the table."""
    from assess.portfolio.projects import row_fault

    try:
        yield
    except OutputError:
        raise
    except (AssessError, RecordError, SpectrumError) as error:
        if task.content is None:
            raise
        raise ProjectError(row_fault(task, str(error))) from None


def _load_task(task: Task) -> Project:
    """Read the project of a task: its file, or its template with the values of its row."""
    from assess.portfolio.projects import project_tree
    from assess.project.project_file import load, load_tree

    if task.content is None:
        return load(task.path)
    return load_tree(project_tree(task), task.path, sha256=task.sha256)


def _write_outputs(job: Job, results: Results) -> str:
    """Write the outputs of a project, whole or not at all; return the link to its report, "" for none."""
    from assess.outputs.manifest import REPORT, RESULTS
    from assess.outputs.writing import output_folder
    from assess.results.json import dumps

    expected = (RESULTS, *(REPORT if job.keep == "report" else ()))
    with output_folder(job.folder, command="assess batch", expected=expected) as stage:
        (stage / RESULTS).write_bytes(dumps(results).encode())
        if job.keep == "results":
            return ""
        from reports.assessment import write_all

        return f"{job.folder.name}/{write_all(results, stage, jobs=1).relative_to(stage).as_posix()}"
