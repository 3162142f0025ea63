"""Challenge of step 5: how large an object really is."""

from __future__ import annotations

from typing import Any

import numpy as np

from labutils import find_valid_depth
from solutions._cases import make_blocks
from solutions._model import Case, Exercise, Misconception, Part, asked, given, told
from solutions._simpler import Simplification

#: Pixels of the mask this far from its median depth see something else, in meters.
_SAME_OBJECT = 0.05


def measure_object_size(
    mask: np.ndarray, depth_metric: np.ndarray, K: np.ndarray
) -> tuple[float, float]:
    """Measure the width and height of the side of an object that faces the camera.

    At the border of a mask some pixels see the background. Take the median depth of the valid
    pixels in the mask (above 0.01 m, below 10 m), and keep the valid pixels in the mask whose
    depth differs from it by at most 0.05 m. Of the points behind these pixels, width is the
    largest minus the smallest x, height the largest minus the smallest y, in the camera frame.

    Parameters
    ----------
    mask : ndarray, uint8, (H, W)
        255 on the object, 0 elsewhere.
    depth_metric : ndarray, float32, (H, W)
        Meters along the optical axis.
    K : ndarray, float64, (3, 3)
        Intrinsic matrix.

    Returns
    -------
    width, height : float
        Meters.
    """
    valid = (mask > 0) & (depth_metric > 0.01) & (depth_metric < 10)
    near_median = np.abs(depth_metric - np.median(depth_metric[valid])) <= _SAME_OBJECT
    v, u = np.nonzero(valid & near_median)
    z = depth_metric[v, u].astype(np.float64)
    x, y = (u - K[0, 2]) / K[0, 0] * z, (v - K[1, 2]) / K[1, 1] * z
    return float(np.ptp(x)), float(np.ptp(y))


def _answer_with(
    mistakes: frozenset[str], mask: np.ndarray, depth_metric: np.ndarray, K: np.ndarray
) -> Any:
    kept = (depth_metric > 0.01) & (depth_metric < 10)
    if "mask-ignored" not in mistakes:
        kept &= mask > 0
    middle = np.median(depth_metric[kept])
    if "edges-kept" not in mistakes:
        kept &= np.abs(depth_metric - middle) <= _SAME_OBJECT
    v, u = np.nonzero(kept)
    fx, fy = K[0, 0], K[0, 0] if "one-focal-length" in mistakes else K[1, 1]
    slope_x, slope_y = (u - K[0, 2]) / fx, (v - K[1, 2]) / fy
    z = depth_metric[kept].astype(np.float64)
    if "ray-length" in mistakes:
        z = z / np.sqrt(1 + slope_x**2 + slope_y**2)
    if "one-depth" in mistakes:
        z = np.full_like(z, np.median(z))
    size = (float(np.ptp(slope_x * z)), float(np.ptp(slope_y * z)))
    return size[::-1] if "height-first" in mistakes else size


