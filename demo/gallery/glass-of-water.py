#!/usr/bin/env python3
"""Writes glass-of-water.json: a tumbler with water and a pencil in it.

The tumbler is one closed surface of revolution, as smooth triangles whose normals point out of the glass, into the cavity
too. The wall of the water lies within the wall of the glass, so that a ray passes from one to the other with no air between.
"""
import math

from scene_text import scene_text

SEGMENTS = 64
PROFILE = (  # (radius, height, normal outwards, normal upwards): a corner stands twice, once for each side of it
    (0.0, 0.02, 0, -1), (0.9, 0.02, 0, -1), (0.98, 0.1, 1, -0.3), (1.1, 1.4, 1, -0.1), (1.22, 2.7, 1, -0.1), (1.21, 2.76, 0.6, 1),
    (1.16, 2.78, 0, 1), (1.11, 2.76, -0.6, 1), (1.1, 2.7, -1, 0.1), (0.99, 1.5, -1, 0.1), (0.9, 0.42, -1, 0.3), (0.84, 0.34, -0.5, 1),
    (0.0, 0.32, 0, 1))


def around(radius, height, segment):
    angle = 2 * math.pi * segment / SEGMENTS
    return [round(x, 4) + 0.0 for x in (radius * math.cos(angle), height, radius * math.sin(angle))]


def triangles():
    for (r, h, n, m), (s, k, o, p) in zip(PROFILE, PROFILE[1:]):
        for i in range(SEGMENTS):
            points = around(r, h, i), around(r, h, i + 1), around(s, k, i + 1), around(s, k, i)
            normals = around(n, m, i), around(n, m, i + 1), around(o, p, i + 1), around(o, p, i)
            for a, b, c in ((0, 2, 1), (0, 3, 2)):
                if points[a] != points[b] and points[b] != points[c] and points[c] != points[a]:
                    yield [points[j] for j in (a, b, c)], [normals[j] for j in (a, b, c)]


def main():
    level, low = 2.05, 0.33
    stage = {
        "format": "durero-scene", "version": 1,
        "camera": {"eye": [0.6, 3.4, -8.2], "look_at": [0.05, 1.35, 0], "up": [0, 1, 0], "fov_y": 32},
        "resolution": [1280, 960], "max_depth": 60,
        "environment": {"gradient": [[0.86, 0.84, 0.8], [0.45, 0.6, 0.8]]},
        "lights": [{"position": [-6, 9, -5], "color": [0.9, 0.88, 0.82]}],
        "textures": {"tiles": {"checker": [[0.93, 0.9, 0.84], [0.3, 0.42, 0.52]], "repeat": [12, 12]}},
        "materials": {
            "table": {"color": [1, 1, 1], "k_a": 0.1, "k_d": 0.65, "ambient": [0.32, 0.32, 0.32],
                      "textures": {"color": "tiles", "ambient": "tiles"}},
            "glass": {"color": [0, 0, 0], "k_d": 0, "k_s": 0.8, "e": 300, "k_ps": 0.05, "k_t": 0.95, "M_T": [0.97, 1, 0.985], "index": 1.5},
            "water": {"color": [0, 0, 0], "k_d": 0, "k_s": 0.5, "e": 300, "k_ps": 0.04, "k_t": 0.96, "M_T": [0.95, 0.99, 1], "index": 1.333},
            "lacquer": {"color": [0.9, 0.62, 0.08], "k_a": 0.1, "k_d": 0.75, "k_s": 0.4, "e": 60, "ambient": [0.25, 0.17, 0.02]},
            "wood": {"color": [0.82, 0.62, 0.4], "k_a": 0.1, "k_d": 0.75, "ambient": [0.22, 0.16, 0.1]},
            "rubber": {"color": [0.8, 0.35, 0.32], "k_a": 0.1, "k_d": 0.75, "ambient": [0.2, 0.09, 0.08]},
            "tin": {"color": [0.6, 0.6, 0.62], "k_a": 0.1, "k_d": 0.4, "k_s": 0.7, "e": 40, "k_ps": 0.3, "ambient": [0.08, 0.08, 0.08]},
        },
    }
    foot, top = (0.5, 0.45, 0.25), (-1.35, 4.0, -0.35)
    axis = tuple(b - a for a, b in zip(foot, top))
    length = math.sqrt(sum(x * x for x in axis))
    d = [x / length for x in axis]

    def at(s):
        return [a + s * b for a, b in zip(foot, d)]
    elements = [
        {"id": "table", "tipo": "disco", "centro": [0, 0, 2], "radio": 6, "vector": [0, 1, 0], "material": "table"},
        {"id": "water", "tipo": "tronco", "centro": [0, level, 0], "radio": 0.93, "proporcion": 0.12 / (level - low), "vector": [0, -1, 0],
         "altura": level - low, "material": "water"},
        {"id": "water-top", "tipo": "disco", "centro": [0, level, 0], "radio": 1.05, "vector": [0, 1, 0], "material": "water"},
        {"id": "water-low", "tipo": "disco", "centro": [0, low - 0.06, 0], "radio": 0.93, "vector": [0, -1, 0], "material": "water"},
        {"id": "point", "tipo": "cono", "centro": at(0.32), "proporcion": 0.1 / 0.32, "vector": [-x for x in d], "altura": 0.32, "material": "wood"},
        {"id": "pencil", "tipo": "cilindro", "centro": at(0.32), "radio": 0.1, "vector": d, "altura": length - 0.72, "material": "lacquer"},
        {"id": "band", "tipo": "cilindro", "centro": at(length - 0.4), "radio": 0.105, "vector": d, "altura": 0.18, "material": "tin"},
        {"id": "rubber", "tipo": "cilindro", "centro": at(length - 0.22), "radio": 0.1, "vector": d, "altura": 0.2, "material": "rubber"},
        {"id": "rubber-end", "tipo": "disco", "centro": at(length - 0.02), "radio": 0.1, "vector": d, "material": "rubber"},
    ]
    for number, (corners, normals) in enumerate(triangles(), 1):
        elements.append({"id": f"glass{number}", "tipo": "triangulo", "vertices": corners, "material": "glass", "normals": normals})
    print(scene_text(stage, elements))


if __name__ == "__main__":
    main()
