"""Products, grippers and the other tables of a scenario as objects: an attribute for each key, with its unit in its name."""
from __future__ import annotations

import json
import tomllib
from pathlib import Path
from typing import Any, Iterator, Mapping, Optional

from . import _unbruised

TABLES = ("product", "gripper", "cell", "sensor", "strategy", "limits", "simulation")


def literal(value: Any) -> str:
    """A value as TOML."""
    if hasattr(value, "tolist"):  # numpy's numbers and arrays
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(literal(item) for item in value) + "]"
    if value is None:
        return '"none"'
    return json.dumps(str(value), ensure_ascii=False)


def sets_of(values: Mapping[str, Any]) -> list[str]:
    """What `--set` takes."""
    return [f"{key}={literal(value)}" for key, value in values.items()]


def nested(table: Mapping[str, Any], key: str) -> Any:
    """The value of a dotted key; KeyError where there is none."""
    for part in key.split("."):
        table = table[part]
    return table


class Table:
    """One table of a scenario ("product", "strategy"): reading an attribute gives the value in use, setting one changes it.

    Names are checked at once, values when the study is next looked at, so that two that belong together can be set one after
    the other. `explain(name)` says what a key means.
    """

    def __init__(self, name: str, values: Optional[Mapping[str, Any]] = None) -> None:
        object.__setattr__(self, "_name", name)
        object.__setattr__(self, "_values", dict(values or {}))
        object.__setattr__(self, "_owner", None)

    def _known(self, key: str) -> str:
        known = _unbruised.keys_of(self._name)
        if key.split("[")[0] in known:
            return key
        near = _unbruised.nearest(key, known)
        hint = f"; did you mean '{near}'?" if near else ""
        raise AttributeError(f"[{self._name}] has no key '{key}'{hint}")

    def __getattr__(self, key: str) -> Any:
        if key.startswith("_"):
            raise AttributeError(key)
        return self[key]

    def __setattr__(self, key: str, value: Any) -> None:
        self[key] = value

    def __getitem__(self, key: str) -> Any:
        self._known(key)
        if key in self._values:
            return self._values[key]
        if self._owner is not None:
            try:
                return nested(self._owner.resolved.get(self._name, {}), key)
            except KeyError:
                return None
        return None

    def __setitem__(self, key: str, value: Any) -> None:
        self._values[self._known(key)] = value

    def __dir__(self) -> Iterator[str]:
        return iter([*super().__dir__(), *(key for key in _unbruised.keys_of(self._name) if key.isidentifier())])

    def __repr__(self) -> str:
        values = ", ".join(f"{key}={value!r}" for key, value in self._values.items())
        return f"{type(self).__name__}({values})"

    def update(self, values: Mapping[str, Any]) -> None:
        for key, value in values.items():
            self[key] = value

    def explain(self, key: str) -> str:
        """What a key means: unit, default, range."""
        return _unbruised.explain(f"{self._name}.{self._known(key)}") or ""

    def changes(self) -> dict[str, Any]:
        """What was set, by the keys of a study."""
        return {f"{self._name}.{key}": value for key, value in self._values.items()}


class _Shipped(Table):
    """A table that a file of the library fills."""

    _table = ""

    def __init__(self, use: str, **values: Any) -> None:
        super().__init__(self._table, {"use": use})
        source = _unbruised.Source("", "")
        places = (Path(use), Path(source.root) / use)
        file = next((place for place in places if place.is_file()), None)
        if file is None:
            raise FileNotFoundError(f"{self._table} {use}: neither here nor in {source.root}")
        if file == places[0]:
            self._values["use"] = str(file.resolve())
        object.__setattr__(self, "_file", tomllib.loads(file.read_text(encoding="utf-8")))
        self.update(values)

    def __getitem__(self, key: str) -> Any:
        value = super().__getitem__(key)
        if value is not None or key in self._values:
            return value
        try:
            return nested(self._file, key)
        except KeyError:
            return None


class Product(_Shipped):
    """A product of the library, to be changed and given to a study:

        peach = ub.Product("products/peach.toml", mass_kg=0.14)
        study.product = peach
    """

    _table = "product"


class Gripper(_Shipped):
    """A gripper of the library, likewise: `study.gripper = ub.Gripper("grippers/parallel_jaw.toml", stroke_m=0.04)`."""

    _table = "gripper"
