#!/usr/bin/env python3
"""Writes solids.json: solids that are joined by union, intersection and difference.

Dürer's solid of Melencolia I (1514) is eight half-spaces; the magnifying glass two balls, within a ring that is two
cylinders; the die a box in a ball without 21 balls; the brass one a box in a ball without three rods; the bowl half a ball
without another.
"""
import math

from scene_text import scene_text


def sphere(centre, radius):
    return {"tipo": "esfera", "centro": centre, "radio": radius}


def cylinder(centre, radius, vector, height):
    return {"tipo": "cilindro", "centro": centre, "radio": radius, "vector": vector, "altura": height}


def behind(point, normal):
    return {"tipo": "plano", "centro": point, "vector": normal}


def box(low, high):
    return {"tipo": "caja", "esquinas": [low, high]}


def union(*parts):
    return {"tipo": "union", "de": list(parts)}


def intersection(*parts):
    return {"tipo": "interseccion", "de": list(parts)}


def difference(first, *others):
    return {"tipo": "diferencia", "de": [first, *others]}


def rounded(*numbers):
    return [round(number, 6) + 0.0 for number in numbers]


def melencolia(x, z, height, turn):
    """A rhombohedron on its tip, six planes at one distance, cut off above and below by two."""
    rise, centre = math.radians(27), [x, height, z]
    planes = [behind([x, 2 * height, z], [0, 1, 0]), behind([x, 0, z], [0, -1, 0])]
    for k in range(3):
        around = turn + 2 * math.pi * k / 3
        n = [math.cos(rise) * math.cos(around), math.sin(rise), math.cos(rise) * math.sin(around)]
        for sign in (1, -1):
            normal = [sign * a for a in n]
            planes.append(behind([c + 1.0 * a for c, a in zip(centre, normal)], normal))
    return intersection(*planes)


def die(x, z, half):
    """One at its right, two in front, three above, and opposite faces make seven."""
    y, step, radius = half, 0.5 * half, 0.2 * half
    places = {1: [(0, 0)], 2: [(-1, -1), (1, 1)], 3: [(-1, -1), (0, 0), (1, 1)], 4: [(-1, -1), (-1, 1), (1, -1), (1, 1)],
              5: [(-1, -1), (-1, 1), (0, 0), (1, -1), (1, 1)], 6: [(-1, -1), (-1, 0), (-1, 1), (1, -1), (1, 0), (1, 1)]}
    pips = []
    for count, axis, sign in ((1, 0, 1), (6, 0, -1), (3, 1, 1), (4, 1, -1), (2, 2, -1), (5, 2, 1)):
        for a, b in places[count]:
            at = [a * step, b * step]
            at.insert(axis, sign * 1.06 * half)
            pips.append(sphere(rounded(x + at[0], y + at[1], z + at[2]), radius))
    return difference(intersection(box(rounded(x - half, 0, z - half), rounded(x + half, 2 * half, z + half)),
                                   sphere([x, y, z], rounded(1.42 * half)[0])), *pips)


def glass(x, y, z):
    """The lens, and its ring on a stem and a foot: what carries the lens is cut out for it."""
    lens = intersection(sphere([x, y, z - 5.87], 6), sphere([x, y, z + 5.87], 6))
    ring = union(cylinder([x, y, z - 0.12], 1.36, [0, 0, 1], 0.24), cylinder([x, 0.1, z], 0.1, [0, 1, 0], 0.6),
                 intersection(sphere([x, -0.9, z], 1.1), behind([x, 0, z], [0, -1, 0])))
    return lens, difference(ring, cylinder([x, y, z - 0.5], 1.2, [0, 0, 1], 1), lens)


def drilled(x, z):
    centre, reach = [x, 1, z], 1.6
    rods = []
    for axis in range(3):
        vector = [0, 0, 0]
        vector[axis] = 1
        rods.append(cylinder([c - reach * v for c, v in zip(centre, vector)], 0.58, vector, 2 * reach))
    return difference(intersection(box([x - 1, 0, z - 1], [x + 1, 2, z + 1]), sphere(centre, 1.3)), union(*rods))


def bowl(x, z):
    whole = intersection(sphere([x, 0.9, z], 0.95), behind([x, 0.8, z], [0, 1, 0]), behind([x, 0, z], [0, -1, 0]))
    return difference(whole, sphere([x, 0.95, z], 0.87))


def main():
    stage = {
        "format": "durero-scene", "version": 1,
        "camera": {"eye": [0.4, 4.1, -10.5], "look_at": [0.1, 0.95, 0], "up": [0, 1, 0], "fov_y": 30},
        "resolution": [1280, 800], "max_depth": 8,
        "environment": {"gradient": [[0.9, 0.87, 0.82], [0.42, 0.55, 0.75]]},
        "lights": [{"position": [-7, 10, -7], "color": [0.9, 0.88, 0.82]}],
        "textures": {"tiles": {"checker": [[0.9, 0.86, 0.78], [0.5, 0.33, 0.26]], "repeat": [22, 22]}},
        "materials": {
            "floor": {"color": [1, 1, 1], "k_a": 0.1, "k_d": 0.65, "ambient": [0.28, 0.28, 0.28],
                      "textures": {"color": "tiles", "ambient": "tiles"}},
            "stone": {"color": [0.72, 0.7, 0.66], "k_a": 0.1, "k_d": 0.75, "ambient": [0.2, 0.2, 0.2]},
            "glass": {"color": [0, 0, 0], "k_d": 0, "k_s": 0.8, "e": 300, "k_ps": 0.05, "k_t": 0.95, "M_T": [0.98, 1, 0.99], "index": 1.5},
            "brass": {"color": [0.78, 0.58, 0.24], "k_a": 0.1, "k_d": 0.5, "k_s": 0.7, "e": 60, "k_ps": 0.25, "ambient": [0.17, 0.12, 0.05]},
            "ivory": {"color": [0.93, 0.89, 0.78], "k_a": 0.1, "k_d": 0.75, "k_s": 0.35, "e": 50, "ambient": [0.24, 0.23, 0.2]},
            "red": {"color": [0.75, 0.16, 0.13], "k_a": 0.1, "k_d": 0.75, "k_s": 0.35, "e": 50, "ambient": [0.2, 0.045, 0.035]},
            "copper": {"color": [0.72, 0.38, 0.25], "k_a": 0.1, "k_d": 0.5, "k_s": 0.7, "e": 50, "k_ps": 0.25, "ambient": [0.16, 0.08, 0.05]},
            "marble": {"color": [0.25, 0.42, 0.36], "k_a": 0.1, "k_d": 0.7, "k_s": 0.5, "e": 90, "k_ps": 0.08, "ambient": [0.06, 0.1, 0.09]},
        },
    }
    lens, ring = glass(0.25, 1.72, -2.2)
    elements = [{"id": "floor", "tipo": "disco", "centro": [0, 0, 2], "radio": 11, "vector": [0, 1, 0], "material": "floor"},
                {"id": "marble", **sphere([2.15, 0.5, -3.1], 0.36), "material": "marble"}]
    for name, material, solid in (("melencolia", "stone", melencolia(-2.7, 1.1, 1.3, 0.5)), ("lens", "glass", lens), ("ring", "brass", ring),
                                  ("drilled", "brass", drilled(2.9, 0.6)), ("die", "ivory", die(0.2, -0.1, 0.62)),
                                  ("red-die", "red", die(-2.2, -3.2, 0.4)), ("bowl", "copper", bowl(2.15, -3.1))):
        elements.append({"id": name, **solid, "material": material})
    print(scene_text(stage, elements))


if __name__ == "__main__":
    main()
