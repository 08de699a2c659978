#!/usr/bin/python3
"""Draws what flexible pads buy, from the results of configs/soft_pads.toml: the grip windows between pads of each kind,
and the peak pressure under each over the grip force.

    plot_pads.py RESULTS.h5 [-o FILE.svg]     docs/images/soft_pads.svg unless given

Both ends are read from /window, the pressures from the runs that the study made on the way.
Exit status: 0 drawn, 2 the file does not hold what is needed.
"""
import argparse
import sys
from pathlib import Path

import h5py
import matplotlib.pyplot as plt
import numpy as np

from draw_pictures import INK, SOFT, save  # which sets the looks of the pictures
from window_tables import Unsuitable, read_results, text_list

KEY = "gripper.use"
PADS = {"parallel_jaw_firm": ("firm rubber, 2 mm", "#4a7fb0"), "parallel_jaw": ("silicone 10A, 3 mm", "#1b9e77"),
        "soft_silicone_pads": ("silicone 00-50, 10 mm", "#e0702d"), "foam_pads": ("foam, 12.7 mm", "#c583b0")}


def pads_of(value):
    return PADS.get(Path(value).stem, (Path(value).stem, SOFT))


def read_runs(path):
    """Pads, grip force, peak pressure and outcome of every run."""
    with h5py.File(path, "r") as file:
        inputs, metrics = file["scenarios/input"], file["scenarios/metric"]
        return (text_list(inputs[KEY]), inputs["strategy.grip_force_N"][...],
                metrics["peak_pressure_Pa"][...], file["scenarios/outcome"][...])


def draw_windows(axes, window, most_N):
    names = window["inputs"][KEY]["values"]
    for row, name in enumerate(names):
        label, colour = pads_of(name)
        low, high = window["hold_force_N"][row], window["damage_force_N"][row]
        is_open = not np.isfinite(high)  # no damage up to the largest force that was tried
        high = most_N if is_open else high
        axes.barh(row, high - low, left=low, height=0.55, color=colour, alpha=0.85)
        for place, side in ((low, "right"), (high, "left")):
            text = f"above {place:.2g}" if is_open and side == "left" else f"{place:.2g}"
            axes.text(place + (-0.08 if side == "right" else 0.08), row, text, va="center", ha=side, fontsize=9)
    axes.set_yticks(range(len(names)), [pads_of(name)[0] for name in names])
    axes.invert_yaxis()
    axes.set_xlim(0, 1.25 * most_N)
    axes.set_xlabel("window of the grip force [N]")
    axes.spines[["top", "right"]].set_visible(False)


def draw_pressures(axes, runs, held_N):
    names, force, pressure, _ = runs
    for name in dict.fromkeys(names):
        chosen = np.array([other == name for other in names]) & np.isfinite(pressure) & (force >= held_N)
        order = np.argsort(force[chosen])
        label, colour = pads_of(name)
        axes.plot(force[chosen][order], 1e-3 * pressure[chosen][order], "o-", color=colour, ms=3.5, lw=1.3, label=label)
    axes.set_xlabel("grip force [N]")
    axes.set_ylabel("peak pressure [kPa]")
    axes.set_xlim(left=0)
    axes.set_ylim(bottom=0)
    axes.legend(frameon=False, fontsize=9, loc="upper left")
    axes.spines[["top", "right"]].set_visible(False)


def draw(path):
    data = read_results(path)
    if KEY not in data["window"]["inputs"]:
        raise Unsuitable(f"no column {KEY}: not the results of configs/soft_pads.toml")
    figure, (left, right) = plt.subplots(1, 2, figsize=(9.4, 3.5))
    runs = read_runs(path)
    draw_windows(left, data["window"], runs[1].max())
    draw_pressures(right, runs, data["window"]["hold_force_N"].max())
    figure.tight_layout(w_pad=2.5)
    return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", metavar="RESULTS.h5")
    default = Path(__file__).resolve().parent.parent / "docs" / "images" / "soft_pads.svg"
    parser.add_argument("-o", "--output", metavar="FILE.svg", default=default)
    options = parser.parse_args()
    try:
        figure = draw(options.results)
    except Unsuitable as error:
        print(f"plot_pads.py: {error}", file=sys.stderr)
        return 2
    save(figure, options.output)
    return 0


if __name__ == "__main__":
    sys.exit(main())
