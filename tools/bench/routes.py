"""The routes that tools/bench/clouds.py compares, each for a process of its own.

Clouds in the camera frame, and pictures; clouds in the world are in `tools.bench.world_routes`.
"""

from __future__ import annotations

import sys
from typing import Any

import numpy as np

from tools.bench.serving import MAX_DEPTH, MIN_DEPTH, Frame, Route, serve


def make_labutils(rgb: np.ndarray, depth: np.ndarray, K: np.ndarray) -> Route:
    """Our own function."""
    from labutils import depth_to_pointcloud  # noqa: PLC0415 - one process, one library

    return lambda: depth_to_pointcloud(depth, K, rgb)


def make_open3d_legacy(
    rgb: np.ndarray,
    depth: np.ndarray,
    K: np.ndarray,
    *,
    pose: np.ndarray | None = None,
    prebuilt: bool = False,
) -> Route:
    """Open3D's first interface; its filter is the far limit, and nothing here is too near.

    `pose` (3, 4) takes its points into the world. Without one it turns them all the same.
    """
    import open3d as o3d  # noqa: PLC0415 - one process, one library

    extrinsic: np.ndarray = np.eye(4)
    if pose is not None:
        extrinsic[:3] = pose
        extrinsic = np.linalg.inv(extrinsic)

    height, width = depth.shape
    camera = o3d.camera.PinholeCameraIntrinsic(width, height, K[0, 0], K[1, 1], K[0, 2], K[1, 2])

    geometry: Any = o3d.geometry  # whose types do not know NumPy

    def make_images() -> Any:
        return geometry.RGBDImage.create_from_color_and_depth(
            geometry.Image(rgb),
            geometry.Image(depth),
            depth_scale=1.0,
            depth_trunc=MAX_DEPTH,
            convert_rgb_to_intensity=False,
        )

    kept = make_images() if prebuilt else None

    def run() -> tuple[np.ndarray, np.ndarray]:
        images = make_images() if kept is None else kept
        cloud = o3d.geometry.PointCloud.create_from_rgbd_image(images, camera, extrinsic)
        return np.asarray(cloud.points), np.asarray(cloud.colors)

    return run


def make_open3d_tensor(
    rgb: np.ndarray, depth: np.ndarray, K: np.ndarray, *, prebuilt: bool = False
) -> Route:
    """Open3D's second interface, on the processor."""
    import open3d as o3d  # noqa: PLC0415 - one process, one library

    core: Any = o3d.core  # whose types do not know NumPy
    camera = core.Tensor(K)

    def make_images() -> Any:
        return o3d.t.geometry.RGBDImage(o3d.t.geometry.Image(rgb), o3d.t.geometry.Image(depth))

    kept = make_images() if prebuilt else None

    def run() -> tuple[np.ndarray, np.ndarray]:
        cloud = o3d.t.geometry.PointCloud.create_from_rgbd_image(
            make_images() if kept is None else kept, camera, depth_scale=1.0, depth_max=MAX_DEPTH
        )
        return cloud.point.positions.numpy(), cloud.point.colors.numpy()

    return run


def make_textbook(rgb: np.ndarray, depth: np.ndarray, K: np.ndarray) -> Route:
    """Back-project every pixel with whole-picture arrays, then throw away the invalid ones."""

    def run() -> tuple[np.ndarray, np.ndarray]:
        u, v = np.meshgrid(np.arange(depth.shape[1]), np.arange(depth.shape[0]))
        x = (u - K[0, 2]) * depth / K[0, 0]
        y = (v - K[1, 2]) * depth / K[1, 1]
        kept = ((depth > MIN_DEPTH) & (depth < MAX_DEPTH)).ravel()
        points = np.stack([x, y, depth], axis=-1).reshape(-1, 3)[kept]
        return points, rgb.reshape(-1, 3)[kept] / 255.0

    return run


def make_opencv(rgb: np.ndarray, depth: np.ndarray, K: np.ndarray) -> Route:  # noqa: ARG001
    """OpenCV's back-projection: four numbers per pixel, whether it saw something or not."""
    import cv2  # noqa: PLC0415 - one process, one library

    return lambda: (cv2.depthTo3d(depth, K), None)


def make_copy(rgb: np.ndarray, depth: np.ndarray, K: np.ndarray) -> Route:  # noqa: ARG001
    """Touch every input byte once."""
    return lambda: (depth.copy(), rgb.copy())


def make_renderers() -> dict[str, Route]:
    """All ways to draw a frame, each with a renderer of its own."""
    import mujoco  # noqa: PLC0415 - labutils chooses the OpenGL backend first

    from labutils import make_scene, render_camera  # noqa: PLC0415 - one process, one library

    model, data = make_scene()
    renderer = mujoco.Renderer(model, 480, 640)

    def bare() -> tuple[np.ndarray, np.ndarray]:
        renderer.update_scene(data, camera="head_camera")
        rgb = renderer.render()
        renderer.enable_depth_rendering()
        depth = renderer.render()
        renderer.disable_depth_rendering()
        return rgb, depth

    def color(*, shadow: bool = True) -> tuple[np.ndarray, None]:
        renderer.update_scene(data, camera="head_camera")
        renderer.scene.flags[mujoco.mjtRndFlag.mjRND_SHADOW] = shadow
        return renderer.render(), None

    return {
        "bare": bare,
        "render_camera": lambda: render_camera(model, data, renderer, "head_camera"),
        "color": color,
        "color_no_shadow": lambda: color(shadow=False),
    }


def make_route(name: str, frame: Frame) -> Route:
    """Build one route, ready to run."""
    inputs = frame["rgb"], frame["depth"], frame["K"]
    base = name.removesuffix("_prebuilt")
    if f"make_{base}" not in globals():
        return make_renderers()[name]
    options = {"prebuilt": True} if name != base else {}
    return globals()[f"make_{base}"](*inputs, **options)


if __name__ == "__main__":
    sys.exit(serve(make_route))
