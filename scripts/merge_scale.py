#!/usr/bin/python3
"""Measures `merge`, `info` and `report` on journals of a study that was not run: rows of the right form with made-up numbers. From that and
what a scenario of kiwi_first takes it says what many nodes would do (docs/cluster.md).

usage: scripts/merge_scale.py ROWS [--program FILE] [--journals N] [--folder FOLDER] [--memory GB] [--nodes N] [--cores N]
"""
import argparse
import os
import re
import resource
import struct
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy

sys.path.insert(0, str(Path(__file__).parent.parent / "tests"))
from small_studies import masses  # pylint: disable=wrong-import-position

HEADER_BYTES = 40
ROWS_AT_ONCE = 100_000
KIWI = Path(__file__).resolve().parent.parent / "configs" / "kiwi_first.toml"


def crc_table():
    """CRC-32C, byte by byte."""
    table = numpy.arange(256, dtype=numpy.uint32)
    for _ in range(8):
        table = numpy.where(table & 1, (table >> 1) ^ numpy.uint32(0x82F63B78), table >> 1)
    return table


TABLE = crc_table()


def crc32c(columns):
    """Of each row of bytes."""
    crc = numpy.full(columns.shape[0], 0xFFFFFFFF, dtype=numpy.uint32)
    for column in columns.T:
        crc = TABLE[(crc ^ column) & 0xFF] ^ (crc >> 8)
    return crc ^ numpy.uint32(0xFFFFFFFF)


def records_of(journal):
    """(kind, whole record) of a journal."""
    at = 0
    while at < len(journal):
        kind, length = struct.unpack_from("<HI", journal, at + 6)
        yield kind, journal[at : at + HEADER_BYTES + length]
        at += HEADER_BYTES + length


def rows_like(record, ids, inputs, chance):
    """Bytes of records with these ids and values of the one varied key, every finite metric another than in `record`."""
    rows = numpy.tile(numpy.frombuffer(record, dtype=numpy.uint8), (len(ids), 1))
    first = HEADER_BYTES + 1 + 8 + 4
    count = struct.unpack_from("<I", record, first - 4)[0]
    metrics = numpy.frombuffer(record, dtype="<f8", count=count, offset=first)
    rows[:, first : first + 8 * count] = (metrics * chance.uniform(0.5, 1.5, (len(ids), count))).view(numpy.uint8).reshape(len(ids), -1)
    rows[:, -8:] = inputs.astype("<f8").view(numpy.uint8).reshape(len(ids), 8)
    rows[:, 12:16] = crc32c(rows[:, HEADER_BYTES:]).view(numpy.uint8).reshape(len(ids), 4)
    rows[:, 16:24] = ids.astype("<u8").view(numpy.uint8).reshape(len(ids), 8)
    rows[:, 36:40] = crc32c(rows[:, :36]).view(numpy.uint8).reshape(len(ids), 4)
    return rows.tobytes()


def make(program, folder, count, journals):
    """A run directory with a row for every scenario."""
    (folder / "study.toml").write_text(masses(1, count))
    subprocess.run([program, "run", "study.toml", "-q", "-o", "run", "--shard", f"1/{count}"], cwd=folder, check=True, capture_output=True)
    first = next((folder / "run" / "journal").glob("*.jrnl"))
    records = list(records_of(first.read_bytes()))
    session = next(record for kind, record in records if kind == 2)
    row = next(record for kind, record in records if kind == 1)
    chance = numpy.random.default_rng(7)
    for journal, ids in enumerate(numpy.array_split(numpy.arange(1, count), journals)):
        with open(folder / "run" / "journal" / f"made-{journal}.jrnl", "wb") as file:
            file.write(session)
            for at in range(0, len(ids), ROWS_AT_ONCE):
                part = ids[at : at + ROWS_AT_ONCE]
                file.write(rows_like(row, part, 40.0 + 20.0 * part / (count - 1), chance))
    return sum(path.stat().st_size for path in (folder / "run" / "journal").iterdir()) / count


