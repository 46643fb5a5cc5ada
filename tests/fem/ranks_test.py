"""Several ranks give the curve of one to 1e-9 of each number.

Arguments: the program ranks_curves, mpirun, numbers of ranks. Tolerance: as required; systems are
solved to 1e-12 and the condition number of a block is some 1e3. Stiffnesses follow
from systems solved to 1e-8 and are compared to 1e-7.
"""
import math
import os
import subprocess
import sys


def curves(command):
    # Two ranks on a busy core must not wait by spinning.
    root = {"OMPI_MCA_mpi_yield_when_idle": "1", "OMPI_ALLOW_RUN_AS_ROOT": "1",
            "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMP_NUM_THREADS": "1"}
    done = subprocess.run(command, env=os.environ | root, text=True, timeout=400,
                          stdout=subprocess.PIPE, check=True)
    rows, notes = [], []
    for line in done.stdout.splitlines():
        if line.startswith("#"):
            notes.append(line)
        elif len(line.split()) == 6:
            rows.append(line.split())
    return rows, notes


def differences(one, two):
    """Yields (row name, value, value) for each pair of numbers that differ."""
    assert one and [row[0] for row in one] == [row[0] for row in two]
    for a, b in zip(one, two):
        assert a[1] == "1" and b[1] == "1", f"not converged: {a} {b}"
        tolerance = 1e-7 if a[0] == "sticking" else 1e-9
        for x, y in zip(map(float, a[2:]), map(float, b[2:])):
            if not (math.isfinite(x) and abs(x - y) <= tolerance * abs(x)):
                yield a[0], x, y


def main(program, mpirun, *numbers):
    sample = [["self", "1", "1.0", "2.0", "3.0", "4.0"]]
    for value in ("4.00000001", "nan", "inf"):
        other = [sample[0][:5] + [value]]
        assert list(differences(sample, other)), "cannot fail"
        assert list(differences(other, sample)), "cannot fail"
    assert not list(differences(sample, sample)), "cannot pass"

    one, notes_of_one = curves([program])
    assert len(one) == 65, f"{len(one)} rows"
    assert all("1 rank" in note for note in notes_of_one), notes_of_one
    n_found = 0
    # Three ranks share the rows of a box_grid. Five ranks have too few of them.
    for ranks in numbers:
        which, expected = ([], one) if ranks == "2" else (["box_grid"], one[20:40])
        several, notes = curves([mpirun, "-np", ranks, "--oversubscribe", program] + which)
        assert all(f"{ranks} ranks" in note for note in notes), notes
        for name, x, y in differences(expected, several):
            print(f"{name}: {x:.16e} on one rank, {y:.16e} on {ranks}")
            n_found += 1
    return 1 if n_found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
