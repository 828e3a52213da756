"""Changes, undo and redo, transactions and callbacks: every step leads back to the text that the scene had before it."""
from __future__ import annotations

import copy
from collections.abc import Callable

import numpy as np
import pytest

import durero


def two_spheres() -> durero.Scene:
    scene = durero.Scene.loads(
        '{"format":"durero-scene","version":1,"materials":{"red":{"color":[1,0,0]}},"elementos":['
        '{"id":"a","tipo":"esfera","centro":[0,0,5],"radio":1},{"id":"b","tipo":"esfera","centro":[0,0,9],"radio":1}],'
        '"groups":{"pair":{"elementos":["a"]}}}'
    )
    assert scene.history == ()
    return scene


def test_a_change_keeps_the_element_in_its_group() -> None:
    scene = two_spheres()
    assert scene.change("a", radio=np.float64(2), centro=np.array([1, 2, 3])) == "elemento_cambiado"
    assert scene["a"] == durero.Esfera(centro=(1, 2, 3), radio=2)
    assert scene.groups["pair"].elementos == ("a",)
    assert scene.change("a", radius=3, center=(0, 0, 0)) == "elemento_cambiado"
    assert scene["a"] == durero.Esfera(centro=(0, 0, 0), radio=3)
    assert scene.set_material("a", "red") == scene.set_group("b", "pair") == "elemento_cambiado"
    assert scene["a"].material == "red"
    assert scene.groups["pair"].elementos == ("a", "b")
    assert scene.set_material("a", None) == scene.set_group("b", None) == "elemento_cambiado"
    assert scene["a"].material is None
    assert scene.groups["pair"].elementos == ("a",)


def test_a_change_is_whole_or_refused() -> None:
    scene = two_spheres()
    before = scene.dumps()
    with pytest.raises(durero.Refused) as refused:
        scene.change("a", centro=(9, 9, 9), radio=0)
    assert (refused.value.label, refused.value.r) == ("Cambiar_Radio.pre.2", "radio_no_positivo")
    assert refused.value.values == {"e": "a", "radio": 0.0}
    with pytest.raises(durero.Refused) as refused:
        scene.change("a", altura=1)
    assert refused.value.label == "Cambiar_Altura.pre.1"
    with pytest.raises(durero.Refused) as refused:
        scene.set_material("a", "green")
    assert refused.value.label == "Cambiar_Material.pre.2"
    with pytest.raises(durero.Refused) as refused:
        scene.set_group("nobody", "pair")
    assert refused.value.label == "Cambiar_Grupo.pre.1"
    with pytest.raises(ValueError, match="names no attribute"):
        scene.change("a")
    with pytest.raises(TypeError):
        scene.change(3, radio=1)  # type: ignore[call-overload]
    assert scene.dumps() == before
    assert scene.history == ()


def test_each_step_is_undone_and_done_again() -> None:
    scene = two_spheres()
    texts = [scene.dumps()]
    square = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], float)
    faces = np.array([[0, 1, 2], [0, 2, 3]])
    edits: list[Callable[[], object]] = [
        lambda: scene.change("a", radio=4, centro=(1, 1, 1)),
        lambda: scene.remove("a"),
        lambda: scene.add("c", durero.Esfera(centro=(0, 0, 5), radio=1)),
        lambda: scene.apply_all(["Eliminar_Esfera e?=b", "Cambiar_Radio e?=c radio?=2"]),
        lambda: scene.add_mesh("square", square, faces, uv=square[:, :2]),
        lambda: scene.move_vertex("square", 2, (2, 2, 0)),
        lambda: scene.replace_mesh("square", square[:3], faces[:1]),
        lambda: scene.group("all", ["c", "square:0"]),
        lambda: scene.remove_mesh("square"),
        lambda: scene.ungroup("pair"),
    ]
    for edit in edits:
        edit()
        texts.append(scene.dumps())
    assert len(scene.history) == len(texts) - 1
    for text in reversed(texts[:-1]):
        assert scene.undo() == "deshecho"
        assert scene.dumps() == text
    with pytest.raises(durero.Refused) as refused:
        scene.undo()
    assert (refused.value.label, refused.value.predicate) == ("Deshacer.pre.1", "hechas ≠ ⟨⟩")
    for text in texts[1:]:
        assert scene.redo() == "rehecho"
        assert scene.dumps() == text
    with pytest.raises(durero.Refused) as refused:
        scene.redo()
    assert refused.value.r == "nada_que_rehacer"


