"""Projects that fail, of every basis of the verdict, small enough to be judged in a few hundredths of a second.

Each has what its basis asks for, with a source, so that what it lacks is strength. Whatever is added to one of them
and improves its outcome has to be seen.
"""

from __future__ import annotations

from typing import Any

Tables = dict[str, Any]

ITALY = {"code": "ntc2018", "a_g": "0.25 g", "f_0": 2.4, "t_c_star": "0.3 s", "soil": "B", "topography": "T1"}
AMERICA = {"code": "asce7-16", "s_ds": "1.0 g", "s_d1": "0.5 g", "t_l": "6 s"}
EUROPE = {"code": "ec8", "a_g": "0.25 g", "ground_type": "B"}
ZEALAND = {"code": "nzs1170.5", "z": 0.4, "r": 1.0, "subsoil": "C"}
SURVEY = "measured: survey of 2024"
BOX = {"thickness": "0.4 m", "length": "3 m", "height": "4.5 m"}
WALL = {"material": "stone", "box": BOX}
FLOOR = {"kind": "mass", "mass": "1500 kg", "at": [0.1, 4.5], "seat": "0.12 m"}
LOAD = {"kind": "overburden", "force": "10 kN"}
TIE = {"kind": "tie", "force": "5 kN", "at": [-0.2, 4.0], "anchor": [-5.0, 4.0]}


def _project(basis: str, spectrum: Tables, mechanisms: Tables, **more: Any) -> Tables:
    """Return a project; `more` are tables in place of the usual ones, or beside them."""
    states = {"ntc2018": "SLV", "dmi2008": "SLV", "asce43-05": "DBE", "asce41-13": "BSE-1E"}
    usual = {
        "site": {"spectrum": spectrum, "limit_state": states.get(basis, "ULS")},
        "building": {"height": 4.5, "storeys": 2, "ground_elevation": 0.0, "use_class": "II"},
        "materials": {"stone": {"density": 1900, "disintegration": "excluded"}},
        "bodies": {"wall": WALL},
        "verdict": {"basis": basis},
        "mechanisms": mechanisms,
        "report": {"sources": {"materials.stone.disintegration": SURVEY}},
        "analysis": {"scan": False},
        "records": {"synthetic": {"count": 1, "duration": "25 s"}},
    }
    return {**usual, **more}


def _block(**more: Any) -> Tables:
    return {"kind": "single-block", "blocks": ["wall"], "direction": [1, 0, 0], **more}


