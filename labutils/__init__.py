"""What a chapter imports: render a scene, measure it, and compare with the truth.

Frames, units and pixel grid are stated once, on the book's conventions page; names carry them.
"""

from labutils.rendering import NoOpenGLWarning, choose_gl_backend, is_gl_available, make_renderer

choose_gl_backend()  # MuJoCo reads MUJOCO_GL once, at import: so before the imports below

from labutils._constants import HSV_RANGES, MAX_DEPTH, MIN_DEPTH
from labutils.camera_utils import (
    get_camera_intrinsics,
    get_camera_pose,
    intrinsics_matrix,
    make_scene,
    render_camera,
    render_segmentation,
)
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
from labutils.outputs import (
    save_depth_view,
    save_detection_result,
    save_outputs,
    save_pointcloud_xyz,
    save_rgb_view,
    save_scene_pointcloud,
)
from labutils.pointcloud import (
    camera_to_world,
    depth_to_pointcloud,
    pixels_to_points,
    points_to_pixels,
    visualize_pointcloud,
    world_to_camera,
    write_ply,
)
from labutils.raycast import raycast_depth, raycast_points

__version__ = "0.1.0"

__all__ = [
    "HSV_RANGES",
    "MAX_DEPTH",
    "MIN_DEPTH",
    "NoOpenGLWarning",
    "camera_to_world",
    "depth_to_pointcloud",
    "find_object_centroid",
    "find_valid_depth",
    "get_camera_intrinsics",
    "get_camera_pose",
    "get_clip_planes",
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
