#!/usr/bin/env python3
"""povray_trace.py DURERO [SEED]: POV-Ray's own trace() meets the objects of random texts where `durero import` has put
them.

Each text has spheres, boxes, cylinders, cones, discs, planes, triangles, meshes, polygons, prisms and bicubic patches, tori, quadrics and
quartics, lathes, sors, superellipsoids, blobs, isosurfaces, discs with holes and clipped things (by demo/surfaces/algebraic.tex), solids of the first by union, merge,
intersection and difference, all moved by transformations of every kind, made by macros and loops, and placed along splines. trace() is asked for the first points of 10,000 rays. It prints twelve digits, takes no point nearer
than its own tolerance, which is 0.0001 of a polynomial and 0.01 of a blob, and rounds: a ray that it answers otherwise is asked again, moved by a millionth eight ways, and
passes where one of these has its answer. Exit status 77 (skipped) where POV-Ray is absent (Debian: povray).
"""
import json
import math
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile

TEXTS, RAYS, OBJECTS = 5, 2000, 14
ALGEBRAIC = str(pathlib.Path(__file__).resolve().parents[2] / "demo/surfaces/algebraic.tex")
CLOSE = 2e-6  # of POV-Ray's points, whose smallest tolerance is a millionth
NEAR = 4e-2  # of an origin, and passed over by POV-Ray: 0.01 of a blob, in its own space
MOST_BESIDE_EDGES = TEXTS * RAYS // 100

MACROS = """
#declare Way = spline { natural_spline 0, <-4, 0, 2> 1, <0, 3, -2> 2.5, <3, -1, 1> 4, <5, 2, 4> }
#macro Row(Count, Step)
  union { #for (I, 1, Count) sphere { I * Step, 0.2 + mod(I, 3) / 8 } #end }
#end
#macro Beads(Count)
  union { #local I = 0; #while (I < Count) sphere { Way(4 * I / Count), 0.3 } #local I = I + 1; #end }
#end
"""


