"""Where the point cloud explorer starts: its limits, its first view, and checks of what came in."""

from __future__ import annotations

import numbers
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from labutils._constants import MAX_DEPTH, TURN_WORLD
from labutils._guards import check_pixel, check_pose, check_real_array
from labutils._splat import get_view_point
from labutils.depth_values import find_valid_depth

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

#: The slider of the field of view reaches from half the true angle to twice it, within these.
_FOV_LIMITS_DEG = (1.0, 150.0)
_FAR_STEP = 0.1
#: First place to look from: beside and above the camera, so that its rays can be seen.
_AZIMUTH_DEG, _ELEVATION_DEG = 40.0, -5.0
_DISTANCE = 1.65  # in radii of the cloud
#: How far from the middle of the cloud toward the camera one looks, so that both are in sight.
_TOWARD_CAMERA = 0.05


class Limits(NamedTuple):
    """Of the sliders (least, most), and of the scales of the colors [least, most]."""

    fov_y_deg: float
    fov: tuple[float, float]
    far: tuple[float, float]
    depth: list[float]
    height: list[float]


def turn_to_view(T_world_cam: np.ndarray | None) -> np.ndarray:
    """Build the transform (4x4) from the camera frame to the frame the reader orbits in.

    That frame has x right, y down and z forward: the camera frame itself where no pose is known,
    else the world turned.
    """
    if T_world_cam is None:
        return np.eye(4)
    turn = np.eye(4)
    turn[:3, :3] = TURN_WORLD
    return turn @ T_world_cam


def find_limits(
    points: np.ndarray, K: np.ndarray, rows: int, T_world_cam: np.ndarray | None
) -> Limits:
    """Derive all limits from a cloud in the camera frame and its picture's matrix and height."""
    fov_y_deg = float(np.degrees(2 * np.arctan(rows / 2 / K[1, 1])))
    least, most = _FOV_LIMITS_DEG
    if not least < fov_y_deg < most:
        raise ValueError(
            f"K: expected a field of view of {least:g} to {most:g} degrees from top to bottom, "
            f"got {fov_y_deg:.1f}"
        )
    near, far = float(points[:, 2].min()), float(points[:, 2].max())
    # The next tenth beyond the farthest point, or the library's own limit: either keeps them all.
    end = min(MAX_DEPTH, round((np.floor(far / _FAR_STEP) + 1) * _FAR_STEP, 6))
    begin = round(np.floor(near / _FAR_STEP) * _FAR_STEP, 6)
    T_view_cam = turn_to_view(T_world_cam)
    heights = -(points @ T_view_cam[1, :3] + T_view_cam[1, 3])
    low, high = np.percentile(heights, [0.5, 99.5])
    return Limits(
        fov_y_deg=fov_y_deg,
        fov=(
            float(np.floor(max(least, fov_y_deg / 2))),
            float(np.ceil(min(most, 2 * fov_y_deg))),
        ),
        far=(max(float(begin), 0.05), float(end)),
        depth=[near, max(far, near + 0.01)],
        height=[float(low), max(float(high), float(low) + 0.01)],
    )


def make_start_orbit(points: np.ndarray, T_world_cam: np.ndarray | None) -> dict[str, Any]:
    """Choose where to look from first: from behind the camera's right shoulder."""
    T_view_cam = turn_to_view(T_world_cam)
    forward = T_view_cam[:3, 2]
    azimuth_deg = float(np.degrees(np.arctan2(-forward[0], forward[2]))) + _AZIMUTH_DEG
    elevation_deg = float(np.degrees(np.arcsin(np.clip(forward[1], -1, 1)))) + _ELEVATION_DEG
    middle, eye = get_view_point(points @ T_view_cam[:3, :3].T + T_view_cam[:3, 3])
    target = middle + _TOWARD_CAMERA * (T_view_cam[:3, 3] - middle)
    return {
        "azimuth_deg": round(azimuth_deg, 3),
        "elevation_deg": round(min(elevation_deg, 85.0), 3),
        "distance": round(_DISTANCE * float(np.linalg.norm(eye - middle)), 3),
        "target": [round(float(value), 3) for value in target],
    }


def check_transform(value: Any) -> np.ndarray:
    """Return a pose as float64 (4, 4)."""
    matrix = check_real_array("T_world_cam", value).astype(np.float64)
    if matrix.shape != (4, 4) or not np.array_equal(matrix[3], [0, 0, 0, 1]):
        raise ValueError(
            "T_world_cam: expected a 4x4 matrix with the last row 0, 0, 0, 1, "
            f"got {matrix.tolist()}"
        )
    check_pose(matrix[:3, 3], matrix[:3, :3])
    return matrix


def find_stretch(fov_y_deg: float, true_fov_y_deg: float) -> float:
    """Return how many times too wide a cloud is with an assumed field of view."""
    half, true_half = np.radians([fov_y_deg / 2, true_fov_y_deg / 2])
    return float(np.tan(half) / np.tan(true_half))


def check_fov(fov_y: Any, limits: tuple[float, float]) -> float:
    """Return an angle in radians as one of the slider's, in degrees."""
    if isinstance(fov_y, bool) or not isinstance(fov_y, numbers.Real):
        raise TypeError(f"fov_y: expected a number, got {type(fov_y).__name__} {fov_y!r}")
    degrees = float(np.degrees(float(fov_y)))
    if not limits[0] <= degrees <= limits[1]:
        least, most = limits
        raise ValueError(
            f"fov_y: expected {least:g} to {most:g} degrees in radians, got {degrees:g} degrees"
        )
    return round(degrees, 1)


def check_faces(faces: Mapping[str, Sequence[Sequence[int]]], depth: np.ndarray) -> list[list[Any]]:
    """Return two faces as [name, three pixels] each."""
    if len(faces) != 2 or any(len(pixels) != 3 for pixels in faces.values()):
        raise ValueError(
            "faces: expected two names with three pixels each, "
            f"got { ({name: len(pixels) for name, pixels in faces.items()}) }"
        )
    valid = find_valid_depth(depth)
    height, width = depth.shape
    checked: list[list[Any]] = []
    for name, pixels in faces.items():
        three = [list(check_pixel(f"faces: {name!r}", one, width, height)) for one in pixels]
        for u, v in three:
            if not valid[v, u]:
                raise ValueError(f"faces: expected a surface at ({u}, {v}) of {name!r}, got none")
        (u0, v0), (u1, v1), (u2, v2) = three
        if (u1 - u0) * (v2 - v0) == (u2 - u0) * (v1 - v0):
            raise ValueError(f"faces: expected three pixels of {name!r} not on a line, got {three}")
        checked.append([name, three])
    return checked
