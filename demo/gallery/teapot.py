#!/usr/bin/env python3
"""Writes teapot.json: the teapot of M. Newell (1975), 32 patches of Bézier as smooth triangles, that mirrors a stadium."""
import math

from scene_text import scene_text

STEPS = 5  # the parts of a patch each way
PROFILES = (  # (radius, height) of four control points each: rim, body, knob, lid, bottom
    ((1.4, 2.4), (1.3375, 2.53125), (1.4375, 2.53125), (1.5, 2.4)),
    ((1.5, 2.4), (1.75, 1.875), (2, 1.35), (2, 0.9)),
    ((2, 0.9), (2, 0.45), (1.5, 0.225), (1.5, 0.15)),
    ((0, 3.15), (0.8, 3.15), (0, 2.7), (0.2, 2.7)),
    ((0.2, 2.7), (0.4, 2.55), (1.3, 2.55), (1.3, 2.4)),
    ((1.5, 0.15), (1.5, 0.075), (1.425, 0), (0, 0)),
)
SIDES = (  # rows of (x of the inner edge, its height, half the breadth, x of the outer edge, its height): handle, then spout
    ((-1.6, 2.025, 0.3, -1.5, 2.25), (-2.3, 2.025, 0.3, -2.5, 2.25), (-2.7, 2.025, 0.3, -3, 2.25), (-2.7, 1.8, 0.3, -3, 1.8)),
    ((-2.7, 1.8, 0.3, -3, 1.8), (-2.7, 1.575, 0.3, -3, 1.35), (-2.5, 1.125, 0.3, -2.65, 0.9375), (-2, 0.9, 0.3, -1.9, 0.6)),
    ((1.7, 1.425, 0.66, 1.7, 0.6), (2.6, 1.425, 0.66, 3.1, 0.825), (2.3, 2.1, 0.25, 2.4, 2.025), (2.7, 2.4, 0.25, 3.3, 2.4)),
    ((2.7, 2.4, 0.25, 3.3, 2.4), (2.8, 2.475, 0.25, 3.525, 2.49375), (2.9, 2.475, 0.15, 3.45, 2.5125), (2.8, 2.4, 0.15, 3.2, 2.4)),
)


def patches():
    """Four rows of four control points each, in Newell's axes: z is up."""
    for profile in PROFILES:
        for turn in range(4):
            c, s = round(math.cos(turn * math.pi / 2)), round(math.sin(turn * math.pi / 2))
            yield [[(c * x * r - s * y * r, s * x * r + c * y * r, h) for x, y in ((1, 0), (1, 0.56), (0.56, 1), (0, 1))]
                   for r, h in profile]
    for rows in SIDES:
        for side in (1, -1):
            yield [[(x, 0, z), (x, side * w, z), (u, side * w, v), (u, 0, v)] for x, z, w, u, v in rows]


def bernstein(t):
    return ((1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3)


def slope(t):
    return (-3 * (1 - t) ** 2, 3 * (1 - t) ** 2 - 6 * t * (1 - t), 6 * t * (1 - t) - 3 * t * t, 3 * t * t)


def mean(patch, rows, columns):
    return tuple(sum(a * b * patch[i][j][k] for i, a in enumerate(rows) for j, b in enumerate(columns)) for k in range(3))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def normal(patch, s, t):
    """A patch may end in a point, which has no normal of its own: that of a point near it."""
    for at in (s, min(max(s, 1e-3), 1 - 1e-3)):
        n = cross(mean(patch, slope(at), bernstein(t)), mean(patch, bernstein(at), slope(t)))
        length = math.sqrt(sum(x * x for x in n))
        if length > 1e-6:
            return tuple(x / length for x in n)
    return (0, 0, 1)


def seen(p):
    """The picture's axes: y is up."""
    return [round(p[0], 4) + 0.0, round(p[2], 4) + 0.0, round(p[1], 4) + 0.0]


def triangles():
    for patch in patches():
        place = [(i / STEPS, j / STEPS) for i in range(STEPS + 1) for j in range(STEPS + 1)]
        points = [seen(mean(patch, bernstein(s), bernstein(t))) for s, t in place]
        normals = [seen(normal(patch, s, t)) for s, t in place]
        for i in range(STEPS):
            for j in range(STEPS):
                a, b, c, d = (k * (STEPS + 1) + m for k, m in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)))
                for corners in ((a, b, c), (a, c, d)):
                    p, q, r = (points[k] for k in corners)
                    if p not in (q, r) and q != r:
                        yield [p, q, r], [normals[k] for k in corners]


def main():
    stage = {
        "format": "durero-scene", "version": 1,
        "camera": {"eye": [-3.6, 2.75, -10.4], "look_at": [0.2, 1.5, 0], "up": [0, 1, 0], "fov_y": 33},
        "resolution": [1280, 800], "max_depth": 5,
        "environment": {"equirectangular": "stadium.png"},
        "lights": [{"position": [-9, 14, -12], "color": [0.7, 0.68, 0.6]}, {"position": [12, 12, -6], "color": [0.3, 0.3, 0.35]}],
        "textures": {"squares": {"checker": [[0.82, 0.78, 0.7], [0.45, 0.2, 0.16]], "repeat": [7, 7]}},
        "materials": {
            "china": {"color": [0.25, 0.3, 0.4], "k_a": 0.05, "k_d": 0.3, "k_s": 0.8, "e": 200, "k_ps": 0.62, "M_PS": [0.95, 0.97, 1]},
            "table": {"color": [1, 1, 1], "k_a": 0.15, "k_d": 0.6, "k_ps": 0.08, "ambient": [0.3, 0.3, 0.3],
                      "textures": {"color": "squares", "ambient": "squares"}},
            "rim": {"color": [0.5, 0.4, 0.2], "k_a": 0.1, "k_d": 0.5, "k_s": 0.6, "e": 50, "k_ps": 0.3, "ambient": [0.1, 0.08, 0.04]},
        },
    }
    elements = [{"id": "table", "tipo": "disco", "centro": [0.3, 0, 0], "radio": 4.6, "vector": [0, 1, 0], "material": "table"},
                {"id": "rim", "tipo": "cilindro", "centro": [0.3, -0.35, 0], "radio": 4.6, "vector": [0, 1, 0], "altura": 0.35, "material": "rim"}]
    for number, (corners, normals) in enumerate(triangles(), 1):
        elements.append({"id": f"pot{number}", "tipo": "triangulo", "vertices": corners, "material": "china", "normals": normals})
    print(scene_text(stage, elements))


if __name__ == "__main__":
    main()
