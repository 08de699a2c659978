#!/usr/bin/python3
"""Draws what a correlation does: the products of two runs of configs/kiwi_correlated.toml, drawn together and independently,
over modulus and yield stress, in the colours of their outcomes.

    plot_correlated.py RESULTS.h5 INDEPENDENT.h5 [-o FILE.svg]     docs/images/kiwi_correlated.svg unless given

Exit status: 0 drawn, 2 a file does not hold what is needed.
"""
import argparse
import sys
from pathlib import Path

import matplotlib.pyplot as plt

from draw_pictures import INK, save  # which sets the looks of the pictures
from window_tables import Unsuitable, opened, read_outcomes

ROOT = Path(__file__).resolve().parent.parent
KEYS = ("product.youngs_modulus_Pa", "product.yield_stress_Pa")


def draw(axes, path, title):
    with opened(path) as file:
        modulus, stress = (1e-3 * file[f"scenarios/input/{key}"][:] for key in KEYS)
        found = read_outcomes(file["scenarios/outcome"])
    for code in sorted(set(found["outcome"])):
        chosen = found["outcome"] == code
        axes.scatter(modulus[chosen], stress[chosen], s=12, color=found["colours"][code], edgecolor=INK, linewidth=0.3,
                     label=f"{found['words'][code]}, {chosen.sum()}")
    axes.set_title(title)
    axes.set_xlabel("Young's modulus, kPa")
    axes.legend(loc="upper left", fontsize=8, framealpha=1.0)


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("results", type=Path)
    parser.add_argument("independent", type=Path)
    parser.add_argument("-o", "--output", type=Path, default=ROOT / "docs/images/kiwi_correlated.svg")
    words = parser.parse_args()
    figure, axes = plt.subplots(1, 2, figsize=(9.0, 3.8), sharex=True, sharey=True, layout="constrained")
    try:
        draw(axes[0], words.results, "drawn together")
        draw(axes[1], words.independent, "drawn independently")
    except (Unsuitable, KeyError) as fault:
        print(f"plot_correlated: {fault}", file=sys.stderr)
        return 2
    axes[0].set_ylabel("yield stress, kPa")
    save(figure, words.output)
    return 0


if __name__ == "__main__":
    sys.exit(main())
