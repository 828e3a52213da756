#!/usr/bin/env python3
"""povray.py DURERO [SCENE...]: how long POV-Ray 3.7 and this program take to draw a scene.

Both have one thread, take turns in one run, read the scene and write the picture as PNG. Of each the least of three is taken, of
the time that its processor worked for it (user). The ratio is POV-Ray's over Durero's.

First scenes with one ray a pixel, 1280 by 720, equal depth, the same lights and materials: POV-Ray draws what `durero export`
writes, in patterns of its own. SCENE is a scene file or NFF; without any, the two of demo/, Whitted's of its gallery, and the
Standard Procedural Databases where the folder DURERO_SPD, or shared/data/spd beside the sources, has them.

Without a SCENE, soft shadows and depth of field follow, at equal error: area lights with and without `adaptive`, `jitter` and
antialiasing, and `aperture` with `blur_samples`. Each program draws with more and more samples. Its error is the RMS difference
of its bytes from a picture of its own with very many. The least time in which POV-Ray comes to an error of Durero's is read off
between its own pictures, by logarithms, on the line of those that no other beats in both.
"""
import json
import math
import os
import pathlib
import re
import resource
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "support"))
from png import png_pixels  # noqa: E402

WIDTH, HEIGHT, RUNS = 1280, 720, 3
SMALL = (160, 90)  # where errors are measured
POVRAY = ["povray", "+Iscene.pov", "+Othere.png", "+WT1", "-D", "File_Gamma=sRGB"]


