#!/usr/bin/env python3
"""Predictions of `asperity run --dry-run` against what then happens.

    tools/plan_accuracy.py PROGRAM CASE... > table

Runs each case without a cache in a temporary folder, and prints CPU time and
peak memory, predicted and measured, as a Markdown table. Words after a case, as
in "polymer --methods fem", are given to both calls. Exits 1 if a CPU time is
further off than a factor of two and the run took more than half a second.
"""
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

FACTOR = 2.0
SHORTEST = 0.5  # s; below, loading and probing are all there is
PREDICTED = re.compile(r"^predicted: CPU ([^,]+), .* memory ([^,]+),", re.M)
SCALES = {"s": 1.0, "min": 60.0, "h": 3600.0, "MB": 1.0, "GB": 1e3}
MEBIBYTE = 1.048576  # MB


def number(text):
    """'1.5 min' in seconds, '2 GB' in MB."""
    value, unit = text.split()
    return float(value) * SCALES[unit]


def measured(words, folder, program):
    subprocess.run([program, "run", *words, "--no-cache", "--out", folder],
                   check=False, stdout=subprocess.DEVNULL)
    made = json.loads(Path(folder, "summary.json").read_text())["provenance"]
    return (float(made["CPU time"].split()[0]),
            MEBIBYTE * float(made["peak memory"].split()[0]))


def compare(program, case):
    words = case.split()
    plan = subprocess.run([program, "run", *words, "--no-cache", "--dry-run"],
                          check=True, capture_output=True, text=True).stdout
    predicted = [number(text) for text in PREDICTED.search(plan).groups()]
    with tempfile.TemporaryDirectory() as folder:
        return predicted, measured(words, folder, program)


def main(program, cases):
    worst = 1.0
    print("| case | CPU, predicted | happened | ratio | memory, predicted | "
          "happened | ratio |")
    print("|---|---|---|---|---|---|---|")
    for case in cases:
        (time, memory), (took, peak) = compare(program, case)
        print(f"| `{case}` | {time:.2g} s | {took:.2g} s | {time / took:.2f} | "
              f"{memory:.0f} MB | {peak:.0f} MB | {memory / peak:.2f} |",
              flush=True)
        if took > SHORTEST:
            worst = max(worst, time / took, took / time)
    print(f"\nworst ratio of CPU times: {worst:.2f}")
    return 1 if worst > FACTOR else 0


if __name__ == "__main__":
    assert number("1.5 min") == 90.0 and number("2 GB") == 2e3
    sys.exit(main(sys.argv[1], sys.argv[2:]))
