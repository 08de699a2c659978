#!/usr/bin/python3
"""Compares the processor time of this tree with that of another revision, run by run in turns.

    against.py REV [--turns N] [--study FILE.toml]... [--set KEY=VALUE]... [--set-here KEY=VALUE]...
               [--build FOLDER] [--here FOLDER]

Builds REV as a release in build/against/REV (a worktree of its own, kept for the next time) and this tree in
build/release, unless --build and --here name programs that are built already. Each study then runs in both, on one
thread, A B A B ...: a machine's moods meet both alike. Printed are the processor seconds of either (user and system,
the kernel's account of the child) as minimum and median, and the ratio of this tree to REV, pair by pair: its median
says what changed, its range what the machine made of it. Without --study: cube512 at 1 ms and what a sweep of kiwis
takes, as benchmarks/studies has them. --set goes to both programs, --set-here to this tree's alone: for keys that REV
did not know.
Exit status: 0 compared, 1 a study failed in one of them, 2 wrong arguments.
"""
import argparse
import os
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
STUDIES = ["benchmarks/studies/cube512.toml", "benchmarks/studies/kiwi_cycles.toml"]


def program_of(revision):
    """The program of a revision, built in its own worktree."""
    commit = subprocess.run(["git", "-C", ROOT, "rev-parse", "--short", "--verify", f"{revision}^{{commit}}"],
                            capture_output=True, text=True)
    if commit.returncode != 0:
        sys.exit(f"against: {revision} is no revision of this repository")
    tree = ROOT / "build" / "against" / commit.stdout.strip()
    if not tree.exists():
        subprocess.run(["git", "-C", ROOT, "worktree", "add", "--detach", tree, commit.stdout.strip()], check=True,
                       stdout=subprocess.DEVNULL)
    subprocess.run([tree / "scripts" / "build", "release", "unbruised"], check=True, stdout=sys.stderr)
    return tree / "build" / "release" / "unbruised"


def without_replay(program):
    """The option that keeps a run from simulating scenarios again for its page, where the program has one."""
    offered = subprocess.run([program, "run", "--help"], capture_output=True, text=True).stdout
    return ["--no-replay"] if "--no-replay" in offered else []


def processor_seconds(program, study, options, folder):
    """One run on one thread. Raises RuntimeError with what the program said where it fails."""
    command = [program, "run", study, "--threads", "1", "--quiet", "--output", folder, *options]
    with tempfile.TemporaryFile() as said:
        child = subprocess.Popen([str(part) for part in command], stdin=subprocess.DEVNULL, stdout=said, stderr=said)
        _, status, usage = os.wait4(child.pid, 0)
        if os.waitstatus_to_exitcode(status) != 0:
            said.seek(0)
            raise RuntimeError(f"{program} run {study}: {said.read().decode(errors='replace').strip()[-600:]}")
    return usage.ru_utime + usage.ru_stime


def compare(study, settings, settings_here, here, there, turns):
    seconds = {here: [], there: []}
    options = {}
    for program, given in ((here, settings + settings_here), (there, settings)):
        options[program] = [*without_replay(program), *(word for setting in given for word in ("--set", setting))]
    with tempfile.TemporaryDirectory(prefix="against-") as folder:
        for turn in range(turns + 1):  # the first pair warms up
            for program in (here, there):
                took = processor_seconds(program, study, options[program], Path(folder) / f"{turn}-{program is here}")
                if turn > 0:
                    seconds[program].append(took)
    ratio = sorted(a / b for a, b in zip(seconds[here], seconds[there]))
    a, b = seconds[here], seconds[there]
    print(f"{Path(study).stem:>20} {min(a):9.3f} {statistics.median(a):9.3f} {min(b):9.3f} "
          f"{statistics.median(b):9.3f} {min(a) / min(b):9.3f} {statistics.median(ratio):9.3f} "
          f"{ratio[0]:9.3f} {ratio[-1]:9.3f}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("revision")
    parser.add_argument("--turns", type=int, default=5)
    parser.add_argument("--study", action="append", default=[])
    parser.add_argument("--set", action="append", default=[], dest="settings")
    parser.add_argument("--set-here", action="append", default=[], dest="settings_here")
    parser.add_argument("--build", help="folder of REV's program")
    parser.add_argument("--here", help="folder of this tree's program")
    options = parser.parse_args()
    if options.turns < 1:
        parser.error("--turns asks for one pair at least")
    studies = [Path(study).resolve() for study in options.study] or [ROOT / study for study in STUDIES]
    if not options.here:
        subprocess.run([ROOT / "scripts" / "build", "release", "unbruised"], check=True, stdout=sys.stderr)
    here = Path(options.here or ROOT / "build" / "release").resolve() / "unbruised"
    there = Path(options.build).resolve() / "unbruised" if options.build else program_of(options.revision)
    print(f"processor seconds of one thread, {options.turns} pairs in turns: this tree, {options.revision}, ratios")
    print(f"{'study':>20} {'least':>9} {'median':>9} {'least':>9} {'median':>9} {'of least':>9} {'median':>9} "
          f"{'lowest':>9} {'highest':>9}")
    try:
        for study in studies:
            compare(study, options.settings, options.settings_here, here, there, options.turns)
    except RuntimeError as failure:
        sys.exit(f"against: {failure}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
