"""`assess spectrum`: a design spectrum as a table or figure."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from assess.cli.completions import Completion, of_words, spectrum_codes
from assess.cli.options import FigurePath, refuse_both, refuse_figure

OWN = (
    "project",
    "vertical",
    "as_json",
    "as_csv",
    "output",
)  # parameters of the command that are not keys of a spectrum

HAZARDS = of_words("design", "mce")


def _key(name: str, metavar: str, words: str, complete: Completion | None = None) -> typer.models.OptionInfo:
    option: typer.models.OptionInfo = typer.Option(
        f"--{name}", metavar=metavar, help=words, show_default=False, autocompletion=complete
    )
    return option


def spectrum(
    context: typer.Context,
    project: Annotated[
        Path | None, typer.Argument(metavar="PROJECT", help="A project file or its folder; otherwise give --code.")
    ] = None,
    code: Annotated[
        str | None,
        _key(
            "code",
            "CODE",
            "asce7-05, ibc2009, asce7-10, asce7-16, ec8, nzs1170.5, ntc2008, ntc2018, table.",
            spectrum_codes,
        ),
    ] = None,
    s_s: Annotated[
        str | None, _key("s-s", "ACC", 'asce7: mapped acceleration at short periods, such as "0.25 g".')
    ] = None,
    s_1: Annotated[str | None, _key("s-1", "ACC", "asce7: mapped acceleration at 1 s.")] = None,
    site_class: Annotated[str | None, _key("site-class", "CLASS", "asce7: A to E.", of_words(*"ABCDE"))] = None,
    s_ds: Annotated[
        str | None, _key("s-ds", "ACC", "asce7: design acceleration at short periods, instead of a mapped one.")
    ] = None,
    s_d1: Annotated[str | None, _key("s-d1", "ACC", "asce7: design acceleration at 1 s.")] = None,
    t_l: Annotated[str | None, _key("t-l", "TIME", 'asce7: long-period transition, such as "6 s".')] = None,
    hazard: Annotated[str | None, _key("hazard", "WORD", "asce7: design (default) or mce.", HAZARDS)] = None,
    a_g: Annotated[str | None, _key("a-g", "ACC", "ec8, ntc: peak ground acceleration on rock.")] = None,
    ground_type: Annotated[str | None, _key("ground-type", "TYPE", "ec8: A to E.", of_words(*"ABCDE"))] = None,
    type: Annotated[str | None, _key("type", "1|2", "ec8: type of the spectrum (default: 1).")] = None,
    importance_factor: Annotated[
        str | None, _key("importance-factor", "NUMBER", "ec8: importance factor (default: 1).")
    ] = None,
    subsoil: Annotated[str | None, _key("subsoil", "CLASS", "nzs1170.5: A to E.", of_words(*"ABCDE"))] = None,
    z: Annotated[str | None, _key("z", "NUMBER", "nzs1170.5: hazard factor.")] = None,
    r: Annotated[str | None, _key("r", "NUMBER", "nzs1170.5: return period factor.")] = None,
    return_period: Annotated[
        str | None, _key("return-period", "YEARS", "nzs1170.5: return period, instead of --r.")
    ] = None,
    near_fault_distance: Annotated[
        str | None, _key("near-fault-distance", "LENGTH", "nzs1170.5: distance to the nearest major fault.")
    ] = None,
    f_0: Annotated[str | None, _key("f-0", "NUMBER", "ntc: maximum spectral amplification on rock.")] = None,
    t_c_star: Annotated[str | None, _key("t-c-star", "TIME", "ntc: T_C* on rock.")] = None,
    soil: Annotated[str | None, _key("soil", "CATEGORY", "ntc: A to E.", of_words(*"ABCDE"))] = None,
    topography: Annotated[str | None, _key("topography", "CATEGORY", "ntc: T1 (default) to T4.")] = None,
    relief_position: Annotated[
        str | None, _key("relief-position", "NUMBER", "ntc: 1 at the top of the relief (default), 0 at its foot.")
    ] = None,
    file: Annotated[
        str | None, _key("file", "CSV", "table: periods and accelerations, with units in the header.")
    ] = None,
    damping: Annotated[
        str | None, _key("damping", "NUMBER", "Damping ratio (default: 0.05); for a table, that of its ordinates.")
    ] = None,
    pga: Annotated[str | None, _key("pga", "ACC", "Scale the ordinates to this peak ground acceleration.")] = None,
    vertical: Annotated[
        bool, typer.Option("--vertical", help="Print the vertical spectrum (ec8, nzs1170.5, ntc).")
    ] = False,
    as_json: Annotated[bool, typer.Option("--json", help="Print the spectrum as in results.json.")] = False,
    as_csv: Annotated[
        bool, typer.Option("--csv", help="Print period and acceleration, as read by --code table.")
    ] = False,
    output: FigurePath = None,
) -> None:
    """Print the design spectrum of a project, or of a code with its parameters.

    The parameters are the keys of [site.spectrum]: assess spectrum --code ec8 --a-g "0.25 g" --ground-type B
    """
    options = {key: value for key, value in context.params.items() if key not in OWN and value is not None}
    _refuse(project, options, as_json=as_json, as_csv=as_csv, output=output)
    from assess.cli.tables.design_spectrum import csv_text, json_text, print_spectrum_warnings, table_text
    from assess.project.site_options import read_site_options, site_option_messages
    from assess.project.site_spectrum import site_of, spectrum_of, vertical_of

    site = read_site_options(options, folder=Path()) if project is None else site_of(project)
    found = (vertical_of if vertical else spectrum_of)(site)
    print_spectrum_warnings(found, messages=site_option_messages(options))
    if output is not None:
        from assess.cli.tables.design_spectrum import draw

        draw(found, output)
    print((json_text if as_json else csv_text if as_csv else table_text)(found), end="")


def _refuse(project: Path | None, options: dict[str, str], *, as_json: bool, as_csv: bool, output: Path | None) -> None:
    """Raise BadParameter for options that exclude each other, or that need others."""
    refuse_both(as_json=as_json, as_csv=as_csv)
    refuse_figure(output)
    if project is not None and options:
        raise typer.BadParameter(f"--{next(iter(options)).replace('_', '-')} and PROJECT exclude each other")
    if project is None and "code" not in options:
        raise typer.BadParameter("give a PROJECT, or --code with its parameters")
