"""Valid input of the exercises between depth images and clouds."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from solutions._cases import make_rotation
from tools.mutants.inputs.pictures import make_depths, make_size

if TYPE_CHECKING:
    from collections.abc import Callable


def _make_intrinsics(rng: np.random.Generator, height: int, width: int) -> np.ndarray:
    fx, fy = rng.uniform(0.4, 3, size=2) * max(height, width)
    cx, cy = rng.uniform(-0.2, 1.2, size=2) * [width, height]
    return np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]])


def _make_pose(rng: np.random.Generator) -> np.ndarray:
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = make_rotation(rng, 0.0, 3.1), rng.uniform(-2, 2, size=3)
    return pose


def _depth_to_pointcloud(rng: np.random.Generator) -> tuple[Any, ...]:
    height, width = make_size(rng, 6)
    if rng.random() < 0.15:  # several blocks of rows
        height, width = int(rng.integers(79, 170)), int(rng.integers(1, 3))
    depth = make_depths(rng, height, width)
    if rng.random() < 0.2:
        depth = depth.astype(np.float64)
    rgb = rng.integers(0, int(rng.choice([2, 200, 256])), (height, width, 3)).astype(np.uint8)
    return depth, _make_intrinsics(rng, height, width), rgb if rng.random() < 0.5 else None


def _measure_object_size(rng: np.random.Generator) -> tuple[Any, ...]:
    while True:
        height, width = make_size(rng, 8)
        depth = make_depths(rng, height, width)
        board = rng.random((height, width)) < 0.6
        gaps = rng.choice(
            [0.0, 0.03, -0.03, 0.047, -0.047, 0.054, -0.054, 0.3], size=(height, width)
        )
        middle = float(rng.choice([0.05, 0.7, 1.5, 9.95]))
        depth[board] = (middle + gaps)[board] + rng.uniform(-0.002, 0.002)
        mask = (rng.random((height, width)) < rng.choice([0.4, 0.9])).astype(np.uint8) * 255
        valid = depth[(mask > 0) & (depth > 0.01) & (depth < 10)].astype(np.float64)
        # Something valid in the mask, and nothing so close to a limit that rounding decides.
        gaps = np.abs(valid - np.median(valid)) if valid.size else np.array([1.0])
        if (gaps < 0.05).any() and (np.abs(gaps - 0.05) > 1e-4).all():
            return mask, depth, _make_intrinsics(rng, height, width)


def _nearest_object(rng: np.random.Generator) -> tuple[Any, ...]:
    while True:
        height, width = make_size(rng, 9)
        K = _make_intrinsics(rng, height, width)
        depth = make_depths(rng, height, width)
        count = int(rng.integers(0, 5))
        labels = rng.integers(0, count + 1, size=(height, width)).astype(np.int32)
        if rng.random() < 0.6:  # in one piece each
            labels = np.sort(labels, axis=1)
        for label in range(1, count + 1):
            seen = (labels == label) & (rng.random(labels.shape) < 0.8)
            depth[seen] = rng.uniform(0.5, 3) + rng.uniform(
                -0.05, 0.05, size=np.count_nonzero(seen)
            )
        if rng.random() < 0.1:  # an object without a valid depth
            depth[labels == 1] = rng.choice([0.0, 12.0])
        if not set(range(1, count + 1)) <= set(labels.ravel().tolist()):
            continue  # every number from 1 on is an object
        max_width = float(rng.choice([0.0, 0.02, 0.2, 0.5, 1.0, 3.0, 50.0]))
        if _is_certain(labels, depth, K, max_width):
            return labels, depth, K, _make_pose(rng), max_width


def _is_certain(labels: np.ndarray, depth: np.ndarray, K: np.ndarray, max_width: float) -> bool:
    """Tell whether no width is close to the limit and no two distances are alike."""
    distances = []
    for label in range(1, labels.max() + 1):
        v, u = np.nonzero((depth > 0.01) & (depth < 10) & (labels == label))
        if not v.size:
            continue
        z = depth[v, u].astype(np.float64)
        x, y = (u - K[0, 2]) / K[0, 0] * z, (v - K[1, 2]) / K[1, 1] * z
        if 0 < abs(np.ptp(x) - max_width) < 1e-4:
            return False
        distances.append(np.linalg.norm([np.median(x), np.median(y), np.median(z)]))
    return len(distances) < 2 or float(np.diff(np.sort(distances)).min()) > 1e-4


def _crop_region(rng: np.random.Generator) -> tuple[Any, ...]:
    low = rng.uniform(-1, 0.5, size=3)
    high = low + rng.uniform(0.1, 2, size=3)
    pose, margin = _make_pose(rng), 1e-4
    points = rng.uniform(low - 0.5, high + 0.5, size=(int(rng.integers(0, 12)), 3))
    if rng.random() < 0.2:  # eighths of a meter and no turn: exact, so that limits are met
        low, high, pose, margin = np.round(8 * low) / 8, np.round(8 * high) / 8, np.eye(4), -1.0
        points = np.round(8 * points) / 8
        pose[:3, 3] = np.round(8 * rng.uniform(-1, 1, size=3)) / 8
    near = (np.abs(points - low) < margin) | (np.abs(points - high) < margin)
    points = points[~near.any(axis=1)]
    return points @ pose[:3, :3].T + pose[:3, 3], pose, low, high


def _level_cloud(rng: np.random.Generator) -> tuple[Any, ...]:
    """Draw a table within 2 mm, smaller than half of all points or not, things and a floor."""
    table = rng.uniform([-0.6, -0.4, -0.002], [0.6, 0.4, 0.002], size=(120, 3))
    things = rng.uniform([-0.3, -0.2, 0.03], [0.1, 0.3, 0.4], size=(int(rng.integers(0, 80)), 3))
    floor = rng.uniform([-1.5, -1, -0.72], [1.5, 1, -0.68], size=(int(rng.integers(0, 60)), 3))
    points = rng.permutation(np.concatenate([table, things, floor]))
    while True:
        rotation = make_rotation(rng, 0.1, 3.0)
        if rotation[2, 2] > -0.95:  # at -1 the smallest rotation is not unique
            break
    camera = rng.uniform([-1, -1, 0.5], [1, 1, 2.0])
    return ((points - camera) @ rotation.T,)


def _project_visible_points(rng: np.random.Generator) -> tuple[Any, ...]:
    height, width = make_size(rng, 7)
    depth, K, pose = (
        make_depths(rng, height, width),
        _make_intrinsics(rng, height, width),
        _make_pose(rng),
    )
    count = int(rng.integers(1, 12))
    u, v = rng.integers(-2, width + 2, count), rng.integers(-2, height + 2, count)
    inside = (u >= 0) & (u < width) & (v >= 0) & (v < height)
    z = rng.choice([0.02, 0.5, 1.5, 9.0, 30.0], size=count)
    seen = depth[v[inside], u[inside]]
    z[inside] = np.where(np.isfinite(seen) & (seen > 0.02), seen, z[inside])
    z += rng.choice([0.0, 0.0, 0.015, 0.025, 0.3, -0.3, 2.0], size=count)
    z = np.where(rng.random(count) < 0.1, rng.choice([0.005, -0.5, -2.0, 0.012], count), z)
    z = np.where(np.abs(z) < 0.002, 0.5, z)
    shift = rng.uniform(-0.45, 0.45, size=(count, 2))
    places = (np.stack([u, v], axis=1) + shift - K[:2, 2]) / K[[0, 1], [0, 1]] * z[:, None]
    world = np.column_stack([places, z]) @ pose[:3, :3].T + pose[:3, 3]
    return world, pose, K, depth


def _draw_top_view(rng: np.random.Generator) -> tuple[Any, ...]:
    scale = int(rng.integers(1, 40))
    height, width = map(int, rng.integers(1, 7, size=2))
    high = rng.uniform(-2, 3, size=2)
    # Where the size is rounded up, no point lies in the picture, but beyond the limits.
    low = high - (np.array([height, width]) - rng.uniform(-0.4, 0.4, size=2)) / scale
    count = int(rng.integers(0, 25))
    row, column = rng.integers(-2, height + 2, count), rng.integers(-2, width + 2, count)
    shift = rng.uniform(0.05, 0.55, size=(count, 2))
    places = high - (np.stack([row, column], axis=1) + shift) / scale
    heights = (rng.permutation(count) - float(rng.uniform(0, count + 1))) / 10
    return np.column_stack([places, heights]), rng.random((count, 3)), low, high, scale


MAKERS: dict[str, Callable[[np.random.Generator], tuple[Any, ...]]] = {
    "depth_to_pointcloud": _depth_to_pointcloud,
    "measure_object_size": _measure_object_size,
    "nearest_object": _nearest_object,
    "crop_region": _crop_region,
    "level_cloud": _level_cloud,
    "project_visible_points": _project_visible_points,
    "draw_top_view": _draw_top_view,
}
