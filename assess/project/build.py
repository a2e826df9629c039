"""From the tables of a project file to the study they describe, and the files that it is made of."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import Executor
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field, fields, replace
from functools import partial
from pathlib import Path
from typing import Protocol

import numpy as np

from assess.codes.asce43_05 import VERTICAL_RATIO
from assess.codes.context import Building
from assess.codes.verdict import falling_message
from assess.dynamics.packing import Equation
from assess.errors import AssessError, FallingError, Faults, ProjectError, locate_errors, other_faults
from assess.geometry.mesh import MeshesBySelection
from assess.geometry.solid import Solid, scale_density
from assess.loads.load import bodies_of as loading_bodies
from assess.mechanisms.kinds import Definition
from assess.mechanisms.mechanism import BlockMechanism
from assess.mechanisms.single_block import EquivalentBlock
from assess.mechanisms.two_block import TwoBlock
from assess.messages.message import Message, locate
from assess.model.assembly import Built
from assess.model.bodies import Bodies
from assess.model.directions import mechanism_as_given, mechanism_in_direction
from assess.model.walls import stands_on_masonry
from assess.project import sections
from assess.project.input_messages import project_messages
from assess.project.inputs import FileStates, inputs_of, note_states, refuse_changes
from assess.project.key_errors import key_text, value_text
from assess.project.keys import KeySweep, ProjectVariant, Setting, dependents, key_sweeps, read_case, with_values
from assess.project.overrides import replace_values, replaceables_of
from assess.project.project_file import Project, resolve
from assess.project.question import (
    facts_of,
    fragility_question,
    free_periods_of,
    knowledge_of,
    options_of,
    procedures_of,
    question_of,
    with_values_of_run,
)
from assess.project.record_set import (
    horizontal_records,
    lock_messages,
    locked_records,
    named_records,
    select_records,
    vertical_record_messages,
)
from assess.project.report import annex_of, report_matter_of, uses_of
from assess.project.section import plain_data
from assess.project.site_and_structure import (
    amplification_method_of,
    base_elevation_of,
    bodies_of,
    definitions_of,
    density_of,
    ground_mechanism,
    ground_of,
    hazard_over_periods,
    is_drawn_tie,
    models_of,
    site_in,
    solid_of,
    spectrum_of,
    structure_of,
)
from assess.project.state_before import Before, at_another_site, read_before
from assess.project.variables import Cases, Variants, sampling_of, survey_of, uncertainty_messages, variables_of
from assess.results.run import FallingMechanism
from assess.study.amplification import MechanismInPlace, amplify
from assess.study.study import Fitting, PulseGrid, Replaceable, Study, Sweep, SweepCase, levels_with_site
from assess.study.suites import ALL_PERIODS, RecordSet, record_messages
from records.errors import RecordError
from records.pulses import pulse_shape
from spectra.spectrum import Spectrum

Builder = Callable[[str, Definition, Bodies], Built]
NO_RECORDS = RecordSet((), Fitting(ALL_PERIODS))
CLAUSES_NEED = {"height", "storeys", "period", "damping"}  # of [building]


@dataclass(frozen=True)
class ProjectFiles:
    """What the files of a project hold: models; bodies by name, None without geometry; the site's spectrum; records.

    states : of the files, before the first was read
    built : the mechanisms that are already built of these bodies, by name
    before : the state before the works; None where the project names none
    """

    models: MeshesBySelection
    solids: Mapping[str, Solid | None]
    spectrum: Spectrum | None
    named: RecordSet
    states: FileStates
    built: Mapping[str, Built] = field(default_factory=dict)
    before: Before | None = None


@dataclass(frozen=True)
class Known:
    """What has been read of a project that differs from another in a few values."""

    content: sections.Content
    files: ProjectFiles


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
        return _study_to_decide(project)


def _study_to_decide(project: Project, *, known: Known | None = None) -> Study:
    """Build the study of `build_to_decide`, with errors that do not name the project file."""
    if project.sweeps:
        return study_of(project, known=known)
    study, files, messages = _deciding_study(project, known=known)
    study = _with_replaceables(study, project, files, read_again=_study_to_decide)
    refuse_changes(files.states)
    return replace(study, messages=_input_messages(project, study, files, messages))


def uses_of_project(project: Project) -> tuple[str, ...]:
    """Return what a project uses of the program, in the words of `assess.results.verification`.

    Raises
    ------
    AssessError, SpectrumError or RecordError : as `build`
    """
    with locate_errors(str(project.path)):
        return uses_of(project.content, _deciding_study(project)[0])


def study_of(project: Project, *, executor: Executor | None = None, known: Known | None = None) -> Study:
    """Build the study of a project, with errors that do not name the project file.

    Parameters
    ----------
    project : the project file as read
    executor : processes that share the reading of many records; None for this process alone
    known : what has been read of a project that differs in a few values; its models are not read again
    """
    content = project.content
    report = report_matter_of(content, project.folder)
    study, files, messages = _deciding_study(project, executor=executor, known=known)
    variants = Variants(project, files.solids, partial(cases_of, project=project, files=files))
    annex, annex_messages = annex_of(project, uses_of(content, study))
    study = _with_replaceables(study, project, files, read_again=study_of)
    inputs = tuple(inputs_of(project, files.named.records, annex))
    refuse_changes(files.states)
    touching = {each.name: each.adjacent_bodies for each in study.mechanisms}
    sweeps = tuple(
        _sweep_of(sweep, project, files, names=dependents(content, sweep.path, touching=touching))
        for sweep in project.sweeps
    )
    return replace(
        study,
        annex=annex,
        inputs=inputs,
        fragility=fragility_question(
            content.analysis.fragility or sections.Fragility(),
            content.analysis.risk or sections.Risk(),
            study.hazard,
            folder=project.folder,
        ),
        report=report,
        resolved=with_values_of_run(resolve(project), content, study.question),
        messages=(*_input_messages(project, study, files, messages), *annex_messages),
        sweeps=sweeps,
        survey=survey_of(variants, study),
        variables=variables_of(variants, study),
        sampling=sampling_of(variants, study),
    )


class ReadAgain(Protocol):
    """Builds the study of a project that differs in a few values from one that has been read."""

    def __call__(self, project: Project, /, *, known: Known | None = None) -> Study:
        """Build the study."""


def _with_replaceables(study: Study, project: Project, files: ProjectFiles, *, read_again: ReadAgain) -> Study:
    """Return a study with its values that something stands for, and what builds it without some of them.

    read_again : builds the study of the project in which they are replaced
    """

    touching = {each.name: each.adjacent_bodies for each in study.mechanisms}

    def study_at(setting: Setting) -> Callable[[str], Study]:
        content = read_case(setting, project.content, project.raw, project.folder)
        known = _files_of_case(content, project, files)
        raw = with_values(project.raw, setting, project.content) if content.analysis.sweeps else {}
        swept = key_sweeps(content, raw, project.folder)

        def alone(name: str) -> Study:
            sweeps = (
                _sweep_of(each, project, files, names=(name,))
                for each in swept
                if name in dependents(content, each.path, touching=touching)
            )
            return replace(_study_of_mechanisms(content, known, names=(name,)), sweeps=tuple(sweeps))

        return alone

    def replaced(values: Sequence[Replaceable]) -> Study:
        without = read_again(replace_values(project, values), known=Known(project.content, files))
        return replace(without, replaceables=(), replaced=None)

    found = replaceables_of(project, files.solids, study, study_at=study_at)
    return replace(study, replaceables=found, replaced=replaced)


def case_of(variant: ProjectVariant, project: Project, files: ProjectFiles, *, names: tuple[str, ...]) -> SweepCase:
    """Build one case of a sweep."""
    with locate_errors(variant.name):
        study = _study_of_mechanisms(variant.content, _files_of_case(variant.content, project, files), names=names)
    return SweepCase(variant.value, variant.name, study)


def cases_of(content: sections.Content, *, project: Project, files: ProjectFiles) -> Cases:
    """Return what builds the study of one mechanism from other content of the project, whose files are read once."""
    known = _files_of_case(content, project, files)

    def study_of_case(name: str, replaced: Mapping[str, Solid]) -> Study:
        solids = {**known.solids, **replaced}
        return _study_of_mechanisms(content, replace(known, solids=solids), names=(name,), built_by=mechanism_as_given)

    return Cases(known.solids, study_of_case)


@dataclass(frozen=True)
class BuiltProject:
    """A project whose files are read once, and whose mechanisms can be built again of other tables.

    study : what its verdict depends on; solids : its bodies by name, None without geometry
    study_at : builds the study of mechanisms by their names, of other content of the project
    bodies_at : returns the bodies by name, of other content of the project
    study_to_decide : builds what `build_to_decide` does, of a project that differs in a few values
    """

    project: Project
    study: Study
    solids: Mapping[str, Solid | None]
    study_at: Callable[[sections.Content, tuple[str, ...]], Study]
    bodies_at: Callable[[sections.Content], Bodies]
    study_to_decide: Callable[[Project], Study]


def build_with_cases(project: Project) -> BuiltProject:
    """Build what the verdict of a project depends on, and what builds its mechanisms with other values.

    Direction and sides that the project leaves open stay what they are with its own values.

    Raises
    ------
    AssessError, SpectrumError or RecordError : as `build`
    """
    content = project.content
    with locate_errors(str(project.path)):
        study, files, _ = _deciding_study(project)
        refuse_changes(files.states)
    fixed = Variants(project, files.solids, partial(cases_of, project=project, files=files))
    directed = fixed.with_directions(study.mechanisms).project

    def study_at(content: sections.Content, names: tuple[str, ...]) -> Study:
        known = _files_of_case(content, directed, files)
        return _study_of_mechanisms(content, known, names=names, built_by=mechanism_as_given)

    def bodies_at(content: sections.Content) -> Bodies:
        return bodies_of(content, _files_of_case(content, directed, files).solids)

    def study_to_decide(tried: Project) -> Study:
        same = all(getattr(tried.content, key) == getattr(content, key) for key in ("site", "verdict", "building"))
        with locate_errors(str(project.path)):  # the state before the works depends on what is asked of the site
            return _study_to_decide(tried, known=Known(content, files) if same else None)

    return BuiltProject(directed, study, files.solids, study_at, bodies_at, study_to_decide)


def levels_of(given: tuple[float, ...] | None, spectrum: Spectrum | None) -> tuple[float, ...]:
    """Return the levels given and the site's own PGA, at which the verdict is found, in rising order [m/s2]."""
    if spectrum is None:
        return tuple(sorted(given or ()))
    return levels_with_site(tuple(sorted(given or ())), spectrum.pga)


