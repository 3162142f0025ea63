"""MuJoCo in the page: the Python package `mujoco`, over its WebAssembly build.

Names, shapes, types, words of errors and what an assignment does are those of the real package, as
far as a learner of this book meets them. What is not here says so: "run the notebook".
"""

from __future__ import annotations

import re
from typing import Any

from ._by_hand import BY_HAND as _BY_HAND
from ._data import MjData
from ._derived import CONSTANTS as _CONSTANTS
from ._derived import ELSEWHERE as _ELSEWHERE
from ._derived import ENUMS as _ENUMS
from ._derived import FIELDS as _FIELDS
from ._derived import FUNCTIONS as _FUNCTIONS
from ._engine import FatalError, UnexpectedError
from ._engine import engine as _engine
from ._enums import make_enum as _make_enum
from ._functions import make_function as _make_function
from ._model import MjModel
from ._rays import mj_multiRay, mj_ray
from ._scene import MjvScene
from ._spec import MjSpec
from ._structs import from_number as _from_number
from ._structs import make_class as _make_class

__version__: str = _engine.mj_versionString()

__all__ = [
    "FatalError",
    "MjData",
    "MjModel",
    "MjSpec",
    "MjvScene",
    "Renderer",
    "UnexpectedError",
    "mj_multiRay",
    "mj_ray",
]

globals().update(_BY_HAND)

#: Structs that a reader may make; the others are parts of models and states.
_STRUCTS = frozenset(
    name for name in _FIELDS if re.match(r"Mj(v|Option$|Visual$|Statistic$)", name)
)


def __getattr__(name: str) -> Any:
    value = _find(name)
    globals()[name] = value
    return value


def _find(name: str) -> Any:
    """Make what a name stands for, when it is asked for first: there are hundreds."""
    if name == "Renderer":
        from labutils.renderers.rays import RaycastRenderer  # noqa: PLC0415 - it imports us

        return RaycastRenderer
    if name in _FUNCTIONS:
        return _make_function(name)
    if name in _ENUMS:
        return _make_enum(name)
    if name in _CONSTANTS:
        value = getattr(_engine, name)
        return (
            _read_texts(value) if _CONSTANTS[name] == "s" else _from_number(_CONSTANTS[name], value)
        )
    if name in _STRUCTS:
        return _make_class(name)
    if name in _ELSEWHERE:
        message = f"mujoco.{name} is not in the page's MuJoCo; run the notebook"
    else:
        message = f"module 'mujoco' has no attribute '{name}'"
    raise AttributeError(message, name=name, obj=_get_self())


def _read_texts(value: Any) -> Any:
    found = value.to_py() if hasattr(value, "to_py") else value
    return tuple(tuple(one) if isinstance(one, list) else one for one in found)


def _get_self() -> Any:
    import sys  # noqa: PLC0415 - only where something went wrong

    return sys.modules[__name__]


def __dir__() -> list[str]:
    own = (name for name in globals() if name.startswith("__"))
    return sorted({*own, *__all__, *_FUNCTIONS, *_ENUMS, *_CONSTANTS, *_STRUCTS})
