#!/usr/bin/env python3
"""The script ./asperity: where it builds, what it says meanwhile, and its exit codes.

script_test.py SCRIPT: runs a copy of the script with stubs of cmake, ninja, ctest and dpkg-query.
If it is root it changes to another user first, because root may write everywhere.
"""
import fcntl
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
    "ninja": 'echo "[7/120] Building"; sleep "${BUILD_SECONDS:-0}"; [ -z "$BROKEN" ] || { echo "error: broken"; exit 1; }; mkdir -p "$2/bin"; '
             'printf "#!/bin/sh\\necho program \\$*\\nexit 3\\n" > "$2/bin/asperity"; '
             'chmod +x "$2/bin/asperity"',
    "ctest": '[ "$3" != -N ] || { echo "  Test  #7: reports/browser"; exit 0; }; exit 8',
    # Another apt-get holds the lock for two tries.
    "sudo": '[ -n "$LOCKED" ] || exit 1; n=$(cat "$HOME/tries" 2>/dev/null || echo 0); '
            'echo $((n + 1)) > "$HOME/tries"; [ "$n" -ge 2 ] || '
            '{ echo "E: Could not get lock /var/lib/apt/lists/lock. It is held by process 7"; exit 100; }; '
            'echo "$*" >> "$HOME/apt.log"',
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

    def run(self, *words, script=None, **environment):
        return subprocess.run(
            [script or self.root / "asperity", *words], env=self.environment | environment,
            cwd=self.home, capture_output=True, text=True, check=False, timeout=50, **self.user)


def expect(condition, what, ended):
    if not condition:
        sys.exit(f"{what}: exit code {ended.returncode}\n{ended.stdout}{ended.stderr}")


def main(script):
    with tempfile.TemporaryDirectory(prefix="asperity-script-") as folder:
        checkout = Checkout(Path(script), Path(folder))
        check(checkout)
        check_foreign_folders(checkout)
        check_waiting(checkout)


def check(checkout):
    ended = checkout.run("run", "polymer")
    builds = list((checkout.home / ".cache/asperity").glob("build-*/bin/asperity"))
    expect(ended.returncode == 3 and ended.stdout == "program run polymer\n",
           "the program's words and exit code come through", ended)
    expect(len(builds) == 1, "the build is in the cache", ended)
    expect([p.name for p in checkout.root.iterdir()] == ["asperity"],
           "the checkout is left alone", ended)

    ended = checkout.run("list", XDG_CACHE_HOME=str(checkout.home / "xdg"))
    expect(ended.returncode == 3 and list((checkout.home / "xdg/asperity").glob("build-*")),
           "the build follows XDG_CACHE_HOME", ended)
    ended = checkout.run("list", ASPERITY_BUILD="mine/build")
    expect(ended.returncode == 3 and (checkout.home / "mine/build/bin/asperity").exists(),
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
    ended = checkout.run("list", MISSING="ninja-build", LOCKED="yes")
    words = (checkout.home / "apt.log").read_text()
    expect(ended.returncode == 3 and ended.stderr.count("waiting for another apt-get to end: E: "
                                                        "Could not get lock") == 1
           and "update" in words and "install" in words and "ninja-build" in words,
           "another apt-get is waited for, and the user is told", ended)
    ended = checkout.run("test")
    expect(ended.returncode == 1 and "skipped" not in ended.stderr,
           "failed tests are exit code 1", ended)
    ended = checkout.run("test", MISSING="chromium")
    expect(ended.returncode == 1 and "skipped: what needs chromium" in ended.stderr,
           "a package of some tests that cannot be had ends nothing", ended)
    ended = checkout.run("test", MISSING="lammps")
    expect(ended.returncode == 1 and "lammps" not in ended.stderr,
           "packages of tests that do not run are not installed", ended)

    checkout.root.chmod(0o777)
    ended = checkout.run("list")
    expect(ended.returncode == 3 and (checkout.root / "build/release/bin/asperity").exists(),
           "a checkout that can be written to is built in itself", ended)


def check_foreign_folders(checkout):
    foreign = checkout.home / "foreign"
    foreign.mkdir()
    (foreign / "thesis.tex").write_text("years of work")
    foreign.chmod(0o777)
    ended = checkout.run("list", ASPERITY_BUILD=str(foreign))
    expect(ended.returncode == 4 and "no build of Asperity" in ended.stderr
           and (foreign / "thesis.tex").exists(), "a folder with other files is left alone", ended)

    link_folder = checkout.home / "links"
    (link_folder / "build/release").mkdir(parents=True)
    (link_folder / "build/release/mine.txt").write_text("mine")
    link_folder.chmod(0o777)
    (link_folder / "asperity").symlink_to(checkout.root / "asperity")
    ended = checkout.run("list", script=link_folder / "asperity")
    expect(ended.returncode == 3 and (link_folder / "build/release/mine.txt").exists(),
           "a symbolic link stands for the checkout that it points to", ended)

    (checkout.root / "build/release/CMakeCache.txt").write_text(
        "CMAKE_PROJECT_NAME:STATIC=asperity\nCMAKE_HOME_DIRECTORY:INTERNAL=/elsewhere\n")
    ended = checkout.run("list")
    expect(ended.returncode == 3 and "configuring" in ended.stderr,
           "a build of Asperity that was copied along is made again", ended)


def check_waiting(checkout):
    ended = checkout.run("list", BUILD_SECONDS="1", ASPERITY_PROGRESS_SECONDS="0.4")
    expect("building: step 7 of 120" in ended.stderr, "a long build says how far it is", ended)

    lock = checkout.root / "build/release.lock"
    released = checkout.home / "released"
    held = "flock \"$0\" sh -c 'until test -e \"$0\"; do sleep 0.1; done' \"$1\""
    with lock.open() as file, subprocess.Popen(["sh", "-c", held, lock, released],
                                               **checkout.user):
        while True:  # until the other process holds the lock
            try:
                fcntl.flock(file, fcntl.LOCK_SH | fcntl.LOCK_NB)
            except BlockingIOError:
                break
            fcntl.flock(file, fcntl.LOCK_UN)
        ended = checkout.run("list", BROKEN="yes")
        expect(ended.returncode == 3 and "waiting" not in ended.stderr,
               "a current program runs beside another build", ended)
        (checkout.root / "new.cpp").write_text("")
        with subprocess.Popen([checkout.root / "asperity", "list"], env=checkout.environment,
                              cwd=checkout.home, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              text=True, **checkout.user) as waiting:
            words = waiting.stderr.readline()
            released.write_text("")
            waiting.communicate(timeout=50)
        expect(waiting.returncode == 3 and "waiting for another build" in words,
               "an outdated program waits for another build and says so", ended)

    ended = checkout.run("list")
    checkout.root.chmod(0o555)
    for path in checkout.root.rglob("*"):
        path.chmod(0o555)
    if os.geteuid() == 0:  # a build of another user, which this one can only read
        os.chown(checkout.root / "build", 0, 0)
        os.chown(checkout.root / "build/release", 0, 0)
        ended = checkout.run("list", BROKEN="yes")
        expect(ended.returncode == 3, "a current program of another user is run", ended)


if __name__ == "__main__":
    main(*sys.argv[1:])
