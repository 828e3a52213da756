#!/usr/bin/env python3
"""mitsuba_scenes.py DURERO [SCENE.xml ...]: what `durero import` reads of a scene of Mitsuba is what Mitsuba sees in it, and
what `durero export` writes of a scene, too.

Rays through the scene's box meet something in both or in neither, at the same parameter to a thousandth, which is of Mitsuba's
numbers of 24 bits; the pixels of the camera have the same rays. Rays along outlines may differ: 3 of 1000. Where import names
shapes that it leaves out, what it keeps is met, or something before it. Without a scene it is one of its own, with each construct. Exit status 77 (skipped) where Mitsuba is absent (pip: mitsuba).
"""
import json
import math
import pathlib
import random
import re
import subprocess
import sys
import tempfile

try:
    import mitsuba
except ImportError:
    print("no Mitsuba here: skipped")
    sys.exit(77)

from povray import scene as random_elements

RAYS, SEED, OUTLINES, RELATIVE = 10000, 1, 0.003, 1e-3
OWN = """<scene version="3.0.0">
<default name="wide" value="0.4"/>
<integrator type="path"/>
<sensor type="perspective"><float name="fov" value="50"/><string name="fov_axis" value="x"/>
  <transform name="to_world"><lookat origin="3, 2, 6" target="0, 0.2, 0" up="0, 1, 0"/></transform>
  <film type="hdrfilm"><integer name="width" value="80"/><integer name="height" value="45"/></film></sensor>
<bsdf type="diffuse" id="grey"><rgb name="reflectance" value="0.5"/></bsdf>
<shape type="sphere"><point name="center" x="0.5" y="0.25" z="-0.5"/><float name="radius" value="$wide"/>
  <transform name="to_world"><rotate y="1" angle="40"/><scale value="1.5"/><translate x="-1" z="0.25"/></transform><ref id="grey"/></shape>
<shape type="cylinder"><point name="p0" x="0" y="-1" z="0"/><point name="p1" x="0.2" y="1" z="0.1"/><float name="radius" value="0.3"/>
  <transform name="to_world"><rotate x="0.6" z="0.8" angle="-25"/><translate x="1.5"/></transform></shape>
<shape type="disk"><transform name="to_world"><scale value="0.7"/><rotate x="1" angle="100"/><translate x="0.5" y="1.2"/></transform></shape>
<shape type="rectangle"><transform name="to_world"><scale x="2.5" y="2"/><rotate x="1" angle="-90"/><translate y="-1.2"/></transform></shape>
<shape type="cube"><transform name="to_world">
  <matrix value="0.3 0 0.1 -1.5  0 0.5 0 0.75  -0.2 0 0.4 0.5  0 0 0 1"/></transform></shape>
<shape type="shapegroup" id="pair"><shape type="sphere"><float name="radius" value="0.25"/></shape>
  <shape type="obj"><string name="filename" value="tetrahedron.obj"/></shape></shape>
<shape type="instance"><ref id="pair"/><transform name="to_world"><scale x="2" y="0.5" z="1"/><translate z="1.5"/></transform></shape>
<shape type="instance"><ref id="pair"/><transform name="to_world"><rotate z="1" angle="30"/><translate x="-1" z="1.5"/></transform></shape>
</scene>
"""
TETRAHEDRON = "v 0.4 0.4 0.4\nv 1 0.4 0.4\nv 0.4 1 0.4\nv 0.4 0.4 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"


def rays_of(box, rng):
    """From a sphere about a box to points of it."""
    low, high = list(box.min), list(box.max)
    middle = [(a + b) / 2 for a, b in zip(low, high)]
    radius = math.dist(low, high)
    for _ in range(RAYS):
        way = [rng.gauss(0, 1) for _ in range(3)]
        p = [m + radius * w / math.hypot(*way) for m, w in zip(middle, way)]
        q = [rng.uniform(a, b) for a, b in zip(low, high)]
        yield [float(x) for x in p], [(b - a) / math.dist(p, q) for a, b in zip(p, q)]


def camera_differs(sensor, stage):
    """By how much the directions of pixels differ, at most."""
    camera = stage["camera"]
    width, height = stage["resolution"] if isinstance(stage["resolution"], list) else stage["resolution"].values()
    unit = lambda v: [x / math.hypot(*v) for x in v]  # noqa: E731
    cross = lambda a, b: [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]  # noqa: E731
    ahead = unit([b - a for a, b in zip(camera["eye"], camera["look_at"])])
    right = unit(cross(ahead, camera["up"]))
    up = cross(right, ahead)
    side = math.tan(math.radians(camera["fov_y"]) / 2)
    hand = -1 if camera.get("mirrored") else 1
    worst = 0
    for u, v in ((0.5, 0.5), (0.125, 0.25), (0.9, 0.1), (0.3, 0.95)):
        ray = sensor.sample_ray(0, 0, [u, v], [0.5, 0.5])[0]
        own = unit([a + side * ((1 - 2 * v) * b + hand * (2 * u - 1) * width / height * c) for a, b, c in zip(ahead, up, right)])
        worst = max(worst, math.dist(own, [float(x) for x in ray.d]))
    return worst


