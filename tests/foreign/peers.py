"""Load a peer's model, pose it, and let the peer itself look at it first.

Everything a peer says is taken down before the library draws: a peer keeps its OpenGL context for
the current one, and would draw into nothing after a renderer of ours was closed.
"""

from __future__ import annotations

import copy
import functools
import importlib
from collections.abc import Callable
from dataclasses import dataclass

import mujoco
import numpy as np

from labutils.cameras import Camera
from tests.foreign.views import VIEWS

#: Turns of the joints away from where a peer's own reset puts them: radians, or meters of a slide.
_TURN = 0.15


@dataclass(frozen=True)
class Said:
    """What a peer says about one camera at the pose.

    Attributes
    ----------
    camera : str or mujoco.MjvCamera
        What `render_camera` gets: a name, or the peer's own free camera.
    depth : ndarray, float32, shape (H, W)
        Meters, by the peer's own conversion where it has one.
    K : ndarray, float64, shape (3, 3), or None
        Intrinsic matrix in OpenCV's frame, None where the peer has none.
    T_world_cam : ndarray, float64, shape (4, 4), or None
        Pose in OpenCV's frame, None where the peer has none.
    """

    camera: Camera
    depth: np.ndarray
    K: np.ndarray | None = None
    T_world_cam: np.ndarray | None = None


@dataclass(frozen=True)
class PeerModel:
    """A peer's model, apart from the peer; a pose; and what the peer says of it by camera."""

    model: mujoco.MjModel
    qpos: np.ndarray
    said: dict[str, Said]
    scene_option: mujoco.MjvOption | None = None

    def make_data(self) -> mujoco.MjData:
        """Make a state that was posed and never forwarded, as many a reader does."""
        data = mujoco.MjData(self.model)
        data.qpos[:] = self.qpos
        return data

    def make_stepped_data(self, count: int = 40) -> mujoco.MjData:
        """Make a state after some steps: all positions lag one step behind its qpos."""
        data = self.make_data()
        rng = np.random.default_rng(1)
        limited = self.model.actuator_ctrllimited.astype(bool)
        low, high = np.where(limited[:, None], self.model.actuator_ctrlrange, (-1, 1)).T
        for _ in range(count):
            data.ctrl[:] = rng.uniform(low, high)
            mujoco.mj_step(self.model, data)
        return data


@functools.cache
def load(peer: str, name: str) -> PeerModel:
    """Load one model of a peer with all the cameras that `views` names."""
    cameras = [view.camera for view in VIEWS if (view.peer, view.model) == (peer, name)]
    look: Callable[[str, list[str]], PeerModel]
    look = importlib.import_module(f"tests.foreign.peer_{peer}").look
    return look(name, cameras)


def turn_joints(model: mujoco.MjModel, qpos: np.ndarray) -> np.ndarray:
    """Turn every hinge and slide a little, always the same way."""
    turned = qpos.copy()
    single = (model.jnt_type == mujoco.mjtJoint.mjJNT_HINGE.value) | (
        model.jnt_type == mujoco.mjtJoint.mjJNT_SLIDE.value
    )
    places = model.jnt_qposadr[single]
    # A slide moves by a share of the model's size: 15 cm are much for a small one.
    is_slide = model.jnt_type[single] == mujoco.mjtJoint.mjJNT_SLIDE.value
    sizes = np.where(is_slide, min(1.0, 0.1 * model.stat.extent), 1.0)
    turned[places] += np.random.default_rng(0).uniform(-_TURN, _TURN, len(places)) * sizes
    return turned


def copy_model(model: mujoco.MjModel) -> mujoco.MjModel:
    """Copy a model, so that neither side changes the other's."""
    return copy.deepcopy(model)
