"""The chapter on the site: its spectrum, the records and their processing."""

from __future__ import annotations

from functools import partial

from assess.results import RecordResult, RecordSpectrum, Results, SpectrumResult
from reports.chapters import suite
from reports.document import Block, Cell, Column, Figure, Section, Table, nonempty
from reports.figures import spectrum as figure
from reports.language import spectrum_parameters
from reports.language.numerals import as_given


def section(results: Results) -> list[Section]:
    """Return the chapter: spectrum, records and suite; none without spectrum and records."""
    blocks: list[Block] = []
    if results.spectrum is not None:
        caption = (
            f"Elastic response spectrum of the site ({results.spectrum.code}, damping {results.spectrum.damping:.3g}) "
            f"and of the records as scaled to it{_fitted(results)}."
        )
        blocks.append(Figure("spectrum", caption, partial(figure.draw, results.spectrum, results.records)))
        blocks += nonempty(site(results))
    blocks += [*nonempty(records(results)), *suite.blocks(results), *nonempty(processing_history(results))]
    return [Section("Site and ground motion", 0, tuple(blocks))] if blocks else []


def _fitted(results: Results) -> str:
    """Return how far artificial records are fitted, where there are any."""
    artificial = any(not record.path for record in results.records)
    return "; artificial records are fitted up to a period of 4 s" if artificial else ""


def site(results: Results) -> Table:
    """Tabulate the parameters of the site's spectrum."""
    spectrum = results.spectrum
    rows: tuple[tuple[Cell, ...], ...] = ()
    if spectrum is not None:
        rows = (
            ("code", "-", spectrum.code),
            ("clause", "-", spectrum.clause),
            *spectrum_parameters.parameter_rows(spectrum.parameters),
            ("damping ratio", "-", as_given(spectrum.damping)),
            ("other damping", "-", spectrum.damping_rule),
            ("peak ground acceleration, Sₐ(0)", "g", spectrum.pga_g),
        )
    columns = (Column("Parameter"), Column("Unit"), Column("Value"))
    return Table("site", "The site's elastic response spectrum.", columns, rows)


def records(results: Results) -> Table:
    """Tabulate the records as scaled to the site's spectrum."""
    columns = (
        Column("Record"),
        Column("Event"),
        Column("NGA", kind="given"),
        Column("Magnitude", kind="given"),
        Column("Component"),
        Column("Step", "s", "given"),
        Column("Samples", kind="number"),
        Column("Misfit", "-", "number"),
        Column("Scale factor", "-", "number"),
        Column("PGA, scaled", "g", "number"),
    )
    rows = tuple(
        (r.id, event_name(r), r.nga, r.magnitude, r.component, r.dt_s, r.npts, r.mse, r.scale_factor, r.pga_g)
        for r in results.records
    )
    caption = (
        "Records, scaled to the site's spectrum (as thesis Table 8.8). Misfit: mean squared difference of the "
        "logarithms of the ordinates."
    )
    return Table("records", caption, columns, rows)


def event_name(record: RecordResult) -> str:
    """Return the earthquake with its year, where that is known and not part of its name."""
    year = record.date[:4]
    return record.event if year in record.event else f"{record.event} {year}".strip()


def processing_history(results: Results) -> Table:
    """Tabulate the origin and the processing of each record."""
    columns = (Column("Record"), Column("Station"), Column("File"), Column("Processing, in order"))
    rows = tuple((record.id, record.station, record.path, "; ".join(record.trail)) for record in results.records)
    return Table("processing", "Origin and processing of the records.", columns, rows)


def ordinates(results: Results) -> Table:
    """Tabulate the spectra of the target and the records, point by point."""
    columns = (Column("Series"), Column("Period", "s", "number"), Column("Acceleration", "g", "number"))
    curves: list[tuple[str, SpectrumResult | RecordSpectrum]] = []
    curves += [("target", results.spectrum)] if results.spectrum is not None else []
    curves += [(record.id, record.spectrum) for record in results.records]
    rows = tuple(
        (name, period, value)
        for name, curve in curves
        for period, value in zip(curve.period_s, curve.acceleration_g, strict=True)
    )
    return Table("spectra", "Elastic response spectra, target and records.", columns, rows)
