"""What the reliability tests share: calling the program, reading its journals, counting what went wrong."""

import argparse
import concurrent.futures
import os
import pathlib
import random
import re
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import threading
import time

HERE = pathlib.Path(__file__).resolve().parent
CONFIGS = HERE.parent.parent / "configs"
STATUS_OF_SIGNAL = 128

# Every study kind, as small as it can be and still take some tenths of a second.
COARSE = ["product.cell_size_m=0.0125", "simulation.time_step_s=4e-3"]
KINDS = {
    "simulate": [str(HERE / "studies/simulate.toml")],
    "sweep": [str(HERE / "studies/sweep.toml")],
    "window": [str(CONFIGS / "kiwi_window.toml"), "window.tolerance=0.05"],
    "sample": [str(CONFIGS / "kiwi_sample.toml"), "sampling.count=64", "sampling.factor_groups=4"],
    "optimize": [str(CONFIGS / "kiwi_optimize.toml"), "search.starts=4", "search.budget=32"],
    "robust": [str(CONFIGS / "kiwi_robust.toml"), "search.starts=2", "search.budget=4", "sampling.count=10",
               "sampling.factor_groups=2"],
    "pareto": [str(CONFIGS / "kiwi_pareto.toml"), "search.points=4", "search.starts=1", "search.budget=60"],
    "compare": [str(CONFIGS / "kiwi_compare.toml"), "sampling.count=24", "sampling.factor_groups=4"],
    "sensitivity": [str(CONFIGS / "kiwi_sensitivity.toml"), "sensitivity.samples=8"],
}

# Whole cells, whose scenarios part ways: what is awake in one lane must not show in another.
CELLS = {
    "belt": [str(CONFIGS / "belt_pick.toml"), "product.cell_size_m=8.33e-3"],
}


def words_of(kind):
    """The words behind `run` that make the small study of a kind, or that of a cell."""
    study, *sets = (KINDS | CELLS)[kind]
    if kind in KINDS and not study.startswith(str(HERE)):
        sets = COARSE + sets
    return [study] + [word for key in sets for word in ("--set", key)]


class Answer:
    def __init__(self, status, out, err):
        self.status, self.out, self.err = status, out, err

    def line(self, beginning):
        for line in self.out.splitlines():
            if line.startswith(beginning):
                return line[len(beginning):]
        return ""

    @property
    def digest(self):
        return self.line("digest ")

    @property
    def crashed(self):
        """Ended by a signal of its own, or as an internal error."""
        return self.status == 1 or self.status in (
            -signal.SIGSEGV, -signal.SIGABRT, -signal.SIGBUS, -signal.SIGFPE, -signal.SIGILL)


