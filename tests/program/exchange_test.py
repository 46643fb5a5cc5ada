"""Problems that are published, and answers that are submitted: what a developer of
another code does with the program, with numpy and h5py alone.

Arguments: asperity, an empty folder.
"""
import hashlib
import json
import os
import pathlib
import shutil
import subprocess
import sys
import xml.etree.ElementTree

import h5py
import jsonschema
import numpy

CASE = """schema = 1
title = "A small rough surface"
[surface]
kind = "self-affine"
length = "1 um"
points = 64
seed = 1
rms_height = "3 nm"
hurst = 0.8
wavelength_long = "1 length"
wavelength_roll_off = "0.5 length"
wavelength_short = "8 h"
[material]
contact_modulus = "2 GPa"
{material}
[load]
{load}
[halfspace]
{method}
"""
LOADS = 'nominal_pressure = ["0.002 E*", "0.02 E*"]'
LAYERED = """poisson_ratio = 0.3
[[material.layers]]
thickness = "0.05 length"
youngs_modulus = "10 GPa"
poisson_ratio = 0.25
"""


def asperity(*arguments, expected=0):
    done = subprocess.run(
        [PROGRAM, *map(str, arguments)], cwd=FOLDER, text=True, timeout=300,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
        env=os.environ | {"ASPERITY_CACHE_SIZE": "0"})
    assert done.returncode == expected, f"{arguments}: {done.returncode}\n{done.stdout}"
    return done.stdout


def problem_of(name, material="", load=LOADS, method=""):
    folder = FOLDER / name
    folder.mkdir()
    case = folder / "case.toml"
    case.write_text(CASE.format(material=material, load=load, method=method))
    said = asperity("problem", case, "--out", folder / "problem")
    loads = json.loads((folder / "problem/problem.json").read_text())["loads"]
    table = said.split("estimated\n")[1].split("problem:")[0]
    assert len(table.splitlines()) == len(loads), said
    return folder / "problem"


def solved(problem):
    """The pressures of the program itself, as the answer of another code."""
    out = problem.parent / "solved"
    asperity("run", problem / "case.toml", "--set", "report.fields=100", "--no-report",
             "--out", out)
    return solved_fields(out)


def solved_fields(out):
    with h5py.File(out / "result.h5") as file:
        fields = file["methods/halfspace/0/fields"]
        return [fields[step]["pressure"][...].astype(float)
                for step in sorted(fields, key=int)]


def submission(problem, pressures, name, extra="", each=lambda k: "", save=numpy.save,
               ending=".npy"):
    """A submission folder beside the problem."""
    folder = problem.parent / name
    folder.mkdir()
    statement = json.loads((problem / "problem.json").read_text())
    text = (f'problem = "{statement["name"]}"\ncode = "numpy code"\nversion = "1.0"\n'
            'method = "copied"\naccuracy = "default"\nauthors = ["A. Name"]\n'
            f'licence = "CC0-1.0"\n{extra}\n')
    for k, (load, pressure) in enumerate(zip(statement["loads"], pressures)):
        save(folder / f"p{k}{ending}", pressure)
        text += (f'[[load]]\nnominal_pressure = {load["nominal_pressure [Pa]"]!r}\n'
                 f'pressure = "p{k}{ending}"\n{each(k)}\n')
    (folder / "submission.toml").write_text(text)
    return folder


def imported(problem, folder, expected=0):
    out = folder / "out"
    said = asperity("import", folder, "--problem", problem, "--out", out,
                    expected=expected)
    if expected == 2:
        assert not (out / "result.h5").exists(), said
        return said, None
    return said, json.loads((out / "certificate.json").read_text())