def test_the_history_is_a_script() -> None:
    scene, other = two_spheres(), two_spheres()
    scene.change("a", radio=2.5, centro=(0.1, 1e300, -0.0))
    scene.set_group("b", "pair")
    scene.set_material("b", "red")
    scene.remove("a")
    for step in scene.history:
        other.apply_all(step)
    assert other.dumps() == scene.dumps()
    assert scene.history[0] == ("Cambiar_Centro e?=a centro?=(0.1,1e+300,-0)", "Cambiar_Radio e?=a radio?=2.5")


def test_a_transaction_is_one_step_or_none() -> None:
    scene = two_spheres()
    before = scene.dumps()
    with scene.transaction() as within:
        assert within is scene
        scene.remove("a")
        with pytest.raises(durero.Refused):
            scene.remove("a")
        with pytest.raises(durero.Refused):
            scene.apply_all(["Eliminar_Esfera e?=b", "Eliminar_Esfera e?=b"])
        assert "b" in scene
        with pytest.raises(RuntimeError, match="a transaction is open"):
            scene.undo()
    assert scene.history == (("Eliminar_Elemento e?=a",),)
    scene.undo()
    assert scene.dumps() == before

    with pytest.raises(durero.Refused):
        with scene.transaction():
            scene.remove("b")
            scene.remove("b")
    assert scene.dumps() == before
    with pytest.raises(KeyboardInterrupt):
        with scene.transaction():
            scene.remove("b")
            raise KeyboardInterrupt
    assert scene.dumps() == before
    assert scene.redo() == "rehecho"  # what was undone before is not forgotten


def test_callbacks_know_each_step() -> None:
    scene, told = two_spheres(), []  # type: ignore[var-annotated]
    scene.on_edit(told.append)
    scene.remove("a")
    scene.undo()
    scene.redo()
    with scene.transaction():
        scene.remove("b")
        scene.add("c", durero.Esfera(centro=(0, 0, 5), radio=1))
    with pytest.raises(durero.Refused):
        scene.remove("nobody")
    assert [step.kind for step in told] == ["done", "undone", "redone", "done"]
    assert told[1].operations == ("Eliminar_Elemento e?=a",)
    assert told[3].operations == ("Eliminar_Elemento e?=b", "Agregar_Esfera e?=c centro?=(0,0,5) radio?=1")


def test_a_copy_has_its_own_history() -> None:
    scene = two_spheres()
    scene.change("a", radio=2)
    other = copy.copy(scene)
    other.undo()
    assert other["a"] == durero.Esfera(centro=(0, 0, 5), radio=1)
    assert scene["a"] == durero.Esfera(centro=(0, 0, 5), radio=2)
    scene.undo()
    assert scene.dumps() == other.dumps()


def test_a_trace_beside_an_undo_answers_for_its_scene() -> None:
    scene = two_spheres()
    rays = np.array([[0, 0, 0, 0, 0, 1]], float)
    scene.change("a", radio=2)
    assert scene.trace(rays)["t"][0] == 3
    scene.undo()
    assert scene.trace(rays)["t"][0] == 4
    scene.redo()
    assert scene.trace(rays)["t"][0] == 3


def test_ten_thousand_steps_are_kept() -> None:
    scene = two_spheres()
    for i in range(10_002):
        scene.change("a", radio=i + 2)
    for _ in range(10_000):
        scene.undo()
    assert scene["a"] == durero.Esfera(centro=(0, 0, 5), radio=3)
    with pytest.raises(durero.Refused):
        scene.undo()
