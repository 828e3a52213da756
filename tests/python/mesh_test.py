"""Meshes go in and out as arrays; a mesh that is refused or malformed changes nothing."""
from __future__ import annotations

import types
from collections.abc import Callable

import numpy as np
import numpy.typing as npt
import pytest

import durero

POINTS = np.array([[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]], float)
FACES = np.array([[0, 1, 2], [0, 2, 3]])


def square() -> durero.Scene:
    scene = durero.Scene()
    assert scene.add_mesh("m", POINTS, FACES) == "malla_agregada"
    return scene


def down(x: float, y: float) -> npt.NDArray[np.float64]:
    return np.array([[x, y, 5, 0, 0, -1]], float)


def test_faces_are_elements_and_arrays_know_them() -> None:
    scene = square()
    scene.add("z", durero.Esfera(centro=(9, 9, 9), radio=1))
    scene.add_mesh("a", POINTS + 7, FACES)
    assert scene.names == ("z", "a:0", "a:1", "m:0", "m:1")
    assert scene.faces.tolist() == [[-1, -1], [0, 0], [0, 1], [1, 0], [1, 1]]
    assert scene["m:1"] == durero.Triangulo(vertices=((0, 0, 0), (4, 4, 0), (0, 4, 0)))
    hits = scene.trace(down(1, 3))
    assert hits["t"].tolist() == [5.0]
    assert scene.names[hits["element"][0]] == "m:1"
    assert scene.trace(down(2, 2))["tied"].tolist() == [True]  # on the edge of both
    on_the_face = np.array([[1, 3, 0, 0, 0, -1]], float)
    assert scene.occluded(on_the_face, en=hits["element"]).tolist() == [False]


@pytest.mark.parametrize("points", [POINTS, POINTS.astype(np.float32), np.asfortranarray(POINTS), POINTS[::-1][::-1]])
@pytest.mark.parametrize("kind", [np.int64, np.int32, np.uint32, np.uint8])
def test_arrays_of_every_layout_give_the_same_scene(points: npt.NDArray[np.float64], kind: type) -> None:
    scene = durero.Scene()
    scene.add_mesh("m", points, FACES.astype(kind))
    assert scene == square()


def test_a_scene_file_keeps_meshes_and_their_looks() -> None:
    text = '{"format":"durero-scene","version":1,"materials":{"red":{"color":[1,0,0]}},"elementos":[]}'
    scene = durero.Scene.loads(text)
    normals = np.array([[0, 0, 1], [0, 1, 1], [1, 0, 1], [0, 0, 2]], float)
    uv = np.array([[0, 0], [1, 0], [1, 1], [0, 0.1]])
    scene.add_mesh("m", POINTS, FACES, normals=normals, uv=uv, material="red")
    read = durero.Scene.loads(scene.dumps())
    assert read == scene
    found = read.meshes["m"]
    assert found.vertices.tolist() == POINTS.tolist()
    assert found.faces.tolist() == FACES.tolist()
    assert found.normals is not None and found.normals.tolist() == normals.tolist()
    assert found.uv is not None and found.uv.tolist() == uv.tolist()
    assert found.material == "red"
    assert read["m:0"].material == "red"
    again = durero.Scene.loads(text)
    again.add_mesh("m", *found[:2], normals=found.normals, uv=found.uv, material=found.material)
    assert again == scene


def test_meshes_of_other_libraries_are_taken_by_their_arrays() -> None:
    for of in (types.SimpleNamespace(vertices=POINTS, faces=FACES), types.SimpleNamespace(vertices=POINTS, triangles=FACES)):
        scene = durero.Scene()
        scene.add_mesh("m", of)
        assert scene == square()
    with pytest.raises(TypeError, match="without faces; expected arrays, or a mesh that has both"):
        durero.Scene().add_mesh("m", POINTS)


