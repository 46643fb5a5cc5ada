"""Realisations and points of a sweep, distributed by mpirun: the numbers of one
process, also with more ranks than members and after a rank's work was killed,
and a case that is refused once.

Arguments: asperity, mpirun, an empty folder.
"""
import filecmp
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

from rough_case import rough_case

CASE = rough_case("small", points=64, realizations=3, steps=4, methods="""[theory]
gamma = 0.42
[halfspace]
contact = "hard"
[fem]
contact = "penalty"
penalty = "100 E*/h"
""")
SWEEP = """[sweep]
"surface.hurst" = [0.5, 0.8]
"""
PATIENCE = 60.0  # [s]


class Runner:
    def __init__(self, program, mpirun, folder):
        self.program, self.mpirun, self.folder = program, mpirun, folder

    def start(self, *words, ranks=1):
        environment = os.environ | {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMP_NUM_THREADS": "1",
                                    "OMPI_MCA_mpi_yield_when_idle": "1",
                                    "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
        several = [self.mpirun, "-np", str(ranks), "--oversubscribe"] if ranks > 1 else []
        return subprocess.Popen([*several, self.program, *words], cwd=self.folder, text=True,
                                env=environment, stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT)

    def run(self, *words, ranks=1, code=0):
        process = self.start(*words, ranks=ranks)
        output, _ = process.communicate(timeout=280)
        assert process.returncode == code, f"{words}: {process.returncode}, not {code}\n{output}"
        return output


def check_ensemble(runner):
    ask = ["run", "rough.toml", "--no-cache", "--methods", "theory,halfspace"]
    runner.run(*ask, "--out", "whole")
    output = runner.run(*ask, ranks=2)
    assert output.count("rough: 3 realisations on 2 ranks") == 1, output
    runner.run("diff", "out/rough", "whole", "--tolerance", "0")
    for name in ("curves.csv", "report.html"):
        assert (runner.folder / "out/rough" / name).exists(), name
    for part in ("1-of-2", "2-of-2"):
        log = (runner.folder / f"out/rough/parts/{part}/log.txt").read_text()
        assert "steps: " in log and "is complete already" not in log, log


def check_repetition(runner):
    """Without --resume everything is computed again, with it nothing."""
    ask = ["run", "rough.toml", "--no-cache", "--methods", "theory,halfspace", "--no-report"]
    runner.run(*ask, "--resume", ranks=2)
    log = runner.folder / "out/rough/parts/2-of-2/log.txt"
    assert "is complete already" in log.read_text(), log.read_text()
    notes = runner.folder / "out/rough/parts/1-of-2/notes.txt"
    notes.write_text("the user's own\n")
    runner.run(*ask, ranks=2)
    assert "is complete already" not in log.read_text(), log.read_text()
    assert notes.read_text() == "the user's own\n"


def check_sweep(runner):
    """Two points leave the third rank without work."""
    ask = ["run", "swept.toml", "--no-cache", "--methods", "theory,halfspace"]
    runner.run(*ask, "--out", "whole-sweep")
    output = runner.run(*ask, ranks=3)
    assert output.count("swept: 2 points on 2 ranks") == 1, output
    for name in ("sweep.csv", "sweep.json"):
        assert filecmp.cmp(runner.folder / "whole-sweep" / name,
                           runner.folder / "out/swept" / name, shallow=False), name


def check_maps(runner):
    """Maps are points, and a refusal of one leaves nothing."""
    maps = runner.folder / "maps"
    maps.mkdir()
    for name in "12":
        rows = "\n".join(" ".join(f"{(3 * i + int(name) * i * j) % 7}e-9" for i in range(8))
                         for j in range(8))
        (maps / f"{name}.txt").write_text("# Channel: Z\n# Width: 4 um\n# Height: 4 um\n"
                                          f"# Value units: m\n{rows}\n")
    ask = ["run", "maps", "--contact-modulus", "2 GPa", "--no-cache"]
    (maps / "bare.txt").write_text("1 2 3\n4 5 6\n7 8 9\n")
    output = runner.run(*ask, ranks=2, code=2)
    assert "bare.txt is a plain matrix" in output and "--height-unit nm" in output, output
    assert not (runner.folder / "out/maps").exists()
    (maps / "bare.txt").unlink()
    output = runner.run(*ask, ranks=2)
    assert output.count("maps: 2 points on 2 ranks") == 1, output
    runner.run(*ask, "--out", "one/maps")
    for name in ("sweep.csv", "sweep.json", "maps.toml"):
        assert filecmp.cmp(runner.folder / "one/maps" / name,
                           runner.folder / "out/maps" / name, shallow=False), name


def check_kill(runner):
    """What a killed part has lost is named, and --resume computes it."""
    ask = ["run", "rough.toml", "--no-cache", "--methods", "halfspace", "--no-report",
           "--set", "surface.points=384", "--set", "surface.realizations=2"]
    runner.run(*ask, "--out", "undivided")
    process = runner.start(*ask, "--out", "killed", ranks=2)
    part = runner.folder / "killed/parts/2-of-2"
    end = time.monotonic() + PATIENCE
    while not ((part / "log.txt").exists() and " 1/4 " in (part / "log.txt").read_text()):
        assert time.monotonic() < end and process.poll() is None, "no step"
        time.sleep(0.01)
    os.kill(int(re.search(r"process (\d+) ", (part / ".lock").read_text())[1]), signal.SIGKILL)
    output, _ = process.communicate(timeout=280)
    assert process.returncode == 2, output
    assert "1 of 2 parts is missing or incomplete" in output, output
    assert "--part 2/2: parts/2-of-2 is running" in output, output
    runner.run(*ask, "--out", "killed", "--resume", ranks=2)
    runner.run("diff", "killed", "undivided", "--tolerance", "0")
    assert "is complete already" in (runner.folder / "killed/parts/1-of-2/log.txt").read_text()


def check_full_block(runner):
    """All ranks solve a full block together, so that its realisations are not
    distributed; the points of a sweep are processes of rank 0 alone."""
    ask = ["run", "rough-3d", "--no-cache", "--no-report", "--methods", "fem",
           "--set", "surface.points=16", "--set", 'load.nominal_pressure=["0.01 E*"]']
    output = runner.run(*ask, "--set", "surface.realizations=2", ranks=2)
    assert "ranks" not in output and output.count("steps: ") == 1, output
    output = runner.run(*ask, "--set", 'sweep."surface.seed"=[1, 2]', "--out", "seeds", ranks=2)
    assert "ranks" not in output and output.count("/2 point") == 2, output
    assert (runner.folder / "seeds/points/001/result.h5").exists()


def check_refusal(runner):
    output = runner.run("run", "rough.toml", "--set", "surface.hurst=2", ranks=2, code=2)
    assert output.count("surface.hurst = 2, but") == 1, output


def main(program, mpirun, folder):
    folder = Path(folder)
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    (folder / "rough.toml").write_text(CASE)
    (folder / "swept.toml").write_text(CASE + SWEEP)
    runner = Runner(program, mpirun, folder)
    for check in (check_ensemble, check_repetition, check_sweep, check_maps, check_kill,
                  check_full_block, check_refusal):
        check(runner)


if __name__ == "__main__":
    main(*sys.argv[1:])
