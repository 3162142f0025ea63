"""The depth range explorer: colors, counts and raw values, in Python and as the page computes."""

from __future__ import annotations

import cv2
import mujoco
import numpy as np
import pytest

from labutils import (
    find_valid_depth,
    get_clip_planes,
    make_renderer,
    metric_to_raw,
    render_camera,
    visualize_depth,
)
from labutils.explorers import _depth_picture as picture
from labutils.explorers import explore_depth_range
from labutils.explorers._base import DEPTH_STEP
from labutils.explorers.depth_range import BINS, DepthRangeExplorer
from tests.helpers.node import evaluate
from tests.helpers.tolerances import EXACT

CLIP = (0.02, 12.0)


@pytest.fixture
def depth(scene: tuple[mujoco.MjModel, mujoco.MjData]) -> np.ndarray:
    renderer = make_renderer(scene[0], 60, 80)
    try:
        return render_camera(*scene, renderer, "head_camera")[1]
    finally:
        renderer.close()


@pytest.fixture
def explorer(depth: np.ndarray, scene: tuple[mujoco.MjModel, mujoco.MjData]) -> DepthRangeExplorer:
    return explore_depth_range(depth, 0.8, 1.9, clip=get_clip_planes(scene[0]))


@pytest.fixture
def awkward() -> np.ndarray:
    """Every kind of pixel, and values on the limits, in an image as wide as its stripes are."""
    depth = np.random.default_rng(7).uniform(0, 5, (40, 61))
    depth[:2, :4] = [[0.01, 0.0102, 9.9998, 10.0], [12.0, 14.0, 0.0, np.nan]]
    depth[2, :5] = [np.inf, -1.0, 0.5, 2.5, 2.5002]
    return depth


def test_shares_and_invalid_pixels_are_those_of_labutils(
    explorer: DepthRangeExplorer, depth: np.ndarray
) -> None:
    values = explorer.values
    near, far = explorer.depth_range
    surface = find_valid_depth(depth)
    inside = surface & (depth >= near) & (depth <= far)
    # a step of depth moves the pixels on the limits: two of them would be many in this scene
    share = 100 * inside[surface].mean()
    assert values["share_inside"] == pytest.approx(share, abs=200 / depth.size)
    assert values["surfaces"] == np.count_nonzero(surface)
    assert values["no_surface"] == np.count_nonzero(~surface) > 0
    shares = [values[f"share_{name}"] for name in ("nearer", "inside", "farther")]
    assert sum(shares) == pytest.approx(100, abs=1e-9)
    assert values["left_out"] == pytest.approx((shares[0] + shares[2]) * values["surfaces"] / 100)
    assert min(shares) > 0


def test_histograms_are_those_of_numpy(explorer: DepthRangeExplorer, depth: np.ndarray) -> None:
    values = explorer.values
    steps = picture.decode_steps(explorer.view.depth_png)
    meters = steps[find_valid_depth(depth)] * DEPTH_STEP
    raw = metric_to_raw(meters, *CLIP)
    expected, _ = np.histogram(raw, BINS, (0, 1))
    assert values["raw_bins"] == expected.tolist()
    # depths on the border of two bins of 0.1 m are rounded either way by np.histogram
    off_border = np.abs(meters / 0.1 - np.round(meters / 0.1)) > 1e-9
    expected, _ = np.histogram(meters[off_border], BINS, (0, 5))
    assert np.abs(np.array(values["metric_bins"]) - expected).sum() == np.count_nonzero(~off_border)


def test_raw_values_crowd_at_one(explorer: DepthRangeExplorer) -> None:
    values = explorer.values
    assert values["raw_closest"] > 0.95
    assert np.count_nonzero(values["raw_bins"]) <= 3 < np.count_nonzero(values["metric_bins"])
    assert values["raw_range"] == pytest.approx(metric_to_raw([0.8, 1.9], *CLIP).tolist())


def test_a_pixel_is_read_in_meters_and_raw(explorer: DepthRangeExplorer, depth: np.ndarray) -> None:
    explorer.move(pixel=[40, 50])
    values = explorer.values
    assert explorer.pixel == (40, 50)
    assert values["pixel_depth"] == pytest.approx(float(depth[50, 40]), abs=DEPTH_STEP / 2 + 1e-6)
    assert values["pixel_raw"] == pytest.approx(metric_to_raw(values["pixel_depth"], *CLIP))


