#!/usr/bin/env python3
"""radiance.py DURERO [SEED]: Radiance, which shares no line with this program, meets the surface of the same name at the
same distance on a text of its own that `durero import` has read, and on a scene that `durero export` has written.

The text has each surface, placed by xform, repeated, and boxes by genbox. Radiance prints seven digits, and binary64
without care decides its answers: a ray that it answers otherwise is asked again, moved by a millionth eight ways, and
passes where one of these has its answer. Exit status 77 (skipped) where oconv, rtrace and xform are absent: they are
Radiance's, which also the wheel pyradiance brings.
"""
import json
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile

from povray import scene

RAYS, PARTS = 10000, 12
MOST_BESIDE_EDGES = RAYS // 100
PROGRAMS = ("oconv", "rtrace", "xform", "genbox")


def surfaces(rng, number):
    """The primitives of one file: all types, around the origin, in a cube of side 2."""
    def place():
        return " ".join(f"{rng.uniform(-1, 1):.6f}" for _ in range(3))

    def length():
        return f"{rng.uniform(0.1, 0.4):.6f}"
    a, b, c = place(), place(), place()
    rows = [f"sphere 0 0 4 {place()} {length()}", f"bubble 0 0 4 {place()} {length()}",
            f"cylinder 0 0 7 {place()} {place()} {length()}", f"tube 0 0 7 {place()} {place()} {length()}",
            f"cone 0 0 8 {place()} {place()} {length()} {length()}", f"cup 0 0 8 {place()} {place()} {length()} 0",
            f"ring 0 0 8 {place()} {place()} 0 {length()}", f"polygon 0 0 9 {a} {b} {c}"]
    made = []
    for i, row in enumerate(rows):
        kind, numbers = row.split(" ", 1)
        made.append(f"white {kind} n{number}k{i} {numbers}")
    return "\n".join(made) + "\n"


def text(rng, folder):
    """Writes the files, and returns the text that names them."""
    lines = ["void plastic white 0 0 5 0.5 0.5 0.5 0 0"]
    holed = "0 0 0  4 0 0  4 4 0  0 4 0  0 0 0  1 1 0  1 3 0  3 3 0  3 1 0  1 1 0"
    lines.append(f"white polygon frame 0 0 30 {holed}")
    for number in range(PARTS):
        (folder / f"part{number}.rad").write_text(surfaces(rng, number))
        turns = " ".join(f"-r{axis} {rng.uniform(-180, 180):.4f}" for axis in "xyz")
        way = " ".join(f"{rng.uniform(-4, 4):.4f}" for _ in range(3))
        mirror = rng.choice(["", "-mx", "-my", "-mz"])
        array = rng.choice(["", f"-a 3 -t {rng.uniform(1, 2):.3f} 0.5 0 -i 1", "-i 2 -rz 25 -i 1"])
        lines.append(f"!xform -s {rng.uniform(0.5, 1.5):.4f} {mirror} {turns} {array} -t {way} part{number}.rad")
    lines.append("!genbox white box 1 2 0.5 | xform -rx 30 -t -3 -3 2 -a 2 -t 0 0 1.5")
    return "\n".join(lines) + "\n"


def by_radiance(folder, rays):
    """Of each ray the name of the surface and the distance; None where it meets none."""
    octree = subprocess.run(["oconv", "scene.rad"], cwd=folder, check=True, capture_output=True).stdout
    (folder / "scene.oct").write_bytes(octree)
    said = subprocess.run(["rtrace", "-h", "-w", "-ab", "0", "-oLs", "scene.oct"], cwd=folder, check=True, text=True,
                          input="".join(" ".join(map(repr, ray)) + "\n" for ray in rays), capture_output=True).stdout
    answers = []
    for line in said.splitlines():
        far, name = line.split()
        answers.append(None if name == "*" else (name, float(far)))
    return answers


