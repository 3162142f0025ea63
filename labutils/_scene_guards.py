"""Do model, state and renderer belong together? Asked before MuJoCo is, which does not."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import mujoco
import numpy as np

from labutils._versions import check_mujoco_version

if TYPE_CHECKING:
    from labutils.renderers.protocol import Renderer

check_mujoco_version(getattr(mujoco, "__version__", ""))  # before anything is drawn

#: Arrays of a state whose lengths are counts of its model.
_COUNTED = {"qpos": "nq", "qvel": "nv", "xpos": "nbody", "geom_xpos": "ngeom", "cam_xpos": "ncam"}


def check_model(model: Any) -> None:
    """Raise TypeError for what is no ``mujoco.MjModel``; say what to pass instead of a wrapper."""
    _check_type("model", model, mujoco.MjModel)


def check_state(model: Any, data: Any) -> None:
    """Raise TypeError or ValueError unless `data` is a state of `model`."""
    check_model(model)
    _check_type("data", data, mujoco.MjData)
    for array, count in _COUNTED.items():
        due, came = getattr(model, count), len(getattr(data, array))
        if due != came:
            raise ValueError(
                f"data: expected a state of this model ({count} = {due}), got one of another "
                f"({count} = {came}); make it with mujoco.MjData(model)"
            )


def check_renderer(model: mujoco.MjModel, renderer: Renderer) -> None:
    """Raise TypeError or ValueError unless `renderer` draws `model`."""
    if not hasattr(renderer, "update_scene"):
        raise TypeError(
            f"renderer: expected one from make_renderer, got {type(renderer).__name__} "
            f"{renderer!r:.60}"
        )
    theirs = getattr(renderer, "model", model)
    # A renderer draws its own model, whatever state it is given: another one shows the wrong
    # scene, or reads beyond the end of an array. An equal copy is as good as the same object.
    if theirs is not model and not is_same_model(theirs, model):
        raise ValueError(
            "renderer: expected one made for this model, got one made for another; "
            "use make_renderer(model, height, width)"
        )


def is_same_model(one: mujoco.MjModel, other: mujoco.MjModel) -> bool:
    """Tell whether two models are equal in every byte."""
    size = mujoco.mj_sizeModel(one)
    if mujoco.mj_sizeModel(other) != size:
        return False
    files = np.zeros((2, size), np.uint8)
    for model, file in zip((one, other), files, strict=True):
        mujoco.mj_saveModel(model, None, file)
    return bool((files[0] == files[1]).all())


def _check_type(name: str, value: Any, kind: type) -> None:
    if isinstance(value, kind):
        return
    came = f"{type(value).__module__}.{type(value).__name__}"
    if isinstance(getattr(value, "ptr", None), kind):  # dm_control's wrappers
        raise TypeError(
            f"{name}: expected a mujoco.{kind.__name__}, got a wrapper of one ({came}); "
            f"pass its {name}.ptr"
        )
    raise TypeError(f"{name}: expected a mujoco.{kind.__name__}, got {came}")
