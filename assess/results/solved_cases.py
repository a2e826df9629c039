"""What each solved case of the program exercises, in one table of words, and which cases concern a project.

The words are those of the project file where it has one.
"""

from __future__ import annotations

import tomllib
from collections.abc import Collection, Mapping
from functools import cache
from pathlib import Path

from assess.messages.message import Term

CASES = Path(__file__).parents[1] / "verification" / "cases"
"""The folder of the program's solved cases, one TOML file for each; project files stand beside them."""
OF_A_CASE = frozenset({"source", "solver", "quantities"})
"""Keys of which a case has one and a project file none."""
KINDS = frozenset({"single-block", "two-block", "four-hinge", "arch", "equivalent-block"})
JOINTS = frozenset({"rigid", "crushing", "flexible", "semi-flexible", "flexible-thesis"})
ORDINARY = KINDS - {"arch"} | JOINTS - {"flexible-thesis"} | {"box", "exact", "linearised", "free motion"}
"""What so many cases exercise that it says little to share it."""


@cache
def exercised_by_case() -> Mapping[str, frozenset[str]]:
    """Return what each of the program's cases exercises, by key, read once in a process."""
    found = {}
    for path in sorted(CASES.rglob("*.toml")):
        text = path.read_text(encoding="utf-8")
        if "quantities" in text:  # a third of the files are projects, and parsing takes long
            content = tomllib.loads(text)
            if OF_A_CASE & content.keys():
                found[path.relative_to(CASES).with_suffix("").as_posix()] = frozenset(content["uses"])
    return found


def keys_for(exercised: Mapping[str, Collection[str]], uses: Collection[str]) -> frozenset[str]:
    """Return the keys of the cases that concern a project.

    A case is chosen where it shares with the project anything but what is ordinary, such as a procedure, a spectrum, a
    motion or a load; where it exercises a kind of mechanism of the project with one of its kinds of joint, and nothing
    out of the ordinary that the project does not use; or where no case chosen so far exercises what it shares.

    Parameters
    ----------
    exercised : by each case, by key
    uses : of the project; both in the words of `assess.results.solved_cases`
    """
    used = frozenset(uses)
    chosen = {key for key, words in exercised.items() if _concerns(frozenset(words), used)}
    bare = used.difference(*(exercised[key] for key in chosen))
    return frozenset(chosen | {key for key, words in exercised.items() if not bare.isdisjoint(words)})


def _concerns(exercised: frozenset[str], used: frozenset[str]) -> bool:
    both, particular = exercised & used, exercised - ORDINARY
    return bool(particular & used) or (bool(both & KINDS and both & JOINTS) and not particular)


