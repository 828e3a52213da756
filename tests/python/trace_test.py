"""Answers are the program's, byte for byte; rays are read where they lie, and what is no ray is refused by name."""
from __future__ import annotations

import json
import pathlib
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from support import STILL_LIFE, along_z, random_rays, run, sphere_scene, tie_scene

import durero
from durero import Resultado

COUNT = 3000


def test_hits_are_those_of_the_program_byte_for_byte(tmp_path: pathlib.Path) -> None:
    scene = durero.Scene.load(STILL_LIFE)
    rays = random_rays(COUNT)
    rays[7, 3:] *= 1e200
    rays[8, :3] = 1e-310
    np.save(tmp_path / "rays.npy", rays)
    for engine in [engine.name for engine in durero.engines() if engine.exact_bytes]:
        run("trace", STILL_LIFE, tmp_path / "rays.npy", "--engine", engine, "-o", tmp_path / "hits.npy")
        expected = np.load(tmp_path / "hits.npy")
        hits, offsets, elements = scene.trace(rays, engine, elements="all")
        assert hits.tobytes() == scene.trace(rays, engine).tobytes()
        assert [Resultado(outcome).name.encode() for outcome in hits["outcome"]] == expected["outcome"].tolist()
        assert hits["t"].tobytes() == expected["t"].tobytes()
        assert hits["point"].tobytes() == expected["point"].tobytes()
        names = [",".join(scene.names[e] for e in elements[offsets[i] : offsets[i + 1]]) for i in range(COUNT)]
        assert names == [joined.decode() for joined in expected["elementos"]]
        firsts = [scene.names[e] if e >= 0 else "" for e in hits["element"]]
        assert firsts == [joined.split(",")[0] for joined in names]
        assert 0 < np.count_nonzero(hits["outcome"] == Resultado.hit) < COUNT


def test_ties_and_starts_on_elements_are_those_of_the_program(tmp_path: pathlib.Path) -> None:
    scene = tie_scene()
    scene.add("c", durero.Cilindro(centro=(3, 0, -1), radio=1, vector=(0, 0, 1), altura=20))
    scene.save(tmp_path / "scene.json")
    origins = [[0, 0, 0], [0, 0, 3.5], [2, 0, 0], [2, 0, 3.5], [-3, 0, 0]]
    directions = [[0, 0, 1]] * 4 + [[0, 1, 0]]
    rays = np.hstack([np.array(origins, np.float64), np.array(directions, np.float64)])
    starts: list[list[str]] = [[], ["a", "s1"], ["c"], ["c", "a", "a"], []]
    lines = [" ".join(map(repr, ray)) + "".join(f" @{name}" for name in on) for ray, on in zip(rays.tolist(), starts)]
    (tmp_path / "rays.txt").write_text("\n".join(lines))
    expected = [json.loads(line) for line in run("trace", tmp_path / "scene.json", tmp_path / "rays.txt").splitlines()]
    offsets = np.cumsum([0] + [len(on) for on in starts])
    numbers = np.array([scene.names.index(name) for on in starts for name in on])
    hits, ends, elements = scene.trace(rays, en=(offsets, numbers), elements="all")
    for i, (hit, line) in enumerate(zip(hits, expected)):
        assert Resultado(hit["outcome"]).name == line["outcome"]
        assert [scene.names[e] for e in elements[ends[i] : ends[i + 1]]] == line["elementos"]
        assert bool(hit["tied"]) == (len(line["elementos"]) > 1)
        assert line["outcome"] != "hit" or (hit["t"], hit["point"].tolist()) == (line["t"], line["point"])
        assert line["outcome"] == "hit" or np.isnan([hit["t"], *hit["point"]]).all()
        exact = scene.exact(rays[i], en=starts[i])
        assert (exact.outcome.name, list(exact.elements)) == (line["outcome"], line["elementos"])
    assert {line["outcome"] for line in expected} == {"hit", "miss", "no_minimum"}
    assert scene.occluded(rays, en=(offsets, numbers)).tolist() == [line["outcome"] != "miss" for line in expected]


