"""The answers of the concept questions on following a ball, computed."""

from __future__ import annotations

import numpy as np
import pytest

import labutils as lab
from solutions._ball_cases import cast_ball
from tests.helpers.quiz import ITEMS, get_numbers
from tests.helpers.tolerances import EXACT

K = np.array([[500.0, 0, 319.5], [0, 500.0, 239.5], [0, 0, 1]])
LIMITS = ((-1.4, 1.4), (-0.7, 1.0))
RADIUS = 0.045
#: The time constant of the servo of the neck, and the time between two commands, in seconds.
SERVO_S, STEP_S = 0.05, 0.05


def find_points(center: np.ndarray) -> np.ndarray:
    """The points of a ball that a camera sees, (N, 3)."""
    depth = cast_ball(center, RADIUS, K, (480, 640))
    v, u = np.nonzero(np.isfinite(depth))
    return lab.pixels_to_points(np.column_stack([u, v]), depth[v, u], K)


def test_a_pixel_far_out_becomes_a_smaller_angle() -> None:
    right, tilt = lab.command_from_pixel((569.5, 239.5), K, 0.2, 0.3, LIMITS)
    assert tilt == 0.3
    turn = np.arctan(0.5)
    answers = [right, 0.2 + turn, 0.2 - 0.5, 0.2 - np.degrees(turn)]
    np.testing.assert_allclose(get_numbers(ITEMS["7a"]), answers, atol=0.005)
    assert "250 px" in ITEMS["7a"].question


def test_behind_the_smallest_depth_the_center_lies_along_the_axis() -> None:
    center = np.array([0.5, 0.3, 1.0])
    points = find_points(center)
    foremost = points[points[:, 2].argmin()]
    along_the_axis = foremost + np.array([0, 0, RADIUS])
    along_the_ray = foremost * (1 + RADIUS / np.linalg.norm(foremost))
    px = center[2] / K[0, 0]
    assert np.linalg.norm(along_the_axis - center) < 2 * px
    assert np.linalg.norm(along_the_ray - center) > RADIUS / 3
    assert ITEMS["7b"].right_text == "Add the radius to z; x and y stay."


def test_a_hole_in_the_depth_is_no_reason_to_lose_the_ball() -> None:
    center = np.array([0.1, 0.05, 1.0])
    z = find_points(center)[:, 2]
    assert z.min() + RADIUS == pytest.approx(center[2], abs=1e-3)
    assert z.mean() + RADIUS > center[2] + 0.01
    assert ITEMS["7b2"].right_text == "At the smallest valid depth of the mask, plus the radius"


def test_an_angle_of_an_old_picture_belongs_to_the_old_pose() -> None:
    seen_pan, late, speed = 0.2, 0.1, 0.5
    middle = K[:2, 2]
    now = seen_pan + speed * late
    right, _ = lab.command_from_pixel(middle, K, seen_pan, 0.0, LIMITS)
    stale, _ = lab.command_from_pixel(middle, K, now, 0.0, LIMITS)
    assert right == pytest.approx(seen_pan, abs=EXACT)
    assert f"By {abs(stale - right):.2f} rad" == ITEMS["7c"].right_text
    assert f"{late} s late" in ITEMS["7c"].question


def test_a_loop_without_prediction_lags_and_stays_behind() -> None:
    speed, delay = 0.3, 2
    pan, ball, errors = 0.0, [0.0], []
    for _ in range(200):
        target = ball[max(len(ball) - 1 - delay, 0)]
        pan += (target - pan) * (1 - np.exp(-STEP_S / SERVO_S))
        ball.append(ball[-1] + speed * STEP_S)
        errors.append(ball[-1] - pan)
    lag_s = errors[-1] / speed
    assert np.ptp(errors[100:]) < 1e-6
    assert delay * STEP_S < lag_s < (delay + 2) * STEP_S + SERVO_S
    assert ITEMS["7c2"].right_text == "A constant lag remains."
