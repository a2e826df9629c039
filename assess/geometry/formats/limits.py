"""Limits on what the instances of a scene may multiply into."""

from __future__ import annotations

MAX_INSTANCES = 100_000  # of meshes in a scene
MAX_TRIANGLES = 100_000_000  # of a scene with all its instances
