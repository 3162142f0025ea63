"""The stereo explorer, against the two real eyes of the scene, and as the page computes."""

from __future__ import annotations

from typing import Any, NamedTuple

import mujoco
import numpy as np
import pytest

from labutils import (
    camera_to_world,
    find_valid_depth,
    get_camera_intrinsics,
    make_renderer,
    make_scene,
    pixels_to_points,
    points_to_pixels,
    render_camera,
    world_to_camera,
)
from labutils.explorers import explore_stereo
from labutils.explorers._base import DEPTH_STEP, decode_depth, decode_rgb
from labutils.explorers.stereo import StereoExplorer
from labutils.stereo import HIDDEN, OUTSIDE, SEEN
from tests.helpers.node import evaluate

BASELINE = 0.064  # of the scene's eyes
#: Both sides compute in double precision, in another order here and there.
SAME = 1e-12


class Eyes(NamedTuple):
    rgb: np.ndarray
    depth: np.ndarray
    right_rgb: np.ndarray
    right_depth: np.ndarray
    K: np.ndarray
    data: mujoco.MjData


@pytest.fixture(scope="module")
def eyes() -> Eyes:
    """What both eyes of the scene see, 320 x 240."""
    model, data = make_scene()
    renderer = make_renderer(model, 240, 320)
    try:
        rgb, depth = render_camera(model, data, renderer, "left_eye")
        right_rgb, right_depth = render_camera(model, data, renderer, "right_eye")
    finally:
        renderer.close()
    K, _ = get_camera_intrinsics(model, "left_eye", 320, 240)
    return Eyes(rgb, depth, right_rgb, right_depth, K, data)


@pytest.fixture
def explorer(eyes: Eyes) -> StereoExplorer:
    return explore_stereo(eyes.rgb, eyes.depth, eyes.K, BASELINE)


def choose_pixels(depth: np.ndarray, count: int, seed: int) -> list[list[int]]:
    v, u = np.nonzero(find_valid_depth(depth))
    chosen = np.random.default_rng(seed).choice(u.size, count, replace=False)
    return [[int(u[i]), int(v[i])] for i in chosen]


def project_into_right_eye(eyes: Eyes, u: int, v: int) -> tuple[np.ndarray, float]:
    """Follow one pixel of the left eye through the world into the right eye, with labutils."""
    left, right = (eyes.data.camera(f"{name}_eye") for name in ("left", "right"))
    point = pixels_to_points(np.array([[u, v]]), np.array([eyes.depth[v, u]]), eyes.K)
    world = camera_to_world(point, left.xpos, left.xmat)
    seen = world_to_camera(world, right.xpos, right.xmat)
    return points_to_pixels(seen, eyes.K)[0], seen[0, 2]


def test_disparity_is_where_the_real_right_eye_sees_the_point(
    eyes: Eyes, explorer: StereoExplorer
) -> None:
    for u, v in choose_pixels(eyes.depth, 40, seed=1):
        explorer.move(pixel=[u, v])
        (u_right, v_right), z_right = project_into_right_eye(eyes, u, v)
        values = explorer.values
        # depth travels in steps: half of one moves the disparity by d / Z times as much
        off = values["disparity"] / values["depth"] * DEPTH_STEP / 2 + 1e-4
        assert values["u_right"] == pytest.approx(u_right, abs=off)
        assert explorer.disparity == pytest.approx(u - u_right, abs=off)
        assert v_right == pytest.approx(v, abs=1e-4)
        assert values["depth"] == pytest.approx(z_right, abs=DEPTH_STEP)


def test_what_the_right_eye_sees_agrees_with_its_own_depth(
    eyes: Eyes, explorer: StereoExplorer
) -> None:
    """The left picture alone tells what is hidden, but for what only the right eye sees."""
    found, agree, checked = set(), 0, 0
    for u, v in choose_pixels(eyes.depth, 250, seed=2):
        explorer.move(pixel=[u, v])
        values = explorer.values
        column = round(values["u_right"])
        found.add(values["right"])
        assert (values["right"] == OUTSIDE) == (values["u_right"] < -0.5)
        if values["right"] == OUTSIDE:
            continue
        around = eyes.right_depth[v, max(column - 1, 0) : column + 2]
        # one pixel off at an edge is not another surface: any of the neighbors may be the one
        really = SEEN if np.abs(around - values["depth"]).min() < 0.02 else HIDDEN
        checked += 1
        agree += values["right"] == really
    assert found == {OUTSIDE, SEEN, HIDDEN}
    assert agree / checked > 0.97


