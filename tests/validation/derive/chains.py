"""Chains of rigid blocks on four hinges, or three with a top that slides: energies by complex steps.

Makris and Vassiliou 2013; DeJong and Dimitrakopoulos 2014; Doherty et al. 2002. Positions follow from lengths; first
derivatives are taken along the imaginary axis, exact to rounding, the second by central differences of the first.
"""

from __future__ import annotations

from collections.abc import Callable
from math import atan, atan2, cos, hypot, sin, sqrt, tan

import numpy as np
from scipy.constants import g
from scipy.optimize import brentq

STEP = 1e-30


class Chain:
    """Blocks (mass, centroid, polar inertia) on hinges A, B, C, D; the first turns by phi about A."""

    def __init__(self, blocks, hinges):
        self.blocks, self.hinges = blocks, [complex(*h) for h in hinges]

    def _turned(self, phi):
        """Positions of centroids (x, z) and the turns of blocks at a complex phi, clockwise positive."""
        A, B, C, D = self.hinges
        c, s = np.cos(phi), np.sin(phi)

        def about(point, pivot, moved, c, s):
            x, z = (point - pivot).real, (point - pivot).imag
            return moved[0] + c * x + s * z, moved[1] - s * x + c * z

        a = (A.real, A.imag)
        b = about(B, A, a, c, s)
        # C lies on the circles of |BC| about b and of |DC| about D, near where it was
        r1, r2 = abs(C - B), abs(C - D)
        dx, dz = D.real - b[0], D.imag - b[1]
        d2 = dx * dx + dz * dz
        along = (r1**2 - r2**2 + d2) / (2 * d2)
        across = np.sqrt(r1**2 / d2 - along**2)
        sign = 1.0 if (dx.real * (C.imag - b[1].real) - dz.real * (C.real - b[0].real)) > 0 else -1.0
        cx = b[0] + along * dx - sign * across * dz
        cz = b[1] + along * dz + sign * across * dx
        centroids, turns = [], []
        for (_, at, _), (pivot, moved, other, there) in zip(
            self.blocks,
            ((A, a, B, b), (B, b, C, (cx, cz)), (D, (D.real, D.imag), C, (cx, cz))),
            strict=True,
        ):
            x0, z0 = (other - pivot).real, (other - pivot).imag
            x1, z1 = there[0] - moved[0], there[1] - moved[1]
            n = x0 * x0 + z0 * z0
            ck, sk = (x0 * x1 + z0 * z1) / n, (z0 * x1 - x0 * z1) / n
            centroids.append(about(complex(*at), pivot, moved, ck, sk))
            turns.append((ck, sk))
        return centroids, turns

    def rates(self, phi):
        """Return I, the weights' moment that resists, and B = sum of m dx/dphi, at phi."""
        centroids, turns = self._turned(complex(phi, STEP))
        inertia = moment = push = 0.0
        for (mass, _, polar), (x, z), (ck, sk) in zip(self.blocks, centroids, turns, strict=True):
            vx, vz = np.imag(x) / STEP, np.imag(z) / STEP
            w = (np.real(ck) * np.imag(sk) - np.real(sk) * np.imag(ck)) / STEP
            inertia += mass * (vx * vx + vz * vz) + polar * w * w
            moment += mass * g * vz
            push += mass * vx
        return inertia, moment, push

    def parameters(self, highest):
        """Return p and lambda linearised about the unstable equilibrium, its rotation, and the uplift multiplier."""
        phi = brentq(lambda x: self.rates(x)[1], 1e-6, highest, xtol=1e-15)
        h = 1e-4
        slope = (8 * (self.rates(phi + h)[1] - self.rates(phi - h)[1]) -
                 (self.rates(phi + 2 * h)[1] - self.rates(phi - 2 * h)[1])) / (12 * h)  # fmt: skip
        inertia, _, push = self.rates(phi)
        _, moment, lifting = self.rates(0.0)
        return {
            "p": sqrt(-slope / inertia),
            "λ": -slope * phi / (g * push),
            "φ_ov": phi,
            "uplift multiplier": moment / (g * lifting),
        }


def box(thickness, height, x, z, density=2400.0):
    """Mass, centroid and polar inertia per metre of a box on (x, z)."""
    mass = density * thickness * height
    return mass, (x, z + height / 2), mass * (thickness**2 + height**2) / 12


def portal_of(left, right, span, beam, beam_density):
    """Columns (thickness, height) `span` apart under a level beam of that depth, hinged at opposite corners."""
    (b1, h1), (b2, h2) = left, right
    length = span + (b1 + b2) / 2
    top = box(length, beam, (span + (b2 - b1) / 2) / 2, max(h1, h2), beam_density)
    foot = h1 - h2  # the shorter column stands on a plinth
    return Chain(
        (box(b1, h1, 0.0, 0.0), top, box(b2, h2, span, foot)),
        ((b1 / 2, 0.0), (-b1 / 2, h1), (span - b2 / 2, h1), (span + b2 / 2, foot)),
    )


