"""All that a project file says: its keys at the top, the table [report], and whether its tables agree.

[report] says how the report looks, its front matter, and what became of each mechanism that a building of its type can
have: examined, absent, or possible and not examined.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from difflib import get_close_matches
from typing import Annotated, Any, Literal

from pydantic import (
    AfterValidator,
    BaseModel,
    BeforeValidator,
    Field,
    PrivateAttr,
    StrictInt,
    StrictStr,
    ValidationError,
    ValidationInfo,
    model_validator,
)
from pydantic_core import PydanticCustomError

from assess.codes.checklists import CHECKLISTS, BuildingType, PossibleMechanism, possible_mechanism
from assess.codes.procedures import procedures_of_site
from assess.declaration import FREE, Evidence, Name, Several
from assess.loads.load import body_faults
from assess.project.key_errors import KeyPath, error_at, errors_at, quote_names, value_text
from assess.project.section import ProjectSection
from assess.project.sections.analysis import Analysis
from assess.project.sections.bodies_and_loads import BodySection, DirectBody, MaterialSection
from assess.project.sections.ground_motion import BuildingSection, Records, SiteSection
from assess.project.sections.mechanisms import ChainSection, MechanismSection
from assess.project.sections.procedures import Procedures, VerdictSection
from assess.project.values import (
    CHECKLIST,
    STRUCK_OUT,
    DateText,
    GeographicCoordinates,
    InputFile,
    ItemKeys,
    NumberText,
    Paragraph,
    TextLine,
    text_of_date,
)
from assess.results import ChecklistItem
from assess.results.provenance import source_line

ASSUMED = "assumed"
SOURCE_KINDS = ("measured", "literature", ASSUMED)
NO_SOURCE = "assum"  # beginning of a text, in any case: what it says is an assumption
TO_FILL_IN = ("…", "...")  # in a text: what an example or a message has in place of a source
MOST_FIGURES = 12
MOST_REVISIONS = 40
ALIKE = ("client", "checker", "date", "reference")
"""Keys that may stand at the top of the file or in [report]."""


def _begins_with_its_kind(text: str) -> str:
    if text.partition(":")[0].strip() not in SOURCE_KINDS:
        raise PydanticCustomError(
            "project", "{reason}", {"reason": f"begin with {quote_names(SOURCE_KINDS)}, then a colon and the source"}
        )
    return text


FreeText = Annotated[StrictStr, FREE]
SourceText = Annotated[str, AfterValidator(_begins_with_its_kind)]


class RevisionSection(ProjectSection, title="RevisionSection"):
    """One issue of the report."""

    evidence = FREE

    number: NumberText
    """of the revision, like 0 or "B\""""
    date: DateText
    """of the revision, like 2024-05-31"""
    description: Paragraph = ""
    """what changed"""
    author: TextLine = ""
    """who made it"""


class FigureSection(ProjectSection, title="FigureSection"):
    """A photograph or drawing of the building."""

    evidence = FREE

    file: InputFile
    """PNG or JPEG, path relative to the project file"""
    caption: Paragraph = ""
    """what it shows"""


SOURCE = Evidence("measured", "up", '"assumed: …"', judged="a source vouches for other keys, which then count as typed")


def vouches(text: str) -> bool:
    """Return whether a text names a source: one that says "assumed", or is still to be filled in, is none."""
    assumed = text.strip().lower().startswith(NO_SOURCE) or any(dots in text for dots in TO_FILL_IN)
    return bool(text.strip()) and not assumed


