"""Right answers to project_visible_points, written in ways that the card does not contain."""

import cv2
import numpy as np


def visible_by_homogeneous(
    points_world: np.ndarray, T_world_cam: np.ndarray, K: np.ndarray, depth_metric: np.ndarray
) -> tuple[np.ndarray, list[bool]]:
    points = np.linalg.solve(T_world_cam, np.c_[points_world, np.ones(len(points_world))].T)[:3]
    u, v, z = K @ points
    pixels = np.where(z > 0.01, [u / z, v / z], np.nan).T
    surface = np.where((depth_metric > 0.01) & (depth_metric < 10), depth_metric, np.inf)
    seen = []
    for (column, row), depth in zip(pixels, z, strict=True):
        inside = (
            depth > 0.01
            and -0.5 <= column < depth_metric.shape[1] - 0.5
            and -0.5 <= row < depth_metric.shape[0] - 0.5
        )
        seen.append(bool(inside and depth - 0.02 <= surface[round(row), round(column)]))
    return pixels, seen


def visible_by_cv2(
    points_world: np.ndarray, T_world_cam: np.ndarray, K: np.ndarray, depth_metric: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    back = np.linalg.inv(T_world_cam)
    turn, _ = cv2.Rodrigues(back[:3, :3])
    pixels = cv2.projectPoints(points_world, turn, back[:3, 3], K, None)[0][:, 0]
    z = (back @ np.c_[points_world, np.ones(len(points_world))].T)[2]
    pixels[z <= 0.01] = np.nan
    padded = np.pad(depth_metric, 1, constant_values=-1)  # a frame that says: outside
    u, v = np.clip(np.nan_to_num(np.rint(pixels), nan=-1).astype(int), -1, None).T
    u, v = np.minimum(u, depth_metric.shape[1]), np.minimum(v, depth_metric.shape[0])
    found = padded[v + 1, u + 1]
    hides = (found > 0.01) & (found < 10) & (z > found + 0.02)
    return pixels, (found != -1) & ~hides


def visible_in_single_precision(
    points_world: np.ndarray, T_world_cam: np.ndarray, K: np.ndarray, depth_metric: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    pixels, seen = visible_by_homogeneous(points_world, T_world_cam, K, depth_metric)
    return pixels.astype(np.float32), np.array(seen)


VARIANTS = [visible_by_homogeneous, visible_by_cv2, visible_in_single_precision]
