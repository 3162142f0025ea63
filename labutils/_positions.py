"""Bring everything up to date that a picture shows, and change nothing else of a state."""

from __future__ import annotations

from contextlib import contextmanager
from typing import TYPE_CHECKING

import mujoco

if TYPE_CHECKING:
    from collections.abc import Iterator

#: What `mujoco.mj_sensorPos` may write: arrays, and the mark that the energy is up to date.
_WRITTEN_BY_SENSORS = ("sensordata", "energy", "history")
_MARK = "flg_energypos"


def update_positions(model: mujoco.MjModel, data: mujoco.MjData) -> None:
    """Compute from ``qpos`` where bodies, geoms, cameras, lights, flexes and tendons are.

    The full ``mj_forward`` would also run contacts, forces and sensors, which no picture shows by
    default: these calls leave accelerations and sensor data alone. The order is that of
    ``mj_fwdPosition``: a camera may follow a center of mass, a tendon may wrap around a geom.
    """
    mujoco.mj_kinematics(model, data)
    mujoco.mj_comPos(model, data)
    mujoco.mj_camlight(model, data)
    mujoco.mj_flex(model, data)
    mujoco.mj_tendon(model, data)


@contextmanager
def range_finders_measured(model: mujoco.MjModel, data: mujoco.MjData) -> Iterator[None]:
    """Let the range finders hold what they measure now, inside the block only.

    A range finder is drawn as a line of the length in ``sensordata``. The sensors have to measure
    for the picture, and what they hold belongs to whoever stepped the simulation.
    """
    if not (model.sensor_type == int(mujoco.mjtSensor.mjSENS_RANGEFINDER)).any():
        yield
        return
    kept = {name: getattr(data, name).copy() for name in _WRITTEN_BY_SENSORS}
    mark = getattr(data, _MARK)
    try:
        mujoco.mj_sensorPos(model, data)
        yield
    finally:
        for name, values in kept.items():
            getattr(data, name)[:] = values
        setattr(data, _MARK, mark)
