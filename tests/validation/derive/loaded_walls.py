"""Virtual work of walls with ties and with loads on top."""

from __future__ import annotations

from math import sqrt

from scipy.constants import g
from scipy.optimize import minimize_scalar

B, H, DENSITY = 0.6, 6.0, 1800.0
WEIGHT = DENSITY * B * H * g  # per metre
PULLS = {"tie at 5 m": (8e3, 5.0), "force at 5 m": (-3e3, 5.0)}
"""Horizontal force towards the wall's inside [N/m] and its height [m]: the tie holds, the force pushes."""


def tied_wall():
    """alpha_0 = (W b / 2 + F z) / (W h / 2): a tie holds one way only, a thrust helps the other way."""
    out = {name: (WEIGHT * B / 2 + F * z) / (WEIGHT * H / 2) for name, (F, z) in PULLS.items()}
    inwards = {"tie at 5 m": B / H, "force at 5 m": (WEIGHT * B / 2 + 3e3 * 5.0) / (WEIGHT * H / 2)}
    return {"uplift multiplier, outwards": out, "uplift multiplier, inwards": inwards}


SHARES = {"N = W/4": 0.25, "N = W": 1.0, "N = 4 W": 4.0}
T, L = 0.3, 4.0


def cracked_wall():
    """The crack of least multiplier of a wall of thickness T and height L under N at mid-thickness of its top.

    lambda(x) = 2 T / (x L) (x / 2 + (1 - x + n)(1 + r / 2)), r = x / (1 - x): lower part x L, hinges on opposite faces.
    """
    height, least = {}, {}
    for name, n in SHARES.items():
        found = minimize_scalar(
            lambda x, n=n: 2 * T / (x * L) * (x / 2 + (1 - x + n) * (1 + x / (1 - x) / 2)),
            bounds=(0.3, 0.999), method="bounded", options={"xatol": 1e-12},
        )  # fmt: skip
        x = 1 / (1 + sqrt(n / (2 * (1 + n))))  # eq. 3.27 of the thesis for no tension
        assert abs(found.x - x) < 1e-6
        height[name], least[name] = x * L, found.fun
    return {"uplift multiplier": least}


VALUES = {"virtual_work/tied_wall": tied_wall, "virtual_work/cracked_wall": cracked_wall}
