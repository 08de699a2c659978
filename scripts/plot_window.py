#!/usr/bin/python3
"""Draws what a study found: the map of outcomes of a sweep, the windows of a window study, or a trace.

    plot_window.py RESULTS.h5 [-o FILE.png]

A sweep over strategy.grip_force_N becomes a map: grip force across, approach speed (or the first other varied
key) upwards, one panel per combination of the remaining keys. The edges of the window come from /window, the
thin line is the closed-form hold force m (g + a) / (2 mu). A window study becomes one bar from F_hold to F_damage
per value of its varied key. A file with a trace and no varied grip force becomes curves over time.
Exit status: 0 drawn, 2 the file does not hold what is needed.
"""
import argparse
import itertools
import math
import os
import sys
import tomllib

import h5py
import numpy as np

GRIP = "strategy.grip_force_N"
SPEED = "strategy.approach_speed_m_s"
MAX_PANELS = 8
OUTCOMES = ["held", "slipped", "dropped", "damaged", "not_grasped", "diverged", "out_of_range"]
# After Okabe and Ito: tells the outcomes apart for the common kinds of colour blindness and in grey.
COLOURS = {"held": "#1b9e77", "slipped": "#9fd0ee", "dropped": "#4a7fb0", "damaged": "#e0702d",
           "not_grasped": "#c9ccd1", "diverged": "#222222", "out_of_range": "#c583b0", "not_run": "#ffffff"}
INK = "#20242a"
SOFT_INK = "#6a717b"


class Unsuitable(Exception):
    """The file cannot be drawn; the message is one line for the user."""


# --- reading --------------------------------------------------------------------------------------------------

def text_list(dataset):
    return [value.decode() if isinstance(value, bytes) else str(value) for value in dataset[...]]


def read_inputs(group):
    """The varied keys of a group in the study's order: key -> {values, units}."""
    columns = {}
    chosen = [(int(item.attrs["position"]), key, item) for key, item in group.items() if "position" in item.attrs]
    for _, key, item in sorted(chosen, key=lambda entry: entry[0]):
        values = text_list(item) if item.dtype.kind == "O" else item[...].astype(float)
        columns[key] = {"values": values, "units": item.attrs.get("units", "")}
    return columns


def read_results(path):
    """Everything the drawings need, as plain arrays."""
    if not os.path.exists(path):
        raise Unsuitable(f"{path}: no such file")
    try:
        file = h5py.File(path, "r")
    except OSError as error:
        raise Unsuitable(f"{path}: not a readable HDF5 file ({str(error).splitlines()[0]})") from error
    with file:
        if "format_version" not in file.attrs or "scenarios" not in file:
            raise Unsuitable(f"{path}: not a results file of unbruised")
        try:
            return read_tables(file)
        except (KeyError, OSError, ValueError) as error:
            raise Unsuitable(f"{path}: damaged or unfinished ({error})") from error


def read_tables(file):
    data = {"name": file.attrs["study_name"], "kind": file.attrs["study_kind"],
            "complete": int(file.attrs["complete"]) == 1, "config": parse_config(file.attrs["config"]),
            "inputs": read_inputs(file["scenarios/input"]), "outcome": file["scenarios/outcome"][...].astype(int),
            "window": None, "trace": None}
    if "window" in file:
        group = file["window"]
        data["window"] = {key: group[key][...] for key in group if group[key].dtype.kind in "fiu"}
        data["window"]["note"] = text_list(group["note"])
        data["window"]["inputs"] = read_inputs(group)
    if "trace" in file:
        data["trace"] = {key: (item[...], item.attrs.get("units", ""), item.attrs.get("long_name", ""))
                         for key, item in file["trace"].items() if item.ndim <= 3}
    return data


def parse_config(text):
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError:
        return {}


# --- the closed form ------------------------------------------------------------------------------------------

def lookup(config, overrides, key, default=None):
    if key in overrides:
        return overrides[key]
    value = config
    for part in key.split("."):
        if not isinstance(value, dict) or part not in value:
            return default
        value = value[part]
    return value


