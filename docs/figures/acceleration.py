"""acceleration.py measure DURERO ACCEL_TESTS SPD | draw | check DURERO

The figures of docs/acceleration-reference.md, of what is counted: the same on every machine.

  measure  counts, by `durero stats --format json --no-times` and a test of the grid, and writes acceleration.json; SPD is
           the folder of the Standard Procedural Databases (balls.nff, …)
  draw     writes the pictures, growth.svg, scenes.svg and grid.svg, from acceleration.json
  check    fails where a picture is not the one that is drawn from acceleration.json, or where the counts of its smallest
           scene are not those that DURERO gives now"""
import json
import pathlib
import random
import subprocess
import sys
import tempfile

from chart import Chart

here = pathlib.Path(__file__).parent
ENGINES = ["volumes", "bvh", "octree", "bsp", "grid", "classification", "fast"]
COLOURS = dict(zip(ENGINES, ["#000000", "#0072b2", "#009e73", "#d55e00", "#cc79a7", "#8a6d00", "#56b4e9"]))
SIZES = [100, 1000, 10_000, 100_000]
DATABASES = ["lattice", "balls", "rings", "jacks", "tree"]


def scene_text(spheres):
    elements = ",\n".join(f'{{"id":"s{i}","tipo":"esfera","centro":[{x!r},{y!r},{z!r}],"radio":{r!r}}}'
                          for i, (x, y, z, r) in enumerate(spheres))
    return f'{{"format":"durero-scene","version":1,"elementos":[\n{elements}]}}\n'


def evenly(count, seed=1):
    """At random in the unit cube, of radius 0.25·count^(−1/3) times a number between ½ and 1."""
    draw = random.Random(seed).random
    return [(draw(), draw(), draw(), 0.25 * count ** (-1 / 3) * (0.5 + draw() / 2)) for _ in range(count)]


def teapot_in_stadium():
    """A thousand small balls in a cube of side 1, in the middle of two hundred large ones around a field of 300 by 200."""
    draw = random.Random(2).random
    seats = []
    for _ in range(200):
        x, y = 2 * draw() - 1, 2 * draw() - 1
        far = max(abs(x), abs(y))
        seats.append((150 * x / far, 100 * y / far, 20 * draw(), 5.0))
    return evenly(1000, 3) + seats


def counts(durero, scene):
    """Of each engine: volumes, cells and elements of all rays together."""
    calls = [word for engine in ENGINES for word in ("--engine", engine)]
    done = subprocess.run([durero, "stats", scene, "--format", "json", "--no-times", *calls], capture_output=True, text=True,
                          check=True)
    said = json.loads(done.stdout)
    kinds = ("rays", "volumes", "cells", "candidates")
    engines = {of["engine"]: {kind: of["work"][kind] for kind in kinds} for of in said["engines"]}
    return {"elements": said["elementos"], "engines": engines}


def counts_of(durero, spheres):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "scene.json"
        path.write_text(scene_text(spheres))
        return counts(durero, path)


def measure(durero, tests, spd):
    found = {"growth": [counts_of(durero, evenly(size)) for size in SIZES], "scenes": {}}
    with tempfile.TemporaryDirectory() as folder:
        for name in DATABASES:
            scene = pathlib.Path(folder) / f"{name}.json"
            subprocess.run([durero, "import", pathlib.Path(spd) / f"{name}.nff", "-o", scene], check=True)
            found["scenes"][name] = counts(durero, scene)
    found["scenes"]["teapot in a stadium"] = counts_of(durero, teapot_in_stadium())
    said = subprocess.run([tests, "the U of the grid for its figure"], capture_output=True, text=True, check=True).stdout
    found["grid"] = [json.loads(line) for line in said.splitlines() if line.startswith("{")]
    (here / "acceleration.json").write_text(json.dumps(found, indent=1) + "\n")


def steps(of):
    """A ray: volumes and planes tested, cells looked through, elements tested."""
    return (of["volumes"] + of["cells"] + of["candidates"]) / of["rays"]


def growth(found):
    chart = Chart("Steps a ray, by the number of elements", "elements", "steps a ray", x=(100, 100_000), y=(1, 100_000))
    for engine in ENGINES:
        points = [(of["elements"], steps(of["engines"][engine])) for of in found["growth"] if engine in of["engines"]]
        chart.line(points, COLOURS[engine], engine)
    return chart.text()


def scenes(found):
    chart = Chart("Steps a ray, by scene", "steps a ray", "", x=(10, 10_000), rows=list(found["scenes"]))
    for row, of in found["scenes"].items():
        best = min((engine for engine in ENGINES), key=lambda engine: steps(of["engines"][engine]))
        chart.row(row, [(steps(of["engines"][engine]), COLOURS[engine]) for engine in ENGINES],
                  f"least: {best}, {steps(of['engines'][best]):.0f}")
    chart.legend([(engine, COLOURS[engine]) for engine in ENGINES])
    return chart.text()


def grid(found):
    chart = Chart("The grid's U: 10⁴ balls, by the number of cubes an element", "cubes an element", "a ray",
                  x=(1 / 16, 1024), y=(1, 1000))
    for key, colour, name in [("crossed", COLOURS["grid"], "cubes crossed"), ("tested", COLOURS["bvh"], "elements tested")]:
        chart.line([(of["cells_per_element"], of[key] / of["rays"]) for of in found["grid"]], colour, name)
    both = [(of["cells_per_element"], (of["crossed"] + of["tested"]) / of["rays"]) for of in found["grid"]]
    chart.line(both, "#000000", "both", width=3)
    chart.mark(8, "default")
    return chart.text()


def pictures():
    found = json.loads((here / "acceleration.json").read_text())
    return {"growth.svg": growth(found), "scenes.svg": scenes(found), "grid.svg": grid(found)}


def draw():
    for name, text in pictures().items():
        (here / name).write_text(text)


def check(durero):
    for name, text in pictures().items():
        if (here / name).read_text() != text:
            sys.exit(f"docs/figures/{name} is not what acceleration.py draws; expected it drawn anew")
    smallest = json.loads((here / "acceleration.json").read_text())["growth"][0]
    now = counts_of(durero, evenly(SIZES[0]))
    if now != smallest:
        sys.exit(f"docs/figures/acceleration.json has other counts than durero now; expected it measured anew:\n"
                 f"{json.dumps(smallest)}\n{json.dumps(now)}")
    print(f"{len(pictures())} pictures and the counts of {len(now['engines'])} engines are as they should be")


if __name__ == "__main__":
    {"measure": measure, "draw": draw, "check": check}[sys.argv[1]](*sys.argv[2:])