def check_problem(problem):
    """The folder is self-contained: schema, checksums, the equations."""
    statement = json.loads((problem / "problem.json").read_text())
    jsonschema.validate(statement,
                        json.loads((problem / "problem.schema.json").read_text()))
    names = {path.name for path in problem.iterdir()}
    for line in (problem / "SHA256SUMS").read_text().splitlines():
        digest, name = line.split()
        assert hashlib.sha256((problem / name).read_bytes()).hexdigest() == digest, name
        names.remove(name)
    assert names == {"SHA256SUMS"}, names
    heights = numpy.load(problem / "heights.npy")
    assert heights.shape == (64, 64) and abs(heights.mean()) < 1e-20
    assert numpy.array_equal(heights, numpy.loadtxt(problem / "heights.txt"))
    with h5py.File(problem / "heights.h5") as file:
        assert numpy.array_equal(heights, file["heights"][...])
    reference = json.loads((problem / "reference.json").read_text())
    for answer in reference["discrete"]["answers"]:
        assert 0 <= answer["mean_gap_error [m]"] < 1e-6 * heights.std()
    for answer, limit in zip(reference["discrete"]["answers"],
                             reference["continuum"]["answers"]):
        assert abs(answer["mean_gap [m]"] - limit["mean_gap [m]"]) < 0.01 * heights.std()
        assert 0 < limit["mean_gap_error [m]"] < 0.01 * heights.std()
    again = problem.parent / "again"
    asperity("problem", problem.parent / "case.toml", "--out", again)
    assert (again / "SHA256SUMS").read_text() == (problem / "SHA256SUMS").read_text()


def check_example(problem, pressures):
    """The example answer follows from the equations of the README, by numpy."""
    statement = json.loads((problem / "problem.json").read_text())
    grid, example = statement["grid"], statement["example"]
    heights, p = numpy.load(problem / "heights.npy"), pressures[0]
    qx = 2 * numpy.pi * numpy.fft.fftfreq(
        grid["points_x"], grid["length_x [m]"] / grid["points_x"])
    qy = 2 * numpy.pi * numpy.fft.fftfreq(
        grid["points_y"], grid["length_y [m]"] / grid["points_y"])
    q = numpy.hypot(qx[None, :], qy[:, None])
    q[0, 0] = numpy.inf
    w = numpy.fft.ifft2(numpy.fft.fft2(p) * 2 / (
        statement["body"]["contact_modulus [Pa]"] * q)).real
    # Single precision of the stored field limits the comparison to some 1e-6.
    assert abs(p.mean() / example["nominal_pressure [Pa]"] - 1) < 1e-6
    gap = (p * (heights - w)).sum() / p.sum()
    assert abs(gap - example["mean_gap [m]"]) < 1e-6 * heights.std()
    assert abs((p * w).mean() / 2 / example["elastic_energy [J/m^2]"] - 1) < 1e-6
    assert abs((p > 0).mean() - example["contact_area_fraction [1]"]) < 3e-4
    assert abs(p.max() / example["largest_pressure [Pa]"] - 1) < 1e-6


def check_right_answers(problem, pressures):
    said, certificate = imported(problem, submission(problem, pressures, "right"))
    assert certificate["is_certified"] and "does not hold" not in said, said
    for load in certificate["loads"]:
        assert load["mean_gap_error [m]"] < 1e-6 * load["rms_height [m]"]
        assert load["mistakes"] == []
        assert load["mean_gap_low [m]"] <= load["mean_gap [m]"] + 1e-6 * load["rms_height [m]"]
        assert 0 < load["area_fraction_corrected [1]"] < load["area_fraction [1]"]
        assert load["contact_stiffness [Pa/m]"] > 0

    def save_h5(path, array):
        with h5py.File(path, "w") as file:
            file["pressure"] = array
    for ending, save in ((".h5", save_h5), (".txt", numpy.savetxt), (".csv", lambda path, array:
                         numpy.savetxt(path, array, delimiter=","))):
        _, other = imported(problem, submission(problem, pressures, "right" + ending,
                                                save=save, ending=ending))
        assert (other["loads"][0]["duality_gap [J/m^2]"]
                == certificate["loads"][0]["duality_gap [J/m^2]"]), ending
    out = problem.parent / "right/out"
    # The import is a result: it can be certified, and reported beside others.
    again = json.loads(asperity("certify", "--json", out))
    assert len(again) == 2 and again[0]["method"] == "numpy-code-1.0-default", again
    asperity("report", problem.parent / "solved", out, "--out", problem.parent / "both")
    page = (problem.parent / "both/report.html").read_text()
    assert "numpy-code-1.0-default" in page and "Errors of the mean gap" in page
    theirs, = json.loads((problem.parent / "both/comparison.json").read_text())
    assert "numpy-code" in theirs["method"] and len(theirs["rows"]) == 2, theirs
    for row in theirs["rows"]:  # the same answer in single precision
        assert abs(row["gap_difference [h_rms]"]) < 1e-6, row
        assert row["pressure_difference [1]"] < 1e-6, row


