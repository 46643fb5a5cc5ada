#!/usr/bin/env python3
"""Refuse answers to the board that are not laid out as docs/submit.md says, or whose numbers
do not hold, and problems with links or wrong checksums. Prints what is wrong after the name of
the answer or the problem, whatever is in its files, and exits 1.

    check_submissions.py PROGRAM BOARD FOLDER

BOARD has a folder with case.toml for each problem, and the answers in
submissions/<problem>/<code>/<version>. Problems and certificates are written to FOLDER,
which is emptied first. Proves on itself first that it can fail.
"""
import hashlib
import pathlib
import re
import shutil
import subprocess
import sys
import tomllib

import numpy as np

LARGEST = 8 * 2**20 # bytes of all files of an answer
LICENCES = ("CC0-1.0", "CC-BY-4.0", "CC-BY-SA-4.0", "ODC-By-1.0", "PDDL-1.0", "MIT", "BSD-2-Clause",
            "BSD-3-Clause", "Apache-2.0")
OWN_LICENCE = re.compile(r"LicenseRef-[A-Za-z0-9.-]+")
NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9._+-]*")
FIELD = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]*\.(npy|h5)")
SUM = re.compile(r"([0-9a-f]{64})  ([A-Za-z0-9][A-Za-z0-9._-]*)")
LONGEST_RUN = 1200 # seconds of the program for one problem or answer


def unread(mistake):
    """What is reported of a file that no reader of it was prepared for."""
    return f"cannot be read: {type(mistake).__name__}: {mistake}"


def wrong_kinds(folder):
    """Links and devices below a folder, which would show other files of the machine."""
    for path in [folder, *sorted(folder.rglob("*"))]:
        if path.is_symlink() or not (path.is_file() or path.is_dir()):
            yield f"{path.name}: must be a file or a folder, and no link"


def wrong_sums(problem):
    """Files that are not those of SHA256SUMS, which goes with problem.json."""
    if not (problem / "problem.json").exists():
        return
    lines = (problem / "SHA256SUMS").read_text(encoding="utf-8").splitlines()
    sums = [SUM.fullmatch(line) for line in lines]
    if None in sums:
        yield f"SHA256SUMS:{sums.index(None) + 1}: must be a sum, two blanks and a name"
        return
    sums = {line[2]: line[1] for line in sums}
    for name in sorted({path.name for path in problem.iterdir()} - {*sums, "SHA256SUMS"}):
        yield f"{name}: is not named in SHA256SUMS"
    for name, stated in sums.items():
        if not (problem / name).is_file():
            yield f"{name}: is missing"
        elif hashlib.sha256((problem / name).read_bytes()).hexdigest() != stated:
            yield f"{name}: is not the file of SHA256SUMS"


def wrong_problem(problem):
    """All mistakes of the folder of a problem that need no program."""
    try:
        wrong = list(wrong_kinds(problem))
        return wrong or list(wrong_sums(problem))
    except Exception as mistake: # pylint: disable=broad-except
        return [unread(mistake)]


def problems(board):
    """The folders of all problems."""
    return [path for path in sorted(board.iterdir()) if path.name != "submissions" and
            (path.is_symlink() or path.is_dir())]


def answers(board):
    """The folders of all answers, and mistakes of the folders above them."""
    found, mistakes = sorted((board / "submissions").glob("*/*/*")), []
    for depth in ("*", "*/*", "*/*/*"):
        for path in sorted((board / "submissions").glob(depth)):
            if path.is_symlink() or not path.is_dir():
                mistakes.append(f"{path}: must be a folder <problem>/<code>/<version>")
            elif not NAME.fullmatch(path.name):
                mistakes.append(f"{path}: a name has letters, digits and . _ + - only")
    if not found:
        mistakes.append(f"{board}/submissions: has no answer")
    return [path for path in found if path.is_dir()], mistakes


def wrong_head(head, answer):
    """What submission.toml says against its own place, and its licence."""
    for key, folder in (("problem", answer.parent.parent.name), ("code", answer.parent.name)):
        if head.get(key) != folder:
            yield f"{key} = {head.get(key)!r}, but the folder is {folder}"
    if not (answer.name + "-").startswith(f"{head.get('version')}-"):
        yield f"version = {head.get('version')!r}, but the folder is {answer.name}"
    licence = str(head.get("licence"))
    if OWN_LICENCE.fullmatch(licence):
        if not (answer / "LICENSE").is_file():
            yield f"licence = {licence!r}, but there is no file LICENSE with its text"
    elif licence not in LICENCES:
        yield f"licence = {licence!r}, but must be LicenseRef-... or one of {', '.join(LICENCES)}"


