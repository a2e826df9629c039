"""The elastic spectra of EN 1998-1:2004 with the recommended values of its tables; a national annex may change them.

Not compared with the printed standard: the tables of types 1 and 2 and of vertical motion agree with public
implementations (eqdes, rshalib); T_E and T_F of Annex A are from memory, and equal those of the Italian code.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from functools import partial
from math import inf

from spectra.errors import SpectrumError
from spectra.spectrum import FourBranches, Spectrum, check_positive, plausibility_warnings

AMPLIFICATION, VERTICAL_AMPLIFICATION = 2.5, 3.0  # of the level branch, (3.3) and (3.9)
DAMPING_RULE = "EN 1998-1 eq. (3.6): eta = √(10 / (5 + ξ)) ≥ 0.55; not checked against the printed standard"


@dataclass(frozen=True)
class GroundType:
    """Soil factor S [-] and corner periods [s] of a ground type; T_E and T_F only where Annex A has them."""

    s: float
    t_b: float
    t_c: float
    t_d: float
    t_e: float = inf
    t_f: float = inf


GROUNDS: Mapping[int, Mapping[str, GroundType]] = {
    1: {  # Table 3.2; T_E, T_F: Table A.1
        "A": GroundType(1.00, 0.15, 0.4, 2.0, 4.5, 10.0),
        "B": GroundType(1.20, 0.15, 0.5, 2.0, 5.0, 10.0),
        "C": GroundType(1.15, 0.20, 0.6, 2.0, 6.0, 10.0),
        "D": GroundType(1.35, 0.20, 0.8, 2.0, 6.0, 10.0),
        "E": GroundType(1.40, 0.15, 0.5, 2.0, 6.0, 10.0),
    },
    2: {  # Table 3.3
        "A": GroundType(1.00, 0.05, 0.25, 1.2),
        "B": GroundType(1.35, 0.05, 0.25, 1.2),
        "C": GroundType(1.50, 0.10, 0.25, 1.2),
        "D": GroundType(1.80, 0.10, 0.30, 1.2),
        "E": GroundType(1.60, 0.05, 0.25, 1.2),
    },
}
SPECIAL_STUDY = ("S1", "S2")  # ground types that 3.1.2(4) leaves to one
VERTICAL_RATIO: Mapping[int, float] = {1: 0.90, 2: 0.45}  # a_vg / a_g, Table 3.4
VERTICAL_CORNERS = (0.05, 0.15, 1.0)  # T_B, T_C, T_D [s] of both types, Table 3.4


def elastic_spectrum(
    *,
    a_g: float,
    ground_type: str,
    spectrum_type: int = 1,
    importance_factor: float = 1.0,
    national: GroundType | None = None,
) -> Spectrum:
    """Return the horizontal elastic spectrum.

    The design ground acceleration is importance_factor a_gR. The standard gives the spectrum up to 4 s; beyond, its
    last branch continues, which is on the safe side of the displacements of Annex A (type 1 only).

    Parameters
    ----------
    a_g : a_gR, reference peak ground acceleration on type A [m/s2]
    ground_type : "A" to "E"
    spectrum_type : 1, or 2 where earthquakes of M_s <= 5.5 govern
    importance_factor : gamma_I [-]
    national : values of a national annex for the ground, in place of those recommended

    Raises
    ------
    SpectrumError : a value is not positive; the type or ground is unknown, or is S1 or S2; not T_B < T_C < T_D

    Source: EN 1998-1:2004, 3.2.2.2, (3.2)-(3.7), Tables 3.2 and 3.3; Annex A; importance 3.2.1(3).
    """
    check_positive("ec8", a_g=a_g, importance_factor=importance_factor)
    ground = _ground_type(ground_type, spectrum_type)
    if national is not None:
        ground = national
        check_positive("ec8", s=ground.s, t_b=ground.t_b)
        if not ground.t_b < ground.t_c < ground.t_d:
            raise SpectrumError(
                f"ec8 spectrum: t_b = {ground.t_b:.4g} s, t_c = {ground.t_c:.4g} s, t_d = {ground.t_d:.4g} s; they "
                "must rise"
            )
    design = importance_factor * a_g
    shape = FourBranches(design * ground.s, AMPLIFICATION, ground.t_b, ground.t_c, ground.t_d)
    annex_a = ground.t_e < inf
    return Spectrum(
        code="ec8",
        parameters={
            **_parameters(a_g, ground_type, spectrum_type, importance_factor),
            **{name: value for name, value in asdict(ground).items() if value < inf},
        },
        damping=0.05,
        damping_rule=DAMPING_RULE,
        ordinates=shape.ordinates,
        clause="EN 1998-1:2004, 3.2.2.2, recommended values"
        if national is None
        else "EN 1998-1:2004, 3.2.2.2, national values",
        displacements=partial(shape.displacements, t_e=ground.t_e, t_f=ground.t_f) if annex_a else None,
        warnings=plausibility_warnings(a_g=a_g),
    )


def vertical_spectrum(
    *, a_g: float, ground_type: str = "A", spectrum_type: int = 1, importance_factor: float = 1.0
) -> Spectrum:
    """Return the vertical elastic spectrum, which does not depend on the ground.

    Parameters
    ----------
    a_g, ground_type, spectrum_type, importance_factor : as in `elastic_spectrum`

    Source: EN 1998-1:2004, 3.2.2.3, (3.8)-(3.11), Table 3.4.
    """
    check_positive("ec8", a_g=a_g, importance_factor=importance_factor)
    _ground_type(ground_type, spectrum_type)
    a_vg = VERTICAL_RATIO[spectrum_type] * importance_factor * a_g
    t_b, t_c, t_d = VERTICAL_CORNERS
    return Spectrum(
        code="ec8",
        parameters={
            **_parameters(a_g, ground_type, spectrum_type, importance_factor),
            "a_vg": a_vg,
            "t_b": t_b,
            "t_c": t_c,
            "t_d": t_d,
        },
        damping=0.05,
        damping_rule=DAMPING_RULE,
        ordinates=FourBranches(a_vg, VERTICAL_AMPLIFICATION, t_b, t_c, t_d).ordinates,
        clause="EN 1998-1:2004, 3.2.2.3 (vertical), recommended values",
        warnings=plausibility_warnings(a_g=a_g),
    )


def _parameters(a_g: float, ground_type: str, spectrum_type: int, importance_factor: float) -> dict[str, float | str]:
    """Return the parameters of a spectrum, with the design ground acceleration."""
    return {
        "a_g": a_g,
        "importance_factor": importance_factor,
        "design_a_g": importance_factor * a_g,
        "ground_type": ground_type,
        "type": str(spectrum_type),
    }


def _ground_type(ground_type: str, spectrum_type: int) -> GroundType:
    if spectrum_type not in GROUNDS:
        raise SpectrumError(f"ec8 spectrum: type = {spectrum_type}; write 1 (M_s > 5.5) or 2 (EN 1998-1, 3.2.2.2(2)P)")
    if ground_type in SPECIAL_STUDY:
        raise SpectrumError(
            f"ec8 spectrum: ground_type = {ground_type}: EN 1998-1, 3.1.2(4)P asks for a special study of this ground; "
            'give its spectrum with code = "table"'
        )
    known = GROUNDS[spectrum_type]
    if ground_type not in known:
        raise SpectrumError(f"ec8 spectrum: ground_type = {ground_type}; choose one of {', '.join(known)}")
    return known[ground_type]
