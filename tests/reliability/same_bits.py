#!/usr/bin/env python3
"""Digests of every study kind and of a whole cell for 1, 2, 4 and 8 threads, and the replay of rows alone by their
number: the same bits."""

import random
import re
import shlex

import trials

ROWS_OF_A_KIND = 4


class SameBits:
    def __init__(self, program, folder, figures, thread_counts):
        self.program, self.folder, self.figures = program, folder, figures
        self.thread_counts = thread_counts

    def kind(self, kind):
        digests = {}
        for threads in self.thread_counts:
            answer = self.program.run(kind, self.folder / f"{kind}_{threads}", "--threads", threads)
            if not self.figures.expect(answer.status in (0, 3), f"{kind}: {answer.status} {answer.err}"):
                return
            digests[threads] = answer.digest
            self.figures.add("runs")
        if not self.figures.expect(len(set(digests.values())) == 1, f"{kind}: {digests}"):
            self.figures.add("changed digests")
        self.replay(kind, self.folder / f"{kind}_{self.thread_counts[0]}")

    def replay(self, kind, directory):
        """The rows whose replay `info` prints, by its words, and some others by their number."""
        info = self.program.call("info", directory)
        printed = [line.strip() for line in info.out.splitlines() if " --scenario " in line]
        commands = [shlex.split(line[line.index(self.program.path):], comments=True)[1:] for line in printed]
        count = int(re.search(r"([\d,]+) scenarios?", info.out).group(1).replace(",", ""))
        dice = random.Random(kind)
        for number in sorted(dice.sample(range(count), min(ROWS_OF_A_KIND, count))):
            commands.append(["run", str(directory / "config.toml"), "--output", str(directory), "--scenario", str(number)])
        for words in commands:
            answer = self.program.call(*words)
            self.figures.add("replays")
            same = answer.status in (0, 3) and "same bits as the recorded row" in answer.err
            if not self.figures.expect(same, f"{kind}: {' '.join(words)}: {answer.status} {answer.err}"):
                self.figures.add("other bits")


def main():
    options = trials.arguments(__doc__)
    figures = trials.Figures(options.figures)
    kinds = ["sweep", "optimize"] if options.quick else [*trials.KINDS, *trials.CELLS]
    with trials.Folder() as folder:
        bits = SameBits(trials.Program(options.program, options.shim), folder, figures,
                        ["2", "1"] if options.quick else ["8", "1", "2", "4"])
        trials.in_parallel(bits.kind, kinds)
    figures.finish(f"same bits: {figures['runs']} runs of {len(kinds)} studies on {', '.join(bits.thread_counts)} threads: "
                   f"{figures['changed digests']} changed digests; {figures['replays']} rows replayed alone: "
                   f"{figures['other bits']} with other bits")


if __name__ == "__main__":
    main()
