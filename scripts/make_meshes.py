#!/usr/bin/env python3
"""Makes the meshes of configs/data: shapes drawn by rules, not scanned from real products.

usage: scripts/make_meshes.py [FOLDER]     configs/data unless given

ribbed_tomato.ply: a beefsteak tomato in mm, with six ribs, a dimple at the stem and a smaller one below.
"""
import sys
from pathlib import Path

import numpy as np


def geodesic_sphere(frequency):
    """Places and triangles of a unit sphere: an icosahedron, each triangle in frequency^2."""
    g = (1 + 5 ** 0.5) / 2
    corners = np.array([p for a in (-1, 1) for b in (-g, g) for p in ((0, a, b), (a, b, 0), (b, 0, a))], float)
    near = np.linalg.norm(corners[:, None] - corners[None], axis=2)
    faces = [(i, j, k) for i in range(12) for j in range(i + 1, 12) for k in range(j + 1, 12)
             if max(near[i, j], near[j, k], near[k, i]) < 2.001]
    places, number, triangles = [], {}, []

    def number_of(place):
        place = place / np.linalg.norm(place)
        key = tuple(np.round(place, 9) + 0.0)
        if key not in number:
            number[key] = len(places)
            places.append(place)
        return number[key]

    for face in faces:
        a, b, c = corners[list(face)]
        if np.dot(a, np.cross(b, c)) < 0:
            b, c = c, b
        grid = {(i, j): number_of(a + (b - a) * i / frequency + (c - a) * j / frequency)
                for i in range(frequency + 1) for j in range(frequency + 1 - i)}
        for i in range(frequency):
            for j in range(frequency - i):
                triangles.append((grid[i, j], grid[i + 1, j], grid[i, j + 1]))
                if i + j < frequency - 1:
                    triangles.append((grid[i + 1, j], grid[i + 1, j + 1], grid[i, j + 1]))
    return np.array(places), np.array(triangles)


def ribbed_tomato():
    """In mm, 76 x 74 x 58; z up, stem above."""
    d, triangles = geodesic_sphere(14)
    blocky = 2.3  # of its outline, seen from the side
    d = d / ((d[:, 0] ** 2 + d[:, 1] ** 2) ** (blocky / 2) + np.abs(d[:, 2]) ** blocky)[:, None] ** (1 / blocky)
    across, angle = np.hypot(d[:, 0], d[:, 1]), np.arctan2(d[:, 1], d[:, 0])
    ribs = 1 + np.clip(across, 0, 1) ** 1.5 * (0.055 * np.cos(6 * angle) - 0.006 * np.cos(12 * angle) +
                                               0.012 * np.cos(angle - 0.7) + 0.008 * np.cos(2 * angle + 1))
    x, y, z = d[:, 0] * ribs, d[:, 1] * ribs, d[:, 2].copy()
    z -= np.where(z > 0, 0.28 * np.exp(-(across / 0.32) ** 2), 0)
    z += np.where(z < 0, 0.08 * np.exp(-(across / 0.28) ** 2), 0)
    places = np.stack([x, y, z], axis=1)
    places -= (places.max(axis=0) + places.min(axis=0)) / 2
    return places / (places.max(axis=0) - places.min(axis=0)) * [76, 74, 58], triangles


def write_ply(path, places, triangles, comment):
    lines = ["ply", "format ascii 1.0", f"comment {comment}", f"element vertex {len(places)}",
             *(f"property float {axis}" for axis in "xyz"), f"element face {len(triangles)}",
             "property list uchar int vertex_indices", "end_header"]
    lines += [" ".join(f"{x:.3f}" for x in place) for place in places]
    lines += [f"3 {a} {b} {c}" for a, b, c in triangles]
    path.write_text("\n".join(lines) + "\n")


def main():
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent.parent / "configs/data")
    folder.mkdir(parents=True, exist_ok=True)
    write_ply(folder / "ribbed_tomato.ply", *ribbed_tomato(), "beefsteak tomato, drawn by scripts/make_meshes.py, in mm")


if __name__ == "__main__":
    main()
