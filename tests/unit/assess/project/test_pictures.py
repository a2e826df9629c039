"""Pictures of a project: read within limits, encoded anew without metadata, or refused in one line."""

from __future__ import annotations

import base64
import hashlib
import io
import struct
import zlib
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from PIL.PngImagePlugin import PngInfo

from assess.errors import ProjectError
from assess.project import report
from assess.project.project_file import load
from assess.project.report import read_picture, report_matter_of
from assess.results import Picture
from assess.results.json import dumps, loads
from assess.study.run import run_study
from tests.support.projects import study_of

ORIENTATION = 0x0112
SPIRE = '[mechanisms.spire]\nkind = "equivalent-block"\np = 1.6\nuplift = 0.14\nradius = 2.8\n'


def pixels(width: int, height: int) -> Image.Image:
    """A picture that is red on its left and blue on its right."""
    columns = np.arange(width) < width / 2
    colours = np.zeros((height, width, 3), dtype=np.uint8)
    colours[:, columns, 0] = colours[:, ~columns, 2] = 255
    return Image.fromarray(colours)


def written(folder: Path, image: Image.Image, name: str = "a.png", **options) -> Path:
    image.save(folder / name, **options)
    return folder / name


def read(path: Path) -> Picture:
    return read_picture(path, key="report.logo", folder=path.parent)


def decoded(picture: Picture) -> Image.Image:
    image = Image.open(io.BytesIO(base64.b64decode(picture.data)))
    image.load()
    return image


def refused(path: Path) -> str:
    with pytest.raises(ProjectError) as found:
        read(path)
    said = str(found.value)
    assert said.startswith("report.logo: ")
    assert said.isprintable()
    return said


@pytest.mark.parametrize(("name", "media_type"), [("a.png", "image/png"), ("a.jpg", "image/jpeg")])
def test_a_picture_keeps_its_format_and_is_the_same_bytes_each_time(tmp_path, name, media_type):
    path = written(tmp_path, pixels(40, 30), name)
    found = read(path)
    assert (found.name, found.media_type, found.width_px, found.height_px) == (name, media_type, 40, 30)
    assert decoded(found).size == (40, 30)
    assert read(path) == found


def test_pixels_of_a_png_are_kept_exactly(tmp_path):
    found = decoded(read(written(tmp_path, pixels(40, 30))))
    np.testing.assert_array_equal(np.array(found), np.array(pixels(40, 30)))


def test_the_format_is_that_of_the_bytes_not_of_the_name(tmp_path):
    written(tmp_path, pixels(4, 4), "a.jpg", format="PNG")
    assert read(tmp_path / "a.jpg").media_type == "image/png"


def test_a_large_picture_is_made_smaller_in_proportion(tmp_path):
    found = read(written(tmp_path, pixels(4000, 1000)))
    assert (found.width_px, found.height_px) == (1600, 400) == decoded(found).size


def test_a_line_of_pixels_stays_one(tmp_path):
    assert read(written(tmp_path, pixels(5000, 1))).height_px == 1


def test_the_camera_s_orientation_is_applied_and_no_metadata_is_left(tmp_path):
    exif = Image.Exif()
    exif[ORIENTATION] = 6  # to be turned a quarter clockwise: what was left is at the top
    exif[0x010E] = "the owner's secret"
    found = read(written(tmp_path, pixels(40, 20), "a.jpg", exif=exif, quality=95, comment="secret"))
    assert (found.width_px, found.height_px) == (20, 40)
    image = decoded(found)
    assert image.convert("RGB").getpixel((10, 2))[0] > 200
    assert image.convert("RGB").getpixel((10, 38))[2] > 200
    assert not image.getexif()
    assert b"secret" not in base64.b64decode(found.data)


def test_texts_and_profiles_of_a_png_are_dropped(tmp_path):
    info = PngInfo()
    info.add_text("Comment", "<script>alert(1)</script>")
    path = written(tmp_path, pixels(4, 4), pnginfo=info, icc_profile=b"profile " * 9, dpi=(300, 300))
    assert set(decoded(read(path)).info) == set()


@pytest.mark.parametrize(
    ("mode", "kept"), [("1", "RGB"), ("L", "RGB"), ("P", "RGB"), ("LA", "RGBA"), ("RGBA", "RGBA"), ("I;16", "RGB")]
)
def test_every_kind_of_png_becomes_plain_colours(tmp_path, mode, kept):
    grey = np.linspace(0, 65535, 64).reshape(8, 8).astype(np.uint16)
    image = Image.fromarray(grey) if mode == "I;16" else pixels(8, 8).convert(mode)
    found = decoded(read(written(tmp_path, image)))
    assert found.mode == kept
    if mode == "I;16":
        np.testing.assert_allclose(np.array(found)[..., 0], grey / 257.0, atol=1.0)


