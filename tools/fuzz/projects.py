"""Small projects that are read in a few hundredths of a second, one for each way to write a mechanism."""

from __future__ import annotations

SITE = """
[site.spectrum]
code = "ec8"
a_g = "0.25 g"
ground_type = "B"
[materials.stone]
density = "2000 kg/m^3"
young_modulus = "2 GPa"
compressive_strength = "1.5 MPa"
friction = 0.5
"""
BODIES = """
[bodies.wall]
material = "stone"
box = { thickness = "0.6 m", length = "4 m", height = "4.5 m" }
[bodies.floor]
material = "stone"
box = { thickness = 3, length = 4, height = 0.1, base = [1.5, 0, 4.5] }
"""
ONE = f"""title = "Boundary wall"
engineer = "E. N. Gineer"
{SITE}{BODIES}
[mechanisms.overturning]
label = "Façade"
kind = "single-block"
blocks = ["wall"]
direction = [1, 0, 0]
cut = "0.5 m"
interface = {{ model = "flexible", stiffness = "10 GPa/m", strength = "1 MPa" }}
loads = [
    {{ kind = "mass", mass = "1200 kg", at = [0.2, 0, 4.5], bearing = true }},
    {{ kind = "tie", at = [0, 0, 4], direction = [-1, 0, 0], force = "5 kN", strength = "20 kN" }},
]
"""
TWO = f"""{SITE}{BODIES}
[building]
height = "9 m"
storeys = 3
[mechanisms.between]
kind = "two-block"
blocks = ["wall"]
direction = [1, 0, 0]
crack = "2.5 m"
base_elevation = "3 m"
restitution = 0.8
loads = [{{ kind = "overburden", force = "20 kN", eccentricity = "0.05 m" }}]
[mechanisms.published]
kind = "equivalent-block"
p = "1.60 1/s"
uplift = 0.14
radius = "2.84 m"
sides = "one"
restitution = {{ positive = 0.8, negative = 0.7 }}
"""
FOUR = """
[materials.stone]
density = "2200 kg/m^3"
[bodies.left]
material = "stone"
box = { thickness = "0.5 m", length = "1 m", height = "3 m" }
[bodies.right]
material = "stone"
box = { thickness = "0.5 m", length = "1 m", height = "3 m", base = [4, 0, 0] }
[bodies.beam]
material = "stone"
length = "1 m"
profile = [[-0.25, 3], [4.25, 3], [4.25, 3.5], [-0.25, 3.5]]
[bodies.lamp]
mass = "100 kg"
centroid = [2.0, 3.7]
inertia = 3.0
[mechanisms.frame]
kind = "four-hinge"
blocks = ["left", ["beam", "lamp"], "right"]
hinges = { A = [0.25, 0], B = [-0.25, 3], C = [3.75, 3], D = [4.25, 0] }
sides = "one"
"""
NTC = """title = "Torre"
client = "Comune"
[site]
pga = "0.2 g"
[site.spectrum]
code = "ntc2018"
a_g = "0.15 g"
f_0 = 2.45
t_c_star = "0.3 s"
soil = "C"
topography = "T2"
damping = 0.05
[verdict]
basis = "ntc2018"
limit_state = "SLV"
survey_tolerance = "20 mm"
[building]
use_class = "III"
[procedures.ntc2018]
knowledge_level = "LC1"
[materials.stone]
density = "1900 kg/m^3"
[bodies.tower]
material = "stone"
box = { thickness = 3, length = "2.5 m", height = "12 m" }
[mechanisms.tower]
kind = "single-block"
blocks = ["tower"]
direction = "sweep"
[analysis]
levels = ["0.1 g", "0.2 g"]
procedures = ["ntc2018-linear", "sliding"]
[report]
units = "US"
language = "it"
paper = "A4"
detail = "full"
client = "Comune"
coordinates = [42.35, 13.15]
date = 2024-06-14
revisions = [{ number = 0, date = "May", description = "first", author = "A" }]
seismic_zone = 2
building_type = "church"
absent = ["porch", 7]
not_examined = { bell-cell = "no access" }
"""
MESH = """
[materials.stone]
density = 2240
[bodies.wall]
material = "stone"
mesh = "%s"
%s
[mechanisms.wall]
kind = "single-block"
blocks = ["wall"]
direction = [1, 0, 0]
"""
RUN = """
[site]
limit_state = "DBE"
[site.spectrum]
code = "asce7-16"
s_ds = "0.5 g"
s_d1 = 0.2
t_l = "6 s"
[verdict]
basis = "asce43-05"
procedures = ["asce43-05-spectrum"]
[mechanisms.parapet]
kind = "equivalent-block"
p = 2.4
uplift = 0.2
radius = 1.2
[records]
synthetic = { count = 1, duration = 8, seed = 1 }
[analysis]
levels = ["0.1 g"]
procedures = ["asce43-05-spectrum"]
[analysis.pulses]
frequency = { from = "1 Hz", to = "2 Hz", count = 2 }
amplitude = { from = "0 g", to = "4 g", count = 2 }
"""
WALL = """title = "Wall"
engineer = "E. N. Gineer"
[site.spectrum]
code = "ntc2018"
a_g = "0.20 g"
f_0 = 2.4
t_c_star = "0.3 s"
soil = "B"
topography = "T1"
[site]
limit_state = "SLV"
[verdict]
basis = "ntc2018"
limit_state = "SLV"
[procedures.ntc2018]
knowledge_level = "LC1"
[building]
use_class = "II"
ground_elevation = 0
[materials.stone]
density = "2000 kg/m^3"
disintegration = "excluded"
[bodies.wall]
material = "stone"
box = { thickness = "0.60 m", length = "6.0 m", height = "7.0 m" }
[mechanisms.wall]
kind = "single-block"
blocks = ["wall"]
direction = [1, 0, 0]
sides = "one"
loads = [
  { kind = "force", force = "10 kN", direction = [-1, 0, 0], at = [0.0, 3.5], until = "0.10 m" },
  { kind = "mass", mass = "2500 kg", at = [-0.10, 7.0], seat = "0.20 m" },
]
[analysis]
procedures = ["ntc2018-linear", "ntc2018-nonlinear"]
[report.sources]
"materials.stone.disintegration" = "measured: one opening of the plaster"
"""
VERDICT = WALL.replace('limit_state = "SLV"\n[procedures', """limit_state = "SLV"
procedures = ["ntc2018-nonlinear"]
works = "improvement"
survey_tolerance = "10 mm"
[procedures""").replace("ground_elevation = 0\n", """ground_elevation = 0
limit_states = { SLV = { period = "0.5 s", damping = 0.10, reason = "measured" } }
height = "9 m"
storeys = 3
""")  # fmt: skip
UNCERTAIN = RUN.replace("uplift = 0.2", "uplift = { mean = 0.2, cov = 0.1 }").replace(
    "p = 2.4", 'p = { mean = "2.4 1/s", sd = 0.1, distribution = "normal", group = "a" }\nrestitution = { mean = 0.8, '
    'cov = 0.05, distribution = "uniform" }'
).replace("[analysis.pulses]", "[analysis.uncertainty]\nsamples = 16\nseed = 2\n[analysis.pulses]")  # fmt: skip
HAZARD = """hazard = [
  { return_period = 30, pga = "0.05 g" }, { return_period = 475, pga = "0.16 g" }, { rate = 4e-4, pga = "0.30 g" }
]
"""
FRAGILITY = """
[site.spectrum]
code = "asce7-16"
s_ds = "0.5 g"
s_d1 = 0.2
t_l = "6 s"
[mechanisms.parapet]
kind = "equivalent-block"
p = 4.0
uplift = 0.2
radius = 0.6
[records]
files = ["records/*.AT2"]
[analysis.fragility]
measures = ["pga", "pgv"]
states = ["rocking", 0.5, "overturning"]
method = "ida"
samples = 8
seed = 1
draws = 100
largest_factor = 100
epistemic = { model = 0.2 }
[analysis.risk]
target = 1e-4
%s"""
LOCKED = (
    RUN.replace("synthetic = { count = 1, duration = 8, seed = 1 }\n", "").replace("[records]\n", "")
    + """[records]
files = ["records/*.AT2"]
scale_to = "pga"
"""
)
