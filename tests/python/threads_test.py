"""Threads trace one scene at once and beside edits, and nothing is kept that nobody holds."""
from __future__ import annotations

import copy
import gc
import resource
import signal
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from support import STILL_LIFE, along_z, random_rays, sphere_scene

import durero


def test_threads_that_trace_one_scene_get_the_same_bytes() -> None:
    scene = durero.Scene.load(STILL_LIFE)
    rays = random_rays(20000, seed=7)
    expected = scene.trace(rays).tobytes()
    fresh = copy.copy(scene)
    fresh.remove("apple")
    fresh.add("apple", scene["apple"])
    with ThreadPoolExecutor(4) as threads:
        answers = list(threads.map(lambda _: fresh.trace(rays).tobytes(), range(12)))
    assert set(answers) == {expected}


def test_python_goes_on_while_a_thread_traces() -> None:
    scene = durero.Scene.load(STILL_LIFE)
    rays = random_rays(2000, seed=8)
    thread = threading.Thread(target=scene.trace, args=(rays, "exact"))
    thread.start()
    counted = 0
    while thread.is_alive():
        counted += 1
        time.sleep(0.001)
    assert counted > 1


def test_a_trace_answers_for_the_scene_as_it_was_when_it_began() -> None:
    scene = durero.Scene()
    scene.add("plane", durero.Plano(centro=(0, 0, 5), vector=(0, 0, 1)))
    rays = along_z(50000)
    done = threading.Event()
    edits = 0

    def edit() -> None:
        nonlocal edits
        while not done.is_set():
            scene.apply(f"Agregar_Plano e?=near centro?=(0,0,{1 + edits % 3}) vector?=(0,0,1)")
            scene.apply("Eliminar_Plano e?=near")
            edits += 1

    editor = threading.Thread(target=edit)
    editor.start()
    try:
        for _ in range(100):
            assert len(np.unique(scene.trace(rays)["t"])) == 1
    finally:
        done.set()
        editor.join()
    assert edits > 0 and scene.names == ("plane",) and scene.trace(rays[:1])["t"] == 5


def test_an_edit_is_seen_by_the_next_trace() -> None:
    scene = sphere_scene()
    assert scene.trace(along_z())["t"] == 4
    scene.add("near", durero.Esfera(centro=(0, 0, 2), radio=1))
    assert scene.trace(along_z())["t"] == 1 and scene.names == ("near", "s1")
    scene.remove("near")
    assert scene.trace(along_z())["t"] == 4


def test_an_interrupt_stops_a_long_trace() -> None:
    class Stopped(Exception):
        pass

    def stop(*_: object) -> None:
        raise Stopped

    before = signal.signal(signal.SIGALRM, stop)
    rays = random_rays(1 << 20, seed=9)
    many = np.ascontiguousarray(np.tile(rays, (4, 1)))
    scene = durero.Scene.load(STILL_LIFE)
    signal.setitimer(signal.ITIMER_REAL, 0.01)
    try:
        with pytest.raises(Stopped):
            scene.trace(many)
            pytest.fail("the trace was over before it was interrupted")
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def _resident() -> int:
    """In KiB."""
    with open("/proc/self/statm") as statm:
        return int(statm.read().split()[1]) * resource.getpagesize() // 1024


def test_a_thousand_traces_keep_nothing() -> None:
    scene = sphere_scene()
    rays = along_z(500)
    wrong = rays.copy()
    wrong[400, 0] = np.nan

    def once() -> None:
        scene.trace(rays, elements="all")
        scene.add("more", durero.Esfera(centro=(0, 0, 2), radio=1))
        scene.occluded(rays, en=np.zeros(500, np.int32))
        scene.remove("more")
        with pytest.raises(ValueError):
            scene.trace(wrong)
        with pytest.raises(durero.Refused):
            scene.apply("Eliminar_Esfera e?=none")

    for _ in range(100):
        once()
    gc.collect()
    before = _resident()
    for _ in range(1000):
        once()
    gc.collect()
    # One answer that was kept in each round would be 20 MB in all.
    assert _resident() - before < 8 * 1024
