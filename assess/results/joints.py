"""The joints and hinges of a mechanism: moments by simpler interfaces, and forces when rocking starts."""

from __future__ import annotations

from dataclasses import dataclass

from assess.codes.calculation_step import Step
from assess.codes.check import BranchName
from assess.results.values import Floats, Point
from assess.short_repr import ShortRepr


@dataclass(frozen=True, repr=False)
class BranchMoment(ShortRepr):
    """A moment-rotation curve."""

    rotation_rad: Floats
    restoring_n_m: Floats


@dataclass(frozen=True, repr=False)
class InterfaceCurves(ShortRepr):
    """Moments of the positive branch by simpler interfaces, for comparison: rigid, and hinges fixed at a_SF."""

    rigid: BranchMoment
    fixed_hinges: BranchMoment


@dataclass(frozen=True, repr=False)
class ContactSheet(ShortRepr):
    """The contact of a joint that yields or crushes, as the lines of a calculation sheet. hinge: with ' if negative."""

    hinge: str
    steps: tuple[Step, ...]


@dataclass(frozen=True, repr=False)
class HingeForceResult(ShortRepr):
    """The force through a hinge when its mechanism starts to rock, at the ground acceleration activation_g.

    horizontal_n, vertical_n: on the block that presses, along the branch's own direction and up; normal_n, shear_n:
    normal to its faces (compression positive) and along them; face: unit normal of the faces (along, up), towards that
    block; face_found: False if the geometry has no faces there and they are taken as level. needed_friction: |shear_n|
    / normal_n, None without compression; friction: of the joint, None if not known. sliding_g: ground acceleration at
    which it slides before it rocks, None if it rocks first or friction is not known. held: whether a support holds it
    besides friction, as at the top of a wall.
    """

    hinge: str
    branch: BranchName
    horizontal_n: float
    vertical_n: float
    needed_friction: float | None
    friction: float | None
    normal_n: float
    shear_n: float
    face: Point
    face_found: bool
    activation_g: float
    sliding_g: float | None
    held: bool
