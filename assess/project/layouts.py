"""Layouts of works on a project: what each costs, why one is not to be built, and the study of its mechanisms.

Layouts are refused that rules of detailing exclude, whatever they reach: pretension above half of what yields the bar,
and anchors farther apart than allowed, 3 m unless the engineer has checked the wall between them. Where the anchorage
of ties is computed from their plates, the wall between them is a part of it, and three plates in one cone are refused.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import nan
from typing import Any

import numpy as np
import shapely

from assess.errors import AssessError, ProjectError
from assess.loads.load import Tie, TieLoad
from assess.messages.message import Message, Quantity, message, warning
from assess.project import sections
from assess.project.bars import Bar, bars_of
from assess.project.build import BuiltProject
from assess.project.key_errors import key_text
from assess.project.keys import read_content
from assess.project.prices import Prices
from assess.project.works import Axis, Subject, Tables, at_height, in_order, ties_by_level
from assess.results.retrofit import Layout, Place, Tolerance
from assess.study.retrofit import AS_DRAWN
from assess.study.study import Study

STEEL = 7850.0  # kg/m3
MOST_PRETENSION = 0.5  # of the yield force
MOST_IN_CONE = 2  # plates
TOLERATED = {"area": "area", "stiffness": "area", "length": "length", "yield_stress": "yield_stress"}
"""Numbers of a tie by the tolerance that changes them; of a restraint without a bar its stiffness is as its area.

