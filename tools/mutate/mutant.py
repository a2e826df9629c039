"""Mutants, and those that a seed draws: of each package as many as its share of all places."""

from __future__ import annotations

import difflib
from collections.abc import Sequence
from dataclasses import dataclass
from random import Random

from tools.mutate.site import ROOT, Site, all_sites, mutated


@dataclass(frozen=True)
class Mutant:
    """A place with one change."""

    site: Site
    operator: str
    occurrence: int
    source: str  # the whole file, changed

    @property
    def package(self) -> str:
        """The room of `assess`, or the package."""
        first, second = self.site.path.split("/")[:2]
        return second.removesuffix(".py") if first == "assess" else first

    @property
    def lines(self) -> tuple[str, str]:
        """The lines that differ, before and after, without indentation."""
        before, after = self._original().splitlines(), self.source.splitlines()
        changes = difflib.SequenceMatcher(None, before, after, autojunk=False).get_opcodes()
        kept = [each for each in changes if each[0] != "equal"]
        old = [line.strip() for _, i, j, _, _ in kept for line in before[i:j]]
        return "\n".join(old), "\n".join(line.strip() for _, _, _, i, j in kept for line in after[i:j])

    @property
    def diff(self) -> str:
        """Unified, with one line around it."""
        pair = self._original().splitlines(), self.source.splitlines()
        lines = difflib.unified_diff(*pair, self.site.path, self.site.path, lineterm="", n=1)
        return "\n".join(list(lines)[2:])

    def _original(self) -> str:
        return (ROOT / self.site.path).read_text(encoding="utf-8")


def draw(count: int, *, seed: int) -> list[Mutant]:
    """Mutants at different places, in no order; the same for the same sources and seed."""
    random, rooms = Random(seed), dict[str, list[Site]]()
    for site in all_sites():
        rooms.setdefault(
            "/".join(site.path.split("/")[:2]) if site.path.startswith("assess") else site.path.split("/")[0], []
        ).append(site)
    shares = _shares([len(each) for each in rooms.values()], count)
    found = [mutant for room, share in zip(rooms.values(), shares, strict=True) for mutant in _of(room, share, random)]
    return random.sample(found, len(found))


def _shares(sizes: Sequence[int], count: int) -> list[int]:
    """Whole numbers in proportion to `sizes` that add up to `count`, by largest remainder."""
    exact = [count * size / sum(sizes) for size in sizes]
    shares = [int(each) for each in exact]
    by_remainder = sorted(range(len(sizes)), key=lambda i: shares[i] - exact[i])
    for i in by_remainder[: count - sum(shares)]:
        shares[i] += 1
    return shares


def _of(sites: Sequence[Site], count: int, random: Random) -> list[Mutant]:
    found = list[Mutant]()
    for site in random.sample(sites, len(sites)):
        if len(found) == count:
            break
        operator, occurrence = random.choice(site.mutants)
        source = mutated(site.path, operator, occurrence)
        if source is not None:
            found.append(Mutant(site, operator, occurrence, source))
    return found
