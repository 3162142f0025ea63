"""The way to the engine: a WebAssembly module that JavaScript has registered, and its errors.

What the engine reports becomes an exception of the type and with the words of MuJoCo's own Python
package. It can be used on after that. Where WebAssembly itself breaks down, the engine is lost:
every further call says so.
"""

from __future__ import annotations

import re
from typing import Any

import _mujoco_wasm
import pyodide_js
from pyodide.ffi import JsException

#: What ``bridge.js`` has put there.
bridge = _mujoco_wasm
bridge.setPython(pyodide_js._module)
#: The functions, classes and enums of the engine.
engine = bridge.engine

#: How WebAssembly and JavaScript name errors after which memory cannot be trusted.
_BREAKDOWNS = ("RuntimeError", "RangeError", "InternalError")

_lost = ""


class FatalError(Exception):
    """The engine could not do what it was asked."""


class UnexpectedError(Exception):
    """The engine broke down."""


for _error in (FatalError, UnexpectedError):
    _error.__module__ = "mujoco"


def ask(function: Any, *arguments: Any, otherwise: type[Exception] = FatalError) -> Any:
    """Call the engine; raise what it reports as an exception of Python.

    Parameters
    ----------
    function : JsProxy
        Of the engine.
    *arguments
        Objects of the engine, numbers and texts.
    otherwise : type
        The exception where the engine's own words do not tell a better one.
    """
    if _lost:
        raise UnexpectedError(_lost)
    try:
        return function(*arguments)
    except JsException as problem:
        bridge.resetStack()
        raise _translate(problem, otherwise) from None


def _translate(problem: JsException, otherwise: type[Exception]) -> Exception:
    global _lost  # noqa: PLW0603 - one engine in one process, and it does not come back
    text = str(getattr(problem, "message", problem))
    kind = str(getattr(problem, "name", ""))
    if kind in _BREAKDOWNS:
        _lost = f"MuJoCo in the page broke down ({text}). Start Python again: press Stop"
        return UnexpectedError(_lost)
    text = text.removeprefix("MuJoCo Error: ").removeprefix("Loading error: ")
    text = text.removeprefix("Could not create Spec from XML string: ").removesuffix("\n")
    text = text.removeprefix("Error: engine error: ")
    if kind == "BindingError":
        return TypeError(text)
    # the bindings check sizes themselves, and say for which function; the package says TypeError
    found = re.match(r"\[\w+\] (.*)", text, re.DOTALL)
    return TypeError(found[1]) if found else otherwise(text)
