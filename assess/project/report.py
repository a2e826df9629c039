"""What a report states besides the analysis: front matter, pictures, and the annex of verification.

Logo and photographs are never trusted. They are encoded anew from their pixels: only the decoders of PNG and JPEG are
used, on files of limited size, and no pixel is decoded before their number is known. The result is upright, small
enough for a page and without metadata; the same file gives the same bytes.

The annex is held against what the project uses of the program, in the words of `USES` (`assess.results.verification`).
"""

from __future__ import annotations

import base64
import io
import warnings
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from assess.codes.procedures import uses_histories
from assess.errors import ProjectError, ResultsError
from assess.mechanisms.mechanism import Mechanism
from assess.mechanisms.restitution import ABOUT_BASE, HOUSNER, MOMENTUM
from assess.messages.message import Message, list_values, warning, whole_number
from assess.outputs.manifest import VERIFICATION
from assess.project import sections
from assess.project.key_errors import value_text
from assess.project.project_file import Project, resolve
from assess.project.section import ProjectSection
from assess.project.sections.bodies_and_loads import ProfileBody
from assess.project.sections.content import Content, checklist
from assess.results import Input, MediaType, Picture, ReportMatter, Revision
from assess.results.json import read_verification
from assess.results.provenance import describe_program, file_sha256
from assess.results.verification import USES, AnnexResult, VerificationResults, exercised_by_case, keys_for
from assess.study.study import Study
from records.reading import relative_path

if TYPE_CHECKING:
    from PIL.Image import Image


def report_matter_of(content: Content, folder: Path) -> ReportMatter:
    """Return what the report states besides the analysis; pictures are read.

    Parameters
    ----------
    content : the project file
    folder : its folder

    Returns
    -------
    ReportMatter

    Raises
    ------
    ProjectError : if a picture cannot be read
    """
    front = content.report
    logo = None if front.logo is None else read_picture(front.logo, key="report.logo", folder=folder)
    return ReportMatter(
        client=front.client or content.client,
        address=front.address,
        coordinates=front.coordinates,
        author=front.author,
        office=front.office,
        licence_number=front.licence_number,
        checker=front.checker or content.checker,
        date=front.date or content.date,
        status=front.status,
        engineer=content.engineer,
        reference=front.reference or content.reference,
        revisions=tuple(Revision(each.number, each.date, each.description, each.author) for each in front.revisions),
        seismic_zone=front.seismic_zone,
        national_annex=front.national_annex,
        building_type=front.building_type or "",
        logo=logo,
        figures=tuple(
            read_picture(each.file, key=f"report.figures[{place}].file", folder=folder, caption=each.caption)
            for place, each in enumerate(front.figures, start=1)
        ),
        checklist=checklist(front, content.mechanisms),
        struck_out=tuple(front.struck_out.items()),
    )


def picture_files(content: Content) -> Iterator[Path]:
    """Yield the files of the pictures that the report shows."""
    if content.report.logo is not None:
        yield content.report.logo
    yield from (each.file for each in content.report.figures)


PictureFormat = Literal["PNG", "JPEG"]
LARGEST_FILE = 25_000_000  # bytes
MOST_PIXELS = 60_000_000
TOO_MANY = f"too many pixels; give at most {MOST_PIXELS // 1_000_000} million"
LONGEST_SIDE = 1600  # px, of the picture as the report has it
QUALITY = 85  # of JPEG
FIRST_BYTES: dict[PictureFormat, bytes] = {"PNG": b"\x89PNG\r\n\x1a\n", "JPEG": b"\xff\xd8\xff"}
MEDIA_TYPES: dict[PictureFormat, MediaType] = {"PNG": "image/png", "JPEG": "image/jpeg"}


def read_picture(path: Path, *, key: str, folder: Path, caption: str = "") -> Picture:
    """Read a picture and encode it anew.

    Parameters
    ----------
    path : PNG or JPEG file
    key : key of the project file that names it, for errors
    folder : folder of the project file
    caption : what it shows

    Returns
    -------
    At most 1600 px in width and height.

    Raises
    ------
    ProjectError : if the file is too large, damaged, or no PNG or JPEG
    """
    name = relative_path(path, folder)
    where = f"{key}: {value_text(name)}"
    image, kind = _decode(_bytes(path, where), where)
    data = base64.b64encode(_encode(image, kind)).decode("ascii")
    return Picture(name, caption, MEDIA_TYPES[kind], *image.size, data)


