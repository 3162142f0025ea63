"""Back-projection, its inverse, frames, and what is left out."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from labutils import (
    camera_to_world,
    depth_to_pointcloud,
    pixels_to_points,
    points_to_pixels,
    world_to_camera,
)
from tests.helpers.tolerances import EXACT, FLOAT32_RTOL


def random_rotation(rng: np.random.Generator) -> np.ndarray:
    """A uniformly random rotation matrix."""
    q, r = np.linalg.qr(rng.normal(size=(3, 3)))
    q = q * np.sign(np.diag(r))
    return q * np.sign(np.linalg.det(q))


@pytest.mark.parametrize("shape", [(48, 64), (97, 31), (1, 1), (1, 7), (9, 1), (83, 5)])
@pytest.mark.parametrize("holes", [0.0, 0.3, 1.0])
def test_cloud_equals_the_formula_pixel_by_pixel(
    K: np.ndarray, shape: tuple[int, int], holes: float
) -> None:
    rng = np.random.default_rng(shape[0])
    depth = rng.uniform(0.1, 9, shape).astype(np.float32)
    depth[rng.random(shape) < holes] = np.nan
    rgb = rng.integers(0, 256, (*shape, 3), np.uint8)
    points, colors = depth_to_pointcloud(depth, K, rgb)
    assert colors is not None
    v, u = np.nonzero(~np.isnan(depth))
    z = depth[v, u].astype(np.float64)
    expected = np.stack([(u - K[0, 2]) / K[0, 0] * z, (v - K[1, 2]) / K[1, 1] * z, z], axis=1)
    assert points.shape == (len(z), 3)
    # Two float32 roundings of a slope and a product.
    assert_allclose(points, expected, rtol=4 * FLOAT32_RTOL, atol=1e-7)
    assert_allclose(colors, rgb[v, u] / 255, rtol=2 * FLOAT32_RTOL)
    assert colors.max(initial=0) <= 1


def test_what_is_no_surface_is_left_out(K: np.ndarray) -> None:
    row = [np.nan, np.inf, -np.inf, -1.0, 0.0, 0.01, 0.0101, 9.999, 10.0, 12.0]
    points, colors = depth_to_pointcloud(np.array([row]), K)
    assert_allclose(points[:, 2], [0.0101, 9.999], rtol=EXACT)
    assert colors is None


@pytest.mark.parametrize("holes", [0.0, 0.3])
def test_other_limits_leave_out_what_lies_outside_them(K: np.ndarray, holes: float) -> None:
    # More rows than one block has: full blocks take a path of their own.
    rng = np.random.default_rng(7)
    depth = rng.uniform(0.002, 0.009, (200, 30))
    depth[rng.random(depth.shape) < holes] = 0.5
    points, _ = depth_to_pointcloud(depth, K, min_depth=0.001, max_depth=0.5)
    assert_allclose(points[:, 2], depth[depth < 0.5], rtol=EXACT)
    far, _ = depth_to_pointcloud(10_000 * depth, K, min_depth=10.0, max_depth=5000.0)
    assert_allclose(far, 10_000 * points, rtol=EXACT)
    assert len(depth_to_pointcloud(depth, K)[0]) == (depth == 0.5).sum()


@pytest.mark.parametrize(
    ("limits", "error", "words"),
    [
        ({"min_depth": 10.0}, ValueError, "expected 0 < min_depth < max_depth, got 10.0 and 10.0"),
        ({"max_depth": np.inf}, ValueError, "expected 0 < min_depth < max_depth"),
        ({"min_depth": 0}, ValueError, "expected 0 < min_depth < max_depth"),
        ({"max_depth": "5"}, TypeError, "max_depth: expected meters as a number, got str '5'"),
    ],
)
def test_limits_that_are_none_are_refused(
    K: np.ndarray, limits: dict[str, Any], error: type[Exception], words: str
) -> None:
    with pytest.raises(error, match=words):
        depth_to_pointcloud(np.ones((2, 2)), K, **limits)


def test_a_few_invalid_rows_do_not_disturb_their_neighbors(K: np.ndarray) -> None:
    # Blocks of rows that are all valid take a faster path than blocks with holes.
    depth = np.full((200, 30), 2.0, np.float32)
    depth[90:95, 10:20] = np.nan
    points, colors = depth_to_pointcloud(depth, K, np.zeros((200, 30, 3), np.uint8))
    assert colors is not None
    assert len(points) == len(colors) == 200 * 30 - 50
    pixels = points_to_pixels(points, K)
    v, u = np.nonzero(~np.isnan(depth))
    assert_allclose(pixels, np.stack([u, v], axis=1), rtol=0, atol=1e-3)


@pytest.mark.parametrize(
    ("given", "returned"),
    [(np.float32, np.float32), (np.float64, np.float64), (np.uint8, np.float32)],
)
def test_points_are_float32_unless_float64_came_in(
    K: np.ndarray, given: type[np.generic], returned: type[np.generic]
) -> None:
    points, colors = depth_to_pointcloud(np.ones((3, 4), given), K, np.zeros((3, 4, 3), np.uint8))
    assert points.dtype == returned
    assert colors is not None
    assert colors.dtype == np.float32


@pytest.mark.parametrize("value", [0, 1, 254, 255])
def test_a_picture_of_one_color_keeps_it(K: np.ndarray, value: int) -> None:
    rgb = np.full((5, 6, 3), value, np.uint8)
    _, colors = depth_to_pointcloud(np.ones((5, 6)), K, rgb)
    assert colors is not None
    assert_allclose(colors, value / 255, rtol=2 * FLOAT32_RTOL)


def test_strided_and_listed_input_is_accepted(K: np.ndarray) -> None:
    depth = np.arange(1, 49, dtype=np.float32).reshape(6, 8)[::-1, ::2] / 10
    rgb = np.random.default_rng(0).integers(0, 256, (6, 16, 3), np.uint8)[:, ::4]
    points, _ = depth_to_pointcloud(depth, K, rgb)
    again, _ = depth_to_pointcloud(depth.tolist(), K.tolist())
    assert_allclose(points, again, rtol=1e-6)


def test_results_of_two_calls_share_no_memory(K: np.ndarray) -> None:
    depth = np.ones((5, 6), np.float32)
    first, _ = depth_to_pointcloud(depth, K)
    kept = first.copy()
    depth_to_pointcloud(2 * depth, K)
    assert_array_equal(first, kept)


@pytest.mark.parametrize(
    ("depth", "rgb", "error", "words"),
    [
        (np.ones(4), None, ValueError, r"depth_metric: expected a depth image of shape \(H, W\)"),
        (np.ones((4, 4), bool), None, TypeError, "depth_metric: expected real numbers"),
        (np.ones((4, 5)), np.zeros((5, 4, 3), np.uint8), ValueError, "rgb_image: expected the dep"),
        (np.ones((4, 5)), np.zeros((4, 5, 3)), TypeError, "rgb_image: expected a uint8"),
    ],
)
def test_bad_pictures_say_why(
    K: np.ndarray, depth: np.ndarray, rgb: np.ndarray | None, error: type[Exception], words: str
) -> None:
    with pytest.raises(error, match=words):
        depth_to_pointcloud(depth, K, rgb)


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        (np.eye(4), "expected a 3x3 matrix"),
        (np.array([[100, 0, 0], [0, 100, 0], [50, 40, 1.0]]), r"expected \[\[fx, 0, cx\]"),
        (np.array([[100, 2.0, 50], [0, 100, 40], [0, 0, 1]]), r"expected \[\[fx, 0, cx\]"),
        (np.array([[-100, 0, 50], [0, 100, 40], [0, 0, 1.0]]), "expected positive focal"),
        (np.array([[np.nan, 0, 50], [0, 100, 40], [0, 0, 1.0]]), r"expected \[\[fx, 0, cx\]"),
    ],
)
def test_a_matrix_that_is_no_intrinsics_is_refused(wrong: np.ndarray, words: str) -> None:
    with pytest.raises(ValueError, match=words):
        depth_to_pointcloud(np.ones((2, 2)), wrong)


def test_projecting_undoes_back_projecting(K: np.ndarray) -> None:
    for seed in range(20):
        rng = np.random.default_rng(seed)
        pixels = rng.uniform(-10, 100, (50, 2))
        depth = rng.uniform(0.1, 20, 50)
        assert_allclose(
            points_to_pixels(pixels_to_points(pixels, depth, K), K), pixels, rtol=0, atol=1e-10
        )


def test_points_behind_the_camera_have_no_pixel(K: np.ndarray) -> None:
    pixels = points_to_pixels([[0, 0, 1.0], [0, 0, 0.0], [0, 0, -1.0]], K)
    assert_allclose(pixels[0], [K[0, 2], K[1, 2]], rtol=0, atol=EXACT)
    assert np.isnan(pixels[1:]).all()


def test_nan_depth_gives_a_nan_point(K: np.ndarray) -> None:
    assert np.isnan(pixels_to_points([[3, 4]], [np.nan], K)).all()


def test_pixels_and_depths_must_match(K: np.ndarray) -> None:
    with pytest.raises(ValueError, match=r"depth: expected one value per pixel \(2\)"):
        pixels_to_points([[1, 2], [3, 4]], [1.0], K)
    with pytest.raises(ValueError, match=r"pixels: expected shape \(N, 2\)"):
        pixels_to_points([1, 2], [1.0], K)
    with pytest.raises(ValueError, match=r"points: expected shape \(N, 3\)"):
        points_to_pixels([[1, 2]], K)


def test_world_and_camera_frames_undo_each_other() -> None:
    for seed in range(20):
        rng = np.random.default_rng(seed)
        points, position = rng.normal(size=(30, 3)), rng.normal(size=3)
        rotation = random_rotation(rng)
        world = camera_to_world(points, position, rotation.ravel())
        assert_allclose(world_to_camera(world, position, rotation), points, rtol=0, atol=1e-12)
        # A rigid motion keeps distances.
        assert_allclose(
            np.linalg.norm(world[0] - world[1]), np.linalg.norm(points[0] - points[1]), rtol=1e-12
        )


def test_a_camera_with_mujocos_axes_looks_down_its_negative_z() -> None:
    # With cam_xmat = identity MuJoCo looks along world -z, y up; forward in OpenCV is +z.
    points = [[0, 0, 2.0], [1.0, 0, 0], [0, 1.0, 0]]
    ahead, right, below = camera_to_world(points, [10, 20, 30], np.eye(3))
    assert_allclose(ahead, [10, 20, 28], rtol=0, atol=EXACT)
    assert_allclose(right, [11, 20, 30], rtol=0, atol=EXACT)
    assert_allclose(below, [10, 19, 30], rtol=0, atol=EXACT)


def test_no_points_stay_no_points(K: np.ndarray) -> None:
    assert camera_to_world(np.empty((0, 3)), np.zeros(3), np.eye(3)).shape == (0, 3)
    assert depth_to_pointcloud(np.zeros((3, 3)), K)[0].shape == (0, 3)
    assert points_to_pixels(np.empty((0, 3)), K).shape == (0, 2)


@pytest.mark.parametrize("function", [camera_to_world, world_to_camera])
@pytest.mark.parametrize(
    ("position", "rotation", "words"),
    [
        (np.zeros(4), np.eye(3), "cam_xpos: expected 3 numbers"),
        (np.zeros(3), np.eye(4), "cam_xmat: expected 9 numbers or a 3x3 matrix"),
        (np.zeros(3), 2 * np.eye(3), "cam_xmat: expected a rotation matrix"),
        (np.zeros(3), np.diag([1, 1, -1]), "cam_xmat: expected a rotation matrix"),
        (np.zeros(3), np.full((3, 3), np.nan), "cam_xmat: expected a rotation matrix"),
    ],
)
def test_a_pose_that_is_none_is_refused(
    function: Callable[..., Any], position: np.ndarray, rotation: np.ndarray, words: str
) -> None:
    with pytest.raises(ValueError, match=words):
        function(np.zeros((1, 3)), position, rotation)
