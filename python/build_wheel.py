"""Builds the wheel of asperity.py for pip (PEP 517) by the standard library alone, so that
`pip install ./python` works without a network."""
import base64
import hashlib
import tomllib
import zipfile
from pathlib import Path

HERE = Path(__file__).resolve().parent


def _record_line(name, content):
    digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(content)}\n"


def _write(folder, name, content):
    project = tomllib.loads((HERE / "pyproject.toml").read_text("utf-8"))["project"]
    info = f"{project['name']}-{project['version']}.dist-info"
    metadata = (f"Metadata-Version: 2.1\nName: {project['name']}\nVersion: {project['version']}\n"
                f"Summary: {project['description']}\nRequires-Python: {project['requires-python']}\n"
                + "".join(f"Requires-Dist: {need}\n" for need in project["dependencies"]))
    files = {name: content, f"{info}/METADATA": metadata.encode(),
             f"{info}/WHEEL": b"Wheel-Version: 1.0\nGenerator: build_wheel\n"
                              b"Root-Is-Purelib: true\nTag: py3-none-any\n"}
    record = "".join(_record_line(*file) for file in files.items()) + f"{info}/RECORD,,\n"
    wheel = f"{project['name']}-{project['version']}-py3-none-any.whl"
    with zipfile.ZipFile(Path(folder) / wheel, "w") as archive:
        for path, data in {**files, f"{info}/RECORD": record.encode()}.items():
            archive.writestr(path, data)
    return wheel


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """The wheel with a copy of the module."""
    del config_settings, metadata_directory
    return _write(wheel_directory, "asperity.py", (HERE / "asperity.py").read_bytes())


def build_editable(wheel_directory, config_settings=None, metadata_directory=None):
    """A wheel that names this folder (pip install -e)."""
    del config_settings, metadata_directory
    return _write(wheel_directory, "asperity.pth", f"{HERE}\n".encode())
