"""Make drake's cloud in the world of a depth image: run by the Python of its own environment.

Usage: ``python tests/foreign/drake_clouds.py FRAME.npz CLOUD.npz``. A frame has ``depth`` (float32,
H x W, meters), ``K`` (3 x 3), ``T_world_cam`` (4 x 4, OpenCV's frame) and ``fov_y`` (radians). The
cloud has ``points`` (N x 3, world, without those that drake itself marks as not finite), ``K`` as
drake derives it from the angle, and drake's ``version``.
"""

from __future__ import annotations

import sys
from importlib.metadata import version

import numpy as np
from pydrake.math import RigidTransform
from pydrake.perception import DepthImageToPointCloud
from pydrake.systems.sensors import CameraInfo, ImageDepth32F, PixelType


def main(frame_path: str, cloud_path: str) -> None:
    """Read a frame, write a cloud."""
    with np.load(frame_path) as frame:
        depth, K, T_world_cam = frame["depth"], frame["K"], frame["T_world_cam"]
        fov_y = float(frame["fov_y"])
    height, width = depth.shape
    info = CameraInfo(width, height, K[0, 0], K[1, 1], K[0, 2], K[1, 2])
    system = DepthImageToPointCloud(info, PixelType.kDepth32F)
    context = system.CreateDefaultContext()
    image = ImageDepth32F(width, height)
    image.mutable_data[:] = depth[..., None]
    system.depth_image_input_port().FixValue(context, image)
    system.camera_pose_input_port().FixValue(context, RigidTransform(T_world_cam))
    points = system.point_cloud_output_port().Eval(context).xyzs().T
    np.savez(
        cloud_path,
        points=points[np.isfinite(points).all(axis=1)],
        K=CameraInfo(width, height, fov_y).intrinsic_matrix(),
        version=version("drake"),
    )


if __name__ == "__main__":
    main(*sys.argv[1:])
