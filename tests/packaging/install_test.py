#!/usr/bin/env python3
"""An installation: files, manual pages, completions, and a run from it.

install_test.py CMAKE BUILD FOLDER: installs BUILD into FOLDER/prefix, moves it to FOLDER/moved and
uses it from there.
"""
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

FILES = ["bin/asperity", "lib/asperity/asperity_fem.so",
         "lib/python3/dist-packages/asperity.py", "share/asperity/cases/hertz/case.toml",
         "share/asperity/cases/hertz/quick.set", "share/asperity/cases/paper/collection.toml",
         "share/doc/asperity/index.md", "share/doc/asperity/copyright",
         "share/doc/asperity/CHANGELOG.md", "share/man/man1/asperity.1",
         "share/man/man1/asperity-run.1", "share/bash-completion/completions/asperity",
         "share/zsh/vendor-completions/_asperity",
         "share/fish/vendor_completions.d/asperity.fish"]
COMMAND = re.compile(r"^  ([a-z]+)(?:, [a-z]+)*(?: {2,}|$)", re.MULTILINE)
OPTION = re.compile(r"^  (?:-\w,)?(--[a-z-]+)", re.MULTILINE)


def run(*words, **options):
    return subprocess.run(list(map(str, words)), capture_output=True, text=True, check=True,
                          **options).stdout


def complete(script, *words):
    """The completions of bash for the last word."""
    quoted = " ".join(f"'{word}'" for word in words)
    text = (f"source {script}; COMP_WORDS=({quoted}); COMP_CWORD={len(words) - 1}; "
            "_asperity_words; printf '%s\\n' \"${COMPREPLY[@]}\"")
    return run("bash", "-c", text).split()


def check_completion(script, commands):
    assert set(commands) <= set(complete(script, "asperity", "")), commands
    assert complete(script, "asperity", "run", "polymer-n") == ["polymer-nominal"]
    assert complete(script, "asperity", "run", "board/wave") == ["board/wave-1d", "board/wave-2d"]
    assert complete(script, "asperity", "check", "--jun") == ["--junit"]
    assert complete(script, "asperity", "run", "x", "--methods", "half") == ["halfspace"]
    assert complete(script, "asperity", "run", "x", "--set", "surface.po") == ["surface.points="]
    assert complete(script, "asperity", "list", "--ju") == []
    assert complete(script, "asperity", "report", "poly") == []


def check_first_completion_in_zsh(folder):
    """The first Tab in a new zsh, typed in a pseudo terminal."""
    if not shutil.which("zsh"):
        print("skipped: needs zsh")
        return
    lines = ["zmodload zsh/zpty", "zpty shell zsh -f -i",
             f"zpty -w shell 'fpath=({folder} $fpath); autoload -U compinit; compinit -u -D'",
             "zpty -w -n shell $'asperity run hertz-adap\\t'",
             "zpty -r shell seen '*hertz-adaptive*' && print found", "zpty -d shell"]
    ended = subprocess.run(["zsh", "-f", "-c", "\n".join(lines)], capture_output=True, text=True,
                           timeout=30)
    assert ended.stdout.strip() == "found", ended


def check_pages(program, commands, folder):
    """Each page names every option of --help, and groff has no warnings."""
    pages = sorted(folder.glob("asperity*.1"))
    assert len(pages) == len(commands) + 1, pages
    for command in commands:
        text = (folder / f"asperity-{command}.1").read_text().replace("\\-", "-")
        for option in OPTION.findall(run(program, command, "--help")):
            assert f"\\fB{option}\\fR" in text, (command, option)
    if not shutil.which("groff"):
        print("skipped: needs groff-base")
        return
    ended = subprocess.run(["groff", "-man", "-ww", "-z", *pages], capture_output=True, text=True,
                           check=True)
    assert ended.stderr == "", ended.stderr


def check_run(program, prefix, folder):
    """Cases, documentation and module are those of the prefix, and nothing else is needed."""
    environment = {**os.environ, "ASPERITY_CACHE_SIZE": "0"}
    assert f"documentation: {prefix}/share/doc/asperity" in run(program, "--help")
    described = json.loads(run(program, "describe", "hertz", "--json"))
    assert described["file"] == f"{prefix}/share/asperity/cases/hertz/case.toml"
    answer = json.loads(run(program, "run", "hertz", "--quick", "--quiet", "--json",
                            cwd=folder, env=environment))
    assert answer["exit_code"] == 0 and answer["results"][0]["summary"]["all_ok"]
    assert "fem" in [one["name"] for one in answer["results"][0]["summary"]["methods"]]
    libraries = run("ldd", program)
    assert f"{prefix}/bin/../lib/asperity/libasperity_base.so" in libraries, libraries
    assert "not found" not in libraries + run("ldd", prefix / "lib/asperity/asperity_fem.so")


def main(cmake, build, scratch):
    folder = Path(scratch).resolve()
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    run(cmake, "--install", build, "--prefix", folder / "prefix")
    prefix = folder / "moved"
    (folder / "prefix").rename(prefix)
    missing = [name for name in FILES if not (prefix / name).is_file()]
    assert not missing, missing
    stray = [path for path in (prefix / "share/asperity").rglob("*.[ch]pp")]
    assert not stray, stray
    program = prefix / "bin/asperity"
    commands = COMMAND.findall(run(program, "--help").partition("Subcommands:")[2])
    check_completion(prefix / "share/bash-completion/completions/asperity", commands)
    check_first_completion_in_zsh(prefix / "share/zsh/vendor-completions")
    check_pages(program, commands, prefix / "share/man/man1")
    check_run(program, prefix, folder)
    shutil.rmtree(folder)


if __name__ == "__main__":
    main(*sys.argv[1:])
