"""The five files the lab promises, one function each, and all at once.

Taught in: steps 3 to 6. From a shell: ``python -m labutils``.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import cv2
import numpy as np
from tqdm import tqdm

from labutils._constants import HSV_RANGES
from labutils._files import write_in_one_step
from labutils._guards import check_columns, check_finite_rows, check_rgb_image
from labutils.camera_utils import render_camera
from labutils.cameras import get_camera_intrinsics
from labutils.color_segmentation import find_object_centroid, segment_by_color, visualize_detection
from labutils.depth_processing import visualize_depth
from labutils.ply import write_ply
from labutils.pointcloud import depth_to_pointcloud
from labutils.rendering import make_renderer
from labutils.scene import make_scene

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import ArrayLike


def save_rgb_view(folder: str | Path, rgb_image: np.ndarray) -> Path:
    """Write ``rgb_view.png``.

    Parameters
    ----------
    folder : path
        Made if it does not exist.
    rgb_image : array-like, uint8, shape (H, W, 3)
        RGB; the file shows the same colors.

    Returns
    -------
    pathlib.Path
        The file written.

    Raises
    ------
    TypeError, ValueError, OSError
        If the picture is not uint8 RGB, or the file cannot be written.
    """
    return _save_rgb(folder, "rgb_view.png", rgb_image)


def save_depth_view(folder: str | Path, depth_metric: np.ndarray, max_depth: float = 5.0) -> Path:
    """Write ``depth_view.png``: blue close, red at `max_depth` meters and beyond.

    `folder` as in `save_rgb_view`, other parameters and errors as in `visualize_depth`; returns the
    file written.
    """
    return _save_bgr(folder, "depth_view.png", visualize_depth(depth_metric, max_depth))


def save_detection_result(
    folder: str | Path,
    rgb_image: np.ndarray,
    centroid: tuple[int, int] | None,
    mask: np.ndarray | None = None,
) -> Path:
    """Write ``detection_result.png``: the picture with the object outlined and its center marked.

    `folder` as in `save_rgb_view`, other parameters and errors as in `visualize_detection`; returns
    the file written.
    """
    return _save_rgb(folder, "detection_result.png", visualize_detection(rgb_image, centroid, mask))


def save_scene_pointcloud(
    folder: str | Path,
    points: ArrayLike,
    colors: ArrayLike | None = None,
    *,
    frame: str | None = None,
) -> Path:
    """Write ``scene_pointcloud.ply``, with its frame in a comment: "camera", "world" or a text.

    `folder` as in `save_rgb_view`, other parameters and errors as in `write_ply`; returns the file
    written.
    """
    return write_ply(_make_folder(folder) / "scene_pointcloud.ply", points, colors, frame=frame)


def save_pointcloud_xyz(folder: str | Path, points: ArrayLike) -> Path:
    """Write ``pointcloud.xyz``: one point a line, meters with four decimals (0.1 mm).

    Parameters
    ----------
    folder : path
        Made if it does not exist.
    points : array-like, real and finite, shape (N, 3)
        Meters.

    Returns
    -------
    pathlib.Path
        The file written.

    Raises
    ------
    TypeError, ValueError, OSError
        If the points have another shape or one is not finite, or the file cannot be written.
    """
    cloud = check_finite_rows("points", check_columns("points", points, 3), np.float64)
    path = _make_folder(folder) / "pointcloud.xyz"
    # One format call for all numbers: ten times as fast as np.savetxt, byte for byte the same.
    text = ("%.4f %.4f %.4f\n" * len(cloud)) % tuple(cloud.ravel().tolist())
    return write_in_one_step(path, text.encode("ascii"))


def save_outputs(
    folder: str | Path,
    camera_name: str = "head_camera",
    width: int = 640,
    height: int = 480,
    *,
    progress: bool = False,
) -> list[Path]:
    """Run the whole lab once and write all five files.

    Parameters
    ----------
    folder : path
        Made if it does not exist.
    camera_name : str
        Camera to look through.
    width, height : int
        Picture size in pixels.
    progress : bool
        Show a progress bar on standard error.

    Returns
    -------
    list of pathlib.Path
        The five files, in the order of the lab.

    Raises
    ------
    TypeError, ValueError, OSError
        If the camera does not exist, the size is no picture size, or a file cannot be written.
    """
    folder = _make_folder(folder)
    bar = tqdm(total=6, unit="step", disable=not progress)
    with bar:
        bar.set_description("rendering")
        model, data = make_scene()
        with make_renderer(model, height, width) as renderer:
            rgb, depth = render_camera(model, data, renderer, camera_name)
        bar.update()
        K, _ = get_camera_intrinsics(model, camera_name, width, height)
        points, colors = depth_to_pointcloud(depth, K, rgb)
        mask = segment_by_color(rgb, HSV_RANGES["red"])
        centroid = find_object_centroid(mask)
        steps: dict[str, Callable[[], Path]] = {
            "rgb_view.png": lambda: save_rgb_view(folder, rgb),
            "depth_view.png": lambda: save_depth_view(folder, depth),
            "detection_result.png": lambda: save_detection_result(folder, rgb, centroid, mask),
            "scene_pointcloud.ply": lambda: save_scene_pointcloud(
                folder, points, colors, frame="camera"
            ),
            "pointcloud.xyz": lambda: save_pointcloud_xyz(folder, points),
        }
        paths = []
        for name, save in steps.items():
            bar.set_description(name)
            paths.append(save())
            bar.update()
    return paths


def _make_folder(folder: str | Path) -> Path:
    path = Path(folder)
    path.mkdir(parents=True, exist_ok=True)
    return path


def _save_rgb(folder: str | Path, name: str, rgb_image: np.ndarray) -> Path:
    rgb = check_rgb_image("rgb_image", rgb_image)
    return _save_bgr(folder, name, cv2.cvtColor(rgb, cv2.COLOR_RGB2BGR))


def _save_bgr(folder: str | Path, name: str, image_bgr: np.ndarray) -> Path:
    path = _make_folder(folder) / name
    # cv2.imwrite answers False instead of raising, and cannot open non-ASCII paths on Windows.
    done, encoded = cv2.imencode(".png", image_bgr)
    if not done:
        raise OSError(f"{name}: OpenCV could not encode the picture as PNG")
    return write_in_one_step(path, encoded.tobytes())
