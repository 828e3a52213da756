"""Scenes are mappings that operations edit; what is refused or malformed changes nothing, and says all that is known."""
from __future__ import annotations

import copy
import json
import pathlib
import pickle
import struct
import zlib
from collections.abc import Callable
from fractions import Fraction

import numpy as np
import numpy.typing as npt
import pytest
from support import ROOT, STILL_LIFE, run, sphere_scene

import durero

AXIS = (0.0, 0.0, 1.0)
ONE_OF_EACH: dict[str, durero.Element] = {
    "cilindro": durero.Cilindro(centro=(1, 2, 3), radio=0.1, vector=AXIS, altura=2),
    "cono": durero.Cono(centro=(1, 2, 3), proporcion=0.3, vector=AXIS, altura=2),
    "disco": durero.Disco(centro=(1, 2, 3), radio=0.1, vector=AXIS),
    "esfera": durero.Esfera(centro=(1, 2, 3), radio=0.1),
    "plano": durero.Plano(centro=(1, 2, 3), vector=AXIS),
    "triangulo": durero.Triangulo(vertices=((0, 0, 0), (1, 0, 0), (0, 0.1, 0))),
    "tronco": durero.Tronco(centro=(1, 2, 3), radio=0.1, proporcion=0.3, vector=AXIS, altura=2),
}


def test_each_element_is_added_and_read_back() -> None:
    scene = durero.Scene()
    for name, element in ONE_OF_EACH.items():
        assert scene.add(name, element).endswith(("agregado", "agregada"))
    assert dict(scene) == ONE_OF_EACH
    assert scene.names == tuple(sorted(ONE_OF_EACH))
    assert durero.Scene.loads(scene.dumps()) == scene
    for name in ONE_OF_EACH:
        assert scene.remove(name) == "elemento_eliminado"
    assert len(scene) == 0 and scene == durero.Scene()


def test_groups_are_kept_and_edited_as_the_program_does(tmp_path: pathlib.Path) -> None:
    path = ROOT / "demo" / "groups.json"
    scene = durero.Scene.load(path)
    assert durero.Scene.loads(scene.dumps()).groups == scene.groups and scene.groups
    scene.save(tmp_path / "python.json")
    run("import", path, "-o", tmp_path / "program.json")
    assert (tmp_path / "python.json").read_bytes() == (tmp_path / "program.json").read_bytes()
    for name in list(scene.groups):
        assert scene.ungroup(name) == "ungrouped"
    assert scene.groups == {}
    one, other, *_ = scene.names
    assert scene.group("pair", [other, one]) == "grouped"
    assert scene.group("outer", groups=["pair"]) == "grouped"
    assert scene.groups == {"outer": ((), ("pair",)), "pair": ((one, other), ())}
    element = scene[one]
    assert scene.remove(one) == "elemento_eliminado"
    assert scene.add(one, element).left_group == "pair" and scene.groups["pair"].elementos == (other,)
    answers = scene.apply_all([f"Eliminar_Elemento e?={other}", f"Eliminar_Elemento e?={one}"])
    assert [answer.left_group for answer in answers] == ["pair", None]
    scene = durero.Scene.load(path)
    for name in list(scene.groups):
        assert scene.ungroup(name).left_group is None
    assert scene.group("pair", [other, one]) == scene.group("outer", groups=["pair"]) == "grouped"
    before = copy.copy(scene)
    with pytest.raises(durero.Refused) as refused:
        scene.group("again", [one])
    assert refused.value.label == "group.pre.4" and refused.value.r == "element_in_a_group"
    assert refused.value.operation == "group"
    assert refused.value.values == {"g": "again", "elementos": [one], "groups": []}
    with pytest.raises(durero.Refused):
        scene.apply_all(["ungroup g?=outer", "ungroup g?=outer"])
    assert scene == before
    scene.remove(one)
    assert scene.groups["pair"].elementos == (other,) and before.groups["pair"].elementos == (one, other)
    with pytest.raises(TypeError):
        scene.ungroup(3)  # type: ignore[arg-type]


