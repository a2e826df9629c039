"""Checks of codes on plain walls, by their clauses: worked here without the program.

Bending curves are those of a rigid block, not straightened: sin and tan of what remains to the unstable equilibrium.
"""

from __future__ import annotations

from math import acosh, asin, atan, cos, hypot, log, pi, sin, sqrt, tan

from scipy.constants import g
from scipy.optimize import brentq

B, H = 0.6, 6.0  # of the wall of the Italian checks
A_G, F_0, T_C_STAR = 0.261, 2.364, 0.347
S = min(1.2, 1.4 - 0.4 * F_0 * A_G)  # soil B
T_C, T_D = 1.10 * T_C_STAR**-0.20 * T_C_STAR, 4 * A_G + 1.6
LC1 = 1.35


def _s_e(T, damping):
    """S_e of NTC 2018 3.2.3.2.1 [m/s2], T from T_B on."""
    eta = max(sqrt(10 / (5 + 100 * damping)), 0.55)
    return A_G * g * S * eta * F_0 * min(1, T_C / T) * min(1, T_D / T)


def _secant(height, share, FC):
    """d0*, d and a(d) of a wall B thick, at a share of d0*."""
    R = hypot(B, height) / 2
    d0 = B / 2
    return d0, share * d0, tan(asin((1 - share) * d0 / R)) * g / FC


def ntc_at_the_ground():
    """C8.7.1.2: a0* = alpha_0 g / FC; at 0.4 d0* a(d), T = 1.68 pi sqrt(d / a), S_De by 8 % of damping."""
    d0, d, a = _secant(H, 0.4, LC1)
    T = 1.68 * pi * sqrt(d / a)
    demand = _s_e(T, 0.08) * (T / (2 * pi)) ** 2
    linear = A_G * g * S / 2
    a0 = B / H * g / LC1
    return {
        "linear": {"a0*": a0, "a_max / q": linear},
        "linear index": {"": 2 * a0 / (A_G * g * S)},
        "non-linear": {"d0*": d0, "a(d_SLV)": a, "T_SLV": T, "S_De(T)": demand},
        "ratio": {"": demand / d},
    }


def ntc_at_height():
    """C7.2.5 to C7.2.11 on 6 m of 9 m, three storeys, T_1 = 0.28 s doubled, 10 %: the floor decides."""
    _, d, a = _secant(3.0, 0.4, LC1)
    T = 1.68 * pi * sqrt(d / a)
    first, xi = 0.56, 0.10
    a_z = _s_e(first, xi) * 9 / 7 * 6 / 9 * sqrt(1 + 0.0004 * (100 * xi) ** 2)
    A = 1.1 / sqrt(xi) * sqrt(10 / 13)
    s_ez = A * a_z / (1 + (A - 1) * (T / (1.1 * first) - 1) ** 1.2)
    return {
        "non-linear": {"a(d_SLV)": a, "T_SLV": T, "a_Z(T1')": a_z, "A": A, "S_eZ(T_SLV)": s_ez},
        "demand": {"": s_ez * (T / (2 * pi)) ** 2},
    }


def circular_2009():
    """C8A.4: d_u* = 0.4 d_0*, d_s* = 0.4 d_u*, T_s = 2 pi sqrt(d_s / a_s); S_D1 = 0.2 g on its branch 1 / T."""
    d0, ds, a_s = _secant(H, 0.16, LC1)
    T = 2 * pi * sqrt(ds / a_s)
    demand = 0.2 * g / T * (T / (2 * pi)) ** 2
    return {
        "non-linear": {"d0*": d0, "d_u*": 0.4 * d0, "d_s*": ds, "a_s*": a_s, "T_s": T},
        "demand": {"": demand},
        "linear": {"a0*": B / H * g / LC1},
    }


W, L, P_T = 1800.0 * 0.23 * 4.0 * g, 4.0, 0.23
E = {"0": (0.0, 0.0), "1": (0.0, 0.5), "2": (0.5, 0.0), "3": (0.5, 0.5)}


def _b_and_j(case, W, P, t):
    """b and J g of C8B for the eccentricities of P and of the base, over t."""
    return {
        "0": ((W / 2 + P) * t, W / 12 * (L**2 + 7 * t**2) + P * t**2),
        "1": ((W + 1.5 * P) * t, W / 12 * (L**2 + 16 * t**2) + 2.25 * P * t**2),
        "2": ((W / 2 + 1.5 * P) * t, W / 12 * (L**2 + 7 * t**2) + 2.25 * P * t**2),
        "3": ((W + 2 * P) * t, W / 12 * (L**2 + 16 * t**2) + 4 * P * t**2),
    }[case]


def nzsee_boundary_cases():
    """C8B with t_eff = t (0.975 - 0.025 P / W), P = W / 2: from Delta_i to %NBS; h_i = 4 m of 8 m, Z = 0.4, class C."""
    share = 0.5
    k = 0.975 - 0.025 * share
    weight, P, t = k * W, share * W, k * P_T
    found = {}
    for case in E:
        b, gJ = _b_and_j(case, weight, P, t)
        a = (weight / 2 + P) * L
        delta = b * L / (2 * a)
        T = 4.0 * acosh(1.0 / (1.0 - 0.36)) * sqrt(gJ / g / a)
        gamma = weight * L**2 / (8 * gJ)
        C_p = 0.532 * 5 / 3 * min(max(2 * (1.75 - T), 0.5), 2.0)
        D = gamma * (T / (2 * pi)) ** 2 * C_p * g
        found[f"case {case}"] = {"Δ_i": delta, "T_p": T, "D_ph": D, "%NBS": 60 * delta / D}
    return {name: {row: each[name] for row, each in found.items()} for name in ("Δ_i", "T_p", "D_ph", "%NBS")}


def asce43():
    """A.2 of ASCE 43-05 by hand: S_DS = 0.9 g, S_D1 = 0.4 g, and 1.25 S_a at 2 % of damping and less."""
    a, h = 0.2, 2.5
    alpha = atan(a)
    C1 = 4 / 3 * (1 + a * a)
    gamma = -2 * log(1 - 2 * a * a / C1)
    f1 = lambda x: cos(x) + a * sin(x) - 1  # noqa: E731
    capacity = lambda x: 2 * g * f1(x) / x  # noqa: E731
    frequency = lambda x: sqrt(2 * f1(x) * g / (C1 * x * x * h)) / (2 * pi)  # noqa: E731
    theta = brentq(lambda x: capacity(x) - 1.25 * 0.4 * g * frequency(x), 1e-4, 0.5 * alpha, xtol=1e-15)
    return {
        "steps": {
            "C1": C1, "γ": gamma, "β_e": gamma / sqrt(4 * pi**2 + gamma**2), "θ": theta, "f1": f1(theta),
            "SA_H,CAP": capacity(theta), "f_e": frequency(theta),
        },
        "θ over the third of α that is allowed": {"": 3.0 * theta / alpha},
    }  # fmt: skip


VALUES = {
    "ntc_2018/wall_at_the_ground": ntc_at_the_ground,
    "ntc_2018/wall_at_height": ntc_at_height,
    "circolare_617_2009/wall": circular_2009,
    "nzsee_2017/boundary_cases": nzsee_boundary_cases,
    "asce43_05/block": asce43,
}
