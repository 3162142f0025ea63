"""``mujoco.MjData``: the state of a scene, and what follows from it."""

from __future__ import annotations

from typing import Any

from ._engine import ask, engine
from ._model import MjModel
from ._object import IN_STRUCT, EngineObject
from ._structs import MODULE

_NO_MODEL = (
    "__init__(): incompatible constructor arguments. The following argument types are supported:\n"
    f"    1. {MODULE}.MjData(arg0: {MODULE}.MjModel)\n\nInvoked with: {{}}"
)


class MjData(EngineObject):
    """The state of a scene, and all that the engine computes from it."""

    __module__ = MODULE
    _kind = "MjData"

    def __init__(self, model: MjModel) -> None:
        if not isinstance(model, MjModel):
            raise TypeError(_NO_MODEL.format(repr(model)))
        model._memory.push()
        self._take(ask(engine.MjData.new, model._handle), model)

    def _take(self, handle: Any, model: MjModel) -> None:
        self.__dict__["_model"] = model
        super().__init__(handle, model._data_layout)
        model.__dict__["_data_layout"] = self._layout

    @property
    def model(self) -> MjModel:
        """The model it was made for."""
        return self._model

    def __copy__(self) -> MjData:
        twin = MjData.__new__(MjData)
        twin._take(self._copy_handle(), self._model)
        return twin

    def _copy_handle(self) -> Any:
        self._model._memory.push()
        self._memory.push()
        return ask(engine.MjData.new, self._model._handle, self._handle)

    def become_copy_of(self, source: MjData) -> None:
        """Take over all that another state of the same model holds; arrays stay the same ones."""
        handle = source._copy_handle()
        before = {name: self._find(name)[0] for name in IN_STRUCT}
        start, size = self._start, int(self._handle.nbuffer)
        self.__dict__.update(_handle=handle, _start=int(handle.buffer.byteOffset))
        beside = {address: self._find(name)[0] for name, address in before.items()}

        def place(address: int) -> int:
            is_inside = start <= address < start + size
            return address - start + self._start if is_inside else beside[address]

        self._memory.take(handle)
        self._memory.move(place)
        self._memory.pull()
