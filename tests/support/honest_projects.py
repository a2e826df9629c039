"""Projects that an honest engineer would write, and that pass.

What they type is what the code or the drawing gives, or it has a source. Each has to keep its pass, so that nothing
is gained by refusing.
"""

from __future__ import annotations

from typing import Any

from tools.adversary.projects import AMERICA, EUROPE, ITALY, ZEALAND, Tables

SURVEY = "measured: survey by the office, May 2024"
TEST = "measured: ambient vibration test, University of Pavia, June 2024"
DESIGN = "literature: design drawings of the strengthening, sheet 4, 2023"
STATES = {"ntc2018": "SLV", "dmi2008": "SLV", "asce43-05": "DBE", "asce41-13": "BSE-1E"}
STONE = {"density": 1900, "disintegration": "excluded"}
FLOOR = {"kind": "mass", "mass": "2500 kg", "at": [-0.2, 3.0], "seat": "0.20 m"}
TIE = {"kind": "tie", "force": "20 kN", "at": [-0.3, 2.8], "anchor": [-5.0, 2.8], "until": "collapse"}


def wall(thickness: float, height: float, *, foot: float = 0.0, length: float = 4.0) -> Tables:
    """Return a wall of stone [m]."""
    box = {"thickness": thickness, "length": length, "height": height, "base": [0.0, 0.0, foot]}
    return {"material": "stone", "box": box}


def block(**more: Any) -> Tables:
    """Return the overturning of the wall about its foot."""
    return {"kind": "single-block", "blocks": ["wall"], "direction": [1, 0, 0], **more}


def honest(basis: str, spectrum: Tables, body: Tables, mechanism: Tables, **more: Any) -> Tables:
    """Return a project; `more` are tables whose keys are added to the usual ones."""
    top = body["box"]["height"] + body["box"]["base"][2]
    usual: Tables = {
        "site": {"spectrum": spectrum, "limit_state": STATES.get(basis, "ULS")},
        "building": {"height": top, "storeys": 2, "ground_elevation": 0.0, "use_class": "II"},
        "materials": {"stone": STONE},
        "bodies": {"wall": body},
        "verdict": {"basis": basis},
        "mechanisms": {"wall": mechanism},
        "report": {"sources": {"materials.stone.disintegration": SURVEY}},
        "analysis": {"scan": False},
    }
    for name, table in more.items():
        usual[name] = {**usual.get(name, {}), **table}
    usual["report"] = {"sources": {"materials.stone.disintegration": SURVEY, **usual["report"].get("sources", {})}}
    return usual


def _two_block(**more: Any) -> Tables:
    return {"kind": "two-block", "blocks": ["wall"], "direction": [1, 0, 0], **more}


def _scaled(spectrum: Tables, pga: str) -> Tables:
    """Return a spectrum by its PGA: a_g, Z, or S_DS and 0.4 of it as S_D1."""
    if "z" in spectrum:
        return spectrum | {"z": float(pga)}
    if "s_ds" in spectrum:
        return spectrum | {"s_ds": f"{pga} g", "s_d1": f"{0.4 * float(pga):.4g} g"}
    return spectrum | {"a_g": f"{pga} g"}


NZ = {"verdict": {"target_nbs": 67}, "building": {"importance_level": 2}}
SPECTRUM = {"verdict": {"procedures": ["asce43-05-spectrum"]}}
OF_LOAD, OF_TIE = ({"report": {"sources": {"mechanisms.wall.loads[1]": source}}} for source in (SURVEY, DESIGN))
PRESSED = {"loads": [{"kind": "overburden", "force": "20 kN"}]}
WHOLE, THIN = wall(0.6, 3.0), wall(0.4, 3.0)
FOOTING = {"thickness": 0.6, "length": 4.0, "height": 0.5, "base": [0.0, 0.0, -0.5]}
UP = wall(0.6, 2.0, foot=4.0)
JOINT = {"model": "flexible", "stiffness": "2 GPa/m"}

