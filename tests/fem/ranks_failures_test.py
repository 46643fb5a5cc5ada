"""A failure on any rank ends all of them with its message and its exit code.

Arguments: the program ranks_failures, mpirun, an empty folder. The time limit
of a run ends a deadlock, in which ranks wait for one another.
"""
import os
import shutil
import subprocess
import sys

CASE = """schema = 1
title = "A small block"

[surface]
kind = "wave-1d"
length = "1 um"
points = 8
amplitude = "1 nm"
wavelength = "1 length"

[material]
youngs_modulus = "2 GPa"
poisson_ratio = 0.3
{material}

[load]
nominal_pressure = ["0.01 E*"]

[fem]
element = "Q1"
solver = "full"
{fem}
"""

# One cube.
MSH = """$MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
8
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
5 0 0 1
6 1 0 1
7 1 1 1
8 0 1 1
$EndNodes
$Elements
3
1 3 2 1 1 1 2 3 4
2 3 2 2 2 5 6 7 8
3 5 2 3 3 1 2 3 4 5 6 7 8
$EndElements
"""

RANKS = 2


def run(command, folder):
    environment = os.environ | {
        "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
        "OMPI_MCA_mpi_yield_when_idle": "1", "OMP_NUM_THREADS": "1"}
    return subprocess.run(command, env=environment, cwd=folder, text=True, timeout=100,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)


def write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def wrong_ends(ranked, folder):
    """Yields (stage, when, rank, mistake) for each failure that is not handled."""
    for stage, when, rank in (("build", "before", "1"), ("solve", "before", "0"),
                              ("write", "after", "1"), ("solve", "before", "all")):
        try:
            done = run(ranked + ["case.toml", stage, when, rank], folder)
        except subprocess.TimeoutExpired:
            yield stage, when, rank, "hangs"
            continue
        teller = "0" if rank == "all" else rank
        if done.returncode != 4:
            yield stage, when, rank, f"exit code {done.returncode}\n{done.stdout}"
        if f"injected into {stage} on rank {teller}" not in done.stdout:
            yield stage, when, rank, f"does not say why\n{done.stdout}"
        if "done" in done.stdout.split():
            yield stage, when, rank, "goes on"


def main(program, mpirun, folder):
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    ranked = [mpirun, "-np", str(RANKS), "--oversubscribe", program]
    write(f"{folder}/case.toml", CASE.format(material="", fem="growth = 1.5"))
    write(f"{folder}/mesh.toml", CASE.format(material="", fem="") + """
[mesh]
kind = "gmsh"
geometry = "file"
file = "block.msh"
file_unit = "1 um"
""")
    write(f"{folder}/block.msh", MSH)
    write(f"{folder}/wrong.toml", CASE.format(material="""
[material.variation]
kind = "function"
factor = "x - 0.5"
""", fem="growth = 1.5"))

    meshed = run(ranked + ["mesh.toml", "none"], folder)
    assert meshed.returncode == 0 and "done 1" in meshed.stdout, meshed.stdout

    write(f"{folder}/table.toml", CASE.format(material="""
[material.variation]
kind = "table"
file = "factors.txt"
""", fem="growth = 1.5"))
    write(f"{folder}/factors.txt", "# boxes 2 2 2\n1 2\n")
    for case, words in (("wrong.toml", "factor of the modulus at ("),
                        ("table.toml", "factors.txt:2: expected a line")):
        wrong = run(ranked + [case, "none"], folder)
        assert wrong.returncode == 2, (wrong.returncode, wrong.stdout)
        assert words in wrong.stdout, wrong.stdout
    found = list(wrong_ends(ranked, folder))
    for line in found:
        print(*line)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
