"""What a definition may hold: names that are chosen from, and ranges. Project files and plain data share them."""

from __future__ import annotations

RESTITUTIONS = ("thesis", "housner", "sorrentino", "momentum")
CRACKS = ("sorrentino", "minimum")
MOST_VOUSSOIRS = 80  # of an arch: all choices of four of its joints are looked at, which takes seconds
INERTIA_RATIOS = (1e-4, 1e4)  # I_O / (M R^2) = g / (p^2 R): 4/3 of a slender block, less of a wall that spans
