"""What the Z text says is what the program's `spec` says."""
from __future__ import annotations

import pathlib

import pytest
from support import ROOT, STILL_LIFE, run, sphere_scene

import durero


def test_predicates_are_true_or_false_and_expressions_have_values() -> None:
    scene = sphere_scene()
    assert durero.spec.eval("s1 ∈ elementos", scene) is True
    assert durero.spec.eval("#elementos = 2", scene) is False
    assert durero.spec.eval("mi_radio(s1) / 3", scene) == "1/3"
    assert durero.spec.eval("1 / 0") is None
    assert durero.spec.eval("1 + 2") == "3"


def test_values_are_those_of_the_program() -> None:
    scene = durero.Scene.load(STILL_LIFE)
    for expression in ("# (de_que_tipo ∼ ⦇ { soy_cono } ⦈)", "∃ e : dom mi_radio • mi_radio e * 10 < 1", "mi_radio(apple)"):
        said = run("spec", "eval", "--scene", STILL_LIFE, "--", expression).strip()
        value = durero.spec.eval(expression, scene)
        assert {"true": True, "false": False}.get(said, said) == value


def test_what_cannot_be_read_or_worked_out_is_said() -> None:
    with pytest.raises(durero.InputError) as caught:
        durero.spec.eval("1 + ")
    assert caught.value.file == "EXPR" and caught.value.line == 1
    with pytest.raises(durero.InputError):
        durero.spec.eval("s1 ∈ elementos")
    with pytest.raises(durero.Undecided):
        durero.spec.eval("∀ x : ℝ • x * x * x * x ≥ 0")


def test_texts_are_checked(tmp_path: pathlib.Path) -> None:
    assert durero.spec.check() == []
    assert durero.spec.check(*sorted((ROOT / "spec").glob("*.tex"))) == []
    wrong = tmp_path / "wrong.tex"
    wrong.write_text("\\begin{zed}\n  A == 1 \\cup 2\n\\end{zed}\n")
    (defect, *_) = durero.spec.check(wrong)
    assert (defect.file, defect.line, defect.is_warning) == (str(wrong), 2, False)
    assert str(defect).startswith(f"{wrong}:2:{defect.column}: ")
    with pytest.raises(FileNotFoundError):
        durero.spec.check(tmp_path / "none.tex")
