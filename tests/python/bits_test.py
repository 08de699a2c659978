"""Same bits as the command line."""
import unittest

import h5py
import numpy as np
import pandas as pd
from studies import StudyTest

import unbruised as ub


class SameBits(StudyTest):
    def test_a_run_is_the_program_s_own(self):
        results = ub.load(self.masses).run(self.folder / "python", threads=2)
        self.call("run", self.masses, "-q", "--no-replay", "-o", "program")
        theirs = ub.open_results(self.folder / "program")
        self.assertTrue(results.complete)
        self.assertEqual(self.digest_in(self.call("info", "python")), self.digest_in(self.call("info", "program")))
        for name, column in results.scenarios.items():
            other = theirs.scenarios[name]
            self.assertEqual(column.dtype, other.dtype)
            same = column.values.tobytes() == other.values.tobytes() if column.dtype != object else (column.values == other.values).all()
            self.assertTrue(same, name)
        self.assertEqual(self.digest_in(self.call("verify", "python")), self.digest_in(self.call("info", "program")))

    def test_each_row_of_evaluate_is_a_run_with_set(self):
        study = ub.load(self.block)
        time_step_s = study.check()["time_step_s"]
        rows = [{"strategy.grip_force_N": force, "product.friction": friction} for force in (0.7, 1.5, 4.0) for friction in (0.4, 0.6)]
        table = study.evaluate(rows, threads=2)
        self.assertEqual(len(set(table.digest.values)), len(rows))
        text = self.block.read_text().split("[[vary]]", maxsplit=1)[0].replace('"sweep"', '"simulate"')
        (self.folder / "single.toml").write_text(text)
        for row, values in enumerate(rows):
            sets = [word for key, value in values.items() for word in ("--set", f"{key}={value!r}")]
            self.call("run", "single.toml", "-q", "--no-replay", "-o", f"single{row}", *sets, "--set", f"simulation.time_step_s={time_step_s!r}")
            with h5py.File(self.folder / f"single{row}/results.h5") as file:
                self.assertEqual(int(file["scenarios/digest"][0]), int(table.digest[row]), values)
                for name, column in file["scenarios/metric"].items():
                    self.assertEqual(column[...].tobytes(), table[name].values[row:row + 1].tobytes(), f"{name} of {values}")

    def test_neighbours_order_and_threads_change_nothing(self):
        study = ub.load(self.block)
        forces = np.linspace(0.8, 5.0, 21)
        frame = pd.DataFrame({"strategy.grip_force_N": forces})
        all_at_once = study.evaluate(frame, threads=2)
        backwards = study.evaluate(frame[::-1], threads=1)
        self.assertEqual(all_at_once.digest.values.tolist(), backwards.digest.values[::-1].tolist())
        alone = study.simulate({"strategy.grip_force_N": forces[7]})
        self.assertEqual(alone.digest, f"{int(all_at_once.digest[7]):016x}")
        self.assertEqual(alone.attrs["peak_finger_force_N"], float(all_at_once.peak_finger_force_N[7]))

    def test_a_scenario_of_the_study_is_the_recorded_one_and_has_its_trace(self):
        self.call("run", self.block, "-q", "--no-replay", "-o", "block")
        recorded = ub.open_results(self.folder / "block").scenarios
        self.call("run", self.block, "-q", "--no-replay", "-o", "block", "--scenario", "4", "--full-trace")
        trace = ub.simulate(self.block, scenario=4, motion=True)
        self.assertEqual(trace.digest, f"{int(recorded.digest[4]):016x}")
        with h5py.File(self.folder / "block/scenario_4.h5") as file:
            for name in ("time_s", "displacement_m", "finger_force_N", "support_force_N"):
                self.assertEqual(file["trace"][name][...].tobytes(), np.ascontiguousarray(trace[name].values).tobytes(), name)
                self.assertEqual(file["trace"][name].attrs["units"], trace[name].attrs["units"].encode() if isinstance(file["trace"][name].attrs["units"], bytes)
                                 else trace[name].attrs["units"])


if __name__ == "__main__":
    unittest.main()
