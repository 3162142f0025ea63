"""Truth without OpenGL: one ray per pixel, cast against the scene's exact geometry.

The ray caster knows nothing of depth buffers, clip planes or focal lengths derived from pictures:
it asks MuJoCo where a straight line meets a surface. That makes it the reference that every
measured number of the book is compared with, and a stand-in renderer where no OpenGL works.
Taught in: step 3 and step 5.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from labutils._ray_casting import cast_rays, get_pixel_rays
from labutils.cameras import get_camera_pose
from labutils.renderers.rays import RaycastRenderer

if TYPE_CHECKING:
    import mujoco

    from labutils.cameras import Camera

__all__ = ["RaycastRenderer", "get_pixel_rays", "raycast_depth", "raycast_points"]


def raycast_depth(
    model: mujoco.MjModel, data: mujoco.MjData, camera_name: Camera, width: int, height: int
) -> np.ndarray:
    """Measure the true depth of every pixel.

    Convention
    ----------
    Rays leave through pixel centers: integer (u, v) is the center. Depth is the distance along
    the optical axis, not the length of the ray. Rays hit geoms of the groups that MuJoCo draws by
    default, and nothing else; `RaycastRenderer` says where that differs from OpenGL.

    Parameters
    ----------
    model, data : mujoco.MjModel, mujoco.MjData
        The scene, forwarded.
    camera_name : str, int or mujoco.MjvCamera
        Name or number of a camera of the model, or the free camera of a viewer.
    width, height : int
        Picture size in pixels.

    Returns
    -------
    ndarray, float32, shape (H, W)
        Meters; NaN where the ray meets nothing.

    Raises
    ------
    TypeError, ValueError
        If the model has no such camera, or the state was never forwarded.
    """
    rays = get_pixel_rays(model, data, camera_name, width, height)
    origin = get_camera_pose(model, data, camera_name)[:3, 3]
    return cast_rays(model, data, origin, rays)[0].astype(np.float32)


def raycast_points(
    model: mujoco.MjModel, data: mujoco.MjData, camera_name: Camera, width: int, height: int
) -> np.ndarray:
    """Find the world point that every pixel looks at.

    Parameters
    ----------
    model, data, camera_name, width, height
        As in `raycast_depth`.

    Returns
    -------
    ndarray, float64, shape (H, W, 3)
        World coordinates in meters; NaN where the ray meets nothing.

    Raises
    ------
    TypeError, ValueError
        If the model has no such camera, or the state was never forwarded.
    """
    rays_world = get_pixel_rays(model, data, camera_name, width, height)
    origin = get_camera_pose(model, data, camera_name)[:3, 3]
    depth = cast_rays(model, data, origin, rays_world)[0]
    return origin + depth[..., None] * rays_world
