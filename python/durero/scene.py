"""A scene: read, edited under contract, asked for hits and drawn."""
from __future__ import annotations

import contextlib
import copy
import dataclasses
import json
import os
import pathlib
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import Any, Literal, NamedTuple, Optional, Tuple, Union, overload

import numpy as np
import numpy.typing as npt

from . import _durero
from .elements import TYPES, Element, Written
from .english import in_both_languages, takes_english
from .exact import ExactHit, surd
from .hits import Resultado

_Path = Union[str, os.PathLike[str]]
_Numbers = Union[npt.NDArray[np.int32], npt.NDArray[np.int64]]
_Number = Union[float, np.float64]
_Vector = Union[Sequence[float], npt.NDArray[np.float64]]
Origins = Union[_Numbers, Tuple[_Numbers, _Numbers]]
"""The elements that rays start on: for each ray the number of one in scene.names, -1 for none; or offsets and numbers,
of which ray i has numbers[offsets[i]:offsets[i + 1]]."""


class HitsWithElements(NamedTuple):
    """Hits, and every element of each: hit i has elements[offsets[i]:offsets[i + 1]], ascending."""

    hits: npt.NDArray[np.void]
    offsets: npt.NDArray[np.int64]
    elements: npt.NDArray[np.int32]


@in_both_languages
class Group(NamedTuple):
    """What is directly in a group, by name, ascending."""

    elementos: Tuple[str, ...]
    groups: Tuple[str, ...]


class Answer(str):
    """r! of an edit that was done, and what it tells of groups.

    >>> import durero
    >>> scene = durero.Scene()
    >>> ball = durero.Esfera(centro=(0, 0, 5), radio=1)
    >>> scene.add("s1", ball), scene.group("alone", ["s1"])
    ('esfera_agregada', 'grouped')
    >>> scene.remove("s1").left_group, scene.add("s1", ball).left_group
    ('alone', 'alone')
    """

    left_group: Optional[str]
    """Of a removal, the group that the element left; of an addition, the one that an element of its name left before,
    and that the new one is not in. None where there is none."""

    def __new__(cls, r: str, left_group: str = "") -> Answer:
        self = super().__new__(cls, r)
        self.left_group = left_group or None
        return self


class Step(NamedTuple):
    """A step of a scene's history, as on_edit tells it."""

    kind: Literal["done", "undone", "redone"]
    operations: Tuple[str, ...]
    """The edits, in order, as lines of a script."""


class Mesh(NamedTuple):
    """A mesh: its vertices, and its faces by the places of their corners."""

    vertices: npt.NDArray[np.float64]
    faces: npt.NDArray[np.uint32]
    normals: Optional[npt.NDArray[np.float64]]
    uv: Optional[npt.NDArray[np.float64]]
    material: Optional[str]


class Imported(NamedTuple):
    """A scene from a file of another program, and a line for each kind of thing that it does not keep."""

    scene: Scene
    lost: Tuple[str, ...]


def _mesh_arrays(vertices: object, faces: object) -> Tuple[object, object]:
    """The arrays of vertices and faces, or those of a mesh of trimesh (faces) or Open3D (triangles)."""
    if faces is not None:
        return vertices, faces
    of = vertices
    corners = getattr(of, "faces", None)
    if corners is None:
        corners = getattr(of, "triangles", None)
    if corners is None or not hasattr(of, "vertices"):
        raise TypeError(f"vertices is a {type(of).__name__} without faces; expected arrays, or a mesh that has both")
    return np.array(of.vertices), np.array(corners)


