#!/usr/bin/env python3
"""Refuse an include that points against the direction of the tree.

Prints every offending line and exits 1. Proves on itself first that it can fail.
"""
import re
import sys
from pathlib import Path

EVERYTHING = {"base", "cases", "surfaces", "theory", "meshes", "contact", "fem",
              "md", "results", "reports", "stress"}
MAY_INCLUDE = {
    "base": set(),
    "cases": {"base"},
    "theory": {"base"},
    "contact": {"base"},
    "surfaces": {"base", "cases"},
    "meshes": {"base", "cases", "surfaces"},
    "fem": {"base", "cases", "surfaces", "meshes", "contact"},
    "md": {"base", "cases", "surfaces"},
    "results": {"base", "cases", "theory"},  # (20) is (1) with another variance
    "reports": {"base", "cases", "surfaces", "theory", "results"},
    "stress": {"base", "cases", "surfaces", "theory", "contact", "meshes",
               "results", "fem/plugin.hpp", "md/engines.hpp"},
    "app": EVERYTHING - {"fem", "md"} | {"fem/plugin.hpp", "md/atomic_contact.hpp", "md/engines.hpp"},
}
INCLUDE = re.compile(r'^\s*#\s*include\s*"(([a-z_]+)/[^"]+)"')


def offences(folder, lines):
    """(line number, line) of each include in `folder` that it may not make."""
    allowed = MAY_INCLUDE[folder] | {folder}
    for number, line in enumerate(lines, start=1):
        match = INCLUDE.match(line)
        if match and not {match[1], match[2]} & allowed:
            yield number, line.strip()


def main(root):
    assert list(offences("fem", ['#include "md/lattice.hpp"'])), "cannot fail"
    assert list(offences("app", ['#include "fem/block.hpp"'])), "cannot fail"
    assert not list(offences("fem", ['#include "meshes/box.hpp"'])), "cannot pass"
    found = 0
    for folder in MAY_INCLUDE:
        for path in sorted((root / folder).rglob("*.[ch]pp")):
            for number, line in offences(folder, path.read_text().splitlines()):
                print(f"{path.relative_to(root)}:{number}: {line}")
                found += 1
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