def _files_of(project: Project, *, known: Known | None) -> tuple[ProjectFiles, tuple[Message, ...]]:
    """Read the files of a project, with messages on its records.

    A model is not read again that is known, nor a body put together again. What is wrong with spectrum, bodies and
    records is raised at once, and with it what is wrong with the mechanisms of bodies without a fault.
    """
    content, faults = project.content, Faults(RecordError)
    states = note_states(project) if known is None else known.files.states
    spectrum: Spectrum | None = None
    with faults.gather():
        site = site_in(content)
        spectrum = None if site is None else spectrum_of(site)
    models = models_of(content.bodies, known={} if known is None else known.files.models, faults=faults)
    solids: dict[str, Solid | None] = {}
    for name, body in content.bodies.items():
        if known is not None and name in known.content.bodies and _same_body(name, content, known.content):
            solids[name] = known.files.solids[name]
        elif not isinstance(body, sections.MeshBody) or (body.mesh, body.element) in models:
            with faults.gather():
                solids[name] = solid_of(name, body, content.materials, models)
    named, messages = NO_RECORDS, tuple[Message, ...]()
    with faults.gather():
        named, messages = _all_records(content.records, project.folder, spectrum)
    before = None if known is None else known.files.before
    if known is None and spectrum is not None:
        with faults.gather():
            question = question_of(content, site_pga=spectrum.pga, scale=spectrum.factor)
            before = read_before(content, question, spectrum, project.folder)
    if faults.any:
        _gather_mechanism_faults(content, solids, faults)
    faults.raise_all()
    built = {} if known is None else _same_mechanisms(content, known.content, known.files.built)
    return ProjectFiles(models, solids, spectrum, named, states, built, before), messages


