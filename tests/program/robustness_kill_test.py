#!/usr/bin/env python3
"""A robustness run that is ended leaves the table of the problems that had ended: killed, and
by SIGTERM, where it says besides how many there were, what is left, and ends with 130.

Usage: robustness_kill_test.py PROGRAM FOLDER"""
import csv
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import time

PATIENCE = 240  # seconds until the first table, which a busy machine writes after a minute
WANTED = 20000  # to be killed
FEW = 4000     # to be ended after a second


def command(program, folder, *more):
    return [program, "robustness", "--only", "theory", "--threads", "1", "--out", folder,
            *map(str, more)]


def started(program, folder, instances, **options):
    shutil.rmtree(folder, ignore_errors=True)
    return subprocess.Popen(command(program, folder, "--instances", instances),
                            start_new_session=True, text=True, **options)


def wait_for(process, found, missing):
    begin = time.monotonic()
    while not found():
        assert process.poll() is None, "the run ended"
        assert time.monotonic() - begin < PATIENCE, missing
        time.sleep(0.2)


def rows_of(folder):
    with open(folder / "stress.csv", newline="", encoding="utf-8") as table:
        rows = list(csv.DictReader(table))
    for row in rows:
        assert row["outcome"] in ("verified", "refused"), row
        assert row["family"] == "theory", row
        assert None not in row and None not in row.values(), row
    return rows


def test_killed(program, folder):
    process = started(program, folder, WANTED, stdout=subprocess.DEVNULL)
    try:
        wait_for(process, (folder / "stress.csv").exists, "no table was written")
    finally:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()
    assert rows_of(folder)


def test_terminated(program, folder):
    process = started(program, folder, FEW, stdout=subprocess.PIPE)
    try:
        wait_for(process, folder.exists, "no folder was made")
        time.sleep(1)
        process.terminate()
        text, _ = process.communicate(timeout=PATIENCE)
    finally:
        process.kill()
    assert process.returncode == 130, process.returncode
    rows = rows_of(folder)
    verified = sum(row["outcome"] == "verified" for row in rows)
    assert f" {verified} verified, " in text, text
    said = re.search(r"interrupted after (\d+) of (\d+) problem instances; continue with asperity "
                     r"robustness --seed 1 --only theory --first (\d+) --instances (\d+)", text)
    assert said, text
    ended, all_wanted, first, left = map(int, said.groups())
    assert (ended, all_wanted, ended + left) == (len(rows), FEW, FEW), text
    known = {int(row["instance"]) for row in rows}
    assert first > max(known, default=-1)
    rest = folder.with_name("rest")
    shutil.rmtree(rest, ignore_errors=True)
    subprocess.run(command(program, rest, "--first", first, "--instances", 2), check=True,
                   stdout=subprocess.DEVNULL)
    assert int(rows_of(rest)[0]["instance"]) == first  # one thread: nothing twice, nothing left out


if __name__ == "__main__":
    test_terminated(sys.argv[1], pathlib.Path(sys.argv[2]) / "terminated")
    test_killed(sys.argv[1], pathlib.Path(sys.argv[2]) / "killed")
