"""Fragility: how likely a mechanism is to rock and to overturn, given the strength of the ground motion."""
