#!/usr/bin/python3
"""usage: scripts/gripper_table.py [--check]

Writes the tables of docs/grippers.md from the files in configs/grippers. --check writes nothing and fails where the page
is not what they say.
"""
import pathlib
import sys
import tomllib

from library_pages import is_assumed, settle

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs/grippers.md"
BEGIN, END = "<!-- made by scripts/gripper_table.py -->", "<!-- end -->"
MADE_UP = {"bare_aluminium", "foam_10kPa", "foam_2kPa", "foam_5kPa", "foam_pads", "force_limited", "independent_fingers",
           "jaw_convex", "jaw_cradle", "jaw_groove", "jaw_sphere", "parallel_jaw", "parallel_jaw_firm", "soft_silicone_pads",
           "three_jaw"}


def flat(table, before=""):
    """A table of tables by its dotted keys."""
    for key, value in table.items():
        if isinstance(value, dict):
            yield from flat(value, before + key + ".")
        else:
            yield before + key, value


def read(path):
    with path.open("rb") as file:
        gripper = tomllib.load(file)
    return gripper | {"source": dict(flat(gripper.get("source", {})))}


def standing(gripper, key):
    """The source of a value; empty where it is assumed."""
    source = gripper.get("source", {}).get(key, gripper.get("source", {}).get("others", ""))
    return "" if is_assumed(source) else source


def shown(gripper, key, factor=1.0):
    """A number, in brackets where it is assumed."""
    value = gripper.get(key)
    if value is None:
        return ""
    text = value if isinstance(value, str) else f"{value * factor:.3g}"
    return text if standing(gripper, key) else f"({text})"


def force(gripper):
    least, most = shown(gripper, "min_force_N"), shown(gripper, "max_force_N")
    return f"{least} to {most}" if least else f"to {most}"


def row(path):
    gripper = read(path)
    if "finger" in gripper:
        fingers = str(len(gripper["finger"]))
    else:
        fingers = "2"
    cells = [f"`{path.stem}`", fingers, force(gripper), shown(gripper, "stroke_m", 1e3), shown(gripper, "max_speed_m_s", 1e3),
             shown(gripper, "payload_kg"), shown(gripper, "hold"), shown(gripper, "safety_factor")]
    return "| " + " | ".join(cells) + " |"


def sources(path):
    gripper = read(path)
    cited = {}
    for key, source in gripper.get("source", {}).items():
        if not is_assumed(source):
            cited.setdefault(source, []).append(f"`{key}`")
    lines = [f"  - {', '.join(keys)}: {source}" for source, keys in cited.items()]
    return [f"- `{path.stem}`: {gripper['description']}"] + lines


def tables():
    files = [path for path in sorted((ROOT / "configs/grippers").glob("*.toml")) if path.stem not in MADE_UP]
    head = ["| file | fingers | force of one, N | stroke of one, mm | speed of one, mm/s | payload, kg | holds by | safety factor |",
            "|---|---|---|---|---|---|---|---|"]
    text = "\n".join([BEGIN, ""] + head + [row(path) for path in files] + ["", "Where the numbers without brackets come from:", ""])
    return text + "\n" + "\n".join(line for path in files for line in sources(path)) + "\n\n" + END


def main():
    if sys.argv[1:] not in ([], ["--check"]):
        print(__doc__.strip(), file=sys.stderr if sys.argv[1:] != ["--help"] else sys.stdout)
        return 0 if sys.argv[1:] == ["--help"] else 2
    page = PAGE.read_text(encoding="utf-8")
    before, after = page.split(BEGIN)[0], page.split(END)[1]
    wanted = before + tables() + after
    return settle(PAGE, wanted, sys.argv[1:] == ["--check"], "scripts/gripper_table.py")


if __name__ == "__main__":
    sys.exit(main())
