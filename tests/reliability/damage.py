#!/usr/bin/env python3
"""Truncates files of run directories and flips bits in them, finished and unfinished runs: nothing crashes, nothing
wrong is said without a word, and a run that goes on ends with the digest of an undisturbed one.
"""

import random
import shutil

import trials

WORDS_OF_DAMAGE = ("damage", "checksum", "unfinished record", "not match", "another config", "cannot", "not an HDF5",
                   "not one of unbruised", "format version", "no run directory", "not a run directory")


def names_damage(answer):
    return any(word in answer.out + answer.err for word in WORDS_OF_DAMAGE)


class Damage:
    def __init__(self, program, folder, figures):
        self.program, self.folder, self.figures = program, folder, figures
        self.digest = {}
        self.templates = []

    def prepare(self, kind):
        directory = self.folder / f"{kind}_finished"
        answer = self.program.run(kind, directory)
        assert answer.status in (0, 3), answer.err
        self.digest[kind] = answer.digest
        self.templates.append((kind, True, directory))
        half = self.folder / f"{kind}_unfinished"
        shutil.copytree(directory, half)
        journal = trials.journals(half)[0]
        data = journal.read_bytes()
        journal.write_bytes(data[:trials.boundary(data, max(1, len(trials.scenarios(data)) // 2))])
        for path in half.glob("results.h5*"):
            path.unlink()
        self.program.call("info", half)  # writes an unfinished results.h5
        self.templates.append((kind, False, half))

    def trial(self, seed):
        dice = random.Random(seed)
        kind, finished, template = dice.choice(self.templates)
        directory = self.folder / f"trial_{seed}"
        shutil.copytree(template, directory)
        journal = trials.journals(directory)[0]
        choices = [journal, journal, directory / "config.toml"]
        if (directory / "results.h5").exists():  # a study of one scenario has none before its end
            choices += [directory / "results.h5", directory / "results.h5", directory / "results.h5.sha256"]
        path = dice.choice(choices)
        data = bytearray(path.read_bytes())
        if dice.random() < 0.35:
            del data[dice.randrange(len(data)):]
            self.figures.add("truncations")
        else:
            data[dice.randrange(len(data))] ^= 1 << dice.randrange(8)
            self.figures.add("bit flips")
        # A journal cut between two records is that of a run that was stopped earlier; nothing is wrong with it.
        clean = path.suffix == ".jrnl" and trials.ends_whole(bytes(data))
        path.write_bytes(data)
        name = f"trial {seed}: {kind}, {'finished' if finished else 'unfinished'}, {path.name}"
        self.judge(name, kind, finished, clean, directory)
        shutil.rmtree(directory, ignore_errors=True)

    def judge(self, name, kind, finished, clean, directory):
        info, verify = self.program.call("info", directory), self.program.call("verify", directory)
        again = self.program.run(kind, directory)
        for command, answer in (("info", info), ("verify", verify), ("run", again)):
            if not self.figures.expect(not answer.crashed, f"{name}: {command}: {answer.status} {answer.err}"):
                self.figures.add("crashes")
        for answer in (info, verify, again):
            self.figures.add("found") if names_damage(answer) else None
        silent = []
        if not clean and not (names_damage(verify) or verify.status != 0):
            silent.append(f"verify: {verify.out}")
        if info.status == 0 and finished and info.digest != self.digest[kind]:
            silent.append(f"info: digest {info.digest}")
        if again.status in (0, 3) and again.digest != self.digest[kind]:
            silent.append(f"run: digest {again.digest}")
        if again.status not in (0, 2, 3):
            silent.append(f"run: {again.status} {again.err}")
        for what in silent:
            self.figures.add("silent errors")
            self.figures.expect(False, f"{name}: {what}")
        if again.status in (0, 3):
            self.figures.add("continued to the same digest")
        else:
            self.figures.add("refused with a reason")


def main():
    options = trials.arguments(__doc__)
    figures = trials.Figures(options.figures)
    count = 12 if options.quick else 300
    with trials.Folder() as folder:
        damage = Damage(trials.Program(options.program, options.shim), folder, figures)
        for kind in ["sweep"] if options.quick else ["sweep", "optimize", "simulate", "window", "robust"]:
            damage.prepare(kind)
        trials.in_parallel(damage.trial, range(options.seed, options.seed + count))
    figures.finish(
        f"damage: {figures['truncations']} truncations and {figures['bit flips']} bit flips of journals, results, hashes and "
        f"configs: {figures['crashes']} crashes, {figures['silent errors']} silent errors; "
        f"{figures['continued to the same digest']} continued to the same digest, "
        f"{figures['refused with a reason']} refused with a reason")


if __name__ == "__main__":
    main()
