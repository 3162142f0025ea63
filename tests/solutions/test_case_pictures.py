"""Pictures of the cases are the same on every machine."""

from __future__ import annotations

import colorsys

import numpy as np

from solutions._cases import hsv_to_rgb


def test_colors_are_those_of_the_definition_rounded_to_whole_numbers() -> None:
    levels = (0, 1, 40, 127, 128, 200, 254, 255)
    hsv = np.array([[h, s, v] for h in range(180) for s in levels for v in levels], np.uint8)
    true = [255 * np.array(colorsys.hsv_to_rgb(h / 180, s / 255, v / 255)) for h, s, v in hsv]
    found = hsv_to_rgb(hsv[None])[0]
    assert found.dtype == np.uint8
    # half a step, and the rounding of the floats of the definition
    assert np.abs(found - np.array(true)).max() <= 0.5 + 1e-9


def test_a_color_is_the_same_wherever_in_a_row_it_stands() -> None:
    rng = np.random.default_rng(3)
    colors = rng.integers((0, 150, 130), (180, 250, 240), (61, 3)).astype(np.uint8)
    one_by_one = [hsv_to_rgb(color[None, None])[0, 0] for color in colors]
    # The rival, cv2.cvtColor with COLOR_HSV2RGB, differs by one in 21 of these 61.
    np.testing.assert_array_equal(hsv_to_rgb(colors[None])[0], one_by_one)
