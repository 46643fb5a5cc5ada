"""Times of codes are compared in alternation: the order there and back, the medians with their
ends, and the memory of a code that does not state it.

Arguments: the folder of the adapters, a folder for the problems.
"""
import hashlib
import pathlib
import shutil
import subprocess
import sys
import tomllib

import numpy as np

from problem_folder import write_problem

# Notes its turn and states the number of all turns so far as its time.
CODE = """import pathlib, sys
folder, name = pathlib.Path(sys.argv[2]), sys.argv[4]
folder.mkdir(parents=True, exist_ok=True)
turns = folder.parent.parent / "turns"
with open(turns, "a") as file:
    file.write(name)
(folder / "submission.toml").write_text(f'''problem = "rough"
code = "{name}"
authors = ["A", "B"]
[[load]]
nominal_pressure = 1e6
pressure = "p.npy"
cpu_time = {len(turns.read_text())}
''' + ("peak_memory = 5\\n" if name == "a" else ""))
"""


def main():
    problem = write_problem(WORK / "rough", np.eye(4), 1e-6, 1e-6, [1e6])
    (WORK / "code.py").write_text(CODE, encoding="utf-8")
    adapters = [f"{WORK}/code.py --name {name}" for name in "ab"]
    command = [sys.executable, TOOL, problem, WORK / "out", *adapters, "--run", "here"]
    subprocess.run(command + ["--pairs", "2"], check=True, timeout=60)
    assert (WORK / "turns").read_text() == "abbaabba"
    for number, times in ((1, (1, 4.5, 8)), (2, (2, 4.5, 7))):
        text = (WORK / f"out/{number}/submission.toml").read_text(encoding="utf-8")
        found = tomllib.loads(text)
        load = found["load"][0]
        assert found["authors"] == ["A", "B"] and found["code"] == "ab"[number - 1], found
        assert (load["cpu_time_low"], load["cpu_time"], load["cpu_time_high"]) == times, load
        assert (load["peak_memory"] == 5) == (number == 1) and load["peak_memory"] < 1e9, load
        assert found["timing"] == {
            "run": "here", "pairs": 2, "threads": 1,
            "heights": hashlib.sha256((problem / "heights.npy").read_bytes()).hexdigest()}, found
    for refused in (["--pairs", "1"], ["--pairs", "2"]):  # and a folder that exists
        assert subprocess.run(command + refused, check=False, timeout=60,
                              stderr=subprocess.DEVNULL).returncode == 2


TOOL, WORK = pathlib.Path(sys.argv[1]).resolve() / "compare_times.py", pathlib.Path(sys.argv[2])
WORK = WORK.resolve()
shutil.rmtree(WORK, ignore_errors=True)
WORK.mkdir(parents=True)
main()
