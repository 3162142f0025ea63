"""Window depth to meters and back, validity, and the colored picture."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import cv2
import mujoco
import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from labutils import (
    find_valid_depth,
    get_clip_planes,
    make_renderer,
    metric_to_raw,
    process_depth,
    raycast_depth,
    render_camera,
    render_raw_depth,
    visualize_depth,
)
from labutils.raycast import RaycastRenderer
from tests.helpers.scenes import find_depth_edges
from tests.helpers.tolerances import FLOAT32_RTOL


def test_window_depth_ends_at_the_clip_planes() -> None:
    assert_allclose(process_depth(np.array([0.0, 1.0]), 0.3, 7.0), [0.3, 7.0], rtol=1e-15)


def test_window_depth_is_hyperbolic_not_linear() -> None:
    # Linear would say 5.05 m in the middle.
    assert_allclose(process_depth(np.array([0.5]), 0.1, 10.0), [2 / (1 / 0.1 + 1 / 10)], rtol=1e-12)


def test_metric_to_raw_undoes_process_depth() -> None:
    for seed in range(20):
        rng = np.random.default_rng(seed)
        near, span = rng.uniform(0.01, 1), rng.uniform(1, 50)
        metric = rng.uniform(near, near + span, (7, 5))
        raw = metric_to_raw(metric, near, near + span)
        # Far away one rounding of the raw value is worth span / near roundings of the distance.
        assert_allclose(process_depth(raw, near, near + span), metric, rtol=1e-15 * span / near * 8)


def test_values_outside_the_window_are_clipped_and_nan_stays() -> None:
    depth = process_depth(np.array([-0.5, 1.5, np.nan]), 1.0, 3.0)
    assert_array_equal(depth, [1.0, 3.0, np.nan])
    assert_array_equal(metric_to_raw(np.array([0.1, 99.0, np.nan]), 1.0, 3.0), [0, 1, np.nan])


@pytest.mark.parametrize(
    ("given", "returned"),
    [(np.float16, np.float32), (np.float32, np.float32), (np.float64, np.float64)],
)
def test_result_is_float32_unless_float64_came_in(
    given: type[np.generic], returned: type[np.generic]
) -> None:
    assert process_depth(np.ones((2, 3), given)).dtype == returned


def test_lists_and_integers_are_accepted() -> None:
    assert process_depth([[0, 1]], 1, 2).shape == (1, 2)


@pytest.mark.parametrize(
    ("near", "far", "error", "words"),
    [
        (0, 10, ValueError, "expected 0 < near < far, got 0 and 10"),
        (10, 0.1, ValueError, "expected 0 < near < far"),
        (0.1, float("inf"), ValueError, "expected 0 < near < far"),
        ("1", 2, TypeError, "near: expected meters as a number"),
    ],
)
def test_clip_planes_that_are_none_are_refused(
    near: Any, far: float, error: type[Exception], words: str
) -> None:
    with pytest.raises(error, match=words):
        process_depth(np.zeros(3), near, far)


@pytest.mark.parametrize("function", [process_depth, metric_to_raw, find_valid_depth])
def test_depth_that_is_no_number_is_refused(function: Callable[..., Any]) -> None:
    with pytest.raises(TypeError, match="expected real numbers"):
        function(np.array(["1"]))
    with pytest.raises(TypeError, match="expected real numbers"):
        function(np.array([True]))


def test_raw_buffer_becomes_the_true_depth_off_edges(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    model, data = scene
    with make_renderer(model, 240, 320) as renderer:
        raw = render_raw_depth(model, data, renderer, "head_camera")
    assert (raw.dtype, raw.shape) == (np.float32, (240, 320))  # type: ignore[comparison-overlap]  # a dtype equals its type
    truth = raycast_depth(model, data, "head_camera", 320, 240)
    inner = np.isfinite(truth) & ~find_depth_edges(truth)
    error = np.abs(process_depth(raw, *get_clip_planes(model)) - truth)[inner]
    # Read 0-near-1-far, float32 has steps of 6e-8 near 1: at 2 m with near = 0.02 that is
    # 2^2 / 0.02 * 6e-8 = 0.012 mm a step; multisampling adds up to 0.4 % of the distance.
    assert np.median(error) < 0.002
    # The rival, reading the buffer as linear, is off by meters.
    linear = 0.02 + raw * (12.0 - 0.02)
    assert np.median(np.abs(linear - truth)[inner]) > 5


def test_raw_buffer_leaves_the_renderer_usable(scene: tuple[mujoco.MjModel, mujoco.MjData]) -> None:
    model, data = scene
    with make_renderer(model, 48, 64) as renderer:
        before, _ = render_camera(model, data, renderer, "head_camera")
        render_raw_depth(model, data, renderer, "head_camera")
        after, _ = render_camera(model, data, renderer, "head_camera")
    assert_array_equal(after, before)


def test_raw_buffer_of_the_ray_caster_is_the_exact_one(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    model, data = scene
    renderer = RaycastRenderer(model, 48, 64)
    _, depth = render_camera(model, data, renderer, "head_camera")
    raw = render_raw_depth(model, data, renderer, "head_camera")
    expected = metric_to_raw(depth, *get_clip_planes(model))
    assert_allclose(raw, expected, rtol=FLOAT32_RTOL)


def test_clip_planes_follow_the_extent() -> None:
    xml = '<mujoco><statistic extent="3"/><visual><map znear="0.02" zfar="20"/></visual></mujoco>'
    assert get_clip_planes(mujoco.MjModel.from_xml_string(xml)) == (0.06, 60.0)


def test_valid_depth_excludes_its_limits_nan_and_infinity() -> None:
    depth = np.array([np.nan, -1, 0, 0.01, 0.011, 9.99, 10, np.inf, -np.inf])
    assert_array_equal(np.flatnonzero(find_valid_depth(depth)), [4, 5])
    with pytest.raises(ValueError, match="expected 0 < min_depth < max_depth"):
        find_valid_depth(depth, 2.0, 1.0)


def test_depth_picture_is_black_exactly_where_there_is_no_surface() -> None:
    depth = np.array([[np.nan, np.inf, -np.inf], [0.0, -1.0, 1e-3], [2.0, 5.0, 50.0]])
    picture = visualize_depth(depth)
    assert (picture.dtype, picture.shape) == (np.uint8, (3, 3, 3))  # type: ignore[comparison-overlap]  # a dtype equals its type
    black = (picture == 0).all(axis=-1)
    assert_array_equal(black, [[1, 1, 1], [1, 1, 0], [0, 0, 0]])
    assert_array_equal(picture[2, 1], picture[2, 2])


def test_depth_picture_scales_with_max_depth() -> None:
    assert_array_equal(visualize_depth([[1.0]], 2.0), visualize_depth([[2.5]], 5.0))
    table = cv2.applyColorMap(np.arange(256, dtype=np.uint8)[None], cv2.COLORMAP_TURBO)
    assert_array_equal(visualize_depth([[5.0]])[0, 0], table[0, 255])


@pytest.mark.parametrize(
    ("depth", "limit", "error", "words"),
    [
        (np.zeros(3), 5.0, ValueError, r"depth_metric: expected a depth image of shape \(H, W\)"),
        (np.zeros((2, 2, 1)), 5.0, ValueError, r"of shape \(H, W\)"),
        (np.zeros((2, 2)), 0.0, ValueError, "max_depth: expected meters > 0"),
        (np.zeros((2, 2)), float("nan"), ValueError, "max_depth: expected meters > 0"),
        (np.zeros((2, 2), complex), 5.0, TypeError, "expected real numbers"),
    ],
)
def test_depth_pictures_of_bad_input_say_why(
    depth: np.ndarray, limit: float, error: type[Exception], words: str
) -> None:
    with pytest.raises(error, match=words):
        visualize_depth(depth, limit)


def test_the_input_is_left_alone() -> None:
    depth = np.array([[0.5, np.nan], [2.0, -1.0]])
    kept = depth.copy()
    process_depth(depth)
    metric_to_raw(depth)
    visualize_depth(depth)
    assert_array_equal(depth, kept)