def test_the_strip_shows_what_the_real_right_eye_sees(eyes: Eyes) -> None:
    rows = (90, 170)
    depths = np.where(find_valid_depth(eyes.depth), eyes.depth, 0)
    rgba = np.dstack([eyes.rgb, np.full(eyes.depth.shape, 255, np.uint8)])
    found = evaluate(
        "_right_eye",
        """(() => {
        const left = { colors: Uint32Array.from(colors), depths, width: 320 };
        const out = new Uint32Array(80 * 320);
        m.warpRows(left, rows, focal, baseline, out);
        return [...out];
        })()""",
        colors=np.ascontiguousarray(rgba).view("<u4").ravel().tolist(),
        depths=depths.ravel().tolist(),
        rows=rows,
        focal=eyes.K[0, 0],
        baseline=BASELINE,
    )
    strip = np.array(found, "<u4").view(np.uint8).reshape(80, 320, 4)
    seen = strip[..., 3] > 0
    assert 0.8 < seen.mean() < 0.99  # the rest lies behind something for the left eye
    off = np.abs(strip[..., :3].astype(int) - eyes.right_rgb[slice(*rows)]).max(axis=2)[seen]
    # edges may be a pixel off; the left picture as it is has five times as many wrong pixels
    unmoved = np.abs(eyes.rgb.astype(int) - eyes.right_rgb)[slice(*rows)].max(axis=2)
    assert (off > 40).mean() < (unmoved > 40).mean() / 5 < 0.1


def test_the_interval_holds_the_disparities_it_came_from(
    explorer: StereoExplorer, eyes: Eyes
) -> None:
    f = eyes.K[0, 0]
    for u, v in choose_pixels(eyes.depth, 20, seed=3):
        for baseline_mm, error in ((20.0, 3.0), (64.0, 0.5), (300.0, 0.1)):
            explorer.move(pixel=[u, v], baseline_mm=baseline_mm, error_px=error)
            values = explorer.values
            product = f * explorer.baseline
            assert explorer.depth_interval is not None
            z_near, z_far = explorer.depth_interval
            assert product / z_near - error == pytest.approx(values["disparity"])
            if np.isinf(z_far):
                assert values["disparity"] <= error
                assert values["error_mm"] is None
                continue
            assert product / z_far + error == pytest.approx(values["disparity"])
            assert values["error_mm"] == pytest.approx(1000 * (z_far - values["depth"]))
            assert values["error_mm"] > 1000 * (values["depth"] - z_near)  # the far end is worse
            # the series: exact = linear / (1 - e / d)
            ratio = 1 - error / values["disparity"]
            assert values["error_linear_mm"] == pytest.approx(values["error_mm"] * ratio)


def test_a_disparity_no_larger_than_its_error_has_no_far_end(
    explorer: StereoExplorer, eyes: Eyes
) -> None:
    farthest = np.where(find_valid_depth(eyes.depth), eyes.depth, 0).argmax()
    v, u = (int(one) for one in np.unravel_index(farthest, eyes.depth.shape))
    explorer.move(pixel=[u, v], baseline_mm=20.0)
    d = explorer.disparity
    assert d is not None
    explorer.move(error_px=d)
    assert explorer.depth_interval is not None
    assert explorer.depth_interval[1] == np.inf
    explorer.move(error_px=np.nextafter(d, 0))
    assert explorer.depth_interval is not None
    assert explorer.depth_interval[1] < np.inf
    explorer.move(error_px=d + 0.1)
    assert explorer.values["z_far"] is None
    assert repr(explorer).endswith("m or more")


