"""Stores: the file that Python writes is the one that the command line reads, and the other way; who is refused, comes too
late or finds a spoiled file changes nothing; those that edit at once lose nothing."""
from __future__ import annotations

import json
import multiprocessing
import pathlib
import shutil
import sqlite3
import subprocess
import threading
from collections.abc import Callable
from typing import Any

import pytest
from support import PROGRAM, STILL_LIFE, run

import durero

NOON = "2026-01-31T12:00:00Z"


def ball(name: str, radius: float = 1) -> str:
    return f"Agregar_Esfera e?={name} centro?=(0,0,5) radio?={radius}"


def create(folder: pathlib.Path, scene: durero.Scene | pathlib.Path | None = None) -> durero.Store:
    return durero.Store.create(folder / "room.store", scene, author="ann", time=NOON)


def cli(*arguments: Any) -> str:
    return run("store", *arguments)


def cli_log(path: pathlib.Path) -> list[Any]:
    return [json.loads(line) for line in cli("log", path, "--json").splitlines()]


def is_whole(path: pathlib.Path) -> bool:
    return cli("verify", path, "--by-spec").endswith("whole\n")


def refused(of: Callable[[], object], kind: type[Exception] = OSError) -> str:
    with pytest.raises(kind) as error:
        of()
    assert "\n" not in str(error.value)
    return str(error.value)


def test_the_command_line_reads_what_python_writes(tmp_path: pathlib.Path) -> None:
    with create(tmp_path, STILL_LIFE) as store:
        store.edit([ball("a"), ball("b")], author="bob", time="2026-01-31T13:00:00Z", comment="two ∀")
        store.edit(ball("c"), author="", time=NOON)
        path = tmp_path / "room.store"
        log = store.log()
        assert cli_log(path) == log
        assert [event["event"] for event in log] == [4, 3, 2, 1]
        assert log[0]["names"] == ["HEAD", "main"] and log[3].get("import") == str(STILL_LIFE)
        assert [(event["author"], event["comment"]) for event in log] == [("", ""), *[("bob", "two ∀")] * 2, ("ann", "")]
        assert [event["time"] for event in log] == [NOON, *["2026-01-31T13:00:00Z"] * 2, NOON]
        assert [event["begins"] for event in log] == [True, False, True, True]
        assert store.log("HEAD~1", limit=1) == log[1:2] and store.log(2) == log[2:]
        assert cli("export", path) == store.scene().dumps()
        assert cli("export", path, "HEAD~2") == store.scene(1).dumps() == durero.Scene.load(STILL_LIFE).dumps()
        assert is_whole(path)


def test_python_reads_what_the_command_line_writes(tmp_path: pathlib.Path) -> None:
    path = tmp_path / "room.store"
    cli("init", path, "--from", STILL_LIFE, "--author", "ann")
    with durero.Store(path) as store:
        cli("edit", path, "--op", ball("a"), "--op", ball("b"), "--comment", "why", "--author", "eve")
        assert store.head == (3, "main") and store.head.branch == "main"
        assert "a" in store.scene() and "a" not in store.scene("HEAD~1")
        assert store.log() == cli_log(path) and store.log()[0]["comment"] == "why"
        cli("undo", path)
        assert store.head.event == 1 and [event["event"] for event in store.log(all_events=True)] == [3, 2, 1]
        assert store.redo() == 3
        cli("tag", path, "good", "2")
        cli("branch", path, "side", "good")
        assert store.tags == {"good": 2} and store.branches == {"main": 3, "side": 2}
        store.go_to("side")
        assert cli("undo", path) == "event 1, branch side\n"


def test_answers_are_those_of_the_command_line(tmp_path: pathlib.Path) -> None:
    script = "\n".join([ball("a"), "# nothing", ball("a"), "group g?=alone elementos?=a", "Eliminar_Esfera e?=a"])
    with create(tmp_path) as store:
        answers = store.edit(script)
        assert [answer.line for answer in answers] == [1, 3, 4, 5]
        assert [answer.ok for answer in answers] == [True, False, True, True]
        assert answers[1] == durero.StoreAnswer(
            3, False, "elemento_ya_existe", None, "Agregar_Elemento.pre.1", "e? ∉ elementos")
        assert answers[3].left_group == "alone" and answers[3].violated is None
        assert store.edit("") == store.edit([]) == []
    cli("init", tmp_path / "other.store")
    done = subprocess.run([PROGRAM, "store", "edit", tmp_path / "other.store"], input=script, capture_output=True, text=True)
    assert done.returncode == 1
    assert [durero.StoreAnswer(**json.loads(line)) for line in done.stdout.splitlines()] == answers


