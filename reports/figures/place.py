"""The place of one mechanism in the building."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from assess.results import MechanismResult, Results
from reports.figures.building import building_of, moved_by
from reports.figures.key_plan import draw_lines, paint_building, scene_points
from reports.figures.projection import INCH, Room, draw_arrow, draw_triad, fit_camera
from reports.figures.scale_bar import round_length, write_arm
from reports.figures.sight import project_faces, visible_middle
from reports.figures.style import HALF, bare_sheet, report_style
from reports.figures.view import direction_arrow
from reports.language.locale import Locale

ROOM = Room(wide=HALF, tall=2.3, left=0.7, around=0.1)


def draw(results: Results, mechanism: MechanismResult, locale: Locale) -> Figure:
    """Draw all bodies grey, the part that a mechanism moves in the colour of its verdict, and its direction.

    Where bodies have no common position, those of the mechanism alone. Raises ValueError for one without geometry.
    """
    building = building_of(results)
    movings = () if building is None else building.moving
    place = next((k for k, each in enumerate(movings) if mechanism.name in each.names), None)
    if building is None or place is None:
        raise ValueError(f'mechanism "{mechanism.name}" has no geometry that can be drawn in space')
    moving, shown = building.moving[place], moved_by(building, place)
    corners = building.surface.corners[moving.triangles].reshape(-1, 3)
    reach = float(np.ptp(scene_points(shown, [moving]), axis=0).max())
    arrow = direction_arrow(corners, moving.direction, 0.6 * reach)
    points = np.concatenate([scene_points(shown, [moving]), arrow])
    camera, (wide, high) = fit_camera(building.direction, points, ROOM)
    faces, owner = project_faces(shown.surface, shown.owner, camera)
    if visible_middle(faces[owner == place], faces) is None:  # from the other side
        camera, (wide, high) = fit_camera(-building.direction, points, ROOM)
        faces, _ = project_faces(shown.surface, shown.owner, camera)
    with report_style():
        figure = bare_sheet(high, locale, width=HALF)
        axes = figure.add_axes((0.5 * (1.0 - wide / HALF), 0.0, wide / HALF, 1.0))
        axes.set(xlim=(0.0, wide * INCH), ylim=(0.0, high * INCH))
        axes.set_axis_off()
        paint_building(axes, shown, camera, {place: moving})
        draw_lines(axes, moving, camera, faces)
        draw_arrow(axes, *camera.project(arrow)[:, :2], width=1.4)
        arm = round_length(0.3 / camera.scale, locale)
        draw_triad(axes, camera, at=(1.0, 10.0), arm=arm)
        write_arm(axes, arm, at=(1.0, 2.0), locale=locale)
        return figure
