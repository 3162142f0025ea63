"""Challenge of step 6: where points of the world appear, and which of them the camera sees."""

from __future__ import annotations

from typing import Any

import numpy as np

from solutions._cases import make_depth, make_rotation
from solutions._model import Absorbed, Case, Exercise, Misconception, Part, asked, given
from solutions._simpler import Simplification, stay_at_origin, stay_straight
from solutions._simpler_views import (
    keep_ahead,
    keep_inside,
    put_on_pixels,
    put_on_surface,
)

#: A point may lie this far behind the measured surface and still be on it, in meters.
_ON_SURFACE = 0.02
#: Depths at or below, and at or beyond, are no surface, in meters.
_MIN_DEPTH = 0.01
_MAX_DEPTH = 10.0


def project_visible_points(
    points_world: np.ndarray, T_world_cam: np.ndarray, K: np.ndarray, depth_metric: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Project points of the world into a picture and tell which of them the camera sees.

    A point is visible if its depth is above 0.01 m, if its pixel (rounded to the nearest whole
    numbers) lies in the picture, and if the depth image shows nothing in front of it there: its
    own depth is at most 0.02 m larger than the depth of that pixel. A pixel without a valid depth
    (above 0.01 m, below 10 m) hides nothing.

    Parameters
    ----------
    points_world : ndarray, float64, (N, 3)
        Points in the world, meters.
    T_world_cam : ndarray, float64, (4, 4)
        Pose of the camera (x right, y down, z forward): it maps camera points into the world.
    K : ndarray, float64, (3, 3)
        Intrinsic matrix.
    depth_metric : ndarray, float32, (H, W)
        What the camera measured, meters along the optical axis.

    Returns
    -------
    pixels : ndarray, float, (N, 2)
        (u, v) of each point, not rounded, also outside the picture; NaN where its depth is 0.01 m
        or less.
    visible : ndarray, bool, (N,)
        Whether the camera sees the point.
    """
    height, width = depth_metric.shape
    points = (points_world - T_world_cam[:3, 3]) @ T_world_cam[:3, :3]
    z = points[:, 2]
    in_front = z > _MIN_DEPTH
    pixels = np.full((len(points), 2), np.nan)
    pixels[in_front] = (points[in_front] @ K.T)[:, :2] / z[in_front, None]
    u, v = np.rint(np.nan_to_num(pixels, nan=-1)).astype(int).T
    visible = in_front & (u >= 0) & (u < width) & (v >= 0) & (v < height)
    surface = depth_metric[v[visible], u[visible]]
    known = (surface > _MIN_DEPTH) & (surface < _MAX_DEPTH)
    visible[visible] = ~known | (z[visible] <= surface + _ON_SURFACE)
    return pixels, visible


def _answer_with(
    mistakes: frozenset[str],
    points_world: np.ndarray,
    T_world_cam: np.ndarray,
    K: np.ndarray,
    depth_metric: np.ndarray,
) -> Any:
    height, width = depth_metric.shape
    pose = T_world_cam if "pose-not-inverted" in mistakes else np.linalg.inv(T_world_cam)
    x, y, z = pose[:3, :3] @ points_world.T + pose[:3, 3:]
    far = np.sqrt(x**2 + y**2 + z**2) if "ray-length" in mistakes else z
    corner = 0.5 if "pixel-corner" in mistakes else 0.0
    pixels, visible = [], []
    for number in range(len(z)):
        behind = z[number] <= _MIN_DEPTH
        if behind and "behind-kept" not in mistakes:
            pixels.append((np.nan, np.nan))
            visible.append(False)
            continue
        u = K[0, 0] * x[number] / z[number] + K[0, 2] + corner
        v = K[1, 1] * y[number] / z[number] + K[1, 2] + corner
        pixels.append((v, u) if "row-column" in mistakes else (u, v))
        column, row = round(u - corner), round(v - corner)
        seen = 0 <= column < width and 0 <= row < height
        if seen and "nothing-hides" not in mistakes:
            surface = depth_metric[row, column]
            known = _MIN_DEPTH < surface < _MAX_DEPTH
            seen = not known or far[number] <= surface + _ON_SURFACE
        visible.append(bool(seen))
    return np.array(pixels), np.array(visible)


def _make_edge_pixels(depth: np.ndarray) -> tuple[list[int], list[int], list[float]]:
    """Choose columns, rows and depths of points at every edge; write what they meet into `depth`.

    Just inside the picture and just outside, close to the camera, and behind depths that are
    hardly valid, or hardly not.
    """
    height, width = depth.shape
    u: list[int] = []
    v: list[int] = []
    z: list[float] = []
    for column in (-1, 0, width - 1, width):
        u, v, z = [*u, column], [*v, height // 2], [*z, 0.3]
    for row in (-1, 0, height - 1, height):
        u, v, z = [*u, width // 3], [*v, row], [*z, 0.3]
    for number, near in enumerate((0.005, 0.015)):
        u, v, z = [*u, width // 2 + number], [*v, height - 3], [*z, near]
    met = ((0.0, 2.0), (0.01, 2.0), (0.015, 2.0), (9.6, 11.0), (10.0, 11.0), (12.0, 14.0))
    for number, (surface, behind) in enumerate(met):
        depth[height - 6, 3 + 3 * number] = surface
        u, v, z = [*u, 3 + 3 * number], [*v, height - 6], [*z, behind]
    return u, v, z


def _make_case(rng: np.random.Generator, label: str, height: int, width: int) -> Case:
    """Make points on, before and behind the surfaces of a depth image, outside it and behind."""
    depth = make_depth(rng, height, width)
    depth[: height // 4, -width // 4 :] = rng.choice([0.0, 12.0, np.nan])
    focal = rng.uniform(0.8, 1.0) * width
    K = np.array([[focal, 0, width / 2 - 2.3], [0, 1.15 * focal, height / 2 + 1.6], [0, 0, 1]])
    K = np.round(K, 3)
    count = 60
    # Near a pixel's center, so that no rounding decides; some pixels lie outside the picture.
    u, v = rng.integers(-6, width + 6, count), rng.integers(-6, height + 6, count)
    inside = (u >= 0) & (u < width) & (v >= 0) & (v < height)
    z = np.full(count, 1.5)
    z[inside] = np.nan_to_num(depth[v[inside], u[inside]], nan=2.0)
    z[z < 0.1] = 2.0
    # On the surface, behind it by little or by much, before it; never near the limit itself.
    z = z + rng.choice([0.0, 0.008, 0.03, 0.4, -0.3], size=count)
    z[::9] *= -1  # behind the camera, although they would project into the picture
    more_u, more_v, more_z = _make_edge_pixels(depth)
    u, v, z = np.append(u, more_u), np.append(v, more_v), np.append(z, more_z)
    pixels = np.stack([u, v], axis=1) + rng.uniform(-0.3, 0.3, size=(len(z), 2))
    points = np.hstack([(pixels - K[:2, 2]) / K[[0, 1], [0, 1]] * z[:, None], z[:, None]])
    T_world_cam = np.eye(4)
    # A small turn: with the wrong pose, too, some points stay in the picture.
    T_world_cam[:3, :3] = make_rotation(rng, 0.1, 0.2)
    T_world_cam[:3, 3] = rng.uniform(0.05, 0.15, size=3)
    world = points @ T_world_cam[:3, :3].T + T_world_cam[:3, 3]
    return Case(label, (np.round(world, 6), np.round(T_world_cam, 9), K, depth))


def _visible() -> tuple[Case, ...]:
    rng = np.random.default_rng(111)
    return (
        _make_case(rng, "sixty points before a wall with a box", 30, 44),
        _make_case(rng, "a picture that is higher than wide", 46, 28),
    )


def _hidden(rng: np.random.Generator) -> tuple[Case, ...]:
    sizes = rng.integers(28, 50, size=(3, 2))
    return tuple(_make_case(rng, f"view {n}", int(h), int(w)) for n, (h, w) in enumerate(sizes))


EXERCISE = Exercise(
    name="project_visible_points",
    title="project points and tell which are visible",
    chapter="step6",
    place=11,
    points=0,
    section="step6-occlusion",
    objectives=("2b", "2e", "3c", "6c"),
    reference=project_visible_points,
    answer_with=_answer_with,
    simpler=(
        Simplification("none-behind", "every point is well before the camera", keep_ahead),
        Simplification("all-inside", "every point lies in the picture", keep_inside),
        Simplification(
            "on-the-surface", "every point lies on the surface that is measured", put_on_surface
        ),
        Simplification("whole-pixels", "every point projects to a whole pixel", put_on_pixels),
        Simplification("not-turned", "the camera is not turned", stay_straight("T_world_cam")),
        Simplification(
            "at-the-origin", "the camera is at the origin", stay_at_origin("T_world_cam")
        ),
    ),
    parts=(
        Part("pixels", "pixels", "float", atol=0.02, unit="px"),
        Part("visible", "flags", "bool"),
    ),
    tolerance_reason=(
        "a fiftieth of a pixel leaves room for points in single precision; half a pixel is "
        "twenty-five times as much. Visible is yes or no"
    ),
    misconceptions=(
        Misconception(
            "pose-not-inverted",
            "T_world_cam maps from the camera into the world. You need the way back: subtract the "
            "position, then turn back.",
            section="step5-world",
        ),
        Misconception(
            "row-column",
            "your pixels are (row, column). Pixels are (u, v): the column comes first, and u "
            "belongs to x.",
            section="step2-focal",
        ),
        Misconception(
            "behind-kept",
            "points behind the camera get a pixel, mirrored through the center. Where z is not "
            "positive, nothing is seen: return NaN.",
            section="step2-focal",
        ),
        Misconception(
            "ray-length",
            "you compare distance with depth. The depth image holds z along the optical axis: "
            "compare it with the point's z.",
            section="step3-range",
        ),
        Misconception(
            "nothing-hides",
            "you call everything visible that falls into the picture. Something may stand in "
            "front: compare with the depth image.",
        ),
        Misconception(
            "pixel-corner",
            "your pixels are half a pixel off. Whole numbers are pixel centers, and K is made for "
            "that: add no 0.5.",
            section="step2-center",
        ),
    ),
    hints=(
        "World to camera, camera to pixel, pixel to depth image: three steps, each one line.",
        "A rotation's inverse is its transpose: (p - t) @ R for points in rows.",
        "Arrays are indexed [row, column] with whole numbers: depth[v, u], after rounding.",
    ),
    example="""\
table = np.mgrid[0.7:1.3:25j, -0.5:0.5:41j, 0.86:0.86:1j].reshape(3, -1).T
pixels, visible = project_visible_points(table, T_world_cam, K, depth)
u, v = np.rint(pixels[visible]).astype(int).T
dots = np.zeros(depth.shape, bool)
dots[v, u] = True
show(lab.visualize_detection(rgb, None, dots), f"{len(u)} are visible")""",
    contract=(
        asked(
            "other-way",
            "from points in the world to pixels",
            "every case",
            "mistake row-column",
            "mistake pixel-corner",
        ),
        asked("which-seen", "Then ask which", "value of visible"),
        asked("outside-behind", "A point may lie outside the picture", "mistake behind-kept"),
        asked("hidden", "what is farther than the measured surface", "mistake nothing-hides"),
        asked("project", "Project points of the world", "value of pixels"),
        asked(
            "visible-rule", "A point is visible if", "mistake nothing-hides", "mistake ray-length"
        ),
        asked("hides-nothing", "hides nothing", "value of visible"),
        given("points", "Points in the world, meters"),
        asked("pose", "Pose of the camera", "mistake pose-not-inverted"),
        given("intrinsics", "Intrinsic matrix"),
        asked("along-the-axis", "What the camera measured", "mistake ray-length"),
        asked(
            "not-rounded",
            "not rounded, also outside the picture",
            "value of pixels",
            "mistake behind-kept",
        ),
        asked("sees", "Whether the camera sees the point", "value of visible"),
    ),
    visible=_visible,
    hidden=_hidden,
    absorbed=(Absorbed("ray-length", "nothing-hides", "who compares nothing compares no length"),),
)
