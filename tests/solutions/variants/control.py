"""Right controllers of many styles: gains, filters, predictions, what they look at and return."""

# ruff: noqa: ARG001 - a controller is handed more than each of them looks at

from __future__ import annotations

from typing import Any

import cv2
import numpy as np

from labutils.following import command_from_pixel

LOW, HIGH = (0, 120, 50), (7, 255, 255)
DELAY_S = 0.08


def find_ball(rgb: np.ndarray) -> tuple[float, float] | None:
    """Find the middle of all pixels of the ball's color."""
    mask = cv2.inRange(cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV), LOW, HIGH)
    moments = cv2.moments(mask, binaryImage=True)
    if moments["m00"] < 8:
        return None
    return moments["m10"] / moments["m00"], moments["m01"] / moments["m00"]


def get_aim(rgb: np.ndarray, K: np.ndarray, state: Any) -> np.ndarray | None:
    """Return the angles at which the ball was seen, without limits."""
    pixel = find_ball(rgb)
    if pixel is None:
        return None
    u, v = pixel
    return np.array(
        [
            state.seen_pan - np.arctan((u - K[0, 2]) / K[0, 0]),
            state.seen_tilt + np.arctan((v - K[1, 2]) / K[1, 1]),
        ]
    )


def cut(angles: Any, state: Any) -> tuple[float, float]:
    low, high = np.array(state.limits).T
    pan, tilt = np.clip(angles, low, high)
    return float(pan), float(tilt)


def proportional(rgb: Any, depth: Any, K: Any, state: Any) -> Any:
    pixel = find_ball(rgb)
    if pixel is not None:
        state.memory["command"] = command_from_pixel(
            pixel, K, state.seen_pan, state.seen_tilt, state.limits
        )
    return state.memory.get("command", (state.pan, state.tilt))


def low_gain_from_the_pose_of_now(rgb: Any, depth: Any, K: Any, state: Any) -> Any:
    aim = get_aim(rgb, K, state)
    now = np.array([state.pan, state.tilt])
    return cut(now if aim is None else now + 0.8 * (aim - now), state)


def smoothed_command(rgb: Any, depth: Any, K: Any, state: Any) -> Any:
    aim = get_aim(rgb, K, state)
    last = np.array(state.memory.get("last", (state.pan, state.tilt)))
    if aim is not None:
        last = np.array(cut(last + 0.75 * (aim - last), state))
    state.memory["last"] = last
    return cut(last, state)


def with_integral_and_clamp(rgb: Any, depth: Any, K: Any, state: Any) -> Any:
    aim = get_aim(rgb, K, state)
    total = state.memory.setdefault("total", np.zeros(2))
    if aim is None:
        return cut(state.memory.get("last", (state.pan, state.tilt)), state)
    error = aim - (state.seen_pan, state.seen_tilt)
    total += np.where(np.abs(aim + total) < 5, 1.5 * error * state.dt, 0.0)
    total[:] = np.clip(total, -0.1, 0.1)
    state.memory["last"] = aim + total
    return cut(aim + total, state)


def feed_forward(rgb: Any, depth: Any, K: Any, state: Any) -> Any:
    """Add to the angle what the ball turns by until the neck is there."""
    aim, memory = get_aim(rgb, K, state), state.memory
    if aim is None:
        return cut(memory.get("aim", (state.pan, state.tilt)), state)
    passed = state.seen_time - memory.get("time", state.seen_time)
    rate = (aim - memory["aim"]) / passed if passed > 0 else np.zeros(2)
    memory["rate"] = 0.6 * memory.get("rate", np.zeros(2)) + 0.4 * np.clip(rate, -1, 1)
    memory["aim"], memory["time"] = aim, state.seen_time
    return cut(aim + memory["rate"] * (state.time - state.seen_time + DELAY_S), state)


def alpha_beta_filter(rgb: Any, depth: Any, K: Any, state: Any) -> Any:
    aim, memory = get_aim(rgb, K, state), state.memory
    if "x" not in memory:
        if aim is None:
            return cut((state.pan, state.tilt), state)
        memory.update(x=aim, v=np.zeros(2), t=state.seen_time)
    step = state.seen_time - memory["t"]
    if step > 0:
        memory["x"] = memory["x"] + memory["v"] * step
        memory["t"] = state.seen_time
        if aim is not None:
            off = aim - memory["x"]
            memory["x"] = memory["x"] + 0.6 * off
            memory["v"] = memory["v"] + 0.2 * off / step
        else:
            memory["v"] = 0.8 * memory["v"]
    return cut(memory["x"] + memory["v"] * (state.time - memory["t"] + DELAY_S), state)