def check_over_a_run(problem, pressures):
    """An import replaces the result of a run in its folder, with its report."""
    out = problem.parent / "over-a-run"
    asperity("run", problem / "case.toml", "--out", out)
    before = (out / "result.h5").read_bytes()
    folder = submission(problem, pressures, "over")

    asperity("import", folder, "--problem", problem, "--out", out)

    assert (out / "result.h5").read_bytes() != before
    for name in ("report.html", "curves.csv", "summary.json", ".new-run"):
        assert not (out / name).exists(), name
    foreign = problem.parent / "foreign"
    foreign.mkdir()
    (foreign / "report.html").write_text("mine")
    said = asperity("import", folder, "--problem", problem, "--out", foreign, expected=2)
    assert "foreign/report.html: is there already" in said, said
    assert [path.name for path in foreign.iterdir()] == ["report.html"]


def check_faults(problem, pressures):
    """Faults in a submission: the message of the program and its exit code."""
    areas = [(p > 0).mean() for p in pressures]
    for k, (name, sentence, change) in enumerate((
            ("MPa", "it seems to be in MPa", lambda p: 1e-6 * p),
            ("transposed", "transposed", lambda p: p.T),
            ("shifted", "shifted by 61 rows and 0 columns",
             lambda p: numpy.roll(p, 3, axis=0)),
            ("noisy", "does not hold: the mean gap",
             lambda p: p * numpy.random.default_rng(1).uniform(0, 2, p.shape)))):
        said, _ = imported(problem, submission(
            problem, [change(p) for p in pressures], f"fault-{k}"), expected=1)
        assert sentence in said, (name, said)
    for k, (claim, sentence) in enumerate((
            (lambda k: "mean_gap = 1e-9", "does not hold: the mean gap"),
            (lambda k: f"contact_area_fraction = {1.05 * areas[k]}",
             "does not hold: the contact area fraction"),
            (lambda k: "elastic_energy = 1.0", "does not hold: the elastic energy"))):
        said, _ = imported(problem, submission(problem, pressures, f"claim-{k}", each=claim),
                           expected=1)
        assert sentence in said, said
    said, _ = imported(problem, submission(problem, pressures, "exact",
                                           extra="claimed_error = 1e-12"), expected=1)
    assert "within 1e-12 h_rms" in said, said
    for k, (change, sentence) in enumerate((
            (lambda p: p[:32, :32], "has 32 rows and 32 columns, but the problem has 64"),
            (lambda p: -p, "no pressure is > 0, so that nothing can be certified: the mean "
             "pressure is -1 times the load: compression must be positive"),
            (lambda p: p.ravel(), "must have 2: rows and columns"),
            (lambda p: numpy.where(p > 0, p, numpy.nan), "not finite"),
            (lambda p: p.astype(complex), "has numbers of type '<c16'"))):
        said, _ = imported(problem, submission(problem, [change(p) for p in pressures],
                                               f"no-field-{k}"), expected=2)
        assert sentence in said, said


def check_curve(problem):
    """A code without fields is shown as submitted and has no certificate."""
    folder = submission(problem, [], "curve", extra='[curve]\nfile = "curve.csv"')
    (folder / "curve.csv").write_text(
        "nominal_pressure [Pa],mean_gap [m],area_fraction [1]\n4e6,6e-9,0.02\n4e7,3e-9,0.2\n")
    said, certificate = imported(problem, folder)
    assert "as submitted" in said and not certificate["is_certified"], said


