"""What stands on the title block and in the head of each page: who, for whom, where, when, which issue."""

from __future__ import annotations

from collections.abc import Iterator
from math import radians

from assess.results import Picture, Results
from reports.document import NOTHING, Photograph
from reports.language.texts import Date, Text, Verbatim, listing, quantity, say
from reports.project_values import project_text

Fact = tuple[Text, Text]


def title(results: Results) -> Text:
    """Return the title of the project, or what the report is."""
    given = project_text(results, "title")
    return Verbatim(given) if given else say("Seismic assessment of masonry")


def author(results: Results) -> str:
    """Return who wrote the report, as the properties of its file name them."""
    return results.report.author or engineer(results)


def engineer(results: Results) -> str:
    """Return the engineer of the project; empty where none is named."""
    return results.report.engineer or project_text(results, "engineer")


def checker(results: Results) -> str:
    """Return who checked the report; empty where nobody is named."""
    return results.report.checker or project_text(results, "checker")


def client(results: Results) -> str:
    """Return for whom the report is; empty where nobody is named."""
    return results.report.client or project_text(results, "client")


def reference(results: Results) -> str:
    """Return the reference of the report; empty where none is given."""
    return results.report.reference or project_text(results, "reference")


def date(results: Results) -> str:
    """Return the date of the report, as the project writes it; empty where none is given."""
    return results.report.date or project_text(results, "date")


def facts(results: Results) -> tuple[Fact, ...]:
    """Return labels and what they say, of what is given."""
    matter = results.report
    labelled = (
        (say("Client"), client(results)),
        (say("Address"), ", ".join(line.strip(" ,") for line in matter.address.splitlines() if line.strip(" ,"))),
        *_coordinates(results),
        *_people(results),
        (say("Reference"), reference(results)),
        (say("Date"), Date(given) if (given := date(results)) else ""),
        (say("Status"), matter.status),
        *_latest_revision(results),
        (say("Seismic zone"), matter.seismic_zone),
        *_life(results),
        (say("Program"), f"{results.program.name} {results.program.version}"),
        (say("Stamp of these results"), results.stamp),
    )
    pairs = ((label, Verbatim(text) if isinstance(text, str) else text) for label, text in labelled)
    return tuple((label, text) for label, text in pairs if text != NOTHING)


def use_class_of(results: Results) -> str:
    """Return the class of use, given with the site or with the building; empty where it is not."""
    return project_text(results, "site.spectrum.use_class") or project_text(results, "building.use_class")


def running_head(results: Results) -> tuple[Text, ...]:
    """Return what each page says besides the title: reference, revision and status."""
    matter = results.report
    shown: list[Text] = [Verbatim(text) for text in (reference(results),) if text]
    if matter.revisions:
        shown.append(say("revision {number}", number=Verbatim(matter.revisions[-1].number)))
    return (*shown, *(Verbatim(text) for text in (matter.status,) if text))


def logo(results: Results) -> Photograph | None:
    """Return the logo of the office, None where there is none."""
    given = results.report.logo
    return None if given is None else photograph(given, "logo")


def photograph(picture: Picture, name: str) -> Photograph:
    """Return a picture of the results as a block of the document. name: unique, safe as a file name."""
    size = (picture.width_px, picture.height_px)
    return Photograph(name, Verbatim(picture.caption), picture.media_type, *size, picture.data)


def _coordinates(results: Results) -> Iterator[tuple[Text, Text | str]]:
    given = results.report.coordinates
    if isinstance(given, str):
        yield say("Coordinates"), given
        return
    latitude, longitude = (quantity(radians(angle), "angle", 8) for angle in given)
    words = say("latitude {latitude}, longitude {longitude}", latitude=latitude, longitude=longitude)
    yield say("Coordinates"), words


def _people(results: Results) -> Iterator[tuple[Text, Text | str]]:
    """Yield author with office and licence number, the engineer where that is another, and the checker."""
    writer, leader = author(results), engineer(results)
    yield say("Author"), _credentials(results, writer) or ""
    yield say("Engineer"), "" if leader == writer else leader
    yield say("Checked by"), checker(results)


def _credentials(results: Results, name: str) -> Text | None:
    """Return a name with office and licence number, as far as they are given; None where nothing is."""
    matter = results.report
    texts: list[Text] = [Verbatim(given) for given in (name, matter.office) if given]
    if matter.licence_number:
        texts.append(say("licence number {number}", number=Verbatim(matter.licence_number)))
    return listing(texts, "") if texts else None


def _latest_revision(results: Results) -> Iterator[tuple[Text, Text | str]]:
    if not results.report.revisions:
        return
    latest = results.report.revisions[-1]
    parts: list[Verbatim | Date] = [Verbatim(latest.number), Date(latest.date), Verbatim(latest.description)]
    yield say("Latest revision"), listing([part for part in parts if part.text], "")


def _life(results: Results) -> Iterator[tuple[Text, Text | str]]:
    """Yield class of use, nominal life and reference life (NTC 2018 2.4) where the results hold them."""
    use_class, factor = use_class_of(results), _parameter(results, "use_coefficient")
    if use_class and factor is not None:
        yield say("Class of use"), say("{name}, C_U = {factor}", name=Verbatim(use_class), factor=quantity(factor))
    elif factor is not None:
        yield say("Class of use"), say("not given; provisional: C_U = {factor}", factor=quantity(factor))
    else:
        yield say("Class of use"), use_class
    for label, key in ((say("Nominal life V_N"), "nominal_life"), (say("Reference life V_R"), "reference_life")):
        years = _parameter(results, key)
        if years is not None:
            yield label, quantity(years, "return period")


def _parameter(results: Results, key: str) -> float | None:
    """Return a number among the parameters of the site's spectrum."""
    found = None if results.spectrum is None else results.spectrum.parameters.get(key)
    return found if isinstance(found, float) else None
