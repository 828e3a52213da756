#!/usr/bin/env python3
"""povray_texts.py DURERO: what a text says by its version, its gamma and the order of its camera's words is to `durero import` what
it is to POV-Ray, by POV-Ray's own pictures.

- A background and a surface in one term of light have the colours of POV-Ray's picture, for each version and each gamma; a byte
  may be off by one, where a component lies near the middle of two.
- A shaded picture is nearer to POV-Ray's than it is where the numbers are taken for linear light: by half at least.
- The words of a camera, in whatever order, are one camera to both.

Exit status 77 (skipped) where POV-Ray is absent (Debian: povray).
"""
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from png import png_pixels  # noqa: E402

SEED, ORDERS = 1, 12
SIZE = (32, 18)
VERSIONS = ["", "#version 3.5;", "#version 3.6;", "#version 3.7;", "#version unofficial 3.7;"]
GAMMAS = ["", "assumed_gamma 1", "assumed_gamma 1.8", "assumed_gamma 2.2", "assumed_gamma srgb", "assumed_gamma 2.2 assumed_gamma 1"]
CAMERA = "camera { location <0, 0, -3> right -x*16 up y*9 angle 60 look_at 0 }"
FLAT = """background { rgb <0.2, 0.3, 0.5> }
sphere { 0, 0.5 pigment { rgb <0.03, 0.6, 0.9> } finish { ambient 0.5 diffuse 0 } }"""
SHADED = """background { rgb <0.2, 0.3, 0.5> }
light_source { <3, 5, -6>, rgb <1, 0.9, 0.8> }
sphere { 0, 0.8 pigment { rgb <0.9, 0.4, 0.2> } finish { ambient 0 diffuse 0.8 } }
plane { y, -0.8 pigment { rgb 0.6 } finish { ambient 0 diffuse 0.8 } }"""
WORDS = ["location <1, 2, -7>", "look_at <0.5, 0.25, 0>", "angle 42", "right <-16, 0, 0>", "up <0, 9, 0>", "sky <0.25, 1, 0>",
         "direction <0, 0, 2>"]
durero, failures = sys.argv[1], 0


def fail(what):
    global failures
    failures += 1
    print("FAILED:", what)


def by_povray(text, folder):
    (folder / "text.pov").write_text(text)
    call = ["povray", "+Itext.pov", "+Othere.ppm", "+FP8", f"+W{SIZE[0]}", f"+H{SIZE[1]}", "-A", "-D", "File_Gamma=sRGB"]
    said = subprocess.run(call, cwd=folder, capture_output=True, text=True)
    if said.returncode != 0:
        sys.exit(f"povray refuses\n{text}\n{said.stderr[-2000:]}")
    return (folder / "there.ppm").read_bytes()[-3 * SIZE[0] * SIZE[1] :]


def by_durero(text, folder):
    (folder / "text.pov").write_text(text)
    subprocess.run([durero, "import", folder / "text.pov", "-o", folder / "scene.json"], check=True, capture_output=True)
    size = "x".join(map(str, SIZE))
    subprocess.run([durero, "render", folder / "scene.json", "-o", folder / "here.png", "--size", size], check=True, capture_output=True)
    return png_pixels((folder / "here.png").read_bytes())[2], (folder / "scene.json").read_text()


def off(a, b):
    return [abs(x - y) for x, y in zip(a, b, strict=True)]


def colours(folder):
    for version in VERSIONS:
        for gamma in GAMMAS:
            text = f"{version}\n{f'global_settings {{ {gamma} }}' if gamma else ''}\n{CAMERA}\n{FLAT}\n"
            there, (here, _) = by_povray(text, folder), by_durero(text, folder)
            # The ball's outline is not compared: a corner and the middle are.
            middle = 3 * (SIZE[1] // 2 * SIZE[0] + SIZE[0] // 2)
            for at, what in ((0, "the background"), (middle, "the ball")):
                if max(off(here[at : at + 3], there[at : at + 3])) > 1:
                    fail(f"{version} {gamma}: {what} is {tuple(here[at:at + 3])}, of POV-Ray {tuple(there[at:at + 3])}")


def shading(folder):
    for gamma in ("", "global_settings { assumed_gamma 2.2 }"):
        text = f"{gamma}\n{CAMERA}\n{SHADED}\n"
        there = by_povray(text, folder)
        here = sum(off(by_durero(text, folder)[0], there))
        linear = sum(off(by_durero(f"#version 3.7; {CAMERA}\n{SHADED}", folder)[0], there))
        print(f"{gamma or 'no gamma'}: off by {here / len(there):.1f} of 255 in the mean, and by {linear / len(there):.1f} as linear light")
        if 2 * here > linear:
            fail(f"{gamma}: no nearer to POV-Ray's picture than linear light")


def cameras(folder):
    rng, words = random.Random(SEED), list(WORDS)
    first = None
    for _ in range(ORDERS):
        text = f"#version 3.7;\ncamera {{ {' '.join(words)} }}\n{SHADED}\n"
        there, (_, scene) = by_povray(text, folder), by_durero(text, folder)
        first = first or (there, scene)
        if sum(x > 2 for x in off(there, first[0])) > 6:
            fail(f"seed {SEED}: POV-Ray sees another picture by {' '.join(words)}")
        if scene != first[1]:
            fail(f"seed {SEED}: another scene by {' '.join(words)}")
        rng.shuffle(words)


if shutil.which("povray") is None:
    print("skipped: POV-Ray is absent (Debian: povray)")
    sys.exit(77)
with tempfile.TemporaryDirectory() as name:
    for check in (colours, shading, cameras):
        check(pathlib.Path(name))
print(f"{len(VERSIONS) * len(GAMMAS)} gammas, {ORDERS} orders, {failures} failures")
sys.exit(failures > 0)
