"""A store: a scene that is kept with its whole history, in one file."""
from __future__ import annotations

import json
import os
from collections.abc import Iterable
from types import TracebackType
from typing import NamedTuple, Optional, Tuple, TypedDict, Union

from . import _durero
from .scene import Scene, single_line

_Path = Union[str, os.PathLike[str]]

Event = TypedDict(
    "Event",
    {
        "event": int,
        "parent": int,
        "begins": bool,
        "author": str,
        "time": str,
        "comment": str,
        "operation": str,
        "import": str,
        "answer": str,
        "hash": str,
        "names": list[str],
    },
    total=False,
)
"""An event, with the keys that `durero store log --json` has: of the first no parent; of an import no operation, and of an
edit no import."""


class StoreHead(NamedTuple):
    """Where the next edit of a store goes."""

    event: int
    """The event on which HEAD stands."""
    branch: Optional[str]
    """The branch that goes on with it; None where it is on none."""


class StoreAnswer(NamedTuple):
    """What an operation of Store.edit has come to: what `durero store edit` prints of it."""

    line: int
    """Of the script, from 1."""
    ok: bool
    """Whether it was accepted, and is kept unless another was refused and nothing is."""
    r: str
    """The answer r! of the total operation."""
    left_group: Optional[str] = None
    """As of durero.Answer."""
    violated: Optional[str] = None
    """Of one that was refused, the label of the precondition that does not hold."""
    predicate: Optional[str] = None
    """That precondition, as the Z text has it."""


