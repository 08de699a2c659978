#!/usr/bin/python3
"""Draws the grip windows that a sweep or a window study found, from its own tables.

    plot_window.py RESULTS.h5 [-o FILE.png]

A sweep over the grip force becomes a map of outcomes: grip force across, approach speed (or the first other varied
key) upwards, one panel per combination of the remaining keys. A window study becomes one bar from F_hold to F_damage
per value of its varied key. The answer, both ends, their brackets, the set-points and the colours of the outcomes are read
from the results, as the report reads them; nothing is worked out here. Other kinds have no such picture: their report.html shows what they found.
Exit status: 0 drawn, 2 the file does not hold what is needed.
"""
import argparse
import itertools
import math
import os
import sys
import textwrap

import numpy as np

from window_tables import Unsuitable, axis_label, read_results, remarks, value_label

GRIP = "strategy.grip_force_N"
SPEED = "strategy.approach_speed_m_s"
MAX_PANELS = 8
INK = "#20242a"
SOFT_INK = "#6a717b"
DASHES = (0, (3.2, 1.1))


# --- axes and legends ---

def is_log(values):
    values = np.asarray(values, float)
    if len(values) < 3 or values[0] <= 0:
        return False
    ratios, steps = np.diff(np.log(values)), np.diff(values)
    return np.ptp(ratios) < 0.02 * ratios.mean() and np.ptp(steps) > 0.05 * steps.mean()


def edges(values, log):
    """Cell borders half way between the values (in the logarithm where the axis has one)."""
    points = np.log(values) if log else np.asarray(values, float)
    if len(points) == 1:
        half = 0.05 * abs(points[0]) or 0.5
        borders = np.array([points[0] - half, points[0] + half])
    else:
        middle = (points[1:] + points[:-1]) / 2
        borders = np.concatenate([[2 * points[0] - middle[0]], middle, [2 * points[-1] - middle[-1]]])
    return np.exp(borders) if log else borders


def set_up_matplotlib():
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    plt.rcParams.update({
        "font.family": ["DejaVu Sans"], "font.size": 10.5, "axes.edgecolor": "#b9bec6", "axes.labelcolor": INK,
        "axes.titlesize": 10.5, "text.color": INK, "xtick.color": SOFT_INK, "ytick.color": SOFT_INK,
        "axes.linewidth": 0.8, "xtick.major.width": 0.8, "ytick.major.width": 0.8, "figure.dpi": 160,
        "axes.spines.top": False, "axes.spines.right": False, "legend.frameon": False})
    return plt


def plain_ticks(axis, values, log):
    """Ticks at round numbers, written as numbers also on a logarithmic axis."""
    from matplotlib.ticker import FixedLocator, FuncFormatter, MaxNLocator, NullLocator
    if log:
        decades = range(math.floor(math.log10(min(values))) - 1, math.ceil(math.log10(max(values))) + 1)
        steps = (1, 2, 5) if max(values) / min(values) > 4 else (1, 1.5, 2, 3, 4, 5, 6, 7, 8)
        axis.set_major_locator(FixedLocator([s * 10.0**d for d in decades for s in steps]))
        axis.set_minor_locator(NullLocator())
    else:
        axis.set_major_locator(MaxNLocator(6, min_n_ticks=3, steps=[1, 2, 2.5, 5, 10]))
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))


def place_legend(figure, handles):
    """One line where it fits, else as few even lines as the width allows."""
    for lines in range(1, len(handles) + 1):
        legend = figure.legend(handles=handles, loc="lower left", ncol=math.ceil(len(handles) / lines), handlelength=1.4,
                               columnspacing=1.2, fontsize=9.5, bbox_to_anchor=(0.008, 0.06 / figure.get_figheight()))
        if legend.get_window_extent(figure.canvas.get_renderer()).x1 <= 0.995 * figure.bbox.width:
            return
        legend.remove()


def window_handles(data):
    from matplotlib.lines import Line2D
    handles = [Line2D([], [], color=INK, lw=2, label="$F_{hold}$")]
    if data["judged"]:
        handles.append(Line2D([], [], color=INK, lw=2, ls=DASHES, label="$F_{damage}$"))
    if data["window"].get("set_point_exists", np.zeros(1)).any():
        handles.append(Line2D([], [], color=INK, marker="D", ms=6, mec="white", lw=0, label="set here"))
    return handles


# --- panels ---

def choose_axis(columns):
    """The key along the free axis, and those that make panels."""
    numeric = [key for key, column in columns.items() if not isinstance(column["values"], list) and key != GRIP]
    chosen = SPEED if SPEED in numeric else (numeric[0] if numeric else None)
    return chosen, [key for key in columns if key not in (GRIP, chosen)]


def panel_values(columns, keys):
    """The combinations of the panel keys that occur, thinned evenly to MAX_PANELS."""
    combinations = list(dict.fromkeys(zip(*(list(columns[key]["values"]) for key in keys)))) if keys else [()]
    if len(combinations) <= MAX_PANELS:
        return combinations, []
    chosen = np.unique(np.linspace(0, len(combinations) - 1, MAX_PANELS).round().astype(int))
    return [combinations[i] for i in chosen], [f"{len(chosen)} of {len(combinations)} combinations are shown."]


