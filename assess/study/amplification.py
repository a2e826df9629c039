"""The ground motion at the base of a mechanism: its height above the ground, and the amplification up to there.

Rayleigh's method gives the first mode of a mechanism on the ground where frequency and effective height are not given.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import lru_cache

from assess.amplification import (
    ASSUMPTIONS,
    SLICES,
    Amplification,
    FirstMode,
    FloorFactor,
    ModalFilter,
    RayleighMode,
    Srss,
    SrssRelative,
    Unamplified,
    first_mode,
    rayleigh_mode,
    slice_cantilever,
)
from assess.codes.check import ELASTIC, BuildingState, Reason, reason_message
from assess.codes.context import is_above_ground
from assess.codes.question import Missing, missing_input
from assess.errors import GeometryError, ProjectError
from assess.geometry.solid import Solid, Solids
from assess.loads.load import bodies_of
from assess.mechanisms.chain import ROUNDING
from assess.mechanisms.kinds import MECHANISM_KINDS, Definition
from assess.mechanisms.mechanism import BlockMechanism, Mechanism, height_of_support
from assess.messages.message import Message, Quantity, Term, Value, message, note, warning, whole_number
from assess.model.assembly import Built
from assess.model.bodies import Bodies, solids_of_block
from spectra.errors import SpectrumError
from spectra.floor import (
    ec8_resonant_part_factor,
    ec8_resonant_part_factor_with_soil,
    ec8_rigid_part_factor,
    first_mode_factor,
    nzs1170_5_height_coefficient,
)

NEAR_GROUND = 0.05  # m: a body that stands no farther from the ground's elevation stands on it
FIRST_MODE_DAMPING = 0.05  # of the first mode where there is no [building]
RAYLEIGH = "Rayleigh's method"
LINEAR_MODE = "provisional: linear mode of Circolare 7/2019, C7.2.10"
MANY_STOREYS = 2.0 / 3.0  # 1 / gamma_1 of C7.2.10 without end: the least resultant, the most amplification
EC8_AS_PRINTED = "ec8-printed"


@dataclass(frozen=True)
class MechanismAmplification:
    """How the ground's motion reaches the base of a mechanism.

    method : as in the project; height : of the base above the ground [m], None where nothing is amplified
    description : what is done, with which numbers and their sources
    assumptions : on values that are not given
    by_stiffness : whether the amplification follows from the stiffness of the bodies
    missing : what a provisional value stands for, so that nothing that follows the motion is shown
    state : of the building that the motion passes
    """

    method: str
    height: float | None
    amplification: Amplification
    description: tuple[Message | str, ...]
    assumptions: tuple[Message, ...] = ()
    by_stiffness: bool = False
    missing: tuple[Missing, ...] = ()
    state: BuildingState = ELASTIC


NOT_AMPLIFIED = MechanismAmplification("none", None, Unamplified(), ())

FLOOR_FACTORS: dict[str, tuple[Callable[..., float], str]] = {
    "ec8": (
        ec8_rigid_part_factor,
        "EN 1998-1, 4.3.5.2, rigid part (T_a = 0): 1.5 (1 + z/H) - 0.5 on the motion of the surface",
    ),
    "ec8-resonance": (ec8_resonant_part_factor, "EN 1998-1, 4.3.5.2, at resonance (T_a = T_1): 3 (1 + z/H) - 0.5"),
    "nzs1170.5": (nzs1170_5_height_coefficient, "NZS 1170.5, 8.3: the least that applies of 1 + h/6, 1 + 10 h/H and 3"),
}

FIRST_MODES: dict[str, tuple[Callable[[FirstMode, float], Srss | SrssRelative | ModalFilter], str]] = {
    "srss": (Srss, "every record and pulse times sqrt((S_a(T_n)/a_g h/h_e)^2 + 1), Mehrotra 3.48"),
    "srss-relative": (
        SrssRelative,
        "every record times sqrt((S_a(T_n)/a_g h/h_e)^2 + 1), Mehrotra 3.48; every pulse by 3.47, with the response "
        "relative to the ground",
    ),
    "modal-filter": (
        ModalFilter,
        "every record through the first mode, absolute acceleration at the mechanism's base; every pulse times the "
        "ratio of the peaks; no higher modes",
    ),
}


@dataclass(frozen=True, kw_only=True)
class AmplificationChoice:
    """The method by which the ground motion is amplified up to a mechanism, and its given values.

    method : of FLOOR_FACTORS or FIRST_MODES, or "ec8-printed"; height : of the mechanism's base above the ground [m]
    natural_frequency [Hz], effective_height [m] : of the first mode; soil_factor : S [-], of "ec8-printed"
    """

    method: str
    height: float | None = None
    natural_frequency: float | None = None
    effective_height: float | None = None
    soil_factor: float = 1.0


@dataclass(frozen=True, kw_only=True)
class Structure:
    """The structure below a mechanism; values that are not given are None.

    height [m]; storeys; natural_frequency [Hz], effective_height [m], damping [-] : of its first mode; period [s]
    """

    height: float | None = None
    storeys: int | None = None
    natural_frequency: float | None = None
    effective_height: float | None = None
    period: float | None = None
    damping: float = FIRST_MODE_DAMPING


@dataclass(frozen=True, kw_only=True)
class MechanismInPlace:
    """A mechanism with everything that affects the motion at its base.

    base_elevation : height of its base above the ground, if given for this mechanism [m]
    """

    name: str
    definition: Definition
    built: Built
    bodies: Bodies
    ground: GroundLevel
    structure: Structure
    base_elevation: float | None = None

    @property
    def where(self) -> str:
        """The key, as errors name it."""
        return f"mechanisms.{self.name}.amplification"


def amplify(choice: AmplificationChoice | None, in_place: MechanismInPlace) -> MechanismAmplification:
    """Find how the ground motion reaches the base of a mechanism.

    Parameters
    ----------
    choice : the method; None for the ground motion as it is
    in_place : the mechanism in its place

    Returns
    -------
    The amplification, with its description.

    Raises
    ------
    ProjectError : if a value is missing, or a height is outside the clause
    """
    if choice is None:
        return NOT_AMPLIFIED
    height = support_height(choice, in_place)
    if choice.method in FIRST_MODES:
        return _amplify_by_first_mode(choice, in_place, height=height)
    return _amplify_by_floor_factor(choice, in_place, height=height)


def support_height(choice: AmplificationChoice, in_place: MechanismInPlace) -> float:
    """Return the height of the support above the ground [m]: given, the base, or the mean of base and far support."""
    if choice.height is not None:
        return choice.height
    mechanism = in_place.built.mechanism
    base = in_place.ground.base_height(mechanism, in_place.base_elevation)
    if base < -NEAR_GROUND:
        raise ProjectError(
            f"{in_place.where}.height: the mechanism begins {-base:.3g} m below the ground; give height, or "
            "building.ground_elevation"
        )
    return _mean_support_height(base, mechanism)


def given_frequency(choice: AmplificationChoice, structure: Structure) -> tuple[float, str] | None:
    """Return the first natural frequency [Hz] that is given, and its source; None if none is."""
    if choice.natural_frequency is not None:
        return choice.natural_frequency, "given"
    if structure.natural_frequency is not None:
        return structure.natural_frequency, "given for the building"
    if structure.period is not None:
        return 1.0 / structure.period, "1 / period of the building"
    return None


def given_effective_height(choice: AmplificationChoice, structure: Structure) -> tuple[float, str] | None:
    """Return the effective height [m] that is given, and its source; None if none is."""
    if choice.effective_height is not None:
        return choice.effective_height, "given"
    if structure.effective_height is not None:
        return structure.effective_height, "given for the building"
    return None


def linear_mode_height(in_place: MechanismInPlace) -> float | None:
    """Return the height of the resultant of a linear first mode, h_e = H / gamma_1 [m]; None where no height is known.

    gamma_1 = 3 n / (2 n + 1) of n storeys is the participation factor of a mode that is 1 at the top, so that gamma_1
    h / H is the h / h_e of `FirstMode.shape`. H is the building's, or that of the bodies as drawn. Where the storeys
    are not given they are many, which puts the resultant lowest: 2/3 H.

    Source: Circolare 7/2019, C7.2.10.
    """
    structure = in_place.structure
    height = structure.height or _drawn_height(in_place)
    if height is None:
        return None
    return height * (MANY_STOREYS if structure.storeys is None else 1.0 / first_mode_factor(structure.storeys))


def _drawn_height(in_place: MechanismInPlace) -> float | None:
    """Return the height of the highest body above the ground [m]; None where none is drawn above it."""
    solids = (body.solid for body in in_place.bodies.values())
    top = max((float(solid.vertices[:, 2].max()) for solid in solids if solid is not None), default=0.0)
    return max(top - (in_place.ground.elevation or 0.0), 0.0) or None


def young_modulus(name: str, in_place: MechanismInPlace) -> float:
    """Return Young's modulus of a body [Pa]; raise ProjectError if it is not given."""
    material = in_place.bodies[name].material
    if material is None:
        raise _missing_mode(in_place, f'body "{name}" has no geometry')
    modulus = material.young_modulus
    if modulus is None:
        raise _missing_mode(in_place, f"materials.{material.name} has no young_modulus for Rayleigh's method")
    return modulus


