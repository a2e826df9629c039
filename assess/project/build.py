"""From the project file's tables to the field's own objects; bodies, loads and mechanisms have modules beside it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

import numpy as np

from assess.codes.context import Building, FirstMode
from assess.errors import ProjectError, locate_errors
from assess.geometry.affine import scale_density
from assess.geometry.models import Models
from assess.geometry.solid import Solid
from assess.messages.message import Message, locate
from assess.model.assembly import Built
from assess.model.body import Bodies
from assess.model.definitions import Definition
from assess.model.weakest import mechanism_as_given, mechanism_in_direction
from assess.project import record_set, sections
from assess.project.amplification import amplification_method_of, structure_of
from assess.project.bodies import bodies_of, models_of, solid_of
from assess.project.definitions import definitions_of
from assess.project.dependents import dependents
from assess.project.fragility import fragility_question
from assess.project.ground import base_elevation_of, ground_mechanism, ground_of
from assess.project.horizontal_records import horizontal_records, vertical_record_messages
from assess.project.inputs import inputs_of
from assess.project.key_text import value_text
from assess.project.locked_records import lock_messages, locked_records
from assess.project.procedures import free_periods_of, knowledge_of, options_of, procedures_of, with_asked_procedures
from assess.project.question import facts_of, question_of
from assess.project.report_matter import report_matter_of
from assess.project.schema import Project, resolve
from assess.project.site_spectrum import hazard_over_periods, site_in, spectrum_of
from assess.project.study_messages import project_messages
from assess.project.survey import survey_of
from assess.project.uncertainty import Cases, sampling_of, uncertainty_messages
from assess.project.uses import uses_of
from assess.project.variables import variables_of
from assess.project.variations import Variant, Variation
from assess.project.verification import annex_of
from assess.study.amplification import MechanismInPlace, amplify
from assess.study.record_set import EVERYWHERE, RecordSet, record_messages
from assess.study.study import Artificial, Case, Equation, Fitting, PulseGrid, Study, Sweep
from assess.study.verdict import levels_with_site
from records.pulses import shape as pulse_shape
from spectra.spectrum import Spectrum

Builder = Callable[[str, Definition, Bodies], Built]
CLAUSES_NEED = {"height", "storeys", "period", "damping"}  # of [building]


@dataclass(frozen=True)
class Files:
    """What the files of a project hold: models; bodies by name, None without geometry; the site's spectrum; records."""

    models: Models
    solids: Mapping[str, Solid | None]
    spectrum: Spectrum | None
    named: RecordSet


def build(project: Project, *, executor: Executor | None = None) -> Study:
    """Build the study that a project describes, and read every file it names.

    Parameters
    ----------
    project : the project file as read
    executor : processes that share the reading of many records; None for this process alone

    Raises
    ------
    AssessError, SpectrumError or RecordError : it cannot be assessed; one line that names the file
    """
    with locate_errors(str(project.path)):
        return study_of(project, executor=executor)


def build_to_decide(project: Project) -> Study:
    """Build the study of a project as far as its verdict depends on it, with the messages on its input.

    Raises
    ------
    AssessError, SpectrumError or RecordError : as `build`
    """
    with locate_errors(str(project.path)):
        if project.variations:
            return study_of(project)
        study, files, messages = deciding_part_of(project)
        return replace(study, messages=input_messages(project, study, files, messages))


def uses_of_project(project: Project) -> tuple[str, ...]:
    """Return what a project uses of the program, in the words of `assess.results.uses`.

    Raises
    ------
    AssessError, SpectrumError or RecordError : as `build`
    """
    with locate_errors(str(project.path)):
        return uses_of(project.content, deciding_part_of(project)[0])


def study_of(project: Project, *, executor: Executor | None = None) -> Study:
    """Build the study of a project, with errors that do not name the project file."""
    content = project.content
    report = report_matter_of(content, project.folder)
    study, files, messages = deciding_part_of(project, executor=executor)
    solids = files.solids
    annex, said = annex_of(project, uses_of(content, study))
    return replace(
        study,
        annex=annex,
        inputs=tuple(inputs_of(project, files.named.records, annex)),
        fragility=fragility_question(content, study.hazard, folder=project.folder),
        report=report,
        resolved=with_asked_procedures(resolve(project), content),
        messages=(*input_messages(project, study, files, messages), *said),
        sweeps=tuple(
            sweep_of(variation, project, files, beside={m.name: m.beside for m in study.mechanisms})
            for variation in project.variations
        ),
        survey=survey_of(project, study, solids, partial(alone, project=project, files=files)),
        variables=variables_of(project, study, solids, partial(alone, project=project, files=files)),
        sampling=sampling_of(project, study, solids, partial(cases_of, project=project, files=files)),
    )


