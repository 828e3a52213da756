# Made of elements.py by tests/python/stubs.py --write: the same, with the English names beside the Spanish ones.
from typing import overload
import dataclasses
import math
import numbers
from collections.abc import Mapping
from typing import Any, ClassVar, Optional, Tuple, Union
Triple = Tuple[float, float, float]

@dataclasses.dataclass(frozen=True)
class _Element:
    tipo: ClassVar[str]

    @staticmethod
    def _checked(name: str, value: Any) -> Any: ...

@dataclasses.dataclass(frozen=True, init=False)
class Esfera(_Element):
    tipo: ClassVar[str]
    centro: Triple
    radio: float
    material: Optional[str]

    @overload
    def __init__(self, centro: Triple, radio: float, material: Optional[str]=...) -> None: ...

    @overload
    def __init__(self, center: Triple, *, radius: float, material: Optional[str]=...) -> None: ...
    type: ClassVar[str]

    @property
    def center(self) -> Triple: ...

    @property
    def radius(self) -> float: ...
Sphere = Esfera

@dataclasses.dataclass(frozen=True, init=False)
class Cilindro(_Element):
    tipo: ClassVar[str]
    centro: Triple
    radio: float
    vector: Triple
    altura: float
    material: Optional[str]

    @overload
    def __init__(self, centro: Triple, radio: float, vector: Triple, altura: float, material: Optional[str]=...) -> None: ...

    @overload
    def __init__(self, center: Triple, radius: float, vector: Triple, *, height: float, material: Optional[str]=...) -> None: ...
    type: ClassVar[str]

    @property
    def center(self) -> Triple: ...

    @property
    def radius(self) -> float: ...

    @property
    def height(self) -> float: ...
Cylinder = Cilindro

@dataclasses.dataclass(frozen=True, init=False)
class Cono(_Element):
    tipo: ClassVar[str]
    centro: Triple
    proporcion: float
    vector: Triple
    altura: float
    material: Optional[str]

    @overload
    def __init__(self, centro: Triple, proporcion: float, vector: Triple, altura: float, material: Optional[str]=...) -> None: ...

    @overload
    def __init__(self, center: Triple, proportion: float, vector: Triple, *, height: float, material: Optional[str]=...) -> None: ...
    type: ClassVar[str]

    @property
    def center(self) -> Triple: ...

    @property
    def proportion(self) -> float: ...

    @property
    def height(self) -> float: ...
Cone = Cono

@dataclasses.dataclass(frozen=True, init=False)
class Tronco(_Element):
    tipo: ClassVar[str]
    centro: Triple
    radio: float
    proporcion: float
    vector: Triple
    altura: float
    material: Optional[str]

    @overload
    def __init__(self, centro: Triple, radio: float, proporcion: float, vector: Triple, altura: float, material: Optional[str]=...) -> None: ...

    @overload
    def __init__(self, center: Triple, radius: float, proportion: float, vector: Triple, *, height: float, material: Optional[str]=...) -> None: ...
    type: ClassVar[str]

    @property
    def center(self) -> Triple: ...

    @property
    def radius(self) -> float: ...

    @property
    def proportion(self) -> float: ...

    @property
    def height(self) -> float: ...
TruncatedCone = Tronco

@dataclasses.dataclass(frozen=True, init=False)
class Plano(_Element):
    tipo: ClassVar[str]
    centro: Triple
    vector: Triple
    material: Optional[str]

    @overload
    def __init__(self, centro: Triple, vector: Triple, material: Optional[str]=...) -> None: ...

    @overload
    def __init__(self, *, center: Triple, vector: Triple, material: Optional[str]=...) -> None: ...
    type: ClassVar[str]

    @property
    def center(self) -> Triple: ...
Plane = Plano

@dataclasses.dataclass(frozen=True, init=False)
class Disco(_Element):
    tipo: ClassVar[str]
    centro: Triple
    radio: float
    vector: Triple
    material: Optional[str]

    @overload
    def __init__(self, centro: Triple, radio: float, vector: Triple, material: Optional[str]=...) -> None: ...

    @overload
    def __init__(self, center: Triple, *, radius: float, vector: Triple, material: Optional[str]=...) -> None: ...
    type: ClassVar[str]

    @property
    def center(self) -> Triple: ...

    @property
    def radius(self) -> float: ...
Disc = Disco

@dataclasses.dataclass(frozen=True, init=False)
class Triangulo(_Element):
    tipo: ClassVar[str]
    vertices: Tuple[Triple, Triple, Triple]
    material: Optional[str]

    def __init__(self, vertices: Tuple[Triple, Triple, Triple], material: Optional[str]=...) -> None: ...
    type: ClassVar[str]
Triangle = Triangulo

@dataclasses.dataclass(frozen=True, init=False)
class Written:
    tipo: str
    attributes: Mapping[str, Union[float, Triple, Tuple[Triple, Triple, Triple]]]
    material: Optional[str]

    @overload
    def __init__(self, tipo: str, attributes: Mapping[str, Union[float, Triple, Tuple[Triple, Triple, Triple]]], material: Optional[str]=...) -> None: ...

    @overload
    def __init__(self, *, type: str, attributes: Mapping[str, Union[float, Triple, Tuple[Triple, Triple, Triple]]], material: Optional[str]=...) -> None: ...

    @property
    def type(self) -> str: ...
_Shape = Union[Esfera, Cilindro, Cono, Tronco, Plano, Disco, Triangulo]
Element = Union[Esfera, Cilindro, Cono, Tronco, Plano, Disco, Triangulo, Written]
_CLASSES: Tuple[type[_Shape], ...]
TYPES: Mapping[str, type[_Shape]]
