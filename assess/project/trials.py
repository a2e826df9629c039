"""A mechanism with values that are tried: at once as typed, and as a run would decide on it once they are written.

What is asked while a value moves is statics and checks by spectra of the mechanism with the values as typed. What a run
decides by may be others: values without a source are replaced, swept ones take the worst, and the weakest direction may
turn. That is found of the whole project, with the mechanisms that nothing changes taken over.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace

from assess.codes.check import Check
from assess.codes.procedures import uses_histories
from assess.codes.question import methods_of
from assess.codes.verdict import MechanismVerdict, Verdict, at_action
from assess.errors import AssessError, MechanismError
from assess.mechanisms.mechanism import Mechanism
from assess.mechanisms.single_block import SingleBlock
from assess.messages.message import Message
from assess.model.weakest_crack import WeakestCrack, find_weakest_crack
from assess.project import sections
from assess.project.build import BuiltProject
from assess.project.project_file import Project, resolve
from assess.project.sections.content import checklist
from assess.project.site_and_structure import definitions_of
from assess.results import SCHEMA_VERSION, MechanismResult, ReportMatter, Results
from assess.results.provenance import describe_program
from assess.study.assessment import checks_without_twins
from assess.study.checks import decide
from assess.study.level_peaks import Solved
from assess.study.mechanism_results import parameters
from assess.study.run import CheckedMechanism, Decided, find_decided_outcome
from assess.study.study import Study
from spectra.errors import SpectrumError

MOST_SOLVED = 500  # solutions of histories that are kept for the next decision


@dataclass(frozen=True)
class ShownMechanism:
    """What is known of a mechanism.

    result : its parameters; None where it falls at rest or cannot be built, those as typed where it falls in the state
        that decides alone
    checks : its answers; empty without a site
    verdict : its outcome as far as it is known
    fault : why it falls or cannot be built; empty otherwise
    as_typed : whether all that is with the values as typed, where a run may decide by others
    mechanism : as it is built; None where it is not
    """

    name: str
    result: MechanismResult | None
    checks: tuple[Check, ...] = ()
    verdict: MechanismVerdict | None = None
    fault: str = ""
    as_typed: bool = True
    mechanism: Mechanism | None = None


def try_mechanism(built: BuiltProject, content: sections.Content, name: str) -> ShownMechanism:
    """Return a mechanism of other content of a project with the values as typed, without time histories.

    Direction and sides that the project leaves open stay what they are with its own values.

    Parameters
    ----------
    built : the project, whose files are read
    content : its tables with what is tried
    name : of the mechanism
    """
    try:
        study = built.study_at(content, (name,))
        (result,) = parameters(study)
        checks, verdict = checks_by_spectra(study), None
        if study.spectrum is not None and not any(map(uses_histories, methods_of(study.question))):
            found = decide(study, [CheckedMechanism(name, checks)])
            verdict = next(each for each in found.mechanisms if each.mechanism == name)
    except (AssessError, SpectrumError) as error:
        return ShownMechanism(name, None, fault=str(error))
    return ShownMechanism(name, result, checks, verdict, mechanism=study.mechanisms[0])


def checks_by_spectra(study: Study) -> tuple[Check, ...]:
    """Return the checks of a study of one mechanism without time histories; none without a site."""
    if study.spectrum is None or not study.mechanisms:
        return ()
    asked = tuple(each for each in study.procedures if not uses_histories(each))
    return checks_without_twins(replace(study, procedures=asked), study.spectrum, (), jobs=1)


def weakest_crack(
    built: BuiltProject, content: sections.Content, name: str, progress: Callable[[int], object]
) -> WeakestCrack:
    """Find the weakest crack of a mechanism of one block, with what is tried besides; errors are those of the search.

    Parameters
    ----------
    built, content, name : as of `try_mechanism`
    progress : called with the number of cracks that have been tried
    """
    definition = definitions_of(content)[name]
    if not isinstance(definition, SingleBlock):
        raise MechanismError(f'mechanism "{name}": its crack is not that of one block; edit it in the file')
    return find_weakest_crack(name, definition, built.bodies_at(content), progress=progress)


@dataclass(frozen=True, repr=False)
class Decision:
    """What a run of a project decides, but for how near answers by histories are to their limits.

    results : as far as page 1 of the report needs them; shown : each mechanism as it decides, by name
    """

    decided: Decided
    results: Results
    shown: Mapping[str, ShownMechanism]

    @property
    def verdict(self) -> Verdict:
        """The verdict of the building."""
        return self.decided.verdict


@dataclass
class Decider:
    """Decides on projects that differ in a few values; what one decision has solved serves the next."""

    built: BuiltProject
    solved: Solved = field(default_factory=dict)

    def decide(self, project: Project) -> Decision | None:
        """Return what a run of a project decides; None without a site.

        Raises
        ------
        AssessError, SpectrumError or RecordError : as a run of it
        """
        study = self.built.study_to_decide(project)
        if study.spectrum is None:
            return None
        decided = find_decided_outcome(study, jobs=0, solved=self.solved)
        while len(self.solved) > MOST_SOLVED:
            del self.solved[next(iter(self.solved))]
        return Decision(
            decided, _page_results(project, decided, study.messages), {each.name: each for each in _shown(decided)}
        )


def deciding_checks(checks: tuple[Check, ...], study: Study) -> tuple[Check, ...]:
    """Return the checks by the methods that may decide, at the action of the site.

    Parameters
    ----------
    checks : of one mechanism
    study : whose question is decided
    """
    methods, action = methods_of(study.question), study.question.action
    return tuple(each for each in checks if each.procedure in methods and at_action(each, action))


def _shown(decided: Decided) -> Iterator[ShownMechanism]:
    results = {each.name: each for each in decided.mechanisms}
    falling = {each.name: f"falls at rest: {each.reason}" for each in decided.falling}
    for one in decided.verdict.mechanisms:
        name, result = one.mechanism, results.get(one.mechanism)
        built = decided.of[name].study.mechanisms[0] if name in decided.of else None
        fault = falling.get(name, "")
        checks = () if result is None or fault else result.checks
        yield ShownMechanism(name, result, checks, one, fault, as_typed=False, mechanism=built)


def _page_results(project: Project, decided: Decided, warnings: tuple[Message, ...]) -> Results:
    """Return results that hold what page 1 of the report says of a verdict, but for pictures and records."""
    content = project.content
    listed = checklist(content.report, content.mechanisms)
    return Results(
        schema_version=SCHEMA_VERSION,
        program=describe_program(),
        inputs=(),
        warnings=warnings,
        project=resolve(project),
        spectrum=None,
        records=(),
        mechanisms=decided.mechanisms,
        critical=None,
        comparison=(),
        sweeps=(),
        verdict=decided.verdict,
        report=ReportMatter(
            building_type=content.report.building_type or "",
            checklist=listed,
            struck_out=tuple(content.report.struck_out.items()),
        ),
        falling=tuple(each for each in decided.falling if each.name not in decided.of),
    )
