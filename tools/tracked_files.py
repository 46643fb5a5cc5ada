"""The files of the project, without what a user keeps in the checkout."""
import subprocess
from pathlib import Path


def tracked_files(root):
    """The files of the project, relative to `root`: tracked by git, or all of an unpacked archive."""
    git = ["git", "-c", f"safe.directory={root}", "-C", str(root)]
    try:
        top = subprocess.run([*git, "rev-parse", "--show-toplevel"], capture_output=True, text=True)
        if top.returncode == 0 and Path(top.stdout.rstrip("\n")).resolve() == root:
            names = subprocess.run([*git, "ls-files", "-z"], capture_output=True, text=True, check=True)
            return [Path(name) for name in sorted(names.stdout.split("\0"))
                    if name and (root / name).is_file()]
    except FileNotFoundError:  # no git
        pass
    found = (path.relative_to(root) for path in sorted(root.rglob("*")) if path.is_file())
    return [path for path in found if not {"build", "out"} & set(path.parts[:1])]
