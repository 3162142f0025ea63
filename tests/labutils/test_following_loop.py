"""The loop that a controller is put into: what it is told, what it may answer, what is true."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from labutils import make_renderer, segment_by_color
from labutils.following import FollowingLoop, FollowingState, command_from_pixel
from labutils.following.loop import DT

SMALL = (80, 60)


def stay(_rgb: np.ndarray, _depth: np.ndarray, _K: np.ndarray, state: FollowingState) -> Any:
    """Hold the neck where it is."""
    return state.pan, state.tilt


class Listener:
    """A controller that keeps what it is told."""

    def __init__(self, answer: Any = None) -> None:
        self.answer = answer
        self.states: list[FollowingState] = []
        self.pictures: list[tuple[np.ndarray, np.ndarray]] = []

    def __call__(self, rgb: Any, depth: Any, _K: Any, state: FollowingState) -> Any:
        self.states.append(state)
        self.pictures.append((rgb, depth))
        return (state.pan, state.tilt) if self.answer is None else self.answer


def run(control: Any, seconds: float, **settings: Any) -> Any:
    """Run a small loop, and return its record."""
    with FollowingLoop(*SMALL, **settings) as loop:
        return loop.run(control, seconds)


def test_the_same_seed_gives_the_same_pictures_and_another_seed_others() -> None:
    listeners = [Listener(), Listener(), Listener()]
    for listener, seed in zip(listeners, (3, 3, 4), strict=True):
        run(listener, 0.2, seed=seed)
    first, again, other = (listener.pictures for listener in listeners)
    for (rgb, depth), (rgb_again, depth_again) in zip(first, again, strict=True):
        assert_array_equal(rgb, rgb_again)
        assert_array_equal(depth, depth_again)
    assert np.any(first[-1][0] != other[-1][0])


def test_a_picture_arrives_late_with_the_pose_in_which_it_was_taken() -> None:
    listener = Listener(answer=(0.4, 0.3))
    record = run(listener, 0.3, delay=2)
    last = listener.states[-1]
    assert last.time - last.seen_time == pytest.approx(2 * DT)
    assert_allclose((last.seen_pan, last.seen_tilt), record.neck[-3])
    assert_allclose((last.pan, last.tilt), record.neck[-1])
    assert np.abs(record.neck[-1] - record.neck[-3]).max() > 0.001  # or nothing was compared


def test_before_the_first_late_picture_the_first_one_is_shown_again() -> None:
    listener = Listener()
    run(listener, 0.2, delay=2)
    assert [state.seen_time for state in listener.states] == pytest.approx([0, 0, 0, DT])


def test_the_ball_flies_at_the_speed_that_was_asked_for() -> None:
    record = run(stay, 1.0, speed=0.2)
    speeds = np.linalg.norm(np.diff(record.ball, axis=0), axis=1) / DT
    assert speeds.mean() == pytest.approx(0.2, rel=0.02)


def test_the_board_hides_the_ball_when_it_should_and_no_longer() -> None:
    listener = Listener()
    with FollowingLoop(160, 120, delay=0, speed=0.0, hidden=[(0.1, 0.2)]) as loop:
        record = loop.run(listener, 0.35)
    red = [
        segment_by_color(rgb, ((0, 120, 50), (7, 255, 255))).any() for rgb, _ in listener.pictures
    ]
    assert_array_equal(record.is_hidden, [False, False, True, True, False, False, False])
    assert red == [not hidden for hidden in record.is_hidden]


def test_the_true_pixel_is_where_the_ball_is_seen() -> None:
    listener = Listener()
    with FollowingLoop(320, 240, delay=0, noise=0.0) as loop:
        record = loop.run(listener, 0.15)
    for (rgb, _), pixel in zip(listener.pictures, record.pixel, strict=True):
        rows, columns = np.nonzero(segment_by_color(rgb, ((0, 120, 50), (7, 255, 255))))
        assert_allclose((columns.mean(), rows.mean()), pixel, atol=0.7)


def test_noise_spreads_color_and_depth_as_told() -> None:
    clean, noisy = Listener(), Listener()
    run(clean, 0.05, noise=0.0)
    run(noisy, 0.05, noise=4.0)
    (rgb, depth), (rgb_noisy, depth_noisy) = clean.pictures[0], noisy.pictures[0]
    middle = (rgb > 30) & (rgb < 225)  # where nothing is cut off
    assert np.std(rgb_noisy[middle].astype(float) - rgb[middle]) == pytest.approx(4.0, rel=0.1)
    spread = np.std((depth_noisy - depth) / np.square(depth))
    assert spread == pytest.approx(0.0005 * 4.0, rel=0.1)


def test_a_controller_that_aims_at_the_picture_settles_on_a_ball_that_rests() -> None:
    def aim(rgb: np.ndarray, _depth: np.ndarray, K: np.ndarray, state: FollowingState) -> Any:
        rows, columns = np.nonzero(segment_by_color(rgb, ((0, 120, 50), (7, 255, 255))))
        pixel = (columns.mean(), rows.mean())
        return command_from_pixel(pixel, K, state.seen_pan, state.seen_tilt, state.limits)

    with FollowingLoop(160, 120, speed=0.0, delay=2, hidden=()) as loop:
        record = loop.run(aim, 1.5)
    assert record.error_px[0] > 3 * record.near_px
    assert record.get_score().mean_px < record.near_px


def test_memory_is_empty_at_the_start_and_kept_from_call_to_call() -> None:
    counts = []

    def count(_rgb: Any, _depth: Any, _K: Any, state: FollowingState) -> Any:
        counts.append(len(state.memory))
        state.memory[f"call {len(state.memory)}"] = True
        return state.pan, state.tilt

    run(count, 0.15)
    run(count, 0.1)
    assert counts == [0, 1, 2, 0, 1]


def test_what_a_controller_does_to_its_arguments_stays_its_own() -> None:
    def spoil(rgb: np.ndarray, depth: np.ndarray, K: np.ndarray, state: FollowingState) -> Any:
        for array in (rgb, depth, K, state.T_world_cam):
            array[...] = 0
        return state.pan, state.tilt

    spoiled, calm = run(spoil, 0.2, delay=2), run(stay, 0.2, delay=2)
    assert_array_equal(spoiled.pixel, calm.pixel)
    assert_array_equal(spoiled.K, calm.K)


def test_settings_may_change_while_it_runs() -> None:
    listener = Listener()
    with FollowingLoop(*SMALL, delay=3) as loop:
        loop.run(listener, 0.3)
        loop.delay, loop.gain, loop.speed = 0, 2.5, 0.0
        record = loop.run(listener, 0.1)
    last = listener.states[-1]
    assert (last.time, last.gain) == (last.seen_time, 2.5)
    assert_allclose(record.ball[-1], record.ball[-2])


@pytest.mark.parametrize("answer", ["left", ("a", "b"), {}])
def test_an_answer_that_is_no_numbers_is_refused(answer: Any) -> None:
    with (
        FollowingLoop(*SMALL) as loop,
        pytest.raises(TypeError, match=r"control: expected \(pan, tilt\), two finite numbers"),
    ):
        loop.step(lambda *_: answer)


@pytest.mark.parametrize("answer", [None, 0.1, (0.1,), (0.1, np.nan), (0.1, 0.2, 0.3)])
def test_an_answer_of_other_numbers_is_refused(answer: Any) -> None:
    with (
        FollowingLoop(*SMALL) as loop,
        pytest.raises(ValueError, match=r"control: expected \(pan, tilt\), two finite numbers"),
    ):
        loop.step(lambda *_: answer)


def test_a_size_that_is_none_is_refused() -> None:
    with pytest.raises(ValueError, match="width: expected at least 1 pixel, got 0"):
        FollowingLoop(0, 60)


def test_another_renderer_can_draw() -> None:
    made = []

    def make(model: Any, height: int, width: int) -> Any:
        made.append((height, width))
        return make_renderer(model, height, width)

    run(stay, 0.05, renderer_maker=make)
    assert made == [(60, 80)]
