"""What a chapter imports: render a scene, measure it, and compare with the truth.

Frames, units and pixel grid are stated once, on the book's conventions page; names carry them.
Everything that needs MuJoCo is imported on first use, so that the rest also runs where MuJoCo does
not exist: in the browser.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from labutils._constants import HSV_RANGES, MAX_DEPTH, MIN_DEPTH
from labutils.checks import check, hint, report
from labutils.color_segmentation import (
    find_object_centroid,
    segment_by_color,
    visualize_detection,
)
from labutils.depth_processing import (
    find_valid_depth,
    get_clip_planes,
    metric_to_raw,
    process_depth,
    render_raw_depth,
    visualize_depth,
)
from labutils.ply import write_ply
from labutils.pointcloud import (
    camera_to_world,
    depth_to_pointcloud,
    pixels_to_points,
    points_to_pixels,
    visualize_pointcloud,
    world_to_camera,
)
from labutils.rendering import NoOpenGLWarning, choose_gl_backend, is_gl_available, make_renderer

if TYPE_CHECKING:
    from labutils.camera_utils import (
        get_camera_intrinsics,
        get_camera_pose,
        intrinsics_matrix,
        render_camera,
        render_segmentation,
    )
    from labutils.outputs import (
        save_depth_view,
        save_detection_result,
        save_outputs,
        save_pointcloud_xyz,
        save_rgb_view,
        save_scene_pointcloud,
    )
    from labutils.raycast import raycast_depth, raycast_points
    from labutils.scene import make_scene

choose_gl_backend()  # MuJoCo reads MUJOCO_GL once, at import: so here, before anything imports it

__version__ = "0.1.0"

#: Public name to the module it lives in, for what needs MuJoCo.
_NEEDS_MUJOCO = {
    "get_camera_intrinsics": "camera_utils",
    "get_camera_pose": "camera_utils",
    "intrinsics_matrix": "camera_utils",
    "make_scene": "scene",
    "raycast_depth": "raycast",
    "raycast_points": "raycast",
    "render_camera": "camera_utils",
    "render_segmentation": "camera_utils",
    "save_depth_view": "outputs",
    "save_detection_result": "outputs",
    "save_outputs": "outputs",
    "save_pointcloud_xyz": "outputs",
    "save_rgb_view": "outputs",
    "save_scene_pointcloud": "outputs",
}


def __getattr__(name: str) -> Any:
    if name not in _NEEDS_MUJOCO:
        raise AttributeError(f"module 'labutils' has no attribute {name!r}")
    return getattr(import_module(f"labutils.{_NEEDS_MUJOCO[name]}"), name)


def __dir__() -> list[str]:
    return sorted(__all__)


__all__ = [
    "HSV_RANGES",
    "MAX_DEPTH",
    "MIN_DEPTH",
    "NoOpenGLWarning",
    "camera_to_world",
    "check",
    "depth_to_pointcloud",
    "find_object_centroid",
    "find_valid_depth",
    "get_camera_intrinsics",
    "get_camera_pose",
    "get_clip_planes",
    "hint",
    "intrinsics_matrix",
    "is_gl_available",
    "make_renderer",
    "make_scene",
    "metric_to_raw",
    "pixels_to_points",
    "points_to_pixels",
    "process_depth",
    "raycast_depth",
    "raycast_points",
    "render_camera",
    "render_raw_depth",
    "render_segmentation",
    "report",
    "save_depth_view",
    "save_detection_result",
    "save_outputs",
    "save_pointcloud_xyz",
    "save_rgb_view",
    "save_scene_pointcloud",
    "segment_by_color",
    "visualize_depth",
    "visualize_detection",
    "visualize_pointcloud",
    "world_to_camera",
    "write_ply",
]