class Text:
    """Objects drawn at random, in POV-Ray's words."""

    def __init__(self, rng):
        self.rng = rng

    def number(self, least, most):
        return f"{self.rng.uniform(least, most):.4f}"

    def point(self, size=2.0):
        return "<" + ", ".join(self.number(-size, size) for _ in range(3)) + ">"

    def corners(self):
        """The corners of a star about a point of the plane, which touches itself nowhere."""
        count = self.rng.randint(3, 7)
        x, z = self.rng.uniform(-1, 1), self.rng.uniform(-1, 1)
        all_of_them = []
        for i in range(count):
            angle, radius = 2 * math.pi * (i + self.rng.uniform(0, 0.6)) / count, self.rng.uniform(0.5, 1.5)
            all_of_them.append(f"<{x + radius * math.cos(angle):.4f}, {z + radius * math.sin(angle):.4f}>")
        return all_of_them

    def solid(self):
        """A shape that bounds a part of space."""
        kind = self.rng.choice(["sphere", "box", "cylinder", "cone"])
        if kind == "sphere":
            return f"sphere {{ {self.point()}, {self.number(0.4, 1.5)} }}"
        if kind == "box":
            return f"box {{ {self.point()}, {self.point()} }}"
        if kind == "cylinder":
            return f"cylinder {{ {self.point()}, {self.point()}, {self.number(0.2, 1)} }}"
        return f"cone {{ {self.point()}, {self.number(0.5, 1.2)}, {self.point()}, {self.rng.choice(['0', '0.2', '0.75'])} }}"

    def algebraic(self):
        """The zeros of a polynomial."""
        kind = self.rng.randint(0, 2)
        if kind == 0:
            return f"torus {{ {self.number(0.6, 1.5)}, {self.number(0.1, 0.8)} sturm }}"
        if kind == 1:
            return f"quadric {{ {self.point(1)}, {self.point(0.5)}, {self.point(0.5)}, {self.number(-1, -0.2)} }}"
        coefficients = [self.number(-0.1, 0.1) for _ in range(35)]
        for place in 0, 20, 30:  # of the fourth powers, so that it has an end
            coefficients[place] = self.number(0.5, 2)
        coefficients[34] = self.number(-2, -0.5)
        return self.rng.choice([f"quartic {{ <{', '.join(coefficients)}> sturm }}",
                                f"poly {{ 4, <{', '.join(coefficients)}> sturm }}",
                                f"cubic {{ <{', '.join(coefficients[:20])}> sturm }}"])

    def clipped(self):
        """A thing of which others leave a part."""
        kind = self.rng.choice(["plane", "sphere", "box", "cylinder", "two", "solid"])
        move = self.move() if self.rng.random() < 0.5 else ""
        inverse = self.rng.choice(["", "inverse"])
        by = {"plane": lambda: f"plane {{ {self.point()}, {self.number(-0.5, 0.5)} {inverse} {move} }}",
              "sphere": lambda: f"sphere {{ {self.point(1)}, {self.number(0.8, 2)} {inverse} {move} }}",
              "box": lambda: f"box {{ {self.point()}, {self.point()} {inverse} {move} }}",
              "cylinder": lambda: f"cylinder {{ {self.point()}, {self.point()}, {self.number(0.5, 1.5)} {inverse} {move} }}",
              "two": lambda: f"plane {{ {self.point()}, 0.5 }} cone {{ {self.point()}, 1.5, {self.point()}, 0.25 {move} }}",
              "solid": lambda: f"intersection {{ plane {{ {self.point()}, 1 }} sphere {{ {self.point(0.5)}, 2 }} {move} }}"}[kind]()
        thing = self.algebraic() if self.rng.random() < 0.3 else self.solid()
        return f"object {{ {thing} {self.move()} clipped_by {{ {by} }} }}"

    def turned(self):
        """A line turned about an axis."""
        count = self.rng.randint(4, 7)
        word, kind = self.rng.choice([("lathe", "linear_spline "), ("lathe", "quadratic_spline "), ("lathe", "cubic_spline "),
                                      ("lathe", "bezier_spline "), ("sor", "")])
        if kind == "bezier_spline ":
            count = self.rng.choice([4, 8])
        points = ", ".join(f"<{self.number(0.2, 1.5)}, {3 * i / count - 1.5:.4f}>" for i in range(count))
        return f"{word} {{ {kind}{count}, {points} {self.rng.choice(['', 'open']) if word == 'sor' else ''} sturm }}"

    def swept(self):
        """An open prism of curves."""
        corners = self.corners()
        sweep, low, high = self.rng.choice([("linear_sweep", -1, 1), ("conic_sweep", 0.25, 1.5)])
        kind, points = self.rng.choice([("quadratic_spline", corners[-1:] + corners + corners[:1]),
                                        ("cubic_spline", corners[-1:] + corners + corners[:2])])
        return f"prism {{ {sweep} {kind} {low}, {high}, {len(points)}, {', '.join(points)} open sturm }}"

    def shape(self):
        """Any shape."""
        kind = self.rng.randint(0, 19)
        if kind == 19:
            return self.swept()
        if kind == 18:
            points = " ".join(f"<{u - 1.5 + self.rng.uniform(-0.3, 0.3):.4f}, {self.number(-1, 1)}, {v - 1.5 + self.rng.uniform(-0.3, 0.3):.4f}>"
                              for u in range(4) for v in range(4))
            return (f"bicubic_patch {{ type {self.rng.choice('01')} flatness {self.rng.choice(['0', '0.1', '0.3'])} "
                    f"u_steps {self.rng.randint(0, 3)} v_steps {self.rng.randint(0, 3)} {points} }}")
        if kind == 17:
            function = self.rng.choice(["x*x*y - z*z/2 + 0.25*x", "x*y*z - 0.1", "pow(x,4) + pow(y,4) + pow(z,4) - x*x - z*z + 0.2"])
            by = self.rng.choice(["box { -1.2, <1, 1.3, 1.1> }", "sphere { 0.1, 1.3 }"])
            return (f"isosurface {{ function {{ {function} }} contained_by {{ {by} }} max_gradient 40 accuracy 0.0000001 "
                    f"{self.rng.choice(['', 'open'])} }}")
        if kind == 14:
            return self.turned()
        if kind == 15:
            exponents = self.rng.choice(["0.5, 0.25", "1, 0.5", "1, 2", "2, 2", "0.2, 0.2", "2, 1", "0.5, 1"])
            return f"superellipsoid {{ <{exponents}> }}"
        if kind == 16:
            parts = " ".join(f"sphere {{ {self.point(1)}, {self.number(1, 2)}, {self.number(0.7, 1.5)} }}" for _ in range(3))
            return f"blob {{ threshold 0.6 {parts} cylinder {{ {self.point(1)}, {self.point(1)}, 1, -0.5 }} sturm }}"
        if kind == 12:
            return self.clipped()
        if kind == 13:
            return f"disc {{ {self.point()}, {self.point()}, {self.number(1, 2)}, {self.number(0.2, 0.9)} }}"
        if kind <= 2:
            return self.solid()
        if kind in (10, 11):
            return self.algebraic()
        if kind == 3:
            return f"cylinder {{ {self.point()}, {self.point()}, {self.number(0.2, 1)} open }}"
        if kind == 4:
            return f"disc {{ {self.point()}, {self.point()}, {self.number(0.5, 2)} }}"
        if kind == 5:
            return f"triangle {{ {self.point()}, {self.point()}, {self.point()} }}"
        if kind == 6:
            corners = self.corners()
            return f"polygon {{ {len(corners) + 1}, {', '.join(corners + corners[:1])} }}"
        if kind == 7:
            corners = self.corners()
            sweep, low, high = self.rng.choice([("linear_sweep", -1, 1), ("conic_sweep", 0.25, 1.5), ("linear_sweep", 1, -0.5)])
            is_open = " open" if self.rng.random() < 0.3 else ""
            return f"prism {{ {sweep} linear_spline {low}, {high}, {len(corners) + 1}, {', '.join(corners + corners[:1])}{is_open} }}"
        if kind == 8:
            vertices = ", ".join(self.point() for _ in range(5))
            return f"mesh2 {{ vertex_vectors {{ 5, {vertices} }} face_indices {{ 3, <0, 1, 2>, <1, 2, 3>, <2, 3, 4> }} }}"
        return self.rng.choice([f"Row({self.rng.randint(1, 5)}, {self.point(1)})", f"Beads({self.rng.randint(2, 6)})"])

    def move(self):
        kind = self.rng.randint(0, 4)
        if kind == 0:
            return f"rotate {self.point(180)}"
        if kind == 1:
            return f"translate {self.point(3)}"
        if kind == 2:
            return f"scale {self.number(0.4, 1.6)}"
        if kind == 3:
            return f"scale <{self.number(0.4, 1.6)}, {self.number(-1.6, -0.4)}, {self.number(0.4, 1.6)}>"
        rows = [[1.0 if i == k else self.rng.uniform(-0.4, 0.4) for k in range(3)] for i in range(3)]
        rows.append([self.rng.uniform(-2, 2) for _ in range(3)])
        return "matrix <" + ", ".join(f"{x:.4f}" for row in rows for x in row) + ">"

    def object(self):
        kind = self.rng.random()
        moves = " ".join(self.move() for _ in range(self.rng.randint(0, 3)))
        if kind < 0.6:
            return f"object {{ {self.shape()} {moves} }}"
        word = self.rng.choice(["union", "merge", "intersection", "difference"])
        parts = " ".join(f"object {{ {self.solid()} {self.move()} }}" for _ in range(2))
        return f"{word} {{ {parts} {moves} }}"

    def objects(self):
        made = [self.object() for _ in range(OBJECTS)]
        return "\n".join(made + [f"plane {{ {self.point()}, {self.number(-9, -6)} }}"])


