#!/usr/bin/env python3
"""Lets every call that changes a file of a run directory fail once: of a run, of a compaction and of a resume.

After each: `info`, `verify` and a resume in fresh processes. Nothing acknowledged may be missing, and the digest is that
of an undisturbed run (SQLite's method: the Nth call fails, for all N).
"""

import shutil

import trials

FAULTS = ["kill", "torn", "full", "quota", "eio", "denied"]


class Path:
    """One of the ways into a run directory, and the run that a resume makes of it."""

    def __init__(self, name, words, template, run_words, digest):
        self.name, self.words, self.template = name, words, template
        self.run_words, self.digest = run_words, digest

    def prepare(self, directory):
        if self.template:
            shutil.copytree(self.template, directory)


class FaultPoints:
    def __init__(self, program, folder, figures):
        self.program, self.folder, self.figures = program, folder, figures
        run, digest = self.reference("sweep")
        search, search_digest = self.reference("optimize")
        self.paths = [Path("run", run, None, run, digest),
                      Path("compaction", ["info", "DIR"], self.half_done("sweep", "half", 40), run, digest),
                      Path("resume", run, self.half_done("sweep", "resumed", 20), run, digest),
                      Path("search", search, None, search, search_digest)]

    def reference(self, kind):
        """The words that run the small study of a kind, and the digest of an undisturbed run."""
        words = ["run", *trials.words_of(kind), "--output", "DIR", "--threads", "1", "--quiet"]
        answer = self.call(words, self.folder / kind)
        assert answer.status == 0, answer.err
        return words, answer.digest

    def call(self, words, directory, **how):
        return self.program.call(*[directory if word == "DIR" else word for word in words], **how)

    def half_done(self, kind, name, rows):
        """A directory as a kill leaves it: a journal of so many scenarios, no results."""
        directory = self.folder / name
        shutil.copytree(self.folder / kind, directory)
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
        self.judge_afterwards(name, path, directory, len(kept))
        shutil.rmtree(directory, ignore_errors=True)
        log.unlink(missing_ok=True)

    def judge_fault(self, name, kind, answer):
        self.figures.expect(not answer.crashed, f"{name}: crashed: {answer.status} {answer.err}")
        if kind in ("full", "quota", "eio", "denied"):
            # 0: the call did not matter, as that of a line in the log; info goes without compaction.
            self.figures.expect(answer.status in (0, 5), f"{name}: status {answer.status}: {answer.err}")
            self.figures.expect(answer.status == 0 or str(self.folder) in answer.err, f"{name}: no path: {answer.err}")

    def judge_afterwards(self, name, path, directory, kept):
        for command in ("info", "verify"):
            answer = self.program.call(command, directory)
            allowed = (0,) if kept else (0, 2)  # 2: killed before there was a run directory
            self.figures.expect(answer.status in allowed, f"{name}: {command}: {answer.status} {answer.err}")
        answer = self.call(path.run_words, directory)
        if answer.status == 2 and "finished" in answer.err:
            answer = self.program.call("info", directory)
        else:
            found = trials.found_scenarios(answer)
            self.figures.expect(found >= kept, f"{name}: resume found {found} of {kept}: {answer.err}")
        self.figures.expect(answer.status == 0, f"{name}: resume: {answer.status} {answer.err}")
        if not self.figures.expect(answer.digest == path.digest, f"{name}: digest {answer.digest}"):
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
    calls = ", ".join(f"{figures[f'calls of {path.name}']} of a {path.name}" for path in points.paths)
    kinds = ", ".join(f"{kind} {figures[kind]}" for kind in faults)
    figures.finish(f"fault points: {len(items)} (calls: {calls}; faults: {kinds}): {figures['acknowledged']} acknowledged "
                   f"scenarios, {figures['lost']} lost, {figures['changed digests']} changed digests")


if __name__ == "__main__":
    main()
