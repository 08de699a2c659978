#!/usr/bin/env python3
"""Two processes started on one run at the same moment: one runs it, the other says who and ends with 4."""

import trials

STUDY = str(trials.HERE / "studies/sweep.toml")


def main():
    options = trials.arguments(__doc__)
    figures = trials.Figures(options.figures)
    program = trials.Program(options.program, options.shim)
    rounds = 5 if options.quick else 100
    with trials.Folder() as folder:
        # Some tenths of a second of work, so that the second always comes while the first runs.
        words = ["run", STUDY, "--threads", "1", "--quiet", "--set", "simulation.duration_s=150.0", "--output"]
        digest = program.call(*words, folder / "whole").digest
        for number in range(rounds):
            directory = folder / str(number)
            children = [program.start(*words, directory) for _ in range(2)]
            answers = []
            for child in children:
                out, err = child.communicate(timeout=300)
                answers.append(trials.Answer(child.returncode, out, err))
            name = f"round {number}"
            statuses = sorted(answer.status for answer in answers)
            figures.expect(statuses == [0, 4], f"{name}: {statuses} {[answer.err for answer in answers]}")
            for child, answer in zip(children, answers):
                other = children[1 - children.index(child)]
                if answer.status == 4:
                    figures.add("refused")
                    figures.expect(f"pid = {other.pid}" in answer.err, f"{name}: holder not named: {answer.err}")
                elif answer.status == 0:
                    figures.expect(answer.digest == digest, f"{name}: digest {answer.digest}")
            rows = [number for path in trials.journals(directory) for number in trials.scenarios(path.read_bytes())]
            if not figures.expect(len(rows) == len(set(rows)) == 40, f"{name}: {len(rows)} rows"):
                figures.add("double runs")
    figures.finish(f"two processes on one run: {rounds} times, {figures['refused']} refused with status 4 and the holder's "
                   f"name, {figures['double runs']} double runs")


if __name__ == "__main__":
    main()
