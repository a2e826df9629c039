"""Shapes of the values that several chapters of the results share."""

from __future__ import annotations

Floats = tuple[float, ...]
Point = tuple[float, float]
Place = tuple[float, float, float]
Ring = tuple[Point, ...]
