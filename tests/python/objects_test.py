"""Products, grippers and tables as objects; what the stubs promise."""
import ast
import unittest
from pathlib import Path

from studies import SOURCE, StudyTest

import unbruised as ub
from unbruised import _unbruised


class Objects(StudyTest):
    def test_a_table_shows_what_is_in_use_and_takes_changes(self):
        study = ub.load(self.block)
        self.assertEqual(study.product.mass_kg, 0.1)
        self.assertEqual(study.gripper.finger_mass_kg, study.resolved["gripper"]["finger_mass_kg"])
        study.product.mass_kg = 0.2
        study.product.size_m = [0.04, 0.04, 0.06]
        self.assertEqual(study.resolved["product"]["mass_kg"], 0.2)
        self.assertEqual(study.product.size_m, [0.04, 0.04, 0.06])
        self.assertIn("kg", study.product.explain("mass_kg"))
        self.assertIn("grip_force_N", dir(study.strategy))

    def test_names_without_their_unit_are_refused_with_the_nearest(self):
        study = ub.load(self.block)
        with self.assertRaisesRegex(AttributeError, "mass_kg"):
            study.product.mass = 0.2
        with self.assertRaisesRegex(AttributeError, "its tables are"):
            study.robot = 1
        with self.assertRaises(TypeError):
            study.product = ub.Gripper("grippers/parallel_jaw.toml")

    def test_products_and_grippers_of_the_library(self):
        peach = ub.Product("products/peach.toml", friction=0.7)
        self.assertGreater(peach.youngs_modulus_Pa, 0.0)
        study = ub.load("configs/kiwi_first.toml")
        study.product = peach
        study.gripper = ub.Gripper("grippers/parallel_jaw_firm.toml", finger_mass_kg=0.25)
        resolved = study.resolved
        self.assertEqual(resolved["product"]["friction"], 0.7)
        self.assertEqual(resolved["product"]["youngs_modulus_Pa"], peach.youngs_modulus_Pa)
        self.assertEqual(resolved["gripper"]["finger_mass_kg"], 0.25)
        with self.assertRaises(FileNotFoundError):
            ub.Product("products/no_such.toml")

    def test_a_study_of_text(self):
        study = ub.Study(text=self.block.read_text())
        self.assertEqual((study.name, study.kind), ("block", "sweep"))
        self.assertEqual(study.check()["scenarios"], 6)

    def test_the_stub_names_what_the_module_has(self):
        stub = Path(ub.__file__).with_name("_unbruised.pyi").read_text(encoding="utf-8")
        said = {node.name for node in ast.parse(stub).body if isinstance(node, (ast.FunctionDef, ast.ClassDef))}
        there = {name for name in dir(_unbruised) if not name.startswith("_")}
        self.assertEqual(said, there)
        self.assertTrue(Path(ub.__file__).with_name("py.typed").is_file())

    def test_every_public_name_has_words(self):
        for name in ub.__all__:
            if name != "__version__":
                self.assertTrue(getattr(ub, name).__doc__, name)
        self.assertIn(ub.__version__, (SOURCE / "CMakeLists.txt").read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main()
