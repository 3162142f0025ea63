"""Right answers to locate_ball, written in ways that the card does not contain."""

from typing import Any

import cv2
import numpy as np

import labutils as lab


def find_points(mask: np.ndarray, depth: np.ndarray, K: np.ndarray, radius: float) -> np.ndarray:
    """The points of the ball, (N, 3); N may be 0."""
    z = np.where((mask > 0) & lab.find_valid_depth(depth), depth, np.float32(np.inf))
    seen = np.isfinite(z) & (z < z.min() + 2 * radius)
    v, u = np.nonzero(seen)
    return lab.pixels_to_points(np.column_stack([u, v]), z[seen], K)


def ball_behind_the_nearest_point(mask: Any, depth: Any, K: Any, radius: Any) -> Any:
    points = find_points(mask, depth, K, radius)
    if not len(points):
        return None
    distances = np.linalg.norm(points, axis=1)
    nearest = distances.argmin()
    return points[nearest] * (distances[nearest] + radius) / distances[nearest]


def ball_behind_the_smallest_depth(mask: Any, depth: Any, K: Any, radius: Any) -> Any:
    best = None
    height, width = mask.shape
    for v in range(height):
        for u in range(width):
            z = float(depth[v, u])
            if mask[v, u] and 0.01 < z < 10 and (best is None or z < best[2]):
                best = (u, v, z)
    if best is None:
        return None
    u, v, z = best
    return [(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z + radius]


def ball_by_its_outline(mask: Any, depth: Any, K: Any, radius: Any) -> Any:
    centroid = lab.find_object_centroid(mask)  # whole pixels
    near = depth[(mask > 0) & lab.find_valid_depth(depth)]
    if centroid is None or not near.size:
        return None
    u, v = centroid
    z = float(near.min()) + radius
    return (u - K[0, 2]) / K[0, 0] * z, (v - K[1, 2]) / K[1, 1] * z, z


def ball_by_a_patch(mask: Any, depth: Any, K: Any, radius: Any) -> Any:
    u, v = (int(one) for one in lab.find_object_centroid(mask) or (0, 0))
    patch = depth[v - 2 : v + 3, u - 2 : u + 3]
    if not (mask.any() and lab.find_valid_depth(patch).any()):
        return None
    z = np.median(patch[lab.find_valid_depth(patch)])
    surface = z * np.linalg.inv(K) @ [u, v, 1]
    return surface + radius * surface / np.linalg.norm(surface)


def ball_behind_the_mean(mask: Any, depth: Any, K: Any, radius: Any) -> Any:
    points = find_points(mask, depth, K, radius)
    if not len(points):
        return None
    mean = points.mean(axis=0)
    return mean * (1 + 2 / 3 * radius / np.linalg.norm(mean))


def ball_by_a_sphere_of_any_size(mask: Any, depth: Any, K: Any, radius: Any) -> Any:
    # |p|^2 = 2 p c + (r^2 - |c|^2) is linear in the center c and in what is in parentheses
    points = find_points(mask, depth, K, radius)
    if not len(points):
        return None
    left = np.column_stack([2 * points, np.ones(len(points))])
    return np.linalg.lstsq(left, (points**2).sum(axis=1), rcond=None)[0][:3]


def ball_by_a_circle_in_single_precision(mask: Any, depth: Any, K: Any, radius: Any) -> Any:
    contours, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    points = find_points(mask, depth, K, radius)
    if not contours or not len(points):
        return None
    moments = cv2.moments(max(contours, key=cv2.contourArea))
    pixel = np.array([moments["m10"], moments["m01"]], np.float32) / np.float32(moments["m00"])
    way = np.append((pixel - K[:2, 2]) / K[[0, 1], [0, 1]], 1).astype(np.float32)
    way /= np.linalg.norm(way)
    nearest = np.linalg.norm(points.astype(np.float32), axis=1).min()
    return way * (nearest + np.float32(radius))


def ball_by_its_mean_ray(mask: Any, depth: Any, K: Any, radius: Any) -> Any:
    points = find_points(mask, depth, K, radius)
    if not len(points):
        return None
    way = np.median(points / points[:, 2:], axis=0)
    distances = np.linalg.norm(points, axis=1)
    # Half of a disk lies within 0.71 of its radius; there the front is 0.71 radii nearer.
    return way / np.linalg.norm(way) * (np.median(distances) + radius / np.sqrt(2))


VARIANTS = [
    ball_behind_the_nearest_point,
    ball_behind_the_smallest_depth,
    ball_by_its_outline,
    ball_by_a_patch,
    ball_behind_the_mean,
    ball_by_a_sphere_of_any_size,
    ball_by_a_circle_in_single_precision,
    ball_by_its_mean_ray,
]