def kalman_filter(rgb: Any, depth: Any, K: Any, state: Any) -> Any:
    """Estimate angles and rates together, with their covariance."""
    aim, memory = get_aim(rgb, K, state), state.memory
    if "mean" not in memory:
        if aim is None:
            return cut((state.pan, state.tilt), state)
        memory["mean"] = np.concatenate([aim, np.zeros(2)])
        memory["cov"] = np.diag([1e-4, 1e-4, 0.1, 0.1])
        memory["at"] = state.seen_time
    step = state.seen_time - memory["at"]
    F = np.eye(4)
    F[:2, 2:] = step * np.eye(2)
    mean = F @ memory["mean"]
    cov = F @ memory["cov"] @ F.T + np.diag([1e-7, 1e-7, 2.0 * step**2, 2.0 * step**2])
    if aim is not None and step > 0:
        H = np.eye(2, 4)
        gain = cov @ H.T @ np.linalg.inv(H @ cov @ H.T + 1e-5 * np.eye(2))
        mean, cov = mean + gain @ (aim - H @ mean), (np.eye(4) - gain @ H) @ cov
    if aim is None:
        mean[2:] *= 0.8
    memory.update(mean=mean, cov=cov, at=state.seen_time)
    return cut(mean[:2] + mean[2:] * (state.time - state.seen_time + DELAY_S), state)


def velocity_in_the_picture(rgb: Any, depth: Any, K: Any, state: Any) -> Any:
    """Shift the pixel by its velocity, less what the turning of the head explains."""
    pixel, memory = find_ball(rgb), state.memory
    if pixel is None:
        memory.pop("pixel", None)
        return memory.get("command", (state.pan, state.tilt))
    here = np.array(pixel)
    pose = np.array([state.seen_pan, -state.seen_tilt]) * K[0, 0]
    lead = np.zeros(2)
    if "pixel" in memory and state.seen_time > memory["time"]:
        moved = here - memory["pixel"] - (pose - memory["pose"])
        rate = moved / (state.seen_time - memory["time"])
        memory["flow"] = 0.5 * memory.get("flow", np.zeros(2)) + 0.5 * rate
        lead = memory["flow"] * (state.time - state.seen_time + 0.05)
    memory.update(pixel=here, pose=pose, time=state.seen_time)
    memory["command"] = command_from_pixel(
        here + np.clip(lead, -15, 15), K, state.seen_pan, state.seen_tilt, state.limits
    )
    return memory["command"]


def velocity_in_the_world(rgb: Any, depth: Any, K: Any, state: Any) -> Any:
    """Locate the ball with its depth, or at the last distance, and lead it in meters."""
    pixel, memory = find_ball(rgb), state.memory
    if pixel is not None:
        u, v = int(pixel[0]), int(pixel[1])
        near = depth[max(v - 2, 0) : v + 3, max(u - 2, 0) : u + 3]
        near = near[near > 0.1]
        away = float(np.median(near)) + 0.045 if near.size else memory.get("away", 0.9)
        ray = np.linalg.inv(K) @ [*pixel, 1.0]
        place = (state.T_world_cam @ [*(away * ray), 1.0])[:3]
        passed = state.seen_time - memory.get("time", -1.0)
        if "place" in memory and 0 < passed < 0.3 and near.size:
            rate = np.clip((place - memory["place"]) / passed, -1, 1)
            memory["velocity"] = 0.7 * memory["velocity"] + 0.3 * rate
        elif passed > 0:
            memory["velocity"] = np.zeros(3)
        memory.update(place=place, time=state.seen_time, away=away)
    if "place" not in memory:
        return cut((state.pan, state.tilt), state)
    ahead = min(state.time - memory["time"] + DELAY_S, 0.3)
    x, y, z, _ = np.linalg.inv(state.T_world_cam) @ [
        *(memory["place"] + ahead * memory["velocity"]),
        1.0,
    ]
    return cut((state.seen_pan - np.arctan2(x, z), state.seen_tilt + np.arctan2(y, z)), state)


def largest_contour(rgb: Any, depth: Any, K: Any, state: Any) -> Any:
    mask = cv2.inRange(cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV), LOW, HIGH)
    contours, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    if contours:
        (u, v), _ = cv2.minEnclosingCircle(max(contours, key=cv2.contourArea))
        state.memory["command"] = command_from_pixel(
            (u, v), K, state.seen_pan, state.seen_tilt, state.limits
        )
    return state.memory.get("command", (state.pan, state.tilt))


