"""Fragility curves in the formats of other programs."""
