"""Valid input of the exercises on following a ball."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from solutions._ball_cases import cast_ball

if TYPE_CHECKING:
    from collections.abc import Callable

#: What a depth image holds where there is no surface; and depths that are valid, but only just.
_NO_DEPTH = (0.0, 0.004, 0.01, -1.0, 10.0, 10.2, 12.0, np.nan, np.inf)


def _command_from_pixel(rng: np.random.Generator) -> tuple[Any, ...]:
    fx, fy = rng.uniform(20, 1500, size=2)
    cx, cy = rng.uniform(-50, 700, size=2)
    low = rng.uniform(-2, 0.5, size=2)
    high = low + rng.uniform(0.05, 3, size=2) * rng.choice([1, 20])
    pan, tilt = rng.uniform(-2, 2, size=2)
    return (
        tuple(rng.uniform(-20, 900, size=2).tolist()),
        np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]]),
        float(pan),
        float(tilt),
        tuple(zip(low.tolist(), high.tolist(), strict=True)),
    )


def _locate_ball(rng: np.random.Generator) -> tuple[Any, ...]:
    """Draw a ball wholly in the picture, before a wall and behind what is no part of it."""
    height, width = map(int, rng.integers(46, 60, size=2))
    radius = float(rng.uniform(0.03, 0.065))
    z, size_px = float(rng.uniform(0.4, 1.4)), float(rng.uniform(23, 30))
    focal_px = size_px * z / (2 * radius)
    slope = rng.uniform(-0.35, 0.35, size=2)
    middle = np.array([width, height]) / 2
    axis_px = middle - slope * [focal_px, focal_px]
    K = np.array([[focal_px, 0, axis_px[0]], [0, focal_px, axis_px[1]], [0, 0, 1]])
    ball = cast_ball(z * np.array([*slope, 1.0]), radius, K, (height, width))
    inside = np.isfinite(ball)
    depth = np.where(inside, ball, np.float32(z + rng.uniform(4, 10) * radius))
    mask = inside.copy()
    share = rng.choice([0, 0.02, 0.1, 1])
    lost = inside & (rng.random(ball.shape) < share)
    depth[lost] = rng.choice(_NO_DEPTH, size=np.count_nonzero(lost))
    if share < 1 and rng.random() < 0.5:  # some of the wall, right of the ball
        mask[:, 1:] |= inside[:, :-1] & (rng.random((height, width - 1)) < 0.4)
    if rng.random() < 0.3:
        depth[:5, :4] = rng.uniform(0.02, 0.3)
    if rng.random() < 0.1:
        mask[:] = False
    return 255 * mask.astype(np.uint8), depth, K, radius


MAKERS: dict[str, Callable[[np.random.Generator], tuple[Any, ...]]] = {
    "command_from_pixel": _command_from_pixel,
    "locate_ball": _locate_ball,
}