def test_a_mesh_is_edited_under_contract() -> None:
    scene = square()
    assert scene.move_vertex("m", 2, (4, 4, 1)) == "vertice_movido"
    assert scene["m:0"] == durero.Triangulo(vertices=((0, 0, 0), (4, 0, 0), (4, 4, 1)))
    assert scene.move_vertex("m", 2, point=(4, 4, 2)) == "vertice_movido"
    assert scene.replace_mesh("m", POINTS, FACES[:1]) == "malla_reemplazada"
    assert scene.names == ("m:0",)
    assert scene.remove_mesh("m") == "malla_eliminada"
    assert len(scene) == 0


def test_what_the_text_refuses_changes_nothing() -> None:
    scene = square()
    scene.add("x:1", durero.Esfera(centro=(0, 0, 0), radio=1))
    before = scene.dumps()
    edits: dict[str, Callable[[], object]] = {
        "Agregar_Malla.pre.1": lambda: scene.add_mesh("m", POINTS, FACES),
        "Agregar_Malla.pre.2": lambda: scene.add_mesh("x", POINTS, FACES + 1),
        "Agregar_Malla.pre.3": lambda: scene.add_mesh("x", POINTS, np.array([[0, 1, 1]])),
        "Agregar_Malla.pre.4": lambda: scene.add_mesh("y" * 127, POINTS, FACES),
        "Agregar_Malla.pre.5": lambda: scene.add_mesh("x", POINTS, FACES),
        "Reemplazar_Malla.pre.1": lambda: scene.replace_mesh("x", POINTS, FACES),
        "Eliminar_Malla.pre.1": lambda: scene.remove_mesh("x"),
        "Mover_Vertice.pre.2": lambda: scene.move_vertex("m", 4, (0, 0, 0)),
        "Mover_Vertice.pre.3": lambda: scene.move_vertex("m", 2, (8, 0, 0)),
        "Fuera_De_Malla.pre.1": lambda: scene.remove("m:0"),
        "Agregar_Elemento.pre.1": lambda: scene.add("m:1", durero.Esfera(centro=(0, 0, 0), radio=1)),
    }
    for label, edit in edits.items():
        with pytest.raises(durero.Refused) as caught:
            edit()
        assert caught.value.label == label
        assert scene.dumps() == before


@pytest.mark.parametrize(
    ("vertices", "faces", "kind", "message"),
    [
        (POINTS.tolist(), FACES, TypeError, "vertices is no array"),
        (POINTS.astype(int), FACES, TypeError, "vertices has another dtype"),
        (POINTS.astype(np.float16), FACES, TypeError, "vertices has another dtype"),
        (POINTS.astype(">f8"), FACES, TypeError, "vertices has another dtype"),
        (POINTS[:, :2], FACES, ValueError, "vertices has another shape"),
        (POINTS - [np.inf, 0, 0], FACES, ValueError, r"vertices\[0, 0\] is -inf; expected a finite number"),
        (POINTS, FACES.astype(float), TypeError, "faces has another dtype"),
        (POINTS, FACES[0], ValueError, "faces has another shape"),
        (POINTS, -FACES, ValueError, r"faces\[0, 1\] is -1; expected the number of a vertex, from 0"),
        (POINTS, FACES + 2**32, ValueError, r"faces\[0, 0\] is 4294967296; expected"),
    ],
)
def test_arrays_that_are_no_mesh_are_refused_by_place(vertices: object, faces: object, kind: type, message: str) -> None:
    with pytest.raises(kind, match=message):
        durero.Scene().add_mesh("m", vertices, faces)


def test_names_and_looks_that_are_none_are_refused() -> None:
    scene = durero.Scene()
    with pytest.raises(ValueError, match="a b is no name"):
        scene.add_mesh("a b", POINTS, FACES)
    with pytest.raises(ValueError, match="no material red"):
        scene.add_mesh("m", POINTS, FACES, material="red")
    with pytest.raises(ValueError, match="looks at all of its points, or none"):
        scene.add_mesh("m", POINTS, FACES, normals=POINTS[:2] + 1.0)
    with pytest.raises(KeyError):
        scene.meshes["m"]
    assert len(scene) == 0
