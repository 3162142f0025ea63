"""Look at a point cloud: a window, an off-screen picture, or our own point renderer.

Taught in: step 6.
"""

from __future__ import annotations

import contextlib
import functools
import importlib.util
import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from labutils._picture import Picture
from labutils._splat import get_depth_colors, get_view_point
from labutils._versions import is_older
from labutils.figures import plot_cloud

if TYPE_CHECKING:
    from collections.abc import Iterator

_SIZE = (960, 720)  # width, height of an off-screen picture
_FRAME_SIZE = 0.2  # length of the drawn coordinate axes in meters


def show_cloud(points: np.ndarray, colors: np.ndarray | None) -> Picture | None:
    """Show points the best way this machine can; see `visualize_pointcloud`."""
    if find_open3d_problem() is not None:
        return plot_cloud(points, colors)
    if _has_screen():
        _show_window(points, colors)
        return None
    if _ends_without_screen():
        return plot_cloud(points, colors)
    try:
        return _draw_off_screen(points, colors)
    except RuntimeError:
        # No Vulkan driver: Open3D says so with a RuntimeError, and our renderer needs none.
        return plot_cloud(points, colors)


@functools.cache
def find_open3d_problem() -> str | None:
    """Say why Open3D cannot be used here, or return None.

    Returns
    -------
    str or None
        "not installed", or the message of the failed import (without the EGL library Open3D is
        installed but cannot be loaded).
    """
    if importlib.util.find_spec("open3d") is None:
        if sys.platform == "emscripten":
            return "no web page has Open3D: the book's own renderer draws"
        return "Open3D is not installed: pip install open3d"
    # In a notebook Open3D would start a web server for its viewer and print about it.
    os.environ.setdefault("OPEN3D_DISABLE_WEB_VISUALIZER", "true")
    try:
        import open3d as o3d  # noqa: PLC0415 - the import itself is the question
    except (ImportError, OSError) as error:
        return f"Open3D cannot be loaded: {error}"
    # Its notes about missing screens would stand above every picture.
    o3d.utility.set_verbosity_level(o3d.utility.VerbosityLevel.Error)
    return None


def make_open3d_cloud(points: np.ndarray, colors: np.ndarray | None = None) -> Any:
    """Turn arrays into an Open3D point cloud.

    Parameters
    ----------
    points : ndarray, shape (N, 3)
        Meters.
    colors : ndarray, shape (N, 3), optional
        RGB in [0, 1].

    Returns
    -------
    open3d.geometry.PointCloud
        The same points, in double precision.

    Raises
    ------
    ImportError
        If Open3D is not installed or cannot be loaded, with the reason.
    """
    problem = find_open3d_problem()
    if problem is not None:
        raise ImportError(problem)
    import open3d as o3d  # noqa: PLC0415 - a second and a hundred megabytes: only when asked for

    cloud = o3d.geometry.PointCloud()
    cloud.points = o3d.utility.Vector3dVector(np.asarray(points, dtype=np.float64))
    if colors is not None:
        cloud.colors = o3d.utility.Vector3dVector(np.asarray(colors, dtype=np.float64))
    return cloud


def _has_screen() -> bool:
    if os.name == "posix" and sys.platform != "darwin":
        return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))
    # A notebook server on macOS or Windows has a screen too, but a window would block the cell.
    return "ipykernel" not in sys.modules


def _show_window(points: np.ndarray, colors: np.ndarray | None) -> None:
    import open3d as o3d  # noqa: PLC0415 - see make_open3d_cloud

    axes = o3d.geometry.TriangleMesh.create_coordinate_frame(size=_FRAME_SIZE)
    o3d.visualization.draw_geometries([make_open3d_cloud(points, colors), axes])


def _draw_off_screen(points: np.ndarray, colors: np.ndarray | None) -> Picture:
    """Draw with Open3D's own renderer into memory."""
    import open3d as o3d  # noqa: PLC0415 - see make_open3d_cloud

    renderer = _make_off_screen_renderer()
    renderer.scene.clear_geometry()
    material = o3d.visualization.rendering.MaterialRecord()
    material.shader = "defaultUnlit"
    material.point_size = 3.0
    if colors is None:
        colors = get_depth_colors(points)
    renderer.scene.add_geometry("cloud", make_open3d_cloud(points, colors), material)
    axes = o3d.geometry.TriangleMesh.create_coordinate_frame(size=_FRAME_SIZE)
    renderer.scene.add_geometry("axes", axes, material)
    target, eye = get_view_point(points)
    renderer.setup_camera(50.0, target, eye, np.array([0.0, -1.0, 0.0]))
    image = np.asarray(renderer.render_to_image())
    return Picture.from_rgb(image, "Point cloud drawn off screen by Open3D")


@functools.cache
def _make_off_screen_renderer() -> Any:
    """Make one renderer per process: Open3D cannot make a second after the first is gone."""
    import open3d as o3d  # noqa: PLC0415 - see make_open3d_cloud

    with _quiet_stdout():
        renderer = o3d.visualization.rendering.OffscreenRenderer(*_SIZE)
    renderer.scene.set_background([1.0, 1.0, 1.0, 1.0])
    # Filmic tone mapping would change the colors of the points.
    renderer.scene.view.set_post_processing(False)
    return renderer


def _ends_without_screen() -> bool:
    """Tell whether this Open3D ends the process where EGL has no screen to draw on.

    Open3D 0.20 draws with Vulkan. Those before it need ``EGL_PLATFORM=surfaceless``, and nobody can
    catch a segmentation fault.
    """
    import open3d as o3d  # noqa: PLC0415 - see make_open3d_cloud

    on_screen = os.environ.get("EGL_PLATFORM") != "surfaceless"
    return is_older(o3d.__version__, (0, 20)) and on_screen


@contextlib.contextmanager
def _quiet_stdout() -> Iterator[None]:
    """Keep the driver's greeting, which C++ prints past Python, out of the cell's output."""
    sys.stdout.flush()
    saved = os.dup(1)
    try:
        with Path(os.devnull).open("wb") as sink:
            os.dup2(sink.fileno(), 1)
            yield
    finally:
        os.dup2(saved, 1)
        os.close(saved)