def wrong_files(head, answer):
    """Files that are missing, of another kind, not named or too large together."""
    named = [str(load.get("pressure")) for load in head.get("load", [])]
    for name in named:
        if not FIELD.fullmatch(name):
            yield f"{name}: a field is a .npy or .h5 file beside submission.toml"
        elif name.endswith(".npy") and (answer / name).is_file() and not is_float32(answer / name):
            yield f"{name}: must be float32"
    if "curve" in head:
        named.append(str(head["curve"].get("file")))
    found = {path.name for path in answer.iterdir()}
    for name in sorted(set(named) - found):
        yield f"{name}: is missing"
    for name in sorted(found - {*named, "submission.toml", "LICENSE", "README.md"}):
        yield f"{name}: is not named in submission.toml"
    for path in answer.iterdir():
        if not path.is_file():
            yield f"{path.name}: must be a file"
    size = sum(path.lstat().st_size for path in answer.iterdir())
    if size > LARGEST:
        yield f"has {size} bytes, but at most {LARGEST} may be"


def is_float32(field):
    try:
        return np.load(field, mmap_mode="r", allow_pickle=False).dtype == np.float32
    except Exception: # pylint: disable=broad-except # a header can raise almost anything
        return False


def wrong_layout(board, answer):
    """All mistakes that need no program."""
    if not (board / answer.parent.parent.name / "case.toml").is_file():
        return [f"{answer.parent.parent.name} is no problem of {board}"]
    try:
        wrong = list(wrong_kinds(answer))
        if wrong:
            return wrong
        head = tomllib.loads((answer / "submission.toml").read_text(encoding="utf-8"))
        return [*wrong_head(head, answer), *wrong_files(head, answer)]
    except Exception as mistake: # pylint: disable=broad-except # no table, for example
        return [f"submission.toml: {unread(mistake)}"]


