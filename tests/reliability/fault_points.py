#!/usr/bin/env python3
"""Lets every call that changes a file of a run directory fail once: of a run, of a compaction and of a resume.

After each: `info`, `verify` and a resume in fresh processes. Nothing acknowledged may be missing, and the digest is that
of an undisturbed run (SQLite's method: the Nth call fails, for all N).
"""

import shutil

import trials

STUDY = str(trials.HERE / "studies/sweep.toml")
FAULTS = ["kill", "torn", "full", "eio", "denied"]


class Path:
    """One of the ways into a run directory."""

    def __init__(self, name, words, template):
        self.name, self.words, self.template = name, words, template

    def prepare(self, directory):
        if self.template:
            shutil.copytree(self.template, directory)

    def command(self, directory):
        return [directory if word == "DIR" else word for word in self.words]


class FaultPoints:
    def __init__(self, program, folder, figures):
        self.program, self.folder, self.figures = program, folder, figures
        self.run_words = ["run", STUDY, "--output", "DIR", "--threads", "1", "--quiet"]
        whole = folder / "whole"
        answer = self.call(self.run_words, whole)
        assert answer.status == 0, answer.err
        self.digest = answer.digest
        self.paths = [Path("run", self.run_words, None),
                      Path("compaction", ["info", "DIR"], self.half_done(whole, "half", 40)),
                      Path("resume", self.run_words, self.half_done(whole, "resumed", 20))]

    def call(self, words, directory, **how):
        return self.program.call(*[directory if word == "DIR" else word for word in words], **how)

    def half_done(self, whole, name, rows):
        """A directory as a kill leaves it: a journal of so many scenarios, no results."""
        directory = self.folder / name
        shutil.copytree(whole, directory)
        for path in directory.glob("results.h5*"):
            path.unlink()
        journal = trials.journals(directory)[0]
        data = journal.read_bytes()
        journal.write_bytes(data[:trials.boundary(data, rows)])
        return directory

    def count_calls(self, path):
        directory, log = self.folder / f"count_{path.name}", self.folder / f"count_{path.name}.log"
        path.prepare(directory)
        self.call(path.words, directory, fault=trials.fault(directory, 0, "", log))
        return trials.acknowledged(log)[1]

    def trial(self, item):
        path, kind, at = item
        name = f"{path.name}_{kind}_{at}"
        directory, log = self.folder / name, self.folder / f"{name}.log"
        path.prepare(directory)
        before = trials.recorded(directory)
        answer = self.call(path.words, directory, fault=trials.fault(directory, at, kind, log))
        self.figures.add(kind)
        self.figures.add(path.name)
        self.judge_fault(name, kind, answer)
        kept = {**before, **trials.acknowledged_scenarios(trials.acknowledged(log)[0])}
        self.figures.add("acknowledged", len(kept))
        lost = [number for number, row in kept.items() if trials.recorded(directory).get(number) != row]
        self.figures.add("lost", len(lost))
        self.figures.expect(not lost, f"{name}: lost {lost}")
        self.judge_afterwards(name, directory, len(kept))
        shutil.rmtree(directory, ignore_errors=True)
        log.unlink(missing_ok=True)

    def judge_fault(self, name, kind, answer):
        self.figures.expect(not answer.crashed, f"{name}: crashed: {answer.status} {answer.err}")
        if kind in ("full", "eio", "denied"):
            # 0: the call did not matter, as that of a line in the log; info goes without compaction.
            self.figures.expect(answer.status in (0, 5), f"{name}: status {answer.status}: {answer.err}")
            self.figures.expect(answer.status == 0 or str(self.folder) in answer.err, f"{name}: no path: {answer.err}")

    def judge_afterwards(self, name, directory, kept):
        for command in ("info", "verify"):
            answer = self.program.call(command, directory)
            allowed = (0,) if kept else (0, 2)  # 2: killed before there was a run directory
            self.figures.expect(answer.status in allowed, f"{name}: {command}: {answer.status} {answer.err}")
        answer = self.call(self.run_words, directory)
        if answer.status == 2 and "finished" in answer.err:
            answer = self.program.call("info", directory)
        else:
            found = trials.found_scenarios(answer)
            self.figures.expect(found >= kept, f"{name}: resume found {found} of {kept}: {answer.err}")
        self.figures.expect(answer.status == 0, f"{name}: resume: {answer.status} {answer.err}")
        if not self.figures.expect(answer.digest == self.digest, f"{name}: digest {answer.digest}"):
            self.figures.add("changed digests")


def main():
    options = trials.arguments(__doc__)
    figures = trials.Figures(options.figures)
    with trials.Folder() as folder:
        points = FaultPoints(trials.Program(options.program, options.shim), folder, figures)
        items = []
        for path in points.paths:
            count = points.count_calls(path) + 2  # threads and times differ a little: two beyond the end
            figures.add(f"calls of {path.name}", count - 2)
            chosen = [1, count // 4, count // 2, count - 3] if options.quick else range(1, count + 1)
            faults = ["kill", "full"] if options.quick else FAULTS
            items += [(path, kind, at) for kind in faults for at in chosen]
        trials.in_parallel(points.trial, items)
    figures.finish(
        f"fault points: {len(items)} ({figures['calls of run']} calls of a run, {figures['calls of compaction']} of a "
        f"compaction, {figures['calls of resume']} of a resume; kill {figures['kill']}, torn {figures['torn']}, disk full "
        f"{figures['full']}, I/O error {figures['eio']}, denied {figures['denied']}): {figures['acknowledged']} acknowledged scenarios, "
        f"{figures['lost']} lost, {figures['changed digests']} changed digests")


if __name__ == "__main__":
    main()
