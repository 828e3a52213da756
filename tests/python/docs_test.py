"""What the package says of itself is true: its docstrings' examples, and the code of docs/python.md, give what they show."""
from __future__ import annotations

import doctest
import importlib
import inspect
import pkgutil
import pydoc
import re

import pytest
from support import ROOT

import durero

MODULES = ["durero"] + [f"durero.{module.name}" for module in pkgutil.iter_modules(durero.__path__)]


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