NEAR_ZERO = 0.5  # m: a lowest body farther from elevation 0 does not show where the ground is
BY_BUILDING = "by building.ground_elevation"
BY_MECHANISM = "by its base_elevation"
BY_TABLE = "by its elevation, the ground at 0"
BY_BODIES = "by the lowest body, which stands near elevation 0"
UNKNOWN = "not known where the ground is: give building.ground_elevation, or its base_elevation"


@dataclass(frozen=True)
class HeightAboveGround:
    """The height of a mechanism above the ground.

    base : height of its base [m]; support : height of its support, the mean of base and far support if it has both [m]
    above : whether that counts as above the ground; source : of the level of the ground, in words
    unknown : why no check can be answered, if that level is not known
    """

    base: float
    support: float
    above: bool
    source: str
    unknown: tuple[Message, ...] = ()


@dataclass(frozen=True)
class GroundLevel:
    """The level of the ground, as far as given.

    elevation : of the ground [m], None if not given; lowest : elevation of the lowest body [m], None without bodies
    building_height : height of the building above the ground [m], 0 if not given
    """

    elevation: float | None = None
    lowest: float | None = None
    building_height: float = 0.0

    def base_height(self, mechanism: Mechanism, base_elevation: float | None) -> float:
        """Return how high the base of a mechanism is above the ground [m]: given for it alone, or by its elevation."""
        return mechanism.elevation - (self.elevation or 0.0) if base_elevation is None else base_elevation


