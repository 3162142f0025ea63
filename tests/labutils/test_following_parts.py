"""What the loop of the chapter on following is made of: path, commands, scene, record."""

from __future__ import annotations

from typing import Any

import mujoco
import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from labutils import command_from_pixel, get_camera_pose
from labutils.following import BallPath, FollowingRecord
from labutils.following.record import FollowingMoment
from labutils.following.scene import (
    BALL,
    BOARD,
    CAMERA,
    PARKED,
    get_mocap_id,
    hide_ball,
    make_following_scene,
    park_board,
)
from tests.helpers.tolerances import EXACT

WIDE = ((-1.4, 1.4), (-0.7, 1.0))


# --- the path


def test_another_seed_is_another_path_and_the_same_seed_the_same() -> None:
    here, again, there = (BallPath(seed).get_position(0.3) for seed in (1, 1, 2))
    assert_array_equal(here, again)
    assert np.linalg.norm(here - there) > 0.01


@pytest.mark.parametrize("seed", range(5))
def test_a_path_is_closed_and_traversed_by_its_length(seed: int) -> None:
    path = BallPath(seed)
    assert_allclose(path.get_position(path.length), path.get_position(0.0), atol=1e-9)
    places = np.array([path.get_position(meters) for meters in np.arange(0, path.length, 0.005)])
    steps = np.linalg.norm(np.diff(places, axis=0), axis=1)
    # a chord is shorter than its arc, by little where steps are small
    assert np.all(steps <= 0.005 + EXACT)
    assert steps.mean() == pytest.approx(0.005, rel=0.01)


@pytest.mark.parametrize("seed", range(5))
def test_the_ball_stays_above_the_table_and_in_reach_of_the_head(seed: int) -> None:
    path = BallPath(seed)
    places = np.array([path.get_position(meters) for meters in np.linspace(0, path.length, 200)])
    assert np.all(np.abs(places - (1.0, 0.0, 1.17)) <= (0.14, 0.38, 0.13))


# --- from a pixel to a command


def test_a_pixel_to_the_right_needs_less_pan_and_one_below_more_tilt(K: np.ndarray) -> None:
    # K of the fixture has fx != fy and cx != cy: with one exchanged the angles would be others
    pan, tilt = command_from_pixel((K[0, 2] + 21, K[1, 2]), K, 0.0, 0.0, WIDE)
    assert (pan, tilt) == pytest.approx((-np.arctan(0.1), 0.0))  # 21 / 210
    pan, tilt = command_from_pixel((K[0, 2], K[1, 2] + 18), K, 0.0, 0.0, WIDE)
    assert (pan, tilt) == pytest.approx((0.0, np.arctan(0.1)))  # 18 / 180


def test_the_pose_of_the_neck_is_added_and_limits_cut_off(K: np.ndarray) -> None:
    middle = K[:2, 2]
    assert command_from_pixel(middle, K, 0.3, -0.2, WIDE) == pytest.approx((0.3, -0.2))
    assert command_from_pixel(middle, K, 2.0, -2.0, WIDE) == (1.4, -0.7)


def test_a_command_brings_a_direction_to_the_middle_of_an_eye_on_the_axes() -> None:
    # for one axis at a time the angles are exact; the neck is Ry(tilt) after Rz(pan)
    K = np.array([[500.0, 0, 320], [0, 480.0, 240], [0, 0, 1]])
    for pixel in ((100.0, 240.0), (320.0, 400.0)):
        pan, tilt = command_from_pixel(pixel, K, 0.0, 0.0, WIDE)
        forward = [np.cos(tilt) * np.cos(pan), np.cos(tilt) * np.sin(pan), -np.sin(tilt)]
        ray = [1.0, -(pixel[0] - 320) / 500, -(pixel[1] - 240) / 480]  # forward, left, up
        assert_allclose(np.cross(forward, ray), 0, atol=EXACT)


@pytest.mark.parametrize("pixel", [(1.0,), (1.0, np.nan), ((1.0, 2.0),)])
def test_what_is_no_pixel_is_refused(K: np.ndarray, pixel: Any) -> None:
    with pytest.raises(ValueError, match=r"pixel: expected finite numbers of shape \(2,\), got"):
        command_from_pixel(pixel, K, 0.0, 0.0, WIDE)


