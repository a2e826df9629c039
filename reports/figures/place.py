"""The place of one mechanism in the building."""

from __future__ import annotations

from matplotlib.figure import Figure

from assess.results import Results
from reports.figures.building import alone, building_of
from reports.figures.key_plan import draw_lines, paint_building, scene_points
from reports.figures.projection import INCH, Room, draw_triad, fit_camera
from reports.figures.scale_bar import round_length, write_arm
from reports.figures.style import HALF, bare_sheet, report_style
from reports.language.locale import Locale

ROOM = Room(wide=HALF, tall=2.3, left=0.45, around=0.1)


def draw(results: Results, mechanism: str, locale: Locale) -> Figure:
    """Draw all bodies grey, and the part that a mechanism moves in the colour of its verdict.

    mechanism : its name; raises ValueError where it has no geometry. Where bodies have no common position, those of the
    mechanism alone.
    """
    building = building_of(results)
    place = next((k for k, each in enumerate(building.moving) if mechanism in each.names), None) if building else None
    if building is None or place is None:
        raise ValueError(f'mechanism "{mechanism}" has no geometry that can be drawn in space')
    moving = building.moving[place]
    shown = alone(building, moving.group) if building.apart else building
    camera, (wide, high) = fit_camera(building.direction, scene_points(shown, [moving]), ROOM)
    with report_style():
        figure = bare_sheet(high, locale, width=HALF)
        axes = figure.add_axes((0.5 * (1.0 - wide / HALF), 0.0, wide / HALF, 1.0))
        axes.set(xlim=(0.0, wide * INCH), ylim=(0.0, high * INCH))
        axes.set_axis_off()
        paint_building(axes, shown, camera, {place: moving})
        draw_lines(axes, moving, camera)
        arm = round_length(0.3 / camera.scale, locale)
        draw_triad(axes, camera, at=(18.0, 20.0), arm=arm)
        write_arm(axes, arm, at=(1.0, 2.0), locale=locale)
        return figure
