#!/usr/bin/env python3
"""povray.py DURERO [SCENE...]: how long POV-Ray 3.7 and this program take to draw a scene, without antialiasing.

Equal pixels (1280 by 720), one ray through each, equal depth, the same lights and materials: POV-Ray draws what `durero
export` writes. Both have two threads, take turns in one run, and read the scene and write the picture as PNG; of each
the least of three is taken, of the time that a clock on the wall shows, and of that of its processors together. The ratio is
POV-Ray's over Durero's. SCENE is a scene file or NFF; without any, the two of demo/, Whitted's of its gallery, and the
small Standard Procedural Databases where the folder DURERO_SPD, or shared/data/spd beside the sources, has them.
"""
import os
import pathlib
import subprocess
import sys
import tempfile
import time

WIDTH, HEIGHT, THREADS, RUNS = 1280, 720, 2, 3
ROOT = pathlib.Path(__file__).resolve().parents[2]


def seconds(call, folder):
    """On the wall, and of all processors together as the system counts them for a child that has ended."""
    before, start = os.times(), time.monotonic()
    subprocess.run(call, cwd=folder, check=True, capture_output=True)
    wall, after = time.monotonic() - start, os.times()
    return wall, after.children_user + after.children_system - before.children_user - before.children_system


def least(times):
    return tuple(min(column) for column in zip(*times))


def own_scenes():
    spd = pathlib.Path(os.environ.get("DURERO_SPD", ROOT.parent / "shared" / "data" / "spd"))
    names = ["mirrors.json", "still-life.json", "gallery/whitted.json"]
    return [ROOT / "demo" / name for name in names] + sorted(spd.glob("*-small.nff"))


def compare(durero, scene, folder):
    subprocess.run([durero, "import", scene, "-o", folder / "scene.json"], check=True, capture_output=True)
    subprocess.run([durero, "export", "scene.json", "-o", "scene.pov"], cwd=folder, check=True, capture_output=True)
    here = [durero, "render", "scene.json", "-o", "here.png", "--size", f"{WIDTH}x{HEIGHT}", "--threads", str(THREADS), "--quiet"]
    there = ["povray", "+Iscene.pov", "+Othere.png", f"+W{WIDTH}", f"+H{HEIGHT}", f"+WT{THREADS}", "-A", "-D", "File_Gamma=sRGB"]
    turns = [(seconds(here, folder), seconds(there, folder)) for _ in range(RUNS)]
    return (least(times) for times in zip(*turns))


def main():
    durero = str(pathlib.Path(sys.argv[1]).resolve())
    print(f"{WIDTH} by {HEIGHT}, {THREADS} threads, the least of {RUNS}; on the wall and of the processors, in seconds")
    for scene in map(pathlib.Path, sys.argv[2:] or own_scenes()):
        with tempfile.TemporaryDirectory() as name:
            ours, theirs = compare(durero, scene, pathlib.Path(name))
        said = ", ".join(f"{b:.2f} : {a:.2f} = {b / a:.2f}" for a, b in zip(ours, theirs))
        print(f"{scene.name}: POV-Ray : durero {said}", flush=True)


main()
