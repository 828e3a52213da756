"""Distances are the program's, byte for byte; what is no array of points is refused by name."""
from __future__ import annotations

import pathlib

import numpy as np
import pytest
from support import STILL_LIFE, run

import durero


def test_distances_are_those_of_the_program_byte_for_byte(tmp_path: pathlib.Path) -> None:
    scene = durero.Scene.load(STILL_LIFE)
    points = np.random.default_rng(1).uniform(-3, 3, (500, 3))
    np.save(tmp_path / "points.npy", points)
    run("distance", STILL_LIFE, tmp_path / "points.npy", "-o", tmp_path / "near.npy")
    expected, near = np.load(tmp_path / "near.npy"), scene.distance(points)
    assert near.dtype == durero.PROXIMITY
    assert near["distance"].tobytes() == expected["distance"].tobytes()
    assert near["point"].tobytes() == expected["nearest"].tobytes()
    assert [durero.Count(count).name.encode() for count in near["count"]] == expected["count"].tolist()
    assert [scene.names[e] for e in near["element"]] == [names.decode().split(",")[0] for names in expected["elementos"]]
    assert near["tied"].tolist() == [b"," in names for names in expected["elementos"]]


def test_an_empty_scene_has_no_distance() -> None:
    near = durero.Scene().distance(np.zeros((1, 3)))
    assert (near["count"][0], near["element"][0]) == (durero.Count.none, -1)
    assert np.isnan(near["distance"][0]) and np.isnan(near["point"][0]).all()


def test_what_is_no_array_of_points_is_refused_by_name() -> None:
    scene = durero.Scene.load(STILL_LIFE)
    with pytest.raises(TypeError, match="points is no array"):
        scene.distance([[0, 0, 0]])  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="points has another dtype"):
        scene.distance(np.zeros((1, 3), np.float32))
    for points in (np.zeros((1, 6)), np.zeros(3), np.zeros((3, 3)).T[:2]):
        with pytest.raises(ValueError, match="points has another shape or layout"):
            scene.distance(points)
    with pytest.raises(ValueError, match=r"points\[1, 2\] is nan"):
        scene.distance(np.array([[0, 0, 0], [0, 0, np.nan]]))