def _make_case(rng: np.random.Generator, label: str, height: int, width: int) -> Case:
    """Make a slanted board before a wall; its mask reaches one pixel too far on two sides."""
    fx, fy = rng.uniform(0.8, 0.95) * width, rng.uniform(1.0, 1.15) * width
    K = np.round(np.array([[fx, 0, width / 2 + 1.3], [0, fy, height / 2 - 2.1], [0, 0, 1]]), 3)
    v, u = np.mgrid[:height, :width]
    depth = (rng.uniform(1.6, 2.0) + 0.004 * u).astype(np.float64)
    wide, high = (
        int(rng.integers(width // 3, width // 2)),
        int(rng.integers(height // 3, height // 2)),
    )
    left, top = int(rng.integers(2, width // 4)), int(rng.integers(2, height // 4))
    board = np.s_[top : top + high, left : left + wide]
    slant = rng.uniform(0.02, 0.035, size=2) * rng.choice([-1, 1], size=2)
    across, down = (u[board] - left) / wide - 0.5, (v[board] - top) / high - 0.5
    depth[board] = rng.uniform(0.7, 1.0) + slant[0] * across + slant[1] * down
    mask = np.zeros((height, width), dtype=np.uint8)
    mask[top : top + high + 1, left : left + wide + 1] = 255
    # Half of the border on the left sees another thing, a little farther than 0.05 m.
    depth[top : top + high // 2, left] = np.median(depth[board]) + 0.075
    where = rng.choice(high * wide, size=6, replace=False)
    depth[top + where // wide, left + where % wide] = np.tile([0.0, 12.0], 3)
    return Case(label, (mask, np.round(depth, 4).astype(np.float32), K))


def _make_limit_case(
    rng: np.random.Generator, label: str, distance: float, border: tuple[float, ...]
) -> Case:
    """Make a small board at a limit of what is valid; `border` are depths beside it, in the mask.

    It lies to the left of the optical axis: whoever counts the border finds another width.
    """
    height, width, rows = 12, 16, 2 * len(border)
    K = np.array([[14.0, 0, 14.2], [0, 17.5, 4.1], [0, 0, 1]])
    depth = np.full((height, width), 3.0)
    depth[1 : 1 + rows, 2:8] = distance + rng.uniform(0, 0.004, size=(rows, 6))
    depth[1 : 1 + rows : 2, 8] = border
    depth[2 : 2 + rows : 2, 8] = border
    mask = np.zeros((height, width), dtype=np.uint8)
    mask[1 : 1 + rows, 2:9] = 255
    return Case(label, (mask, np.round(depth, 4).astype(np.float32), K))


def _make_limit_cases(rng: np.random.Generator) -> tuple[Case, ...]:
    near = float(rng.uniform(0.03, 0.036))
    return (
        _make_limit_case(rng, "right before the lens", near, (0.0, 0.004, 0.01, 0.015)),
        _make_limit_case(rng, "at the end of the range", 9.97, (10.0, 10.01)),
    )


def _make_column_cases(rng: np.random.Generator) -> tuple[Case, ...]:
    """Make objects of columns, left of the optical axis: what must not count makes them wider."""
    K = np.array([[31.0, 0, 13.2], [0, 35, 8.1], [0, 0, 1]])
    near = float(np.round(rng.uniform(0.9, 1.1), 3))
    columns = {
        "more pixels of the mask are invalid than valid": (0, 0, near, near + 0.02, near, 0, 0),
        "a deep object, before it a nearer thing, behind it a farther one": (
            *(near + step for step in (0.3, 0.04, 0.02, 0, -0.02, -0.04, -0.3)),
        ),
    }
    cases = []
    for label, depths in columns.items():
        labels, depth = make_blocks(((1, 3, 4, depths),))
        cases.append(Case(label, ((labels * 255).astype(np.uint8), depth, K)))
    return tuple(cases)


def _visible() -> tuple[Case, ...]:
    rng = np.random.default_rng(108)
    return (
        _make_case(rng, "a slanted board before a wall", 40, 60),
        _make_case(rng, "a picture that is higher than wide", 66, 46),
        *_make_limit_cases(rng),
        *_make_column_cases(rng),
    )


def _hidden(rng: np.random.Generator) -> tuple[Case, ...]:
    sizes = rng.integers([36, 56], [46, 70], size=(3, 2))
    boards = (_make_case(rng, f"board {n}", int(h), int(w)) for n, (h, w) in enumerate(sizes))
    return (*boards, *_make_limit_cases(rng), *_make_column_cases(rng))


def _find_object(args: dict[str, Any]) -> np.ndarray:
    """Mark the pixels that are measured."""
    depth = args["depth_metric"]
    inside = (args["mask"] > 0) & find_valid_depth(depth)
    return np.asarray(inside & (np.abs(depth - np.median(depth[inside])) <= 0.05))


def _fit_mask(args: dict[str, Any]) -> dict[str, Any]:
    return {"mask": np.where(_find_object(args), 255, 0).astype(np.uint8)}


def _flatten(args: dict[str, Any]) -> dict[str, Any]:
    depth, seen = args["depth_metric"], _find_object(args)
    depth[seen] = np.median(depth[seen])
    return {"depth_metric": depth}


def _aim(args: dict[str, Any]) -> dict[str, Any]:
    K = args["K"]
    rows, columns = np.nonzero(_find_object(args))
    K[:2, 2] = (columns.min() + columns.max()) / 2, (rows.min() + rows.max()) / 2
    return {"K": K}


def _fill_picture(args: dict[str, Any]) -> dict[str, Any]:
    depth, seen = args["depth_metric"], _find_object(args)
    depth[~seen] = np.median(depth[seen])
    return {"depth_metric": depth, "mask": np.full_like(args["mask"], 255)}


EXERCISE = Exercise(
    name="measure_object_size",
    title="measure how large an object really is",
    chapter="step5",
    place=11,
    points=0,
    section="step5-point",
    objectives=("5a", "5d", "5e"),
    reference=measure_object_size,
    answer_with=_answer_with,
    simpler=(
        Simplification("mask-fits", "no pixel of the mask sees the wall", _fit_mask),
        Simplification("flat", "the side has the same depth everywhere", _flatten),
        Simplification("centered-object", "the optical axis meets the middle of the object", _aim),
        Simplification("fills-the-picture", "the object fills the picture", _fill_picture),
    ),
    parts=(Part("size", "vector", "float", atol=1e-4, unit="m"),),
    tolerance_reason="0.1 mm is far above rounding, and a hundredth of what one pixel covers",
    misconceptions=(
        Misconception(
            "edges-kept",
            "pixels at the border of the mask see the wall behind. Keep those within 0.05 m of "
            "the median depth.",
            section="step5-truth",
        ),
        Misconception(
            "one-depth",
            "you use one depth for the whole object. A slanted side has another depth at each "
            "pixel: make a point of every pixel.",
        ),
        Misconception(
            "one-focal-length",
            "y is divided by fx. fx and fy differ where pixels are not square: K[1, 1] belongs to "
            "y.",
            section="step5-fingerprints",
        ),
        Misconception(
            "ray-length",
            "you take depth for the length of the ray. It is z, measured along the optical axis.",
            section="step3-range",
        ),
        Misconception(
            "mask-ignored",
            "you measure the whole picture. Only pixels in the mask belong to the object.",
        ),
        Misconception(
            "height-first",
            "your answer is (height, width). Width comes first; it lies along x.",
        ),
    ),
    hints=(
        "Which pixels belong to the object? There are three conditions, and one is about depth.",
        "Pixels become points by x = (u - cx) z / fx, and y likewise with its own numbers.",
        "np.ptp(x) is the largest minus the smallest value.",
    ),
    example="""\
mask = lab.segment_by_color(rgb, lab.HSV_RANGES["yellow"])
width, height = measure_object_size(mask, depth, K)
print(f"The block: {100 * width:.1f} cm wide, {100 * height:.1f} cm high.")
show(lab.visualize_detection(rgb, None, mask))""",
    contract=(
        asked("how-wide", "How wide and how high", "every case"),
        asked("no-pixels", "pixels are no meters", "mistake one-depth"),
        told("not-perfect", "The mask is not perfect"),
        asked("wall-behind", "At its border some pixels see the wall", "mistake edges-kept"),
        asked("measure", "Measure the width and height", "value"),
        told("background", "some pixels see the background"),
        asked(
            "rule",
            "Take the median depth",
            "mistake edges-kept",
            "mistake mask-ignored",
            "case right before the lens",
            "case at the end of the range",
            "case more pixels of the mask",
            "case a deep object",
        ),
        asked(
            "extent",
            "Of the points behind these pixels",
            "mistake one-depth",
            "mistake height-first",
            "case a picture that is higher",
        ),
        given("on-the-object", "255 on the object"),
        asked("along-the-axis", "Meters along the optical axis", "mistake ray-length"),
        asked("intrinsics", "Intrinsic matrix", "mistake one-focal-length"),
        asked("meters", "width, height: Meters.", "value"),
    ),
    visible=_visible,
    hidden=_hidden,
)
