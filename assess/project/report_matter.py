"""The front matter of the report, its pictures and its list of mechanisms, as the project file gives them."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from assess.project.pictures import read_picture
from assess.project.sections.checklist import checklist
from assess.project.sections.content import Content
from assess.results import ReportMatter, Revision


def report_matter_of(content: Content, folder: Path) -> ReportMatter:
    """Return what the report states besides the analysis; pictures are read.

    Parameters
    ----------
    content : Content
        The project file.
    folder : Path
        Its folder.

    Returns
    -------
    ReportMatter

    Raises
    ------
    ProjectError
        If a picture cannot be read.
    """
    said = content.report
    logo = None if said.logo is None else read_picture(said.logo, key="report.logo", folder=folder)
    return ReportMatter(
        client=said.client or content.client,
        address=said.address,
        coordinates=said.coordinates,
        author=said.author,
        office=said.office,
        licence_number=said.licence_number,
        checker=said.checker or content.checker,
        date=said.date or content.date,
        status=said.status,
        engineer=content.engineer,
        reference=said.reference or content.reference,
        revisions=tuple(Revision(each.number, each.date, each.description, each.author) for each in said.revisions),
        seismic_zone=said.seismic_zone,
        national_annex=said.national_annex,
        building_type=said.building_type or "",
        logo=logo,
        figures=tuple(
            read_picture(each.file, key=f"report.figures[{place}].file", folder=folder, caption=each.caption)
            for place, each in enumerate(said.figures, start=1)
        ),
        checklist=checklist(said, content.mechanisms),
    )


def picture_files(content: Content) -> Iterator[Path]:
    """Yield the files of the pictures that the report shows."""
    if content.report.logo is not None:
        yield content.report.logo
    yield from (each.file for each in content.report.figures)
