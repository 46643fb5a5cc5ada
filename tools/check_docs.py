#!/usr/bin/env python3
"""Refuse a page that names a file, a section or a figure that does not exist.

Reads every Markdown file of the tree: the targets of its links, also the
section behind a #, each path of a source, a script or a case between
backquotes, and each figure in docs/ (`name.svg`). docs/reference/figures.md
must list every figure that the program can draw, and docs/index.md and
mkdocs.yml every page of docs/, and docs/reference/cases.md every shipped case. A page of docs/
that a source names must exist.
Prints every line that names something missing and exits 1. Proves on itself first that it can fail.

Only what git tracks is read, so that outputs, builds and other files that a user
keeps in the checkout are not examined; where there is no checkout, all files are.
"""
import re
import sys
from pathlib import Path

from tracked_files import tracked_files

LINK = re.compile(r"\]\(([^)\s]+)\)")
PATH = re.compile(r"`((?:[a-z0-9_-]+/)+[a-z0-9_-]+\.(?:cpp|hpp|py|md|toml|csv))`")
FIGURE = re.compile(r"`(?:[^`\s]*/)?([a-z0-9-]+)\.svg`")
PAGE = re.compile(r"\bdocs/(?:[a-z-]+/)?[a-z-]+\.md\b")
ELSEWHERE = re.compile(r"^(https?:|mailto:)")
HEADING = re.compile(r"^#+ +(.*)$")
ROW = re.compile(r"^\| `([a-z-]+)(?:<[a-z]+>)?` \|", re.MULTILINE)
SET_NAME = re.compile(r'\.name = "([a-z-]+)";')
LISTED_NAMES = re.compile(r"\.(?:figure_)?names = \{([^}]*)\}")
LISTS = ("reports/figures/*.cpp", "studies/*/*_pages.cpp")
DRAWN = {"reports/surface/surface_figures.cpp": SET_NAME,
         "reports/surface/spectrum_plots.cpp": SET_NAME,
         "reports/surface/contact_plots.cpp": SET_NAME,
         # figure.name = "phases"; {"growth", "Cost against ...
         "suite/bench/pages/bench_figures.cpp": re.compile(
             r'(?:figure\.name = |[{])"([a-z]+-?)"(?:;| \+ (?:reports::)?file_word\(quantity\)[;,]|,\s+"[A-Z])')}


def anchors(text):
    """The anchors of headings that are the same on GitHub and by MkDocs, which joins hyphens."""
    fence = False
    for line in text.splitlines():
        fence ^= line.startswith("```")
        heading = None if fence else HEADING.match(line)
        if heading:
            words = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading[1]).strip().lower()
            anchor = re.sub(r"[^\w\- ]", "", words).replace(" ", "-")
            if "--" not in anchor:
                yield anchor


def missing(folder, root, modules, text):
    """(line number, name) of each file that `text`, a page in `folder`, names in vain.

    A path between backquotes counts if it begins with one of the `modules`, the
    top-level folders of the project: others, such as out/, are a user's.
    """
    for number, line in enumerate(text.splitlines(), start=1):
        for target in LINK.findall(line):
            path, _, anchor = target.partition("#")
            if ELSEWHERE.match(target):
                continue
            page = folder / path
            if path and not page.exists():
                yield number, target
            elif anchor and anchor not in anchors(page.read_text() if path else text):
                yield number, target
        for path in PATH.findall(line):
            if path.split("/")[0] in modules and not (root / path).exists():
                yield number, path


def drawn_figures(root):
    """The names of figures in the sources; one that ends with "-" is continued at run time."""
    return {name for source, names in DRAWN.items()
            for name in names.findall((root / source).read_text())} | {
                name for pages in LISTS for page in root.glob(pages)
                for listed in LISTED_NAMES.findall(page.read_text())
                for name in re.findall(r'"([a-z0-9-]+)"', listed)}


def unknown_figures(known, text):
    """(line number, name) of each figure of a page that the program cannot draw."""
    for number, line in enumerate(text.splitlines(), start=1):
        for name in FIGURE.findall(line):
            if name not in known and not any(k.endswith("-") and name.startswith(k) for k in known):
                yield number, name + ".svg"


def unknown_pages(root, text):
    """(line number, name) of each page of docs/ that a source names in vain."""
    for number, line in enumerate(text.splitlines(), start=1):
        for path in PAGE.findall(line):
            if not (root / path).exists():
                yield number, path


def not_in_reach(root, entrance):
    """The pages of docs/ that a list of pages does not name."""
    for page in sorted((root / "docs").rglob("*.md")):
        name = str(page.relative_to(root / "docs"))
        if name != "index.md" and not re.search(rf"[ (]{re.escape(name)}\b", entrance):
            yield name


SOURCES = {".cpp", ".hpp", ".py", ".txt", ".cmake", ".toml", ".csv"}


def check_itself(root):
    for wrong in ("[a page](no/such/page.md)", "see `tools/no_such_tool.py`", "# A b\n[x](#a-c)",
                  "[x](README.md#no-such-section)"):
        assert list(missing(root, root, {"tools"}, wrong)), wrong
    for right in ("[this](tools/check_docs.py) [x](https://a.b/#c)", "# A `b`, c\n[x](#a-b-c)",
                  "`out/no-such/case.toml`"):
        assert not list(missing(root, root, {"tools"}, right)), right
    assert list(unknown_pages(root, "// see docs/no-such.md")), "cannot fail"
    assert not list(unknown_pages(root, "// see docs/index.md")), "cannot pass"
    assert "glossary.md" in not_in_reach(root, "[g](other-glossary.md)"), "cannot fail"
    assert "glossary.md" not in not_in_reach(root, "[g](glossary.md)"), "cannot pass"
    assert list(unknown_figures({"cost", "maps-"}, "`costs.svg`")), "cannot fail"
    assert not list(unknown_figures({"cost", "maps-"}, "`out/x/maps-fem.svg`")), "cannot pass"


def main(root):
    check_itself(root)
    figures = drawn_figures(root)
    found = 0
    files = [name for name in tracked_files(root) if "corpus" not in name.parts]
    modules = {name.parts[0] for name in files if len(name.parts) > 1}
    for page in (root / name for name in files if name.suffix == ".md"):
        text = page.read_text()
        unknown = unknown_figures(figures, text) if root / "docs" in page.parents else []
        for number, name in [*missing(page.parent, root, modules, text), *unknown]:
            print(f"{page.relative_to(root)}:{number}: {name} does not exist")
            found += 1
    for source in (root / name for name in files if name.suffix in SOURCES):
        if source == Path(__file__).resolve():
            continue
        for number, name in unknown_pages(root, source.read_text(errors="replace")):
            print(f"{source.relative_to(root)}:{number}: {name} does not exist")
            found += 1
    listed = set(ROW.findall((root / "docs/reference/figures.md").read_text()))
    for name in sorted(figures ^ listed):
        why = "not listed" if name in figures else "never drawn"
        print(f"docs/reference/figures.md: {name} is {why}")
        found += 1
    listed = (root / "docs/reference/cases.md").read_text()
    for name in sorted({name.parts[1] for name in files if name.parts[0] == "cases"
                        and name.name in {"case.toml", "collection.toml"}}):
        if f"`{name}`" not in listed:
            print(f"docs/reference/cases.md: the case {name} is not listed")
            found += 1
    for entrance in ("docs/index.md", "mkdocs.yml"):
        for name in not_in_reach(root, (root / entrance).read_text()):
            print(f"{entrance}: docs/{name} is not listed")
            found += 1
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]).resolve()))
