"""Edits of files as bytes: of text line by line, of binary files by bits, words and blocks."""

from __future__ import annotations

import re
import struct
from collections.abc import Callable, Mapping
from random import Random

from tools.fuzz.fuzz_input import Edit, FuzzInput, rewritten

NASTY = (
    *("nan", "inf", "-inf", "1e300", "-1e300", "1e-300", "0", "-0.0", "-1", "-999", "9999999999", "99999", "1e9", ""),
    *("1,5", "1.5.2", "0x10", "1_000", "٣", "½", "1e", "--1", "9" * 400, "abc", "\u202e1", "\u200b1", "=1+1"),
)
WORDS = tuple(
    [struct.pack("<f", value) for value in (0.0, -0.0, 1e30, -1e30, 1e-30, float("nan"), float("inf"))]
    + [struct.pack("<I", value) for value in (0, 1, 2, 2**31 - 1, 2**31, 2**32 - 1, 1000, 10**6)]
)
NUMBER = re.compile(rb"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eEdD][-+]?\d+)?")
DIGIT = re.compile(rb"\d")


def is_text(data: bytes) -> bool:
    """Whether a file is of lines."""
    return b"\0" not in data[:4000] and data[:4000].count(b"\n") > 1


def edits(random: Random, case: FuzzInput) -> tuple[Edit, ...]:
    """One edit of the target, seldom two."""
    one = _text if is_text(case.data) else _binary
    found = one(random, case)
    if random.random() < 0.1:
        more = one(random, case)
        if more[0].offset > found[0].offset + found[0].removed + 1:
            return (*found, *more)
    return found


def _text(random: Random, case: FuzzInput) -> tuple[Edit, ...]:
    name = random.choices(list(TEXT), weights=[weight for _, weight in TEXT.values()])[0]
    return TEXT[name][0](random, case, name)


def _line(random: Random, case: FuzzInput) -> tuple[int, int, bytes]:
    """Start, number from 1, and content of a line; one of the first sixty in two of three cases."""
    lines = case.data.splitlines(keepends=True)
    last = min(len(lines), 60) if random.random() < 0.67 else len(lines)
    number = random.randrange(last)
    return sum(map(len, lines[:number])), number + 1, lines[number]


def _place(number: int, line: bytes) -> str:
    """A label that lines of samples share, and those of a header do not."""
    words = b" ".join(re.findall(rb"[A-Za-z%#]{2,}", line)).decode()
    return f"line {number} {words[:30]}" if words else "rows of numbers"


def _edit(start: int, number: int, line: bytes, at: int, removed: int, inserted: bytes, name: str) -> tuple[Edit, ...]:
    old = line[max(at - 15, 0) : at + removed + 15].decode("latin-1").strip("\r\n")
    new = (line[max(at - 15, 0) : at] + inserted[:40] + line[at + removed : at + removed + 15]).decode("latin-1")
    return (Edit(start + at, removed, inserted, _place(number, line), f"{name}: {old!r} -> {new.rstrip()!r}"),)


def _digit(random: Random, case: FuzzInput, name: str) -> tuple[Edit, ...]:
    start, number, line = _line(random, case)
    found = [match.start() for match in DIGIT.finditer(line)]
    if not found:
        return _drop(random, case, "bytes lost")
    at = random.choice(found)
    new = random.choice([d for d in b"0123456789" if d != line[at]])
    return _edit(start, number, line, at, 1, bytes([new]), name)


def _number(random: Random, case: FuzzInput, name: str) -> tuple[Edit, ...]:
    start, number, line = _line(random, case)
    found = list(NUMBER.finditer(line))
    if not found:
        return _drop(random, case, "bytes lost")
    match = random.choice(found)
    new = random.choice(NASTY).encode()
    if random.random() < 0.5 and match[0].strip(b"0.-+"):  # ten times, a tenth, turned round, in g
        value = float(match[0].lower().replace(b"d", b"e"))
        other = value * random.choice((10.0, 0.1, -1.0, 2.0, 981.0, 1.0 + 1e-3))
        new = (f"%.{len(match[0].split(b'.')[1]) if b'.' in match[0] else 0}f" % other).encode()
        new = new[: len(match[0])].rjust(len(match[0])) if random.random() < 0.7 else new
    return _edit(start, number, line, match.start(), len(match[0]), new, name)


def _drop(random: Random, case: FuzzInput, name: str) -> tuple[Edit, ...]:
    start, number, line = _line(random, case)
    count = min(random.randint(1, 8), len(line))
    return _edit(start, number, line, random.randrange(len(line) - count + 1), count, b"", name)


def _insert(random: Random, case: FuzzInput, name: str) -> tuple[Edit, ...]:
    start, number, line = _line(random, case)
    new = random.choice(
        (b" ", b"\t", b"\0", b"\xff", b"\xe2\x80\xae", b"\n", b"\r", b"\x1a", b"-", b"9", b".", b",", b"*")
    )
    return _edit(start, number, line, random.randrange(len(line)), 0, new, name)


