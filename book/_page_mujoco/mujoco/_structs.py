"""Structs of the engine: numbers go straight through, arrays are views of mirrors."""

from __future__ import annotations

import enum
from json import loads
from typing import Any

import numpy as np

from ._derived import FIELDS, Field
from ._engine import ask, bridge, engine
from ._enums import make_enum
from ._memory import Memory, shape_bytes

#: Where the real package defines them, and so where checks look for their names.
MODULE = "mujoco._structs"

#: Names in Python that C has without a line: `global` is a word of the language.
_IN_C = {"global_": "global"}
_IN_PYTHON = {"global": "global_"}


def to_number(name: str, value: Any) -> Any:
    """Return a plain number or text for the engine; raise TypeError for anything else."""
    if isinstance(value, enum.Enum):
        return value.value
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, np.ndarray) and value.size == 1:
        value = value.item()
    if not isinstance(value, (bool, int, float, str)):
        raise TypeError(f"{name}: expected a number, got {type(value).__name__} {value!r:.60}")
    return value


_FROM_NUMBER = {"f": float, "b": bool, "i": int, "s": str}


def from_number(kind: str, value: Any) -> Any:
    """Return a number of the engine as Python's package has it: JavaScript knows only one kind."""
    if kind in _FROM_NUMBER:
        return _FROM_NUMBER[kind](value)
    return make_enum(kind)(value.value)


def show(name: str, owner: Any, names: list[str]) -> str:
    """Write all attributes, one a line, as the real package does."""
    with np.printoptions(threshold=100):
        lines = "".join(f"\n  {one}: {_indent(repr(getattr(owner, one)))}" for one in names)
    return f"<{name}{lines}\n>"


def _indent(text: str) -> str:
    return text.replace("\n", "\n  ")


class Struct:
    """A struct of the engine: a part of a model, or one that stands alone."""

    _kind = ""

    def __init__(self, handle: Any = None, memory: Memory | None = None) -> None:
        if handle is None:
            handle = ask(getattr(engine, self._kind).new)
            memory = Memory(handle)
        # never deleted where it is a part of another: that would free memory of the whole
        self.__dict__.update(_handle=handle, _memory=memory or Memory())

    def __getattr__(self, name: str) -> Any:
        field = FIELDS[self._kind].get(_IN_C.get(name, name))
        if field is None:
            kind = type(self).__qualname__
            message = f"'{MODULE}.{kind}' object has no attribute '{name}'"
            raise AttributeError(message, name=name, obj=self)
        if field.sizes == ("*",):
            return read_list(field.kind, getattr(self._handle, name))
        if field.sizes or field.kind in FIELDS:
            self.__dict__[name] = self._make_part(_IN_C.get(name, name), field)
            return self.__dict__[name]
        return from_number(field.kind, getattr(self._handle, name))

    def _make_part(self, name: str, field: Field) -> Any:
        if field.kind in FIELDS:
            return make_struct(field.kind, getattr(self._handle, name), self._memory)
        address, count, theirs = loads(bridge.findArray(self._handle, name))
        mirror = self._memory.add(address, address + count)
        # not the sizes of the real package: a newer engine has more flags than this one
        return shape_bytes(mirror, field.kind, theirs, (count // np.dtype(field.kind).itemsize,))

    def __setattr__(self, name: str, value: Any) -> None:
        field = FIELDS[self._kind].get(name)
        if field and field.sizes:
            getattr(self, name)[...] = value
        elif field and field.kind not in FIELDS:
            setattr(self._handle, name, to_number(name, value))
        else:
            getattr(self, name)  # where there is no such name, this says so
            raise AttributeError(f"property of '{type(self).__qualname__}' object has no setter")

    def __dir__(self) -> list[str]:
        return sorted([*super().__dir__(), *self._list_names()])

    def _list_names(self) -> list[str]:
        return [_IN_PYTHON.get(name, name) for name in FIELDS[self._kind]]

    def __repr__(self) -> str:
        return show(type(self).__qualname__, self, self._list_names())

    def __copy__(self) -> Struct:
        self._memory.push()
        twin = type(self).__new__(type(self))
        handle = ask(self._handle.copy)
        twin.__dict__.update(_handle=handle, _memory=Memory(handle))
        return twin

    def __deepcopy__(self, memo: dict[int, Any]) -> Struct:
        return self.__copy__()


_classes: dict[str, type[Struct]] = {}


def make_class(kind: str) -> type[Struct]:
    """Return the class for a kind of struct, always the same one."""
    if kind not in _classes:
        name = kind.replace("MjVisual", "MjVisual.", 1) if kind != "MjVisual" else kind
        _classes[kind] = type(
            kind, (Struct,), {"_kind": kind, "__module__": MODULE, "__qualname__": name}
        )
    return _classes[kind]


def make_struct(kind: str, handle: Any, memory: Memory) -> Struct:
    """Wrap a struct that is a part of another object, whose mirrors it shares."""
    return make_class(kind)(handle, memory)


class StructList:
    """A list of structs of the engine as it was when it was asked for, and its fields as arrays."""

    _kind = ""

    def __init__(self, vector: Any, count: int) -> None:
        handles = [vector.get(number) for number in range(count)]
        columns = {
            name: _stack(field, [getattr(one, name) for one in handles])
            for name, field in FIELDS[self._kind].items()
        }
        for handle in handles:  # copies, each of them
            handle.delete()
        self._columns: dict[str, np.ndarray] = columns
        self._count = count

    def __getattr__(self, name: str) -> np.ndarray:
        if name not in FIELDS[self._kind]:
            message = f"'{MODULE}._{self._kind}List' object has no attribute '{name}'"
            raise AttributeError(message, name=name, obj=self)
        return self._columns[name]

    def __len__(self) -> int:
        return self._count

    def __getitem__(self, index: int) -> Row:
        if not -self._count <= index < self._count:
            raise IndexError("list index out of range")
        return Row(self._kind, {name: column[index] for name, column in self._columns.items()})

    def __dir__(self) -> list[str]:
        return sorted([*super().__dir__(), *FIELDS[self._kind]])

    def __repr__(self) -> str:
        return show(f"_{self._kind}List", self, list(FIELDS[self._kind]))


class Row:
    """One struct of a list."""

    def __init__(self, kind: str, values: dict[str, Any]) -> None:
        self._kind, self._names = kind, list(values)
        for name, value in values.items():
            setattr(self, name, value if isinstance(value, np.ndarray) else value.item())

    def __repr__(self) -> str:
        return show(self._kind, self, self._names)


#: Lists that are a part of their owner. The engine hands out copies of all others.
_PARTS = frozenset({"MjWarningStat", "MjTimerStat", "MjSolverStat"})


def read_list(kind: str, vector: Any, count: int | None = None) -> StructList:
    """Read a list of structs of the engine, and give it back."""
    name = f"_{kind}List"
    if name not in _lists:
        _lists[name] = type(name, (StructList,), {"_kind": kind, "__module__": MODULE})
    try:
        return _lists[name](vector, vector.size() if count is None else count)
    finally:
        if kind not in _PARTS:
            vector.delete()


_lists: dict[str, type[StructList]] = {}


def _stack(field: Field, values: list[Any]) -> np.ndarray:
    sizes = tuple(map(int, field.sizes))
    dtype = {"f": "f8", "i": "i4", "b": "?"}.get(field.kind, field.kind)
    rows = [value.to_py() if sizes else value for value in values]
    return np.array(rows, dtype).reshape(len(values), *sizes)
