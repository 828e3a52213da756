#!/usr/bin/env python3
"""Writes instances.json: a tree that is made of itself, and a second one, its mirror image, which leans in the wind.

A bough bears three smaller copies of all that a bough bears. Each is turned by angles whose sines and cosines are fractions,
of the triangles (3, 4, 5) and (8, 15, 17), so that no copy is rounded. The leaves are balls, flattened.
"""
from fractions import Fraction as F

from scene_text import scene_text

LEVELS = 6


def times(a, b):
    """First b, then a; the last column is where the origin goes."""
    product = [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(4)] for i in range(3)]
    for i in range(3):
        product[i][3] += a[i][3]
    return product


def scale(x, y, z):
    return [[F(x), F(0), F(0), F(0)], [F(0), F(y), F(0), F(0)], [F(0), F(0), F(z), F(0)]]


def shift(x, y, z):
    return [[F(1), F(0), F(0), F(x)], [F(0), F(1), F(0), F(y)], [F(0), F(0), F(1), F(z)]]


def lean(s, c):
    return [[c, s, F(0), F(0)], [-s, c, F(0), F(0)], [F(0), F(0), F(1), F(0)]]


def turn(s, c):
    return [[c, F(0), s, F(0)], [F(0), F(1), F(0), F(0)], [-s, F(0), c, F(0)]]


def entry(e):
    return str(e) if F(float(e)) != e else int(e) if e.denominator == 1 else float(e)


def instance(name, of, *maps):
    mapa = maps[-1]
    for by in reversed(maps[:-1]):
        mapa = times(by, mapa)
    return {"id": name, "tipo": "instancia", "de": of, "mapa": [[entry(e) for e in row] for row in mapa]}


def prototypes():
    ball = {"tipo": "esfera", "centro": [0, 0, 0], "radio": 1}
    leaves = [dict(instance(name, ball, turn(s, c), lean(F(3, 5), F(4, 5)), shift(0, F(1, 2), 0),
                            scale(F(1, 5), F(1, 2), F(1, 20))), material=material)
              for name, s, c, material in (("a", F(0), F(1), "leaf"), ("b", F(15, 17), F(-8, 17), "leaf"),
                                           ("c", F(-15, 17), F(-8, 17), "young"))]
    bough = {"id": "wood", "tipo": "tronco", "centro": [0, 0, 0], "radio": 0.055, "proporcion": 0.03, "vector": [0, 1, 0],
             "altura": 1, "material": "bark"}
    made = {"bough0": {"elementos": leaves}}
    for level in range(1, LEVELS + 1):
        smaller = f"bough{level - 1}"
        made[f"bough{level}"] = {"elementos": [
            bough,
            instance("l", smaller, shift(0, 1, 0), lean(F(-3, 5), F(4, 5)), scale(F(2, 3), F(2, 3), F(2, 3))),
            instance("m", smaller, shift(0, F(9, 10), 0), turn(F(15, 17), F(8, 17)), lean(F(5, 13), F(12, 13)),
                     scale(F(3, 4), F(3, 4), F(-3, 4))),
            instance("r", smaller, shift(0, F(7, 10), 0), turn(F(-15, 17), F(8, 17)), lean(F(3, 5), F(4, 5)),
                     scale(F(3, 5), F(3, 5), F(3, 5)))]}
    return made


def stones():
    ball = {"tipo": "esfera", "centro": [0, 0, 0], "radio": 1}
    for i, (x, z, size) in enumerate(((-0.9, -3.3, F(1, 5)), (-0.35, -3.6, F(1, 8)), (0.25, -2.6, F(1, 4)), (1.0, -3.4, F(1, 6)),
                                      (2.5, -2.0, F(1, 4)), (-2.9, -1.9, F(1, 5)), (-1.9, -3.2, F(1, 7)))):
        s, c = ((F(3, 5), F(4, 5)), (F(-5, 13), F(12, 13)), (F(8, 17), F(15, 17)))[i % 3]
        yield dict(instance(f"stone{i}", ball, shift(F(str(x)), size / 2, F(str(z))), turn(s, c), lean(s, c),
                            scale(size * 2, size * F(2, 3), size)), material=("stone", "pewter")[i % 2])


def main():
    stage = {
        "format": "durero-scene", "version": 1,
        "camera": {"eye": [0.3, 1.9, -9.8], "look_at": [0.1, 1.1, 0], "up": [0, 1, 0], "fov_y": 31},
        "resolution": [1280, 800], "max_depth": 4,
        "environment": {"gradient": [[0.9, 0.8, 0.66], [0.22, 0.42, 0.78]]},
        "lights": [{"position": [-14, 17, -12], "color": [1.35, 1.2, 0.95], "sphere": {"radius": 1.2}}],
        "materials": {
            "bark": {"color": [0.36, 0.25, 0.17], "k_a": 0.15, "k_d": 0.85, "ambient": [0.13, 0.14, 0.17]},
            "leaf": {"color": [0.22, 0.42, 0.13], "k_a": 0.1, "k_d": 0.8, "k_s": 0.12, "e": 20, "ambient": [0.13, 0.14, 0.17]},
            "young": {"color": [0.55, 0.62, 0.2], "k_a": 0.1, "k_d": 0.8, "k_s": 0.12, "e": 20, "ambient": [0.13, 0.14, 0.17]},
            "meadow": {"color": [0.5, 0.52, 0.34], "k_a": 0.1, "k_d": 0.85, "ambient": [0.13, 0.14, 0.17]},
            "pond": {"color": [0.1, 0.16, 0.2], "k_a": 0.1, "k_d": 0.2, "k_ps": 0.6, "ambient": [0.05, 0.06, 0.07]},
            "stone": {"color": [0.6, 0.57, 0.52], "k_a": 0.1, "k_d": 0.85, "ambient": [0.13, 0.14, 0.17]},
            "pewter": {"color": [0.5, 0.5, 0.52], "k_d": 0.4, "k_s": 0.3, "e": 40, "k_ps": 0.4, "ambient": [0.06, 0.06, 0.07]}},
        "prototypes": prototypes()}
    wind = [[F(9, 10), F(-1, 4), F(0), F(0)], [F(0), F(1), F(0), F(0)], [F(0), F(0), F(-9, 10), F(0)]]
    elements = [
        {"id": "meadow", "tipo": "plano", "centro": [0, 0, 0], "vector": [0, 1, 0], "material": "meadow"},
        dict(instance("pond", {"tipo": "disco", "centro": [0, 0, 0], "radio": 1, "vector": [0, 1, 0]}, shift(F(1, 10), F(1, 100), F(-12, 5)),
                      scale(F(7, 2), 1, F(13, 10))), material="pond"),
        instance("tree", f"bough{LEVELS}", shift(F(-7, 5), 0, 0), scale(F(11, 10), F(11, 10), F(11, 10))),
        instance("image", "tree", shift(F(7, 4), 0, F(1, 2)), wind, scale(-1, F(9, 10), 1), shift(F(7, 5), 0, 0)),
        *stones()]
    print(scene_text(stage, elements))


if __name__ == "__main__":
    main()
