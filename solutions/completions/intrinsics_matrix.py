"""Step 2: one point through a camera that names its horizontal angle."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from solutions._completion import Case, Completion, Part, Slip


def project_point(point: np.ndarray, fov_x: float, width: int, height: int) -> tuple[float, float]:
    """Project a point with a camera given by its horizontal angle.

    Parameters
    ----------
    point : ndarray, float64, shape (3,)
        x right, y down, z forward, meters.
    fov_x : float
        Horizontal field of view, radians; pixels are square.
    width, height : int
        Size of the picture, pixels.

    Returns
    -------
    u, v : float
        Column and row; whole numbers are pixel centers.
    """
    x, y, z = point
    focal = (width / 2) / np.tan(fov_x / 2)  # open: half the width fills half the angle
    cx, cy = (width - 1) / 2, (height - 1) / 2  # open: the middle of the picture
    u = focal * x / z + cx
    v = focal * y / z + cy
    return u, v


def _choose(cases: tuple[Case, ...]) -> tuple[Case, ...]:
    points = np.array([[0.3, -0.2, 1.5], [-0.4, 0.5, 2.0], [0.1, 0.1, 0.8]])
    return tuple(
        replace(case, args=(point, *case.args))
        for point, case in zip(points, cases[:3], strict=True)
    )


COMPLETION = Completion(
    title="project one point",
    statement="A camera names its *horizontal* angle, like the phone of the worked example. "
    "Before a point can be projected, two things are missing: the focal length and the middle of "
    "the picture.",
    section="step2-worked-angle",
    twin=project_point,
    parts=(Part("pixel", "vector", "float", atol=1e-3, unit="px"),),
    cases=_choose,
    slips=(
        Slip(
            "whole-width",
            "the focal length is twice as long as it is. Half the angle belongs to half the "
            "width: divide the width by two as well.",
            line="focal = width / np.tan(fov_x / 2)",
        ),
        Slip(
            "half-a-pixel",
            "the middle is half a pixel off. Columns are numbered from 0 to width - 1, and the "
            "middle of these numbers is (width - 1) / 2.",
            line="cx, cy = width / 2, height / 2",
        ),
    ),
    example="""\
u, v = project_point(np.array([0.1, 0.0, 1.0]), np.deg2rad(70), 1280, 720)
print(f"0.1 m to the right and 1 m ahead: column {u:.1f}, row {v:.1f}")""",
)