@pytest.mark.parametrize(
    ("pixel", "kind"),
    [
        ((0, 0), picture.NO_SURFACE),  # 0.01 m is no surface: the limits are excluded
        ((1, 0), picture.NEARER),
        ((2, 0), picture.FARTHER),
        ((3, 0), picture.NO_SURFACE),
        ((0, 1), picture.NO_SURFACE),
        ((2, 2), picture.INSIDE),  # the ends of the range belong to it
        ((3, 2), picture.INSIDE),
        ((4, 2), picture.FARTHER),
    ],
)
def test_each_pixel_is_told_its_kind(
    awkward: np.ndarray, pixel: tuple[int, int], kind: int
) -> None:
    explorer = explore_depth_range(awkward, 0.5, 2.5, clip=CLIP)
    explorer.move(pixel=list(pixel))
    assert explorer.values["pixel_kind"] == kind


@pytest.mark.parametrize("pixel", [(1, 1), (2, 1), (3, 1), (0, 2), (1, 2)])
def test_a_pixel_that_holds_no_depth_is_told_none(
    awkward: np.ndarray, pixel: tuple[int, int]
) -> None:
    explorer = explore_depth_range(awkward, clip=CLIP)
    assert explorer.pixel is None
    assert explorer.values["pixel_kind"] is None
    explorer.move(pixel=list(pixel))
    values = explorer.values
    assert values["pixel_depth"] is values["pixel_raw"] is None
    assert values["pixel_kind"] == picture.NO_SURFACE


def test_colors_are_those_of_visualize_depth(awkward: np.ndarray) -> None:
    explorer = explore_depth_range(awkward, 0.0, 5.0, clip=CLIP)
    steps = picture.decode_steps(explorer.view.depth_png)
    kinds = picture.find_kinds(steps, picture.Limits(0, 25000))
    ours = picture.paint_depth(steps, 0.0, 5.0, 0)
    theirs = cv2.cvtColor(visualize_depth(steps * DEPTH_STEP, 5.0), cv2.COLOR_BGR2RGB)
    inside = kinds == picture.INSIDE
    assert np.count_nonzero(inside) > 2000
    np.testing.assert_array_equal(ours[inside], theirs[inside])
    assert not ours[kinds == picture.NO_SURFACE].any()


def read_tables() -> np.ndarray:
    return np.frombuffer(picture.make_color_tables(), np.uint8).reshape(-1, 256, 3)


def test_color_tables_are_those_of_opencv() -> None:
    turbo, viridis, gray = read_tables()
    ramp = np.arange(256, dtype=np.uint8)[None]
    for table, code in ((turbo, cv2.COLORMAP_TURBO), (viridis, cv2.COLORMAP_VIRIDIS)):
        np.testing.assert_array_equal(table, cv2.applyColorMap(ramp, code)[0, :, ::-1])
    assert (gray == gray[:, :1]).all()
    assert (np.diff(gray[:, 0].astype(int)) >= 0).all()
    assert gray[-1, 0] == 255


def test_no_color_map_holds_black_or_the_colors_of_the_stripes() -> None:
    """What is no surface, too near or too far cannot be taken for a distance."""
    assert read_tables().max(axis=2).min() > 40
    steps = picture.to_step(1.0) + np.zeros((16, 16), int)
    nearer = picture.paint_depth(steps, 2.0, 3.0, 0)
    farther = picture.paint_depth(steps, 0.2, 0.5, 0)
    for stripes in (nearer, farther):
        assert len(np.unique(stripes.reshape(-1, 3), axis=0)) == 2
        np.testing.assert_array_equal(stripes[8:, :8], stripes[:8, 8:])
    assert (nearer != farther).any(axis=2).all()