def connected_in_single_precision(rgb: Any, depth: Any, K: Any, state: Any) -> Any:
    mask = cv2.inRange(cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV), LOW, HIGH)
    count, _, stats, middles = cv2.connectedComponentsWithStats(mask)
    if count > 1:
        u, v = middles[1 + int(np.argmax(stats[1:, cv2.CC_STAT_AREA]))].astype(np.float32)
        focal = np.float32(K[0, 0])
        turn = np.arctan(np.array([K[0, 2] - u, v - K[1, 2]], np.float32) / focal)
        low, high = np.array(state.limits, np.float32).T
        aim = turn + np.array([state.seen_pan, state.seen_tilt], np.float32)
        state.memory["last"] = np.clip(aim, low, high)
    return state.memory.get("last", np.array([state.pan, state.tilt], np.float32))


def by_ratio_of_colors_in_a_list(rgb: Any, depth: Any, K: Any, state: Any) -> Any:
    """Ask of NumPy alone what is red: more green than blue, as the box has not."""
    red, green, blue = (rgb[..., channel].astype(int) for channel in range(3))
    rows, columns = np.nonzero((red > 90) & (red > 3 * green) & (red > 3 * blue) & (green > blue))
    if len(rows) < 8:
        return [min(max(state.pan, -1.4), 1.4), min(max(state.tilt, -0.7), 1.0)]
    right = np.arctan((np.median(columns) - K[0, 2]) / K[0, 0])
    down = np.arctan((np.median(rows) - K[1, 2]) / K[1, 1])
    (low, high), (top, bottom) = state.limits
    return [
        min(max(state.seen_pan - right, low), high),
        min(max(state.seen_tilt + down, top), bottom),
    ]


def searching_while_hidden(rgb: Any, depth: Any, K: Any, state: Any) -> Any:
    """Swing from side to side about the last aim until the ball is seen again."""
    aim, memory = get_aim(rgb, K, state), state.memory
    if aim is not None:
        memory["aim"], memory["lost"] = aim, None
        return cut(aim, state)
    if memory.get("lost") is None:
        memory["lost"] = state.time
    swing = 0.05 * np.sin(6 * (state.time - memory["lost"]))
    return cut(np.add(memory.get("aim", (state.pan, state.tilt)), (swing, 0.0)), state)


def pd_with_a_dead_band(rgb: Any, depth: Any, K: Any, state: Any) -> Any:
    """Leave the head alone for a pixel; damp by the change of the error."""
    aim, memory = get_aim(rgb, K, state), state.memory
    if aim is None:
        return cut(memory.get("last", (state.pan, state.tilt)), state)
    error = aim - (state.seen_pan, state.seen_tilt)
    error = np.where(np.abs(error) * K[0, 0] < 0.5, 0.0, error)
    change = error - memory.get("error", error)
    memory["error"] = error
    memory["last"] = np.array([state.seen_pan, state.seen_tilt]) + error - 0.1 * change
    return cut(memory["last"], state)


def make_with_own_memory() -> Any:
    """Make a controller that keeps what it remembers in a closure."""
    last: list[float] = []

    def with_own_memory(rgb: Any, depth: Any, K: Any, state: Any) -> Any:
        aim = get_aim(rgb, K, state)
        if aim is not None:
            last[:] = cut(aim, state)
        return tuple(last) or (state.pan, state.tilt)

    return with_own_memory


def limited_in_its_rate(rgb: Any, depth: Any, K: Any, state: Any) -> Any:
    """Turn by a quarter of a radian per call at most."""
    aim = get_aim(rgb, K, state)
    now = np.array([state.pan, state.tilt])
    goal = state.memory["goal"] = state.memory.get("goal", now) if aim is None else aim
    return cut(now + np.clip(goal - now, -0.25, 0.25), state)


def careful_sum(rgb: Any, depth: Any, K: Any, state: Any) -> Any:
    """Add up parts of the error, and keep the sum within the limits."""
    aim = get_aim(rgb, K, state)
    total = state.memory.setdefault("sum", np.array([state.pan, state.tilt]))
    if aim is not None:
        total += 0.35 * (aim - (state.seen_pan, state.seen_tilt))
        total[:] = cut(total, state)
    return cut(total, state)


VARIANTS = (
    proportional,
    low_gain_from_the_pose_of_now,
    smoothed_command,
    with_integral_and_clamp,
    feed_forward,
    alpha_beta_filter,
    kalman_filter,
    velocity_in_the_picture,
    velocity_in_the_world,
    largest_contour,
    connected_in_single_precision,
    by_ratio_of_colors_in_a_list,
    searching_while_hidden,
    pd_with_a_dead_band,
    make_with_own_memory(),
    limited_in_its_rate,
    careful_sum,
)
