"""``mujoco.MjModel``: a compiled scene."""

from __future__ import annotations

import hashlib
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
    def from_xml_string(cls, xml: str, assets: Mapping[str, bytes | str] | None = None) -> MjModel:
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
        return cls.from_handle(ask(engine.MjModel.new, _compile(adapt(xml), assets or {})))

    @classmethod
    def from_xml_path(
        cls, filename: str, assets: Mapping[str, bytes | str] | None = None
    ) -> MjModel:
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


#: Compiled scenes by their text and files, the latest ones: what is kept is never handed out.
_compiled: dict[bytes, Any] = {}
_MOST_COMPILED = 8


def _compile(xml: str, assets: Mapping[str, bytes | str]) -> Any:
    """Compile a scene, or find it compiled.

    The engine never gives back what it needs for compiling, some 0.2 MB for the book's scene, and
    cells of a page run again and again.
    """
    digest = hashlib.sha256(xml.encode())
    for name, content in sorted(assets.items()):
        data = content.encode() if isinstance(content, str) else bytes(content)
        digest.update(f"\0{name}\0{len(data)}\0".encode() + data)
    key = digest.digest()
    handle = _compiled.pop(key, None)
    if handle is None:
        vfs = make_vfs(assets)
        try:
            handle = ask(engine.MjModel.from_xml_string, xml, vfs, otherwise=ValueError)
        finally:
            vfs.delete()
        if len(_compiled) >= _MOST_COMPILED:
            _compiled.pop(next(iter(_compiled))).delete()
    _compiled[key] = handle
    return handle
