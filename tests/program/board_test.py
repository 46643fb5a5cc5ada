"""The board: certified, failed and curve-only answers on a static site, for
any text that their authors write into them.

Arguments: asperity, an empty folder.
"""
import html.parser
import json
import shutil

import numpy

import exchange_test as exchange

HOSTILE = "<script>alert(1)</script>"


class Page(html.parser.HTMLParser):
    """Links, and the text of each cell of each row, of a page."""

    def __init__(self, path):
        super().__init__()
        self.links, self.rows, self.scripts, self.cell = [], [], 0, False
        self.text = path.read_text(encoding="utf-8")
        self.feed(self.text)

    def handle_starttag(self, tag, attrs):
        attrs = dict(attrs)
        self.scripts += tag == "script"
        if tag == "a":
            self.links.append(attrs["href"])
        if tag == "tr":
            self.rows.append([])
        if tag in ("td", "th"):
            self.rows[-1].append("")
            self.cell = True

    def handle_endtag(self, tag):
        self.cell = self.cell and tag not in ("td", "th")

    def handle_data(self, data):
        if self.cell:
            self.rows[-1][-1] += data


def change_head(folder, old, new):
    path = folder / "submission.toml"
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new))


def submissions(root, problem, pressures):
    """One of each kind; returns the states that the board must find."""
    noise = numpy.random.default_rng(1)
    kinds = {
        "good/1.0": (pressures, "certified"),
        "good/1.0-best": (pressures, "certified"),
        "good/1.0-again": (pressures, "certified"),
        "rough/2": ([p * noise.uniform(0.999, 1.001, p.shape) for p in pressures], "certified"),
        "flipped/1": ([p[::-1] for p in pressures], "failed"),
        "copied/1": ([q * (p.mean() / q.mean()) for p in pressures
                      for q in (p * noise.uniform(0.9, 1.1, p.shape),)], "certified"),
        "partial/1": (pressures[:1], "certified"),
        "broken/1": (pressures, "failed"),
        "curve/1": ([], "as submitted"),
    }
    for name, (fields, _) in kinds.items():
        made = exchange.submission(problem, fields, name.replace("/", "-"),
                                   each=lambda k: f"cpu_time = {k + 1}\niterations = 7",
                                   extra='[curve]\nfile = "c.csv"' if not fields else "")
        change_head(made, 'code = "numpy code"', f'code = "{name.split("/")[0]}"')
        folder = root / "submissions/small" / name
        folder.parent.mkdir(parents=True, exist_ok=True)
        shutil.move(made, folder)
    change_head(root / "submissions/small/good/1.0-best", '"default"', '"best"')
    hashes = json.loads((problem / "problem.json").read_text())["heights"]["files"]
    path = root / "submissions/small/good/1.0/submission.toml"
    path.write_text(path.read_text() + '[timing]\nrun = "r1"\npairs = 2\nthreads = 1\n'
                    f'heights = "{hashes["heights.npy"]}"\n')
    change_head(root / "submissions/small/flipped/1", 'method = "copied"',
                f'method = "{HOSTILE}"')
    change_head(root / "submissions/small/rough/2", 'code = "rough"', f'code = "{HOSTILE}"')
    change_head(root / "submissions/small/broken/1", "licence", "license")
    # The right mean gaps beside poor fields.
    statement = json.loads((problem / "reference.json").read_text())
    for k, answer in enumerate(statement["discrete"]["answers"]):
        change_head(root / "submissions/small/copied/1", f'pressure = "p{k}.npy"',
                    f'pressure = "p{k}.npy"\nmean_gap = {answer["mean_gap [m]"]!r}')
    change_head(root / "submissions/small/copied/1", "licence", "claimed_error = 0.1\nlicence")
    (root / "submissions/small/curve/1/c.csv").write_text(
        "nominal_pressure [Pa],mean_gap [m],area_fraction [1]\n4e6,6e-9,0.02\n")
    return {f"small/{name}": state for name, (_, state) in kinds.items()}


def state_of(row):
    return ("certified" if row["is_certified"] else
            "as submitted" if row["is_as_submitted"] else "failed")