def test_one_element_for_each_ray_is_what_hits_have() -> None:
    scene = tie_scene()
    scene.remove("s1")
    rays = along_z(3)
    hits = scene.trace(rays)
    onwards = rays.copy()
    onwards[:, :3] = hits["point"]
    assert scene.trace(onwards, en=hits["element"])["t"].tolist() == [5.0] * 3
    onwards[:, 2] = 3.5  # before the plane by what a rounding may make
    assert scene.trace(onwards, en=hits["element"])["t"].tolist() == [5.5] * 3
    assert scene.trace(onwards, en=np.array([-1, 0, -1]))["t"].tolist() == [0.5, 5.5, 0.5]
    starts = np.array([0, 0, -1])
    assert scene.occluded_segment(onwards, en=starts).tolist() == [False, False, True]
    assert scene.occluded(onwards, en=(np.array([0, 2, 3, 3]), np.array([0, 1, 0]))).tolist() == [False, True, True]


def test_occlusion_is_what_first_hits_say() -> None:
    scene = durero.Scene.load(STILL_LIFE)
    rays = random_rays(COUNT, seed=3)
    hits = scene.trace(rays)
    assert np.array_equal(scene.occluded(rays), hits["outcome"] != Resultado.miss)
    segments = scene.occluded_segment(rays)
    assert np.array_equal(segments, hits["t"] < 1) and 0 < segments.sum() < COUNT
    assert np.array_equal(scene.occluded_segment(rays[:200], "exact"), segments[:200])


def masked(rays: Any) -> Any:
    return np.ma.masked_array(rays)  # type: ignore[no-untyped-call]


WRONG: list[tuple[Any, type[Exception], str]] = [
    ([[0, 0, 0, 0, 0, 1]], TypeError, r"rays is a list; expected a numpy.ndarray of float64, shape \(n, 6\)"),
    (along_z().astype(np.float32), TypeError, "rays has the dtype <f4"),
    (along_z().astype(">f8"), TypeError, "rays has the dtype >f8"),
    (along_z().astype(int), TypeError, "rays has the dtype <i8"),
    (along_z().astype(object), TypeError, "rays has the dtype |O"),
    (masked(along_z()), TypeError, "rays is a MaskedArray"),
    (along_z()[0], ValueError, r"rays has the shape \(6,\)"),
    (along_z(6).T[:3], ValueError, r"rays has the strides \(8, 48\).*numpy.ascontiguousarray"),
    (along_z(6)[:, :3], ValueError, r"rays has the shape \(6, 3\)"),
    (along_z(4)[::2], ValueError, r"rays has the strides \(96, 8\)"),
    (along_z(4)[::-1], ValueError, r"rays has the strides \(-48, 8\)"),
    (np.asfortranarray(along_z(4)), ValueError, r"rays has the strides \(8, 32\)"),
    (np.zeros((3, 1, 6)), ValueError, r"rays has the shape \(3, 1, 6\)"),
]


@pytest.mark.parametrize("rays, error, message", WRONG)
def test_arrays_that_are_no_rays_are_refused(rays: Any, error: type[Exception], message: str) -> None:
    scene = sphere_scene()
    with pytest.raises(error, match=message):
        scene.trace(rays)
    with pytest.raises(error, match=message):
        scene.occluded(rays)
    with pytest.raises(error, match=message):
        scene.occluded_segment(rays)


@pytest.mark.parametrize("row, column", [(0, 0), (1, 5), (999, 3)])
@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
def test_a_number_that_is_none_is_refused_by_row_and_column(row: int, column: int, value: float) -> None:
    rays = along_z(1000)
    rays[row, column] = value
    rays[999, 5] = np.nan
    column = 3 if row == 999 else column
    with pytest.raises(ValueError, match=rf"rays\[{row}, {column}\] is -?(nan|inf); expected a finite number"):
        sphere_scene().trace(rays)


