#!/usr/bin/python3
"""Draws what a six-axis sensor read in one scenario, as Fig. 4 of Li, Wang and Ho (1998), and tables the bounces.

    plot_sensor.py RESULTS.h5 [-o FILE.png]     sensor_force.png beside the results unless given

Of a product that bounces on a plate it prints each bounce: when it touched, how long it pressed and flew, the peak,
and the restitution by the flights. Those without a number are the last.
Exit status: 0 drawn, 2 the file holds no trace of a sensor.
"""
import argparse
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from draw_pictures import INK, SOFT, save  # which sets the looks of the pictures

GRAVITY = 9.80665
READ = "#1b9e77"


def trace_of(path):
    """Time, the reading and the compensated reading of /trace, or of the scenario's own file."""
    import h5py

    with h5py.File(path, "r") as results:
        trace = results.get("trace")
        if trace is None or "sensor_wrench" not in trace:
            raise SystemExit(f"plot_sensor: {path} holds no /trace/sensor_wrench: a study of kind = \"simulate\" with a "
                             "[sensor], or `run --scenario ID`, writes it")
        return trace["time_s"][:], trace["sensor_wrench"][:], trace["sensor_wrench_compensated"][:]


def crossings(time, force, level):
    """Times at which the force rises above and falls below a level, between rows."""
    above = force > level
    at = np.flatnonzero(above[1:] != above[:-1])
    when = time[at] + (level - force[at]) / (force[at + 1] - force[at]) * (time[at + 1] - time[at])
    return when[~above[at]], when[above[at]]


def bounces(time, force):
    """Touch, release and peak of every contact that a flight ends."""
    touch, release = crossings(time, force, 0.002 * force.max())
    rows = []
    for start, end in zip(touch, release):
        inside = (time >= start) & (time <= end)
        if inside.any():
            rows.append([start, end, force[inside].max()])
    return np.array(rows).reshape(-1, 3)


def table(rows, file=sys.stdout):
    """Prints the bounces; the restitution of a bounce is the flight after it over the one before."""
    print("bounce  touch_s  contact_ms  flight_s  peak_N  restitution  height_mm", file=file)
    flight = np.append(rows[1:, 0] - rows[:-1, 1], np.nan)
    before = 2.0 * rows[0, 0]  # let go at the top of a flight
    for i, (touch, release, peak) in enumerate(rows):
        if np.isnan(flight[i]) or flight[i] < 2e-3:
            break
        height = GRAVITY * flight[i] ** 2 / 8.0
        print(f"{i + 1:6d}  {touch:7.4f}  {1e3 * (release - touch):10.2f}  {flight[i]:8.4f}  {peak:6.2f}  "
              f"{flight[i] / before:11.3f}  {1e3 * height:9.2f}", file=file)
        before = flight[i]


def draw(time, wrench, compensated):
    """Force over time; torques below where there are any."""
    force = wrench[:, :3]
    torque = wrench[:, 3:]
    has_torque = np.abs(torque).max() > 1e-3 * np.abs(force).max() * 0.01
    figure, axes = plt.subplots(2 if has_torque else 1, 1, figsize=(7.2, 4.8 if has_torque else 3.4), sharex=True,
                                squeeze=False)
    upper = axes[0, 0]
    names = "xyz"
    colors = [SOFT, "#7570b3", READ]
    for axis in range(3):
        if np.abs(force[:, axis]).max() < 1e-3 * np.abs(force).max():
            continue
        upper.plot(time, force[:, axis], color=colors[axis], lw=1.2, label=f"F{names[axis]} read")
    if np.abs(compensated[:, 2] - force[:, 2]).max() > 0.01 * np.abs(force).max():
        upper.plot(time, compensated[:, 2], color=INK, lw=0.8, ls="--", label="Fz compensated")
    upper.set_ylabel("force [N]")
    upper.legend(loc="upper right")
    if has_torque:
        for axis in range(3):
            axes[1, 0].plot(time, torque[:, axis], color=colors[axis], lw=1.2, label=f"M{names[axis]} read")
        axes[1, 0].set_ylabel("torque [N m]")
        axes[1, 0].legend(loc="upper right")
    axes[-1, 0].set_xlabel("time [s]")
    axes[-1, 0].set_xlim(time[0], time[-1])
    return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("results", type=Path)
    parser.add_argument("-o", "--output", type=Path)
    arguments = parser.parse_args()
    time, wrench, compensated = trace_of(arguments.results)
    output = arguments.output or arguments.results.parent / "sensor_force.png"
    save(draw(time, wrench, compensated), output)
    print(f"plot: {output}")
    rows = bounces(time, wrench[:, 2])
    if len(rows) > 2:
        table(rows)


if __name__ == "__main__":
    sys.exit(main())
