"""What an ``MjSpec`` consists of: bodies, geoms, cameras and the like, before they are compiled."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ._derived import FIELDS
from ._engine import ask, engine
from ._memory import Memory
from ._structs import Struct, to_number

if TYPE_CHECKING:
    from pyodide.ffi import JsProxy

#: Where the real package defines them.
MODULE = "mujoco._specs"

#: Of an accessor: the kind of its elements, and their type in `mjtObj`.
KINDS = {
    "body": ("MjsBody", "BODY"),
    "frame": ("MjsFrame", "FRAME"),
    "joint": ("MjsJoint", "JOINT"),
    "geom": ("MjsGeom", "GEOM"),
    "site": ("MjsSite", "SITE"),
    "camera": ("MjsCamera", "CAMERA"),
    "light": ("MjsLight", "LIGHT"),
    "texture": ("MjsTexture", "TEXTURE"),
    "material": ("MjsMaterial", "MATERIAL"),
    "mesh": ("MjsMesh", "MESH"),
    "actuator": ("MjsActuator", "ACTUATOR"),
    "sensor": ("MjsSensor", "SENSOR"),
    "key": ("MjsKey", "KEY"),
    "numeric": ("MjsNumeric", "NUMERIC"),
}
#: Other ways to write a rotation than a quaternion.
ORIENTATIONS = ("axisangle", "euler", "xyaxes", "zaxis")
#: What a body can hold: the name of the engine's function for it.
IN_BODIES = {
    "body": "mjs_addBody",
    "joint": "mjs_addJoint",
    "geom": "mjs_addGeom",
    "site": "mjs_addSite",
    "camera": "mjs_addCamera",
    "light": "mjs_addLight",
}


class Element(Struct):
    """One element of a scene: its fields can be read and written until it is compiled."""

    _spec: Any

    def __init__(self, handle: Any, spec: Any) -> None:
        super().__init__(handle, Memory())
        self.__dict__["_spec"] = spec
        spec._elements.add(self)

    @property
    def name(self) -> str:
        """What other elements call it by."""
        return str(ask(engine.mjs_getName, self._handle.element))

    @property
    def id(self) -> int:
        """The number it has in the model compiled last, or -1."""
        return int(ask(engine.mjs_getId, self._handle.element))

    def __setattr__(self, name: str, value: Any) -> None:
        field = FIELDS[self._kind].get(name)
        if name == "name":
            ask(engine.mjs_setName, self._handle.element, str(value), otherwise=ValueError)
        elif field and field.kind.startswith("mjt") and not field.sizes:
            setattr(self._handle, name, find_enum(name, field.kind, value))
        elif field and field.sizes and np.shape(value) != getattr(self, name).shape:
            shape = getattr(self, name).shape
            raise TypeError(f"{name}: expected an array of shape {shape}, got {np.shape(value)}")
        else:
            super().__setattr__(name, value)

    def fill(self, values: dict[str, Any]) -> Element:
        """Set fields by name, as ``add_geom(size=[0.1])`` does: arrays may be shorter."""
        for name, value in values.items():
            if name in ORIENTATIONS and name not in FIELDS[self._kind]:
                self._orient(name, value)
            elif FIELDS[self._kind].get(name, ("", ()))[1]:
                getattr(self, name)[: np.size(value)] = np.ravel(value)
            elif value is not None:
                setattr(self, name, value)
        return self

    def _orient(self, name: str, value: Any) -> None:
        other = self._handle.alt
        kind = engine.mjtOrientation
        other.type = getattr(kind, f"mjORIENTATION_{name.upper()}")
        getattr(other, name).assign(np.asarray(value, float).reshape(-1))

    def __del__(self) -> None:
        # few keep an element: `body.add_geom(size=[0.1])`, `spec.geom("ball").size = [0.1]`
        self._memory.push()

    def forget(self) -> None:
        """Bring what was written into the engine, and keep no copy of its memory."""
        self._memory.push()
        for name in set(FIELDS[self._kind]) & set(self.__dict__):
            del self.__dict__[name]
        self.__dict__["_memory"] = Memory()

    def __repr__(self) -> str:
        return f"<{MODULE}.{type(self).__name__} object {self.name!r}>"


class Body(Element):
    """A body: it holds other elements."""

    def __getattr__(self, name: str) -> Any:
        what = name.removeprefix("add_")
        if name.startswith("add_") and what in IN_BODIES:
            return lambda **values: self._add(what, values)
        return super().__getattr__(name)

    def _add(self, what: str, values: dict[str, Any]) -> Element:
        defaults = engine.mjs_getSpecDefault(self._spec._handle)
        check_names(what, values)
        made = ask(getattr(engine, IN_BODIES[what]), self._handle, defaults)
        return make_element(what, made, self._spec).fill(values)

    def add_freejoint(self, **values: Any) -> Element:
        """Let the body move freely."""
        check_names("joint", values)
        made = ask(engine.mjs_addFreeJoint, self._handle)
        return make_element("joint", made, self._spec).fill(values)

    def __dir__(self) -> list[str]:
        return sorted([*super().__dir__(), *(f"add_{one}" for one in IN_BODIES)])


def check_names(what: str, values: dict[str, Any]) -> None:
    """Raise TypeError for a field that such an element has not."""
    known = [*FIELDS[KINDS[what][0]], "name", *ORIENTATIONS]
    for name in values:
        if name not in known:
            raise TypeError(f"add_{what}: expected one of {', '.join(known)}, got {name!r}")


def make_element(what: str, handle: Any, spec: Any) -> Element:
    """Wrap an element of the engine."""
    kind = KINDS[what][0]
    if kind not in _classes:
        base = Body if what == "body" else Element
        _classes[kind] = type(kind, (base,), {"_kind": kind, "__module__": MODULE})
    return _classes[kind](handle, spec)


_classes: dict[str, type[Element]] = {}


def find_enum(name: str, kind: str, value: Any) -> JsProxy:
    """Return the engine's own object for a number of an enum.

    Raises
    ------
    TypeError, ValueError
        If it is no number, or the enum has none such.
    """
    number = to_number(name, value)
    if isinstance(number, str):
        raise TypeError(f"{name}: expected a number of {kind}, got {number!r}")
    source = getattr(engine, kind)
    for key in dir(source):
        if key.startswith("mj") and getattr(source, key).value == number:
            return getattr(source, key)
    raise ValueError(f"Invalid int value for {kind}: {number}")
