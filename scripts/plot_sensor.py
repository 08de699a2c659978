#!/usr/bin/python3
"""Draws what a six-axis sensor read in one scenario, as Fig. 4 of Li, Wang and Ho (1998), and tables the bounces.

    plot_sensor.py RESULTS.h5 [-o FILE.png]     sensor_force.png beside the results unless given

Of a product that bounces on a plate it prints each bounce: when it touched, how long it pressed and flew, the peak,
and the restitution by the flights.
Exit status: 0 drawn, 2 the file holds no trace of a sensor.
"""
import argparse
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from draw_pictures import INK, SOFT, save  # which sets the looks of the pictures
from window_tables import Unsuitable, opened

GRAVITY = 9.80665
READ = "#1b9e77"
BESIDE = {"loc": "upper left", "bbox_to_anchor": (1.01, 1.0), "frameon": False}


def trace_of(path):
    """Time, the reading and the compensated reading of /trace, or of the scenario's own file."""
    with opened(path) as file:
        trace = file.get("trace")
        if trace is None or "sensor_wrench" not in trace:
            raise Unsuitable(f"{path} holds no /trace/sensor_wrench: a study of kind = \"simulate\" with a [sensor], or "
                             "`run --scenario ID`, writes it")
        return trace["time_s"][:], trace["sensor_wrench"][:], trace["sensor_wrench_compensated"][:]


def bounces(time, force, least_s=1e-3):
    """Touch and release of every contact; a gap shorter than `least_s` does not end one."""
    pressed = np.flatnonzero(force > 1e-6 * force.max())
    if pressed.size == 0:
        return np.empty((0, 2))
    apart = np.flatnonzero(np.diff(time[pressed]) > least_s)
    first, last = np.append(0, apart + 1), np.append(apart, pressed.size - 1)
    return np.column_stack([time[pressed[first]], time[pressed[last]]])


def table(rows, force, time, file=sys.stdout):
    """Prints the bounces with the peaks that were read; restitution: the flight after a bounce over that before."""
    print("bounce  touch_s  contact_ms  flight_s  peak_N  restitution  height_mm", file=file)
    flight = np.append(rows[1:, 0] - rows[:-1, 1], np.nan)
    before = 2.0 * rows[0, 0]  # let go at the top of a flight
    for i, (touch, release) in enumerate(rows):
        peak = force[(time >= touch) & (time <= release)].max()
        flies = np.isfinite(flight[i])
        left = f"{flight[i]:8.4f}" if flies else "   rests"
        print(f"{i + 1:6d}  {touch:7.4f}  {1e3 * (release - touch):10.2f}  {left}  {peak:6.2f}"
              + (f"  {flight[i] / before:11.3f}  {1e3 * GRAVITY * flight[i] ** 2 / 8.0:9.2f}" if flies else ""), file=file)
        before = flight[i]


def draw(time, wrench, compensated):
    """Force over time; torques below where there are any."""
    force = wrench[:, :3]
    torque = wrench[:, 3:]
    has_torque = np.abs(torque).max() > 1e-5 * np.abs(force).max()
    figure, axes = plt.subplots(2 if has_torque else 1, 1, figsize=(7.2, 4.8 if has_torque else 3.4), sharex=True,
                                squeeze=False)
    upper = axes[0, 0]
    names = "xyz"
    colors = [SOFT, "#7570b3", READ]
    for axis in range(3):
        if np.abs(force[:, axis]).max() < 1e-3 * np.abs(force).max():
            continue
        upper.plot(time, force[:, axis], color=colors[axis], lw=1.2, label=f"F{names[axis]} read")
    if np.abs(compensated[:, 2] - force[:, 2]).max() > 0.1 * np.abs(force).max():
        upper.plot(time, compensated[:, 2], color=INK, lw=0.8, ls="--", label="Fz compensated")
    upper.set_ylabel("force [N]")
    upper.legend(**BESIDE)
    if has_torque:
        for axis in range(3):
            axes[1, 0].plot(time, torque[:, axis], color=colors[axis], lw=1.2, label=f"M{names[axis]} read")
        axes[1, 0].set_ylabel("torque [N m]")
        axes[1, 0].legend(**BESIDE)
    axes[-1, 0].set_xlabel("time [s]")
    axes[-1, 0].set_xlim(time[0], time[-1])
    return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("results", type=Path)
    parser.add_argument("-o", "--output", type=Path)
    arguments = parser.parse_args()
    try:
        time, wrench, compensated = trace_of(arguments.results)
    except Unsuitable as error:
        print(f"plot_sensor: {error}", file=sys.stderr)
        return 2
    output = arguments.output or arguments.results.parent / "sensor_force.png"
    save(draw(time, wrench, compensated), output)
    rows = bounces(time, compensated[:, 2])  # without the plate's own swing
    if len(rows) > 2 and rows[0, 0] > time[0]:
        table(rows, wrench[:, 2], time)
    return 0


if __name__ == "__main__":
    sys.exit(main())
