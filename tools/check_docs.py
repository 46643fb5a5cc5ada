#!/usr/bin/env python3
"""Refuse a page that names a file that does not exist.

Reads every Markdown file of the tree: the targets of its links, and each path
of a source, a script or a case between backquotes. Prints every line that names
a missing file and exits 1. Proves on itself first that it can fail.
"""
import re
import sys
from pathlib import Path

LINK = re.compile(r"\]\(([^)\s]+)\)")
PATH = re.compile(r"`((?:[a-z0-9_-]+/)+[a-z0-9_-]+\.(?:cpp|hpp|py|md|toml|csv))`")
ELSEWHERE = re.compile(r"^(https?:|mailto:|#)")


def missing(folder, root, text):
    """(line number, name) of each file that `text`, a page in `folder`, names in vain."""
    for number, line in enumerate(text.splitlines(), start=1):
        for target in LINK.findall(line):
            path = target.partition("#")[0]
            if path and not ELSEWHERE.match(target) and not (folder / path).exists():
                yield number, target
        for path in PATH.findall(line):
            if (root / path.split("/")[0]).is_dir() and not (root / path).exists():
                yield number, path


def pages(root):
    for path in sorted(root.rglob("*.md")):
        if not {"build", "out", "corpus"} & set(path.relative_to(root).parts):
            yield path


def main(root):
    assert list(missing(root, root, "[a page](no/such/page.md)")), "cannot fail"
    assert list(missing(root, root, "see `tools/no_such_tool.py`")), "cannot fail"
    assert not list(missing(root, root, "[this](tools/check_docs.py) [x](https://a.b)")), "cannot pass"
    found = 0
    for page in pages(root):
        for number, name in missing(page.parent, root, page.read_text()):
            print(f"{page.relative_to(root)}:{number}: {name} does not exist")
            found += 1
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
