"""The exact value is a number x + y√Δ: it solves the equation of what was hit, and rounds to what trace publishes."""
from __future__ import annotations

import math
from decimal import Decimal, localcontext
from fractions import Fraction

import numpy as np
import pytest
from support import STILL_LIFE, along_z, random_rays, sphere_scene

import durero
from durero import Surd


def test_it_rounds_to_what_trace_publishes() -> None:
    scene = durero.Scene.load(STILL_LIFE)
    rays = random_rays(400, seed=5)
    for ray, hit in zip(rays, scene.trace(rays)):
        exact = scene.exact(ray)
        assert exact.outcome == hit["outcome"]
        if exact.t is None or exact.point is None:
            assert np.isnan(hit["t"])
            continue
        assert float(exact.t) == hit["t"] and [float(x) for x in exact.point] == hit["point"].tolist()
        assert scene.names[hit["element"]] == exact.elements[0]


def test_it_solves_the_equation_of_a_sphere() -> None:
    scene = durero.Scene()
    scene.add("s", durero.Esfera(centro=(0.1, -0.2, 5.3), radio=1.7))
    p, v = (0.3, 0.1, 0.0), (0.01, 0.02, 0.7)
    t = scene.exact((*p, *v)).t
    assert t is not None and t.y != 0
    q = [Fraction(a) - Fraction(c) for a, c in zip(p, (0.1, -0.2, 5.3))]
    w = [Fraction(x) for x in v]
    a, b, c = sum(x * x for x in w), sum(x * y for x, y in zip(q, w)), sum(x * x for x in q) - Fraction(1.7) ** 2
    # t = x + y√Δ, so a·t² + 2b·t + c is rational + irrational·√Δ, and both are 0.
    assert a * (t.x * t.x + t.y * t.y * t.delta) + 2 * b * t.x + c == 0
    assert 2 * a * t.x * t.y + 2 * b * t.y == 0 and t.y < 0


def test_a_surd_is_rounded_once() -> None:
    with localcontext() as context:
        context.prec = 60
        for x, y, delta in [(Fraction(1, 3), Fraction(-2, 7), Fraction(5)), (Fraction(0), Fraction(1), Fraction(2))]:
            terms = [Decimal(part.numerator) / Decimal(part.denominator) for part in (x, y, delta)]
            assert float(Surd(x, y, delta)) == float(terms[0] + terms[1] * terms[2].sqrt())
    assert float(Surd(Fraction(1, 3), Fraction(0), Fraction(0))) == 1 / 3
    halfway = Fraction(1) + Fraction(1, 2**53)
    assert float(Surd(halfway, Fraction(0), Fraction(0))) == 1.0
    assert float(Surd(halfway, Fraction(1, 2**2000), Fraction(2))) == math.nextafter(1.0, 2.0)
    assert str(Surd(Fraction(1, 2), Fraction(-3), Fraction(2))) == "1/2 + -3·√(2)"
    with pytest.raises(ValueError):
        float(Surd(Fraction(0), Fraction(1), Fraction(-1)))


def test_numbers_of_any_length_come_through() -> None:
    scene = durero.Scene()
    scene.add("s", durero.Esfera(centro=(5e-324, 1.7e300, 3.3e-160), radio=1.6e300))
    t = scene.exact((0, 0, 1e-300, 1e-5, 0.1, 1e-200)).t
    assert t is not None and t.delta.denominator.bit_length() + t.delta.numerator.bit_length() > 4300 * 3.33 / 4
    assert float(t) == scene.trace(np.array([[0, 0, 1e-300, 1e-5, 0.1, 1e-200]]))["t"][0]


def test_one_ray_is_six_numbers() -> None:
    scene = sphere_scene()
    assert scene.exact([0, 0, 0, 0, 0, 1]) == scene.exact(along_z()[0]) == scene.exact(np.array([0, 0, 0, 0, 0, 1]))
    assert scene.exact((0, 0, 0, 0, 1, 0)).t is None
    assert scene.exact((0, 0, 4, 0, 0, 1), en="s1").t == Surd(Fraction(2), Fraction(0), Fraction(0))
    for ray in ([0, 0, 0, 0, 0], [[0, 0, 0, 0, 0, 1]], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, math.nan], [0, 0, 0, 0, 1, Fraction(1, 3)]):
        with pytest.raises((ValueError, TypeError)):
            scene.exact(ray)  # type: ignore[call-overload]
    with pytest.raises(KeyError):
        scene.exact((0, 0, 0, 0, 0, 1), en=["none"])