def rays(rng):
    all_of_them = []
    for _ in range(RAYS):
        origin = [rng.uniform(-6, 6) for _ in range(3)]
        towards = [rng.uniform(-3, 3) for _ in range(3)]
        all_of_them.append(origin + [a - b for a, b in zip(towards, origin)])
    return all_of_them


def by_povray(folder, asked):
    """The first point of each ray, or None."""
    lines = ["#version 3.7;", '#include "scene.inc"', "#declare N = <0, 0, 0>;"]
    for ray in asked:
        numbers = [f"{x:.17g}" for x in ray]
        lines.append(f"#declare H = trace(All, <{', '.join(numbers[:3])}>, <{', '.join(numbers[3:])}>, N); "
                     '#debug concat("#", #if (vlength(N) = 0) "miss" #else vstr(3, H, " ", 0, 12) #end, "\\n")')
    (folder / "ask.pov").write_text("\n".join(lines) + "\nsphere { 0, 1 }\n")
    done = subprocess.run(["povray", "+Iask.pov", "-D", "-F", "+W4", "+H4"], cwd=folder, capture_output=True, text=True)
    answers = re.findall(r"^#(.*)$", done.stderr, re.M)
    if len(answers) != len(asked):
        sys.exit(f"POV-Ray answers {len(answers)} of {len(asked)} rays:\n{done.stderr[-2000:]}")
    return [None if answer == "miss" else [float(x) for x in answer.split()] for answer in answers]


