"""The key plan: each body once, moving parts numbered and coloured by verdict, bodies without a common place apart."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest
import trimesh
from matplotlib.colors import to_rgb

from assess.codes.verdict import Decision
from assess.results import BodyEdges, MechanismResult, Results, View
from assess.results.mechanism import HingeAxis
from assess.results.provenance import ResolvedValue
from reports.figures import key_plan
from reports.figures.key_plan import building_of, building_of_mechanism
from reports.figures.projection import Hatching, hatch_lines, round_length
from reports.figures.style import FIXED, VERDICT
from reports.language.locale import Locale

Point = tuple[float, float, float]


def wall(at: Point = (0.0, 0.0, 0.0), *, cut: float = 0.0, height: float = 6.0) -> View:
    """Return a wall 0.6 x 3 m; above the cut it moves."""
    low, high = (
        trimesh.creation.box((0.6, 3.0, top - bottom)).apply_translation((at[0], at[1], 0.5 * (top + bottom)))
        for bottom, top in ((0, cut), (cut, height))
    )
    parts = [(high, 0)] if not cut else [(low, -1), (high, 0)]
    vertices = [tuple(vertex) for part, _ in parts for vertex in part.vertices.tolist()]
    triangles, block_of, start = [], [], 0
    for part, block in parts:
        triangles += [(a + start, b + start, c + start) for a, b, c in part.faces.tolist()]
        block_of += [block] * len(part.faces)
        start += len(part.vertices)
    x, y = at[0] + 0.3, at[1]
    ring = tuple((at[0] + dx, y + dy, cut) for dx, dy in ((-0.3, -1.5), (0.3, -1.5), (0.3, 1.5), (-0.3, 1.5)))
    axis = HingeAxis("A", ((x, y - 1.5, cut), (x, y + 1.5, cut)))
    return View(
        tuple(vertices), tuple(triangles), tuple(block_of), (axis,), (ring,) if cut else (), (1.0, 0.0, 0.0),
        (0.6, 3.0, height), len(triangles),
    )  # fmt: skip


def built(results: Results, views: Sequence[tuple[View | None, str]]) -> Results:
    """Return results of mechanisms m1, m2, … with these views of these bodies, that pass, fail and pass again."""
    pattern: MechanismResult = results.mechanisms[0]
    names = [f"m{number}" for number in range(1, len(views) + 1)]
    mechanisms = tuple(replace(pattern, name=name, view=view) for name, (view, _) in zip(names, views, strict=True))
    bodies = {
        f"mechanisms.{name}.blocks": ResolvedValue([[body]], given=True)
        for name, (_, body) in zip(names, views, strict=True)
    }
    assert results.verdict is not None
    answered = results.verdict.mechanisms[0]
    outcomes = [(Decision.PASS, Decision.FAIL)[place % 2] for place in range(len(names))]
    verdicts = tuple(replace(answered, mechanism=n, outcome=o) for n, o in zip(names, outcomes, strict=True))
    return replace(
        results, mechanisms=mechanisms, project=bodies, verdict=replace(results.verdict, mechanisms=verdicts)
    )


def test_a_body_that_two_mechanisms_share_is_drawn_once(results: Results) -> None:
    found = building_of(built(results, [(wall(), "wall"), (wall(cut=4.0), "wall")]))
    assert found is not None
    assert not found.apart
    corners = found.surface.corners
    volume = np.einsum("ki,ki->k", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])).sum() / 6.0
    assert volume == pytest.approx(0.6 * 3.0 * 6.0)
    heights = {
        found.moving_parts[owner].title: found.surface.corners[found.owner == owner][:, :, 2] for owner in (0, 1)
    }
    assert (heights["M2"].min(), heights["M2"].max()) == pytest.approx((4.0, 6.0))
    assert (heights["M1"].min(), heights["M1"].max()) == pytest.approx((0.0, 4.0))


def test_all_of_a_mechanism_is_coloured_at_its_own_place(results: Results) -> None:
    found = building_of(built(results, [(wall(), "wall"), (wall(cut=4.0), "wall")]))
    assert found is not None
    number = next(place for place, each in enumerate(found.moving_parts) if each.title == "M1")
    own = building_of_mechanism(found, number)
    assert set(own.owner.tolist()) == {number}
    assert np.ptp(own.surface.corners[:, :, 2]) == pytest.approx(6.0)


def test_mechanisms_that_move_the_same_share_a_number_and_the_worse_verdict(results: Results) -> None:
    found = building_of(built(results, [(wall(), "wall"), (wall(), "wall")]))
    assert found is not None
    assert [(each.title, each.outcome) for each in found.moving_parts] == [("M1, M2", "fail")]


def test_bodies_in_one_place_stand_apart_and_the_caption_says_so(results: Results) -> None:
    together = built(results, [(wall(), "north"), (wall(height=5.0), "south")])
    found = building_of(together)
    assert found is not None
    assert found.apart
    first, second = (found.surface.vertices[found.surface.triangles[found.group == group]] for group in (0, 1))
    right = np.array([found.direction[0], 0.0, 0.0]) + np.array([0.0, 1.0, 0.0])
    assert (first @ right).max() < (second @ right).min()
    assert "drawn apart" in Locale().text(key_plan.key_plan_caption(found))


def test_walls_at_their_places_stay_there(results: Results) -> None:
    beside = built(results, [(wall(), "north"), (wall((5.0, 0.0, 0.0)), "south"), (wall((0.4, 2.4, 0.0)), "corner")])
    found = building_of(beside)
    assert found is not None
    assert not found.apart
    assert found.surface.vertices[:, 0].max() == pytest.approx(5.3)
    assert "drawn apart" not in Locale().text(key_plan.key_plan_caption(found))


def test_bodies_of_no_mechanism_are_lines_where_all_stand_at_their_places(results: Results) -> None:
    slab = BodyEdges("slab", (((0.0, 0.0, 3.0), (4.0, 0.0, 3.0)), ((4.0, 0.0, 3.0), (4.0, 9.0, 3.0))))
    walls = [(wall(), "north"), (wall((5.0, 0.0, 0.0)), "south")]
    found = building_of(replace(built(results, walls), beside=(slab,)))
    assert found is not None
    assert found.beside.tolist() == [[list(end) for end in edge] for edge in slab.edges]
    lines = [wire for wire in key_plan.model_of_key_plan(found).wires if wire.colour == key_plan.BESIDE]
    assert [wire.points for wire in lines] == list(slab.edges)
    figure = key_plan.draw_key_plan(found, Locale())
    assert key_plan.BESIDE in {line.get_color() for line in figure.axes[0].lines}
    assert "belong to no mechanism" in Locale().text(key_plan.key_plan_caption(found))
    apart = building_of(replace(built(results, [(wall(), "north"), (wall(height=5.0), "south")]), beside=(slab,)))
    assert apart is not None
    assert not apart.beside.size


def test_of_many_mechanisms_only_what_is_seen_of_their_lines_is_drawn(
    results: Results, monkeypatch: pytest.MonkeyPatch
) -> None:
    found = building_of(built(results, [(wall((0.8 * x, 0.0, 0.0), cut=3.0), f"w{x}") for x in range(3)]))
    assert found is not None

    def dotted() -> int:
        lines = key_plan.draw_key_plan(found, Locale()).axes[0].lines
        return sum(line.get_linestyle() == "--" and line.get_linewidth() == 0.5 for line in lines)

    assert dotted() > 0
    monkeypatch.setattr(key_plan, "MOST_SEEN_THROUGH", 2)
    assert dotted() == 0


def test_results_without_geometry_have_no_key_plan(results: Results) -> None:
    bare = built(results, [(None, "wall")])
    assert building_of(bare) is None
    one = building_of(built(results, [(wall(), "wall")]))
    assert one is not None
    with pytest.raises(ValueError, match='mechanism "m7" has no geometry'):
        key_plan.draw_place(one, "m7", Locale())


def test_every_number_and_no_two_on_one_another(results: Results) -> None:
    walls = [(wall((0.8 * x, 3.2 * y, 0.0), cut=3.0), f"w{x}{y}") for x in range(4) for y in range(3)]
    found = building_of(built(results, walls))
    assert found is not None
    figure = key_plan.draw_key_plan(found, Locale())
    figure.draw_without_rendering()
    tags = [text for text in figure.axes[0].texts if text.get_text().startswith("M")]
    assert sorted(tag.get_text() for tag in tags) == sorted(f"M{number}" for number in range(1, 13))
    boxes = [tag.get_window_extent() for tag in tags]
    assert not any(one.overlaps(other) for k, one in enumerate(boxes) for other in boxes[:k])


def test_a_failing_part_is_hatched_and_darker_in_grey() -> None:
    lightness = {name: float(np.dot(to_rgb(colour), (0.299, 0.587, 0.114))) for name, colour in VERDICT.items()}
    assert lightness["fail"] < lightness["pass"] - 0.15 < lightness["incomplete"] - 0.15
    assert set(key_plan.HATCHINGS) == {"fail", "incomplete"}


def test_hatching_lies_within_the_triangle() -> None:
    corners = np.array([[0.0, 0.0], [10.0, 0.0], [0.0, 10.0]])
    lines = hatch_lines(corners, Hatching(2.0, 0.0, "#000000"))
    assert len(lines) >= 5
    assert all((line >= -1e-9).all() and (line.sum(axis=1) <= 10.0 + 1e-9).all() for line in lines)


def test_the_model_has_a_part_for_each_colour_and_names_the_hinges(results: Results) -> None:
    found = building_of(built(results, [(wall(cut=2.0), "a"), (wall((4.0, 0.0, 0.0)), "b")]))
    assert found is not None
    model = key_plan.model_of_key_plan(found)
    assert {part.colour for part in model.parts} == {FIXED, VERDICT["pass"], VERDICT["fail"]}
    assert [wire.name for wire in model.wires if wire.name] == ["M1", "M2"]
    assert sum(wire.dashed for wire in model.wires) == 1


@pytest.mark.parametrize(("near", "system", "length"), [(0.7, "SI", 0.5), (23.0, "SI", 20.0), (0.7, "US", 2 * 0.3048)])
def test_a_scale_is_a_round_number_of_the_unit(near: float, system: str, length: float) -> None:
    assert round_length(near, Locale(system=system)) == pytest.approx(length)  # type: ignore[arg-type]
