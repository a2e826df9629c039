"""The least works on a project: the question, the search, and the project with the best of them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from hashlib import sha256
from math import prod
from pathlib import Path

from assess.amplification import ModalFilter
from assess.codes.procedures import uses_histories
from assess.codes.question import find_limit_states, methods_of, missing_action
from assess.codes.verdict import Verdict
from assess.errors import ProjectError
from assess.loads.anchorage import CLOSE
from assess.messages.message import Message, Quantity, escape_text, note, warning
from assess.project.bars import bars_of
from assess.project.build import BuiltProject, build_to_decide, build_with_cases
from assess.project.key_errors import value_text
from assess.project.layouts import Designs
from assess.project.prices import PER_TIE, prices_of
from assess.project.project_file import Project, load_tree, parse_toml
from assess.project.relocation import relocate_paths, seen_from
from assess.project.toml_text import with_changes
from assess.project.units import to_si
from assess.project.works import Tables, axis_of, subject_of
from assess.results.retrofit import Reached, RetrofitResults, Target, TargetKind, VariedKey, proof_confidence
from assess.study.retrofit import (
    Found,
    Measure,
    Measures,
    find_least,
    measure_histories,
    measure_index,
    most_proofs,
    split_by_event,
    upper_share,
)
from assess.study.retrofit_search import FULL
from assess.study.run import find_outcome
from assess.study.study import Progress, ScaledRecord, Study, require_spectrum
from assess.study.suites import motions_of
from spectra.gravity import g

MOST_LAYOUTS = 100_000
SCHEMA = "#:schema "
TARGETS: tuple[TargetKind, ...] = ("index", "ratio", "probability")


@dataclass(frozen=True)
class RetrofitQuestion:
    """What is asked of works.

    target, reach : the measure and its value
    vary : ranges by keys of the file and by declared works
    limit_state : in place of that of the project
    price : by "steel" for each kg, "tie" for each, and by varied key for each unit of change, before those of the file;
        without any, or where None, steel counts
    spacing : between anchors, at most [m], or with its unit
    search_records : number of records on which layouts are searched, about; every second event where None
    """

    target: TargetKind
    reach: float
    vary: Mapping[str, str | Sequence[float | str]]
    limit_state: str | None = None
    price: Mapping[str, float | str] | None = field(default_factory=dict)
    spacing: float | str = CLOSE
    search_records: int | None = None

    @property
    def farthest(self) -> float:
        """The largest distance between anchors [m]."""
        return to_si(self.spacing, "length", key="spacing")


@dataclass(frozen=True)
class Retrofit:
    """The least works on a project.

    results : what was examined and found; project : as it was read; tables : of the project with the best works, None
    where none is proved
    """

    results: RetrofitResults
    project: Project
    tables: Tables | None

    def project_text(self, folder: Path) -> str:
        """Return the project with the best works as the text of a file in a folder.

        Paths are written anew; comments stay where the text around them does. None is written where none is proved.
        """
        assert self.tables is not None
        assert self.results.best is not None
        original = self.project.path.read_bytes().decode("utf-8-sig")
        text, _ = with_changes(original, relocate_paths(self.tables, self.project, folder))
        values = zip(self.results.varied, self.results.best.values, strict=True)
        lines = [escape_text(f"#   {each.key} = {value:.6g} {each.unit}".rstrip()) for each, value in values]
        head = [f"# Written by `assess retrofit` from {self.project.path.name!r}, with these works:", *lines]
        schema, rest = "", text
        if text.startswith(SCHEMA):  # by which editors find it beside the project
            line, _, rest = text.partition("\n")
            schema = SCHEMA + seen_from(line.removeprefix(SCHEMA).strip(), self.project.folder, folder) + "\n"
        return schema + "\n".join(head) + "\n\n" + rest


def find_retrofit(project: Project, question: RetrofitQuestion, *, jobs: int, progress: Progress) -> Retrofit:
    """Find the least works with which a project reaches a target.

    Parameters
    ----------
    project : as read; its sweeps are ignored
    question : what is to be reached, by what
    jobs : threads, 0 for all cores
    progress : called as layouts are examined

    Raises
    ------
    AssessError : a key or range is wrong, the target cannot be measured, or no number of records could show it
    """
    _check_question(question)
    project, tables = _read_again(project, question)
    progress("mechanisms", 0, 1)
    built = build_with_cases(project)
    designs = _designs(built, question)
    study = built.study
    if fallen := [each.name for each in study.falling if each.name in designs.mechanisms]:
        raise ProjectError(
            f"mechanisms.{fallen[0]}: falls at rest; write works with which it stands into the project, and vary those"
        )
    target = Target(question.target, question.reach, _rises(study, question.target))
    motions = None if question.target == "index" else _ground_motions(study, question, designs, jobs=jobs)
    measures = Measures(measure_index) if motions is None else _measures(target, motions, jobs=jobs)
    found = find_least(designs, target, measures, progress=progress)
    warnings = [*designs.messages(), *_conditions(designs)]
    with_works: Tables | None = None
    verdict: Verdict | None = None
    if found.best is not None:
        with_works = designs.apply(tables, found.best.place)
        reread = load_tree(dict(with_works), project.path, sha256="")
        found, verdict, more = _as_written(found, reread, designs, target, jobs=jobs)
        warnings += more
    results = _results(project, designs, target, motions, found, verdict, warnings)
    return Retrofit(results, project, with_works if found.best is not None else None)


def _read_again(project: Project, question: RetrofitQuestion) -> tuple[Project, Tables]:
    """Return the project with the limit state of a question, and its tables; raise ProjectError if it has changed."""
    written = project.path.read_bytes()
    if sha256(written).hexdigest() != project.sha256:
        raise ProjectError(f"{project.path}: has changed since it was read; run the command again")
    tables = parse_toml(written.decode("utf-8-sig"))
    if question.limit_state is None:
        return project, tables
    tables = {**tables, "verdict": {**tables.get("verdict", {}), "limit_state": question.limit_state}}
    return load_tree(tables, project.path, sha256=project.sha256), tables


@dataclass(frozen=True)
class _GroundMotions:
    """The records of the search and of the proof, and the PGA of the action and of the site [m/s2]."""

    seen: tuple[ScaledRecord, ...]
    rest: tuple[ScaledRecord, ...]
    pga: float
    site_pga: float


def _measures(target: Target, motions: _GroundMotions, *, jobs: int) -> Measures:
    """Return what measures studies by histories."""
    measured = partial(measure_histories, target, pga=motions.pga, site_pga=motions.site_pga, threads=jobs)

    def proof(layouts: int) -> tuple[Measure, Measure]:
        proving = partial(measured, motions.rest, confidence=proof_confidence(layouts))
        return proving(twins=False), proving(twins=True)

    search = measured(motions.seen, twins=False)
    if target.kind != "probability":
        return Measures(search, lambda _: proof(1))
    return Measures(search, proof, partial(most_proofs, len(motions.rest), target.reach), spread=True)


def _results(
    project: Project,
    designs: Designs,
    target: Target,
    motions: _GroundMotions | None,
    found: Found,
    verdict: Verdict | None,
    warnings: Sequence[Message],
) -> RetrofitResults:
    """Return what was found as data."""
    question, report = designs.built.study.question, project.content.report
    states, _ = find_limit_states(question)
    return RetrofitResults(
        title=project.content.title or "",
        language=report.language,
        units=report.units,
        mechanisms=designs.mechanisms,
        target=target,
        limit_state=states[0].name if states else "",
        index=question.basis.index.value if question.basis is not None and motions is None else "",
        pga_g=None if motions is None else motions.pga / g,
        varied=tuple(VariedKey(each.key, each.unit, each.present) for each in designs.axes),
        priced=bool(designs.prices.by_key),
        currency=designs.prices.currency,
        layouts=found.layouts,
        whole=prod(designs.sizes) <= FULL,
        best=found.best,
        nearest=found.nearest,
        proofs=found.proofs,
        tried=found.tried,
        most=found.most,
        candidates=found.candidates,
        search_records=() if motions is None else tuple(each.record.id for each in motions.seen),
        proof_records=() if motions is None else tuple(each.record.id for each in motions.rest),
        verdict="" if verdict is None else verdict.outcome.value,
        building_index=None if verdict is None or verdict.index is None else verdict.index.value,
        warnings=tuple(warnings),
        failed=found.failed,
    )


def _check_question(question: RetrofitQuestion) -> None:
    """Raise ProjectError for a question that cannot be asked."""
    if question.target not in TARGETS:
        raise ProjectError(f"target = {value_text(question.target)}: choose one of {', '.join(TARGETS)}")
    most = 1.0 if question.target == "probability" else 1e6
    if not 0.0 < question.reach <= most or (question.target == "probability" and question.reach == 1.0):
        end = "below 1" if question.target == "probability" else "up to 1e6"
        raise ProjectError(f"reach = {question.reach:g}: write a number above 0 and {end}, in the target's measure")
    if not question.vary:
        raise ProjectError('vary: nothing; write keys with their ranges, such as "mechanisms.NAME.ties.count = 2..6"')
    if not 0.0 < question.farthest <= 100.0:
        raise ProjectError(f"spacing = {question.farthest:g} m: write a distance between anchors, such as 3 m")


def _designs(built: BuiltProject, question: RetrofitQuestion) -> Designs:
    """Return the layouts that a question asks for."""
    content = built.project.content
    subjects = {name: each for name in content.mechanisms if (each := subject_of(name, content, built.solids))}
    axes = [axis_of(key, given, subjects, content) for key, given in question.vary.items()]
    layouts = prod(len(axis.values) for axis in axes)
    if layouts > MOST_LAYOUTS:
        raise ProjectError(f"vary: {layouts} layouts; give fewer values, {MOST_LAYOUTS} layouts at most")
    prices = prices_of(question.price, axes, content)
    for axis in axes:
        if not axis.mechanisms:
            raise ProjectError(f"vary {value_text(axis.key)}: no mechanism depends on it; name another key")
        bars = (tie.load for bar in bars_of(content, axis.mechanisms) for tie in bar)
        shown = axis.of_steel and not axis.priced and any(bar.area and bar.length for bar in bars)
        shown |= axis.key.endswith(".ties.count") and PER_TIE in prices.by_key
        if not shown and axis.key not in prices.by_key:
            raise ProjectError(
                f"vary {value_text(axis.key)}: it shows in no steel, so nothing says how much of it is least; give its "
                f"price for each {axis.unit or 'unit'} of change, price {axis.key} = NUMBER"
            )
    return Designs(built, axes, subjects, prices=prices, farthest=question.farthest)


def _rises(study: Study, kind: TargetKind) -> bool:
    """Return whether more of a measure is better; raise ProjectError for an index that cannot be searched."""
    if kind != "index":
        return False
    require_spectrum(study)
    basis = study.question.basis
    if basis is None:
        raise ProjectError('verdict.basis: missing; an index needs one, such as basis = "asce43-05"')
    _, missing = find_limit_states(study.question)
    if missing:
        raise ProjectError(f"{missing[0].key}: {missing[0].text}")
    if by_histories := [name for name in methods_of(study.question) if uses_histories(name)]:
        raise ProjectError(
            f"target index: it is found by {by_histories[0]}, and could not be proved on records that the search "
            "did not see; write --target ratio or probability, or name a static method in [verdict] procedures"
        )
    return basis.index.value != "D/C"


def _ground_motions(study: Study, question: RetrofitQuestion, designs: Designs, *, jobs: int) -> _GroundMotions:
    """Return the records of the search and of the proof."""
    spectrum = require_spectrum(study)
    for name in designs.mechanisms:
        if study.heights[name].above and not isinstance(study.amplified[name].amplification, ModalFilter):
            raise ProjectError(
                f"mechanisms.{name}: stands above the ground, whose motion can fail it and cannot pass it; write "
                'amplification = { method = "modal-filter" }'
            )
    motions = motions_of(study, spectrum, jobs=jobs)
    seen, left = split_by_event(motions, question.search_records)
    if question.target == "probability" and upper_share(0, len(left)) > question.reach:
        raise ProjectError(
            f"reach = {question.reach:g}: of {len(left)} records that prove it none may overturn and the upper end is "
            f"{upper_share(0, len(left)):.3f}, above it; give more records, or fewer to the search"
        )
    states, missing = find_limit_states(study.question)
    lacking = [*missing, *filter(None, (missing_action(each, study.question.action) for each in states[:1]))]
    if lacking:
        raise ProjectError(f"{lacking[0].key}: {lacking[0].text}")
    at_states = {} if study.hazard is None else study.hazard.spectra
    own = next((at_states[each.name] for each in states if each.name in at_states), spectrum)
    return _GroundMotions(tuple(motions[k] for k in seen), tuple(motions[k] for k in left), own.pga, spectrum.pga)


def _conditions(designs: Designs) -> Iterator[Message]:
    """Yield what the engineer has to see to, as no layout was refused for it."""
    if designs.ties and not designs.has_plates:
        yield note("retrofit-anchors", "mechanisms")
    if designs.farthest > CLOSE:
        yield warning("retrofit-spacing-allowed", "mechanisms", spacing=Quantity(designs.farthest, "length", 3))


def _as_written(
    found: Found, project: Project, designs: Designs, target: Target, *, jobs: int
) -> tuple[Found, Verdict | None, list[Message]]:
    """Return what was found, and verdict and messages of the project with the best works; none where it falls short.

    Values that no source vouches for are replaced there for an index, as in a run; of histories they are named.
    """
    study = build_to_decide(project)
    messages = []
    before = {each.name: each.direction for each in designs.built.study.mechanisms}
    for each in study.mechanisms:
        if each.name in designs.mechanisms and before.get(each.name) != each.direction:
            messages.append(warning("retrofit-direction", f"mechanisms.{each.name}.direction"))
    if target.kind != "index":
        typed = [each for each in study.replaceables if not each.source and {*each.mechanisms} & {*designs.mechanisms}]
        if typed:
            keys = ", ".join(dict.fromkeys(each.key for each in typed))
            messages.append(warning("retrofit-as-typed", "report.sources", keys=keys))
        return found, None, messages
    verdict = find_outcome(study, jobs=jobs or 1)
    short = [each for each in _indices(verdict).items() if not target.holds(Reached(each[1]))]
    if others := [name for name, _ in short if name not in designs.mechanisms]:
        messages.append(warning("retrofit-others", "mechanisms", mechanisms=", ".join(others)))
    if any(name in designs.mechanisms for name, _ in short):
        lacking = [each.key for each in verdict.overrides if not each.source]
        messages.append(warning("retrofit-unsourced", "report.sources", keys=", ".join(lacking) or "report.sources"))
        return replace(found, best=None), verdict, messages
    return found, verdict, messages


def _indices(verdict: Verdict) -> dict[str, float | None]:
    """Return the worst index of each mechanism; None where one is not known."""
    found: dict[str, float | None] = {}
    for each in verdict.mechanisms:
        values = [None if answer.index is None else answer.index for answer in each.answers]
        known = [index for index in values if index is not None]
        least = bool(known) and known[0].name != "D/C"
        numbers = [index.value for index in known]
        found[each.mechanism] = None if len(known) < len(values) or not known else (min if least else max)(numbers)
    return found
