"""Masks by color, the seam of the hue circle, centroids."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np
import pytest
from numpy.testing import assert_array_equal

from labutils import HSV_RANGES, find_object_centroid, segment_by_color, visualize_detection


def make_hue_picture(hue: int, size: tuple[int, int] = (30, 40)) -> np.ndarray:
    """A picture of one saturated hue, as RGB."""
    hsv = np.full((*size, 3), (hue, 255, 255), np.uint8)
    return cv2.cvtColor(hsv, cv2.COLOR_HSV2RGB)


@pytest.mark.parametrize("hue", [0, 5, 10, 170, 175, 179])
def test_a_range_with_low_above_high_wraps_through_red(hue: int) -> None:
    assert segment_by_color(make_hue_picture(hue), ((170, 100, 100), (10, 255, 255))).all()


@pytest.mark.parametrize("hue", [12, 60, 120, 168])
def test_a_wrapping_range_leaves_the_other_hues_out(hue: int) -> None:
    assert not segment_by_color(make_hue_picture(hue), ((170, 100, 100), (10, 255, 255))).any()


def test_limits_are_inclusive() -> None:
    picture = make_hue_picture(60)
    assert segment_by_color(picture, ((60, 255, 255), (60, 255, 255))).all()


def test_saturation_and_value_gate_a_wrapping_range_on_both_sides() -> None:
    gray = np.full((20, 20, 3), 120, np.uint8)  # hue 0, saturation 0
    assert not segment_by_color(gray, ((170, 50, 50), (10, 255, 255))).any()
    dark = make_hue_picture(178) // 10
    assert not segment_by_color(dark, ((170, 50, 50), (10, 255, 255))).any()


def test_a_wrapping_range_is_the_union_of_its_halves() -> None:
    rng = np.random.default_rng(4)
    picture = cv2.resize(rng.integers(0, 256, (12, 16, 3), np.uint8), (96, 72))
    hsv = cv2.cvtColor(picture, cv2.COLOR_RGB2HSV)
    h, s, v = cv2.split(hsv)
    raw = (((h >= 160) | (h <= 20)) & (s >= 40) & (v >= 60)).astype(np.uint8) * 255
    kernel = np.ones((5, 5), np.uint8)
    opened = cv2.morphologyEx(raw, cv2.MORPH_OPEN, kernel)
    expected = cv2.morphologyEx(opened, cv2.MORPH_CLOSE, kernel)
    assert_array_equal(segment_by_color(picture, ((160, 40, 60), (20, 255, 255))), expected)


def test_opening_comes_first_so_specks_go_and_holes_close() -> None:
    picture = np.zeros((60, 60, 3), np.uint8)
    picture[10:40, 10:40] = (0, 255, 0)
    picture[20:23, 20:23] = 0  # a hole of 3: closed
    picture[50:54, 50:54] = (0, 255, 0)  # a speck of 4: gone; closing first would keep it
    mask = segment_by_color(picture, HSV_RANGES["green"])
    assert mask[10:40, 10:40].all()
    assert not mask[45:, 45:].any()
    assert set(np.unique(mask)) == {0, 255}
    assert mask.dtype == np.uint8


def test_numpy_ranges_and_lists_are_accepted() -> None:
    picture = make_hue_picture(60)
    assert segment_by_color(picture, np.array([[50, 0, 0], [70, 255, 255]])).all()  # type: ignore[arg-type]  # they do as well
    assert segment_by_color(picture, [[50, 0, 0], [70, 255, 255]]).all()  # type: ignore[arg-type]  # they do as well


@pytest.mark.parametrize(
    ("limits", "error", "words"),
    [
        (((0, 0, 0), (200, 255, 255)), ValueError, "hue is 0-179 in OpenCV"),
        (((0, 0, 0), (10, 300, 255)), ValueError, "expected 0 to"),
        (((-1, 0, 0), (10, 255, 255)), ValueError, "expected 0 to"),
        (((0, 200, 0), (10, 100, 255)), ValueError, "only hue wraps"),
        (((0, 0, 200), (10, 255, 100)), ValueError, "only hue wraps"),
        (((0, 0), (10, 255)), ValueError, "expected .*h, s, v"),
        (((0.5, 0, 0), (10, 255, 255)), TypeError, "expected whole numbers"),
    ],
)
def test_ranges_that_are_none_are_refused(
    limits: tuple[Any, ...], error: type[Exception], words: str
) -> None:
    with pytest.raises(error, match=words):
        segment_by_color(make_hue_picture(0), limits)


@pytest.mark.parametrize(
    ("picture", "error", "words"),
    [
        (np.zeros((4, 4, 3)), TypeError, "rgb_image: expected a uint8 image"),
        (np.zeros((4, 4), np.uint8), ValueError, r"shape \(H, W, 3\)"),
        (np.zeros((4, 4, 4), np.uint8), ValueError, r"shape \(H, W, 3\)"),
    ],
)
def test_pictures_that_are_none_are_refused(
    picture: np.ndarray, error: type[Exception], words: str
) -> None:
    with pytest.raises(error, match=words):
        segment_by_color(picture, HSV_RANGES["red"])


def test_centroid_is_column_then_row() -> None:
    mask = np.zeros((40, 80), np.uint8)
    mask[5:16, 50:71] = 255  # rows 5-15, columns 50-70
    assert find_object_centroid(mask) == (60, 10)


def test_centroid_is_of_the_largest_object_not_of_all() -> None:
    mask = np.zeros((60, 100), np.uint8)
    mask[2:10, 2:10] = 255
    mask[30:51, 60:91] = 255
    assert find_object_centroid(mask) == (75, 40)


def test_size_is_area_not_length_of_outline() -> None:
    mask = np.zeros((60, 200), np.uint8)
    mask[5:7, 0:200] = 255  # long and thin: 199 square pixels of contour area
    mask[30:51, 90:111] = 255  # 400
    assert find_object_centroid(mask) == (100, 40)


def test_centroid_is_the_center_of_mass_not_of_the_box() -> None:
    mask = np.zeros((60, 60), np.uint8)
    mask[10:51, 10:21] = 255
    mask[40:51, 10:51] = 255  # an L, whose box is centered at (30, 30)
    centroid = find_object_centroid(mask)
    assert centroid is not None
    x, y = centroid
    assert x < 25
    assert y > 35


@pytest.mark.parametrize(
    "mask",
    [
        np.zeros((10, 10), np.uint8),
        np.pad(np.full((1, 1), 255, np.uint8), 5),  # a dot has no area
        np.pad(np.full((1, 6), 255, np.uint8), 3),  # nor has a line
    ],
)
def test_nothing_with_an_area_gives_none(mask: np.ndarray) -> None:
    assert find_object_centroid(mask) is None


def test_bool_masks_and_any_nonzero_value_count_as_inside() -> None:
    mask = np.zeros((20, 20), bool)
    mask[4:11, 4:15] = True
    assert find_object_centroid(mask) == find_object_centroid(mask.astype(np.uint8)) == (9, 7)
    centroid = find_object_centroid(mask)
    assert centroid is not None
    assert all(isinstance(value, int) for value in centroid)


@pytest.mark.parametrize(
    ("mask", "error"),
    [(np.zeros((4, 4)), TypeError), (np.zeros((4, 4, 3), np.uint8), ValueError)],
)
def test_masks_that_are_none_are_refused(mask: np.ndarray, error: type[Exception]) -> None:
    with pytest.raises(error, match="mask: expected a"):
        find_object_centroid(mask)


def test_a_detection_is_drawn_on_a_copy() -> None:
    picture = np.full((60, 80, 3), 50, np.uint8)
    mask = np.zeros((60, 80), np.uint8)
    mask[10:30, 10:30] = 255
    drawn = visualize_detection(picture, (40, 30), mask)
    assert (picture == 50).all()
    assert_array_equal(drawn[30, 50], [0, 255, 0])  # ten pixels right of the center: the circle
    assert_array_equal(drawn[10, 20], [255, 255, 255])  # the outline
    assert_array_equal(visualize_detection(picture, None), picture)
    with pytest.raises(ValueError, match="mask: expected the picture's size"):
        visualize_detection(picture, None, mask[:-1])
