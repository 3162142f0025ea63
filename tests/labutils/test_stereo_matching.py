"""Matching windows, refining and distrusting matches: against exact geometry and slow loops."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from labutils.stereo_matching import (
    cost_to_disparity,
    lr_check,
    make_right_cost,
    matching_cost,
    ssd_disparity,
    subpixel,
)
from labutils.stereo_truth import (
    find_disparity_edges,
    find_occluded,
    find_textureless,
    score_disparity,
    score_regions,
)
from tests.helpers.stereo_pairs import KnownPair, make_known_pair
from tests.helpers.tolerances import FLOAT32_RTOL

COUNT, WINDOW = 16, 5


@pytest.fixture(scope="module")
def pair() -> KnownPair:
    return make_known_pair(noise=2.0)


@pytest.fixture(scope="module")
def noise_pair() -> tuple[np.ndarray, np.ndarray]:
    """Give two pictures that have nothing in common: every cost is another one."""
    rng = np.random.default_rng(11)
    left, right = rng.integers(0, 256, (2, 13, 17), dtype=np.uint8)
    return left, right


def compute_cost_slowly(left: np.ndarray, right: np.ndarray, count: int, window: int) -> np.ndarray:
    """Compute the costs as the definition reads."""
    height, width = left.shape
    half = window // 2
    costs = np.full((count, height, width), np.inf)
    for d in range(count):
        for v in range(half, height - half):
            for u in range(half + d, width - half):
                rows = slice(v - half, v + half + 1)
                a = left[rows, u - half : u + half + 1].astype(float)
                b = right[rows, u - d - half : u - d + half + 1].astype(float)
                costs[d, v, u] = ((a - b) ** 2).sum()
    return costs


@pytest.mark.parametrize("window", [1, 3, 5])
def test_costs_are_those_of_the_definition(
    noise_pair: tuple[np.ndarray, np.ndarray], window: int
) -> None:
    # As wide as the picture and wider: the last candidates fit nowhere.
    for count in (1, 6, 17, 20):
        costs = matching_cost(*noise_pair, count, window)
        assert costs.dtype == np.float32
        assert_array_equal(costs, compute_cost_slowly(*noise_pair, count, window))


def test_pictures_smaller_than_the_window_have_no_match() -> None:
    left = np.arange(12.0).reshape(3, 4)
    assert np.isnan(ssd_disparity(left, left, 3, 5)).all()
    assert (ssd_disparity(left, left, 3, 5, padded=True) == 0).all()


def test_padded_costs_repeat_the_squares_at_the_edge_and_are_the_same_inside(
    noise_pair: tuple[np.ndarray, np.ndarray],
) -> None:
    plain = matching_cost(*noise_pair, 6, WINDOW)
    padded = matching_cost(*noise_pair, 6, WINDOW, padded=True)
    assert_array_equal(padded[np.isfinite(plain)], plain[np.isfinite(plain)])
    left, right = (picture.astype(float) for picture in noise_pair)
    squares = np.pad((left[:, 2:] - right[:, :-2]) ** 2, WINDOW // 2, mode="edge")
    assert padded[2, 0, 2] == squares[:WINDOW, :WINDOW].sum()
    assert np.isinf(padded[2, :, :2]).all()


@pytest.mark.parametrize("padded", [False, True])
def test_the_smallest_cost_wins_with_and_without_all_of_them(pair: KnownPair, padded: bool) -> None:
    costs = matching_cost(pair.left, pair.right, COUNT, WINDOW, padded=padded)
    disparity = ssd_disparity(pair.left, pair.right, COUNT, WINDOW, padded=padded)
    assert disparity.dtype == np.float32
    assert_array_equal(disparity, cost_to_disparity(costs))
    assert np.isnan(disparity).any() is np.bool_(not padded)


def test_of_equal_costs_the_smallest_disparity_wins() -> None:
    plain = np.full((5, 9), 7, np.uint8)
    assert_array_equal(ssd_disparity(plain, plain, 4, 3)[1:-1, 1:-1], 0)
    assert_array_equal(cost_to_disparity(np.ones((4, 2, 2))), np.zeros((2, 2)))


def test_costs_of_the_right_picture_are_those_of_the_mirrored_pair(
    noise_pair: tuple[np.ndarray, np.ndarray],
) -> None:
    left, right = noise_pair
    costs = make_right_cost(matching_cost(left, right, 6, WINDOW))
    # Seen in a mirror, what lies right in the left picture lies left: the roles are exchanged.
    mirrored = matching_cost(right[:, ::-1], left[:, ::-1], 6, WINDOW)[..., ::-1]
    assert_array_equal(costs, mirrored)


def test_a_small_shift_is_found_below_a_pixel() -> None:
    columns = np.arange(60.0)
    for true in (3.0, 3.25, 3.5, 3.75):
        rows = [100 + 50 * np.sin(place / 5) for place in (columns, columns + true)]
        left, right = (np.tile(row, (11, 1)) for row in rows)
        costs = matching_cost(left, right, 8, 9)
        found = subpixel(costs, cost_to_disparity(costs))[5, 20:-5]
        # The cost of a smooth texture is nearly a parabola: a whole pixel would be 0.5 px off.
        assert_allclose(found, true, atol=0.1)


def test_the_parabola_is_lowest_where_it_says() -> None:
    rng = np.random.default_rng(8)
    curve = rng.uniform(1, 5, (2, 3, 4))
    place = rng.uniform(1.5, 3.5, (3, 4))
    candidates = np.arange(6.0).reshape(-1, 1, 1)
    costs = curve[0] * (candidates - place) ** 2 + curve[1]
    assert_allclose(subpixel(costs, np.rint(place)), place, rtol=4 * FLOAT32_RTOL)


@pytest.mark.parametrize(
    ("costs", "disparity", "refined"),
    [
        ([1, 2, 3], 0, 0),  # no neighbor before
        ([3, 2, 1], 2, 2),  # none after
        ([np.inf, 1, 3], 1, 1),
        ([3, 1, np.inf], 1, 1),
        ([1, 1, 1], 1, 1),
        ([1, 2, 4], 1, 1),  # a lower neighbor: not the bottom
        ([1, 1, 3], 1, 0.5),
        ([9, 1, 9], 1, 1),
        ([9, 1, 3], np.nan, np.nan),
        ([np.inf, np.inf, np.inf], 1, 1),
    ],
)
def test_a_disparity_stays_where_no_parabola_fits(
    costs: list[float], disparity: float, refined: float
) -> None:
    found = subpixel(np.array(costs, float).reshape(3, 1, 1), np.array([[disparity]]))
    assert found.dtype == np.float32
    assert_array_equal(found, [[refined]])


def test_only_confirmed_matches_are_kept() -> None:
    left = np.array([[1.0, 1, 1, 2, np.nan, 1.4, 2.5, 0]])
    right = np.array([[1.0, 2.0, 9, np.nan, 0.4, 0, 0, -2]])
    # By column: out of the picture; 1 and 1; 1 and 2; 2 and 2; no match; 1.4 at column 4 and 0.4;
    # 2.5 leads to 3.5, so to column 4 and 0.4; 0 and -2.
    due = [[False, True, True, True, False, True, False, False]]
    assert_array_equal(lr_check(left, right), due)
    assert not lr_check(left, right, tolerance=0.9)[0, 2]
    assert lr_check(left, right, tolerance=2.2)[0].tolist().count(True) == 6


def test_matches_of_hidden_places_are_rejected_and_others_kept(pair: KnownPair) -> None:
    costs = matching_cost(pair.left, pair.right, COUNT, WINDOW, padded=True)
    found = cost_to_disparity(costs)
    kept = lr_check(found, cost_to_disparity(make_right_cost(costs)))
    hidden = find_occluded(pair.depth, pair.depth_right, pair.K, pair.baseline)
    assert 0.02 < hidden.mean() < 0.2
    assert kept[hidden].mean() < 0.35
    assert kept[~hidden].mean() > 0.9


def test_refined_and_checked_matches_are_close_to_the_truth(pair: KnownPair) -> None:
    costs = matching_cost(pair.left, pair.right, COUNT, 9, padded=True)
    whole = cost_to_disparity(costs)
    fine = subpixel(costs, whole)
    kept = lr_check(whole, cost_to_disparity(make_right_cost(costs)))
    hidden = find_occluded(pair.depth, pair.depth_right, pair.K, pair.baseline)
    edges = find_disparity_edges(pair.disparity)
    flat = ~hidden & ~edges
    found = score_disparity(np.where(kept, fine, np.nan), pair.disparity, flat)
    # Whole pixels: 0.26 and more, for the error is spread over one pixel.
    assert found.sd < 0.15
    assert score_disparity(whole, pair.disparity, flat).sd > 0.2
    assert found.not_correct < 0.03
    by_region = score_regions(fine, pair.disparity, {"flat": flat, "edges": ~hidden & edges})
    assert by_region["edges"].bad1 > 5 * by_region["flat"].bad1


def test_opencv_finds_the_same_disparities(pair: KnownPair) -> None:
    """Another method on the same pair: it cannot share a mistake of the sign or of a column."""
    left, right = (np.clip(one, 0, 255).astype(np.uint8) for one in (pair.left, pair.right))
    matcher = cv2.StereoSGBM.create(numDisparities=COUNT, blockSize=5)
    other = matcher.compute(left, right) / 16
    mine = ssd_disparity(left, right, COUNT)
    both = (other > 0) & np.isfinite(mine)
    assert both.mean() > 0.5
    assert np.median(np.abs(mine - other)[both]) < 0.5


# ---- Scores and regions


def test_shares_are_counted_as_they_are_defined() -> None:
    truth = np.array([[5.0, 5, 5, 5, 5, 5, np.nan, 5]])
    yours = np.array([[5.5, 4.5, 6.5, 8, np.nan, 5, 5, 99]])
    score = score_disparity(yours, truth, np.array([[1, 1, 1, 1, 1, 1, 1, 0]], bool))
    assert score.count == 6
    assert score.density == pytest.approx(5 / 6)
    shares = [score.bad1, score.bad2, score.wrong, score.not_correct]
    assert shares == pytest.approx([2 / 5, 1 / 5, 1 / 6, 2 / 6])
    assert score.sd == pytest.approx(np.std([0.5, -0.5, 0]))
    nothing = score_disparity(yours, truth, np.zeros((1, 8), bool))
    assert nothing.count == 0
    assert np.isnan(nothing.density)
    assert score_disparity(yours, truth).count == 7


def test_occlusion_lies_left_of_what_is_nearer_and_at_the_left_edge() -> None:
    K = np.array([[40.0, 0, 10], [0, 40.0, 1], [0, 0, 1]])
    depth = np.full((1, 20), 4.0)  # 1 px at this baseline
    depth[0, 8:12] = 1.0  # 4 px
    seen = np.full((1, 20), 4.0)
    seen[0, 4:8] = 1.0
    hidden = find_occluded(depth, seen, K, 0.1)
    assert np.flatnonzero(hidden).tolist() == [0, 5, 6, 7]


def test_no_depth_counts_as_occluded() -> None:
    depth = np.array([[np.nan, np.nan, 4.0]])
    assert find_occluded(depth, depth, np.eye(3), 0.1).tolist() == [[True, True, False]]


def test_a_jump_is_an_edge_as_far_as_the_window_reaches_and_a_slope_is_none() -> None:
    slope = np.tile(np.arange(20.0) * 0.8, (9, 1))
    assert not find_disparity_edges(slope)[:, 5:-5].any()
    step = np.where(np.arange(20) < 10, 3.0, 6.0)[None].repeat(9, axis=0)
    assert np.flatnonzero(find_disparity_edges(step, 5)[4]).tolist() == list(range(7, 13))


def test_a_plain_wall_is_told_from_a_textured_one_in_spite_of_noise() -> None:
    rng = np.random.default_rng(2)
    image = rng.normal(100, 2, (40, 60))
    image[:, 30:] += rng.normal(0, 20, (40, 30))
    plain = find_textureless(image)
    assert plain[:, :20].mean() > 0.99
    assert not plain[:, 35:].any()


# ---- What is refused

GRAY = np.zeros((4, 5), np.uint8)
COSTS = np.zeros((3, 4, 5))
FOUND = np.zeros((4, 5))


@pytest.mark.parametrize("function", [ssd_disparity, matching_cost])
@pytest.mark.parametrize(
    ("arguments", "error", "words"),
    [
        (("a", GRAY, 4), TypeError, "^left: expected real numbers, got str 'a'$"),
        (
            (GRAY, np.zeros((4, 5, 3)), 4),
            ValueError,
            r"^right: expected a gray picture \(H, W\), got an array of shape \(4, 5, 3\)",
        ),
        ((GRAY[:0], GRAY[:0], 4), ValueError, "^left: expected a gray picture"),
        ((GRAY * np.nan, GRAY, 4), ValueError, "^left: expected finite numbers, got NaN or inf"),
        ((GRAY, GRAY[1:], 4), ValueError, r"^right: expected shape \(4, 5\) as left, got \(3, 5\)"),
        ((GRAY, GRAY, 4.0), TypeError, "^max_disparity: expected a whole number, got float 4.0"),
        ((GRAY, GRAY, True), TypeError, "^max_disparity: expected a whole number, got bool"),
        ((GRAY, GRAY, 0), ValueError, "^max_disparity: expected at least 1 disparity, got 0"),
        ((GRAY, GRAY, 4, 4), ValueError, "^window: expected an odd number, .* got 4"),
        ((GRAY, GRAY, 4, -1), ValueError, "^window: expected at least 1 pixel, got -1"),
        ((GRAY, GRAY, 4, 3.0), TypeError, "^window: expected a whole number, got float 3.0"),
    ],
)
def test_pairs_that_are_none_are_refused(
    function: Any, arguments: tuple[Any, ...], error: type[Exception], words: str
) -> None:
    with pytest.raises(error, match=words):
        function(*arguments)


@pytest.mark.parametrize("function", [cost_to_disparity, make_right_cost])
def test_costs_that_are_none_are_refused(function: Any) -> None:
    with pytest.raises(
        ValueError, match=r"^cost: expected shape \(D, H, W\) with D > 0, got shape"
    ):
        function(FOUND)
    with pytest.raises(ValueError, match=r"got shape \(0, 4, 5\)"):
        function(COSTS[:0])
    with pytest.raises(TypeError, match=r"^cost: expected real numbers"):
        function("costs")


@pytest.mark.parametrize(
    ("found", "words"),
    [
        (FOUND[1:], r"^disparity: expected shape \(4, 5\) as the costs have, got \(3, 5\)"),
        (FOUND + 0.5, "^disparity: expected whole numbers from 0 to 2 or NaN, got 0.5"),
        (FOUND + 3, "got 3.0"),
        (FOUND - 1, "got -1.0"),
        (FOUND + np.inf, "got inf"),
    ],
)
def test_winners_that_are_no_candidates_are_refused(found: np.ndarray, words: str) -> None:
    with pytest.raises(ValueError, match=words):
        subpixel(COSTS, found)


def test_disparities_that_cannot_be_compared_are_refused() -> None:
    with pytest.raises(ValueError, match=r"^disparity_right: expected shape \(4, 5\) as disp"):
        lr_check(FOUND, FOUND[1:])
    with pytest.raises(ValueError, match=r"^tolerance: expected pixels above 0, got 0"):
        lr_check(FOUND, FOUND, 0)
    with pytest.raises(ValueError, match=r"^disparity_left: expected a depth image of shape"):
        lr_check(FOUND[0], FOUND)
    with pytest.raises(ValueError, match=r"^truth: expected shape \(4, 5\) as the others, got"):
        score_disparity(FOUND, FOUND[1:])
    with pytest.raises(ValueError, match=r"^counted: expected shape"):
        score_disparity(FOUND, FOUND, FOUND[1:] > 0)
    with pytest.raises(TypeError, match=r"^counted: expected a uint8 or bool mask"):
        score_disparity(FOUND, FOUND, FOUND)
    with pytest.raises(ValueError, match=r"^depth_right: expected shape"):
        find_occluded(FOUND, FOUND[1:], np.eye(3), 0.1)
    with pytest.raises(ValueError, match=r"^window: expected an odd number"):
        find_disparity_edges(FOUND, 4)
    with pytest.raises(ValueError, match=r"^limit: expected gray levels above 0, got 0"):
        find_textureless(FOUND, limit=0)
    with pytest.raises(ValueError, match=r"^image: expected a gray picture"):
        find_textureless(FOUND[0])
