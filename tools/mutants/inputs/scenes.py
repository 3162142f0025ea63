"""Valid input of the exercises that are given a model: scenes as text."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

import mujoco
import numpy as np

from labutils.checks.table import Scene
from solutions._cases import make_scene_text

if TYPE_CHECKING:
    from collections.abc import Callable

_NAMES = ("head_camera", "side_camera", "sensor_camera", "chase_camera")


def _make_text(rng: np.random.Generator) -> str:
    """Draw a scene; its head camera may sit before the axis, and some cameras may be missing."""
    text = make_scene_text(rng)
    if rng.random() < 0.7:
        place = " ".join(f"{one:.3f}" for one in rng.uniform(-0.5, 0.5, size=3))
        text = text.replace('name="head_camera"', f'name="head_camera" pos="{place}"')
    return text


def _draw_camera(rng: np.random.Generator) -> str:
    # The statement promises an error for a camera that does not exist.
    return str(rng.choice([*_NAMES, *_NAMES, "tail_camera"]))


def _render_camera(rng: np.random.Generator) -> tuple[Any, ...]:
    width, height = map(int, rng.integers(3, 16, size=2))
    qpos = tuple(float(one) for one in rng.uniform(-0.6, 0.6, size=2))
    scene = Scene(_make_text(rng), ("model", "data", "renderer"), qpos, width, height)
    return scene, _draw_camera(rng)


def _get_camera_intrinsics(rng: np.random.Generator) -> tuple[Any, ...]:
    width, height = map(int, rng.integers(1, 1000, size=2))
    return Scene(_make_text(rng)), _draw_camera(rng), width, height


def _rank_cameras(rng: np.random.Generator) -> tuple[Any, ...]:
    while True:
        text = _make_text(rng)
        for name in rng.choice(_NAMES, size=rng.integers(0, 4), replace=False):
            text = re.sub(rf'<camera name="{name}"[^>]*/>', "", text)
        if rng.random() < 0.3:  # a name is no duty
            text = text.replace(f'name="{rng.choice(_NAMES)}"', "")
        qpos = tuple(float(one) for one in rng.uniform(-1.5, 1.5, size=2))
        point = rng.uniform([-1, -3, -0.5], [4.0, 2.0, 2.0])
        model = mujoco.MjModel.from_xml_string(text)
        data = mujoco.MjData(model)
        data.qpos[:] = qpos
        mujoco.mj_forward(model, data)
        distances = np.sort(np.linalg.norm(data.cam_xpos - point, axis=1))
        if len(distances) < 2 or float(np.diff(distances).min()) > 0.01:
            return Scene(text, ("model", "data"), qpos), point


MAKERS: dict[str, Callable[[np.random.Generator], tuple[Any, ...]]] = {
    "render_camera": _render_camera,
    "get_camera_intrinsics": _get_camera_intrinsics,
    "rank_cameras": _rank_cameras,
}
