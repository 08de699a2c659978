#!/usr/bin/env python3
"""Draws the pictures of docs/tutorial.md: axes and sizes of a scene, and the phases of a cycle.

usage: scripts/draw_pictures.py [FOLDER]     docs/images unless given
"""
import sys
from pathlib import Path

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.patches import Ellipse, Rectangle

# The same file for the same picture: no date, fixed ids, text that stays text.
matplotlib.rcParams.update({"svg.hashsalt": "unbruised", "svg.fonttype": "none", "font.size": 10,
                            "font.family": "sans-serif", "font.sans-serif": ["DejaVu Sans", "Arial", "sans-serif"]})
INK, SOFT, PRODUCT, PAD, FORCE = "#22303c", "#8695a3", "#e9b7a0", "#9fb8cf", "#b3461f"


def arrow(axes, start, end, text="", at=(0, 0), both=True, colour=INK, **options):
    """A dimension line from start to end, its text `at` that far from its middle."""
    style = "<|-|>" if both else "-|>"
    axes.annotate("", xy=end, xytext=start,
                  arrowprops={"arrowstyle": style, "color": colour, "lw": 1.2, "shrinkA": 0, "shrinkB": 0})
    middle = ((start[0] + end[0]) / 2 + at[0], (start[1] + end[1]) / 2 + at[1])
    if text:
        axes.text(*middle, text, color=colour, ha="center", va="center", **options)


def draw_frame(axes, corner, names):
    """Two axes of the scene with their names."""
    x, y = corner
    for (dx, dy), name in zip(((10, 0), (0, 10)), names):
        arrow(axes, (x, y), (x + dx, y + dy), both=False)
        axes.text(x + dx * 1.25, y + dy * 1.25, name, ha="center", va="center", weight="bold", color=INK)


def draw_jaw(axes, side):
    """One finger with its pad; side is -1 or 1."""
    pad, finger = (44, 4), (48, 6)
    left = side * pad[0] if side > 0 else -pad[0] - pad[1]
    axes.add_patch(Rectangle((left, 15), pad[1], 20, facecolor=PAD, edgecolor=INK))
    left = side * finger[0] if side > 0 else -finger[0] - finger[1]
    axes.add_patch(Rectangle((left, 13), finger[1], 62, facecolor="#d8dee4", edgecolor=INK))
    arrow(axes, (side * 62, 25), (side * 55, 25), both=False, colour=FORCE)
    axes.text(side * 64, 25, "grip_force_N", color=FORCE, ha="left" if side > 0 else "right", va="center")


def draw_front(axes):
    """The scene seen along y: pads close along x."""
    axes.add_patch(Ellipse((0, 25), 62, 50, facecolor=PRODUCT, edgecolor=INK))
    for side in (-1, 1):
        draw_jaw(axes, side)
    axes.add_patch(Rectangle((-58, 75), 116, 9, facecolor="#d8dee4", edgecolor=INK))
    axes.text(0, 79.5, "palm", ha="center", va="center", color=INK)
    axes.plot([-95, 95], [0, 0], color=INK, lw=2)
    axes.text(93, -2, "support, z = 0", ha="right", va="top", color=INK)
    arrow(axes, (-31, -7), (31, -7), "product.size_m[0]", at=(0, -6))
    arrow(axes, (0, 1), (0, 49), "size_m[2]", at=(-6, 0), rotation=90)
    arrow(axes, (-44, 88), (44, 88), "gripper.opening_m", at=(0, 5))
    arrow(axes, (-44, 40), (-31, 40))
    axes.plot([-37, -37, -62], [40, 55, 55], color=INK, lw=0.8)
    axes.text(-64, 55, "cell.approach_gap_m", ha="right", va="center", color=INK)
    draw_frame(axes, (-112, -16), ("x", "z"))
    axes.text(0, 104, "seen along y", ha="center", color=SOFT)
    axes.set(xlim=(-118, 104), ylim=(-20, 108))


def draw_side(axes):
    """The scene seen along x, with the path of the palm."""
    axes.add_patch(Ellipse((0, 25), 70, 50, facecolor=PRODUCT, edgecolor=INK))
    axes.add_patch(Rectangle((-15, 15), 30, 20, facecolor=PAD, edgecolor=INK, alpha=0.85))
    axes.plot([-58, 185], [0, 0], color=INK, lw=2)
    axes.add_patch(Ellipse((130, 25), 70, 50, facecolor="none", edgecolor=SOFT, linestyle="--"))
    axes.plot([0, 0, 130, 130], [25, 80, 80, 34], color=FORCE, lw=1.5)
    arrow(axes, (130, 40), (130, 25), both=False, colour=FORCE)
    axes.plot([-49, 0], [80, 80], color=SOFT, lw=0.8)
    axes.plot([-49, -15], [25, 25], color=SOFT, lw=0.8)
    arrow(axes, (-48, 25), (-48, 80), "cell.lift_height_m", at=(-8, 0), rotation=90)
    arrow(axes, (0, 88), (130, 88), "cell.transfer_m[1]", at=(0, 5))
    arrow(axes, (-15, 11), (15, 11))
    axes.plot([12, 42], [11, 11], color=INK, lw=0.8)
    axes.text(44, 11, "pad_size_m[0]", ha="left", va="center", color=INK)
    draw_frame(axes, (-66, -16), ("y", "z"))
    axes.text(65, 104, "seen along x", ha="center", color=SOFT)
    axes.set(xlim=(-74, 186), ylim=(-20, 108))