def product_mass_kg(config, overrides):
    mass = lookup(config, overrides, "product.mass_kg")
    if mass is not None:
        return mass
    density = lookup(config, overrides, "product.density_kg_m3")
    size = lookup(config, overrides, "product.size_m")
    fill = {"box": 1.0, "cylinder": math.pi / 4, "sphere": math.pi / 6, "ellipsoid": math.pi / 6}
    shape = lookup(config, overrides, "product.shape", "box")
    if density is None or not isinstance(size, list) or shape not in fill:
        return None
    return density * fill[shape] * math.prod(size)


def closed_form_hold_N(config, overrides):
    """m (g + a) / (2 mu), or None where the config does not say what is needed."""
    mass = product_mass_kg(config, overrides)
    friction = lookup(config, overrides, "product.friction")
    acceleration = lookup(config, overrides, "strategy.lift_acceleration_m_s2")
    gravity = lookup(config, overrides, "cell.gravity_m_s2", [0.0, 0.0, -9.80665])
    if None in (mass, friction, acceleration) or not friction:
        return None
    return mass * (math.hypot(*gravity) + acceleration) / (2.0 * friction)


# --- words ----------------------------------------------------------------------------------------------------

def pretty_units(units):
    return {"m s-1": "m/s", "m s-2": "m/s²", "m3": "m³", "kg m-3": "kg/m³", "1": "", "N s m-1": "N s/m"}.get(
        units, units)


def words_of(key):
    """"strategy.lift_acceleration_m_s2" -> "lift acceleration"."""
    last = key.rsplit(".", 1)[-1]
    for suffix in ("_m_s2", "_m_s", "_kg_m3", "_N_s_m", "_N_m", "_m3", "_kg", "_Pa", "_Hz", "_rad", "_N", "_J", "_s",
                   "_m"):
        if last.endswith(suffix):
            last = last[: -len(suffix)]
            break
    return last.replace("_", " ")


def axis_label(key, units):
    unit = pretty_units(units)
    return words_of(key) + (f"  ({unit})" if unit else "")


def value_label(key, value, units):
    if isinstance(value, str):
        return os.path.splitext(os.path.basename(value))[0].replace("_", " ")
    return f"{words_of(key)} {value:.4g} {pretty_units(units)}".rstrip()


def answer(window):
    """The study's answer in one sentence."""
    if window is None or len(window["exists"]) == 0:
        return ""
    exists = window["exists"].astype(bool)
    total = len(exists)
    if not exists.any():
        return "No window: no grip force holds the product unharmed" + (" at any combination" if total > 1 else "")
    margin = np.where(exists, window["margin"], np.nan)
    if np.isnan(margin).all():
        return f"There is a window at {int(exists.sum())} of {total} combinations; its ends lie outside the range"
    best = int(np.nanargmax(margin))
    where = ", ".join(value_label(key, column["values"][best], column["units"])
                      for key, column in window["inputs"].items())
    words = (f"{window['hold_force_N'][best]:.3g} – {window['damage_force_N'][best]:.3g} N, "
             f"margin {100 * margin[best]:.0f} %")
    if total == 1:
        return f"Window: {words}"
    found = f"Window at {int(exists.sum())} of {total} combinations"
    return f"{found}; widest {words}" + (f", at {where}" if where else "")


# --- drawing --------------------------------------------------------------------------------------------------

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
        "axes.spines.top": False, "axes.spines.right": False, "legend.frameon": False, "hatch.linewidth": 0.6})
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


def headline(figure, data, extra=""):
    """Title, answer below it, remark; returns the height of the block in inches."""
    height = figure.get_figheight()
    figure.text(0.015, 1 - 0.14 / height, data["name"].replace("_", " "), fontsize=16, fontweight="bold", va="top")
    lead = answer(data["window"])
    lines = [line for line in (lead, extra) if line]
    if not data["complete"]:
        lines.append("The study is not complete: some scenarios have not been run.")
    for k, line in enumerate(lines):
        figure.text(0.015, 1 - (0.50 + 0.23 * k) / height, line, fontsize=11 if line == lead else 9.5, va="top",
                    color=INK if line == lead else SOFT_INK)
    return 0.52 + 0.23 * len(lines)