def test_twice_the_baseline_halves_the_error_and_twice_the_depth_makes_it_four_times(
    explorer: StereoExplorer,
) -> None:
    explorer.move(baseline_mm=50.0, error_px=0.1)
    first = explorer.values["error_linear_mm"]
    explorer.move(baseline_mm=100.0)
    assert explorer.values["error_linear_mm"] == pytest.approx(first / 2)
    errors = "[1, 2].map((z) => m.findLinearError(z, 0.5, 579.4, 0.064))"
    one, two = evaluate("_stereo", errors)
    assert two == pytest.approx(4 * one)


def test_no_surface_means_nothing_to_match(explorer: StereoExplorer, eyes: Eyes) -> None:
    v, u = np.argwhere(~find_valid_depth(eyes.depth))[0]
    for pixel in ([int(u), int(v)], []):
        explorer.move(pixel=pixel)
        assert set(explorer.values.values()) == {None}
        assert explorer.disparity is explorer.depth_interval is None  # type: ignore[comparison-overlap]  # None is in both
    assert explorer.pixel is None
    assert repr(explorer) == "Stereo: no surface chosen, so nothing to match"
    np.testing.assert_array_equal(explorer.view.draw_poster(), eyes.rgb)


def test_the_page_computes_the_same(eyes: Eyes, explorer: StereoExplorer) -> None:
    pixels = choose_pixels(eyes.depth, 150, seed=4)
    v, u = np.argwhere(~find_valid_depth(eyes.depth))[5]
    pixels.append([int(u), int(v)])
    depth = decode_depth(explorer.view.depth_png).astype(np.float64)
    steps = np.round(depth / DEPTH_STEP)
    rows = np.where(find_valid_depth(depth), steps * DEPTH_STEP, 0)
    rng = np.random.default_rng(5)
    given, expected = [], []
    for i, (u, v) in enumerate(pixels):
        # every third with the sliders where far points have no far end
        baseline_mm = float(rng.integers(20, 301)) if i % 3 else 20.0
        error = round(float(rng.uniform(0.1, 3)), 1) if i % 3 else 3.0
        explorer.move(pixel=[u, v], baseline_mm=baseline_mm, error_px=error)
        expected.append(explorer.values)
        given.append([u, rows[v].tolist(), eyes.K[0, 0], baseline_mm / 1000, error])
    found = evaluate("stereo", "given.map((one) => m.describePair(...one))", given=given)
    assert any(one["z_far"] is None for one in expected[:-1])
    assert {one["right"] for one in expected} == {None, OUTSIDE, SEEN, HIDDEN}
    for ours, theirs in zip(expected, found, strict=True):
        assert theirs.keys() == ours.keys()
        for key, value in ours.items():
            assert theirs[key] == (value if value is None else pytest.approx(value, rel=SAME)), key


def test_the_tips_of_the_diamond_are_the_ends_of_the_interval(
    eyes: Eyes, explorer: StereoExplorer
) -> None:
    explorer.move(baseline_mm=40.0, error_px=1.5)
    values = explorer.values
    assert explorer.pixel is not None
    u, _ = explorer.pixel
    given = [[u, values["u_right"]], eyes.K.tolist(), 0.04, 1.5, 10]
    shapes = evaluate("_rays", "m.findShapes(...given)", given=given)
    near, side, tip, other_side = np.array(shapes["diamond"])
    assert near[1] == pytest.approx(values["z_near"])
    assert tip[1] == pytest.approx(values["z_far"])
    assert side[1] == pytest.approx(values["depth"])
    assert other_side[1] == pytest.approx(values["depth"])
    # every corner lies on a border of both wedges: project it back into both eyes
    fx, cx = eyes.K[0, 0], eyes.K[0, 2]
    for x, z in (near, side, tip, other_side):
        columns = np.array([x / z, (x - 0.04) / z]) * fx + cx
        np.testing.assert_allclose(np.abs(columns - [u, values["u_right"]]), 0.75, atol=1e-9)


def test_a_diamond_without_far_end_is_open(eyes: Eyes) -> None:
    given = [[100, 98], eyes.K.tolist(), 0.02, 3.0, 10]
    diamond = evaluate("_rays", "m.findShapes(...given).diamond", given=given)
    assert len(diamond) == 5
    assert [corner[1] for corner in diamond].count(10) == 2