USES: Mapping[str, Term] = {
    # mechanisms
    "single-block": Term("one block that rocks about its base"),
    "two-block": Term("a wall held at base and top that opens at a crack between"),
    "four-hinge": Term("three blocks between two fixed hinges"),
    "arch": Term("an arch whose hinges are where it resists least"),
    "equivalent-block": Term("a mechanism by its rocking parameters"),
    "one-sided": Term("rocking in one direction only, with rebound"),
    "free motion": Term("free rocking and its impacts"),
    # geometry
    "mesh": Term("a body from a mesh"),
    "profile": Term("a body extruded from a polygon"),
    "box": Term("a body that is a box"),
    "cut": Term("a body cut at an elevation or along an inclined crack"),
    # where a wall cracks, and what an impact leaves
    "crack sorrentino": Term("the height of the crack by the rule of Sorrentino"),
    "crack minimum": Term("the height of the crack of the least multiplier"),
    "restitution housner": Term("Housner’s restitution of one block (thesis 3.44)"),
    "restitution sorrentino": Term("restitution about the new base hinge of a cracked wall (thesis 3.46)"),
    "restitution one-sided": Term("rebound of one-sided rocking (thesis 3.45)"),
    "restitution momentum": Term("the restitution from the balance of momentum with all masses"),
    # joints
    "rigid": Term("rigid joints"),
    "crushing": Term("crushing of a joint at its strength"),
    "flexible": Term("flexible joints without tension"),
    "semi-flexible": Term("flexible joints, with the inertia about a fixed hinge"),
    "flexible-thesis": Term("flexible joints, with the inertia about the resultant"),
    "rectangle": Term("a rectangular contact"),
    "hollow_rectangle": Term("a hollow rectangular contact"),
    "circle": Term("a circular contact"),
    "annulus": Term("a contact that is a ring"),
    "polygon": Term("a polygonal contact"),
    "outline": Term("a contact with the outline of the mesh"),
    # loads
    "mass": Term("a point mass that moves with the mechanism"),
    "force": Term("a given force"),
    "tie": Term("a tie of given force"),
    "overburden": Term("a load on the top of a cracked wall"),
    "body": Term("a floor, roof or vault that bears on a block"),
    # motion
    "exact": Term("the exact equation of motion"),
    "linearised": Term("the linearised equation of motion"),
    "pulses": Term("pulses and overturning envelopes"),
    "records": Term("records read from files"),
    "synthetic": Term("artificial records"),
    "scaling": Term("records scaled to a spectrum"),
    "selection": Term("records selected out of many"),
    "response spectrum": Term("response spectra of records"),
    "amplification srss": Term("the motion at height by the first mode, SRSS"),
    "amplification srss-relative": Term("the motion at height by the first mode, relative motion by SRSS"),
    "amplification modal-filter": Term("the motion at height through the first mode"),
    "amplification ec8": Term("the floor factor of EN 1998-1"),
    "amplification ec8-resonance": Term("the floor factor of EN 1998-1 in resonance"),
    "amplification ec8-printed": Term("the floor factor as the thesis prints it"),
    "amplification nzs1170.5": Term("the floor factor of NZS 1170.5"),
    # site
    "asce7-05": Term("spectrum of ASCE 7-05"),
    "asce7-10": Term("spectrum of ASCE 7-10"),
    "asce7-16": Term("spectrum of ASCE 7-16"),
    "ec8": Term("spectrum of EN 1998-1"),
    "nzs1170.5": Term("spectrum of NZS 1170.5"),
    "ntc2008": Term("spectrum of NTC 2008"),
    "ntc2018": Term("spectrum of NTC 2018"),
    "hazard over return periods": Term("the hazard of a site at the return period of a limit state"),
    "table": Term("a spectrum given as a table"),
    # procedures
    "asce43-05-spectrum": Term("ASCE 43-05, by spectrum"),
    "asce43-05-spectrum-thesis": Term("ASCE 43-05, by spectrum, as the thesis reads it"),
    "asce43-05-history": Term("ASCE 43-05, by histories"),
    "asce43-05-sliding": Term("ASCE 43-05, sliding"),
    "dmi2008-linear": Term("Italian Guidelines with NTC 2008, linear"),
    "dmi2008-nonlinear": Term("Italian Guidelines with NTC 2008, non-linear"),
    "dmi2008-nonlinear-thesis": Term("Italian Guidelines with NTC 2008, non-linear, as the thesis reads it"),
    "dmi2008-history": Term("Italian Guidelines with NTC 2008, by histories"),
    "ntc2018-linear": Term("NTC 2018, linear"),
    "ntc2018-nonlinear": Term("NTC 2018, non-linear"),
    "ntc2018-history": Term("NTC 2018, by histories"),
    "nzsee2017-face-loaded": Term("NZSEE 2017, face-loaded walls"),
    "asce41-13-ht": Term("ASCE 41-13, limits of slenderness"),
    "ec8-element": Term("EN 1998-1, non-structural elements"),
    "sliding": Term("sliding by friction"),
    # beyond one answer
    "uncertainty": Term("answers under uncertain numbers"),
    "sensitivity": Term("answers under one number that varies"),
    "fragility": Term("fragility curves"),
    "risk": Term("annual rates from fragility and hazard"),
}
"""Each word with what it is."""