def input_messages(project: Project, study: Study, files: Files, messages: tuple[Message, ...]) -> tuple[Message, ...]:
    """Return the messages on a project's input.

    Parameters
    ----------
    project : as read
    study : what its verdict depends on
    files : that it names
    messages : on its records
    """
    return (
        *project.messages,
        *uncertainty_messages(project),
        *locate(files.spectrum.warnings if files.spectrum else (), "site.spectrum"),
        *project_messages(project.content, files.solids, study),
        *messages,
    )


def deciding_part_of(project: Project, *, executor: Executor | None = None) -> tuple[Study, Files, tuple[Message, ...]]:
    """Build what the verdict of a project depends on; with what its files hold, and messages on the records."""
    content = project.content
    site = site_in(content)
    spectrum = None if site is None else spectrum_of(site)
    models = models_of(content.bodies, known={})
    solids = {name: solid_of(name, body, content.materials, models) for name, body in content.bodies.items()}
    named, messages = all_records(content.records, project.folder, spectrum)
    study = part_of(content, Files(models, solids, spectrum, named), names=content.mechanisms)
    wanted = content.records.selection
    if wanted is not None and spectrum is not None:
        named, messages = record_set.select_records(
            content.records,
            wanted,
            study=study,
            spectrum=spectrum,
            folder=project.folder,
            executor=executor,
        )
    study = replace(study, records=named.records, fitting=named.fitting)
    return study, Files(models, solids, spectrum, named), messages


def part_of(
    content: sections.Content, files: Files, *, names: Iterable[str], built_by: Builder = mechanism_in_direction
) -> Study:
    """Build the study of some mechanisms of a project, without messages about its file.

    built_by : builds a mechanism; `mechanism_as_given` where direction and sides are settled
    """
    site, building, synthetic = site_in(content), content.building, content.records.made
    chosen = {name: content.mechanisms[name] for name in names}
    definitions, bodies = definitions_of(content), bodies_of(content, files.solids)
    ground = ground_of(building, definitions, files.solids)
    built = {name: built_by(name, definitions[name], bodies) for name in chosen}
    in_place = {
        name: MechanismInPlace(
            name=name,
            definition=definitions[name],
            built=built[name],
            bodies=bodies,
            ground=ground,
            structure=structure_of(building),
            base_elevation=base_elevation_of(section),
        )
        for name, section in chosen.items()
    }
    own = files.spectrum
    question = question_of(content, site_pga=own.pga if own else 0.0, scale=own.factor if own else 1.0)
    return Study(
        spectrum=files.spectrum,
        vertical_ratio=0.0 if site is None else site.vertical_ratio,
        building=structure_below(building),
        records=files.named.records,
        fitting=files.named.fitting,
        artificial=None if synthetic is None else Artificial(synthetic.count, synthetic.seed, synthetic.duration),
        scale_to=content.records.scale_to,
        record_factor=content.records.further_factor,
        levels=levels_of(content.analysis.levels, files.spectrum),
        scan=content.analysis.scan,
        question=question,
        facts=facts_of(content, question, tuple(chosen), files.spectrum),
        grounded={name: ground_mechanism(section, built[name].mechanism, ground) for name, section in chosen.items()},
        procedures=procedures_of(content),
        offered=content.site_procedures,
        options=options_of(content),
        mechanisms=tuple(each.mechanism for each in built.values()),
        scenes={each.mechanism.name: each.scene for each in built.values() if each.scene is not None},
        amplified={name: amplify(amplification_method_of(chosen[name]), one) for name, one in in_place.items()},
        equations={name: equation_of(section, content) for name, section in chosen.items()},
        inputs=(),
        resolved={},
        messages=(),
        sweeps=(),
        pulses=None if content.analysis.pulses is None else grid_of(content.analysis.pulses),
        hazard=None if site is None else hazard_over_periods(site),
        free_periods=free_periods_of(content),
        knowledge=knowledge_of(content),
        limit_state=None if site is None else site.own_limit_state,
    )


def sweep_of(variation: Variation, project: Project, files: Files, *, beside: Mapping[str, tuple[str, ...]]) -> Sweep:
    """Build the cases of a sweep, each with the mechanisms that depend on its key; beside: bodies that touch each."""
    names = dependents(project.content, variation.path, beside=beside)
    if not names:
        raise ProjectError(
            f"{variation.where}.key: {value_text(variation.key)}: no mechanism depends on it; name another"
        )
    cases = tuple(case_of(variant, project, files, names=names) for variant in variation.variants)
    return Sweep(variation.key, variation.unit, cases)


def case_of(variant: Variant, project: Project, files: Files, *, names: tuple[str, ...]) -> Case:
    """Build one case of a sweep."""
    with locate_errors(variant.name):
        study = part_of(variant.content, reread(variant.content, project, files), names=names)
    return Case(variant.value, variant.name, study)


