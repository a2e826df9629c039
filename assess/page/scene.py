"""The drawing of the page: parts by kind, the mechanism that is picked with its blocks, and the plane of its crack."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from itertools import pairwise
from math import atan2, cos, dist, sin
from typing import Any

import numpy as np

from assess.geometry.surface import parallel_sections, simplify
from assess.project.dragged import Crack
from assess.project.key_errors import KeyPath
from assess.project.opened import ShownPart
from assess.project.trials import ShownMechanism
from assess.results import DrawnLoad, MechanismResult, NamedPoint, Place, View
from assess.study.rocking_motion import BlockPlace
from spectra.arrays import FloatArray

Colour = tuple[int, int, int]
KINDS: dict[str, Colour] = {
    "floor": (213, 184, 133), "roof": (190, 140, 110), "vault": (150, 165, 190), "arch": (150, 165, 190),
    "tower": (168, 151, 122), "chimney": (168, 151, 122), "pinnacle": (168, 151, 122), "tie": (60, 60, 60),
}  # fmt: skip
"""Colours of what is no wall; each part has a label too."""
WALL: Colour = (217, 205, 184)
OUTCOMES: dict[str, Colour] = {"pass": (86, 180, 233), "fail": (213, 94, 0), "incomplete": (240, 228, 66)}
UNKNOWN: Colour = (204, 121, 167)
HATCHES: dict[str, tuple[tuple[float, float, float], ...]] = {
    "pass": (), "fail": ((1, 1, 1), (1, 1, -1)), "incomplete": ((1, 1, 1),),
}  # fmt: skip
"""Normals (along, across, up) of the planes whose traces hatch the moving part: crossed, one way, none.

