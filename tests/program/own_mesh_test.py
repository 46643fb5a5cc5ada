"""A mesh of the user's own, as a user meets it: the example of the manual, the refusals, the cache.

Arguments: the program, an empty folder. It runs in the top-level folder.
"""
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

PROGRAM = os.path.abspath(sys.argv[1])
FOLDER = Path(sys.argv[2]).absolute()
MANUAL = Path("docs/numerics/meshes.md").read_text(encoding="utf-8")
PUNCH = Path("tests/fem/data/punch.msh").read_text(encoding="utf-8")
COUNTER = ["fem.bodies=2", 'fem.contact="augmented"', 'fem.penalty="10 E*/h"',
           "material.counter={ youngs_modulus = 2e9, poisson_ratio = 0.3 }",
           'mesh.counter={ shape = "cylinder", radius = "0.3 length" }']
LINE_OF_FILE = 18  # of the key mesh.file in the case of the manual
CASE = re.search("```toml\n(.*?)```", MANUAL, re.DOTALL).group(1)


def run(*words, env=None):
    done = subprocess.run([PROGRAM, *words], cwd=FOLDER, text=True, timeout=300,
                          env=os.environ | {"ASPERITY_CACHE": "cache"} | (env or {}),
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    return done.returncode, done.stdout


def write(name, text):
    (FOLDER / name).write_text(text, encoding="utf-8")


def contents(folder):
    return {path: path.read_bytes() for path in (FOLDER / folder).rglob("*") if path.is_file()}


def box_mesh(n=8, is_torn=False, depth=0.5, length=1.0, slant=0.0, turn=False):
    """The block of the example as a .msh 2.2; `is_torn`: with two sets of nodes at half its depth."""
    layers = sorted([*range(n + 1)] + [n // 2] * is_torn)
    nodes = [(x / n, length * y / n, depth * z / n - slant * x / n * (n - z) / n)
             for z in layers for y in range(n + 1) for x in range(n + 1)]
    if turn:
        nodes = [(x - y, x + y, z) for x, y, z in nodes]
    number = lambda x, y, z: 1 + x + (n + 1) * (y + (n + 1) * z)
    square = lambda x, y, z: [number(x, y, z), number(x + 1, y, z), number(x + 1, y + 1, z),
                              number(x, y + 1, z)]
    top = len(layers) - 1
    cells = [z for z in range(top) if layers[z] != layers[z + 1]]
    places = [(x, y) for y in range(n) for x in range(n)]
    elements = ([(3, 1, square(x, y, top)) for x, y in places] +
                [(3, 2, square(x, y, 0)) for x, y in places] +
                [(5, 3, square(x, y, z) + square(x, y, z + 1)) for z in cells for x, y in places])
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", "3", '2 1 "contact"',
             '2 2 "fixed"', '3 3 "block"', "$EndPhysicalNames", "$Nodes", str(len(nodes))]
    lines += [f"{i + 1} {x} {y} {z}" for i, (x, y, z) in enumerate(nodes)]
    lines += ["$EndNodes", "$Elements", str(len(elements))]
    lines += [f"{i + 1} {kind} 2 {group} {group} {' '.join(map(str, own))}"
              for i, (kind, group, own) in enumerate(elements)]
    return "\n".join(lines + ["$EndElements", ""])


def test_the_example_of_the_manual_runs():
    code, text = run("run", "case.toml", "--out", "example")
    assert code == 0, text
    code, text = run("run", "case.toml", "--out", "again", "--no-report")
    assert code == 0 and "0 computed" in text, text


def refused_files():
    """Names, contents, overrides and the words with which they must be refused. What a mesh file alone
    shows is tests/fem/mesh_file_test.cpp; these are about the file beside the case."""
    yield "torn.msh", box_mesh(is_torn=True), [], "the parts of the mesh are not connected"
    yield "unit.msh", box_mesh(), ["mesh.file_unit=1.0"], (
        "the contact surface is 1 by 1 in the file and 1 by 1 m with file_unit = \"1 m\", but "
        "[surface] is 1e-06 by 1e-06 m; they are equal with file_unit = \"1e-06 m\"")
    yield "long.msh", box_mesh(length=2.0), [], "no file_unit makes them equal"
    yield "punch.msh", PUNCH, ['mesh.file_unit="0.5 um"'], "the contact surface covers 7"
    yield "turned.msh", box_mesh(turn=True), [], "the contact surface covers 50 %"
    yield "second.msh", PUNCH, ['fem.element="Q2"', 'mesh.file_unit="0.5 um"'], (
        "second.msh: mesh: the contact surface covers")
    yield "fine.msh", box_mesh(), [*COUNTER, 'mesh.counter.size_at_contact="0.05 length"'], (
        "beside this mesh mesh.counter.size_at_contact = 5e-08, but must be ")
    yield "slant.msh", box_mesh(slant=0.2), ['fem.top="sliding"'], (
        "the far boundary (group fixed) must be a plane of constant z unless top = \"clamped\"")


def test_a_mesh_is_refused_by_name_and_line():
    for name, text, overrides, words in refused_files():
        write(name, text)
        write("bad.toml", CASE.replace("block.msh", name))
        code, answer = run("run", "bad.toml", "--dry-run",
                           *[word for entry in overrides for word in ("--set", entry)])
        assert code == 2, (name, code, answer)
        assert words in answer, (name, answer)
        assert f"bad.toml:{LINE_OF_FILE}: mesh.file: " in answer, (name, answer)
        assert name in answer, (name, answer)


def test_a_mesh_is_refused_before_anything_is_touched():
    """A file that cannot be read, one that is no mesh, and one that is a script."""
    before = contents("example")
    assert before
    write("torn.msh", box_mesh(is_torn=True))
    write("block.geo", 'SystemCall "touch made";\n')
    for name, words in (("none.msh", "there is no file "), ("torn.msh", "not connected"),
                        ("block.geo", "mesh it first: gmsh -3 block.geo")):
        write("bad.toml", CASE.replace("block.msh", name))
        for command in (["run", "bad.toml", "--out", "example"], ["check", "bad.toml", "--out", "fresh"],
                        ["describe", "bad.toml"]):
            code, answer = run(*command)
            assert code == 2 and words in answer, (command, name, code, answer)
    assert contents("example") == before
    assert not [path for path in (FOLDER / "fresh").rglob("*") if path.stat().st_size]
    assert not list(FOLDER.rglob("made*"))


def test_the_cache_and_resume_know_the_mesh():
    write("own.toml", CASE.replace("block.msh", "own.msh"))
    write("own.msh", box_mesh(depth=0.25))
    code, text = run("run", "own.toml", "--out", "own", "--no-report")
    assert code == 0 and "0 computed" not in text, text
    before = contents("own")
    write("own.msh", box_mesh(depth=0.125))
    code, text = run("run", "own.toml", "--out", "own", "--no-report", "--resume")
    assert code == 2 and "mesh.file" in text, (code, text)
    assert contents("own") == before


def main():
    shutil.rmtree(FOLDER, ignore_errors=True)
    FOLDER.mkdir(parents=True)
    assert CASE.splitlines()[LINE_OF_FILE - 1].startswith("file = "), "the example has changed"
    write("case.toml", CASE)
    write("block.msh", box_mesh())
    failed = 0
    for name, test in list(globals().items()):
        if name.startswith("test_"):
            try:
                test()
            except AssertionError as error:
                failed += 1
                print(f"{name}: {error}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
