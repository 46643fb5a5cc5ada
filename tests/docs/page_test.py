#!/usr/bin/env python3
"""Runs the commands of a page of docs/ as they are written.

page_test.py PROGRAM SOURCE PAGE FOLDER: runs each line of the fenced blocks of
docs/PAGE.md that begin with ./asperity or python3, and each block marked `python`,
in FOLDER, which is emptied first and gets copies of docs/tutorials and python/adapters and a link to cases. A line ends with `# exit code N` where N is not 0.
A block marked `text` shows lines of what the commands before it print; numbers
may differ by 2 %, and a line that ends with ... may go on. The count before a
load step, as in 4/12, is not compared, because jobs run beside each other.
Afterwards each file `out/...` and each figure `name.svg` that the page names
must exist, and each picture figures/PAGE-NAME.svg of the page must say what the
first figure NAME.svg of these commands says; with ASPERITY_UPDATE_GOLDEN=1 it is
replaced by this figure.
"""
import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

BLOCK = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
EXIT_CODE = re.compile(r"# exit code (\d+)$")
FILE = re.compile(r"`(out/[^`\s<>*]+)`")
FIGURE = re.compile(r"`([a-z0-9-]+\.svg)`")
PICTURE = re.compile(r"!\[[^\]]+\]\(\.\./figures/([a-z0-9-]+)\.svg\)")
LABEL = re.compile(r"<tspan[^>]*>([^<]*)")
TOKEN = re.compile(r"\d+(?:\.\d+)?(?:e[-+]?\d+)?|[^\s\d]+")
COUNT = re.compile(r"^\s*\d+/\d+ ")
CLOSE = 0.02


def is_same(shown, printed):
    """True if a printed line is the one that a page shows."""
    some = TOKEN.findall(COUNT.sub("", shown.removesuffix("...")))
    all_of_it = TOKEN.findall(COUNT.sub("", printed))
    if shown.endswith("..."):
        all_of_it = all_of_it[:len(some)]
    return len(some) == len(all_of_it) and all(map(is_close, some, all_of_it))


def is_close(shown, printed):
    if shown[0].isdigit() and printed[0].isdigit():
        return abs(float(shown) - float(printed)) <= CLOSE * abs(float(shown))
    return shown == printed


def run(program, line, folder):
    """The output of a command, after a check of its exit code."""
    expected = EXIT_CODE.search(line)
    words = shlex.split(line, comments=True)
    programs = {"./asperity": program, "python3": "/usr/bin/python3"} # the one with numpy
    ended = subprocess.run([programs[words[0]], *words[1:]], cwd=folder, text=True, check=False,
                           stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    code = int(expected[1]) if expected else 0
    if ended.returncode != code:
        sys.exit(f"{line}\nexit code {ended.returncode}, not {code}\n{ended.stdout}")
    return ended.stdout


def run_python(code, folder):
    """The output of a block of Python, with the module asperity.py in its path."""
    (folder / "block.py").write_text(code)
    ended = subprocess.run(["/usr/bin/python3", "block.py"], cwd=folder, text=True, check=False,
                           stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if ended.returncode != 0:
        sys.exit(f"{code}\nexit code {ended.returncode}\n{ended.stdout}")
    return ended.stdout


def run_blocks(program, page, folder):
    """Runs the commands of a page and returns how many there are."""
    commands, printed = 0, []
    for kind, block in BLOCK.findall(page):
        if block.startswith(("./asperity", "python3 ")):
            printed = []
            for line in block.splitlines():
                printed += run(program, line, folder).splitlines()
                commands += 1
        elif kind == "python":
            printed = run_python(block, folder).splitlines()
            commands += 1
        elif kind == "text":
            for shown in block.splitlines():
                if not any(is_same(shown, line) for line in printed):
                    sys.exit(f"not printed: {shown}\n" + "\n".join(printed))
    return commands


def check_files(page, folder):
    drawn = {path.name for path in folder.glob("out/**/*.svg")}
    lost = [name for name in FILE.findall(page) if not (folder / name).exists()]
    lost += [name for name in FIGURE.findall(page) if name not in drawn]
    if lost:
        sys.exit("the page names what was not written: " + ", ".join(lost))


def says(figure):
    """The words and numbers of a figure."""
    return " ".join(LABEL.findall(figure.read_text()))


def check_pictures(page, source, name, folder):
    for picture in PICTURE.findall(page):
        stored = source / f"docs/figures/{picture}.svg"
        figure = picture.removeprefix(f"{Path(name).name}-") + ".svg"
        made = sorted(folder.glob(f"**/figures/{figure}"), key=lambda path: path.stat().st_mtime)
        if not made:
            sys.exit(f"{stored} is a picture of {figure}, which no command has drawn")
        if os.environ.get("ASPERITY_UPDATE_GOLDEN") == "1":
            shutil.copyfile(made[0], stored)
        if not is_same(says(stored), says(made[0])):
            sys.exit(f"{stored} says\n{says(stored)}\nand {made[0]}\n{says(made[0])}")


def check_itself():
    assert is_same("ok  fem  0.50 ± 0.02 ...", "ok fem 0.501 ± 0.02 in 0.4..0.6")
    assert not is_same("ok fem 0.50", "ok fem 0.52") and not is_same("ok fem", "ok fem 1")
    assert not is_same("ok fem", "ok md")
    assert is_same("4/12 fem step 1", "  5/12 fem step 1") and not is_same("4/12 fem", "4/12 md")


def main(program, source, name, scratch):
    check_itself()
    folder = Path(scratch)
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(Path(source) / "docs/tutorials", folder / "docs/tutorials")
    shutil.copytree(Path(source) / "python/adapters", folder / "python/adapters")
    (folder / "cases").symlink_to(Path(source).resolve() / "cases")
    os.environ["ASPERITY_CACHE"] = str(folder / "cache")
    os.environ.pop("ASPERITY_CACHE_SIZE", None)
    os.environ["ASPERITY_PROGRAM"] = program
    os.environ["PYTHONPATH"] = str(Path(source) / "python")
    os.environ["PYTHONDONTWRITEBYTECODE"] = "1"
    page = (Path(source) / "docs" / f"{name}.md").read_text()
    if run_blocks(program, page, folder) == 0:
        sys.exit("the page has no command")
    check_files(page, folder)
    check_pictures(page, Path(source), name, folder)


if __name__ == "__main__":
    main(*sys.argv[1:])