def rows_where(columns, keys, combination, count):
    mask = np.ones(count, bool)
    for key, wanted in zip(keys, combination):
        mask &= np.array([value == wanted for value in columns[key]["values"]], bool)
    return mask


def draw_cells(axes, data, mask, y_key, x_values, y_values, scales):
    from matplotlib.colors import ListedColormap
    not_run = min(data["words"])
    grid = np.full((len(y_values), len(x_values)), not_run)
    forces = data["inputs"][GRIP]["values"]
    heights = data["inputs"][y_key]["values"] if y_key else np.zeros(len(forces))
    grid[np.searchsorted(y_values, heights[mask]), np.searchsorted(x_values, forces[mask])] = data["outcome"][mask]
    axes.pcolormesh(edges(x_values, scales[0]), edges(y_values, scales[1]), grid, cmap=ListedColormap(list(data["colours"].values())),
                    vmin=not_run - 0.5, vmax=max(data["words"]) + 0.5, edgecolors="white", linewidth=0.35 if grid.size < 4000 else 0.0)


def draw_edge(axes, window, rows, name, borders, style):
    """A line at the end itself, and a pale band over the bracket in which it is known to lie."""
    import matplotlib.patheffects as effects
    y = np.repeat(borders, 2)[1:-1]
    low, high, end = (np.repeat(window[f"{name}_{column}_N"][rows], 2) for column in ("bracket_low", "bracket_high", "force"))
    axes.fill_betweenx(y, low, high, where=np.isfinite(low + high), facecolor="white", alpha=0.3, lw=0)
    axes.plot(end, y, color=INK, lw=2.0, ls=style, solid_capstyle="butt",
              path_effects=[effects.Stroke(linewidth=3.6, foreground="white"), effects.Normal()])


def draw_window_on_map(axes, data, panel_keys, combination, y_key, y_values, log):
    window = data["window"]
    columns, count = window["inputs"], len(window["exists"])
    if not set(columns) >= {key for key in [*panel_keys, y_key] if key}:
        return
    rows = np.flatnonzero(rows_where(columns, panel_keys, combination, count))
    if y_key:
        rows = np.array([next((r for r in rows if columns[y_key]["values"][r] == y), -1) for y in y_values])
    if len(rows) != len(y_values) or (rows < 0).any():
        return
    borders = edges(y_values, log)
    draw_edge(axes, window, rows, "hold", borders, "-")
    if data["judged"]:
        draw_edge(axes, window, rows, "damage", borders, DASHES)
    if "set_point_N" in window:
        axes.plot(window["set_point_N"][rows], y_values, "D", color=INK, ms=6, mec="white", mew=1.2)


def draw_map_panel(axes, data, panel_keys, combination, y_key):
    x_values = np.unique(data["inputs"][GRIP]["values"])
    y_values = np.unique(data["inputs"][y_key]["values"]) if y_key else np.zeros(1)
    scales = is_log(x_values), bool(y_key) and is_log(y_values)
    mask = rows_where(data["inputs"], panel_keys, combination, len(data["outcome"]))
    draw_cells(axes, data, mask, y_key, x_values, y_values, scales)
    draw_window_on_map(axes, data, panel_keys, combination, y_key, y_values, scales[1])
    for axis, values, log, set_scale, set_limits in ((axes.xaxis, x_values, scales[0], axes.set_xscale, axes.set_xlim),
                                                     (axes.yaxis, y_values, scales[1], axes.set_yscale, axes.set_ylim)):
        if log:
            set_scale("log")
        set_limits(*edges(values, log)[[0, -1]])
        plain_ticks(axis, values, log)
    if not y_key:
        axes.set_yticks([])
    axes.set_xlabel(axis_label(data["inputs"][GRIP]))
    axes.set_ylabel(axis_label(data["inputs"][y_key]) if y_key else "")


def draw_bar(axes, data, row, at, half, ceiling):
    window = data["window"]
    low, high = window["hold_force_N"][row], window["damage_force_N"][row]
    span = [at - half[0], at + half[1]]
    if not window["exists"][row]:
        axes.text(at, ceiling, "no\nwindow", ha="center", va="top", fontsize=8, color=SOFT_INK)
    else:
        axes.fill_between(span, low if np.isfinite(low) else 0.0, high if np.isfinite(high) else ceiling,
                          color=colour_of(data, "held"), lw=0, alpha=0.9)
    for force, style in ((low, "-"), (high if data["judged"] else np.nan, DASHES)):
        if np.isfinite(force):
            axes.plot(span, [force, force], color=INK, lw=2, ls=style)
    if "set_point_exists" in window and window["set_point_exists"][row]:
        axes.plot([at], [window["set_point_N"][row]], "D", color=INK, ms=6, mec="white", mew=1.2)


