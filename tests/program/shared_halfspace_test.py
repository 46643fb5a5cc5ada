"""Half-spaces and condensed blocks whose rows the ranks of mpirun share: the numbers of one process,
also when a run is resumed by another number of ranks, and for steps that the cache of one process
has kept.

Arguments: asperity, mpirun, an empty folder. Tolerance: that of the solver, 1e-6 of the rms height,
with a factor for the numbers that follow.
"""
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

from rough_case import rough_case

CASE = rough_case("shared", points=512, realizations=1, steps=4, methods="""[theory]
gamma = 0.42
[halfspace]
contact = "hard"
[halfspace.thin]
contact = "penalty"
penalty = "100 E*/h"
thickness = "0.5 length"
top = "sliding"
[fem.q1]
element = "Q1"
[fem]
element = "Q2"
""")
SHARED = ["fem", "fem.q1", "halfspace", "halfspace.thin"]
ALONE = {"halfspace.sticky": "the solver of adhesion works on whole surfaces",
         "halfspace.island": "free boundaries are treated on whole surfaces"}
FREE = ["--set", 'halfspace.island.boundaries="free"']
TOLERANCE = "1e-5"
LOADS = ['"0.001 E*"', '"0.003 E*"', '"0.01 E*"', '"0.02 E*"']
PATIENCE = 200.0  # [s]


class Runner:
    def __init__(self, program, mpirun, folder):
        self.program, self.mpirun, self.folder = program, mpirun, folder

    def start(self, *words, ranks=1, output=subprocess.PIPE, cache="cache"):
        environment = os.environ | {
            "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
            "OMPI_MCA_mpi_yield_when_idle": "1", "OMP_NUM_THREADS": "1",
            "XDG_CACHE_HOME": str(self.folder / cache)}
        several = [self.mpirun, "-np", str(ranks), "--oversubscribe"] if ranks > 1 else []
        return subprocess.Popen([*several, self.program, *words], cwd=self.folder, text=True,
                                env=environment, stdout=output,
                                stderr=subprocess.STDOUT)

    def run(self, *words, ranks=1, code=0, cache="cache"):
        process = self.start(*words, ranks=ranks, cache=cache)
        output, _ = process.communicate(timeout=280)
        assert process.returncode == code, f"{words}: {process.returncode}, not {code}\n{output}"
        return output


def of_steps(n):
    """A run of the half-space at the first loads."""
    return ["run", "shared.toml", "--methods", "halfspace", "--exactly", "--no-report",
            "--set", f"load.nominal_pressure=[{', '.join(LOADS[:n])}]"]


def shared_by(output):
    """The methods whose rows are shared, with the number of ranks."""
    return re.findall(r"^(\S+), realization 0: (\d) ranks share the rows", output, re.M)


def check_agreement(runner):
    """The numbers are those of one process within the tolerance of the solver. 518 rows on 3 ranks:
    the last one has fewer rows, and the columns are no multiple."""
    ask = ["run", "shared.toml", "--methods", ",".join(["theory", *SHARED]), "--exactly",
           "--no-cache", "--no-report", "--set", 'load.nominal_pressure=["0.01 E*"]',
           "--set", "surface.points=518"]
    assert not shared_by(runner.run(*ask, "--out", "alone"))
    output = runner.run(*ask, "--out", "on-3", ranks=3)
    assert sorted(shared_by(output)) == [(name, "3") for name in SHARED], output
    runner.run("diff", "alone", "on-3", "--tolerance", TOLERANCE)


def check_plan_of_refusals(runner):
    """The plan says what rank 0 solves alone, and why."""
    plan = runner.run("run", "shared.toml", "--exactly", "--methods", ",".join(ALONE), *FREE,
                      "--set", 'halfspace.sticky.contact="exponential"', "--set",
                      "halfspace.sticky.work_of_adhesion=1e-4", "--dry-run", ranks=2)
    for name, reason in ALONE.items():
        assert f"{name}: rank 0 solves it alone, because {reason}" in plan, plan
    row = " ".join(str(x % 7) for x in range(16384))
    (runner.folder / "wide.txt").write_text(f"{row}\n" * 16)
    (runner.folder / "wide.toml").write_text(re.sub(
        r"(?s)\[surface\].*?(?=\[material\])",
        '[surface]\nkind = "measured"\nlevel = "plane"\nfile = "wide.txt"\nlength = "1024 um"\n'
        'length_y = "1 um"\nheight_unit = "1 nm"\nedges = "periodic"\n', CASE))
    ask = ["run", "wide.toml", "--methods", "halfspace", "--exactly", "--dry-run"]
    sentence = "rank 0 solves it alone, because 16 rows cannot be divided among 3 ranks by " \
        "multiples of 8"
    assert f"halfspace: {sentence}" in runner.run(*ask, ranks=3)
    assert "alone" not in runner.run(*ask, ranks=2)