ANNEX_KEY = "report.verification"

KEYS_OF_LOOK = ("report.language", "report.paper", "report.units")
"""Keys that say how the annex of a project looks."""


def with_project(results: VerificationResults, project: Project) -> VerificationResults:
    """Return results with the front matter of the project whose cases these are.

    Parameters
    ----------
    results : of the cases
    project : as read
    """
    values = {key: each for key, each in resolve(project).items() if key in ("title", *KEYS_OF_LOOK)}
    return replace(
        results,
        inputs=(Input(project.path.name, project.sha256),),
        project=values,
        report=report_matter_of(project.content, project.folder),
    )


def annex_file(project: Project) -> Path | None:
    """Return the verification.json that a project names, or that stands in its default place; None if there is none."""
    named = project.content.report.verification
    if named is not None:
        return named
    place = project.folder / f"{project.path.stem}-verification" / VERIFICATION
    return place if place.is_file() else None


def annex_files(project: Project, annex: AnnexResult | None) -> tuple[Path, ...]:
    """Return the files of the annex that the report names: its results, and the PDF beside them; none without one."""
    file = None if annex is None else annex_file(project)
    return () if file is None else tuple(each for each in (file, file.with_suffix(".pdf")) if each.is_file())


def annex_of(project: Project, uses: Sequence[str]) -> tuple[AnnexResult | None, tuple[Message, ...]]:
    """Return what a run says of its annex, None if there is none, and the messages on it.

    An annex in the default place that cannot be read gets a message, and the run goes on as without one.

    Parameters
    ----------
    project : as read
    uses : what it uses, in the words of `assess.results.verification`

    Raises
    ------
    ProjectError : the project names a file that cannot be read as verification.json, was changed since it was written,
        or has no cases
    """
    file = annex_file(project)
    if file is None:
        return None, ()
    try:
        annex = _read_annex(file, project, uses)
    except ResultsError as error:
        if project.content.report.verification is not None:
            raise ProjectError(f"{ANNEX_KEY}: {error}") from None
        path, why = relative_path(file, project.folder), str(error).removeprefix(f"{file}: ")
        return None, (warning("annex-left-aside", ANNEX_KEY, file=path, why=why),)
    return annex, tuple(_annex_messages(annex))


USE_OF_BODY: Mapping[type[ProjectSection], str] = {
    sections.MeshBody: "mesh",
    sections.BoxBody: "box",
    ProfileBody: "profile",
}

USE_OF_RESTITUTION: Mapping[str, str] = {
    str(HOUSNER[0]): "restitution housner",
    str(MOMENTUM[0]): "restitution momentum",
    str(ABOUT_BASE[0]): "restitution sorrentino",
}
SPECTRUM_OF_CODE: Mapping[str, str] = {"ibc2009": "asce7-05"}  # codes whose spectrum is that of another


def uses_of(content: sections.Content, study: Study) -> tuple[str, ...]:
    """Return what a project uses, each word once, in the order of the table.

    Parameters
    ----------
    content : of the project file
    study : built from it
    """
    found = {
        *_uses_of_bodies(content),
        *(word for section in content.mechanisms.values() for word in _uses_of_section(section)),
        *(word for mechanism in study.mechanisms for word in _uses_of_mechanism(mechanism)),
        *_uses_of_site(content, study),
        *_uses_of_motion(content, study),
        *study.procedures,
        *study.offered,
        *_uses_of_analysis(content),
    }
    if unknown := found - set(USES):
        raise KeyError(f"no word of assess.results.verification: {', '.join(sorted(unknown))}")
    return tuple(word for word in USES if word in found)