def find_height(
    ground: GroundLevel, mechanism: Mechanism, *, base_elevation: float | None = None, by_table: bool = False
) -> HeightAboveGround:
    """Find the height of a mechanism above the ground.

    Parameters
    ----------
    ground : the level of the ground
    mechanism : the mechanism
    base_elevation : height of its base above the ground, if it is not drawn in its place [m]
    by_table : whether the mechanism gives its own elevation, as one of published parameters does

    Returns
    -------
    With the source of the level of the ground.
    """
    base = ground.base_height(mechanism, base_elevation)
    base = 0.0 if abs(base) < ROUNDING else base
    support = _mean_support_height(base, mechanism)
    source = _source_of_level(ground, base_elevation, by_table=by_table)
    lowest = mechanism.elevation if ground.lowest is None else ground.lowest
    if not source:
        source = BY_BODIES if abs(lowest) <= NEAR_ZERO else UNKNOWN
    unknown: tuple[Message, ...] = (
        (reason_message(Reason.GROUND_UNKNOWN, height=Quantity(lowest, "length")),) if source == UNKNOWN else ()
    )
    if source == BY_MECHANISM and not unknown:
        unknown = _contradicted_level(base, ground.base_height(mechanism, None), lowest, mechanism, ground)
    return HeightAboveGround(base, support, is_above_ground(support, ground.building_height), source, unknown)


