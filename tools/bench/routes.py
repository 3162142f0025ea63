"""The routes that tools/bench/clouds.py compares, and the process that runs one of them.

Every route starts from NumPy arrays and ends with NumPy arrays. Started as a script, with a route
and a frame, it answers each line "run N" on its standard input with the seconds of N runs.
"""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

#: Route to its name in the table. The first one is what the others are compared with.
CLOUD = {
    "labutils": "`labutils.depth_to_pointcloud`",
    "open3d_legacy": "Open3D, `o3d.geometry`",
    "open3d_legacy_prebuilt": "Open3D, `o3d.geometry`, its images made beforehand",
    "open3d_tensor": "Open3D, `o3d.t.geometry`",
    "open3d_tensor_prebuilt": "Open3D, `o3d.t.geometry`, its images made beforehand",
    "textbook": "the lab sheet's way, plain NumPy",
    "opencv": "`cv2.depthTo3d`: no colors, no filter",
    "copy": "copying the two pictures: no cloud at all",
}
RENDER = {
    "bare": "two bare passes of `mujoco.Renderer`",
    "render_camera": "`labutils.render_camera`",
    "color": "the bare color pass alone",
    "color_no_shadow": "the bare color pass alone, without shadows",
}

#: Routes that do less than the others, so their results cannot agree.
NOT_COMPARABLE = {"opencv", "copy", "color", "color_no_shadow"}

MIN_DEPTH, MAX_DEPTH = 0.01, 10.0

Route = Callable[[], tuple[Any, Any]]


def make_labutils(rgb: np.ndarray, depth: np.ndarray, K: np.ndarray) -> Route:
    """Our own function."""
    from labutils import depth_to_pointcloud  # noqa: PLC0415 - one process, one library

    return lambda: depth_to_pointcloud(depth, K, rgb)


def make_open3d_legacy(
    rgb: np.ndarray, depth: np.ndarray, K: np.ndarray, *, prebuilt: bool = False
) -> Route:
    """Open3D's first interface; its filter is the far limit, and nothing here is too near."""
    import open3d as o3d  # noqa: PLC0415 - one process, one library

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
        cloud = o3d.geometry.PointCloud.create_from_rgbd_image(images, camera)
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


def make_route(name: str, frame: Path) -> Route:
    """Build one route, ready to run."""
    if name in RENDER:
        return make_renderers()[name]
    with np.load(frame) as file:
        inputs = file["rgb"], file["depth"], file["K"]
    base = name.removesuffix("_prebuilt")
    options = {"prebuilt": True} if name != base else {}
    return globals()[f"make_{base}"](*inputs, **options)


def sort_cloud(points: np.ndarray, colors: np.ndarray | None) -> list[np.ndarray]:
    """Sort points by where they are: Open3D's threads hand them over in any order."""
    if colors is None or np.ndim(points) != 2 or points.shape[1:] != (3,):
        return [np.asarray(points)]
    # The bearing x/z, y/z is the pixel; rounded, so that float32 and float64 sort alike.
    bearing = np.round(points[:, :2] / points[:, 2:] * 1e4).astype(int)
    order = np.lexsort((bearing[:, 0], bearing[:, 1]))
    return [points[order], colors[order]]


def measure(route: Route) -> float:
    """Run once; return seconds."""
    started = time.perf_counter()
    route()  # the result is dropped at once: handing memory back is part of the price
    return time.perf_counter() - started


def main() -> int:
    """Serve one route until the input ends."""
    route = make_route(sys.argv[1], Path(sys.argv[2]))
    # The answers get the real output; whatever a library prints goes to the error output.
    answers = os.fdopen(os.dup(1), "w", buffering=1)
    os.dup2(2, 1)
    for line in sys.stdin:
        command, _, argument = line.strip().partition(" ")
        if command == "save":
            np.savez(argument, *sort_cloud(*route()))
            answers.write("saved\n")
            continue
        answers.write(" ".join(str(measure(route)) for _ in range(int(argument))) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