def draw_axes(path):
    figure, (front, side) = plt.subplots(1, 2, figsize=(13, 3.9), gridspec_kw={"width_ratios": [222, 260], "wspace": 0.05})
    draw_front(front)
    draw_side(side)
    for axes in (front, side):
        axes.set_aspect("equal")
        axes.axis("off")
    save(figure, path)


# Phase, its end, and the keys that fix its length.
PHASES = [("approach", 1.2, "approach_gap_m,\napproach_speed_m_s"), ("grip", 2.7, "grip_ramp_s,\nsettle_s"),
          ("lift", 4.2, "lift_height_m,\nlift_acceleration_m_s2"), ("hold", 5.0, "hold_s"),
          ("transfer", 6.9, "transfer_m,\ntransfer_acceleration_m_s2"),
          ("lower", 9.0, "lower_acceleration_m_s2,\nplace_settle_s"), ("release", 10.1, "release_speed_m_s"),
          ("recover", 11.2, "recover_s")]
BEGIN = {name: end for (_, end, _), (name, _, _) in zip(PHASES, PHASES[1:])}
END = {name: end for name, end, _ in PHASES}


def quintic(part):
    """Minimum jerk from 0 to 1."""
    return part ** 3 * (10 - 15 * part + 6 * part ** 2)


def part_of(phase, time):
    return min(max((time - BEGIN[phase]) / (END[phase] - BEGIN[phase]), 0), 1)


def height(time):
    down = min(part_of("lower", time) / 0.75, 1)  # the rest of the phase is place_settle_s
    return quintic(part_of("lift", time)) - quintic(down)


def force(time):
    if time < BEGIN["grip"]:
        return 0.0
    return max(min(1.0, 0.12 + time - BEGIN["grip"], (BEGIN["release"] + 0.15 - time) / 0.15), 0.0)


def draw_bands(axes):
    begin = 0.0
    for number, (name, end, keys) in enumerate(PHASES):
        axes.axvspan(begin, end, color="#eef2f5" if number % 2 else "#ffffff", zorder=0)
        axes.text((begin + end) / 2, 2.55, name, ha="center", weight="bold", color=INK)
        axes.text((begin + end) / 2, -0.42 - 0.55 * (number % 2), keys, ha="center", va="center", fontsize=9, color=SOFT)
        begin = end


def draw_phases(path):
    figure, axes = plt.subplots(figsize=(13, 3.9))
    draw_bands(axes)
    times = [i / 500 * END["recover"] for i in range(501)]
    axes.plot(times, [1.35 + height(t) for t in times], color=INK, lw=2)
    axes.plot(times, [force(t) for t in times], color=FORCE, lw=2)
    axes.text(-0.1, 1.4, "height\nof the palm", ha="right", va="center", color=INK)
    axes.text(-0.1, 0.2, "force of\na finger", ha="right", va="center", color=FORCE)
    axes.text(2.75, 1.04, "strategy.grip_force_N", ha="left", va="bottom", fontsize=9, color=FORCE)
    axes.annotate("first contact", xy=(BEGIN["grip"], 0.1), xytext=(0.15, 0.62), fontsize=9, color=FORCE,
                  arrowprops={"arrowstyle": "-", "color": FORCE, "lw": 0.8})
    arrow(axes, (0, 2.95), (END["release"], 2.95), "cycle_time_s", at=(0, 0.16))
    axes.set(xlim=(-1.4, END["recover"] + 0.1), ylim=(-1.3, 3.2))
    axes.axis("off")
    save(figure, path)


def save(figure, path):
    figure.savefig(path, metadata={"Date": None, "Creator": None}, bbox_inches="tight", facecolor="white")
    plt.close(figure)
    print(path)


def main():
    if {"--help", "-h"} & set(sys.argv):
        print(__doc__.strip())
        return
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent / "docs/images"
    folder.mkdir(parents=True, exist_ok=True)
    draw_axes(folder / "axes.svg")
    draw_phases(folder / "phases.svg")


if __name__ == "__main__":
    main()