def test_a_null_direction_is_refused_with_its_label() -> None:
    rays = along_z(5)
    rays[3, 3:] = [0, -0.0, 0]
    with pytest.raises(ValueError, match=r"rays\[3, 3:\] is \(0, 0, 0\); expected .*Rayo\.inv\.1"):
        sphere_scene().trace(rays)


def test_a_misaligned_array_is_refused() -> None:
    packed = np.zeros(3, np.dtype([("tag", "u1"), ("ray", "f8", (6,))]))
    packed["ray"] = along_z()
    rays = np.frombuffer(b"\0" + along_z(2).tobytes(), np.float64, offset=1, count=12).reshape(2, 6)
    with pytest.raises(ValueError, match="not aligned"):
        sphere_scene().trace(rays)
    assert sphere_scene().trace(rays.copy())["t"].tolist() == [4.0, 4.0]


def test_memory_maps_and_read_only_arrays_are_rays(tmp_path: pathlib.Path) -> None:
    np.save(tmp_path / "rays.npy", along_z(3))
    assert sphere_scene().trace(np.load(tmp_path / "rays.npy", mmap_mode="r"))["t"].tolist() == [4.0] * 3
    rays = along_z(3)
    rays.flags.writeable = False
    assert sphere_scene().trace(rays)["t"].tolist() == [4.0] * 3
    none = sphere_scene().trace(np.zeros((0, 6)), elements="all")
    assert (len(none.hits), none.offsets.tolist(), len(none.elements)) == (0, [0], 0)


BAD_ORIGINS: list[tuple[Any, type[Exception], str]] = [
    ("s1", TypeError, "en is a str"),
    (np.array([0.0, 0.0]), TypeError, "en has the dtype <f8"),
    (np.array([0, 1]), ValueError, r"en\[1\] is 1; expected -1 to 0"),
    (np.array([-2, 0]), ValueError, r"en\[0\] is -2"),
    (np.array([0]), ValueError, "en has 1 numbers; expected one for each of 2 rays"),
    ((np.array([0, 1, 1]), np.array([-1])), ValueError, r"en\[1\]\[0\] is -1; expected 0 to 0"),
    ((np.array([0, 1]), np.array([0])), ValueError, "offsets of 2 rays"),
    ((np.array([0, 2, 1]), np.array([0])), ValueError, "offsets of 2 rays"),
    ((np.array([1, 1, 1]), np.array([0])), ValueError, "offsets of 2 rays"),
    ((np.array([0, 1, 3]), np.array([0])), ValueError, "offsets of 2 rays"),
    ((np.array([0, 1, 1]),), ValueError, r"expected \(offsets, elements\)"),
]


@pytest.mark.parametrize("en, error, message", BAD_ORIGINS)
def test_origins_that_are_none_are_refused(en: Any, error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        sphere_scene().trace(along_z(2), en=en)


def test_engines_are_known_by_name() -> None:
    with pytest.raises(ValueError, match='no engine "exacto"; expected one of sampled, exact, analytic, '):
        sphere_scene().trace(along_z(), "exacto")
    with pytest.raises(ValueError, match="engine sampled: it knows nothing of the elements that a ray starts on"):
        sphere_scene().trace(along_z(), "sampled", en=np.array([0]))
    with pytest.raises(ValueError, match='elements is "some"|elements is .some.'):
        sphere_scene().trace(along_z(), elements="some")  # type: ignore[call-overload]
    assert abs(sphere_scene().trace(along_z(), "sampled")["t"][0] - 4) < 0.1
    listed, _ = run("engines").split("\n\n", 1)
    assert [engine.name for engine in durero.engines()] == [line.split()[0] for line in listed.splitlines()[::2]]


def test_hits_are_a_plain_array() -> None:
    hits: npt.NDArray[np.void] = sphere_scene().trace(along_z(2))
    assert hits.dtype == durero.HIT and hits.dtype.names == ("outcome", "tied", "element", "t", "point")
    assert hits.flags.c_contiguous and hits.flags.aligned and hits.flags.writeable and hits.dtype.itemsize == 40
    assert hits["point"][0].tolist() == [0, 0, 4]
