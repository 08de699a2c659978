#!/usr/bin/env python3
"""What the pages name exists: links, keys, metrics, files, flags, studies, and the folders of the architecture page.

usage: agreement_test.py PROGRAM SOURCE [unittest options]
"""
import re
import sys
import tomllib
import unittest

import known
from known import code, keys, say, words, wrong_in_toml
from pages import pages

SOURCE = known.SOURCE
FOLDERS_OF_A_RUN = ("build/", "results/")
OTHER_PROGRAMS = {"npm", "sha256sum", "cmake", "ctest", "git", "pip", "apt", "mpirun", "docker"}


def every_quoted(pattern):
    """(place, match) of what stands in backticks and matches as a whole."""
    for page in pages(SOURCE):
        for line, text in page.quoted():
            match = re.fullmatch(pattern, text)
            if match:
                yield f"{page.path.relative_to(SOURCE)}:{line}", match


class Pages(unittest.TestCase):
    """Each test collects every place that is wrong, so that one run names all."""

    def none_wrong(self, wrong):
        self.assertEqual([], sorted(set(wrong)), "\n" + "\n".join(sorted(set(wrong))))

    def test_relative_links_and_their_anchors_resolve(self):
        wrong = []
        by_path = {page.path.resolve(): page for page in pages(SOURCE)}
        for page in pages(SOURCE):
            for line, target in page.links():
                file, _, anchor = target.partition("#")
                aim = (page.path.parent / file).resolve() if file else page.path.resolve()
                resolves = aim in by_path and anchor in by_path[aim].anchors() if anchor else True
                if not aim.exists() or not resolves:
                    wrong.append(f"{page.path.name}:{line}: {target}")
        self.none_wrong(wrong)

    def test_dotted_names_are_config_keys(self):
        tables = {key.split(".")[0] for key in keys()} | {"product", "candidate"}
        lists = {".".join(key.split(".")[:2]) for key in keys()}
        strategy = {key.split(".")[1] for key in keys() if key.startswith("strategy.")}
        lists |= {key.rsplit(".", 1)[0] for key in keys()}
        wrong = []
        for place, match in every_quoted(r"([a-z]+)(?:\[\d\])?\.([a-z]\w*)(?:\[\d\])?(\.\w+)?(?:\[\d\])?(?: ?= ?.*)?"):
            table, name, rest = match.groups()
            name = self.as_in_code(name)
            key = f"{table}.{name}"
            if table not in tables or name in ("toml", "KEY", "cpp", "hpp", "js", "py"):
                continue
            is_key = key in keys() or key in lists or f"{key}{rest or ''}" in keys()
            if not is_key and not (table == "candidate" and name in strategy):
                wrong.append(f"{place}: {match.group(0)}")
        self.none_wrong(wrong)

    def test_names_with_underscores_stand_in_the_code(self):
        self.none_wrong(f"{place}: {match.group(0)}" for place, match in every_quoted(r"/?(?:\w+/)*(\w*[a-zA-Z]_\w+)")
                        if not match.group(1).startswith("_") and self.as_in_code(match.group(1)) not in words())

    @staticmethod
    def as_in_code(name):
        """Columns of CSV files have the name of a key with an axis in it, those of execution errors one with an ending."""
        return re.sub(r"_[xyz](?=_m)|(_relative)?_error$", "", name) if not name.endswith("balance_error") else name

    def test_files_exist_or_are_made_by_the_program(self):
        names, text = code()
        wrong = []
        written = {block.remarks["file"] for page in pages(SOURCE) for block in page.blocks if "file" in block.remarks}
        for place, match in every_quoted(r"([\w./<>*-]*\w\.(?:toml|h5|html|txt|md|cpp|hpp|js|py|sha256|csv|jrnl|png|cmake))(?: .*)?"):
            path = match.group(1)
            name = path.split("/")[-1]
            exists = (SOURCE / path).exists() or name in names or name in written or f'"{name}"' in text or f"/{name}" in text
            if path.startswith(FOLDERS_OF_A_RUN) or not re.fullmatch(r"[\w.-]+", name) or path == "name.cpp":  # a placeholder
                continue
            if not exists or ("/" in path and name in names and not self.found(path)):
                wrong.append(f"{place}: {path}")
        self.none_wrong(wrong)

    @staticmethod
    def found(path):
        return any((SOURCE / top / path).exists() for top in ("", "configs", "docs"))

    def test_flags_are_those_of_the_program_and_the_scripts(self):
        commands = re.findall(r"^  ([a-z]+)  ", say("--help"), re.M)
        helps = say("--help") + "".join(say(command, "--help") for command in commands)
        helps += "".join(path.read_text(encoding="utf-8") for path in (SOURCE / "scripts").iterdir() if path.is_file())
        helps += "".join((SOURCE / other).read_text(encoding="utf-8") for other in ("report/build", "benchmarks/run"))
        flags, wrong = set(re.findall(r"--[a-z][a-z-]*", helps)), []
        for page in pages(SOURCE):
            inside = [(block.line, text) for block in page.blocks for text in block.commands]
            for line, text in [*page.quoted(), *inside]:
                if text.split()[0].strip("$ ") in OTHER_PROGRAMS:
                    continue
                wrong += [f"{page.path.name}:{line}: {flag}" for flag in re.findall(r"(?<![\w-])--[a-z][a-z-]*", text)
                          if flag not in flags]
        self.none_wrong(wrong)

    def test_toml_blocks_are_toml_and_have_keys_of_the_config(self):
        wrong = []
        for page in pages(SOURCE):
            for block in page.blocks:
                if block.language == "toml":
                    wrong += [f"{page.path.name}:{block.line}: {text}" for text in wrong_in_toml(block)]
        self.none_wrong(wrong)

    def test_folders_named_exist(self):
        self.none_wrong(f"{place}: {match.group(0)}" for place, match in
                        every_quoted(r"(?:core|optimizer|studies|report|configs|scripts|tests|benchmarks)(?:/[\w-]+)+")
                        if "HARNESS" not in match.group(0) and not self.stands(match.group(0)))

    @staticmethod
    def stands(path):
        """Is there such a folder, file, or pair of header and source?"""
        return (SOURCE / path).exists() or (SOURCE / f"{path}.hpp").exists()

    def test_folders_of_the_architecture_page_are_those_of_the_tree(self):
        text = (SOURCE / "docs/architecture.md").read_text(encoding="utf-8")
        for house in ("core", "studies"):
            section = text.split(f"### Inside {house}\n")[1].split("\n### ")[0].split("\n## ")[0]
            listed = set(re.findall(r"^\| (?:\d+ \| )?`(\w+)` \|", section, re.M))
            there = {path.name for path in (SOURCE / house).iterdir() if path.is_dir()}
            self.assertEqual(there, listed, f"docs/architecture.md, inside {house}")
        tops = set(re.findall(r"^(\w+)/ ", text, re.M))
        there = {path.name for path in SOURCE.iterdir() if path.is_dir() and not path.name.startswith(".")}
        self.assertEqual(there - {"build", "cmake", "results"}, tops - {"results"}, "docs/architecture.md, houses")

    def test_the_optimizer_files_of_the_architecture_page_are_those_of_the_tree(self):
        text = (SOURCE / "docs/architecture.md").read_text(encoding="utf-8")
        section = text.split("### Inside optimizer\n")[1].split("\n## ")[0]
        rows = re.findall(r"^\| (`.*`) \|", section, re.M)
        listed = {name for row in rows for name in re.findall(r"`(\w+)`", row)}
        there = {path.stem for path in (SOURCE / "optimizer").glob("*.hpp")}
        self.assertEqual(there, listed)

    def test_every_page_with_commands_is_run_by_the_tests(self):
        text = (SOURCE / "tests/docs/CMakeLists.txt").read_text(encoding="utf-8")
        listed = set(re.search(r"foreach\(page ([^)]*)\)", text).group(1).split())
        with_commands = {str(page.path.relative_to(SOURCE)) for page in pages(SOURCE) if any(block.runs for block in page.blocks)}
        self.assertEqual(with_commands, listed, "tests/docs/CMakeLists.txt, foreach(page ...)")

    def test_every_page_is_in_the_index(self):
        linked = {target for page in pages(SOURCE) if page.path.name == "index.md" for _, target in page.links()}
        there = {path.name for path in (SOURCE / "docs").glob("*.md")} - {"index.md"}
        self.assertEqual(set(), there - linked)

    def test_every_number_of_the_library_names_its_source(self):
        wrong = []
        for path in sorted((SOURCE / "configs").glob("*/*.toml")):
            table = tomllib.loads(path.read_text(encoding="utf-8"))
            if path.parent.name not in ("products", "grippers", "strategies"):
                continue
            source = table.get("source", {})
            named = [key for key, value in table.items() if isinstance(value, (int, float, list))]
            wrong += [f"{path.name}: {key}" for key in named
                      if not {key, "others", "all"} & set(source) and not (key == "at_frequency_Hz" and "loss_ratio" in source)]
            wrong += [f"{path.name}: limits.{key}" for key in table.get("limits", {})
                      if not {f"limits_{key}", "limits", "all"} & set(source)]
        self.none_wrong(wrong)


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
