#!/usr/bin/env python3
"""A study on a real Slurm of one node: tasks that are killed, requeued, told of their time limit, or whose node is taken away
or lost. No row is lost, and the digest is that of one process.

usage: slurm_test.py PROGRAM [--figures FILE] [NAME ...]      names: killed requeued drained lost limit (all without a name)
"""
import argparse
import math
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path[:0] = [str(Path(__file__).parent), str(Path(__file__).parent.parent)]
from small_studies import masses  # pylint: disable=wrong-import-position
from slurm import Slurm, missing  # pylint: disable=wrong-import-position

TASKS = 4
TASK_S = 90  # of a task that meets its time limit: it is told after a minute or later


def scenarios_of(program, seconds, task_s):
    """How many keep a task of one core busy for so long on this machine."""
    count = 8
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "study.toml").write_text(masses(seconds, count))
        start = time.monotonic()
        subprocess.run([program, "run", "study.toml", "-q", "--no-replay", "--threads", "1", "-o", "run"], cwd=folder, capture_output=True,
                       check=True)
    return TASKS * max(10, math.ceil(count * task_s / (time.monotonic() - start)))


class Trial:
    """A study in a folder of its own."""

    def __init__(self, program, slurm, name, seconds, count, options=()):
        self.program, self.slurm, self.name = program, slurm, name
        self.folder = Path(tempfile.mkdtemp(prefix=f"unbruised-{name}-"))
        self.count = count
        (self.folder / "study.toml").write_text(masses(seconds, count))
        self.options = options

    def call(self, *words, check=True):
        done = subprocess.run([self.program, *words], cwd=self.folder, env=self.slurm.environment, capture_output=True, text=True, check=False)
        if check and done.returncode != 0:
            raise AssertionError(f"{self.name}: {' '.join(words)} ended with {done.returncode}: {done.stderr}{done.stdout}")
        return done

    def submit(self):
        said = self.call("submit", "study.toml", "--slurm", "--tasks", str(TASKS), "--cpus", "1", "-o", "run", "--now", *self.options)
        numbers = re.search(r"jobs (\d+) \(\d+ tasks\) and (\d+) \(merge\)", said.stdout)
        assert numbers, said.stdout
        return numbers.groups()

    def rows(self):
        """Scenarios that stand in the journals, by `info`."""
        text = self.call("info", "run", check=False).stdout
        found = re.search(r"([\d,]+) of [\d,]+ scenarios|([\d,]+) scenarios", text)
        return int((found.group(1) or found.group(2)).replace(",", "")) if found else 0

    def programs(self):
        """Numbers of the processes that run a part of this study, by the folder they were told."""
        found = []
        for entry in Path("/proc").iterdir():
            if not entry.name.isdigit():
                continue
            try:
                words = (entry / "cmdline").read_bytes().split(b"\0")
            except OSError:
                continue
            if words[0] == os.fsencode(self.program) and os.fsencode(self.folder / "run") in words:
                found.append(int(entry.name))
        return found

    def wait_for_rows(self):
        journals = self.folder / "run" / "journal"
        self.slurm.wait_until(lambda: any(path.stat().st_size > 4000 for path in journals.glob("*.jrnl")), "rows", 60)

    def end(self):
        """The digest, and what it is of one process; the rows that were lost."""
        log = (self.folder / "run.slurm" / "merge.log").read_text()
        merged = re.search(r"^digest (\w{16})$", log, re.M)
        assert merged, f"{self.name}: {log}"
        alone = re.search(r"^digest (\w{16})$", self.call("run", "study.toml", "-q", "--no-replay", "-o", "whole").stdout, re.M)
        verified = self.call("verify", "run").stdout
        rows = int(re.search(r"journal rows: (\d+)", verified).group(1))
        assert merged.group(1) == alone.group(1), (merged.group(1), alone.group(1))
        assert rows >= self.count, verified
        shutil.rmtree(self.folder)
        return f"digest equal, rows lost: 0 of {self.count}"


