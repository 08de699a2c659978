"""Results as xarray's datasets and pandas' tables."""
from __future__ import annotations

from pathlib import Path
from typing import Any, Mapping, Optional, Union

import h5py
import numpy
import pandas
import xarray

from . import _unbruised

OUTCOMES = {0: "held", 1: "slipped", 2: "dropped", 3: "damaged", 4: "not_grasped", 5: "diverged", 6: "out_of_range",
            7: "misplaced", -1: "not_run"}


def scenarios_dataset(columns: Mapping[str, Any], inputs: Mapping[str, Any]) -> xarray.Dataset:
    """What `evaluate` of the module gives, with names and units."""
    variables: dict[str, Any] = {key: ("scenario", numpy.asarray(values)) for key, values in inputs.items()}
    variables["outcome"] = ("scenario", numpy.asarray(columns["outcome_word"], dtype=object))
    variables["cause"] = ("scenario", numpy.asarray(columns["cause"], dtype=object))
    variables["outcome_time_s"] = ("scenario", columns["outcome_time_s"], {"units": "s"})
    for name, units, long_name in _unbruised.metric_table():
        variables[name] = ("scenario", columns["metrics"][name], {"units": units, "long_name": long_name})
    variables["digest"] = ("scenario", columns["digest"])
    return xarray.Dataset(variables, coords={"scenario": numpy.arange(len(columns["outcome"]))},
                          attrs={"numeric_build": _unbruised.numeric_build()})


def trace_dataset(simulated: Mapping[str, Any]) -> xarray.Dataset:
    """One scenario over time, with its metrics as attributes."""
    signals = dict(simulated["signals"])
    events = signals.pop("contact_events")
    variables: dict[str, Any] = {}
    extents: dict[str, int] = {}
    for name, (dimensions, values, units, long_name) in signals.items():
        named = []
        for dimension, extent in zip(dimensions, values.shape):  # as in results.h5: another extent has another name
            known = extents.setdefault(dimension, extent)
            named.append(dimension if known == extent else f"{dimension}_{extent}")
        variables[name] = (tuple(named), values, {"units": units, "long_name": long_name})
    for name, (dimensions, values, units, long_name) in events.items():
        variables[f"event_{name}"] = (tuple(dimensions), values, {"units": units, "long_name": long_name})
    result = simulated["result"]
    attributes: dict[str, Any] = {name: float(values[0]) for name, values in result["metrics"].items()}
    attributes |= {"outcome": result["outcome_word"][0], "cause": result["cause"][0], "digest": f"{int(result['digest'][0]):016x}",
                   "numeric_build": _unbruised.numeric_build()}
    return xarray.Dataset(variables, attrs=attributes)


def _text(value: Any) -> Any:
    return value.decode() if isinstance(value, bytes) else value


def _columns(group: h5py.Group, dimension: str) -> dict[str, Any]:
    columns = {}
    for name, dataset in group.items():
        if not isinstance(dataset, h5py.Dataset) or dataset.ndim != 1 or name == dimension:
            continue
        values = dataset.asstr()[...] if h5py.check_string_dtype(dataset.dtype) else dataset[...]
        kept = {key: _text(dataset.attrs[key]) for key in ("units", "long_name") if key in dataset.attrs}
        columns[name] = (dimension, values, kept)
    return columns


class Results:
    """What stands in a run directory, or in a results file."""

    def __init__(self, path: Union[str, Path]) -> None:
        path = Path(path)
        self.path = path / "results.h5" if path.is_dir() else path
        self.directory = self.path.parent
        with h5py.File(self.path, "r") as file:
            self.attributes: dict[str, Any] = {key: _text(value) for key, value in file.attrs.items()}

    def __repr__(self) -> str:
        return f"Results({str(self.path)!r}: {self.kind} study {self.name!r}, {'complete' if self.complete else 'unfinished'})"

    @property
    def name(self) -> str:
        return self.attributes["study_name"]

    @property
    def kind(self) -> str:
        return self.attributes["study_kind"]

    @property
    def complete(self) -> bool:
        return bool(self.attributes["complete"])

    @property
    def warnings(self) -> list[str]:
        """What belongs to the answer."""
        return [_text(line) for line in numpy.atleast_1d(self.attributes.get("warnings", []))]

    @property
    def scenarios(self) -> xarray.Dataset:
        """Every scenario: varied keys, outcome, metrics."""
        with h5py.File(self.path, "r") as file:
            group = file["scenarios"]
            variables = _columns(group["input"], "scenario") if "input" in group else {}
            variables |= _columns(group["metric"], "scenario")
            ids = group["id"][...]
            variables["outcome"] = ("scenario", numpy.array([OUTCOMES[code] for code in group["outcome"][...]], dtype=object))
            variables["cause"] = ("scenario", group["cause"].asstr()[...])
            variables["outcome_time_s"] = ("scenario", group["outcome_time_s"][...], {"units": "s"})
            variables["digest"] = ("scenario", group["digest"][...])
        return xarray.Dataset(variables, coords={"scenario": ids}, attrs={"study": self.name, "kind": self.kind})

    def to_dataframe(self) -> pandas.DataFrame:
        """The same, a row for each scenario."""
        return self.scenarios.to_dataframe()

    @property
    def tables(self) -> list[str]:
        """What the kind of study found beside: "window", "best", "pareto", ..."""
        with h5py.File(self.path, "r") as file:
            return [name for name, group in file.items() if isinstance(group, h5py.Group)
                    and name not in ("scenarios", "trace", "contact_events")]

    def table(self, name: str) -> pandas.DataFrame:
        """One of them."""
        with h5py.File(self.path, "r") as file:
            return pandas.DataFrame({key: values for key, (_, values, _) in _columns(file[name], "").items()})

    @property
    def strategy_toml(self) -> Optional[str]:
        """The answer as a strategy file; None where the study has none."""
        file = self.directory / "strategy.toml"
        return file.read_text(encoding="utf-8") if file.is_file() else None


def open_results(path: Union[str, Path]) -> Results:
    """The results of a run directory or of a results file."""
    return Results(path)
