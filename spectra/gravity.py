"""Standard gravity, by which accelerations, weights and units are stated in g."""

g = 9.80665
"""Standard acceleration of free fall [m/s2], exact: 3rd CGPM, 1901."""
