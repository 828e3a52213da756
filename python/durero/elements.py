"""The elements of a scene: one class for each type of the specification, with the letters of its attributes and English."""
from __future__ import annotations

import dataclasses
import math
import numbers
from collections.abc import Mapping
from typing import Any, ClassVar, Optional, Tuple, Union

from .english import english, in_both_languages, with_english

Triple = Tuple[float, float, float]
"""Three finite numbers. Any sequence of three is taken, and is kept as a tuple."""


def _number(value: Any, name: str) -> float:
    """The same number as a float; refuses what no binary64 is, so that nothing is rounded in silence."""
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        raise TypeError(f"{with_english(name)} is {value!r}; expected a number")
    number = float(value)
    if not math.isfinite(number):
        raise ValueError(f"{with_english(name)} is {number}; expected a finite number")
    if number != value:
        raise ValueError(f"{with_english(name)} is {value!r}, which is no binary64; expected float({name}), if that is meant")
    return number


def _triple(value: Any, name: str) -> Triple:
    parts = tuple(value)
    if len(parts) != 3:
        raise ValueError(f"{with_english(name)} has {len(parts)} numbers; expected three")
    x, y, z = (_number(part, f"{name}[{i}]") for i, part in enumerate(parts))
    return (x, y, z)


@dataclasses.dataclass(frozen=True)
class _Element:
    tipo: ClassVar[str]
    """The word of the type in files."""

    def __post_init__(self) -> None:
        for field in dataclasses.fields(self):
            object.__setattr__(self, field.name, self._checked(field.name, getattr(self, field.name)))

    @staticmethod
    def _checked(name: str, value: Any) -> Any:
        if name == "material":
            if value is not None and not isinstance(value, str):
                raise TypeError(f"material is {value!r}; expected the name of one, or None")
            return value
        if name in ("centro", "vector"):
            return _triple(value, name)
        if name == "vertices":
            corners = tuple(_triple(corner, f"{name}[{i}]") for i, corner in enumerate(value))
            if len(corners) != 3:
                raise ValueError(f"{name} has {len(corners)} points; expected three")
            return corners
        return _number(value, name)


@in_both_languages
@dataclasses.dataclass(frozen=True)
class Esfera(_Element):
    """A sphere: |w − centro|² = radio²."""

    tipo: ClassVar[str] = "esfera"
    centro: Triple
    radio: float
    material: Optional[str] = None


@in_both_languages
@dataclasses.dataclass(frozen=True)
class Cilindro(_Element):
    """An open cylinder around the axis from centro along vector, a unit vector, as long as altura."""

    tipo: ClassVar[str] = "cilindro"
    centro: Triple
    radio: float
    vector: Triple
    altura: float
    material: Optional[str] = None


@in_both_languages
@dataclasses.dataclass(frozen=True)
class Cono(_Element):
    """An open cone: its base at centro, its apex at centro + altura·vector; proporcion is radius by height."""

    tipo: ClassVar[str] = "cono"
    centro: Triple
    proporcion: float
    vector: Triple
    altura: float
    material: Optional[str] = None


@in_both_languages
@dataclasses.dataclass(frozen=True)
class Tronco(_Element):
    """An open truncated cone: radius radio + proporcion·(altura − s) at the advance s."""

    tipo: ClassVar[str] = "tronco"
    centro: Triple
    radio: float
    proporcion: float
    vector: Triple
    altura: float
    material: Optional[str] = None


@in_both_languages
@dataclasses.dataclass(frozen=True)
class Plano(_Element):
    """A plane through centro, across vector."""

    tipo: ClassVar[str] = "plano"
    centro: Triple
    vector: Triple
    material: Optional[str] = None


@in_both_languages
@dataclasses.dataclass(frozen=True)
class Disco(_Element):
    """A disc around centro, across vector."""

    tipo: ClassVar[str] = "disco"
    centro: Triple
    radio: float
    vector: Triple
    material: Optional[str] = None


@in_both_languages
@dataclasses.dataclass(frozen=True)
class Triangulo(_Element):
    """A triangle by its vertices, which do not lie on one line."""

    tipo: ClassVar[str] = "triangulo"
    vertices: Tuple[Triple, Triple, Triple]
    material: Optional[str] = None


@in_both_languages
@dataclasses.dataclass(frozen=True)
class Written:
    """An element of a type that a Z text declares (Scene.load with surfaces), with the attributes that it gives it.

    >>> Written("toro", {"centro": (0.0, 0.0, 0.0), "mayor": 2.0, "menor": 0.75}).attributes["mayor"]
    2.0
    """

    tipo: str
    attributes: Mapping[str, Union[float, Triple, Tuple[Triple, Triple, Triple]]]
    material: Optional[str] = None


_Shape = Union[Esfera, Cilindro, Cono, Tronco, Plano, Disco, Triangulo]
Element = Union[Esfera, Cilindro, Cono, Tronco, Plano, Disco, Triangulo, Written]

_CLASSES: Tuple[type[_Shape], ...] = (Esfera, Cilindro, Cono, Tronco, Plano, Disco, Triangulo)

TYPES: Mapping[str, type[_Shape]] = {kind.tipo: kind for kind in _CLASSES}
"""The class of each type, by its word."""

globals().update({english(kind.__name__): kind for kind in _CLASSES})  # Sphere …, which elements.pyi lists
