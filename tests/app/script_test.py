#!/usr/bin/env python3
"""The script ./asperity on checkouts that cannot be written to, and its exit codes.

script_test.py SCRIPT: runs a copy of the script with stubs of cmake, ninja, ctest and dpkg-query.
If it is root it changes to another user first, because root may write everywhere.
"""
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

NOBODY = 65534
STUBS = {
    "dpkg-query": 'shift; for p in "$@"; do [ "$p" = "$MISSING" ] || echo "$p installed"; done',
    "cmake": 'mkdir -p "$4"; touch "$4/build.ninja"; '
             'echo "CMAKE_HOME_DIRECTORY:INTERNAL=$2" > "$4/CMakeCache.txt"',
    "ninja": '[ -z "$BROKEN" ] || { echo "error: broken"; exit 1; }; mkdir -p "$2/app"; '
             'printf "#!/bin/sh\\necho program \\$*\\nexit 3\\n" > "$2/app/asperity"; '
             'chmod +x "$2/app/asperity"',
    "ctest": "exit 8",
    "sudo": "exit 1",
}


class Checkout:
    def __init__(self, script, folder):
        folder.chmod(0o755)
        self.home = folder / "home"
        self.root = folder / "checkout"
        stubs = folder / "stubs"
        for made in (self.home, self.root, stubs):
            made.mkdir(parents=True)
        shutil.copy(script, self.root / "asperity")
        for name, text in STUBS.items():
            (stubs / name).write_text(f"#!/bin/sh\n{text}\n")
            (stubs / name).chmod(0o755)
        self.environment = {"PATH": f"{stubs}:/usr/bin:/bin", "HOME": str(self.home)}
        self.user = {}
        if os.geteuid() == 0:
            os.chown(self.home, NOBODY, NOBODY)
            self.user = {"user": NOBODY, "group": NOBODY, "extra_groups": []}
        self.root.chmod(0o555)

    def run(self, *words, **environment):
        return subprocess.run(
            [self.root / "asperity", *words], env=self.environment | environment,
            cwd=self.home, capture_output=True, text=True, check=False, **self.user)


def expect(condition, what, ended):
    if not condition:
        sys.exit(f"{what}: exit code {ended.returncode}\n{ended.stdout}{ended.stderr}")


def main(script):
    with tempfile.TemporaryDirectory(prefix="asperity-script-") as folder:
        check(Checkout(Path(script), Path(folder)))


def check(checkout):
    ended = checkout.run("run", "polymer")
    builds = list((checkout.home / ".cache/asperity").glob("build-*/app/asperity"))
    expect(ended.returncode == 3 and ended.stdout == "program run polymer\n",
           "the program's words and exit code come through", ended)
    expect(len(builds) == 1, "the build is in the cache", ended)
    expect([p.name for p in checkout.root.iterdir()] == ["asperity"],
           "the checkout is left alone", ended)

    ended = checkout.run("list", XDG_CACHE_HOME=str(checkout.home / "xdg"))
    expect(ended.returncode == 3 and list((checkout.home / "xdg/asperity").glob("build-*")),
           "the build follows XDG_CACHE_HOME", ended)
    ended = checkout.run("list", ASPERITY_BUILD="mine/build")
    expect(ended.returncode == 3 and (checkout.home / "mine/build/app/asperity").exists(),
           "the build follows ASPERITY_BUILD", ended)

    ended = checkout.run("list", ASPERITY_BUILD="/proc/nowhere/build")
    expect(ended.returncode == 4 and "ASPERITY_BUILD" in ended.stderr,
           "a build folder that cannot be made is a system error", ended)
    ended = checkout.run("list", BROKEN="yes")
    expect(ended.returncode == 4 and "error: broken" in ended.stderr,
           "a failed build is a system error", ended)
    ended = checkout.run("list", MISSING="ninja-build")
    expect(ended.returncode == 4 and "apt-get" in ended.stderr,
           "a missing package is a system error", ended)
    ended = checkout.run("test")
    expect(ended.returncode == 1, "failed tests are exit code 1", ended)

    checkout.root.chmod(0o777)
    ended = checkout.run("list")
    expect(ended.returncode == 3 and (checkout.root / "build/release/app/asperity").exists(),
           "a checkout that can be written to is built in itself", ended)


if __name__ == "__main__":
    main(*sys.argv[1:])