def test_engines_that_follow_groups_search_by_them() -> None:
    scene = durero.Scene.load(ROOT / "demo" / "groups.json")
    rays = np.array([[0, 0, -50, x / 8, y / 8, 9] for x in range(-8, 9) for y in range(-8, 9)], float)
    asks: tuple[Callable[..., npt.NDArray[np.generic]], ...] = (scene.trace, scene.occluded, scene.occluded_segment)
    for ask in asks:
        answers = ask(rays, "bvh", hierarchy="hand")
        assert answers.tobytes() == ask(rays, "bvh").tobytes() == ask(rays).tobytes()
        with pytest.raises(ValueError, match="hierarchy hand: fast follows no groups; expected engine bvh"):
            ask(rays, hierarchy="hand")
        with pytest.raises(ValueError, match="expected automatic or hand"):
            ask(rays, "bvh", hierarchy="none")
    assert (scene.trace(rays)["element"] >= 0).any()
    all_of_ties = scene.trace(rays, "bvh", elements="all", hierarchy="hand")
    assert all_of_ties.hits.tobytes() == scene.trace(rays).tobytes()
    scene.ungroup(next(name for name in scene.groups if all(name not in of.groups for of in scene.groups.values())))
    assert scene.trace(rays, "bvh", hierarchy="hand").tobytes() == scene.trace(rays).tobytes()


def test_a_file_is_read_and_written_as_the_program_does(tmp_path: pathlib.Path) -> None:
    scene = durero.Scene.load(STILL_LIFE)
    assert {"apple", "table"} <= set(scene) and "apple" in scene and "moon" not in scene and 3 not in scene.keys()  # type: ignore[comparison-overlap]
    elements = {element["id"]: element for element in json.loads(STILL_LIFE.read_text())["elementos"]}
    assert set(elements) == set(scene.names)
    for name, element in scene.items():
        assert elements[name]["tipo"] == element.tipo and elements[name].get("material") == element.material
    operation = "Agregar_Esfera e?=moon centro?=(0,3,4) radio?=0.5 material=pearl"
    assert scene.apply(operation) == "esfera_agregada"
    scene.save(tmp_path / "python.json")
    run("edit", STILL_LIFE, "--op", operation, "-o", tmp_path / "program.json")
    assert (tmp_path / "python.json").read_bytes() == (tmp_path / "program.json").read_bytes()
    with pytest.raises(OSError):
        scene.save(tmp_path / "none" / "scene.json")
    with pytest.raises(FileNotFoundError):
        durero.Scene.load(tmp_path / "none.json")


def test_a_refused_edit_says_why_and_leaves_the_scene() -> None:
    scene = sphere_scene()
    before = scene.dumps()
    with pytest.raises(durero.Refused) as caught:
        scene.add("s1", durero.Esfera(centro=(0, 0, 0), radio=2))
    refused = caught.value
    assert (refused.label, refused.predicate) == ("Agregar_Elemento.pre.1", "e? ∉ elementos")
    assert (refused.r, refused.operation, refused.line) == ("elemento_ya_existe", "Agregar_Esfera", 1)
    assert refused.values == {"e": "s1", "centro": (0.0, 0.0, 0.0), "radio": 2.0}
    assert "Agregar_Elemento.pre.1: e? ∉ elementos" in str(refused)
    assert pickle.loads(pickle.dumps(refused)).values == refused.values
    for operation, label in {
        "Agregar_Esfera e?=b centro?=(0,0,0) radio?=-1": "Agregar_Esfera.pre.2",
        "Agregar_Plano e?=b centro?=(0,0,0) vector?=(0,0,2)": "Agregar_Plano.pre.2",
        "Agregar_Elemento e?=b t?=soy_esfera centro?=(0,0,0) radio?=0": "Agregar_Esfera.pre.2",
        "Eliminar_Cono e?=s1": "Eliminar_Cono.pre.1",
        "Eliminar_Elemento e?=b": "Eliminar_Elemento.pre.1",
    }.items():
        with pytest.raises(durero.Refused) as caught:
            scene.apply(operation)
        assert caught.value.label == label and caught.value.operation == operation.split()[0]
    assert scene.dumps() == before


def test_a_script_is_carried_out_whole_or_not_at_all() -> None:
    scene = sphere_scene()
    before = scene.dumps()
    with pytest.raises(durero.Refused) as refused:
        scene.apply_all(["Eliminar_Esfera e?=s1", "# nothing", "Eliminar_Esfera e?=s1"])
    assert refused.value.line == 3 and scene.dumps() == before
    with pytest.raises(durero.InputError) as malformed:
        scene.apply_all("Eliminar_Esfera e?=s1\nAgregar_Esfra e?=a\n")
    assert (malformed.value.file, malformed.value.line, malformed.value.column) == ("operations", 2, 1)
    assert scene.dumps() == before
    assert scene.apply_all([]) == [] and scene.apply_all("# nothing") == []
    answers = scene.apply_all(["Eliminar_Esfera e?=s1", "Agregar_Esfera e?=s1 centro?=(0,0,1) radio?=0x1p-1"])
    assert answers == ["esfera_eliminada", "esfera_agregada"] and scene["s1"] == durero.Esfera((0, 0, 1), 0.5)


