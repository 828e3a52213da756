"""The module refuses a NumPy whose arrays it would misread."""
from __future__ import annotations

import os
import pathlib
import subprocess
import sys

import pytest

from durero import _durero


def imported_with(version: str, folder: pathlib.Path) -> subprocess.CompletedProcess[str]:
    """What importing the compiled module says where NumPy has this version."""
    (folder / "numpy.py").write_text(f'__version__ = "{version}"\n')
    module = pathlib.Path(_durero.__file__ or "")
    environment = {**os.environ, "PYTHONPATH": f"{folder}:{module.parent}", "PYTHONDONTWRITEBYTECODE": "1"}
    return subprocess.run([sys.executable, "-c", "import _durero"], env=environment, capture_output=True, text=True)


@pytest.mark.skipif(_durero.reads_numpy_2, reason="a module of pybind11 2.12 reads both")
@pytest.mark.parametrize("version", ["2.0.0", "2.4.6", "10.1"])
def test_a_later_numpy_is_refused(version: str, tmp_path: pathlib.Path) -> None:
    said = imported_with(version, tmp_path).stderr.splitlines()[-1]
    assert said.startswith("ImportError: durero: this module was built with a pybind11 before 2.12")
    assert f"NumPy {version};" in said


def test_numpy_1_is_not_refused_for_its_version(tmp_path: pathlib.Path) -> None:
    assert "pybind11" not in imported_with("1.26.4", tmp_path).stderr
