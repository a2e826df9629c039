"""The materials, the values that are assumed, and where all others come from."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from assess.messages.message import Quantity
from assess.results import ResolvedValue, Results
from assess.results.provenance import source_line
from reports import governing
from reports.document import Block, Cell, Column, Prose, Section, Table, nonempty
from reports.language.texts import Phrase, Reference, Text, Verbatim, listing, say, say_count
from reports.language.value_names import PARAMETER_NAMES, key_words, value_title, value_word
from reports.mechanisms import mechanism_list
from reports.project_values import ProjectValue, project_text, project_values, starred_key

SOURCES = "report.sources."
SPECTRUM = "site.spectrum."
FIGURES = 4  # of a value; annex E has all of them
TABLES: Mapping[str, str] = {"site.spectrum.hazard": "hazard", "mechanisms.*.loads": "actions"}
"""Lists of tables of the project file, by their keys, and the tables of the report that show them."""
KINDS: Mapping[str, Phrase] = {
    "measured": say("measured"),
    "literature": say("literature"),
    "assumed": say("assumed"),
}
ASSUMED, DEFAULT, UNSTATED = "assumed", "default", ""
CHOICES = (
    "site.limit_state",
    "verdict.works",
    "records.scale_to",
    "records.synthetic.count",
    "records.synthetic.seed",
    "records.synthetic.duration",
    "analysis.equation",
    "mechanisms.*.sides",
    "mechanisms.*.amplification.method",
    "mechanisms.*.interface.model",
)
"""Values that the engineer chooses, for which there is no source."""
WITHOUT_EFFECT = ("verdict.works", "mechanisms.*.interface.shape")  # defaults that change no number by themselves
PROPERTIES: tuple[tuple[str, Phrase], ...] = (
    ("density", say("Density")),
    ("young_modulus", say("Young’s modulus E")),
    ("compressive_strength", say("Compressive strength f_m")),
    ("tensile_strength", say("Tensile strength f_mt")),
    ("friction", say("Friction μ")),
    ("disintegration", say("Disintegration")),
)


@dataclass(frozen=True)
class ValueSource:
    """Where a value comes from. kind: a key of `KINDS`, "default", or empty where nobody said; words: of the user."""

    kind: str
    words: str = ""


def sections(results: Results) -> list[Section]:
    """Return the chapter: what is assumed first, then the materials and the sources."""
    found = assumptions_table(results)
    blocks: list[Block] = nonempty(found)
    if not found.rows:
        blocks = [Prose((say("No value is marked as assumed, and no default of the program affects the results."),))]
    rest = (
        *blocks,
        *_restitution(results),
        *nonempty(materials_table(results)),
        *_masonry(results),
        *nonempty(sources_table(results)),
        *_values_without_source(results),
    )
    return [Section(say("Assumptions"), 0, rest)]


def assumptions_table(results: Results) -> Table:
    """Tabulate the values that the user assumed, then the defaults of the program on which results depend."""
    columns = (
        Column(say("Assumption"), share=0.34),
        Column(say("Value"), share=0.16),
        Column(say("Source")),
        Column(say("For"), share=0.16),
    )
    own, defaults = list(_assumed_rows(results, ASSUMED)), list(_assumed_rows(results, DEFAULT))
    caption = say("What is assumed: by the engineer, and, in grey, by default of the program.")
    muted = frozenset(range(len(own), len(own) + len(defaults)))
    return Table("assumed", caption, columns, (*own, *defaults), muted, small=True)


def value_source(results: Results, key: str, value: ResolvedValue) -> ValueSource:
    """Return the source of a value, by the rule that the verdict goes by."""
    if not value.given:
        return ValueSource(DEFAULT)
    return _parse_source(source_line(key, _source_lines(results)))


def stated_source(line: str) -> Text:
    """Return a line of [report.sources] as a text: its kind in the language, and the words of the user."""
    source = _parse_source(line)
    kind = KINDS.get(source.kind, Verbatim(source.kind))
    return say("{kind}: {words}", kind=kind, words=Verbatim(source.words)) if source.words else kind


def materials_table(results: Results) -> Table:
    """Tabulate the materials with the properties that some of them has."""
    found: dict[str, dict[str, Cell]] = {}
    for key, value in results.project.items():
        table, _, rest = key.partition(".")
        name, _, last = rest.rpartition(".")
        if table == "materials" and last in dict(PROPERTIES):
            cells = [entry.cell for entry in project_values(key, value)]
            found.setdefault(name, {})[last] = cells[0] if len(cells) == 1 else None
    kept = [(key, title) for key, title in PROPERTIES if any(cells.get(key) is not None for cells in found.values())]
    rows = tuple(
        (Verbatim(name), *(_cell_in_words(cells.get(key)) for key, _ in kept)) for name, cells in found.items()
    )
    columns = (Column(say("Material")), *(Column(title) for _, title in kept))
    return Table("materials", say("Materials."), columns, rows if kept else ())


def sources_table(results: Results) -> Table:
    """Tabulate the sources that the project states, but for assumed values."""
    found: dict[str, tuple[Text, Text, str, list[str]]] = {}
    for title, kind, words, owner in _stated_sources(results):
        row = found.setdefault(repr((title, kind, words)), (title, kind, words, []))
        row[-1].extend([owner] if owner else [])
    rows = tuple(
        (title, kind, Verbatim(words) if words else None, mechanism_list(results, owners) if owners else None)
        for title, kind, words, owners in found.values()
    )
    columns = (
        Column(say("Value"), share=0.32),
        Column(say("Kind of source"), share=0.14),
        Column(say("Source")),
        Column(say("For"), share=0.16),
    )
    return Table("sources", say("Sources of the values that are not assumed."), columns, rows, small=True)


def _restitution(results: Results) -> list[Block]:
    """Return where coefficients of restitution come from that the project does not give."""
    computed = [each.name for each in results.mechanisms if each.restitution_source not in ("", "given")]
    if not computed:
        return []
    words = say(
        "The coefficients of restitution of {mechanisms} are not given by the project; the page of each mechanism "
        "states the one used and its source.",
        mechanisms=mechanism_list(results, computed),
    )
    return [Prose((words,))]


def _assumed_rows(results: Results, kind: str) -> Iterator[tuple[Cell, ...]]:
    """Yield the values with this kind of source; what several mechanisms share has one row."""
    found: dict[tuple[str, str, str], tuple[Cell, list[str]]] = {}
    for key, value in results.project.items():
        source = value_source(results, key, value)
        if source.kind != kind or value.value in (None, [], {}, ""):
            continue
        owner, rest = starred_key(results, key)
        if kind == DEFAULT and not _affects_results(results, rest):
            continue
        for entry in _shown_values(results, rest, value):
            kept = found.setdefault((entry.key, repr(entry.cell), source.words), (entry.cell, []))
            kept[1].extend([owner] if owner else [])
    for (key, _, words), (cell, owners) in found.items():
        where = mechanism_list(results, owners) if owners else None
        yield _value_label(key), _cell_in_words(cell), _source_text(kind, words), where


def _shown_values(results: Results, key: str, value: ResolvedValue) -> Iterator[ProjectValue]:
    """Yield a value as cells with their keys; a list of tables as one, which says where the report shows them."""
    content = value.value
    if not isinstance(content, Sequence) or not any(isinstance(each, Mapping) for each in content):
        yield from project_values(key, value)
    elif key in TABLES and (results.spectrum if key.startswith(SPECTRUM) else any(m.loads for m in results.mechanisms)):
        yield ProjectValue(key, say("see {table}", table=Reference("Table", TABLES[key])))
    else:
        yield ProjectValue(key, say_count("{number} set of values", "{number} sets of values", len(content)))


def _value_label(key: str) -> Text:
    """Return the words for a key of the project file."""
    parameter = PARAMETER_NAMES.get(key.removeprefix(SPECTRUM)) if key.startswith(SPECTRUM) else None
    return value_title(key) or (parameter[0] if parameter else key_words(key))


def _affects_results(results: Results, key: str) -> bool:
    """Return whether answers depend on a default: one with a title, of a code whose method was answered."""
    if key in WITHOUT_EFFECT or value_title(key) is None:
        return False
    table, _, rest = key.partition(".")
    if table != "procedures":
        return True
    code = rest.partition(".")[0]
    answered = (
        check for each in results.mechanisms for check in each.checks if check.verdict not in governing.UNANSWERED
    )
    return any(check.procedure.startswith(code) for check in answered)


def _cell_in_words(cell: Cell) -> Cell:
    if isinstance(cell, Quantity):
        return replace(cell, figures=FIGURES)
    if isinstance(cell, bool):
        return say("yes") if cell else say("no")
    return value_word(cell) if isinstance(cell, Verbatim) else cell


def _source_text(kind: str, words: str) -> Text:
    if kind == DEFAULT:
        return say("default of the program")
    return say("assumed: {words}", words=Verbatim(words)) if words else say("assumed")


def _parse_source(line: str) -> ValueSource:
    kind, _, words = line.partition(":")
    return ValueSource(kind.strip(), words.strip())


def _source_lines(results: Results) -> dict[str, str]:
    """Return the lines of [report.sources] by the keys that they are for."""
    return {
        key.removeprefix(SOURCES): str(each.value) for key, each in results.project.items() if key.startswith(SOURCES)
    }


def _masonry(results: Results) -> list[Block]:
    """Return what the engineer writes of the quality of the masonry, which decides whether it moves as rigid bodies."""
    words = project_text(results, "masonry_quality").strip()
    return [Prose((say("Quality of the masonry: {words}", words=Verbatim(words)),))] if words else []


def _stated_sources(results: Results) -> Iterator[tuple[Text, Text, str, str]]:
    for key, line in _source_lines(results).items():
        kind, _, words = line.partition(":")
        if kind.strip() == ASSUMED:
            continue
        owner, rest = starred_key(results, key)
        yield _value_label(rest), KINDS.get(kind.strip(), Verbatim(kind.strip())), words.strip(), owner


def _values_without_source(results: Results) -> list[Block]:
    """Return what is given without a source, each once with the mechanisms that it is for."""
    found: dict[str, tuple[Text, list[str]]] = {}
    for key, value in results.project.items():
        owner, rest = starred_key(results, key)
        title = value_title(_without_item_name(rest))
        if rest in CHOICES or title is None or not value.given:
            continue
        if value_source(results, key, value).kind == UNSTATED:
            found.setdefault(_without_item_name(rest), (title, []))[1].extend([owner] if owner else [])
    if not found:
        return []
    values = [
        say("{value} ({mechanisms})", value=title, mechanisms=mechanism_list(results, owners)) if owners else title
        for title, owners in found.values()
    ]
    return [Prose((say("The project states no source for: {values}.", values=listing(values)),))]


def _without_item_name(key: str) -> str:
    """Return a key of hinges and loads without the name of each; others as they are."""
    for whole in ("mechanisms.*.hinges", "mechanisms.*.loads"):
        if key.startswith(f"{whole}."):
            return whole
    return key
