"""Every shipped case is valid against `asperity schema`, and violations of the schema
are detected.

Arguments: asperity, the top-level folder. A case with a base
(`base = ...`) contains changes only: its keys and values are checked, but neither
what "" takes away nor that nothing is missing.
"""
import copy
import json
import subprocess
import sys
import tomllib
from pathlib import Path

import jsonschema

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))
from tracked_files import tracked_files  # noqa: E402  (found by the line above)


def without_required(schema):
    """The same schema where every key may be missing."""
    if isinstance(schema, dict):
        return {key: without_required(value) for key, value in schema.items()
                if key not in ("required", "allOf", "anyOf", "oneOf", "if", "then", "else")
                or not isinstance(value, list)}
    return [without_required(one) for one in schema] if isinstance(schema, list) else schema


def without_removals(table):
    return {key: without_removals(value) if isinstance(value, dict) else value
            for key, value in table.items() if value != ""}


def mistakes(case, schema):
    if "base" in case:
        case, schema = without_removals(case), without_required(schema)
    return [f"{'.'.join(map(str, found.path))}: {found.message}"
            for found in jsonschema.Draft202012Validator(schema).iter_errors(case)]


def main(program, folder):
    done = subprocess.run([program, "schema"], stdout=subprocess.PIPE, check=True)
    schema = json.loads(done.stdout)
    jsonschema.Draft202012Validator.check_schema(schema)
    root = Path(folder).resolve()
    files = [root / name for name in tracked_files(root)
             if name.parts[0] == "cases" and name.name == "case.toml"]
    assert len(files) > 20, f"only {len(files)} cases in {root}"
    n_wrong = 0
    for file in files:
        with open(file, "rb") as stream:
            case = tomllib.load(stream)
        for mistake in mistakes(case, schema):
            print(f"{file}: {mistake}")
            n_wrong += 1
        wrong = copy.deepcopy(case) | {"colour": "red"}
        assert mistakes(wrong, schema), f"{file}: an unknown key is not seen"
    return 1 if n_wrong else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
