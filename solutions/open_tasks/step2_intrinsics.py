"""Step 2: what a field of view that is wrong by one degree costs, and where."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

import labutils as lab
from labutils.figures import plot_lines
from solutions._open_answers import Finding

CAMERA, WIDTH, HEIGHT = "head_camera", 320, 240


@dataclass(frozen=True)
class _View:
    """The measured pixels of one picture: where, how far, what, and where they are in truth."""

    pixels: np.ndarray
    z: np.ndarray
    bodies: np.ndarray
    truth: np.ndarray
    pose: np.ndarray
    K: np.ndarray


def measure_strong() -> Finding:
    """Predict the error of every pixel, and compare with the truth near and far from the middle."""
    view, names = _take_picture()
    K_wrong, error_mm = _measure_one_degree(view)
    radius = np.hypot(*(view.pixels - view.K[:2, 2]).T)
    predicted_mm = 1000 * view.z * radius * abs(1 / view.K[0, 0] - 1 / K_wrong[0, 0])
    box, wall, cylinder = (
        view.bodies == names[one] for one in ("red_box", "wall", "orange_cylinder")
    )
    bins = np.arange(10.0, 190, 10)
    on_table = view.bodies == names["table"]
    nearest = [on_table & (np.abs(radius - r) < 5) for r in bins]
    curves = {
        "measured": np.array([np.median(error_mm[one]) for one in nearest]),
        "predicted": np.array([np.median(predicted_mm[one]) for one in nearest]),
    }
    return Finding(
        {
            "box_mm": float(np.median(error_mm[box])),
            "box_predicted_mm": float(np.median(predicted_mm[box])),
            "cylinder_mm": float(np.median(error_mm[cylinder])),
            "wall_mm": float(np.median(error_mm[wall])),
            "largest_gap_mm": float(np.percentile(np.abs(error_mm - predicted_mm), 99)),
        },
        plot_lines(bins, curves, x_label="distance from the middle (px)", y_label="error (mm)"),
    )


def measure_typical() -> Finding:
    """Look at one object only, close to the middle."""
    view, names = _take_picture()
    _, error_mm = _measure_one_degree(view)
    cylinder = view.bodies == names["orange_cylinder"]
    rows = np.unique(view.pixels[cylinder][:, 1])
    means = [error_mm[cylinder & (view.pixels[:, 1] == row)].mean() for row in rows]
    box = view.bodies == names["red_box"]
    return Finding(
        {
            "cylinder_mm": float(np.median(error_mm[cylinder])),
            "box_mm": float(np.median(error_mm[box])),
        },
        plot_lines(
            rows, {"error": np.array(means)}, x_label="row of the picture", y_label="error (mm)"
        ),
    )


def _take_picture() -> tuple[_View, dict[str, int]]:
    model, data = lab.make_scene()
    with lab.make_renderer(model, HEIGHT, WIDTH) as renderer:
        _, depth = lab.render_camera(model, data, renderer, CAMERA)
        bodies = lab.render_segmentation(model, data, renderer, CAMERA)
    truth = lab.raycast_points(model, data, CAMERA, WIDTH, HEIGHT)
    known = lab.find_valid_depth(depth) & np.isfinite(truth).all(axis=-1)
    K, _ = lab.get_camera_intrinsics(model, CAMERA, WIDTH, HEIGHT)
    pixels = np.stack(np.nonzero(known)[::-1], axis=-1)
    pose = lab.get_camera_pose(model, data, CAMERA)
    names = {model.body(i).name: i for i in range(model.nbody)}
    return _View(pixels, depth[known], bodies[known], truth[known], pose, K), names


def _measure_one_degree(view: _View) -> tuple[np.ndarray, np.ndarray]:
    """Return K of a camera that is one degree wider, and the error of every pixel in mm."""
    fov_y = 2 * np.arctan(HEIGHT / 2 / view.K[1, 1])
    K_wrong = lab.intrinsics_matrix(fov_y + np.radians(1), WIDTH, HEIGHT)
    points = lab.pixels_to_points(view.pixels, view.z, K_wrong)
    world = points @ view.pose[:3, :3].T + view.pose[:3, 3]
    return K_wrong, 1000 * np.linalg.norm(world - view.truth, axis=1)