GAMMAS = {"γ = 0.3": 0.3, "γ = 1": 1.0, "γ = 7": 7.0}
WIDTH, HEIGHT, SPAN, DEPTH = 0.9, 5.4, 4.0, 0.8


def portal():
    """p / sqrt(3 g / 4 R) = sqrt((1 + 2 gamma) / (1 + 3 gamma)); restitution with 3 gamma cos 2 alpha."""
    alpha, R = atan2(WIDTH, HEIGHT), hypot(WIDTH, HEIGHT) / 2
    p = sqrt(3 * g / (4 * R))
    return {
        "p": {row: p * sqrt((1 + 2 * y) / (1 + 3 * y)) for row, y in GAMMAS.items()},
        "φ_ov": dict.fromkeys(GAMMAS, alpha),
        "uplift multiplier": {row: tan(alpha) for row in GAMMAS},
        "η": {row: (1 - 1.5 * sin(alpha) ** 2 + 3 * y * cos(2 * alpha)) / (1 + 3 * y) for row, y in GAMMAS.items()},
    }


UNEQUAL = {"short right": ((0.9, 5.4), (0.9, 4.0)), "thin right": ((0.9, 5.4), (0.6, 5.4))}


def _by_quantity(found):
    names = next(iter(found.values()))
    return {name: {row: values[name] for row, values in found.items()} for name in names}


def unequal_portal():
    """Asymmetric portals: a chain of four bars, linearised about its unstable equilibrium."""
    return _by_quantity(
        {row: portal_of(*columns, SPAN, DEPTH, 2400.0).parameters(0.6) for row, columns in UNEQUAL.items()}
    )


WALLS = {"0.11 × 3.3 m": (0.11, 3.3), "0.23 × 4.0 m": (0.23, 4.0), "0.60 × 3.0 m": (0.60, 3.0)}


def spanning_wall():
    """A wall cracked at mid-height, hinged at opposite faces: lambda = 4 t / h, unstable where AB is upright."""
    return {
        "uplift multiplier": {row: 4 * t / h for row, (t, h) in WALLS.items()},
        "φ_ov": {row: atan(2 * t / h) for row, (t, h) in WALLS.items()},
    }


SOLID = {"0.2 × 4 m": (0.2, 4.0), "0.6 × 6 m": (0.6, 6.0)}


def equivalent_block():
    """A block by its table, and by geometry: both are the block of Housner."""
    found = {}
    for row, (b, h) in SOLID.items():
        alpha, R = atan(b / h), hypot(b, h) / 2
        found[row] = {"p": sqrt(3 * g / (4 * R)), "φ_ov": alpha, "η": 1 - 1.5 * sin(alpha) ** 2}
    return _by_quantity(found)


def one_sided():
    """|e|, e = (1 - 1.5 sin^2 alpha)^2 (1 - 1.5 cos^2 alpha)."""
    angle = {row: atan(b / h) for row, (b, h) in {**SOLID, "1.0 × 2 m": (1.0, 2.0)}.items()}
    return {
        "rebound": {row: abs((1 - 1.5 * sin(a) ** 2) ** 2 * (1 - 1.5 * cos(a) ** 2)) for row, a in angle.items()}
    }  # fmt: skip


def facade():
    """A façade 0.25 m by 3.44 m on a transverse wall: alpha, p and the rebound of a plain block of its size."""
    alpha, R = atan(0.25 / 3.44), hypot(0.25, 3.44) / 2
    rebound = abs((1 - 1.5 * sin(alpha) ** 2) ** 2 * (1 - 1.5 * cos(alpha) ** 2))
    return {"α": {"": alpha}, "p": {"": sqrt(3 * g / (4 * R))}, "rebound": {"": rebound}}


GRANITE = {"specimen 1": 0.25, "specimen 2": 0.17, "specimen 3": 0.12}


def granite():
    """Blocks of granite 1.0 m high: alpha, p and restitution of rectangles."""
    alpha = {row: atan(b) for row, b in GRANITE.items()}
    return {
        "α": alpha,
        "p": {row: sqrt(3 * g / (2 * hypot(b, 1.0))) for row, b in GRANITE.items()},
        "η": {row: 1 - 1.5 * sin(a) ** 2 for row, a in alpha.items()},
    }


VALUES: dict[str, Callable[[], dict[str, dict[str, float]]]] = {
    "makris_vassiliou_2013/portal": portal,
    "dejong_dimitrakopoulos_2014/unequal_portal": unequal_portal,
    "dejong_dimitrakopoulos_2014/single_block": equivalent_block,
    "doherty_2002/spanning_wall": spanning_wall,
    "sorrentino_2011/one_sided": one_sided,
    "al_shawa_2012/facade": facade,
    "pena_2007/granite_blocks": granite,
}
