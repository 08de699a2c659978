#!/usr/bin/python3
"""Draws torques and speeds of an arm's joints over the time of one scenario, as shares of their limits, and, where the joints
give way, how far the palm is from where it was told to be.

    plot_robot.py SCENARIO.h5 [-o FILE.png]     robot_joints.png beside the results unless given

SCENARIO.h5 is what `unbruised run STUDY.toml --scenario ID` leaves: /trace with joint_torque_N_m and joint_speed_rad_s;
the limits stand in its resolved config. It prints how much of each limit each joint uses, and when.
Exit status: 0 drawn, 2 the file holds no trace of an arm.
"""
import argparse
import sys
import tomllib
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from draw_instruments import words_of
from draw_pictures import INK, SOFT, save  # which sets the looks of the pictures
from window_tables import Unsuitable, opened

COLOURS = ["#1b9e77", "#d95f02", "#7570b3", "#e7298a", "#66a61e", "#a6761d", "#22303c", "#8695a3"]


def read(path):
    """Time, torques and speeds as shares of their limits, phases as (begin, word), the palm's sway [m] or None."""
    with opened(path) as file:
        trace = file.get("trace")
        if trace is None or "joint_torque_N_m" not in trace:
            raise Unsuitable(f"{path} holds no /trace/joint_torque_N_m: `run --scenario ID` of a study with a [robot] "
                             "writes it")
        config = file.attrs["config"]
        robot = tomllib.loads(config.decode() if isinstance(config, bytes) else config)["robot"]
        limit = {key: np.array([joint[key] for joint in robot["joint"]]) for key in ("torque_N_m", "speed_rad_s")}
        time = trace["time_s"][:]
        words = trace["phase"][:]
        begins = np.flatnonzero(np.r_[True, words[1:] != words[:-1]])
        named = words_of(trace["phase"])
        phases = [(time[i], named[int(words[i])]) for i in begins]
        sway = trace["palm_position_m"][:] - trace["palm_told_m"][:] if "palm_told_m" in trace else None
        return (time, trace["joint_torque_N_m"][:] / limit["torque_N_m"],
                trace["joint_speed_rad_s"][:] / limit["speed_rad_s"], phases, sway)


def draw_shares(axes, time, share, what):
    for joint in range(share.shape[1]):
        axes.plot(time, share[:, joint], color=COLOURS[joint % len(COLOURS)], lw=1.3,
                  ls="-" if joint < 3 else (0, (4, 2)), label=f"joint {joint}")
    for side in (1.0, -1.0):
        axes.axhspan(side, 1.2 * side, color=SOFT, alpha=0.25, lw=0)
    axes.set_ylim(-1.1, 1.1)
    axes.axhline(0.0, color=SOFT, lw=0.6)
    axes.set_ylabel(f"{what} / limit")
    axes.spines[["top", "right"]].set_visible(False)


def draw_phases(axes, time, phases):
    """A line in every panel where a phase begins; its name above the first, where it lasts."""
    ends = [begin for begin, _ in phases[1:]] + [time[-1]]
    for (begin, word), end in zip(phases, ends):
        for each in axes:
            each.axvline(begin, color=SOFT, lw=0.6, ls=":")
        if end - begin > 0.035 * (time[-1] - time[0]):
            axes[0].text(0.5 * (begin + end), 1.02, word, transform=axes[0].get_xaxis_transform(), ha="center",
                         va="bottom", color=INK, fontsize=8)


def draw_sway(axes, time, sway):
    for direction, (name, colour) in enumerate(zip("xyz", COLOURS)):
        axes.plot(time, 1e3 * sway[:, direction], color=colour, lw=1.3, label=name)
    axes.axhline(0.0, color=SOFT, lw=0.6)
    axes.set_ylabel("palm - told [mm]")
    axes.spines[["top", "right"]].set_visible(False)
    axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1.0), frameon=False)


def draw(time, torque, speed, phases, sway):
    panels = 2 if sway is None else 3
    figure, axes = plt.subplots(panels, 1, figsize=(8.0, 2.6 * panels), sharex=True)
    draw_shares(axes[0], time, torque, "torque")
    draw_shares(axes[1], time, speed, "speed")
    if sway is not None:
        draw_sway(axes[2], time, sway)
    draw_phases(axes, time, phases)
    axes[-1].set_xlabel("time [s]")
    axes[-1].set_xlim(time[0], time[-1])
    axes[0].legend(loc="upper left", bbox_to_anchor=(1.01, 1.0), frameon=False)
    return figure


def table(time, share, what, file=sys.stdout):
    for joint in range(share.shape[1]):
        at = int(np.abs(share[:, joint]).argmax())
        print(f"joint {joint}: {abs(share[at, joint]):6.1%} of its {what} at {time[at]:.3f} s", file=file)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("results", type=Path)
    parser.add_argument("-o", "--output", type=Path)
    arguments = parser.parse_args()
    try:
        time, torque, speed, phases, sway = read(arguments.results)
    except Unsuitable as error:
        print(f"plot_robot: {error}", file=sys.stderr)
        return 2
    output = arguments.output or arguments.results.parent / "robot_joints.png"
    save(draw(time, torque, speed, phases, sway), output)
    table(time, torque, "torque")
    table(time, speed, "speed")
    if sway is not None:
        away = np.linalg.norm(sway, axis=1)
        print(f"palm: {1e3 * away.max():.3g} mm from where it was told to be, at {time[away.argmax()]:.3f} s")
    return 0


if __name__ == "__main__":
    sys.exit(main())