def seconds(call, folder):
    """Of a processor, for a child that has ended."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    subprocess.run(call, cwd=folder, check=True, capture_output=True)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def own_scenes():
    spd = pathlib.Path(os.environ.get("DURERO_SPD", ROOT.parent / "shared" / "data" / "spd"))
    names = ["gallery/whitted.json", "mirrors.json", "still-life.json"]
    return [ROOT / "demo" / name for name in names] + sorted(spd.glob("*.nff"))


def compare(durero, scene, folder):
    subprocess.run([durero, "import", scene, "-o", folder / "scene.json"], check=True, capture_output=True)
    subprocess.run([durero, "export", "scene.json", "-o", "scene.pov"], cwd=folder, check=True, capture_output=True)
    here = [durero, "render", "scene.json", "-o", "here.png", "--size", f"{WIDTH}x{HEIGHT}", "--threads", "1", "--quiet"]
    there = [*POVRAY, f"+W{WIDTH}", f"+H{HEIGHT}", "-A"]
    turns = [(seconds(here, folder), seconds(there, folder)) for _ in range(RUNS)]
    return (min(times) for times in zip(*turns))


def soft(text, side, attributes):
    """The text with so many points along a side of each light of some size, which `durero export` writes with nine."""
    changed, count = re.subn(r", 9, 9 jitter ", f", {side}, {side} {attributes} ", text)
    if count == 0:
        sys.exit("durero export writes no light with 9 by 9 points; expected one in the soft shadows")
    return changed


def blurred(text, count, variance):
    """The text with so many rays for a pixel, which `durero export` writes with 64."""
    changed, times = re.subn(r" blur_samples 64 variance 0 ", f" blur_samples {count} confidence 0.95 variance {variance} ", text)
    if times == 0:
        sys.exit("durero export writes no lens with 64 rays a pixel; expected one in the depth of field")
    return changed


def picture(path):
    return png_pixels(path.read_bytes())[2]


def rms(a, b):
    return math.sqrt(sum((x - y) ** 2 for x, y in zip(a, b)) / len(a))


class Equal:
    """A scene drawn by both with more and more samples."""

    def __init__(self, durero, folder, scene):
        self.durero, self.folder, self.scene = durero, folder, scene
        (folder / "scene.json").write_text(json.dumps(scene), encoding="utf-8")
        subprocess.run([durero, "export", "scene.json", "-o", "bare.pov"], cwd=folder, check=True, capture_output=True)
        self.bare = (folder / "bare.pov").read_text(encoding="utf-8")

    def here(self, samples, sampling="net"):
        call = [self.durero, "render", "scene.json", "-o", "here.png", "--size", "{}x{}".format(*SMALL), "--sampling", sampling,
                "--samples", str(samples), "--threads", "1", "--quiet"]
        return min(seconds(call, self.folder) for _ in range(2)), picture(self.folder / "here.png")

    def there(self, text, options):
        (self.folder / "scene.pov").write_text(text, encoding="utf-8")
        call = [*POVRAY, *"+W{} +H{}".format(*SMALL).split(), *options]
        return min(seconds(call, self.folder) for _ in range(2)), picture(self.folder / "there.png")

    @staticmethod
    def print(title, ours, theirs, truths):
        mine = [(t, rms(p, truths[0]), name) for name, (t, p) in ours]
        other = sorted((rms(p, truths[1]), t, name) for name, (t, p) in theirs)
        best = [one for i, one in enumerate(other) if all(one[1] < two[1] and two[0] < one[0] for two in other[:i])]
        print(f"{title}: RMS error of 255 and seconds of a processor")
        for error, time, name in other:
            print(f"  POV-Ray {name}: {error:.2f}, {time:.2f}")
        for time, error, name in mine:
            they = time_for(best, error)
            there = f"POV-Ray {they:.2f}, ratio {they / time:.1f}" if they else "no picture of POV-Ray is so near"
            print(f"  durero {name}: {error:.2f}, {time:.2f}: {there}", flush=True)


def time_for(line, error):
    """On a line of errors and times, ascending by error: between two, by logarithms; beyond the greatest error along the last two;
    nothing below the least."""
    points = [(math.log(e), math.log(t)) for e, t, _ in line if e > 0]
    if not points or error < math.exp(points[0][0]) * (1 - 1e-9):
        return None
    if len(points) == 1:
        return math.exp(points[0][1])
    i = next((k for k in range(1, len(points)) if points[k][0] >= math.log(error)), len(points) - 1)
    (x, a), (y, b) = points[i - 1], points[i]
    return math.exp(a + (b - a) * (math.log(error) - x) / (y - x))


def soft_shadows(durero, folder):
    scene = json.loads((ROOT / "demo" / "gallery" / "soft-shadows.json").read_text(encoding="utf-8"))
    for material in scene["materials"].values():
        material.pop("gloss", None)  # POV-Ray has none
    pair = Equal(durero, folder, scene)
    ways = [(f"{n} by {n} {word} {' '.join(options)}", soft(pair.bare, n, word), options)
            for options in (["+AM1", "+A0.1", "+R2"], ["+AM2", "+A0.05", "+R2"], ["+AM2", "+A0.01", "+R3"], ["+AM1", "+A0.0", "+R4"])
            for word in ("jitter", "jitter adaptive 1") for n in (3, 5, 9)]
    theirs = [(name, pair.there(text, options)) for name, text, options in ways]
    ours = [(f"net {n}", pair.here(n)) for n in (16, 64, 144)]
    truths = pair.here(4096)[1], pair.there(soft(pair.bare, 16, "jitter"), ["+AM1", "+A0.0", "+R6"])[1]
    pair.print("soft shadows", ours, theirs, truths)


def depth_of_field(durero, folder):
    scene = json.loads((ROOT / "demo" / "gallery" / "depth-of-field.json").read_text(encoding="utf-8"))
    for light in scene["lights"]:
        light.pop("sphere", None)
    pair = Equal(durero, folder, scene)
    ways = [(f"{n} samples, variance {variance}", blurred(pair.bare, n, variance)) for n in (7, 19, 37, 64, 128, 256)
            for variance in ("0", "1/128", "1/1000", "1/10000")]
    theirs = [(name, pair.there(text, ["-A"])) for name, text in ways]
    ours = [(f"{how} {n}", pair.here(n, how)) for how, counts in (("net", (16, 64, 144)), ("allotted", (48, 128, 256, 512, 1024)))
            for n in counts]
    truths = pair.here(4096)[1], pair.there(blurred(pair.bare, 4096, "0"), ["-A"])[1]
    pair.print("depth of field", ours, theirs, truths)


def main():
    durero = str(pathlib.Path(sys.argv[1]).resolve())
    print(f"{WIDTH} by {HEIGHT}, one ray a pixel, one thread, the least of {RUNS}, in seconds of a processor")
    for scene in map(pathlib.Path, sys.argv[2:] or own_scenes()):
        with tempfile.TemporaryDirectory() as name:
            ours, theirs = compare(durero, scene, pathlib.Path(name))
        print(f"{scene.name}: POV-Ray {theirs:.2f} : durero {ours:.2f} = {theirs / ours:.2f}", flush=True)
    if len(sys.argv) > 2:
        return
    for compared in (soft_shadows, depth_of_field):
        with tempfile.TemporaryDirectory() as name:
            compared(durero, pathlib.Path(name))


if __name__ == "__main__":
    main()
