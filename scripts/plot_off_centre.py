#!/usr/bin/python3
"""Draws the least grip force of configs/off_centre.toml over how far beside its middle the product is gripped.

    plot_off_centre.py RESULTS.h5 [-o FILE.svg]     docs/images/off_centre.svg unless given

F_hold is read from /window. The closed form is worked out from the study's numbers: half of the weight at the arm e
on each pad, which an evenly pressed square holds until a rigid body turns against it.
Exit status: 0 drawn, 2 the file does not hold what is needed.
"""
import argparse
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from draw_pictures import INK, SOFT, save  # which sets the looks of the pictures
from plot_tilt import even_square, share_at_arm
from window_tables import Unsuitable, read_results

KEY = "cell.grip_offset_m"
# Of configs/off_centre.toml and the files it uses.
LOAD_N, FRICTION, PAD_M = 0.1 * (9.80665 + 0.3), 0.6, 0.020
HELD = "#1b9e77"


def draw(data):
    window = data["window"]
    if KEY not in window["inputs"]:
        raise Unsuitable(f"no column {KEY}: not the results of configs/off_centre.toml")
    offsets_mm = 1e3 * np.asarray(window["inputs"][KEY]["values"])
    fine = np.linspace(0.0, 0.016, 65)
    places = even_square(PAD_M)
    low = np.array([0.5 * LOAD_N / FRICTION / share_at_arm(offset, places) for offset in fine])
    torque_alone = 0.5 * LOAD_N / FRICTION * fine / (0.3826 * PAD_M)
    figure, axes = plt.subplots(figsize=(7.2, 3.6))
    axes.plot(1e3 * fine, low, color=INK, lw=1.4, label="force and moment on an evenly pressed square")
    axes.plot(1e3 * fine, torque_alone, color=SOFT, lw=1.2, ls="--", label="its torque alone, m g e")
    axes.fill_between(1e3 * fine, low, 4.0, color=HELD, alpha=0.12, lw=0)
    axes.plot(offsets_mm, window["hold_force_N"], "o", color=HELD, ms=6, mec=INK, mew=0.7,
              label="F_hold of the study")
    axes.set_xlabel("pads beside the middle of the product [mm]")
    axes.set_ylabel("least grip force [N]")
    axes.set_xlim(-0.5, 16)
    axes.set_ylim(0.0, 2.6)
    axes.spines[["top", "right"]].set_visible(False)
    axes.legend(frameon=False, loc="lower right", fontsize=9)
    axes.text(4.0, 1.9, "held", color=SOFT, ha="center")
    figure.tight_layout()
    return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", metavar="RESULTS.h5")
    default = Path(__file__).resolve().parent.parent / "docs" / "images" / "off_centre.svg"
    parser.add_argument("-o", "--output", metavar="FILE.svg", default=default)
    options = parser.parse_args()
    try:
        figure = draw(read_results(options.results))
    except Unsuitable as error:
        print(f"plot_off_centre.py: {error}", file=sys.stderr)
        return 2
    save(figure, options.output)
    return 0


if __name__ == "__main__":
    sys.exit(main())
