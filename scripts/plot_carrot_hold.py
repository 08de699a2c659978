#!/usr/bin/python3
"""Draws what a carrot that relaxes between locked fingers has to be gripped with, from configs/carrot_hold.toml.

    plot_carrot_hold.py RESULTS.h5 [-o FILE.svg]     docs/images/carrot_hold.svg unless given

F_hold is read from /window and drawn over that of fingers held by force, beside 1 over the share of the modulus that is
left. Exit status: 0 drawn, 2 the file does not hold what is needed.
"""
import argparse
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from draw_pictures import INK, SOFT, save  # which sets the looks of the pictures
from window_tables import Unsuitable, read_results

TIME, HOLD = "strategy.stop_time_s", "gripper.hold"
# Of configs/products/carrot_stick.toml; of configs/carrot_hold.toml: the fingers are locked 0.15 s after the start, and
# the run ends 0.3 s after its stop.
SHARES, TIMES_S, LOCKED_S, AFTER_STOP_S = (0.218, 0.233), (1.684, 26.31), 0.15, 0.3
HELD = "#1b9e77"


def share_left(time_s):
    fading = sum(g * np.exp(-np.asarray(time_s) / tau) for g, tau in zip(SHARES, TIMES_S))
    return 1.0 - sum(SHARES) + fading


def draw(data):
    window = data["window"]
    if TIME not in window["inputs"] or HOLD not in window["inputs"]:
        raise Unsuitable(f"no columns {TIME} and {HOLD}: not the results of configs/carrot_hold.toml")
    force_N = np.asarray(window["hold_force_N"])
    locked = np.array([how == "position" for how in window["inputs"][HOLD]["values"]])
    if locked.all() or not locked.any():
        raise Unsuitable("needs fingers held by force and fingers that are locked")
    times_s = np.asarray(window["inputs"][TIME]["values"])[locked] + AFTER_STOP_S - LOCKED_S
    ratio = force_N[locked] / force_N[~locked][0]
    fine_s = np.linspace(0.0, 65.0, 261)
    figure, axes = plt.subplots(figsize=(7.2, 3.4))
    axes.plot(fine_s, 1.0 / share_left(fine_s), color=INK, lw=1.4, label="1 over the share of the modulus that is left")
    axes.axhline(1.0, color=SOFT, lw=1.2, ls="--", label="held by force")
    axes.plot(times_s, ratio, "o", color=HELD, ms=6, mec=INK, mew=0.7, label="F_hold between locked fingers")
    for time_s, value in zip(times_s, ratio):
        axes.annotate(f"{value:.2f}", (time_s, value), textcoords="offset points", xytext=(7, -12), color=INK)
    axes.set_xlabel("held for [s]")
    axes.set_ylabel("least grip force, over that\nof fingers held by force")
    axes.set_xlim(-1.0, 65.0)
    axes.set_ylim(0.9, 1.9)
    axes.spines[["top", "right"]].set_visible(False)
    axes.legend(frameon=False, loc="lower right", fontsize=9)
    figure.tight_layout()
    return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", metavar="RESULTS.h5")
    default = Path(__file__).resolve().parent.parent / "docs" / "images" / "carrot_hold.svg"
    parser.add_argument("-o", "--output", metavar="FILE.svg", default=default)
    options = parser.parse_args()
    try:
        figure = draw(read_results(options.results))
    except Unsuitable as error:
        print(f"plot_carrot_hold.py: {error}", file=sys.stderr)
        return 2
    save(figure, options.output)
    return 0


if __name__ == "__main__":
    sys.exit(main())