STATIC = {"analysis": {"scan": False, "procedures": ["ntc2018-linear", "ntc2018-nonlinear"]}}
NBS = {"basis": "nzsee2017", "target_nbs": 67}
OF_LEVEL_2 = {"height": 4.5, "storeys": 2, "ground_elevation": 0.0, "importance_level": 2}
UPSTAIRS: Tables = {
    "bodies": {"wall": WALL | {"box": {**BOX, "base": [0, 0, 3.5]}}},
    "building": {"height": 8.0, "storeys": 2, "ground_elevation": 0.0, "use_class": "II"},
}
LEG = {"thickness": "0.4 m", "length": "3 m", "height": "4.5 m"}
FRAME: Tables = {
    "wall": WALL,
    "beam": WALL | {"box": {"thickness": "3.4 m", "length": "3 m", "height": "0.4 m", "base": [1.5, 0, 4.5]}},
    "right": WALL | {"box": {**LEG, "base": [3.0, 0, 0]}},
}
PORTAL: Tables = {
    "kind": "four-hinge",
    "blocks": ["wall", "beam", "right"],
    "sides": "one",
    "direction": [1, 0, 0],
    "hinges": {"A": [0.2, 0.0], "B": [-0.2, 4.5], "C": [2.8, 4.5], "D": [3.2, 0.0]},
}
PUBLISHED: Tables = {
    "kind": "equivalent-block",
    "p": 1.6,
    "uplift": 0.07,
    "radius": 2.84,
    "elevation": 0.0,
    "disintegration": "excluded",
}
PROJECTS: dict[str, Tables] = {
    "ntc-wall": _project("ntc2018", ITALY, {"wall": _block(sides="one", loads=[FLOOR, TIE])}, **STATIC),
    "ntc-free": _project("ntc2018", ITALY, {"wall": _block()}, **STATIC),
    "ntc-upstairs": _project("ntc2018", ITALY, {"wall": _block(loads=[TIE | {"at": [-0.2, 7.0]}])}, **UPSTAIRS),
    "ntc-joint": _project(
        "ntc2018",
        ITALY,
        {"wall": _block(sides="one", interface={"model": "flexible", "stiffness": "1 GPa/m", "strength": "2 MPa"})},
    ),
    "ntc-course": _project(
        "ntc2018",
        ITALY,
        {"wall": _block(sides="one", interface={"model": "flexible", "course_thickness": "0.2 m"})},
        materials={"stone": {"density": 1900, "young_modulus": "1.2 GPa", "disintegration": "excluded"}},
    ),
    "ntc-portal": _project(
        "ntc2018",
        ITALY,
        {"wall": {**PORTAL}},
        bodies=FRAME,
        report={
            "sources": dict.fromkeys(
                ("materials.stone.disintegration", "mechanisms.wall.hinges", "mechanisms.wall.direction"), SURVEY
            )
        },
    ),
    "ntc-two-block": _project(
        "ntc2018",
        ITALY,
        {"wall": {**_block(), "kind": "two-block", "loads": [LOAD]}},
        bodies={"wall": WALL | {"box": {"thickness": "0.12 m", "length": "3 m", "height": "4.5 m"}}},
    ),
    "ntc-tabled": _project(
        "ntc2018",
        ITALY,
        {"wall": {**PUBLISHED}},
        report={"sources": {f"mechanisms.wall.{key}": SURVEY for key in PUBLISHED if key != "kind"}},
    ),
    "dmi-wall": _project("dmi2008", ITALY, {"wall": _block(sides="one", loads=[FLOOR])}),
    "nz-wall": _project("nzsee2017", ZEALAND, {"wall": _block(loads=[FLOOR])}, verdict=NBS, building=OF_LEVEL_2),
    "nz-upstairs": _project(
        "nzsee2017",
        ZEALAND,
        {"wall": _block()},
        verdict=NBS,
        **{**UPSTAIRS, "building": {**UPSTAIRS["building"], "importance_level": 2}},
    ),
    "ec8-gable": _project("ec8", EUROPE, {"wall": _block()}, **UPSTAIRS),
    "asce41-wall": _project("asce41-13", AMERICA, {"wall": {**_block(), "kind": "two-block", "loads": [LOAD]}}),
    "asce43-wall": _project(
        "asce43-05", AMERICA, {"wall": _block()}, verdict={"basis": "asce43-05", "procedures": ["asce43-05-spectrum"]}
    ),
    "own-wall": _project(
        "own",
        EUROPE,
        {"wall": _block(loads=[TIE])},
        verdict={"basis": "own", "procedures": ["ntc2018-linear"], "rule": "all", "statement": "by the client"},
    ),
}
"""By their names."""

SUITE: Tables = {"records": {"synthetic": {"count": 7, "duration": "25 s"}}}
"""As many records as a mean needs."""
HISTORIES: dict[str, Tables] = {
    "own-histories": _project(
        "own",
        EUROPE,
        {"wall": _block()},
        verdict={"basis": "own", "procedures": ["ntc2018-history"], "rule": "all", "statement": "by the client"},
        **SUITE,
    ),
    "ntc-histories": _project(
        "ntc2018",
        ITALY,
        {"wall": _block(interface={"model": "flexible", "stiffness": "1 GPa/m"})},
        verdict={"basis": "ntc2018", "procedures": ["ntc2018-history", "ntc2018-nonlinear"]},
        **SUITE,
    ),
    "own-histories-one-side": _project(
        "own",
        EUROPE,
        {"wall": _block(sides="one")},
        verdict={"basis": "own", "procedures": ["ntc2018-history"], "rule": "all", "statement": "by the client"},
        **SUITE,
    ),
    "own-histories-upstairs": _project(
        "own",
        EUROPE,
        {"wall": _block(amplification={"method": "modal-filter", "natural_frequency": 4.2, "effective_height": 5.3})},
        **UPSTAIRS,
        verdict={"basis": "own", "procedures": ["ntc2018-history"], "rule": "all", "statement": "by the client"},
        **SUITE,
    ),
}
"""Projects on which histories decide: a few seconds each."""