def choose_axes(data):
    keys = list(data["inputs"])
    numeric = [key for key in keys if not isinstance(data["inputs"][key]["values"], list)]
    if GRIP not in numeric:
        return None
    others = [key for key in numeric if key != GRIP]
    y_key = SPEED if SPEED in others else (others[0] if others else None)
    return y_key, [key for key in keys if key not in (GRIP, y_key)]


def panel_values(data, keys):
    """The combinations of the panel keys that occur, thinned evenly to MAX_PANELS."""
    combinations = list(dict.fromkeys(zip(*(list(data["inputs"][key]["values"]) for key in keys)))) if keys else [()]
    if len(combinations) <= MAX_PANELS:
        return combinations, ""
    chosen = np.unique(np.linspace(0, len(combinations) - 1, MAX_PANELS).round().astype(int))
    return [combinations[i] for i in chosen], f"{len(chosen)} of {len(combinations)} combinations are shown."


def rows_where(columns, keys, combination, count):
    mask = np.ones(count, bool)
    for key, wanted in zip(keys, combination):
        mask &= np.array([value == wanted for value in columns[key]["values"]], bool)
    return mask


def draw_cells(axes, data, mask, y_key, x_values, y_values, scales):
    from matplotlib.colors import ListedColormap
    grid = np.full((len(y_values), len(x_values)), -1)
    forces = data["inputs"][GRIP]["values"]
    heights = data["inputs"][y_key]["values"] if y_key else np.zeros(len(forces))
    columns, lines = np.searchsorted(x_values, forces[mask]), np.searchsorted(y_values, heights[mask])
    grid[lines, columns] = data["outcome"][mask]
    colours = [COLOURS["not_run"]] + [COLOURS[word] for word in OUTCOMES]
    axes.pcolormesh(edges(x_values, scales[0]), edges(y_values, scales[1]), grid, cmap=ListedColormap(colours),
                    vmin=-1.5, vmax=6.5, edgecolors="white", linewidth=0.35 if grid.size < 4000 else 0.0)


def steps_of(values, borders):
    """A line that keeps its value over each cell."""
    return np.repeat(values, 2), np.repeat(borders, 2)[1:-1]


def draw_edge(axes, window, rows, name, borders, log, style):
    """The edge lies somewhere in its bracket: a pale band, and a line through the band's middle."""
    import matplotlib.patheffects as effects
    low, high = window[f"{name}_bracket_low_N"][rows], window[f"{name}_bracket_high_N"][rows]
    x_low, y = steps_of(low, borders)
    x_high, _ = steps_of(high, borders)
    axes.fill_betweenx(y, x_low, x_high, where=np.isfinite(x_low + x_high), facecolor="white", alpha=0.22, lw=0)
    middle = np.sqrt(low * high) if log else (low + high) / 2
    x, y = steps_of(np.where(np.isfinite(middle), middle, window[f"{name}_force_N"][rows]), borders)
    axes.plot(x, y, color=INK, lw=2.0, ls=style, solid_capstyle="butt",
              path_effects=[effects.Stroke(linewidth=3.6, foreground="white"), effects.Normal()])


def draw_window(axes, data, panel_keys, combination, y_key, y_values, scales):
    window = data["window"]
    if window is None:
        return
    columns, count = window["inputs"], len(window["exists"])
    if any(key not in columns for key in panel_keys) or (y_key and y_key not in columns):
        return
    rows = np.flatnonzero(rows_where(columns, panel_keys, combination, count))
    if y_key:
        heights = columns[y_key]["values"]
        rows = np.array([next((r for r in rows if heights[r] == y), -1) for y in y_values])
    if len(rows) != len(y_values) or (rows < 0).any():
        return
    borders = edges(y_values, scales[1])
    draw_edge(axes, window, rows, "hold", borders, scales[0], "-")
    draw_edge(axes, window, rows, "damage", borders, scales[0], (0, (3.2, 1.1)))


def draw_closed_form(axes, data, panel_keys, combination, y_key, y_values, x_values, scales):
    overrides = dict(zip(panel_keys, combination))
    forces = [closed_form_hold_N(data["config"], overrides | ({y_key: float(y)} if y_key else {})) for y in y_values]
    if any(force is None for force in forces):
        return False
    x, y = steps_of(np.array(forces), edges(y_values, scales[1]))
    borders = edges(x_values, scales[0])
    if np.min(x) > borders[-1] or np.max(x) < borders[0]:
        return False
    axes.plot(x, y, color="#000000", lw=1.0, ls=(0, (1, 1.6)))
    return True


