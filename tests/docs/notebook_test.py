#!/usr/bin/env python3
"""Executes a notebook of docs/notebooks and compares what it prints with what is stored in it.

notebook_test.py PROGRAM SOURCE NAME FOLDER: executes docs/notebooks/NAME.ipynb in FOLDER, which is
emptied first and gets copies of docs and adapters. Numbers may differ by 2 %, as on a page; of
figures there must be as many. With ASPERITY_UPDATE_GOLDEN=1, what it shows is stored instead.
"""
import os
import shutil
import sys
from pathlib import Path

try:
    import ipykernel  # noqa: F401
    import matplotlib  # noqa: F401
    import nbformat
    from nbclient import NotebookClient
except ImportError as missing:
    print(f"skipped: needs python3-ipykernel, python3-matplotlib and python3-nbconvert ({missing})")
    sys.exit(77)

from page_test import is_same


def shown(cell):
    """The lines that a cell has printed, and how many figures it has drawn."""
    outputs = cell.get("outputs", [])
    text = "".join(output.text for output in outputs if output.output_type == "stream")
    return text.splitlines(), sum("image/png" in output.get("data", {}) for output in outputs)


def is_as_stored(stored, executed):
    (lines, figures), (printed, drawn) = shown(stored), shown(executed)
    return figures == drawn and len(lines) == len(printed) and all(map(is_same, lines, printed))


def check_itself():
    def cell(text, kind="image/png"):
        return nbformat.v4.new_code_cell(outputs=[
            nbformat.v4.new_output("stream", text=text),
            nbformat.v4.new_output("display_data", data={kind: ""})])
    assert is_as_stored(cell("1.00 nm\n"), cell("1.01 nm\n"))
    assert not is_as_stored(cell("1.00 nm\n"), cell("1.03 nm\n"))
    assert not is_as_stored(cell("1.00 nm\n"), cell("1.00 nm\nand\n"))
    assert not is_as_stored(cell("1.00 nm\n"), cell("1.00 nm\n", "text/plain"))


def main(program, source, name, scratch):
    check_itself()
    folder, path = Path(scratch), Path(source) / "docs/notebooks" / f"{name}.ipynb"
    shutil.rmtree(folder, ignore_errors=True)
    for part in ("docs/tutorials", "docs/notebooks", "python/adapters"):
        shutil.copytree(Path(source) / part, folder / part)
    os.environ |= {"ASPERITY_CACHE": str(folder / "cache"), "ASPERITY_PROGRAM": program,
                   "PYTHONPATH": str(Path(source) / "python"), "PYTHONDONTWRITEBYTECODE": "1",
                   "TMPDIR": str(folder), "PYDEVD_DISABLE_FILE_VALIDATION": "1",
                   "IPYTHONDIR": str(folder / "ipython")}
    stored = nbformat.read(path, as_version=4)
    executed = nbformat.from_dict(stored)
    NotebookClient(executed, timeout=300, kernel_name="python3", record_timing=False,
                   resources={"metadata": {"path": str(folder / "docs/notebooks")}}).execute()
    if os.environ.get("ASPERITY_UPDATE_GOLDEN"):
        executed.metadata.pop("language_info", None)
        nbformat.write(executed, path)
        return
    for cell, now in zip(stored.cells, executed.cells):
        if not is_as_stored(cell, now):
            sys.exit(f"{cell.source}\nprinted {shown(now)}\nand not {shown(cell)}")


if __name__ == "__main__":
    main(*sys.argv[1:])
