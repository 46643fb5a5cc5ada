#!/usr/bin/env python3
"""A robustness run that is killed leaves the table of the problems that had ended.

Usage: robustness_kill_test.py PROGRAM FOLDER"""
import csv
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time

PATIENCE = 60  # seconds until the first table, which is written after ten; the run takes a minute


def main(program, folder):
    shutil.rmtree(folder, ignore_errors=True)
    process = subprocess.Popen([program, "robustness", "--instances", "20000", "--only",
                                "theory", "--threads", "1", "--out", folder],
                               stdout=subprocess.DEVNULL, start_new_session=True)
    try:
        begin = time.monotonic()
        tables = []
        while not tables:
            assert process.poll() is None, "the run ended"
            assert time.monotonic() - begin < PATIENCE, "no table was written"
            time.sleep(0.2)
            tables = list(folder.rglob("stress.csv"))
    finally:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()
    with open(tables[0], newline="") as table:
        rows = list(csv.DictReader(table))
    assert rows
    for row in rows:
        assert row["outcome"] in ("verified", "refused"), row
        assert row["family"] == "theory", row
        assert None not in row and None not in row.values(), row


if __name__ == "__main__":
    main(sys.argv[1], pathlib.Path(sys.argv[2]))
