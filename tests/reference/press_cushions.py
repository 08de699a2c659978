#!/usr/bin/python3
"""The force at which an apple first yields between cushions, apart from the simulator: a sphere as an elastic half-space
under rings of pressure, a cushion that answers each place by its own law, and the stress on the axis below them.

    press_cushions.py        prints a line for each gripper of configs/apple_pads.toml (docs/validation.md, "Cushions")
"""
import sys
import tomllib
from pathlib import Path

import numpy as np
from scipy.special import ellipe, ellipk

CONFIGS = Path(__file__).resolve().parent.parent.parent / "configs"
RINGS, REACH_M = 160, 0.030


def read(name):
    with (CONFIGS / name).open("rb") as file:
        return tomllib.load(file)


def sag_under_disc(place_m, radius_m, modulus_Pa):
    """Of the half-space's surface, per pressure over a disc (Johnson 1985, section 3.4). modulus: E / (1 - nu^2)."""
    sag = np.empty_like(place_m)
    inside = place_m < radius_m
    k = (place_m[inside] / radius_m) ** 2
    sag[inside] = 4 * radius_m / (np.pi * modulus_Pa) * ellipe(k)
    r, m = place_m[~inside], (radius_m / place_m[~inside]) ** 2
    sag[~inside] = 4 * r / (np.pi * modulus_Pa) * (ellipe(m) - (1 - m) * ellipk(m))
    return sag


def shear_below_disc(depth_m, radius_m, poisson_ratio):
    """sigma_r - sigma_z on the axis, per pressure over a disc."""
    slant = np.sqrt(radius_m**2 + depth_m**2)
    along = -(1 - (depth_m / slant) ** 3)
    across = -0.5 * ((1 + 2 * poisson_ratio) - 2 * (1 + poisson_ratio) * depth_m / slant + (depth_m / slant) ** 3)
    return across - along


def rings_of(of_disc, edges):
    """What a ring does is what its outer disc does less the inner one."""
    discs = [np.zeros_like(of_disc(edges[1]))] + [of_disc(edge) for edge in edges[1:]]
    return np.stack([outer - inner for inner, outer in zip(discs[:-1], discs[1:])], axis=-1)


def pressures(gap, sag, law, start):
    """Newton on gap - sag p - depth(p) = 0 where p > 0, with steps that stay near the present piece of the law."""
    depth, pressure = law
    p = start
    for _ in range(400):
        free = gap - sag @ p
        at = np.flatnonzero((p > 0) | (free > 0))
        piece = np.clip(np.searchsorted(pressure, p[at], side="right") - 1, 0, len(pressure) - 2)
        give = (depth[piece + 1] - depth[piece]) / (pressure[piece + 1] - pressure[piece])
        step = np.linalg.solve(sag[np.ix_(at, at)] + np.diag(give), free[at] - np.interp(p[at], pressure, depth))
        most = np.maximum(0.5 * p[at], 0.5 * pressure[1])
        new = p.copy()
        new[at] = np.maximum(p[at] + np.clip(step, -most, most), 0)
        change, p = np.max(np.abs(new - p)), new
        if change < 1e-4 * max(p.max(), 1.0):
            return p
    raise RuntimeError("the pressures did not converge")


def force_at_first_yield(radius_m, modulus_Pa, poisson_ratio, yield_Pa, law):
    edges = np.linspace(0.0, REACH_M, RINGS + 1)
    place = 0.5 * (edges[1:] + edges[:-1])
    area = np.pi * (edges[1:] ** 2 - edges[:-1] ** 2)
    sag = rings_of(lambda a: sag_under_disc(place, a, modulus_Pa / (1 - poisson_ratio**2)), edges)
    below = np.linspace(1e-4, 0.02, 300)
    shear = rings_of(lambda a: shear_below_disc(below, a, poisson_ratio), edges)
    behind = radius_m - np.sqrt(radius_m**2 - place**2)
    p, before = np.zeros(RINGS), (0.0, 0.0)
    approach_m, step_m = 0.0, 2e-5
    while True:
        approach_m += step_m
        p = pressures(approach_m - behind, sag, law, p)
        force, stress = float((p * area).sum()), float(np.abs(shear @ p).max())
        if stress >= yield_Pa:
            share = (yield_Pa - before[1]) / (stress - before[1])
            return before[0] + share * (force - before[0]), approach_m, float(p[0])
        before = (force, stress)


def law_of(gripper):
    """Depth and pressure."""
    pad = gripper.get("pad")
    if pad is None:
        deepest_m = 1e-3
        return np.array([0.0, deepest_m]), np.array([0.0, gripper["pad_modulus_Pa"] / gripper["pad_thickness_m"] * deepest_m])
    area_m2 = gripper["pad_size_m"][0] * gripper["pad_size_m"][1]
    return np.array(pad["law_depth_m"]), np.array(pad["law_force_N"]) / area_m2


def main():
    study = read("apple_pads.toml")
    apple = read(study["product"]["use"]) | study["product"]
    for name in study["vary"][0]["values"]:
        force, approach_m, peak_Pa = force_at_first_yield(0.5 * apple["size_m"][0], apple["youngs_modulus_Pa"],
                                                          apple["poisson_ratio"], apple["yield_stress_Pa"], law_of(read(name)))
        print(f"{name}: first yield at {force:.1f} N, pads {1e3 * approach_m:.2f} mm deep in all, {1e-3 * peak_Pa:.0f} kPa")


if __name__ == "__main__":
    sys.exit(main())
