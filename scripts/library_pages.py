"""What the pages of the library have in common: docs/grippers.md and docs/products.md, made from the files in configs."""
import sys


def is_assumed(source):
    """As the program counts it (studies/config/sources.cpp): nothing that anybody could look up."""
    return source == "" or source.startswith(("assumed", "from memory", "numerical choice"))


def settle(page, wanted, only_check, script):
    """Writes the page, or with only_check says where it is not what it should be. @return the exit status"""
    if not only_check:
        page.write_text(wanted, encoding="utf-8")
        return 0
    if page.read_text(encoding="utf-8") == wanted:
        return 0
    print(f"docs/{page.name} is not what the files it is made from say; run {script}", file=sys.stderr)
    return 1