def _gather_mechanism_faults(content: sections.Content, solids: Mapping[str, Solid | None], faults: Faults) -> None:
    """Build each mechanism whose bodies are sound for its faults alone."""
    known = content.model_copy(update={"bodies": {name: content.bodies[name] for name in solids}})
    sound = bodies_of(known, solids)
    for name, definition in definitions_of(content).items():
        moved = definition.bodies if isinstance(definition, BlockMechanism) else ()
        loads = definition.loads if isinstance(definition, BlockMechanism) else ()
        if set(solids).issuperset((*moved, *(body for load in loads for body in loading_bodies(load)))):
            with faults.gather(), suppress(FallingError), _errors_at(name, definition):
                mechanism_in_direction(name, definition, sound)


@contextmanager
def _errors_at(name: str, definition: Definition) -> Iterator[None]:
    """Name the key of a mechanism, as the file has it, in errors of the model, which names the mechanism."""
    try:
        yield
    except FallingError:
        raise
    except AssessError as error:
        first, *others = (_at_key(name, definition, text) for text in (str(error), *other_faults(error)))
        located = type(error)(first)
        for other in others:
            located.add_note(other)
        raise located from None


def _at_key(name: str, definition: Definition, text: str) -> str:
    """Return what the model says of a mechanism, which it names, with the key of the file instead."""
    key, text = key_text(("mechanisms", name)), text.removeprefix(f'mechanism "{name}": ')
    if text.startswith(key):
        return text
    below = re.match(r"(\w+)[^ ]*( =|:) ", text)
    of_its_own = below is not None and below[1] in {each.name for each in fields(definition)}
    return f"{key}{'.' if of_its_own else ': '}{text}"


