#!/usr/bin/python3
"""Draws the picture of docs/belts.md from a run of configs/belt_pick.toml.

usage: scripts/draw_belt.py RUN [PICTURE]     RUN: results/belt_pick, with the trace of scenario 6; docs/images/belt_pick.png

  unbruised run configs/belt_pick.toml
  unbruised run configs/belt_pick.toml --scenario 6
"""
import os
import sys

import h5py
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

SPEED, LAG = "cell.conveyor.speed_m_s", "strategy.tracking_lag_s"
SHOWN = 6  # of the scenarios, in the left half
BELT, PALM, PRODUCT = "#8695a3", "#22303c", "#b3461f"


def draw_ways(axes, trace, speed_m_s, lag_s, lift_s):
    """Belt, palm and product along the belt over time."""
    time = trace["time_s"][...]
    product = trace["displacement_m"][...].mean(axis=1)[:, 1]
    palm = trace["palm_position_m"][...][:, 1]
    belt = speed_m_s * time
    on_belt = belt < 1.25 * product.max()
    axes.plot(time[on_belt], 1e3 * belt[on_belt], color=BELT, lw=5, solid_capstyle="butt", label="a point of the belt")
    axes.plot(time, 1e3 * product, color=PRODUCT, lw=2.2, label="the kiwi")
    axes.plot(time, 1e3 * palm, color=PALM, lw=1.2, ls="--", label="the palm")
    axes.axvline(lift_s, color=BELT, lw=0.8)
    axes.annotate("lift starts", (lift_s, 0), xytext=(4, 4), textcoords="offset points", color=BELT, fontsize=9)
    axes.set_xlabel("time [s]")
    axes.set_ylabel("place along the belt [mm]")
    axes.set_title(f"belt at {speed_m_s:g} m/s, tracked {1e3 * lag_s:g} ms late", fontsize=10)
    axes.legend(frameon=False, fontsize=9, loc="upper left")


def draw_errors(axes, file):
    """Pick error and place error over the lag, one line for each speed of the belt."""
    speed = file["scenarios/input"][SPEED][...]
    lag = file["scenarios/input"][LAG][...]
    picked = file["scenarios/metric/pick_error_m"][...]
    placed = file["scenarios/metric/place_error_m"][...]
    for shade, value in zip(("#9fb8cf", "#5d83a8", "#1f4e79"), np.unique(speed)):
        rows = speed == value
        axes.plot(1e3 * lag[rows], 1e3 * value * lag[rows], color=shade, lw=1)
        axes.plot(1e3 * lag[rows], 1e3 * picked[rows], "o", color=shade, mfc="none", ms=8)
        axes.plot(1e3 * lag[rows], 1e3 * placed[rows], "x", color=shade, label=f"{value:g} m/s")
    axes.set_xlabel("lag of the tracking [ms]")
    axes.set_ylabel("error [mm]")
    axes.set_title("circles: picked, crosses: placed, lines: speed × lag", fontsize=10)
    axes.legend(frameon=False, fontsize=9, loc="upper left")


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    run, picture = sys.argv[1], sys.argv[2] if len(sys.argv) == 3 else "docs/images/belt_pick.png"
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4), layout="constrained")
    with h5py.File(os.path.join(run, "results.h5")) as file, h5py.File(os.path.join(run, f"scenario_{SHOWN}.h5")) as one:
        inputs, lift_s = file["scenarios/input"], file["scenarios/metric/lift_time_s"][SHOWN]
        draw_ways(left, one["trace"], inputs[SPEED][SHOWN], inputs[LAG][SHOWN], lift_s)
        draw_errors(right, file)
    for axes in (left, right):
        axes.spines[["top", "right"]].set_visible(False)
    figure.savefig(picture, dpi=130, metadata={"Software": None})


if __name__ == "__main__":
    main()
