#!/usr/bin/python3
"""The CI workflow and the Dockerfile name what is there: presets, scripts, packages, studies, stages. They run nowhere near the tests, so a
rename must be seen here.

usage: containers_test.py REPOSITORY
"""
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import yaml

REPOSITORY = Path(sys.argv[1])
IMAGE = "debian:12"
# What neither scripts/setup nor the program needs: to fetch the sources, and npm's registry, in a bare image.
BARE_IMAGE_PACKAGES = {"git", "ca-certificates"}
failures = []
debian = set()


def expect(holds, words):
    if not holds:
        failures.append(words)


def presets(kind):
    return {preset["name"] for preset in json.loads((REPOSITORY / "CMakePresets.json").read_text())[kind]}


def packages_of_debian():
    """Empty where apt has no lists."""
    if not shutil.which("apt-cache"):
        return set()
    names = set(subprocess.run(["apt-cache", "pkgnames"], capture_output=True, text=True, check=True).stdout.split())
    return names if "clang-format" in names else set()


def packages_of_setup():
    listed = subprocess.run([REPOSITORY / "scripts/setup", "--tests", "--heavy", "--clang", "--coverage", "--list"],
                            capture_output=True, text=True, check=True)  # fmt: skip
    return set(listed.stdout.split())


def check_commands(where, commands, known_packages):
    """Scripts and studies exist; packages are those of scripts/setup, or Debian's where its list is here."""
    for script in re.findall(r"(?:^|[\s;&])((?:scripts|report|\.ci)/[\w-]+)", commands):
        expect(os.access(REPOSITORY / script, os.X_OK), f"{where}: {script} cannot be executed")
    for study in re.findall(r"[\w/]+\.toml", commands):
        expect((REPOSITORY / "configs" / study).exists(), f"{where}: there is no configs/{study}")
    for words in re.findall(r"apt-get install ([^&|\n]*)", commands.replace("\\\n", " ")):
        names = [word for word in words.split() if not word.startswith("-") and "/" not in word]
        for name in names:
            expect(name in known_packages | BARE_IMAGE_PACKAGES | {"clang-format"}, f"{where}: {name} is none of scripts/setup's packages")
            expect(not debian or name in debian, f"{where}: Debian has no package {name}")


def check_workflow(file, known_packages):
    workflow = yaml.safe_load(file.read_text())
    expect(set(workflow) == {"name", True, "jobs"}, f"{file.name} has other keys than name, on and jobs")  # YAML reads `on` as true
    expect({"push", "pull_request", "schedule"} == set(workflow[True]), f"{file.name}: when it runs")
    for each in workflow[True]["schedule"]:
        expect(re.fullmatch(r"\d+ \d+ \S+ \S+ \S+", each["cron"]), f"{file.name}: cron {each['cron']}")
    for name, job in workflow["jobs"].items():
        where = f"{file.name}, job {name}"
        expect(job["container"] == IMAGE, f"{where} runs in {job['container']}, not in {IMAGE}")
        expect({"runs-on", "steps"} <= set(job), f"{where} lacks runs-on or steps")
        matrix = job.get("strategy", {}).get("matrix", {}).get("include", [])
        for row in matrix:
            expect(row["preset"] in presets("configurePresets") & presets("buildPresets"), f"{where}: no preset {row['preset']}")
        commands = []
        for step in job["steps"]:
            expect(len({"run", "uses"} & set(step)) == 1, f"{where}: a step is either run or uses: {step}")
            if "uses" in step:
                expect(re.fullmatch(r"[\w-]+/[\w-]+@v\d+", step["uses"]), f"{where}: {step['uses']} has no version")
            commands.append(step.get("run", ""))
        for key in re.findall(r"\$\{\{ *([\w.]+) *\}\}", "\n".join(commands) + str(job.get("name", ""))):
            expect(key.startswith("matrix.") and all(key[len("matrix.") :] in row for row in matrix), f"{where}: {key} is not set")
        # Before the sources are there nothing of them can be called.
        checked_out = [i for i, step in enumerate(job["steps"]) if step.get("uses", "").startswith("actions/checkout@")]
        first_call = [i for i, step in enumerate(job["steps"]) if re.search(r"(?:scripts|\.ci)/", step.get("run", ""))]
        expect(checked_out and min(first_call) > checked_out[0], f"{where} calls scripts before it has the sources")
        check_commands(where, "\n".join(commands), known_packages)


def check_dockerfile(file, known_packages):
    text = re.sub(r"\\\n", " ", file.read_text())
    lines = [line.split(None, 1) for line in text.splitlines() if line.strip() and not line.startswith("#")]
    known = {"FROM", "RUN", "COPY", "WORKDIR", "ENTRYPOINT"}
    expect({word for word, _ in lines} <= known, f"Dockerfile: instructions {sorted({word for word, _ in lines} - known)}")
    expect(lines[0][0] == "FROM", "Dockerfile does not begin with FROM")
    stages = [re.fullmatch(r"(\S+)(?: AS (\w+))?", rest) for word, rest in lines if word == "FROM"]
    expect([stage.group(1) for stage in stages] == [IMAGE, IMAGE], "Dockerfile: a clean Debian 12 makes the package, another installs it")
    names = {stage.group(2) for stage in stages if stage.group(2)}
    for word, rest in lines:
        if word == "COPY":
            named = re.match(r"--from=(\w+) (\S+)", rest)
            expect(rest.startswith(". ") or (named and named.group(1) in names), f"Dockerfile: COPY {rest}")
            if named:  # what scripts/package leaves, below the WORKDIR of that stage
                folder = next(r for w, r in lines if w == "WORKDIR")
                expect(named.group(2) == f"{folder}/build/package/*.deb", f"Dockerfile copies {named.group(2)}")
    expect("build/package/*.deb" in (REPOSITORY / "scripts/package").read_text(), "scripts/package leaves the package elsewhere")
    check_commands("Dockerfile", "\n".join(rest for word, rest in lines if word == "RUN"), known_packages)
    entry = next(rest for word, rest in lines if word == "ENTRYPOINT")
    expect(json.loads(entry) == ["unbruised"], f"Dockerfile starts {entry}")
    # What Python needs there is what the package recommends.
    recommended = re.search(r'PACKAGE_RECOMMENDS "([^"]*)"', (REPOSITORY / "cmake/install.cmake").read_text()).group(1)
    for name in recommended.split(", "):
        expect(re.search(rf"\b{name}(?:\s|$)", text), f"Dockerfile leaves out {name}, which the package recommends")


def check_ignored():
    """Sources that the image is made of are not kept out of it."""
    for line in (REPOSITORY / ".dockerignore").read_text().split():
        expect(line in {"build", "results", ".git"}, f".dockerignore keeps {line} out")


def main():
    known_packages = packages_of_setup()
    debian.update(packages_of_debian())
    workflows = sorted((REPOSITORY / ".github/workflows").glob("*.yml"))
    expect(workflows, "there is no workflow")
    for file in workflows:
        check_workflow(file, known_packages)
    check_dockerfile(REPOSITORY / "packaging/Dockerfile", known_packages)
    check_ignored()
    for failure in failures:
        print("FAILED:", failure)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