DRAWN: dict[str, tuple[Any, ...]] = {
    "direction": ([-1, 0, 0], [0, 1, 0], [1, 1, 0], [1, 0.2, 0], "weakest"),
    "cut": (0.5, 1.5, 3.0, 4.0, {"point": [0, 0, 1.0], "angle": "20 deg"}, {"point": [0, 0, 1.0], "angle": "-20 deg"}),
    "crack": (0.1, 1.0, 2.25, 4.4, 6.0, "minimum"),
    "base_elevation": (0.0, 1.0, -1.0),
    "hinges": (
        *({"A": [0.1, 0.0]}, {"A": [-0.3, 0.0]}, {"A": [0.5, 0.0]}, {"A": [0.2, 1.0]}),
        *(
            {"A": [0.2, 0.0], "B": [b, height], "C": [c, 4.5]}
            for b, height, c in ((-0.2, 2.0, 0.2), (-0.5, 2.0, 0.2), (-0.2, 2.0, 0.5), (-0.06, 2.25, 0.3))
        ),
        *(
            {"A": [a, 0.0], "B": [b, 4.5], "C": [c, 4.5], "D": [d, 0.0]}
            for a, b, c, d in (
                (0.5, -0.2, 2.8, 3.2),
                (0.2, -0.5, 2.8, 3.2),
                (0.2, -0.2, 2.5, 3.2),
                (0.2, -0.2, 2.8, 3.5),
            )
        ),
    ),
    "interface": (
        {"model": "rigid"},
        *({"model": "flexible", "stiffness": size} for size in ("0.01 GPa/m", "1 GPa/m", "100 GPa/m", "2 TPa/m")),
        {"model": "semi-flexible", "stiffness": "2 TPa/m", "strength": "2 MPa"},
        {"model": "flexible", "course_thickness": "1 mm"},
    ),
    "restitution": (0.0, 0.3, 0.6, 0.9, 1.0, {"positive": 0.5, "negative": 0.5}),
    "sides": ("one", "two"),
    "side_walls": tuple(
        {"bond": "toothed", "course": course, "overlap": "0.3 m", "thickness": "0.6 m", "friction": 0.9, "count": 2}
        for course in ("0.05 m", "0.25 m")
    ),
}
"""What is drawn at keys of a mechanism that are absent, or in place of what stands there."""
ADDED_LOADS: tuple[Tables, ...] = (
    {"kind": "mass", "mass": "5000 kg", "at": [-0.15, 4.5]},
    {"kind": "mass", "mass": "5000 kg", "at": [-2.0, 4.5]},
    {"kind": "mass", "mass": "80000 kg", "at": [-0.1, 0.0], "bearing": False},
    {"kind": "force", "force": "20 kN", "at": [-0.2, 4.0], "direction": [-1, 0]},
    {"kind": "force", "force": "20 kN", "at": [-0.2, 4.0], "direction": [0, -1], "until": "collapse"},
    {"kind": "force", "force": "20 kN", "at": [-0.2, 2.0], "direction": [-1, -1]},
    {"kind": "tie", "force": "20 kN", "at": [-0.2, 4.4], "anchor": [-5.0, 4.4]},
    {"kind": "tie", "force": "20 kN", "at": [-0.2, 4.4], "anchor": [-5.0, 4.4], "until": "collapse"},
    {"kind": "tie", "force": "20 kN", "at": [3.0, 4.4], "anchor": [-5.0, 4.4]},
    {"kind": "overburden", "force": "30 kN"},
    {"kind": "overburden", "force": "30 kN", "eccentricity": "-0.15 m"},
)
"""What is added to the loads of a mechanism."""
ADDED_BOX: Tables = {"thickness": "1.0 m", "length": "3 m", "height": "1.0 m"}
ADDED_BODIES = (
    (-0.7, 0.0, 0.0),
    (-5.0, 0.0, 0.0),
    (-0.7, 0.0, 3.0),
    (-0.2, 0.0, 0.0),
    (0.0, 0.0, -1.0),
    (0.0, 8.0, 0.0),
)
"""Where a further body of the block stands: a buttress, one apart, one in the air, within the wall, below, beside."""
