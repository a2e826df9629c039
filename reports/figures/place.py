"""The place of one mechanism in the building."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from reports.figures.building import Building, moved_by
from reports.figures.key_plan import draw_lines, paint_building, scene_points
from reports.figures.projection import Room, draw_arrow, fit_camera, scene_sheet
from reports.figures.sight import project_faces, visible_middle
from reports.figures.style import HALF, report_style
from reports.figures.view import direction_arrow
from reports.language.locale import Locale

ROOM = Room(wide=HALF, tall=2.3, left=0.7, around=0.1)


def draw(building: Building, mechanism: str, locale: Locale) -> Figure:
    """Draw all bodies grey, the part that a mechanism moves in the colour of its verdict, and its direction.

    Where bodies have no common position, those of the mechanism alone. Raises ValueError for one without geometry.
    """
    place = next((k for k, each in enumerate(building.moving) if mechanism in each.names), None)
    if place is None:
        raise ValueError(f'mechanism "{mechanism}" has no geometry that can be drawn in space')
    moving, shown = building.moving[place], moved_by(building, place)
    corners, points = building.surface.corners[moving.triangles].reshape(-1, 3), scene_points(shown, [moving])
    arrow = direction_arrow(corners, moving.direction, 0.6 * float(np.ptp(points, axis=0).max()))
    for direction in (building.direction, -building.direction):
        camera = fit_camera(direction, np.concatenate([points, arrow]), ROOM)
        before, owner = project_faces(shown.surface, shown.owner, camera)
        if visible_middle(before.faces[owner == place], before) is not None:
            break
    with report_style():
        figure, axes = scene_sheet(camera, HALF, locale)
        paint_building(axes, shown, camera, {place: moving})
        draw_lines(axes, moving, camera, before)
        draw_arrow(axes, camera.project(arrow), width=1.4)
        return figure
