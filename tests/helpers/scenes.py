"""Known geometry to look at, and random places to look from."""

from __future__ import annotations

import mujoco
import numpy as np

#: A camera with fx != fy, cx != cy and its principal point off center, one given by fovy, and one
#: without perspective; a box and a sphere before a wall.
ASYMMETRIC_SCENE = """
<mujoco>
  <statistic extent="2"/>
  <visual><map znear="0.01" zfar="6"/><global offwidth="800" offheight="800"/></visual>
  <worldbody>
    <light pos="0 0 3"/>
    <geom name="wall" type="box" size="0.05 3 3" pos="3 0 0"/>
    <body name="ball" pos="2 0.3 0.2"><geom type="sphere" size="0.05"/></body>
    <body name="cube" pos="1.5 -0.4 -0.1" euler="20 30 40"><geom type="box" size=".1 .1 .1"/></body>
    <camera name="sensor" xyaxes="0 -1 0 0 0 1" sensorsize="0.006 0.004" focal="0.005 0.006"
            principal="0.0006 0.0005" resolution="640 480"/>
    <camera name="plain" xyaxes="0 -1 0 0 0 1" fovy="50"/>
    <camera name="flat" xyaxes="0 -1 0 0 0 1" projection="orthographic"/>
  </worldbody>
</mujoco>
"""


def make_asymmetric_scene() -> tuple[mujoco.MjModel, mujoco.MjData]:
    """Compile and forward the asymmetric scene."""
    model = mujoco.MjModel.from_xml_string(ASYMMETRIC_SCENE)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    return model, data


def move_neck(model: mujoco.MjModel, data: mujoco.MjData, rng: np.random.Generator) -> None:
    """Turn the head of the book's scene to a random pose within its joints' range."""
    for name in ("neck_pan", "neck_tilt"):
        joint = model.joint(name)
        low, high = joint.range
        data.qpos[joint.qposadr[0]] = rng.uniform(0.8 * low, 0.8 * high)
    mujoco.mj_forward(model, data)


def find_depth_edges(depth: np.ndarray, jump: float = 0.02) -> np.ndarray:
    """Mark pixels next to a depth jump, where half a pixel decides which surface is seen.

    A jump is a neighbor (of eight) whose depth differs by more than `jump` meters, or who sees
    nothing.
    """
    padded = np.pad(np.nan_to_num(depth, nan=1e3), 1, mode="edge")
    windows = np.lib.stride_tricks.sliding_window_view(padded, (3, 3))
    return np.ptp(windows, axis=(2, 3)) > jump
