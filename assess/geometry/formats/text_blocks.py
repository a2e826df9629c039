"""Text of lines and numbers, read in blocks: memory is a few times the numbers, not the text."""

from __future__ import annotations

import re
import warnings
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from spectra.arrays import BoolArray, FloatArray, IntArray

Number = TypeVar("Number", np.float64, np.int64)

BLOCK = 1 << 22  # bytes read at a time
COMMENT = re.compile(rb"#[^\n]*")
SPACE, NEWLINE = 32, 10  # bytes up to the space part words


@dataclass(frozen=True)
class TextBlock:
    """Whole lines of a file.

    text : bytes, ending with a line break
    end : where each line ends: its line break [n]
    words : number of words of each line [n]
    first, second : the first byte of its first word, and the byte after that; 0 where there is none [n]
    """

    text: NDArray[np.uint8]
    end: IntArray
    words: IntArray
    first: NDArray[np.uint8]
    second: NDArray[np.uint8]


def read_blocks(file: Path, *, skip: int = 0, comments: bool = False) -> Iterator[TextBlock]:
    """Read the lines of a file; a backslash at the end of a line joins the next to it.

    Parameters
    ----------
    skip : bytes before the first line
    comments : whether text after a # is dropped

    Raises
    ------
    ValueError : it is not a text of one byte per letter
    """
    with file.open("rb") as content:
        content.seek(skip)
        rest = b""
        while read := content.read(BLOCK):
            if b"\0" in read:
                raise ValueError("it is no plain text; if it is UTF-16, save it as UTF-8")
            text = (rest + read).replace(b"\r\n", b"\n").replace(b"\r", b"\n").replace(b"\\\n", b"  ")
            whole = text.rfind(b"\n") + 1
            rest = text[whole:]
            if whole:
                yield _text_block(COMMENT.sub(b"", text[:whole]) if comments else text[:whole])
        if rest.strip():
            yield _text_block((COMMENT.sub(b"", rest) if comments else rest).rstrip(b"\\") + b"\n")


def _text_block(text: bytes) -> TextBlock:
    letters = np.frombuffer(text, np.uint8)
    end = np.flatnonzero(letters == NEWLINE)
    word = letters > SPACE
    starts = np.flatnonzero(np.diff(word, prepend=False) & word)
    before = np.searchsorted(starts, end)  # words up to the end of each line
    words = np.diff(before, prepend=0)
    heads = np.append(starts, end[-1])[before - words]
    first, second = (np.where(words > 0, letters[np.minimum(heads + k, end[-1])], 0).astype(np.uint8) for k in (0, 1))
    return TextBlock(letters, end, words, first, second)


def join_lines(block: TextBlock, chosen: BoolArray) -> bytes:
    """Return the chosen lines [n] as one text."""
    if chosen.all():
        return block.text.tobytes()
    lengths = np.diff(block.end, prepend=-1)
    return block.text[np.repeat(chosen, lengths)].tobytes()


def parse_numbers(text: bytes, *, count: int) -> FloatArray:
    """Return all numbers of a text [count].

    Raises
    ------
    ValueError : a word is not a number, or their number differs
    """
    with warnings.catch_warnings(), suppress(ValueError):
        warnings.simplefilter("ignore", DeprecationWarning)  # numpy before 2.5 warns of text not read to its end
        found = np.fromstring(text, dtype=np.float64, sep=" ")
        if len(found) == count:
            return found
    raise ValueError(_first_non_number(text))


def parse_words(data: bytes, start: int) -> FloatArray:
    """Parse all words of a text from byte `start` on as numbers; raise ValueError where one is not."""
    cuts = [start]
    while cuts[-1] < len(data):
        space = re.compile(rb"\s").search(data, cuts[-1] + BLOCK)
        cuts.append(space.end() if space else len(data))
    spans = list(pairwise(cuts))
    counts = [_count_words(data[a:b]) for a, b in spans]
    found = np.empty(sum(counts))
    at = 0
    for (a, b), count in zip(spans, counts, strict=True):
        found[at : at + count] = parse_numbers(data[a:b], count=count)
        at += count
    return found


def _count_words(text: bytes) -> int:
    word = np.frombuffer(text, np.uint8) > SPACE
    return int(np.count_nonzero(np.diff(word, prepend=False) & word))


def rows_by_length(values: NDArray[Number], sizes: IntArray) -> Iterator[tuple[IntArray, NDArray[Number]]]:
    """Group rows of equal length: yield their indices [k] and their values [k, size].

    Parameters
    ----------
    values : of all rows, one after another
    sizes : number of values of each row [n]
    """
    starts = np.cumsum(sizes) - sizes
    for size in np.flatnonzero(np.bincount(sizes)).tolist() if len(sizes) else []:
        places = np.flatnonzero(sizes == size)
        together = len(places) == len(sizes)
        yield places, values.reshape(-1, size) if together else values[starts[places][:, None] + np.arange(size)]


def rest_of_line(block: TextBlock, line: int) -> str:
    """Return the text of a line after its first word."""
    start = 0 if line == 0 else int(block.end[line - 1]) + 1
    text = block.text[start : block.end[line]].tobytes().decode("utf-8", errors="replace")
    return " ".join(text.split(maxsplit=1)[1:]).strip()


def _first_non_number(text: bytes) -> str:
    """Describe the first word that is not a number."""
    for word in re.finditer(rb"\S+", text):
        try:
            float(word[0])
        except ValueError:
            shown = word[0][:20].decode("latin-1")
            hint = "; decimals take a point" if re.fullmatch(r"[-+]?\d+,\d+", shown) else ""
            return f'"{shown}" is no number{hint}'
    return "a line has not the numbers that it should have"
