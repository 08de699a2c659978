#!/usr/bin/env python3
"""kill -9 at seeded random moments over all study kinds, in chains: killed, continued, killed again, finished.

Half of the kills are power cuts too: of each journal what no successful fdatasync covered is cut off or overwritten.
Some runs are stopped by SIGINT or SIGTERM instead. After each stop every acknowledged scenario stands in the journals,
and every chain ends with the digest of an undisturbed run.
"""

import random
import signal
import time

import trials

STOPS_OF_A_CHAIN = 6


class RandomKills:
    def __init__(self, program, folder, figures):
        self.program, self.folder, self.figures = program, folder, figures
        self.digest, self.seconds = {}, {}

    def reference(self, kind):
        begin = time.monotonic()
        answer = self.program.run(kind, self.folder / kind, "--threads", "1")
        self.seconds[kind] = time.monotonic() - begin
        assert answer.status in (0, 3), f"{kind}: {answer.status} {answer.err}"
        self.digest[kind] = answer.digest

    def chain(self, item):
        kind, seed = item
        dice = random.Random(f"{kind} {seed}")
        directory, log = self.folder / f"{kind}_{seed}", self.folder / f"{kind}_{seed}.log"
        kept = {}
        for link in range(STOPS_OF_A_CHAIN):
            name = f"{kind} chain {seed} link {link}"
            if self.stopped(name, kind, directory, log, dice) is None:
                break
            kept.update(trials.acknowledged_scenarios(trials.acknowledged(log)[0]))
            there = trials.recorded(directory)
            lost = [number for number, row in kept.items() if there.get(number) != row]
            self.figures.add("lost", len(lost))
            self.figures.expect(not lost, f"{name}: lost {lost}")
            if link % 2 == 0:
                info = self.program.call("info", directory)
                allowed = (0,) if kept else (0, 2)
                if not self.figures.expect(info.status in allowed, f"{name}: info: {info.status} {info.err}"):
                    self.figures.add("unreadable")
        self.figures.add("acknowledged", len(kept))
        self.finish(f"{kind} chain {seed}", kind, directory, len(kept))

    def stopped(self, name, kind, directory, log, dice):
        """Starts the study and stops it; None: it was over before."""
        how = dice.choice([signal.SIGKILL] * 8 + [signal.SIGINT, signal.SIGTERM])
        child = self.program.start("run", *trials.words_of(kind), "--output", directory, "--threads",
                                   dice.choice("12"), "--quiet", fault=trials.fault(directory, 0, "", log),
                                   env={"UNBRUISED_COMPACTION_MS": "40"} if dice.random() < 0.3 else None)
        time.sleep(dice.uniform(0.0, 0.9 * self.seconds[kind]))
        child.send_signal(how)
        _, err = child.communicate(timeout=300)
        if child.returncode in (0, 3) or (child.returncode == 2 and "finished" in err):
            return None
        self.figures.add("kill -9" if how == signal.SIGKILL else "SIGINT, SIGTERM")
        # Before the program listens, a signal ends it as it ends any program.
        self.figures.expect(child.returncode in (-how, trials.STATUS_OF_SIGNAL + how), f"{name}: {child.returncode} {err}")
        if how == signal.SIGKILL and dice.random() < 0.5:
            self.figures.add("power cuts")
            self.cut_power(directory, log, dice)
        return child.returncode

    def cut_power(self, directory, log, dice):
        sizes, _ = trials.acknowledged(log)
        for path in trials.journals(directory):
            data = path.read_bytes()
            safe = sizes.get(str(path), 0)
            if len(data) <= safe:
                continue
            cut = dice.randint(safe, len(data))
            zeros = dice.choice([0, min(4096, len(data) - cut)])  # pages that were allotted and never written
            path.write_bytes(data[:cut] + bytes(zeros))

    def finish(self, name, kind, directory, kept):
        answer = self.program.run(kind, directory, "--threads", "2")
        if answer.status == 2 and "finished" in answer.err:
            answer = self.program.call("info", directory)
        elif kept:
            found = trials.found_scenarios(answer)
            self.figures.expect(found >= kept, f"{name}: found {found} of {kept}: {answer.err}")
        if not self.figures.expect(answer.status in (0, 3), f"{name}: end: {answer.status} {answer.err}"):
            self.figures.add("unreadable")
        if not self.figures.expect(answer.digest == self.digest[kind], f"{name}: digest {answer.digest}"):
            self.figures.add("changed digests")
        verify = self.program.call("verify", directory)
        self.figures.expect(verify.status == 0, f"{name}: verify: {verify.status} {verify.err}")
        self.figures.add("chains")


def main():
    options = trials.arguments(__doc__)
    figures = trials.Figures(options.figures)
    kinds = ["sweep", "optimize"] if options.quick else list(trials.KINDS)
    wanted = 4 if options.quick else 500
    with trials.Folder() as folder:
        kills = RandomKills(trials.Program(options.program, options.shim), folder, figures)
        trials.in_parallel(kills.reference, kinds)
        seed = options.seed
        while figures["kill -9"] < wanted and not figures.complaints:
            trials.in_parallel(kills.chain, [(kind, seed) for kind in kinds])
            seed += 1
    figures.finish(
        f"random kills: {figures['kill -9']} kill -9 ({figures['power cuts']} with a power cut) and "
        f"{figures['SIGINT, SIGTERM']} SIGINT or SIGTERM over {len(kinds)} study kinds in {figures['chains']} chains: "
        f"{figures['acknowledged']} acknowledged scenarios, {figures['lost']} lost, {figures['unreadable']} unreadable, "
        f"{figures['changed digests']} changed digests")


if __name__ == "__main__":
    main()
