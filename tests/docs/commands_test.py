#!/usr/bin/env python3
"""Runs the command blocks of one page, in order, in a temporary copy of what a reader has.

usage: commands_test.py PROGRAM SOURCE PAGE     remarks in the page: see pages.py
"""
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from pages import Page

TAKES_THIN = {"run", "check"}


def make_place(program, source):
    """A folder with build/release/unbruised, configs and scripts, as after a build."""
    place = Path(tempfile.mkdtemp(prefix="unbruised-docs-"))
    (place / "build/release").mkdir(parents=True)
    (place / "build/release/unbruised").symlink_to(program)
    # Copies: scripts draw beside themselves, configs are edited.
    for folder in ("configs", "scripts"):
        shutil.copytree(source / folder, place / folder)
    (place / "docs/images").mkdir(parents=True)
    return place


def default_study(place):
    return re.search(r"^default_study=(\S+)$", (place / "scripts/run").read_text(encoding="utf-8"), re.M).group(1)


def as_tested(command, options, place):
    """The command with the thinning options; scripts/run without its setting up and building."""
    words = shlex.split(command)
    if words[0] == "scripts/run":
        rest = words[1:] or [default_study(place)]
        command = shlex.join(["build/release/unbruised", "run", *rest])
        words = shlex.split(command)
    if options and words[0].endswith("unbruised") and words[1:2] and words[1] in TAKES_THIN:
        command += " " + shlex.join(shlex.split(options))
    return command


def run(command, place):
    """Exit status and what came on stdout and stderr together."""
    package = (place / "build/release/unbruised").resolve().parent / "python"
    environment = dict(os.environ, NO_COLOR="1", MPLBACKEND="Agg", PYTHONPATH=str(package), PATH=f"{place}/build/release:{os.environ['PATH']}")
    done = subprocess.run(["bash", "-c", command], cwd=place, env=environment, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, check=False)
    return done.returncode, done.stdout


def label(line):
    """How a line begins, before its first number, path or colon: what a thinned run prints too."""
    return re.split(r"[:\d<\[]|\bresults/", line.strip(), maxsplit=1)[0].strip()


def missing_lines(block, printed):
    """Lines of an output block that begin like no line that was printed."""
    came = [line.strip() for line in printed.split("\n")]
    for line in block.lines:
        start = label(line)
        if start and not start.startswith("...") and not any(c.startswith(start) for c in came):
            yield line


def try_block(block, place, printed):
    """The failures of a block's commands; what they print is added to `printed`."""
    if "first" in block.remarks:
        status, text = run(block.remarks["first"], place)
        if status != 0:
            yield f"`{block.remarks['first']}` ended with {status}:\n{text}"
    wanted = int(block.remarks.get("exit", 0))
    commands = block.commands or [shlex.join(["/usr/bin/python3", "-c", block.text])]
    for command in commands:
        status, text = run(as_tested(command, block.remarks.get("thin", ""), place), place)
        printed.append(text)
        if status != wanted:
            yield f"`{command}` ended with {status}, not {wanted}:\n{text}"


def try_page(page, place):
    """(line, failure) of every block of the page."""
    printed = []
    for block in page.blocks:
        if "file" in block.remarks:
            (place / block.remarks["file"]).write_text(block.text, encoding="utf-8")
        elif "output" in block.remarks:
            for line in missing_lines(block, "\n".join(printed)):
                yield block.line, f"no such line came: {line}"
        elif block.runs:
            for failure in try_block(block, place, printed):
                yield block.line, failure


def main():
    program, source, name = Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3]
    place = make_place(program.resolve(), source.resolve())
    try:
        failures = [f"{name}:{line}: {failure}" for line, failure in try_page(Page(source / name), place)]
    finally:
        shutil.rmtree(place)
    print("\n".join(failures) or f"{name}: every command block ran")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
