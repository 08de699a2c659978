#!/usr/bin/python3
"""Opens a results file the way users do and checks names, units, dimensions and missing values."""
import sys

import h5py
import numpy as np
import xarray


def check(condition, words):
    if not condition:
        sys.exit("check_results_file.py: " + words)


def check_every_dataset(name, item):
    if not isinstance(item, h5py.Dataset):
        return
    check(item.chunks is not None, f"{name} is not chunked")
    check(item.fletcher32 or item.dtype.kind == "O", f"{name} has no fletcher32")
    check(item.dtype.kind in "fiuO", f"{name} has the type {item.dtype}")
    if item.dtype.kind == "O":
        check(h5py.check_string_dtype(item.dtype).length is None, f"{name} is a fixed-length string")
    if not h5py.h5ds.is_scale(item.id):
        for axis, dimension in enumerate(item.dims):
            check(len(dimension) == 1, f"{name} has no scale on axis {axis}")


def check_scenarios(path, rows):
    metric = xarray.open_dataset(path, group="scenarios/metric", engine="h5netcdf")
    check(dict(metric.sizes) == {"id": rows}, f"scenarios/metric has the dimensions {dict(metric.sizes)}")
    check(metric["permanent_set_max_m"].attrs["units"] == "m", "permanent_set_max_m has no units")
    check("rigid motion removed" in metric["permanent_set_max_m"].attrs["long_name"], "no long_name")
    check(bool(np.isnan(metric["absorbed_energy_J"]).all()), "a missing metric is not NaN")
    check(np.array_equal(metric["permanent_set_max_m"], np.arange(rows, dtype=float)), "wrong values")
    given = xarray.open_dataset(path, group="scenarios/input", engine="h5netcdf")
    check(np.array_equal(given["strategy.grip_force_N"], 0.5 + np.arange(rows)), "wrong grip forces")
    check(given["strategy.grip_force_N"].attrs["long_name"] == "drive force limit", "another long name")
    check(given["product.use"].attrs["long_name"] == "product.use", "a key without its words")
    check(given["product.use"].values[1] == "grüne Pflaume.toml", "wrong text input")
    table = xarray.open_dataset(path, group="scenarios", engine="h5netcdf")
    check(list(table.coords) == ["id"], f"scenarios has the coordinates {list(table.coords)}")
    check(table["outcome"].dtype == np.int8, "the outcome is not int8")
    check(table["outcome"].attrs["flag_meanings"].split()[0] == "not_run", "wrong flag_meanings")
    check(list(table["outcome"].attrs["flag_values"]) == list(range(-1, 8)), "wrong flag_values")
    check(len(set(table["outcome"].attrs["flag_colors"].split())) == 9, "outcomes share a colour")
    check(table["digest"].dtype == np.uint64, "the digest is not 64 bits")


def check_trace(path):
    trace = xarray.open_dataset(path, group="trace", engine="h5netcdf")
    check(trace["displacement_m"].dims == ("time_s", "particle", "component"),
          f"displacement_m has the dimensions {trace['displacement_m'].dims}")
    check(trace["finger_force_N"].dims == ("time_s", "finger", "component"), "finger_force_N has wrong dimensions")
    check(trace["finger_force_N"].attrs["units"] == "N", "finger_force_N has no units")
    check("time_s" in trace.coords, "time_s is no coordinate")
    events = xarray.open_dataset(path, group="contact_events", engine="h5netcdf")
    check(events["kind"].dims == ("event",), "contact_events has no dimension event")
    check(events["kind"].attrs["flag_meanings"] == "make break stick slip", "contact_events/kind has other words")
    check(events["surface"].attrs["long_name"] == "0 left pad, 1 right pad, 2 support", "surfaces have other names")


def main():
    path, rows = sys.argv[1], int(sys.argv[2])
    with h5py.File(path, "r") as file:
        file.visititems(check_every_dataset)
        check(file.attrs["format_version"] == 1, "wrong format_version")
        check(isinstance(file.attrs["config"], str), "the config is not text")
        has_trace = "trace" in file
        has_window = "window" in file
    check_scenarios(path, rows)
    if has_trace:
        check_trace(path)
    if has_window:
        window = xarray.open_dataset(path, group="window", engine="h5netcdf")
        check(dict(window.sizes) == {"window": 2}, f"window has the dimensions {dict(window.sizes)}")
        check(window["hold_force_N"].attrs["units"] == "N", "hold_force_N has no units")
    print("ok")


main()
