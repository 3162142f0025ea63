"""Named views: ``model.camera("head_camera").fovy``, ``data.joint("neck_pan").qpos``."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ._derived import ABSENT, FIELDS, VIEWS
from ._engine import engine
from ._enums import make_enum
from ._structs import MODULE, show

if TYPE_CHECKING:
    from ._object import EngineObject

#: Other names of the accessors.
ALIASES = {
    "jnt": "joint",
    "cam": "camera",
    "eq": "equality",
    "mat": "material",
    "tex": "texture",
    "ten": "tendon",
    "keyframe": "key",
}
#: Of an accessor: its type in `mjtObj`, the number of its objects, and how the package calls views.
_KINDS = {
    "actuator": ("ACTUATOR", "nactuator", "Actuator"),
    "body": ("BODY", "nbody", "Body"),
    "camera": ("CAMERA", "ncam", "Camera"),
    "equality": ("EQUALITY", "neq", "Equality"),
    "exclude": ("EXCLUDE", "nexclude", "Exclude"),
    "geom": ("GEOM", "ngeom", "Geom"),
    "hfield": ("HFIELD", "nhfield", "Hfield"),
    "joint": ("JOINT", "njnt", "Joint"),
    "key": ("KEY", "nkey", "Keyframe"),
    "light": ("LIGHT", "nlight", "Light"),
    "material": ("MATERIAL", "nmat", "Material"),
    "mesh": ("MESH", "nmesh", "Mesh"),
    "numeric": ("NUMERIC", "nnumeric", "Numeric"),
    "pair": ("PAIR", "npair", "Pair"),
    "sensor": ("SENSOR", "nsensor", "Sensor"),
    "site": ("SITE", "nsite", "Site"),
    "skin": ("SKIN", "nskin", "Skin"),
    "tendon": ("TENDON", "ntendon", "Tendon"),
    "texture": ("TEXTURE", "ntex", "Texture"),
    "tuple": ("TUPLE", "ntuple", "Tuple"),
}
#: Numbers in ``qpos`` and in ``qvel``, by the type of a joint: free, ball, slide, hinge.
_QPOS_SIZES, _DOF_SIZES = (7, 4, 1, 1), (6, 3, 1, 1)


def find_id(model: Any, object_type: str, name: str) -> int:
    """Return the number of an object by its name, or -1."""
    return int(engine.mj_name2id(model._handle, get_object_type(object_type), name))


def find_name(model: Any, object_type: str, number: int) -> str:
    """Return the name of an object by its number; empty where it has none."""
    return str(engine.mj_id2name(model._handle, get_object_type(object_type), number) or "")


def get_object_type(name: str) -> int:
    """Return the number of a type of objects, such as BODY."""
    return int(make_enum("mjtObj")[f"mjOBJ_{name}"])


class View:
    """The arrays of one object; numbers are arrays of one number, so that they can be written."""

    _accessor = ""
    _owner_kind = ""

    def __init__(self, owner: EngineObject, model: Any, number: int, name: str) -> None:
        self.__dict__.update(_owner=owner, _model=model, id=number, name=name)

    def __getattr__(self, name: str) -> Any:
        field = VIEWS[self._owner_kind][self._accessor].get(name)
        if field is None:
            absent = ABSENT[self._owner_kind]
            if any(one.endswith(f"_{name}") or one == name for one in absent):
                message = f"{type(self).__name__}.{name} is not in the page's MuJoCo"
                message += "; run the notebook"
            else:
                message = f"'{MODULE}.{type(self).__name__}' object has no attribute '{name}'"
            raise AttributeError(message, name=name, obj=self)
        if (self._accessor, name) in _MADE:
            return _MADE[self._accessor, name](self._owner, self._model, self.id)
        return self._get_rows(field)

    def _find_rows(self, sizes: tuple[str, ...]) -> slice | int:
        """Say which rows of an array are this object's, by the first of its sizes."""
        model, i = self._model, self.id
        first = sizes[0]
        if first in ("nq", "nv"):
            starts, lengths = (
                (model.jnt_qposadr, _QPOS_SIZES)
                if first == "nq"
                else (model.jnt_dofadr, _DOF_SIZES)
            )
            return slice(starts[i], starts[i] + lengths[model.jnt_type[i]])
        if first in _RANGES:
            start, length = (getattr(model, name)[i] for name in _RANGES[first])
            return slice(max(start, 0), max(start, 0) + length)
        return i if len(sizes) > 1 else slice(i, i + 1)

    def _get_rows(self, field: str) -> np.ndarray:
        rows = self._find_rows(FIELDS[self._owner_kind][field].sizes)
        array: np.ndarray = getattr(self._owner, field)[rows]
        # an actuator has one control, as a rule: its range is two numbers, not a row of two
        is_single = FIELDS[self._owner_kind][field].sizes[0] in ("nu", "nout") and len(array) == 1
        return array[0] if is_single and array.ndim > 1 else array

    def __setattr__(self, name: str, value: Any) -> None:
        if name in ("id", "name"):
            raise AttributeError(f"property of '{type(self).__name__}' object has no setter")
        getattr(self, name)[...] = value

    def __dir__(self) -> list[str]:
        return sorted([*super().__dir__(), *self._list_names()])

    def _list_names(self) -> list[str]:
        return sorted([*VIEWS[self._owner_kind][self._accessor], "id", "name"])

    def __repr__(self) -> str:
        return show(type(self).__name__, self, self._list_names())


