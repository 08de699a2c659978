#!/usr/bin/python3
"""Presses a sphere of yielding flesh against a layer of springs, with CalculiX (Debian: calculix-ccx).

One half of the sphere, axisymmetric quadratic elements with reduced integration (CAX8R), J2 plasticity with linear
hardening, small strains, no friction; the plate is a stiff strip behind springs of a stiffness per area (linear pressure
over overclosure). Prints one row per step: force, approach of the plate, largest plastic strain, volume above 1 % of
plastic strain below one pole, absorbed energy there, and in the last step, when the plate is back, the dent of the pole.
The outermost element at the pole is left out: its two points on the axis feel single contact springs.

usage: press_sphere.py NAME RADIUS_mm E_MPa NU YIELD_MPa TANGENT_MPa SPRINGS_MPa_mm APPROACH_mm [APPROACH_mm ...]

The rows of tests/reference-data/fe_spheres.csv:
  press_sphere.py soft  35 0.288 0.35 0.024 0.080 0.1333 1.9 2.3 3.0 3.6
  press_sphere.py stiff 25 0.288 0.35 0.024 0.080 4.0    0.35 0.6 1.0 1.4
"""
import math
import subprocess
import sys

RINGS, LAYERS, STRIP = 16, 20, 30  # elements from the axis out, from the middle up, of the plate


class Deck:
    """Nodes and elements of a body on a grid of half elements."""

    def __init__(self):
        self.nodes, self.index, self.lines = [], {}, []

    def node(self, body, i, j, place):
        key = (body, i, j)
        if key not in self.index:
            self.nodes.append(place(i, j))
            self.index[key] = len(self.nodes)
        return self.index[key]

    def elements(self, body, columns, rows, place, name, first):
        self.lines.append(f"*ELEMENT, TYPE=CAX8R, ELSET={name}")
        corners = [(0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1)]
        for a in range(columns):
            for b in range(rows):
                ids = [self.node(body, 2 * a + di, 2 * b + dj, place) for di, dj in corners]
                self.lines.append(f"{first + a * rows + b}," + ",".join(map(str, ids)))


def write_deck(name, radius, material, springs, approaches):
    youngs, nu, yield_stress, tangent = material
    deck = Deck()

    def in_sphere(i, j):
        # The square on the quarter disc (elliptical mapping), fine towards the pole.
        u, v = (i / (2 * RINGS)) ** 1.7, 1 - (1 - j / (2 * LAYERS)) ** 1.7
        return radius * u * math.sqrt(1 - v * v / 2), radius * v * math.sqrt(1 - u * u / 2)

    def in_plate(i, j):
        return 0.75 * radius * i / (2 * STRIP), radius + j

    deck.elements("sphere", RINGS, LAYERS, in_sphere, "BODY", 1)
    plate = RINGS * LAYERS + 1
    deck.elements("plate", STRIP, 1, in_plate, "PLATE", plate)
    lines = ["*NODE, NSET=ALL"]
    lines += [f"{k + 1},{r:.9g},{z:.9g},0" for k, (r, z) in enumerate(deck.nodes)]
    lines += deck.lines
    lines.append("*SURFACE, NAME=TOP")
    lines += [f"{(a + 1) * LAYERS},S3" for a in range(RINGS) if ((a + 1) / RINGS) ** 1.7 < 0.75]
    lines.append("*SURFACE, NAME=LAYER")
    lines += [f"{plate + k},S1" for k in range(STRIP)]

    def node_set(title, keep):
        lines.append(f"*NSET, NSET={title}")
        lines.extend(f"{number}," for key, number in deck.index.items() if keep(*key))

    node_set("AXIS", lambda body, i, j: body == "sphere" and i == 0)
    node_set("MIDDLE", lambda body, i, j: body == "sphere" and j == 0)
    node_set("POLE", lambda body, i, j: body == "sphere" and i == 0 and j == 2 * LAYERS)
    node_set("STRIP", lambda body, i, j: body == "plate")
    hardening = youngs * tangent / (youngs - tangent)
    lines.append(
        f"*MATERIAL, NAME=FLESH\n*ELASTIC\n{youngs},{nu}\n*PLASTIC\n{yield_stress},0.\n{yield_stress + hardening},1.\n"
        f"*MATERIAL, NAME=STIFF\n*ELASTIC\n{1000 * youngs},0.3\n"
        "*SOLID SECTION, ELSET=BODY, MATERIAL=FLESH\n*SOLID SECTION, ELSET=PLATE, MATERIAL=STIFF\n"
        f"*SURFACE INTERACTION, NAME=SPRINGS\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n{springs},1e-6\n"
        "*CONTACT PAIR, INTERACTION=SPRINGS, TYPE=SURFACE TO SURFACE\nTOP,LAYER\n"
        "*BOUNDARY\nAXIS,1\nMIDDLE,2\nSTRIP,1"
    )
    for approach in approaches:
        lines.append(
            f"*STEP, INC=300\n*STATIC\n0.25,1.,1e-5,0.25\n*BOUNDARY\nSTRIP,2,2,{-approach}\n"
            "*NODE PRINT, NSET=STRIP, TOTALS=ONLY, FREQUENCY=1000\nRF\n*NODE PRINT, NSET=POLE, FREQUENCY=1000\nU\n"
            "*EL PRINT, ELSET=BODY, FREQUENCY=1000\nPEEQ\n*EL PRINT, ELSET=BODY, FREQUENCY=1000\nEVOL\n*END STEP"
        )
    with open(name + ".inp", "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")
    return hardening


def read_steps(name):
    """Force, displacement of the pole, strains and volumes of each step; a wedge of two degrees."""
    steps, block = [], None
    for line in open(name + ".dat", encoding="utf-8"):
        words = line.split()
        if not words:
            continue
        if words[0][0].isalpha():
            titles = (("total force", "force"), ("displacements", "pole"), ("equivalent", "strain"), ("volume", "volume"))
            block = next((what for title, what in titles if line.strip().startswith(title)), None)
            if block == "force":
                steps.append({"strain": [], "volume": {}})
        elif block == "force":
            steps[-1]["force"] = -180 * float(words[1])
        elif block == "pole":
            steps[-1]["pole"] = float(words[2])
        elif block == "strain":
            steps[-1]["strain"].append((int(words[0]), float(words[2])))
        elif block == "volume":
            steps[-1]["volume"][int(words[0])] = 180 * float(words[1])
    return steps


def main():
    if len(sys.argv) < 9:
        sys.exit(__doc__)
    name, values = sys.argv[1], [float(word) for word in sys.argv[2:]]
    radius, material, springs, approaches = values[0], values[1:5], values[5], values[6:] + [0.0]
    hardening = write_deck(name, radius, material, springs, approaches)
    subprocess.run(["ccx", "-i", name], check=True, stdout=subprocess.DEVNULL)
    print("force_N,approach_mm,plastic_strain_max,volume_above_1_percent_mm3,absorbed_energy_mJ,pole_mm")
    for approach, step in zip(approaches, read_steps(name)):
        at = [(step["volume"][e] / 8, p) for e, p in step["strain"] if e != LAYERS]  # 8 points of a wedge element
        bruised = sum(volume for volume, p in at if p > 0.01)
        energy = sum(volume * (material[2] * p + 0.5 * hardening * p * p) for volume, p in at)
        strain = max(p for _, p in at)
        print(f"{step['force']:.4f},{approach},{strain:.5f},{bruised:.1f},{energy:.5f},{step['pole']:.4f}")


if __name__ == "__main__":
    main()