class Program:
    def __init__(self, path, shim):
        self.path, self.shim = path, shim

    def environment(self, fault=None):
        env = dict(os.environ, LC_ALL="C")
        if fault:
            env.update(fault, LD_PRELOAD=self.shim)
        return env

    def start(self, *words, fault=None, env=None):
        environment = self.environment(fault)
        environment.update(env or {})
        return subprocess.Popen([self.path, *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                text=True, errors="replace", env=environment)

    def call(self, *words, fault=None, env=None, seconds=300):
        child = self.start(*words, fault=fault, env=env)
        try:
            out, err = child.communicate(timeout=seconds)
        except subprocess.TimeoutExpired:
            child.kill()
            out, err = child.communicate()
            return Answer(-signal.SIGXCPU, out, err + "\n(ended: it hung)")
        return Answer(child.returncode, out, err)

    def run(self, kind, directory, *more, **how):
        return self.call("run", *words_of(kind), "--output", directory, "--quiet", *more, **how)


def fault(directory, at, kind, log=None):
    variables = {"UNBRUISED_FAULT_BELOW": str(directory), "UNBRUISED_FAULT_AT": str(at), "UNBRUISED_FAULT_KIND": kind}
    if log:
        variables["UNBRUISED_FAULT_LOG"] = str(log)
    return variables


# -- Journals, read by the page of the format (docs/results.md) and by nothing of the program. ------------------------

def _crc_table():
    table = []
    for value in range(256):
        for _ in range(8):
            value = (value >> 1) ^ (0x82F63B78 if value & 1 else 0)
        table.append(value)
    return table


_TABLE = _crc_table()


def crc32c(data):
    crc = 0xFFFFFFFF
    for byte in data:
        crc = _TABLE[(crc ^ byte) & 0xFF] ^ (crc >> 8)
    return crc ^ 0xFFFFFFFF


def records(data):
    """(kind, id, payload) of the whole records from the start, up to the first that does not hold."""
    at, found = 0, []
    while at + 40 <= len(data):
        if data[at:at + 4] != b"UBJ\n" or struct.unpack_from("<I", data, at + 36)[0] != crc32c(data[at:at + 36]):
            break
        _, kind, length, crc, number = struct.unpack_from("<HHIIQ", data, at + 4)
        payload = data[at + 40:at + 40 + length]
        if len(payload) < length or crc32c(payload) != crc:
            break
        found.append((kind, number, payload))
        at += 40 + length
    return found


def scenarios(data):
    return {number: payload for kind, number, payload in records(data) if kind == 1}


def journals(directory):
    return sorted(pathlib.Path(directory).glob("journal/*.jrnl"))


def recorded(directory):
    """All scenarios of all journals."""
    rows = {}
    for path in journals(directory):
        for number, payload in scenarios(path.read_bytes()).items():
            rows.setdefault(number, payload)
    return rows


def acknowledged(log):
    """The last acknowledged size of each journal that the shim saw, and the normal end's count of calls."""
    sizes, calls = {}, None
    if pathlib.Path(log).exists():
        for line in pathlib.Path(log).read_text().splitlines():
            word, rest = line.split(" ", 1)
            if word == "calls":
                calls = int(rest)
            else:
                size, path = rest.split(" ", 1)
                if path.endswith(".jrnl"):
                    sizes[path] = int(size)
    return sizes, calls


def acknowledged_scenarios(sizes):
    """Scenarios whose record a successful fdatasync covered: what must never get lost."""
    rows = {}
    for path, size in sizes.items():
        rows.update(scenarios(pathlib.Path(path).read_bytes()[:size]))
    return rows


# -- Trials. -----------------------------------------------------------------------------------------------------

class Figures:
    """Counts and complaints, thread-safe."""

    def __init__(self, file=None):
        self.file = file
        self.lock = threading.Lock()
        self.counts = {}
        self.complaints = []

    def add(self, name, count=1):
        with self.lock:
            self.counts[name] = self.counts.get(name, 0) + count

    def expect(self, holds, complaint):
        if not holds:
            with self.lock:
                self.complaints.append(complaint)
        return holds

    def __getitem__(self, name):
        return self.counts.get(name, 0)

    def finish(self, summary):
        for complaint in self.complaints[:20]:
            print("WRONG:", complaint)
        if self.complaints:
            summary += f"; {len(self.complaints)} WRONG"
        print(summary, flush=True)
        if self.file:
            pathlib.Path(self.file).parent.mkdir(exist_ok=True)
            pathlib.Path(self.file).write_text(summary + "\n")
        sys.exit(1 if self.complaints else 0)


def in_parallel(trial, items):
    """Calls trial(item) for each; an exception is the test's own fault and ends it."""
    workers = int(os.environ.get("UNBRUISED_TRIALS_AT_ONCE", min(2, os.cpu_count() or 1)))
    with concurrent.futures.ThreadPoolExecutor(workers) as pool:
        for _ in pool.map(trial, items):
            pass


def arguments(description):
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--program", required=True)
    parser.add_argument("--shim", required=True)
    parser.add_argument("--quick", action="store_true", help="a few trials of each kind")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--figures", help="file that gets the summary too")
    return parser.parse_args()


class Folder:
    """A folder of its own, removed at the end; kept where something went wrong and KEEP_TRIALS is set."""

    def __enter__(self):
        self.path = pathlib.Path(tempfile.mkdtemp(prefix="unbruised_trials_"))
        return self.path

    def __exit__(self, kind, *_):
        if not os.environ.get("KEEP_TRIALS"):
            shutil.rmtree(self.path, ignore_errors=True)


def found_scenarios(answer):
    """How many scenarios a continued run says it found."""
    match = re.search(r"(\d+) scenarios found in", answer.err)
    return int(match.group(1)) if match else 0


def boundary(data, rows):
    """Bytes of a journal up to its row of this number."""
    size = 0
    while len(scenarios(data[:size])) < rows:
        size += 40 + int.from_bytes(data[size + 8:size + 12], "little")
    return size


def ends_whole(data):
    """Is a journal nothing but whole records?"""
    size = 0
    for _, _, payload in records(data):
        size += 40 + len(payload)
    return size == len(data)
