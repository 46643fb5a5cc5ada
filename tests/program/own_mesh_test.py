"""A mesh of the user's own, as a user meets it: the example of the manual, the refusals, the cache.

Arguments: the program, an empty folder. It runs in the top-level folder.
"""
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

PROGRAM = os.path.abspath(sys.argv[1])
FOLDER = Path(sys.argv[2]).absolute()
MANUAL = Path("docs/numerics/meshes.md").read_text(encoding="utf-8")
PUNCH = Path("tests/meshes/data/punch.geo").read_text(encoding="utf-8")
COUNTER = ["fem.bodies=2", 'fem.contact="augmented"', 'fem.penalty="10 E*/h"',
           "material.counter={ youngs_modulus = 2e9, poisson_ratio = 0.3 }",
           'mesh.counter={ shape = "cylinder", radius = "0.3 length" }']
SLANT = """SetFactory("OpenCASCADE");
Point(1) = {0, 0, 0};
Point(2) = {1, 0, -0.2};
Point(3) = {1, 0, 0.5};
Point(4) = {0, 0, 0.5};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
block[] = Extrude {0, 1, 0} { Surface{1}; };
"""
LINE_OF_FILE = 18  # of the key mesh.file in the case of the manual


def example(language):
    return re.search(f"```{language}\n(.*?)```", MANUAL, re.DOTALL).group(1)


CASE = example("toml")
GEO = example("geo")


