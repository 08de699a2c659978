"""What exists: the keys the program explains, the words and file names of the tree.

The program and the repository are the first two arguments of the test that imports this.
"""
import re
import subprocess
import sys
import tomllib
from dataclasses import replace
from functools import lru_cache
from pathlib import Path

PROGRAM, SOURCE = Path(sys.argv.pop(1)), Path(sys.argv.pop(1)).resolve()
CODE = ("core", "optimizer", "studies", "python", "examples", "packaging", "report", "configs", "scripts", "tests", "benchmarks", "cmake")


def say(*words):
    return subprocess.run([PROGRAM, *words], capture_output=True, text=True, check=True).stdout


@lru_cache
def keys():
    """Every key that `explain` names, lists without their index."""
    return {line.replace("[]", "") for line in say("explain").split("\n") if re.match(r"^[a-z_]+(\[\])?(\.[a-z_]+(\[\])?)?\.\w+$", line)}


@lru_cache
def code():
    """The text of the tree without the pages, and the names of its files."""
    names, texts = set(), []
    for top in CODE:
        for path in sorted((SOURCE / top).rglob("*")):
            if path.is_dir() or "node_modules" in path.parts:
                continue
            names.add(path.name)
            if path.suffix not in (".png", ".svg", ".lock", ".json") and path.parent.name != "history":
                texts.append(path.read_text(encoding="utf-8", errors="replace"))
    return names, "\n".join(texts)


@lru_cache
def words():
    """Every word of the tree."""
    return set(re.findall(r"\w+", code()[1])) | {name.split(".")[0] for name in code()[0]}


def paths_in(table, path=""):
    """(path, value) of everything in a TOML table that is no table itself; lists of tables without their index."""
    for key, value in table.items():
        here = f"{path}.{key}" if path else key
        if isinstance(value, dict):
            yield from paths_in(value, here)
        elif isinstance(value, list) and value and isinstance(value[0], dict):
            for element in value:
                yield from paths_in(element, here)
        else:
            yield here


def wrong_in_toml(block):
    """What is no TOML, or no key of the config: of a study, or of a product, gripper or strategy file."""
    try:
        table = tomllib.loads("\n".join(line for line in block.lines if line.strip() != "..."))
    except tomllib.TOMLDecodeError as error:
        if len(block.lines) == 1:
            yield str(error)
        else:  # alternatives of one key stand below each other
            for line in block.lines:
                yield from wrong_in_toml(replace(block, lines=[line]))
        return
    strategy = {key.split(".")[1] for key in keys() if key.startswith("strategy.")}
    bare = {key.split(".")[-1] for key in keys()} | {"name", "description"}
    for path in paths_in(table):
        table_name, _, key = path.partition(".")
        is_key = path in keys() or (not key and path in bare) or table_name == "source"
        if not is_key and not (table_name == "candidate" and key in strategy):
            yield path
