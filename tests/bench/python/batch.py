"""batch.py BATCH: a million rays by Python's trace and by one call of the C++ batch, in turns, so that both meet the same
machine: the ratio of their times for scenes of few and of more elements. The figure is at most 1.1."""
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import numpy as np

import durero

ROUNDS = 9
RAYS = 1_000_000


def scene_of(count: int) -> durero.Scene:
    """Spheres in the unit cube."""
    random = np.random.default_rng(1)
    scene = durero.Scene()
    for i in range(count):
        scene.add(f"s{i}", durero.Esfera(random.uniform(0, 1, 3), random.uniform(0.1, 0.25) * count ** (-1 / 3)))
    return scene


def compare(count: int, batch: str, folder: pathlib.Path) -> None:
    random = np.random.default_rng(2)
    scene = scene_of(count)
    eye = np.broadcast_to([0.5, 0.5, -1.2], (RAYS, 3))
    rays = np.ascontiguousarray(np.hstack([eye, random.uniform(0, 1, (RAYS, 3)) - eye]))
    scene.save(folder / "scene.json")
    np.save(folder / "rays.npy", rays)
    command = [batch, folder / "scene.json", folder / "rays.npy"]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as program:
        assert program.stdin and program.stdout
        ratios, seconds = [], []
        for _ in range(ROUNDS):
            program.stdin.write("\n")
            program.stdin.flush()
            in_cpp = float(program.stdout.readline().split()[0])
            begin = time.perf_counter()
            scene.trace(rays)
            seconds.append(time.perf_counter() - begin)
            ratios.append(seconds[-1] / in_cpp)
        program.stdin.close()
    print(f"{count} spheres: Python takes {statistics.median(ratios):.3f} of C++'s time"
          f" ({min(ratios):.3f} to {max(ratios):.3f}); {RAYS / min(seconds):.3g} rays/s")


with tempfile.TemporaryDirectory() as name:
    for elements in (3, 30, 300):
        compare(elements, sys.argv[1], pathlib.Path(name))
