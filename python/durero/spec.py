"""The specification, asked: the Z text itself evaluates what one types."""
from __future__ import annotations

import dataclasses
import os
import pathlib
from typing import Optional, Union

from . import _durero
from .scene import Scene


@dataclasses.dataclass(frozen=True)
class Defect:
    """What is wrong with a Z text, and where; lines and columns count from 1."""

    file: str
    line: int
    column: int
    what: str
    expected: str
    is_warning: bool

    def __str__(self) -> str:
        kind = "warning: " if self.is_warning else ""
        return f"{self.file}:{self.line}:{self.column}: {kind}{self.what}; {self.expected}"


def eval(expression: str, scene: Optional[Scene] = None) -> Union[bool, str, None]:
    """Whether a predicate holds, or the value of an expression as text; None where it is undefined.

    The expression is Z, in Unicode or in LaTeX mark-up. With a scene, Escena's components and the elements are names.
    Raises InputError where it cannot be read or has no type, and Undecided where it cannot be worked out.

    >>> import durero
    >>> scene = durero.Scene()
    >>> scene.add("s1", durero.Esfera(centro=(0, 0, 5), radio=2))
    'esfera_agregada'
    >>> durero.spec.eval("mi_radio(s1) ∈ Rmas", scene), durero.spec.eval("mi_radio(s1) * 3", scene)
    (True, '6')
    """
    text, _ = _durero.evaluate(expression, None if scene is None else scene._scene)
    return {"true": True, "false": False, "undefined": None}.get(text, text)


def check(*files: Union[str, os.PathLike[str]]) -> list[Defect]:
    """The defects of Z texts in LaTeX mark-up, type errors and more; without a file, of Durero's own text.

    >>> import durero
    >>> durero.spec.check()
    []
    """
    sources = [(os.fspath(file), pathlib.Path(file).read_text(encoding="utf-8")) for file in files]
    return [Defect(*defect) for defect in _durero.check(sources)]