def changed_result(problem, change):
    """A copy of a good result, in which something is changed."""
    out = problem.parent / "changed"
    shutil.rmtree(out, ignore_errors=True)
    shutil.copytree(problem.parent / "right/out", out)
    with h5py.File(out / "result.h5", "r+") as file:
        change(file, file["methods/numpy-code-1.0-default/0"])
    return out


def check_wrong_results(problem):
    """A result cannot lie to its certificate: what follows from its fields is verified by all
    commands that read it, and the rest by `certify`."""
    def attribute(place, name, factor):
        def change(file, _):
            file[place].attrs[name] *= factor
        return change

    def row(name, factor):
        def change(_, curve):
            curve["curve"][name][0] *= factor
        return change

    def constant_pressure(file, curve):
        file["surfaces/0"].attrs["rms_height"] = 1.0
        curve["fields/0/pressure"][...] = curve["curve/nominal_pressure"][0]

    def twice_the_size(file, _):
        """All numbers of the surface agree; the case states another length."""
        for name, factor in (("length_x", 2), ("length_y", 2), ("rms_slope", 1 / 2),
                             ("rms_curvature", 1 / 4)):
            file["surfaces/0"].attrs[name] *= factor

    fields = "methods/numpy-code-1.0-default/0/fields/0"
    for change, words in (
            (constant_pressure, "/surfaces/0/rms_height = 1, but the heights have 3"),
            (attribute("surfaces/0", "rms_height", 1.001), "/surfaces/0/rms_height = "),
            (attribute("surfaces/0", "rms_slope", 0.9), "/surfaces/0/rms_slope = "),
            (attribute("surfaces/0", "kurtosis", 1.1), "/surfaces/0/kurtosis = "),
            (attribute("surfaces/0", "length_x", 2), "/surfaces/0/rms_slope = "),
            (twice_the_size, "its case states surface.length = 1e-06 [m]"),
            (attribute("surfaces/0", "length_y", -1), "length_y = -1e-06, but must be finite"),
            (attribute(fields, "length_x", 0), "length_x = 0, but must be finite and > 0 [m]"),
            (attribute(fields, "length_y", numpy.nan), "length_y = nan, but must be finite"),
            (attribute(fields, "nominal_pressure", -1), "nominal_pressure = -"),
            (attribute(fields, "nominal_pressure", 0), "nominal_pressure = 0, but"),
            (attribute(fields, "nominal_pressure", 2), "but the row of this step has"),
            (attribute("/", "contact_modulus", 2), "its case states E* = 2000000000 [Pa]"),
            (row("nominal_pressure", 2), "nominal_pressure = "),
            (row("mean_gap", 1.01), "mean_gap, step 0 = ")):
        said = asperity("certify", changed_result(problem, change), expected=2)
        assert words in said and "result.h5: " in said, (words, said)
    said = asperity("report", changed_result(problem, constant_pressure), expected=2)
    assert "/surfaces/0/rms_height = 1, but" in said, said

    def wrong_gap(_, curve):
        """Consistent, and yet wrong."""
        gap = curve["curve/mean_gap"][0] * 0.01
        curve["curve/mean_gap"][0] += gap
        curve["fields/0/gap"][...] += gap

    def twice_the_load(_, curve):
        """A pressure of another mean, in a method whose nodes may have unequal weights."""
        curve.parent.attrs["kind"] = "fem"
        curve["fields/0/pressure"][...] *= 2

    for change, words in ((wrong_gap, "the mean gap is within"),
                          (twice_the_load, "the nominal pressure is"),
                          (row("area_fraction", 1.1), "the contact area fraction is"),
                          (row("elastic_energy", 1.01), "the elastic energy [J/m^2] is")):
        said = asperity("certify", changed_result(problem, change), expected=1)
        assert "does not hold: " + words in said, (words, said)