def test_a_jpeg_for_print_becomes_plain_colours(tmp_path):
    assert decoded(read(written(tmp_path, pixels(8, 8).convert("CMYK"), "a.jpg"))).mode == "RGB"


@pytest.mark.parametrize("name", ["a.png", "a.jpg"])
def test_a_truncated_picture_is_refused(tmp_path, name):
    whole = written(tmp_path, pixels(400, 300), name).read_bytes()
    for share in (0.1, 0.5, 0.9):
        (tmp_path / name).write_bytes(whole[: int(share * len(whole))])
        assert "a damaged" in refused(tmp_path / name)


@pytest.mark.parametrize("data", [b"", b"hello", b"<svg/>", b"GIF89a" + bytes(99), b"%!PS", b"II*\0", b"BM" + bytes(9)])
def test_other_files_are_refused(tmp_path, data):
    (tmp_path / "a.png").write_bytes(data)
    assert refused(tmp_path / "a.png") == 'report.logo: "a.png": not a PNG or JPEG picture; save it as one of them'


def header_of(width: int, height: int) -> bytes:
    """A PNG that says it is so large, and has hardly any bytes."""

    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    size = chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
    return b"\x89PNG\r\n\x1a\n" + size + chunk(b"IDAT", zlib.compress(bytes(99))) + chunk(b"IEND", b"")


@pytest.mark.parametrize("side", [9_000, 50_000, 2_000_000])
def test_a_picture_of_too_many_pixels_is_refused_before_it_is_decoded(tmp_path, side, monkeypatch):
    monkeypatch.setattr(Image.Image, "load", lambda self: pytest.fail("decoded"))
    (tmp_path / "a.png").write_bytes(header_of(side, side))
    assert "too many pixels; give at most 60 million" in refused(tmp_path / "a.png")


def test_a_text_that_unpacks_to_gigabytes_is_refused(tmp_path):
    info = PngInfo()
    info.add_text("Comment", "x" * 90_000_000, zip=True)
    assert "a damaged PNG" in refused(written(tmp_path, pixels(4, 4), pnginfo=info))


def test_a_file_of_too_many_bytes_is_refused(tmp_path, monkeypatch):
    monkeypatch.setattr(report, "LARGEST_FILE", 50)
    assert "give at most" in refused(written(tmp_path, pixels(4, 4)))


def test_logo_and_figures_arrive_with_their_captions_and_a_wrong_one_is_named(tmp_path):
    written(tmp_path, pixels(4, 4), "logo.png")
    written(tmp_path, pixels(6, 4), "north.jpg")
    table = '[report]\nlogo = "logo.png"\nfigures = [{ file = "north.jpg", caption = "<b>North" }]\n'
    (tmp_path / "project.toml").write_text(SPIRE + table, encoding="utf-8")
    project = load(tmp_path)
    found = report_matter_of(project.content, project.folder)
    assert found.logo is not None
    assert (found.logo.name, found.figures[0].name, found.figures[0].caption) == ("logo.png", "north.jpg", "<b>North")
    (tmp_path / "north.jpg").write_bytes(b"x")
    with pytest.raises(ProjectError, match=r'report\.figures\[1\]\.file: "north\.jpg": not a PNG or JPEG picture'):
        report_matter_of(project.content, project.folder)


def test_pictures_are_among_the_inputs_and_in_the_results(tmp_path):
    written(tmp_path, pixels(4, 4), "logo.png")
    path = written(tmp_path, pixels(6, 4), "north.jpg")
    spectrum = '[site.spectrum]\ncode = "ec8"\na_g = "0.1 g"\nground_type = "A"\ntype = 1\n'
    asked = '[analysis]\nprocedures = ["ec8-element"]\n'
    table = '[report]\nlogo = "logo.png"\nfigures = [{ file = "north.jpg" }, { file = "north.jpg" }]\n'
    found = run_study(study_of(tmp_path, SPIRE + spectrum + asked + table))
    hashes = {each.path: each.sha256 for each in found.inputs}
    assert list(hashes) == ["project.toml", "logo.png", "north.jpg"]
    assert hashes["north.jpg"] == hashlib.sha256(path.read_bytes()).hexdigest()
    assert len(found.report.figures) == 2
    assert loads(dumps(found)).report == found.report
    assert found.project["report.logo"].value == "logo.png"
