"""A smooth walk around the table, and what an inertial sensor in the head feels on it.

The joints follow uniform quintic B-splines: position, velocity and acceleration are polynomials
known exactly at every time. The robot starts at rest.
"""

from __future__ import annotations

from dataclasses import dataclass

import mujoco
import numpy as np
from tqdm import tqdm

from labutils.room.scene import IMU, JOINTS

#: Seconds that the walk takes, that one round takes, and between two control points.
DURATION, ROUND, KNOT = 26.0, 24.0, 0.1
#: Half axes of the ellipse along x and y, in meters.
RADII = (1.35, 1.15)
#: Steps in a second.
STEPS = 1.6

_DEGREE = 5
#: Powers of the time between two knots (rows) to the six control points around it, times 120.
_BASIS = np.array(
    [
        [1, 26, 66, 26, 1, 0],
        [-5, -50, 0, 50, 5, 0],
        [10, 20, -60, 20, 10, 0],
        [-10, 20, 0, -20, 10, 0],
        [5, -20, 30, -20, 5, 0],
        [-1, 5, -10, 10, -5, 1],
    ]
) / 120.0  # fmt: skip


@dataclass(frozen=True)
class ImuRecord:
    """What an inertial measurement unit felt, without noise and bias.

    Parameters
    ----------
    time : ndarray, float64, shape (N,)
        Seconds since the start.
    gyro : ndarray, float64, shape (N, 3)
        Angular velocity in rad/s, in the sensor's frame.
    accel : ndarray, float64, shape (N, 3)
        Specific force in m/s2, in the sensor's frame: 9.81 upward at rest.
    position : ndarray, float64, shape (N, 3)
        Where the sensor truly was, world, in meters.
    rotation : ndarray, float64, shape (N, 3, 3)
        From the sensor's frame to the world.
    """

    time: np.ndarray
    gyro: np.ndarray
    accel: np.ndarray
    position: np.ndarray
    rotation: np.ndarray


class Walk:
    """The walk, to be asked at any time from 0 to `DURATION`."""

    def __init__(self) -> None:
        self._points = _make_control_points()

    def __call__(self, time: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return position, velocity and acceleration of all joints, in the order of `JOINTS`.

        Raises
        ------
        ValueError
            If the walk does not last so long.
        """
        if not 0 <= time <= DURATION:
            raise ValueError(f"time: expected 0 to {DURATION} s, got {time}")
        span = min(int(time / KNOT), len(self._points) - _DEGREE - 2)
        u = time / KNOT - span
        points = _BASIS @ self._points[span : span + _DEGREE + 1]
        power = np.arange(_DEGREE + 1)
        place = u**power
        speed = power[1:] * u ** power[:-1] / KNOT
        change = power[2:] * power[1:-1] * u ** power[:-2] / KNOT**2
        return place @ points, speed @ points[1:], change @ points[2:]


def put(model: mujoco.MjModel, data: mujoco.MjData, walk: Walk, time: float) -> None:
    """Put the robot where it is at a time of its walk, moving as it moves then.

    Positions, velocities and accelerations are prescribed; the sensors of the model then read
    what they would feel. ``mj_forward`` would let the robot fall instead.
    """
    data.time = time
    data.qpos[:], data.qvel[:], data.qacc[:] = walk(time)
    mujoco.mj_inverse(model, data)


def measure_imu(
    model: mujoco.MjModel,
    data: mujoco.MjData,
    walk: Walk,
    *,
    rate: float = 200.0,
    progress: bool = True,
) -> ImuRecord:
    """Walk, and read the inertial sensor of the head at a fixed rate.

    Parameters
    ----------
    model, data : mujoco.MjModel, mujoco.MjData
        A room from `make_room`.
    walk : Walk
        Where the robot is when.
    rate : float
        Readings per second.
    progress : bool
        Show a progress bar.

    Returns
    -------
    ImuRecord
        Exact readings and the exact pose of the sensor.
    """
    times = np.arange(round(DURATION * rate)) / rate
    site = data.site(IMU)
    gyro, accel, position, rotation = [], [], [], []
    for time in tqdm(times, desc="inertial sensor", disable=not progress):
        put(model, data, walk, time)
        gyro.append(data.sensor("gyro").data.copy())
        accel.append(data.sensor("accelerometer").data.copy())
        position.append(site.xpos.copy())
        rotation.append(site.xmat.reshape(3, 3).copy())
    return ImuRecord(times, *map(np.array, (gyro, accel, position, rotation)))


def _make_control_points() -> np.ndarray:
    """Return what the joints are drawn to, one row every `KNOT` seconds."""
    count = round(DURATION / KNOT) + 1
    # Six equal points at the start: there the curve has no velocity and no acceleration.
    time = np.maximum(np.arange(count + _DEGREE) - _DEGREE, 0) * KNOT
    started = 1 - np.exp(-time / 1.2)
    step = 2 * np.pi * STEPS * time
    angle = np.pi + 2 * np.pi * (time - 1.2 * started) / ROUND
    x, y = RADII[0] * np.cos(angle), RADII[1] * np.sin(angle)
    sway = 0.012 * np.sin(step / 2) * started
    columns = {
        "base_x": x - sway * np.sin(angle),
        "base_y": y + sway * np.cos(angle),
        "base_z": 0.012 * np.sin(step) * started,
        "base_yaw": np.unwrap(np.arctan2(-y, -x)) + 0.03 * np.sin(step / 2) * started,
        "neck_pan": 0.3 * np.sin(2 * np.pi * time / 9) * started,
        "neck_tilt": 0.33
        + 0.10 * np.sin(2 * np.pi * time / 6.5) * started
        + 0.01 * np.sin(step) * started,
    }
    return np.stack([columns[name] for name in JOINTS], axis=1)
