"""The package and its tests are typed throughout: mypy --strict finds nothing, and the stubs are what the modules have."""
from __future__ import annotations

import os
import pathlib
import shutil
import subprocess
import sys

import pytest
import stubs
from durero.elements import TYPES
from durero.english import english
from support import ROOT

MYPY = shutil.which("mypy")
ENGLISH = {english(kind.__name__): kind.__name__ for kind in TYPES.values()}


def mypy(package: pathlib.Path, *paths: pathlib.Path) -> str:
    """What mypy says of these files; empty where it finds nothing."""
    options = ["--strict", "--cache-dir", os.devnull, "--python-executable", sys.executable]
    environment = {**os.environ, "MYPYPATH": str(package.parent)}
    command = [str(MYPY), *options, str(package), *map(str, paths)]
    here = pathlib.Path(__file__).parent
    checked = subprocess.run(command, env=environment, cwd=here, capture_output=True, text=True)
    return "" if checked.returncode == 0 else checked.stdout + checked.stderr


@pytest.mark.skipif(MYPY is None, reason="absent: mypy")
def test_mypy_finds_nothing() -> None:
    assert mypy(ROOT / "python" / "durero", *sorted(pathlib.Path(__file__).parent.glob("*.py"))) == ""


@pytest.mark.skipif(MYPY is None, reason="absent: mypy")
def test_mypy_finds_nothing_in_the_sources_of_the_stubs(tmp_path: pathlib.Path) -> None:
    """Where a source has a stub, mypy reads the stub alone. The English classes, which only a stub lists, are added."""
    package = tmp_path / "durero"
    shutil.copytree(ROOT / "python" / "durero", package)
    for stub, _ in stubs.stubs():
        (package / stub.name).unlink()
    (package / "elements.py").write_text((package / "elements.py").read_text() + "".join(
        f"{name} = {spanish}\n" for name, spanish in ENGLISH.items()))
    assert mypy(package) == ""


@pytest.mark.skipif(MYPY is None, reason="absent: mypy")
def test_mypy_knows_the_names_of_both_languages(tmp_path: pathlib.Path) -> None:
    use = tmp_path / "use.py"
    use.write_text("import durero\n"
                   "ball = durero.Sphere(center=(0, 0, 5), radius=1)\n"
                   "same: durero.Esfera = ball\n"
                   "number: float = ball.radius + ball.radio\n"
                   "durero.Scene().group('all', elements=['a'])\n")
    assert mypy(ROOT / "python" / "durero", use) == ""
    use.write_text("import durero\ndurero.Sphere(center=(0, 0, 5), colour=1)\ndurero.Cone.radius\n")
    said = mypy(ROOT / "python" / "durero", use)
    assert "use.py:2" in said and "use.py:3" in said


def test_the_stubs_of_both_languages_are_fresh() -> None:
    assert stubs.stale() == [], "python3 tests/python/stubs.py --write puts them right"


def test_the_stub_names_what_the_module_has() -> None:
    import ast

    from durero import _durero

    stub = ast.parse((ROOT / "python" / "durero" / "_durero.pyi").read_text())
    named: set[str] = set()
    methods: dict[str, set[str]] = {}
    for node in stub.body:
        if isinstance(node, ast.FunctionDef):
            named.add(node.name)
        elif isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
            named.add(node.target.id)
        elif isinstance(node, ast.ClassDef):
            named.add(node.name)
            methods[node.name] = {method.name for method in node.body if isinstance(method, ast.FunctionDef)}
    assert named == {name for name in vars(_durero) if not name.startswith("__")}
    for kind, own in methods.items():
        has = {name for name in vars(getattr(_durero, kind)) if not name.startswith("__") or name == "__init__"}
        assert own == has - {"_pybind11_conduit_v1_"}, kind
