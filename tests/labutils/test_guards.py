"""Guards that no public function of its own tests: what they return, what they say."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from labutils._guards import check_hsv_range, check_pixel, check_positive


@pytest.mark.parametrize("pixel", [(3, 4), [3, 4], np.array([3, 4]), (np.int8(3), np.uint16(4))])
def test_a_pixel_comes_back_as_two_ints(pixel: Any) -> None:
    checked = check_pixel("pixel", pixel, 4, 5)
    assert checked == (3, 4)
    assert [type(one) for one in checked] == [int, int]


@pytest.mark.parametrize(
    ("pixel", "error", "words"),
    [
        ((4, 0), ValueError, r"^seed: expected \(u, v\) within 4 x 5 pixels, got tuple \(4, 0\)$"),
        ((0, 5), ValueError, r"within 4 x 5 pixels, got tuple \(0, 5\)"),
        ((-1, 0), ValueError, "within 4 x 5"),
        ((), ValueError, "within 4 x 5"),
        ((1, 2, 3), ValueError, "within 4 x 5"),
        (
            (1.0, 2),
            TypeError,
            r"^seed: expected \(u, v\), two whole numbers, got tuple \(1.0, 2\)$",
        ),
        ((True, 2), TypeError, "two whole numbers"),
        ("12", TypeError, "two whole numbers, got str '12'"),
        (None, TypeError, "two whole numbers, got NoneType None"),
    ],
)
def test_what_is_no_pixel_of_the_picture_is_refused(
    pixel: Any, error: type[Exception], words: str
) -> None:
    with pytest.raises(error, match=words):
        check_pixel("seed", pixel, 4, 5)


def test_an_hsv_range_comes_back_as_two_arrays_and_is_named_when_it_is_none() -> None:
    low, high = check_hsv_range("limits", ((170, 1, 2), (6, 3, 4)))
    assert (low.tolist(), high.tolist()) == ([170, 1, 2], [6, 3, 4])
    with pytest.raises(ValueError, match=r"^limits: expected 0 to \(179, 255, 255\)"):
        check_hsv_range("limits", ((0, 0, 0), (0, 0, 256)))


@pytest.mark.parametrize(
    ("value", "error", "words"),
    [
        (0, ValueError, "^baseline: expected meters above 0, got 0$"),
        (-0.1, ValueError, "got -0.1"),
        (float("inf"), ValueError, "got inf"),
        (float("nan"), ValueError, "got nan"),
        ("1", TypeError, "^baseline: expected meters as a number, got str '1'$"),
        (True, TypeError, "got bool True"),
    ],
)
def test_a_length_that_is_none_is_refused(value: Any, error: type[Exception], words: str) -> None:
    with pytest.raises(error, match=words):
        check_positive("baseline", value, "meters")
    assert check_positive("baseline", np.float32(0.5), "meters") == 0.5
