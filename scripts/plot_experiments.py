#!/usr/bin/python3
"""Draws what docs/products.csv (scripts/product_table.py --run) says of published experiments: simulated over published for
each, the carrot between locked fingers over time against its closed form, and the firm kiwi that falls onto steel over the height.

    plot_experiments.py KIWI_DROP_RESULTS.h5 [-o FILE.svg]     docs/images/experiments.svg unless given

Exit status: 0 drawn, 2 the file does not hold what is needed.
"""
import argparse
import csv
import re
import sys
import textwrap
import tomllib
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from draw_pictures import FORCE, INK, SOFT, save  # which sets the looks of the pictures
from window_tables import Unsuitable, opened

ROOT = Path(__file__).resolve().parent.parent
LEAST_RATIO = 0.1  # what is less is drawn at the edge


def experiments():
    with (ROOT / "docs/products.csv").open(encoding="utf-8", newline="") as file:
        return [(row["experiment"], float(row["published"]), float(row["simulated"]), row["study"]) for row in csv.DictReader(file)]


def full_names(rows):
    """"the same, 5 s" with what it is the same as."""
    stem, names = "", []
    for name, *_ in rows:
        if name.startswith("the same"):
            names.append(stem + name.removeprefix("the same").replace(":", ","))
        else:
            stem = re.sub(r", (?:12\.7 mm of foam|grip locked).*|: bruised.*", "", name)
            names.append(name)
    return names


def draw_ratios(axes, rows):
    ratios = np.array([simulated / published for _, published, simulated, _ in rows])
    shown, places = np.maximum(ratios, LEAST_RATIO), np.arange(len(rows))[::-1]
    axes.axvspan(1 / 1.15, 1.15, color=SOFT, alpha=0.22, lw=0)
    axes.axvline(1.0, color=SOFT, lw=1.0)
    axes.hlines(places, 1.0, shown, color=SOFT, lw=0.8)
    inside = ratios >= LEAST_RATIO
    axes.plot(shown[inside], places[inside], "o", color=INK, ms=5)
    axes.plot(shown[~inside], places[~inside], "<", color=FORCE, ms=6, clip_on=False)
    axes.set_xscale("log")
    axes.set_xlim(LEAST_RATIO, 10.0)
    axes.set_xticks([0.1, 0.2, 0.5, 1, 2, 5, 10], ["0.1", "0.2", "0.5", "1", "2", "5", "10"])
    axes.minorticks_off()
    axes.set_yticks(places, [textwrap.fill(name, 58) for name in full_names(rows)], fontsize=7.5)
    axes.tick_params(axis="y", length=0)
    axes.set_xlabel("simulated over published (band: 15 %; arrows: less than a tenth)")


def draw_carrot(axes, rows):
    with (ROOT / "configs/products/carrot_stick.toml").open("rb") as file:
        carrot = tomllib.load(file)
    time_s = np.geomspace(0.1, 200.0, 200)
    left = 1.0 - sum(g * (1.0 - np.exp(-time_s / tau)) for g, tau in zip(carrot["prony_modulus"], carrot["prony_time_s"]))
    axes.plot(time_s, 1.0 / left, color=SOFT, label="1 / share of the force that is left")
    points = [(float(re.search(r"([\d.]+) s\b", name)[1]), value) for name, _, value, study in rows if study == "carrot_held"]
    axes.plot(*zip(*points), "o", color=INK, ms=5, label="simulated windows")
    axes.set_xscale("log")
    axes.set_xticks([0.1, 1, 10, 100], ["0.1", "1", "10", "100"])
    axes.minorticks_off()
    axes.set_xlabel("held by locked fingers, s")
    axes.set_ylabel("hold force over that\nof a grip held by force")
    axes.legend(loc="upper left", fontsize=8)


def draw_drop(axes, path):
    with opened(path) as file:
        height_m = file["scenarios/input/product.initial_height_m"][:]
        ratio = file["scenarios/metric/contact_yield_ratio_max"][:]
        area_mm2 = 1e6 * file["scenarios/metric/bruised_area_m2"][:]
    axes.axhline(1.0, color=SOFT, lw=1.0)
    axes.plot(height_m, ratio, "o-", color=INK, ms=5)
    for x, y, area in zip(height_m, ratio, area_mm2):
        axes.annotate(f"{area:.0f} mm² bruised" if area > 0 else "no bruise", (x, y), (-8, 3), textcoords="offset points", ha="right", fontsize=8)
    axes.set_xlim(-0.08, 0.6)
    axes.set_ylim(0.6, 1.25)
    axes.set_xlabel("firm kiwi falls onto steel from, m")
    axes.set_ylabel("pressure over that\nof first yield")


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("results", type=Path)
    parser.add_argument("-o", "--output", type=Path, default=ROOT / "docs/images/experiments.svg")
    words = parser.parse_args()
    rows = experiments()
    figure = plt.figure(figsize=(11.0, 6.4), layout="constrained")
    grid = figure.add_gridspec(2, 2, width_ratios=(1.25, 1.0))
    draw_ratios(figure.add_subplot(grid[:, 0]), rows)
    draw_carrot(figure.add_subplot(grid[0, 1]), rows)
    try:
        draw_drop(figure.add_subplot(grid[1, 1]), words.results)
    except (Unsuitable, KeyError) as fault:
        print(f"plot_experiments: {fault}", file=sys.stderr)
        return 2
    save(figure, words.output)
    return 0


if __name__ == "__main__":
    sys.exit(main())
