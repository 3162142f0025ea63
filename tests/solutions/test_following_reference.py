"""The worked answer of `control` keeps the bounds of the book, over several paths of the ball."""

from __future__ import annotations

import pytest

from labutils import is_gl_available
from labutils.checks.loops.drawing import LoopRenderer
from labutils.following import FollowingLoop
from solutions.control import control
from tests.solutions.variants.control import proportional
from tools.measure.following_score import MAX_CENTER_MM, MAX_RECOVERY_S, is_within, measure


@pytest.mark.parametrize("seed", range(3))
def test_the_ball_is_followed_located_and_found_again_in_small_pictures(seed: int) -> None:
    with FollowingLoop(160, 120, seed=seed, renderer_maker=LoopRenderer) as loop:
        record = loop.run(control, 8.0)
    score = record.get_score()
    assert score.mean_px <= record.near_px
    assert score.center_mm <= MAX_CENTER_MM
    assert score.recovery_s <= MAX_RECOVERY_S


def test_turning_by_the_angle_of_each_picture_alone_is_not_enough_for_that() -> None:
    with FollowingLoop(160, 120, seed=0, renderer_maker=LoopRenderer) as loop:
        record = loop.run(proportional, 8.0)
    assert record.get_score().mean_px > record.near_px


@pytest.mark.slow
def test_the_bounds_hold_over_5_seeds_at_full_size() -> None:
    if not is_gl_available():
        pytest.skip("pictures of 640x480 by rays take minutes")
    for seed in range(5):
        score = measure(control, seed, 640)
        assert is_within(score, 640), (seed, score)