def test_malformed_input_has_its_place() -> None:
    with pytest.raises(durero.InputError) as caught:
        durero.Scene.loads('{"format":"durero-scene","version":1,\n"elementos":[{"id":"a b"}]}', "mine.json")
    error = caught.value
    assert (error.file, error.line) == ("mine.json", 2) and str(error).startswith(f"mine.json:2:{error.column}: ")
    assert isinstance(error, ValueError) and pickle.loads(pickle.dumps(error)).column == error.column
    with pytest.raises(durero.InputError):
        durero.Scene().add("no name", durero.Esfera((0, 0, 0), 1))
    with pytest.raises(durero.InputError):
        durero.Scene().add("a", durero.Esfera((0, 0, 0), 1, material="gold"))
    for blank in ("", "  # nothing"):
        with pytest.raises(ValueError, match="blank"):
            durero.Scene().apply(blank)
    with pytest.raises(ValueError, match="more than one line"):
        durero.Scene().apply("Eliminar_Esfera e?=a\nEliminar_Esfera e?=b")
    with pytest.raises(KeyError):
        durero.Scene()["s1"]


def test_no_number_is_changed_on_the_way() -> None:
    with pytest.raises(ValueError, match="no binary64"):
        durero.Esfera((0, 0, 0), Fraction(1, 3))  # type: ignore[call-overload]
    with pytest.raises(ValueError, match="no binary64"):
        durero.Esfera((0, 0, 2**53 + 1), 1)
    with pytest.raises(ValueError, match=r"centro\[1\] \(center\) is nan; expected a finite number"):
        durero.Esfera((0, float("nan"), 0), 1)
    with pytest.raises(TypeError, match=r"radio \(radius\) is '1'; expected a number"):
        durero.Esfera((0, 0, 0), "1")  # type: ignore[call-overload]
    with pytest.raises(ValueError, match=r"centro \(center\) has 2 numbers; expected three"):
        durero.Esfera((0, 0), 1)  # type: ignore[arg-type]
    assert durero.Esfera(np.array([0, 0, 0.1]), np.float32(0.5)) == durero.Esfera((0, 0, 0.1), 0.5)  # type: ignore[call-overload]
    scene = durero.Scene()
    scene.add("tiny", durero.Esfera((5e-324, 1.7976931348623157e308, 0.1), 5e-324))
    assert scene["tiny"] == durero.Esfera((5e-324, 1.7976931348623157e308, 0.1), 5e-324)


def test_copies_and_pickles_are_equal_and_apart() -> None:
    scene = durero.Scene.load(STILL_LIFE)
    for other in (copy.copy(scene), copy.deepcopy(scene), pickle.loads(pickle.dumps(scene))):
        assert other == scene
        other.remove("apple")
        assert other != scene and "apple" in scene
    with pytest.raises(TypeError):
        hash(scene)


def test_a_picture_is_that_of_the_program(tmp_path: pathlib.Path) -> None:
    scene = durero.Scene.load(STILL_LIFE)
    picture = scene.render(size=(64, 36))
    assert picture.shape == (36, 64, 3) and picture.dtype == np.uint8 and len(np.unique(picture)) > 50
    smaller = json.loads(STILL_LIFE.read_text())
    smaller["resolution"] = [64, 36]
    assert np.array_equal(durero.Scene.loads(json.dumps(smaller)).render(), picture)
    assert np.array_equal(scene.render((64, 36), engine="exact"), picture)
    with pytest.raises(ValueError, match="camera"):
        sphere_scene().render()
    with pytest.raises(ValueError, match="sampled: shadow rays start on elements"):
        scene.render(engine="sampled")
    (tmp_path / "smaller.json").write_text(json.dumps(smaller))
    run("render", tmp_path / "smaller.json", "-o", tmp_path / "picture.png")
    assert np.array_equal(pixels_of(tmp_path / "picture.png", 64), picture)


def pixels_of(path: pathlib.Path, width: int) -> npt.NDArray[np.uint8]:
    """The pixels of a PNG file of 8-bit RGB."""
    data, at, packed = path.read_bytes(), 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at : at + 8])
        packed += data[at + 8 : at + 8 + length] if kind == b"IDAT" else b""
        at += 12 + length
    return unfiltered(np.frombuffer(zlib.decompress(packed), np.uint8).reshape(-1, 1 + 3 * width))


