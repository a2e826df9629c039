"""The commands with which a project is begun, without analysis: `new`, `check`, `parameters`, `schema`."""

from __future__ import annotations

import json
from collections.abc import Sequence
from enum import StrEnum
from pathlib import Path
from typing import Annotated, Literal

import typer

from assess.cli.options import JobsOption, ProjectPath, UpAxis, flag, folder_option, refuse_two_formats
from assess.cli.stderr import print_messages, progress
from assess.messages.message import escape_text, locate


def new(
    folder: Annotated[
        Path | None, typer.Argument(metavar="DIR", help="Folder to create; it must be empty or not exist yet.")
    ] = None,
    more: Annotated[list[Path] | None, typer.Argument(metavar="MODEL…", help="Further models, with --from.")] = None,
    example: Annotated[
        str | None,
        typer.Option(
            "--example",
            metavar="NAME",
            autocompletion=_complete_examples,
            help="Name of the example; --list shows them. The smallest wall if absent.",
        ),
    ] = None,
    models: Annotated[
        list[Path] | None,
        typer.Option("--from", metavar="MODEL", help="IFC or mesh of a building, whose mechanisms are found."),
    ] = None,
    unit: Annotated[
        str | None, typer.Option(metavar="UNIT", help="Unit of the models' coordinates, such as mm, with --from.")
    ] = None,
    up: Annotated[UpAxis | None, typer.Option(help="Axis of the models that points up, with --from.")] = None,
    list_examples: Annotated[bool, flag("--list", "List the examples and exit.")] = False,
) -> None:
    """Create a runnable project to start from: the smallest wall, an example, or the building of a model."""
    from assess.examples import EXAMPLES, copy_example

    if list_examples:
        for name, each in EXAMPLES.items():
            print(f"{name:20} {each.about}")
        return
    if folder is None:
        raise typer.BadParameter("give the folder to create, or --list")
    if models:
        if example is not None:
            raise typer.BadParameter("--example beside --from; give one of them")
        _draw([*models, *(more or ())], folder, unit=unit, up=None if up is None else up.value)
        return
    if more or unit is not None or up is not None:
        raise typer.BadParameter("further models, --unit and --up go with --from MODEL")
    name = example or "single_wall"
    file = copy_example(name, folder)
    print(file)
    for table in EXAMPLES[name].tables():
        print(f"assess batch {file.parent / table} --template {file}")


def _draw(models: Sequence[Path], folder: Path, *, unit: str | None, up: Literal["y", "z"] | None) -> None:
    """Write the project of a building and say what was found."""
    from assess.model.candidates import texts_of
    from assess.project.drawn_project import PROJECT, is_stated, write_project

    with progress() as shown:
        shown.step("building")
        structure, candidates = write_project(models, folder, unit=unit, up=up)
    print_messages(locate(structure.warnings, models[0].name))
    stated = sum(map(is_stated, candidates))
    print(folder / PROJECT)
    print(
        f"parts: {len(structure.parts)}; mechanisms: {stated}; found, to be assessed apart: {len(candidates) - stated}"
    )
    for text in structure.left_out_texts:
        print(escape_text(f"left out: {text}"))
    for text in texts_of(candidates.gaps):
        print(escape_text(f"not looked for: {text}"))
    for text in texts_of(candidates.ruled_out):
        print(escape_text(f"ruled out: {text}"))
    for message in candidates.without.values():
        print(escape_text(f"without a mechanism: {message}"))


def check(project: ProjectPath) -> None:
    """Read and validate a project and describe each mechanism, without analysis.

    Shows how the program understood the file: hinges, loads, interfaces and rocking parameters.
    """
    from assess.project.project_file import load

    with progress() as shown:
        loaded = load(project)
        from assess.cli.tables.project import description, sensitivity_text
        from assess.cli.tables.units import units_on_terminal
        from assess.project.build import build
        from assess.study.mechanism_results import parameters
        from assess.study.study import without_scenes

        shown.step("mechanisms")
        study = build(loaded)
    with units_on_terminal(loaded.content.report.units):
        print(description(loaded, parameters(without_scenes(study)), study.sweeps, study.messages), end="")
    print(sensitivity_text(study.variables), end="")


