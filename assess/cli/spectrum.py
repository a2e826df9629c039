"""`assess spectrum`: a design spectrum as a table, as CSV, as JSON and as a figure."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from assess.cli.options import Completion, FigurePath, check_figure_path, complete_words, flag, refuse_two_formats
from assess.cli.stderr import print_messages
from assess.cli.tables import text_table
from assess.messages.message import Message, Quantity, locate

if TYPE_CHECKING:
    from reports.language.texts import Phrase, Verbatim
    from spectra.spectrum import Spectrum


NOT_KEYS = ("project", "vertical", "as_json", "as_csv", "output")
"""Parameters of the command that are not keys of a spectrum."""
ROUND_PERIODS = (0.0, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0)  # s
HAZARDS = complete_words("design", "mce")


def spectrum(
    context: typer.Context,
    project: Annotated[
        Path | None, typer.Argument(metavar="PROJECT", help="A project file or its folder; otherwise give --code.")
    ] = None,
    code: Annotated[
        str | None,
        _key_option(
            "code",
            "CODE",
            "asce7-05, ibc2009, asce7-10, asce7-16, asce7-22, ec8, nzs1170.5, ts1170.5, ntc2008, ntc2018, table.",
            _complete_codes,
        ),
    ] = None,
    s_s: Annotated[
        str | None, _key_option("s-s", "ACC", 'asce7: mapped acceleration at short periods, such as "0.25 g".')
    ] = None,
    s_1: Annotated[str | None, _key_option("s-1", "ACC", "asce7: mapped acceleration at 1 s.")] = None,
    site_class: Annotated[
        str | None, _key_option("site-class", "CLASS", "asce7: A to E; ts1170.5: I to VI.", complete_words(*"ABCDE"))
    ] = None,
    s_ds: Annotated[
        str | None, _key_option("s-ds", "ACC", "asce7: design acceleration at short periods, instead of a mapped one.")
    ] = None,
    s_d1: Annotated[str | None, _key_option("s-d1", "ACC", "asce7: design acceleration at 1 s.")] = None,
    t_l: Annotated[str | None, _key_option("t-l", "TIME", 'asce7: long-period transition, such as "6 s".')] = None,
    hazard: Annotated[str | None, _key_option("hazard", "WORD", "asce7: design (default) or mce.", HAZARDS)] = None,
    a_g: Annotated[str | None, _key_option("a-g", "ACC", "ec8, ntc: peak ground acceleration on rock.")] = None,
    ground_type: Annotated[
        str | None, _key_option("ground-type", "TYPE", "ec8: A to E.", complete_words(*"ABCDE"))
    ] = None,
    type: Annotated[str | None, _key_option("type", "1|2", "ec8: type of the spectrum (default: 1).")] = None,
    importance_factor: Annotated[
        str | None, _key_option("importance-factor", "NUMBER", "ec8: importance factor (default: 1).")
    ] = None,
    subsoil: Annotated[
        str | None, _key_option("subsoil", "CLASS", "nzs1170.5: A to E.", complete_words(*"ABCDE"))
    ] = None,
    z: Annotated[str | None, _key_option("z", "NUMBER", "nzs1170.5: hazard factor.")] = None,
    r: Annotated[str | None, _key_option("r", "NUMBER", "nzs1170.5: return period factor.")] = None,
    return_period: Annotated[
        str | None, _key_option("return-period", "YEARS", "nzs1170.5, ts1170.5: return period, instead of --r.")
    ] = None,
    near_fault_distance: Annotated[
        str | None, _key_option("near-fault-distance", "LENGTH", "nzs1170.5: distance to the nearest major fault.")
    ] = None,
    pga_site: Annotated[str | None, _key_option("pga-site", "ACC", "ts1170.5: PGA of its table.")] = None,
    s_as: Annotated[str | None, _key_option("s-as", "ACC", "ts1170.5: S_a,s of its table, the plateau.")] = None,
    s: Annotated[
        str | None, _key_option("s", "NUMBER", "ec8: S of a national annex, with --t-b, --t-c, --t-d.")
    ] = None,
    t_b: Annotated[str | None, _key_option("t-b", "TIME", "ec8: T_B of a national annex.")] = None,
    t_c: Annotated[str | None, _key_option("t-c", "TIME", "ec8: T_C of an annex; ts1170.5: T_c of its table.")] = None,
    t_d: Annotated[str | None, _key_option("t-d", "TIME", "ec8: T_D of an annex; ts1170.5: T_d of its table.")] = None,
    location: Annotated[
        str | None, _key_option("location", "NAME", "ts1170.5: settlement or grid point of --file.")
    ] = None,
    f_0: Annotated[str | None, _key_option("f-0", "NUMBER", "ntc: maximum spectral amplification on rock.")] = None,
    t_c_star: Annotated[str | None, _key_option("t-c-star", "TIME", "ntc: T_C* on rock.")] = None,
    soil: Annotated[str | None, _key_option("soil", "CATEGORY", "ntc: A to E.", complete_words(*"ABCDE"))] = None,
    topography: Annotated[str | None, _key_option("topography", "CATEGORY", "ntc: T1 (default) to T4.")] = None,
    relief_position: Annotated[
        str | None,
        _key_option("relief-position", "NUMBER", "ntc: 1 at the top of the relief (default), 0 at its foot."),
    ] = None,
    file: Annotated[
        str | None,
        _key_option(
            "file", "FILE", "table: CSV of periods and accelerations; ts1170.5: its table; asce7-22: JSON of the USGS."
        ),
    ] = None,
    damping: Annotated[
        str | None,
        _key_option("damping", "NUMBER", "Damping ratio (default: 0.05); for a table, that of its ordinates."),
    ] = None,
    pga: Annotated[
        str | None, _key_option("pga", "ACC", "Scale the ordinates to this peak ground acceleration.")
    ] = None,
    vertical: Annotated[bool, flag("--vertical", "Print the vertical spectrum (ec8, nzs1170.5, ntc).")] = False,
    as_json: Annotated[bool, flag("--json", "Print the spectrum as in results.json.")] = False,
    as_csv: Annotated[bool, flag("--csv", "Print period and acceleration, as read by --code table.")] = False,
    output: FigurePath = None,
) -> None:
    """Print the design spectrum of a project, or of a code with its parameters.

    The parameters are the keys of [site.spectrum]: assess spectrum --code ec8 --a-g "0.25 g" --ground-type B
    """
    options = {key: value for key, value in context.params.items() if key not in NOT_KEYS and value is not None}
    _check_options(project, options, as_json=as_json, as_csv=as_csv, output=output)
    from assess.project.site_and_structure import (
        read_site_options,
        site_of,
        site_option_messages,
        spectrum_of,
        vertical_of,
    )

    site = read_site_options(options, folder=Path()) if project is None else site_of(project)
    found = (vertical_of if vertical else spectrum_of)(site)
    _print_spectrum_warnings(found, messages=site_option_messages(options))
    if output is not None:
        _draw_spectrum(found, output)
    print((_spectrum_json if as_json else _spectrum_csv if as_csv else _spectrum_table)(found), end="")


def periods_of(spectrum: Spectrum) -> list[float]:
    """Return round periods and the spectrum's corners [s], ascending, as far as the spectrum extends."""
    from reports.language.value_names import corners

    periods = {*ROUND_PERIODS, *corners(spectrum.parameters)}
    return sorted(period for period in periods if period <= min(spectrum.longest_period, max(ROUND_PERIODS)))


