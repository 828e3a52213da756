# Made of scene.py by tests/python/stubs.py --write: the same, with the English names beside the Spanish ones.
from typing import overload
import copy
import dataclasses
import json
import os
import pathlib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any, Literal, NamedTuple, Optional, Tuple, Union, overload
import numpy as np
import numpy.typing as npt
from . import _durero
from .elements import TYPES, Element, Written
from .exact import ExactHit, surd
from .hits import Resultado
_Path = Union[str, os.PathLike[str]]
_Numbers = Union[npt.NDArray[np.int32], npt.NDArray[np.int64]]
Origins = Union[_Numbers, Tuple[_Numbers, _Numbers]]

class HitsWithElements(NamedTuple):
    hits: npt.NDArray[np.void]
    offsets: npt.NDArray[np.int64]
    elements: npt.NDArray[np.int32]

class Group(NamedTuple):
    elementos: Tuple[str, ...]
    groups: Tuple[str, ...]

    @property
    def elements(self) -> Tuple[str, ...]: ...

class Answer(str):
    left_group: Optional[str]

    def __new__(cls, r: str, left_group: str=...) -> Answer: ...

class Mesh(NamedTuple):
    vertices: npt.NDArray[np.float64]
    faces: npt.NDArray[np.uint32]
    normals: Optional[npt.NDArray[np.float64]]
    uv: Optional[npt.NDArray[np.float64]]
    material: Optional[str]

class Imported(NamedTuple):
    scene: Scene
    lost: Tuple[str, ...]

class Scene(Mapping[str, Element]):
    _scene: _durero.Scene
    __hash__ = None  # type: ignore[assignment]

    def __init__(self) -> None: ...

    @classmethod
    def load(cls, path: Union[str, os.PathLike[str]], *, surfaces: Optional[_Path]=...) -> Scene: ...

    @classmethod
    def loads(cls, text: str, name: str=..., *, surfaces: Optional[_Path]=...) -> Scene: ...

    @classmethod
    def _read(cls, text: bytes, name: str, surfaces: Optional[_Path]) -> Scene: ...

    @classmethod
    def import_file(cls, path: _Path, *, triangles: Optional[Literal['mesh', 'single']]=..., root: Optional[_Path]=..., surfaces: Optional[_Path]=...) -> Imported: ...

    def export_file(self, path: _Path, *, binary: bool=...) -> Tuple[str, ...]: ...

    @property
    def surfaces(self) -> Optional[str]: ...

    def save(self, path: Union[str, os.PathLike[str]]) -> None: ...

    def dumps(self) -> str: ...

    def apply(self, operation: str) -> Answer: ...

    def apply_all(self, operations: Union[str, Iterable[str]]) -> list[Answer]: ...

    def add(self, e: str, element: Element) -> Answer: ...

    def remove(self, e: str) -> Answer: ...

    @overload
    def group(self, g: str, elementos: Iterable[str]=..., groups: Iterable[str]=...) -> Answer: ...

    @overload
    def group(self, g: str, *, elements: Iterable[str]=..., groups: Iterable[str]=...) -> Answer: ...

    def ungroup(self, g: str) -> Answer: ...

    def close(self, e: str, base: str | None=..., top: str | None=...) -> Answer: ...

    def add_mesh(self, m: str, vertices: object, faces: object=..., *, normals: Optional[npt.NDArray[np.floating[Any]]]=..., uv: Optional[npt.NDArray[np.floating[Any]]]=..., material: Optional[str]=...) -> Answer: ...

    def replace_mesh(self, m: str, vertices: object, faces: object=..., *, normals: Optional[npt.NDArray[np.floating[Any]]]=..., uv: Optional[npt.NDArray[np.floating[Any]]]=..., material: Optional[str]=...) -> Answer: ...

    def remove_mesh(self, m: str) -> Answer: ...

    @overload
    def move_vertex(self, m: str, n: int, punto: Sequence[float]) -> Answer: ...

    @overload
    def move_vertex(self, m: str, n: int, *, point: Sequence[float]) -> Answer: ...

    @property
    def meshes(self) -> dict[str, Mesh]: ...

    @property
    def faces(self) -> npt.NDArray[np.int32]: ...

    @property
    def groups(self) -> dict[str, Group]: ...

    def _operate(self, operation: dict[str, object]) -> Answer: ...

    def __len__(self) -> int: ...

    def __contains__(self, name: object) -> bool: ...

    def __iter__(self) -> Iterator[str]: ...

    def __getitem__(self, name: str) -> Element: ...

    @property
    def names(self) -> Tuple[str, ...]: ...

    @property
    def materials(self) -> Tuple[str, ...]: ...

    def __eq__(self, other: object) -> bool: ...

    def __repr__(self) -> str: ...

    def __copy__(self) -> Scene: ...

    def __deepcopy__(self, memo: dict[int, object]) -> Scene: ...

    def __getstate__(self) -> Tuple[str, Optional[str]]: ...

    def __setstate__(self, state: Tuple[str, Optional[str]]) -> None: ...

    @overload
    def trace(self, rays: npt.NDArray[np.float64], engine: str=..., *, en: Optional[Origins]=..., elements: Literal['first']=..., hierarchy: str=...) -> npt.NDArray[np.void]: ...

    @overload
    def trace(self, rays: npt.NDArray[np.float64], engine: str=..., *, on: Optional[Origins]=..., elements: Literal['first']=..., hierarchy: str=...) -> npt.NDArray[np.void]: ...

    @overload
    def trace(self, rays: npt.NDArray[np.float64], engine: str=..., *, en: Optional[Origins]=..., elements: Literal['all'], hierarchy: str=...) -> HitsWithElements: ...

    @overload
    def trace(self, rays: npt.NDArray[np.float64], engine: str=..., *, on: Optional[Origins]=..., elements: Literal['all'], hierarchy: str=...) -> HitsWithElements: ...

    def distance(self, points: npt.NDArray[np.float64]) -> npt.NDArray[np.void]: ...

    @overload
    def occluded(self, rays: npt.NDArray[np.float64], engine: str=..., *, en: Optional[Origins]=..., hierarchy: str=...) -> npt.NDArray[np.bool_]: ...

    @overload
    def occluded(self, rays: npt.NDArray[np.float64], engine: str=..., *, on: Optional[Origins]=..., hierarchy: str=...) -> npt.NDArray[np.bool_]: ...

    @overload
    def occluded_segment(self, rays: npt.NDArray[np.float64], engine: str=..., *, en: Optional[Origins]=..., hierarchy: str=...) -> npt.NDArray[np.bool_]: ...

    @overload
    def occluded_segment(self, rays: npt.NDArray[np.float64], engine: str=..., *, on: Optional[Origins]=..., hierarchy: str=...) -> npt.NDArray[np.bool_]: ...

    @overload
    def exact(self, ray: Union[Sequence[float], npt.NDArray[np.float64]], en: Iterable[str]=...) -> ExactHit: ...

    @overload
    def exact(self, ray: Union[Sequence[float], npt.NDArray[np.float64]], *, on: Iterable[str]=...) -> ExactHit: ...

    def render(self, size: Optional[Tuple[int, int]]=..., engine: str=..., *, hierarchy: str=...) -> npt.NDArray[np.uint8]: ...
