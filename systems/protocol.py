"""The question protocol, for systems that are asked from Python: an adapter says how its system is asked, no more.

Import it before the system: it keeps standard output for the answers, and what the system prints goes to standard
error.
"""

import math
import os
import sys

answers = os.fdopen(os.dup(1), "w")
os.dup2(2, 1)


BODIES = ("caja", "capsula", "elipsoide", "copia_caja", "copia_esfera")


class Element:
    """An element of the scene, by the names of its type's attributes; of a body, by its sides."""

    def __init__(self, line):
        self.tipo, self.name, *numbers = line.split()
        numbers = [float(number) for number in numbers]
        if self.tipo == "triangulo":
            self.vertices = [tuple(numbers[i : i + 3]) for i in (0, 3, 6)]
            return
        self.centro = tuple(numbers[:3])
        if self.tipo in BODIES:
            self.sides = [tuple(numbers[i : i + 3]) for i in (3, 6, 9)]
            return
        if self.tipo == "esfera":
            self.radio = numbers[3]
            return
        self.vector = tuple(numbers[3:6])
        sizes = {"cilindro": "radio altura", "cono": "proporcion altura", "tronco": "radio proporcion altura",
                 "plano": "", "disco": "radio"}[self.tipo].split()
        for size, number in zip(sizes, numbers[6:], strict=True):
            setattr(self, size, number)

    def along(self, advance):
        """The point of the axis at that advance from the centre."""
        return tuple(c + advance * d for c, d in zip(self.centro, self.vector))

    def radii(self):
        """The radii at the centre and at the other end of the axis."""
        top = 0.0 if self.tipo == "cono" else self.radio
        return top + (0.0 if self.tipo == "cilindro" else self.proporcion * self.altura), top

    def rotation(self):
        """The rows of a rotation that takes the z axis to the element's, and is the identity where they are one."""
        x, y, z = self.vector
        sign = math.copysign(1.0, z)
        a = -1.0 / (sign + z)
        return ((1.0 + sign * x * x * a, x * y * a, x),
                (sign * x * y * a, sign + y * y * a, y),
                (-sign * x, -y, z))

    def quaternion(self):
        """x, y, z and w of the least rotation that takes the z axis to the element's."""
        x, y, z = self.vector
        w = 1.0 + z if z > 0.0 else (x * x + y * y) / (1.0 - z)
        if w == 0.0:
            return 1.0, 0.0, 0.0, 0.0
        length = math.hypot(x, y, w)
        return -y / length, x / length, 0.0, w / length

    def half(self):
        """The lengths of a body's sides."""
        return [math.hypot(*side) for side in self.sides]

    def turn(self, order=(0, 1, 2)):
        """x, y, z and w of the rotation that takes the axes of coordinates to the directions of those sides, which are
        at right angles and right-handed in that order."""
        x, y, z = ([c / math.hypot(*self.sides[i]) for c in self.sides[i]] for i in order)
        four = [1 + x[0] - y[1] - z[2], 1 - x[0] + y[1] - z[2], 1 - x[0] - y[1] + z[2], 1 + x[0] + y[1] + z[2]]
        rows = [[four[0], x[1] + y[0], z[0] + x[2], y[2] - z[1]],
                [x[1] + y[0], four[1], y[2] + z[1], z[0] - x[2]],
                [z[0] + x[2], y[2] + z[1], four[2], x[1] - y[0]],
                [y[2] - z[1], z[0] - x[2], x[1] - y[0], four[3]]]
        q = rows[four.index(max(four))]
        length = math.hypot(*q)
        return tuple(part / length for part in q)

    def farthest(self, p, u):
        """How far from p the last of its points can be that a ray along the unit vector u meets."""
        if self.tipo == "triangulo":
            return max(math.dist(p, vertex) for vertex in self.vertices)
        reach = math.dist(p, self.centro)
        if self.tipo in BODIES:
            return reach + sum(self.half())
        if self.tipo == "plano":
            slope = abs(sum(a * b for a, b in zip(u, self.vector)))
            return reach / slope if slope else 0.0
        if self.tipo in ("esfera", "disco"):
            return reach + self.radio
        return reach + max(self.radii()) + self.altura


def unit(v):
    """The unit vector of v's direction, whatever the magnitude of v."""
    _, exponent = math.frexp(max(abs(x) for x in v))
    v = [math.ldexp(x, -exponent) for x in v]
    length = math.hypot(*v)
    return tuple(x / length for x in v)


