"""The figure of a thing that a Python session holds: a motion, a record, a mechanism, a map of pulses, a building."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from assess.dynamics.pulses import Envelope
from assess.errors import AssessError
from assess.model.structure import Structure
from assess.results import HistoryTrace
from assess.results.fragility import FragilityCurve, FragilityResults, MechanismFragility
from assess.study.block import Block
from assess.study.drawing import simplify_surfaces
from assess.study.envelopes import envelope_result
from assess.study.ground_motion import spectrum_result
from assess.study.mechanism_results import mechanism_result
from assess.study.motions import Motions
from assess.study.response import RockingResponse
from records.record import Record
from records.response import response_spectrum
from reports.figures import style
from reports.figures.capacity import draw_capacity
from reports.figures.fragility import draw_fragility, draw_states, draw_states_of_each
from reports.figures.key_plan import KEY_PLAN_SIZE, SHARP_ANGLE
from reports.figures.projection import Appearance, TriangleSurface, fit_camera, paint_bodies, scene_sheet
from reports.figures.rocking import RotationCourse, draw_course, draw_envelope
from reports.figures.spectrum import (
    SHORTEST_PERIOD,
    draw_design_spectrum,
    draw_record_spectra,
    frame_logarithmic_spectra,
)
from reports.language.locale import Locale
from reports.language.texts import say
from spectra.gravity import g
from spectra.spectrum import Spectrum

LONGEST_PERIOD = 5.0  # s
VIEWED_ALONG = np.array([0.0, -1.0, 0.0])


def draw_figure(thing: Any, locale: Locale) -> Figure:
    """Draw a thing of one of the kinds in `DRAWINGS`.

    Parameters
    ----------
    thing : to be drawn
    locale : of the labels

    Raises
    ------
    AssessError : it is of no such kind, nor a list of one in `LISTS`; the text lists them
    """
    several = isinstance(thing, list | tuple | Motions)
    if several and len(thing):
        for kind, (_, draw) in LISTS.items():
            if all(isinstance(each, kind) for each in thing):
                return draw(thing, locale)
    for kind, (_, draw) in DRAWINGS.items():
        if isinstance(thing, kind):
            return draw(thing, locale)
    known = ", ".join(name for name, _ in DRAWINGS.values())
    lists = ", ".join(name for name, _ in LISTS.values())
    raise AssessError(
        f"{type(thing).__name__}: there is no figure of it; give {known}, or a list of {lists}; or call figure(…) of "
        "a run"
    )


def draw_motion(motion: RockingResponse, locale: Locale) -> Figure:
    """Draw the acceleration of the ground [g] and rotation / phi_ov [-] of a motion over time [s]."""
    limit = np.where(motion.rotation < 0.0, motion.limits[-1], motion.limits[0])
    trace = HistoryTrace(
        tuple(motion.time.tolist()), tuple(motion.rotation.tolist()), tuple((motion.acceleration / g).tolist())
    )
    if motion.max_rotation is None or motion.time_of_max is None:
        largest = None
    else:
        largest = motion.time_of_max, float(np.copysign(motion.max_ratio, motion.max_rotation))
    course = RotationCourse(
        motion.rotation / limit, largest, motion.overturning_time, two_sided=len(motion.limits) == 2
    )
    return draw_course(trace, course, None, locale)


def draw_record(record: Record, locale: Locale) -> Figure:
    """Draw the acceleration of a record [g] over time [s], and its spectrum at 5 % damping [g] over period [s]."""
    shortest = max(SHORTEST_PERIOD, record.dt)
    period = np.geomspace(shortest, LONGEST_PERIOD, 200)
    with style.report_style():
        figure = style.sheet(3.4, locale)
        above, below = figure.subplots(2, 1, height_ratios=(1.2, 1))
        time = record.dt * np.arange(record.npts)
        above.plot(time, record.acceleration / g, color=style.INK, linewidth=0.6)
        above.set_title(style.record_label(record.id, 90))
        above.set_xlabel(locale.heading(say("time t"), "time"))
        above.set_ylabel(locale.heading(say("acceleration"), "ground acceleration"))
        above.set_xlim(time[0], max(time[-1], record.dt))
        below.plot(period, response_spectrum(record, period) / g, color=style.INK, linewidth=1.2)
        frame_logarithmic_spectra(below, LONGEST_PERIOD, locale)
        below.set_ylabel(locale.heading(say("Sₐ, damping 5 %"), "ground acceleration"))
        return figure


def draw_motions(motions: Sequence[RockingResponse], locale: Locale) -> Figure:
    """Draw rotation / phi_ov [-] of several motions over time [s]; those that overturn in another colour."""
    with style.report_style():
        figure = style.sheet(2.6, locale)
        axes = figure.subplots()
        for motion in motions:
            limit = np.where(motion.rotation < 0.0, motion.limits[-1], motion.limits[0])
            colour = style.FAIL if motion.overturned else style.INK
            axes.plot(motion.time, motion.rotation / limit, color=colour, linewidth=0.6)
        axes.set_xlabel(locale.heading(say("time t"), "time"))
        axes.set_ylabel(locale.heading(say("rotation φ / φₒᵥ"), "ratio"))
        axes.set_xlim(0.0, max(float(motion.time[-1]) for motion in motions))
        return figure


def draw_records(records: Sequence[Record], locale: Locale) -> Figure:
    """Draw the spectra of several records at 5 % damping [g] over period [s]."""
    period = np.geomspace(max(SHORTEST_PERIOD, *(record.dt for record in records)), LONGEST_PERIOD, 200)
    ordinates = np.array([response_spectrum(record, period) for record in records]) / g
    return draw_record_spectra([style.record_label(record.id, 40) for record in records], period, ordinates, locale)


def draw_block(block: Block, locale: Locale) -> Figure:
    """Draw the moment and the multiplier of a mechanism over rotation."""
    starting = block.mechanism.variants.starting
    return draw_capacity(mechanism_result(block.mechanism, starting, equation=block.equation), locale)


def draw_mechanism_fragility(found: MechanismFragility, locale: Locale) -> Figure:
    """Draw the shares of every state of a mechanism [%] over its primary measure."""
    return draw_states_of_each({found.label: _primary_curves(found)}, locale)


def draw_all_fragilities(found: FragilityResults, locale: Locale) -> Figure:
    """Draw the shares of every state of each mechanism [%] over its primary measure."""
    curves = {each.label: _primary_curves(each) for each in found.mechanisms}
    if not curves:
        raise AssessError("fragility: no mechanism of it has histories, so there is nothing to draw")
    return draw_states_of_each(curves, locale)


def draw_structure(structure: Structure, locale: Locale) -> Figure:
    """Draw the parts of a building: walls and other plates in one colour, the rest grey."""
    if not structure.parts:
        raise AssessError("structure: it has no part, so there is nothing to draw")
    solids = [(part.solid.vertices, part.solid.triangles, int(part.is_plate)) for part in structure.parts]
    surfaces = simplify_surfaces(solids)
    starts = np.cumsum([0, *(len(vertices) for vertices, _, _ in surfaces[:-1])])
    vertices = np.concatenate([vertices for vertices, _, _ in surfaces])
    triangles = np.concatenate([own + start for (_, own, _), start in zip(surfaces, starts, strict=True)])
    owner = np.repeat([plate for _, _, plate in surfaces], [len(own) for _, own, _ in surfaces])
    camera = fit_camera(VIEWED_ALONG, vertices, KEY_PLAN_SIZE)
    with style.report_style():
        figure, axes = scene_sheet(camera, style.WIDTH, locale)
        appearance = Appearance({0: style.FIXED, 1: style.shade(0)}, {}, SHARP_ANGLE)
        paint_bodies(axes, TriangleSurface(vertices, triangles), owner, camera, appearance)
        return figure


DRAWINGS: dict[type, tuple[str, Callable[[Any, Locale], Figure]]] = {
    RockingResponse: ("a motion", draw_motion),
    Record: ("a record", draw_record),
    Spectrum: ("a spectrum", lambda thing, locale: draw_design_spectrum(spectrum_result(thing), locale)),
    Block: ("a mechanism", draw_block),
    Envelope: ("an envelope", lambda thing, locale: draw_envelope(envelope_result(thing, None), (), locale)),
    FragilityResults: ("a fragility", draw_all_fragilities),
    MechanismFragility: ("that of one mechanism", draw_mechanism_fragility),
    FragilityCurve: ("one of its curves", draw_fragility),
    Structure: ("a building", draw_structure),
}
"""What can be drawn: its name for a message, and how."""


LISTS: dict[type, tuple[str, Callable[[Any, Locale], Figure]]] = {
    RockingResponse: ("motions", draw_motions),
    Record: ("records", draw_records),
    FragilityCurve: ("curves of a fragility", draw_states),
}
"""What can be drawn together: its name for a message, and how."""


def _primary_curves(found: MechanismFragility) -> list[FragilityCurve]:
    return [each for each in found.curves if each.measure == found.measures[0]]