def alone(
    name: str, content: sections.Content, replaced: Mapping[str, Solid], *, project: Project, files: Files
) -> Study:
    """Build the study of one mechanism from other content of the project, with some of its bodies replaced.

    Its direction and sides stand in the content.
    """
    return cases_of(content, project=project, files=files).build(name, replaced)


def cases_of(content: sections.Content, *, project: Project, files: Files) -> Cases:
    """Return what builds the study of one mechanism from other content of the project, whose files are read once."""
    known = reread(content, project, files)

    def case(name: str, replaced: Mapping[str, Solid]) -> Study:
        solids = {**known.solids, **replaced}
        return part_of(content, replace(known, solids=solids), names=(name,), built_by=mechanism_as_given)

    return Cases(known.solids, case)


def reread(content: sections.Content, project: Project, files: Files) -> Files:
    """Read the files of a case; what the case has not changed is not read again."""
    whole = project.content
    changed = {name: body for name, body in content.bodies.items() if not same_body(name, content, whole)}
    models = models_of(changed, known=files.models)
    solids = {
        name: solid_in_case(name, content, whole, models, files.solids) if name in changed else files.solids[name]
        for name in content.bodies
    }
    site = site_in(content)
    spectrum = files.spectrum if site is None or site == site_in(whole) else spectrum_of(site)
    same = content.records == whole.records
    if not same and (content.records.select is not None or content.records.lock is not None):
        how = "selected by" if content.records.lock is None else "locked by"
        raise ProjectError(f"records: a sweep cannot vary what records are {how}; sweep another key")
    records = files.named if same else all_records(content.records, project.folder, spectrum)[0]
    return Files(models, solids, spectrum, records)


def solid_in_case(
    name: str, case: sections.Content, whole: sections.Content, models: Models, solids: Mapping[str, Solid | None]
) -> Solid | None:
    """Return the solid of a body that a case changes; a mesh of another density only is not put together again."""
    body, known = case.bodies[name], solids[name]
    if known is None or body != whole.bodies[name] or not isinstance(body, sections.MeshBody):
        return solid_of(name, body, case.materials, models)
    before, after = (content.materials[body.material].density for content in (whole, case))
    return scale_density(known, after / before)


def same_body(name: str, case: sections.Content, whole: sections.Content) -> bool:
    """Whether a body and its material are those of the whole project."""
    material = getattr(case.bodies[name], "material", "")
    return case.bodies[name] == whole.bodies[name] and case.materials.get(material) == whole.materials.get(material)


def levels_of(given: tuple[float, ...] | None, spectrum: Spectrum | None) -> tuple[float, ...]:
    """Return the levels given and the site's own PGA, at which the verdict is found, in rising order [m/s2]."""
    if spectrum is None:
        return tuple(sorted(given or ()))
    return levels_with_site(tuple(sorted(given or ())), spectrum.pga)


def structure_below(section: sections.Building | None) -> Building | None:
    """Return the structure below the mechanisms; None if its height is not given."""
    if section is None or section.height is None:
        return None
    stated: dict[str, FirstMode] = {
        name: FirstMode(mode.period, mode.damping, mode.reason) for name, mode in section.limit_states.items()
    }
    return Building(**section.model_dump(include=CLAUSES_NEED), limit_states=stated)


def equation_of(section: sections.Mechanism, content: sections.Content) -> Equation:
    """Return the equation of motion requested, else linearised for equivalent blocks and exact for all others."""
    default: Equation = "linearised" if isinstance(section, sections.EquivalentBlock) else "exact"
    return content.analysis.equation or default


def grid_of(section: sections.Pulses) -> PulseGrid:
    """Return the grid of pulses of the envelopes."""
    spaced = np.geomspace if section.frequency.spacing == "log" else np.linspace
    frequency = spaced(section.frequency.start, section.frequency.to, section.frequency.count)
    amplitude = np.linspace(section.amplitude.start, section.amplitude.to, section.amplitude.count)
    return PulseGrid(pulse_shape(section.shape, gamma=section.gamma, nu=section.nu), frequency, amplitude)


def all_records(
    section: sections.Records, folder: Path, spectrum: Spectrum | None
) -> tuple[RecordSet, tuple[Message, ...]]:
    """Read every horizontal record named or locked, with messages; none are read here if a suite is to be selected."""
    if section.selection is not None or (section.lock is not None and spectrum is None):
        return RecordSet((), Fitting(EVERYWHERE)), ()
    if section.lock is not None and spectrum is not None:
        locked = locked_records(section.lock, folder=folder, spectrum=spectrum)
        return locked, (*lock_messages(section.lock, section), *record_messages(locked.records))
    found = record_set.all_of(section, folder)
    return replace(found, records=horizontal_records(found.records)), (
        *vertical_record_messages(found.records),
        *record_messages(found.records),
    )
