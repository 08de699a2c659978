#!/usr/bin/env python3
"""Reads a study while it runs and writes results.h5 over and over: `info`, `verify` and h5py see whole files only, and
the study does not notice."""

import trials

try:
    import h5py
except ImportError:  # the program's own readers are tried all the same
    h5py = None

STUDY = str(trials.HERE / "studies/sweep.toml")


def read_with_h5py(path, figures):
    with h5py.File(path, "r") as file:
        ids, outcomes = file["scenarios/id"][:], file["scenarios/outcome"][:]
        figures.expect(list(ids) == list(range(len(ids))), f"ids {ids}")
        figures.expect(len(outcomes) == len(ids) == len(file["scenarios/metric/step_count"][:]), "columns differ")
        figures.add("h5py")
        return int((outcomes >= 0).sum())


def main():
    options = trials.arguments(__doc__)
    figures = trials.Figures(options.figures)
    program = trials.Program(options.program, options.shim)
    duration, count = ("100.0", 80) if options.quick else ("300.0", 400)
    words = ["run", STUDY, "--threads", "1", "--quiet", "--set", f"simulation.duration_s={duration}", "--set",
             f"vary[0].count={count}", "--output"]
    with trials.Folder() as folder:
        undisturbed = program.call(*words, folder / "undisturbed")
        assert undisturbed.status == 0, undisturbed.err
        directory = folder / "read"
        child = program.start(*words, directory, env={"UNBRUISED_COMPACTION_MS": "20"})
        rows = 0
        while child.poll() is None:
            if not (directory / "results.h5").exists():
                continue
            if h5py:
                now = read_with_h5py(directory / "results.h5", figures)
                figures.expect(now >= rows, f"{now} rows after {rows}")
                rows = now
            for command in ("info", "verify"):
                answer = program.call(command, directory)
                figures.expect(answer.status == 0, f"{command}: {answer.status} {answer.err}")
                figures.add(command)
        out, err = child.communicate()
        figures.expect(child.returncode == 0, f"run: {child.returncode} {err}")
        figures.expect(trials.Answer(0, out, err).digest == undisturbed.digest, "another digest")
    figures.expect(figures["info"] > 0, "the study was over before it was read")
    figures.finish(f"readers beside a running study: {figures['h5py']} h5py, {figures['info']} info, {figures['verify']} "
                   f"verify: {len(figures.complaints)} wrong")


if __name__ == "__main__":
    main()