def _deciding_study(
    project: Project, *, executor: Executor | None = None, known: Known | None = None
) -> tuple[Study, ProjectFiles, tuple[Message, ...]]:
    """Build what the verdict of a project depends on; with what its files hold, and messages on the records.

    known : what has been read of a project that differs in a few values
    """
    content = project.content
    files, messages = _files_of(project, known=known)
    study = _study_of_mechanisms(content, files, names=content.mechanisms, may_fall=True)
    spectrum, named = files.spectrum, files.named
    selection = content.records.selection
    if selection is not None and spectrum is not None and study.mechanisms:
        named, messages = select_records(
            content.records,
            selection,
            study=study,
            spectrum=spectrum,
            folder=project.folder,
            executor=executor,
        )
    study = replace(study, records=named.records, fitting=named.fitting)
    built = {each.name: Built(each, study.scenes.get(each.name)) for each in study.mechanisms}
    return study, replace(files, named=named, built=built), messages


def _study_of_mechanisms(
    content: sections.Content,
    files: ProjectFiles,
    *,
    names: Iterable[str],
    built_by: Builder = mechanism_in_direction,
    may_fall: bool = False,
) -> Study:
    """Build the study of some mechanisms of a project, without messages about its file.

    built_by : builds a mechanism; `mechanism_as_given` where direction and sides are settled
    may_fall : whether mechanisms that fall under their own loads are set apart; raises FallingError for one otherwise
    """
    site, building = site_in(content), content.building
    chosen = {name: content.mechanisms[name] for name in names}
    definitions, bodies = definitions_of(content), bodies_of(content, files.solids)
    ground = ground_of(building, definitions, files.solids)
    known = files.built if built_by is mechanism_in_direction else {}
    built: dict[str, Built] = {}
    falling: list[FallingMechanism] = []
    faults = Faults()
    for name, section in chosen.items():
        try:
            with faults.gather(besides=(FallingError,)), _errors_at(name, definitions[name]):
                built[name] = known.get(name) or built_by(name, definitions[name], bodies)
        except FallingError as error:
            if not may_fall:
                raise
            reason = str(error).removeprefix(f'mechanism "{name}": already falling').lstrip(": ")
            falling.append(FallingMechanism(name, section.label, section.kind, error.multiplier, reason))
    faults.raise_all()
    chosen = {name: chosen[name] for name in built}
    heights = {}
    for name, section in chosen.items():
        with _errors_at(name, definitions[name]):  # here a mechanism is first placed on its joints
            heights[name] = ground_mechanism(section, built[name].mechanism, ground)
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
    chains = (each for each in content.mechanisms.values() if isinstance(each, sections.ChainSection))
    in_blocks = {body for each in chains for block in each.blocks for body in block}
    beside = {name: solid for name, solid in files.solids.items() if solid is not None and name not in in_blocks}
    question = question_of(
        content, site_pga=own.pga if own else 0.0, scale=own.factor if own else 1.0, before=files.before
    )
    return Study(
        spectrum=files.spectrum,
        vertical_ratio=VERTICAL_RATIO if site is None else site.vertical_ratio,
        building=_structure_below(building),
        records=files.named.records,
        fitting=files.named.fitting,
        artificial=content.records.made,
        scale_to=content.records.scale_to,
        record_factor=content.records.further_factor,
        levels=levels_of(content.analysis.levels, files.spectrum),
        scan=content.analysis.scan,
        question=question,
        facts=facts_of(content, question, tuple(chosen), files.spectrum, solids=files.solids),
        heights=heights,
        moving={name: each.bodies for name, each in definitions.items() if not isinstance(each, EquivalentBlock)},
        on_masonry={
            name: stands_on_masonry(definition, bodies)
            for name, definition in definitions.items()
            if name in built and isinstance(definition, TwoBlock)
        },
        procedures=procedures_of(content),
        offered=content.site_procedures,
        options=options_of(content),
        mechanisms=tuple(each.mechanism for each in built.values()),
        scenes={each.mechanism.name: each.scene for each in built.values() if each.scene is not None},
        beside=tuple(beside.values()),
        drawn_ties=frozenset(
            solid.name
            for name, solid in beside.items()
            if is_drawn_tie(name, content.bodies[name], solid, files.models)
        ),
        amplified={name: amplify(amplification_method_of(chosen[name]), one) for name, one in in_place.items()},
        equations={name: _equation_of(section, content) for name, section in chosen.items()},
        inputs=(),
        resolved={},
        messages=(),
        sweeps=(),
        pulses=None if content.analysis.pulses is None else _grid_of(content.analysis.pulses),
        hazard=None if site is None else hazard_over_periods(site),
        free_periods=free_periods_of(content),
        knowledge=knowledge_of(content),
        limit_state=None if site is None else site.own_limit_state,
        falling=tuple(falling),
        before=None if files.before is None else files.before.shown,
    )


