"""The matching explorer, against labutils, the truth of a recorded pair, and the page."""

from __future__ import annotations

from typing import Any, NamedTuple

import cv2
import numpy as np
import pytest

from labutils.explorers import MatchingExplorer, explore_matching
from labutils.explorers._base import decode_gray
from labutils.explorers._noise import add_noise, make_noise
from labutils.explorers._window_match import DISPARITY_STEP, WINDOWS, find_runner_up, refine
from labutils.recordings import load_recording
from labutils.stereo import HIDDEN, OUTSIDE, SEEN, depth_to_disparity, disparity_to_depth
from labutils.stereo_matching import matching_cost, ssd_disparity, subpixel
from labutils.stereo_truth import find_occluded
from tests.helpers.node import evaluate

LONGEST = 64
#: A part of the recorded view in which there are a pattern, a plain panel and a pole.
PART = np.s_[20:220, 60:480]
#: The same expressions in double precision, in the same order.
SAME = 1e-12
#: What `subpixel` rounds to: float32 at 64 pixels.
FLOAT32 = 1e-5

PLACES = {
    "texture": (220, 110),
    "pattern": (90, 40),
    "plain": (362, 30),
    "pole": (395, 140),
    "hidden": (376, 124),
}


class Pair(NamedTuple):
    left: np.ndarray
    right: np.ndarray
    K: np.ndarray
    baseline: float
    truth: np.ndarray
    occluded: np.ndarray


@pytest.fixture(scope="module")
def pair() -> Pair:
    """A recorded pair with the noise of its cameras."""
    found = load_recording("room").pairs[0]
    K, baseline = found.K, found.baseline
    depth, depth_right = found.depth[PART], found.depth_right[PART]
    return Pair(
        left=found.left[PART],
        right=found.right[PART],
        K=K,
        baseline=baseline,
        truth=depth_to_disparity(depth, K, baseline),
        occluded=find_occluded(depth, depth_right, K, baseline),
    )


def make_explorer(pair: Pair, **options: Any) -> MatchingExplorer:
    given = {"truth": pair.truth, "max_disparity": LONGEST, **options}
    return explore_matching(pair.left, pair.right, K=pair.K, baseline=pair.baseline, **given)


@pytest.fixture
def explorer(pair: Pair) -> MatchingExplorer:
    return make_explorer(pair)


def choose_settings(count: int, seed: int) -> list[dict[str, Any]]:
    """Choose pixels, windows, searches and noise, also at the edges of the picture."""
    rng = np.random.default_rng(seed)
    return [
        {
            "pixel": [int(rng.integers(420)), int(rng.integers(200))],
            "window": int(rng.choice(WINDOWS)),
            "search": int(rng.integers(8, LONGEST + 1)),
            "noise": int(rng.integers(0, 21)),
        }
        for _ in range(count)
    ]


@pytest.mark.parametrize("window", [3, 9, 31])
def test_the_curve_is_that_of_the_whole_cost_volume(
    pair: Pair, explorer: MatchingExplorer, window: int
) -> None:
    volume = matching_cost(pair.left, pair.right, LONGEST, window)
    disparity = ssd_disparity(pair.left, pair.right, LONGEST, window)
    refined = subpixel(volume, disparity)
    for setting in choose_settings(12, seed=1):
        u, v = setting["pixel"]
        explorer.move(pixel=[u, v], window=window)
        costs = volume[:, v, u]
        np.testing.assert_array_equal(explorer.costs, costs[np.isfinite(costs)])
        if np.isnan(disparity[v, u]):
            assert explorer.disparity is None
            continue
        assert explorer.values["disparity"] == disparity[v, u]
        assert explorer.disparity == pytest.approx(float(refined[v, u]), abs=FLOAT32)


def test_a_cost_is_the_sum_of_squared_differences_of_two_windows(
    pair: Pair, explorer: MatchingExplorer
) -> None:
    explorer.move(pixel=[200, 100], window=5)
    left = pair.left[98:103, 198:203].astype(float)
    right = pair.right[98:103, 191:196].astype(float)
    assert explorer.costs[7] == cv2.norm(left, right, cv2.NORM_L2SQR)