def lowest_body_elevation(definitions: Mapping[str, Definition], solids: Solids) -> float | None:
    """Return the elevation of the lowest body [m] that is more than a load; None where there is none.

    Parameters
    ----------
    definitions : the mechanisms by name
    solids : of the building's bodies by name
    """
    mechanisms = [each for each in definitions.values() if isinstance(each, BlockMechanism)]
    in_mechanisms = {body for each in mechanisms for body in each.bodies}
    loads = {body for each in mechanisms for load in each.loads for body in bodies_of(load)}
    bodies = [
        solid for name, solid in solids.items() if solid is not None and (name in in_mechanisms or name not in loads)
    ]
    return min((float(solid.vertices[:, 2].min()) for solid in bodies), default=None)


def _amplify_by_floor_factor(
    choice: AmplificationChoice, in_place: MechanismInPlace, *, height: float
) -> MechanismAmplification:
    """Return the amplification by the factor of a code for the height [m]."""
    building = in_place.structure.height
    if building is None:
        raise ProjectError(
            f'{in_place.where}: "{choice.method}" needs the height of the building; add a table [building] with height'
        )
    try:
        if choice.method == EC8_AS_PRINTED:
            factor = ec8_resonant_part_factor_with_soil(
                height, building_height=building, soil_factor=choice.soil_factor
            )
            clause_text: Term | Message = message("clause-3-49", {"soil": Quantity(choice.soil_factor)})
        else:
            rule, clause = FLOOR_FACTORS[choice.method]
            clause_text = Term(clause)
            factor = rule(height, building_height=building)
    except SpectrumError as error:
        raise ProjectError(f"{in_place.where}.height: {error}") from None
    description = note(
        "by-floor-factor",
        in_place.where,
        factor=Quantity(factor),
        height=Quantity(height, "length"),
        building=Quantity(building, "length"),
        clause=clause_text,
    )
    return MechanismAmplification(
        choice.method,
        height,
        FloorFactor(factor, str(clause_text)),
        (description, "not checked against the printed standard"),
    )


def _amplify_by_first_mode(
    choice: AmplificationChoice, in_place: MechanismInPlace, *, height: float
) -> MechanismAmplification:
    """Return the amplification by the first mode, with values given or by Rayleigh's method."""
    structure = in_place.structure
    frequency, effective = given_frequency(choice, structure), given_effective_height(choice, structure)
    assumed: tuple[Message, ...] = ()
    missing: tuple[Missing, ...] = ()
    if frequency is not None and effective is None and not _has_own_mode(in_place):
        linear = linear_mode_height(in_place)
        if linear is not None:
            effective = linear, LINEAR_MODE
            why = message("missing-effective-height", {"height": Quantity(linear, "length")})
            missing = (missing_input("building.effective_height", why, f'effective_height = "{linear:.3g} m"'),)
    if frequency is None or effective is None:
        rayleigh = _rayleigh_mode_of(in_place)
        frequency = frequency or (rayleigh.frequency, RAYLEIGH)
        effective = effective or (rayleigh.effective_height, RAYLEIGH)
        values: dict[str, Value] = {"slices": whole_number(SLICES), "assumptions": Term(ASSUMPTIONS)}
        assumed = (warning("by-rayleigh", in_place.where, **values),)
    damping = structure.damping
    mode = first_mode(frequency=frequency[0], effective_height=effective[0], damping=damping)
    description = note(
        "by-first-mode",
        in_place.where,
        frequency=Quantity(frequency[0], "frequency"),
        frequency_from=Term(frequency[1]),
        effective=Quantity(effective[0], "length"),
        effective_from=Term(effective[1]),
        damping=Quantity(damping, "ratio", 3),
        height=Quantity(height, "length"),
        shape=Quantity(mode.shape(height)),
    )
    make, how = FIRST_MODES[choice.method]
    return MechanismAmplification(
        choice.method,
        height,
        make(mode, height),
        (how, description),
        assumed,
        by_stiffness=bool(assumed),
        missing=missing,
    )


