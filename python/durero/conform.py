"""Is a renderer right? Its hits are judged by exact arithmetic.

A verdict is a theorem: a hit is off only where no data within sixteen roundings of those given have it as their answer.
docs/conformance.md says how, and what the verdicts mean.
"""
from __future__ import annotations

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
from .english import in_both_languages
from .hits import Resultado
from .scene import Scene


class Verdict(enum.Enum):
    """How a claim stands to the truth."""

    exact = "exact"
    right = "right"
    off = "off"
    phantom = "phantom"
    missed = "missed"
    wrong_element = "wrong_element"
    far_root = "far_root"
    misplaced = "misplaced"
    out_of_range = "out_of_range"
    doubled = "doubled"
    unsorted = "unsorted"
    wrong_count = "wrong_count"
    wrong_normal = "wrong_normal"
    wrong_face = "wrong_face"
    wrong_uv = "wrong_uv"
    non_finite = "non_finite"
    crashed = "crashed"
    hung = "hung"
    skipped = "skipped"

    @property
    def meaning(self) -> str:
        """What the verdict says, in one line."""
        return _MEANINGS[self.value][0]

    @property
    def is_gross(self) -> bool:
        """Whether the picture is another: a hit for a miss, another element, far from the point, or no number."""
        return _MEANINGS[self.value][1]


_MEANINGS = {name: (meaning, is_gross) for name, meaning, is_gross in _durero.verdicts()}


class Judgement(NamedTuple):
    """The verdict on one ray, and how far off the claim is."""

    verdict: Verdict
    ulps: float
    """Of a hit where the truth is one: |t − t!| in units of the last place of t! in the system's format."""
    backward: float
    """Of a hit: how far its point is from the surface, in units of the rounding of the data; up to 16 is right."""
    clause: str
    """Skipped: of the profile, what the ray is outside of."""
    otherwise: Optional[Verdict]
    """Skipped, of a system that answered all the same: what the verdict would be inside the profile."""


@in_both_languages
@dataclasses.dataclass(frozen=True)
class Profile:
    """What a system claims for itself: what is outside of that is skipped, not judged. The defaults claim everything."""

    system: str = "system"
    format: str = "binary64"
    """Of its numbers: binary32 or binary64."""
    tipos: Sequence[str] = tuple(TYPES)
    """The elements that it knows, by their words."""
    caps: str = "open"
    """Whether its cylinders and cones are open or solid."""
    measure: str = "parameter"
    """What its t is: the parameter, the length, or nothing, where it gives a point alone."""
    directions: str = "any"
    """Whether v may be any, must be a unit vector, or must be and is unchecked."""
    inside: str = "exit_point"
    """What it answers from inside a solid: exit_point, nothing, origin or undefined."""
    names_elements: bool = True
    thickness: float = 0.0
    least_t: float = 0.0
    greatest_t: Optional[float] = None
    least_size: float = 0.0
    greatest_size: Optional[float] = None
    greatest_coordinate: Optional[float] = None
    watertight: bool = False

    def _text(self) -> str:
        members = dataclasses.asdict(self)
        system = members.pop("system")
        given = {name: value for name, value in members.items() if value is not None}
        return json.dumps({"format": "durero-profile", "version": 1, "system": system, "profile": given})


def judge(
    scene: Scene,
    rays: npt.NDArray[np.float64],
    hits: npt.NDArray[Any],
    profile: Union[Profile, str, os.PathLike[str]] = Profile(),
) -> list[Judgement]:
    """Judges what a system answered to each ray.

    `hits` is float64 of shape (n,), the t of each ray with inf for a miss; or a structured array with any of the fields
    of durero.HIT: `outcome`, without which a row is a hit where its t is not inf; `t`, `point`, `element` (the number in
    scene.names, -1 where the system does not say). `profile` is a Profile, or a file: a system's, or a profile alone.

    >>> import durero, numpy as np
    >>> scene = durero.Scene()
    >>> scene.add("s1", durero.Esfera(centro=(0, 0, 5), radio=1))
    'esfera_agregada'
    >>> rays = np.array([[0, 0, 0, 0, 0, 1]] * 3, float)
    >>> [judgement.verdict.name for judgement in durero.conform.judge(scene, rays, np.array([4, 6, np.inf]))]
    ['exact', 'far_root', 'missed']
    """
    columns = _columns(hits)
    if isinstance(profile, Profile):
        text, name = profile._text(), "profile"
    else:
        text, name = pathlib.Path(profile).read_text(encoding="utf-8"), os.fspath(profile)
    if any(column is not None and len(column) != len(rays) for column in columns):
        raise ValueError(f"{len(hits)} hits of {len(rays)} rays; expected one of each")
    numbers = columns[1]
    if numbers is not None and not np.all((numbers >= -1) & (numbers < len(scene))):
        raise ValueError(f"hits['element'] has a number beyond -1 … {len(scene) - 1}; expected those of scene.names")
    return [
        Judgement(Verdict(verdict), ulps, backward, clause, None if otherwise is None else Verdict(otherwise))
        for verdict, ulps, backward, clause, otherwise in _durero.judge(scene._scene, rays, *columns, text, name)
    ]