def is_other(own, theirs, is_whole):
    """Whether a hit of Mitsuba, or none, is not that of the imported scene."""
    if own is None or theirs is None:
        return own is not None or (is_whole and theirs is not None)
    bound = RELATIVE * max(1, own)
    return theirs - own > bound or (is_whole and own - theirs > bound)


def compare(durero, path, folder):
    """Prints how the two see a scene; whether they agree, or None where Mitsuba reads nothing of it."""
    out = folder / "scene.json"
    read = subprocess.run([durero, "import", str(path), "-o", str(out)], capture_output=True, text=True)
    if read.returncode != 0:
        print(f"{path}: not read: {read.stderr.strip()}")
        return False
    try:
        scene = mitsuba.load_file(str(path))
    except Exception as error:  # of whatever class: a plug-in or a file is missing
        print(f"{path}: Mitsuba reads it not: {str(error).splitlines()[0]}")
        return None
    if not scene.bbox().valid():
        return None
    is_whole = not re.search(r"^\S+ \S+ \d+ shapes? .*left out", read.stderr, re.M)
    return judge(durero, path, out, scene, is_whole)


def judge(durero, path, out, scene, is_whole):
    """Whether a scene of a file is Mitsuba's."""
    rays = list(rays_of(scene.bbox(), random.Random(SEED)))
    text = "".join(" ".join(map(repr, p + v)) + "\n" for p, v in rays)
    hits = subprocess.run([durero, "trace", str(out), "-", "--quiet"], input=text, capture_output=True, text=True, check=True)
    differ = found = 0
    for (p, v), line in zip(rays, hits.stdout.splitlines(), strict=True):
        own = json.loads(line).get("t")
        hit = scene.ray_intersect(mitsuba.Ray3f(p, v))
        theirs = float(hit.t) if hit.is_valid() else None
        found += own is not None
        differ += is_other(own, theirs, is_whole)
    stage = json.loads(out.read_text())
    camera = camera_differs(scene.sensors()[0], stage) if "camera" in stage and scene.sensors() else None
    print(f"{path}: {RAYS} rays, {found} meet something, {differ} differ{'' if is_whole else ', shapes are left out'}; camera by {camera}")
    return differ <= OUTLINES * RAYS and (camera is None or camera < 1e-5)


def exported(durero, folder):
    """Whether Mitsuba sees what a scene has that it is written from: one with all shapes that Mitsuba has, boxes and copies."""
    elements = [e for e in random_elements(random.Random(SEED)) if e["tipo"] not in ("plano", "cono", "tronco")]
    elements.append({"id": "box", "tipo": "caja", "esquinas": [[0.25, 0.5, 0.25], [0.5, 0.625, 0.75]]})
    for name, of, way in (("a", "e00", 0.3), ("b", "e01", -0.2), ("c", "e04", 0.25), ("d", "box", -0.3)):
        rows = [[1, 0.25, 0, way], [0, 2, 0, -0.7], ["1/3", 0, 1, way]]
        elements.append({"id": name, "tipo": "instancia", "de": of, "mapa": rows})
    camera = {"eye": [2, 1, 3], "look_at": [0.5, 0.25, 0.5], "up": [0, 1, 0], "fov_y": 40, "mirrored": True}
    scene = {"format": "durero-scene", "version": 1, "camera": camera, "resolution": [80, 45], "elementos": elements}
    (folder / "written.json").write_text(json.dumps(scene))
    path = folder / "written.xml"
    subprocess.run([durero, "export", str(folder / "written.json"), "-o", str(path)], check=True, capture_output=True)
    return judge(durero, path, folder / "written.json", mitsuba.load_file(str(path)), True)


def main():
    durero = str(pathlib.Path(sys.argv[1]).resolve())
    mitsuba.set_variant("scalar_rgb")
    mitsuba.set_log_level(mitsuba.LogLevel.Error)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "tetrahedron.obj").write_text(TETRAHEDRON)
        (folder / "own.xml").write_text(OWN)
        scenes = [pathlib.Path(path) for path in sys.argv[2:]] or [folder / "own.xml"]
        agree = [answer for path in scenes if (answer := compare(durero, path, folder)) is not None]
        if not sys.argv[2:]:
            agree.append(exported(durero, folder))
        print(f"{sum(agree)} of {len(agree)} agree")
        sys.exit(0 if all(agree) else 1)


main()
