"""The program under mpirun: only rank 0 writes, two ranks give the curve of
one to 1e-9, and a case that is refused ends all of them. Another number of
ranks can mean another solver of the linear systems; the contact is therefore
solved to 1e-10 instead of the default 1e-8.

Arguments: asperity, mpirun, a case, an empty folder. Tolerance: as required.
"""
import csv
import glob
import math
import os
import shutil
import subprocess
import sys

NUMBERS = ["nominal_pressure [Pa]", "mean_gap [m]", "area_fraction [1]",
           "area_fraction_corrected [1]", "area_fraction_fit [1]",
           "area_fraction_moment [1]", "contact_perimeter [1/m]",
           "elastic_energy [J/m^2]"]
# A least-squares minimum is known to half the digits of a double.
TOLERANCES = {"area_fraction_fit [1]": 3e-8}


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
    """The numbers that differ by a relative 1e-9. A column that is missing and a
    table without rows are errors, and so is a number that is not finite, but
    for a fit that has too few nodes in contact in both."""
    assert one and len(one) == len(two), (len(one), len(two))
    for a, b in zip(one, two):
        for name in NUMBERS:
            x, y = float(a[name]), float(b[name])
            if math.isnan(x) and math.isnan(y) and name.startswith("area_fraction_fit"):
                continue  # too few nodes in contact for a histogram
            if not (math.isfinite(x) and abs(x - y) <= TOLERANCES.get(name, 1e-9) * abs(x)):
                yield a["method"], name, x, y


def sections(folder):
    """The von Mises stress of each drawn section, by the name of its file."""
    found = {}
    for path in glob.glob(f"{folder}/figures/stress-section-*.csv"):
        with open(path, encoding="utf-8") as file:
            found[os.path.basename(path)] = [float(row["von Mises/E* [1]"])
                                             for row in csv.DictReader(file)]
    return found


def section_differences(one, two):
    """Sections that differ by more than 1e-9 of their largest value."""
    assert len(one) == 2 and one.keys() == two.keys(), (one.keys(), two.keys())
    for name in one:
        scale = max(one[name])
        assert scale > 0.0 and len(one[name]) == len(two[name]), name
        if not all(abs(x - y) <= 1e-9 * scale for x, y in zip(one[name], two[name])):
            yield (name,)


def main(program, mpirun, case, folder):
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    several = [mpirun, "-np", "2", "--oversubscribe"]
    ask = [program, "run", case, "--set", "surface.points=16", "--no-cache",
           "--set", "report.stress_inside=true", "--set", "fem.tolerance=1e-10",
           "--methods", "fem", "--threads", "1"]
    one = run(ask + ["--out", "one"], folder)
    assert one.returncode == 0, one.stdout
    two = run(several + ask + ["--out", "two"], folder)
    assert two.returncode == 0, two.stdout
    assert two.stdout.count("steps: ") == 1, f"said twice:\n{two.stdout}"
    found = list(differences(rows_of(f"{folder}/one"), rows_of(f"{folder}/two")))
    found += section_differences(sections(f"{folder}/one"), sections(f"{folder}/two"))
    for line in found:
        print(*line)
    refused = run(several + ask + ["--set", "fem.growth=0.5"], folder)
    assert refused.returncode == 2, refused.stdout
    return 1 if found else 0


if __name__ == "__main__":
    sample = [{"method": "fem"} | dict.fromkeys(NUMBERS, "1.0")]
    assert not list(differences(sample, sample)), "cannot pass"
    for name in NUMBERS:
        for other in ("1.0000001", "nan", "inf"):
            changed = [sample[0] | {name: other}]
            assert list(differences(sample, changed)), "cannot fail"
            assert list(differences(changed, sample)), "cannot fail"
    plain = {"a": [1.0, 2.0], "b": [1.0]}
    assert not list(section_differences(plain, plain))
    for value in (2.0 + 1e-8, math.nan):
        assert list(section_differences(plain, plain | {"a": [1.0, value]}))
    sys.exit(main(*sys.argv[1:]))
