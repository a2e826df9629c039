"""The table [report]: how the report looks, its front matter, and the list of the building's mechanisms."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import AfterValidator, Field, model_validator
from pydantic_core import PydanticCustomError

from assess.codes.checklists import BuildingType
from assess.project.quantities import InputFile
from assess.project.report_texts import (
    Coordinates,
    DateText,
    ItemKeys,
    Line,
    NumberText,
    Paragraph,
)
from assess.project.section import Section, quote_names, wrong

SOURCES = ("measured", "literature", "assumed")
MOST_FIGURES = 12
MOST_REVISIONS = 40


def _begins_with_its_kind(text: str) -> str:
    if text.partition(":")[0].strip() not in SOURCES:
        raise PydanticCustomError(
            "project", "{reason}", {"reason": f"begin with {quote_names(SOURCES)}, then a colon and the source"}
        )
    return text


Source = Annotated[str, AfterValidator(_begins_with_its_kind)]


class RevisionSection(Section):
    """One issue of the report."""

    number: NumberText
    """of the revision, like 0 or "B\""""
    date: DateText
    """of the revision, like 2024-05-31"""
    description: Paragraph = ""
    """what changed"""
    author: Line = ""
    """who made it"""


class FigureSection(Section):
    """A photograph or drawing of the building."""

    file: InputFile
    """PNG or JPEG, path relative to the project file"""
    caption: Paragraph = ""
    """what it shows"""


class Report(Section):
    """How the report looks, what its front matter says, and which mechanisms the building can have."""

    units: Literal["SI", "US"] = "SI"
    """units of the report, tables and figures; results.json is in SI, calculation sheets are in both"""
    paper: Literal["A4", "letter"] = "A4"
    """paper size"""
    language: Literal["en", "it"] = "en"
    """language of the report: English or Italian"""
    detail: Literal["main", "full"] = "main"
    """"main", or "full": with the annexes"""
    client: Line = ""
    """for whom"""
    address: Paragraph = ""
    """of the building; may have several lines"""
    coordinates: Coordinates = ""
    """of the building: [latitude, longitude] in degrees, like [42.351, 13.401], or a text"""
    author: Line = ""
    """who wrote the report"""
    office: Line = ""
    """office or company of the author"""
    licence_number: NumberText = ""
    """of the author in the register of the profession"""
    checker: Line = ""
    """who checked it"""
    date: DateText = ""
    """date of the report"""
    status: Line = ""
    """status of the report, like "for approval\""""
    reference: Line = ""
    """the office's number of the job"""
    revisions: Annotated[tuple[RevisionSection, ...], Field(max_length=MOST_REVISIONS)] = ()
    """[ { number, date, description, author }, … ], the oldest first"""
    logo: InputFile | None = None
    """PNG or JPEG of the office, path relative to the project file"""
    figures: Annotated[tuple[FigureSection, ...], Field(max_length=MOST_FIGURES)] = ()
    """[ { file, caption }, … ]: photographs and drawings, PNG or JPEG"""
    seismic_zone: NumberText = ""
    """of the municipality, like 2 or "3S\""""
    national_annex: Line = ""
    """to the Eurocodes as used, like "UNI EN 1998-1, Italian annex 2013\""""
    building_type: BuildingType | None = None
    """"house" or "church": which list of possible mechanisms the report goes through"""
    absent: ItemKeys = ()
    """keys of that list which the building cannot have, like ["corner", "chimney"]"""
    not_examined: dict[Line, Paragraph] = Field(default_factory=dict)
    """keys of that list which are possible and were not examined, each with the reason"""
    verification: InputFile | None = None
    """the verification.json that the report names, written by `assess verify --for PROJECT`; if absent that of the
    folder NAME-verification beside this file, where there is one"""
    sources: dict[str, Source] = Field(default_factory=dict)
    """where values come from: a key of this file, or the beginning of one, with "measured: …", "literature: …" or
    "assumed: …\""""

    @model_validator(mode="after")
    def _revisions_differ(self) -> Report:
        numbers = [each.number for each in self.revisions]
        for place, number in enumerate(numbers):
            if number in numbers[:place]:
                raise wrong(("revisions", place, "number"), "a revision of this number is there already; count on")
        return self
