"""Arguments that need MuJoCo: a model, its state and a renderer, made from the text of a scene."""

from __future__ import annotations

import inspect
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import mujoco
import numpy as np

from labutils.raycast import RaycastRenderer

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

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
        for _ in range(2):
            try:
                return renderer.render().dtype == np.uint8
            except RuntimeError:
                # Closed, or never given a scene: who draws with a renderer of their own needs none.
                renderer.update_scene(data)
        return False

    return (model, data, renderer), (is_in_color_mode,)


@contextmanager
def drawing_by_rays(function: Callable[..., object]) -> Iterator[None]:
    """Let every renderer that a function makes inside the block draw by rays.

    Whoever makes a second renderer, of another size or to leave the given one alone, does nothing
    wrong; but OpenGL's colors would differ from the frozen ones, which were drawn by rays.

    Parameters
    ----------
    function : callable
        The learner's: names in its module that stand for ``mujoco.Renderer`` are changed too.
    """
    theirs = mujoco.Renderer
    names = getattr(inspect.unwrap(function), "__globals__", {})
    places: list[tuple[dict[str, Any], str]] = [(vars(mujoco), "Renderer")]
    places += [(names, name) for name, value in names.items() if value is theirs]
    try:
        for place, name in places:
            place[name] = RaycastRenderer
        yield
    finally:
        for place, name in places:
            place[name] = theirs