class Store:
    """A scene that is kept with every edit that led to it, in one file, or on a PostgreSQL server, whose URI is then given
    in the place of the path. What an edit answered is on disk.

    >>> import durero, pathlib, tempfile
    >>> path = pathlib.Path(tempfile.mkdtemp(), "room.store")
    >>> store = durero.Store.create(path, author="ann")
    >>> answers = store.edit("Agregar_Esfera e?=ball centro?=(0,0,5) radio?=1", author="ann", comment="the first")
    >>> answers[0].r
    'esfera_agregada'
    >>> store.close()
    >>> with durero.Store(path, write=False) as store:
    ...     print(store.head, list(store.scene()), [event["comment"] for event in store.log()])
    StoreHead(event=2, branch='main') ['ball'] ['the first', '']

    It is the file that `durero store` uses, and both may at a time: programs, stores and threads that edit one file wait
    for each other, without Python's lock. A revision is a branch, a tag, the number of an event or HEAD, and perhaps ~N
    for the N-th transaction before. Every method raises OSError where the file cannot be used, is not whole or has no such
    revision, and ValueError where the store is closed; nothing is changed then. A process that is forked opens the store
    anew.
    """

    _store: _durero.Store

    def __init__(self, path: _Path, *, write: bool = True) -> None:
        """Opens a store that is there. With write=False it stays as it is, one that cannot be written can be read, and
        all that is asked is answered of the store as it was at the first question."""
        self._path = os.fspath(path)
        self._store = _durero.Store(self._path, write)

    @classmethod
    def create(
        cls,
        path: _Path,
        scene: Union[Scene, _Path, None] = None,
        *,
        author: Optional[str] = None,
        time: Optional[str] = None,
        comment: str = "",
    ) -> Store:
        """Makes a new store with a scene, or with that of a scene file, or with the empty one, and opens it. It takes no
        file's place. Author, time and comment are those of its first event, as of edit.

        Pictures that a scene file names are named from the store's folder then; those of a Scene are taken to be so
        already. Raises ValueError of a scene that was read with surfaces, and InputError of a file that holds no scene.
        """
        kept, name = _named(os.fspath(path), scene)
        _durero.create_store(os.fspath(path), None if kept is None else kept._scene, name, (author, time, comment))
        return cls(path)

    def close(self) -> None:
        """Closes the store. One that is closed stays so."""
        self._store.close()

    def __enter__(self) -> Store:
        return self

    def __exit__(
        self, kind: Optional[type[BaseException]], error: Optional[BaseException], trace: Optional[TracebackType]
    ) -> None:
        self.close()

    def edit(
        self,
        operations: Union[str, Iterable[str]],
        *,
        author: Optional[str] = None,
        time: Optional[str] = None,
        comment: str = "",
        all_or_nothing: bool = False,
        expected_head: Optional[int] = None,
    ) -> list[StoreAnswer]:
        """Carries the operations of a script, or of a sequence of lines, out where HEAD is, as one transaction and one
        step of undo, and answers each. It returns when those that were accepted are on disk.

        An operation that is refused is answered so, raises nothing and changes nothing; the others are kept. With
        all_or_nothing the first refusal ends the call, and nothing of it is kept. Raises InputError at a line that is no
        operation, and keeps nothing. With expected_head, the number of an event, it raises StaleHead where HEAD is
        elsewhere, since another has edited, and does nothing.

        Without an author it is the first of DURERO_AUTHOR, LOGNAME and USER that the environment has, and without a time
        it is now; a time is of UTC, as 2026-01-31T12:00:00Z. Raises ValueError where one of the texts has more than a
        line, or the time is none.
        """
        text = operations if isinstance(operations, str) else "\n".join(map(single_line, operations))
        answers = self._store.edit(text, (author, time, comment), all_or_nothing, expected_head)
        return [StoreAnswer(**json.loads(line)) for line in answers.splitlines()]

    def import_scene(
        self,
        scene: Union[Scene, _Path],
        *,
        author: Optional[str] = None,
        time: Optional[str] = None,
        comment: str = "",
    ) -> int:
        """Puts another scene, or that of a scene file, in the place of HEAD's, as one event and one step of undo, and
        answers its number. What operations do not change, such as materials and the camera, is changed so. For author,
        time and comment see edit, for pictures and errors create."""
        kept, name = _named(self._path, scene)
        assert kept is not None
        return self._store.import_scene(kept._scene, name, (author, time, comment))

    def undo(self) -> int:
        """Goes back before the last transaction, and answers the event where HEAD is then. Nothing is deleted. Raises
        Refused where there is none before."""
        return self._store.undo()

    def redo(self) -> int:
        """Goes on to where undo has left from last, and answers the event where HEAD is then. Raises Refused where there
        is no such."""
        return self._store.redo()

    @property
    def head(self) -> StoreHead:
        """Where the next edit goes."""
        return StoreHead(*self._store.head())

    def scene(self, revision: Union[str, int] = "HEAD") -> Scene:
        """The scene of a revision, a copy: edits of it are not kept. Its pictures are named from the store's folder."""
        scene = Scene()
        scene._scene = self._store.scene(str(revision))
        return scene

    def log(
        self, revision: Union[str, int] = "HEAD", *, limit: Optional[int] = None, all_events: bool = False
    ) -> list[Event]:
        """The events up to a revision, the last one first, at most `limit` of them. With all_events every event of the
        store, also those that undo has left."""
        if limit is not None and limit < 1:
            raise ValueError(f"limit is {limit}; expected 1 or more")
        return [json.loads(line) for line in self._store.log(str(revision), limit or 0, all_events)]

    @property
    def branches(self) -> dict[str, int]:
        """The event that each branch stands on, by its name, ascending."""
        return self._store.branches()

    @property
    def tags(self) -> dict[str, int]:
        """The event that each tag stands for, by its name, ascending."""
        return self._store.tags()

    def go_to(self, revision: Union[str, int]) -> None:
        """Puts HEAD on a branch, or, where the revision is none, on an event."""
        self._store.go_to(str(revision))

    def branch(self, name: str, revision: Union[str, int] = "HEAD") -> None:
        """Makes a branch, which goes on from the revision when HEAD is on it. Neither a branch nor a tag has its name."""
        self._store.add_branch(name, str(revision))

    def tag(self, name: str, revision: Union[str, int] = "HEAD") -> None:
        """Makes a tag, which stays on the revision. Neither a branch nor a tag has its name."""
        self._store.add_tag(name, str(revision))

    def __repr__(self) -> str:
        return f"<durero.Store {_durero.shown_path(self._path)}>"


def _named(path: str, scene: Union[Scene, _Path, None]) -> Tuple[Optional[Scene], str]:
    """A scene to be kept, and the name that its event has: of its file, or beside the store, so that pictures keep their
    names."""
    if scene is None:
        return None, ""
    if isinstance(scene, Scene):
        return scene, os.path.join(os.path.dirname(_durero.picture_place(path)), "<scene>")
    return Scene.load(scene), os.fspath(scene)
