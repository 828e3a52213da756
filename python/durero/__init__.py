"""Durero: formally specified, contract-checked ray/object intersection.

A scene is edited under contract, and asked for the first hits of rays; each number of an answer is the exact value,
rounded once:

>>> import durero, numpy as np
>>> scene = durero.Scene()
>>> scene.add("ball", durero.Esfera(centro=(0, 0, 5), radio=1))
'esfera_agregada'
>>> scene.apply("Agregar_Plano e?=floor centro?=(0,-1,0) vector?=(0,1,0)")
'plano_agregado'
>>> rays = np.array([[0, 0, 0, 0, 0, 1], [0, 0, 0, 0, -1, 1], [0, 0, 0, 0, 1, 0]], float)
>>> hits = scene.trace(rays)
>>> hits["t"].tolist()
[4.0, 1.0, nan]
>>> [scene.names[i] if i >= 0 else None for i in hits["element"]]
['ball', 'floor', None]

What the specification does not allow is refused, with the predicate that does not hold:

>>> scene.add("ball", durero.Esfera(centro=(0, 0, 9), radio=1))
Traceback (most recent call last):
    ...
durero.errors.Refused: Agregar_Elemento.pre.1: e? ∉ elementos (elemento_ya_existe, element_already_exists): Agregar_Esfera e?=ball centro?=(0.0, 0.0, 9.0) radio?=1.0

The exact value is there too, a number x + y√Δ, and the specification itself answers:

>>> print(scene.exact((0.5, 0, 0, 0, 0, 1)).t)
5 + -1·√(3/4)
>>> durero.spec.eval("#elementos = 2", scene)
True

Scene           help(durero.Scene): load, save, import_file, export_file, apply, add, remove, group, trace, occluded, exact, render
Esfera …        the elements: Esfera, Cilindro, Cono, Tronco, Plano, Disco, Triangulo; Written, of a type of a Z text
Sphere …        the same classes in English: Sphere, Cylinder, Cone, TruncatedCone, Plane, Disc, Triangle; arguments and
                properties have English names too, as center is centro
Store           help(durero.Store): a scene that is kept with its whole history, in one file
spec            help(durero.spec): the Z text evaluates and checks
check_mesh      help(durero.check_mesh): what is wrong with a mesh, and on which side of it a point is
conform         help(durero.conform): judges the hits of other programs
Refused …       what goes wrong: Refused, InputError, StaleHead, Undecided
"""
import difflib
from typing import TYPE_CHECKING, NamedTuple

from . import _durero, conform, spec
from .elements import Cilindro, Cone, Cono, Cylinder, Disc, Disco, Element, Esfera, Plane, Plano, Sphere, Triangle
from .elements import Triangulo, Tronco, TruncatedCone, Written
from .errors import InputError, Refused, StaleHead, Undecided
from .exact import ExactHit, Surd
from .hits import HIT, PROXIMITY, Count, Outcome, Resultado
from .mesh import MeshCheck, MeshFinding, MeshPiece, check_mesh
from .scene import Answer, Group, HitsWithElements, Imported, Mesh, Scene, Step
from .store import Store, StoreAnswer, StoreHead

__version__ = _durero.version


class Engine(NamedTuple):
    """A way to answer rays, and what it promises."""

    name: str
    what: str
    exact_bytes: bool
    """Its answers are those of `exact`, byte for byte."""
    honours_origins: bool
    """It knows of the elements that a ray starts on."""


def engines() -> list[Engine]:
    """Every engine that Scene.trace may be given the name of.

    >>> [engine.name for engine in engines() if engine.exact_bytes][:2]
    ['exact', 'analytic']
    """
    return [Engine(*row) for row in _durero.engines()]


if not TYPE_CHECKING:  # to whom every name would be an attribute

    def __getattr__(name: str) -> object:
        """Says which name is near."""
        near = difflib.get_close_matches(name, __all__, 1, 0.7)
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}{f'; expected {near[0]}' if near else ''}")


__all__ = [
    "Answer",
    "Cilindro",
    "Cone",
    "Cono",
    "Count",
    "Cylinder",
    "Disc",
    "Disco",
    "Element",
    "Engine",
    "Esfera",
    "ExactHit",
    "Group",
    "HIT",
    "HitsWithElements",
    "Imported",
    "InputError",
    "Mesh",
    "MeshCheck",
    "MeshFinding",
    "MeshPiece",
    "Outcome",
    "PROXIMITY",
    "Plane",
    "Plano",
    "Refused",
    "Resultado",
    "Scene",
    "Sphere",
    "StaleHead",
    "Step",
    "Store",
    "StoreAnswer",
    "StoreHead",
    "Surd",
    "Triangle",
    "Triangulo",
    "Tronco",
    "TruncatedCone",
    "Undecided",
    "Written",
    "__version__",
    "check_mesh",
    "conform",
    "engines",
    "spec",
]
