"""The grip windows of a results file as plain arrays, and what they say in words: what plot_window.py draws."""
import os

import h5py
import numpy as np

UNITS = {"m s-1": "m/s", "m s-2": "m/s²", "m3": "m³", "kg m-3": "kg/m³", "1": "", "N s m-1": "N s/m", "N m-1": "N/m"}
SUFFIXES = ("_m_s2", "_m_s", "_kg_m3", "_N_s_m", "_N_m", "_m3", "_kg", "_Pa", "_Hz", "_rad", "_N", "_J", "_s", "_m")


class Unsuitable(Exception):
    """The file cannot be drawn; the message is one line for the user."""


# --- reading ---

def text_list(dataset):
    return [value.decode() if isinstance(value, bytes) else str(value) for value in dataset[...]]


def read_inputs(group):
    """The columns of varied keys in the study's order: key -> {values, units}."""
    chosen = [(int(item.attrs["position"]), key, item) for key, item in group.items()
              if "position" in item.attrs and "." in key]
    return {key: {"values": text_list(item) if item.dtype.kind == "O" else item[...].astype(float),
                  "units": item.attrs.get("units", "")} for _, key, item in sorted(chosen, key=lambda entry: entry[:2])}


def read_numbers(group):
    return {key: item[...] for key, item in group.items() if item.dtype.kind in "fiu"}


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
        kind = file.attrs["study_kind"]
        if kind not in ("sweep", "window") or "window" not in file or not len(file["window/exists"]):
            raise Unsuitable(f"nothing to draw: a study of kind \"{kind}\" without windows over the grip force; "
                             "its report.html shows what it found")
        try:
            return read_tables(file)
        except (KeyError, OSError, ValueError) as error:
            raise Unsuitable(f"{path}: damaged or unfinished ({error})") from error


def read_tables(file):
    window = read_numbers(file["window"]) | {"inputs": read_inputs(file["window"])}
    settings = None
    if "set_points" in file:
        settings = read_numbers(file["set_points"]) | {"inputs": read_inputs(file["set_points"])}
    return {"name": file.attrs["study_name"], "kind": file.attrs["study_kind"],
            "complete": int(file.attrs["complete"]) == 1, "judged": file.attrs.get("damage", "judged") in ("judged", ""),
            "warnings": len(file.attrs.get("warnings", ())), "inputs": read_inputs(file["scenarios/input"]),
            "outcome": file["scenarios/outcome"][...].astype(int), "window": window, "set_points": settings}


# --- words ---

def words_of(key):
    """"strategy.lift_acceleration_m_s2" -> "lift acceleration"."""
    last = key.rsplit(".", 1)[-1]
    suffix = next((each for each in SUFFIXES if last.endswith(each)), "")
    return last[: len(last) - len(suffix)].replace("_", " ")


def axis_label(key, units):
    unit = UNITS.get(units, units)
    return words_of(key) + (f"  ({unit})" if unit else "")


def value_label(key, value, units):
    if isinstance(value, str):
        return os.path.splitext(os.path.basename(value))[0].replace("_", " ")
    if units == "Pa" and abs(value) >= 1e3:
        mega = abs(value) >= 1e6
        return f"{words_of(key)} {value / (1e6 if mega else 1e3):.4g} {'MPa' if mega else 'kPa'}"
    return f"{words_of(key)} {value:.4g} {UNITS.get(units, units)}".rstrip()


def place(columns, row):
    return ", ".join(value_label(key, column["values"][row], column["units"]) for key, column in columns.items())


def ends_text(table, row):
    low, high = table["hold_force_N"][row], table["damage_force_N"][row]
    return f"F_hold {low:.3g} N, F_damage {high:.3g} N" if np.isfinite(low + high) else "one end lies outside the range"


def answer(data):
    """The study's answer in one sentence, from its own tables: set-point first."""
    window, table = data["window"], data["set_points"]
    if not data["judged"]:
        return f"Held at {int(window['exists'].sum())} of {len(window['exists'])} combinations; damage was not judged"
    found = f"window at {int(window['exists'].sum())} of {len(window['exists'])} combinations"
    if table is None or not len(table["exists"]):
        exists = np.flatnonzero(window["exists"])
        if not len(exists):
            return "No window: no grip force holds the product unharmed"
        return found.capitalize() if len(window["exists"]) > 1 else f"Window: {ends_text(window, exists[0])}"
    best = np.flatnonzero(table["best"] == 1)
    if not len(best):
        return f"No set-point; {found}"
    row = best[0]
    where = place(table["inputs"], row)
    return (f"Set {table['set_point_N'][row]:.3g} N, may be off by {table['set_point_tolerance_N'][row]:.2g} N either way"
            f" ({ends_text(table, row)}{'; ' + where if where else ''})")


def remarks(data):
    count = data["warnings"]
    lines = [f"{count} warning{'s belong' if count > 1 else ' belongs'} to this answer: see report.html."] if count else []
    return lines if data["complete"] else lines + ["The study is not complete: some scenarios have not been run."]
