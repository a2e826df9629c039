"""The smallest project of a brick wall; what a test adds to its mechanism follows the text at once."""

WALL = """
[materials.brick]
density = 1800
[bodies.wall]
material = "brick"
box = { thickness = 0.6, length = 3.0, height = 4.0 }
[site.spectrum]
code = "asce7-16"
s_ds = "0.5 g"
s_d1 = "0.2 g"
t_l = "6 s"
[mechanisms.wall]
kind = "single-block"
blocks = ["wall"]
"""
