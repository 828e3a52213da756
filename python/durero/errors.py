"""What goes wrong, as exceptions that hold what they know."""
from __future__ import annotations

from .english import english


class Refused(Exception):
    """An edit that the specification refuses; the scene is as it was.

    >>> import durero
    >>> scene = durero.Scene()
    >>> try:
    ...     scene.apply("Agregar_Esfera e?=s1 centro?=(0,0,5) radio?=0")
    ... except durero.Refused as refused:
    ...     print(refused.label, "|", refused.predicate, "|", refused.r, "|", refused.values["radio"])
    Agregar_Esfera.pre.2 | radio? ∈ Rmas | radio_no_positivo | 0.0
    """

    def __init__(
        self, label: str, predicate: str, r: str, operation: str, values: dict[str, object], line: int = 1
    ) -> None:
        super().__init__(label, predicate, r, operation, values, line)
        self.label = label
        """Of the precondition that does not hold: its name in the Z text."""
        self.predicate = predicate
        """The precondition, as the Z text has it."""
        self.r = r
        """The answer r! of the total operation."""
        self.operation = operation
        """The operation that was asked for."""
        self.values = values
        """Its inputs by their names, without the question mark."""
        self.line = line
        """Of the script, from 1."""

    def __str__(self) -> str:
        inputs = " ".join(f"{name}?={value}" for name, value in self.values.items())
        answer = self.r if english(self.r) == self.r else f"{self.r}, {english(self.r)}"
        return f"{self.label}: {self.predicate} ({answer}): {self.operation} {inputs}"


class InputError(ValueError):
    """A malformed text: what is wrong, and where. Lines and columns count from 1."""

    def __init__(self, message: str, file: str, line: int, column: int) -> None:
        super().__init__(message, file, line, column)
        self.file = file
        self.line = line
        self.column = column

    def __str__(self) -> str:
        return str(self.args[0])


class Undecided(Exception):
    """An expression that the Z text has a value for, but that cannot be worked out: it quantifies over a set that is
    not finite, without an equation that gives the value."""


class StaleHead(Exception):
    """An edit of a store that was to go elsewhere than HEAD is: another has edited since. Nothing was done.

    >>> import durero, pathlib, tempfile
    >>> store = durero.Store.create(pathlib.Path(tempfile.mkdtemp(), "room.store"))
    >>> _ = store.edit("Agregar_Esfera e?=a centro?=(0,0,5) radio?=1")
    >>> store.edit("Eliminar_Esfera e?=a", expected_head=1)
    Traceback (most recent call last):
        ...
    durero.errors.StaleHead: HEAD is at event 2; expected event 1
    """

    def __init__(self, head: int, expected: int) -> None:
        super().__init__(head, expected)
        self.head = head
        """The event where HEAD is."""
        self.expected = expected
        """The event where it was expected."""

    def __str__(self) -> str:
        return f"HEAD is at event {self.head}; expected event {self.expected}"