def test_starts_at_the_surface_next_to_the_middle(eyes: Eyes) -> None:
    assert explore_stereo(eyes.rgb, eyes.depth, eyes.K).pixel == (160, 120)
    holes = eyes.depth.copy()
    holes[118:123, 155:170] = 12.0
    assert explore_stereo(eyes.rgb, holes, eyes.K).pixel == (160, 117)
    assert explore_stereo(eyes.rgb, eyes.depth, eyes.K, pixel=(3, 200)).pixel == (3, 200)


def test_starts_on_a_step_of_its_sliders(eyes: Eyes) -> None:
    explorer = explore_stereo(eyes.rgb, eyes.depth, eyes.K, 0.0647, 0.123)
    assert (explorer.baseline, explorer.match_error) == (0.065, 0.1)


def test_the_poster_marks_the_point_and_its_place_for_the_right_eye(
    explorer: StereoExplorer, eyes: Eyes
) -> None:
    explorer.move(pixel=[200, 200])
    poster = explorer.view.draw_poster()
    np.testing.assert_array_equal(decode_rgb(explorer.view.rgb_png), eyes.rgb)
    assert poster.shape == eyes.rgb.shape
    changed = np.argwhere((poster != eyes.rgb).any(axis=2))
    assert changed[:, 0].min() >= 190
    assert changed[:, 0].max() <= 210
    right = explorer.values["u_right"]
    assert changed[:, 1].min() == pytest.approx(right - 8, abs=2)
    assert changed[:, 1].max() == pytest.approx(209, abs=2)


@pytest.mark.parametrize(
    ("change", "error", "message"),
    [
        ({"depth_metric": np.ones((3, 4))}, ValueError, "expected the size of rgb_image"),
        ({"depth_metric": np.zeros((240, 320))}, ValueError, "expected a surface between"),
        ({"rgb_image": np.zeros((240, 320))}, TypeError, "rgb_image: expected a uint8 image"),
        ({"K": np.eye(2)}, ValueError, "K: expected a 3x3 matrix"),
        ({"baseline": 0.005}, ValueError, "baseline: expected 0.01 to 0.3, got 0.005"),
        ({"baseline": True}, TypeError, "baseline: expected a number, got bool"),
        ({"match_error": 4}, ValueError, "match_error: expected 0.1 to 3, got 4"),
        ({"match_error": "1"}, TypeError, "match_error: expected a number, got str"),
        ({"pixel": (320, 0)}, ValueError, r"pixel: expected \(u, v\) within 320 x 240 pixels"),
        ({"pixel": (1.5, 0)}, TypeError, r"pixel: expected \(u, v\), two whole numbers"),
        ({"pixel": (1, 2, 3)}, ValueError, r"pixel: expected \(u, v\) within 320 x 240"),
    ],
)
def test_bad_arguments_are_refused(
    eyes: Eyes, change: dict[str, Any], error: type[Exception], message: str
) -> None:
    arguments = {"rgb_image": eyes.rgb, "depth_metric": eyes.depth, "K": eyes.K, **change}
    with pytest.raises(error, match=message):
        explore_stereo(**arguments)


def test_the_goal_is_a_far_point_that_both_eyes_see_and_know_well(eyes: Eyes) -> None:
    explorer = explore_stereo(eyes.rgb, eyes.depth, eyes.K, pixel=(300, 5))
    assert explorer.values["depth"] > 1.5
    reached = [explorer.goal_is_reached]
    explorer.move(baseline_mm=300.0, error_px=0.1)
    reached.append(explorer.goal_is_reached)
    # as well known, but the right eye does not see it
    explorer.move(pixel=[5, 5])
    assert explorer.values["error_mm"] < 10
    assert explorer.values["right"] == OUTSIDE
    assert explorer.values["shared_depth"] is None
    reached.append(explorer.goal_is_reached)
    # on the table, near
    explorer.move(pixel=[300, 235])
    assert explorer.values["depth"] < 1.5
    reached.append(explorer.goal_is_reached)
    assert reached == [False, True, False, False]
