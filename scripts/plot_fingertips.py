#!/usr/bin/python3
"""Draws what fingertips do: the force of measured ones over their depth, and the grip windows between pads of other forms.

    plot_fingertips.py PRESS.h5 WINDOWS.h5 [-o FILE.svg]     docs/images/fingertips.svg unless given

PRESS.h5 is of configs/fingertip_press.toml: each point is a grip at rest, half of what both pads have closed past the
block; the lines are the published laws. WINDOWS.h5 is of configs/fingertips.toml. The largest deviation from each law
over 0 to 3 mm is printed.
Exit status: 0 drawn, 2 a file does not hold what is needed.
"""
import argparse
import sys
from pathlib import Path

import h5py
import matplotlib.pyplot as plt
import numpy as np

from draw_pictures import INK, SOFT, save  # which sets the looks of the pictures
from window_tables import Unsuitable, read_results, text_list

# N and mm: data of "A Grip Force Planning Method for Reliable and Rapid Fruit Grasping Based on Rupture Force
# Estimation" (github SheepLiu712/FruitRuptureEstimate).
LAWS = {"soft_tip_v1": (2.4013, 4.2755), "soft_tip_v2": (4.4405, 1.5621)}
COLOURS = {"soft_tip_v1": "#1b9e77", "soft_tip_v2": "#d95f02"}
NAMES = {"parallel_jaw": "plane", "jaw_convex": "cylinder, 20 mm", "jaw_sphere": "sphere, 25 mm",
         "jaw_cradle": "cradle, 26 mm", "jaw_groove": "V groove"}
USE = "gripper.use"


def stem(text):
    return Path(text).stem


def read_press(path):
    """Tip -> depths [mm] and forces [N]."""
    try:
        with h5py.File(path, "r") as file:
            tips = [stem(text) for text in text_list(file["scenarios/input"][USE])]
            depth = 500.0 * file["scenarios/metric/compression_max_m"][...]
            force = file["scenarios/metric/peak_finger_force_N"][...]
    except (OSError, KeyError) as error:
        raise Unsuitable(f"{path}: not the results of configs/fingertip_press.toml ({error})") from error
    return {tip: (depth[[t == tip for t in tips]], force[[t == tip for t in tips]]) for tip in dict.fromkeys(tips)}


def draw_press(axes, press):
    line = np.linspace(0.0, 3.2, 100)
    for tip, (depth, force) in press.items():
        if tip not in LAWS:
            raise Unsuitable(f"{tip}: no law is known of it")
        linear, square = LAWS[tip]
        axes.plot(line, linear * line + square * line**2, color=COLOURS[tip], lw=1.2)
        axes.plot(depth, force, "o", color=COLOURS[tip], ms=5, mec=INK, mew=0.6, label=tip.replace("_", " "))
        near = depth <= 3.0
        law = linear * depth[near] + square * depth[near] ** 2
        print(f"{tip}: within {100 * np.max(np.abs(force[near] / law - 1)):.2f} % of the measured law, "
              f"0 to {depth[near].max():.2f} mm")
    axes.set_xlim(0, 3.2)
    axes.set_ylim(0, 50)
    axes.set_xlabel("depth of a tip [mm]")
    axes.set_ylabel("force [N]")
    axes.legend(frameon=False, fontsize=9, loc="upper left")


def draw_windows(axes, window):
    if USE not in window["inputs"]:
        raise Unsuitable(f"no column {USE}: not the results of configs/fingertips.toml")
    names = [NAMES.get(stem(text), stem(text)) for text in window["inputs"][USE]["values"]]
    hold, damage = window["hold_force_N"], window["damage_force_N"]
    for row, (low, high) in enumerate(zip(hold, damage)):
        open_end = np.isnan(low)  # held at the least force looked at
        if high > (0.0 if open_end else low):
            axes.barh(row, high - (0.0 if open_end else low), left=0.0 if open_end else low, height=0.5,
                      color="#1b9e77", alpha=0.7, lw=0)
        elif not (np.isnan(low) or np.isnan(high)) or np.isnan(high):
            axes.annotate("no window", (np.nanmax([low, high]), row), (10, 0), textcoords="offset points",
                          va="center", fontsize=9, color=SOFT)
            continue
        for force, side in ((low, "left"), (high, "right")):
            if np.isnan(force):
                continue
            axes.plot([force, force], [row - 0.32, row + 0.32], color=INK, lw=1.2)
            axes.annotate(f"{force:.3g}", (force, row), (4 if side == "left" else -4, 0), textcoords="offset points",
                          ha=side, va="center", fontsize=8, color=INK)
    axes.set_yticks(range(len(names)), names)
    axes.invert_yaxis()
    axes.set_xlim(0, 1.15 * max(np.nanmax(damage), np.nanmax(hold)))
    axes.set_xlabel("grip force of a ripe kiwi: from held to first damage [N]")
    axes.tick_params(axis="y", length=0)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("press", metavar="PRESS.h5")
    parser.add_argument("windows", metavar="WINDOWS.h5")
    default = Path(__file__).resolve().parent.parent / "docs" / "images" / "fingertips.svg"
    parser.add_argument("-o", "--output", metavar="FILE.svg", default=default)
    options = parser.parse_args()
    figure, (left, right) = plt.subplots(1, 2, figsize=(9.4, 3.4), width_ratios=[1, 1.35])
    try:
        draw_press(left, read_press(options.press))
        draw_windows(right, read_results(options.windows)["window"])
    except Unsuitable as error:
        print(f"plot_fingertips.py: {error}", file=sys.stderr)
        return 2
    for axes in (left, right):
        axes.spines[["top", "right"]].set_visible(False)
    figure.tight_layout()
    save(figure, options.output)
    return 0


if __name__ == "__main__":
    sys.exit(main())