def test_errors_are_those_of_the_true_disparity_and_depth(
    pair: Pair, explorer: MatchingExplorer
) -> None:
    for u, v in PLACES.values():
        explorer.move(pixel=[u, v])
        values, truth = explorer.values, pair.truth[v, u]
        assert values["truth"] == pytest.approx(truth, abs=DISPARITY_STEP / 2)
        assert values["error_px"] == values["subpixel"] - values["truth"]
        depth = disparity_to_depth(values["subpixel"], pair.K, pair.baseline)
        assert values["depth"] == pytest.approx(float(depth))
        off = values["depth"] - values["true_depth"]
        assert values["depth_error_mm"] == pytest.approx(1000 * off)
        place = WINDOWS.index(explorer.window)
        assert values["errors_px"][place] == abs(values["error_px"])


def test_what_the_right_camera_does_not_see_agrees_with_its_own_depth(
    pair: Pair, explorer: MatchingExplorer
) -> None:
    states, agree = set(), 0
    settings = choose_settings(60, seed=2)
    for setting in settings:
        u, v = setting["pixel"]
        explorer.move(pixel=[u, v])
        states.add(explorer.values["right"])
        agree += (explorer.values["right"] != SEEN) == pair.occluded[v, u]
    assert states == {OUTSIDE, SEEN, HIDDEN}
    # edges of things may be a pixel off, and what only the right camera sees can hide as well
    assert agree / len(settings) > 0.95


@pytest.mark.parametrize(
    ("place", "right"),
    [
        ("texture", set(WINDOWS)),
        ("pattern", {29, 31}),
        ("plain", set()),
        ("hidden", set()),
    ],
)
def test_every_place_has_its_lesson(
    explorer: MatchingExplorer, place: str, right: set[int]
) -> None:
    """Texture suits every window, a pattern large ones; a plain and a hidden place suit none."""
    explorer.move(pixel=list(PLACES[place]))
    errors = dict(zip(WINDOWS, explorer.values["errors_px"], strict=True))
    assert {side for side, error in errors.items() if error <= 1} == right
    assert explorer.values["right_windows"] == len(right)


def test_a_thin_pole_suits_small_windows_alone(explorer: MatchingExplorer) -> None:
    explorer.move(pixel=list(PLACES["pole"]))
    errors = dict(zip(WINDOWS, explorer.values["errors_px"], strict=True))
    assert errors[3] < 1
    assert min(errors[side] for side in range(17, 32, 2)) > 10


def test_a_pattern_has_a_second_valley_one_period_away(explorer: MatchingExplorer) -> None:
    explorer.move(pixel=list(PLACES["pattern"]))
    values = explorer.values
    assert values["ratio"] > 0.5
    assert abs(values["second"] - values["disparity"]) == pytest.approx(12, abs=1)
    explorer.move(pixel=list(PLACES["texture"]))
    assert explorer.values["ratio"] < 0.1


def test_a_disparity_beyond_the_search_is_not_found(explorer: MatchingExplorer) -> None:
    explorer.move(pixel=list(PLACES["texture"]), search=LONGEST)
    found = explorer.disparity
    assert found is not None
    explorer.move(search=int(found) - 1)
    assert len(explorer.costs) == int(found) - 1
    assert explorer.values["right_windows"] == 0


def test_the_goal_is_a_pixel_that_needs_a_large_window(explorer: MatchingExplorer) -> None:
    reached = {}
    for name, pixel in PLACES.items():
        explorer.move(pixel=list(pixel))
        reached[name] = explorer.goal_is_reached
    assert not any(reached.values())
    share = 0
    for setting in choose_settings(30, seed=3):
        explorer.move(pixel=setting["pixel"])
        share += explorer.goal_is_reached
    assert 2 <= share <= 12  # to be found, and not everywhere


def test_a_window_beyond_the_picture_matches_nothing(explorer: MatchingExplorer) -> None:
    explorer.move(pixel=[4, 100], window=9)
    assert explorer.values["disparity"] == 0  # the one candidate that is left
    assert explorer.values["depth"] is None  # is infinitely far
    for pixel in ([3, 100], [416, 100], [200, 3], [200, 196], []):
        explorer.move(pixel=pixel)
        assert explorer.disparity is None
        assert explorer.costs.size == 0
        assert explorer.values["cost"] is explorer.values["second"] is None
    assert repr(explorer).endswith("so nothing to match")


def test_without_truth_there_is_a_match_and_no_goal(pair: Pair) -> None:
    explorer = make_explorer(pair, truth=None)
    assert explorer.goal is None
    values = explorer.values
    assert values["subpixel"] is not None
    assert values["depth"] is not None
    for name in ("truth", "true_depth", "error_px", "depth_error_mm", "right", "right_windows"):
        assert values[name] is None
    assert set(values["errors_px"]) == {None}


