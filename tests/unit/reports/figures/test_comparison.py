"""What stands beside the lines of the comparison."""

from __future__ import annotations

from reports.figures.comparison import line_labels


def test_long_labels_are_folded() -> None:
    assert line_labels({"m": "Apse from the window, crack at 45 deg"}) == ["Apse from the window,\ncrack at 45 deg"]


def test_labels_that_look_alike_when_shortened_give_way_to_the_names() -> None:
    long = "The wall of the northern transept above the vault, "
    assert line_labels({"left": long + "left", "right": long + "right", "gable": "Gable"}) == ["left", "right", "Gable"]


def test_hostile_labels_stay_text() -> None:
    assert line_labels({"m": "$x$\x07 <b>"}) == ["$x$⟨U+0007⟩ <b>"]
