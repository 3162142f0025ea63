"""The functions ``mj_*``, ``mju_*``, ``mjv_*`` and ``mjd_*``, made from their signatures."""

from __future__ import annotations

import functools
from typing import TYPE_CHECKING, Any

import numpy as np
from pyodide.ffi import to_js

from ._data import MjData
from ._derived import FUNCTIONS, MODEL_WRITERS
from ._engine import ask, engine
from ._guards import check_call
from ._model import MjModel
from ._signature import Parameter, Signature
from ._structs import Struct, from_number

if TYPE_CHECKING:
    from collections.abc import Callable

_BUFFERS = {"f8": "DoubleBuffer", "f4": "FloatBuffer", "i4": "IntBuffer", "u1": "Uint8Buffer"}

#: Sizes that JavaScript wants after the arrays: of which argument, and of which axis (-1: of all).
_SIZES: dict[str, tuple[tuple[int, int], ...]] = {
    "mju_zero": ((0, -1),),
    "mju_sum": ((0, -1),),
    "mju_L1": ((0, -1),),
    "mju_norm": ((0, -1),),
    "mju_normalize": ((0, -1),),
    "mju_isZero": ((0, -1),),
    "mju_symmetrize": ((1, 0),),
    "mju_transpose": ((1, 0), (1, 1)),
    "mju_mulMatVec": ((1, 0), (1, 1)),
    "mju_mulMatTVec": ((1, 0), (1, 1)),
    "mju_sqrMatTD": ((1, 0), (1, 1)),
    "mju_mulMatMat": ((1, 0), (1, 1), (2, 1)),
    "mju_mulMatMatT": ((1, 0), (1, 1), (2, 0)),
    "mju_mulMatTMat": ((1, 0), (1, 1), (2, 1)),
}


class _Call:
    """One call: what goes in, and what comes back into arrays and objects of Python."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.objects: list[Any] = []
        self.outputs: list[tuple[Any, np.ndarray]] = []

    def convert(self, parameter: Parameter, value: Any) -> Any:
        """Return an argument in the form that JavaScript takes."""
        if isinstance(value, MjModel | MjData | Struct):
            self.objects.append(value)
            value._memory.push()
            return value._handle
        if value is None:
            return _make_default(parameter)
        if not parameter.sizes:
            return _to_plain(parameter, value)
        array = np.ascontiguousarray(value, parameter.kind).reshape(-1)
        if not parameter.is_written:
            return to_js(array if array.size else [])
        buffer = getattr(engine, _BUFFERS[parameter.kind]).new(array.size)
        if array.size:
            buffer.GetView().assign(array)
        self.outputs.append((buffer, value))
        return buffer

    def finish(self) -> None:
        """Bring back what the engine has written."""
        for one in self.objects:
            if not isinstance(one, MjModel) or self.name in MODEL_WRITERS:
                one._memory.pull()
        for buffer, array in self.outputs:
            if array.size:
                answer = np.empty(array.size, array.dtype)
                buffer.GetView().assign_to(answer)
                array[...] = answer.reshape(array.shape)

    def free(self) -> None:
        """Give the memory of the arrays back."""
        for buffer, _ in self.outputs:
            buffer.delete()


def make_function(name: str) -> Callable[..., Any]:
    """Make the function of a name; its signature is derived from the real package's."""
    signature = Signature.parse(name, FUNCTIONS[name])
    theirs = getattr(engine, name)

    def function(*arguments: Any, **named: Any) -> Any:
        values = signature.bind(arguments, named)
        check_call(signature, values)
        call = _Call(name)
        try:
            given = list(map(call.convert, signature.parameters, values))
            given += _list_sizes(name, values)
            result = ask_and_recover(call.objects, theirs, *given)
            call.finish()
        finally:
            call.free()
        return _from_result(signature.returns, result)

    function.__name__ = function.__qualname__ = name
    function.__module__ = "mujoco._functions"
    return function


def ask_and_recover(objects: list[Any], theirs: Any, *given: Any) -> Any:
    """Call the engine; where it gives up half way, let its states be as ready as before."""
    try:
        return ask(theirs, *given)
    except Exception:
        for one in objects:
            if isinstance(one, MjData):
                # the engine leaves what it had put on the stack of the state, until it is full
                one._handle.pstack = one._handle.pbase = 0
                one._memory.pull()
        raise


def _make_default(parameter: Parameter) -> Any:
    """Return what stands for None: the engine takes no null for a struct."""
    return _get_no_perturbation() if parameter.kind == "MjvPerturb" else None


@functools.cache
def _get_no_perturbation() -> Any:
    perturbation = ask(engine.MjvPerturb.new)
    engine.mjv_defaultPerturb(perturbation)
    return perturbation


def _to_plain(parameter: Parameter, value: Any) -> Any:
    if parameter.kind == "str":
        return value
    if isinstance(value, np.ndarray):
        value = value.item()
    return {"bool": bool, "int": int, "float": float}[parameter.kind](value)


def _list_sizes(name: str, values: list[Any]) -> list[int]:
    arrays = [np.shape(value) for value in values]
    return [
        int(np.prod(arrays[number])) if axis < 0 else arrays[number][axis]
        for number, axis in _SIZES.get(name, ())
    ]


def _from_result(returns: str, result: Any) -> Any:
    if returns == "None":
        return None
    if returns == "str":
        return result or None
    kind = {"float": "f", "bool": "b"}.get(returns, "i")
    return from_number(kind, result)