def restate(problem, statement):
    """Changes problem.json with its checksum."""
    old = hashlib.sha256((problem / "problem.json").read_bytes()).hexdigest()
    (problem / "problem.json").write_text(json.dumps(statement))
    new = hashlib.sha256((problem / "problem.json").read_bytes()).hexdigest()
    sums = (problem / "SHA256SUMS").read_text()
    (problem / "SHA256SUMS").write_text(sums.replace(old, new))


def check_hostile_folders(problem, pressures):
    """Damage, links and texts that no reader takes are refused, and nothing is written."""
    def refused(folder, words, of=problem):
        said, _ = imported(of, folder, expected=2)
        assert words in said and "Traceback" not in said, (words, said)

    good = submission(problem, pressures, "hostile")
    text = (good / "submission.toml").read_text()
    for key, value, words in (
            ("version", '"' + "1" * 10000 + '"', "1 to 40 bytes"),
            ("version", '"1\\u0000"', "without control characters"),
            ("code", '"a\\u001b[2J"', "without control characters"),
            ("method", '"' + "m" * 2000 + '"', "1 to 1000 bytes"),
            ("method", '"a\\nb"', "one line"),
            ("authors", '["a", "b\\u0007"]', "without control characters"),
            ("authors", "[" + '"a",' * 101 + "]", "list of 1 to 100 texts"),
            ("licence", '""', "1 to 1000 bytes")):
        lines = [f"{key} = {value}" if line.startswith(f"{key} = ") else line
                 for line in text.splitlines()]
        (good / "submission.toml").write_text("\n".join(lines) + "\n")
        refused(good, words)
    longest = text.replace('version = "1.0"', f'version = "{"1" * 40}"').replace(
        '"numpy code"', f'"{"c" * 40}"')
    (good / "submission.toml").write_text(longest)
    _, certificate = imported(problem, good)
    assert len(certificate["loads"]) == 2
    asperity("report", good / "out")
    (good / "submission.toml").write_text(text)
    shutil.rmtree(good / "out")
    field = (good / "p0.npy").read_bytes()
    elsewhere = problem.parent / "elsewhere"
    elsewhere.mkdir()
    (elsewhere / "p0.npy").write_bytes(field)
    (good / "p0.npy").unlink()
    (good / "p0.npy").symlink_to(elsewhere / "p0.npy")
    refused(good, "is a symbolic link")
    (good / "sub").symlink_to(elsewhere)
    (good / "submission.toml").write_text(text.replace('"p0.npy"', '"sub/p0.npy"'))
    refused(good, "is a symbolic link")
    (elsewhere / "submission.toml").write_text(text)
    (good / "submission.toml").unlink()
    (good / "submission.toml").symlink_to(elsewhere / "submission.toml")
    refused(good, "is a symbolic link")

    right = problem.parent / "right"
    shutil.rmtree(right / "out")
    for name in ("heights.txt", "README.md", "heights.h5"):
        damaged = problem.parent / "damaged"
        shutil.copytree(problem, damaged)
        with open(damaged / name, "ab") as file:
            file.write(b"1")
        refused(right, f"{name}: its SHA-256 is", damaged)
        (damaged / name).unlink()
        refused(right, name, damaged)
        (damaged / name).symlink_to(problem / name)
        refused(right, "is a symbolic link", damaged)
        shutil.rmtree(damaged)
    statement = json.loads((problem / "problem.json").read_text())
    for change, words in ((lambda s: s["heights"].update({"rms_height [m]": 1.0}), "rms_height"),
                          (lambda s: s["heights"].update({"rms_slope [1]": 1.0}), "rms_slope"),
                          (lambda s: s.update(name="../../x"), "/name"),
                          (lambda s: s.update(name="n" * 101), "/name"),
                          (lambda s: s.update(title="a\0b"), "/title"),
                          (lambda s: s.update(title="t" * 2000), "/title"),
                          (lambda s: s["grid"].update({"length_x [m]": 2e-6}), "rms_slope")):
        lie = problem.parent / "lie"
        shutil.copytree(problem, lie)
        other = json.loads(json.dumps(statement))
        change(other)
        restate(lie, other)
        refused(right, words, lie)
        shutil.rmtree(lie)
    lie = problem.parent / "lie"
    shutil.copytree(problem, lie)
    case = lie / "case.toml"
    old = hashlib.sha256(case.read_bytes()).hexdigest()
    case.write_text(case.read_text().replace("points = 64", "points = 128"))
    sums = (lie / "SHA256SUMS").read_text()
    (lie / "SHA256SUMS").write_text(
        sums.replace(old, hashlib.sha256(case.read_bytes()).hexdigest()))
    refused(right, "its case states surface.points = 128", lie)


