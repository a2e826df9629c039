"""One component of ground acceleration: where it came from, and which way it points."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import radians

import numpy as np
from numpy.typing import ArrayLike

from assess.messages.message import Message, Quantity, note
from assess.short_repr import html_table
from records.errors import RecordError
from spectra.arrays import FloatArray
from spectra.gravity import g

STRONGEST = 1000.0  # m/s2, a hundred g: beyond any ground motion


@dataclass(frozen=True)
class Earthquake:
    """The earthquake of a record, as far as its file says.

    time : of its origin, ISO 8601 in UTC ("2018-01-24T10:51:00Z"), the date alone where no more is known, "" unknown
    magnitude, scale : the moment magnitude where the file has it; "Mw", "ML", "MJMA", "" unknown
    latitude, longitude : of the epicentre [deg], north and east positive
    depth : of the hypocentre [m]
    """

    time: str = ""
    magnitude: float | None = None
    scale: str = ""
    latitude: float | None = None
    longitude: float | None = None
    depth: float | None = None


@dataclass(frozen=True)
class StationSite:
    """The site of the instrument, as far as the file says.

    latitude, longitude : [deg], north and east positive; elevation : above sea level [m]
    vs30 : mean shear-wave velocity of the upper 30 m [m/s]; ground : its class with the code ("EC8 B"), or the soil
    place : location of the instrument in the ground or a structure ("borehole"), "" for the free surface or unknown
    """

    latitude: float | None = None
    longitude: float | None = None
    elevation: float | None = None
    vs30: float | None = None
    ground: str = ""
    place: str = ""


NO_STATION_SITE = StationSite()


def scale(record: Record, factor: float) -> Record:
    """Multiply every acceleration of the record by `factor`.

    Parameters
    ----------
    record : accelerogram
    factor : scale factor [-]
    """
    acceleration = record.acceleration * factor
    acceleration.flags.writeable = False
    return with_step(replace(record, acceleration=acceleration), note("scaled-by", factor=Quantity(factor, figures=6)))


def with_step(record: Record, step: Message) -> Record:
    """Add one step to the record's processing history.

    Parameters
    ----------
    record : accelerogram
    step : what was done to it
    """
    return replace(record, processing_history=(*record.processing_history, step))


NO_EARTHQUAKE = Earthquake()


@dataclass(frozen=True)
class Record:
    """A uniformly sampled accelerogram, linear between samples.

    id : short unique name (file stem, or "artificial-1")
    acceleration : ground acceleration, read-only [n] [m/s2]
    dt : time step [s]
    path : the file it was read from, "" for synthetic ones
    event, station, component : as the file says, "" where it does not; an event without a name is called by its
    origin's time, magnitude and epicentre
    azimuth : direction of positive acceleration, clockwise from north [rad]; None if vertical or unknown
    distance : from the epicentre [m], None if unknown
    earthquake, site : what else the file says of them
    processing_history : what was done to it, in order; a str is a line of its file
    stationary : of an artificial record, how long its envelope is level [s]; None of recorded ones
    longest_period : up to which the processing of its source left the motion usable [s]; None where it does not say
    start : time of the first sample, as `earthquake.time`, "" unknown
    warnings : what is odd in its file
    """

    id: str
    acceleration: FloatArray
    dt: float
    path: str = ""
    event: str = ""
    station: str = ""
    component: str = ""
    processing_history: tuple[Message | str, ...] = ()
    azimuth: float | None = None
    distance: float | None = None
    earthquake: Earthquake = NO_EARTHQUAKE
    site: StationSite = NO_STATION_SITE
    stationary: float | None = None
    longest_period: float | None = None
    start: str = ""
    warnings: tuple[Message, ...] = ()

    def __repr__(self) -> str:
        """Return one line without the samples: id, size, step and PGA."""
        return f"Record(id={self.id!r}, npts={self.npts}, dt={self.dt:g} s, pga={self.pga:.4g} m/s2)"

    def _repr_html_(self) -> str:
        return html_table(
            ("record", self.id),
            (
                "event, station, component",
                ", ".join(each or "-" for each in (self.event, self.station, self.component)),
            ),
            ("time step [s], samples", f"{self.dt:g}, {self.npts}"),
            ("PGA [g]", self.pga / g),
        )

    @property
    def artificial(self) -> bool:
        """Whether it was made, not recorded."""
        return self.stationary is not None

    @property
    def npts(self) -> int:
        """Number of samples."""
        return int(self.acceleration.size)

    @property
    def pga(self) -> float:
        """Largest absolute acceleration [m/s2]."""
        return float(np.max(np.abs(self.acceleration)))

    @property
    def time(self) -> FloatArray:
        """Time of each sample [n] [s], from 0."""
        return self.dt * np.arange(self.npts, dtype=np.float64)


def make_record(
    id: str,
    acceleration: ArrayLike,
    dt: float,
    *,
    path: str = "",
    event: str = "",
    station: str = "",
    component: str = "",
    processing_history: tuple[Message | str, ...] = (),
    azimuth: float | None = None,
    distance: float | None = None,
    earthquake: Earthquake = NO_EARTHQUAKE,
    site: StationSite = NO_STATION_SITE,
    longest_period: float | None = None,
    start: str = "",
    warnings: Sequence[Message | None] = (),
) -> Record:
    """Make a record, checked, with a read-only copy of the acceleration.

    Parameters
    ----------
    id : short name
    acceleration : of the ground [n] [m/s2]
    dt : time step [s]
    path, event, station, component, processing_history, azimuth, distance, earthquake, site, longest_period, start,
        warnings : as in `Record`; None among the warnings is dropped

    Raises
    ------
    RecordError : fewer than two samples, values not finite or beyond any ground motion, a step that is not positive
    """
    a = np.array(acceleration, dtype=np.float64)
    where = path or f'record "{id}"'
    if a.ndim != 1 or a.size < 2:
        raise RecordError(f"{where}: {a.size} samples of acceleration; a record needs at least two")
    bad = np.flatnonzero(~np.isfinite(a))
    if bad.size:
        raise RecordError(f"{where}: sample {bad[0] + 1} is {a[bad[0]]}; every acceleration must be a finite number")
    beyond = np.flatnonzero(np.abs(a) > STRONGEST)
    if beyond.size:
        raise RecordError(
            f"{where}: sample {beyond[0] + 1} is {a[beyond[0]]:.4g} m/s2, over {STRONGEST:g}; check the unit"
        )
    if not (np.isfinite(dt) and dt > 0):
        raise RecordError(f"{where}: time step {dt} s; it must be positive")
    a.flags.writeable = False
    event_name = event or _designation(earthquake)
    return Record(
        id,
        a,
        float(dt),
        path,
        event_name,
        station,
        component,
        processing_history,
        azimuth,
        distance,
        earthquake,
        site,
        longest_period=longest_period,
        start=start,
        warnings=tuple(each for each in warnings if each is not None),
    )


def usable_period(low_cut: float | None) -> float | None:
    """Return the longest period [s] that a low cut [Hz] of the source's filter leaves usable; None without one.

    The lowest usable frequency is 1.25 times the corner, as in the NGA database of PEER.
    """
    return 1.0 / (1.25 * low_cut) if low_cut else None


COMPASS = {"N": 0.0, "E": 90.0, "S": 180.0, "W": 270.0}
COMPASS_WORDS = {"NORTH": "N", "EAST": "E", "SOUTH": "S", "WEST": "W", "NS": "N", "SN": "N", "EW": "E", "WE": "E"}
VERTICAL_NAMES = {"UP", "U", "V", "Z", "UD", "DU", "VERT", "VERTICAL", "DOWN", "DWN", "DN"}
QUADRANT = re.compile(r"([NS])(\d{1,2})([EW])")
DEGREES = re.compile(r"(\d{1,3})(?:DEG)?")
SIGNED = re.compile(r"-\s*[\d-]")  # a hyphen before a digit or another is a sign, or damage
CHANNEL = re.compile(r"[A-Z][A-Z]([NEZ])")  # SEED: band, instrument, orientation
NUMBERED = re.compile(r"([A-Z-]+)[12]")  # KiK-net: 1 in the borehole, 2 at the surface


def azimuth_of(component: str) -> float | None:
    """Return the direction of positive motion of `component`, clockwise from north [rad].

    None if it is vertical, reversed or unknown. Understood are degrees ("360", "90 DEG"), quadrants ("N28W"), letters
    ("E", "EW", "E-W", "EW2": each positive towards north or east) and SEED channels ("HNE"; SEED manual 2.4, appendix
    A).
    """
    if component.lstrip().startswith("-") or SIGNED.search(component):
        return None
    name = _orientation_name(component)
    quadrant, degrees = QUADRANT.fullmatch(name), DEGREES.fullmatch(name)
    if quadrant and float(quadrant[2]) <= 90.0:
        return radians(_from_quadrant(quadrant[1], float(quadrant[2]), quadrant[3]))
    if degrees:
        return radians(float(degrees[1]) % 360.0) if float(degrees[1]) <= 360.0 else None
    letter = COMPASS_WORDS.get(name, name)
    return radians(COMPASS[letter]) if letter in COMPASS else None


def is_vertical(component: str) -> bool:
    """Return whether `component` is named as a vertical one ("UP", "U-D", "UD2", "HNZ")."""
    return _orientation_name(component) in VERTICAL_NAMES


def _designation(earthquake: Earthquake) -> str:
    """Return what an earthquake without a name is called: "2018-01-24 10:51, M6.2, 41.00N 142.50E", as far as known.

    A time alone stays as it is, ISO 8601.
    """
    magnitude, north, east = earthquake.magnitude, earthquake.latitude, earthquake.longitude
    size = "" if magnitude is None else f"M{magnitude:.3g}"
    place = "" if north is None or east is None else f"{_degrees_towards(north, 'NS')} {_degrees_towards(east, 'EW')}"
    if not (size or place):
        return earthquake.time
    when = earthquake.time[:16].replace("T", " ").removesuffix("Z")
    return ", ".join(part for part in (when, size, place) if part)


def _degrees_towards(degrees: float, sides: str) -> str:
    return f"{abs(degrees):.2f}{sides[degrees < 0.0]}"


def _orientation_name(component: str) -> str:
    """Return the name in capitals without blanks and hyphens; the orientation alone of a channel or a numbered name."""
    name = re.sub(r"[\s.-]", "", component.upper())
    found = CHANNEL.fullmatch(name) or NUMBERED.fullmatch(name)
    return found[1] if found and name not in VERTICAL_NAMES else name


def _from_quadrant(start: str, angle: float, towards: str) -> float:
    """Return the azimuth [deg] of "N28W": `angle`, at most 90, from north or south `towards` east or west."""
    clockwise = (start == "N") == (towards == "E")
    return (COMPASS[start] + (angle if clockwise else -angle)) % 360.0