def _has_own_mode(in_place: MechanismInPlace) -> bool:
    """Return whether Rayleigh's method gives the first mode of a mechanism."""
    try:
        _rayleigh_mode_of(in_place)
    except ProjectError:
        return False
    return True


def _rayleigh_mode_of(in_place: MechanismInPlace) -> RayleighMode:
    """Return the first mode by Rayleigh's method of the bodies of a single block on the ground, in its direction."""
    definition, scene = in_place.definition, in_place.built.scene
    stands = MECHANISM_KINDS[definition.kind].support == "free"
    if not isinstance(definition, BlockMechanism) or not stands or scene is None:
        raise _missing_mode(
            in_place, "only a single-block of bodies that stand on the ground has a first mode of its own"
        )
    solids = [solid for block in definition.blocks for solid in solids_of_block(block, in_place.bodies)]
    moduli = [young_modulus(solid.name, in_place) for solid in solids]
    foot = min(float(solid.vertices[:, 2].min()) for solid in solids)
    ground = in_place.ground.elevation or 0.0
    if abs(foot - ground) > NEAR_GROUND:
        raise _missing_mode(in_place, f"its bodies begin at z = {foot:.4g} m, the ground is at {ground:.4g} m")
    try:
        return _mode_of_bodies(tuple(solids), tuple(moduli), tuple(scene.direction.tolist()))
    except GeometryError as error:
        raise ProjectError(f"{in_place.where}: {error}") from None


@lru_cache(maxsize=64)
def _mode_of_bodies(solids: tuple[Solid, ...], moduli: tuple[float, ...], direction: tuple[float, ...]) -> RayleighMode:
    """Return the first mode of bodies, which works on what they carry leave as it is."""
    return rayleigh_mode(slice_cantilever(solids, moduli, direction=direction))


def _missing_mode(in_place: MechanismInPlace, why: str) -> ProjectError:
    return ProjectError(
        f"{in_place.where}: natural_frequency and effective_height: not both given, and {why}; give both here or in "
        "[building]"
    )


def _mean_support_height(base: float, mechanism: Mechanism) -> float:
    """Return the height of the support above the ground [m]: of the base, or the mean of base and far support."""
    return max(base, 0.0) + height_of_support(mechanism) / 2.0


def _contradicted_level(
    base: float, drawn_base: float, lowest: float, mechanism: Mechanism, ground: GroundLevel
) -> tuple[Message, ...]:
    """Return why a base_elevation below the drawn base cannot be right: the project defines the level of the ground.

    It does so by ground_elevation, or by bodies under the mechanism, which is then not drawn alone.
    """
    nothing_below = lowest > mechanism.elevation - NEAR_ZERO
    if base >= drawn_base - NEAR_ZERO or (nothing_below and ground.elevation is None):
        return ()
    return (
        reason_message(
            Reason.GROUND_CONTRADICTED, given=Quantity(base, "length"), drawn=Quantity(drawn_base, "length")
        ),
    )


def _source_of_level(ground: GroundLevel, base_elevation: float | None, *, by_table: bool) -> str:
    """Return which key defines the level of the ground, in words; empty if none does."""
    if base_elevation is not None:
        return BY_MECHANISM
    if ground.elevation is not None:
        return BY_BUILDING
    return BY_TABLE if by_table else ""
