"""Challenge of step 5: keep the part of a cloud that the robot can reach."""

from __future__ import annotations

from typing import Any

import numpy as np

from solutions._cases import make_rotation
from solutions._model import Case, Exercise, Misconception, Part, asked, given
from solutions._simpler import Simplification, stay_at_origin, stay_straight


def crop_region(
    points_world: np.ndarray, T_world_robot: np.ndarray, low: np.ndarray, high: np.ndarray
) -> np.ndarray:
    """Move a cloud into the frame of the robot and keep what lies in a box.

    Parameters
    ----------
    points_world : ndarray, float64, (N, 3)
        Points in the world, meters.
    T_world_robot : ndarray, float64, (4, 4)
        Pose of the robot: it maps points of the robot's frame into the world.
    low, high : ndarray, float64, (3,)
        Limits of the box in the robot's frame, (x, y, z), meters, limits included.

    Returns
    -------
    ndarray, float, (M, 3)
        The points in the box, in the robot's frame, in any order; M may be 0.
    """
    points = (points_world - T_world_robot[:3, 3]) @ T_world_robot[:3, :3]
    inside = ((points >= low) & (points <= high)).all(axis=1)
    return points[inside]


def _answer_with(
    mistakes: frozenset[str],
    points_world: np.ndarray,
    T_world_robot: np.ndarray,
    low: np.ndarray,
    high: np.ndarray,
) -> Any:
    rotation, position = T_world_robot[:3, :3], T_world_robot[:3, 3]
    if "position-last" in mistakes:
        points = points_world @ rotation - position
    else:
        points = (points_world - position) @ rotation
    if "pose-not-inverted" in mistakes:
        points = points_world @ rotation.T + position
        if "position-last" in mistakes:
            points = (points_world + position) @ rotation.T
    tested = points_world if "box-in-the-world" in mistakes else points
    above, below = tested >= low, tested <= high
    inside = (above & below).all(axis=1)
    if "one-axis-is-enough" in mistakes:
        inside = (above & below).any(axis=1)
    if "upper-limit-only" in mistakes:
        inside = below.any(axis=1) if "one-axis-is-enough" in mistakes else below.all(axis=1)
    return (points_world if "left-in-the-world" in mistakes else points)[inside]


def _make_case(rng: np.random.Generator, label: str) -> Case:
    low = np.round(rng.uniform([0.1, -0.7, 0.2], [0.3, -0.4, 0.4]), 2)
    high = np.round(low + rng.uniform(0.7, 1.1, size=3), 2)
    T_world_robot = np.eye(4)
    T_world_robot[:3, :3] = make_rotation(rng)
    T_world_robot[:3, 3] = rng.uniform(0.3, 0.6, size=3) * rng.choice([-1, 1], size=3)
    T_world_robot = np.round(T_world_robot, 9)
    points = rng.uniform(low - 0.3, high + 0.3, size=(120, 3))
    # A point within a millimeter of a limit would depend on rounding.
    near = (np.abs(points - low) < 1e-3) | (np.abs(points - high) < 1e-3)
    points = points[~near.any(axis=1)]
    world = points @ T_world_robot[:3, :3].T + T_world_robot[:3, 3]
    return Case(label, (np.round(world, 6), T_world_robot, low, high))


def _make_limit_case(rng: np.random.Generator, label: str) -> Case:
    """Make points on the limits, in eighths of a meter without a turn: nothing is rounded."""
    T_world_robot = np.eye(4)
    T_world_robot[:3, 3] = rng.integers(1, 12, size=3) / 8
    low = rng.integers(-4, 3, size=3) / 8
    high = low + 0.5
    # One step outside, on the limit, one step inside.
    places = np.array([-0.125, 0.0, 0.125, 0.375, 0.5, 0.625])
    points = low + np.stack([rng.permutation(places) for _ in range(6)]).reshape(-1, 1) * [1, 0, 0]
    points[:, 1:] += rng.choice([0.0, 0.25, 0.5, 0.5, 0.625], size=(len(points), 2))
    points = rng.permutation(np.unique(points, axis=0))
    return Case(label, (points + T_world_robot[:3, 3], T_world_robot, low, high))


