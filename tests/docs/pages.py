"""Reads the Markdown pages: fenced blocks with the remark above each, headings, links, names in backticks.

Remarks are HTML comments on the line above a block, seen by the tests and not by the reader:

  <!-- file: NAME -->         the block is the file NAME, which later commands of the page use
  <!-- first: COMMANDS -->    what the reader has done on another page runs first
  <!-- thin: OPTIONS -->      `unbruised run` in the block gets these options too, so that the test is quick
  <!-- output -->             the block is what the commands above printed: its lines begin like lines that came
  <!-- exit: STATUS -->       the commands of the block end with this exit status
  <!-- not run: REASON -->    the commands are not run by the tests
"""
import re
from dataclasses import dataclass, field
from pathlib import Path

REMARK = re.compile(r"<!--\s*(file|first|thin|output|exit|not run)(?::\s*(.*?))?\s*-->$")
COMMAND = re.compile(r"^(?:\$ )?((?:build/release/unbruised|unbruised|scripts/|report/build|benchmarks/run|build/release/benchmarks/|/usr/bin/python3|export )\S*.*)$")


@dataclass
class Block:
    """A fenced block: its language, its lines, the line it begins on and the remarks above it."""
    language: str
    lines: list
    line: int
    remarks: dict = field(default_factory=dict)

    @property
    def text(self):
        return "\n".join(self.lines) + "\n"

    @property
    def commands(self):
        """Its command lines without prompt and trailing comment; none where it is no block of commands."""
        if self.language not in ("", "sh", "console") or not self.lines or not COMMAND.match(self.lines[0]):
            return []
        found, prompts = [], any(line.startswith("$ ") for line in self.lines)
        for line in "\n".join(self.lines).replace("\\\n", " ").split("\n"):
            match = COMMAND.match(line)
            if match and (line.startswith("$ ") or not prompts):
                found.append(re.sub(r"\s+#.*$", "", match.group(1)))
        return found

    @property
    def runs(self):
        """Is it run by the tests: commands, or a piece of Python, and no remark that says otherwise?"""
        return bool(self.commands or self.language == "python") and "not run" not in self.remarks


class Page:
    """A Markdown page. `prose` has blanks where fenced blocks and comments stand, so that line numbers stay."""

    def __init__(self, path):
        self.path = Path(path)
        self.blocks, self.prose, self.headings = [], [], []
        self._read(self.path.read_text(encoding="utf-8").split("\n"))

    def _read(self, lines):
        remarks, block, fence = {}, None, ""
        for number, line in enumerate(lines, 1):
            if block is not None:
                if line.strip() == fence:
                    self.blocks.append(block)
                    block = None
                else:
                    block.lines.append(line)
                self.prose.append("")
                continue
            opening = re.match(r"\s*(```+)(\w*)\s*$", line)
            remark = REMARK.match(line.strip())
            if opening:
                fence = opening.group(1)
                block, remarks = Block(opening.group(2), [], number, remarks), {}
            elif remark:
                remarks[remark.group(1)] = remark.group(2) or ""
            elif line.strip():
                remarks = {}
            heading = re.match(r"#+\s+(.*)$", line)
            if heading:
                self.headings.append(heading.group(1))
            self.prose.append("" if opening or remark else line)

    def anchors(self):
        """The ids GitHub gives the headings."""
        plain = (re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", h).replace("`", "").lower() for h in self.headings)
        return {re.sub(r"[^\w\- ]", "", h).replace(" ", "-") for h in plain}

    def links(self):
        """(line, target) of links and pictures that point into the repository."""
        for number, line in enumerate(self.prose, 1):
            for target in re.findall(r"\]\(([^)\s]+)\)", re.sub(r"`[^`]*`", "", line)):
                if not re.match(r"[a-z]+:", target):
                    yield number, target

    def quoted(self):
        """(line, text) of what stands in backticks."""
        for number, line in enumerate(self.prose, 1):
            for text in re.findall(r"`([^`]+)`", line):
                yield number, text


def pages(source):
    """All pages of the repository, README first."""
    root = Path(source)
    others = ("README.md", "CONTRIBUTING.md", "SECURITY.md", "benchmarks/README.md", "results/README.md")
    return [*(Page(root / name) for name in others), *map(Page, sorted((root / "docs").glob("*.md")))]
