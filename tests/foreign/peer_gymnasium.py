"""gymnasium's MuJoCo environments: their named cameras, and the free one of their viewer."""

from __future__ import annotations

import copy

import gymnasium
import mujoco
import numpy as np

from labutils import get_clip_planes, process_depth
from tests.foreign.peers import PeerModel, Said, copy_model, turn_joints
from tests.foreign.views import FREE, HEIGHT, WIDTH


def look(name: str, cameras: list[str]) -> PeerModel:
    """Make an environment for each camera, as its interface wants it, and let it draw."""
    said = {}
    for camera in cameras:
        model, qpos, said[camera] = _look_through(name, camera)
    return PeerModel(model, qpos, said)


def _look_through(name: str, camera: str) -> tuple[mujoco.MjModel, np.ndarray, Said]:
    chosen = {"camera_id": -1} if camera == FREE else {"camera_name": camera}
    environment = gymnasium.make(
        name, render_mode="depth_array", width=WIDTH, height=HEIGHT, **chosen
    )
    environment.reset(seed=0)
    inner = environment.unwrapped
    model = copy_model(inner.model)
    qpos = turn_joints(model, inner.data.qpos)
    inner.set_state(qpos, np.zeros(model.nv))
    raw = environment.render()
    viewer = inner.mujoco_renderer.viewer
    taken = copy.copy(viewer.cam) if camera == FREE else camera
    environment.close()
    # It hands out the bare depth buffer, 0 to 1, and has no function that makes meters of it.
    return model, qpos, Said(taken, process_depth(raw, *get_clip_planes(model)).astype(np.float32))
