#!/usr/bin/python3
"""Draws what the shape of a product is worth, from the results of configs/mesh_window.toml: the mesh of the ribbed tomato
and the ellipsoid of its extents from above, between pads, and the grip windows of both.

    plot_mesh.py RESULTS.h5 [-o FILE.svg]     docs/images/mesh_window.svg unless given

Both ends are read from /window, the outline from configs/data/ribbed_tomato.ply.
Exit status: 0 drawn, 2 the file does not hold what is needed.
"""
import argparse
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import Ellipse, Rectangle

from draw_pictures import INK, PAD, PRODUCT, SOFT, save  # which sets the looks of the pictures
from window_tables import Unsuitable, read_results

ROOT = Path(__file__).resolve().parent.parent
MESH = ROOT / "configs/data/ribbed_tomato.ply"
KEY, LABELS = "product.shape", {"mesh": "mesh, six ribs", "ellipsoid": "ellipsoid of its extents"}
PAD_mm, THICKNESS_mm = 30, 3


def read_ply(path):
    """Places and triangles of a PLY text file."""
    lines = path.read_text().split("\n")
    count = {name: int(line.split()[-1]) for line in lines[:20] for name in ("vertex", "face") if line.startswith(f"element {name}")}
    first = lines.index("end_header") + 1
    places = np.array([line.split() for line in lines[first:first + count["vertex"]]], float)
    faces = [line.split()[1:] for line in lines[first + count["vertex"]:first + count["vertex"] + count["face"]]]
    return places, np.array(faces, int)


def cut(places, triangles, z):
    """The ring in which a horizontal plane cuts the surface, which goes once around the middle."""
    ring = set()
    for corner in places[triangles]:
        for a, b in zip(corner, np.roll(corner, -1, axis=0)):
            if a[2] < z < b[2]:  # each edge belongs to two triangles, which pass it in opposite directions
                ring.add(tuple((a + (b - a) * (z - a[2]) / (b[2] - a[2]))[:2]))
    ring = sorted(ring, key=lambda place: np.arctan2(place[1], place[0]))
    return np.array(ring + ring[:1])


def draw_shapes(axes):
    places, triangles = read_ply(MESH)
    size = places.max(axis=0) - places.min(axis=0)
    for share, width in ((0.0, 1.8), (-0.35, 0.7), (-0.45, 0.7)):
        ring = cut(places, triangles, share * size[2] + 1e-3)
        axes.plot(*ring.T, color=INK, lw=width)
        if share == 0.0:
            axes.fill(*ring.T, color=PRODUCT, zorder=0)
    axes.add_patch(Ellipse((0, 0), size[0], size[1], fill=False, edgecolor=SOFT, lw=1.4, ls=(0, (4, 2))))
    for side in (-1, 1):
        left = side * size[0] / 2 - (THICKNESS_mm if side < 0 else 0)
        axes.add_patch(Rectangle((left, -PAD_mm / 2), THICKNESS_mm, PAD_mm, facecolor=PAD, edgecolor=INK))
    axes.set_aspect("equal")
    axes.set_xlim(-47, 47)
    axes.set_ylim(-43, 43)
    axes.set_xlabel("x, the grip axis [mm]")
    axes.set_ylabel("y [mm]")
    axes.set_title("from above, at three heights; dashed: the ellipsoid", fontsize=9.5)


def draw_windows(axes, window):
    names = window["inputs"][KEY]["values"]
    for row, name in enumerate(names):
        low, high = window["hold_force_N"][row], window["damage_force_N"][row]
        if not np.isfinite([low, high]).all():
            raise Unsuitable("a window with an open end is not drawn here; see plot_window.py")
        axes.barh(row, high - low, left=low, height=0.5, color=PRODUCT if name == "mesh" else "#cfd5db", edgecolor=INK)
        for place, side, gap in ((low, "right", -0.2), (high, "left", 0.2)):
            axes.text(place + gap, row, f"{place:.3g}", va="center", ha=side, fontsize=9.5)
    axes.set_yticks(range(len(names)), [LABELS.get(name, name) for name in names])
    axes.set_ylim(len(names) - 0.4, -0.6)
    axes.set_xlim(0, 1.25 * max(window["damage_force_N"]))
    axes.set_xlabel("window of the grip force [N]")
    axes.spines[["top", "right"]].set_visible(False)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results")
    parser.add_argument("-o", "--output", default=ROOT / "docs/images/mesh_window.svg", type=Path)
    options = parser.parse_args()
    try:
        window = read_results(options.results)["window"]
        if window is None or KEY not in window["inputs"]:
            raise Unsuitable(f"no windows over {KEY}")
        figure, (left, right) = plt.subplots(1, 2, figsize=(9.4, 4.2), gridspec_kw={"width_ratios": [1, 1.15]})
        draw_shapes(left)
        draw_windows(right, window)
    except Unsuitable as why:
        print(f"plot_mesh.py: {why}", file=sys.stderr)
        return 2
    figure.tight_layout()
    save(figure, options.output)
    return 0


if __name__ == "__main__":
    sys.exit(main())
