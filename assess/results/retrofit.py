"""The least works that reach a target, as data: what was varied, every layout that was examined, and the proof."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf, isclose, isinf
from typing import TYPE_CHECKING, Any, Literal

from assess.messages.message import Message
from assess.short_repr import ShortRepr

if TYPE_CHECKING:
    from pandas import DataFrame

TargetKind = Literal["index", "ratio", "probability"]
CONFIDENCE = 0.84
"""Of the share of records that overturn, which the least layout has."""
SAME = 1e-9  # relative difference of numbers that are one
Place = tuple[int, ...]
"""A layout by the number of its value on each axis, from 0."""


@dataclass(frozen=True)
class Reached:
    """What a layout reaches.

    value : in the measure of the target; None where it is not known, inf for a ratio where a record overturns
    overturned : records that overturn a mechanism
    """

    value: float | None
    overturned: int = 0


@dataclass(frozen=True)
class Layout:
    """Works of certain sizes.

    place : in the grid; values : in the units of the axes
    steel : of the ties [kg]; objective : what is to be least, steel [kg] or cost
    refused : why it is no layout to be built; reached : None where it was refused
    """

    place: Place
    values: tuple[float, ...]
    steel: float
    objective: float
    refused: Message | None = None
    reached: Reached | None = None


@dataclass(frozen=True)
class Target:
    """What works are to reach: index, largest ratio of a history to the overturning rotation, or probability.

    rising : whether more of it is better
    """

    kind: TargetKind
    reach: float
    rising: bool

    def holds(self, reached: Reached) -> bool:
        """Return whether a value reaches it; what is not known does not."""
        if reached.value is None:
            return False
        return reached.value >= self.reach if self.rising else reached.value <= self.reach

    def may_hold(self, reached: Reached) -> bool:
        """Return whether it is worth a proof: a few records of which none overturns cannot show a small share."""
        return self.holds(reached) or (self.kind == "probability" and not reached.overturned)

    def beyond(self, layout: Layout) -> float:
        """Return what a layout reaches, the less the better; inf where it is not known."""
        value = None if layout.reached is None else layout.reached.value
        if value is None or isinf(value):
            return inf
        return -value if self.rising else value


@dataclass(frozen=True)
class Tolerance:
    """Factors on what is built: areas, lengths, heights above the hinge and yield stresses of ties [-]."""

    area: float = 1.0
    length: float = 1.0
    height: float = 1.0
    yield_stress: float = 1.0


@dataclass(frozen=True)
class Proof:
    """What a layout reaches on records that the search did not see, with one tolerance of its ties.

    refused : why it cannot be built with it; None where it can
    """

    tolerance: Tolerance
    reached: Reached
    holds: bool
    refused: Message | None = None


@dataclass(frozen=True)
class Trial:
    """A layout put to the proof, and what it reaches with one tolerance."""

    layout: Layout
    proof: Proof


@dataclass(frozen=True)
class VariedKey:
    """What was varied: a key or a declared work, its unit, "" for none, and its value in the file, if it has one."""

    key: str
    unit: str
    present: float | None


@dataclass(frozen=True, repr=False)
class RetrofitResults(ShortRepr):
    """What a search for the least works found.

    title, language, units : of the project
    mechanisms : that the works change; limit_state : "" where none is chosen; index : the name of the measure, or ""
    pga_g : of the action of the histories [g]; None for an index
    layouts : that were examined or refused, in the order of the grid; whole : whether they are the whole grid
    best : the least that is proved; None where none is; nearest : the best of those examined
    proofs : of `best`, else of the last that was tried, up to its failure
    priced : whether the least cost counts, not the least steel; currency : of it, "" where none is named
    tried : how many were put to the proof, of `most` that might be, which each counts for
    candidates : how many reached the target in the search
    failed : those that fell short, the least first, each with the tolerance that was the first to show it
    search_records, proof_records : their names
    verdict : of the project with the best works: "pass", "fail" or "incomplete"; "" where it was not asked
    building_index : of that project, the worst of all its mechanisms; None where it is not known or was not asked
    """

    title: str
    language: str
    units: str
    mechanisms: tuple[str, ...]
    target: Target
    limit_state: str
    index: str
    pga_g: float | None
    varied: tuple[VariedKey, ...]
    priced: bool
    currency: str
    layouts: tuple[Layout, ...]
    whole: bool
    best: Layout | None
    nearest: Layout | None
    proofs: tuple[Proof, ...]
    tried: int
    most: int
    candidates: int
    search_records: tuple[str, ...] = ()
    proof_records: tuple[str, ...] = ()
    verdict: str = ""
    building_index: float | None = None
    warnings: tuple[Message, ...] = ()
    failed: tuple[Trial, ...] = ()

    @property
    def confidence(self) -> float | None:
        """The confidence at which a share counts in the proof, by Bonferroni over `most` layouts; None of no share."""
        return proof_confidence(self.most) if self.target.kind == "probability" and self.most else None

    @property
    def front(self) -> tuple[Layout, ...]:
        """The Pareto front: layouts for which none of less steel or cost reaches as much, and the one proved."""
        return pareto_front(self.layouts, self.target, proved=self.best)

    @property
    def trials(self) -> tuple[Trial, ...]:
        """Those that fell short in the proof, and of the layout that did not what it reaches with every tolerance."""
        kept = self.best or self.nearest
        proved = kept is not None and all(proof.holds for proof in self.proofs)
        return (*self.failed, *(Trial(kept, proof) for proof in self.proofs if kept is not None and proved))

    def fell_short(self, layout: Layout) -> bool:
        """Return whether a layout was put to the proof and fell short."""
        return any(each.layout.place == layout.place for each in self.failed)

    def table(self) -> DataFrame:
        """Return a row for each layout: its values, steel, cost, what it reaches, and why it was refused."""
        import pandas as pd

        return pd.DataFrame([self._row(each) for each in self.layouts])

    def _row(self, layout: Layout) -> dict[str, Any]:
        keys = [f"{each.key} [{each.unit}]" if each.unit else each.key for each in self.varied]
        reached = layout.reached or Reached(None)
        return {
            **dict(zip(keys, layout.values, strict=True)),
            "steel_kg": layout.steel,
            **({"cost": layout.objective} if self.priced else {}),
            self.target.kind: reached.value,
            "overturned": reached.overturned,
            "refused": "" if layout.refused is None else layout.refused.text,
            "proof": "falls short" if self.fell_short(layout) else "holds" if layout == self.best else "",
        }


def proof_confidence(layouts: int) -> float:
    """Return the confidence at which each of several layouts counts that may be put to the proof on the same records.

    The one that is chosen then has its share at CONFIDENCE whatever led to it (Bonferroni).
    """
    return 1.0 - (1.0 - CONFIDENCE) / layouts


def pareto_front(layouts: Sequence[Layout], target: Target, *, proved: Layout | None = None) -> tuple[Layout, ...]:
    """Return the layouts for which none of a lesser objective reaches as much, rising in the objective.

    Numbers that differ by rounding alone are equal. Of layouts of one objective that which reaches the most is on the
    front, or the one that is proved.

    Parameters
    ----------
    layouts : examined or refused, which are left out
    target : whose measure counts
    proved : the least that is, on the front even where a lesser one that fell short in the proof reached as much
    """
    front: list[Layout] = []
    most = inf
    for each in sorted(
        layouts, key=lambda each: (round_off(each.objective), round_off(target.beyond(each)), each.steel, each.place)
    ):
        beyond = target.beyond(each)
        is_more = beyond < most and not isclose(beyond, most, rel_tol=SAME)
        if not is_more and each != proved:
            continue
        most = min(most, beyond)
        if front and round_off(front[-1].objective) == round_off(each.objective):
            front.pop()
        front.append(each)
    return tuple(front)


def round_off(number: float) -> float:
    """Round a number to nine figures, off what differs by rounding alone."""
    return float(f"{number:.9g}")
