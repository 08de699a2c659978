"""Small studies for the tests, and the program to compare with."""
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent))
from small_studies import masses  # pylint: disable=wrong-import-position

PROGRAM, SOURCE = os.environ["UNBRUISED_PROGRAM"], Path(os.environ["UNBRUISED_SOURCE"])

BLOCK = """[study]
name = "block"
kind = "sweep"
[product]
shape = "box"
size_m = [0.04, 0.04, 0.04]
cell_size_m = 0.02
mass_kg = 0.1
youngs_modulus_Pa = 1e6
yield_stress_Pa = 1e5
tangent_modulus_Pa = 1e5
relaxation_time_s = 1e-3
friction = 0.5
[limits]
contact_yield_ratio = 1.0
[gripper]
use = "grippers/parallel_jaw.toml"
[[vary]]
key = "strategy.grip_force_N"
values = [1.0, 2.0, 3.0]
[[vary]]
key = "strategy.approach_speed_m_s"
values = [0.05, 0.2]
"""


class StudyTest(unittest.TestCase):
    """A folder of its own with both studies; what is shipped is found in the source tree."""

    def setUp(self):
        place = tempfile.TemporaryDirectory(prefix="unbruised-python-")  # pylint: disable=consider-using-with
        self.addCleanup(place.cleanup)
        self.folder = Path(place.name)
        os.environ["UNBRUISED_CONFIGS"] = str(SOURCE / "configs")
        self.masses, self.block = self.folder / "masses.toml", self.folder / "block.toml"
        self.masses.write_text(masses(1.0, 40))
        self.block.write_text(BLOCK)

    def call(self, *words):
        """What the program says on stdout."""
        done = subprocess.run([PROGRAM, *map(str, words)], cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    @staticmethod
    def digest_in(text):
        return re.search(r"^digest (\w{16})$", text, re.M).group(1)
