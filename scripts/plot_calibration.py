#!/usr/bin/python3
"""Draws measured over simulated curves of a calibration, and what its fits predict.

    plot_calibration.py RESULTS.h5 [-o FILE.svg]     docs/images/calibration.svg unless given

Left: each specimen's measured points and the curve with its fitted keys. Right: the outcome that was predicted by
cross-validation over the measured one, with intervals; without an outcome, simulated over measured at every point.
Exit status: 0 drawn, 2 a file does not hold what is needed.
"""
import argparse
import sys
from pathlib import Path

import h5py
import matplotlib.pyplot as plt
import numpy as np

from draw_pictures import INK, SOFT, save  # which sets the looks of the pictures
from window_tables import Unsuitable, text_list

SPECIMENS_MOST = 12


def read(path):
    try:
        with h5py.File(path, "r") as file:
            curve = file["calibration_curve"]
            over = next(name for name in curve if name in ("closure_m", "time_s"))
            fits = file["calibration"]
            columns = {name: fits[name][...] for name in fits if fits[name].dtype.kind == "f"}
            attributes = {name: fits.attrs[name] for name in fits.attrs}
            return (over, text_list(curve["specimen"]), curve[over][...], curve["measured"][...],
                    curve["simulated"][...], columns, attributes)
    except (OSError, KeyError, StopIteration) as error:
        raise Unsuitable(f"{path}: not the results of a calibration ({error})") from error


def words(value):
    return value.decode() if isinstance(value, bytes) else str(value)


def draw_curves(axes, over, specimens, x, measured, simulated, label):
    names = list(dict.fromkeys(specimens))
    chosen = [names[i] for i in np.linspace(0, len(names) - 1, min(SPECIMENS_MOST, len(names))).astype(int)]
    scale, unit = (1e3, "mm") if over == "closure_m" else (1.0, "s")
    for number, name in enumerate(chosen):
        rows = np.array([s == name for s in specimens])
        colour = plt.cm.viridis(number / max(1, len(chosen) - 1))
        axes.plot(scale * x[rows], simulated[rows], color=colour, lw=1.2)
        axes.plot(scale * x[rows], measured[rows], "o", color=colour, ms=4, mec=INK, mew=0.4)
    axes.set_xlabel(f"{over.split('_')[0]} [{unit}]")
    axes.set_ylabel(label)
    axes.set_title(f"measured (dots) and simulated, {len(chosen)} of {len(names)} specimens", fontsize=9)


def draw_outcome(axes, columns, attributes):
    outcome, found = columns["outcome"], columns["predicted"]
    low, high = columns["predicted_low"], columns["predicted_high"]
    there = np.isfinite(found)
    axes.errorbar(outcome[there], found[there], yerr=[found[there] - low[there], high[there] - found[there]], fmt="o",
                  color=INK, ecolor=SOFT, ms=4, lw=1)
    most = 1.1 * max(outcome[there].max(), found[there].max())
    axes.plot([0, most], [0, most], color=SOFT, lw=1)
    axes.set_xlim(0, most)
    axes.set_ylim(0, min(3 * most, 1.05 * high[there].max()))
    axes.set_xlabel(f"{words(attributes['outcome'])}, measured")
    axes.set_ylabel("predicted by the other specimens")
    inside = int(np.sum((low <= outcome) & (outcome <= high)))
    axes.set_title(f"{inside} of {int(there.sum())} inside their intervals", fontsize=9)


def draw_points(axes, measured, simulated):
    axes.plot(measured, simulated, ".", color=INK, ms=4)
    ends = [min(measured.min(), 0), measured.max()]
    axes.plot(ends, ends, color=SOFT, lw=1)
    axes.set_xlabel("measured")
    axes.set_ylabel("simulated")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", type=Path)
    parser.add_argument("-o", "--output", type=Path,
                        default=Path(__file__).resolve().parent.parent / "docs/images/calibration.svg")
    arguments = parser.parse_args()
    try:
        over, specimens, x, measured, simulated, columns, attributes = read(arguments.results)
    except Unsuitable as error:
        print(error, file=sys.stderr)
        return 2
    figure, (left, right) = plt.subplots(1, 2, figsize=(9.0, 3.8))
    draw_curves(left, over, specimens, x, measured, simulated, words(attributes["measured"]))
    if "predicted" in columns and np.isfinite(columns["predicted"]).any():
        draw_outcome(right, columns, attributes)
    else:
        draw_points(right, measured, simulated)
    figure.tight_layout()
    save(figure, arguments.output)
    return 0


if __name__ == "__main__":
    sys.exit(main())
