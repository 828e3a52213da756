#!/usr/bin/env python3
"""Writes coloured-shadows.json: a round window of clear panes between cames of lead, and two balls of glass, before a lamp.

A pane is a triangle that mirrors little and lets its colour through; its medium has the index of the air, so that light goes
straight on through it, as the coloured shadows have it.
"""
import math

from scene_text import scene_text

MIDDLE, NEAR, FAR, PARTS = (-0.55, 2.35, 1.2), 0.92, 1.9, 12
COLOURS = {"ruby": [1, 0.13, 0.1], "leaf": [0.16, 0.86, 0.24], "sky": [0.16, 0.36, 1], "honey": [1, 0.68, 0.12],
           "violet": [0.58, 0.2, 0.95], "sea": [0.1, 0.8, 0.85]}
INNER, OUTER = ("honey", "ruby"), ("sky", "leaf", "violet", "sea")


def at(radius, part):
    angle = 2 * math.pi * part / PARTS
    return [round(MIDDLE[0] + radius * math.cos(angle), 4), round(MIDDLE[1] + radius * math.sin(angle), 4), MIDDLE[2]]


def bar(name, a, b, radius, material):
    way = [q - p for p, q in zip(a, b)]
    length = math.sqrt(sum(x * x for x in way))
    return {"id": name, "tipo": "cilindro", "centro": list(a), "radio": radius, "vector": [x / length for x in way], "altura": length,
            "material": material}


def main():
    materials = {
        "plaster": {"color": [0.92, 0.9, 0.86], "k_a": 0.03, "k_d": 0.9, "ambient": [0.05, 0.05, 0.06]},
        "lead": {"color": [0.2, 0.2, 0.22], "k_a": 0.05, "k_d": 0.6, "k_s": 0.4, "e": 30, "ambient": [0.01, 0.01, 0.01]},
        "rose-ball": {"color": [0, 0, 0], "k_d": 0, "k_s": 0.6, "e": 300, "k_ps": 0.07, "k_t": 0.93, "M_T": [1, 0.5, 0.62], "index": 1.3},
        "green-ball": {"color": [0, 0, 0], "k_d": 0, "k_s": 0.6, "e": 300, "k_ps": 0.07, "k_t": 0.93, "M_T": [0.5, 0.95, 0.6], "index": 1.3},
    }
    for name, colour in COLOURS.items():
        materials[name] = {"color": colour, "k_d": 0.12, "k_s": 0.2, "e": 90, "k_ps": 0.04, "k_t": 0.9, "M_T": colour}
    elements = [
        {"id": "floor", "tipo": "plano", "centro": [0, 0, 0], "vector": [0, 1, 0], "material": "plaster"},
        {"id": "wall", "tipo": "plano", "centro": [0, 0, 9], "vector": [0, 0, -1], "material": "plaster"},
        {"id": "rose", "tipo": "esfera", "centro": [2.55, 0.8, 0.1], "radio": 0.8, "material": "rose-ball"},
        {"id": "green", "tipo": "esfera", "centro": [1.75, 0.45, -1.75], "radio": 0.45, "material": "green-ball"},
        bar("foot", [MIDDLE[0], 0, MIDDLE[2]], at(FAR, 9), 0.07, "lead"),
    ]
    for i in range(PARTS):
        a, b, c, d = at(NEAR, i), at(NEAR, i + 1), at(FAR, i + 1), at(FAR, i)
        outer = OUTER[i % len(OUTER)]
        elements += [
            {"id": f"inner{i}", "tipo": "triangulo", "vertices": [list(MIDDLE), a, b], "material": INNER[i % 2]},
            {"id": f"outer{i}a", "tipo": "triangulo", "vertices": [a, b, c], "material": outer},
            {"id": f"outer{i}b", "tipo": "triangulo", "vertices": [a, c, d], "material": outer},
            bar(f"spoke{i}", list(MIDDLE), d, 0.022, "lead"), bar(f"ring{i}", a, b, 0.03, "lead"), bar(f"rim{i}", d, c, 0.06, "lead"),
            {"id": f"knot{i}", "tipo": "esfera", "centro": d, "radio": 0.075, "material": "lead"},
        ]
    stage = {
        "format": "durero-scene", "version": 1,
        "camera": {"eye": [1.4, 4.6, -11.5], "look_at": [0.55, 1.25, -0.2], "up": [0, 1, 0], "fov_y": 32},
        "resolution": [1280, 720], "background": [0.03, 0.03, 0.05], "max_depth": 8,
        "lights": [{"position": [-3.2, 7.6, 8.2], "color": [0.9, 0.87, 0.8], "disc": {"radius": 0.12, "normal": [0.35, -0.6, -0.75]}},
                   {"position": [4, 7, -9], "color": [0.2, 0.21, 0.25]}],
        "materials": materials,
    }
    print(scene_text(stage, elements))


if __name__ == "__main__":
    main()
