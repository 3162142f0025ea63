"""Arguments that need MuJoCo: a model, its state and a renderer, made from the text of a scene."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import mujoco
import numpy as np

from labutils.raycast import RaycastRenderer

if TYPE_CHECKING:
    from collections.abc import Callable

    from labutils.checks.table import Scene


def make_scene_arguments(scene: Scene) -> tuple[tuple[Any, ...], tuple[Callable[[], bool], ...]]:
    """Build what a scene gives, fresh, and what to look at after the call.

    The renderer is the ray caster: its pictures are the same on every machine, with and without
    OpenGL, so that they can be compared with a frozen answer.
    """
    model = mujoco.MjModel.from_xml_string(scene.xml)
    if "data" not in scene.gives:
        return (model,), ()
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    # Positions change after the last mj_forward, as in a simulation loop: cameras and geoms are
    # stale until someone brings them up to date.
    data.qpos[:] = np.array(scene.qpos)
    if "renderer" not in scene.gives:
        return (model, data), ()
    renderer = RaycastRenderer(model, scene.height, scene.width)

    def is_in_color_mode() -> bool:
        try:
            return renderer.render().dtype == np.uint8
        except RuntimeError:
            return False  # closed, or never given a scene

    return (model, data, renderer), (is_in_color_mode,)