def check_rows(site, expected):
    rows = json.loads((site / "board.json").read_text())
    found = {row["folder"]: state_of(row) for row in rows}
    assert found == expected, found
    by_folder = {row["folder"]: row for row in rows}
    assert by_folder["small/good/1.0"]["cpu_time [s]"] == 3
    assert by_folder["small/good/1.0"]["iterations"] == 14
    partial = by_folder["small/partial/1"]
    assert (partial["loads"], partial["missing_loads"]) == (1, 1)
    assert "nearest: licence" in by_folder["small/broken/1"]["reasons"][0]
    certified = [row for row in rows if row["is_certified"]]
    assert certified[-1] == partial  # after the others, whatever its error is
    errors = [row["gap_error [h_rms]"] for row in certified[:-1]]
    assert certified[-2]["code"] == "copied" and errors[-1] > 1e-3, certified[-2]
    errors.pop()
    assert errors == sorted(errors) and errors[0] < 1e-6 < errors[-1] < 1e-3, errors


def check_pages(site):
    problem = Page(site / "problem-small.html")
    # Two settings share a row; the second answer at one of them has its own.
    leading, again = [row for row in problem.rows if row[0].startswith("good 1.0")]
    assert again[1] == leading[1] and again[6] == "–", again
    assert leading[1] == leading[6] and leading[5] == "14", leading
    # A time says in which run it was measured, or that nobody knows.
    assert leading[3] == "3run r1, 2 pairs, 1 thread", leading
    assert leading[8] == "3as submitted" and again[3] == "3as submitted", (leading, again)
    assert any(row[0].startswith("small/flipped/1") and "reverse order" in row[2]
               for row in problem.rows if len(row) == 3), problem.rows
    assert "data:image/svg" in problem.text and "could not be drawn" not in problem.text
    front = Page(site / "index.html")
    for page in site.glob("*.html"):
        parsed = Page(page)
        # Our own: the theme; beside figures also their data and two scripts.
        assert parsed.scripts == (4 if page.name.startswith("problem-") else 1), page
        assert HOSTILE not in parsed.text, page
        assert "Content-Security-Policy" in parsed.text, page
        assert page.name == "index.html" or "index.html" in parsed.links, page
        for link in parsed.links:
            assert (site / link).exists(), (page, link)
    assert ["small", "4096", "9", "6"] == [cell.split("A small")[0] for cell in front.rows[1][:4]]
    codes = {row[0] for row in front.rows[2:]}
    assert {"good", "flipped", "partial", "broken", "curve", HOSTILE} <= codes, codes


def main():
    folder = exchange.start()
    problem = exchange.problem_of("small")
    pressures = exchange.solved(problem)
    board = folder / "board"
    board.mkdir()
    expected = submissions(board, problem, pressures)
    said = exchange.asperity("board", board, "--out", "site", expected=2)
    assert "no folder" in said and not (folder / "site/index.html").exists(), said
    shutil.copytree(problem, board / "small")
    exchange.asperity("board", board, "--out", "site", expected=1)
    check_rows(folder / "site", expected)
    check_pages(folder / "site")
    # A problem that is given as a case is computed; without failures the exit
    # code is 0, and the same numbers come out.
    shutil.rmtree(board / "small")
    (board / "small").mkdir()
    shutil.copy(folder / "small/case.toml", board / "small/case.toml")
    for name, state in expected.items():
        if state == "failed":
            shutil.rmtree(board / "submissions" / name)
    exchange.asperity("board", board, "--out", "again")
    again = json.loads((folder / "again/board.json").read_text())
    first = json.loads((folder / "site/board.json").read_text())
    assert again == [row for row in first if state_of(row) != "failed"]
    check_named_answer(folder, board)
    check_unanswered(folder, board)
    (board / "other").mkdir()
    statement = json.loads((problem / "problem.json").read_text()) | {"name": "another"}
    shutil.copytree(problem, board / "other", dirs_exist_ok=True)
    exchange.restate(board / "other", statement)
    shutil.copytree(board / "submissions/small/good", board / "submissions/other/good")
    said = exchange.asperity("board", board, expected=2)
    assert 'states the problem "another", but its folder is other' in said, said
    said = exchange.asperity("board", folder / "small", expected=2)
    assert "has no submission" in said, said
    check_foreign_files(folder, problem)