def test_a_hole_in_the_truth_is_not_known(pair: Pair) -> None:
    holed = pair.truth.copy()
    holed[100, 200] = np.nan
    explorer = make_explorer(pair, truth=holed, pixel=(200, 100))
    assert explorer.values["truth"] is None
    explorer.move(pixel=[201, 100])
    assert explorer.values["truth"] is not None


def test_a_flat_valley_and_an_end_of_the_curve_have_no_parabola() -> None:
    assert refine(np.array([5.0, 1.0, 3.0]), 1) == pytest.approx(1 + 2 / 12)
    assert refine(np.array([2.0, 2.0, 2.0]), 1) == 1
    assert refine(np.array([1.0, 2.0, 3.0]), 0) == 0
    assert refine(np.array([3.0, 2.0, 1.0]), 2) == 2


def test_the_runner_up_is_another_valley_and_not_a_slope() -> None:
    assert find_runner_up(np.array([9.0, 1.0, 2.0, 3.0, 4.0]), 1) is None
    assert find_runner_up(np.array([9.0, 1.0, 4.0, 2.0, 5.0, 3.0, 6.0]), 1) == 3
    assert find_runner_up(np.zeros(1), 0) is None


def test_noise_has_the_spread_it_is_asked_for_and_two_pictures_differ() -> None:
    gray = np.full((300, 400), 128, np.uint8)
    one, other = (add_noise(gray, 10, seed).astype(float) for seed in (0, 1))
    assert one.std() == pytest.approx(10, rel=0.01)
    assert one.mean() == pytest.approx(128, abs=0.1)
    for rolled in (other, np.roll(one, 1), np.roll(one, 400)):
        assert abs(np.corrcoef(one.ravel(), rolled.ravel())[0, 1]) < 0.01
    np.testing.assert_array_equal(add_noise(gray, 0, 1), gray)


def test_noise_stays_within_eight_bits() -> None:
    ends = np.repeat(np.array([[0], [255]], np.uint8), 500, axis=1)
    noisy = add_noise(ends, 20, 0)
    assert noisy[0].min() == 0
    assert noisy[0].max() < 128
    assert noisy[1].max() == 255
    assert noisy[1].min() > 128


def test_the_page_adds_the_same_noise() -> None:
    gray = np.random.default_rng(4).integers(0, 256, 500, np.uint8)
    found = evaluate(
        "_noise",
        """given.map(([sigma, seed]) => {
        const out = new Uint8ClampedArray(gray.length);
        m.addNoise(gray, m.makeNoise(gray.length, seed), sigma, out);
        return [...out];
        })""",
        gray=gray.tolist(),
        given=[[sigma, seed] for sigma in range(21) for seed in (0, 1)],
    )
    expected = [add_noise(gray, sigma, seed).tolist() for sigma in range(21) for seed in (0, 1)]
    assert found == expected
    assert make_noise(100_000, 1).min() >= -510


def test_the_page_computes_the_same(pair: Pair, explorer: MatchingExplorer) -> None:
    settings = choose_settings(30, seed=5)
    settings += [
        {**settings[0], "pixel": list(pixel)} for pixel in (*PLACES.values(), (2, 150), ())
    ]
    expected, given = [], []
    for setting in settings:
        explorer.move(**setting)
        left, right = explorer.view.make_pictures()
        expected.append(explorer.values)
        # the rows that a window can reach, so that not all pictures travel
        v = setting["pixel"][1] if setting["pixel"] else 0
        first, last = max(0, v - 15), min(200, v + 16)
        given.append(
            {
                **setting,
                "first": first,
                "left": left[first:last].ravel().tolist(),
                "right": right[first:last].ravel().tolist(),
                "row": decode_gray(explorer.view.truth_png)[v].tolist(),
            }
        )
    found = evaluate(
        "_matching",
        """given.map(({ left, right, first, row, pixel, window, search }) => {
        const place = (part) => {
          const whole = new Uint8ClampedArray(420 * 200);
          whole.set(part, first * 420);
          return whole;
        };
        const scene = {
          ...{ left: place(left), right: place(right), width: 420, height: 200, product },
          readRow: () => row.map((steps) => steps * step),
        };
        return m.describeMatch(scene, pixel, window, search);
        })""",
        given=given,
        product=pair.K[0, 0] * pair.baseline,
        step=DISPARITY_STEP,
    )
    assert {one["right"] for one in expected} == {None, OUTSIDE, SEEN, HIDDEN}
    for ours, theirs in zip(expected, found, strict=True):
        assert theirs.keys() == ours.keys()
        for name, value in ours.items():
            if isinstance(value, float):
                assert theirs[name] == pytest.approx(value, rel=SAME, abs=SAME), name
            elif name == "errors_px":
                known = [one for one in value if one is not None]
                assert [one for one in theirs[name] if one is not None] == pytest.approx(known)
            else:
                assert theirs[name] == value, name