def by_durero(durero, folder, asked):
    (folder / "rays.txt").write_text("".join(" ".join(f"{x:.17g}" for x in ray) + "\n" for ray in asked))
    done = subprocess.run([durero, "trace", "scene.json", "rays.txt", "--with", ALGEBRAIC], cwd=folder, capture_output=True, text=True, check=True)
    return [answer.get("point") for answer in map(json.loads, done.stdout.splitlines())]


def agree(one, other, close=CLOSE):
    if one is None or other is None:
        return one is other
    return max(abs(a - b) for a, b in zip(one, other)) <= close * max(1, *map(abs, one))


def moved(rng, ray):
    return [x + rng.uniform(-1e-6, 1e-6) for x in ray]


def main(durero, seed="1"):
    if shutil.which("povray") is None:
        print("absent: povray")
        return 77
    rng, beside, hits = random.Random(int(seed)), 0, 0
    for number in range(TEXTS):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            objects = Text(rng).objects()
            (folder / "scene.inc").write_text(MACROS + "#declare All = union {\n" + objects + "\n}\n")
            (folder / "scene.pov").write_text("#version 3.7;\n" + MACROS + objects + "\n")
            imported = subprocess.run([durero, "import", "scene.pov", "-o", "scene.json", "--with", ALGEBRAIC], cwd=folder, capture_output=True, text=True)
            if imported.returncode != 0:
                sys.exit(f"seed {seed}, text {number}: {imported.stderr}")
            left_out = [line for line in imported.stderr.splitlines() if "left out" in line and not re.search("nothing is in it|attributes? left out", line)]
            if left_out:
                sys.exit(f"seed {seed}, text {number}: {left_out}")
            asked = rays(rng)
            theirs, ours = by_povray(folder, asked), by_durero(durero, folder, asked)
            hits += sum(point is not None for point in ours)
            for ray, their, our in zip(asked, theirs, ours):
                if agree(their, our):
                    continue
                beside += 1
                if our is not None and math.dist(our, ray[:3]) < NEAR:
                    continue
                again = [moved(rng, ray) for _ in range(8)]
                if not any(agree(their, other, 1e-4) for other in by_durero(durero, folder, again)):
                    sys.exit(f"seed {seed}, text {number}, ray {ray}: POV-Ray {their}, durero {our}\n{objects}")
    print(f"{TEXTS} texts, {TEXTS * RAYS} rays, {hits} hits: POV-Ray's, {beside} of them beside edges")
    if beside > MOST_BESIDE_EDGES or hits < TEXTS * RAYS // 2:
        sys.exit(f"expected at most {MOST_BESIDE_EDGES} beside edges, and hits of half of the rays")
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
