"""The response of one branch of a face-loaded wall: effective thickness, period and demand."""

from __future__ import annotations

from dataclasses import dataclass

from scipy.constants import g

from assess.codes.check import BranchName
from assess.codes.context import Context, Gravity
from assess.codes.nzsee2017.clauses import (
    USABLE,
    Options,
    Part,
    demand_per_pga,
    floor_factor,
    nominal,
    period,
    thickness_factor,
    uplift_pga,
    with_effective_thickness,
)
from assess.oscillator import Branch, threshold


@dataclass(frozen=True)
class Response:
    """One branch by the clause.

    whole, part : with its own and with its effective thickness; gravity : None where they are the same
    Tp : period [s]; usable : phi_m / phi_i [-]; floor : C_Hi [-]; risk_factor : R_p [-]
    surface : C(0) over the PGA of the spectrum [-]
    per_pga : phi_D over PGA [rad s2/m]; multiplier : at rest [-], uplift : PGA below which nothing rocks [m/s2]; both
    None on joints without a threshold
    """

    whole: Part
    part: Part
    gravity: Gravity | None
    Tp: float
    usable: float
    floor: float
    risk_factor: float
    surface: float
    per_pga: float
    multiplier: float | None
    uplift: float | None

    @property
    def thickness(self) -> float:
        """t_eff / t [-]."""
        return 1.0 if self.gravity is None else thickness_factor(self.gravity.overburden_ratio)

    @property
    def instability(self) -> float:
        """phi_i [rad]."""
        return self.part.line.instability

    @property
    def usable_rotation(self) -> float:
        """phi_m [rad]."""
        return self.usable * self.instability

    @property
    def capacity(self) -> float:
        """PGA at 100 %NBS [m/s2]."""
        return max(self.usable_rotation / self.per_pga, self.uplift or 0.0)


def response(branch: Branch, name: BranchName, context: Context, options: Options) -> Response:
    """Return line, period and demand of one branch.

    Parameters
    ----------
    branch, name : the direction of rocking
    context : site, building and size of the wall
    options : usable rotation, R_p and C(0), where they are given

    Returns
    -------
    Response
    """
    whole, floor = nominal(branch), floor_factor(context)
    gravity = gravity_of(whole, name, context)
    part = whole if gravity is None else with_effective_thickness(whole, gravity)
    Tp, R_p, at_rest = period(part, support=context.support), options.risk_factor, threshold(branch)
    multiplier = None if at_rest is None else at_rest * (part.line.b / part.B) / (whole.line.b / whole.B)
    surface = 1.0 if options.c_0 is None else options.c_0 * g / context.spectrum.pga
    return Response(
        whole=whole,
        part=part,
        gravity=gravity,
        Tp=Tp,
        usable=USABLE[context.support] if options.usable is None else options.usable,
        floor=floor,
        risk_factor=R_p,
        surface=surface,
        per_pga=surface * demand_per_pga(part, Tp, floor=floor, risk_factor=R_p),
        multiplier=multiplier,
        uplift=uplift_pga(multiplier, floor=surface * floor, risk_factor=R_p),
    )


def is_overloaded(name: BranchName, context: Context) -> bool:
    """Return whether the load on the wall leaves it no effective thickness."""
    gravity = {} if context.wall is None else context.wall.gravity
    return name in gravity and thickness_factor(gravity[name].overburden_ratio) == 0.0


def gravity_of(whole: Part, name: BranchName, context: Context) -> Gravity | None:
    """Return what the effective thickness acts on; None for a wall that stands free.

    Where the wall's weight and load are not known apart, all of it counts as the wall's own.
    """
    if context.support != "spanning":
        return None
    known = {} if context.wall is None else context.wall.gravity
    return known.get(name, Gravity(0.0, whole.line.b, 0.0, whole.line.a, whole.J, 0.0, whole.B))
