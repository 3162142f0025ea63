"""What models and states have in common: arrays of one block of the engine's memory, and names."""

from __future__ import annotations

import json
from typing import Any, NamedTuple

import numpy as np

from ._derived import ABSENT, FIELDS, VIEWS, Field
from ._engine import bridge
from ._memory import BIG, Memory, read, shape_bytes, write
from ._named import ALIASES, View, make_view
from ._structs import MODULE, from_number, make_struct, read_list, to_number


class Layout(NamedTuple):
    """Where arrays lie in the block of an object: the same for all objects of the same sizes."""

    arrays: dict[str, tuple[int, int, str]]  # from the start of the block on, bytes, kind of array
    stretches: list[tuple[int, int]]  # of the block, without its big arrays

    @classmethod
    def read(cls, handle: Any) -> Layout:
        """Ask the engine."""
        start, size = int(handle.buffer.byteOffset), int(handle.nbuffer)
        found: dict[str, list[Any]] = json.loads(bridge.listArrays(handle))
        arrays = {
            name: (address - start, count, kind)
            for name, (address, count, kind) in found.items()
            if 0 <= address - start < size
        }
        return cls(arrays, _list_stretches(size, arrays))


class EngineObject:
    """A model or a state: its arrays, its numbers and its named views."""

    _kind = ""

    def __init__(self, handle: Any, layout: Layout | None) -> None:
        start = int(handle.buffer.byteOffset)
        layout = layout or Layout.read(handle)
        memory = Memory(handle)
        for first, last in layout.stretches:
            memory.add(start + first, start + last)
        self.__dict__.update(_handle=handle, _start=start, _layout=layout, _memory=memory)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        field = FIELDS[self._kind].get(name)
        if field is not None:
            return self._read(name, field)
        if (kind := ALIASES.get(name, name)) in VIEWS[self._kind]:
            return lambda key="": self._make_view(kind, key)
        if name in ABSENT[self._kind]:
            message = f"{self._kind}.{name} is not in the page's MuJoCo; run the notebook"
        else:
            message = f"'{MODULE}.{self._kind}' object has no attribute '{name}'"
        raise AttributeError(message, name=name, obj=self)

    def _read(self, name: str, field: Field) -> Any:
        if field.sizes == ("*",):
            return read_list(field.kind, getattr(self._handle, name))
        if field.sizes:
            return self._read_array(name, field)
        if field.kind in FIELDS:
            self.__dict__[name] = make_struct(field.kind, getattr(self._handle, name), self._memory)
            return self.__dict__[name]
        return from_number(field.kind, getattr(self._handle, name))

    def _read_array(self, name: str, field: Field) -> Any:
        """Return a view of the mirror, or a copy of what cannot be mirrored."""
        shape = tuple(self._resolve(size) for size in field.sizes)
        address, count, theirs = self._find(name)
        if count > BIG:
            return _make_big(address, count, field, theirs, shape)
        if name not in self._layout.arrays and name not in IN_STRUCT:
            # made anew by every step, and not always there
            if not address:
                return np.zeros(shape, field.kind)
            return shape_bytes(read(address, count), field.kind, theirs, shape)
        mirror = self._memory.find(address, count)
        if mirror is None:
            mirror = self._memory.add(address, address + count)
        array = shape_bytes(mirror, field.kind, theirs, shape)
        if isinstance(array, np.ndarray):
            self.__dict__[name] = array  # the same object every time
        return array

    def _find(self, name: str) -> tuple[int, int, str]:
        """Return the address of an array, its bytes and its kind."""
        if name in self._layout.arrays:
            offset, count, theirs = self._layout.arrays[name]
            return self._start + offset, count, theirs
        address, count, theirs = json.loads(bridge.findArray(self._handle, name))
        return address, count, theirs

    def _resolve(self, size: str) -> int:
        """Return a size: a number, or the name of one in the model or the state."""
        name, _, factor = size.partition("*")
        if name.isdecimal():
            return int(name)
        owner = self if name in FIELDS[self._kind] else self.model
        return int(getattr(owner, name)) * int(factor or 1)

    def _make_view(self, kind: str, key: Any) -> View:
        return make_view(self, kind, key)

    def __setattr__(self, name: str, value: Any) -> None:
        field = FIELDS[self._kind].get(name)
        if field and field.sizes and field.sizes != ("*",):
            self._write_array(name, value)
        elif field and not field.sizes and field.kind not in FIELDS and self._kind == "MjData":
            setattr(self._handle, name, to_number(name, value))
        else:
            getattr(self, name)  # where there is no such name, this says so
            raise AttributeError(f"property of '{self._kind}' object has no setter")

    def _write_array(self, name: str, value: Any) -> None:
        address, count, _ = self._find(name)
        array = getattr(self, name)
        if count > BIG:
            array = array.copy()  # what is asked for cannot be written
            array[...] = value
            write(address, array)
        else:
            array[...] = value

    def __dir__(self) -> list[str]:
        accessors = [one for one in (*VIEWS[self._kind], *ALIASES) if self._has_views(one)]
        return sorted([*super().__dir__(), *FIELDS[self._kind], *accessors])

    def _has_views(self, name: str) -> bool:
        return ALIASES.get(name, name) in VIEWS[self._kind]

    def __deepcopy__(self, memo: dict[int, Any]) -> Any:
        return self.__copy__()

    def __copy__(self) -> Any:
        raise NotImplementedError


#: Arrays that lie in the struct itself, beside the block.
IN_STRUCT = frozenset({"energy", "solver_fwdinv", "solver_niter", "solver_nnz"})


def _list_stretches(size: int, arrays: dict[str, tuple[int, int, str]]) -> list[tuple[int, int]]:
    """List the stretches of a block between its big arrays, which are copied when asked for."""
    big = sorted((offset, offset + count) for offset, count, _ in arrays.values() if count > BIG)
    start, found = 0, []
    for first, last in big:
        found.append((start, first))
        start = last
    return [*found, (start, size)]


def _make_big(
    address: int, count: int, field: Field, theirs: str, shape: tuple[int, ...]
) -> np.ndarray:
    """Return a copy that cannot be written, because the engine would not see it."""
    array: np.ndarray = shape_bytes(read(address, count), field.kind, theirs, shape)
    array.flags.writeable = False
    return array