HONEST: dict[str, Tables] = {
    "wall": honest("ntc2018", _scaled(ITALY, "0.18"), WHOLE, block()),
    "wall, weakest direction": honest(
        "ntc2018", _scaled(ITALY, "0.18"), WHOLE, {"kind": "single-block", "blocks": ["wall"]}
    ),
    "wall under a floor": honest(
        "ntc2018", _scaled(ITALY, "0.21"), WHOLE, block(sides="one", loads=[FLOOR]), **OF_LOAD
    ),
    "wall under a floor of no source": honest(
        "ntc2018", _scaled(ITALY, "0.18"), WHOLE, block(sides="one", loads=[FLOOR | {"at": [-0.4, 3.0]}])
    ),
    "tied wall": honest("ntc2018", _scaled(ITALY, "0.18"), WHOLE, block(loads=[TIE]), **OF_TIE),
    "tie that breaks": honest(
        "ntc2018", _scaled(ITALY, "0.15"), WHOLE, block(loads=[TIE | {"until": "0.05 m"}]), **OF_TIE
    ),
    "two blocks": honest("ntc2018", _scaled(ITALY, "0.25"), THIN, _two_block(**PRESSED), **OF_LOAD),
    "two blocks, surveyed crack": honest(
        "ntc2018",
        _scaled(ITALY, "0.3"),
        THIN,
        _two_block(**PRESSED, crack=1.5),
        report={"sources": {"mechanisms.wall.loads[1]": SURVEY, "mechanisms.wall.crack": SURVEY}},
    ),
    "upper storey": honest("ntc2018", _scaled(ITALY, "0.21"), UP, block()),
    "upper storey, measured period": honest(
        "ntc2018",
        _scaled(ITALY, "0.18"),
        UP,
        block(),
        building={"period": 0.2},
        report={"sources": {"building.period": TEST}},
    ),
    "upper storey, softened period stated": honest(
        "ntc2018",
        _scaled(ITALY, "0.18"),
        UP,
        block(),
        building={
            "period": 0.2,
            "limit_states": {
                "SLV": {"period": 0.3, "damping": 0.1, "reason": "push-over of the building, report 12 of 2024"}
            },
        },
        report={"sources": {"building.period": TEST, "building.limit_states": TEST}},
    ),
    "bell-cote above the eaves": honest(
        "ntc2018", _scaled(ITALY, "0.15"), wall(0.8, 2.0, foot=8.0), block(), building={"height": 8.0}
    ),
    "parapet": honest("ntc2018", _scaled(ITALY, "0.1"), wall(0.4, 1.0, foot=6.0), block(), building={"height": 6.5}),
    "tower": honest("ntc2018", _scaled(ITALY, "0.6"), wall(4.0, 16.0), block()),
    "surveyed joint": honest(
        "ntc2018",
        _scaled(ITALY, "0.18"),
        WHOLE,
        block(interface=JOINT),
        report={"sources": {"mechanisms.wall.interface": SURVEY}},
    ),
    "surveyed joint that crushes": honest(
        "ntc2018",
        _scaled(ITALY, "0.18"),
        WHOLE,
        block(interface={"model": "semi-flexible", "stiffness": "2 GPa/m", "strength": "3 MPa"}),
        report={"sources": {"mechanisms.wall.interface": SURVEY}},
        procedures={"ntc2018": {"knowledge_level": "LC2"}},
    ),
    "measured restitution": honest(
        "ntc2018",
        _scaled(ITALY, "0.18"),
        WHOLE,
        block(restitution=0.9),
        report={"sources": {"mechanisms.wall.restitution": SURVEY}},
    ),
    "linear alone": honest(
        "ntc2018", _scaled(ITALY, "0.18"), WHOLE, block(), analysis={"procedures": ["ntc2018-linear"]}
    ),
    "published block": honest(
        "ntc2018",
        _scaled(ITALY, "0.3"),
        WHOLE,
        {"kind": "equivalent-block", "p": 1.6, "uplift": 0.2, "radius": 2.84, "disintegration": "excluded"},
        report={"sources": {"mechanisms.wall.disintegration": SURVEY}},
    ),
    "class I": honest("ntc2018", _scaled(ITALY, "0.18"), WHOLE, block(), building={"use_class": "I"}),
    "roof a little above the building": honest(
        "ntc2018", _scaled(ITALY, "0.18"), WHOLE, block(), building={"height": 3.2}
    ),
    "DMI wall": honest("dmi2008", _scaled(ITALY, "0.21"), WHOLE, block()),
    "DMI wall under a floor": honest(
        "dmi2008", _scaled(ITALY, "0.21"), WHOLE, block(sides="one", loads=[FLOOR]), **OF_LOAD
    ),
    "DMI tied wall": honest("dmi2008", _scaled(ITALY, "0.21"), WHOLE, block(loads=[TIE]), **OF_TIE),
    "DMI upper storey": honest("dmi2008", _scaled(ITALY, "0.15"), UP, block()),
    "DMI two blocks": honest("dmi2008", _scaled(ITALY, "0.35"), THIN, _two_block(**PRESSED), **OF_LOAD),
    "EC8 wall": honest("ec8", _scaled(EUROPE, "0.045"), WHOLE, block()),
    "EC8 gable": honest("ec8", _scaled(EUROPE, "0.04"), UP, block()),
    "EC8 tied wall": honest("ec8", _scaled(EUROPE, "0.045"), WHOLE, block(loads=[TIE]), **OF_TIE),
    "NZ wall": honest("nzsee2017", _scaled(ZEALAND, "0.35"), WHOLE, block(), **NZ),
    "NZ wall under a floor": honest(
        "nzsee2017", _scaled(ZEALAND, "0.35"), WHOLE, block(loads=[FLOOR]), **(NZ | OF_LOAD)
    ),
    "NZ tied wall": honest("nzsee2017", _scaled(ZEALAND, "0.35"), WHOLE, block(loads=[TIE]), **(NZ | OF_TIE)),
    "NZ upper storey": honest("nzsee2017", _scaled(ZEALAND, "0.18"), UP, block(), **NZ),
    "NZ two blocks": honest(
        "nzsee2017",
        _scaled(ZEALAND, "0.35"),
        THIN,
        _two_block(**PRESSED),
        bodies={"footing": {"material": "stone", "box": FOOTING}},
        report={"sources": {"mechanisms.wall.loads[1]": SURVEY, "building.ground_elevation": SURVEY}},
        **NZ,
    ),
    "ASCE 41 two blocks": honest("asce41-13", _scaled(AMERICA, "0.8"), THIN, _two_block(**PRESSED), **OF_LOAD),
    "ASCE 41 thick wall": honest(
        "asce41-13", _scaled(AMERICA, "1.0"), wall(0.5, 3.0), _two_block(**PRESSED), **OF_LOAD
    ),
    "ASCE 43 wall": honest("asce43-05", _scaled(AMERICA, "0.5"), WHOLE, block(), **SPECTRUM),
    "ASCE 43 tied wall": honest("asce43-05", _scaled(AMERICA, "0.5"), WHOLE, block(loads=[TIE]), **(SPECTRUM | OF_TIE)),
    "ASCE 43 two blocks": honest(
        "asce43-05",
        _scaled(AMERICA, "0.8"),
        THIN,
        _two_block(**PRESSED),
        procedures={"asce43-05": {"floor_vertical_ratio": 1.0, "floor_spectrum": "circolare-7-2019"}},
        report={"sources": {"mechanisms.wall.loads[1]": SURVEY, "procedures.asce43-05.floor_vertical_ratio": DESIGN}},
        **SPECTRUM,
    ),
    "own, linear": honest(
        "own",
        _scaled(EUROPE, "0.18"),
        WHOLE,
        block(),
        verdict={"procedures": ["ntc2018-linear"], "rule": "all", "statement": "agreed with the client"},
    ),
    "own, tied": honest(
        "own",
        _scaled(EUROPE, "0.15"),
        WHOLE,
        block(loads=[TIE]),
        **{
            "verdict": {"procedures": ["ntc2018-nonlinear"], "rule": "all", "statement": "agreed with the client"},
            **OF_TIE,
        },
    ),
}
"""By what is special about them; each holds about 1.1 to 1.3 times its action."""