def check_named_answer(folder, board):
    """An answer beside the board is shown among those of its problem, and other problems are left out."""
    mine = shutil.copytree(board / "submissions/small/rough/2", folder / "mine")
    change_head(mine, HOSTILE, "my own")
    shutil.copytree(board / "small", board / "unasked")
    shutil.copytree(board / "submissions/small/good", board / "submissions/unasked/good")
    exchange.asperity("board", board, "mine", "--out", "with-mine")
    shutil.rmtree(board / "unasked")
    shutil.rmtree(board / "submissions/unasked")
    rows = {row["folder"]: row for row in json.loads((folder / "with-mine/board.json").read_text())}
    others = {row["folder"]: row for row in json.loads((folder / "again/board.json").read_text())}
    assert rows.pop("mine")["code"] == "my own" and rows == others, rows
    text = (folder / "with-mine/problem-small.html").read_text()
    assert text.count('<tr class="named">') == 1 and '<tr class="named"><td data-key="my own 1.0">' in text
    said = exchange.asperity("board", board, "small", "--out", "with-none", expected=2)
    assert "submission.toml" in said, said


def check_unanswered(folder, board):
    """A problem without an answer has its page with our own answer and its files, beside the others."""
    shutil.copytree(board / "small", board / "lone")
    exchange.asperity("board", board, "--out", "with-lone")
    shutil.rmtree(board / "lone")
    page = Page(folder / "with-lone/problem-lone.html")
    assert "There is none yet." in page.text and "problems/lone/heights.npy" in page.links, page.links
    assert all((folder / "with-lone" / link).exists() for link in page.links), page.links
    reference = [row for row in page.rows if len(row) == 8][1:]
    assert len(reference) == 2 and reference[0][0].endswith(" MPa"), page.rows
    assert ["lone", "4096", "0", "0"] in [[cell.split("A small")[0] for cell in row[:4]]
                                          for row in Page(folder / "with-lone/index.html").rows]


def check_foreign_files(folder, problem):
    """Nothing is published that is not a file of the problem, with its checksum."""
    board = folder / "foreign"
    answers = board / "submissions/small/good"
    shutil.copytree(folder / "board/submissions/small/good/1.0", answers / "1.0")
    secret = folder / "secret.txt"
    secret.write_text("secret")

    def restored():
        shutil.rmtree(board / "small", ignore_errors=True)
        shutil.copytree(problem, board / "small")
        return board / "small"

    (restored() / "not-listed.txt").write_text("secret")
    exchange.asperity("board", board, "--out", "clean")
    assert not (folder / "clean/problems/small/not-listed.txt").exists()
    assert (folder / "clean/problems/small/SHA256SUMS").exists()
    for name in ("README.md", "heights.txt", "problem.json", "SHA256SUMS"):
        home = restored()
        (home / name).unlink()
        (home / name).symlink_to(secret)
        said = exchange.asperity("board", board, "--out", f"link-{name}", expected=2)
        assert "is a symbolic link" in said, said
        assert not (folder / f"link-{name}/index.html").exists()
    home = restored()
    text = (home / "heights.txt").read_text()
    (home / "heights.txt").write_text(text.replace("1", "2", 1))
    said = exchange.asperity("board", board, "--out", "damaged", expected=2)
    assert "heights.txt: its SHA-256 is" in said, said
    (restored() / "SHA256SUMS").unlink()
    said = exchange.asperity("board", board, "--out", "unsummed", expected=2)
    assert "SHA256SUMS: is missing" in said, said
    shutil.rmtree(board / "small")
    (board / "small").symlink_to(problem)
    said = exchange.asperity("board", board, "--out", "linked", expected=2)
    assert "is a symbolic link" in said, said
    (board / "small").unlink()
    (board / "small").mkdir()
    (board / "small/case.toml").write_text((problem / "case.toml").read_text().replace(
        'kind = "self-affine"', 'kind = "measured"\nfile = "../../secret.txt"'))
    exchange.asperity("board", board, "--out", "outside", expected=2)
    restored()
    # An answer that is a link, or that has one, fails alone.
    (answers / "2.0").symlink_to(folder / "board/submissions/small/good/1.0")
    shutil.copytree(answers / "1.0", answers / "3.0")
    (answers / "3.0/p0.npy").unlink()
    (answers / "3.0/p0.npy").symlink_to(answers / "1.0/p0.npy")
    exchange.asperity("board", board, "--out", "answers", expected=1)
    rows = {row["folder"]: row for row in
            json.loads((folder / "answers/board.json").read_text())}
    assert state_of(rows["small/good/1.0"]) == "certified", rows
    for name in ("2.0", "3.0"):
        row = rows[f"small/good/{name}"]
        assert state_of(row) == "failed" and "symbolic link" in row["reasons"][0], row


main()
