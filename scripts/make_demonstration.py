#!/usr/bin/python3
"""Writes a demonstration as a teach pendant would record it: the palm's pose and whether the gripper is closed, over time.

    make_demonstration.py [FILE.csv]     configs/data/kiwi_demonstration.csv unless given

No person's hand: a kiwi is gripped, lifted by 60 mm, carried on a curve over an obstacle, leaning a little on the way, and put
down 0.35 m on; every motion of minimum jerk, with a tremor of 0.1 mm and 1 mrad (standard deviations) and 50 rows a second.
"""
import sys
from pathlib import Path

import numpy as np

RATE_HZ, TREMOR_M, TREMOR_RAD = 50.0, 1e-4, 1e-3
HOME = np.array([0.42, -0.11, 0.165])  # of the palm where it grips, in the robot's base
YAW = 0.25  # of the grip axis there


def share(time, start, length):
    """Of a motion of minimum jerk."""
    s = np.clip((time - start) / length, 0.0, 1.0)
    return s**3 * (10 - 15 * s + 6 * s**2)


def turned(yaw, points):
    c, s = np.cos(yaw), np.sin(yaw)
    return points @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])


def main():
    default = Path(__file__).resolve().parent.parent / "configs/data/kiwi_demonstration.csv"
    path = Path(sys.argv[1]) if len(sys.argv) > 1 else default
    random = np.random.default_rng(7)
    time = np.arange(0.0, 5.8, 1.0 / RATE_HZ)
    up, over, down = share(time, 1.2, 0.8), share(time, 2.0, 1.6), share(time, 3.6, 1.0)
    arch = np.sin(np.pi * over)
    place = np.stack([0.05 * arch, 0.35 * over, 0.06 * up - 0.06 * down + 0.08 * arch], axis=1)
    place += TREMOR_M * random.standard_normal(place.shape)
    place = HOME + turned(YAW, place)
    # Leans about the grip axis, by turns first about the vertical.
    lean, heading = 0.15 * arch + TREMOR_RAD * random.standard_normal(len(time)), YAW + TREMOR_RAD * random.standard_normal(len(time))
    quaternion = np.stack([np.cos(heading / 2) * np.cos(lean / 2), np.cos(heading / 2) * np.sin(lean / 2),
                           np.sin(heading / 2) * np.sin(lean / 2), np.sin(heading / 2) * np.cos(lean / 2)], axis=1)
    closed = (time >= 0.6) & (time < 5.0)
    force = np.where(closed, 3.0, 0.0)
    with open(path, "w", encoding="utf-8") as file:
        file.write("# Made by scripts/make_demonstration.py, which says how; recorded from nobody's hand.\n")
        file.write("time_s,x_m,y_m,z_m,qw,qx,qy,qz,closed,grip_force_N\n")
        for row in zip(time, place, quaternion, closed, force):
            numbers = ",".join(f"{number:.5f}" for number in (*row[1], *row[2]))
            file.write(f"{row[0]:.3f},{numbers},{int(row[3])},{row[4]:.1f}\n")
    print(path)


if __name__ == "__main__":
    main()
