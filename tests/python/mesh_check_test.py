"""The audit of a mesh is the program's; what is no mesh is refused by name."""
from __future__ import annotations

import json
import pathlib
import subprocess
from fractions import Fraction

import numpy as np
import pytest
from support import PROGRAM

import durero

VERTICES = np.array([[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2], [1, 0, 0]], float)
FACES = np.array([[0, 2, 1], [0, 4, 3], [4, 1, 3], [1, 2, 3], [0, 2, 3], [0, 1, 1]])


def scene_of_faces() -> durero.Scene:
    scene = durero.Scene()
    for n, face in enumerate(FACES[:5]):
        scene.add(str(n), durero.Triangulo(vertices=VERTICES[face].tolist()))
    return scene


def test_findings_are_those_of_the_program(tmp_path: pathlib.Path) -> None:
    scene = scene_of_faces()
    scene.save(tmp_path / "mesh.json")
    command = [PROGRAM, "check", "--mesh", str(tmp_path / "mesh.json"), "--point", "1,1,1", "--format", "json"]
    told = json.loads(subprocess.run(command, capture_output=True, text=True).stdout)
    check = durero.check_mesh(scene, point=(1, 1, 1))
    assert [f.kind for f in check.findings] == [f["kind"] for f in told["findings"]]
    assert [list(f.faces) for f in check.findings] == [f["faces"] for f in told["findings"]]
    assert [[list(p) for p in f.places] for f in check.findings] == [f["places"] for f in told["findings"]]
    assert [list(f.mended) for f in check.findings] == [f["mended"] for f in told["findings"]]
    assert (check.triangles, check.vertices, check.pieces, check.volume) == (5, 5, 1, None)
    assert check.side == told["point"]["side"]
    assert [(piece.first, piece.triangles, piece.volume) for piece in check.each_piece] == [("0", 5, None)]


def test_each_piece_has_its_volume() -> None:
    closed = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])
    check = durero.check_mesh(np.concatenate([VERTICES[:4], VERTICES[:4] * 3 + 9]), np.concatenate([closed, closed + 4]))
    assert [(piece.first, piece.triangles, piece.volume) for piece in check.each_piece] == [
        ("0", 4, Fraction(4, 3)),
        ("4", 4, 36),
    ]
    assert check.volume == Fraction(112, 3)


def test_arrays_are_audited_as_a_scene_and_their_degenerate_faces_told() -> None:
    of_scene = durero.check_mesh(scene_of_faces())
    assert durero.check_mesh(VERTICES, FACES[:5]).findings == of_scene.findings
    degenerate = [f for f in durero.check_mesh(VERTICES, FACES).findings if f.kind == "degeneradas"]
    assert [f.faces for f in degenerate] == [("5",)]


@pytest.mark.parametrize(
    "mesh, faces, error",
    [
        (VERTICES, None, TypeError),
        (durero.Scene(), FACES, TypeError),
        (VERTICES.astype(int), FACES, TypeError),
        (VERTICES, FACES.astype(float), TypeError),
        (VERTICES[:, :2], FACES, ValueError),
        (VERTICES, FACES + 1, ValueError),
        (VERTICES * np.inf, FACES, ValueError),
    ],
)
def test_no_mesh_is_refused(mesh: object, faces: object, error: type[Exception]) -> None:
    with pytest.raises(error, match="expected"):
        durero.check_mesh(mesh, faces)  # type: ignore[arg-type]


def test_a_point_that_is_none_is_refused() -> None:
    with pytest.raises(ValueError, match="point has"):
        durero.check_mesh(VERTICES, FACES, point=(0, 0, np.nan))
