"""The front matter of a report, its pictures, and the list of mechanisms that a building of its type can have."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from assess.codes.checklists import BuildingType
from assess.results.values import Point
from assess.short_repr import ShortRepr

MediaType = Literal["image/png", "image/jpeg"]
ChecklistOutcome = Literal["examined", "absent", "not-examined"]


@dataclass(frozen=True, repr=False)
class Picture(ShortRepr):
    """A logo or photograph as the report shows it; name: of its file; data: its bytes in base64.

    The bytes are re-encoded by this program from the file's pixels: upright, and without the file's metadata.
    """

    name: str
    caption: str
    media_type: MediaType
    width_px: int
    height_px: int
    data: str


@dataclass(frozen=True, repr=False)
class Revision(ShortRepr):
    """An issue of the report; date: as the user wrote it."""

    number: str
    date: str
    description: str
    author: str


@dataclass(frozen=True, repr=False)
class ChecklistItem(ShortRepr):
    """A mechanism that buildings of this type can have, and what became of it here.

    number: in the Italian form for churches, None for houses; mechanisms: names of those that examine it; reason: why
    it is not examined, in the user's words; spoken_for: False if the project file does not mention it, which counts as
    possible and not examined.
    """

    key: str
    number: int | None
    outcome: ChecklistOutcome
    mechanisms: tuple[str, ...] = ()
    reason: str = ""
    spoken_for: bool = True


@dataclass(frozen=True, repr=False)
class ReportMatter(ShortRepr):
    """Front matter and checklist of a report; texts are the user's, "" where not given.

    coordinates: latitude and longitude [deg], or the user's text; building_type, checklist: "" and empty if the project
    file does not say what the building is.
    """

    client: str = ""
    address: str = ""
    coordinates: Point | str = ""
    author: str = ""
    office: str = ""
    licence_number: str = ""
    checker: str = ""
    date: str = ""
    status: str = ""
    engineer: str = ""
    reference: str = ""
    revisions: tuple[Revision, ...] = ()
    seismic_zone: str = ""
    national_annex: str = ""
    building_type: BuildingType | Literal[""] = ""
    logo: Picture | None = None
    figures: tuple[Picture, ...] = ()
    checklist: tuple[ChecklistItem, ...] = ()

    @property
    def not_examined(self) -> tuple[ChecklistItem, ...]:
        """Items that are possible and were not examined: they make the building's index an upper bound."""
        return tuple(item for item in self.checklist if item.outcome == "not-examined")


NO_MATTER = ReportMatter()
"""Of results whose project file has no [report]."""
