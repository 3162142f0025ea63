"""robosuite's tasks with a Panda: its cameras, their matrices, depth and what it hides."""

from __future__ import annotations

import types
from typing import Any

import mujoco
import numpy as np
import robosuite
from robosuite.controllers.parts import controller
from robosuite.utils import binding_utils, camera_utils

from tests.foreign.peers import PeerModel, Said, copy_model, turn_joints
from tests.foreign.views import HEIGHT, WIDTH


class _OlderMuJoCo(types.ModuleType):
    """MuJoCo 4.0 as robosuite 1.5.2 knows it, in the two places where that has changed.

    A number of NumPy is no longer "in" a tuple of joint types, and the full inertia matrix is made
    from the state, no longer from its field ``qM``. Cameras and drawing are as they were.
    """

    mjtJoint = types.SimpleNamespace(  # noqa: N815 - MuJoCo's own name
        **{name: int(value) for name, value in mujoco.mjtJoint.__members__.items()}
    )

    def __getattr__(self, name: str) -> Any:
        return getattr(mujoco, name)

    @staticmethod
    def mj_fullM(model: mujoco.MjModel, full: np.ndarray, state: mujoco.MjData) -> None:
        mujoco.mj_fullM(model, state, full)


binding_utils.mujoco = controller.mujoco = _OlderMuJoCo("mujoco")
binding_utils.MjData.qM = property(lambda state: state._data)


def look(name: str, cameras: list[str]) -> PeerModel:
    """Make a task and let robosuite draw all cameras."""
    task = robosuite.make(
        name,
        robots="Panda",
        has_renderer=False,
        has_offscreen_renderer=True,
        use_camera_obs=True,
        camera_names=cameras,
        camera_heights=HEIGHT,
        camera_widths=WIDTH,
        camera_depths=True,
        seed=0,
    )
    task.reset()
    sim = task.sim
    model = copy_model(sim.model._model)
    qpos = turn_joints(model, sim.data.qpos)
    sim.data.qpos[:] = qpos
    sim.forward()
    option = mujoco.MjvOption()
    option.geomgroup[:] = sim._render_context_offscreen.vopt.geomgroup
    option.sitegroup[:] = sim._render_context_offscreen.vopt.sitegroup
    option.flags[:] = sim._render_context_offscreen.vopt.flags
    said = {one: _look_through(sim, one) for one in cameras}
    task.close()
    return PeerModel(model, qpos, said, option)


def _look_through(sim: Any, name: str) -> Said:
    _, raw = sim.render(width=WIDTH, height=HEIGHT, camera_name=name, depth=True)
    depth = camera_utils.get_real_depth_map(sim, raw)
    return Said(
        camera=name,
        depth=depth[::-1].copy(),  # its first row is the bottom one
        K=camera_utils.get_camera_intrinsic_matrix(sim, name, HEIGHT, WIDTH),
        T_world_cam=camera_utils.get_camera_extrinsic_matrix(sim, name),
    )
