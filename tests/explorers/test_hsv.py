"""The HSV explorer: the values Python reads, and the arguments it takes."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest
import traitlets

from labutils import (
    HSV_RANGES,
    find_object_centroid,
    segment_by_color,
)
from labutils.explorers import explore_hsv
from labutils.explorers._base import encode_rgb
from labutils.explorers._modules import join_modules
from labutils.explorers.hsv import FULL_RANGE
from tests.helpers.node import run_node


def test_the_explorer_starts_with_the_limits_it_is_given_and_shows_every_color_without(
    rgb: np.ndarray,
) -> None:
    explorer = explore_hsv(rgb, HSV_RANGES["green"], open_radius=1, close_radius=3)
    assert explorer.hsv_range == HSV_RANGES["green"]
    assert (explorer.open_radius, explorer.close_radius) == (1, 3)
    assert explore_hsv(rgb).values["share"] == 1
    assert explore_hsv(rgb).hsv_range == FULL_RANGE


@pytest.mark.parametrize("color", HSV_RANGES)
def test_the_mask_is_the_one_of_segment_by_color(rgb: np.ndarray, color: str) -> None:
    explorer = explore_hsv(rgb, HSV_RANGES[color])
    expected = segment_by_color(rgb, HSV_RANGES[color])
    np.testing.assert_array_equal(explorer.mask, expected)
    assert explorer.mask.dtype == np.uint8
    assert explorer.values["count"] == np.count_nonzero(expected)
    assert explorer.values["share"] == np.count_nonzero(expected) / expected.size
    assert tuple(explorer.values["centroid"]) == find_object_centroid(expected)


def test_the_radii_are_those_of_opening_and_closing_with_a_square(rgb: np.ndarray) -> None:
    explorer = explore_hsv(rgb, HSV_RANGES["green"], open_radius=0, close_radius=0)
    raw = cv2.inRange(cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV), *HSV_RANGES["green"])
    np.testing.assert_array_equal(explorer.mask, raw)
    explorer.move(open_radius=1, close_radius=4)
    opened = cv2.morphologyEx(raw, cv2.MORPH_OPEN, np.ones((3, 3), np.uint8))
    closed = cv2.morphologyEx(opened, cv2.MORPH_CLOSE, np.ones((9, 9), np.uint8))
    np.testing.assert_array_equal(explorer.mask, closed)


def test_moved_controls_are_limits_that_segment_by_color_takes(rgb: np.ndarray) -> None:
    explorer = explore_hsv(rgb)
    explorer.move(hue_from=170, hue_to=6, saturation_limits=[120, 255], value_limits=[50, 255])
    assert explorer.hsv_range == HSV_RANGES["red"]
    np.testing.assert_array_equal(explorer.mask, segment_by_color(rgb, explorer.hsv_range))
    widget = explorer.controls["saturation_limits"].widget
    assert tuple(widget.value) == (120, 255)


def test_a_picked_pixel_tells_its_color_and_what_keeps_it_out() -> None:
    picture = np.array([[[200, 20, 20], [20, 20, 30]]], np.uint8)
    explorer = explore_hsv(picture, ((170, 120, 50), (6, 255, 255)), 0, 0)
    assert explorer.pixel is None
    assert explorer.pixel_rgb is None
    assert explorer.pixel_hsv is None
    explorer.move(pixel=[0, 0])
    assert explorer.pixel == (0, 0)
    assert explorer.pixel_rgb == (200, 20, 20)  # type: ignore[unreachable]  # the move picks a pixel
    assert explorer.pixel_hsv == (0, 229, 200)
    assert explorer.values["pixel_excluded_by"] == []
    assert explorer.values["pixel_inside"] is explorer.values["pixel_selected"] is True
    explorer.move(pixel=[1, 0])
    assert explorer.pixel_hsv == (120, 85, 30)
    assert explorer.values["pixel_excluded_by"] == ["hue", "saturation", "value"]
    assert explorer.values["pixel_inside"] is explorer.values["pixel_selected"] is False


def test_with_the_truth_the_goal_is_to_come_close_to_it(rgb: np.ndarray) -> None:
    truth = segment_by_color(rgb, HSV_RANGES["red"]) > 0
    explorer = explore_hsv(rgb, HSV_RANGES["green"], truth=truth, aim="Select what is red.")
    assert explorer.values["iou"] == 0
    assert explorer.goal is not None
    assert explorer.goal.text == "Select what is red."
    assert not explorer.goal_is_reached
    explorer.move(hue_from=170, hue_to=6, saturation_limits=[120, 255], value_limits=[190, 255])
    selected = explorer.mask > 0
    assert explorer.values["iou"] == (truth & selected).sum() / (truth | selected).sum() < 1
    explorer.move(value_limits=[50, 255])
    reached = explorer.goal_is_reached
    assert (explorer.values["iou"], reached) == (1, True)


def test_without_the_truth_there_is_no_goal(rgb: np.ndarray) -> None:
    explorer = explore_hsv(rgb)
    assert explorer.values["iou"] is None
    assert explorer.goal is None


@pytest.mark.parametrize("pixel", [[2, 0], [0, 1], [-1, 0], [0]])
def test_a_pixel_outside_the_picture_is_refused(pixel: list[int]) -> None:
    explorer = explore_hsv(np.zeros((1, 2, 3), np.uint8))
    with pytest.raises(
        traitlets.TraitError, match=r"pixel: expected \(u, v\) within 2 x 1 pixels, got list"
    ):
        explorer.move(pixel=pixel)


def test_nothing_selected_has_no_centroid(rgb: np.ndarray) -> None:
    explorer = explore_hsv(rgb, ((100, 250, 250), (101, 255, 255)))
    assert explorer.values["count"] == 0
    assert explorer.values["centroid"] is None
    assert repr(explorer).endswith("0.00% of the pixels selected, centroid none")


def test_the_sentence_and_the_poster_show_the_selection(rgb: np.ndarray) -> None:
    explorer = explore_hsv(rgb, HSV_RANGES["red"])
    x, y = explorer.values["centroid"]
    assert repr(explorer) == (
        f"HSV limits: (170, 120, 50) to (6, 255, 255), {explorer.values['share']:.2%} of the "
        f"pixels selected, centroid at ({x}, {y})"
    )
    poster = explorer.view.draw_poster()
    assert poster[y, x].tolist() == [255, 255, 255]  # the cross
    mask = explorer.mask.astype(bool)
    mask[y - 20 : y + 21, x - 20 : x + 21] = False
    np.testing.assert_array_equal(poster[mask], rgb[mask])
    outside = poster[explorer.mask == 0]
    away = np.ptp(outside, axis=1) > 0  # gray, and the cross is gray too
    assert not away.any()


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        ({"rgb": np.zeros((4, 4, 3))}, TypeError, "rgb: expected a uint8 image"),
        ({"rgb": np.zeros((4, 4), np.uint8)}, ValueError, r"rgb: expected .* \(H, W, 3\)"),
        ({"rgb": np.zeros((0, 4, 3), np.uint8)}, ValueError, "rgb: expected at least one pixel"),
        ({"hsv_range": (1, 2)}, ValueError, r"^hsv_range: expected \(\(h, s, v\)"),
        ({"hsv_range": ((0, 0, 0), (180, 9, 9))}, ValueError, "^hsv_range: .*degrees halved"),
        ({"hsv_range": ((0, 9, 0), (1, 8, 9))}, ValueError, "^hsv_range: only hue wraps"),
        ({"hsv_range": ((0, 0, 0), (1.5, 8, 9))}, TypeError, "^hsv_range: expected whole"),
        ({"open_radius": 7}, ValueError, "open_radius: expected 0 to 6 pixels, got 7"),
        ({"close_radius": -1}, ValueError, "close_radius: expected 0 to 6 pixels, got -1"),
        ({"open_radius": 1.5}, TypeError, "open_radius: expected a whole number"),
        ({"truth": np.ones((4, 4), np.uint8)}, ValueError, "truth: expected bool .*, got uint8"),
        ({"truth": np.ones((4, 5), bool)}, ValueError, r"shape \(4, 4\), got bool of \(4, 5\)"),
        ({"truth": np.zeros((4, 4), bool)}, ValueError, "truth: expected at least one pixel"),
        ({"close_radius": True}, TypeError, "close_radius: expected a whole number"),
    ],
)
def test_wrong_arguments_are_named(
    arguments: dict[str, Any], error: type[Exception], message: str
) -> None:
    with pytest.raises(error, match=message):
        explore_hsv(**{"rgb": np.zeros((4, 4, 3), np.uint8), **arguments})


def test_the_joined_view_is_one_module_with_a_default_export(tmp_path: Path) -> None:
    module = tmp_path / "joined.mjs"
    module.write_text(join_modules("hsv"), encoding="utf-8")
    code = "console.log(Object.keys((await import(process.argv[1])).default));"
    assert run_node(code, module.as_uri()).strip() == "[ 'render' ]"


def test_no_code_of_the_view_sends_anything() -> None:
    text = join_modules("hsv")
    for way_out in ("fetch(", "XMLHttpRequest", "WebSocket", "sendBeacon", "RTCPeerConnection"):
        assert way_out not in text
    assert "http" not in text.replace("http://www.w3.org/2000/svg", "")


def test_the_picture_travels_without_loss(rgb: np.ndarray) -> None:
    view = explore_hsv(rgb).view
    np.testing.assert_array_equal(view.rgb, rgb)
    assert view.rgb_png == encode_rgb(rgb)
