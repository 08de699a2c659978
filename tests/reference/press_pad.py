#!/usr/bin/python3
"""Boundary elements of a pad that presses an elastic half-space through a layer (Debian: python3-numpy).

Pressures on a grid of squares, the deflection by fast Fourier transforms, no friction, conjugate gradients on what
touches (Polonsky and Keer 1999); the stress inside by Boussinesq's field, wave by wave. The layer is springs, or
rubber bonded to a rigid back that may move along the product.

usage: press_pad.py fruit RADIUS_mm RADIUS_mm E_MPa NU YIELD_MPa LAYER_MPa LAYER_mm LAYER_NU
                          force at first yield [N] and area of the patch [mm2]; a LAYER_NU of 0: springs
       press_pad.py flat LAMBDA NU [EDGE_mm FORCE_N]
                          peak stress over mean pressure in 10 mm3 below a square pad of 30 mm of E = 0.288 MPa, nu 0.35,
                          LAMBDA = k w / E*, w = 15 mm; with the radius of its edges, under a force
       press_pad.py strip LAMBDA RADIUS_mm FORCE_N
                          the same pad across a cylinder, over the peak of a strip without ends: in 10 mm3, in the middle

The rows of fe_kiwi.csv with rubber:  press_pad.py fruit 50.41 25 0.288 0.35 0.024 0.4 3 0.49 ... (within 1.3 %)
The tables of core/contact/pad_edge.cpp:  flat 0.316 0.35 to flat 100 0.35, strip 0.316 20 10.8 to strip 100 20 10.8
"""
import sys

import numpy as np

FLESH, FLESH_NU = 0.288, 0.35  # MPa


def waves(count, cell):
    """Wave numbers along x and y, and their length; the constant has 1 instead of 0."""
    each = 2 * np.pi * np.fft.fftfreq(count, cell)
    along, across = np.meshgrid(each, each, indexing="ij")
    length = np.hypot(along, across)
    length[0, 0] = 1
    return along, across, length


def layer_deflection(modulus, thickness, nu):
    """Deflection of the layer's face per pressure, by wave number."""
    if nu == 0:
        return lambda q: thickness / modulus + 0 * q

    def of(q):
        x, kappa = np.clip(q * thickness, 1e-9, 35), 3 - 4 * nu
        response = (2 * kappa * np.sinh(2 * x) - 4 * x) / (2 * kappa * np.cosh(2 * x) + 4 * x * x + 1 + kappa**2)
        return 2 * (1 - nu**2) / modulus * response / q
    return of


class Press:
    """A grid over the pad; lengths in mm, forces in N."""

    def __init__(self, cell, count, gap, allowed, modulus, nu, layer):
        self.cell, self.count, self.gap, self.allowed, self.nu = cell, count, gap, allowed, nu
        _, _, q = waves(2 * count, cell)  # room around it, so that images do not touch
        self.deflection = 2 / (modulus / (1 - nu**2) * q) + layer(q)
        self.deflection[0, 0] = layer(np.array([1e-9]))[0]

    def deflect(self, pressure):
        room = np.zeros((2 * self.count,) * 2)
        room[:self.count, :self.count] = pressure
        return np.real(np.fft.ifft2(np.fft.fft2(room) * self.deflection))[:self.count, :self.count]

    def under(self, force):
        area = self.cell**2
        pressure = np.where(self.allowed & (self.gap < 1.0), 1.0, 0.0)
        pressure *= force / (pressure.sum() * area)
        search, last, keep = np.zeros_like(pressure), 1.0, 0.0
        for _ in range(1000):
            touches = pressure > 0
            apart = self.deflect(pressure) + self.gap
            apart -= apart[touches].mean()
            square = (apart[touches]**2).sum()
            search = np.where(touches, apart + keep * square / last * search, 0.0)
            last = square
            response = self.deflect(search)
            response -= response[touches].mean()
            step = (apart[touches] * search[touches]).sum() / (response[touches] * search[touches]).sum()
            moved = np.maximum(np.where(touches, pressure - step * search, pressure), 0)
            closing = self.allowed & (moved == 0) & (apart < 0)
            keep = 0.0 if closing.any() else 1.0
            moved = np.where(closing, moved - step * apart, moved)
            moved *= force / (moved.sum() * area)
            change, pressure = np.abs(moved - pressure).sum() / pressure.sum(), moved
            if change < 1e-7:
                return pressure
        sys.exit("press_pad: the pressure did not converge")

    def stress(self, pressure, depths):
        """Von Mises stress at these depths below the grid."""
        count, nu = 4 * self.count, self.nu
        room, at = np.zeros((count, count)), (count - self.count) // 2
        room[at:at + self.count, at:at + self.count] = pressure
        along, across, q = waves(count, self.cell)
        x, y, spectrum = along / q, across / q, np.fft.fft2(room)

        def field(wave):
            return np.real(np.fft.ifft2(wave))[at:at + self.count, at:at + self.count]
        layers = []
        for z in depths:
            wave, qz = spectrum * np.exp(-q * z), q * z
            xx = -field(wave * (x * x * (1 - qz) + 2 * nu * y * y))
            yy = -field(wave * (y * y * (1 - qz) + 2 * nu * x * x))
            zz = -field(wave * (1 + qz))
            xy = -field(wave * x * y * ((1 - qz) - 2 * nu))
            xz, yz = field(1j * along * z * wave), field(1j * across * z * wave)
            normal = ((xx - yy)**2 + (yy - zz)**2 + (zz - xx)**2) / 2
            layers.append(np.sqrt(normal + 3 * (xy**2 + xz**2 + yz**2)))
        return np.array(layers)


