"""English beside the Spanish names of the specification, by the one table of the program.

A class, an argument or a property that has a Spanish name has an English one too, and either may be used:

>>> import durero
>>> durero.Sphere is durero.Esfera
True
>>> ball = durero.Sphere(center=(0, 0, 5), radius=1)
>>> ball.radius, ball
(1.0, Esfera(centro=(0.0, 0.0, 5.0), radio=1.0, material=None))
>>> durero.Sphere(center=(0, 0, 5), radius=1, radio=2)
Traceback (most recent call last):
    ...
TypeError: Esfera has both radio and radius, which is its English; expected one of them
"""
from __future__ import annotations

import dataclasses
import functools
import inspect
import operator
from collections.abc import Callable, Iterable, Mapping
from typing import Any, TypeVar, cast

from . import _durero

_ENGLISH = {name: english for name, english, _ in _durero.spanish_names()}
_MEANING = {name: meaning for name, _, meaning in _durero.spanish_names()}

F = TypeVar("F", bound=Callable[..., Any])
T = TypeVar("T")


def english(name: str) -> str:
    """The English of a Spanish name; the name itself where that is English, or is no name of the specification.

    >>> english("radio"), english("Esfera"), english("Agregar_Cono"), english("material")
    ('radius', 'Sphere', 'Add_Cone', 'material')
    """
    if name in _ENGLISH:
        return _ENGLISH[name]
    if name[:1].isupper() and name.lower() in _ENGLISH:
        return "".join(word.capitalize() for word in _ENGLISH[name.lower()].split("_"))
    return name


def meaning(name: str) -> str:
    """What a Spanish name means; empty where it is no name of the specification.

    >>> meaning("altura?")
    'the height of the element that is added'
    """
    return _MEANING.get(name, "")


def with_english(name: str) -> str:
    """The name as a message shows it.

    >>> with_english("radio"), with_english("centro[2]"), with_english("material")
    ('radio (radius)', 'centro[2] (center)', 'material')
    """
    word = name.partition("[")[0]
    return name if english(word) == word else f"{name} ({english(word)})"


def _aliases(names: Iterable[str]) -> dict[str, str]:
    """The Spanish of each English name; a letter alone has none."""
    return {english(name): name for name in names if len(name) > 1 and english(name) != name}


def _in_spanish(of: str, known: Iterable[str], aliases: Mapping[str, str], given: Mapping[str, Any]) -> dict[str, Any]:
    """The arguments by their Spanish names. Raises TypeError at one that has both names, and at an unknown one."""
    named: dict[str, Any] = {}
    for name, value in given.items():
        spanish = aliases.get(name, name)
        if spanish not in known:
            expected = ", ".join(map(with_english, known))
            raise TypeError(f"{of} has no argument {name}; expected one of {expected}")
        if spanish in named:
            raise TypeError(f"{of} has both {spanish} and {english(spanish)}, which is its English; expected one of them")
        named[spanish] = value
    return named


def _told(doc: str | None, names: Iterable[str], kind: str = "") -> str:
    """The docstring, and behind it the English of the names."""
    words = [f"durero.{english(kind)} is this class"] if english(kind) != kind else []
    words += [f"{spanish} is {word}" for word, spanish in _aliases(names).items()]
    return f"{inspect.cleandoc(doc or '')}\n\nIn English: {', '.join(words)}." if words else doc or ""


def takes_english(function: F) -> F:
    """The function, whose arguments may be named in English too."""
    known = [name for name in inspect.signature(function).parameters if name != "self"]
    aliases = _aliases(known)
    if not aliases:
        return function
    spanish = frozenset(known)

    @functools.wraps(function)
    def taking(*arguments: Any, **named: Any) -> Any:
        if not spanish.issuperset(named):
            named = _in_spanish(function.__qualname__.removesuffix(".__init__"), known, aliases, named)
        return function(*arguments, **named)

    taking.__doc__ = function.__doc__ if function.__name__ == "__init__" else _told(function.__doc__, known)
    return cast(F, taking)


def in_both_languages(kind: type[T]) -> type[T]:
    """The class, whose fields and arguments have their English names too."""
    names = [name for base in reversed(kind.__mro__) for name in vars(base).get("__annotations__", ())]
    is_data = dataclasses.is_dataclass(kind)
    fields = [field.name for field in dataclasses.fields(cast(Any, kind))] if is_data else getattr(kind, "_fields", [])
    for word, spanish in _aliases(names).items():
        if spanish in fields:
            told = f"{spanish}, in English."
            setattr(kind, word, property(operator.attrgetter(spanish), doc=told))
        elif hasattr(kind, spanish):
            setattr(kind, word, getattr(kind, spanish))
    if is_data:
        setattr(kind, "__init__", takes_english(kind.__init__))
    kind.__doc__ = _told(kind.__doc__, dict.fromkeys(names), kind.__name__)
    return kind
