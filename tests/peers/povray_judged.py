#!/usr/bin/env python3
"""povray_judged.py DURERO [SEED]: the judge about POV-Ray's tori, quadrics, cubics and quartics, by a Z text.

POV-Ray's trace() is asked for the first points of rays on one object each, and `durero conform judge --with` judges them by
demo/surfaces/algebraic.tex. No answer is gross. POV-Ray solves polynomials in binary64: its quadrics are right, and most of
its tori, which says that the allowance is neither too narrow nor wide: answers that are moved by a few billionths are off,
and misses and crossings behind the first are gross. Exit status 77 (skipped) where POV-Ray is absent (Debian: povray).
"""
import collections
import json
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile

RAYS = 400
ALGEBRAIC = str(pathlib.Path(__file__).resolve().parents[2] / "demo/surfaces/algebraic.tex")
# Each with the least share of its answers that is exact or right; POV-Ray 3.7 has 0.98, 0.92, 1, 0.94 and 0.53.
OBJECTS = [
    ("torus { 1.2, 0.4 }", 0.9),
    ("torus { 1.2, 0.2 sturm rotate <20, 30, 40> }", 0.8),
    ("quadric { <1, 2, 1>, <0, 0.5, 0>, <0.1, 0, 0>, -1 }", 1),
    ("cubic { <5, 0, 0, -5, 0, 0, 0, 0, 0, 2, 5, 0, -5, 0, 0, 0, 5, -5, 0, -1> }", 0.8),
    ("quartic { <1, 0, 0, 0, 2, 0, 0, 2, 0, -3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, -3, 0, 0, 0, 0, 1, 0, -3, 0, 2> }", 0.3)]
GROSS = {"phantom", "missed", "wrong_element", "far_root", "misplaced", "out_of_range", "non_finite"}


def drawn_rays(rng):
    """Rays from around an object towards places near it."""
    rays = []
    for _ in range(RAYS):
        origin = [rng.uniform(-5, 5) for _ in range(3)]
        rays.append((origin, [rng.uniform(-1.6, 1.6) - x for x in origin]))
    return rays


def vector(numbers):
    return "<" + ", ".join(map(repr, numbers)) + ">"


def ask_povray(folder, thing, rays):
    """The first points that trace() gives, with fifteen digits; None where it gives none."""
    text = ["#version 3.7;", "#declare Thing = object { %s };" % thing, '#fopen To "points.txt" write', "#declare N = <0, 0, 0>;"]
    for origin, direction in rays:
        text.append("#declare P = trace(Thing, %s, %s, N);" % (vector(origin), vector(direction)))
        text.append('#write(To, str(vlength(N), 0, 3), " ", str(P.x, 0, 15), " ", str(P.y, 0, 15), " ", str(P.z, 0, 15), "\\n")')
    (folder / "trace.pov").write_text("\n".join(text + ["#fclose To"]) + "\n")
    subprocess.run(["povray", "+Itrace.pov", "+Oout.png", "-D", "+W1", "+H1", "-V"], cwd=folder, check=True, capture_output=True)
    lines = [list(map(float, line.split())) for line in (folder / "points.txt").read_text().splitlines()]
    return [tuple(point) if length > 0 else None for length, *point in lines]


def verdicts(durero, folder, points, element):
    """How many answers have each verdict."""
    lines = []
    for ray, point in enumerate(points):
        hit = {"ray": ray, "outcome": "miss"}
        if point:
            hit.update(outcome="hit", element=element, point=point)
        lines.append(json.dumps(hit) + "\n")
    (folder / "hits.jsonl").write_text("".join(lines))
    ended = subprocess.run([durero, "conform", "judge", "--scene", "scene.json", "--with", ALGEBRAIC, "--rays", "rays.txt", "hits.jsonl",
                            "--profile", "profile.json", "--format", "json"], cwd=folder, capture_output=True, text=True)
    if ended.returncode == 2:
        sys.exit(ended.stderr)
    return collections.Counter(json.loads(line)["verdict"] for line in ended.stdout.splitlines())


def read_scene(durero, folder, thing):
    """The element that the object becomes, with a profile that claims its type, and no hit nearer than 0.0001."""
    (folder / "scene.pov").write_text("#version 3.7;\nobject { %s }\n" % thing)
    subprocess.run([durero, "import", "scene.pov", "--with", ALGEBRAIC, "-o", "scene.json"], cwd=folder, check=True, capture_output=True)
    (element,) = json.loads((folder / "scene.json").read_text())["elementos"]
    profile = {"format": "binary64", "tipos": [], "surfaces": [element["tipo"]], "caps": "open", "measure": "point", "directions": "any",
               "inside": "exit_point", "names_elements": True, "least_t": 1e-4, "greatest_t": 1e7}
    (folder / "profile.json").write_text(json.dumps({"format": "durero-profile", "version": 1, "system": "POV-Ray", "profile": profile}))
    return element["id"]


def share(counted, *names):
    return sum(counted[name] for name in names) / max(1, sum(counted.values()))


def judge(durero, folder, rng, thing, least):
    """What is wrong with the judgements on an object, as a list."""
    element, rays, wrong = read_scene(durero, folder, thing), drawn_rays(rng), []
    (folder / "rays.txt").write_text("".join(" ".join(map(repr, origin + way)) + "\n" for origin, way in rays))
    points = ask_povray(folder, thing, rays)
    counted = verdicts(durero, folder, points, element)
    print(thing, dict(counted))
    if share(counted, "exact", "right") < least or share(counted, *GROSS) > 0:
        wrong.append("POV-Ray's answers: expected no gross one, and a share of %g that is right" % least)
    hits = sum(point is not None for point in points)
    moved = [point and tuple(x + 3e-9 for x in point) for point in points]
    if hits < RAYS / 10 or verdicts(durero, folder, moved, element)["off"] < 0.9 * hits:
        wrong.append("points moved by 3e-9: expected that they are off")
    if verdicts(durero, folder, [None] * RAYS, element)["missed"] < 0.9 * hits:
        wrong.append("nothing but misses: expected that they are gross")
    beyond = [point and tuple(x + 0.01 * v for x, v in zip(point, way)) for point, (_, way) in zip(points, rays)]
    if share(verdicts(durero, folder, beyond, element), *GROSS) * RAYS < 0.9 * hits:
        wrong.append("points behind the first: expected that they are gross")
    return ["%s: %s" % (thing, what) for what in wrong]


def main(durero, seed="1"):
    if not shutil.which("povray"):
        print("POV-Ray is absent")
        return 77
    rng, wrong = random.Random(int(seed)), []
    for thing, least in OBJECTS:
        with tempfile.TemporaryDirectory() as folder:
            wrong += judge(durero, pathlib.Path(folder), rng, thing, least)
    if wrong:
        sys.exit("seed %s\n%s" % (seed, "\n".join(wrong)))
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
