#!/usr/bin/python3
"""Draws what a guarded approach gains, from the results of configs/guarded_approach.toml, and prints its numbers.

    plot_guard.py RESULTS.h5 [-o FILE.svg]     docs/images/guarded_approach.svg unless given

Left: which approach speeds and grip forces hold the product unharmed, for each guard. Right: the forces that do, over
the time of the cycle. Exit status: 0 drawn, 2 the file does not hold what is needed.
"""
import argparse
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from draw_pictures import INK, SOFT, save  # which sets the looks of the pictures
from window_tables import Unsuitable, opened, text_list

GUARD, SPEED, FORCE = "strategy.guard", "strategy.approach_speed_m_s", "strategy.grip_force_N"
LOOKS = {"none": ("no guard", "#b3461f", "s"), "range": ("guard by range", "#1b9e77", "o"),
         "force": ("guard by force", "#7570b3", "^")}
HELD = 0


def read(path):
    """Of every guard a table [speed, force] of safe, cycle time and peak force; the speeds, the forces."""
    with opened(path) as file:
        scenarios = file["scenarios"]
        if any(key not in scenarios["input"] for key in (GUARD, SPEED, FORCE)):
            raise Unsuitable(f"{path}: not the results of configs/guarded_approach.toml")
        guard = np.array(text_list(scenarios["input"][GUARD]))
        speed, force = scenarios["input"][SPEED][...], scenarios["input"][FORCE][...]
        outcome = scenarios["outcome"][...]
        metric = {name: scenarios["metric"][name][...] for name in ("cycle_time_s", "peak_finger_force_N")}
    speeds, forces = np.unique(speed), np.unique(force)
    tables = {}
    for name in dict.fromkeys(guard):
        shape = (len(speeds), len(forces))
        table = {"safe": np.zeros(shape, bool), **{key: np.full(shape, np.nan) for key in metric}}
        for row in np.flatnonzero(guard == name):
            at = np.searchsorted(speeds, speed[row]), np.searchsorted(forces, force[row])
            table["safe"][at] = outcome[row] == HELD
            for key, values in metric.items():
                table[key][at] = values[row]
        tables[name] = table
    return tables, speeds, forces


def windows(table, forces):
    """Of each speed: least and greatest safe force of the grid, and the mean cycle time."""
    rows = []
    for safe, time_s in zip(table["safe"], table["cycle_time_s"]):
        ends = (forces[safe].min(), forces[safe].max()) if safe.any() else (np.nan, np.nan)
        rows.append((*ends, np.nanmean(time_s) if np.isfinite(time_s).any() else np.nan))
    return np.array(rows)


def draw_map(axes, tables, speeds, forces):
    """A mark at each pair that is safe, side by side for the guards."""
    for place, (name, table) in enumerate(tables.items()):
        words, colour, mark = LOOKS[name]
        shift = 1.0 + 0.055 * (place - (len(tables) - 1) / 2)
        for safe in (False, True):
            s, f = np.nonzero(table["safe"] == safe)
            axes.plot(speeds[s] * shift, forces[f], mark, ms=5.5 if safe else 3.2, color=colour,
                      mfc=colour if safe else "none", mew=0.7, alpha=1.0 if safe else 0.45,
                      label=words if safe else None)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xticks(speeds, [f"{v:g}" for v in speeds])
    axes.set_yticks([1, 2, 3, 4], ["1", "2", "3", "4"])
    axes.minorticks_off()
    axes.set_xlabel("approach speed [m/s]")
    axes.set_ylabel("grip force [N]")
    axes.set_title("full marks: held unharmed", fontsize=10, color=INK)


def draw_windows(axes, tables, forces):
    """The safe forces over the cycle time that they take; a cross where there are none."""
    for name, table in tables.items():
        words, colour, mark = LOOKS[name]
        low, high, time_s = windows(table, forces).T
        order = np.argsort(time_s)
        low, high, time_s = low[order], high[order], time_s[order]
        some = np.isfinite(low)
        axes.fill_between(time_s[some], low[some], high[some], color=colour, alpha=0.15, lw=0)
        axes.plot(time_s[some], high[some], mark + "-", color=colour, ms=5, lw=1.2, label=words)
        axes.plot(time_s[some], low[some], mark + "-", color=colour, ms=5, lw=1.2, mfc="white")
        axes.plot(time_s[~some], np.full((~some).sum(), forces.min()), "x", color=colour, ms=6)
    axes.set_ylim(0.85 * forces.min(), 1.08 * forces.max())
    axes.set_yscale("log")
    axes.set_yticks([1, 2, 3, 4], ["1", "2", "3", "4"])
    axes.minorticks_off()
    axes.set_xlabel("cycle time [s]")
    axes.set_title("the grip window at equal time; ×: none", fontsize=10, color=INK)
    axes.locator_params(axis="x", nbins=5)


def report(tables, speeds, forces):
    count = len(speeds) * len(forces)
    for name, table in tables.items():
        print(f"{LOOKS[name][0]}: {table['safe'].sum()} of {count} pairs of speed and force are safe")
        for speed, (low, high, time_s), peak in zip(speeds, windows(table, forces), table["peak_finger_force_N"]):
            safe = "none" if np.isnan(low) else f"{low:.2f} to {high:.2f} N"
            print(f"  {speed:.2f} m/s: cycle {time_s:.3f} s, safe {safe}, peak at the least force {peak[0]:.2f} N")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("results")
    parser.add_argument("-o", "--output", type=Path,
                        default=Path(__file__).resolve().parent.parent / "docs/images/guarded_approach.svg")
    options = parser.parse_args()
    try:
        tables, speeds, forces = read(options.results)
    except Unsuitable as error:
        print(f"plot_guard: {error}", file=sys.stderr)
        return 2
    report(tables, speeds, forces)
    figure, (left, right) = plt.subplots(1, 2, figsize=(9.6, 4.0))
    draw_map(left, tables, speeds, forces)
    draw_windows(right, tables, forces)
    for axes in (left, right):
        axes.tick_params(colors=INK)
        for side in ("top", "right"):
            axes.spines[side].set_visible(False)
        for side in ("left", "bottom"):
            axes.spines[side].set_color(SOFT)
    figure.tight_layout(rect=(0.0, 0.06, 1.0, 1.0))
    figure.legend(*right.get_legend_handles_labels(), loc="lower center", ncol=len(tables), frameon=False, fontsize=9)
    save(figure, options.output)
    return 0


if __name__ == "__main__":
    sys.exit(main())