def measured(memory_gb, *command, cwd):
    """(seconds, seconds of processor time, peak memory in bytes of the largest process, what it said)."""

    def limit():
        resource.setrlimit(resource.RLIMIT_AS, (int(memory_gb * 1e9), int(memory_gb * 1e9)))

    start = time.monotonic()
    with tempfile.TemporaryFile("w+") as words:
        process = subprocess.Popen(command, cwd=cwd, stdout=words, stderr=words, preexec_fn=limit)  # pylint: disable=all
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        words.seek(0)
        said = words.read()
    if process.returncode != 0:
        raise SystemExit(f"{' '.join(map(str, command))} ended with {process.returncode}: {said[-2000:]}")
    return time.monotonic() - start, used.ru_utime + used.ru_stime, 1024 * used.ru_maxrss, said


def core_seconds(program, folder):
    """Of one scenario of kiwi_first, its share of the factorisation included."""
    _, busy, _, said = measured(1000.0, program, "run", KIWI, "--threads", "1", "--quiet", "--no-replay", "-o", "kiwi", cwd=folder)
    return busy / int(re.search(r"([\d,]+) scenarios", said).group(1).replace(",", ""))


def say_of_nodes(words, each_s, bytes_per_row, merge_s, merge_bytes):
    """What all nodes make in an hour, and what merging that would take, by row."""
    rows = words.nodes * words.cores * 3600.0 / each_s
    print(f"{words.nodes:,} nodes of {words.cores} cores, {each_s:.2f} core-seconds a scenario (kiwi_first, measured): {rows / 1e6:.0f} million scenarios in "
          f"an hour, journals of {rows * bytes_per_row / 1e9:.0f} GB, {rows * bytes_per_row / words.nodes / 1e6:.0f} MB a node; one merge of them "
          f"would take {rows * merge_s / words.rows / 60:.0f} minutes of one core and {rows * merge_bytes / words.rows / 1e9:.0f} GB of memory")
    print(f"what {words.rows:,} of them take: {words.rows * each_s / words.nodes / words.cores:.0f} s of all nodes")


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("rows", type=int)
    parser.add_argument("--program", type=Path, default=Path(__file__).parent.parent / "build" / "release" / "unbruised")
    parser.add_argument("--journals", type=int, default=100)
    parser.add_argument("--folder", type=Path)
    parser.add_argument("--memory", type=float, default=1000.0, help="GB of address space that a command may take")
    parser.add_argument("--nodes", type=int, default=1000)
    parser.add_argument("--cores", type=int, default=16)
    words = parser.parse_args()
    program = words.program.resolve()
    with tempfile.TemporaryDirectory(prefix="unbruised-merge-", dir=words.folder) as name:
        folder = Path(name)
        start = time.monotonic()
        bytes_per_row = make(program, folder, words.rows, words.journals)
        print(f"{words.rows:,} rows in {words.journals} journals, {bytes_per_row:.0f} bytes a row, made in {time.monotonic() - start:.0f} s", flush=True)
        used = {}
        for command in (["info", "run"], ["merge", "run", "--threads", "1", "--quiet"], ["info", "run"], ["report", "run", "--no-replay"]):
            seconds, busy, peak, said = measured(words.memory, program, *command, cwd=folder)
            used[command[0]] = (busy, peak)
            digest = re.search(r"^digest (\w+)", said, re.M)
            print(f"{command[0]}: {seconds:.1f} s ({busy:.1f} s of one core), {peak / 1e9:.2f} GB, {peak / words.rows:.0f} bytes a row"
                  f"{', digest ' + digest.group(1) if digest else ''}", flush=True)
        for file in ("results.h5", "report.html"):
            size = (folder / "run" / file).stat().st_size
            print(f"{file}: {size / 1e6:.1f} MB, {size / words.rows:.0f} bytes a row")
        say_of_nodes(words, core_seconds(program, folder), bytes_per_row, *used["merge"])
    return 0


if __name__ == "__main__":
    sys.exit(main())