def run(*words, env=None):
    done = subprocess.run([PROGRAM, *words], cwd=FOLDER, text=True, timeout=300,
                          env=os.environ | {"ASPERITY_CACHE": "cache"} | (env or {}),
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    return done.returncode, done.stdout


def write(name, text):
    (FOLDER / name).write_text(text, encoding="utf-8")


def mean_gap(folder):
    header, *rows = (FOLDER / folder / "curves.csv").read_text(encoding="utf-8").splitlines()
    column = next(i for i, name in enumerate(header.split(",")) if name.startswith("mean_gap ["))
    return [row.split(",")[column] for row in rows]


def contents(folder):
    return {path: path.read_bytes() for path in (FOLDER / folder).rglob("*") if path.is_file()}


def box_mesh(n=8, is_torn=False):
    """The block of the example as a .msh 2.2; `is_torn`: with two sets of nodes at half its depth."""
    layers = sorted([*range(n + 1)] + [n // 2] * is_torn)
    nodes = [(x / n, y / n, z / (2 * n)) for z in layers for y in range(n + 1) for x in range(n + 1)]
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
    code, text = run("run", "case.toml", "--out", "again")
    assert code == 0 and "0 computed" in text, text


def test_a_msh_file_gives_the_numbers_of_the_geometry():
    write("block.msh", box_mesh())
    code, text = run("run", "case.toml", "--set", 'mesh.file="block.msh"', "--out", "msh")
    assert code == 0, text
    # The solver's tolerance, 1e-6 h_rms, is the only difference of the two.
    one, other = (float(mean_gap(folder)[0]) for folder in ("example", "msh"))
    assert abs(one - other) < 1e-6 * abs(one), (one, other)


def refused_files():
    """Names, contents (None: there is no such file), overrides and the words with which they must be refused."""
    turned = GEO.replace("Transfinite Curve",
                         "Rotate {{0, 0, 1}, {0, 0, 0}, Pi/4} { Volume{1}; }\nTransfinite Curve")
    yield "none.msh", None, [], "there is no file "
    yield "empty.msh", "", [], 'begins with ""'
    yield "script.msh", 'SystemCall "touch made";\n', [], "must begin with $MeshFormat"
    yield "cut.msh", box_mesh()[:2000], [], "cut.msh"
    yield "command.geo", 'SystemCall "touch made";\n' + GEO, [], "line 1: starts a program"
    yield "write.geo", GEO + 'Save "made.msh";\n', [], "writes a file"
    yield "syntax.geo", "Point(1) = {\n", [], "syntax error"
    yield "exit.geo", "Exit;\n", [], "before there is a mesh"
    yield "torn.msh", box_mesh(is_torn=True), [], "the parts of the mesh are not connected"
    yield ("torn2.msh", box_mesh(is_torn=True), ['fem.sides="periodic"'],
           "the parts of the mesh are not connected")
    yield "unit.msh", box_mesh(), ["mesh.file_unit=1.0"], (
        "the contact surface is 1 by 1 in the file and 1 by 1 m with file_unit = \"1 m\", but "
        "[surface] is 1e-06 by 1e-06 m; they are equal with file_unit = \"1e-06 m\"")
    yield "long.geo", GEO.replace("{0, 0, 0, 1, 1,", "{0, 0, 0, 1, 2,"), [], (
        "no file_unit makes them equal")
    yield "punch.geo", PUNCH, ['mesh.file_unit="0.5 um"'], "the contact surface covers 7"
    yield "turned.geo", turned, [], "the contact surface covers 50 %"
    tetrahedra = GEO.replace("Transfinite", "//").replace("Recombine", "//")
    tetrahedra += "MeshSize {:} = 0.3;\n"
    yield "second.geo", tetrahedra, ['fem.element="Q2"'], "contact_at must be \"gauss\""
    yield "coarse.geo", tetrahedra, COUNTER, "those of mesh.counter and of its block are hexahedra"
    yield "fine.geo", GEO, [*COUNTER, 'mesh.counter.size_at_contact="0.05 length"'], (
        "beside this mesh mesh.counter.size_at_contact = 5e-08, but must be ")
    slant = SLANT + "".join(line + "\n" for line in tetrahedra.splitlines()[3:] if "Box" not in line)
    slant = slant.replace('{6}', "{block[4]}").replace('{5}', "{block[2]}")
    yield "slant.geo", slant, ['fem.top="sliding"'], (
        "the far boundary (group fixed) must be a plane of constant z unless top = \"clamped\"")
    yield "sides.geo", PUNCH, ['fem.sides="periodic"'], "a periodic block needs the face left"


def test_a_mesh_is_refused_before_anything_is_touched():
    run("run", "case.toml", "--out", "kept")
    before = contents("kept")
    assert before
    for name, text, overrides, words in refused_files():
        if text is not None:
            write(name, text)
        options = [word for entry in overrides for word in ("--set", entry)]
        write("bad.toml", CASE.replace("block.geo", name))
        for command in (["run", "bad.toml", "--out", "kept"],
                        ["run", "bad.toml", "--out", "kept", "--no-cache"],
                        ["run", "bad.toml", "--dry-run"],
                        ["check", "bad.toml", "--out", "kept"],
                        ["describe", "bad.toml"], ["bench", "bad.toml", "--out", "fresh"],
                        ["run", "bad.toml", "--out", "fresh"]):
            code, answer = run(*command, *options)
            assert code == 2, (command, name, code, answer)
            assert words in answer, (command, name, answer)
            assert f"bad.toml:{LINE_OF_FILE}: mesh.file: " in answer, (command, name, answer)
            assert name in answer, (command, name, answer)
        assert contents("kept") == before, name
        assert not [path for path in (FOLDER / "fresh").rglob("*") if path.stat().st_size], name
        assert not list(FOLDER.rglob("made*")), name


def test_the_cache_and_resume_know_what_a_geometry_includes():
    for name, depth in (("shallow", 0.25), ("deep", 0.5)):
        write("part1.inc", f"depth = {depth};\n")
        write("included.geo", 'Include Sprintf("part%g.inc", 1);\n' +
              GEO.replace("0, 0, 0, 1, 1, 0.5", "0, 0, 0, 1, 1, depth"))
        write("included.toml", CASE.replace("block.geo", "included.geo"))
        code, text = run("run", "included.toml", "--out", name)
        assert code == 0 and "0 computed" not in text, text
        fresh, text = run("run", "included.toml", "--out", "fresh-" + name, "--no-cache")
        assert fresh == 0, text
        assert mean_gap(name) == mean_gap("fresh-" + name), name
    assert mean_gap("shallow") != mean_gap("deep")
    write("part1.inc", "depth = 0.125;\n")
    before = contents("deep")
    code, text = run("run", "included.toml", "--out", "deep", "--resume")
    assert code == 2 and "mesh.file" in text, (code, text)
    assert contents("deep") == before


def test_an_interrupt_ends_gmsh_and_the_program():
    write("endless.geo", "For i In {1:1e15}\n  x = i;\nEndFor\n")
    write("endless.toml", CASE.replace("block.geo", "endless.geo"))
    for words in (["run", "endless.toml", "--out", "none"], ["run", "endless.toml", "--dry-run"],
                  ["check", "endless.toml", "--out", "none"]):
        for number in (signal.SIGINT, signal.SIGTERM):
            with subprocess.Popen([PROGRAM, *words], cwd=FOLDER, stdout=subprocess.DEVNULL,
                                  stderr=subprocess.DEVNULL) as running:
                wait_for(lambda: children_of(running.pid))
                gmsh = children_of(running.pid)
                running.send_signal(number)
                assert running.wait(60) == -number, (words, number, running.returncode)
                wait_for(lambda: not any(os.path.exists(f"/proc/{child}") for child in gmsh))


def children_of(process):
    with open(f"/proc/{process}/task/{process}/children", encoding="utf-8") as file:
        return file.read().split()


def wait_for(is_so):
    for _ in range(600):
        if is_so():
            return
        time.sleep(0.1)
    raise AssertionError("waited for a minute")


def main():
    shutil.rmtree(FOLDER, ignore_errors=True)
    FOLDER.mkdir(parents=True)
    assert CASE.splitlines()[LINE_OF_FILE - 1].startswith("file = "), "the example has changed"
    write("case.toml", CASE)
    write("block.geo", GEO)
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