class Report(ProjectSection):
    """How the report looks, what its front matter says, and which mechanisms the building can have."""

    evidence = FREE

    units: Literal["SI", "US"] = "SI"
    """units of the report, tables and figures; results.json is in SI, calculation sheets are in both"""
    paper: Literal["A4", "letter"] = "A4"
    """paper size"""
    language: Literal["en", "it"] = "en"
    """language of the report: English or Italian"""
    detail: Literal["main", "full"] = "main"
    """"main", or "full": with the annexes"""
    client: TextLine = ""
    """for whom"""
    address: Paragraph = ""
    """of the building; may have several lines"""
    coordinates: GeographicCoordinates = ""
    """of the building: [latitude, longitude] in degrees, like [42.351, 13.401], or a text"""
    author: TextLine = ""
    """who wrote the report"""
    office: TextLine = ""
    """office or company of the author"""
    licence_number: NumberText = ""
    """of the author in the register of the profession"""
    checker: TextLine = ""
    """who checked it"""
    date: DateText = ""
    """date of the report"""
    status: TextLine = ""
    """status of the report, like "for approval\""""
    reference: TextLine = ""
    """the office's number of the job"""
    revisions: Annotated[tuple[RevisionSection, ...], Several(most=MOST_REVISIONS)] = ()
    """[ { number, date, description, author }, … ], the oldest first"""
    logo: InputFile | None = None
    """PNG or JPEG of the office, path relative to the project file"""
    figures: Annotated[tuple[FigureSection, ...], Several(most=MOST_FIGURES)] = ()
    """[ { file, caption }, … ]: photographs and drawings, PNG or JPEG"""
    seismic_zone: NumberText = ""
    """of the municipality, like 2 or "3S\""""
    national_annex: TextLine = ""
    """to the Eurocodes as used, like "UNI EN 1998-1, Italian annex 2013\""""
    building_type: Annotated[BuildingType | None, CHECKLIST] = None
    """"house" or "church": which list of possible mechanisms the report goes through"""
    absent: Annotated[ItemKeys, CHECKLIST] = ()
    """keys of that list which the building cannot have, like ["corner", "chimney"]"""
    not_examined: Annotated[dict[TextLine, Paragraph], CHECKLIST] = Field(default_factory=dict)
    """keys of that list which are possible and were not examined, each with the reason"""
    struck_out: Annotated[dict[TextLine, Paragraph], STRUCK_OUT] = Field(default_factory=dict)
    """mechanisms of the file, or found on it, that are not examined, each with the reason why it cannot occur, on which
    a pass then depends"""
    verification: InputFile | None = None
    """the verification.json that the report names, written by `assess verify --for PROJECT`; if absent that of the
    folder NAME-verification beside this file, where there is one"""
    sources: Annotated[dict[str, SourceText], SOURCE] = Field(default_factory=dict)
    """where values come from: a key of this file, or the table that holds it, a load as "mechanisms.NAME.loads[1]";
    with "measured: …", "literature: …" or "assumed: …\""""

    def source_of(self, key: str) -> str:
        """Return the source of a key or of the innermost table that holds it; empty where none vouches for it.

        A text that says that the value is assumed is none, nor is one that is still to be filled in.

        key : with dots, items of lists counted from 0
        """
        found = source_line(key, self.sources)
        return found if vouches(found) else ""

    @model_validator(mode="after")
    def _revisions_differ(self) -> Report:
        numbers = [each.number for each in self.revisions]
        for place, number in enumerate(numbers):
            if number in numbers[:place]:
                raise error_at(("revisions", place, "number"), "a revision of this number is there already; count on")
        return self


class _Table(BaseModel):
    """The table of one mechanism."""

    mechanism: MechanismSection


