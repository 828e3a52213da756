"""Instances and solids in Python: what is read and written, first hits as the program has them, and edits."""
from __future__ import annotations

import copy
import pathlib
import pickle
from typing import Any

import numpy as np
import pytest
from support import ROOT, random_rays, run

import durero

SCENE = """{"format":"durero-scene","version":1,"elementos":[
{"id":"back","tipo":"plano","centro":[0,0,20],"vector":[0,0,1]},
{"id":"ball","tipo":"esfera","centro":[0,0,0],"radio":1},
{"id":"egg","tipo":"instancia","de":"ball","mapa":[[2,0,0,9],[0,1,0,0],[0,0,"1/2",0]]},
{"id":"lens","tipo":"interseccion","de":[
 {"tipo":"esfera","centro":[0,0,-3],"radio":5},{"tipo":"esfera","centro":[0,0,3],"radio":5}]}]}"""
ALONG_Z = np.array([[x, 0, z, 0, 0, 1] for x, z in ((0, -9), (0, 1.5), (9, -9), (10.5, -9), (5, -9))], np.float64)


def scene_of(text: str = SCENE) -> durero.Scene:
    return durero.Scene.loads(text)


def test_they_are_read_compared_and_written_back(tmp_path: pathlib.Path) -> None:
    scene = scene_of()
    assert scene.names == ("back", "ball", "egg", "lens")
    lens, egg = scene["lens"], scene["egg"]
    assert isinstance(lens, durero.Written) and lens.tipo == "interseccion"
    parts: Any = lens.attributes["de"]
    assert [part["radio"] for part in parts] == [5, 5]
    assert isinstance(egg, durero.Written) and egg.tipo == "instancia"
    for same in (scene_of(scene.dumps()), copy.deepcopy(scene), pickle.loads(pickle.dumps(scene))):
        assert same == scene
        assert same.trace(ALONG_Z).tobytes() == scene.trace(ALONG_Z).tobytes()
    assert scene_of(SCENE.replace('"1/2"', '"1/3"')) != scene
    scene.save(tmp_path / "python.json")
    (tmp_path / "scene.json").write_text(SCENE)
    run("import", tmp_path / "scene.json", "-o", tmp_path / "program.json")
    assert (tmp_path / "python.json").read_bytes() == (tmp_path / "program.json").read_bytes()


def test_first_hits_are_on_the_surface_of_the_whole() -> None:
    scene = scene_of()
    assert scene.remove("ball") == "elemento_eliminado"  # of which the copy is a value
    for engine in ("exact", "bvh", "fast"):
        hits = scene.trace(ALONG_Z, engine)
        assert [scene.names[e] for e in hits["element"]] == ["lens", "lens", "egg", "egg", "back"]
        assert hits["t"][:3].tolist() == [7, 0.5, 8.5]
        assert hits["point"][3].tolist() == [10.5, 0, -(7**0.5) / 8]
    assert scene.occluded(ALONG_Z).all()
    ends = np.array([[0, 0, -9, 0, 0, 7], [0, 0, -9, 0, 0, 7.5]], np.float64)
    assert scene.occluded_segment(ends).tolist() == [False, True]
    number = scene.names.index("lens")
    on_lens = np.array([[0, 0, -2, 0, 0, 1], [0, 0, -2, 0, 0, -1]], np.float64)
    starts = scene.trace(on_lens, en=(np.array([0, 1, 2]), np.array([number, number])))
    assert starts["outcome"].tolist() == [durero.Resultado.hit, durero.Resultado.miss]
    assert starts["t"][0] == 4


@pytest.mark.parametrize("name", ["solids", "instances"])
def test_hits_of_the_gallery_are_those_of_the_program(name: str, tmp_path: pathlib.Path) -> None:
    path, rays = ROOT / "demo" / "gallery" / f"{name}.json", random_rays(500)
    scene = durero.Scene.load(path)
    np.save(tmp_path / "rays.npy", rays)
    run("trace", path, tmp_path / "rays.npy", "-o", tmp_path / "hits.npy")
    expected, hits = np.load(tmp_path / "hits.npy"), scene.trace(rays)
    assert hits["t"].tobytes() == expected["t"].tobytes()
    assert hits["point"].tobytes() == expected["point"].tobytes()
    assert 0 < np.count_nonzero(hits["outcome"] == durero.Resultado.hit)


def test_solids_are_edited_and_what_is_refused_changes_nothing() -> None:
    scene = scene_of()
    assert scene.apply("Agregar_Diferencia e?=rest de?=lens,ball") == "solido_agregado"
    within = np.array([[0, 0, 0, 0, 0, 1]], np.float64)
    hits, _, elements = scene.trace(within, elements="all")
    assert hits["t"][0] == 1 and [scene.names[e] for e in elements] == ["ball", "rest"]
    before = scene.dumps()
    with pytest.raises(durero.Refused) as refused:
        scene.apply("Agregar_Union e?=rest de?=lens,ball")
    assert refused.value.r == "elemento_ya_existe"
    with pytest.raises(durero.Refused, match="Agregar_Solido.pre.2") as refused:
        scene.apply("Agregar_Union e?=both de?=lens,nobody")
    assert refused.value.r == "elemento_no_existe"
    assert scene.dumps() == before
    assert scene.remove("rest") == "elemento_eliminado"
    assert scene == scene_of()


def test_what_knows_shapes_alone_says_so() -> None:
    scene = scene_of()
    with pytest.raises(ValueError, match="distance knows the program's own shapes alone"):
        scene.distance(np.zeros((1, 3)))
    with pytest.raises(ValueError, match="exact knows the program's own shapes alone"):
        scene.exact(ALONG_Z[0])
    with pytest.raises(durero.InputError, match="do not lie in one plane|Mapa.inv.1"):
        scene_of(SCENE.replace('[0,1,0,0]', '[4,0,0,0]'))
