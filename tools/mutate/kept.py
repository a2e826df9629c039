"""Mutants kept as text, so that the same can be tried again after files, lines and names have moved.

One is found by the tokens of its lines and, where these stand in several places, of the lines around them: in the
function that it was drawn in or wherever they stand now, as they were or with other names for the same things. What is
found nowhere, or still in several places, is lost.
"""

from __future__ import annotations

import ast
import io
import json
import tokenize
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass
from difflib import SequenceMatcher
from functools import cache
from keyword import iskeyword
from pathlib import Path

from tools.mutate.mutant import Mutant
from tools.mutate.site import ROOT, Site, files

BLANK = (tokenize.NL, tokenize.NEWLINE, tokenize.COMMENT, tokenize.INDENT, tokenize.DEDENT, tokenize.ENDMARKER)


@dataclass(frozen=True)
class KeptMutant:
    """A mutant as text: the path and function it was drawn in, its operator, and its lines before and after.

    above, below : the lines around these
    """

    path: str
    function: str
    operator: str
    before: str
    after: str
    above: str
    below: str


def keep(mutants: Sequence[Mutant], file: Path) -> None:
    """Write mutants as text."""
    kept = [
        KeptMutant(each.site.path, each.site.function, each.operator, *each.lines, *_around(each)) for each in mutants
    ]
    file.write_text(json.dumps([asdict(each) for each in kept], indent=1), encoding="utf-8")


def _around(mutant: Mutant) -> tuple[str, str]:
    """The lines above and below the change."""
    lines = [line for line in mutant.diff.splitlines() if not line.startswith("@@")]
    changed = [number for number, line in enumerate(lines) if line.startswith(("+", "-"))]
    above, below = lines[: changed[0]], lines[changed[-1] + 1 :]
    return "\n".join(line[1:] for line in above), "\n".join(line[1:] for line in below)


def find_again(file: Path) -> tuple[list[Mutant], list[KeptMutant]]:
    """Return the mutants of a file where they stand now, and those that are lost."""
    found, lost = list[Mutant](), list[KeptMutant]()
    for entry in json.loads(file.read_text(encoding="utf-8")):
        kept = KeptMutant(**{name: entry[name] for name in KeptMutant.__dataclass_fields__})
        mutant = _find(kept)
        if mutant is None:
            lost.append(kept)
        else:
            found.append(mutant)
    return found, lost


@dataclass(frozen=True)
class _Token:
    """A token, with where it begins and ends in the text of its file."""

    text: str
    start: int
    end: int
    line: int

    @property
    def kind(self) -> str:
        """The token itself; "name" for one that may have been renamed."""
        return "name" if self.text.isidentifier() and not iskeyword(self.text) else self.text


def _find(kept: KeptMutant) -> Mutant | None:
    for renamed in (False, True):
        for above, below in (("", ""), ("", kept.below), (kept.above, ""), (kept.above, kept.below)):
            before, after = (
                [token for part in (above, lines, below) for token in _tokens(part)]
                for lines in (kept.before, kept.after)
            )
            places = [(path, at) for path in files() for at in _places(path, before, renamed=renamed)]
            named = [place for place in places if _function_at(*place) == kept.function.split(".")[-1]]
            for here in (named, places):
                if len(here) == 1:
                    return _mutant(kept, *here[0], before, after)
    return None


def _places(path: str, tokens: Sequence[_Token], *, renamed: bool) -> Iterator[int]:
    """Where a run of tokens begins among those of a source; renamed: with one other name for each."""
    own, size = _tokens_of(path), len(tokens)
    if not tokens:
        return
    key = [each.kind if renamed else each.text for each in tokens]
    found = [each.kind if renamed else each.text for each in own]
    for at in range(len(own) - size + 1):
        if found[at] == key[0] and found[at : at + size] == key:
            names = {(each.text, here.text) for each, here in zip(tokens, own[at : at + size], strict=True)}
            if len({old for old, _ in names}) == len(names):
                yield at


def _mutant(kept: KeptMutant, path: str, at: int, before: Sequence[_Token], after: Sequence[_Token]) -> Mutant:
    """Change the tokens that the mutant changes, under the names of today."""
    own, source = _tokens_of(path)[at : at + len(before)], _text(path)
    today = {old.text: new.text for old, new in zip(before, own, strict=True)}
    changes = SequenceMatcher(None, [each.text for each in before], [each.text for each in after], autojunk=False)
    changed, last = "", 0
    for kind, i, j, k, m in changes.get_opcodes():
        if kind != "equal":
            start = own[i].start if i < len(own) else own[-1].end
            changed += source[last:start] + " ".join(today.get(each.text, each.text) for each in after[k:m])
            last = own[j - 1].end if j > i else start
            changed += "" if j > i else " "
    lines = own[0].line, own[-1].line
    place = ((lines[0], 0), (lines[1], 0))
    site = Site(path, place, lines, _function_at(path, at), ((kept.operator, 0),))
    return Mutant(site, kept.operator, 0, changed + source[last:])


@cache
def _text(path: str) -> str:
    return (ROOT / path).read_text(encoding="utf-8")


@cache
def _tokens_of(path: str) -> list[_Token]:
    return _tokens(_text(path))


def _tokens(text: str) -> list[_Token]:
    """The tokens of a text, also of lines cut out of a statement."""
    lines, found = text.splitlines(keepends=True), list[_Token]()
    starts = [0]
    for line in lines:
        starts.append(starts[-1] + len(line))
    try:
        for each in tokenize.generate_tokens(io.StringIO(text).readline):
            if each.type not in BLANK:
                (row, column), (last, end) = each.start, each.end
                found.append(_Token(each.string, starts[row - 1] + column, starts[last - 1] + end, row))
    except (tokenize.TokenError, IndentationError):  # brackets that open or close elsewhere
        pass
    return found


def _function_at(path: str, at: int) -> str:
    """The name of the innermost function around a token; "" outside functions."""
    line = _tokens_of(path)[at].line
    around = [each for each in _functions(path) if each[0] <= line <= each[1]]
    return max(around)[2] if around else ""


@cache
def _functions(path: str) -> list[tuple[int, int, str]]:
    """First line, last line and name of every function of a source."""
    nodes = (node for node in ast.walk(ast.parse(_text(path))) if isinstance(node, ast.FunctionDef))
    return [(node.lineno, node.end_lineno or node.lineno, node.name) for node in nodes]
