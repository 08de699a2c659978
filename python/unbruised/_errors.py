"""What can go wrong, as exceptions."""
from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Optional

# `file:line: key = value: rule`, `--set: key = value: rule`; value and key may be missing.
_PLACE = re.compile(r"(?P<place>--set|(?P<file>.*?):(?P<line>\d+)): (?P<rest>.*)", re.DOTALL)
_RULE = re.compile(r"(?P<key>\S+?)(?: = (?P<value>.*?))?: (?P<rule>.*)", re.DOTALL)


@dataclass(frozen=True)
class Problem:
    """One broken rule of a study."""

    text: str
    file: Optional[str] = None  #: None: what was set from Python
    line: Optional[int] = None
    key: Optional[str] = None
    value: Optional[str] = None  #: as TOML, a long one shortened
    rule: Optional[str] = None

    @classmethod
    def read(cls, text: str) -> "Problem":
        place = _PLACE.fullmatch(text)
        if place is None:
            return cls(text)
        line = place["line"]
        rule = _RULE.fullmatch(place["rest"])
        said = rule.groupdict() if rule else {"key": None, "value": None, "rule": place["rest"]}
        return cls(text, place["file"], int(line) if line else None, said["key"], said["value"], said["rule"])


class ConfigError(ValueError):
    """A study breaks rules: all of them, each with file, line, key, value and rule."""

    def __init__(self, messages: list[str], row: Optional[int] = None) -> None:
        self.problems = [Problem.read(message) for message in messages]
        self.row = row  #: of what was to be evaluated, from 0
        super().__init__("\n".join(([] if row is None else [f"row {row}:"]) + list(messages)))

    @property
    def file(self) -> Optional[str]:
        """Where the first problem stands."""
        return self.problems[0].file

    @property
    def line(self) -> Optional[int]:
        return self.problems[0].line

    @property
    def key(self) -> Optional[str]:
        return self.problems[0].key


class RunError(RuntimeError):
    """A run directory or this machine does not let a study run. `kind`: io, busy, finished, other_config, other_build, foreign,
    not_built, damaged, or refused (it does not fit)."""

    def __init__(self, message: str, kind: str) -> None:
        self.kind = kind
        super().__init__(message)
