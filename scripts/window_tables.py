"""The grip windows of a results file as plain arrays, and what they say in words: what plot_window.py draws."""
import os

import h5py
import numpy as np

UNITS = {"m s-1": "m/s", "m s-2": "m/s²", "m3": "m³", "kg m-3": "kg/m³", "1": "", "N s m-1": "N s/m", "N m-1": "N/m"}


class Unsuitable(Exception):
    """The file cannot be drawn; the message is one line for the user."""


# --- reading ---

def opened(path):
    """An HDF5 file, to be read."""
    try:
        return h5py.File(path, "r")
    except OSError as error:
        raise Unsuitable(f"{path}: not a readable HDF5 file ({str(error).splitlines()[0]})") from error


def text_list(dataset):
    return [value.decode() if isinstance(value, bytes) else str(value) for value in dataset[...]]


def read_inputs(group):
    """The columns of varied keys in the study's order: key -> {values, units, words}."""
    chosen = [(int(item.attrs["position"]), key, item) for key, item in group.items()
              if "position" in item.attrs and "." in key]
    return {key: {"values": text_list(item) if item.dtype.kind == "O" else item[...].astype(float),
                  "units": item.attrs.get("units", ""), "words": item.attrs.get("long_name", key)} for _, key, item in sorted(chosen, key=lambda entry: entry[:2])}


def read_numbers(group):
    return {key: item[...] for key, item in group.items() if item.dtype.kind in "fiu"}


def read_results(path):
    """Everything the drawings need, as plain arrays."""
    if not os.path.exists(path):
        raise Unsuitable(f"{path}: no such file")
    with opened(path) as file:
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


def read_outcomes(column):
    """The outcome of each scenario as a code; words and colours of the codes."""
    if "flag_colors" not in column.attrs:
        raise Unsuitable("these results are of an older version and name no colours; run the study again")
    codes = [int(code) for code in column.attrs["flag_values"]]
    words, colours = column.attrs["flag_meanings"].split(), column.attrs["flag_colors"].split()
    return {"outcome": column[...].astype(int), "words": dict(zip(codes, words)), "colours": dict(zip(codes, colours))}


def read_tables(file):
    window = read_numbers(file["window"]) | {"inputs": read_inputs(file["window"])}
    return {"name": file.attrs["study_name"], "kind": file.attrs["study_kind"],
            "complete": int(file.attrs["complete"]) == 1, "judged": file.attrs.get("damage", "judged") in ("judged", ""),
            "warnings": len(file.attrs.get("warnings", ())), "inputs": read_inputs(file["scenarios/input"]),
            "answer": file["set_points"].attrs["answer"], "window": window} | read_outcomes(file["scenarios/outcome"])


# --- words ---

def axis_label(column):
    unit = UNITS.get(column["units"], column["units"])
    return column["words"] + (f"  ({unit})" if unit else "")


def value_label(column, value):
    if isinstance(value, str):
        return os.path.splitext(os.path.basename(value))[0].replace("_", " ")
    units = column["units"]
    if units == "Pa" and abs(value) >= 1e3:
        mega = abs(value) >= 1e6
        return f"{column['words']} {value / (1e6 if mega else 1e3):.4g} {'MPa' if mega else 'kPa'}"
    return f"{column['words']} {value:.4g} {UNITS.get(units, units)}".rstrip()


def remarks(data):
    count = data["warnings"]
    lines = [f"{count} warning{'s belong' if count > 1 else ' belongs'} to this answer: see report.html."] if count else []
    return lines if data["complete"] else lines + ["The study is not complete: some scenarios have not been run."]