def check_full_contact():
    """At the load of first full contact the pressure is p_0 (1 + cos), which is 0 at one node.
    Its answer has a sharp certificate (the bound was 36 h_rms)."""
    problem = FOLDER / "full/problem"
    for points in (16, 64):
        asperity("problem", "wave-1d", "--set", 'load.nominal_pressure=["0.01 E*"]', "--set",
                 f"surface.points={points}", "--out", problem)
        statement = json.loads((problem / "problem.json").read_text())
        load = statement["loads"][0]["nominal_pressure [Pa]"]
        x = 2 * numpy.pi * numpy.arange(points) / points
        field = numpy.tile(load * (1 + numpy.cos(x)), (points, 1)).astype(numpy.float32)
        _, certificate = imported(problem, submission(problem, [field], f"full-{points}"))
        answer = certificate["loads"][0]
        assert answer["mean_gap_error [m]"] < 1e-6 * answer["rms_height [m]"], answer


def check_names():
    """A case in a folder of any name: what is written for other programs has none of its
    control characters, and every command reads what another wrote."""
    home = FOLDER / "a\n#SBATCH --hold\x1b\"$(id)"
    home.mkdir()
    (home / "case.toml").write_text(CASE.format(material="", load=LOADS, method=""))
    said = asperity("plan", home / "case.toml", "--slurm", "--out", "slurmed", expected=2)
    assert "has a control character" in said and not (FOLDER / "slurmed").exists(), said
    quoted = FOLDER / 'b"$(id)\\'
    quoted.mkdir()
    shutil.copy(home / "case.toml", quoted / "case.toml")
    asperity("plan", quoted / "case.toml", "--slurm", "--out", "slurmed")
    for script in ("parts.sh", "merge.sh"):
        name = (FOLDER / "slurmed/slurm" / script).read_text().splitlines()[1]
        assert name.endswith('b---id--"') and name.count('"') == 2, name
    asperity("run", home / "case.toml", "--out", "named")
    asperity("check", home / "case.toml", "--junit", FOLDER / "named.xml", "--out", "checked",
             expected=2) # the case states no expectation
    xml.etree.ElementTree.parse(FOLDER / "named.xml")
    asperity("report", "named")
    asperity("certify", "named")
    asperity("problem", home / "case.toml", "--out", "named-problem")
    assert "\n" not in json.loads((FOLDER / "named-problem/problem.json").read_text())["name"]
    imported(FOLDER / "named-problem", submission(
        FOLDER / "named-problem", solved_fields(FOLDER / "named"), "named-answer"))
    case = FOLDER / "escaped.toml"
    for entry in ('title = "a\\u0000b"', 'title = "\\u001b[2J"', '"k\\u0007" = 1'):
        text = CASE.format(material="", load=LOADS, method="")
        case.write_text(text.replace('title = "A small rough surface"', entry))
        said = asperity("run", case, "--dry-run", expected=2)
        assert "escaped.toml:2: " in said and "control characters" in said, said