def map_legend(figure, data, bottom_in, with_window, with_closed_form):
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch
    counts = {word: int((data["outcome"] == code).sum()) for code, word in enumerate(OUTCOMES)}
    counts["not_run"] = int((data["outcome"] == -1).sum())
    handles = [Patch(facecolor=COLOURS[word], edgecolor="#9aa0a8" if word == "not_run" else "none",
                     label=f"{word.replace('_', ' ')}  {count}") for word, count in counts.items() if count]
    if with_window:
        handles += [Line2D([], [], color=INK, lw=2, label="$F_{hold}$"),
                    Line2D([], [], color=INK, lw=2, ls=(0, (3.2, 1.1)), label="$F_{damage}$")]
    if with_closed_form:
        handles.append(Line2D([], [], color="black", lw=1, ls=(0, (1, 1.6)), label="$m(g+a)/2\\mu$"))
    place_legend(figure, handles, bottom_in)


def place_legend(figure, handles, bottom_in):
    """One line where it fits, in a smaller letter if need be, else as few even lines as the width allows."""
    count = len(handles)
    for lines, size in [(1, 10), (1, 9.2)] + [(lines, 10) for lines in range(2, count + 1)]:
        legend = figure.legend(handles=handles, loc="lower left", ncol=math.ceil(count / lines), handlelength=1.4,
                               columnspacing=0.12 * size, fontsize=size,
                               bbox_to_anchor=(0.008, bottom_in / figure.get_figheight()))
        if legend.get_window_extent(figure.canvas.get_renderer()).x1 <= 0.995 * figure.bbox.width:
            return
        legend.remove()


def panel_grid(count):
    columns = count if count <= 4 else math.ceil(count / 2)
    return math.ceil(count / columns), columns


def draw_map(data, plt):
    y_key, panel_keys = choose_axes(data)
    panels, remark = panel_values(data, panel_keys)
    x_values = np.unique(data["inputs"][GRIP]["values"])
    y_values = np.unique(data["inputs"][y_key]["values"]) if y_key else np.zeros(1)
    scales = is_log(x_values), bool(y_key) and is_log(y_values)
    lines, columns = panel_grid(len(panels))
    panel_height = (4.9 if lines == 1 else 3.0) if y_key else 1.6
    figure, all_axes = plt.subplots(lines, columns, figsize=(10.0 if columns < 4 else 12.0, lines * panel_height + 2.0),
                                    sharex=True, sharey=True, squeeze=False)
    closed_form = False
    for axes, combination in itertools.zip_longest(all_axes.flat, panels):
        if combination is None:
            axes.set_visible(False)
            continue
        mask = rows_where(data["inputs"], panel_keys, combination, len(data["outcome"]))
        draw_cells(axes, data, mask, y_key, x_values, y_values, scales)
        draw_window(axes, data, panel_keys, combination, y_key, y_values, scales)
        closed_form |= draw_closed_form(axes, data, panel_keys, combination, y_key, y_values, x_values, scales)
        axes.set_title(",  ".join(value_label(key, value, data["inputs"][key]["units"])
                                  for key, value in zip(panel_keys, combination)), loc="left")
        finish_map_axes(axes, x_values, y_values, scales, y_key)
    label_map(figure, all_axes, data, y_key)
    top = headline(figure, data, remark)
    height = figure.get_figheight()
    figure.tight_layout(rect=(0.005, 0.46 / height, 0.995, 1 - top / height), h_pad=1.2, w_pad=1.2)
    map_legend(figure, data, 0.06, data["window"] is not None, closed_form)
    return figure


