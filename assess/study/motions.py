"""The rocking motions of a mechanism under several records, and their table."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from assess.study.response import RockingResponse

if TYPE_CHECKING:
    from pandas import DataFrame

FLOATS = ("scale", "max_ratio", "max_rotation", "time_of_max", "overturning_time", "rebound")
UNITS = {"max_rotation": "rad", "time_of_max": "s", "overturning_time": "s"}


@dataclass(frozen=True)
class Motions(Sequence[RockingResponse]):
    """The motions of one mechanism, one for each record, in the order of the records.

    mechanism : its name; each : the motions, which `len`, `for` and `[place]` reach too
    """

    mechanism: str
    each: tuple[RockingResponse, ...]

    def __len__(self) -> int:
        return len(self.each)

    def __iter__(self) -> Iterator[RockingResponse]:
        return iter(self.each)

    def __getitem__(self, place):  # type: ignore[no-untyped-def]  # one motion, or a tuple of a slice
        return self.each[place]

    def __repr__(self) -> str:
        overturned = sum(motion.overturned for motion in self)
        plural = "" if len(self) == 1 else "s"
        return f"Motions({self.mechanism!r}, {len(self)} record{plural}, {overturned} overturned)"

    def table(self) -> DataFrame:
        """Return a row for each record: id, scale, max_ratio, overturned, impacts and the rest of the largest response.

        What a motion that overturned does not have is nan; `frame.attrs["units"]` lists the units.
        """
        import pandas as pd  # late: it takes a third of a second

        columns = ("scale", "max_ratio", "overturned", "impacts", *FLOATS[2:])
        rows = [(motion.record, *(getattr(motion, column) for column in columns)) for motion in self]
        frame = pd.DataFrame.from_records(rows, columns=["id", *columns]).astype(dict.fromkeys(FLOATS, "float64"))
        frame.attrs["units"] = dict(UNITS)
        return frame

    def _repr_html_(self) -> str:
        return str(self.table().to_html(notebook=True))