def test_limits_come_in_pairs(K: np.ndarray) -> None:
    with pytest.raises(ValueError, match=r"limits: expected finite numbers of shape \(2, 2\)"):
        command_from_pixel((1.0, 2.0), K, 0.0, 0.0, (-1.4, 1.4))


# --- the scene and its board


@pytest.mark.parametrize("place", [(1.0, 0.0, 1.17), (1.1, 0.35, 1.05), (0.9, -0.35, 1.3)])
def test_the_board_hides_the_whole_ball_and_goes_away_again(place: tuple[float, ...]) -> None:
    model, data = make_following_scene()
    data.mocap_pos[get_mocap_id(model, BALL)] = place
    mujoco.mj_forward(model, data)
    free = count_pixels(model, data, BALL)
    hide_ball(model, data)
    mujoco.mj_forward(model, data)
    assert free > 20
    assert count_pixels(model, data, BALL) == 0
    assert count_pixels(model, data, BOARD) > free
    park_board(model, data)
    mujoco.mj_forward(model, data)
    assert count_pixels(model, data, BALL) == free
    assert_array_equal(data.mocap_pos[get_mocap_id(model, BOARD)], PARKED)


def count_pixels(model: mujoco.MjModel, data: mujoco.MjData, body: str) -> int:
    """Count the rays of the head camera that meet a body first."""
    eye = get_camera_pose(model, data, CAMERA)
    place = data.body(body).xpos
    ray = np.linalg.inv(eye) @ [*place, 1.0]
    grid = np.linspace(-0.045, 0.045, 9)
    count, geom = 0, np.zeros(1, np.int32)
    for right in grid:
        for down in grid:
            toward = eye[:3, :3] @ (ray[:3] + np.array([right, down, 0.0]))
            static = True
            mujoco.mj_ray(model, data, eye[:3, 3], toward, None, static, -1, geom)
            count += int(geom[0] >= 0 and model.geom_bodyid[geom[0]] == model.body(body).id)
    return count


# --- the record


def make_record(errors_px: list[float], hidden: list[int], width: int = 640) -> FollowingRecord:
    """Make a record with a ball so far right of the middle, and hidden at some commands."""
    K = np.array([[500.0, 0, (width - 1) / 2], [0, 500.0, 239.5], [0, 0, 1]])
    moments = [
        FollowingMoment(
            time=0.05 * place,
            ball=np.array([1.0, 0.01 * place, 1.0]),
            pan=0.0,
            tilt=0.0,
            command=np.array([0.1, -0.4]),
            pixel=K[:2, 2] + (error, 0.0),
            is_hidden=place in hidden,
            seen_time=0.05 * max(place - 1, 0),
            center=np.array([1.0, 0.01 * max(place - 1, 0), 1.003]),
        )
        for place, error in enumerate(errors_px)
    ]
    return FollowingRecord.from_moments(moments, K)


def test_the_first_second_does_not_count() -> None:
    record = make_record([100.0] * 20 + [4.0] * 20, [])
    score = record.get_score()
    assert score.mean_px == pytest.approx(4.0)
    assert score.command_rad == pytest.approx(0.4)
    assert np.isnan(score.recovery_s)


def test_a_center_is_compared_with_where_the_ball_was_in_the_picture() -> None:
    assert make_record([0.0] * 40, []).get_score().center_mm == pytest.approx(3.0)


def test_a_hidden_ball_does_not_count_and_the_time_to_find_it_is_told() -> None:
    errors = [0.0] * 20 + [90.0] * 10 + [50.0] * 4 + [10.0] * 30
    record = make_record(errors, list(range(20, 30)))
    score = record.get_score()
    assert score.mean_px == pytest.approx(10.0)
    assert score.recovery_s == pytest.approx(4 * 0.05)


def test_a_ball_that_is_not_found_again_is_never_near() -> None:
    record = make_record([0.0] * 20 + [90.0] * 30, list(range(20, 30)))
    assert record.get_score().recovery_s == np.inf


def test_near_is_the_same_angle_in_a_small_picture() -> None:
    assert make_record([0.0], []).near_px == pytest.approx(15.0)
    assert make_record([0.0], [], width=160).near_px == pytest.approx(3.75)


def test_an_empty_record_has_a_score_of_nothing() -> None:
    score = FollowingRecord.from_moments([], np.eye(3)).get_score()
    assert all(np.isnan(value) for value in score)