def _input_messages(
    project: Project, study: Study, files: ProjectFiles, messages: tuple[Message, ...]
) -> tuple[Message, ...]:
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
        *(() if study.before is None else study.before.differences),
        *uncertainty_messages(project),
        *locate(files.spectrum.warnings if files.spectrum else (), "site.spectrum"),
        *project_messages(project.content, files.solids, study),
        *map(falling_message, study.falling),
        *messages,
    )


def _sweep_of(sweep: KeySweep, project: Project, files: ProjectFiles, *, names: tuple[str, ...]) -> Sweep:
    """Build the cases of a sweep, each with these of the mechanisms that depend on its key."""
    if not names:
        raise ProjectError(f"{sweep.where}.key: {value_text(sweep.key)}: no mechanism depends on it; name another")
    cases = tuple(case_of(variant, project, files, names=names) for variant in sweep.variants)
    return Sweep(sweep.key, sweep.unit, cases, has_typed=sweep.has_typed)


def _files_of_case(content: sections.Content, project: Project, files: ProjectFiles) -> ProjectFiles:
    """Read the files of a case; what the case has not changed is not read again."""
    whole = project.content
    changed = {name: body for name, body in content.bodies.items() if not _same_body(name, content, whole)}
    models = models_of(changed, known=files.models)
    solids = {
        name: _solid_in_case(name, content, whole, models, files.solids) if name in changed else files.solids[name]
        for name in content.bodies
    }
    site = site_in(content)
    same_site = site is None or site == site_in(whole)
    spectrum = files.spectrum if site is None or same_site else spectrum_of(site)
    before = files.before if same_site else at_another_site(files.before)
    same = content.records == whole.records
    if not same and (content.records.select is not None or content.records.lock is not None):
        how = "selected by" if content.records.lock is None else "locked by"
        raise ProjectError(f"records: a sweep cannot vary what records are {how}; sweep another key")
    records = files.named if same else _all_records(content.records, project.folder, spectrum)[0]
    built = _same_mechanisms(content, whole, files.built)
    return ProjectFiles(models, solids, spectrum, records, files.states, built, before)