def segment(elements, p, v):
    """A power of two f for systems that ask of segments: none of the elements is beyond p + f v."""
    farthest = max(element.farthest(p, unit(v)) for element in elements)
    return 2.0 ** math.ceil(math.log2(2.0 * farthest / math.hypot(*v)))


def refusal(why):
    return "refused " + " ".join(f"{type(why).__name__} {why}".split())[:200]


def each(first):
    """Asks ray by ray: first(p, v) is None for a miss, (name, t) or (name, t, point).

    What it says besides may stand last, as {"normal": (x, y, z), "front": True, "uv": (u, v)} or some of it.
    """

    def ask(rays):
        claims = []
        for p, v in rays:
            try:
                claims.append(first(p, v))
            except Exception as why:
                claims.append(refusal(why))
        return claims

    return ask


def nearest(hits):
    """The hit of least t; None of none. For systems that answer of one element at a time."""
    return min(hits, key=lambda hit: hit[1], default=None)


def shown(claim):
    if claim is None:
        return "miss"
    if isinstance(claim, str):
        return claim
    name, t, *rest = claim
    besides = rest.pop() if rest and isinstance(rest[-1], dict) else {}
    numbers = [t, *(rest[0] if rest else ())]
    words = ["hit", name or "-", *("-" if x is None else repr(float(x)) for x in numbers)]
    if "normal" in besides:
        words += ["normal", *(repr(float(x)) for x in besides["normal"])]
    if "front" in besides:
        words += ["front" if besides["front"] else "back"]
    if "uv" in besides:
        words += ["uv", *(repr(float(x)) for x in besides["uv"])]
    return " ".join(words)


def shadow_lines(load_shadows, elements, rays):
    try:
        is_hit = load_shadows(elements)
        return ["hit" if is_hit(tuple(n[:3]), tuple(n[3:6]), n[6]) else "miss" for n in rays]
    except Exception as why:
        return [refusal(why)] * len(rays)


def range_lines(load_ranges, elements, rays):
    try:
        first = load_ranges(elements)
        return [shown(first(tuple(n[:3]), tuple(n[3:6]), n[6], n[7])) for n in rays]
    except Exception as why:
        return [refusal(why)] * len(rays)


def all_lines(load_all, elements, rays, is_count):
    try:
        hits_of = load_all(elements)
        lines = []
        for n in rays:
            hits = sorted(hits_of(tuple(n[:3]), tuple(n[3:6])), key=lambda hit: hit[1])
            lines.append(f"count {len(hits)}" if is_count else " ; ".join(map(shown, hits)) or "miss")
        return lines
    except Exception as why:
        return [refusal(why)] * len(rays)


def serve(system, version, load, load_shadows=None, load_ranges=None, load_all=None):
    """Answers until the questions end: load(elements) is a function of the rays to their answers, see each().

    Of a system that answers shadow rays, load_shadows(elements)(p, v, end) is whether anything is hit up to the end; of
    one that answers ranges, load_ranges(elements)(p, v, begin, end) is the first hit between the two ends; of one that
    answers all hits and their number, load_all(elements)(p, v) has them, in any order.
    """
    print("system", system, version, file=answers, flush=True)
    elements = []
    for line in sys.stdin:
        word = line.split(None, 1)[0]
        if word == "scene":
            elements = []
        elif word in ("shadows", "ranges", "crossings", "counts"):
            rays = [[float(number) for number in sys.stdin.readline().split()] for _ in range(int(line.split()[1]))]
            if word == "shadows":
                lines = shadow_lines(load_shadows, elements, rays)
            elif word == "ranges":
                lines = range_lines(load_ranges, elements, rays)
            else:
                lines = all_lines(load_all, elements, rays, word == "counts")
            print(*lines, sep="\n", file=answers, flush=True)
        elif word != "rays":
            elements.append(Element(line))
        else:
            rays = []
            for _ in range(int(line.split()[1])):
                numbers = [float(number) for number in sys.stdin.readline().split()]
                rays.append((tuple(numbers[:3]), tuple(numbers[3:])))
            try:
                claims = load(elements)(rays) if elements else [None] * len(rays)
            except Exception as why:
                claims = [refusal(why)] * len(rays)
            print(*map(shown, claims), sep="\n", file=answers, flush=True)