#: Arrays that hold a range of numbers for each object: where it starts, and how long it is.
_RANGES = {
    "nJten": ("ten_J_rowadr", "ten_J_rownnz"),
    "nsensordata": ("sensor_adr", "sensor_dim"),
    "nnumericdata": ("numeric_adr", "numeric_size"),
    "ntupledata": ("tuple_adr", "tuple_size"),
    "na": ("actuator_actadr", "actuator_actnum"),
    "nu": ("actuator_ctrladr", "actuator_ctrlnum"),
    "nout": ("actuator_outadr", "actuator_outnum"),
}


def _get_moment(data: Any, model: Any, number: int) -> np.ndarray:
    """Return the moment arm of an actuator for every degree of freedom; the engine keeps few."""
    moment = np.zeros(model.nv)
    start, count = data.moment_rowadr[number], data.moment_rownnz[number]
    columns = data.moment_colind[start : start + count]
    moment[columns] = data.actuator_moment[start : start + count]
    return moment


def _get_heights(_: Any, model: Any, number: int) -> np.ndarray:
    start, rows = model.hfield_adr[number], model.hfield_nrow[number]
    columns = model.hfield_ncol[number]
    heights: np.ndarray = model.hfield_data[start : start + rows * columns]
    return heights.reshape(rows, columns)


def _get_pixels(_: Any, model: Any, number: int) -> np.ndarray:
    shapes = np.stack([model.tex_height, model.tex_width, model.tex_nchannel], axis=1)
    ends = np.cumsum(shapes.prod(axis=1))
    shape = shapes[number]
    pixels: np.ndarray = model.tex_data[ends[number] - shape.prod() : ends[number]]
    return pixels.reshape(shape)


#: Attributes that are no rows of an array.
_MADE = {
    ("actuator", "moment"): _get_moment,
    ("hfield", "data"): _get_heights,
    ("texture", "data"): _get_pixels,
}

_classes: dict[tuple[str, str], type[View]] = {}


def make_view(owner: EngineObject, accessor: str, key: Any) -> View:
    """Look an object up, by name or number.

    Raises
    ------
    KeyError, IndexError, TypeError
        If there is none, or `key` is neither; the words are the real package's.
    """
    owner_kind = owner._kind
    model = owner if owner_kind == "MjModel" else owner.model
    object_type, count_name, title = _KINDS[accessor]
    count = getattr(model, count_name)
    if isinstance(key, str):
        number = find_id(model, object_type, key) if key else -1
        if number < 0:
            names = sorted(find_name(model, object_type, i) for i in range(count))
            raise KeyError(f"Invalid name '{key}'. Valid names: {names}")
    else:
        number = _read_index(accessor, key, count)
    if (owner_kind, accessor) not in _classes:
        name = f"_{owner_kind}{title}Views"
        parts = {"_accessor": accessor, "_owner_kind": owner_kind, "__module__": MODULE}
        _classes[owner_kind, accessor] = type(name, (View,), parts)
    name = find_name(model, object_type, number)
    return _classes[owner_kind, accessor](owner, model, number, name)


def _read_index(accessor: str, key: Any, count: int) -> int:
    if not isinstance(key, int | np.integer):
        raise TypeError(
            f"{accessor}(): incompatible function arguments. Expected a name or a number, "
            f"got {type(key).__name__} {key!r:.60}"
        )
    if not 0 <= key < count:
        raise IndexError(f"Invalid index {key}. Valid indices from 0 to {count - 1}")
    return int(key)