def _solid_in_case(
    name: str,
    case: sections.Content,
    whole: sections.Content,
    models: MeshesBySelection,
    solids: Mapping[str, Solid | None],
) -> Solid | None:
    """Return the solid of a body that a case changes; a mesh of another density only is not put together again."""
    body, known = case.bodies[name], solids.get(name)
    if known is None or body != whole.bodies[name] or not isinstance(body, sections.MeshBody):
        return solid_of(name, body, case.materials, models)
    before, after = (density_of(body, content.materials) for content in (whole, case))
    return scale_density(known, after / before)


def _same_body(name: str, case: sections.Content, whole: sections.Content) -> bool:
    """Whether a body and its material are those of the whole project."""
    material = getattr(case.bodies[name], "material", "")
    return (
        name in whole.bodies
        and case.bodies[name] == whole.bodies[name]
        and case.materials.get(material) == whole.materials.get(material)
    )


def _same_mechanisms(
    case: sections.Content, whole: sections.Content, built: Mapping[str, Built]
) -> Mapping[str, Built]:
    """Return those mechanisms of the whole project that a case builds of the same bodies, by the same definition."""
    if any((case.bodies != whole.bodies, case.materials != whole.materials, case.report != whole.report)):
        return {}
    before, after = definitions_of(whole), definitions_of(case)  # plates have FC, and those of other mechanisms
    return {
        name: each
        for name, each in built.items()
        if case.mechanisms.get(name) == whole.mechanisms.get(name) and after.get(name) == before.get(name)
    }


def _structure_below(section: sections.BuildingSection | None) -> Building | None:
    """Return the structure below the mechanisms; None if its height is not given."""
    if section is None or section.height is None:
        return None
    return Building(**section.model_dump(include=CLAUSES_NEED), limit_states=plain_data(section.limit_states))


def _equation_of(section: sections.MechanismSection, content: sections.Content) -> Equation:
    """Return the equation of motion requested, else linearised for equivalent blocks and exact for all others."""
    default: Equation = "linearised" if section.kind == "equivalent-block" else "exact"
    return content.analysis.equation or default


def _grid_of(section: sections.Pulses) -> PulseGrid:
    """Return the grid of pulses of the envelopes."""
    spaced = np.geomspace if section.frequency.spacing == "log" else np.linspace
    frequency = spaced(section.frequency.start, section.frequency.to, section.frequency.count)
    amplitude = np.linspace(section.amplitude.start, section.amplitude.to, section.amplitude.count)
    return PulseGrid(pulse_shape(section.shape, gamma=section.gamma, nu=section.nu), frequency, amplitude)


def _all_records(
    section: sections.Records, folder: Path, spectrum: Spectrum | None
) -> tuple[RecordSet, tuple[Message, ...]]:
    """Read every horizontal record named or locked, with messages; none are read here if a suite is to be selected."""
    if section.selection is not None or (section.lock is not None and spectrum is None):
        return NO_RECORDS, ()
    if section.lock is not None and spectrum is not None:
        locked = locked_records(section.lock, folder=folder, spectrum=spectrum)
        return locked, (*lock_messages(section.lock, section), *record_messages(locked.records))
    found = named_records(section, folder)
    return replace(found, records=horizontal_records(found.records)), (
        *vertical_record_messages(found.records),
        *record_messages(found.records),
    )
