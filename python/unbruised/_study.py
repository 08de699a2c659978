"""Studies, and scenarios without one."""
from __future__ import annotations

import sys
import tomllib
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable, Iterable, Mapping, Optional, Union

import numpy
import pandas
import xarray

from . import _unbruised
from ._errors import RunError
from ._objects import TABLES, Table, sets_of
from ._results import Results, scenarios_dataset, trace_dataset

Overrides = Union[pandas.DataFrame, Iterable[Mapping[str, Any]]]


@dataclass(frozen=True)
class Progress:
    """How far a run is."""

    done: int
    total: int
    text: str  #: as `unbruised run` says it


class Study:
    """A study that can be changed, checked and run. Its tables are objects: `study.product.mass_kg = 0.1`.

    `source` is a file, or with `text` what stands for it. `sets` go on top, as `--set` does.
    """

    def __init__(self, source: Union[str, Path] = "", sets: Optional[Mapping[str, Any]] = None, *,
                 text: Optional[str] = None) -> None:
        object.__setattr__(self, "_source", _unbruised.Source(str(source), text))
        object.__setattr__(self, "_sets", dict(sets or {}))
        object.__setattr__(self, "_tables", {})
        for name in TABLES:
            self._give(name, Table(name))
        object.__setattr__(self, "_seen", (None, None))
        self._facts()

    def _give(self, name: str, table: Table) -> None:
        object.__setattr__(table, "_owner", self)
        self._tables[name] = table

    def __getattr__(self, name: str) -> Any:
        if name in TABLES:
            return self._tables[name]
        raise AttributeError(f"a study has no '{name}'")

    def __setattr__(self, name: str, value: Any) -> None:
        if name not in TABLES:
            raise AttributeError(f"a study has no '{name}'; its tables are {', '.join(TABLES)}")
        if not isinstance(value, Table) or value._name != name:
            raise TypeError(f"study.{name} takes an unbruised.{name.capitalize()}")
        self._give(name, value)

    def __repr__(self) -> str:
        return f"Study({self.name!r}, {self.kind})"

    @property
    def changes(self) -> dict[str, Any]:
        """What was set on top of the file, by dotted key."""
        changes = dict(self._sets)
        for table in self._tables.values():
            changes |= table.changes()
        return changes

    def set(self, values: Mapping[str, Any]) -> "Study":
        """Gives keys other values, `{"window.tolerance": 0.01}`; those of any table."""
        self._sets.update(values)
        return self

    def _facts(self) -> dict[str, Any]:
        sets = sets_of(self.changes)
        if self._seen[0] != sets:
            object.__setattr__(self, "_seen", (sets, _unbruised.facts(self._source, sets)))
        return self._seen[1]

    @property
    def name(self) -> str:
        return self._facts()["name"]

    @property
    def kind(self) -> str:
        return self._facts()["kind"]

    @property
    def file(self) -> str:
        return self._source.file

    @property
    def resolved_toml(self) -> str:
        """The whole study as TOML, every value written out."""
        return self._facts()["resolved_toml"]

    @property
    def resolved(self) -> dict[str, Any]:
        """The same as nested dictionaries."""
        return tomllib.loads(self.resolved_toml)

    def check(self, threads: Optional[int] = None) -> dict[str, Any]:
        """What it will cost (`scenarios`, `seconds`, `memory_bytes`, ...), and `warnings`. Raises ConfigError."""
        return _unbruised.check(self._source, sets_of(self.changes), threads or _unbruised.usable_cores())

    def run(self, directory: Union[str, Path, None] = None, *, threads: Optional[int] = None, fresh: bool = False,
            progress: Union[bool, Callable[[Progress], Any]] = False) -> Results:
        """Runs the study, or goes on with it, as `unbruised run` does, in the same run directory (results/<name>).

        A study that is finished there is not run again; `fresh` moves it aside. `progress`: True for a line on stderr, or what is
        called with a Progress a few times a second. Ctrl-C raises KeyboardInterrupt once all that was run is safe: the same call
        goes on. Raises ConfigError, RunError.
        """
        directory = Path(directory) if directory is not None else Path("results") / self.name
        show = _progress(progress)
        try:
            _unbruised.run(self._source, sets_of(self.changes), str(directory), threads or _unbruised.usable_cores(), fresh, show)
        except RunError as error:
            if error.kind != "finished":
                raise
        finally:
            if progress is True:
                print(file=sys.stderr)
        return Results(directory)

    def simulate(self, overrides: Optional[Mapping[str, Any]] = None, **options: Any) -> xarray.Dataset:
        """`unbruised.simulate(self, ...)`."""
        return simulate(self, overrides, **options)

    def evaluate(self, overrides: Overrides, **options: Any) -> xarray.Dataset:
        """`unbruised.evaluate(self, ...)`."""
        return evaluate(self, overrides, **options)


