"""The program under mpirun: rank 0 alone writes, two ranks give one rank's
curve to 1e-9, and a case that is refused ends all of them.

Arguments: asperity, mpirun, a case, an empty folder. Tolerance: the issue's.
"""
import csv
import math
import os
import shutil
import subprocess
import sys

NUMBERS = ["nominal_pressure", "mean_gap", "area_fraction", "elastic_energy",
           "von_mises"]


def run(command, folder):
    root = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
            "OMP_NUM_THREADS": "1"}
    return subprocess.run(command, env=os.environ | root, cwd=folder, text=True,
                          timeout=280, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT)


def rows_of(folder):
    with open(os.path.join(folder, "curves.csv"), encoding="utf-8") as file:
        return list(csv.DictReader(file))


def differences(one, two):
    """What differs by more than 1e-9 of itself."""
    assert len(one) == len(two), (len(one), len(two))
    for a, b in zip(one, two):
        for name in a:
            if name.split(" ")[0] in NUMBERS:
                x, y = float(a[name]), float(b[name])
                same = (math.isnan(x) and math.isnan(y)) or abs(x - y) <= 1e-9 * abs(x)
                if not same:
                    yield a["method"], name, x, y


def main(program, mpirun, case, folder):
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    several = [mpirun, "-np", "2", "--oversubscribe"]
    ask = [program, "run", case, "--set", "surface.points=16", "--no-cache",
           "--methods", "fem", "--threads", "1"]
    one = run(ask + ["--out", "one"], folder)
    assert one.returncode == 0, one.stdout
    two = run(several + ask + ["--out", "two"], folder)
    assert two.returncode == 0, two.stdout
    assert two.stdout.count("steps: ") == 1, f"said twice:\n{two.stdout}"
    found = list(differences(rows_of(f"{folder}/one"), rows_of(f"{folder}/two")))
    for line in found:
        print(*line)
    refused = run(several + ask + ["--set", "fem.growth=0.5"], folder)
    assert refused.returncode == 2, refused.stdout
    return 1 if found else 0


if __name__ == "__main__":
    sample = [{"method": "fem", "mean_gap [m]": "1.0"}]
    other = [{"method": "fem", "mean_gap [m]": "1.00000001"}]
    assert list(differences(sample, other)), "cannot fail"
    sys.exit(main(*sys.argv[1:]))
