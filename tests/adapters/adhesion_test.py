"""A path with adhesion by two codes that share no line, the half-space of Asperity and the numpy
template: they find the same states. The board ranks by energy: a state of the way back at the
same mean gap is a minimum, too, and lower or higher.

Arguments: the folder of the adapters, a folder for the problems, asperity.
"""
import json
import pathlib
import shutil
import subprocess
import sys
import tomllib

import numpy as np

from problem_folder import start

CASE = """schema = 1
title = "A sticky surface"
[surface]
kind = "self-affine"
length = "1 um"
points = 64
seed = 1
rms_slope = 0.1
hurst = 0.8
wavelength_long = "1 length"
wavelength_roll_off = "0.25 length"
wavelength_short = "8 h"
[material]
contact_modulus = "300 MPa"
[load]
mean_gap = ["4 h_rms", "3 h_rms", "2 h_rms", "1 h_rms"]
cycle = "load-unload"
[halfspace]
contact = "exponential"
work_of_adhesion = "150 mJ/m^2"
range = "5 nm"
"""
STEPS = 7


def asperity(*arguments, exit_code=0):
    done = subprocess.run([PROGRAM, *map(str, arguments)], text=True, timeout=300, cwd=WORK,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    assert done.returncode == exit_code, (arguments, done.returncode, done.stdout)
    return done.stdout


def answer_of(adapter, name, *options):
    """The folder of a complete answer."""
    folder = ANSWERS / name / "1.0"
    done = start(ADAPTERS / adapter, PROBLEM, folder, *options)
    assert done.returncode == 0, (adapter, done.returncode, done.stdout)
    text = (folder / "submission.toml").read_text(encoding="utf-8")
    code = tomllib.loads(text)["code"]
    (folder / "submission.toml").write_text(text.replace(f'code = "{code}"', f'code = "{name}"'))
    return folder


def certificate(folder, exit_code=0):
    """What `import` says of each step."""
    said = asperity("import", folder, "--problem", PROBLEM, "--out", WORK / "out",
                    exit_code=exit_code)
    loads = json.loads((WORK / "out/certificate.json").read_text(encoding="utf-8"))["loads"]
    assert [load["step"] for load in loads] == list(range(STEPS)), said
    return said, loads


def energies(folder):
    return np.array([load["energy [J/m^2]"] for load in certificate(folder)[1]]) / WORK_OF_ADHESION


def with_state_of(other, step, folder, name):
    """The answer with the field of another step at the same mean gap."""
    copy = shutil.copytree(folder, ANSWERS / name / "1.0")
    path = copy / "submission.toml"
    text = path.read_text(encoding="utf-8").replace('code = "own"', f'code = "{name}"')
    lines = [line.replace(f'"pressure-{step + 1}.npy"', f'"pressure-{other + 1}.npy"')
             for line in text.splitlines() if not line.startswith("energy")]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def check_codes(own, numpy_answer):
    reference = [answer["energy [J/m^2]"] / WORK_OF_ADHESION for answer in
                 json.loads((PROBLEM / "reference.json").read_text())["discrete"]["answers"]]
    assert abs(energies(own) - reference).max() < 1e-9, energies(own) - reference
    assert abs(energies(numpy_answer) - reference).max() < 1e-9, energies(numpy_answer) - reference
    return np.array(reference)


def check_ranking(energy):
    asperity("board", WORK / "board", "--out", WORK / "site")
    rows = json.loads((WORK / "site/board.json").read_text(encoding="utf-8"))
    assert [row["code"] for row in rows] == ["lower", "own", "template", "higher"], rows
    above = [row["energy_above [w]"] for row in rows]
    early, late = (energy[1] - energy[5]) / STEPS, (energy[4] - energy[2]) / STEPS
    assert early > 1e-4 and late > 1e-4, energy  # the way back has other states
    expected = [0, early, early, early + late]
    assert np.allclose(above, expected, rtol=0, atol=1e-9), (above, expected)
    lowest = [(row["lowest_loads"], row["reference_loads"]) for row in rows]
    assert lowest == [(7, 6), (6, 7), (6, 7), (5, 6)], lowest
    page = (WORK / "site/problem-sticky.html").read_text(encoding="utf-8")
    assert "6 of 7 lowest, 7 as the reference" in page and "exponential attraction of" in page
    # Without reference.json the answers are compared with each other.
    (PROBLEM / "reference.json").unlink()
    sums = PROBLEM / "SHA256SUMS"
    sums.write_text("".join(line for line in sums.read_text().splitlines(keepends=True)
                            if not line.endswith("reference.json\n")), encoding="utf-8")
    asperity("board", WORK / "board", "--out", WORK / "site")
    alone = json.loads((WORK / "site/board.json").read_text(encoding="utf-8"))
    assert [row["code"] for row in alone] == [row["code"] for row in rows], alone
    assert [row["reference_loads"] for row in alone] == [0, 0, 0, 0], alone


def check_refused(own):
    """A field in MPa is no state near a minimum, and energies are compared."""
    copy = shutil.copytree(own, WORK / "wrong")
    field = np.load(copy / "pressure-4.npy")
    np.save(copy / "pressure-4.npy", field * np.float32(1e-6))
    said, loads = certificate(copy, exit_code=1)
    assert "step 3: does not hold: the gap that follows" in said, said
    assert all(claim["holds"] for claim in loads[2]["claims"])
    said = asperity("certify", "out", exit_code=2)
    assert "no bound exists for faces that attract each other" in said, said


ADAPTERS = pathlib.Path(sys.argv[1]).resolve()
WORK = pathlib.Path(sys.argv[2]).resolve()
PROGRAM = sys.argv[3]
PROBLEM = WORK / "board/sticky"
ANSWERS = WORK / "board/submissions/sticky"
WORK_OF_ADHESION = 0.15 # [J/m^2]
shutil.rmtree(WORK, ignore_errors=True)
ANSWERS.mkdir(parents=True)
(WORK / "sticky").mkdir()
(WORK / "sticky/case.toml").write_text(CASE, encoding="utf-8")
asperity("problem", WORK / "sticky", "--out", PROBLEM)
mine = answer_of("asperity_adapter.py", "own", "--program", PROGRAM)
states = check_codes(mine, answer_of("numpy_adhesion.py", "template"))
with_state_of(5, 1, mine, "lower")
with_state_of(4, 2, mine, "higher")
check_ranking(states)
check_refused(mine)