def _make_row_cases(rng: np.random.Generator) -> tuple[Case, ...]:
    """Make two small clouds: one with points that are equal, one that the box does not hold."""
    world, pose, low, high = _make_case(rng, "").args
    points = (world - pose[:3, 3]) @ pose[:3, :3]
    inside = ((points >= low) & (points <= high)).all(axis=1)
    some = [*np.flatnonzero(inside)[[0, 0, 1, 1, 2, 3]], *np.flatnonzero(~inside)[:9]]
    return (
        Case("two points are in the cloud twice", (world[rng.permutation(some)], pose, low, high)),
        Case("no point is in the box", (world[:9], pose, low + 4, high + 4)),
    )


def _visible() -> tuple[Case, ...]:
    rng = np.random.default_rng(109)
    return (
        _make_case(rng, "a robot in the room"),
        _make_case(rng, "another robot"),
        _make_limit_case(rng, "points on the limits"),
        *_make_row_cases(rng),
    )


def _hidden(rng: np.random.Generator) -> tuple[Case, ...]:
    robots = tuple(_make_case(rng, f"robot {number}") for number in range(4))
    return (*robots, _make_limit_case(rng, "on the limits"), *_make_row_cases(rng))


EXERCISE = Exercise(
    name="crop_region",
    title="keep what lies in a box before the robot",
    chapter="step5",
    place=12,
    points=0,
    section="step5-world",
    objectives=("5c", "6b"),
    reference=crop_region,
    answer_with=_answer_with,
    simpler=(
        Simplification("not-turned", "the robot is not turned", stay_straight("T_world_robot")),
        Simplification(
            "at-the-origin", "the robot is at the origin", stay_at_origin("T_world_robot")
        ),
    ),
    parts=(Part("points", "cloud", "float", atol=1e-4, unit="m"),),
    tolerance_reason=(
        "0.1 mm is far above rounding, in single precision too; every mistake is off by centimeters"
    ),
    misconceptions=(
        Misconception(
            "box-in-the-world",
            "you compare world coordinates with limits that belong to the robot. Move the points "
            "first, then compare.",
        ),
        Misconception(
            "pose-not-inverted",
            "T_world_robot maps from the robot into the world. You go the other way: subtract the "
            "position, then turn back.",
        ),
        Misconception(
            "position-last",
            "you turn first and shift after. The position is in the world: subtract it before you "
            "turn back.",
        ),
        Misconception(
            "left-in-the-world",
            "the right points are kept, but with their world coordinates. Return them in the "
            "robot's frame.",
        ),
        Misconception(
            "one-axis-is-enough",
            "you keep points that are inside along one axis. A box needs x and y and z: use all, "
            "not any.",
        ),
        Misconception(
            "upper-limit-only",
            "you compare with the upper limits only. A box also ends below: low <= point <= high.",
        ),
    ),
    hints=(
        "In which frame are the points, in which the limits? One of the two has to move.",
        "p_world = R p_robot + t. Solve for p_robot; a rotation's inverse is its transpose.",
        "A comparison gives (N, 3) truth values. Which axis of it does all(axis=...) join?",
    ),
    example="""\
T_world_robot = np.eye(4)
T_world_robot[:3, 3] = data.body("pelvis").xpos
low, high = np.array([0.4, -0.5, -0.05]), np.array([1.4, 0.5, 0.3])
points_robot = crop_region(points_world[::3], T_world_robot, low, high)
print(f"{len(points_robot)} points are in reach.")
show(points_robot, frame="world")""",
    contract=(
        asked("frame-of-the-robot", "given in the frame of the robot", "mistake box-in-the-world"),
        given("in-the-world", "The cloud is in the world"),
        asked("return", "Return the points in the box", "every case", "mistake left-in-the-world"),
        asked("move", "Move a cloud into the frame", "value", "mistake position-last"),
        given("points", "Points in the world, meters"),
        asked("pose", "Pose of the robot", "mistake pose-not-inverted"),
        asked(
            "limits",
            "Limits of the box",
            "mistake one-axis-is-enough",
            "mistake upper-limit-only",
            "case points on the limits",
        ),
        asked(
            "in-the-box",
            "The points in the box, in the robot's frame, in any order",
            "value",
            "shape",
            "case two points are in the cloud twice",
            "case no point is in the box",
        ),
    ),
    visible=_visible,
    hidden=_hidden,
)
