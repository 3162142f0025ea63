"""``mujoco.MjModel``: a compiled scene."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Self

from ._engine import ask, engine
from ._files import adapt, make_vfs, read_scene
from ._object import EngineObject, Layout
from ._structs import MODULE

if TYPE_CHECKING:
    from collections.abc import Mapping


class MjModel(EngineObject):
    """A compiled scene: what does not change while it moves."""

    __module__ = MODULE
    _kind = "MjModel"

    def __new__(cls, *arguments: Any) -> Self:
        """Refuse: a model is compiled from a scene."""
        del arguments
        raise TypeError(f"{MODULE}.MjModel: No constructor defined!")

    @classmethod
    def from_handle(cls, handle: Any, layout: Layout | None = None) -> MjModel:
        """Wrap a model of the engine, which belongs to Python from now on."""
        model = object.__new__(cls)
        EngineObject.__init__(model, handle, layout)
        model.__dict__["_data_layout"] = None  # of its states: the first one finds it out
        return model

    @classmethod
    def from_xml_string(cls, xml: str, assets: Mapping[str, bytes] | None = None) -> MjModel:
        """Compile a scene from its text.

        Parameters
        ----------
        xml : str
            In MuJoCo's format.
        assets : dict, optional
            Files that the scene names, by their names.

        Raises
        ------
        ValueError
            If the text is no scene; the message is the parser's.
        """
        vfs = make_vfs(assets or {})
        try:
            handle = ask(engine.MjModel.from_xml_string, adapt(xml), vfs, otherwise=ValueError)
        finally:
            vfs.delete()
        return cls.from_handle(handle)

    @classmethod
    def from_xml_path(cls, filename: str, assets: Mapping[str, bytes] | None = None) -> MjModel:
        """Compile a scene from a file; what it names is looked for beside it.

        Raises
        ------
        ValueError
            If there is no such file, or it is no scene.
        """
        xml, found = read_scene(filename)
        return cls.from_xml_string(xml, {**found, **(assets or {})})

    def __copy__(self) -> MjModel:
        self._memory.push()
        return MjModel.from_handle(ask(engine.MjModel.new, self._handle), self._layout)
