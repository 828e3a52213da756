"""Verdicts are those of the program's `conform`, on the same rays and the same claims."""
from __future__ import annotations

import json
import pathlib
import subprocess
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from support import PROGRAM, ROOT, along_z, run, sphere_scene

import durero
from durero.conform import Profile, Verdict, judge


def verdicts(*arguments: Any, **named: Any) -> list[str]:
    return [judgement.verdict.name for judgement in judge(*arguments, **named)]


def test_claims_of_one_ray() -> None:
    claims = np.array([4, np.nextafter(4, 5), 4.1, 4.0005, 6, np.inf, np.nan])
    scene, rays = sphere_scene(), along_z(len(claims))
    expected = ["exact", "right", "misplaced", "off", "far_root", "missed", "non_finite"]
    assert verdicts(scene, rays, claims) == expected
    judgements = judge(scene, rays, claims)
    assert judgements[1].ulps == 1 and judgements[2].backward > 1e12 and judgements[0].clause == ""
    away = along_z()
    away[0, 5] = -1
    assert verdicts(scene, away, np.array([4.0])) == ["phantom"] and verdicts(scene, away, np.array([np.inf])) == ["exact"]


def test_the_tracer_itself_is_exact_on_every_family() -> None:
    of_bodies = [family.name for family in durero.conform.families() if family.name.startswith("bodies")]
    assert len(of_bodies) == 9  # they are no types of the text, and judge() knows those alone
    for family in durero.conform.families():
        if family.name in of_bodies:
            continue
        for case in durero.conform.suite(family.name, rays=32):
            judgements = judge(case.scene, case.rays, case.scene.trace(case.rays))
            assert {judgement.verdict for judgement in judgements} <= {Verdict.exact, Verdict.skipped}


def test_verdicts_are_those_of_the_program(tmp_path: pathlib.Path) -> None:
    run("conform", "make", tmp_path / "suite", "--family", "rim", "--rays", 16, "--seed", 3)
    (case,) = durero.conform.suite("rim", rays=16, seed=3)
    files = tmp_path / "suite" / case.name
    assert np.load(f"{files}.rays.npy").tobytes() == case.rays.tobytes()
    assert durero.Scene.load(f"{files}.scene.json") == case.scene
    hits = case.scene.trace(case.rays)
    t = np.where(hits["outcome"] == durero.Resultado.hit, hits["t"] * (1 + 1e-4 * (np.arange(16) % 3)), np.inf)
    np.save(tmp_path / "claims.npy", t)
    profile = tmp_path / "profile.json"
    profile.write_text(Profile(format="binary32", least_t=0.5)._text())
    said = json.loads(_report(tmp_path, profile))
    counts = {name: count for name, count in said["families"][0]["verdicts"].items() if count}
    judged = verdicts(case.scene, case.rays, t, profile)
    assert judged == verdicts(case.scene, case.rays, t, Profile(format="binary32", least_t=0.5))
    assert {name: judged.count(name) for name in set(judged)} == counts and len(counts) > 2


def _report(folder: pathlib.Path, profile: pathlib.Path) -> str:
    command: list[Any] = [PROGRAM, "conform", "judge", folder / "suite", folder / "claims.npy", "--profile", profile]
    subprocess.run([*command, "--report", folder / "report"], check=False, capture_output=True)
    return (folder / "report" / "report.json").read_text()


def test_columns_that_a_system_does_not_give() -> None:
    scene, rays = sphere_scene(), along_z(3)
    scene.add("z", durero.Esfera(centro=(0, 0, 9), radio=1))
    points = np.zeros(3, [("point", "f8", (3,))])
    points["point"] = [[0, 0, 4], [0, 0, 4.5], [0, 0, 8]]
    assert verdicts(scene, rays, points, Profile(measure="point")) == ["exact", "misplaced", "wrong_element"]
    named = np.array([(4.0, 0), (4.0, 1), (np.inf, -1)], [("t", "f8"), ("element", "i4")])
    assert verdicts(scene, rays, named) == ["exact", "wrong_element", "missed"]


def test_a_profile_skips_and_says_why() -> None:
    (judgement,) = judge(sphere_scene(), along_z(), np.array([6.0]), Profile(tipos=["cono"]))
    assert (judgement.verdict, judgement.clause) == (Verdict.skipped, "no esfera")
    (judgement,) = judge(sphere_scene(), along_z(), np.array([6.0]), Profile(least_t=5))
    assert (judgement.clause, judgement.otherwise) == ("a distance at least 5", Verdict.far_root)
    with pytest.raises(durero.InputError):
        judge(sphere_scene(), along_z(), np.array([6.0]), Profile(format="binary16"))
    embree = ROOT / "systems" / "embree" / "embree.json"
    assert verdicts(sphere_scene(), along_z(), np.array([4.0]), embree) == ["exact"]
    assert Verdict.skipped.meaning and not Verdict.skipped.is_gross and Verdict.missed.is_gross
    assert [verdict.name for verdict in Verdict] == [name for name, _, _ in durero._durero.verdicts()]


WRONG: list[tuple[npt.NDArray[Any], type[Exception], str]] = [
    (np.array([4.0, 4.0]), ValueError, "2 hits of 1 rays"),
    (np.array([4.0], np.float32), TypeError, "hits has the dtype <f4"),
    (np.array([[4.0]]), ValueError, r"hits has the shape \(1, 1\)"),
    (np.zeros(1, [("depth", "f8")]), ValueError, "hits has the fields depth"),
    (np.zeros(1, [("point", "f8", (2,))]), ValueError, r"hits\['point'\] has the shape \(1, 2\)"),
    (np.array([(4.0, 1)], [("t", "f8"), ("element", "i4")]), ValueError, r"hits\['element'\] has a number beyond"),
    (np.array([(4.0, 3)], [("t", "f8"), ("outcome", "u1")]), ValueError, "the outcome of row 0 is none"),
]


@pytest.mark.parametrize("hits, error, message", WRONG)
def test_hits_that_are_none_are_refused(hits: npt.NDArray[Any], error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        judge(sphere_scene(), along_z(), hits)


def test_an_answer_is_explained() -> None:
    text = durero.conform.explain(sphere_scene(), (0.5, 0, 0, 0, 0, 1))
    assert "the exact answer: s1 at t = 4.133974596215562" in text and "√" in text
    with pytest.raises(ValueError, match='no family "rims"'):
        durero.conform.suite("rims")
