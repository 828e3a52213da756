"""English stands beside the Spanish names: classes, arguments, properties, docstrings and messages, by the program's table."""
from __future__ import annotations

import copy
import dataclasses
import inspect
import pickle
from typing import Any

import numpy as np
import pytest
from support import along_z, run, sphere_scene

import durero
from durero import _durero
from durero.elements import TYPES
from durero.english import english, meaning, with_english

SHAPES: dict[str, tuple[str, dict[str, Any]]] = {
    "Sphere": ("Esfera", {"center": (0, 0, 5), "radius": 1}),
    "Cylinder": ("Cilindro", {"center": (0, 0, 5), "radius": 1, "vector": (0, 1, 0), "height": 2}),
    "Cone": ("Cono", {"center": (0, 0, 5), "proportion": 1, "vector": (0, 1, 0), "height": 2}),
    "TruncatedCone": ("Tronco", {"center": (0, 0, 5), "radius": 1, "proportion": 1, "vector": (0, 1, 0), "height": 2}),
    "Plane": ("Plano", {"center": (0, 0, 5), "vector": (0, 1, 0)}),
    "Disc": ("Disco", {"center": (0, 0, 5), "radius": 1, "vector": (0, 1, 0)}),
    "Triangle": ("Triangulo", {"vertices": ((0, 0, 5), (1, 0, 5), (0, 1, 5))}),
}


def test_the_table_is_that_of_the_program() -> None:
    rows = {name: (word, said) for name, word, said in _durero.spanish_names()}
    assert rows["radio"][0] == "radius" and rows["elementos!"][0] == "elements"
    for name, (word, said) in rows.items():
        assert english(name) == word and meaning(name) == said
    for name in list(rows)[::20]:
        assert rows[name][1] in run("help", name)
    assert english("nadie") == "nadie" and meaning("nadie") == "" and with_english("nadie") == "nadie"


def test_each_class_has_its_english_name() -> None:
    assert {english(kind.__name__) for kind in TYPES.values()} == set(SHAPES)
    for name, (spanish, _) in SHAPES.items():
        assert getattr(durero, name) is getattr(durero, spanish) is getattr(durero.elements, name)
        assert {name, spanish} <= set(durero.__all__)
    assert durero.Outcome is durero.Resultado and english("Resultado") == "Outcome"


@pytest.mark.parametrize("name", SHAPES)
def test_arguments_and_properties_have_english_names(name: str) -> None:
    spanish, given = SHAPES[name]
    kind = getattr(durero, name)
    made = kind(**given)
    fields = [field.name for field in dataclasses.fields(made)]
    assert made == getattr(durero, spanish)(*given.values()) == kind(**{field: getattr(made, field) for field in fields})
    assert repr(made).startswith(f"{spanish}(") and made.type == made.tipo == kind.type
    for field in fields:
        assert getattr(made, english(field)) == getattr(made, field)
        if english(field) != field:
            with pytest.raises(AttributeError):
                setattr(made, english(field), 1)
    assert pickle.loads(pickle.dumps(made)) == copy.deepcopy(made) == made
    scene = durero.Scene()
    scene.add("a", made)
    assert scene["a"] == made
    told = inspect.getdoc(kind)
    assert told is not None and f"In English: durero.{name} is this class" in told
    for word in given:
        assert word in told or word in fields


def test_both_names_and_unknown_ones_are_refused() -> None:
    sphere: Any = durero.Sphere
    with pytest.raises(TypeError, match="Esfera has both centro and center, which is its English; expected one of them"):
        sphere(centro=(0, 0, 5), center=(0, 0, 5), radius=1)
    with pytest.raises(TypeError, match="Esfera has both radio and radius"):
        sphere(center=(0, 0, 5), radius=1, radio=1)
    with pytest.raises(TypeError, match=r"no argument colour; expected one of centro \(center\), radio \(radius\), material"):
        sphere(center=(0, 0, 5), radius=1, colour="red")
    with pytest.raises(TypeError, match="multiple values for argument 'centro'"):
        sphere((0, 0, 5), 1, center=(0, 0, 5))
    with pytest.raises(TypeError, match="radio"):
        sphere(center=(0, 0, 5))
    with pytest.raises(TypeError, match="no argument height"):
        sphere(center=(0, 0, 5), radius=1, height=1)
    scene: Any = sphere_scene()
    with pytest.raises(TypeError, match="Scene.trace has both en and on"):
        scene.trace(along_z(), en=None, on=None)
    with pytest.raises(TypeError, match="Scene.group has no argument element; expected one of g, elementos"):
        scene.group("all", element=["s1"])


def test_functions_take_english_names() -> None:
    scene = sphere_scene()
    on = np.array([0], np.int32)
    assert scene.trace(along_z(), on=on).tobytes() == scene.trace(along_z(), en=on).tobytes()
    assert scene.occluded(along_z(), on=on).tolist() == scene.occluded(along_z(), en=on).tolist()
    assert scene.occluded_segment(along_z(), on=on).tolist() == scene.occluded_segment(along_z(), en=on).tolist()
    ray = (0, 0, 3.5, 0, 0, 1)
    assert scene.exact(ray, on=["s1"]) == scene.exact(ray, en=["s1"]) != scene.exact(ray)
    scene.group("all", elements=["s1"])
    assert scene.groups["all"].elements == scene.groups["all"].elementos == ("s1",)
    assert durero.conform.Profile(types=["esfera"]) == durero.conform.Profile(tipos=["esfera"])
    assert durero.conform.Profile(types=["esfera"]).types == ["esfera"]
    assert durero.Written(type="toro", attributes={}).type == "toro"
    assert "en is on" in str(inspect.getdoc(durero.Scene.trace))


def test_messages_say_the_english() -> None:
    with pytest.raises(TypeError, match=r"^radio \(radius\) is 'x'; expected a number$"):
        durero.Sphere(center=(0, 0, 5), radius="x")  # type: ignore[call-overload]
    with pytest.raises(ValueError, match=r"^centro \(center\) has 2 numbers; expected three$"):
        durero.Sphere(center=(0, 0), radius=1)  # type: ignore[arg-type]
    with pytest.raises(durero.Refused, match=r"\(elemento_ya_existe, element_already_exists\)"):
        sphere_scene().add("s1", durero.Sphere(center=(0, 0, 5), radius=1))


def test_a_near_name_is_expected() -> None:
    with pytest.raises(AttributeError, match="has no attribute 'Disk'; expected Disc$"):
        getattr(durero, "Disk")
    with pytest.raises(AttributeError, match="has no attribute 'Torus'$"):
        getattr(durero, "Torus")
