"""A textured room for the extensions: its pictures can be matched, its truth is exact."""

from labutils.room.cache import record_once
from labutils.room.scene import make_room, set_baseline, set_pose
from labutils.room.walk import Walk, measure_imu

__all__ = ["Walk", "make_room", "measure_imu", "record_once", "set_baseline", "set_pose"]
