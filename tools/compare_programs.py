#!/usr/bin/env python3
"""Compare the CPU time of two commands in pairs, on a machine that others use.

    tools/compare_programs.py [--pairs 9] "old/bin/asperity args" "new/bin/asperity args"

Runs them in turn, the order swapped from pair to pair, and prints the ratio old/new of user and
system time: its median and the interval between its order statistics that holds the true median
with 95 % or more (binomial). Wall time is shown, not compared. Proves on itself first that it can
tell a ratio.
"""
import argparse
import math
import os
import shlex
import statistics
import subprocess
import sys
import time


def run(command):
    """(CPU, wall) seconds of one run; exits if the command fails."""
    before, start = os.times(), time.monotonic()
    status = subprocess.run(shlex.split(command), stdout=subprocess.DEVNULL).returncode
    wall, after = time.monotonic() - start, os.times()
    if status != 0:
        sys.exit(f"{command}: exit {status}")
    return (after.children_user + after.children_system
            - before.children_user - before.children_system), wall


def interval(values):
    """(low, median, high): the narrowest symmetric order statistics with 95 %, else the range."""
    ordered, n = sorted(values), len(values)
    inside, rank = 1.0, 0
    while 2 * (rank + 1) < n:
        outside = 2 * sum(math.comb(n, k) for k in range(rank + 1)) / 2 ** n
        if 1 - 2 * sum(math.comb(n, k) for k in range(rank + 2)) / 2 ** n < 0.95:
            inside = 1 - outside
            break
        rank += 1
        inside = 1 - outside
    return ordered[rank], statistics.median(ordered), ordered[n - 1 - rank], inside


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--pairs", type=int, default=9)
    parser.add_argument("old")
    parser.add_argument("new")
    options = parser.parse_args()
    low, middle, high, _ = interval([2.0 + 0.01 * k for k in range(9)])
    assert low == 2.01 and high == 2.07 and abs(middle - 2.04) < 1e-12, "cannot tell a ratio"

    run(options.old), run(options.new)  # warm-up
    times = {"old": [], "new": []}
    for pair in range(options.pairs):
        for side in ("old", "new") if pair % 2 == 0 else ("new", "old"):
            times[side].append(run(getattr(options, side)))
    for side, values in times.items():
        cpu, wall = zip(*values)
        print(f"{side}: CPU min {min(cpu):.3f} median {statistics.median(cpu):.3f} max {max(cpu):.3f} s; "
              f"wall min {min(wall):.3f} s; n = {len(cpu)}")
    low, middle, high, inside = interval(
        [old[0] / new[0] for old, new in zip(times["old"], times["new"])])
    print(f"CPU old/new: {middle:.2f} [{low:.2f}, {high:.2f}] ({100 * inside:.0f} %)")


if __name__ == "__main__":
    main()