Colours and hatches are told apart without colour vision; the word stands beside them.
"""
UNKNOWN_HATCH = ((0, 0, 1),)
HATCH = 0.06  # spacing, of the mechanism's size
FIXED: Colour = (223, 226, 229)
HINGE: Colour = (0, 0, 0)
LOAD: dict[str, Colour] = {"mass": (107, 76, 154), "force": (107, 76, 154), "tie": (0, 114, 178)}
UNMARKED, MARKED = 0.35, 0.9  # opacity of parts
PART_TRIANGLES = 4000
MOST_LABELS = 40
PLAIN: dict[str, Any] = {"side": "double", "cast_shadow": False, "receive_shadow": False}
AWAY, VIEW = 1.1, (0.62, -0.66, 0.42)  # of the diagonal of what is seen, and from where
LEVEL_KINDS = ("horizontal-arch",)  # whose plane of motion is not upright
ARROW = 0.12  # of the mechanism's size
LABELS_APART = 0.03  # of the mechanism's size: hinges nearer than this have one label


class Drawing:
    """What is drawn in the scene of a server of viser.

    moved : called with a point of the plane [m], its angle in the plane of motion [rad] and whether it is let go
    moved_end : called with the key of an end of a tie, where it is [m], and whether it is let go
    """

    def __init__(
        self,
        viser: Any,
        *,
        moved: Callable[[Sequence[float], float, bool], None],
        moved_end: Callable[[KeyPath, Sequence[float], bool], None],
    ) -> None:
        self._scene, self._camera = viser.scene, viser.initial_camera
        self._moved, self._moved_end = moved, moved_end
        self._parts: list[Any] = []
        self._labels: list[Any] = []
        self._shown: list[Any] = []
        self._frames: dict[int, Any] = {}
        self._plane: Any = None
        self._ends: dict[KeyPath, Any] = {}
        self._ties: list[Any] = []
        self._along = np.array([1.0, 0.0, 0.0])
        self.show_labels = False
        self._scene.configure_default_lights(cast_shadow=False)

    def draw_building(self, parts: Iterable[ShownPart]) -> None:
        """Draw the parts of a building, with a label each."""
        self._clear(self._parts)
        self._clear(self._labels)
        corners = []
        for number, part in enumerate(parts):
            vertices, triangles = simplify(part.solid.vertices, part.solid.triangles, limit=PART_TRIANGLES)
            corners.append(np.array([vertices.min(axis=0), vertices.max(axis=0)]))
            colour = KINDS.get(part.kind, WALL)
            self._parts.append(
                self._scene.add_mesh_simple(
                    f"/parts/{number}", vertices, triangles, color=colour, opacity=UNMARKED, flat_shading=True, **PLAIN
                )
            )
            if number < MOST_LABELS:
                self._labels.append(
                    self._scene.add_label(
                        f"/labels/{number}",
                        f"{part.kind}: {part.name}",
                        position=tuple((vertices.min(axis=0) + vertices.max(axis=0)) / 2.0),
                        visible=self.show_labels,
                    )
                )
        self._look_at(np.concatenate(corners or [np.array([[0.0, 0.0, 0.0], [1.0, 1.0, 1.0]])]))

    def _look_at(self, places: FloatArray) -> None:
        """Let a browser that opens the page see all of these places [k, 3] from a corner."""
        middle = (places.min(axis=0) + places.max(axis=0)) / 2.0
        away = AWAY * float(np.linalg.norm(np.ptp(places, axis=0)))
        self._camera.look_at = tuple(middle)
        self._camera.position = tuple(middle + away * np.array(VIEW))

    def label_parts(self, shown: bool, *, moving: Collection[str] = ()) -> None:
        """Show or hide the labels of the parts, but for those of parts that move in any case."""
        self.show_labels = shown
        for each in self._labels:
            each.visible = shown or each.text.partition(": ")[2] in moving

    def mark_parts(self, places: Iterable[int]) -> None:
        """Mark the parts at these places as those that move in a mechanism without a drawing of its own."""
        chosen = set(places)
        if chosen:
            self._clear(self._shown)
        for number, part in enumerate(self._parts):
            part.opacity = MARKED if number in chosen else UNMARKED

    def draw_mechanism(self, shown: ShownMechanism, *, outcome: str) -> None:
        """Draw a mechanism in the colour and hatching of its outcome.

        Parameters
        ----------
        shown : the mechanism
        outcome : in a word, "pass", "fail", "incomplete", or any other where it is not known
        """
        made: list[Any] = []
        result = shown.result
        if result is not None and result.view is not None:
            made += self._bodies(result.view, outcome)
            made += self._lines(result)
            top = max(result.view.vertices, key=lambda place: place[2])
            made.append(self._scene.add_label("/mechanism/outcome", outcome.upper(), position=top))
        names = {each.name for each in made}
        self._clear([each for each in self._shown if each.name not in names])
        self._shown = made

    def place_plane(self, crack: Crack | None, result: MechanismResult | None) -> None:
        """Put the handle of the crack where it is; None takes it away."""
        if self._plane is not None:
            self._plane.remove()
            self._plane = None
        if crack is None or result is None or result.view is None:
            return
        self._along, size = np.array(result.view.direction), float(max(result.view.size))
        self._plane = self._scene.add_transform_controls(
            "/crack", scale=max(0.4, size / 4.0), active_axes=(crack.turns, False, True), depth_test=False,
            disable_rotations=not crack.turns, position=np.array(crack.point),
            wxyz=quaternion(self._along, crack.angle, crack.aside),
        )  # fmt: skip
        half = 0.6 * size
        corners = np.array([[-half, -half, 0.0], [half, -half, 0.0], [half, half, 0.0], [-half, half, 0.0]])
        self._scene.add_mesh_simple(
            "/crack/plane", corners, np.array([[0, 1, 2], [0, 2, 3]]), color=HINGE, opacity=0.25, **PLAIN
        )

        @self._plane.on_update  # type: ignore[untyped-decorator, unused-ignore]
        async def _(event: Any) -> None:
            plane = event.target
            self._moved(plane.position.tolist(), angle_of(plane.wxyz, self._along), event.phase == "end")

    def move_plane(self, crack: Crack) -> None:
        """Put the handle of the crack elsewhere."""
        if self._plane is not None:
            self._plane.position = np.array(crack.point)
            self._plane.wxyz = quaternion(self._along, crack.angle, crack.aside)

    def place_ties(self, ends: Mapping[KeyPath, Place], result: MechanismResult | None) -> None:
        """Draw ties with a handle at each of their ends, by its key in the file; those of before are taken away."""
        self._clear([*self._ends.values()])
        size = 1.0 if result is None or result.view is None else float(max(result.view.size))
        self._ends = {key: self._handle_of_end(key, at, size) for key, at in ends.items()}
        self._draw_ties()

    def _handle_of_end(self, key: KeyPath, at: Place, size: float) -> Any:
        handle = self._scene.add_transform_controls(
            f"/ties/{key[-2]}-{key[-1]}", scale=max(0.3, size / 6.0), disable_rotations=True, depth_test=False,
            position=np.array(at),
        )  # fmt: skip

        @handle.on_update  # type: ignore[untyped-decorator, unused-ignore]
        async def _(event: Any) -> None:
            self._draw_ties()
            self._moved_end(key, event.target.position.tolist(), event.phase == "end")

        return handle

    def _draw_ties(self) -> None:
        """Draw a line between the handles at both ends of each tie."""
        places = {key: each.position for key, each in self._ends.items()}
        pairs = [
            (at, places[far]) for key, at in places.items() if (far := (*key[:-1], "anchor")) in places and key != far
        ]
        if pairs:
            self._ties = [self._segments("/ties/lines", pairs, LOAD["tie"], 0.03)]
        else:
            self._clear(self._ties)

    def place_blocks(self, places: Sequence[BlockPlace]) -> None:
        """Put the blocks of the mechanism where they are after a rotation; at rest where none is given."""
        for number, frame in self._frames.items():
            at = places[number] if number < len(places) else None
            frame.wxyz = (1.0, 0.0, 0.0, 0.0) if at is None else at.quaternion
            frame.position = (0.0, 0.0, 0.0) if at is None else at.move

    def _bodies(self, view: View, outcome: str) -> list[Any]:
        vertices, triangles, block_of = np.array(view.vertices), np.array(view.triangles), np.array(view.block_of)
        along = np.array(view.direction)
        axes, size = np.array([along, [-along[1], along[0], 0.0], [0.0, 0.0, 1.0]]), float(max(view.size))
        made = []
        for number in np.unique(block_of).tolist():
            moves, name = number >= 0, "/mechanism/fixed"
            used, places = np.unique(triangles[block_of == number], return_inverse=True)
            if moves:
                name = f"/blocks/{number}/body"
                if number not in self._frames:
                    self._frames[number] = self._scene.add_frame(f"/blocks/{number}", show_axes=False)
                corners = vertices[triangles[block_of == number]]
                strokes = [
                    parallel_sections(corners, normal=np.array(each) @ axes, spacing=HATCH * size)
                    for each in HATCHES.get(outcome, UNKNOWN_HATCH)
                ]
                if strokes:
                    made.append(self._segments(f"/blocks/{number}/hatch", np.concatenate(strokes), HINGE, size / 400.0))
            made.append(
                self._scene.add_mesh_simple(
                    name, vertices[used], places.reshape(-1, 3), flat_shading=True,
                    color=OUTCOMES.get(outcome, UNKNOWN) if moves else FIXED, opacity=None if moves else 0.6, **PLAIN,
                )
            )  # fmt: skip
        return made

    def _lines(self, result: MechanismResult) -> list[Any]:
        view, made = result.view, []
        assert view is not None
        size = float(max(view.size))
        made.append(self._segments("/mechanism/hinges", [each.ends for each in view.axes], HINGE, size / 100.0))
        rings = [pair for ring in view.sections for pair in pairwise(ring)]
        made += [self._segments("/mechanism/sections", rings, HINGE, size / 300.0)] if rings else []
        if result.kind in LEVEL_KINDS:
            return made
        middle = _middle_across(view)
        for kind, colour in LOAD.items():
            loads = [each for each in result.drawing.loads if each.kind == kind]
            strokes = [stroke for load in loads for stroke in _arrow(load, view, middle, size)]
            made += [self._segments(f"/mechanism/loads-{kind}", strokes, colour, size / 120.0)] if strokes else []
        for number, (text, at) in enumerate(hinge_labels(result.drawing.hinges, apart=LABELS_APART * size)):
            place = _in_space(at, view, middle)
            made.append(self._scene.add_label(f"/mechanism/hinge-{number}", text, position=place))
        return made

    def _segments(self, name: str, pairs: Any, colour: Colour, thickness: float) -> Any:
        return self._scene.add_line_segments(
            name, np.array(pairs, dtype=np.float64), np.array(colour), thickness=thickness
        )

    @staticmethod
    def _clear(handles: list[Any]) -> None:
        for each in handles:
            each.remove()
        handles.clear()


def quaternion(along: FloatArray, angle: float, aside: float = 0.0) -> tuple[float, float, float, float]:
    """Return the rotation (w, x, y, z) that turns x to a direction, and then tilts its plane by angles [rad].

    A positive angle lets the plane fall towards the direction, a positive one aside to its left.
    """
    yaw = atan2(along[1], along[0])
    a, b, c, d = cos(yaw / 2.0), sin(yaw / 2.0), cos(angle / 2.0), sin(angle / 2.0)
    w, x, y, z = a * c, -b * d, a * d, b * c  # about z by the yaw, times about y by the angle
    e, f = cos(aside / 2.0), sin(aside / 2.0)
    return (w * e + x * f, x * e - w * f, y * e - z * f, z * e + y * f)  # times about x by what is aside, backwards


def angle_of(wxyz: FloatArray, along: FloatArray) -> float:
    """Return by how much the plane of a rotation falls towards a direction, in the vertical plane through it [rad]."""
    w, x, y, z = (float(each) for each in wxyz)
    normal = np.array([2.0 * (x * z + w * y), 2.0 * (y * z - w * x), 1.0 - 2.0 * (x * x + y * y)])
    normal = -normal if normal[2] < 0.0 else normal
    return atan2(float(normal @ along), normal[2])


def hinge_labels(hinges: Sequence[NamedPoint], *, apart: float) -> list[tuple[str, tuple[float, float]]]:
    """Return the names of hinges each with its place, in one label where they lie less than `apart` [m]."""
    found: list[tuple[str, tuple[float, float]]] = []
    for each in hinges:
        near = next((place for place, (_, at) in enumerate(found) if dist(at, each.at) < apart), None)
        if near is None:
            found.append((each.name, each.at))
        else:
            found[near] = (f"{found[near][0]}, {each.name}", found[near][1])
    return found


def _middle_across(view: View) -> float:
    """Return where the middle of the moving bodies lies across the direction [m]."""
    moving = np.array(view.triangles)[np.array(view.block_of) >= 0]
    reach = np.array(view.vertices)[np.unique(moving)] @ [-view.direction[1], view.direction[0], 0.0]
    return float(reach.min() + reach.max()) / 2.0


def _in_space(point: Sequence[float], view: View, middle: float) -> tuple[float, float, float]:
    """Return a place of the plane of motion in space [m]."""
    x, y, _ = view.direction
    return (point[0] * x - middle * y, point[0] * y + middle * x, point[1])


def _arrow(load: DrawnLoad, view: View, middle: float, size: float) -> list[Any]:
    """Return the strokes of an arrow that ends where a load acts, or of a tie that pulls from there."""
    towards = (0.0, -1.0) if load.towards is None else load.towards
    sign = 1.0 if load.kind == "tie" else -1.0
    far = (load.at[0] + sign * ARROW * size * towards[0], load.at[1] + sign * ARROW * size * towards[1])
    strokes = [(load.at, far)]
    for side in (-1.0, 1.0):
        back = (
            load.at[0] - 0.03 * size * (towards[0] + side * towards[1]),
            load.at[1] - 0.03 * size * (towards[1] - side * towards[0]),
        )
        strokes += [] if load.kind == "tie" else [(load.at, back)]
    return [tuple(_in_space(end, view, middle) for end in stroke) for stroke in strokes]
