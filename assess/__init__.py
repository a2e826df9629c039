"""Rocking of masonry in earthquakes, beside the checks of the codes.

The public names are those of `__all__`: SI floats in, frozen data out, errors of `assess.errors`. Each is loaded when
it is first used, so that `import assess` takes no time; rooms such as `assess.loads` and `assess.model` likewise.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from assess.late import late_names

if TYPE_CHECKING:
    from assess.codes.context import building
    from assess.interfaces.contact import Interface
    from assess.interfaces.section import Shape
    from assess.loads.anchorage import Plate
    from assess.loads.far_wall import SiteAction
    from assess.loads.load import BodyLoad, ForceLoad, MassLoad, OverburdenLoad, TieLoad
    from assess.mechanisms.four_hinge import RadialJoints
    from assess.mechanisms.mechanism import CutAngle, CutPlane
    from assess.mechanisms.side_walls import SideWalls
    from assess.mechanisms.wedged_block import Wedge
    from assess.model.bodies import Body, Material, box, mesh, profile
    from assess.project.suites import catalogue, select_records
    from assess.study.block import (
        Block,
        corner,
        equivalent_block,
        facade_with_wedges,
        four_hinge,
        horizontal_arch,
        single_block,
        two_block,
    )
    from assess.verbs import (
        Run,
        answers,
        batch,
        envelope,
        fragility,
        load,
        plot,
        read_building,
        respond,
        retrofit,
        run,
        write_report,
        write_retrofit,
    )
    from records.reading import read_record, read_records
    from records.record import Record
    from records.synthetic import artificial_records
    from spectra.gravity import g
    from spectra.registry import spectrum

__all__ = [
    "Block",
    "Body",
    "BodyLoad",
    "CutAngle",
    "CutPlane",
    "ForceLoad",
    "Interface",
    "MassLoad",
    "Material",
    "OverburdenLoad",
    "Plate",
    "RadialJoints",
    "Record",
    "Run",
    "Shape",
    "SideWalls",
    "SiteAction",
    "TieLoad",
    "Wedge",
    "answers",
    "artificial_records",
    "batch",
    "box",
    "building",
    "catalogue",
    "corner",
    "envelope",
    "equivalent_block",
    "facade_with_wedges",
    "four_hinge",
    "fragility",
    "g",
    "horizontal_arch",
    "load",
    "mesh",
    "plot",
    "profile",
    "read_building",
    "read_record",
    "read_records",
    "respond",
    "retrofit",
    "run",
    "select_records",
    "single_block",
    "spectrum",
    "two_block",
    "write_report",
    "write_retrofit",
]

_HOMES = {
    "assess.codes.context": ("building",),
    "assess.interfaces.contact": ("Interface",),
    "assess.interfaces.section": ("Shape",),
    "assess.loads.anchorage": ("Plate",),
    "assess.loads.far_wall": ("SiteAction",),
    "assess.loads.load": ("BodyLoad", "ForceLoad", "MassLoad", "OverburdenLoad", "TieLoad"),
    "assess.mechanisms.four_hinge": ("RadialJoints",),
    "assess.mechanisms.mechanism": ("CutAngle", "CutPlane"),
    "assess.mechanisms.side_walls": ("SideWalls",),
    "assess.mechanisms.wedged_block": ("Wedge",),
    "assess.model.bodies": ("Body", "Material", "box", "mesh", "profile"),
    "assess.project.suites": ("catalogue", "select_records"),
    "assess.study.block": (
        "Block",
        "corner",
        "equivalent_block",
        "facade_with_wedges",
        "four_hinge",
        "horizontal_arch",
        "single_block",
        "two_block",
    ),
    "assess.verbs": (
        "Run",
        "answers",
        "batch",
        "envelope",
        "fragility",
        "load",
        "plot",
        "read_building",
        "respond",
        "retrofit",
        "run",
        "write_report",
        "write_retrofit",
    ),
    "records.reading": ("read_record", "read_records"),
    "records.record": ("Record",),
    "records.synthetic": ("artificial_records",),
    "spectra.gravity": ("g",),
    "spectra.registry": ("spectrum",),
}
_ROOMS = (
    "amplification",
    "codes",
    "dynamics",
    "errors",
    "geometry",
    "interfaces",
    "loads",
    "mechanisms",
    "model",
    "study",
)
__getattr__, __dir__ = late_names(__name__, _HOMES, _ROOMS)
