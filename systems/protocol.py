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
    return past(max(element.farthest(p, unit(v)) for element in elements), v)


def past(farthest, v):
    """A power of two f: f v is longer than that distance."""
    return 2.0 ** math.ceil(math.log2(2.0 * farthest / math.hypot(*v)))


def mesh(elements):
    """Their points, each once, and of each triangle the numbers of its three points: one mesh of them all."""
    numbers = {}
    faces = [tuple(numbers.setdefault(vertex, len(numbers)) for vertex in element.vertices) for element in elements]
    return list(numbers), faces


def of_faces(build):
    """load(elements) of a system that has meshes: build(points, faces) answers with the number of a face for its name."""

    def load(elements):
        ask = build(*mesh(elements))
        return lambda *question: named(elements, ask(*question))

    return load


def named(elements, claim):
    if isinstance(claim, list):
        return [named(elements, one) for one in claim]
    if not isinstance(claim, tuple):
        return claim
    return (None if claim[0] is None else elements[claim[0]].name, *claim[1:])


def rays_of_faces(build):
    """load(elements) of such a system that is asked ray by ray: build(points, faces)(p, v) is None or (face, t), see each()."""
    return of_faces(lambda points, faces: each(build(points, faces)))


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


def listed(hits):
    """Those without a number stay in the order in which they are."""
    return " ; ".join(map(shown, sorted(hits, key=lambda hit: 0 if hit[1] is None else hit[1]))) or "miss"


def counting(load_all):
    def load(elements):
        ask = load_all(elements)
        return lambda p, v: len(ask(p, v))

    return load


def parts(line):
    """The points and vectors of a question, and the numbers behind them."""
    n = [float(word) for word in line.split()]
    return [tuple(n[i : i + 3]) for i in (0, 3) if i < len(n)] + n[6:]


def lines_of(load, elements, questions, write):
    """The answers of a system that is asked one question after another."""
    lines = []
    try:
        ask = load(elements)
    except Exception as why:
        return [refusal(why)] * len(questions)
    for question in questions:
        try:
            lines.append(write(ask(*question)))
        except Exception as why:
            lines.append(refusal(why))
    return lines


def lines_of_rays(load, elements, rays):
    try:
        return list(map(shown, load(elements)(rays) if elements else [None] * len(rays)))
    except Exception as why:
        return [refusal(why)] * len(rays)


def serve(system, version, load, load_shadows=None, load_ranges=None, load_all=None, load_count=None,
          load_closest=None, load_casts=None):
    """Answers until the questions end: load(elements) is a function of the rays to their answers, see each().

    Of a system that answers shadow rays, load_shadows(elements)(p, v, end) is whether anything is hit up to the end; of
    one that answers ranges, load_ranges(elements)(p, v, begin, end) is the first hit between the two ends; of one that
    answers all hits and their number, load_all(elements)(p, v) has them, in any order, or load_count(elements)(p, v) is
    their number; of one that answers nearest points, load_closest(elements)(p) is (name, distance, point); of one that
    casts balls, load_casts(elements)(p, v, radius) is the first touch, as each() has it.
    """
    others = {"shadows": (load_shadows, lambda is_hit: "hit" if is_hit else "miss"), "ranges": (load_ranges, shown),
              "crossings": (load_all, listed), "counts": (load_count or counting(load_all), lambda number: f"count {number}"),
              "points": (load_closest, shown), "casts": (load_casts, shown)}
    print("system", system, version, file=answers, flush=True)
    elements = []
    for line in sys.stdin:
        word = line.split(None, 1)[0]
        if word == "scene":
            elements = []
        elif word != "rays" and word not in others:
            elements.append(Element(line))
        else:
            questions = [parts(sys.stdin.readline()) for _ in range(int(line.split()[1]))]
            if word == "rays":
                lines = lines_of_rays(load, elements, questions)
            else:
                lines = lines_of(others[word][0], elements, questions, others[word][1])
            print(*lines, sep="\n", file=answers, flush=True)
