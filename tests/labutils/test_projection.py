"""Moving clouds between camera and world: precision, both ways to compute it, odd input."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from labutils import camera_to_world, projection, world_to_camera
from labutils._constants import FLIP_YZ
from tests.helpers.tolerances import FLOAT32_RTOL

FUNCTIONS = (camera_to_world, world_to_camera)

#: The rival spelling of the same motion, in double precision.
FORMULAS: dict[Callable[..., np.ndarray], Callable[..., np.ndarray]] = {
    camera_to_world: lambda p, t, R: p @ (R @ FLIP_YZ).T + t,
    world_to_camera: lambda p, t, R: (p - t) @ (R @ FLIP_YZ),
}


def make_motion(seed: int, distance: float = 1.0) -> tuple[np.ndarray, np.ndarray]:
    """A random position at a distance from the origin, and a rotation."""
    rng = np.random.default_rng(seed)
    q, r = np.linalg.qr(rng.normal(size=(3, 3)))
    q = q * np.sign(np.diag(r))
    position = rng.normal(size=3)
    return distance * position / np.linalg.norm(position), q * np.sign(np.linalg.det(q))


@pytest.fixture(params=["with OpenCV", "NumPy alone"])
def either_way(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """Compute with OpenCV, then as where it is not installed."""
    if request.param == "NumPy alone":
        monkeypatch.setattr(projection, "_find_opencv", lambda: None)
    else:
        assert projection._find_opencv() is not None


@pytest.mark.usefixtures("either_way")
@pytest.mark.parametrize("function", FUNCTIONS)
@pytest.mark.parametrize("count", [0, 1, 2, 3, 4, 5, 1000])
def test_double_precision_agrees_with_the_formula_to_rounding(
    function: Callable[..., np.ndarray], count: int
) -> None:
    position, rotation = make_motion(count)
    points = np.random.default_rng(count).uniform(-5, 5, (count, 3))
    moved = function(points, position, rotation)
    assert moved.dtype == np.float64
    # Four products and sums of numbers below 8.
    assert_allclose(moved, FORMULAS[function](points, position, rotation), rtol=0, atol=8e-15)


@pytest.mark.usefixtures("either_way")
@pytest.mark.parametrize("distance", [0.0, 1.0, 1e3, 1e6])
def test_float32_points_reach_the_world_with_errors_of_its_rounding(distance: float) -> None:
    position, rotation = make_motion(1, distance)
    points = np.random.default_rng(0).uniform(-5, 5, (5000, 3)).astype(np.float32)
    world = camera_to_world(points, position, rotation)
    assert world.dtype == np.float32
    error = world - FORMULAS[camera_to_world](points.astype(np.float64), position, rotation)
    # Three products, three sums and two roundings of what goes in, each half a step at most of the
    # largest number that can occur. At 1000 m that is 0.5 mm; a step alone is 0.06 mm.
    largest = np.sqrt(3) * 5 + distance
    assert np.abs(error).max() < 4 * FLOAT32_RTOL * largest


@pytest.mark.usefixtures("either_way")
@pytest.mark.parametrize("distance", [0.0, 1.0, 1e3, 1e6])
def test_float32_points_reach_the_camera_with_one_rounding_of_the_result(distance: float) -> None:
    # However far from the origin both are: no digit is lost but those that float32 had lost before.
    position, rotation = make_motion(2, distance)
    spread = np.random.default_rng(0).uniform(-5, 5, (5000, 3))
    points = (position + spread).astype(np.float32)
    found = world_to_camera(points, position, rotation)
    assert found.dtype == np.float32
    exact = FORMULAS[world_to_camera](points.astype(np.float64), position, rotation)
    assert_allclose(found, exact, rtol=FLOAT32_RTOL / 2 * 1.001, atol=1e-15 * (1 + distance))


@pytest.mark.usefixtures("either_way")
@pytest.mark.parametrize("function", FUNCTIONS)
@pytest.mark.parametrize("count", [0, 7])
@pytest.mark.parametrize(
    ("given", "returned"),
    [
        (np.float32, np.float32),
        (np.float64, np.float64),
        (np.float16, np.float64),
        (np.int64, np.float64),
        (np.uint8, np.float64),
        (">f8", np.float64),
    ],
)
def test_single_precision_stays_and_everything_else_becomes_double(
    function: Callable[..., np.ndarray], given: Any, returned: type[np.generic], count: int
) -> None:
    moved = function(np.ones((count, 3), given), *make_motion(0))
    assert moved.dtype == returned
    assert moved.shape == (count, 3)


@pytest.mark.usefixtures("either_way")
@pytest.mark.parametrize("function", FUNCTIONS)
@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_memory_in_any_order_is_read_and_left_alone(
    function: Callable[..., np.ndarray], dtype: type[np.floating]
) -> None:
    motion = make_motion(3)
    wide = np.random.default_rng(0).normal(size=(40, 8)).astype(dtype)
    wide.setflags(write=False)
    kept = wide.copy()
    plain = function(np.array(wide[::-2, 1:7:2]), *motion)
    assert_array_equal(function(wide[::-2, 1:7:2], *motion), plain)
    assert_array_equal(function(np.asfortranarray(wide[::-2, 1:7:2]), *motion), plain)
    assert_array_equal(wide, kept)
    plain[:] = 0  # what comes back is the caller's own
    assert_array_equal(wide, kept)


@pytest.mark.usefixtures("either_way")
@pytest.mark.parametrize("function", FUNCTIONS)
@pytest.mark.parametrize("bad", [np.nan, np.inf])
@pytest.mark.filterwarnings("ignore:invalid value encountered:RuntimeWarning")
def test_a_point_that_is_none_spoils_no_other(
    function: Callable[..., np.ndarray], bad: float
) -> None:
    motion = make_motion(4)
    points = np.random.default_rng(0).normal(size=(50, 3))
    right = function(points, *motion)
    points[17, 1] = bad
    moved = function(points, *motion)
    assert not np.isfinite(moved[17]).any()
    others = np.arange(50) != 17
    assert_allclose(moved[others], right[others], rtol=0, atol=8e-15)


def test_more_points_than_opencv_can_count_are_left_to_numpy(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    asked = []
    monkeypatch.setattr(projection, "_MOST_POINTS", 10)
    monkeypatch.setattr(projection, "_find_opencv", lambda: asked.append(True))
    motion = make_motion(5)
    for count, expected in ((9, 1), (10, 1), (0, 1)):
        camera_to_world(np.ones((count, 3)), *motion)
        assert len(asked) == expected
