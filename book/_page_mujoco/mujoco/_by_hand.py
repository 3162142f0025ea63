"""Functions that are more than one call of the engine, or have to be fast."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ._derived import FUNCTIONS
from ._engine import ask, bridge, engine
from ._functions import ask_and_recover
from ._named import get_object_type
from ._signature import Signature

if TYPE_CHECKING:
    from ._model import MjModel

_SIGNATURES = {
    name: Signature.parse(name, FUNCTIONS[name])
    for name in ("mj_step", "mj_saveModel", "mj_copyData", "mj_name2id", "mj_id2name")
}


def mj_step(*arguments: Any, **named: Any) -> None:
    """Advance the simulation, by one step or ``nstep``."""
    model, data, count = _SIGNATURES["mj_step"].bind(arguments, named)
    model._memory.push()
    data._memory.push()
    ask_and_recover([data], bridge.step, model._handle, data._handle, int(count))
    data._memory.pull()


def mj_name2id(*arguments: Any, **named: Any) -> int:
    """Return the number of an object of a type by its name, or -1."""
    model, kind, name = _SIGNATURES["mj_name2id"].bind(arguments, named)
    return int(ask(engine.mj_name2id, model._handle, int(kind), name))


def mj_id2name(*arguments: Any, **named: Any) -> str | None:
    """Return the name of an object of a type by its number; None where there is none."""
    model, kind, number = _SIGNATURES["mj_id2name"].bind(arguments, named)
    # beyond the last object the engine reads on in its memory; every object has an address
    count = _count_objects(model, int(kind))
    if not 0 <= number < count:
        return None
    return ask(engine.mj_id2name, model._handle, int(kind), int(number)) or None


def _count_objects(model: MjModel, kind: int) -> int:
    for name, field in _NAME_FIELDS.items():
        if get_object_type(name) == kind:
            return len(getattr(model, field))
    return 0


#: Types of objects, and the array of a model that has one number for each of them.
_NAME_FIELDS = {
    "BODY": "name_bodyadr",
    "XBODY": "name_bodyadr",
    "JOINT": "name_jntadr",
    "GEOM": "name_geomadr",
    "SITE": "name_siteadr",
    "CAMERA": "name_camadr",
    "LIGHT": "name_lightadr",
    "FLEX": "name_flexadr",
    "MESH": "name_meshadr",
    "SKIN": "name_skinadr",
    "HFIELD": "name_hfieldadr",
    "TEXTURE": "name_texadr",
    "MATERIAL": "name_matadr",
    "PAIR": "name_pairadr",
    "EXCLUDE": "name_excludeadr",
    "EQUALITY": "name_eqadr",
    "TENDON": "name_tendonadr",
    "ACTUATOR": "name_actuatoradr",
    "SENSOR": "name_sensoradr",
    "NUMERIC": "name_numericadr",
    "TEXT": "name_textadr",
    "TUPLE": "name_tupleadr",
    "KEY": "name_keyadr",
    "PLUGIN": "name_pluginadr",
}


def mj_copyData(*arguments: Any, **named: Any) -> None:  # noqa: N802 - MuJoCo's name
    """Copy a state, and all that follows from it, into another one of the same model."""
    target, _, source = _SIGNATURES["mj_copyData"].bind(arguments, named)
    if target is not source:
        target.become_copy_of(source)


def mj_saveModel(*arguments: Any, **named: Any) -> None:  # noqa: N802 - MuJoCo's name
    """Write a model as bytes into an array; the page has no file to write to."""
    model, filename, buffer = _SIGNATURES["mj_saveModel"].bind(arguments, named)
    if buffer is None:
        raise OSError(f"mj_saveModel: the page writes no file {filename!r}; give a buffer")
    size = int(ask(engine.mj_sizeModel, model._handle))
    if buffer.size < size:
        raise TypeError(f"buffer should have at least {size} bytes, got {buffer.size}")
    model._memory.push()
    theirs = engine.Uint8Buffer.new(size)
    try:
        ask(engine.mj_saveModel, model._handle, None, theirs)
        content = np.empty(size, np.uint8)
        theirs.GetView().assign_to(content)
        buffer.reshape(-1)[:size] = content
    finally:
        theirs.delete()


BY_HAND = {
    function.__name__: function
    for function in (mj_step, mj_name2id, mj_id2name, mj_copyData, mj_saveModel)
}
for _function in BY_HAND.values():
    _function.__module__ = "mujoco._functions"