def killed(trial):
    """A task's program is killed: the others go on, merge names what is missing, the same jobs end it."""
    _, merge = trial.submit()
    trial.wait_for_rows()
    victims = trial.programs()
    os.kill(victims[0], signal.SIGKILL)
    trial.slurm.wait_for_jobs()
    states = dict(trial.slurm.jobs())
    log = (trial.folder / "run.slurm" / "merge.log").read_text()
    assert "scenarios are missing" in log and states[merge] == "FAILED", (log, states)
    subprocess.run([trial.folder / "run.slurm" / "submit.sh"], env=trial.slurm.environment, check=True, capture_output=True)
    trial.slurm.wait_for_jobs()
    return "1 task of 4 killed, its jobs handed in again"


def requeued(trial):
    """A running task is put back into the queue: the merge waits for it."""
    array, _ = trial.submit()
    trial.wait_for_rows()
    trial.slurm.say("scontrol", "requeue", f"{array}_1")
    trial.slurm.wait_for_jobs()
    return "1 task of 4 requeued while it ran"


def limit(trial):
    """Tasks are told a minute before their limit, stop, and put themselves back into the queue."""
    array, _ = trial.submit()
    trial.slurm.wait_for_jobs(900)
    logs = "".join(path.read_text() for path in (trial.folder / "run.slurm").glob("task_*.log"))
    stopped = logs.count("stopping; once more ends at once")
    restarts = trial.slurm.restarts(array)
    assert stopped > 0 and restarts > 0, (restarts, logs)
    return f"{stopped} times told of the time limit, {restarts} times put back into the queue"


def drained(trial):
    """The node is said to be down in mid-run, and comes back: Slurm ends its tasks and puts them back."""
    array, _ = trial.submit()
    trial.wait_for_rows()
    slurm = trial.slurm
    running = len(slurm.jobs("RUNNING"))
    slurm.say("scontrol", "update", f"nodename={slurm.host}", "state=down", "reason=test")
    slurm.wait_until(lambda: not trial.programs(), "the end of all tasks", 90)
    slurm.say("scontrol", "update", f"nodename={slurm.host}", "state=resume", check=False)  # it may be back by itself
    slurm.wait_for_jobs(400)
    restarts = slurm.restarts(array)
    assert restarts > 0, slurm.logs()
    return f"the node set down under {running} tasks, {restarts} put back into the queue"


def lost(trial):
    """The node is gone from one moment to the next, all that ran on it too; it is started again when Slurm has seen that."""
    array, _ = trial.submit()
    trial.wait_for_rows()
    slurm, victims = trial.slurm, trial.programs()
    assert victims
    slurm.lose_node(victims)
    slurm.start_node()
    slurm.wait_for_jobs(400)
    restarts = slurm.restarts(array)
    assert restarts > 0, slurm.logs()
    return f"the node lost with {len(victims)} tasks, {restarts} put back into the queue"


TRIALS = {"killed": (killed, 60, 240, ()), "requeued": (requeued, 60, 240, ()), "drained": (drained, 60, 240, ()),
          "lost": (lost, 60, 240, ()), "limit": (limit, 1000, None, ("--time", "2"))}


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("program", type=Path)
    parser.add_argument("--figures", type=Path)
    parser.add_argument("names", nargs="*")
    words = parser.parse_args()
    if missing():
        print(f"skipped: {', '.join(missing())} not here (scripts/setup --heavy)")
        return 77
    lines = []
    with Slurm(cpus=2) as slurm:
        for name in words.names or TRIALS:
            trial_of, seconds, count, options = TRIALS[name]
            start, program = time.monotonic(), str(words.program.resolve())
            trial = Trial(program, slurm, name, seconds, count or scenarios_of(program, seconds, TASK_S), options)
            what = trial_of(trial)
            lines.append(f"slurm, {name}: {what}; {trial.end()}; {time.monotonic() - start:.0f} s")
            print(lines[-1], flush=True)
    if words.figures:
        words.figures.parent.mkdir(parents=True, exist_ok=True)
        words.figures.write_text("\n".join(lines) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
