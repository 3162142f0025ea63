"""Arrays of the engine for NumPy, which cannot look into the engine's memory.

An object of the engine has mirrors: copies of the stretches of memory that hold its arrays. What
Python sees are views of the mirrors. They are copied into the engine before a call, and back after
it, so that a write to an array reaches the engine, and an array that was kept shows the newest
numbers. Both memories may grow: a stretch is looked up by its address, which never changes.
"""

from __future__ import annotations

import weakref
from typing import TYPE_CHECKING, Any

import numpy as np
from pyodide.ffi import to_js

from ._engine import bridge

if TYPE_CHECKING:
    from collections.abc import Callable

#: Bytes from which on an array is copied when it is asked for, and not with every call: textures.
BIG = 1 << 16

_DTYPES = {
    "Float64Array": "f8",
    "Float32Array": "f4",
    "Int32Array": "i4",
    "Uint32Array": "u4",
    "Int8Array": "i1",
    "Uint8Array": "u1",
    "BigInt64Array": "i8",
    "BigUint64Array": "u8",
}


class Memory:
    """The mirrors of one object of the engine, shared by all that stand for a part of it.

    Parameters
    ----------
    handle : JsProxy, optional
        The object, where it is Python's: it is deleted once nothing shares the memory any more.
        (Were it bound to the object of Python, ``make_scene()[0].opt`` would be of a dead model.)
    """

    def __init__(self, handle: Any = None) -> None:
        self._stretches: list[tuple[int, np.ndarray]] = []
        self._table: Any = None  # the same for JavaScript
        self._release: Any = None
        if handle is not None:
            self.take(handle)

    def take(self, handle: Any) -> None:
        """Own an object of the engine, in place of the one before."""
        if self._release:
            self._release()
        self._release = weakref.finalize(self, handle.delete)

    def add(self, start: int, end: int) -> np.ndarray:
        """Mirror a stretch of memory; return the mirror, filled."""
        mirror = np.empty(end - start, np.uint8)
        if mirror.size:
            bridge.getBytes(start, mirror.size).assign_to(mirror)
            self._set_stretches([*self._stretches, (start, mirror)])
        return mirror

    def _set_stretches(self, stretches: list[tuple[int, np.ndarray]]) -> None:
        self._stretches = stretches
        rows = [(start, mirror.ctypes.data, mirror.size) for start, mirror in stretches]
        self._table = to_js(np.array(rows, float).reshape(-1))

    def push(self) -> None:
        """Bring what Python has written into the engine."""
        if self._table:
            bridge.copyStretches(self._table, True)  # noqa: FBT003 - JavaScript knows no names

    def pull(self) -> None:
        """Bring what the engine has written to Python."""
        if self._table:
            bridge.copyStretches(self._table, False)  # noqa: FBT003 - as above

    def find(self, address: int, count: int) -> np.ndarray | None:
        """Return the part of a mirror that stands for some bytes, or None."""
        for start, mirror in self._stretches:
            if start <= address and address + count <= start + mirror.size:
                return mirror[address - start : address - start + count]
        return None

    def move(self, place: Callable[[int], int]) -> None:
        """Take every stretch at another address: the arrays of Python stay what they are."""
        self._set_stretches([(place(start), mirror) for start, mirror in self._stretches])


def read(address: int, count: int) -> np.ndarray:
    """Copy bytes of the engine."""
    content = np.empty(count, np.uint8)
    if count:
        bridge.getBytes(address, count).assign_to(content)
    return content


def write(address: int, content: np.ndarray) -> None:
    """Copy bytes into the engine."""
    if content.nbytes:
        flat = np.ascontiguousarray(content).reshape(-1).view(np.uint8)
        bridge.getBytes(address, flat.size).assign(flat)


def shape_bytes(content: np.ndarray, kind: str, theirs: str, shape: tuple[int, ...]) -> Any:
    """Give bytes the type and the shape that the real package has.

    Parameters
    ----------
    content : ndarray, uint8
        The bytes.
    kind : str
        The type in the real package: a dtype, or ``bytes``.
    theirs : str
        The kind of array in the engine, which counts where the sizes differ.
    shape : tuple of int
        As in the real package.
    """
    if kind == "bytes":
        return content.tobytes()
    count = int(np.prod(shape))
    if count * np.dtype(kind).itemsize == content.size:
        return content.view(kind).reshape(shape)
    if not content.size:  # not made yet: the engine has no array there
        return np.empty((0, *shape[1:]), kind)
    values = content.view(_DTYPES[theirs])
    # the same rows, in a version of MuJoCo in which they are of another length
    return values.reshape(shape[0], -1) if len(shape) > 1 else values