class Content(ProjectSection):
    """All a project file says."""

    format: Annotated[StrictInt, FREE] = 1
    """version of this format"""
    title: FreeText = ""
    """title of the report"""
    engineer: FreeText = ""
    """who made the assessment"""
    checker: FreeText = ""
    """who checked it"""
    reference: FreeText = ""
    """the office's number of the job"""
    client: FreeText = ""
    """for whom"""
    date: Annotated[StrictStr, BeforeValidator(text_of_date), FREE] = ""
    """date of the report"""
    notes: FreeText = ""
    """remarks for the report"""
    masonry_quality: FreeText = ""
    """the engineer's judgement of the masonry, for the report"""
    site: SiteSection | None = None
    """a table [site] with the spectrum"""
    verdict: VerdictSection = Field(default_factory=VerdictSection)
    """a table [verdict]: what decides"""
    building: BuildingSection | None = None
    """a table [building], for mechanisms above ground"""
    materials: dict[Name, MaterialSection] = Field(default_factory=dict)
    """a table [materials.NAME] for each material"""
    bodies: dict[Name, BodySection] = Field(default_factory=dict)
    """a table [bodies.NAME] for each body"""
    mechanisms: Annotated[dict[Name, MechanismSection], Several(1)]
    """add a table [mechanisms.NAME] for each way to collapse"""
    records: Records = Field(default_factory=Records)
    """a table [records]"""
    analysis: Analysis = Field(default_factory=Analysis)
    """a table [analysis]"""
    procedures: Procedures = Field(default_factory=Procedures)
    """tables [procedures.CODE] with options"""
    report: Report = Field(default_factory=Report)
    """a table [report]"""
    columns: Annotated[dict[StrictStr, StrictStr], FREE] = Field(default_factory=dict)
    """of a template of `assess batch`: by heading of the table the key whose values its cells give, "carry",
    or by the key of a load's elevation "top" or a share of the height like "50 %\""""

    _struck_out: dict[str, Any] = PrivateAttr(default_factory=dict)

    @property
    def site_procedures(self) -> tuple[str, ...]:
        """The procedures that the code of the site's spectrum adds if the project names none."""
        if self.site is None or self.analysis.has_key("procedures"):
            return ()
        return procedures_of_site(self.site.spectrum.code)

    @model_validator(mode="after")
    def _names_exist(self) -> Content:
        if faults := tuple(self._unknown_names()):
            raise errors_at(faults)
        return self

    def _unknown_names(self) -> Iterator[tuple[KeyPath, str]]:
        """Yield each key that names what the file has not, or a body twice."""
        for name, body in self.bodies.items():
            if not isinstance(body, DirectBody) and body.material not in self.materials:
                yield ("bodies", name, "material"), f"no such material; {_known_names('materials', self.materials)}"
        for name, mechanism in self.mechanisms.items():
            used = [body for block in mechanism.blocks for body in block] if isinstance(mechanism, ChainSection) else []
            twice = sorted({body for body in used if used.count(body) > 1})
            if not set(used) <= set(self.bodies):
                yield ("mechanisms", name, "blocks"), f"no such body; {_known_names('bodies', self.bodies)}"
            elif twice:
                yield ("mechanisms", name, "blocks"), f"{quote_names(tuple(twice))} named twice; a body moves once"
            if isinstance(mechanism, ChainSection):
                known = _known_names("bodies", self.bodies)
                for place, key, reason in body_faults(mechanism.loads, self.bodies, moving=used, known=known):
                    yield ("mechanisms", name, "loads", place, key), reason

    @model_validator(mode="wrap")
    @classmethod
    def _without_what_is_struck_out(cls, data: Any, read: Any, info: ValidationInfo) -> Any:
        """Read the file without the mechanisms that the report strikes out, whatever their tables say."""
        report, mechanisms = (data.get(key) if isinstance(data, Mapping) else None for key in ("report", "mechanisms"))
        struck = report.get("struck_out") if isinstance(report, Mapping) else None
        if not isinstance(struck, Mapping) or not isinstance(mechanisms, Mapping):
            return read(data)
        if mechanisms and all(name in struck for name in mechanisms):
            raise error_at(("report", "struck_out"), "every mechanism of the file is struck out; keep one")
        content = read({**data, "mechanisms": {name: each for name, each in mechanisms.items() if name not in struck}})
        for name, each in mechanisms.items():
            if name in struck:
                content._struck_out[name] = None
                with suppress(ValidationError):  # what is wrong in such a table stops nothing
                    content._struck_out[name] = _Table.model_validate(
                        {"mechanism": each}, context=info.context
                    ).mechanism
        return content

    @property
    def struck_out(self) -> Mapping[str, MechanismSection | None]:
        """The mechanisms of the file that are struck out, by their names; None where their table cannot be read."""
        return self._struck_out

    def is_struck_out(self, key: str) -> bool:
        """Return whether a key, with dots, is of a mechanism that is struck out."""
        owners = [name for name in (*self.mechanisms, *self._struck_out) if f"{key}.".startswith(f"mechanisms.{name}.")]
        return max(owners, key=len, default="") in self._struck_out

    @model_validator(mode="after")
    def _reasons_for_striking_out(self) -> Content:
        faults: list[tuple[KeyPath, str]] = []
        for name, reason in self.report.struck_out.items():
            if not vouches(reason):
                why = 'no reason; write what was seen there, like "measured: the gable is tied to the roof, drawing 4"'
                faults.append((("report", "struck_out", name), why))
        if faults:
            raise errors_at(faults)
        return self

    @model_validator(mode="after")
    def _front_matter_agrees(self) -> Content:
        faults: list[tuple[KeyPath, str]] = []
        for key in ALIKE:
            above, below = getattr(self, key), getattr(self.report, key)
            if above and below and above != below:
                given = f"beside {key} = {value_text(above)} at the top of the file; give one"
                faults.append((("report", key), given))
        if faults:
            raise errors_at(faults)
        return self

    @model_validator(mode="after")
    def _checklist_agrees(self) -> Content:
        checklist(self.report, self.mechanisms)
        return self


def _known_names(table: str, names: Mapping[str, Any]) -> str:
    return f"known: {quote_names(names)}" if names else f"add a table [{table}.NAME]"


def checklist(report: Report, mechanisms: Mapping[str, MechanismSection]) -> tuple[ChecklistItem, ...]:
    """Return every item of the list of the building's type, with what became of it; empty without a type.

    An item that some mechanisms examine and `not_examined` names too is examined in part: it counts as not examined.

    Parameters
    ----------
    report : the section of the project file
    mechanisms : of the project, by name

    Raises
    ------
    ProjectError : an item is not in the list, is named twice, or is absent and yet examined
    """
    building_type = report.building_type
    if building_type is None:
        _refuse_items(report, mechanisms)
        return ()
    examined = _mechanisms_by_item(building_type, mechanisms)
    absent = _absent_items(report, building_type, examined)
    reasons = _reasons(report, building_type, absent)
    return tuple(_item(each, examined, absent, reasons) for each in CHECKLISTS[building_type])