def by_durero(durero, folder, rays):
    """Of each ray the names of the groups that are met, or else of the elements, and the parameter."""
    (folder / "rays.txt").write_text("".join(" ".join(map(repr, ray)) + "\n" for ray in rays))
    said = subprocess.run([durero, "trace", "scene.json", "rays.txt"], cwd=folder, check=True, text=True, capture_output=True)
    groups = json.loads((folder / "scene.json").read_text()).get("groups", {})
    names = {element: name for name, group in groups.items() for element in group.get("elementos", [])}
    answers = []
    for line in said.stdout.splitlines():
        hit = json.loads(line)
        met = {names.get(element, element) for element in hit.get("elementos", [])}
        answers.append((met, hit["t"]) if hit["outcome"] == "hit" else None)
    return answers


def agree(ours, theirs):
    if ours is None or theirs is None:
        return ours is theirs
    return theirs[0] in ours[0] and abs(ours[1] - theirs[1]) <= 1e-5 * max(1, theirs[1])


def imported(durero, rng, folder):
    """A text that is read, and rays."""
    (folder / "scene.rad").write_text(text(rng, folder))
    subprocess.run([durero, "import", "scene.rad", "-o", "scene.json"], cwd=folder, check=True, capture_output=True)
    return [between(rng, 6, 4, 0) for _ in range(RAYS)]


def exported(durero, rng, folder):
    """A scene that is written, of all that Radiance has, and rays."""
    elements = [element for element in scene(rng) if element["tipo"] != "plano"]
    elements.append({"id": "box", "tipo": "caja", "esquinas": [[0.25, 0.5, 0.25], [0.5, 0.625, 0.75]]})
    (folder / "scene.json").write_text(json.dumps({"format": "durero-scene", "version": 1, "elementos": elements}))
    subprocess.run([durero, "export", "scene.json", "-o", "scene.rad"], cwd=folder, check=True, capture_output=True)
    return [between(rng, 1, 0.5, 0.5) for _ in range(RAYS)]


def between(rng, far, near, middle):
    eye, there = ([middle + rng.uniform(-size, size) for _ in range(3)] for size in (far, near))
    length = sum((b - a) ** 2 for a, b in zip(eye, there)) ** 0.5
    return eye + [(b - a) / length for a, b in zip(eye, there)]


def compare(durero, folder, rng, rays, what):
    """Whether both answer the same but beside edges."""
    theirs, ours = by_radiance(folder, rays), by_durero(durero, folder, rays)
    assert len(theirs) == len(ours) == RAYS
    hits = sum(answer is not None for answer in ours)
    unlike = [i for i in range(RAYS) if not agree(ours[i], theirs[i])]
    shaken = [[x + rng.choice((-1e-6, 1e-6)) for x in rays[i]] for i in unlike for _ in range(8)]
    again = by_durero(durero, folder, shaken) if shaken else []
    wrong = [i for k, i in enumerate(unlike) if not any(agree(answer, theirs[i]) for answer in again[8 * k:8 * k + 8])]
    for i in wrong[:10]:
        print("ray", rays[i], "here", ours[i], "Radiance", theirs[i])
    print(f"radiance, {what}: {RAYS} rays, {hits} hits, {len(unlike)} answered otherwise beside edges, {len(wrong)} elsewhere")
    return not wrong and hits > RAYS // 5 and len(unlike) <= MOST_BESIDE_EDGES


def main():
    durero = str(pathlib.Path(sys.argv[1]).resolve())
    seed = int(sys.argv[2]) if len(sys.argv) > 2 else 1
    missing = [program for program in PROGRAMS if shutil.which(program) is None]
    if missing:
        print(f"skipped: {' and '.join(missing)} of Radiance absent")
        return 77
    rng = random.Random(seed)
    passed = []
    for make in (imported, exported):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            passed.append(compare(durero, folder, rng, make(durero, rng, folder), make.__name__))
    print(f"again by: radiance.py DURERO {seed}")
    return 0 if all(passed) else 1


if __name__ == "__main__":
    sys.exit(main())
