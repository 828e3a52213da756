#!/usr/bin/env python3
"""Writes drawing-machine.json: Dürer's machine of 1525, as it draws a lute.

A weight keeps a thread taut that runs over a pulley on the wall, which is the eye, through a frame to a point of the lute. Two
threads across the frame mark where it passes; the door, which is turned out of the frame, bears what is drawn so far: each of
its points is where the ray from the eye to a point of the lute meets the plane of the frame.
"""
import math

from scene_text import scene_text

MATERIALS = {
    "floor": {"color": [1, 1, 1], "k_a": 0.1, "k_d": 0.8, "ambient": [0.16, 0.15, 0.14],
              "textures": {"color": "tiles", "ambient": "tiles"}},
    "plaster": {"color": [0.86, 0.8, 0.68], "k_a": 0.08, "k_d": 0.8, "ambient": [0.2, 0.19, 0.16]},
    "wood": {"color": [0.52, 0.33, 0.18], "k_a": 0.1, "k_d": 0.8, "k_s": 0.12, "e": 20, "ambient": [0.1, 0.07, 0.045]},
    "pale": {"color": [0.74, 0.56, 0.34], "k_a": 0.1, "k_d": 0.8, "k_s": 0.1, "e": 20, "ambient": [0.15, 0.12, 0.08]},
    "dark": {"color": [0.2, 0.12, 0.07], "k_a": 0.1, "k_d": 0.8, "k_s": 0.25, "e": 40, "ambient": [0.04, 0.03, 0.02]},
    "board": {"color": [0.88, 0.72, 0.44], "k_a": 0.1, "k_d": 0.8, "k_s": 0.1, "e": 30, "ambient": [0.17, 0.14, 0.09]},
    "ribs": {"color": [0.6, 0.32, 0.14], "k_a": 0.1, "k_d": 0.75, "k_s": 0.35, "e": 60, "k_ps": 0.05,
             "ambient": [0.11, 0.07, 0.04]},
    "paper": {"color": [0.94, 0.91, 0.82], "k_a": 0.1, "k_d": 0.8, "ambient": [0.22, 0.21, 0.19]},
    "ink": {"color": [0.05, 0.04, 0.08], "k_d": 0.6},
    "thread": {"color": [0.85, 0.1, 0.05], "k_a": 0.3, "k_d": 0.6, "emission": [0.25, 0.02, 0.01]},
    "cord": {"color": [0.9, 0.87, 0.78], "k_a": 0.2, "k_d": 0.7, "ambient": [0.15, 0.15, 0.13]},
    "lead": {"color": [0.35, 0.36, 0.4], "k_a": 0.1, "k_d": 0.5, "k_s": 0.5, "e": 40, "k_ps": 0.15, "ambient": [0.05, 0.05, 0.06]},
    "brass": {"color": [0.75, 0.55, 0.2], "k_a": 0.1, "k_d": 0.45, "k_s": 0.7, "e": 60, "k_ps": 0.25, "M_PS": [1, 0.85, 0.5],
              "ambient": [0.08, 0.06, 0.02]},
    "sky": {"color": [0, 0, 0], "k_d": 0, "emission": [0.75, 0.85, 1]},
}


def add(a, b):
    return tuple(x + y for x, y in zip(a, b))


def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def times(k, a):
    return tuple(k * x for x in a)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    return times(1 / math.sqrt(dot(a, a)), a)


def plain(a):
    """As a file has it: a hundredth of a millimetre is enough."""
    return [round(x, 5) + 0.0 for x in a]


def seen(a):
    """Of the picture: here x grows towards the eye of the machine, and there to the left."""
    return [-a[0] + 0.0, *a[1:]]


