#!/usr/bin/env python3
"""povray_pictures.py DURERO ROOT: POV-Ray draws what `durero export` writes for it as `durero render` draws the scene, and
a text of its own as `durero render` draws what `durero import` reads of it.

Both draw one ray a pixel through its centre and go through the curve of sRGB. What may differ, and does:
- a pixel whose ray comes near an edge, in sight, in a mirror or in glass, or whose shadow ray does: POV-Ray's rays have other
  last digits, start off their surface by a distance of its own, and miss what is nearer than that;
- where a relief turns a slope away from whoever looks, at outlines, and where it has steps: what is drawn then is told in
  docs/rendering-reference.md, which has traced the pixels of demo/gallery/everything.json one by one;
- a byte by one, where a component lies near the middle of two.
So the share of the pixels with a component that is off by more than OFF steps of 255 must be below FEW, and all others
are alike (of a text of its own below FEW_READ); where they stand is said, and with a third argument drawn there, as a grey
PGM. Exit status 77 (skipped) where POV-Ray is absent (Debian: povray).
"""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from png import png_pixels  # noqa: E402

OFF, FEW = 2, 0.01
FEW_READ = 0.001  # of a text without reliefs, of which one cap of a solid is 0.9 %
WIDTH = 320
SCENES = ["demo/mirrors.json", "demo/still-life.json", "demo/gallery/whitted.json", "demo/gallery/everything.json", "tests/peers/worn.json", "tests/peers/spots.json", "tests/peers/relief.json", "demo/gallery/solids.json", "tests/peers/unions.pov", "tests/peers/solids.pov"]


def drawn(durero, scene, folder):
    text = folder / "scene.pov"
    if scene.suffix == ".pov":
        shutil.copy(scene, text)
        scene = folder / "scene.json"
        subprocess.run([durero, "import", text, "-o", scene], check=True, capture_output=True)
    else:
        subprocess.run([durero, "export", scene, "-o", text], check=True, capture_output=True)
    # The camera that is exported has the form of the scene's own picture.
    across, down = json.loads(scene.read_text())["resolution"]
    height = WIDTH * down // across
    subprocess.run([durero, "render", scene, "-o", folder / "here.png", "--size", f"{WIDTH}x{height}"], check=True)
    call = ["povray", "+Iscene.pov", "+Othere.ppm", "+FP8", f"+W{WIDTH}", f"+H{height}", "-A", "-D", "File_Gamma=sRGB"]
    said = subprocess.run(call, cwd=folder, capture_output=True, text=True)
    if said.returncode != 0:
        sys.exit(f"{scene}: povray refuses the text:\n{said.stderr[-3000:]}")
    return png_pixels((folder / "here.png").read_bytes())[2], (folder / "there.ppm").read_bytes()[-3 * WIDTH * height :]


def compare(name, here, there, into):
    steps = [max(abs(here[i + k] - there[i + k]) for k in range(3)) for i in range(0, len(here), 3)]
    off = [i for i, step in enumerate(steps) if step > OFF]
    share = len(off) / len(steps)
    print(f"{name}: {len(off)} of {len(steps)} pixels off by more than {OFF} of 255 ({100 * share:.2f} %), {sum(s > 0 for s in steps)} not the same")
    for i in off[:8]:
        print(f"  ({i % WIDTH}, {i // WIDTH}): here {tuple(here[3 * i : 3 * i + 3])}, POV-Ray {tuple(there[3 * i : 3 * i + 3])}")
    if into:
        pathlib.Path(into, f"{pathlib.Path(name).stem}.pgm").write_bytes(b"P5 %d %d 255\n" % (WIDTH, len(steps) // WIDTH) + bytes(steps))
    return share < (FEW_READ if name.endswith(".pov") else FEW) and len(set(here)) > 50


def main():
    if shutil.which("povray") is None:
        print("skipped: POV-Ray is absent (Debian: povray)")
        sys.exit(77)
    alike = True
    for name in SCENES:
        with tempfile.TemporaryDirectory() as folder:
            here, there = drawn(sys.argv[1], pathlib.Path(sys.argv[2], name), pathlib.Path(folder))
        alike &= compare(name, here, there, sys.argv[3] if len(sys.argv) > 3 else None)
    sys.exit(0 if alike else 1)


main()
