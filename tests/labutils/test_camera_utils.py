"""Intrinsics and poses: derivation, limits, bad input."""

from __future__ import annotations

from typing import Any

import mujoco
import numpy as np
import pytest
from numpy.testing import assert_allclose

from labutils import get_camera_intrinsics, get_camera_pose, intrinsics_matrix
from tests.helpers.tolerances import EXACT


def test_focal_length_is_half_the_height_over_the_tangent_of_half_the_angle() -> None:
    for seed in range(20):
        rng = np.random.default_rng(seed)
        fov_y = rng.uniform(0.1, 3.0)
        width, height = rng.integers(1, 2000, 2)
        K = intrinsics_matrix(fov_y, int(width), int(height))
        # The upper edge of the picture, half a pixel above row 0, is seen at half the angle.
        upper = np.arctan((K[1, 2] + 0.5) / K[1, 1])
        assert_allclose(2 * upper, fov_y, rtol=0, atol=EXACT)
        assert K[0, 0] == K[1, 1]


def test_focal_length_scales_with_the_picture() -> None:
    small, large = intrinsics_matrix(0.8, 320, 240), intrinsics_matrix(0.8, 640, 480)
    assert_allclose(large[0, 0], 2 * small[0, 0], rtol=EXACT)


def test_intrinsics_are_float64_and_accept_numpy_sizes() -> None:
    assert intrinsics_matrix(0.8, np.int64(320), np.int32(240)).dtype == np.float64  # type: ignore[arg-type]  # they do as well


@pytest.mark.parametrize(
    ("arguments", "error", "words"),
    [
        ((45.0, 640, 480), ValueError, "expected radians between 0 and pi, got 45.0 .*degrees"),
        ((0.0, 640, 480), ValueError, "expected radians"),
        ((float("nan"), 640, 480), ValueError, "expected radians"),
        ((0.8, 0, 480), ValueError, "width: expected at least 1"),
        ((0.8, 640, -1), ValueError, "height: expected at least 1"),
        ((0.8, 640.0, 480), TypeError, "width: expected a whole number"),
        ((0.8, "640", 480), TypeError, "width: expected a whole number"),
    ],
)
def test_bad_input_says_what_was_expected(
    arguments: tuple[Any, ...], error: type[Exception], words: str
) -> None:
    with pytest.raises(error, match=words):
        intrinsics_matrix(*arguments)


def test_a_camera_by_fovy_has_the_intrinsics_of_its_angle(
    asymmetric: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    model, _ = asymmetric
    K, fov_y = get_camera_intrinsics(model, "plain", 400, 301)
    assert_allclose(fov_y, np.deg2rad(50), rtol=EXACT)
    assert_allclose(K, intrinsics_matrix(np.deg2rad(50), 400, 301), rtol=EXACT)


def test_unknown_and_orthographic_cameras_are_refused(
    asymmetric: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    model, data = asymmetric
    with pytest.raises(ValueError, match="expected one of sensor, plain, flat, got 'nose'"):
        get_camera_intrinsics(model, "nose", 10, 10)
    with pytest.raises(ValueError, match="expected one of"):
        get_camera_pose(model, data, "nose")
    with pytest.raises(ValueError, match="expected perspective, got orthographic"):
        get_camera_intrinsics(model, "flat", 10, 10)


def test_pose_is_a_rigid_transform(scene: tuple[mujoco.MjModel, mujoco.MjData]) -> None:
    T = get_camera_pose(*scene, "head_camera")
    assert_allclose(T[:3, :3] @ T[:3, :3].T, np.eye(3), rtol=0, atol=1e-9)
    assert np.linalg.det(T[:3, :3]) > 0
    assert_allclose(T[3], [0, 0, 0, 1], rtol=0, atol=0)