The thread of a bar is cut into it, so that its section is as that of the bar too.
"""


class Designs:
    """The layouts of works on a project (`assess.study.retrofit.Designs`)."""

    def __init__(
        self,
        built: BuiltProject,
        axes: Sequence[Axis],
        subjects: Mapping[str, Subject],
        *,
        prices: Prices,
        farthest: float,
    ) -> None:
        """Take a project and what works vary of it.

        Parameters
        ----------
        built : the project; axes : what is varied; subjects : its mechanisms with geometry
        prices : by which the least is found, none for the least steel
        farthest : largest distance between anchors [m]
        """
        self.axes, self.prices, self.farthest = tuple(axes), prices, farthest
        changed = {name for axis in axes for name in axis.mechanisms}
        self.mechanisms = tuple(name for name in built.project.content.mechanisms if name in changed)
        self.built, self.subjects, self._order = built, subjects, in_order(axes)

    @property
    def sizes(self) -> tuple[int, ...]:
        """The number of values on each axis."""
        return tuple(len(axis.values) for axis in self.axes)

    @property
    def ties(self) -> list[Bar]:
        """The ties of the file that hold a mechanism which the works change."""
        return bars_of(self.built.project.content, self.mechanisms)

    @property
    def has_plates(self) -> bool:
        """Whether the anchorage of every tie is computed from its plate."""
        return all(tie.load.plate is not None and tie.load.strength is None for bar in self.ties for tie in bar)

    def apply(self, tables: Tables, place: Place) -> Tables:
        """Return tables with the works of a layout."""
        for number in self._order:
            axis = self.axes[number]
            tables = axis.change(tables, axis.values[place[number]])
        return tables

    def design(self, place: Place) -> Design:
        """Return the layout at a place of the grid."""
        values = tuple(axis.values[number] for axis, number in zip(self.axes, place, strict=True))
        try:
            tables = self.apply(self.built.project.raw, place)
            content = self.content_of(tables)
        except AssessError as error:
            refused = message("retrofit-not-built", {"error": str(error)})
            return Design(self, Layout(place, values, nan, nan, refused), {}, None)
        bars = bars_of(content, self.mechanisms)
        steel = sum(_steel(bar) for bar in bars)
        refusal = next(self._refusals(content), None)
        cost = self.prices.cost_of(self.axes, values, steel=steel, ties=len(bars))
        return Design(self, Layout(place, values, steel, steel if cost is None else cost, refusal), tables, content)

    def content_of(self, tables: Tables) -> sections.Content:
        """Read tables as the project with works."""
        return read_content(tables, self.built.project.folder)

    def messages(self) -> Iterator[Message]:
        """Yield what ties lack to count up to collapse."""
        if not any(axis.of_steel for axis in self.axes):
            return
        for tie in (tie for bar in self.ties for tie in bar if tie.mechanism in self.mechanisms):
            needed = ("strength",) * (not tie.load.plate) + ("length", "fracture_strain") * (tie.load.stiffness is None)
            lacks = [key for key in needed if getattr(tie.load, key) is None]
            source = self.built.project.content.report.source_of(".".join(map(str, (*tie.path, "until"))))
            if lacks := [*lacks, *(() if source else ("report.sources",))]:
                yield warning("retrofit-tie-lacks", key_text(tie.path), keys=", ".join(lacks))

    def _refusals(self, content: sections.Content) -> Iterator[Message]:
        """Yield why a layout may not be built."""
        anchors: dict[str, list[TieLoad]] = {}
        for tie in (tie for bar in bars_of(content, self.mechanisms) for tie in bar):
            anchors.setdefault(tie.mechanism, []).append(tie.load)
            if tie.load.area is None or tie.load.yield_stress is None:
                continue
            most, pull = MOST_PRETENSION * tie.load.area * tie.load.yield_stress, tie.load.force or 0.0
            if pull > most * (1.0 + 1e-9):
                yield message(
                    "retrofit-pretension", {"force": Quantity(pull, "force"), "most": Quantity(most, "force")}
                )
        designed = dict.fromkeys(name for axis in self.axes if axis.of_steel for name in axis.mechanisms)
        for name in (each for each in designed if each in anchors and each in self.subjects):
            if all(tie.plate is not None and tie.strength is None for tie in anchors[name]):
                continue  # the wall between them is a part of their anchorage
            levels = ties_by_level({place: tie.at[-1] for place, tie in enumerate(anchors[name])})
            apart = self.subjects[name].length / max(map(len, levels))
            if apart > self.farthest * (1.0 + 1e-9):
                yield message(
                    "retrofit-spacing",
                    {"spacing": Quantity(apart, "length", 3), "most": Quantity(self.farthest, "length", 3)},
                )


@dataclass(frozen=True)
class Design:
    """A layout (`assess.study.retrofit.Design`), with the project as it has it.

    designs : that it is of; tables, content : of the project with its works, as written and as read; None where the
    works cannot be written
    """

    designs: Designs
    layout: Layout
    tables: Tables
    content: sections.Content | None

    @property
    def has_ties(self) -> bool:
        """Whether a mechanism that the works change has a tie."""
        return self.content is not None and bool(bars_of(self.content, self.designs.mechanisms))

    def study(self, tolerance: Tolerance) -> Study:
        """Return the study of the mechanisms that the works change.

        Raises
        ------
        AssessError : it cannot be built with the tolerance
        """
        designs, content = self.designs, self.content
        assert content is not None
        if tolerance != AS_DRAWN:
            changed = with_tolerance(self.tables, content, designs.subjects, designs.mechanisms, tolerance)
            content = designs.content_of(changed)
        study = designs.built.study_at(content, designs.mechanisms)
        for each in study.mechanisms:
            if not each.rocks or each.variants.collapse is None:
                raise ProjectError(f"mechanisms.{each.name}: falls at rest without what is not shown to last")
            plates = [action.anchorage for chain in each.chains for action in chain.actions if isinstance(action, Tie)]
            if (most := max((plate.site.meeting for plate in plates if plate), default=0)) > MOST_IN_CONE:
                raise ProjectError(f"mechanisms.{each.name}: {most} plates punch one cone; {MOST_IN_CONE} at most may")
        return study


def with_tolerance(
    tables: Tables,
    content: sections.Content,
    subjects: Mapping[str, Subject],
    names: Sequence[str],
    tolerance: Tolerance,
) -> Tables:
    """Return tables whose ties differ by a tolerance; none is raised to where a wall that it holds could not hold it.

    Parameters
    ----------
    tables, content : of the project, as written and as read
    subjects : its mechanisms with geometry
    names : of the mechanisms whose ties differ, wherever these are stated
    tolerance : the factors
    """
    mechanisms = dict(tables["mechanisms"])
    for bar in bars_of(content, names):
        height = _height(bar, subjects, tolerance.height)
        for tie in bar:
            loads: list[Any] = list(mechanisms[tie.mechanism]["loads"])
            changed = dict(loads[tie.place])
            for key, factor in TOLERATED.items():
                if (value := getattr(tie.load, key)) is not None:
                    changed[key] = value * getattr(tolerance, factor)
            if tie.load.plate and (thread := tie.load.plate.thread_area):
                changed["plate"] = {**changed["plate"], "thread_area": thread * tolerance.area}
            loads[tie.place] = changed if height is None else at_height(changed, tie.load, height)
            mechanisms[tie.mechanism] = {**mechanisms[tie.mechanism], "loads": loads}
    return {**tables, "mechanisms": mechanisms}


def _height(bar: Bar, subjects: Mapping[str, Subject], factor: float) -> float | None:
    """Return the elevation of a bar whose height above the hinge differs by a factor [m]; None without geometry.

    Of several hinges that of the largest change counts, of several walls that which holds it least far up.
    """
    held = [(tie.load, subjects[tie.mechanism]) for tie in bar if tie.mechanism in subjects]
    if not held:
        return None
    now = held[0][0].at[-1]
    change = max(load.at[-1] - subject.hinge for load, subject in held) * (factor - 1.0)
    return min(now + change, max(now, min(_highest(load, subject) for load, subject in held)))


def _steel(bar: Bar) -> float:
    """Return the mass of a bar, by the thickest statement of it [kg]."""
    return max(STEEL * (tie.load.area or 0.0) * (tie.load.length or 0.0) for tie in bar)


def _highest(tie: TieLoad, subject: Subject) -> float:
    """Return the elevation up to which a tie may be raised: where its cone reaches the top of the wall above it [m].

    A plate nearer the edge punches a cone that the drawing does not have. A tie without a plate may be raised to the
    top, which is that of the hull of the bodies as seen along the direction.
    """
    plate = tie.plate
    width, height = ((plate and (getattr(plate, side) or plate.diameter)) or 0.0 for side in ("width", "height"))
    top = subject.top
    if len(tie.at) == 3:
        hull = shapely.MultiPoint(
            np.column_stack([subject.corners @ subject.across, subject.corners[:, 2]])
        ).convex_hull
        station = float(np.dot(tie.at, subject.across))
        for s in (station - width / 2.0, station + width / 2.0):
            above = shapely.intersection(hull, shapely.LineString([(s, subject.hinge - 1.0), (s, top + 1.0)]))
            top = top if above.is_empty else min(top, float(above.bounds[3]))
    if plate is None:
        return top
    leaf = plate.leaf or float(np.ptp(subject.corners @ subject.along))
    return top - height / 2.0 - leaf