def _bytes(path: Path, where: str) -> bytes:
    try:
        size = path.stat().st_size
        if size > LARGEST_FILE:
            raise ProjectError(f"{where}: {size / 1e6:.1f} MB; give at most {LARGEST_FILE / 1e6:.0f} MB")
        return path.read_bytes()
    except OSError as error:
        raise ProjectError(f"{where}: cannot be read ({error.strerror}); check its permissions") from None


def _decode(data: bytes, where: str) -> tuple[Image, PictureFormat]:
    """Return the picture, upright, in plain colours and of its final size, and the format of its file."""
    from PIL import Image, ImageOps

    kind = next((each for each, start in FIRST_BYTES.items() if data.startswith(start)), None)
    if kind is None:
        raise ProjectError(f"{where}: not a PNG or JPEG picture; save it as one of them")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of many pixels, which are counted here, and of metadata, which is dropped
            opened = Image.open(io.BytesIO(data), formats=[kind])
            _check_pixels(opened.size, where)
            opened.draft("RGB", (2 * LONGEST_SIDE, 2 * LONGEST_SIDE))  # a JPEG is decoded at a half, quarter or eighth
            ImageOps.exif_transpose(opened, in_place=True)  # no copy of all pixels
            image = _plain_colours(opened)
    except ProjectError:
        raise
    except Image.DecompressionBombError:
        raise ProjectError(f"{where}: {TOO_MANY}") from None
    except Exception:  # on damaged files decoders raise OSError, SyntaxError, struct.error, ZeroDivisionError, …
        raise ProjectError(f"{where}: a damaged {kind} picture; save it again") from None
    image.thumbnail((LONGEST_SIDE, LONGEST_SIDE), Image.Resampling.LANCZOS)
    return image, kind


def _check_pixels(size: tuple[int, int], where: str) -> None:
    width, height = size
    if width * height > MOST_PIXELS:
        raise ProjectError(f"{where}: {width} x {height} px: {TOO_MANY}")


def _plain_colours(image: Image) -> Image:
    """Return 8-bit red, green and blue, with opacity if the picture has any."""
    if image.mode.startswith("I"):  # 16 bits of grey, which `convert` alone would clip
        image = image.convert("I").point(lambda value: value * (1.0 / 257.0)).convert("L")
    has_opacity = "A" in image.getbands() or "transparency" in image.info
    mode = "RGBA" if has_opacity else "RGB"
    return image if image.mode == mode and "transparency" not in image.info else image.convert(mode)


def _encode(image: Image, kind: PictureFormat) -> bytes:
    """Return the bytes of a file with the pixels alone."""
    from PIL.Image import frombytes

    pixels = frombytes(image.mode, image.size, image.tobytes())  # without what the file said besides
    file = io.BytesIO()
    if kind == "PNG":
        pixels.save(file, "PNG", optimize=True)
    else:
        pixels.save(file, "JPEG", quality=QUALITY, optimize=True)
    return file.getvalue()


def _annex_messages(annex: AnnexResult) -> Iterator[Message]:
    """Yield what limits the annex that a run names."""
    where = ANNEX_KEY
    if annex.program.sha256 != describe_program().sha256:
        yield warning("annex-other-sources", where, file=annex.path)
    if annex.failures:
        failures, cases = whole_number(annex.failures), whole_number(annex.cases)
        yield warning("annex-failures", where, file=annex.path, failures=failures, cases=cases)
    if annex.quick:
        yield warning("annex-quick", where, file=annex.path)
    if annex.left_out and not annex.quick:
        yield warning("annex-left-out", where, file=annex.path, number=whole_number(annex.left_out))
    if annex.foreign:
        yield warning("annex-foreign", where, file=annex.path, number=whole_number(annex.foreign))
    if not annex.pdf_as_written:
        yield warning("annex-pdf", where, file=annex.path)
    if annex.uncovered:
        yield warning(
            "annex-uncovered", where, file=annex.path, uses=list_values(*map(USES.__getitem__, annex.uncovered))
        )


