"""Pictures of a rectified pair whose disparity is known, by rays against exact geometry."""

from __future__ import annotations

from dataclasses import dataclass

import mujoco
import numpy as np

from labutils import get_camera_intrinsics, raycast_depth, raycast_points
from labutils.stereo import depth_to_disparity

BASELINE = 0.1

#: A box and a ball before a wall; the right camera stands a baseline along x of the left one.
_SCENE = f"""
<mujoco>
  <worldbody>
    <geom name="wall" type="box" size="0.05 4 4" pos="2.55 0 0"/>
    <geom name="box" type="box" size="0.1 0.2 0.15" pos="1.1 0.15 0.05"/>
    <geom name="ball" type="sphere" size="0.15" pos="1.5 -0.3 -0.1"/>
    <geom name="ramp" type="box" size="2 0.4 0.02" pos="1.6 0 -0.5" euler="0 -6 0"/>
    <camera name="left" pos="0 {BASELINE / 2} 0" xyaxes="0 -1 0 0 0 1" fovy="58"/>
    <camera name="right" pos="0 {-BASELINE / 2} 0" xyaxes="0 -1 0 0 0 1" fovy="58"/>
  </worldbody>
</mujoco>
"""


@dataclass(frozen=True)
class KnownPair:
    """A pair of gray pictures, float32, with the depth images of both cameras and their K."""

    left: np.ndarray
    right: np.ndarray
    depth: np.ndarray
    depth_right: np.ndarray
    K: np.ndarray
    baseline: float

    @property
    def disparity(self) -> np.ndarray:
        """The true disparity of the left picture."""
        return depth_to_disparity(self.depth, self.K, self.baseline)


def make_known_pair(width: int = 160, height: int = 120, noise: float = 0.0) -> KnownPair:
    """Look at textured things with both cameras.

    The texture is a smooth function of the place in the world, so both cameras see the same gray
    value at the same place, whatever the pixel grid is: pictures of a surface that scatters light.
    """
    model = mujoco.MjModel.from_xml_string(_SCENE)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    K, _ = get_camera_intrinsics(model, "left", width, height)
    rng = np.random.default_rng(3)
    waves, phases = rng.normal(0, 30, (3, 40)), rng.uniform(0, 2 * np.pi, 40)
    pictures, depths = [], []
    for camera in ("left", "right"):
        points = raycast_points(model, data, camera, width, height)
        gray = 128 + 18 * np.sin(points @ waves + phases).sum(axis=-1)
        pictures.append((gray + rng.normal(0, noise, gray.shape)).astype(np.float32))
        depths.append(raycast_depth(model, data, camera, width, height))
    (left, right), (depth, depth_right) = pictures, depths
    return KnownPair(left, right, depth, depth_right, K, BASELINE)
