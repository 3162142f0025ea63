"""What a chapter imports: render a scene, measure it, and compare with the truth.

Frames, units and pixel grid are stated once, on the book's conventions page; names carry them.
Everything that needs more than NumPy is imported on first use: geometry stands on NumPy alone, and
what needs no MuJoCo also runs where it does not exist, in the browser.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from labutils._constants import HSV_RANGES, MAX_DEPTH, MIN_DEPTH
from labutils.cameras import get_camera_intrinsics, get_camera_pose, intrinsics_matrix
from labutils.depth_values import (
    find_valid_depth,
    get_clip_planes,
    get_depth_limits,
    metric_to_raw,
    process_depth,
)
from labutils.ply import read_ply, read_ply_comments, write_ply
from labutils.projection import (
    camera_to_world,
    pixels_to_points,
    points_to_pixels,
    world_to_camera,
)
from labutils.rendering import NoOpenGLWarning, choose_gl_backend, is_gl_available, make_renderer

if TYPE_CHECKING:
    from labutils.camera_utils import render_camera, render_segmentation
    from labutils.checks import check, hint, report
    from labutils.color_segmentation import (
        find_object_centroid,
        segment_by_color,
        visualize_detection,
    )
    from labutils.depth_processing import render_raw_depth, visualize_depth
    from labutils.following import command_from_pixel
    from labutils.outputs import (
        save_depth_view,
        save_detection_result,
        save_outputs,
        save_pointcloud_xyz,
        save_rgb_view,
        save_scene_pointcloud,
    )
    from labutils.pointcloud import depth_to_pointcloud, visualize_pointcloud
    from labutils.raycast import raycast_depth, raycast_points
    from labutils.renderers.omissions import NotDrawnWarning
    from labutils.scene import make_scene
    from labutils.showing import show
    from labutils.stereo import depth_to_disparity, disparity_to_depth
    from labutils.stereo_matching import matching_cost, ssd_disparity
    from labutils.stereo_refining import lr_check, subpixel

choose_gl_backend()  # MuJoCo reads MUJOCO_GL once, at import: so here, before anything imports it

__version__ = "0.1.0"

#: Public name to the module it lives in, for what needs more than NumPy.
_ON_FIRST_USE = {
    "NotDrawnWarning": "renderers.omissions",
    "check": "checks",
    "command_from_pixel": "following",
    "depth_to_disparity": "stereo",
    "depth_to_pointcloud": "pointcloud",
    "disparity_to_depth": "stereo",
    "find_object_centroid": "color_segmentation",
    "hint": "checks",
    "lr_check": "stereo_refining",
    "make_scene": "scene",
    "matching_cost": "stereo_matching",
    "raycast_depth": "raycast",
    "raycast_points": "raycast",
    "render_camera": "camera_utils",
    "render_raw_depth": "depth_processing",
    "render_segmentation": "camera_utils",
    "report": "checks",
    "save_depth_view": "outputs",
    "save_detection_result": "outputs",
    "save_outputs": "outputs",
    "save_pointcloud_xyz": "outputs",
    "save_rgb_view": "outputs",
    "save_scene_pointcloud": "outputs",
    "segment_by_color": "color_segmentation",
    "show": "showing",
    "ssd_disparity": "stereo_matching",
    "subpixel": "stereo_refining",
    "visualize_depth": "depth_processing",
    "visualize_detection": "color_segmentation",
    "visualize_pointcloud": "pointcloud",
}


def __getattr__(name: str) -> Any:
    if name in _ON_FIRST_USE:
        return getattr(import_module(f"labutils.{_ON_FIRST_USE[name]}"), name)
    if name in _ON_FIRST_USE.values():
        return import_module(f"labutils.{name}")  # ``labutils.pointcloud`` without an import of it
    raise AttributeError(f"module 'labutils' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted(__all__)


__all__ = [
    "HSV_RANGES",
    "MAX_DEPTH",
    "MIN_DEPTH",
    "NoOpenGLWarning",
    "NotDrawnWarning",
    "camera_to_world",
    "check",
    "command_from_pixel",
    "depth_to_disparity",
    "depth_to_pointcloud",
    "disparity_to_depth",
    "find_object_centroid",
    "find_valid_depth",
    "get_camera_intrinsics",
    "get_camera_pose",
    "get_clip_planes",
    "get_depth_limits",
    "hint",
    "intrinsics_matrix",
    "is_gl_available",
    "lr_check",
    "make_renderer",
    "make_scene",
    "matching_cost",
    "metric_to_raw",
    "pixels_to_points",
    "points_to_pixels",
    "process_depth",
    "raycast_depth",
    "raycast_points",
    "read_ply",
    "read_ply_comments",
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
    "show",
    "ssd_disparity",
    "subpixel",
    "visualize_depth",
    "visualize_detection",
    "visualize_pointcloud",
    "world_to_camera",
    "write_ply",
]
