#!/usr/bin/env python3
"""docs/reference/commands.md names every command, option and exit code of the program.

commands_test.py PROGRAM PAGE: compares the page with the texts of --help, in
both directions.
"""
import re
import subprocess
import sys
from pathlib import Path

COMMAND = re.compile(r"^  ([a-z]+)(?:, [a-z]+)*(?: {2,}|$)", re.MULTILINE)
OPTION = re.compile(r"^  (?:-\w,)?(--[a-z-]+)", re.MULTILINE)
SECTION = re.compile(r"^## (?:`([a-z]+)`|(.*))$", re.MULTILINE)
ROW = re.compile(r"^\| `(--[a-z-]+)", re.MULTILINE)
OF_THE_SCRIPT = {"test"}


def help_of(program, *command):
    return subprocess.run([program, *command, "--help"], capture_output=True, text=True,
                          check=True).stdout


def sections(page):
    """The text below each heading of second level."""
    parts = SECTION.split(page)
    return {name or title: text for name, title, text in zip(parts[1::3], parts[2::3], parts[3::3])}


def differences(where, here, there):
    """Yields a line for each name that is only in the help of the program or only on the page."""
    for name in sorted(here - there):
        yield f"{where}: {name} is not on the page"
    for name in sorted(there - here):
        yield f"{where}: the program has no {name}"


def compare(helps, general, page):
    """Every difference between the help texts and the page."""
    told = sections(page)
    yield from differences("commands", set(helps),
                           {name for name in told if name.islower()} - OF_THE_SCRIPT)
    shared = set(ROW.findall(told.get("Shared options", "")))
    yield from differences("Shared options", set(), shared - set(OPTION.findall(helps.get("run", ""))))
    for command in helps.keys() & told.keys():
        options = set(OPTION.findall(helps[command])) - {"--help"}
        rows = set(ROW.findall(told[command]))
        if "(#shared-options)" in told[command]:
            rows |= shared & options
        yield from differences(command, options, rows)
    codes = general.partition("exit codes:")[2]
    yield from differences("exit codes", set(re.findall(r"(?:^|, )\s*(\d+) ", codes, re.MULTILINE)),
                           set(re.findall(r"^\| (\d+) \|", told["Exit codes"], re.MULTILINE)))


def check_itself():
    helps = {"run": "  -h,--help  x\n  --out TEXT  y\n"}
    general = "exit codes:\n  0 success, 1 no\n"
    page = "## `run`\n| `--out DIR` | y |\n## Exit codes\n| 0 | x |\n| 1 | y |\n"
    assert not list(compare(helps, general, page))
    assert len(list(compare(helps, general, page.replace("--out", "--in")))) == 2
    assert len(list(compare(helps, general, page.replace("`run`", "`walk`")))) == 2
    assert len(list(compare(helps, general, page.replace("| 1 |", "| 2 |")))) == 2
    shared = page.replace("| `--out DIR` | y |", "(#shared-options)\n## Shared options\n| `--out DIR` | y |")
    assert not list(compare(helps, general, shared))
    assert len(list(compare(helps, general, shared.replace("(#shared-options)", "")))) == 1
    assert len(list(compare(helps, general, shared.replace("--out", "--in")))) == 2


def main(program, page):
    check_itself()
    general = help_of(program)
    commands = COMMAND.findall(general.partition("Subcommands:")[2])
    helps = {name: help_of(program, name) for name in commands}
    found = list(compare(helps, general, Path(page).read_text()))
    print("\n".join(found))
    return 1 if found or not commands else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
