#!/usr/bin/python3
"""Draws energies and contacts of one scenario over time, the picture of docs/instruments.md.

usage: scripts/draw_instruments.py SCENARIO.h5 [PICTURE]     docs/images/instruments.png unless given

  unbruised run configs/kiwi_first.toml --scenario 9
"""
import sys

import h5py
import matplotlib.pyplot as plt
import numpy as np

from draw_pictures import INK, SOFT  # which sets the looks of the pictures

STORED = (("kinetic_energy_J", "motion of the product", "#5d83a8"), ("elastic_energy_J", "product, elastic", "#1f4e79"),
          ("contact_energy_J", "layers", "#7fa37a"), ("finger_energy_J", "fingers", "#c9a227"))
LOST = ("#1f4e79", "#b3461f", "#7fa37a", "#6a4c93", "#c9a227", "#8695a3", "#22303c")
SURFACES = ("#b3461f", "#5d83a8", "#22303c")
KINDS = (("make", "^"), ("break", "v"), ("slip", "x"), ("stick", "s"))


def words_of(dataset):
    """{0: "product damping", ...} from "...: 0 product damping, 1 plastic flow"."""
    text = dataset.attrs["long_name"]
    text = text.decode() if isinstance(text, bytes) else str(text)
    return {int(part.split(" ", 1)[0]): part.split(" ", 1)[1] for part in text.split(": ", 1)[1].split(", ")}


def shade_phases(axes, time, phase, names):
    """Every second phase shaded; the names above the first axes."""
    edges = np.flatnonzero(np.diff(phase)) + 1
    starts, ends = np.r_[0, edges], np.r_[edges, len(time) - 1]
    for number, (start, end) in enumerate(zip(starts, ends)):
        for each in axes:
            if number % 2:
                each.axvspan(time[start], time[end], color=INK, alpha=0.05, lw=0)
        if time[end] - time[start] > 0.03 * time[-1]:
            axes[0].text((time[start] + time[end]) / 2, 1.02, names[int(phase[start])], color=SOFT, fontsize=8,
                         ha="center", va="bottom", transform=axes[0].get_xaxis_transform())


def draw_stored(axes, time, trace):
    for name, label, colour in STORED:
        if name in trace:
            axes.semilogy(time, np.maximum(1e3 * trace[name][...], 1e-6), color=colour, lw=1.5, label=label)
    axes.set_ylim(1e-5, None)
    axes.set_ylabel("stored [mJ]")
    axes.legend(frameon=False, fontsize=8, loc="center left", bbox_to_anchor=(1, 0.5))


def draw_lost(axes, time, trace):
    lost, names = trace["dissipated_by_cause_J"], words_of(trace["dissipated_by_cause_J"])
    for cause, colour in enumerate(LOST):
        values = 1e3 * lost[:, cause]
        if abs(values).max() > 1e-3 * abs(1e3 * lost[...]).max():
            axes.plot(time, values, color=colour, lw=1.5, label=names[cause])
    axes.set_ylabel("lost [mJ]")
    axes.legend(frameon=False, fontsize=8, loc="center left", bbox_to_anchor=(1, 0.5))


def draw_counts(axes, time, trace):
    closed, sliding, names = trace["contact_count"], trace["sliding_count"], words_of(trace["contact_count"])
    for surface, colour in enumerate(SURFACES[: closed.shape[1]]):
        axes.step(time, closed[:, surface], where="post", color=colour, lw=4 if surface == 0 else 1.5,
                  alpha=0.5 if surface == 0 else 1, label=names[surface])
        axes.fill_between(time, sliding[:, surface], step="post", color=colour, alpha=0.3, lw=0)
    axes.set_ylabel("closed contacts\n(filled: sliding)")
    axes.legend(frameon=False, fontsize=8, loc="center left", bbox_to_anchor=(1, 0.5))


def draw_events(axes, events, names):
    for row, (kind, mark) in enumerate(KINDS):
        for surface, colour in enumerate(SURFACES):
            here = (events["kind"][...] == row) & (events["surface"][...] == surface)
            axes.plot(events["time_s"][...][here], events["place_z_m"][...][here] * 1e3, mark, color=colour, ms=7 if surface == 0 else 4,
                      mfc="none", mew=0.9, label=kind if surface == 2 else None)
    axes.set_ylabel("height of the event [mm]")
    axes.set_xlabel("time [s]")
    axes.legend(frameon=False, fontsize=8, loc="center left", bbox_to_anchor=(1, 0.5))


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    picture = sys.argv[2] if len(sys.argv) == 3 else "docs/images/instruments.png"
    figure, axes = plt.subplots(4, 1, figsize=(9, 8.5), sharex=True, layout="constrained")
    with h5py.File(sys.argv[1]) as file:
        trace = file["trace"]
        time = trace["time_s"][...]
        if "phase" in trace:
            shade_phases(axes, time, trace["phase"][...], words_of(trace["phase"]))
        draw_stored(axes[0], time, trace)
        draw_lost(axes[1], time, trace)
        draw_counts(axes[2], time, trace)
        draw_events(axes[3], file["contact_events"], words_of(trace["contact_count"]))
    for each in axes:
        each.spines[["top", "right"]].set_visible(False)
        each.set_xlim(0, time[-1])
    figure.savefig(picture, dpi=110, metadata={"Software": None})


if __name__ == "__main__":
    main()
