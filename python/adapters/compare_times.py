#!/usr/bin/env python3
"""Times of codes that can be compared: all of them in alternation, in one run.

    compare_times.py PROBLEM_DIR OUT_DIR --pairs 3 "numpy_polonsky_keer.py" \\
        "calculix_adapter.py --element C3D8"

Runs the adapters there and back (A B B A) as many times as there are pairs, each on one
thread, and writes OUT_DIR/1, OUT_DIR/2, ...: the last answer of each with the median of its
CPU times, their lowest and highest value, its peak memory and the table [timing].
"""
import argparse
import hashlib
import os
import pathlib
import shlex
import statistics
import subprocess
import sys
import tomllib

import submission

HERE = pathlib.Path(__file__).resolve().parent
THREADS = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), "1")


def answer_of(adapter, problem, folder):
    """The submission of an adapter, each load with its peak memory."""
    name, *options = shlex.split(adapter)
    child = subprocess.Popen([sys.executable, HERE / name, problem, folder, *options],
                             env=os.environ | THREADS)
    _, status, used = os.wait4(child.pid, 0)
    if status != 0:
        sys.exit(f"{adapter}: ended with the exit code {os.waitstatus_to_exitcode(status)}")
    found = tomllib.loads((folder / "submission.toml").read_text(encoding="utf-8"))
    for load in found["load"]:  # of the adapter with all that it started, if it does not say
        load.setdefault("peak_memory", 1024 * used.ru_maxrss)
    return found


def text_of(answers, run, pairs, heights):
    """submission.toml with the times of all answers."""
    last = answers[-1]
    loads = last.pop("load")
    text = submission.toml(**last) + "\n[timing]\n" + submission.toml(
        run=run, pairs=pairs, threads=1, heights=heights)
    for number, load in enumerate(loads):
        times = [one["load"][number]["cpu_time"] for one in answers[:-1]] + [load["cpu_time"]]
        load |= {"cpu_time": statistics.median(times), "cpu_time_low": min(times),
                 "cpu_time_high": max(times)}
        text += "\n[[load]]\n" + submission.toml(**load)
    return text


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("problem", type=pathlib.Path, metavar="PROBLEM_DIR")
    parser.add_argument("out", type=pathlib.Path, metavar="OUT_DIR")
    parser.add_argument("adapters", nargs="+", metavar="ADAPTER", help="file and its options")
    parser.add_argument("--pairs", type=int, default=3, help="at least 2")
    parser.add_argument("--run", default="unnamed", help="machine and day, as the board shows it")
    given = parser.parse_args()
    if given.pairs < 2 or given.out.exists():
        parser.error("--pairs must be at least 2, and OUT_DIR a new folder")
    heights = hashlib.sha256((given.problem / "heights.npy").read_bytes()).hexdigest()
    order = list(range(len(given.adapters)))
    answers = [[] for _ in order]
    for one in (order + order[::-1]) * given.pairs:
        answers[one].append(answer_of(given.adapters[one], given.problem, given.out / str(one + 1)))
    for one in order:
        (given.out / str(one + 1) / "submission.toml").write_text(
            text_of(answers[one], given.run, given.pairs, heights), encoding="utf-8")


if __name__ == "__main__":
    main()