def test_colors_are_matched_in_gray(pair: Pair) -> None:
    colored = [np.repeat(one[..., None], 3, axis=2) for one in (pair.left, pair.right)]
    explorer = explore_matching(*colored, K=pair.K, baseline=pair.baseline)
    np.testing.assert_array_equal(decode_gray(explorer.view.left_png), pair.left)


def test_places_are_kept_in_their_order_and_the_first_is_chosen(pair: Pair) -> None:
    explorer = make_explorer(pair, places={"z": (3, 4), "a": (5, 6)})
    assert explorer.view.places == [["z", [3, 4]], ["a", [5, 6]]]
    assert explorer.pixel == (3, 4)


def test_starts_in_the_middle_with_the_longest_search(explorer: MatchingExplorer) -> None:
    assert explorer.pixel == (210, 100)
    assert (explorer.window, explorer.view.search, explorer.view.noise) == (9, LONGEST, 0)


def test_the_poster_shows_the_window_and_below_it_the_match(pair: Pair) -> None:
    explorer = make_explorer(pair, pixel=PLACES["texture"])
    poster = explorer.view.draw_poster()
    assert poster.shape == (200 + 4 + 60, 420, 3)
    plain = np.repeat(pair.left[..., None], 3, axis=2)
    changed = np.argwhere((poster[:200] != plain).any(axis=2))
    assert np.ptp(changed, axis=0).tolist() == [12, 12]
    assert changed.mean(axis=0) == pytest.approx([110, 220], abs=1)
    explorer.move(pixel=[])
    np.testing.assert_array_equal(explorer.view.draw_poster(), plain)


def test_the_sentence_tells_the_match_and_its_error(explorer: MatchingExplorer) -> None:
    explorer.move(pixel=list(PLACES["plain"]))
    assert repr(explorer).startswith(
        "Matching: at (362, 30) windows of 9 x 9 pixels differ least at "
    )
    assert repr(explorer).endswith(f"{abs(explorer.values['error_px']):.2f} px from the truth")


@pytest.mark.parametrize(
    ("change", "error", "message"),
    [
        ({"left": np.zeros((4, 5), np.float32)}, ValueError, "left: expected uint8 with at least"),
        ({"left": np.zeros((0, 5), np.uint8)}, ValueError, "left: expected uint8 with at least"),
        ({"left": np.zeros((4, 5, 2), np.uint8)}, ValueError, "left: expected"),
        ({"right": np.zeros((4, 5), np.uint8)}, ValueError, "right: expected the size of left"),
        ({"truth": np.zeros((4, 5))}, ValueError, "truth: expected the size of left"),
        ({"K": np.eye(2)}, ValueError, "K: expected a 3x3 matrix"),
        ({"baseline": 0}, ValueError, "baseline: expected"),
        ({"window": 8}, ValueError, "window: expected an odd number"),
        ({"window": 33}, ValueError, "window: expected 3 to 31, got 33"),
        ({"window": 9.0}, TypeError, "window: expected a whole number"),
        ({"max_disparity": 7}, ValueError, "max_disparity: expected 8 to 256, got 7"),
        ({"max_disparity": True}, TypeError, "max_disparity: expected a whole number, got bool"),
        ({"noise": 21}, ValueError, "noise: expected 0 to 20, got 21"),
        ({"noise": "2"}, TypeError, "noise: expected a whole number, got str"),
        ({"pixel": (420, 0)}, ValueError, r"pixel: expected \(u, v\) within 420 x 200 pixels"),
        ({"places": {"far": (0, 200)}}, ValueError, r"places\['far'\]: expected \(u, v\) within"),
    ],
)
def test_bad_arguments_are_refused(
    pair: Pair, change: dict[str, Any], error: type[Exception], message: str
) -> None:
    arguments = {"left": pair.left, "right": pair.right, "K": pair.K, "baseline": pair.baseline}
    with pytest.raises(error, match=message):
        explore_matching(**{**arguments, **change})
