"""The amplification of the ground motion up to the base of a mechanism; Rayleigh's method for values not given."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from assess.amplification.floor_motion import (
    FirstMode,
    FloorFactor,
    ModalFilter,
    Srss,
    SrssRelative,
    Unamplified,
    first_mode,
)
from assess.amplification.natural_frequency import ASSUMPTIONS, SLICES, Rayleigh, rayleigh_mode, slice_cantilever
from assess.errors import GeometryError, ProjectError
from assess.mechanisms.limits import height_of_support
from assess.messages.message import Message, Quantity, Term, Value, message, note, warning, whole_number
from assess.model.assembly import Built
from assess.model.body import Bodies
from assess.model.definitions import Definition, SingleBlock
from assess.study.grounding import Ground
from assess.study.study import Amplified
from spectra.errors import SpectrumError
from spectra.floor import ec8, ec8_at_resonance_with_soil, ec8_resonance, nzs1170_5

NEAR_GROUND = 0.05  # m: a body that stands no farther from the ground's elevation stands on it
DAMPING = 0.05  # of the first mode where there is no [building]
RAYLEIGH = "Rayleigh's method"
PRINTED = "ec8-printed"
AS_IT_IS = Amplified("none", None, Unamplified(), ())

FLOORS: dict[str, tuple[Callable[..., float], str]] = {
    "ec8": (ec8, "EN 1998-1, 4.3.5.2, rigid part (T_a = 0): 1.5 (1 + z/H) - 0.5 on the motion of the surface"),
    "ec8-resonance": (ec8_resonance, "EN 1998-1, 4.3.5.2, at resonance (T_a = T_1): 3 (1 + z/H) - 0.5"),
    "nzs1170.5": (nzs1170_5, "NZS 1170.5, 8.3: the least that applies of 1 + h/6, 1 + 10 h/H and 3"),
}

FIRST_MODES: dict[str, tuple[Callable[[FirstMode, float], Srss | SrssRelative | ModalFilter], str]] = {
    "srss": (Srss, "every record and pulse times sqrt((S_a(T_n)/a_g h/h_e)^2 + 1), thesis 3.48"),
    "srss-relative": (
        SrssRelative,
        "every record times sqrt((S_a(T_n)/a_g h/h_e)^2 + 1), thesis 3.48; every pulse by 3.47, with the response "
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

    method : of FLOORS or FIRST_MODES, or "ec8-printed"; height : of the mechanism's base above the ground [m]
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

    height [m]; natural_frequency [Hz], effective_height [m], damping [-] : of its first mode; period [s]
    """

    height: float | None = None
    natural_frequency: float | None = None
    effective_height: float | None = None
    period: float | None = None
    damping: float = DAMPING


@dataclass(frozen=True, kw_only=True)
class MechanismInPlace:
    """A mechanism with everything that affects the motion at its base.

    base_elevation : height of its base above the ground, if given for this mechanism [m]
    """

    name: str
    definition: Definition
    built: Built
    bodies: Bodies
    ground: Ground
    structure: Structure
    base_elevation: float | None = None

    @property
    def where(self) -> str:
        """The key, as errors name it."""
        return f"mechanisms.{self.name}.amplification"


def amplify(asked: AmplificationChoice | None, standing: MechanismInPlace) -> Amplified:
    """Find how the ground motion reaches the base of a mechanism.

    Parameters
    ----------
    asked : AmplificationChoice, optional
        The method; None for the ground motion as it is.
    standing : MechanismInPlace
        The mechanism in its place.

    Returns
    -------
    Amplified
        The amplification, with its description.

    Raises
    ------
    ProjectError
        If a value is missing, or a height is outside the clause.
    """
    if asked is None:
        return AS_IT_IS
    height = height_of(asked, standing)
    if asked.method in FIRST_MODES:
        return by_first_mode(asked, standing, height=height)
    return by_floor_factor(asked, standing, height=height)


def height_of(asked: AmplificationChoice, standing: MechanismInPlace) -> float:
    """Return the height of the support above the ground [m]: given, the base, or the mean of base and far support."""
    if asked.height is not None:
        return asked.height
    mechanism = standing.built.mechanism
    base = standing.ground.below(mechanism, standing.base_elevation)
    if base < -NEAR_GROUND:
        raise ProjectError(
            f"{standing.where}.height: the mechanism begins {-base:.3g} m below the ground; give height, or "
            "building.ground_elevation"
        )
    return max(base, 0.0) + height_of_support(mechanism) / 2.0


