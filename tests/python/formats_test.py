"""Scenes in other programs' formats: read and written as the program does."""
from __future__ import annotations

import pathlib

import numpy as np
import pytest
from support import ROOT, STILL_LIFE, run

import durero

SOLID = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"


@pytest.mark.parametrize("triangles", [None, "mesh", "single"])
def test_a_file_is_read_as_by_the_program(triangles: object, tmp_path: pathlib.Path) -> None:
    (tmp_path / "solid.obj").write_text(SOLID + "l 1 2\n")
    choice = [] if triangles is None else ["--triangles", triangles]
    run("import", tmp_path / "solid.obj", "-o", tmp_path / "program.json", *choice)
    scene, lost = durero.Scene.import_file(tmp_path / "solid.obj", triangles=triangles)  # type: ignore[arg-type]
    assert scene.dumps() == (tmp_path / "program.json").read_text()
    assert lost == ("1 other statement left out: no vertex, no face",)


@pytest.mark.parametrize("ending", ["nff", "pov", "ply"])
def test_a_scene_is_written_as_by_the_program(ending: str, tmp_path: pathlib.Path) -> None:
    lost = durero.Scene.load(STILL_LIFE).export_file(tmp_path / f"python.{ending}")
    run("export", STILL_LIFE, "-o", tmp_path / f"program.{ending}")
    assert (tmp_path / f"python.{ending}").read_bytes() == (tmp_path / f"program.{ending}").read_bytes()
    assert lost


def test_bytes_are_written_and_read(tmp_path: pathlib.Path) -> None:
    (tmp_path / "solid.obj").write_text(SOLID)
    scene = durero.Scene.import_file(tmp_path / "solid.obj").scene
    scene.export_file(tmp_path / "solid.stl", binary=True)
    assert (tmp_path / "solid.stl").stat().st_size == 84 + 4 * 50
    assert len(durero.Scene.import_file(tmp_path / "solid.stl").scene) == 4


def test_a_root_bounds_the_files_that_a_text_names(tmp_path: pathlib.Path) -> None:
    (tmp_path / "room").mkdir()
    (tmp_path / "size.inc").write_text("#declare R = 2;")
    (tmp_path / "room" / "ball.pov").write_text('#include "../size.inc" sphere { 0, R }')
    with pytest.raises(durero.InputError, match="no file"):
        durero.Scene.import_file(tmp_path / "room" / "ball.pov")
    scene, lost = durero.Scene.import_file(tmp_path / "room" / "ball.pov", root=tmp_path)
    assert scene["s1"] == durero.Esfera(centro=(0, 0, 0), radio=2)
    assert lost == ("1 object without a texture: of no material, where POV-Ray's is black",)
    with pytest.raises(OSError, match="lies elsewhere"):
        durero.Scene.import_file(tmp_path / "room" / "ball.pov", root=ROOT)


def test_surfaces_of_povray_come_in_by_a_text(tmp_path: pathlib.Path) -> None:
    text = ROOT / "demo/surfaces/algebraic.tex"
    file = tmp_path / "ring.pov"
    file.write_text("torus { 2, 0.5 pigment { rgb 1 } } sphere { 0, 1 pigment { rgb 1 } }\n#version 3.7;")
    scene, lost = durero.Scene.import_file(file, surfaces=text)
    assert lost == () and len(scene) == 2 and scene.surfaces == str(text)
    hits = scene.trace(np.array([[0.0, 0, 9, 0, 0, -1]]))
    assert hits["t"].tolist() == [6.5]
    assert "toro_oblicuo" in scene.dumps()
    assert len(durero.Scene.import_file(file).scene) == 1
    with pytest.raises(ValueError, match="torus.tex declares no toro_oblicuo as POV-Ray's surfaces need it"):
        durero.Scene.import_file(file, surfaces=ROOT / "demo/surfaces/torus.tex")
    file.write_text("torus { 2, 0 }")
    with pytest.raises(durero.InputError, match="a1 is not in the domain of puntos_toro_oblicuo"):
        durero.Scene.import_file(file, surfaces=text)


def test_what_cannot_be_done_is_said(tmp_path: pathlib.Path) -> None:
    scene = durero.Scene()
    with pytest.raises(OSError, match="expected one that ends in"):
        scene.export_file(tmp_path / "scene.step")
    with pytest.raises(OSError, match="no format with a binary form"):
        scene.export_file(tmp_path / "scene.nff", binary=True)
    with pytest.raises(OSError, match="No such file"):
        durero.Scene.import_file(tmp_path / "none.obj")
    with pytest.raises(ValueError, match="expected 'mesh' or 'single'"):
        durero.Scene.import_file(tmp_path / "none.obj", triangles="both")  # type: ignore[arg-type]
    torus = durero.Scene.load(ROOT / "demo/surfaces/torus.json", surfaces=ROOT / "demo/surfaces/torus.tex")
    with pytest.raises(ValueError, match="export_file"):
        torus.export_file(tmp_path / "torus.pov")
