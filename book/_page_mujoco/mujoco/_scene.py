"""``mujoco.MjvScene``: what OpenGL would draw. Rays do not read it, but a reader may."""

from __future__ import annotations

from typing import Any

from ._engine import ask, engine
from ._memory import Memory
from ._structs import MODULE, Struct, StructList, read_list


class MjvScene(Struct):
    """Geoms, lights and cameras of a picture, as ``mjv_updateScene`` collects them."""

    __module__ = MODULE
    _kind = "MjvScene"

    def __init__(self, model: Any = None, maxgeom: int = 0) -> None:
        handle = None if model is None else model._handle
        made = ask(engine.MjvScene.new, *(() if handle is None else (handle, int(maxgeom))))
        self.__dict__.update(_handle=made, _memory=Memory(made))

    @property
    def geoms(self) -> StructList:
        """The geoms that there are now; a copy."""
        return read_list("MjvGeom", self._handle.geoms, self.ngeom)