def by_floor_factor(asked: AmplificationChoice, standing: MechanismInPlace, *, height: float) -> Amplified:
    """Return the amplification by the factor of a code for the height [m]."""
    building = standing.structure.height
    if building is None:
        raise ProjectError(
            f'{standing.where}: "{asked.method}" needs the height of the building; add a table [building] with height'
        )
    try:
        if asked.method == PRINTED:
            factor = ec8_at_resonance_with_soil(height, building_height=building, soil_factor=asked.soil_factor)
            said_clause: Term | Message = message("clause-3-49", {"soil": Quantity(asked.soil_factor)})
        else:
            rule, clause = FLOORS[asked.method]
            said_clause = Term(clause)
            factor = rule(height, building_height=building)
    except SpectrumError as error:
        raise ProjectError(f"{standing.where}.height: {error}") from None
    said = note(
        "by-floor-factor",
        standing.where,
        factor=Quantity(factor),
        height=Quantity(height, "length"),
        building=Quantity(building, "length"),
        clause=said_clause,
    )
    return Amplified(
        asked.method, height, FloorFactor(factor, str(said_clause)), (said, "not checked against the printed standard")
    )


def by_first_mode(asked: AmplificationChoice, standing: MechanismInPlace, *, height: float) -> Amplified:
    """Return the amplification by the first mode, with values given or by Rayleigh's method."""
    structure = standing.structure
    frequency, effective = given_frequency(asked, structure), given_effective_height(asked, structure)
    assumed: tuple[Message, ...] = ()
    if frequency is None or effective is None:
        found = rayleigh_mode_of(standing)
        frequency = frequency or (found.frequency, RAYLEIGH)
        effective = effective or (found.effective_height, RAYLEIGH)
        values: dict[str, Value] = {"slices": whole_number(SLICES), "assumptions": Term(ASSUMPTIONS)}
        assumed = (warning("by-rayleigh", standing.where, **values),)
    damping = structure.damping
    mode = first_mode(frequency=frequency[0], effective_height=effective[0], damping=damping)
    said = note(
        "by-first-mode",
        standing.where,
        frequency=Quantity(frequency[0], "frequency"),
        frequency_from=Term(frequency[1]),
        effective=Quantity(effective[0], "length"),
        effective_from=Term(effective[1]),
        damping=Quantity(damping, "ratio", 3),
        height=Quantity(height, "length"),
        shape=Quantity(mode.shape(height)),
    )
    make, how = FIRST_MODES[asked.method]
    return Amplified(asked.method, height, make(mode, height), (how, said), assumed, by_stiffness=bool(assumed))


def given_frequency(asked: AmplificationChoice, structure: Structure) -> tuple[float, str] | None:
    """Return the first natural frequency [Hz] that is given, and its source; None if none is."""
    if asked.natural_frequency is not None:
        return asked.natural_frequency, "given"
    if structure.natural_frequency is not None:
        return structure.natural_frequency, "given for the building"
    if structure.period is not None:
        return 1.0 / structure.period, "1 / period of the building"
    return None


def given_effective_height(asked: AmplificationChoice, structure: Structure) -> tuple[float, str] | None:
    """Return the effective height [m] that is given, and its source; None if none is."""
    if asked.effective_height is not None:
        return asked.effective_height, "given"
    if structure.effective_height is not None:
        return structure.effective_height, "given for the building"
    return None


def rayleigh_mode_of(standing: MechanismInPlace) -> Rayleigh:
    """Return the first mode by Rayleigh's method of the bodies of a single block on the ground, in its direction."""
    definition, scene = standing.definition, standing.built.scene
    if not isinstance(definition, SingleBlock) or scene is None:
        raise _missing(standing, "only a single-block of bodies that stand on the ground has a first mode of its own")
    names = definition.blocks[0]
    moduli = [young_modulus(name, standing) for name in names]
    solids = [solid for name in names if (solid := standing.bodies[name].solid) is not None]
    foot = min(float(solid.vertices[:, 2].min()) for solid in solids)
    ground = standing.ground.elevation or 0.0
    if abs(foot - ground) > NEAR_GROUND:
        raise _missing(standing, f"its bodies begin at z = {foot:.4g} m, the ground is at {ground:.4g} m")
    try:
        return rayleigh_mode(slice_cantilever(solids, moduli, direction=scene.direction.tolist()))
    except GeometryError as error:
        raise ProjectError(f"{standing.where}: {error}") from None


def young_modulus(name: str, standing: MechanismInPlace) -> float:
    """Return Young's modulus of a body [Pa]; raise ProjectError if it is not given."""
    material = standing.bodies[name].material
    if material is None:
        raise _missing(standing, f'body "{name}" has no geometry')
    modulus = material.young_modulus
    if modulus is None:
        raise _missing(standing, f"materials.{material.name} has no young_modulus for Rayleigh's method")
    return modulus


def _missing(standing: MechanismInPlace, why: str) -> ProjectError:
    return ProjectError(
        f"{standing.where}: natural_frequency and effective_height: not both given, and {why}; give both here or in "
        "[building]"
    )
