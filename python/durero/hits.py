"""What a ray is answered, and the array that holds many answers."""
from __future__ import annotations

import enum

from . import _durero


class Resultado(enum.IntEnum):
    """The outcome of a first intersection, in the field `outcome` of an array of hits."""

    hit = 0
    """There is a nearest point."""
    miss = 1
    """The ray meets nothing."""
    no_minimum = 2
    """The ray starts inside a stretch of a surface, so that there are points as near as one likes."""


Outcome = Resultado
"""Resultado, in English."""

HIT = _durero.hit_dtype
"""The dtype of an array of hits. A row has the fields

outcome   u1      a Resultado
tied      bool    whether the point lies on more elements than one
element   i4      the number of the element in scene.names, of several the first by name; -1 for none
t         f8      the parameter of the point p + t·v, rounded once; NaN without a hit
point     3 f8    each coordinate rounded once; NaN without a hit
"""


class Count(enum.IntEnum):
    """How many points of a scene are nearest to a point."""

    none = 0
    """The scene has no element."""
    one = 1
    """One point is nearest."""
    many = 2
    """Several are, or a whole ring or sphere of them."""


PROXIMITY = _durero.proximity_dtype
"""The dtype of an array of distances. A row has the fields

count     u1      a Count
tied      bool    whether more elements than one have the distance
element   i4      the number of the element in scene.names, of several the first by name; -1 of an empty scene
distance  f8      how far the nearest point is, rounded once; NaN of an empty scene
point     3 f8    the nearest point, of many the first by x, y, z, each coordinate rounded once; NaN of an empty scene
"""