def check_layers():
    """A layered slab with loads as mean gaps: the problem is certified with its
    own body, here and by `certify`; the half-space of E* would fail."""
    problem = problem_of("layered", LAYERED,
                         'mean_gap = ["1 h_rms", "0.5 h_rms"]',
                         'thickness = "0.5 length"\ntop = "sliding"')
    body = json.loads((problem / "problem.json").read_text())["body"]
    assert body["far_boundary"] == "sliding" and len(body["layers"]) == 1, body
    pressures = solved(problem)
    _, certificate = imported(problem, submission(problem, pressures, "right"))
    for load in certificate["loads"]:
        assert load["mean_gap_error [m]"] < 1e-6 * load["rms_height [m]"], load
    again = json.loads(asperity("certify", "--json", problem.parent / "right/out"))
    assert all(load["mean_gap_error [m]"] < 1e-6 * load["rms_height [m]"] for load in again)
    half_space = problem.parent / "half-space"
    shutil.copytree(problem, half_space)
    statement = json.loads((problem / "problem.json").read_text())
    statement["body"] |= {"thickness [m]": None, "far_boundary": None, "layers": []}
    (half_space / "SHA256SUMS").unlink()
    (half_space / "problem.json").write_text(json.dumps(statement))
    (half_space / "case.toml").unlink()
    said, _ = imported(half_space, submission(half_space, pressures, "wrong-body"), expected=1)
    assert "of a modulus" in said or "does not hold" in said, said


def check_free_boundaries():
    """The problem is certified without periodic images, here and by `certify`, which takes
    no other body for that of an import without its case."""
    problem = problem_of("free", method='boundaries = "free"')
    statement = json.loads((problem / "problem.json").read_text())
    assert statement["grid"]["is_periodic"] is False, statement["grid"]
    pressures = solved(problem)
    _, certificate = imported(problem, submission(problem, pressures, "right"))
    again = json.loads(asperity("certify", "--json", problem.parent / "right/out"))
    for load in certificate["loads"] + again:
        assert load["mean_gap_error [m]"] < 1e-6 * load["rms_height [m]"], load
    (problem / "case.toml").unlink()
    (problem / "SHA256SUMS").unlink()
    answer = submission(problem, pressures, "no-case")
    imported(problem, answer)
    said = asperity("certify", answer / "out", expected=2)
    assert "as submitted: its body has free boundaries" in said, said


def check_refusals():
    theory = FOLDER / "theory.toml"
    theory.write_text(CASE.format(material="", load=LOADS, method="").replace(
        "[halfspace]", "[theory]\ngamma = 0.4"))
    said = asperity("problem", theory, expected=2)
    assert "no half-space or condensed finite-element method" in said, said
    said = asperity("problem", "wave-1d", "--set", 'load.nominal_pressure=', "--set",
                    'load.mean_gap=["1 um"]', "--out", "apart", expected=3)
    assert "there is no contact" in said and not (FOLDER / "apart").exists(), said
    said = asperity("problem", "wave-1d", "--method", "fem.none", expected=2)
    assert "it has" in said, said
    said = asperity("problem", "paper", expected=2)
    assert "is a collection" in said, said
    said = asperity("import", FOLDER, "--problem", FOLDER, expected=2)
    assert "problem.json" in said, said
    assert not (FOLDER / "out").exists()


def main():
    problem = problem_of("small")
    check_problem(problem)
    pressures = solved(problem)
    check_example(problem, pressures)
    check_right_answers(problem, pressures)
    check_over_a_run(problem, pressures)
    check_faults(problem, pressures)
    check_curve(problem)
    check_wrong_results(problem)
    check_hostile_folders(problem, pressures)
    check_full_contact()
    check_names()
    check_layers()
    check_free_boundaries()
    check_refusals()


def start():
    """The program and an empty folder, from the command line."""
    global PROGRAM, FOLDER
    PROGRAM = sys.argv[1]
    FOLDER = pathlib.Path(sys.argv[2]).resolve()
    shutil.rmtree(FOLDER, ignore_errors=True)
    FOLDER.mkdir(parents=True)
    return FOLDER


if __name__ == "__main__":
    start()
    main()
