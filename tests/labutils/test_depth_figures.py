"""Several depth images in one figure: one scale, nothing invented where there is nothing."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from labutils.depth_figures import plot_depths
from labutils.figures import Picture


def decode(picture: Picture) -> np.ndarray:
    """Read a picture back: BGRA."""
    image = cv2.imdecode(np.frombuffer(picture.png, np.uint8), cv2.IMREAD_UNCHANGED)
    assert image is not None
    return image


def test_equal_depths_have_the_same_color_in_every_picture() -> None:
    near, far = np.full((30, 40), 1.0), np.full((30, 40), 3.0)
    near[:, 20:] = 3.0
    image = decode(plot_depths({"both": near, "far": far}, limits=(1, 3)))
    height, width = image.shape[:2]
    row = image[height // 3]
    first = row[width // 8], row[3 * width // 8]
    second = row[5 * width // 8], row[7 * width // 8]
    assert (first[1] == second[0]).all()
    assert (second[0] == second[1]).all()
    assert first[0][0] > first[0][2], "expected blue where it is close"
    assert first[1][2] > first[1][0], "expected red where it is far"


@pytest.mark.parametrize("nothing", [np.nan, np.inf])
def test_what_is_not_finite_stays_empty(nothing: float) -> None:
    depth = np.full((30, 40), 2.0)
    depth[:, :20] = nothing
    image = decode(plot_depths({"half": depth}, limits=(1, 3)))
    height, width = image.shape[:2]
    assert image[height // 3, width // 4, 3] == 0
    assert image[height // 3, 3 * width // 4, 3] == 255


def test_a_figure_without_pictures_is_refused() -> None:
    with pytest.raises(ValueError, match="depths: expected at least one depth image, got none"):
        plot_depths({}, limits=(1, 3))


def test_a_picture_of_another_shape_is_named() -> None:
    with pytest.raises(ValueError, match=r"depths\['colors'\]: expected"):
        plot_depths({"colors": np.zeros((3, 4, 3))}, limits=(1, 3))
