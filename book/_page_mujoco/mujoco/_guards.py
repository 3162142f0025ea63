"""What the engine itself does not look at, and would answer with memory that is not its own."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ._engine import engine

if TYPE_CHECKING:
    from ._signature import Signature

#: Parameters that name an object by its number, and the count of these objects in a model.
_COUNTED = {
    "body": "nbody",
    "geom1": "ngeom",
    "geom2": "ngeom",
    "geomid": "ngeom",
    "siteid": "nsite",
    "k": "nkey",
}
#: Functions whose parameter of such a name is something else, or is looked at by the engine.
_FREE = frozenset({"mj_ray", "mj_multiRay", "mj_maxContact"})
#: Functions that take an array of the length that ``mj_stateSize`` gives.
_STATES = frozenset({"mj_getState", "mj_setState"})


def check_call(signature: Signature, values: list[Any]) -> None:
    """Raise IndexError or TypeError for numbers and sizes that the model has not."""
    given = {
        parameter.name: value for parameter, value in zip(signature.parameters, values, strict=True)
    }
    model = given.get("m")
    if model is None or signature.name in _FREE:
        return
    for name, count in _COUNTED.items():
        if isinstance(given.get(name), int):
            _check_index(given[name], getattr(model, count))
    if signature.name == "mj_contactForce":
        _check_index(given["id"], given["d"].ncon)
    if signature.name in _STATES:
        size = engine.mj_stateSize(model._handle, int(given["sig"]))
        if len(given["state"]) != size:
            raise TypeError("state size should equal mj_stateSize(m, sig)")


def _check_index(index: int, count: int) -> None:
    if not 0 <= index < count:
        raise IndexError(f"Invalid index {index}. Valid indices from 0 to {count - 1}")
