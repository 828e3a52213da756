"""What the tests of the package share: the program, scenes, and random rays."""
from __future__ import annotations

import os
import pathlib
import subprocess
from typing import Any

import numpy as np
import numpy.typing as npt

import durero

PROGRAM = os.environ["DURERO"]
ROOT = pathlib.Path(os.environ["DURERO_ROOT"])
STILL_LIFE = ROOT / "demo" / "still-life.json"

Rays = npt.NDArray[np.float64]


def run(*arguments: Any) -> str:
    """What the program says."""
    command = [PROGRAM, *map(str, arguments)]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def sphere_scene() -> durero.Scene:
    scene = durero.Scene()
    scene.add("s1", durero.Esfera(centro=(0, 0, 5), radio=1))
    return scene


def tie_scene() -> durero.Scene:
    """Two elements that touch the ray along z at t = 4, and a plane behind."""
    scene = sphere_scene()
    scene.add("a", durero.Plano(centro=(0, 0, 4), vector=(0, 0, 1)))
    scene.add("z", durero.Plano(centro=(0, 0, 9), vector=(0, 0, 1)))
    return scene


def random_rays(count: int, seed: int = 1) -> Rays:
    """Towards the still life, from around it."""
    random = np.random.default_rng(seed)
    origins = random.uniform(-6, 6, (count, 3))
    targets = random.uniform((-3, 0, -3), (3, 3, 3), (count, 3))
    return np.ascontiguousarray(np.hstack([origins, targets - origins]))


def along_z(count: int = 1) -> Rays:
    return np.array([[0, 0, 0, 0, 0, 1]] * count, float)
