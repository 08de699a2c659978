"""Mistakes are exceptions that say where."""
import unittest

from studies import StudyTest

import unbruised as ub


class Errors(StudyTest):
    def test_a_study_s_problems_have_file_line_key_and_rule(self):
        text = self.masses.read_text().replace("mass_kg = 2.0", "mass_kg = -2.0").replace("duration_s = 1.0", "duration_m = 1.0")
        self.masses.write_text(text)
        with self.assertRaises(ub.ConfigError) as caught:
            ub.load(self.masses)
        problems = {problem.key: problem for problem in caught.exception.problems}
        mass = problems["product.particle[1].mass_kg"]
        self.assertEqual((mass.file, mass.line, mass.value), (str(self.masses), 11, "-2.0"))
        self.assertTrue(mass.rule.startswith("must be"), mass)
        self.assertIn("did you mean", problems["simulation.duration_m"].rule)
        self.assertIsInstance(caught.exception, ValueError)
        self.assertEqual(caught.exception.file, str(self.masses))

    def test_what_is_set_from_python_has_no_file(self):
        study = ub.load(self.block)
        study.strategy.grip_force_N = -1.0
        with self.assertRaises(ub.ConfigError) as caught:
            study.check()
        self.assertEqual((caught.exception.file, caught.exception.key), (None, "strategy.grip_force_N"))

    def test_the_row_that_is_wrong_is_named(self):
        with self.assertRaises(ub.ConfigError) as caught:
            ub.evaluate(self.block, [{"strategy.grip_force_N": 1.0}, {"strategy.grip_force_N": 0.0}, {"no.such_key": 1.0}])
        self.assertEqual((caught.exception.row, caught.exception.key), (1, "strategy.grip_force_N"))
        self.assertIn("row 1", str(caught.exception))

    def test_a_run_directory_of_another_study_is_refused(self):
        study = ub.load(self.masses)
        study.run(self.folder / "run")
        study.set({"product.particle[1].mass_kg": 3.0})
        with self.assertRaises(ub.RunError) as caught:
            study.run(self.folder / "run")
        self.assertEqual(caught.exception.kind, "other_config")
        self.assertIn("mass_kg", str(caught.exception))
        self.assertTrue(study.run(self.folder / "run", fresh=True).complete)

    def test_scenarios_that_are_not_there_are_refused(self):
        with self.assertRaisesRegex(ValueError, "0 to 5"):
            ub.simulate(self.block, scenario=6)
        with self.assertRaises(ub.ConfigError):
            ub.load(self.folder / "nowhere.toml")


if __name__ == "__main__":
    unittest.main()