def unfiltered(rows: npt.NDArray[np.uint8]) -> npt.NDArray[np.uint8]:
    """PNG's five filters undone, a row at a time."""
    out = np.zeros((len(rows), rows.shape[1] - 1), np.uint8)
    for y, row in enumerate(rows):
        above = out[y - 1] if y else np.zeros_like(out[0])
        for x, byte in enumerate(row[1:]):
            left, up = (int(out[y, x - 3]) if x >= 3 else 0), int(above[x])
            corner = int(above[x - 3]) if x >= 3 else 0
            nearest = min((left, up, corner), key=lambda value: abs(left + up - corner - value))
            predicted = (0, left, up, (left + up) // 2, nearest)[int(row[0])]
            out[y, x] = (int(byte) + predicted) % 256
    return out.reshape(len(rows), -1, 3)


def test_the_repository_has_one_version() -> None:
    assert f"project(durero VERSION {durero.__version__} " in (ROOT / "CMakeLists.txt").read_text()


SURFACES = ROOT / "demo" / "surfaces"
TORUS = SURFACES / "torus.tex"


def torus_scene() -> durero.Scene:
    return durero.Scene.load(SURFACES / "torus.json", surfaces=TORUS)


def test_a_text_says_what_elements_are() -> None:
    scene = torus_scene()
    assert scene.surfaces == str(TORUS) and durero.Scene().surfaces is None
    ring = scene["ring"]
    assert ring == durero.Written("toro", {"centro": (0.0, 0.0, 0.0), "mayor": 2.0, "menor": 0.75}, "brass")
    assert isinstance(scene["ball"], durero.Esfera)
    rays = np.array([[-5, 0, 0, 1, 0, 0], [0, 9, 0, 0, 1, 0]], float)
    hits = scene.trace(rays)
    assert hits["t"][0] == 2.25 and scene.names[hits["element"][0]] == "ring"
    assert scene.occluded(rays).tolist() == [True, False]
    start = np.array([[-2.75, 0, 0, 1, 0, 0]], float)
    on_ring = np.array([scene.names.index("ring")])
    assert scene.trace(start, en=on_ring)["t"][0] == 1.5
    assert scene.render((12, 8)).shape == (8, 12, 3)


def test_edits_are_held_against_the_text() -> None:
    scene = torus_scene()
    before = scene.dumps()
    with pytest.raises(durero.Refused) as refused:
        scene.add("wide", durero.Written("toro", {"centro": (0, 0, 0), "mayor": 1, "menor": 2}))
    assert (refused.value.label, refused.value.predicate) == ("puntos_toro.dom", "menor < mayor")
    assert (refused.value.r, refused.value.operation) == ("not_in_domain", "Agregar_Toro")
    assert refused.value.values == {"e": "wide", "centro": (0, 0, 0), "mayor": 1, "menor": 2}
    with pytest.raises(durero.Refused) as refused:
        scene.apply("Eliminar_Toro e?=ball")
    assert (refused.value.label, refused.value.operation) == ("Eliminar_Toro.pre.1", "Eliminar_Toro")
    with pytest.raises(durero.Refused):
        scene.apply_all(["Eliminar_Toro e?=ring", "Eliminar_Toro e?=ring"])
    assert scene.dumps() == before
    rays = np.array([[-5, 0, 0, 1, 0, 0]], float)
    assert scene.trace(rays)["t"][0] == 2.25
    red = durero.Written("toro", {"centro": (0, 0, 0), "mayor": 3, "menor": 0.5}, "brass")
    assert scene.add("outer", red) == "elemento_agregado"
    assert scene["outer"] == red
    assert scene.trace(rays)["t"][0] == 1.5
    assert scene.remove("outer") == "elemento_eliminado"
    assert scene.dumps() == before and durero.Scene.loads(before, surfaces=TORUS).dumps() == before


def test_copies_and_pickles_keep_the_text() -> None:
    scene = torus_scene()
    other = copy.copy(scene)
    other.remove("ring")
    assert "ring" in scene and "ring" not in other
    again = pickle.loads(pickle.dumps(scene))
    assert again == scene and again.surfaces == scene.surfaces


def test_what_knows_the_types_of_the_specification_alone_refuses_a_text() -> None:
    scene = torus_scene()
    ray = (0, 0, 0, 1, 0, 0)
    by_a_text = "the scene was read by .*torus.tex"
    with pytest.raises(ValueError, match=by_a_text):
        scene.exact(ray)
    with pytest.raises(ValueError, match=by_a_text):
        durero.spec.eval("#elementos", scene)
    with pytest.raises(ValueError, match=by_a_text):
        durero.conform.explain(scene, ray)
    with pytest.raises(ValueError, match=by_a_text):
        scene.trace(np.array([ray], float), "exact")
    with pytest.raises(ValueError, match=by_a_text):
        scene.trace(np.array([ray], float), hierarchy="hand")
    with pytest.raises(durero.InputError, match='tipo .type. is "toro"'):
        durero.Scene.load(SURFACES / "torus.json")
    with pytest.raises(OSError):
        durero.Scene.load(SURFACES / "torus.json", surfaces="none.tex")
