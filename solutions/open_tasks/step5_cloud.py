"""Step 5: a camera that is mounted half a degree off, and a depth that is two percent long."""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np

import labutils as lab
from labutils.figures import plot_histogram, plot_lines
from solutions._open_answers import Finding

CAMERA, WIDTH, HEIGHT = "head_camera", 320, 240
HALF_DEGREE = np.radians(0.5)


@dataclass(frozen=True)
class _Cloud:
    """Points of one picture in the camera frame, their truth in the room, and their pixels."""

    points: np.ndarray
    truth: np.ndarray
    bodies: np.ndarray
    pose: np.ndarray

    def move(self, points: np.ndarray, turn: np.ndarray | None = None) -> np.ndarray:
        """Move points into the room, with a camera that is turned or not."""
        R = self.pose[:3, :3] if turn is None else self.pose[:3, :3] @ turn
        return points @ R.T + self.pose[:3, 3]

    def get_errors_mm(self, world: np.ndarray) -> np.ndarray:
        """Return how far each point is from its truth."""
        return 1000 * np.linalg.norm(world - self.truth, axis=1)


def measure_strong() -> Finding:
    """Pitch the mounted camera, predict the error of every point, and fit two planes."""
    cloud, names = _make_cloud()
    c, s = np.cos(HALF_DEGREE), np.sin(HALF_DEGREE)
    pitched = cloud.move(cloud.points, np.array([[1, 0, 0], [0, c, -s], [0, s, c]]))
    error_mm = cloud.get_errors_mm(pitched)
    across = np.hypot(cloud.points[:, 1], cloud.points[:, 2])  # from the axis of the turn
    predicted_mm = 2000 * np.sin(HALF_DEGREE / 2) * across
    clean = cloud.get_errors_mm(cloud.move(cloud.points)) < 1  # off depth edges
    table = clean & (cloud.bodies == names["table"]) & (abs(cloud.truth[:, 2] - 0.86) < 1e-3)
    front = np.median(cloud.truth[cloud.bodies == names["wall"]][:, 0])
    wall = clean & (cloud.bodies == names["wall"]) & (abs(cloud.truth[:, 0] - front) < 1e-3)
    low, high = across[clean].min(), across[clean].max()
    edges = np.linspace(low, high, 15)
    nearest = [clean & (across >= a) & (across <= b) for a, b in itertools.pairwise(edges)]
    filled = [one for one in nearest if one.any()]  # no surface is at some distances
    up, ahead = _fit_normal(pitched[table]), _fit_normal(pitched[wall])
    return Finding(
        {
            "box_mm": float(np.median(error_mm[cloud.bodies == names["red_box"]])),
            "wall_mm": float(np.median(error_mm[wall])),
            "largest_gap_mm": float(np.abs(error_mm - predicted_mm)[clean].max()),
            "tilt_deg": float(np.degrees(np.arccos(abs(up[2])))),
            "angle_deg": float(np.degrees(np.arccos(abs(up @ ahead)))),
        },
        plot_lines(
            np.array([np.median(across[one]) for one in filled]),
            {
                "measured": np.array([np.median(error_mm[one]) for one in filled]),
                "predicted": np.array([np.median(predicted_mm[one]) for one in filled]),
            },
            x_label="distance from the camera's x axis (m)",
            y_label="error (mm)",
        ),
    )


def measure_typical() -> Finding:
    """Stretch the depth, and sum the error up over all points."""
    cloud, names = _make_cloud()
    before_mm = cloud.get_errors_mm(cloud.move(cloud.points))
    stretched = cloud.move(1.02 * cloud.points)
    error_mm = cloud.get_errors_mm(stretched)
    table = (cloud.bodies == names["table"]) & (abs(cloud.truth[:, 2] - 0.86) < 1e-3)
    return Finding(
        {
            "mean_mm": float(error_mm.mean()),
            "largest_mm": float(error_mm.max()),
            "largest_before_mm": float(before_mm.max()),
            "too_low_mm": float(1000 * (0.86 - np.median(stretched[table][:, 2]))),
        },
        plot_histogram({"points": error_mm}, label="error (mm)"),
    )


def _make_cloud() -> tuple[_Cloud, dict[str, int]]:
    model, data = lab.make_scene()
    with lab.make_renderer(model, HEIGHT, WIDTH) as renderer:
        _, depth = lab.render_camera(model, data, renderer, CAMERA)
        bodies = lab.render_segmentation(model, data, renderer, CAMERA)
    truth = lab.raycast_points(model, data, CAMERA, WIDTH, HEIGHT)
    known = lab.find_valid_depth(depth) & np.isfinite(truth).all(axis=-1)
    K, _ = lab.get_camera_intrinsics(model, CAMERA, WIDTH, HEIGHT)
    pixels = np.stack(np.nonzero(known)[::-1], axis=-1)
    points = lab.pixels_to_points(pixels, depth[known], K).astype(float)
    names = {model.body(i).name: i for i in range(model.nbody)}
    pose = lab.get_camera_pose(model, data, CAMERA)
    return _Cloud(points, truth[known], bodies[known], pose), names


def _fit_normal(points: np.ndarray) -> np.ndarray:
    """Return the direction in which a plane of points is thinnest."""
    _, _, axes = np.linalg.svd(points - points.mean(axis=0), full_matrices=False)
    return np.asarray(axes[2])
