"""A share of a portfolio, for one of several commands that divide it among themselves."""

from __future__ import annotations

import hashlib
import re
from dataclasses import dataclass

from assess.errors import AssessError

_WRITTEN = re.compile(r"([0-9]{1,6})/([0-9]{1,6})")


@dataclass(frozen=True)
class Shard:
    """One of `count` shares, by its number from 1. A project belongs to a share by the hash of its key alone."""

    number: int = 1
    count: int = 1

    def holds(self, key: str) -> bool:
        """Return whether the project of a key is of this share."""
        place = hashlib.sha256(key.encode("utf-8", "surrogatepass")).digest()[:8]
        return int.from_bytes(place) % self.count == self.number - 1

    @property
    def ledger(self) -> str:
        """The name of its ledger."""
        return "ledger.sqlite" if self.count == 1 else f"ledger-{self.number}-of-{self.count}.sqlite"


WHOLE = Shard()
LEDGERS = ("ledger.sqlite", "ledger-*-of-*.sqlite")
"""Patterns of the names of ledgers."""


def shard_of(text: str) -> Shard:
    """Return the share that "i/n" names; raise AssessError for what names none."""
    found = _WRITTEN.fullmatch(text)
    if found is None or not 1 <= int(found[1]) <= int(found[2]):
        raise AssessError(f"--shard {text!r:.40}: give i/n, such as 1/8, with i from 1 to n")
    return Shard(int(found[1]), int(found[2]))
