"""What the package says of itself is true: its docstrings' examples, and the code of docs/python.md, give what they show."""
from __future__ import annotations

import doctest
import importlib
import inspect
import pkgutil
import pydoc
import re
import sys

import numpy as np
import pytest
from support import ROOT

import durero

MODULES = ["durero"] + [f"durero.{module.name}" for module in pkgutil.iter_modules(durero.__path__)]


def has_scalar(value: object) -> bool:
    """Whether it is a scalar of NumPy, or a list or tuple with one: NumPy 1 and NumPy 2 show it differently."""
    return isinstance(value, np.generic) or (isinstance(value, (list, tuple)) and any(map(has_scalar, value)))


@pytest.fixture(autouse=True)
def scalars_are_told_of(monkeypatch: pytest.MonkeyPatch) -> None:
    """An example that shows a scalar of NumPy fails by every NumPy."""
    show = sys.__displayhook__

    def told(value: object) -> None:
        if has_scalar(value):
            print("a scalar of NumPy; expected bool(…), float(…) or int(…) of it:", end=" ")
        show(value)

    monkeypatch.setattr(sys, "__displayhook__", told)


@pytest.mark.parametrize("name", MODULES)
def test_examples_of_docstrings(name: str) -> None:
    assert doctest.testmod(importlib.import_module(name)).failed == 0


def test_help_teaches_by_an_example() -> None:
    help_text = pydoc.plain(pydoc.render_doc(durero))
    assert ">>> hits = scene.trace(rays)" in help_text
    for name in durero.__all__:
        value = getattr(durero, name)
        is_told_of = inspect.isclass(value) or inspect.isfunction(value) or inspect.ismodule(value)
        assert not is_told_of or inspect.getdoc(value), f"{name} has no docstring"


def test_the_tutorial(monkeypatch: pytest.MonkeyPatch, tmp_path: object) -> None:
    """Each block of `pycon` goes on where the one before it ended."""
    text = (ROOT / "docs" / "python.md").read_text(encoding="utf-8")
    blocks = re.findall(r"^```pycon\n(.*?)^```$", text, re.DOTALL | re.MULTILINE)
    monkeypatch.chdir(ROOT)
    parsed = doctest.DocTestParser().get_doctest("\n".join(blocks), {}, "docs/python.md", None, 0)
    assert len(parsed.examples) > 30
    runner = doctest.DocTestRunner()
    runner.run(parsed)
    assert runner.failures == 0