def test_a_refused_operation_is_not_kept_and_the_others_are(tmp_path: pathlib.Path) -> None:
    with create(tmp_path) as store:
        store.edit([ball("a"), ball("a"), ball("b")])
        assert list(store.scene()) == ["a", "b"] and store.head.event == 3
        before = store.log(all_events=True)
        assert [answer.ok for answer in store.edit([ball("a"), ball("b", 0)])] == [False, False]
        assert [answer.ok for answer in store.edit([ball("c"), ball("a"), ball("d")], all_or_nothing=True)] == [True, False]
        assert store.log(all_events=True) == before and list(store.scene()) == ["a", "b"]
        assert [answer.ok for answer in store.edit([ball("c"), ball("d")], all_or_nothing=True)] == [True, True]
        assert list(store.scene()) == ["a", "b", "c", "d"]
        with pytest.raises(durero.InputError) as malformed:
            store.edit([ball("e"), "Agregar_Esfera e?="])
        assert (malformed.value.file, malformed.value.line) == ("operations", 2)
        assert "e" not in store.scene() and store.head.event == 5
    assert is_whole(tmp_path / "room.store")


def test_undo_and_redo_go_by_transactions(tmp_path: pathlib.Path) -> None:
    with create(tmp_path) as store:
        store.edit([ball("a"), ball("b")])
        store.edit(ball("c"))
        assert (store.undo(), list(store.scene())) == (3, ["a", "b"])
        assert (store.undo(), list(store.scene())) == (1, [])
        with pytest.raises(durero.Refused, match="Deshacer.pre.1"):
            store.undo()
        assert (store.redo(), store.redo(), list(store.scene())) == (3, 4, ["a", "b", "c"])
        with pytest.raises(durero.Refused, match="Rehacer.pre.1"):
            store.redo()
        store.undo()
        store.edit(ball("z"))
        assert list(store.scene()) == ["a", "b", "z"] and list(store.scene(4)) == ["a", "b", "c"]


def test_branches_and_tags_lead_to_their_events(tmp_path: pathlib.Path) -> None:
    with create(tmp_path) as store:
        store.edit(ball("a"))
        store.branch("side", 1)
        store.tag("one")
        assert store.branches == {"main": 2, "side": 1} and store.tags == {"one": 2}
        store.go_to("side")
        store.edit(ball("b"))
        assert store.head == (3, "side") and list(store.scene("main")) == list(store.scene("one")) == ["a"]
        store.go_to(2)
        assert store.head == durero.StoreHead(2, None)
        assert "there is a branch side" in refused(lambda: store.tag("side"))
        assert "no revision" in refused(lambda: store.branch("new", "nowhere"))
        assert "no revision" in refused(lambda: store.go_to(9))
        assert "no revision" in refused(lambda: store.scene("HEAD~9"))
        assert "no revision" in refused(lambda: store.log("nowhere"))
        assert store.branches == {"main": 2, "side": 3} and store.tags == {"one": 2} and store.head == (2, None)


def test_an_edit_that_comes_too_late_does_nothing(tmp_path: pathlib.Path) -> None:
    with create(tmp_path) as store, durero.Store(tmp_path / "room.store") as other:
        head = store.head.event
        other.edit(ball("a"))
        with pytest.raises(durero.StaleHead) as stale:
            store.edit(ball("b"), expected_head=head)
        assert (stale.value.head, stale.value.expected) == (2, 1)
        assert str(stale.value) == "HEAD is at event 2; expected event 1"
        assert list(store.scene()) == ["a"] and store.head.event == 2
        assert store.edit(ball("b"), expected_head=2)[0].ok
        assert "expected_head is 0" in refused(lambda: store.edit(ball("c"), expected_head=0), ValueError)
        assert store.head.event == 3


