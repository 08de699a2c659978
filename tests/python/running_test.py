"""Progress, Ctrl-C, other threads, results as tables."""
import os
import re
import signal
import subprocess
import sys
import threading
import time
import unittest

import numpy as np
from studies import StudyTest

import unbruised as ub

RUN = """
import sys, unbruised as ub
try:
    ub.load(sys.argv[1], {"simulation.duration_s": 600.0}).run("run", threads=1, progress=lambda now: print(now.done, flush=True))
except KeyboardInterrupt:
    print("interrupted")
"""


class Running(StudyTest):
    def test_progress_ends_with_all(self):
        seen = []
        ub.load(self.masses, {"simulation.duration_s": 50.0}).run(self.folder / "run", progress=seen.append)
        self.assertEqual((seen[-1].done, seen[-1].total), (40, 40))
        self.assertIn("40 of 40 scenarios", seen[-1].text)
        self.assertEqual(sorted(now.done for now in seen), [now.done for now in seen])

    def test_what_progress_raises_stops_the_run_and_the_same_call_goes_on(self):
        study = ub.load(self.masses, {"simulation.duration_s": 300.0})

        def stop(now):
            if now.done > 0:
                raise RuntimeError("enough")

        with self.assertRaisesRegex(RuntimeError, "enough"):
            study.run(self.folder / "run", threads=1, progress=stop)
        self.assertFalse(ub.open_results(self.folder / "run").complete)
        self.assertTrue(study.run(self.folder / "run").complete)

    def test_ctrl_c_leaves_all_that_was_run(self):
        with subprocess.Popen([sys.executable, "-c", RUN, str(self.masses)], cwd=self.folder, stdout=subprocess.PIPE, text=True,
                              env=os.environ) as child:
            for line in child.stdout:
                if int(line) > 0:
                    break
            child.send_signal(signal.SIGINT)
            rest = child.stdout.read()
        self.assertEqual(child.returncode, 0)
        self.assertTrue(rest.rstrip().endswith("interrupted"), rest)
        rows = int(re.search(r"journal rows: (\d+)", self.call("verify", "run")).group(1))
        self.assertGreater(rows, 0)
        self.assertLess(rows, 40)

    def test_other_threads_go_on_meanwhile(self):
        counted, stop = [0], threading.Event()

        def count():
            while not stop.is_set():
                counted[0] += 1
                time.sleep(0.005)

        thread = threading.Thread(target=count)
        thread.start()
        before, start = counted[0], time.monotonic()
        ub.evaluate(self.masses, [{"simulation.duration_s": 300.0}] * 8, threads=1)
        took = time.monotonic() - start
        stop.set()
        thread.join()
        self.assertGreater(took, 0.05, "too quick to see anything")
        self.assertGreater(counted[0] - before, took / 0.005 / 20)

    def test_results_are_tables(self):
        results = ub.load(self.block).run(self.folder / "run")
        self.assertIn("block", repr(results))
        frame = results.to_dataframe()
        self.assertEqual(len(frame), 6)
        self.assertEqual(set(frame["strategy.grip_force_N"]), {1.0, 2.0, 3.0})
        self.assertEqual(results.scenarios.cycle_time_s.attrs["units"], "s")
        self.assertIn("window", results.tables)
        self.assertEqual(len(results.table("window")), 2)
        # Finished is finished: the same call gives what is there.
        self.assertEqual(results.scenarios.digest.values.tolist(), ub.load(self.block).run(self.folder / "run").scenarios.digest.values.tolist())

    def test_an_empty_list_is_an_empty_table(self):
        table = ub.evaluate(self.block, [])
        self.assertEqual(table.sizes["scenario"], 0)
        self.assertEqual(table.cycle_time_s.dtype, np.float64)


if __name__ == "__main__":
    unittest.main()
