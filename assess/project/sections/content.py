"""All that a project file says."""

from __future__ import annotations

from collections.abc import Mapping
from datetime import date
from typing import Annotated, Any

from pydantic import BeforeValidator, Field, StrictInt, StrictStr, model_validator

from assess.codes.families import procedures_of_site
from assess.project.key_text import value_text
from assess.project.quantities import Name
from assess.project.section import Section, quote_names, wrong
from assess.project.sections.analysis import Analysis, Procedures, Records
from assess.project.sections.bodies import BodySection, DirectBody, Material
from assess.project.sections.checklist import checklist
from assess.project.sections.loads import BodyLoad, OverburdenLoad
from assess.project.sections.mechanisms import Chained, MechanismSection
from assess.project.sections.report import Report
from assess.project.sections.site import Building, Site
from assess.project.sections.verdict import VerdictSection

ALIKE = ("client", "checker", "date", "reference")
"""Keys that may stand at the top of the file or in [report]."""


def _text_or_date(value: Any) -> Any:
    return value.isoformat() if isinstance(value, date) else value


class Content(Section):
    """All a project file says."""

    format: StrictInt = 1
    """version of this format"""
    title: StrictStr = ""
    """title of the report"""
    engineer: StrictStr = ""
    """who made the assessment"""
    checker: StrictStr = ""
    """who checked it"""
    reference: StrictStr = ""
    """the office's number of the job"""
    client: StrictStr = ""
    """for whom"""
    date: Annotated[StrictStr, BeforeValidator(_text_or_date)] = ""
    """date of the report"""
    notes: StrictStr = ""
    """remarks for the report"""
    masonry_quality: StrictStr = ""
    """the engineer's judgement of the masonry, for the report"""
    site: Site | None = None
    """a table [site] with the spectrum"""
    verdict: VerdictSection = Field(default_factory=VerdictSection)
    """a table [verdict]: what decides"""
    building: Building | None = None
    """a table [building], for mechanisms above ground"""
    materials: dict[Name, Material] = Field(default_factory=dict)
    """a table [materials.NAME] for each material"""
    bodies: dict[Name, BodySection] = Field(default_factory=dict)
    """a table [bodies.NAME] for each body"""
    mechanisms: Annotated[dict[Name, MechanismSection], Field(min_length=1)]
    """add a table [mechanisms.NAME] for each way to collapse"""
    records: Records = Field(default_factory=Records)
    """a table [records]"""
    analysis: Analysis = Field(default_factory=Analysis)
    """a table [analysis]"""
    procedures: Procedures = Field(default_factory=Procedures)
    """tables [procedures.CODE] with options"""
    report: Report = Field(default_factory=Report)
    """a table [report]"""

    @property
    def site_procedures(self) -> tuple[str, ...]:
        """The procedures that the code of the site's spectrum adds if the project names none."""
        if self.site is None or self.analysis.has_key("procedures"):
            return ()
        return procedures_of_site(self.site.spectrum.code)

    @model_validator(mode="after")
    def _names_exist(self) -> Content:
        for name, body in self.bodies.items():
            if not isinstance(body, DirectBody) and body.material not in self.materials:
                raise wrong(("bodies", name, "material"), f"no such material; {_known('materials', self.materials)}")
        for name, mechanism in self.mechanisms.items():
            used = [body for block in mechanism.blocks for body in block] if isinstance(mechanism, Chained) else []
            if not set(used) <= set(self.bodies):
                raise wrong(("mechanisms", name, "blocks"), f"no such body; {_known('bodies', self.bodies)}")
            twice = sorted({body for body in used if used.count(body) > 1})
            if twice:
                raise wrong(
                    ("mechanisms", name, "blocks"), f"{quote_names(tuple(twice))} named twice; a body moves once"
                )
            if isinstance(mechanism, Chained):
                self._bodies_are_loads(name, mechanism, set(used))
        return self

    @model_validator(mode="after")
    def _front_matter_agrees(self) -> Content:
        for key in ALIKE:
            above, below = getattr(self, key), getattr(self.report, key)
            if above and below and above != below:
                raise wrong(("report", key), f"beside {key} = {value_text(above)} at the top of the file; give one")
        return self

    @model_validator(mode="after")
    def _checklist_agrees(self) -> Content:
        checklist(self.report, self.mechanisms)
        return self

    def _bodies_are_loads(self, name: str, mechanism: Chained, moving: set[str]) -> None:
        """Refuse a body as load that does not exist, is part of the mechanism, or loads the same block already."""
        taken: dict[str, set[int | None]] = {}
        for place, load in enumerate(mechanism.loads):
            if isinstance(load, OverburdenLoad) and not set(load.bodies) <= set(self.bodies) - moving:
                known = _known("bodies", self.bodies)
                raise wrong(("mechanisms", name, "loads", place, "bodies"), f"no body beside the wall; {known}")
            if not isinstance(load, BodyLoad):
                continue
            key = ("mechanisms", name, "loads", place, "body")
            if load.body not in self.bodies:
                raise wrong(key, f"no such body; {_known('bodies', self.bodies)}")
            blocks = taken.setdefault(load.body, set())
            if load.body in moving or load.block in blocks:
                raise wrong(key, "it is part of a block, or a load of this block already; name another body")
            if blocks and (load.block is None or None in blocks):
                raise wrong(key, "it is listed twice; give each of the entries its block, or keep one without")
            blocks.add(load.block)


def _known(table: str, names: Mapping[str, Any]) -> str:
    return f"known: {quote_names(names)}" if names else f"add a table [{table}.NAME]"