def test_another_scene_takes_the_place_of_the_first(tmp_path: pathlib.Path) -> None:
    scene = durero.Scene.load(STILL_LIFE)
    with create(tmp_path, scene) as store:
        assert store.scene() == scene and store.log()[0].get("import", "").endswith("<scene>")
        scene.add("new", durero.Esfera(centro=(0, 9, 0), radio=1))
        assert "new" not in store.scene()
        assert store.import_scene(scene, author="bob", comment="again") == 2
        assert store.scene() == scene and (store.log()[0]["author"], store.log()[0]["comment"]) == ("bob", "again")
        assert store.import_scene(STILL_LIFE) == 3 and "new" not in store.scene()
        taken = store.scene()
        taken.add("mine", durero.Esfera(centro=(0, 9, 0), radio=1))
        assert "mine" not in store.scene()
        assert store.undo() == 2 and "new" in store.scene()
    with durero.Store.create(tmp_path / "relative.store", scene) as beside:
        assert beside.log()[0].get("import") == str(tmp_path / "<scene>")
    assert is_whole(tmp_path / "room.store")


def test_a_scene_of_a_text_is_not_kept(tmp_path: pathlib.Path) -> None:
    surfaces = STILL_LIFE.parent / "surfaces"
    rings = durero.Scene.load(surfaces / "torus.json", surfaces=surfaces / "torus.tex")
    assert "without surfaces" in refused(lambda: create(tmp_path, rings), ValueError)
    assert list(tmp_path.iterdir()) == []


