"""A rough block that yields answers as CalculiX does on the same mesh: first-order hexahedra, J2 flow
without hardening, hard contact against stiff springs at the nodes, loads up and down.

Arguments: the folder of the adapters, a folder for the problem, asperity.
"""
import csv
import pathlib
import shutil
import subprocess
import sys

import numpy as np

FOLDER, WORK = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
PROGRAM = sys.argv[3]
sys.path.insert(0, str(FOLDER))
import calculix_adapter as calculix  # noqa: E402
import meshed  # noqa: E402
import submission  # noqa: E402

YIELD = 0.02   # [E*], E* h'/5
SPRING = 1e3   # over area [E*/spacing]
WEAK = 1e-7    # spring that holds the rigid surface until it touches [E* spacing]
TOLERANCE = 0.01
LOADS = (0.001, 0.002, 0.004, 0.008, 0.016, 0.004)  # [E*]
CASE = f"""schema = 1
[surface]
kind = "self-affine"
length = "1 um"
points = 16
seed = 7
rms_slope = 0.1
hurst = 0.8
wavelength_long = "1 length"
wavelength_roll_off = "0.5 length"
wavelength_short = "8 h"
[material]
youngs_modulus = "2 GPa"
poisson_ratio = 0.3
[load]
nominal_pressure = [{", ".join(f'"{load} E*"' for load in LOADS)}]
[fem]
solver = "full"
element = "Q1"
depth = "0.5 length"
yield_stress = "{YIELD} E*"
"""


def deck(mesh):
    """The heights grow in the first step, until the highest touches; then the loads act one after another."""
    text, bound, leader = calculix.block(mesh, f"{YIELD},0\n{YIELD * (1 + 1e-9):.15f},9\n")
    spring = 1 + sum(len(group[1]) for group in mesh.groups) + mesh.heights.size
    text += f"*ELEMENT,TYPE=SPRING1,ELSET=weak\n{spring},{leader}\n*SPRING,ELSET=weak\n3\n{WEAK:.1e}\n"
    text += f"*GAP,ELSET=gaps\n0,0,0,1,,{SPRING * mesh.area:.12e},1e-12\n"
    head = f"*STEP,INC=1000\n*STATIC\n1,1\n*BOUNDARY,OP=NEW\n{bound}"
    text += f"{head}{leader},3,3,{-mesh.heights.max():.12e}\n*END STEP\n"
    for load in LOADS:
        force = load * mesh.heights.size * mesh.area
        text += f"{head}*CLOAD,OP=NEW\n{leader},3,{force:.12e}\n"
        text += "*NODE PRINT,NSET=rigid,FREQUENCY=1000\nRF,U\n*NODE PRINT,NSET=face,FREQUENCY=1000\nU\n"
        text += "*EL PRINT,ELSET=block,FREQUENCY=1000\nPEEQ\n*END STEP\n"
    return text


def theirs(folder):
    """Mean gap [m], area fraction and largest plastic strain under each load."""
    problem = submission.read_problem(folder, True, False)
    mesh = meshed.read_mesh(problem)
    (WORK / "block.inp").write_text(deck(mesh), encoding="utf-8")
    meshed.run(["ccx", "block"], WORK, calculix.GIVEN)
    values = calculix.printed((WORK / "block.dat").read_text(encoding="utf-8"))
    force, strain = values["forcesRIGID"], values["equivalentBLOCK"]
    gap = [face - rigid for face, rigid in
           zip(values["displacementsFACE"], values["displacementsRIGID"], strict=True)]
    rows = list(zip(gap, force, strain, strict=True))[-len(LOADS):]
    for (_, forces, _), load in zip(rows, LOADS, strict=True):
        assert abs(forces.sum() / (mesh.heights.size * mesh.area) / load - 1) < 1e-4, (forces.sum(), load)
    return [(gaps.mean() * mesh.spacing, (np.abs(forces) > 1e-6 * np.abs(forces).max()).mean(), strains.max())
            for gaps, forces, strains in rows]


if not shutil.which("ccx"):
    print("skipped: needs calculix-ccx")
    sys.exit(77)
shutil.rmtree(WORK, ignore_errors=True)
WORK.mkdir(parents=True)
(WORK / "case.toml").write_text(CASE, encoding="utf-8")
for arguments in (["problem", WORK / "case.toml", "--mesh", "--out", WORK / "problem",
                   "--set=fem.solver=condensed", "--set=fem.yield_stress="],
                  ["run", WORK / "case.toml", "--methods", "fem", "--out", WORK / "out"]):
    subprocess.run([PROGRAM, *arguments], check=True, timeout=300, stdout=subprocess.DEVNULL)
with open(WORK / "out/curves.csv", encoding="utf-8") as file:
    ours = [tuple(float(row[key]) for key in ("mean_gap [m]", "area_fraction [1]", "plastic_strain [1]"))
            for row in csv.DictReader(file)]
for mine, other in zip(ours, theirs(WORK / "problem"), strict=True):
    print("ours", *(f"{value:.6g}" for value in mine), "CalculiX", *(f"{value:.6g}" for value in other))
    assert np.allclose(mine, other, rtol=TOLERANCE, atol=0), (mine, other)
assert ours[-1][2] > 0.08 and ours[-1][0] < 0.6 * ours[2][0], "nothing has flowed"