def _read_annex(file: Path, project: Project, uses: Sequence[str]) -> AnnexResult:
    """Read an annex; what it leaves out is counted for this project, whatever it was made for."""
    found = read_verification(file)
    if not found.cases:
        raise ResultsError(f"{file}: has no cases; run `assess verify` again")
    run = {each.key for each in found.cases}
    pdf = file.with_suffix(".pdf")
    pdf_sha256 = file_sha256(pdf) if pdf.is_file() else ""
    return AnnexResult(
        path=relative_path(file, project.folder),
        sha256=file_sha256(file),
        pdf_sha256=pdf_sha256,
        program=found.program,
        cases=len(found.cases),
        failures=len(found.failures),
        quick=found.quick,
        uncovered=tuple(use for use in uses if use not in found.passed_uses),
        left_out=len(keys_for(exercised_by_case(), uses) - run),
        foreign=len(found.foreign),
        pdf_as_written=bool(pdf_sha256) and pdf_sha256 == found.pdf_sha256,
        solved=tuple(each.line for each in found.cases),
    )


def _uses_of_bodies(content: sections.Content) -> Iterator[str]:
    chained = (each for each in content.mechanisms.values() if isinstance(each, sections.ChainSection))
    names = {name for each in chained for block in each.blocks for name in block}
    yield from (
        USE_OF_BODY[type(body)] for name, body in content.bodies.items() if name in names and type(body) in USE_OF_BODY
    )


def _uses_of_section(section: sections.MechanismSection) -> Iterator[str]:
    yield section.kind
    if not isinstance(section, sections.ChainSection):
        return
    yield from (str(getattr(load, "kind", "")) for load in section.loads)
    for joint in (section.interface, *section.interfaces.values()):
        if joint.model != "rigid" or joint.strength is not None:
            yield from ("outline",) if isinstance(joint.shape, str) else _sizes_given(joint.shape)
    if section.cut is not None:
        yield "cut"
    if section.kind == "two-block" and isinstance(section.crack, str):
        yield f"crack {section.crack}"
    if section.kind == "four-hinge" and section.hinges == "minimum":
        yield "arch"


def _sizes_given(shape: ProjectSection) -> Iterator[str]:
    yield from (name for name, size in shape.entries().items() if size is not None)


def _uses_of_mechanism(mechanism: Mechanism) -> Iterator[str]:
    """Yield sides, joints and the rule of restitution, as they came out with all defaults."""
    rules = set(map(str, mechanism.restitution_source_parts))
    if mechanism.sides == "one":
        yield "one-sided"
        if any(getattr(each, "key", "") == "restitution-3-45" for each in mechanism.restitution_source_parts):
            yield "restitution one-sided"
    yield from (word for rule, word in USE_OF_RESTITUTION.items() if rule in rules)
    joints = [joint for chain in (mechanism.positive, mechanism.negative) if chain for joint in chain.joints]
    if not joints or None in joints:
        yield "rigid"
    for joint in joints:
        if joint is not None:
            yield "crushing" if joint.model == "rigid" else joint.model
            if joint.law.strength < float("inf"):
                yield "crushing"


def _uses_of_site(content: sections.Content, study: Study) -> Iterator[str]:
    if content.site is None:
        return
    code = content.site.spectrum.code
    yield SPECTRUM_OF_CODE.get(code, code)
    if study.hazard is not None:
        yield "hazard over return periods"


def _uses_of_motion(content: sections.Content, study: Study) -> Iterator[str]:
    """Yield what histories and envelopes use; nothing where there are none."""
    histories = any(map(uses_histories, (*study.procedures, *study.offered)))
    if study.pulses is not None:
        yield "pulses"
    if not histories and study.pulses is None:
        return
    yield from study.equations.values()
    yield from (f"amplification {each.method}" for each in study.amplified.values() if each.method != "none")
    if not histories:
        return
    if study.records:
        yield "records"
    if study.artificial is not None:
        yield "synthetic"
    if study.scale_to == "spectrum":
        yield "scaling"
    if content.records.selection is not None:
        yield "selection"


def _uses_of_analysis(content: sections.Content) -> Iterator[str]:
    analysis = content.analysis
    for word in ("sensitivity", "uncertainty", "fragility", "risk"):
        if getattr(analysis, word) not in (None, False):
            yield word
