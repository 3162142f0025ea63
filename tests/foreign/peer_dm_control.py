"""dm_control's suite: its cameras, their matrices and depth."""

from __future__ import annotations

import mujoco
import numpy as np
from dm_control.mujoco.wrapper.mjbindings import sizes

from tests.foreign.peers import PeerModel, Said, copy_model, turn_joints
from tests.foreign.views import FREE, HEIGHT, WIDTH

# dm_control 1.0.50 lists fields of flexes that MuJoCo 4.0 has renamed, and reads each of them when
# a model is loaded. Without those names it works: no model of the suite has a flex.
for _struct, _owner in (("mjmodel", mujoco.MjModel), ("mjdata", mujoco.MjData)):
    for _name in [one for one in sizes.array_sizes[_struct] if not hasattr(_owner, one)]:
        del sizes.array_sizes[_struct][_name]

from dm_control import mujoco as dm_mujoco  # noqa: E402 - reads the list that was mended above
from dm_control import suite  # noqa: E402 - likewise


def look(name: str, cameras: list[str]) -> PeerModel:
    """Load "domain.task" and let dm_control draw all cameras."""
    domain, _, task = name.partition(".")
    environment = suite.load(domain, task, task_kwargs={"random": 0})
    environment.reset()
    physics = environment.physics
    model = copy_model(physics.model.ptr)
    qpos = turn_joints(model, physics.data.qpos)
    with physics.reset_context():  # ends with a forward
        physics.data.qpos[:] = qpos
    said = {name: _look_through(physics, model, name) for name in cameras}
    environment.close()
    return PeerModel(model, qpos, said)


def _look_through(physics: dm_mujoco.Physics, model: mujoco.MjModel, name: str) -> Said:
    camera = dm_mujoco.Camera(physics, HEIGHT, WIDTH, camera_id=-1 if name == FREE else name)
    depth = camera.render(depth=True).copy()
    matrices = camera.matrices()
    # Its camera frame is MuJoCo's, x right, y up, z backward; ours has y down and z forward, and
    # its image is that of -K: the same matrix for homogeneous pixels.
    flip = np.diag([1.0, -1.0, -1.0])
    K = -matrices.image @ matrices.focal[:, :3] @ flip
    T_cam_world = np.diag([1.0, -1.0, -1.0, 1.0]) @ matrices.rotation @ matrices.translation
    return Said(
        camera=_make_free_camera(model) if name == FREE else name,
        depth=depth,
        K=K,
        T_world_cam=np.linalg.inv(T_cam_world),
    )


def _make_free_camera(model: mujoco.MjModel) -> mujoco.MjvCamera:
    """Make the camera that dm_control takes for its number -1."""
    camera = mujoco.MjvCamera()
    mujoco.mjv_defaultFreeCamera(model, camera)
    return camera
