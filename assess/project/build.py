"""From the project file's tables to the field's own objects; bodies, loads and mechanisms have modules beside it."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

from assess.codes.context import Building
from assess.codes.dmi2008.clauses import Options as Dmi2008Options
from assess.codes.registry import CodeOptions
from assess.errors import AssessError
from assess.project import sections
from assess.project.bodies import solid_of
from assess.project.mechanisms import mechanism_of
from assess.project.notices import notices_of
from assess.project.schema import Project, relative, resolved
from assess.project.study import Artificial, Equation, Study
from assess.results import Input
from records.reading import read
from records.record import Record
from spectra.asce7 import design_spectrum
from spectra.errors import SpectrumError
from spectra.spectrum import Spectrum, scaled_to_pga
from spectra.table import read_table


def build(project: Project) -> Study:
    """The study that `project` describes, with every file it names read.

    Raises AssessError, SpectrumError or RecordError, each one line with the file, for what cannot be assessed.
    """
    try:
        return study_of(project)
    except (AssessError, SpectrumError) as error:
        raise type(error)(f"{project.path}: {error}") from None


def study_of(project: Project) -> Study:
    """The same, with errors that do not name the project file."""
    content = project.content
    site, building = content.site, content.building
    spectrum = None if site is None else spectrum_of(site)
    solids = {name: solid_of(name, body, content.materials) for name, body in content.bodies.items()}
    built = [mechanism_of(name, section, content, solids) for name, section in content.mechanisms.items()]
    mechanisms = tuple(each.mechanism for each in built)
    synthetic = content.records.synthetic
    return Study(
        spectrum=spectrum,
        vertical_ratio=0.0 if site is None else site.vertical_ratio,
        building=None if building is None else Building(**building.model_dump()),
        records=records_of(project),
        artificial=None if synthetic is None else Artificial(synthetic.count, synthetic.seed, synthetic.duration),
        scale_to=content.records.scale_to,
        levels=levels_of(content.analysis.levels, spectrum),
        procedures=content.analysis.procedures,
        options=CodeOptions(dmi2008=Dmi2008Options(**content.procedures.dmi2008.model_dump())),
        mechanisms=mechanisms,
        scenes={each.mechanism.name: each.scene for each in built if each.scene is not None},
        equations={name: equation_of(section, content) for name, section in content.mechanisms.items()},
        inputs=tuple(inputs_of(project)),
        resolved=resolved(project),
        notices=tuple(notices_of(content, solids, mechanisms)),
    )


def spectrum_of(site: sections.Site) -> Spectrum:
    """The site's spectrum, scaled to the PGA the project gives."""
    section = site.spectrum
    if isinstance(section, sections.TableSpectrum):
        spectrum = read_table(section.file, damping=section.damping, pga=site.pga)
    else:
        spectrum = design_spectrum(
            s_ds=section.s_ds, s_d1=section.s_d1, t_l=section.t_l, code=section.code, hazard=section.hazard
        )
        spectrum = replace(spectrum, damping=section.damping)
    return spectrum if site.pga is None else scaled_to_pga(spectrum, site.pga)


def levels_of(given: tuple[float, ...] | None, spectrum: Spectrum | None) -> tuple[float, ...]:
    """The levels [m/s2], rising: those given, or the site's own PGA."""
    if given is not None:
        return tuple(sorted(given))
    return () if spectrum is None else (spectrum.pga,)


def equation_of(section: sections.Mechanism, content: sections.Content) -> Equation:
    """The equation of motion asked for, or the default of the kind: linearised for equivalent blocks, else exact."""
    default: Equation = "linearised" if isinstance(section, sections.EquivalentBlock) else "exact"
    return content.analysis.equation or default


def records_of(project: Project) -> tuple[Record, ...]:
    """The records of every file, each with its path as the project file would write it."""
    section = project.content.records
    found = [record for path in section.files for record in read(path, unit=section.unit)]
    return uniquely_named([replace(one, path=relative(Path(one.path), project.folder)) for one in found])


def uniquely_named(records: Sequence[Record]) -> tuple[Record, ...]:
    """The records, a second one of the same id numbered "id (2)", and so on."""
    seen: dict[str, int] = {}
    named = []
    for record in records:
        seen[record.id] = seen.get(record.id, 0) + 1
        again = seen[record.id]
        named.append(record if again == 1 else replace(record, id=f"{record.id} ({again})"))
    return tuple(named)


def inputs_of(project: Project) -> Iterator[Input]:
    """The project file and every file it names, with their hashes."""
    yield Input(project.path.name, project.sha256)
    content = project.content
    bodies = [body.mesh for body in content.bodies.values() if isinstance(body, sections.MeshBody)]
    table = content.site.spectrum if content.site is not None else None
    tables = [table.file] if isinstance(table, sections.TableSpectrum) else []
    for path in dict.fromkeys([*bodies, *tables, *content.records.files]):
        yield Input(relative(path, project.folder), hashlib.sha256(path.read_bytes()).hexdigest())