def finish_map_axes(axes, x_values, y_values, scales, y_key):
    if scales[0]:
        axes.set_xscale("log")
    if scales[1]:
        axes.set_yscale("log")
    axes.set_xlim(*edges(x_values, scales[0])[[0, -1]])
    axes.set_ylim(*edges(y_values, scales[1])[[0, -1]])
    plain_ticks(axes.xaxis, x_values, scales[0])
    if y_key:
        plain_ticks(axes.yaxis, y_values, scales[1])
    else:
        axes.set_yticks([])
    axes.tick_params(length=3)


def label_map(figure, all_axes, data, y_key):
    for column in all_axes.T:
        visible = [axes for axes in column if axes.get_visible()]
        visible[-1].set_xlabel(axis_label(GRIP, data["inputs"][GRIP]["units"] or "N"))
        visible[-1].tick_params(labelbottom=True)
    if y_key:
        for axes in all_axes[:, 0]:
            axes.set_ylabel(axis_label(y_key, data["inputs"][y_key]["units"]))


def window_axes(window):
    numeric = [key for key, column in window["inputs"].items() if not isinstance(column["values"], list)]
    x_key = numeric[0] if numeric else None
    return x_key, [key for key in window["inputs"] if key != x_key]


def draw_bars(axes, window, rows, positions, width, floor, ceiling):
    for row, at, half in zip(rows, positions, width):
        low, high = window["hold_force_N"][row], window["damage_force_N"][row]
        if window["exists"][row]:
            bottom = low if np.isfinite(low) else floor
            top = high if np.isfinite(high) else ceiling
            axes.fill_between([at - half[0], at + half[1]], bottom, top, color=COLOURS["held"], lw=0, alpha=0.9)
        for force, colour in ((low, COLOURS["dropped"]), (high, COLOURS["damaged"])):
            if np.isfinite(force):
                axes.plot([at - half[0], at + half[1]], [force, force], color=colour, lw=2.6, solid_capstyle="butt")
        if not window["exists"][row]:
            axes.text(at, ceiling, "no\nwindow", ha="center", va="top", fontsize=8, color=SOFT_INK)


def bar_places(values, log):
    """Positions on the axis and how far a bar reaches to either side."""
    borders = edges(values, log)
    return values, [(0.72 * (at - low), 0.72 * (high - at)) for at, low, high in
                    zip(values, borders[:-1], borders[1:])]


def draw_windows(data, plt):
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch
    window = data["window"]
    x_key, panel_keys = window_axes(window)
    panels, remark = panel_values({"inputs": window["inputs"]}, panel_keys)
    forces = np.concatenate([window["hold_force_N"], window["damage_force_N"]])
    forces = forces[np.isfinite(forces)]
    search = data["config"].get("window", {})
    floor, ceiling = (0.0, 1.12 * forces.max()) if len(forces) else (search.get("from_N", 0.0), search.get("to_N", 1.0))
    lines, columns = panel_grid(len(panels))
    figure, all_axes = plt.subplots(lines, columns, figsize=(10.0 if columns < 4 else 12.0,
                                                             lines * (4.6 if lines == 1 else 3.0) + 2.0),
                                    sharex=True, sharey=True, squeeze=False)
    closed_form = False
    for axes, combination in itertools.zip_longest(all_axes.flat, panels):
        if combination is None:
            axes.set_visible(False)
            continue
        rows = np.flatnonzero(rows_where(window["inputs"], panel_keys, combination, len(window["exists"])))
        closed_form |= draw_window_panel(axes, data, rows, x_key, dict(zip(panel_keys, combination)), floor, ceiling)
        axes.set_title(",  ".join(value_label(key, value, window["inputs"][key]["units"])
                                  for key, value in zip(panel_keys, combination)), loc="left")
        axes.set_ylim(floor, ceiling)
    for axes in all_axes[:, 0]:
        axes.set_ylabel("grip force  (N)")
    top = headline(figure, data, remark)
    height = figure.get_figheight()
    figure.tight_layout(rect=(0.005, 0.46 / height, 0.995, 1 - top / height), h_pad=1.2, w_pad=1.2)
    handles = [Patch(color=COLOURS["held"], label="window"),
               Line2D([], [], color=COLOURS["damaged"], lw=2.6, label="$F_{damage}$"),
               Line2D([], [], color=COLOURS["dropped"], lw=2.6, label="$F_{hold}$")]
    if closed_form:
        handles.append(Line2D([], [], color="black", lw=1, ls=(0, (1, 1.6)), label="$m(g+a)/2\\mu$"))
    place_legend(figure, handles, 0.06)
    return figure


