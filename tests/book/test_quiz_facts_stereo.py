"""The answers of the concept questions on stereo, computed; `check` in the data names one."""

from __future__ import annotations

import numpy as np
import pytest

from labutils.stereo import find_linear_depth_error
from labutils.stereo_matching import lr_check, ssd_disparity, subpixel
from tests.helpers.quiz import ITEMS, get_numbers


def test_what_is_too_near_for_the_search() -> None:
    right = np.random.default_rng(6).integers(0, 256, (9, 200), dtype=np.uint8)
    for depth, found in ((1.3, False), (1.5, True), (9.0, True)):
        true = round(43 / depth)
        disparity = ssd_disparity(np.roll(right, true, axis=1), right, 32, 9)
        assert (disparity[4, 60:-4] == true).all() == found
    assert ITEMS["8a"].right_text == f"Those nearer than about {43 / 31:.1f} m"
    # The first columns get answers all the same.
    assert np.isfinite(disparity[4, 4:31]).all()


def test_the_parabola_leans_to_the_cheaper_side() -> None:
    cost = np.full((9, 1, 1), 99.0)
    cost[6:9, 0, 0] = [30, 10, 20]
    assert "at 6, 7 and 8 px are 30, 10 and 20" in ITEMS["8b"].question
    (found,) = subpixel(cost, np.array([[7.0]]))[0]
    assert found == pytest.approx(7 + 1 / 6)
    assert ITEMS["8b"].right_text == "A little above 7 px"


def test_a_hidden_point_does_not_come_back() -> None:
    left, right = np.full((2, 1, 130), np.nan)
    left[0, 100], right[0, 80] = 20, 35
    assert not lr_check(left, right).any()
    assert ITEMS["8b2"].right_text == "It rejects the match"


def test_three_times_as_far_is_nine_times_the_error() -> None:
    K = np.diag([433.0, 433, 1])
    near, far = 1000 * find_linear_depth_error([1.0, 3.0], 0.25, K, 0.1)
    assert near == pytest.approx(6, abs=0.5)
    assert get_numbers(ITEMS["8c"]) == [6 * round(far / near), 6, 18]