def load(file: Union[str, Path], sets: Optional[Mapping[str, Any]] = None) -> Study:
    """Reads a study's TOML file; where there is none of that name, the one that ships. Raises ConfigError."""
    return Study(file, sets)


def _study(study: Union[Study, str, Path]) -> Study:
    return study if isinstance(study, Study) else load(study)


def _progress(progress: Union[bool, Callable[[Progress], Any]]) -> Optional[Callable[..., None]]:
    if progress is True:
        return lambda done, total, text="": print(f"\r\x1b[K{text or f'{done} of {total} scenarios'}", end="", file=sys.stderr, flush=True)
    if isinstance(progress, bool) or progress is None:
        return None
    show = progress  # of which the type is known inside the function too
    return lambda done, total, text="": show(Progress(done, total, text))


def _on_top(study: Study, overrides: Mapping[str, Any]) -> list[str]:
    """What one scenario is made with. A time step that the study chose for all its scenarios is theirs too."""
    values = study.changes | dict(overrides)
    facts = study._facts()
    if facts["is_time_step_chosen"]:
        values.setdefault("simulation.time_step_s", facts["time_step_s"])
    blocks = ("study.kind", "study.seed", "window.", "search.", "sampling.", "compare.", "sensitivity.", "calibrate.", "vary", "variable",
              "random", "correlation", "candidate", "parameter", "specimen")
    return sets_of({key: value for key, value in values.items() if not key.startswith(blocks)})


def simulate(study: Union[Study, str, Path], overrides: Optional[Mapping[str, Any]] = None, *, scenario: Optional[int] = None,
             motion: bool = False) -> xarray.Dataset:
    """One scenario over time: forces, energies, contacts, and with `motion` the way of every particle.

    Without `scenario` it is what the study says about a single one, without what it varies or searches, `overrides`
    (`{"strategy.grip_force_N": 2.0}`) on top; with it the scenario of that number, as `unbruised run --scenario` runs it.
    Outcome, cause, digest and metrics are attributes. Raises ConfigError.
    """
    study = _study(study)
    if scenario is None:
        sets = _on_top(study, overrides or {})
    else:
        sets = sets_of(study.changes | dict(overrides or {}))
    return trace_dataset(_unbruised.simulate(study._source, sets, scenario, motion))


def evaluate(study: Union[Study, str, Path], overrides: Overrides, *, threads: Optional[int] = None,
             progress: Union[bool, Callable[[Progress], Any]] = False) -> xarray.Dataset:
    """Many scenarios in lanes, without a run directory: a row for each of `overrides`, in their order.

    Each is what `simulate` runs with that override, to the bit, whatever stands beside it. A DataFrame has a column for each key.
    Rows with the same geometry, stiffness and time step share one factored matrix and are fast; others cost a factorisation each.
    `.to_dataframe()` makes a table of it. Raises ConfigError with `row`.
    """
    study = _study(study)
    table = overrides if isinstance(overrides, pandas.DataFrame) else None
    rows = table.to_dict("records") if table is not None else [dict(row) for row in overrides]
    rows = [{key: value for key, value in row.items() if not (isinstance(value, float) and numpy.isnan(value))} for row in rows]
    sets = [_on_top(study, row) for row in rows]
    columns = _unbruised.evaluate(study._source, sets, threads or _unbruised.usable_cores(), _progress(progress))
    keys = dict.fromkeys(key for row in rows for key in row)
    return scenarios_dataset(columns, {key: _column([row.get(key) for row in rows]) for key in keys})


def _column(values: list[Any]) -> numpy.ndarray:
    if all(isinstance(value, (int, float, numpy.number)) and not isinstance(value, bool) for value in values):
        return numpy.asarray(values, dtype=float)
    column = numpy.empty(len(values), dtype=object)
    for at, value in enumerate(values):  # lists too are one value each
        column[at] = value
    return column
