"""Two mechanisms on which clauses can be worked out by hand: a straight capacity curve, and a slender block.

    M = 1000 kg, B = 2000 kg m, I = 8000 kg m2, sum m x'^2 = 5000 kg m2, all constant; lambda(phi) = 0.2 - phi

    e* = B^2 / (M sum m x'^2) = 0.8      d* = B phi / (M e*) = 2.5 phi      a* = (0.2 - phi) g / (0.8 FC)
    E(phi) = g B (0.2 phi - phi^2 / 2)   d0* = 0.5 m                        a0* = 0.25 g / FC

`SOFT` stands on joints without a threshold: restoring = c phi (0.2 - phi), with c such that T of small motions is 1 s.
`SPECTRUM` has S_DS = 0.5 g, S_D1 = 0.2 g, T_L = 6 s: PGA 0.2 g, S_a = 0.5 g from 0.08 s to 0.4 s, then 0.2 g / T.
`SLENDER` is a block of lambda = tan(alpha - phi) and d = R (sin alpha - sin(alpha - phi)), so that d0 = R sin alpha.
"""

from __future__ import annotations

from dataclasses import replace
from math import sin

import numpy as np
from scipy.constants import g

from assess.codes.context import Building, Context
from assess.codes.italian_limit_states import BranchCurves
from assess.mechanisms.single_block import equivalent_block
from assess.oscillator import Branch, Oscillator
from spectra.asce7 import design_spectrum

MASS = 1000.0
PHI = np.linspace(0.0, 0.25, 251)
STRAIGHT = Branch(
    rotation=PHI,
    inertia=np.full_like(PHI, 8000.0),
    restoring=2000.0 * g * (0.2 - PHI),
    excitation=np.full_like(PHI, 2000.0),
    participation=np.full_like(PHI, 5000.0),
    lift=np.zeros_like(PHI),
    restitution=0.9,
    overturning=0.2,
    critical=0.2,
)
CURVATURE = 8000.0 * (2.0 * np.pi) ** 2 / 0.2  # c: the stiffness at rest is 0.2 c = I (2 pi / 1 s)^2
SOFT = replace(STRAIGHT, restoring=CURVATURE * PHI * (0.2 - PHI), overturning_flexible=0.2)
OSCILLATOR = Oscillator(STRAIGHT, STRAIGHT, MASS)
CURVES = BranchCurves("positive", STRAIGHT, STRAIGHT, STRAIGHT, (), MASS)
SPECTRUM = design_spectrum(s_ds=0.5 * g, s_d1=0.2 * g, t_l=6.0)
GROUND = Context(SPECTRUM, (SPECTRUM.pga,), 0.0, 0.0, None)
HOUSE = Building(height=9.0, storeys=3, period=0.5, damping=0.05)
RAISED = replace(GROUND, elevation=6.0, building=HOUSE)  # psi = 6/9, gamma = 3 x 3 / (2 x 3 + 1) = 9/7


ALPHA, RADIUS = 0.1, 3.0
SLENDER = equivalent_block("w", p=1.6, uplift=ALPHA, radius=RADIUS).oscillator
D0 = RADIUS * sin(ALPHA)


def displacement(share: float) -> float:
    """Return d [m] at a share of alpha."""
    return RADIUS * (sin(ALPHA) - sin(ALPHA * (1 - share)))