@pytest.mark.parametrize("limits", [(0.0, 5.0), (0.5, 2.5), (1.0, 1.0)])
@pytest.mark.parametrize("color_map", [0, 1, 2])
def test_the_page_paints_and_counts_the_same(
    awkward: np.ndarray, limits: tuple[float, float], color_map: int
) -> None:
    explorer = explore_depth_range(awkward, clip=CLIP)
    explorer.move(range_m=list(limits), color_map=color_map)
    steps = picture.decode_steps(explorer.view.depth_png)
    given = {
        "png": list(explorer.view.depth_png),
        "tables": list(explorer.view.color_tables),
        "range": limits,
        "clip": CLIP,
        "valid": explorer.view.valid_m,
        "step": DEPTH_STEP,
        "upper": explorer.view.upper_m,
        "from": 768 * color_map,
    }
    found = evaluate(
        "_depth_picture",
        """await (async () => {
        const { decodePng } = await load("_png");
        const { data, width } = await decodePng(new Uint8Array(given.png));
        const [range, step] = [given.range, given.step];
        const [rangeSteps, valid] = [m.toSteps(range, step), m.toSteps(given.valid, step)];
        const table = m.readTable(given.tables, given.from);
        const [palette, out] = [new Uint32Array(m.LEVELS), new Uint32Array(data.length)];
        m.paintDepth(data, width, { table, range, rangeSteps, valid, step }, palette, out);
        const counts = m.countSteps(data);
        return {
          steps: [...data],
          rgba: [...new Uint8Array(out.buffer)],
          kinds: m.countKinds(counts, rangeSteps, valid),
          metric: m.binMetric(counts, 50, given.upper, step, valid),
          raw: m.binRaw(counts, 50, step, valid, given.clip),
        };
        })()""",
        given=given,
    )
    assert found["steps"] == steps.ravel().tolist()
    rgba = np.array(found["rgba"], np.uint8).reshape(*steps.shape, 4)
    np.testing.assert_array_equal(rgba[..., :3], picture.paint_depth(steps, *limits, color_map))
    assert (rgba[..., 3] == 255).all()
    values = explorer.values
    assert found["metric"] == values["metric_bins"]
    assert found["raw"] == values["raw_bins"]
    assert found["kinds"][picture.NO_SURFACE] == values["no_surface"]
    inside = 100 * found["kinds"][picture.INSIDE] / values["surfaces"]
    assert inside == pytest.approx(values["share_inside"], rel=EXACT)


def test_the_page_converts_as_labutils_does() -> None:
    z = np.linspace(0.001, 14, 400)
    raw = evaluate("_depth", "z.map((z) => m.metricToRaw(z, ...clip))", z=z.tolist(), clip=CLIP)
    np.testing.assert_allclose(raw, metric_to_raw(z, *CLIP), rtol=EXACT)


def test_the_poster_shows_the_picture_over_its_color_bar(
    explorer: DepthRangeExplorer, depth: np.ndarray
) -> None:
    poster = explorer.view.draw_poster()
    steps = picture.decode_steps(explorer.view.depth_png)
    assert poster.dtype == np.uint8
    assert poster.shape[1:] == (depth.shape[1], 3)
    shown = poster[: depth.shape[0]]
    np.testing.assert_array_equal(shown, picture.paint_depth(steps, 0.8, 1.9, 0))
    table = read_tables()[0]
    np.testing.assert_array_equal(poster[depth.shape[0] + 5, [0, -1]], table[[0, 255]])
    assert "0.80 to 1.90 m" in repr(explorer)


def test_the_slider_reaches_the_farthest_surface() -> None:
    far_away = np.full((4, 4), 7.3)
    assert explore_depth_range(far_away, clip=CLIP).view.upper_m == 7.5
    assert explore_depth_range(far_away, 1, 9.9, clip=CLIP).depth_range == (1.0, 9.9)


def test_depth_must_hold_a_surface() -> None:
    with pytest.raises(ValueError, match=r"depth_metric: expected a surface between .* got none"):
        explore_depth_range(np.full((4, 4), 12.0), clip=CLIP)
    with pytest.raises(ValueError, match="depth_metric: expected a depth image"):
        explore_depth_range(np.ones(4), clip=CLIP)


@pytest.mark.parametrize("limits", [(-0.1, 2), (2, 2), (3, 2), (0, 10.5)])
def test_limits_must_be_in_order_and_on_the_slider(limits: tuple[float, float]) -> None:
    with pytest.raises(ValueError, match=r"expected 0 <= near < far <= 10, got"):
        explore_depth_range(np.ones((4, 4)), *limits, clip=CLIP)


def test_clip_planes_must_be_in_order() -> None:
    with pytest.raises(ValueError, match=r"expected 0 < clip\[0\] < clip\[1\]"):
        explore_depth_range(np.ones((4, 4)), clip=(1.0, 0.5))


def test_the_goal_is_every_surface_in_the_tightest_range(depth: np.ndarray) -> None:
    explorer = explore_depth_range(depth, clip=CLIP)
    meters = depth[find_valid_depth(depth)]
    near, far = float(meters.min()) - 0.005, float(meters.max()) + 0.005
    span = far - near
    # the range at first holds every surface too: that alone is not the goal
    assert explorer.values["left_out"] == 0
    assert explorer.values["width_percent"] > 200
    assert not explorer.goal_is_reached
    for low, high, reached in (
        (near, far, True),
        (near, far + 0.03 * span, True),
        (near, far + 0.07 * span, False),
        (near + 0.02, far, False),
        (near, far - 0.02, False),
        (1.2, 1.2, False),
    ):
        explorer.move(range_m=[low, high])
        assert explorer.goal_is_reached is reached, (low, high)
