#!/usr/bin/python3
"""Stiffness of a block of rubber between a bonded back and a face that is pressed in as a whole, by finite elements
that share nothing with the lattice: bricks of 27 nodes, 27 integration points, a quarter of the block.

tests/core/gripper/pad_body_test.cpp has its numbers.
"""

import itertools

import numpy as np
import scipy.sparse as sparse
from scipy.sparse.linalg import spsolve

SIDE_m, MODULUS_Pa = 0.03, 1e6


def shape_1d(x):
    """Values and slopes of the three quadratics at -1, 0, 1."""
    return (np.array([x * (x - 1) / 2, 1 - x * x, x * (x + 1) / 2]), np.array([x - 0.5, -2 * x, x + 0.5]))


def element_stiffness(h, poisson):
    lam = MODULUS_Pa * poisson / ((1 + poisson) * (1 - 2 * poisson))
    mu = MODULUS_Pa / (2 * (1 + poisson))
    D = np.diag([2 * mu] * 3 + [mu] * 3)
    D[:3, :3] += lam
    points, weights = np.polynomial.legendre.leggauss(3)
    K = np.zeros((81, 81))
    for (a, wa), (b, wb), (c, wc) in itertools.product(zip(points, weights), repeat=3):
        (na, da), (nb, db), (nc, dc) = shape_1d(a), shape_1d(b), shape_1d(c)
        slope = [np.einsum("i,j,k->ijk", *s).ravel() * 2 / h[d]
                 for d, s in enumerate([(da, nb, nc), (na, db, nc), (na, nb, dc)])]
        B = np.zeros((6, 81))
        for i in range(3):
            B[i, i::3] = slope[i]
        for row, (i, j) in zip((3, 4, 5), ((1, 2), (0, 2), (0, 1))):
            B[row, i::3], B[row, j::3] = slope[j], slope[i]
        K += wa * wb * wc * np.prod(h) / 8 * B.T @ D @ B
    return K


def stiffness_N_m(thickness_m, poisson, cells, held_face):
    """Of the whole pad along x. Elements grow smaller towards its free sides, its back and its face, where stress
    has no bound. @param held_face may the face not move along itself?"""
    part = np.arange(cells + 1) / cells
    size = [np.diff(thickness_m * (1 - np.cos(np.pi * part)) / 2)] + 2 * [np.diff(SIDE_m / 2 * np.sin(np.pi / 2 * part))]
    nodes = 3 * (2 * cells + 1,)
    number = np.arange(np.prod(nodes)).reshape(nodes)
    values, dofs = [], []
    for e in itertools.product(range(cells), repeat=3):
        values.append(element_stiffness([size[d][e[d]] for d in range(3)], poisson).ravel())
        block = number[tuple(slice(2 * i, 2 * i + 3) for i in e)].ravel()
        dofs.append((3 * block[:, None] + np.arange(3)).ravel())
    dofs = np.array(dofs)
    K = sparse.csr_matrix((np.concatenate(values),
                           (np.repeat(dofs, 81, axis=1).ravel(), np.tile(dofs, (1, 81)).ravel())))
    fixed = np.zeros(3 * number.size, bool)
    given = np.zeros(3 * number.size)
    fixed[[3 * n + i for n in number[0].ravel() for i in range(3)]] = True
    face = number[-1].ravel()
    fixed[3 * face] = True
    given[3 * face] = -1.0
    if held_face:
        fixed[3 * face + 1] = fixed[3 * face + 2] = True
    fixed[3 * number[:, 0, :].ravel() + 1] = True  # symmetry: y = 0 and z = 0 are the middle
    fixed[3 * number[:, :, 0].ravel() + 2] = True
    free = ~fixed
    u = given.copy()
    u[free] = spsolve(K[free][:, free].tocsc(), -K[free] @ given)
    return 4 * -(K @ u)[3 * face].sum()


def main():
    for thickness_m, poisson in ((0.01, 0.49), (0.01, 0.3), (0.003, 0.0)):
        for held in (True, False):
            values = [stiffness_N_m(thickness_m, poisson, n, held) for n in (3, 5, 7)]
            print(f"t {1e3 * thickness_m:.0f} mm, nu {poisson}, face {'held' if held else 'free'}: "
                  f"{', '.join(f'{v:.0f}' for v in values)} N/m", flush=True)


if __name__ == "__main__":
    main()
