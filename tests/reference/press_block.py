#!/usr/bin/python3
"""Presses a cube between two square pads that end within its faces, with brick elements of its own (Debian: python3-scipy).

One eighth of the cube: bricks with eight corners and incompatible modes, small strains, no friction; the pads are rigid
plates behind springs of a stiffness per area. Prints a row per case: force per approach of both pads together.

usage: press_block.py SIDE_mm E_MPa NU SPRINGS_MPa_mm ELEMENTS PAD_mm [PAD_mm ...]

ELEMENTS lie along half a side; half a pad has to end between two of them. The rows of tests/reference-data/fe_blocks.csv:
  press_block.py 50 0.1 0.25 0.1333 40 20 30 40
  press_block.py 50 0.1 0.25 1.25   40 20 30 40
  press_block.py 50 0.1 0.45 0.1333 40 20 30 40
"""
import sys

import numpy as np
import scipy.sparse as sparse
import scipy.sparse.linalg as solvers

CORNERS = np.array([[i, j, k] for i in (0, 1) for j in (0, 1) for k in (0, 1)])


def strain_rows(slopes):
    """Six strains by three displacements of each function, from the functions' slopes along x, y, z."""
    rows = np.zeros((6, 3 * len(slopes)))
    for n, (x, y, z) in enumerate(slopes):
        rows[:, 3 * n:3 * n + 3] = [[x, 0, 0], [0, y, 0], [0, 0, z], [y, x, 0], [0, z, y], [z, 0, x]]
    return rows


def brick(modulus, nu, side):
    """Stiffness of a cube element, its incompatible modes 1 - s^2 condensed out."""
    first, shear = modulus * nu / ((1 + nu) * (1 - 2 * nu)), modulus / 2 / (1 + nu)
    law = np.diag([2 * shear] * 3 + [shear] * 3)
    law[:3, :3] += first
    own, mixed, inner = np.zeros((24, 24)), np.zeros((9, 24)), np.zeros((9, 9))
    signs = 2 * CORNERS - 1
    for at in (2 * CORNERS - 1) / np.sqrt(3):
        factors = (1 + signs * at) / 2
        slopes = np.array([[s[d] / 2 * np.prod(np.delete(f, d)) for d in range(3)] for s, f in zip(signs, factors)])
        body, bubble = strain_rows(slopes * 2 / side), strain_rows(np.diag(-2 * at) * 2 / side)
        weight = (side / 2) ** 3
        own += body.T @ law @ body * weight
        mixed += bubble.T @ law @ body * weight
        inner += bubble.T @ law @ bubble * weight
    return own - mixed.T @ np.linalg.solve(inner, mixed)


class Eighth:
    """One eighth of the cube from its middle out; the pad lies on x = half."""

    def __init__(self, half, modulus, nu, count):
        self.count, self.element = count, half / count
        self.points = (count + 1) ** 3
        cells = np.array([[i, j, k] for i in range(count) for j in range(count) for k in range(count)])
        corners = self.index(*(cells[:, None, :] + CORNERS).reshape(-1, 3).T).reshape(-1, 8)
        freedoms = (corners[:, :, None] * 3 + np.arange(3)).reshape(-1, 24)
        values = np.tile(brick(modulus, nu, self.element).ravel(), len(cells))
        self.stiffness = sparse.coo_matrix(
            (values, (np.repeat(freedoms, 24, axis=1).ravel(), np.tile(freedoms, (1, 24)).ravel())),
            shape=(3 * self.points,) * 2).tocsr()

    def index(self, i, j, k):
        return (i * (self.count + 1) + j) * (self.count + 1) + k

    def pad(self, half_pad, springs):
        """Stiffness and load of the springs under a pad that is one unit pressed in."""
        share = np.array([[4, 2, 2, 1], [2, 4, 1, 2], [2, 1, 4, 2], [1, 2, 2, 4]]) / 36 * self.element**2 * springs
        covered = round(half_pad / self.element)
        if abs(covered * self.element - half_pad) > 1e-9:
            sys.exit("press_block: half a pad has to end between two elements")
        load, rows, columns, values = np.zeros(3 * self.points), [], [], []
        for j in range(covered):
            for k in range(covered):
                at = [3 * self.index(self.count, j + a, k + b) for a in (0, 1) for b in (0, 1)]
                load[at] += share.sum(axis=1)
                rows += np.repeat(at, 4).tolist()
                columns += at * 4
                values += share.ravel().tolist()
        return sparse.coo_matrix((values, (rows, columns)), shape=self.stiffness.shape).tocsr(), load

    def force_per_approach(self, half_pad, springs):
        layer, load = self.pad(half_pad, springs)
        grid = np.arange(self.count + 1)
        a, b = (each.ravel() for each in np.meshgrid(grid, grid))
        fixed = np.concatenate([3 * self.index(0, a, b), 3 * self.index(a, 0, b) + 1, 3 * self.index(a, b, 0) + 2])
        free = np.setdiff1d(np.arange(3 * self.points), fixed)
        matrix = (self.stiffness + layer)[free][:, free]
        scale = sparse.diags(1 / matrix.diagonal())
        inward, failed = solvers.cg(matrix, load[free], tol=1e-9, M=scale, maxiter=20000)
        if failed:
            sys.exit("press_block: the solver did not converge")
        force = springs * half_pad**2 - load[free] @ inward
        return 4 * force / 2  # four quarters of the pad; both pads approach


def main():
    if len(sys.argv) < 7:
        sys.exit(__doc__)
    side, modulus, nu, springs = map(float, sys.argv[1:5])
    block = Eighth(side / 2, modulus, nu, int(sys.argv[5]))
    for pad in map(float, sys.argv[6:]):
        print(f"{side:g},{modulus:g},{nu:g},{springs:g},{pad:g},{block.force_per_approach(pad / 2, springs):.4f}", flush=True)


if __name__ == "__main__":
    main()