def draw_window_panel(axes, data, rows, x_key, overrides, floor, ceiling):
    window = data["window"]
    values = window["inputs"][x_key]["values"][rows] if x_key else np.zeros(len(rows))
    order = np.argsort(values, kind="stable")
    rows, values = rows[order], values[order]
    log = bool(x_key) and is_log(values)
    positions, width = bar_places(values, log)
    draw_bars(axes, window, rows, positions, width, floor, ceiling)
    if x_key:
        if log:
            axes.set_xscale("log")
        axes.set_xlim(*edges(values, log)[[0, -1]])
        plain_ticks(axes.xaxis, values, log)
        axes.set_xlabel(axis_label(x_key, window["inputs"][x_key]["units"]))
    else:
        axes.set_xticks([])
        axes.set_xlim(-2, 2)
    axes.grid(axis="y", color="#e6e8eb", lw=0.7)
    axes.set_axisbelow(True)
    holds = [closed_form_hold_N(data["config"], overrides | ({x_key: float(v)} if x_key else {})) for v in values]
    if not holds or any(force is None for force in holds):
        return False
    if len(set(holds)) == 1:
        axes.axhline(holds[0], color="black", lw=1, ls=(0, (1, 1.6)))
    else:
        axes.plot(values, holds, color="black", lw=1, ls=(0, (1, 1.6)))
    return True


def draw_trace(data, plt):
    trace = data["trace"]
    time = trace["time_s"][0]
    curves = []
    for name, (values, units, long_name) in trace.items():
        if name == "finger_force_N" and values.ndim == 3:
            curves.append(("force on the product  (N)", [(f"finger {k + 1}, normal", np.abs(values[:, k, 0]))
                                                         for k in range(values.shape[1])]))
        elif values.ndim == 1 and len(values) == len(time) and name != "time_s" and not name.endswith("count"):
            curves.append((axis_label(name, units), [(words_of(name), values)]))
    if not curves:
        raise Unsuitable("the trace holds no signal to draw")
    curves = curves[:6]
    figure, all_axes = plt.subplots(len(curves), 1, figsize=(10, 1.7 * len(curves) + 1.4), sharex=True, squeeze=False)
    for axes, (label, lines) in zip(all_axes[:, 0], curves):
        for (name, values), colour in zip(lines, (COLOURS["dropped"], COLOURS["damaged"], COLOURS["held"])):
            axes.plot(time, values, color=colour, lw=1.5, label=name)
        axes.set_ylabel(label, fontsize=9.5)
        axes.grid(color="#eceef0", lw=0.7)
        if len(lines) > 1:
            axes.legend(loc="best", fontsize=9)
    all_axes[-1, 0].set_xlabel("time  (s)")
    all_axes[-1, 0].set_xlim(time[0], time[-1])
    top = headline(figure, data, "")
    figure.align_ylabels()
    figure.tight_layout(rect=(0.005, 0, 0.995, 1 - top / figure.get_figheight()))
    return figure


def draw(data, plt):
    if data["kind"] == "window" and data["window"] is not None and len(data["window"]["exists"]):
        return draw_windows(data, plt)
    if choose_axes(data) is not None and len(data["outcome"]):
        return draw_map(data, plt)
    if data["trace"] is not None:
        return draw_trace(data, plt)
    raise Unsuitable(f"nothing to draw: {GRIP} is not varied, and there is neither a window table nor a trace")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("results", metavar="RESULTS.h5")
    parser.add_argument("-o", "--output", metavar="FILE.png", help="default: the name of the results with .png")
    arguments = parser.parse_args()
    output = arguments.output or os.path.splitext(arguments.results)[0] + ".png"
    try:
        data = read_results(arguments.results)
        figure = draw(data, set_up_matplotlib())
        figure.savefig(output, dpi=160)
    except (Unsuitable, OSError) as error:
        print(f"plot_window.py: {error}", file=sys.stderr)
        return 2
    print(output)
    return 0


if __name__ == "__main__":
    sys.exit(main())
