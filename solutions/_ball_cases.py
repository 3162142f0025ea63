"""A ball before a wall, cast with rays: its mask, its depth, and what is wrong with both."""

from __future__ import annotations

from typing import Any

import numpy as np

from labutils import find_valid_depth
from labutils.checks.table import Case

#: Depth of the wall, and of a block that stands nearer than the ball, in meters.
_WALL, _BLOCK = 2.2, 0.42


def cast_ball(
    center: np.ndarray, radius: float, K: np.ndarray, shape: tuple[int, int]
) -> np.ndarray:
    """Return the depth of a ball at each pixel, infinite where the ray passes it.

    Parameters
    ----------
    center : ndarray, float64, shape (3,)
        In the camera frame, in meters.
    radius : float
        In meters.
    K : ndarray, float64, shape (3, 3)
        Intrinsic matrix.
    shape : tuple of int
        (H, W).

    Returns
    -------
    ndarray, float32, shape (H, W)
        Meters along the optical axis.
    """
    v, u = np.mgrid[: shape[0], : shape[1]]
    rays = np.stack([(u - K[0, 2]) / K[0, 0], (v - K[1, 2]) / K[1, 1], np.ones(shape)], axis=-1)
    # |depth * ray - center| = radius is quadratic in depth; the smaller root is the front.
    a, b = (rays**2).sum(axis=-1), rays @ center
    discriminant = b**2 - a * (center @ center - radius**2)
    depth = (b - np.sqrt(np.maximum(discriminant, 0))) / a
    return np.where(discriminant > 0, np.round(depth, 4), np.inf).astype(np.float32)


def make_ball(
    rng: np.random.Generator, label: str, side: tuple[int, int], far: float = 1.0
) -> Case:
    """Make a ball to the right (1) or left (-1) of the optical axis, below (1) or above (-1) it.

    The picture is a part cut out of a larger one: the ball fills most of it, the axis is outside.
    A ball that is `far` times as far is seen through a lens that is as many times as long.
    """
    height, width = map(int, rng.integers((43, 49), (47, 54)))
    focal_px = far * float(rng.uniform(136, 148))
    ball_px = np.array([width, height]) / 2 + rng.uniform(-2, 2, size=2)
    slope = np.array(side) * rng.uniform(0.24, 0.3, size=2)
    axis_px = ball_px - slope * [focal_px, 1.05 * focal_px]
    K = np.array([[focal_px, 0, axis_px[0]], [0, 1.05 * focal_px, axis_px[1]], [0, 0, 1]])
    K, radius = np.round(K, 3), round(float(rng.uniform(0.056, 0.062)), 4)
    center = far * float(rng.uniform(0.58, 0.66)) * np.array([*slope, 1.0])
    ball = cast_ball(center, radius, K, (height, width))
    depth = np.where(np.isfinite(ball), ball, np.float32(_WALL))
    depth[:7, -5:] = _BLOCK  # a corner is free of the ball
    return Case(label, (255 * np.isfinite(ball).astype(np.uint8), depth, K, radius))


def lose_depth(rng: np.random.Generator, case: Case, label: str, *values: float) -> Case:
    """Lose the depth at the middle of the ball, and here and there."""
    mask, depth, K, radius = case.args
    depth = depth.copy()
    rows, columns = np.nonzero(mask)
    some = rng.choice(len(rows), size=len(rows) // 12, replace=False)
    depth[rows[some], columns[some]] = rng.choice(values, size=len(some)).astype(np.float32)
    depth[_find_middle(mask)] = values[0]
    return Case(label, (mask, depth, K, radius))


def _find_middle(mask: np.ndarray) -> tuple[slice, slice]:
    """Return the few pixels at the middle of a ball: those to which a centroid may be rounded."""
    v, u = (int(one.mean()) for one in np.nonzero(mask))
    return np.s_[v : v + 2, u : u + 2]


def widen_mask(rng: np.random.Generator, case: Case, label: str) -> Case:
    """Let some pixels at the border see the wall, and make a hole where the ball shines."""
    mask, depth, K, radius = case.args
    wide = mask.copy()
    wide[1:] |= mask[:-1]
    wide[:, :-1] |= mask[:, 1:]
    border = (wide > mask) & (rng.random(mask.shape) < 0.5)
    wide[(wide > mask) & ~border] = 0
    rows, columns = np.nonzero(mask)
    top, left = int(rows.mean()) - 6, int(columns.mean()) - 5
    wide[top : top + 3, left : left + 3] = 0
    return Case(label, (wide, depth, K, radius))


def make_nothing(case: Case, empty: str, lost: str) -> tuple[Case, Case]:
    """Make a mask without a pixel, and one of which no pixel has a valid depth."""
    mask, depth, K, radius = case.args
    without = depth.copy()
    without[mask > 0] = np.resize([0, 12, 10, 0.01], np.count_nonzero(mask))
    without[_find_middle(mask)] = 0
    return (
        Case(empty, (np.zeros_like(mask), depth, K, radius)),
        Case(lost, (mask, without, K, radius)),
    )


def take_depth_everywhere(args: dict[str, Any], center: np.ndarray) -> dict[str, Any]:
    """Give every pixel of the ball its depth."""
    depth = args["depth"]
    ball = cast_ball(center, args["radius"], args["K"], depth.shape)
    return {"depth": np.where(np.isfinite(ball) & ~find_valid_depth(depth), ball, depth)}


def fit_mask(args: dict[str, Any], center: np.ndarray) -> dict[str, Any]:
    """Let the mask be the ball, no pixel more and none less."""
    ball = cast_ball(center, args["radius"], args["K"], args["depth"].shape)
    return {"mask": 255 * np.isfinite(ball).astype(np.uint8)}


def look_at_ball(args: dict[str, Any], center: np.ndarray) -> dict[str, Any]:
    """Turn the camera to the ball: what is lost and wrong in its picture stays at its pixels."""
    mask, depth, K, radius = (args[name] for name in ("mask", "depth", "K", "radius"))
    was = np.isfinite(cast_ball(center, radius, K, depth.shape))
    K[:2, 2] = [one.mean() for one in np.nonzero(was)[::-1]]
    ball = cast_ball(np.array([0, 0, np.linalg.norm(center)]), radius, K, depth.shape)
    seen = np.isfinite(ball)
    lost = was & seen & ~find_valid_depth(depth)
    new = np.where(seen & ~lost, ball, np.where(was & ~lost, np.float32(_WALL), depth))
    return {"K": K, "depth": new, "mask": 255 * ((mask > 0) ^ was ^ seen).astype(np.uint8)}
