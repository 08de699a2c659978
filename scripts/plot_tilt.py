#!/usr/bin/python3
"""Draws the least grip force of configs/tilt_window.toml over the angle of the tilt, with its closed form.

    plot_tilt.py RESULTS.h5 [-o FILE.svg]     docs/images/tilt_window.svg unless given

F_hold is read from /window. The closed form is worked out from the study's numbers: half of the weight at the arm
d sin(angle) on each pad, which a pressed square holds until a rigid body turns against it.
Exit status: 0 drawn, 2 the file does not hold what is needed.
"""
import argparse
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from draw_pictures import INK, SOFT, save  # which sets the looks of the pictures
from window_tables import Unsuitable, read_results

KEY = "strategy.tilt_rad[0]"
# Of configs/tilt_window.toml and the files it uses.
WEIGHT_N, LIFT, FRICTION, PAD_M, ARM_M = 0.1 * 9.80665, 1 + 0.3 / 9.80665, 0.6, 0.030, 0.010
HELD = "#1b9e77"


def even_square(pad_m, count=300):
    """Places along an edge of an evenly pressed pad, and the share of the force at each."""
    return pad_m * ((np.arange(count) + 0.5) / count - 0.5), np.full(count, 1.0 / count)


def particles():
    """The same for the particles of cells of 10 mm: those on the edge of the pad stand for half a cell."""
    return np.array([-0.015, -0.005, 0.005, 0.015]), np.array([1, 2, 2, 1]) / 6


def share_at_arm(arm_m, places):
    """Friction force of a square pad at this arm from its middle, over mu N, as it begins to turn."""
    if arm_m <= 0.0:
        return 1.0
    line, share = places
    along, across = np.meshgrid(line, line)
    weight = np.outer(share, share)

    def friction(center_m):
        arm = across - center_m
        radius = np.maximum(np.hypot(along, arm), 1e-12)
        return (weight * arm / radius).sum(), (weight * (along**2 + across * arm) / radius).sum()

    far_m, near_m = -1e3, -1e-7  # from sliding to turning about the middle
    for _ in range(60):
        middle_m = -np.sqrt(far_m * near_m)
        force, moment = friction(middle_m)
        far_m, near_m = (far_m, middle_m) if moment > force * arm_m else (middle_m, near_m)
    return friction(far_m)[0]


def least_force(angles, places):
    """The largest of what is needed on the way to each angle; the lift comes first."""
    needed = np.array([0.5 * WEIGHT_N / FRICTION / share_at_arm(ARM_M * np.sin(angle), places) for angle in angles])
    return np.maximum.accumulate(np.maximum(needed, 0.5 * WEIGHT_N * LIFT / FRICTION))


def draw(data):
    window = data["window"]
    if KEY not in window["inputs"]:
        raise Unsuitable(f"no column {KEY}: not the results of configs/tilt_window.toml")
    angles = np.degrees(window["inputs"][KEY]["values"])
    fine = np.linspace(0.0, np.pi, 91)
    figure, axes = plt.subplots(figsize=(7.2, 3.6))
    axes.plot(np.degrees(fine), least_force(fine, even_square(PAD_M)), color=SOFT, lw=1.2, ls="--",
              label="an evenly pressed square")
    low = least_force(fine, particles())
    axes.plot(np.degrees(fine), low, color=INK, lw=1.4, label="the 16 particles under a pad")
    axes.fill_between(np.degrees(fine), low, 1.5, color=HELD, alpha=0.12, lw=0)
    axes.plot(angles, window["hold_force_N"], "o", color=HELD, ms=6, mec=INK, mew=0.7, label="F_hold of the study")
    axes.set_xlabel("turned about the grip axis [degrees]")
    axes.set_ylabel("least grip force [N]")
    axes.set_xticks(range(0, 181, 30))
    axes.set_xlim(-5, 185)
    axes.set_ylim(0.7, 1.35)
    axes.spines[["top", "right"]].set_visible(False)
    axes.legend(frameon=False, loc="lower right", fontsize=9)
    axes.text(92, 1.24, "held", color=SOFT, ha="center")
    figure.tight_layout()
    return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", metavar="RESULTS.h5")
    default = Path(__file__).resolve().parent.parent / "docs" / "images" / "tilt_window.svg"
    parser.add_argument("-o", "--output", metavar="FILE.svg", default=default)
    options = parser.parse_args()
    try:
        figure = draw(read_results(options.results))
    except Unsuitable as error:
        print(f"plot_tilt.py: {error}", file=sys.stderr)
        return 2
    save(figure, options.output)
    return 0


if __name__ == "__main__":
    sys.exit(main())
