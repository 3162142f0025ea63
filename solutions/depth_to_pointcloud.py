"""Step 5: from a depth image to points."""

from __future__ import annotations

from typing import Any

import numpy as np

import labutils
from solutions._cases import make_depth, make_rgb, spoil_depth
from solutions._model import Case, Exercise, Misconception, Part, asked, told
from solutions._simpler import Simplification
from solutions.completions.depth_to_pointcloud import COMPLETION


def _answer_with(
    mistakes: frozenset[str],
    depth_metric: np.ndarray,
    K: np.ndarray,
    rgb_image: np.ndarray | None,
) -> Any:
    height, width = depth_metric.shape
    v, u = np.mgrid[:height, :width].astype(np.float64)
    if "rows-as-columns" in mistakes:
        u, v = v, u
    if "pixel-corner" in mistakes:
        u, v = u + 0.5, v + 0.5
    slope_x = (u - K[0, 2]) / K[0, 0]
    slope_y = (v - K[1, 2]) / (K[0, 0] if "one-focal-length" in mistakes else K[1, 1])
    z = depth_metric.astype(np.float64)
    if "ray-length" in mistakes:
        z = z / np.sqrt(slope_x**2 + slope_y**2 + 1)
    points = np.stack([slope_x * z, slope_y * z, z], axis=-1).reshape(-1, 3)
    if "y-up" in mistakes:
        points = points * [1, -1, -1]
    valid = ((depth_metric > 0.01) & (depth_metric < 10)).ravel()
    if "invalid-kept" in mistakes:
        valid[:] = True
    points = points[valid].astype(depth_metric.dtype)
    if rgb_image is None:
        return points, None
    colors = rgb_image.reshape(-1, 3)[valid].astype(np.float32)
    return points, colors if "colors-to-255" in mistakes else colors / 255


def _make_intrinsics(rng: np.random.Generator, height: int, width: int) -> np.ndarray:
    fx, fy = rng.uniform(0.8, 1.0) * width, rng.uniform(1.15, 1.4) * width
    cx, cy = (width - 1) / 2 + rng.uniform(1, 2), (height - 1) / 2 - rng.uniform(1, 2)
    return np.round(np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]]), 3)


def _make_limit_case(rng: np.random.Generator, label: str, odd: float, dtype: Any) -> Case:
    """Make a tiny picture that is all surface but for one pixel."""
    # The optical axis is outside: what a part that was cut out of a larger picture has.
    K = np.array([[0.8, 0, -0.4], [0, 0.9, -0.3], [0, 0, 1]])
    depth = np.round(rng.uniform(0.7, 2.5, size=(3, 4)), 4).astype(dtype)
    depth[int(rng.integers(3)), int(rng.integers(4))] = odd
    return Case(label, (depth, K, make_rgb(rng, 3, 4)))


def _make_empty_case(rng: np.random.Generator) -> Case:
    depth = rng.permutation([np.nan, np.inf, 0.0, 0.004, 10.5, 12.0]).reshape(2, 3)
    K = _make_intrinsics(rng, 2, 3)
    return Case("no pixel sees a surface", (depth.astype(np.float32), K, make_rgb(rng, 2, 3)))


def _visible() -> tuple[Case, ...]:
    rng = np.random.default_rng(71)
    clean = make_depth(rng, 11, 15)
    spoiled = spoil_depth(rng, make_depth(rng, 14, 19))
    return (
        Case("every pixel sees a surface, no colors", (clean, _make_intrinsics(rng, 11, 15), None)),
        Case(
            "colors, and pixels without a surface",
            (spoiled, _make_intrinsics(rng, 14, 19), make_rgb(rng, 14, 19)),
        ),
        _make_limit_case(rng, "a pixel at the lower limit, double precision", 0.01, np.float64),
        _make_limit_case(rng, "a pixel at the upper limit", 10.0, np.float32),
        _make_empty_case(rng),
    )


def _hidden(rng: np.random.Generator) -> tuple[Case, ...]:
    cases = []
    for number in range(4):
        height, width = map(int, rng.integers(12, 40, size=2))
        depth = spoil_depth(rng, make_depth(rng, height, width))
        rgb = make_rgb(rng, height, width) if number % 2 else None
        cases.append(Case(f"view {number + 1}", (depth, _make_intrinsics(rng, height, width), rgb)))
    full = make_depth(rng, 9, 13)
    cases.append(Case("full", (full, _make_intrinsics(rng, 9, 13), make_rgb(rng, 9, 13))))
    cases += [
        _make_limit_case(rng, "a pixel at the lower limit", 0.01, np.float32),
        _make_limit_case(rng, "a pixel at the upper limit", 10.0, np.float64),
        _make_limit_case(rng, "a pixel too near", 0.004, np.float64),
        _make_limit_case(rng, "a pixel too far", 12.0, np.float32),
        _make_empty_case(rng),
    ]
    return tuple(cases)