_Columns = Tuple[
    npt.NDArray[np.uint8],
    Optional[npt.NDArray[np.int64]],
    Optional[npt.NDArray[np.float64]],
    Optional[npt.NDArray[np.float64]],
]


def _columns(hits: npt.NDArray[Any]) -> _Columns:
    """Outcomes, elements, t and points: copies, each refused where it is no array of its kind."""
    if not isinstance(hits, np.ndarray):
        raise TypeError(f"hits is a {type(hits).__name__}; expected a numpy.ndarray")
    names = hits.dtype.names
    if names is None:
        t = _column(hits, "hits", np.float64, ())
        return np.where(t == np.inf, Resultado.miss, Resultado.hit).astype(np.uint8), None, t, None
    if not {"t", "point", "outcome"} & set(names):
        raise ValueError(f"hits has the fields {', '.join(names)}; expected outcome, t or point among them")
    given_t = _column(hits["t"], "hits['t']", np.float64, ()) if "t" in names else None
    points = _column(hits["point"], "hits['point']", np.float64, (3,)) if "point" in names else None
    elements = hits["element"].astype(np.int64) if "element" in names else None
    if "outcome" in names:
        outcomes = hits["outcome"].astype(np.uint8)
    elif given_t is not None:
        outcomes = np.where(given_t == np.inf, Resultado.miss, Resultado.hit).astype(np.uint8)
    else:
        outcomes = np.full(len(hits), Resultado.hit, np.uint8)
    return outcomes, elements, given_t, points


def _column(
    values: npt.NDArray[Any], name: str, dtype: type[np.float64], shape: Tuple[int, ...]
) -> npt.NDArray[np.float64]:
    if values.dtype != dtype:
        raise TypeError(f"{name} has the dtype {values.dtype.str}; expected float64")
    if values.shape[1:] != shape or values.ndim != 1 + len(shape):
        raise ValueError(f"{name} has the shape {values.shape}; expected (n{', 3' if shape else ','})")
    return np.array(values, dtype=dtype, order="C")


def explain(scene: Scene, ray: Union[Sequence[float], npt.NDArray[np.float64]]) -> str:
    """The exact answer to one ray in words and digits: every crossing to 40 digits and as x + y√Δ, and what else may
    be answered."""
    return _durero.explain(scene._scene, np.array([ray], dtype=np.float64))


class Family(NamedTuple):
    """A kind of rays on which renderers go wrong."""

    name: str
    kind: str
    reason: str


def families() -> list[Family]:
    """Every family, the generic one first."""
    return [Family(*family) for family in _durero.families()]


class Case(NamedTuple):
    """A scene and rays for it."""

    name: str
    scene: Scene
    rays: npt.NDArray[np.float64]


def suite(family: str, rays: int = 64, seed: int = 1, format: str = "binary32") -> list[Case]:
    """Cases of a family, with so many rays in all; the same for the same arguments, on every machine, and those of
    `durero conform make`. Every number of them is one of the format.

    >>> import durero
    >>> [(case.name, case.rays.shape) for case in durero.conform.suite("rim", rays=25)]
    [('rim/0000', (16, 6)), ('rim/0001', (9, 6))]
    """
    if format not in ("binary32", "binary64"):
        raise ValueError(f"format is {format!r}; expected binary32 or binary64")
    cases = []
    for name, drawn, rays_of_case in _durero.suite(family, rays, seed, format == "binary32"):
        scene = Scene()
        scene._scene = drawn
        cases.append(Case(name, scene, rays_of_case))
    return cases
