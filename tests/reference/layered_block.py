#!/usr/bin/python3
"""usage: layered_block.py [CELLS ...]

Finite elements of a block with a core and a skin, pressed by two square punches, independent of the simulator: the reference of
tests/core/body/layers_test.cpp. An eighth of a cube of 40 mm in trilinear bricks (2 x 2 x 2 points), the skin as bilinear membranes
on its three outer faces, u_x given under a frictionless square of 16 mm. Prints the stiffness of the whole, force over the way of one
punch, in N/m for E = 1 MPa, nu = 0.3, on meshes of CELLS bricks along each edge of the eighth (by default 10 and 20), and their
limit: the error at the edge of a punch falls with the first power of the cell.
"""
import itertools
import sys

import numpy
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import cg, LinearOperator, spilu

HALF, PUNCH, E, NU = 0.020, 0.008, 1e6, 0.3
CORE_DEPTH, CORE = 0.008, 3.0
SKIN, SKIN_MODULUS, SKIN_NU = 0.0015, 6.8e6, 0.3
SIGN = numpy.array([[1 if (c >> d) & 1 else -1 for d in range(3)] for c in range(8)])
POINT = 1.0 / numpy.sqrt(3.0)


def elasticity(modulus, nu):
    mu, lam = modulus / (2 * (1 + nu)), modulus * nu / ((1 + nu) * (1 - 2 * nu))
    D = numpy.diag([2 * mu] * 3 + [mu] * 3)
    D[:3, :3] += lam
    return D


def strain(gradient):
    B = numpy.zeros((6, 24))
    for c in range(8):
        gx, gy, gz = gradient[c]
        B[:, 3 * c : 3 * c + 3] = [[gx, 0, 0], [0, gy, 0], [0, 0, gz], [0, gz, gy], [gz, 0, gx], [gy, gx, 0]]
    return B


def brick(h, modulus):
    K = numpy.zeros((24, 24))
    for point in itertools.product((-POINT, POINT), repeat=3):
        gradient = numpy.empty((8, 3))
        for c in range(8):
            for d in range(3):
                a, b = [x for x in range(3) if x != d]
                gradient[c, d] = SIGN[c, d] * (1 + SIGN[c, a] * point[a]) * (1 + SIGN[c, b] * point[b]) / (4 * h)
        B = strain(gradient)
        K += B.T @ elasticity(modulus, NU) @ B * (h / 2) ** 3
    return K


def membrane(h):
    """Of a square of side h: freedoms 2 corner + axis, corners (0, 0), (1, 0), (0, 1), (1, 1)."""
    D = SKIN * SKIN_MODULUS / (1 - SKIN_NU**2) * numpy.array([[1, SKIN_NU, 0], [SKIN_NU, 1, 0], [0, 0, (1 - SKIN_NU) / 2]])
    K = numpy.zeros((8, 8))
    for p, q in itertools.product((-POINT, POINT), repeat=2):
        B = numpy.zeros((3, 8))
        for c in range(4):
            s, t = (1 if c & 1 else -1), (1 if c & 2 else -1)
            gx, gy = s * (1 + t * q) / (2 * h), t * (1 + s * p) / (2 * h)
            B[:, 2 * c : 2 * c + 2] = [[gx, 0], [0, gy], [gy, gx]]
        K += B.T @ D @ B * (h / 2) ** 2
    return K


def stiffness(n, core, skin):
    h = HALF / n
    node = lambda i, j, k: i + (n + 1) * (j + (n + 1) * k)  # noqa: E731
    rows, columns, values = [], [], []

    def add(freedoms, K):
        rows.append(numpy.repeat(freedoms, len(freedoms)))
        columns.append(numpy.tile(freedoms, len(freedoms)))
        values.append(K.ravel())

    flesh, stiff = brick(h, E), brick(h, CORE * E)
    for i, j, k in itertools.product(range(n), repeat=3):
        corners = [node(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2)) for c in range(8)]
        depth = HALF - h * (max(i, j, k) + 0.5)
        freedoms = numpy.array([3 * at + d for at in corners for d in range(3)])
        add(freedoms, stiff if core and depth >= CORE_DEPTH else flesh)
    if skin:
        K = membrane(h)
        for axis in range(3):
            a, b = [d for d in range(3) if d != axis]
            for i, j in itertools.product(range(n), repeat=2):
                freedoms = []
                for c in range(4):
                    at = [0, 0, 0]
                    at[axis], at[a], at[b] = n, i + (c & 1), j + (c >> 1)
                    freedoms += [3 * node(*at) + a, 3 * node(*at) + b]
                add(numpy.array(freedoms), K)
    count = 3 * (n + 1) ** 3
    K = coo_matrix((numpy.concatenate(values), (numpy.concatenate(rows), numpy.concatenate(columns))), (count, count)).tocsr()
    u = numpy.zeros(count)
    held = numpy.zeros(count, bool)
    for i, j, k in itertools.product(range(n + 1), repeat=3):
        for d, at in enumerate((i, j, k)):
            held[3 * node(i, j, k) + d] |= at == 0
        if i == n and j * h <= PUNCH * (1 + 1e-9) and k * h <= PUNCH * (1 + 1e-9):
            held[3 * node(i, j, k)] = True
            u[3 * node(i, j, k)] = -1.0
    free = ~held
    inner = K[free][:, free].tocsc()
    guess = spilu(inner, drop_tol=1e-3, fill_factor=8)
    u[free], failed = cg(inner, -(K[free][:, held] @ u[held]), tol=1e-8, M=LinearOperator(inner.shape, guess.solve))
    assert failed == 0
    return 4.0 * float(u @ (K @ u))  # a quarter of the punch in an eighth of the body


def main():
    cells = [int(argument) for argument in sys.argv[1:]] or [10, 20]
    for name, core, skin in (("plain", False, False), ("core", True, False), ("skin", False, True), ("both", True, True)):
        found = [stiffness(n, core, skin) for n in cells]
        h = [1.0 / n for n in cells]
        limit = (found[-1] * h[-2] - found[-2] * h[-1]) / (h[-2] - h[-1]) if len(cells) > 1 else found[-1]
        print(f"{name:6}", *(f"{value:10.1f}" for value in found), f"limit {limit:10.1f}", flush=True)


main()
