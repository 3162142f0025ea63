"""Challenge of Following: where the center of a ball is, of which the camera sees the front."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from labutils import find_valid_depth
from solutions._ball_cases import (
    fit_mask,
    look_at_ball,
    lose_depth,
    make_ball,
    make_nothing,
    take_depth_everywhere,
    widen_mask,
)
from solutions._model import Absorbed, Case, Exercise, Misconception, Part, asked, given, told
from solutions._simpler import Simplification

if TYPE_CHECKING:
    from collections.abc import Callable


def locate_ball(
    mask: np.ndarray, depth: np.ndarray, K: np.ndarray, radius: float
) -> np.ndarray | None:
    """Locate the center of a ball of known size in the camera frame.

    The ball is wholly in the picture, more than 20 pixels wide, and nothing hides it. A center
    that is up to 1 cm off in each coordinate is right, so there are many ways.

    Parameters
    ----------
    mask : ndarray, uint8, (H, W)
        255 on the ball, 0 elsewhere. It may have a hole where the ball shines, and some pixels at
        its border that see the wall far behind.
    depth : ndarray, float32, (H, W)
        Meters along the optical axis. Not valid are depths up to 0.01 m, from 10 m on, infinity
        and NaN; also pixels of the ball may be without a valid depth.
    K : ndarray, float64, (3, 3)
        Intrinsic matrix. Where the picture is a part of a larger one, the principal point may lie
        outside.
    radius : float
        Of the ball, meters, up to 0.065.

    Returns
    -------
    ndarray, float, (3,), or None
        The center (x, y, z) in the camera frame (x right, y down, z forward), meters. None where
        no pixel of the mask has a valid depth.
    """
    seen = (mask > 0) & find_valid_depth(depth)
    if not seen.any():
        return None
    seen &= depth < depth[seen].min() + 2 * radius  # the wall is farther behind
    v, u = np.nonzero(seen)
    z = depth[seen].astype(np.float64)
    points = np.column_stack([(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z])
    # All these points are one radius from the center: start behind them, and solve for the rest.
    center = points.mean(axis=0) + np.array([0, 0, radius])
    for _ in range(9):
        ways = points - center
        reach = np.linalg.norm(ways, axis=1)
        normals = ways / reach[:, None]
        center = center + np.linalg.solve(normals.T @ normals, normals.T @ (reach - radius))
    return center


def _answer_with(
    mistakes: frozenset[str], mask: np.ndarray, depth: np.ndarray, K: np.ndarray, radius: float
) -> Any:
    seen = np.ones(mask.shape, dtype=bool) if "mask-ignored" in mistakes else mask > 0
    if "depth-lost" not in mistakes:
        seen &= find_valid_depth(depth)
    if "no-empty-case" not in mistakes and not seen.any():
        return None
    if not {"depth-lost", "wall-kept"} & mistakes:
        seen &= depth < depth[seen].min() + 2 * radius  # of nothing, a ValueError
    v, u = np.nonzero(seen)
    z = depth[seen].astype(np.float64)
    pixels = (v, u) if "row-column" in mistakes else (u, v)
    rays = np.column_stack([*((np.stack(pixels).T - K[:2, 2]) / np.diag(K)[:2]).T, np.ones(len(z))])
    if "ray-length" in mistakes:
        rays /= np.linalg.norm(rays, axis=1, keepdims=True)
    points = rays * z[:, None]
    if {"wall-kept", "mean-surface"} & mistakes:
        surface = points.mean(axis=0)
    else:
        surface = points[np.argmin(z if "smallest-depth" in mistakes else (points**2).sum(axis=1))]
    # The mean of the front of a ball lies two thirds of the radius before its center.
    share = 2 / 3 if "wall-kept" in mistakes and "mean-surface" not in mistakes else 1.0
    if "surface-point" in mistakes:
        return surface
    if "axis-for-ray" in mistakes and "smallest-depth" not in mistakes:
        return surface + np.array([0, 0, share * radius])
    return surface * (1 + share * radius / np.linalg.norm(surface))


def _make_cases(rng: np.random.Generator) -> tuple[Case, ...]:
    right = make_ball(rng, "a ball on the right, below the middle", (1, 1))
    left = make_ball(rng, "a ball on the left, above the middle", (-1, -1), 1.7)
    third, fourth = make_ball(rng, "", (1, -1)), make_ball(rng, "", (-1, 1), 1.5)
    return (
        right,
        left,
        lose_depth(rng, third, "a ball without a depth at its middle", 0.0, 0.004, 12.0),
        lose_depth(rng, fourth, "a ball with NaN at its middle", np.nan, np.inf, 10.0),
        widen_mask(rng, left, "a mask with a hole, and with some of the wall"),
        *make_nothing(right, "an empty mask", "a ball that measured nothing"),
    )


def _changing(
    change: Callable[[dict[str, Any], np.ndarray], dict[str, Any]], args: dict[str, Any]
) -> dict[str, Any]:
    """Change a case that shows a ball."""
    center = locate_ball(**args)
    return {} if center is None else change(args, center)


#: Why two mistakes exclude each other.
_ONE_SURFACE = "a mean of the surface starts at no single pixel"


EXERCISE = Exercise(
    name="locate_ball",
    title="locate the center of a ball",
    chapter="following",
    place=2,
    points=0,
    section="following-center",
    objectives=("7b",),
    reference=locate_ball,
    answer_with=_answer_with,
    simpler=(
        Simplification(
            "all-valid",
            "every pixel of the ball has a depth",
            partial(_changing, take_depth_everywhere),
        ),
        Simplification(
            "mask-fits", "the mask is the ball and nothing else", partial(_changing, fit_mask)
        ),
        Simplification(
            "straight-ahead", "the ball is straight ahead", partial(_changing, look_at_ball)
        ),
    ),
    parts=(
        Part(
            "center",
            "vector",
            "float",
            atol=1e-2,
            unit="m",
            nullable=True,
            note="None exactly where no pixel of the mask has a valid depth",
        ),
    ),
    tolerance_reason=(
        "on balls cast with rays, ways by the nearest pixel, by a centroid in whole pixels and by "
        "the mean of the front are up to 7.5 mm off; every mistake is off by more than 12 mm"
    ),
    misconceptions=(
        Misconception(
            "surface-point",
            "this is a point of the surface. The center lies one radius behind the nearest one, "
            "along the same ray.",
        ),
        Misconception(
            "axis-for-ray",
            "you add the radius along the optical axis. The center lies behind the nearest point "
            "along its ray: x and y grow with z.",
        ),
        Misconception(
            "smallest-depth",
            "you start at the smallest depth. At the side, that is not the nearest point: compare "
            "distances from the camera.",
            section="step3-range",
        ),
        Misconception(
            "mean-surface",
            "you add the whole radius to the mean of the surface. The mean lies deeper than the "
            "nearest point: take that one, or add less.",
        ),
        Misconception(
            "ray-length",
            "you take depth for the length of the ray. It is z, along the optical axis: a ball at "
            "the side is farther away than its depth.",
            section="step3-range",
        ),
        Misconception(
            "row-column",
            "you exchange rows and columns. np.nonzero gives rows first, and rows belong to y.",
        ),
        Misconception(
            "depth-lost",
            "pixels without a depth take part: 0 is no distance, and NaN spoils all. Keep valid "
            "depths only: lab.find_valid_depth.",
            section="step3-invalid",
        ),
        Misconception(
            "wall-kept",
            "pixels at the border of the mask see the wall, and they pull the mean away. Keep "
            "depths near the smallest valid one.",
            section="step5-truth",
        ),
        Misconception(
            "mask-ignored",
            "you look at the whole picture, where something else is nearer. Only pixels in the "
            "mask belong to the ball.",
        ),
        Misconception(
            "no-empty-case",
            "a ball that nobody sees stops your program. Ask whether any pixel of the mask has a "
            "valid depth, and return None.",
        ),
    ),
    hints=(
        "Which pixels saw the ball? They are in the mask, and their depth passes two tests.",
        "Make points of them. The one with the smallest distance from the camera faces it.",
        "Camera, nearest point and center lie on one line: go on along it, by one radius.",
    ),
    example="""\
