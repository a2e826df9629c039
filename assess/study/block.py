"""A mechanism made of plain data, as a Python session has it, with its rocking parameters."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

from assess.errors import MechanismError
from assess.geometry.scene import Scene
from assess.mechanisms.mechanism import Mechanism
from assess.messages.message import Message, locate
from assess.model.as_floats import with_floats
from assess.model.body import Bodies, Body, solids_of
from assess.model.check import check_definition
from assess.model.definitions import (
    Definition,
    EquivalentBlock,
)
from assess.model.gaps import gaps_of
from assess.model.overlaps import overlaps_of
from assess.model.weakest import mechanism_in_direction
from assess.oscillator import Oscillator
from assess.results import OscillatorResult
from assess.study.grounding import lowest_of
from assess.study.oscillator_results import oscillator_result, rigid_branches
from assess.study.study import Equation


@dataclass(frozen=True)
class RockingParameters:
    """What rocking needs to know of one branch of a mechanism, as `assess parameters` prints it.

    p : frequency parameter [1/s]; slenderness : of the equivalent block [rad]; radius : of the equivalent block [m]
    multiplier : acceleration in g that starts the rocking [-], None where a flexible joint lets it start at once
    overturning : rotation beyond which it falls under gravity alone [rad]; restitution : of the impact [-]; mass [kg]
    """

    p: float
    slenderness: float
    radius: float
    multiplier: float | None
    overturning: float
    restitution: float
    mass: float

    @classmethod
    def of(cls, result: OscillatorResult) -> RockingParameters:
        """Return the parameters of a branch of the results."""
        return cls(
            p=result.p_eq_per_s,
            slenderness=result.slenderness_rad,
            radius=result.radius_m,
            multiplier=result.uplift_multiplier,
            overturning=result.overturning_rad,
            restitution=result.restitution,
            mass=result.mass_kg,
        )


@dataclass(frozen=True, repr=False)
class Block:
    """A mechanism made of plain data, ready for histories, envelopes and the procedures of the codes.

    definition : what was asked for; bodies : by name; mechanism : as built; scene : its bodies in space
    """

    name: str
    definition: Definition
    bodies: Bodies
    mechanism: Mechanism
    scene: Scene | None

    def __repr__(self) -> str:
        one = self.oscillator
        multiplier = "none" if one.multiplier is None else f"{one.multiplier:.4g}"
        return (
            f"Block({self.name!r}, {self.mechanism.kind}, p={one.p:.4g} 1/s, slenderness={one.slenderness:.4g} rad, "
            f"multiplier={multiplier}, overturning={one.overturning:.4g} rad, {one.mass:.4g} kg)"
        )

    @cached_property
    def oscillator(self) -> RockingParameters:
        """The parameters of positive rotation, which topples towards the direction."""
        found = self._parameters[0]
        assert found is not None
        return found

    @cached_property
    def oscillator_negative(self) -> RockingParameters | None:
        """The parameters of negative rotation; None where it rocks to one side."""
        return self._parameters[1]

    @cached_property
    def rocking(self) -> Oscillator:
        """The oscillator that histories and envelopes move: with what is shown to last up to collapse.

        Raises
        ------
        MechanismError : the mechanism stands only by ties or forces that are not shown to last
        """
        found = self.mechanism.variants.collapse
        if found is None:
            names = ", ".join(self.mechanism.variants.depends_on)
            raise MechanismError(
                f'mechanism "{self.name}": it stands only by {names}, not shown to last up to collapse; give until and '
                "evidence"
            )
        return found

    @property
    def equation(self) -> Equation:
        """The equation of motion of its histories: linearised for published parameters, else exact."""
        return "linearised" if isinstance(self.definition, EquivalentBlock) else "exact"

    @cached_property
    def lowest(self) -> float | None:
        """The elevation of the lowest body that is more than a load [m]; None without bodies."""
        return lowest_of({self.name: self.definition}, solids_of(self.bodies))

    @cached_property
    def messages(self) -> tuple[Message, ...]:
        """What the engineer should know before using it: gaps, overlaps, doubtful loads and hinges."""
        where, definitions = f"mechanisms.{self.name}", {self.name: self.definition}
        return (
            *overlaps_of(definitions, self.bodies),
            *gaps_of(definitions, self.bodies),
            *locate(self.mechanism.warnings, where),
            *self.mechanism.messages,
        )

    @cached_property
    def _parameters(self) -> tuple[RockingParameters, RockingParameters | None]:
        starting = self.mechanism.variants.starting
        rigid, mass = rigid_branches(self.mechanism, starting), starting.mass
        front = oscillator_result(starting.positive, mass=mass, rigid=rigid[0], equilibrium=starting.equilibrium)
        if starting.negative is None:
            return RockingParameters.of(front), None
        back = oscillator_result(
            starting.negative, mass=mass, rigid=rigid[-1], equilibrium=starting.equilibrium_negative
        )
        return RockingParameters.of(front), RockingParameters.of(back)


def make_block(name: str, definition: Definition, bodies: Sequence[Body]) -> Block:
    """Build a mechanism from its definition and the bodies of the building.

    Raises
    ------
    MechanismError : two bodies have one name, or a value is one that no mechanism can have
    """
    if not isinstance(name, str) or not name:
        raise MechanismError(f"name = {name!r:.60}: give a text, by which messages call the mechanism")
    by_name = {body.name: body for body in bodies}
    if len(by_name) < len(bodies):
        twice = sorted({body.name for body in bodies if sum(body.name == other.name for other in bodies) > 1})
        raise MechanismError(f'mechanism "{name}": several bodies are called {", ".join(twice)}; give each its name')
    definition = with_floats(definition)
    check_definition(name, definition, by_name)
    built = mechanism_in_direction(name, definition, by_name)
    return Block(name, definition, by_name, built.mechanism, built.scene)
