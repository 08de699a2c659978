"""mypy sees the types of the package as its users' programs use them: no mistake in the examples, and one where there is one.

usage: types_test.py SOURCE CACHE
"""
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

SOURCE, CACHE = Path(sys.argv[1]), sys.argv[2]
SKIPPED = 77
WRONG = """
import unbruised as ub

study = ub.load(17)
study.run(threads="two")
results: int = study.run("folder")
"""


def mypy(*files):
    """What mypy says of these, and whether it found a mistake."""
    done = subprocess.run(["mypy", "--cache-dir", CACHE, "--ignore-missing-imports", *map(str, files)], capture_output=True, text=True,
                          check=False, env={**os.environ, "MYPYPATH": str(SOURCE / "python")})
    return done.returncode, done.stdout + done.stderr


def main():
    """Right programs, then a wrong one."""
    if shutil.which("mypy") is None:
        print("mypy is not installed: types were not checked")
        return SKIPPED
    status, said = mypy(*sorted((SOURCE / "examples").glob("*.py")))
    assert status == 0, said
    with tempfile.TemporaryDirectory() as folder:
        wrong = Path(folder) / "wrong.py"
        wrong.write_text(WRONG)
        status, said = mypy(wrong)
    assert status == 1 and said.count("wrong.py:") == 3, said
    return 0


if __name__ == "__main__":
    sys.exit(main())
