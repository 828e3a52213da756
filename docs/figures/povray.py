#!/usr/bin/env python3
"""povray.py DURERO SCENE...: how long POV-Ray 3.7 and this program take to draw a scene, without antialiasing.

Equal pixels (1280 by 720), one ray through each, equal depth, the same lights and materials: POV-Ray draws what `durero
export` writes. Both have all processors; what is compared is the processor time of each process in one run, the least of three,
reading the scene and writing the picture with it. SCENE is a scene file or NFF.
"""
import os
import pathlib
import subprocess
import sys
import tempfile

WIDTH, HEIGHT, RUNS = 1280, 720, 3


def seconds(call, folder):
    """Of all processors together, as the system counts them for a child that has ended."""
    before = os.times()
    subprocess.run(call, cwd=folder, check=True, capture_output=True)
    after = os.times()
    return after.children_user + after.children_system - before.children_user - before.children_system


def main():
    durero = str(pathlib.Path(sys.argv[1]).resolve())
    for scene in sys.argv[2:]:
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            call = [durero, "import", scene, "-o", folder / "scene.json"]
            subprocess.run(call, check=True, capture_output=True)
            subprocess.run([durero, "export", "scene.json", "-o", "scene.pov"], cwd=folder, check=True, capture_output=True)
            size = f"{WIDTH}x{HEIGHT}"
            here = [durero, "render", "scene.json", "-o", "here.png", "--size", size]
            there = ["povray", "+Iscene.pov", "+Othere.png", f"+W{WIDTH}", f"+H{HEIGHT}", "-A", "-D", "File_Gamma=sRGB"]
            ours, theirs = (min(seconds(c, folder) for _ in range(RUNS)) for c in (here, there))
        print(f"{pathlib.Path(scene).name}: POV-Ray {theirs:.2f} s, durero {ours:.2f} s, ratio {theirs / ours:.2f}", flush=True)


main()
