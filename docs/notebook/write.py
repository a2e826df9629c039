"""Write docs/notebook/first_wall.ipynb again: the cells below, executed, with what they print and draw."""

from __future__ import annotations

from pathlib import Path

import nbformat
from nbclient import NotebookClient
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook

PAGE = Path(__file__).with_name("first_wall.ipynb")

CELLS = (
    """# A first wall in Python

Everything the command line does can be asked from Python: SI floats in, frozen data out. This page is run with the
tests, so what it prints is what the program answers.""",
    """%matplotlib inline
import tempfile
from pathlib import Path

import numpy as np

import assess""",
    """## A wall and the way it rocks

A box of 0.6 x 4.0 x 4.5 m. `"weakest"` looks for the direction of least resistance among the normals of the edges of
its base: across the thickness.""",
    """wall = assess.box(thickness=0.6, length=4.0, height=4.5, density=2000.0)
block = assess.single_block(wall, direction="weakest")
block""",
    """one = block.oscillator
R, alpha = np.hypot(0.3, 2.25), np.arctan(0.6 / 4.5)  # by hand
print(f"p            {one.p:.6f} 1/s    sqrt(3 g / (4 R)) = {np.sqrt(0.75 * assess.g / R):.6f}")
print(f"slenderness  {one.slenderness:.6f} rad    atan(b / h)       = {alpha:.6f}")
print(f"multiplier   {one.multiplier:.6f}        tan(alpha)        = {np.tan(alpha):.6f}")""",
    """## Under a motion of the ground

`read_record` reads the formats of the databases; a motion can also be made of an array. This one is a decaying sine of
1 Hz with a peak of 0.31 g.""",
    """time = 0.005 * np.arange(1600)
shaking = assess.Record(id="decaying sine", acceleration=3.1 * np.sin(2 * np.pi * time) * np.exp(-0.3 * time), dt=0.005)
for scale in (1.0, 1.5, 2.0):
    motion = assess.respond(block, shaking, scale=scale)
    print(f"scale {scale}: overturned {motion.overturned}, rotation over overturning {motion.max_ratio:.3f}")""",
    """## Which pulses overturn it

One full sine of each frequency: the least amplitude that overturns, in either polarity.""",
    """pulses = assess.envelope(block, "sine", frequency=np.linspace(0.5, 2.5, 5), amplitude=np.linspace(0.5, 15.0, 59))
for frequency, amplitude in zip(pulses.frequency, pulses.lower_bound, strict=True):
    print(f"{frequency:.1f} Hz  {amplitude / assess.g:.2f} g")""",
    """## What the codes say

The same rules as for a project: what lacks an input is not answered, and says what to give.""",
    """target = assess.spectrum("ec8", a_g=0.25 * assess.g, ground_type="C")
for level in ("LC1", None):
    procedures = ["ntc2018-linear", "ntc2018-nonlinear"]
    for check in assess.answers(block, target, procedures=procedures, knowledge_level=level):
        print(f"{level!s:5} {check.procedure:18} {check.limit_state} {check.verdict.value:13} {check.reason.text}")""",
    """## Fifty records to a fragility in eight lines

The records are artificial ones, made for a spectrum of EN 1998-1, so that nobody's data are copied here; with recorded
motions the fourth line is `assess.read_records` or `assess.select_records`. A motion that overturned has no largest
ratio, and is counted in no mean.""",
    """wall = assess.box(thickness=0.6, length=4.0, height=4.5, density=2000.0)
block = assess.single_block(wall, direction="weakest")
target = assess.spectrum("ec8", a_g=0.25 * assess.g, ground_type="C")
records = assess.artificial_records(target, count=50, duration=10.0)
table = assess.respond(block, records).table()
print(table[["scale", "max_ratio", "impacts"]].describe().round(3))
found = assess.fragility(block, records, measures=["pga"])
assess.plot(found)""",
    """## A project, its tables and its report

`assess new DIR` writes the project of a garden wall. A `Run` gives its tables as pandas
DataFrames and its figures as matplotlib figures.""",
    """from assess.examples import copy_example

folder = Path(tempfile.mkdtemp())
copy_example("single_wall", folder / "wall")
run = assess.run(assess.load(folder / "wall" / "project.toml"))
run""",
    """run.table("parameters")[["mechanism", "branch", "p_eq_per_s", "slenderness_rad", "uplift_multiplier"]]""",
    """run.figure("capacity", mechanism="wall")""",
    """report = assess.write_report(run, folder / "out")
print(sorted(path.name for path in report.parent.iterdir() if not path.name.startswith(".")))""",
)


def notebook() -> nbformat.NotebookNode:
    """Return the notebook without what its cells print."""
    made = new_notebook(metadata={"kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"}})
    for number, text in enumerate(CELLS):
        code = not text.startswith("#") or text.startswith("%")
        made.cells.append((new_code_cell if code else new_markdown_cell)(text, id=f"cell-{number}"))
    return made


def execute(made: nbformat.NotebookNode) -> nbformat.NotebookNode:
    """Run every cell in a kernel of this Python, and return the notebook with what they print and draw."""
    NotebookClient(made, timeout=300, kernel_name="python3", record_timing=False).execute()
    return made


if __name__ == "__main__":
    nbformat.write(execute(notebook()), PAGE)
