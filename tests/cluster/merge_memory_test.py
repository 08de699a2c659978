"""`merge`, `info`, `report`, `verify` and a part of a study of a million scenarios: what they take of memory grows by some tens of bytes a
row, and all say the same digest.

usage: merge_memory_test.py PROGRAM [--figures FILE]
"""
import argparse
import re
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent.parent / "scripts"))
import merge_scale  # pylint: disable=wrong-import-position

FEW, MANY = 250_000, 1_000_000
# Sixteen bytes to find a row, twice while they are put into order, eight for its digest, eight for its factor group, eight for the value of
# its key; the table of free memory of the C library makes it up to twice that, and what was read at once is no smaller than a block.
BYTES_A_ROW_MOST = 250.0
# Whatever the number of rows: blocks of them, pages of results.h5, the choice on a page.
BYTES_MOST = 900e6
COMMANDS = (
    ["info", "run"],
    ["run", "study.toml", "--quiet", "-o", "run", "--shard", "1/1000000"],
    ["merge", "run", "--threads", "1", "--quiet"],
    ["info", "run"],
    ["verify", "run"],
    ["report", "run", "--no-replay"],
)


def peaks(program, rows):
    """Peak memory of each command in bytes; all that say a digest say the same."""
    found, digests = [], set()
    with tempfile.TemporaryDirectory(prefix="unbruised-merge-") as name:
        folder = Path(name)
        merge_scale.make(program, folder, rows, 20)
        for command in COMMANDS:
            _, _, peak, said = merge_scale.measured(8.0, program, *command, cwd=folder)
            found.append(peak)
            digests.update(re.findall(r"^digest (\w{16})", said, re.M))
    assert len(digests) == 1, digests
    return found


def main():
    """Measures both sizes."""
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("program", type=Path)
    parser.add_argument("--figures", type=Path)
    words = parser.parse_args()
    program = words.program.resolve()
    few, many = peaks(program, FEW), peaks(program, MANY)
    lines = []
    for command, before, after in zip(COMMANDS, few, many):
        each = (after - before) / (MANY - FEW)
        lines.append(f"{' '.join(command[:2])}: {before / 1e6:.0f} MB for {FEW:,} rows, {after / 1e6:.0f} MB for {MANY:,}, {each:.0f} bytes a row")
    print("\n".join(lines))
    if words.figures:
        words.figures.parent.mkdir(parents=True, exist_ok=True)
        words.figures.write_text("\n".join(lines) + "\n")
    for command, before, after in zip(COMMANDS, few, many):
        assert after < BYTES_MOST, (command, after)
        assert (after - before) / (MANY - FEW) < BYTES_A_ROW_MOST, (command, before, after)
    return 0


if __name__ == "__main__":
    sys.exit(main())
