"""Logo and photographs of a project: read, never trusted, and encoded anew from their pixels.

Only the decoders of PNG and JPEG are used, on files of limited size, and no pixel is decoded before their number is
known. The result is upright, small enough for a page and without metadata; the same file gives the same bytes.
"""

from __future__ import annotations

import base64
import io
import warnings
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from assess.errors import ProjectError
from assess.project.key_text import value_text
from assess.results import MediaType, Picture
from records.paths import relative_path

if TYPE_CHECKING:
    from PIL.Image import Image

Kind = Literal["PNG", "JPEG"]
LARGEST_FILE = 25_000_000  # bytes
MOST_PIXELS = 60_000_000
TOO_MANY = f"too many pixels; give at most {MOST_PIXELS // 1_000_000} million"
LONGEST_SIDE = 1600  # px, of the picture as the report has it
QUALITY = 85  # of JPEG
STARTS: dict[Kind, bytes] = {"PNG": b"\x89PNG\r\n\x1a\n", "JPEG": b"\xff\xd8\xff"}
ENCODED: dict[Kind, MediaType] = {"PNG": "image/png", "JPEG": "image/jpeg"}


def read_picture(path: Path, *, key: str, folder: Path, caption: str = "") -> Picture:
    """Read a picture and encode it anew.

    Parameters
    ----------
    path : Path
        PNG or JPEG file.
    key : str
        Key of the project file that names it, for errors.
    folder : Path
        Folder of the project file.
    caption : str
        What it shows.

    Returns
    -------
    Picture
        At most 1600 px in width and height.

    Raises
    ------
    ProjectError
        If the file is too large, damaged, or no PNG or JPEG.
    """
    name = relative_path(path, folder)
    where = f"{key}: {value_text(name)}"
    image, kind = _decode(_bytes(path, where), where)
    data = base64.b64encode(_encode(image, kind)).decode("ascii")
    return Picture(name, caption, ENCODED[kind], *image.size, data)


def _bytes(path: Path, where: str) -> bytes:
    try:
        size = path.stat().st_size
        if size > LARGEST_FILE:
            raise ProjectError(f"{where}: {size / 1e6:.1f} MB; give at most {LARGEST_FILE / 1e6:.0f} MB")
        return path.read_bytes()
    except OSError as error:
        raise ProjectError(f"{where}: cannot be read ({error.strerror}); check its permissions") from None


def _decode(data: bytes, where: str) -> tuple[Image, Kind]:
    """Return the picture, upright, in plain colours and of its final size, and the format of its file."""
    from PIL import Image, ImageOps

    kind = next((each for each, start in STARTS.items() if data.startswith(start)), None)
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


def _encode(image: Image, kind: Kind) -> bytes:
    """Return the bytes of a file with the pixels alone."""
    from PIL.Image import frombytes

    pixels = frombytes(image.mode, image.size, image.tobytes())  # without what the file said besides
    file = io.BytesIO()
    if kind == "PNG":
        pixels.save(file, "PNG", optimize=True)
    else:
        pixels.save(file, "JPEG", quality=QUALITY, optimize=True)
    return file.getvalue()
