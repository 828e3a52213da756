"""The package and its tests are typed throughout: mypy --strict finds nothing, and the stub is what the module has."""
from __future__ import annotations

import os
import pathlib
import shutil
import subprocess
import sys

import pytest
from support import ROOT

MYPY = shutil.which("mypy")


@pytest.mark.skipif(MYPY is None, reason="absent: mypy")
def test_mypy_finds_nothing() -> None:
    here = pathlib.Path(__file__).parent
    options = ["--strict", "--cache-dir", os.devnull, "--python-executable", sys.executable]
    environment = {**os.environ, "MYPYPATH": str(ROOT / "python")}
    paths = [ROOT / "python" / "durero", *sorted(here.glob("*.py"))]
    checked = subprocess.run([str(MYPY), *options, *map(str, paths)], env=environment, cwd=here, capture_output=True, text=True)
    assert checked.returncode == 0, checked.stdout


def test_the_stub_names_what_the_module_has() -> None:
    import ast

    from durero import _durero

    stub = ast.parse((ROOT / "python" / "durero" / "_durero.pyi").read_text())
    named: set[str] = set()
    methods: set[str] = set()
    for node in stub.body:
        if isinstance(node, ast.FunctionDef):
            named.add(node.name)
        elif isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
            named.add(node.target.id)
        elif isinstance(node, ast.ClassDef):
            named.add(node.name)
            methods |= {method.name for method in node.body if isinstance(method, ast.FunctionDef)}
    assert named == {name for name in vars(_durero) if not name.startswith("__")}
    assert methods == {name for name in vars(_durero.Scene) if not name.startswith("__") or name == "__init__"} - {"_pybind11_conduit_v1_"}
