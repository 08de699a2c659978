#!/usr/bin/env python3
"""Writes the tables *program, independent, ratio* of docs/validation.md from what the tests print (tests/comparison.hpp).

usage: scripts/validation_tables.py [BUILD]     BUILD: build/release

Between `<!-- compared: NAME -->` and `<!-- end of NAME -->` stands the table of that name. The independent numbers and the
scripts that made them lie in tests/reference-data and tests/reference.
"""
import os
import re
import subprocess
import sys

TESTS = ("kiwi_force_test", "patch_damage_test", "patch_traction_test", "rubber_layer_test", "pad_edge_test", "contact_area_test", "support_yield_test",
         "support_yield_work_test")
ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
PAGE = os.path.join(ROOT, "docs", "validation.md")


def digits(value):
    """Three of them, four from 1000 on, without an exponent."""
    text = f"{value:.3g}" if abs(value) < 1000 else f"{value:.0f}"
    return f"{float(text):g}" if "e" not in text else f"{float(text):f}".rstrip("0")


def comparisons(build):
    """Table name -> rows (quantity, program, independent), in the order of the tests."""
    tables = {}
    for name in TESTS:
        test = os.path.join(build, "tests", "core", "contact", name)
        done = subprocess.run([test, "--gtest_brief=1"], stdout=subprocess.PIPE, text=True, check=False)
        if done.returncode != 0:
            sys.exit(f"validation_tables: {name} fails")
        for line in done.stdout.splitlines():
            if line.startswith("compared|"):
                _, table, quantity, program, independent = line.split("|")
                tables.setdefault(table, []).append((quantity, float(program), float(independent)))
    return tables


def markdown(rows):
    lines = ["| quantity | program | independent | ratio |", "|---|---|---|---|"]
    lines += [f"| {quantity} | {digits(program)} | {digits(independent)} | {program / independent:.2f} |" for quantity, program, independent in rows]
    return "\n".join(lines)


def main():
    build = sys.argv[1] if len(sys.argv) > 1 else os.path.join(ROOT, "build", "release")
    tables = comparisons(build)
    with open(PAGE, encoding="utf-8") as file:
        page = file.read()
    for name, rows in tables.items():
        block = re.compile(rf"(<!-- compared: {name} -->\n).*?(<!-- end of {name} -->)", re.DOTALL)
        page, found = block.subn(lambda match: match.group(1) + "\n" + markdown(rows) + "\n\n" + match.group(2), page)
        if found != 1:
            sys.exit(f"validation_tables: docs/validation.md has no place for {name}")
    with open(PAGE, "w", encoding="utf-8") as file:
        file.write(page)
    print(f"docs/validation.md: {sum(map(len, tables.values()))} rows in {len(tables)} tables")


if __name__ == "__main__":
    main()
