#!/usr/bin/env python3
"""Refuse an include that points against the direction of the tree.

Prints every offending line and exits 1. Proves on itself first that it can fail.
"""
import re
import sys
from pathlib import Path

# Where a module is that is no top-level folder; sub-folders of a place are its own.
PLACES = {
    "base/ranks": "ranks",
    "input/text": "cases",
    "input/types": "cases",
    "input/reader": "cases",
    "input/sweeps": "cases",
    "mechanics/flow": "flow",
    "run/methods": "methods",
    "run/cli": "cli",
    "suite/exchange": "exchange",
    "suite/bench": "bench",
    "suite/robustness": "robustness",
}

# Which other modules a module may include; a path allows these files alone.
MAY_INCLUDE = {
    "base": set(),
    "ranks": {"base"},
    "input": {"base"},
    "mechanics": {"base"},
    "cases": {"base", "input", "mechanics", "surfaces/formats/map_format.hpp"},
    "theory": {"base"},
    "contact": {"base", "ranks", "mechanics"},
    "surfaces": {"base", "input", "mechanics", "ranks", "results/storage/hdf5_file.hpp",
                 "results/trial_read.hpp"},
    "meshes": {"base", "input", "mechanics", "surfaces"},
    "flow": {"base", "mechanics"},
    "fem": {"base", "flow", "ranks", "input", "mechanics", "surfaces", "meshes", "contact"},
    "md": {"base", "input", "mechanics", "surfaces"},
    "results": {"base", "input", "mechanics", "ranks", "theory"},  # its Eq. (20) is (1) with another variance
    "reports": {"base", "input", "mechanics", "cases", "surfaces", "theory", "results"},
    "methods": {"base", "ranks", "input", "mechanics", "cases", "surfaces", "theory", "meshes",
                "contact", "flow", "results", "fem/plugin.hpp", "md/contact/atomic_contact.hpp",
                "md/engines.hpp"},
    "studies": {"base", "input", "mechanics", "cases", "surfaces", "theory", "contact", "flow",
                "results", "reports", "methods", "fem/plugin.hpp"},
    "exchange": {"base", "input", "mechanics", "meshes", "cases", "surfaces", "contact", "results",
                 "reports", "methods"},
    "run": {"base", "ranks", "input", "mechanics", "cases", "surfaces", "theory", "meshes",
            "contact", "results", "reports", "methods", "studies", "fem/plugin.hpp", "md/engines.hpp"},
    # It makes cases and runs them.
    "robustness": {"base", "ranks", "input", "mechanics", "cases", "surfaces", "theory", "contact",
                   "results", "methods", "run", "fem/plugin.hpp"},
    "bench": {"base", "ranks", "input", "mechanics", "cases", "surfaces", "theory", "results",
              "reports", "methods", "run"},
    "cli": {"base", "input", "mechanics", "cases", "surfaces", "theory", "contact", "results",
            "reports", "robustness", "methods", "exchange", "run", "bench"},
}

# The sub-folders of a module, lowest first; "." is the module's own folder. A
# file may include its own sub-folder and those before it, so no cycle can arise.
ORDER = {
    "cases": ["text", "types", "reader", "sweeps"],
    "theory": ["persson", "exact"],
    "results": ["types", "observables", "storage", "."],
    "contact": ["operators", "solvers", "certificate"],
    "surfaces": ["maps", "formats", "analysis", "."],
    "meshes": ["layers", "."],
    "fem": ["parallel", "waves", "multigrid", "hexahedra", "material", "block", "linear", "newton", "refined",
            "solution", "adaptive", "."],
    "md": ["interface", "lattice", "minimise", "dynamics", "contact", "lammps", "."],
    "reports": [".", "numbers", "analysis", "explore", "figures", "pages", "sweeps", "surface"],
    "methods": ["cache", "."],
    "studies": [".", "adhesion", "spots", "conductance", "flow", "friction", "magnification",
                "resistance", "list"],
    "exchange": [".", "answers", "board"],
    "run": ["plan", ".", "arguments", "sweeps"],
    "bench": [".", "analysis", "settings", "pages", "runs"],
    "cli": ["manual", "."],
}

INCLUDE = re.compile(r'^\s*#\s*include\s*"((?:[a-z_]+/)+[a-z_0-9]+\.[a-z]+)"')


def split(path):
    """(module, sub-folder) of "module/file" or "module/sub-folder/file"."""
    parts = path.split("/")
    module = PLACES.get("/".join(parts[:2]))
    if module is None:
        return parts[0], parts[1] if len(parts) > 2 else "."
    place = [place for place in PLACES if PLACES[place] == module]
    if len(place) > 1:
        return module, parts[1]
    return module, parts[2] if len(parts) > 3 else "."


def is_allowed(source, target):
    module, folder = split(source)
    other, other_folder = split(target)
    if other == module:
        order = ORDER.get(module)
        return order is None or (
            other_folder in order
            and order.index(other_folder) <= order.index(folder))
    return bool({other, target} & MAY_INCLUDE[module])


def offences(source, lines):
    """(line number, line) of each include in `source` that it may not make."""
    for number, line in enumerate(lines, start=1):
        match = INCLUDE.match(line)
        if match and split(match[1])[0] in MAY_INCLUDE and not is_allowed(source, match[1]):
            yield number, line.strip()


def table():
    """The rows of the table in docs/architecture.md."""
    for module in MAY_INCLUDE:
        names = ", ".join(f"`{name}`" for name in sorted(MAY_INCLUDE[module])) or "nothing"
        folders_in_order = ", ".join(f"`{name}`" for name in ORDER.get(module, []) if name != ".")
        places = [place for place in PLACES if PLACES[place] == module]
        at = f" in `{places[0].split('/')[0]}/`" if places else ""
        yield f"| `{module}`{at} | {folders_in_order or '–'} | {names} |"


def main(root):
    assert list(offences("fem/block/a.hpp", ['#include "md/lattice/crystal.hpp"'])), "cannot fail"
    assert list(offences("run/a.hpp", ['#include "fem/block/full_block.hpp"'])), "cannot fail"
    assert list(offences("fem/waves/a.hpp", ['#include "fem/block/full_block.hpp"'])), "cannot fail"
    assert list(offences("suite/bench/runs/a.cpp", ['#include "run/cli/checks.hpp"'])), "cannot fail"
    assert not list(offences("run/cli/a.cpp", ['#include "suite/bench/runs/bench.hpp"'])), "cannot pass"
    assert not list(offences("fem/block/a.hpp", ['#include "meshes/box.hpp"'])), "cannot pass"
    found = 0
    page = (root / "docs/architecture.md").read_text()
    for row in table():
        if row not in page:
            print(f"docs/architecture.md lacks this row: {row}")
            found += 1
    tops = {module for module in MAY_INCLUDE if (root / module).is_dir()} | {
        place.split("/")[0] for place in PLACES}
    for path in sorted(path for top in tops for path in (root / top).rglob("*.[ch]pp")):
        source = str(path.relative_to(root))
        module, folder = split(source)
        if module not in MAY_INCLUDE or folder not in ORDER.get(module, [folder]):
            print(f"{source}: its folder has no place in the order of {module}")
            found += 1
            continue
        for number, line in offences(source, path.read_text().splitlines()):
            print(f"{source}:{number}: {line}")
            found += 1
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