class Scene:
    def __init__(self):
        self.elements, self.count = [], {}

    def put(self, name, tipo, material, **attributes):
        number = self.count[name] = self.count.get(name, 0) + 1
        for key in ("centro", "vector"):
            if key in attributes:
                attributes[key] = seen(attributes[key])
        for key in ("vertices", "normals"):
            if key in attributes:
                a, b, c = (seen(point) for point in attributes[key])
                attributes[key] = [a, c, b]  # a mirror turns round the way that they go
        self.elements.append({"id": f"{name}{number}", "tipo": tipo, **attributes, "material": material})

    def tube(self, name, material, start, end, radius):
        """A cylinder with round ends, from point to point."""
        axis = sub(end, start)
        self.put(name, "cilindro", material, centro=plain(start), radio=radius, vector=list(unit(axis)),
                 altura=round(math.sqrt(dot(axis, axis)), 6))
        for at in (start, end):
            self.put(f"{name}-end", "esfera", material, centro=plain(at), radio=radius)

    def cone(self, name, material, base, apex, radius):
        axis = sub(apex, base)
        height = math.sqrt(dot(axis, axis))
        self.put(name, "cono", material, centro=plain(base), proporcion=radius / height, vector=list(unit(axis)), altura=height)

    def triangle(self, name, material, corners, normals=None):
        rounded = [plain(c) for c in corners]
        if cross(sub(rounded[1], rounded[0]), sub(rounded[2], rounded[0])) == (0, 0, 0):
            return
        more = {"normals": [plain(n) for n in normals]} if normals else {}
        self.put(name, "triangulo", material, vertices=rounded, **more)

    def box(self, name, material, low, high, frame=None):
        """A box between two corners, in the axes of a frame (origin and three unit vectors) where one is given."""
        def at(i):
            point = tuple(high[k] if i >> k & 1 else low[k] for k in range(3))
            if frame is None:
                return point
            origin, axes = frame
            return add(origin, tuple(sum(point[k] * axes[k][j] for k in range(3)) for j in range(3)))
        for a, b, c, d in ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)):
            self.triangle(name, material, (at(a), at(b), at(c)))
            self.triangle(name, material, (at(a), at(c), at(d)))


TABLE = 0.78
EYE = (2.5, 1.62, 0.12)
FRAME = 0.55  # the plane x = FRAME
LOW, HIGH, NEAR, FAR = TABLE + 0.08, TABLE + 0.68, -0.36, 0.36


class Lute:
    """It leans on its ribs, its neck towards the wall at the back, its board turned to the frame."""
    ROWS, COLUMNS = 20, 12
    LENGTH = 0.74

    def __init__(self):
        along, out = unit((-0.5, 0.28, 0.82)), (0.8, 0.6, 0.1)  # from the tail to the neck, and out of the board
        up = unit(sub(out, times(dot(out, along), along)))
        self.axes = (along, up, cross(along, up))
        self.origin = (-0.1, TABLE + 0.225, -0.36)

    def point(self, s, height, across):
        a, u, v = self.axes
        return add(self.origin, add(times(s, a), add(times(height, u), times(across, v))))

    def width(self, s):
        """Half the width of the board at the advance s: a pear."""
        x = s / self.LENGTH
        return 0.0 if x <= 0 else 0.34 * math.sqrt(x) * max(0.0, 1 - x) ** 0.62 * 1.2 + 0.035 * x * x

    def rib(self, row, column):
        """A point of the bowl: columns go round from one edge of the board to the other."""
        s = self.LENGTH * 0.5 * (1 - math.cos(math.pi * row / self.ROWS))
        angle = math.pi * column / self.COLUMNS
        w = self.width(s)
        return self.point(s, -0.72 * w * math.sin(angle), w * math.cos(angle))

    def normal(self, row, column):
        row = min(max(row, 0.5), self.ROWS - 0.5)
        step = 0.02
        along = sub(self.rib(row + step, column), self.rib(row - step, column))
        around = sub(self.rib(row, column + step), self.rib(row, column - step))
        n = cross(along, around)
        return unit(n if dot(n, sub(self.rib(row, column), self.point(self.LENGTH / 2, 0, 0))) > 0 else times(-1, n))

    def outline(self, count):
        """Points along the edge of the board."""
        half = [self.rib(self.ROWS * i / count, 0) for i in range(count + 1)]
        return half + [self.rib(self.ROWS * i / count, self.COLUMNS) for i in reversed(range(count))]

    def build(self, scene):
        for row in range(self.ROWS):
            for column in range(self.COLUMNS):
                places = [(row, column), (row + 1, column), (row + 1, column + 1), (row, column + 1)]
                material = "ribs" if column % 2 else "wood"
                for a, b, c in ((0, 1, 2), (0, 2, 3)):
                    corners = [places[a], places[b], places[c]]
                    scene.triangle("rib", material, [self.rib(*p) for p in corners], [self.normal(*p) for p in corners])
        for row in range(self.ROWS):
            a, b = self.rib(row, 0), self.rib(row + 1, 0)
            c, d = self.rib(row + 1, self.COLUMNS), self.rib(row, self.COLUMNS)
            scene.triangle("board", "board", (a, b, c))
            scene.triangle("board", "board", (a, c, d))
        frame = (self.origin, self.axes)
        scene.put("rose", "disco", "dark", centro=plain(self.point(0.4, 0.002, 0)), radio=0.05, vector=list(self.axes[1]))
        for i in range(3):
            scene.put("rose", "disco", "board" if i % 2 == 0 else "dark", centro=plain(self.point(0.4, 0.003 + 0.001 * i, 0)),
                      radio=0.042 - 0.012 * i, vector=list(self.axes[1]))
        scene.box("bridge", "dark", (0.1, 0, -0.085), (0.115, 0.012, 0.085), frame)
        scene.box("neck", "dark", (0.68, -0.022, -0.032), (1.05, 0.004, 0.032), frame)
        bent = (self.point(1.05, 0.0, 0), (unit(add(times(0.35, self.axes[0]), times(-0.95, self.axes[1]))),
                                          unit(add(times(0.95, self.axes[0]), times(0.35, self.axes[1]))), self.axes[2]))
        scene.box("pegbox", "dark", (0, -0.02, -0.03), (0.2, 0.012, 0.03), bent)
        for i in range(6):
            peg = add(bent[0], times(0.04 + 0.028 * i, bent[1][0]))
            scene.tube("peg", "pale", add(peg, times(-0.06, self.axes[2])), add(peg, times(0.06, self.axes[2])), 0.005)
            across = 0.009 * (i - 2.5)
            scene.tube("string", "cord", self.point(0.107, 0.013, 1.6 * across), self.point(1.05, 0.008, across), 0.0012)