def draw_window_panel(axes, data, panel_keys, combination, x_key):
    window = data["window"]
    rows = np.flatnonzero(rows_where(window["inputs"], panel_keys, combination, len(window["exists"])))
    values = window["inputs"][x_key]["values"][rows] if x_key else np.zeros(len(rows))
    order = np.argsort(values, kind="stable")
    rows, values = rows[order], values[order]
    log = bool(x_key) and is_log(values)
    borders = edges(values, log)
    forces = np.concatenate([window["hold_force_N"], window["damage_force_N"]])
    ceiling = 1.12 * np.nanmax(forces) if np.isfinite(forces).any() else 1.0
    for row, at, low, high in zip(rows, values, borders[:-1], borders[1:]):
        draw_bar(axes, data, row, at, (0.72 * (at - low), 0.72 * (high - at)), ceiling)
    if log:
        axes.set_xscale("log")
    axes.set_xlim(*(borders[[0, -1]] if x_key else (-2, 2)))
    axes.set_ylim(0.0, ceiling)
    if x_key:
        plain_ticks(axes.xaxis, values, log)
        axes.set_xlabel(axis_label(window["inputs"][x_key]))
    else:
        axes.set_xticks([])
    axes.set_ylabel("grip force  (N)")
    axes.grid(axis="y", color="#e6e8eb", lw=0.7)
    axes.set_axisbelow(True)


# --- the picture ---

def colour_of(data, word):
    return next(colour for code, colour in data["colours"].items() if data["words"][code] == word)


def sentence(text):
    return text[:1].upper() + text[1:]


def headline(figure, data, more):
    """Title, answer below it, remarks; returns the height of the block in inches."""
    height = figure.get_figheight()
    figure.text(0.015, 1 - 0.14 / height, data["name"].replace("_", " "), fontsize=16, fontweight="bold", va="top")
    lines = textwrap.wrap(sentence(data["answer"]), int(11.5 * figure.get_figwidth()))
    answer_lines = len(lines)
    lines += remarks(data) + more
    for k, line in enumerate(lines):
        figure.text(0.015, 1 - (0.50 + 0.23 * k) / height, line, fontsize=11 if k < answer_lines else 9.5, va="top",
                    color=INK if k < answer_lines else SOFT_INK)
    return 0.52 + 0.23 * len(lines)


def outcome_handles(data):
    from matplotlib.patches import Patch
    counts = {code: int((data["outcome"] == code).sum()) for code in data["words"]}
    return [Patch(facecolor=data["colours"][code], edgecolor="#9aa0a8" if data["words"][code] == "not_run" else "none",
                  label=f"{data['words'][code].replace('_', ' ')}  {counts[code]}")
            for code in sorted(counts, key=lambda code: (code < 0, code)) if counts[code]]


def draw(data, plt):
    is_map = data["kind"] == "sweep" and GRIP in data["inputs"]
    columns = data["inputs"] if is_map else data["window"]["inputs"]
    free_key, panel_keys = choose_axis(columns)
    panels, more = panel_values(columns, panel_keys)
    across = len(panels) if len(panels) <= 4 else math.ceil(len(panels) / 2)
    lines = math.ceil(len(panels) / across)
    tall = 1.6 if is_map and not free_key else (4.9 if lines == 1 else 3.0)
    title = 0.17 * max(0, len(panel_keys) - 1) if across > 1 else 0.0
    figure, all_axes = plt.subplots(lines, across, figsize=(10.0 if across < 4 else 12.0, lines * (tall + title) + 2.2),
                                    sharex=True, sharey=True, squeeze=False)
    for axes, combination in itertools.zip_longest(all_axes.flat, panels):
        if combination is None:
            axes.set_visible(False)
            continue
        (draw_map_panel if is_map else draw_window_panel)(axes, data, panel_keys, combination, free_key)
        axes.set_title(("\n" if across > 1 else ",  ").join(value_label(columns[key], value)
                                                             for key, value in zip(panel_keys, combination)), loc="left")
        axes.label_outer()
    top, height = headline(figure, data, more), figure.get_figheight()
    figure.tight_layout(rect=(0.005, 0.46 / height, 0.995, 1 - top / height), h_pad=1.2, w_pad=1.2)
    from matplotlib.patches import Patch
    first = outcome_handles(data) if is_map else [Patch(color=colour_of(data, "held"), label="window")]
    place_legend(figure, first + window_handles(data))
    return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("results", metavar="RESULTS.h5")
    parser.add_argument("-o", "--output", metavar="FILE.png", help="default: the name of the results with .png")
    arguments = parser.parse_args()
    output = arguments.output or os.path.splitext(arguments.results)[0] + ".png"
    try:
        figure = draw(read_results(arguments.results), set_up_matplotlib())
        figure.savefig(output, dpi=160)
    except (Unsuitable, OSError) as error:
        print(f"plot_window.py: {error}", file=sys.stderr)
        return 2
    print(output)
    return 0


if __name__ == "__main__":
    sys.exit(main())