mask = lab.segment_by_color(rgb, ((0, 120, 50), (7, 255, 255)))
center = locate_ball(mask, depth, K, 0.045)
pose = lab.get_camera_pose(model, data, "head_camera")
off = (pose @ [*center, 1])[:3] - data.body("red_ball").xpos
show(lab.visualize_detection(rgb, None, mask))
show(center, f"center in m, {1000 * np.linalg.norm(off):.1f} mm off")""",
    contract=(
        told("front-only", "A camera sees the front of a ball"),
        asked("the-center", "Where is its center", "every case", "mistake surface-point"),
        asked(
            "picture",
            "The picture is as a robot gets it",
            "case a ball without a depth",
            "case a ball with NaN",
            "case a mask with a hole",
        ),
        asked("locate", "Locate the center of a ball", "value"),
        given("whole", "wholly in the picture"),
        asked(
            "how-near",
            "up to 1 cm off in each coordinate",
            "value",
            "mistake mean-surface",
            "mistake smallest-depth",
            "mistake axis-for-ray",
        ),
        asked("mask", "255 on the ball", "mistake mask-ignored"),
        asked("not-perfect", "It may have a hole", "mistake wall-kept", "case a mask with a hole"),
        asked("along-the-axis", "Meters along the optical axis", "mistake ray-length"),
        asked("valid", "Not valid are depths", "mistake depth-lost", "case a ball with NaN"),
        given("intrinsics", "Intrinsic matrix"),
        asked("part", "a part of a larger one", "every case"),
        given("radius", "Of the ball, meters"),
        asked("frame", "in the camera frame (x right", "mistake row-column"),
        asked(
            "nothing",
            "None where no pixel",
            "mistake no-empty-case",
            "case an empty mask",
            "case a ball that measured nothing",
        ),
    ),
    visible=lambda: _make_cases(np.random.default_rng(1138)),
    hidden=_make_cases,
    absorbed=(
        Absorbed("surface-point", "axis-for-ray", "who adds no radius adds it in no direction"),
        Absorbed(
            "axis-for-ray",
            "smallest-depth",
            "both together are right: the center is one radius behind the smallest depth, along "
            "the optical axis",
        ),
        Absorbed("smallest-depth", "mean-surface", _ONE_SURFACE),
        Absorbed("smallest-depth", "wall-kept", _ONE_SURFACE),
        Absorbed(
            "smallest-depth",
            "ray-length",
            "who takes depth for distance finds the same pixel by either",
        ),
        Absorbed(
            "mean-surface",
            "mask-ignored",
            "what is nearer than the ball is small and flat: its mean is nearly its nearest point",
        ),
        Absorbed("mask-ignored", "no-empty-case", "a whole picture is never without a valid depth"),
    ),
)
