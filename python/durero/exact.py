"""The exact value of a first hit: numbers x + y√Δ over the rationals."""
from __future__ import annotations

import dataclasses
from fractions import Fraction
from typing import Optional, Tuple

from . import _durero
from .hits import Resultado


@dataclasses.dataclass(frozen=True)
class Surd:
    """The number x + y√delta. Where that is rational by sight, y and delta are 0."""

    x: Fraction
    y: Fraction
    delta: Fraction

    def __float__(self) -> float:
        """The value rounded once to the nearest binary64, ties to even: what trace publishes."""
        return _durero.rounded(*(_hexadecimal(part) for part in (self.x, self.y, self.delta)))

    def __str__(self) -> str:
        return f"{self.x} + {self.y}·√({self.delta})" if self.y else str(self.x)


@dataclasses.dataclass(frozen=True)
class ExactHit:
    """The first hit of a ray, not rounded: t and point are there for a hit alone."""

    outcome: Resultado
    elements: Tuple[str, ...]
    """Every element that the point lies on, by name; without a nearest point, the elements that have none."""
    t: Optional[Surd]
    point: Optional[Tuple[Surd, Surd, Surd]]


_Hexadecimal = Tuple[str, str]


def _hexadecimal(value: Fraction) -> _Hexadecimal:
    return (f"{value.numerator:x}", f"{value.denominator:x}")


def _fraction(digits: _Hexadecimal) -> Fraction:
    return Fraction(int(digits[0], 16), int(digits[1], 16))


def surd(parts: Tuple[_Hexadecimal, _Hexadecimal, _Hexadecimal]) -> Surd:
    """The number that the compiled module says."""
    return Surd(_fraction(parts[0]), _fraction(parts[1]), _fraction(parts[2]))