def run(*words):
    """What a command of the program prints if it fails."""
    try:
        done = subprocess.run(words, text=True, errors="replace", timeout=LONGEST_RUN, check=False,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    except subprocess.TimeoutExpired:
        return [f"{words[1]}: has not ended after {LONGEST_RUN} s"]
    if done.returncode == 0:
        return []
    return [f"{words[1]}: exit code {done.returncode}\n{done.stdout}"]


def certify(program, answer, problem, out):
    """What `import` prints if the answer cannot be read or a claim does not hold."""
    return run(program, "import", answer, "--problem", problem, "--out", out)


def check_board(program, board, folder):
    found, mistakes = answers(board)
    for problem in problems(board):
        mistakes += [f"{problem.name}: {mistake}" for mistake in wrong_problem(problem)]
    for answer in found:
        name = answer.relative_to(board / "submissions")
        problem = folder / "problems" / name.parts[0]
        wrong = wrong_problem(board / name.parts[0]) or wrong_layout(board, answer)
        if not wrong and not problem.exists():
            wrong = run(program, "problem", board / name.parts[0], "--out", problem)
        if not wrong:
            wrong = certify(program, answer, problem, folder / "certified" / name)
        mistakes += [f"{name}: {mistake}" for mistake in wrong]
    return found, mistakes


HEAD = {"problem": '"wave"', "code": '"a-code"', "version": '"1.0"', "licence": '"CC0-1.0"'}


def check_layout_itself(board):
    """Of a small made-up answer, each of these mistakes is found, and no other."""
    (board / "wave").mkdir(parents=True)
    (board / "wave/case.toml").touch()
    answer = board / "submissions/wave/a-code/1.0-best"

    def found(head=HEAD, field="p.npy", numbers=np.float32, extra=None, size=0, load=None):
        shutil.rmtree(answer, ignore_errors=True)
        answer.mkdir(parents=True)
        np.save(answer / "p.npy", np.zeros((2, 2), numbers))
        text = "".join(f"{key} = {value}\n" for key, value in head.items())
        (answer / "submission.toml").write_text(text + (
            f'[[load]]\npressure = "{field}"\n' if load is None else f"load = {load}\n"))
        if extra is not None:
            (answer / extra).write_bytes(bytes(size))
        return "; ".join(wrong_layout(board, answer))

    assert found() == "" and answers(board) == ([answer], []), found()
    assert found(extra="README.md", size=2**22) == ""
    for key in HEAD:
        assert f"{key} = 'another'" in found(HEAD | {key: '"another"'}), key
        assert f"{key} = " in found({name: HEAD[name] for name in HEAD if name != key}), key
    own = HEAD | {"licence": '"LicenseRef-mine"'}
    assert "no file LICENSE" in found(own) and found(own, extra="LICENSE") == ""
    assert "float32" in found(numbers=np.float64)
    assert "a field is" in found(field="../p.npy") and "missing" in found(field="q.npy")
    assert "not named" in found(extra="q.npy") and "submission.toml:" in found({"a": "b"})
    assert "at most" in found(extra="README.md", size=LARGEST)
    (answer / "more").mkdir()
    assert "more: must be a file" in "; ".join(wrong_layout(board, answer))
    for load in ("5", '"text"', "[1, 2]", "{}", "[[]]"): # whatever it is, no traceback
        assert found(load=load) != "", load
    for header in (b"", b"\x93NUMPY\x01\x00\xff\xff{", b"\x93NUMPY\x01\x00\x08\x00((((((((",
                   b"\x93NUMPY\x01\x00\x40\x00" + b"{'descr': '<f4', 'fortran_order': False, "
                   b"'shape': (9" + b"9" * 60 + b",)}\n"):
        found()
        (answer / "p.npy").write_bytes(header)
        assert "float32" in "; ".join(wrong_layout(board, answer)), header
    for name in ("p.npy", "submission.toml", "README.md"):
        found()
        (answer / name).unlink(missing_ok=True)
        (answer / name).symlink_to("/etc/hostname")
        assert f"{name}: must be a file or a folder" in "; ".join(wrong_layout(board, answer))
    found()
    (board / "submissions/wave/stray").touch()
    assert "stray: must be a folder" in answers(board)[1][0]
    (board / "submissions/a code").mkdir()
    assert "a code: a name has" in answers(board)[1][0]
    (board / "wave/case.toml").unlink()
    assert "is no problem" in found()
    assert "has no answer" in answers(board / "wave")[1][0]


def check_problems_itself(board):
    """Links and files that are not those of SHA256SUMS are found, and no others."""
    problem = board / "stated"
    problem.mkdir(parents=True)
    text = b"1 2 3"
    for name in ("problem.json", "heights.txt"):
        (problem / name).write_bytes(text)
    sums = "".join(f"{hashlib.sha256(text).hexdigest()}  {name}\n"
                   for name in ("problem.json", "heights.txt"))
    assert "cannot be read" in wrong_problem(problem)[0]
    (problem / "SHA256SUMS").write_text(sums)
    assert wrong_problem(problem) == [] and problems(board) == [problem]
    (problem / "SHA256SUMS").write_text(sums + "0  ../../etc/hostname\n")
    assert "SHA256SUMS:3" in wrong_problem(problem)[0]
    (problem / "SHA256SUMS").write_text(sums)
    (problem / "heights.txt").write_bytes(b"1 2 4")
    assert wrong_problem(problem) == ["heights.txt: is not the file of SHA256SUMS"]
    (problem / "heights.txt").unlink()
    assert wrong_problem(problem) == ["heights.txt: is missing"]
    (problem / "heights.txt").symlink_to("/etc/hostname")
    assert "no link" in wrong_problem(problem)[0]
    (problem / "heights.txt").unlink()
    (problem / "heights.txt").write_bytes(text)
    (problem / "more.txt").write_bytes(text)
    assert wrong_problem(problem) == ["more.txt: is not named in SHA256SUMS"]
    (board / "link").symlink_to("stated")
    assert "no link" in wrong_problem(problems(board)[0])[0]


def check_certificate_itself(program, answer, problem, folder):
    """An accepted answer is refused with one of its fields in MPa."""
    copy = folder / "wrong"
    shutil.copytree(answer, copy)
    field = next(copy.glob("*.npy"))
    np.save(field, np.load(field) * np.float32(1e-6))
    assert "MPa" in "".join(certify(program, copy, problem, folder / "refused")), copy


def main(program, board, folder):
    program, board, folder = map(pathlib.Path, (program, board, folder))
    shutil.rmtree(folder, ignore_errors=True)
    check_layout_itself(folder / "itself")
    check_problems_itself(folder / "itself-problems")
    found, mistakes = check_board(program.resolve(), board, folder)
    if mistakes:
        sys.exit("\n".join(mistakes))
    with_field = next((answer for answer in found if list(answer.glob("*.npy"))), None)
    if with_field:
        problem = folder / "problems" / with_field.parent.parent.name
        check_certificate_itself(program.resolve(), with_field, problem, folder)
    print(f"{len(found)} answers are complete, and their claims hold")


if __name__ == "__main__":
    main(*sys.argv[1:])