EXERCISE = Exercise(
    name="depth_to_pointcloud",
    title="turn a depth image into points",
    chapter="step5",
    place=1,
    points=14,
    section="step5-point",
    objectives=("3c", "5a", "5b", "5e"),
    reference=labutils.depth_to_pointcloud,
    answer_with=_answer_with,
    simpler=(
        Simplification(
            "one-meter",
            "every depth is 1 m",
            lambda a: {"depth_metric": np.ones_like(a["depth_metric"])},
        ),
    ),
    parts=(
        Part("points", "cloud", "float", atol=1e-4, unit="m"),
        Part(
            "colors",
            "attached",
            "float",
            atol=2e-3,
            low=0.0,
            high=1.0,
            nullable=True,
            note="None exactly where rgb_image is None",
        ),
    ),
    tolerance_reason=(
        "0.1 mm is fifty times the rounding of float32 at 10 m; half a pixel moves the nearest "
        "point by 2 cm. Colors: half a level of 255"
    ),
    misconceptions=(
        Misconception(
            "rows-as-columns",
            "u and v are exchanged. u counts columns and v counts rows: check the order that "
            "np.meshgrid or np.indices gives.",
        ),
        Misconception(
            "pixel-corner",
            "your points are half a pixel off. A whole number (u, v) is the pixel's center, and K "
            "is made for that: add no 0.5.",
            section="step2-center",
        ),
        Misconception(
            "one-focal-length",
            "y is divided by fx. fx and fy differ where pixels are not square: K[0, 0] belongs to "
            "x, K[1, 1] to y.",
        ),
        Misconception(
            "ray-length",
            "you take depth for the length of the ray. It is z, measured along the optical axis: "
            "multiply the slopes by it as it is.",
            section="step3-range",
        ),
        Misconception(
            "y-up",
            "y points up and z backwards: MuJoCo's axes. In the camera frame of OpenCV y points "
            "down and z forward.",
        ),
        Misconception(
            "invalid-kept",
            "pixels without a surface are still points. Leave out NaN, infinity, depth at or below "
            "0.01 m, and 10 m or more.",
            section="step3-invalid",
        ),
        Misconception(
            "colors-to-255",
            "the colors go from 0 to 255. Point clouds take 0 to 1: divide by 255.",
        ),
    ),
    hints=(
        (
            "A pixel's ray leaves through (u, v). How far does it move sideways per meter "
            "forward? K holds what you need."
        ),
        (
            "x = (u - cx) z / fx, and y likewise with its own numbers. Which of u and v counts the "
            "columns?"
        ),
        (
            "One mask of valid pixels serves points and colors alike: a comparison with NaN is "
            "False, so NaN falls out by itself."
        ),
    ),
    example="""\
cloud, cloud_colors = depth_to_pointcloud(depth, K, rgb)
print(f"{len(cloud)} points of {depth.size} pixels")
show((cloud, cloud_colors))""",
    contract=(
        asked(
            "every-pixel",
            "Every pixel with a valid depth becomes a point",
            "every case",
            "mistake y-up",
            "mistake rows-as-columns",
        ),
        asked(
            "take-colors",
            "the points take the colors",
            "mistake colors-to-255",
            "case colors, and pixels",
        ),
        asked(
            "leave-out",
            "Leave out NaN, infinity",
            "mistake invalid-kept",
            "case a pixel at the lower limit",
            "case a pixel at the upper limit",
        ),
        asked("back-project", "Back-project a depth image", "value of points"),
        asked("frame", "Points are in the OpenCV camera frame", "mistake y-up"),
        asked("pixel-center", "is a pixel's center", "mistake pixel-corner"),
        told("any-order", "Points may come in any order"),
        asked("along-the-axis", "Meters along the optical axis", "mistake ray-length"),
        asked("intrinsics", "Intrinsic matrix of the picture", "mistake one-focal-length"),
        asked("colors-of", "Colors of the same pixels", "value of colors"),
        asked("meters", "points: Meters.", "value of points"),
        asked(
            "limits",
            "are left out",
            "mistake invalid-kept",
            "case no pixel sees a surface",
        ),
        asked(
            "colors-range",
            "RGB in [0, 1]",
            "range of colors",
            "case every pixel sees a surface, no colors",
        ),
        asked("example", "array([[-0.01", "value of points"),
    ),
    visible=_visible,
    hidden=_hidden,
    asks={
        "Convention": (
            "Points are in the OpenCV camera frame: x right, y down, z forward. Integer (u, v) is "
            "a pixel's center. Points may come in any order, with their colors in the same."
        ),
        "depth_metric": "ndarray, float, shape (H, W)\nMeters along the optical axis.",
        "K": "ndarray, float, shape (3, 3)\nIntrinsic matrix of the picture, in pixels.",
        "rgb_image": "ndarray, uint8, shape (H, W, 3), optional\nColors of the same pixels.",
        "Returns": (
            "points : ndarray, float, shape (N, 3)\n"
            "    Meters. Pixels whose depth is NaN, infinite, <= 0.01 m or >= 10 m are left out; "
            "where no pixel is left, N is 0.\n"
            "colors : ndarray, float, shape (N, 3), or None\n"
            "    RGB in [0, 1] of the same pixels; None without `rgb_image`."
        ),
        "Raises": "",
    },
    completion=COMPLETION,
)
