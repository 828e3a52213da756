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
