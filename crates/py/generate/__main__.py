"""Writes what follows from the compiled module: `use_cases.py` from the JSON schemas of the use cases, and the docstrings of `_native.pyi`; and
`problem.py`, from the schema of problem files.

    python crates/py/generate

It takes the compiled module of the package that is installed for this Python. A test says if a file is out of date.
"""

from __future__ import annotations

import importlib.machinery
import importlib.util
import json
import sys
from pathlib import Path
from types import ModuleType

from problem import problem
from stub import stub
from use_cases import use_cases

PACKAGE = Path(__file__).resolve().parents[1] / "python" / "soilctl"
PROBLEM = Path(__file__).resolve().parents[3] / "docs/schemas/soilctl.problem.1.json"


def native() -> ModuleType:
    """The compiled module, without the package around it, which may be older than this."""
    package = importlib.util.find_spec("soilctl")
    folders = list(package.submodule_search_locations or []) if package else []
    found = importlib.machinery.PathFinder.find_spec("_native", folders)
    if found is None or found.loader is None:
        sys.exit("the package soilctl is not installed for this Python")
    spec = importlib.util.spec_from_file_location("soilctl._native", found.origin)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def files(module: ModuleType) -> dict[Path, str]:
    """The files by path, as they should be."""
    path = PACKAGE / "_native.pyi"
    return {
        PACKAGE / "problem.py": problem(json.loads(PROBLEM.read_text(encoding="utf-8"))),
        PACKAGE / "use_cases.py": use_cases(module.use_case_schemas()),
        path: stub(path.read_text(encoding="utf-8"), module),
    }


if __name__ == "__main__":
    for path, text in files(native()).items():
        path.write_text(text, encoding="utf-8")