class Scene(Mapping[str, Element]):
    """A scene of the specification: a mapping from names to elements, which operations edit.

    >>> import durero
    >>> scene = durero.Scene()
    >>> scene.add("s1", durero.Esfera(centro=(0, 0, 5), radio=1))
    'esfera_agregada'
    >>> scene["s1"].radio, len(scene), "s2" in scene
    (1.0, 1, False)

    An edit that the specification refuses raises Refused and changes nothing. An edit while another thread traces is
    safe: the trace answers for the scene as it was when it began.
    """

    _scene: _durero.Scene

    def __init__(self) -> None:
        self._scene = _durero.Scene()
        self._callbacks: list[Callable[[Step], object]] = []

    @classmethod
    def load(cls, path: Union[str, os.PathLike[str]], *, surfaces: Optional[_Path] = None) -> Scene:
        """Reads a scene file (JSON). Raises OSError, and InputError at the first thing that is wrong.

        `surfaces` is a Z text, another file, that says what the points of each element are: an element of a type that
        it declares is a durero.Written, trace, occluded and render ask the text, whatever engine is usual, and an
        addition that it gives no points is refused. exact, spec and conform know the types of the specification alone,
        and raise ValueError.
        """
        return cls._read(pathlib.Path(path).read_bytes(), os.fspath(path), surfaces)

    @classmethod
    def loads(cls, text: str, name: str = "<text>", *, surfaces: Optional[_Path] = None) -> Scene:
        """Reads a scene from the text of a scene file; messages call it by the name. For `surfaces` see load."""
        return cls._read(text.encode("utf-8", "surrogateescape"), name, surfaces)

    @classmethod
    def _read(cls, text: bytes, name: str, surfaces: Optional[_Path]) -> Scene:
        scene = cls()
        scene._scene = _durero.read_scene(text, name, None if surfaces is None else os.fspath(surfaces))
        return scene

    @classmethod
    def import_file(
        cls,
        path: _Path,
        *,
        triangles: Optional[Literal["mesh", "single"]] = None,
        root: Optional[_Path] = None,
        surfaces: Optional[_Path] = None,
    ) -> Imported:
        """Reads a scene in any format that `durero import` knows, by the ending of the name. Raises InputError at the
        first thing that is wrong, and OSError.

        `triangles` become faces of a mesh, or each an element, `single`; without it as the format has them. The files
        that a text names lie in the folder `root` or beneath it, without it in the text's own. `surfaces` is a Z text,
        such as demo/surfaces/algebraic.tex, that says what the points of POV-Ray's algebraic surfaces are: these are
        kept then, and the scene is one of that text, as by load. Raises ValueError where it lacks a type of these.

        >>> import pathlib, tempfile
        >>> file = pathlib.Path(tempfile.mkdtemp(), "ball.nff")
        >>> _ = file.write_text("s 0 0 5 1 Q 2")
        >>> scene, lost = Scene.import_file(file)
        >>> scene["s1"].centro, lost
        ((0.0, 0.0, 5.0), ('1 setting of another tracer (Q, Z) left out',))
        """
        if triangles not in (None, "mesh", "single"):
            raise ValueError(f"triangles is {triangles!r}; expected 'mesh' or 'single'")
        scene = cls()
        in_meshes = None if triangles is None else triangles == "mesh"
        scene._scene, lost = _durero.import_file(
            os.fspath(path),
            "" if root is None else os.fspath(root),
            in_meshes,
            None if surfaces is None else os.fspath(surfaces),
        )
        return Imported(scene, tuple(lost))

    def export_file(self, path: _Path, *, binary: bool = False) -> Tuple[str, ...]:
        """Writes the scene in any format that `durero export` knows, by the ending of the name, as a text or as bytes.
        The file appears whole or not at all. Answers a line for each kind of thing that it does not keep. Raises
        OSError.
        """
        return tuple(_durero.export_file(self._scene, os.fspath(path), binary))

    @property
    def surfaces(self) -> Optional[str]:
        """The Z text that the scene was read by, a file; None where there is none."""
        return self._scene.surfaces()

    def save(self, path: Union[str, os.PathLike[str]]) -> None:
        """Writes a scene file, which appears whole or not at all. Raises OSError."""
        self._scene.save(os.fspath(path))

    def dumps(self) -> str:
        """The text of a scene file: the same scene gives the same text."""
        return self._scene.text()

    def apply(self, operation: str) -> Answer:
        """Carries out one operation as text, and answers its r!. Raises Refused or InputError, and changes nothing.

        >>> Scene().apply("Agregar_Esfera e?=s1 centro?=(0,0,5) radio?=1")
        'esfera_agregada'
        """
        answers = self._scene.apply(single_line(operation), "operation")
        if not answers:
            raise ValueError("the operation is blank; expected one operation")
        self._tell("done")
        return Answer(*answers[0])

    def apply_all(self, operations: Union[str, Iterable[str]]) -> list[Answer]:
        """Carries out every operation of a script, or of a sequence of lines, or none of them: where one is malformed
        or refused it raises InputError or Refused, which know the line, and the scene is as it was.

        >>> scene = Scene()
        >>> scene.apply_all(["Agregar_Esfera e?=a centro?=(0,0,5) radio?=1", "Eliminar_Esfera e?=a"])
        ['esfera_agregada', 'esfera_eliminada']
        """
        text = operations if isinstance(operations, str) else "\n".join(map(single_line, operations))
        answers = [Answer(*answer) for answer in self._scene.apply(text, "operations")]
        if answers:
            self._tell("done")
        return answers

    def add(self, e: str, element: Element) -> Answer:
        """Adds an element under a name, by the operation of its type, and answers its r!. Raises Refused."""
        if isinstance(element, Written):
            inputs: dict[str, object] = {**element.attributes}
            if element.material is not None:
                inputs["material"] = element.material
        else:
            inputs = {name: value for name, value in dataclasses.asdict(element).items() if value is not None}
        tipo = element.tipo
        return self._operate({"op": f"Agregar_{tipo[:1].upper()}{tipo[1:]}", "e": e, **inputs})

    def remove(self, e: str) -> Answer:
        """Removes the element of that name, by the general operation, and answers its r!. Raises Refused.

        It leaves its group, which the answer names: left_group."""
        return self._operate({"op": "Eliminar_Elemento", "e": e})

    @takes_english
    def change(
        self,
        e: str,
        *,
        centro: Optional[_Vector] = None,
        radio: Optional[_Number] = None,
        vector: Optional[_Vector] = None,
        altura: Optional[_Number] = None,
        proporcion: Optional[_Number] = None,
        vertices: Optional[Sequence[_Vector]] = None,
    ) -> Answer:
        """Gives an element other values of attributes, in one step, and answers r!. Raises Refused, and then nothing is
        changed. The element keeps its name, its type, its material and its group.

        >>> import durero
        >>> scene = durero.Scene()
        >>> scene.add("s1", durero.Esfera(centro=(0, 0, 5), radio=1))
        'esfera_agregada'
        >>> scene.change("s1", radio=2, centro=(0, 0, 9)), scene["s1"].radio
        ('elemento_cambiado', 2.0)
        """
        if not isinstance(e, str):
            raise TypeError(f"e is {e!r}; expected a name")
        given = {"centro": centro, "radio": radio, "vector": vector, "altura": altura, "proporcion": proporcion}
        changed: dict[str, object] = {word: _plain(value) for word, value in given.items() if value is not None}
        if vertices is not None:
            changed["vertices"] = [_plain(vertex) for vertex in vertices]
        if not changed:
            raise ValueError("change names no attribute; expected one or more, such as radio=2")
        return self.apply_all(
            json.dumps({"op": f"Cambiar_{word.capitalize()}", "e": e, word: value}) for word, value in changed.items()
        )[-1]

    def set_material(self, e: str, material: Optional[str]) -> Answer:
        """Gives an element another material of the scene, or none, and answers its r!. Raises Refused."""
        if material is None:
            return self._operate({"op": "Quitar_Material", "e": e})
        return self._operate({"op": "Cambiar_Material", "e": e, "material": material})

    def set_group(self, e: str, g: Optional[str]) -> Answer:
        """Puts an element into another group, or takes it out of its group, and answers its r!. Raises Refused."""
        if g is None:
            return self._operate({"op": "Quitar_Grupo", "e": e})
        return self._operate({"op": "Cambiar_Grupo", "e": e, "g": g})

    def undo(self) -> Answer:
        """Undoes the last step: an edit, a call of apply_all or change, or a transaction. Raises Refused where there is
        none. The last 10,000 steps are kept.

        >>> import durero
        >>> scene = durero.Scene()
        >>> scene.add("s1", durero.Esfera(centro=(0, 0, 5), radio=1)), scene.undo(), len(scene)
        ('esfera_agregada', 'deshecho', 0)
        >>> scene.redo(), len(scene), len(scene.history)
        ('rehecho', 1, 1)
        """
        answer = Answer(self._scene.undo())
        self._tell("undone")
        return answer

    def redo(self) -> Answer:
        """Does the step again that was undone last. Raises Refused where there is none."""
        answer = Answer(self._scene.redo())
        self._tell("redone")
        return answer

    @contextlib.contextmanager
    def transaction(self) -> Iterator[Scene]:
        """Makes one step of the edits within. Where they end by an exception, everything is undone.

        >>> import durero
        >>> scene, ball = durero.Scene(), durero.Esfera(centro=(0, 0, 5), radio=1)
        >>> with scene.transaction():
        ...     _ = scene.add("a", ball), scene.add("b", ball)
        >>> len(scene.history), scene.undo(), len(scene)
        (1, 'deshecho', 0)
        """
        self._scene.begin()
        try:
            yield self
        except BaseException:
            self._scene.roll_back()
            raise
        self._scene.commit()
        self._tell("done")

    def on_edit(self, callback: Callable[[Step], object]) -> None:
        """Has a function called behind each step that is done, undone or done again. A transaction is one step, behind
        its end; one that is undone at its end is none.

        >>> import durero
        >>> scene = durero.Scene()
        >>> scene.on_edit(lambda step: print(step.kind, len(step.operations)))
        >>> _ = scene.add("s1", durero.Esfera(centro=(0, 0, 5), radio=1))
        done 1
        """
        self._callbacks.append(callback)

    def _tell(self, kind: Literal["done", "undone", "redone"]) -> None:
        if not self._callbacks or self._scene.in_transaction():
            return
        step = Step(kind, tuple(self._scene.last_step(kind == "undone")))
        for callback in self._callbacks:
            callback(step)

    @property
    def history(self) -> Tuple[Tuple[str, ...], ...]:
        """The steps that are done, in order: of each the operations, as lines of a script."""
        return tuple(map(tuple, self._scene.history()))

    @takes_english
    def group(self, g: str, elementos: Iterable[str] = (), groups: Iterable[str] = ()) -> Answer:
        """Makes a group of elements and groups that are in none yet, and answers its r!. Raises Refused.

        >>> import durero
        >>> scene = durero.Scene()
        >>> scene.add("s1", durero.Esfera(centro=(0, 0, 5), radio=1))
        'esfera_agregada'
        >>> scene.group("alone", ["s1"]), scene.groups["alone"].elementos
        ('grouped', ('s1',))
        """
        return self._operate({"op": "group", "g": g, "elementos": list(elementos), "groups": list(groups)})

    def ungroup(self, g: str) -> Answer:
        """Takes a group away, what was in it is then in the group around it, and answers its r!. Raises Refused."""
        return self._operate({"op": "ungroup", "g": g})

    def close(self, e: str, base: str | None = None, top: str | None = None) -> Answer:
        """Closes a cylinder, a cone or a truncated cone by discs of its material, all or none, and answers `closed`, or
        `closed_but_for_rounding` where a number of a disc had to be rounded. Raises Refused.

        >>> import durero
        >>> scene = durero.Scene()
        >>> scene.add("can", durero.Cilindro(centro=(0, 0, 0), radio=1, vector=(0, 1, 0), altura=2))
        'cilindro_agregado'
        >>> scene.close("can"), sorted(scene)
        ('closed', ['can', 'can:base', 'can:top'])
        """
        names = {"base": base, "top": top}
        return self._operate({"op": "close", "e": e, **{k: name for k, name in names.items() if name is not None}})

    def add_mesh(
        self,
        m: str,
        vertices: object,
        faces: object = None,
        *,
        normals: Optional[npt.NDArray[np.floating[Any]]] = None,
        uv: Optional[npt.NDArray[np.floating[Any]]] = None,
        material: Optional[str] = None,
    ) -> Answer:
        """Adds a mesh, whose face n is the triangle m:n, all or none, and answers its r!. Raises Refused.

        Vertices are numbers of shape (n, 3), float64 or float32, and faces whole numbers of shape (k, 3), each the
        place of a vertex. A mesh of trimesh or Open3D may stand for both. Normals, of shape (n, 3), and uv, of shape
        (n, 2), are those of the vertices; no intersection depends on them.

        >>> import numpy as np
        >>> scene = Scene()
        >>> square = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], float)
        >>> scene.add_mesh("square", square, np.array([[0, 1, 2], [0, 2, 3]])), scene.names
        ('malla_agregada', ('square:0', 'square:1'))
        """
        points, corners = _mesh_arrays(vertices, faces)
        answer = Answer(_durero.add_mesh(self._scene, m, points, corners, normals, uv, material, False))
        self._tell("done")
        return answer

    def replace_mesh(
        self,
        m: str,
        vertices: object,
        faces: object = None,
        *,
        normals: Optional[npt.NDArray[np.floating[Any]]] = None,
        uv: Optional[npt.NDArray[np.floating[Any]]] = None,
        material: Optional[str] = None,
    ) -> Answer:
        """Puts another mesh in the place of one, under its name, and answers its r!. Raises Refused. See add_mesh."""
        points, corners = _mesh_arrays(vertices, faces)
        answer = Answer(_durero.add_mesh(self._scene, m, points, corners, normals, uv, material, True))
        self._tell("done")
        return answer

    def remove_mesh(self, m: str) -> Answer:
        """Removes a mesh with its triangles, and answers its r!. Raises Refused."""
        return self._operate({"op": "Eliminar_Malla", "m": m})

    @takes_english
    def move_vertex(self, m: str, n: int, punto: Sequence[float]) -> Answer:
        """Moves a vertex of a mesh, the corner of every face that has it, and answers its r!. Raises Refused."""
        return self._operate({"op": "Mover_Vertice", "m": m, "n": int(n), "punto": [float(x) for x in punto]})

    @property
    def meshes(self) -> dict[str, Mesh]:
        """The meshes by their names, ascending: copies of their arrays."""
        return {m: Mesh(*_durero.mesh(self._scene, m)) for m in _durero.meshes(self._scene)}

    @property
    def faces(self) -> npt.NDArray[np.int32]:
        """For each element, by its place in names: the place of its mesh among meshes, and the number of its face; −1
        and −1 where it is in no mesh. Of shape (n, 2)."""
        return _durero.faces(self._scene)

    @property
    def groups(self) -> dict[str, Group]:
        """The groups by their names: no answer depends on them, and what is in no group is just that."""
        return {name: Group(tuple(elementos), tuple(groups)) for name, (elementos, groups) in self._scene.groups().items()}

    def _operate(self, operation: dict[str, object]) -> Answer:
        named = next(key for key in ("e", "g", "m") if key in operation)
        if not isinstance(operation[named], str):
            raise TypeError(f"{named} is {operation[named]!r}; expected a name")
        return self.apply(json.dumps(operation))

    def __len__(self) -> int:
        return self._scene.size()

    def __contains__(self, name: object) -> bool:
        return isinstance(name, str) and self._scene.contains(name)

    def __iter__(self) -> Iterator[str]:
        return iter(self._scene.names())

    def __getitem__(self, name: str) -> Element:
        word, attributes, material = self._scene.element(name)
        if word not in TYPES:
            return Written(word, attributes, material)  # type: ignore[arg-type]
        return TYPES[word](**attributes, material=material)  # type: ignore[arg-type]

    @property
    def names(self) -> Tuple[str, ...]:
        """The names of the elements: those by themselves, ascending, then the faces of the meshes, mesh by mesh. Arrays
        know an element by its place here."""
        return tuple(self._scene.names())

    @property
    def materials(self) -> Tuple[str, ...]:
        """The names of the materials."""
        return tuple(self._scene.materials())

    def __eq__(self, other: object) -> bool:
        """Whether both have the same scene file."""
        if not isinstance(other, Scene):
            return NotImplemented
        return self.dumps() == other.dumps()

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"<durero.Scene of {len(self)} elements>"

    def __copy__(self) -> Scene:
        """Shares what it can, so it costs nothing until one of both is edited."""
        scene = type(self)()
        scene._scene = self._scene.copy()
        return scene

    def __deepcopy__(self, memo: dict[int, object]) -> Scene:
        return copy.copy(self)

    def __getstate__(self) -> Tuple[str, Optional[str]]:
        return self.dumps(), self.surfaces

    def __setstate__(self, state: Tuple[str, Optional[str]]) -> None:
        text, surfaces = state
        self._scene = _durero.read_scene(text.encode(), "pickle", surfaces)
        self._callbacks = []

    @overload
    def trace(
        self,
        rays: npt.NDArray[np.float64],
        engine: str = ...,
        *,
        en: Optional[Origins] = ...,
        elements: Literal["first"] = ...,
        hierarchy: str = ...,
    ) -> npt.NDArray[np.void]: ...

    @overload
    def trace(
        self,
        rays: npt.NDArray[np.float64],
        engine: str = ...,
        *,
        en: Optional[Origins] = ...,
        elements: Literal["all"],
        hierarchy: str = ...,
    ) -> HitsWithElements: ...

    @takes_english
    def trace(
        self,
        rays: npt.NDArray[np.float64],
        engine: str = _durero.default_engine,
        *,
        en: Optional[Origins] = None,
        elements: str = "first",
        hierarchy: str = "automatic",
    ) -> Union[npt.NDArray[np.void], HitsWithElements]:
        """The first hit of every ray: an array of durero.HIT, a row a ray.

        Rays are float64 of shape (n, 6), px py pz vx vy vz, C-contiguous and finite, with v other than 0; v need not be
        a unit vector. They are read where they lie; whatever else is given raises TypeError or ValueError, which says
        what is wrong, and nothing is converted. `en` says which elements each ray starts on: those are met there no
        more, so that a surface does not shadow itself. With elements="all" every element of a tie is told. With
        hierarchy="hand" the engine "bvh" groups the elements as the groups of the scene do, and no engine else does: no
        answer depends on it.

        >>> import numpy as np
        >>> scene = Scene.loads('{"format":"durero-scene","version":1,"elementos":'
        ...                     '[{"id":"s1","tipo":"esfera","centro":[0,0,5],"radio":1}]}')
        >>> hits = scene.trace(np.array([[0, 0, 0, 0, 0, 2], [0, 0, 0, 0, 1, 0]], float))
        >>> hits["t"].tolist(), [Resultado(outcome).name for outcome in hits["outcome"]]
        ([2.0, nan], ['hit', 'miss'])

        It runs on every processor, without Python's lock.
        """
        if elements == "first":
            return _durero.first_hits(self._scene, rays, engine, en, hierarchy)
        if elements == "all":
            return HitsWithElements(*_durero.first_hits_with_elements(self._scene, rays, engine, en, hierarchy))
        raise ValueError(f'elements is {elements!r}; expected "first" or "all"')

    def distance(self, points: npt.NDArray[np.float64]) -> npt.NDArray[np.void]:
        """How far each point is from the scene: an array of durero.PROXIMITY, a row a point.

        Points are float64 of shape (n, 3), C-contiguous and finite. Each number is the exact one, rounded once; elements
        that tie do so exactly.

        >>> import numpy as np
        >>> scene = Scene.loads('{"format":"durero-scene","version":1,"elementos":'
        ...                     '[{"id":"s1","tipo":"esfera","centro":[0,0,5],"radio":1}]}')
        >>> near = scene.distance(np.array([[0, 0, 0], [0, 0, 5]], float))
        >>> near["distance"].tolist(), near["point"].tolist(), near["count"].tolist()
        ([4.0, 1.0], [[0.0, 0.0, 4.0], [-1.0, 0.0, 5.0]], [1, 2])

        It runs on every processor, without Python's lock.
        """
        return _durero.distance(self._scene, points)

    @takes_english
    def occluded(
        self,
        rays: npt.NDArray[np.float64],
        engine: str = _durero.default_engine,
        *,
        en: Optional[Origins] = None,
        hierarchy: str = "automatic",
    ) -> npt.NDArray[np.bool_]:
        """Whether each ray meets some element at some t > 0. Arguments are those of trace."""
        return _durero.occluded(self._scene, rays, engine, en, hierarchy)

    @takes_english
    def occluded_segment(
        self,
        rays: npt.NDArray[np.float64],
        engine: str = _durero.default_engine,
        *,
        en: Optional[Origins] = None,
        hierarchy: str = "automatic",
    ) -> npt.NDArray[np.bool_]:
        """Whether each ray meets some element at some 0 < t < 1, between p and p + v. Arguments are those of trace."""
        return _durero.occluded_segment(self._scene, rays, engine, en, hierarchy)

    @takes_english
    def exact(self, ray: Union[Sequence[float], npt.NDArray[np.float64]], en: Iterable[str] = ()) -> ExactHit:
        """The first hit of one ray, by exact arithmetic and not rounded: t and each coordinate as x + y√delta.

        The ray is six numbers, and en the names of the elements that it starts on.

        >>> import durero
        >>> scene = durero.Scene()
        >>> scene.add("s1", durero.Esfera(centro=(0, 0, 5), radio=2))
        'esfera_agregada'
        >>> print(scene.exact((1, 0, 0, 0, 0, 1)).t)
        5 + -1·√(3)
        """
        row = np.array([ray], dtype=np.float64)
        if not np.array_equal(row[0], np.asarray(ray)):
            raise ValueError(f"the ray is {ray!r}; expected six numbers, each of which a float64 is")
        outcome, elements, t, point = _durero.exact_first_hit(self._scene, row, [en] if isinstance(en, str) else list(en))
        if t is None or point is None:
            return ExactHit(Resultado(outcome), tuple(elements), None, None)
        x, y, z = map(surd, point)
        return ExactHit(Resultado(outcome), tuple(elements), surd(t), (x, y, z))

    def render(
        self,
        size: Optional[Tuple[int, int]] = None,
        engine: str = _durero.default_engine,
        *,
        hierarchy: str = "automatic",
    ) -> npt.NDArray[np.uint8]:
        """The picture that the scene's camera sees, as sRGB of shape (height, width, 3), the upper row first.

        `size` is (width, height), by default the scene's resolution; `hierarchy` as of trace. Raises ValueError without a camera.
        """
        return self._scene.render(size, engine, hierarchy)


def _plain(value: object) -> object:
    """A number or numbers, as JSON writes them."""
    return float(value) if np.ndim(value) == 0 else [float(x) for x in value]  # type: ignore[arg-type, attr-defined]


def single_line(line: str) -> str:
    """The line, of which a script is made. Raises ValueError where it is several."""
    if "\n" in line or "\r" in line:
        raise ValueError(f"the operation {line!r} has more than one line; expected one")
    return line
