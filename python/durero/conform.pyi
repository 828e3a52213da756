# Made of conform.py by tests/python/stubs.py --write: the same, with the English names beside the Spanish ones.
from typing import overload
import dataclasses
import enum
import json
import os
import pathlib
from typing import Any, NamedTuple, Optional, Sequence, Tuple, Union
import numpy as np
import numpy.typing as npt
from . import _durero
from .elements import TYPES
from .hits import Resultado
from .scene import Scene

class Verdict(enum.Enum):
    exact = 'exact'
    right = 'right'
    off = 'off'
    phantom = 'phantom'
    missed = 'missed'
    wrong_element = 'wrong_element'
    far_root = 'far_root'
    misplaced = 'misplaced'
    out_of_range = 'out_of_range'
    doubled = 'doubled'
    unsorted = 'unsorted'
    wrong_count = 'wrong_count'
    wrong_normal = 'wrong_normal'
    wrong_face = 'wrong_face'
    wrong_uv = 'wrong_uv'
    non_finite = 'non_finite'
    crashed = 'crashed'
    hung = 'hung'
    skipped = 'skipped'

    @property
    def meaning(self) -> str: ...

    @property
    def is_gross(self) -> bool: ...

class Judgement(NamedTuple):
    verdict: Verdict
    ulps: float
    backward: float
    clause: str
    otherwise: Optional[Verdict]

@dataclasses.dataclass(frozen=True, init=False)
class Profile:
    system: str
    format: str
    tipos: Sequence[str]
    caps: str
    measure: str
    directions: str
    inside: str
    names_elements: bool
    thickness: float
    least_t: float
    greatest_t: Optional[float]
    least_size: float
    greatest_size: Optional[float]
    greatest_coordinate: Optional[float]
    watertight: bool

    @overload
    def __init__(self, system: str=..., format: str=..., tipos: Sequence[str]=..., caps: str=..., measure: str=..., directions: str=..., inside: str=..., names_elements: bool=..., thickness: float=..., least_t: float=..., greatest_t: Optional[float]=..., least_size: float=..., greatest_size: Optional[float]=..., greatest_coordinate: Optional[float]=..., watertight: bool=...) -> None: ...

    @overload
    def __init__(self, system: str=..., format: str=..., *, types: Sequence[str]=..., caps: str=..., measure: str=..., directions: str=..., inside: str=..., names_elements: bool=..., thickness: float=..., least_t: float=..., greatest_t: Optional[float]=..., least_size: float=..., greatest_size: Optional[float]=..., greatest_coordinate: Optional[float]=..., watertight: bool=...) -> None: ...

    @property
    def types(self) -> Sequence[str]: ...

    def _text(self) -> str: ...

def judge(scene: Scene, rays: npt.NDArray[np.float64], hits: npt.NDArray[Any], profile: Union[Profile, str, os.PathLike[str]]=...) -> list[Judgement]: ...
_Columns = Tuple[npt.NDArray[np.uint8], Optional[npt.NDArray[np.int64]], Optional[npt.NDArray[np.float64]], Optional[npt.NDArray[np.float64]]]

def explain(scene: Scene, ray: Union[Sequence[float], npt.NDArray[np.float64]]) -> str: ...

class Family(NamedTuple):
    name: str
    kind: str
    reason: str

def families() -> list[Family]: ...

class Case(NamedTuple):
    name: str
    scene: Scene
    rays: npt.NDArray[np.float64]

def suite(family: str, rays: int=..., seed: int=..., format: str=...) -> list[Case]: ...