def on_frame(point):
    """Where the ray from the eye to a point meets the plane of the frame."""
    t = (FRAME - EYE[0]) / (point[0] - EYE[0])
    return add(EYE, times(t, sub(point, EYE)))


def on_door(point):
    """Where a point of the frame lies on the door, which is turned out of it by a right angle."""
    return (FRAME + 0.06 + (FAR - point[2]), point[1], FAR + 0.028)


def room(scene):
    scene.put("floor", "plano", "floor", centro=[0, 0, 0], vector=[0, 1, 0])
    scene.put("back", "plano", "plaster", centro=[0, 0, 1.9], vector=[0, 0, -1])
    scene.put("right", "plano", "plaster", centro=[2.62, 0, 0], vector=[-1, 0, 0])
    scene.put("left", "plano", "plaster", centro=[-3.2, 0, 0], vector=[1, 0, 0])
    for i in range(2):
        x = -1.75 + 1.5 * i
        scene.box("pane", "sky", (x, 1.35, 1.87), (x + 0.95, 2.25, 1.89))
        for k in (0, 0.475, 0.95):
            scene.box("bar", "wood", (x + k - 0.025, 1.3, 1.82), (x + k + 0.025, 2.3, 1.86))
        for k in (1.325, 1.8, 2.275):
            scene.box("bar", "wood", (x - 0.05, k - 0.025, 1.82), (x + 1, k + 0.025, 1.86))
    scene.box("skirting", "wood", (-3.2, 0, 1.86), (2.62, 0.12, 1.9))


def table(scene):
    scene.box("top", "wood", (-1.15, TABLE - 0.05, -0.62), (1.35, TABLE, 0.72))
    for x in (-1.05, 1.25):
        for z in (-0.52, 0.62):
            scene.put("leg", "tronco", "wood", centro=[x, 0, z], radio=0.05, proporcion=0.03, vector=[0, 1, 0], altura=TABLE - 0.05)
    scene.box("rail", "wood", (-1.05, 0.14, 0.0), (1.25, 0.2, 0.06))


def frame(scene, through):
    thick = 0.06
    for name, low, high in (("sill", (LOW - thick, NEAR - thick), (LOW, FAR + thick)),
                            ("lintel", (HIGH, NEAR - thick), (HIGH + thick, FAR + thick)),
                            ("post", (LOW, NEAR - thick), (HIGH, NEAR)), ("post", (LOW, FAR), (HIGH, FAR + thick))):
        scene.box(name, "pale", (FRAME - 0.03, low[0], low[1]), (FRAME + 0.03, high[0], high[1]))
    scene.box("foot", "pale", (FRAME - 0.16, TABLE, NEAR - 0.05), (FRAME + 0.16, TABLE + 0.03, NEAR + 0.03))
    scene.box("foot", "pale", (FRAME - 0.16, TABLE, FAR - 0.03), (FRAME + 0.16, TABLE + 0.03, FAR + 0.05))
    _, y, z = through
    scene.tube("across", "cord", (FRAME, y, NEAR - 0.02), (FRAME, y, FAR + 0.02), 0.0035)
    scene.tube("upright", "cord", (FRAME, LOW - 0.02, z), (FRAME, HIGH + 0.02, z), 0.0035)
    scene.box("door", "paper", (FRAME + 0.06, LOW, FAR + 0.03), (FRAME + 0.06 + FAR - NEAR, HIGH, FAR + 0.045))
    for height in (LOW + 0.1, HIGH - 0.1):
        scene.tube("hinge", "brass", (FRAME + 0.045, height - 0.04, FAR + 0.035), (FRAME + 0.045, height + 0.04, FAR + 0.035), 0.014)