def test_author_and_time_are_those_of_the_environment_and_the_clock(
    tmp_path: pathlib.Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with create(tmp_path) as store:
        monkeypatch.setenv("DURERO_AUTHOR", "eve")
        store.edit(ball("a"))
        cli("edit", tmp_path / "room.store", "--op", ball("b"))
        mine, other = store.log()[1], store.log()[0]
        assert mine["author"] == other["author"] == "eve" and NOON < mine["time"] <= other["time"]
        assert "no line of text" in refused(lambda: store.edit(ball("c"), author="a\nb"), ValueError)
        assert "no line of text" in refused(lambda: store.edit(ball("c"), comment="a\nb"), ValueError)
        assert "no time" in refused(lambda: store.edit(ball("c"), time="noon"), ValueError)
        assert store.head.event == 3


def edit_often(path: pathlib.Path, who: str, count: int) -> None:
    with durero.Store(path) as store:
        for i in range(count):
            (answer,) = store.edit(ball(f"{who}{i}"), author=who)
            assert answer.ok


def test_processes_that_edit_at_once_lose_nothing(tmp_path: pathlib.Path) -> None:
    create(tmp_path).close()
    path, spawn = tmp_path / "room.store", multiprocessing.get_context("spawn")
    processes = [spawn.Process(target=edit_often, args=(path, who, 20)) for who in ("p", "q")]
    for process in processes:
        process.start()
    for process in processes:
        process.join()
    assert [process.exitcode for process in processes] == [0, 0]
    with durero.Store(path, write=False) as store:
        assert set(store.scene()) == {f"{who}{i}" for who in "pq" for i in range(20)}
        assert len(store.log()) == 41
    assert is_whole(path)


@pytest.mark.parametrize("shared", [True, False])
def test_threads_that_edit_at_once_lose_nothing(tmp_path: pathlib.Path, shared: bool) -> None:
    first = create(tmp_path)
    second = first if shared else durero.Store(tmp_path / "room.store")
    failed: list[BaseException] = []

    def edit(store: durero.Store, who: str) -> None:
        try:
            for i in range(30):
                assert store.edit(ball(f"{who}{i}"))[0].ok
                assert f"{who}{i}" in store.scene()
        except BaseException as error:
            failed.append(error)

    other = sqlite3.connect(tmp_path / "room.store", isolation_level=None)
    other.execute("BEGIN IMMEDIATE")  # so that all of them begin at once, behind it
    pairs = [(first, "w"), (second, "x"), (first, "y"), (second, "z")]
    threads = [threading.Thread(target=edit, args=pair) for pair in pairs]
    for thread in threads:
        thread.start()
    threads[0].join(0.2)
    other.execute("ROLLBACK")
    other.close()
    for thread in threads:
        thread.join()
    assert failed == []
    assert set(first.scene()) == {f"{who}{i}" for who in "wxyz" for i in range(30)}
    first.close()
    second.close()
    assert is_whole(tmp_path / "room.store")


def test_who_waits_for_another_writer_holds_no_lock_of_python(tmp_path: pathlib.Path) -> None:
    """A thread waits for a transaction that this one ends."""
    with create(tmp_path) as store:
        other = sqlite3.connect(tmp_path / "room.store", isolation_level=None)
        other.execute("BEGIN IMMEDIATE")
        waits = threading.Thread(target=store.edit, args=(ball("a"),))
        waits.start()
        waits.join(0.2)
        assert waits.is_alive()
        other.execute("ROLLBACK")
        other.close()
        waits.join(60)
        assert not waits.is_alive() and list(store.scene()) == ["a"]


def test_a_store_for_reading_stays_as_it_is(tmp_path: pathlib.Path) -> None:
    create(tmp_path).close()
    with durero.Store(tmp_path / "room.store", write=False) as store, durero.Store(tmp_path / "room.store") as other:
        assert store.head.event == 1
        other.edit(ball("a"))
        assert store.head.event == 1 and len(store.log()) == 1 and list(store.scene()) == []
        writing: list[Callable[[], object]] = [
            lambda: store.edit(ball("b")), store.undo, store.redo, lambda: store.go_to(1), lambda: store.tag("t"),
            lambda: store.branch("b"), lambda: store.import_scene(durero.Scene())]
        for write in writing:
            assert "open for reading" in refused(write, ValueError)
        assert other.head.event == 2 and other.tags == {} and other.branches == {"main": 2}


def test_a_closed_store_is_used_no_more(tmp_path: pathlib.Path) -> None:
    with create(tmp_path) as store:
        pass
    store.close()
    assert "closed" in refused(lambda: store.head, ValueError) and "closed" in refused(store.undo, ValueError)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["room.store"]


def test_a_file_that_is_missing_or_there_already_is_left_so(tmp_path: pathlib.Path) -> None:
    path = tmp_path / "room.store"
    assert refused(lambda: durero.Store(path)).startswith(f"{path}: cannot be read")
    assert list(tmp_path.iterdir()) == []
    path.write_text("mine")
    assert "is there already" in refused(lambda: create(tmp_path))
    assert "is no store" in refused(lambda: durero.Store(path))
    assert path.read_text() == "mine"
    assert "cannot be written" in refused(lambda: durero.Store.create(tmp_path / "none" / "room.store"))


def test_a_store_of_a_later_version_is_refused(tmp_path: pathlib.Path) -> None:
    create(tmp_path).close()
    path = tmp_path / "room.store"
    with sqlite3.connect(path) as changed:
        changed.execute("PRAGMA user_version = 2")
    changed.close()
    before = path.read_bytes()
    for write in (True, False):
        assert "is a store of version 2" in refused(lambda: durero.Store(path, write=write))
    assert path.read_bytes() == before


def test_a_spoiled_event_is_told_of_and_nothing_is_kept_behind_it(tmp_path: pathlib.Path) -> None:
    with create(tmp_path) as store:
        store.edit([ball("a"), ball("b"), ball("c")])
    path = tmp_path / "room.store"
    path.write_bytes(path.read_bytes().replace(b"Agregar_Esfera e?=b", b"Agregar_Esfera e?=d"))
    before = path.read_bytes()
    with durero.Store(path) as store:
        assert "event 3 is not as it was written" in refused(store.scene)
        assert "event 3 is not as it was written" in refused(lambda: store.edit(ball("z")))
        assert "event 3 is not as it was written" in refused(store.log)
        assert store.head.event == 4 and list(store.scene(2)) == ["a"]
    assert path.read_bytes() == before
    torn = tmp_path / "torn.store"
    shutil.copy(path, torn)
    torn.write_bytes(before[:5000])
    assert refused(lambda: durero.Store(torn).scene()).startswith(f"{torn}: ")
    assert torn.read_bytes() == before[:5000]


def test_a_server_that_is_not_there_is_told_without_the_password() -> None:
    said = refused(lambda: durero.Store("postgresql://ann:secret@/scenes?host=/nowhere&password=secret"))
    assert said.startswith("postgresql://ann@/scenes?host=/nowhere: ") and "secret" not in said