def parameters(
    project: ProjectPath,
    as_json: Annotated[bool, flag("--json", "Print the mechanisms as in results.json.")] = False,
    as_csv: Annotated[bool, flag("--csv", "Print the table as CSV at full precision.")] = False,
) -> None:
    """Print the rocking parameters of each mechanism and of each case of its sweeps, without analysis."""
    refuse_two_formats(as_json=as_json, as_csv=as_csv)
    from assess.project.project_file import load

    loaded = load(project)
    from assess.cli.tables.project import directions_text, parameters_csv, parameters_text
    from assess.cli.tables.units import units_on_terminal
    from assess.project.build import build
    from assess.results.json import dumps_mechanisms
    from assess.study.mechanism_results import case_parameters
    from assess.study.mechanism_results import parameters as parameters_of_study
    from assess.study.study import without_scenes

    text = dumps_mechanisms if as_json else parameters_csv if as_csv else parameters_text
    study = build(loaded)
    print_messages(study.messages)
    shown = study if as_json else without_scenes(study)
    mechanisms = parameters_of_study(shown)
    with units_on_terminal(loaded.content.report.units):
        print(text((*mechanisms, *case_parameters(shown))), end="")
    if text is parameters_text:
        print(directions_text(mechanisms), end="")


class Ranking(StrEnum):
    """By what the mechanisms of a building are ranked."""

    INDEX = "index"
    PGA = "pga"


def mechanisms(
    project: ProjectPath,
    output: Annotated[Path | None, folder_option("Write mechanisms.csv into this folder.")] = None,
    write: Annotated[bool, flag("--write", "Add what the project can state to the end of its file.")] = False,
    index: Annotated[
        bool, flag("--index", "Examine them by the project's basis, and rank by the PGA that they hold.")
    ] = False,
    by: Annotated[
        Ranking | None,
        typer.Option(help="index: as --index; pga: rank by the PGA at which the suite overturns half of its runs."),
    ] = None,
    jobs: JobsOption = None,
) -> None:
    """Find the mechanisms that the bodies of a project can have, the weakest by static multiplier first.

    The column "in file" names the mechanism of the project that is the same. Parts that have none are named.
    """
    if index and by == Ranking.PGA:
        raise typer.BadParameter("--index beside --by pga; give one of them")
    from assess.cli.tables.project import mechanisms_text
    from assess.project.found_mechanisms import add_mechanisms, find_margins, find_mechanisms, find_overturning_pga
    from assess.project.project_file import load

    with progress() as shown:
        loaded = load(project)
        shown.step("mechanisms")
        found = find_mechanisms(loaded)
        margins = overturning = None
        if by == Ranking.PGA:
            shown.step("rocking histories")
            overturning = find_overturning_pga(loaded, found, jobs=jobs or 0)
        elif index or by == Ranking.INDEX:
            shown.step("checks")
            margins = find_margins(loaded, found, jobs=jobs or 0)
    print(mechanisms_text(found, margins, overturning), end="")
    if output is not None:
        from assess.outputs.writing import make_folder, replace_file
        from reports.render.table_text import csv_lines

        with make_folder(output):
            file = output / "mechanisms.csv"
            with replace_file(file, command="assess mechanisms", is_replaceable=_is_table_of_mechanisms) as made:
                table = found.table(margins, overturning).astype(object)
                rows = table.where(table.notna(), "").values.tolist()
                made.write_text(csv_lines([list(table.columns), *rows]), encoding="utf-8")
        print(file)
    if write:
        added = add_mechanisms(loaded, found)
        print(f"{loaded.path}: {len(added)} mechanisms added" if added else f"{loaded.path}: nothing to add")


def schema(
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", metavar="FILE", help="Write the schema to a file; an earlier one is replaced."),
    ] = None,
) -> None:
    """Print the JSON Schema of the project file, or write it to a file.

    Editors with TOML support check and complete a project file by it, units of quantities included. They find it by the
    first line of the project file, `#:schema ./project.schema.json`; `assess new` writes both.
    """
    from assess.project.project_file import schema_text

    if output is None:
        print(schema_text(), end="")
        return
    from assess.outputs.writing import replace_file

    with replace_file(output, command="assess schema", is_replaceable=_is_schema) as made:
        made.write_text(schema_text(), encoding="utf-8", newline="\n")
    print(output)


def _complete_examples(incomplete: str) -> Sequence[str]:
    """Complete the name of an example, by the folders that are shipped."""
    folders = (Path(__file__).parents[1] / "examples" / "projects").iterdir()
    return sorted(each.name for each in folders if each.is_dir() and each.name.startswith(incomplete))


def _is_table_of_mechanisms(path: Path) -> bool:
    """Whether a file is a table that `mechanisms` wrote."""
    with path.open(encoding="utf-8", errors="replace") as file:
        return file.readline().startswith("name,in_file,class,")


def _is_schema(path: Path) -> bool:
    """Whether a file is a schema that this command wrote."""
    from assess.project.project_file import TITLE

    try:
        content = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError):
        return False
    return isinstance(content, dict) and content.get("title") == TITLE