def drawing(scene, points):
    for point in points:
        scene.put("dot", "disco", "ink", centro=plain(on_door(on_frame(point))), radio=0.0055, vector=[0, 0, -1])


def thread(scene, point):
    scene.tube("thread", "thread", EYE, point, 0.0045)
    scene.tube("plumb", "thread", EYE, (EYE[0], 0.75, EYE[2]), 0.0045)
    scene.put("weight", "cilindro", "lead", centro=[EYE[0], 0.55, EYE[2]], radio=0.055, vector=[0, 1, 0], altura=0.16)
    for y, d in ((0.55, -1), (0.71, 1)):
        scene.put("weight-end", "disco", "lead", centro=[EYE[0], y, EYE[2]], radio=0.055, vector=[0, d, 0])
    scene.cone("weight-top", "lead", (EYE[0], 0.71, EYE[2]), (EYE[0], 0.76, EYE[2]), 0.03)
    scene.put("nail", "cilindro", "brass", centro=[2.62, EYE[1] + 0.012, EYE[2]], radio=0.012, vector=[-1, 0, 0], altura=0.16)
    scene.put("ring", "esfera", "brass", centro=[EYE[0], EYE[1], EYE[2]], radio=0.03)
    scene.box("plate", "dark", (2.59, EYE[1] - 0.12, EYE[2] - 0.08), (2.62, EYE[1] + 0.12, EYE[2] + 0.08))


def pin(scene, point, board):
    """The pointer that holds the thread to the lute."""
    end = add(point, times(0.33, unit(add(board, (-0.5, 0.35, -0.45)))))
    scene.cone("pin", "brass", end, point, 0.011)
    scene.put("knob", "esfera", "brass", centro=plain(end), radio=0.022)


def more(scene):
    scene.box("book", "ribs", (0.78, TABLE, -0.5), (1.1, TABLE + 0.045, -0.24))
    scene.box("book", "paper", (0.79, TABLE + 0.006, -0.505), (1.09, TABLE + 0.039, -0.25))
    scene.put("ink", "tronco", "lead", centro=[1.2, TABLE, -0.1], radio=0.03, proporcion=0.2, vector=[0, 1, 0], altura=0.07)
    scene.tube("pen", "paper", (1.2, TABLE + 0.03, -0.1), (1.29, TABLE + 0.3, -0.02), 0.005)
    scene.put("seat", "cilindro", "wood", centro=[-1.75, 0.44, 0.25], radio=0.2, vector=[0, 1, 0], altura=0.045)
    for y, d in ((0.44, -1), (0.485, 1)):
        scene.put("seat-end", "disco", "wood", centro=[-1.75, y, 0.25], radio=0.2, vector=[0, d, 0])
    for i in range(3):
        a = 2 * math.pi * i / 3 + 0.8
        scene.tube("stool", "wood", (-1.75 + 0.12 * math.cos(a), 0.44, 0.25 + 0.12 * math.sin(a)),
                   (-1.75 + 0.2 * math.cos(a), 0.02, 0.25 + 0.2 * math.sin(a)), 0.018)


def main():
    scene, lute = Scene(), Lute()
    outline = lute.outline(22)
    met = 30  # the point that the thread has come to
    room(scene)
    table(scene)
    lute.build(scene)
    frame(scene, on_frame(outline[met]))
    drawing(scene, outline[:met])
    drawing(scene, [lute.point(0.4 + 0.05 * math.sin(a), 0, 0.05 * math.cos(a))
                    for a in (2 * math.pi * i / 14 for i in range(14))])
    thread(scene, outline[met])
    pin(scene, outline[met], lute.axes[1])
    more(scene)
    stage = {
        "format": "durero-scene", "version": 1,
        "camera": {"eye": seen([1.95, 1.75, -3.25]), "look_at": seen([0.78, 0.98, 0.1]), "up": [0, 1, 0], "fov_y": 38},
        "resolution": [1280, 800], "max_depth": 4,
        "lights": [
            {"position": seen([-1.6, 2.7, -2.4]), "color": [0.66, 0.63, 0.57], "disc": {"radius": 0.45, "normal": seen([0.5, -0.7, 0.6])}},
            {"position": seen([2.2, 2.9, -2.2]), "color": [0.32, 0.32, 0.34], "disc": {"radius": 0.6, "normal": seen([-0.5, -0.7, 0.6])}}],
        "textures": {"tiles": {"checker": [[0.62, 0.5, 0.4], [0.4, 0.3, 0.24]], "repeat": [2, 2]}},
        "materials": MATERIALS,
    }
    print(scene_text(stage, scene.elements))


if __name__ == "__main__":
    main()