def _item(
    item: PossibleMechanism, examined: Mapping[str, Sequence[str]], absent: Sequence[str], reasons: Mapping[str, str]
) -> ChecklistItem:
    names = tuple(examined.get(item.key, ()))
    if item.key in reasons:
        return ChecklistItem(item.key, item.number, "not-examined", names, reasons[item.key])
    if names:
        return ChecklistItem(item.key, item.number, "examined", names)
    if item.key in absent:
        return ChecklistItem(item.key, item.number, "absent")
    return ChecklistItem(item.key, item.number, "not-examined", spoken_for=False)


def _refuse_items(report: Report, mechanisms: Mapping[str, MechanismSection]) -> None:
    """Refuse items of a list where the file does not say which list."""
    named: dict[KeyPath, object] = {
        ("report", "absent"): report.absent,
        ("report", "not_examined"): report.not_examined,
    }
    named |= {("mechanisms", name, "examines"): each.examines for name, each in mechanisms.items()}
    for key, items in named.items():
        if items:
            raise error_at(key, 'names items of no list; write building_type = "house" or "church" in [report]')


def _mechanisms_by_item(
    building_type: BuildingType, mechanisms: Mapping[str, MechanismSection]
) -> dict[str, list[str]]:
    """Return the names of the mechanisms that examine each item."""
    found: dict[str, list[str]] = {}
    for name, mechanism in mechanisms.items():
        given = mechanism.examines
        for key in _items_by_kind(building_type, mechanism) if given is None else given:
            where: KeyPath = ("mechanisms", name, "examines")
            item = _listed_item(building_type, key, where)
            if item.in_plane:
                raise error_at(where, f'"{item.key}": no mechanism here is of damage in the plane of walls; remove it')
            if name in found.setdefault(item.key, []):
                raise error_at(where, f'"{item.key}" stands there twice, by number and by key; remove one')
            found[item.key].append(name)
    return found


ITEM_OF_KIND = {
    "two-block": "vertical-bending",
    "facade-with-wedges": "compound-overturning",
    "corner": "corner",
    "horizontal-arch": "horizontal-bending",
}
"""The item of the list of a house that a kind of mechanism is, whatever its bodies."""


def _items_by_kind(building_type: BuildingType, mechanism: MechanismSection) -> tuple[str, ...]:
    """Return the item that the kind of a mechanism tells: of houses, for one wall above a level crack or its base."""
    if building_type != "house":
        return ()
    if mechanism.kind in ITEM_OF_KIND:
        return (ITEM_OF_KIND[mechanism.kind],)
    inclined = mechanism.kind == "single-block" and isinstance(mechanism.cut, ProjectSection)
    if mechanism.kind == "single-block" and len(mechanism.blocks[0]) == 1 and not inclined:
        return ("simple-overturning",)
    return ()


def _absent_items(report: Report, building_type: BuildingType, examined: Mapping[str, Sequence[str]]) -> list[str]:
    where: KeyPath = ("report", "absent")
    keys = [_listed_item(building_type, key, where).key for key in report.absent]
    for place, key in enumerate(keys):
        if key in keys[:place]:
            raise error_at(where, f'"{key}" stands there twice, by number and by key; remove one')
        if key in examined:
            of = f"mechanisms.{examined[key][0]}"
            raise error_at(where, f'"{key}" is what {of} examines; remove it, or give {of} other items in `examines`')
    return keys


def _reasons(report: Report, building_type: BuildingType, absent: Sequence[str]) -> dict[str, str]:
    """Return why items are not examined, by their keys."""
    found: dict[str, str] = {}
    for written, reason in report.not_examined.items():
        where: KeyPath = ("report", "not_examined", written)
        key = _listed_item(building_type, written, where).key
        if not reason.strip():
            raise error_at(where, 'no reason; write why it was not examined, like "no access"')
        if key in found:
            raise error_at(where, f'"{key}" stands there twice, by number and by key; remove one')
        if key in absent:
            raise error_at(where, f'"{key}" stands in `absent` too; remove it there or here')
        found[key] = reason
    return found


def _listed_item(building_type: BuildingType, key: str, where: KeyPath) -> PossibleMechanism:
    found = possible_mechanism(building_type, key)
    if found is None:
        raise error_at(where, f'"{key}" is none of the list for a {building_type}; {_item_remedy(building_type, key)}')
    return found


def _item_remedy(building_type: BuildingType, key: str) -> str:
    near = get_close_matches(key, list(_item_keys(building_type)), n=1)
    if near:
        return f'did you mean "{near[0]}"?'
    numbers = ", or a number from 1 to 28" if building_type == "church" else ""
    return f"known: {', '.join(_item_keys(building_type))}{numbers}"


def _item_keys(building_type: BuildingType) -> Iterator[str]:
    yield from (each.key for each in CHECKLISTS[building_type])
