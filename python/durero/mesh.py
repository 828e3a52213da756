"""The audit of a mesh: what is wrong with triangles, exactly."""
from __future__ import annotations

import dataclasses
import fractions
import json
from collections.abc import Sequence
from typing import Any, Optional, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _durero
from .scene import Scene

_Point = Tuple[float, float, float]


@dataclasses.dataclass(frozen=True)
class MeshFinding:
    """Something wrong with a mesh, and where."""

    kind: str
    """Its name in the text: `abiertas`, `cruzadas`, …"""
    faces: Tuple[str, ...]
    """The names of the triangles that have it; of faces given as arrays their numbers, from 0."""
    places: Tuple[_Point, ...]
    """A vertex, the ends of an edge, the corners of a face, or a point where faces cross, rounded."""
    message: str
    mended: Tuple[str, ...]
    """Operations that mend it, as Scene.apply takes them; none where none are known."""


@dataclasses.dataclass(frozen=True)
class MeshPiece:
    """Triangles that share vertices with each other, and with no others."""

    first: str
    """The name of the first of them; of faces given as arrays its number, from 0."""
    triangles: int
    volume: Optional[fractions.Fraction]
    """Exact; None where the piece is open or its faces disagree."""


@dataclasses.dataclass(frozen=True)
class MeshCheck:
    """What is found of a mesh."""

    triangles: int
    vertices: int
    pieces: int
    volume: Optional[fractions.Fraction]
    """Exact; None where the mesh is open or its faces disagree."""
    side: Optional[str]
    """Of the point that was asked about: inside, outside, surface, or none where the triangles bound nothing."""
    findings: Tuple[MeshFinding, ...]
    each_piece: Tuple[MeshPiece, ...]


def check_mesh(
    mesh: Union[Scene, npt.NDArray[np.float64]],
    faces: Optional[npt.NDArray[np.int64]] = None,
    *,
    point: Optional[Sequence[float]] = None,
) -> MeshCheck:
    """Audits the triangles of a scene, or vertices of shape (n, 3) and faces, three numbers of them each, as one mesh.

    The findings are those of `durero check --mesh`. With a point, its side is told.

    >>> import durero, numpy as np
    >>> vertices = np.array([[0, 0, 0], [3, 0, 0], [0, 3, 0], [0, 0, 3]], float)
    >>> check = durero.check_mesh(vertices, np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]), point=(1, 1, 0.5))
    >>> check.volume, check.side, check.findings
    (Fraction(9, 2), 'inside', ())
    """
    at = None if point is None else [float(coordinate) for coordinate in point]
    if isinstance(mesh, Scene):
        if faces is not None:
            raise TypeError("faces are given beside a scene; expected them beside an array of vertices")
        text = _durero.mesh_check(mesh._scene, at)
    else:
        if faces is None:
            raise TypeError("faces are absent; expected them beside an array of vertices")
        text = _durero.mesh_check_of_arrays(mesh, faces, at)
    told = json.loads(text)
    return MeshCheck(
        told["triangles"],
        told["vertices"],
        told["pieces"],
        _volume(told),
        told["point"]["side"] if "point" in told else None,
        tuple(_finding(finding) for finding in told["findings"]),
        tuple(MeshPiece(piece["first"], piece["triangles"], _volume(piece)) for piece in told["each_piece"]),
    )


def _volume(told: dict[str, Any]) -> Optional[fractions.Fraction]:
    return fractions.Fraction(told["volume"]) if "volume" in told else None


def _finding(told: dict[str, Any]) -> MeshFinding:
    places = tuple((float(x), float(y), float(z)) for x, y, z in told["places"])
    return MeshFinding(told["kind"], tuple(told["faces"]), places, told["message"], tuple(told["mended"]))
