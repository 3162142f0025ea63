"""``mujoco.MjSpec``: a scene before it is compiled. Read it, change it, compile it."""

from __future__ import annotations

import weakref
from typing import TYPE_CHECKING, Any

from ._elements import KINDS, MODULE, Element, check_names, make_element
from ._engine import ask, engine
from ._files import adapt, make_vfs, read_scene
from ._memory import Memory
from ._model import MjModel
from ._structs import make_struct

if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import TypeAlias

    Files: TypeAlias = Mapping[str, bytes | str]

#: What a scene holds beside its bodies: the engine's function for it, and whether it has defaults.
_IN_SCENES = {
    "texture": ("mjs_addTexture", False),
    "material": ("mjs_addMaterial", True),
    "mesh": ("mjs_addMesh", True),
    "actuator": ("mjs_addActuator", True),
    "sensor": ("mjs_addSensor", False),
    "key": ("mjs_addKey", False),
    "numeric": ("mjs_addNumeric", False),
}
_PLURALS = {"bodies": "body", "meshes": "mesh"} | {
    f"{what}s": what for what in KINDS if what not in ("body", "mesh")
}
#: Parts of the scene that are structs of their own.
_PARTS = {"option": "MjOption", "stat": "MjStatistic", "visual": "MjVisual"}
_NUMBERS = ("modelname", "memory", "nuserdata")
#: What the real one has besides.
_ELSEWHERE = (
    *("to_xml", "to_file", "to_zip", "from_zip", "attach", "recompile", "copy", "encode"),
    *("tendon", "equality", "pair", "exclude", "skin", "flex", "hfield", "plugin", "tuple", "text"),
    *("default", "compiler", "assets"),
)


class MjSpec:
    """A scene as text or code describes it."""

    __module__ = MODULE

    def __init__(self) -> None:
        self._take("<mujoco/>", {})

    def _take(self, xml: str, assets: Files) -> None:
        self._vfs = make_vfs(assets)
        weakref.finalize(self, self._vfs.delete)
        self._handle = ask(engine.parseXMLString, adapt(xml), self._vfs, otherwise=ValueError)
        weakref.finalize(self, self._handle.delete)
        self._elements: weakref.WeakSet[Element] = weakref.WeakSet()
        self._memory = Memory()

    @classmethod
    def from_string(
        cls, xml: str, include: Files | None = None, assets: Files | None = None
    ) -> MjSpec:
        """Read a scene from its text; what it includes or names is given by name.

        Raises
        ------
        ValueError
            If the text is no scene; the message is the parser's.
        """
        spec = cls.__new__(cls)
        spec._take(xml, {**(include or {}), **(assets or {})})
        return spec

    @classmethod
    def from_file(
        cls, filename: str, include: Files | None = None, assets: Files | None = None
    ) -> MjSpec:
        """Read a scene from a file; what it names is looked for beside it."""
        xml, found = read_scene(filename)
        return cls.from_string(xml, {**found, **(include or {})}, assets)

    @property
    def worldbody(self) -> Any:
        """The body that does not move."""
        return self._find("body", "world")

    def __getattr__(self, name: str) -> Any:
        if name in KINDS:
            return lambda key: self._find(name, key)
        if name in _PLURALS:
            return self._list(_PLURALS[name])
        if name.startswith("add_") and name.removeprefix("add_") in _IN_SCENES:
            return lambda **values: self._add(name.removeprefix("add_"), values)
        if name in _PARTS:
            part = make_struct(_PARTS[name], getattr(self._handle, name), self._memory)
            self.__dict__[name] = part
            return part
        if name in _NUMBERS:
            return getattr(self._handle, name)
        if name in _ELSEWHERE:
            message = f"MjSpec.{name} is not in the page's MuJoCo; run the notebook"
        else:
            message = f"'{MODULE}.MjSpec' object has no attribute '{name}'"
        raise AttributeError(message, name=name, obj=self)

    def __setattr__(self, name: str, value: Any) -> None:
        if name in _NUMBERS:
            setattr(self._handle, name, value)
        else:
            super().__setattr__(name, value)

    def _find(self, what: str, name: str) -> Element | None:
        kind = getattr(engine.mjtObj, f"mjOBJ_{KINDS[what][1]}")
        found = ask(engine.mjs_findElement, self._handle, kind, name)
        if found:
            return self._wrap(what, found)
        # once compiled, the engine finds by name only what was there then
        return next((one for one in self._list(what) if one.name == name), None)

    def _list(self, what: str) -> list[Element]:
        kind = getattr(engine.mjtObj, f"mjOBJ_{KINDS[what][1]}")
        found, elements = ask(engine.mjs_firstElement, self._handle, kind), []
        while found:
            elements.append(self._wrap(what, found))
            found = ask(engine.mjs_nextElement, self._handle, found)
        return elements

    def _wrap(self, what: str, element: Any) -> Element:
        as_kind = getattr(engine, KINDS[what][0].replace("Mjs", "mjs_as", 1))
        return make_element(what, ask(as_kind, element), self)

    def _add(self, what: str, values: dict[str, Any]) -> Element:
        check_names(what, values)
        function, has_defaults = _IN_SCENES[what]
        defaults = (engine.mjs_getSpecDefault(self._handle),) if has_defaults else ()
        made = ask(getattr(engine, function), self._handle, *defaults)
        return make_element(what, made, self).fill(values)

    def delete(self, element: Element) -> None:
        """Take an element out of the scene, with all that it holds."""
        if not isinstance(element, Element):
            raise TypeError(f"delete: expected an element of a scene, got {element!r:.60}")
        self._bring_in()
        ask(engine.mjs_delete, self._handle, element._handle.element, otherwise=ValueError)

    def compile(self) -> MjModel:
        """Make a model of the scene.

        Raises
        ------
        ValueError
            If something is wrong in it; the message is the compiler's.
        """
        self._bring_in()
        self._memory.push()
        handle = ask(engine.mj_compile, self._handle, self._vfs, otherwise=ValueError)
        return MjModel.from_handle(handle)

    def _bring_in(self) -> None:
        """Bring all that was written into the engine: it may move or free elements now."""
        for element in list(self._elements):
            element.forget()

    def __dir__(self) -> list[str]:
        added = (f"add_{what}" for what in _IN_SCENES)
        return sorted([*super().__dir__(), *KINDS, *_PLURALS, *_PARTS, *_NUMBERS, *added])