def check_studies(runner):
    """Rank 0 finds flow, spots, conductance and slip of the gathered maps, beside
    methods that it solves alone, and says why it does."""
    ask = ["run", "shared.toml", "--methods", "theory,halfspace,halfspace.island,winkler",
           "--exactly", "--no-cache", "--no-report", *FREE]
    for setting in ["flow={ viscosity = 1e-3, pressure_drop = 1e5 }", "spots={}",
                    "conductance={ thermal_conductivity = 50.0, gap_conductivity = 0.026, "
                    "counter_thermal_conductivity = 16.0, smallest_gap = 1e-9 }",
                    "friction.coefficient=0.3", "winkler.stiffness=1 E*/h",
                    "magnification={ nominal_pressure = 1e6, from = 1.0, to = 8.0, points = 4 }",
                    'load.nominal_pressure=["0.002 E*"]']:
        ask += ["--set", setting]
    runner.run(*ask, "--out", "studies-alone")
    output = runner.run(*ask, "--out", "studies-2", ranks=2)
    assert shared_by(output) == [("halfspace", "2")], output
    assert ("halfspace.island, realization 0: rank 0 solves it alone, because "
            f"{ALONE['halfspace.island']}") in output, output
    runner.run("diff", "studies-alone", "studies-2", "--tolerance", TOLERANCE)


def check_plan(runner):
    output = runner.run("run", "shared.toml", "--dry-run", ranks=2)
    for name in SHARED:
        assert output.count(f"{name}: 2 ranks share the rows") == 1, output
    assert "ranks" not in runner.run("run", "shared.toml", "--dry-run")
    small = runner.run("run", "shared.toml", "--dry-run", "--methods", "halfspace", "--exactly",
                       "--set", "surface.points=256", ranks=2)
    assert "share the rows" not in small, small


def check_cache(runner):
    """Steps that one process kept are taken over, and ranks continue from its
    state; one process continues from theirs. Rank 0 finds the stresses inside."""
    runner.run(*of_steps(4), "--no-cache", "--out", "whole")
    runner.run(*of_steps(1), "--out", "kept")
    output = runner.run(*of_steps(2), "--set", "report.stress_inside=true", "--out", "kept",
                        ranks=2)
    assert "not computed" not in output, output
    assert "2 steps: 1 computed, 1 from the cache" in output, output
    output = runner.run(*of_steps(4), "--out", "kept")
    assert "4 steps: 2 computed, 2 from the cache" in output, output
    assert "again" not in output, output
    runner.run("diff", "whole", "kept", "--tolerance", TOLERANCE)


def check_kill(runner):
    """A killed rank ends all; --resume on other ranks computes what is missing."""
    ask = [*of_steps(4), "--no-cache", "--out", "killed"]
    log = runner.folder / "killed.log"
    with open(log, "w", encoding="utf-8") as file:
        process = runner.start(*ask, ranks=3, output=file)
    end = time.monotonic() + PATIENCE
    while "] 1/4" not in log.read_text(encoding="utf-8"):
        assert time.monotonic() < end and process.poll() is None, "no step"
        time.sleep(0.01)
    ranks = subprocess.run(["pgrep", "-P", str(process.pid)], stdout=subprocess.PIPE, text=True,
                           check=True).stdout.split()
    os.kill(int(ranks[-1]), signal.SIGKILL)
    start = time.monotonic()
    code = process.wait(timeout=280)
    assert code != 0 and time.monotonic() - start < 30.0, log.read_text(encoding="utf-8")
    output = runner.run(*ask, "--resume", ranks=2)
    assert shared_by(output) == [("halfspace", "2")], output
    assert 0 < int(re.search(r"(\d) steps: ", output)[1]) < 4, output
    runner.run("diff", "killed", "whole", "--tolerance", TOLERANCE)


def main(program, mpirun, folder):
    folder = Path(folder)
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    (folder / "shared.toml").write_text(CASE)
    runner = Runner(program, mpirun, folder)
    for check in (check_plan, check_agreement, check_plan_of_refusals, check_studies,
                  check_cache, check_kill):
        check(runner)


if __name__ == "__main__":
    main(*sys.argv[1:])
