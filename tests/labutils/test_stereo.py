"""Disparity, the interval of depths, errors, and what the right camera does not see."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from labutils import points_to_pixels
from labutils.stereo import (
    HIDDEN,
    OUTSIDE,
    SEEN,
    depth_to_disparity,
    disparity_to_depth,
    find_depth_error,
    find_depth_interval,
    find_linear_depth_error,
    find_right_state,
)
from tests.helpers.tolerances import EXACT

BASELINE = 0.064


@pytest.fixture
def depths() -> np.ndarray:
    return np.random.default_rng(4).uniform(0.2, 9.0, (6, 7))


def test_disparity_is_the_distance_between_the_two_projections(
    K: np.ndarray, depths: np.ndarray
) -> None:
    # The rival, fy, would give 180/210 of it; cx cancels out.
    x, y = np.random.default_rng(5).uniform(-1, 1, (2, depths.size))
    points = np.stack([x, y, depths.ravel()], axis=1)
    left = points_to_pixels(points, K)
    right = points_to_pixels(points - [BASELINE, 0, 0], K)
    disparity = depth_to_disparity(depths.ravel(), K, BASELINE)
    assert_allclose(left - right, np.stack([disparity, 0 * disparity], axis=1), atol=1e-9)


def test_depth_comes_back_from_its_disparity(K: np.ndarray, depths: np.ndarray) -> None:
    for baseline in (0.01, 0.064, 3.0):
        disparity = depth_to_disparity(depths, K, baseline)
        assert disparity.shape == depths.shape
        assert_allclose(disparity_to_depth(disparity, K, baseline), depths, rtol=EXACT)


def test_what_no_point_in_front_has_is_nan_and_infinity_is_kept(K: np.ndarray) -> None:
    depth = [np.nan, 0.0, -1.0, np.inf]
    assert_array_equal(depth_to_disparity(depth, K, BASELINE), [np.nan, np.nan, np.nan, 0.0])
    disparity = [np.nan, -0.5, 0.0, -0.0]
    assert_array_equal(disparity_to_depth(disparity, K, BASELINE), [np.nan, np.nan, np.inf, np.inf])


def test_the_ends_of_the_interval_have_a_disparity_one_error_away(
    K: np.ndarray, depths: np.ndarray
) -> None:
    error = 2.0
    near, far = find_depth_interval(depths, error, K, BASELINE)
    disparity = depth_to_disparity(depths, K, BASELINE)
    bounded = disparity > error
    assert 0 < bounded.sum() < bounded.size
    assert (near < depths).all()
    assert (far > depths).all()
    assert_allclose(depth_to_disparity(near, K, BASELINE), disparity + error, rtol=EXACT)
    assert_allclose(
        depth_to_disparity(far[bounded], K, BASELINE), (disparity - error)[bounded], rtol=1e-10
    )


def test_a_disparity_no_larger_than_its_error_has_no_far_end(K: np.ndarray) -> None:
    disparity = 2.0
    depth = disparity_to_depth(disparity, K, BASELINE)
    d = float(depth_to_disparity(depth, K, BASELINE))
    for error, bounded in ((np.nextafter(d, 0), True), (d, False), (d + 1, False)):
        near, far = find_depth_interval(depth, error, K, BASELINE)
        assert near < depth
        assert np.isfinite(far) == bounded
        assert bounded or np.isinf(find_depth_error(depth, error, K, BASELINE))


def test_no_rounding_next_to_the_limit_makes_an_error_negative(K: np.ndarray) -> None:
    for depth in np.random.default_rng(8).uniform(0.3, 5, 300):
        d = depth_to_disparity(depth, K, BASELINE)
        for error in (np.nextafter(d, 0), np.nextafter(np.nextafter(d, 0), 0)):
            assert find_depth_error(depth, float(error), K, BASELINE) > 0


def test_the_largest_error_is_the_far_end_minus_the_depth(
    K: np.ndarray, depths: np.ndarray
) -> None:
    for error in (1e-3, 0.5, 1.4):
        near, far = find_depth_interval(depths, error, K, BASELINE)
        largest = find_depth_error(depths, error, K, BASELINE)
        bounded = np.isfinite(far)
        assert bounded.any()
        assert_array_equal(np.isfinite(largest), bounded)
        assert_allclose(largest[bounded], (far - depths)[bounded], rtol=1e-9)
        assert (largest > depths - near).all()  # the far end is the farther off


def test_the_linear_error_is_the_limit_for_small_errors_and_never_larger(
    K: np.ndarray, depths: np.ndarray
) -> None:
    for error, share in ((1e-6, 1e-5), (1e-3, 1e-2)):
        linear = find_linear_depth_error(depths, error, K, BASELINE)
        exact = find_depth_error(depths, error, K, BASELINE)
        assert (linear < exact).all()
        assert_allclose(linear, exact, rtol=share)


def test_the_linear_error_grows_with_the_square_of_the_depth_and_falls_with_the_baseline(
    K: np.ndarray,
) -> None:
    first = find_linear_depth_error(1.5, 0.5, K, BASELINE)
    assert_allclose(find_linear_depth_error(3.0, 0.5, K, BASELINE), 4 * first, rtol=EXACT)
    assert_allclose(find_linear_depth_error(1.5, 1.0, K, BASELINE), 2 * first, rtol=EXACT)
    assert_allclose(find_linear_depth_error(1.5, 0.5, K, 2 * BASELINE), first / 2, rtol=EXACT)


@pytest.mark.parametrize("function", [find_depth_error, find_linear_depth_error])
def test_errors_of_what_is_no_depth_are_nan(K: np.ndarray, function: Callable[..., Any]) -> None:
    assert np.isnan(function([np.nan, 0.0, -2.0], 0.5, K, BASELINE)).all()


def test_the_interval_of_what_is_no_depth_is_nan(K: np.ndarray) -> None:
    for end in find_depth_interval([np.nan, 0.0, -2.0], 0.5, K, BASELINE):
        assert np.isnan(end).all()


def make_row(near: float, far: float, edge: int, width: int) -> np.ndarray:
    """Disparities of a near sheet from column `edge` on, before a far wall."""
    return np.where(np.arange(width) >= edge, near, far).astype(float)


def test_a_near_sheet_hides_as_many_columns_of_the_wall_as_the_disparities_differ() -> None:
    # The sheet (20 px) from column 60 on, the wall at 8 px: in the right picture the sheet starts
    # at column 40, where the wall's column 48 would be. So of the wall 48 to 59 are hidden: 20 - 8.
    row = make_row(20, 8, 60, 100)
    states = np.array([find_right_state(u, row) for u in range(row.size)])
    assert_array_equal(np.flatnonzero(states == HIDDEN), np.arange(48, 60))
    assert_array_equal(np.flatnonzero(states == OUTSIDE), np.arange(8))
    assert (states[60:] == SEEN).all()


def test_a_sheet_that_is_hardly_nearer_hides_nothing() -> None:
    # One pixel of disparity may be a slope, or rounding: not yet another surface.
    row = make_row(9, 8, 60, 100)
    assert HIDDEN not in {find_right_state(u, row) for u in range(row.size)}
    row = make_row(9.01, 8, 60, 100)
    assert HIDDEN in {find_right_state(u, row) for u in range(row.size)}


def test_the_edge_of_the_picture_lies_half_a_pixel_beyond_its_first_column() -> None:
    assert find_right_state(3, np.full(9, 3.5)) == SEEN
    assert find_right_state(3, np.full(9, 3.51)) == OUTSIDE


def test_no_surface_hides_nothing() -> None:
    row = make_row(np.nan, 8, 60, 100)
    assert {find_right_state(u, row) for u in range(8, 60)} == {SEEN}


def test_what_lies_to_the_left_hides_nothing() -> None:
    # A sheet left of the wall moves away from it in the right picture.
    row = make_row(8, 20, 60, 100)
    assert {find_right_state(u, row) for u in range(60, 100)} == {SEEN}


@pytest.mark.parametrize(
    ("u", "row", "error", "words"),
    [
        (
            0,
            np.ones((2, 2)),
            ValueError,
            r"disparity_row: expected shape \(W,\), got shape \(2, 2\)",
        ),
        (0, ["a"], TypeError, "disparity_row: expected real numbers"),
        (1.0, np.ones(3), TypeError, "u: expected a whole number, got float 1.0"),
        (True, np.ones(3), TypeError, "u: expected a whole number, got bool"),
        (3, np.ones(3), ValueError, "u: expected a column from 0 to 2, got 3"),
        (-1, np.ones(3), ValueError, "u: expected a column from 0 to 2, got -1"),
        (0, [np.nan, 1.0], ValueError, "u: expected a column that sees a surface, got 0"),
    ],
)
def test_a_column_or_row_that_is_none_is_refused(
    u: Any, row: Any, error: type[Exception], words: str
) -> None:
    with pytest.raises(error, match=words):
        find_right_state(u, row)


WITHOUT_ERROR = (depth_to_disparity, disparity_to_depth)
WITH_ERROR = (find_depth_error, find_depth_interval, find_linear_depth_error)


@pytest.mark.parametrize(
    ("change", "error", "words"),
    [
        ({"K": np.eye(2)}, ValueError, "K: expected a 3x3 matrix"),
        ({"baseline": 0.0}, ValueError, "baseline: expected meters above 0, got 0.0"),
        ({"baseline": "1"}, TypeError, "baseline: expected meters as a number"),
    ],
)
@pytest.mark.parametrize("function", WITHOUT_ERROR + WITH_ERROR)
def test_a_pair_of_cameras_that_is_none_is_refused(
    K: np.ndarray,
    function: Callable[..., Any],
    change: dict[str, Any],
    error: type[Exception],
    words: str,
) -> None:
    given = {"K": K, "baseline": BASELINE} | change
    if function in WITH_ERROR:
        given["match_error"] = 0.5
    with pytest.raises(error, match=words):
        function(np.ones(2), **given)


@pytest.mark.parametrize("function", WITHOUT_ERROR + WITH_ERROR)
def test_what_is_no_number_is_refused_by_name(K: np.ndarray, function: Callable[..., Any]) -> None:
    given = {"K": K, "baseline": BASELINE}
    if function in WITH_ERROR:
        given["match_error"] = 0.5
    name = "disparity" if function is disparity_to_depth else "depth_metric"
    with pytest.raises(TypeError, match=f"^{name}: expected real numbers"):
        function(["1"], **given)


@pytest.mark.parametrize("function", WITH_ERROR)
def test_a_match_error_that_is_none_is_refused(K: np.ndarray, function: Callable[..., Any]) -> None:
    with pytest.raises(ValueError, match="match_error: expected pixels above 0, got -1"):
        function(1.0, -1, K, BASELINE)
    with pytest.raises(TypeError, match="match_error: expected pixels as a number, got NoneType"):
        function(1.0, None, K, BASELINE)