def grid(cell, count):
    each = (np.arange(count) - count / 2 + 0.5) * cell
    return np.meshgrid(each, each, indexing="ij")


def passed_in(stress, volume, of_cell):
    return np.sort(stress.ravel())[-int(volume / of_cell)]


def fruit(radius_x, radius_y, modulus, nu, yield_stress, layer):
    cell, count = 0.5, 128
    x, y = grid(cell, count)
    press = Press(cell, count, x**2 / (2 * radius_x) + y**2 / (2 * radius_y), x < np.inf, modulus, nu, layer)
    low, high = 0.2, 40.0
    for _ in range(14):
        force = np.sqrt(low * high)
        pressure = press.under(force)
        area = (pressure > 0).sum() * cell**2
        peak = press.stress(pressure, np.linspace(0.3, 0.6, 7) * np.sqrt(area / np.pi)).max()
        low, high = (low, force) if peak > yield_stress else (force, high)
    print(f"first yield {force:.3f} N, patch {area:.1f} mm2")


def pad(stiffness, radius, edge, force, nu):
    """Stress below a pad of 30 mm across a cylinder (radius inf: a flat face), and the grid's cell."""
    cell, count, half = 0.75, 80, 15.0
    x, y = grid(cell, count)
    gap = x**2 / (2 * radius)
    for side in (x, y):
        beyond = np.maximum(np.abs(side) - (half - edge), 0)
        gap = gap + edge - np.sqrt(np.maximum(edge**2 - beyond**2, 0))
    press = Press(cell, count, gap, (np.abs(x) < half) & (np.abs(y) < half), FLESH, nu, lambda q: 1 / stiffness + 0 * q)
    depths = np.arange(1, 40) * 0.375
    return press.stress(press.under(force), depths), cell**2 * 0.375


def main():
    kind, numbers = (sys.argv[1] if len(sys.argv) > 1 else ""), [float(each) for each in sys.argv[2:]]
    half = 15.0
    if kind == "fruit" and len(numbers) == 8:
        fruit(*numbers[:5], layer_deflection(*numbers[5:]))
    elif kind == "flat" and len(numbers) in (2, 4):
        edge, force = numbers[2:] if len(numbers) == 4 else (0.0, 10.0)
        stress, of_cell = pad(numbers[0] * FLESH / (1 - FLESH_NU**2) / half, np.inf, edge, force, numbers[1])
        print(f"{numbers[0]:g}: {passed_in(stress, 10.0, of_cell) / (force / (4 * half**2)):.3f}")
    elif kind == "strip" and len(numbers) == 3:
        lam, radius, force = numbers
        modulus, line = FLESH / (1 - FLESH_NU**2), force / (2 * half)
        stiffness = lam * modulus / half
        stress, of_cell = pad(stiffness, radius, 0.0, force, FLESH_NU)
        width = np.cbrt((4 * line * radius / (np.pi * modulus))**1.5 + 1.5 * line * radius / stiffness)
        even = 0.6886 * line / (2 * width)  # Hertz's strip at this Poisson ratio
        middle = stress[:, :, stress.shape[2] // 2].max()
        print(f"{lam:g}: {passed_in(stress, 10.0, of_cell) / even:.3f}, middle {middle / even:.3f}")
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main()