def _lost_line(random: Random, case: FuzzInput, name: str) -> tuple[Edit, ...]:
    start, number, line = _line(random, case)
    return _edit(start, number, line, 0, len(line), b"", name)


def _line_again(random: Random, case: FuzzInput, name: str) -> tuple[Edit, ...]:
    start, number, line = _line(random, case)
    return _edit(start, number, line, 0, 0, line, name)


def _lines_swapped(random: Random, case: FuzzInput, name: str) -> tuple[Edit, ...]:
    start, number, line = _line(random, case)
    after = case.data[start + len(line) :].split(b"\n", 1)[0] + b"\n"
    return _edit(start, number, line + after, 0, len(line + after), after + line, name)


def _lower_word(random: Random, case: FuzzInput, name: str) -> tuple[Edit, ...]:
    start, number, line = _line(random, case)
    found = list(re.finditer(rb"[A-Za-z]{2,}", line))
    if not found:
        return _digit(random, case, "digit")
    match = random.choice(found)
    new = random.choice((match[0].swapcase(), match[0][:-1], match[0][::-1], b"", b"gal", b"g", b"mm", b"up"))
    return _edit(start, number, line, match.start(), len(match[0]), new, name)


def _cut(random: Random, case: FuzzInput, name: str) -> tuple[Edit, ...]:
    at = random.randrange(len(case.data))
    return (Edit(at, len(case.data) - at, b"", "end", f"{name} at {at} of {len(case.data)}"),)


WHOLE: Mapping[str, Callable[[bytes], bytes]] = {
    "CRLF": lambda data: data.replace(b"\r\n", b"\n").replace(b"\n", b"\r\n"),
    "CR": lambda data: data.replace(b"\r\n", b"\n").replace(b"\n", b"\r"),
    "BOM": lambda data: b"\xef\xbb\xbf" + data,
    "UTF-16": lambda data: data.decode("latin-1").encode("utf-16"),
    "decimal commas": lambda data: re.sub(rb"(\d)\.(\d)", rb"\1,\2", data),
    "tabs": lambda data: re.sub(rb" +", b"\t", data),
    "no leading blanks": lambda data: re.sub(rb"(?m)^ +", b"", data),
    "blanks at the ends": lambda data: data.replace(b"\n", b"   \n"),
    "blank lines between": lambda data: data.replace(b"\n", b"\n\n"),
    "upper case": bytes.upper,
    "twice": lambda data: data + data,
    "D exponents": lambda data: re.sub(rb"(\d)[eE]([-+]\d\d)", rb"\1D\2", data),
    "two columns lost at the right": lambda data: re.sub(rb"(?m)..$", b"", data),
}


def _whole(random: Random, case: FuzzInput, name: str) -> tuple[Edit, ...]:
    of = random.choice(list(WHOLE))
    return rewritten(case, WHOLE[of](case.data), where="whole file", what=of) or _digit(random, case, "digit")


Maker = Callable[[Random, FuzzInput, str], tuple[Edit, ...]]
TEXT: Mapping[str, tuple[Maker, int]] = {
    "digit": (_digit, 30),
    "number": (_number, 25),
    "bytes lost": (_drop, 10),
    "byte more": (_insert, 8),
    "line lost": (_lost_line, 6),
    "line again": (_line_again, 4),
    "lines swapped": (_lines_swapped, 4),
    "word": (_lower_word, 8),
    "cut": (_cut, 3),
    "whole": (_whole, 4),
}


def _binary(random: Random, case: FuzzInput) -> tuple[Edit, ...]:
    data = case.data
    at = random.randrange(min(len(data), 300)) if random.random() < 0.4 else random.randrange(len(data))
    name = random.choices(("bit", "byte", "word", "lost", "more", "cut", "zeros"), weights=(30, 15, 30, 5, 5, 5, 3))[0]
    removed, inserted = 1, b""
    if name == "bit":
        inserted = bytes([data[at] ^ (1 << random.randrange(8))])
    elif name == "byte":
        inserted = bytes([random.choice((0, 1, 127, 128, 255))])
    elif name == "word":
        at, removed, inserted = at - at % 4, 4, random.choice(WORDS)
    elif name == "lost":
        removed = random.choice((1, 2, 4, 12, 50))
    elif name == "more":
        removed, inserted = 0, data[at : at + random.choice((1, 2, 4, 12, 50))]
    elif name == "cut":
        removed = len(data) - at
    else:
        removed = min(random.choice((4, 12, 100)), len(data) - at)
        inserted = bytes(removed)
    removed = min(removed, len(data) - at)
    shown = f"{name} at {at}: {data[at : at + removed][:12].hex()} -> {inserted[:12].hex()}"
    return (Edit(at, removed, inserted, f"byte {at}" if at < 84 else f"byte {at // 256 * 256} and on", shown),)