def _key_option(name: str, metavar: str, words: str, complete: Completion | None = None) -> Any:
    return typer.Option(f"--{name}", metavar=metavar, help=words, show_default=False, autocompletion=complete)


def _complete_codes(incomplete: str) -> Sequence[str]:
    """Complete the name of a design spectrum."""
    from spectra.design_spectra import SPECTRA

    return [name for name in SPECTRA if name.startswith(incomplete)]


def _check_options(
    project: Path | None, options: dict[str, str], *, as_json: bool, as_csv: bool, output: Path | None
) -> None:
    """Raise BadParameter for options that exclude each other, or that need others."""
    refuse_two_formats(as_json=as_json, as_csv=as_csv)
    check_figure_path(output)
    if project is not None and options:
        raise typer.BadParameter(f"--{next(iter(options)).replace('_', '-')} and PROJECT exclude each other")
    if project is None and "code" not in options:
        raise typer.BadParameter("give a PROJECT, or --code with its parameters")


def _spectrum_table(spectrum: Spectrum) -> str:
    """Write the clause, the parameters, and the ordinates at round and corner periods."""
    from reports.language.locale import Locale
    from reports.language.value_names import parameter_rows
    from spectra.gravity import g

    scale = "" if spectrum.factor == 1.0 else f", ordinates scaled by {spectrum.factor:.4g}"
    peak = f"PGA {spectrum.pga / g:.4g} g{scale}"
    heading = f"{spectrum.code}: {spectrum.clause}; damping {spectrum.damping:g}, {peak}\n"
    parameters = [[Locale().text(name), *_shown(value)] for name, value in parameter_rows(spectrum.parameters)]
    period = periods_of(spectrum)
    columns = zip(period, spectrum.acceleration(period) / g, spectrum.displacement(period), strict=True)
    ordinates = [[f"{T:.4g}", f"{S_a:.4f}", f"{1e3 * S_d:.2f}"] for T, S_a, S_d in columns]
    return "\n".join(
        (
            heading,
            text_table(["parameter", "value", "unit"], parameters),
            text_table(["T [s]", "S_a [g]", "S_d [mm]"], ordinates),
        )
    )


def _spectrum_csv(spectrum: Spectrum) -> str:
    """Write period and acceleration at full precision, in the format of a spectrum table."""
    from assess.study.ground_motion import spectrum_result
    from reports.render.table_text import csv_lines

    result = spectrum_result(spectrum)
    rows = zip(result.period_s, result.acceleration_g, strict=True)
    return csv_lines([("period [s]", "acceleration [g]"), *rows])


def _spectrum_json(spectrum: Spectrum) -> str:
    """Write the block `spectrum` of results.json."""
    from assess.results.json import dumps_spectrum
    from assess.study.ground_motion import spectrum_result

    return dumps_spectrum(spectrum_result(spectrum))


def _print_spectrum_warnings(spectrum: Spectrum, *, messages: tuple[Message, ...] = ()) -> None:
    """Print on stderr what to consider before using the spectrum; messages: on the options given."""
    found = locate(spectrum.warnings, "site.spectrum")
    print_messages((*messages, *found))


def _draw_spectrum(spectrum: Spectrum, path: Path) -> Path:
    """Draw the figure of the spectrum to `path`."""
    from assess.results.provenance import origin
    from assess.study.ground_motion import spectrum_result
    from reports.figures.spectrum import draw_design_spectrum
    from reports.language.locale import Locale
    from reports.render.vector import write_figure

    return write_figure(
        draw_design_spectrum(spectrum_result(spectrum), Locale()),
        path,
        creator=origin("spectrum", _spectrum_json(spectrum)),
    )


def _shown(value: Quantity | Verbatim | Phrase) -> tuple[str, str]:
    """Return a value and its unit, "-" for none."""
    from reports.language.locale import Locale

    locale = Locale()
    if not isinstance(value, Quantity):
        return locale.text(value), "-"
    unit = locale.table_unit(value.dimension)
    return locale.number(value.value / unit.size, figures=value.figures), unit.name or "-"
