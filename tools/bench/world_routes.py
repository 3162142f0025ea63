"""The routes of tools/bench/clouds.py that end in the world: clouds, and the last step alone."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

from tools.bench.routes import make_open3d_legacy
from tools.bench.serving import Frame, Route, make_pose, serve

if TYPE_CHECKING:
    import numpy as np


def make_route(name: str, frame: Frame) -> Route:
    """Build one route, ready to run."""
    return globals()[f"make_{name}"](frame)


def make_cloud_labutils(frame: Frame) -> Route:
    """Our own two functions."""
    from labutils import camera_to_world, depth_to_pointcloud  # noqa: PLC0415 - one process, one library

    rgb, depth, K, xpos, xmat = (frame[name] for name in ("rgb", "depth", "K", "xpos", "xmat"))

    def run() -> tuple[np.ndarray, np.ndarray | None]:
        points, colors = depth_to_pointcloud(depth, K, rgb)
        return camera_to_world(points, xpos, xmat), colors

    return run


def make_cloud_numpy(frame: Frame) -> Route:
    """Our cloud, turned by NumPy's matrix product."""
    from labutils import depth_to_pointcloud  # noqa: PLC0415 - one process, one library

    rgb, depth, K = frame["rgb"], frame["depth"], frame["K"]
    turn, position = split_pose(frame, depth.dtype)

    def run() -> tuple[np.ndarray, np.ndarray | None]:
        points, colors = depth_to_pointcloud(depth, K, rgb)
        return points @ turn + position, colors

    return run


def make_cloud_open3d(frame: Frame) -> Route:
    """Open3D's first interface, which takes the pose of the world in the camera."""
    return make_open3d_legacy(frame["rgb"], frame["depth"], frame["K"], pose=make_pose(frame))


def make_cloud_open3d_prebuilt(frame: Frame) -> Route:
    """Have Open3D's images made beforehand."""
    inputs = frame["rgb"], frame["depth"], frame["K"]
    return make_open3d_legacy(*inputs, pose=make_pose(frame), prebuilt=True)


def make_turn_labutils(frame: Frame) -> Route:
    """Our own function, checks included."""
    from labutils import camera_to_world  # noqa: PLC0415 - one process, one library

    points, xpos, xmat = frame["points"], frame["xpos"], frame["xmat"]
    return lambda: (camera_to_world(points, xpos, xmat), None)


def make_turn_opencv(frame: Frame) -> Route:
    """OpenCV's function alone."""
    import cv2  # noqa: PLC0415 - one process, one library

    pixels, pose = frame["points"][:, None], make_pose(frame)
    return lambda: (cv2.transform(pixels, pose)[:, 0], None)


def make_turn_numpy(frame: Frame) -> Route:
    """Write it as one does at first."""
    points = frame["points"]
    turn, position = split_pose(frame, points.dtype)
    return lambda: (points @ turn + position, None)


make_turn_numpy_one_thread = make_turn_numpy  # its process is told so


def make_turn_numpy_product(frame: Frame) -> Route:
    """Rotate alone."""
    points = frame["points"]
    turn = split_pose(frame, points.dtype)[0]
    return lambda: (points @ turn, None)


def make_turn_numpy_sum(frame: Frame) -> Route:
    """Add the position alone."""
    points = frame["points"]
    position = split_pose(frame, points.dtype)[1]
    return lambda: (points + position, None)


def split_pose(frame: Frame, dtype: np.dtype) -> tuple[np.ndarray, np.ndarray]:
    """Return what rows of points are multiplied by, and what is added then, in their precision."""
    pose = make_pose(frame).astype(dtype)
    return pose[:, :3].T, pose[:, 3]


if __name__ == "__main__":
    sys.exit(serve(make_route))
