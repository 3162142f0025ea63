"""Step 5: from the camera frame into the world."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

import labutils
from solutions._cases import make_rotation
from solutions._model import Absorbed, Case, Exercise, Misconception, Part, asked, given
from solutions._simpler import Simplification, put
from solutions.completions.camera_to_world import COMPLETION


def _answer_with(
    mistakes: frozenset[str], points: np.ndarray, cam_xpos: np.ndarray, cam_xmat: np.ndarray
) -> np.ndarray:
    rotation = cam_xmat.reshape(3, 3)
    flip = np.diag([1.0, -1.0, 1.0 if "z-not-flipped" in mistakes else -1.0])
    if "no-flip" not in mistakes:
        rotation = flip @ rotation if "flip-outside" in mistakes else rotation @ flip
    if "transposed" in mistakes:
        rotation = rotation.T
    if "no-position" in mistakes:
        return points @ rotation.T
    if "position-first" in mistakes:
        return (points + cam_xpos) @ rotation.T
    return points @ rotation.T + cam_xpos


def _make_case(rng: np.random.Generator, label: str, count: int, *, flat: bool) -> Case:
    points = np.round(rng.uniform((-1, -1, 0.5), (1.5, 0.8, 4), size=(count, 3)), 4)
    position = np.round(rng.uniform((0.5, -2, 0.8), (2, -0.5, 2), size=3), 4)
    rotation = make_rotation(rng)
    return Case(label, (points, position, rotation.ravel() if flat else rotation))


def _visible() -> tuple[Case, ...]:
    rng = np.random.default_rng(81)
    return (
        _make_case(rng, "five points, cam_xmat as 3x3 matrix", 5, flat=False),
        _make_case(rng, "forty points, cam_xmat as the nine numbers MuJoCo gives", 40, flat=True),
        _make_case(rng, "no point at all", 0, flat=True),
        _make_whole(rng),
        _make_case(rng, "a single point", 1, flat=False),
    )


def _make_whole(rng: np.random.Generator) -> Case:
    case = _make_case(rng, "points in whole meters", 13, flat=False)
    points, *pose = case.args
    return replace(case, args=(np.round(4 * points).astype(np.int64), *pose))


def _hidden(rng: np.random.Generator) -> tuple[Case, ...]:
    return (
        *(
            _make_case(rng, f"pose {number + 1}", int(rng.integers(3, 60)), flat=bool(number % 2))
            for number in range(5)
        ),
        _make_case(rng, "no point at all", 0, flat=False),
        _make_whole(rng),
        _make_case(rng, "a single point", 1, flat=True),
    )


def _get_identity(args: dict[str, Any]) -> np.ndarray:
    return np.eye(3).reshape(args["cam_xmat"].shape)


EXERCISE = Exercise(
    name="camera_to_world",
    title="move points from the camera into the world",
    chapter="step5",
    place=2,
    points=6,
    section="step5-world",
    objectives=("5c",),
    reference=labutils.camera_to_world,
    answer_with=_answer_with,
    simpler=(
        Simplification(
            "not-turned", "the camera is not turned", lambda a: {"cam_xmat": _get_identity(a)}
        ),
        Simplification("at-the-origin", "the camera is at the origin", put(cam_xpos=np.zeros(3))),
        Simplification(
            "plain",
            "the camera is at the origin, not turned",
            lambda a: {"cam_xpos": np.zeros(3), "cam_xmat": _get_identity(a)},
        ),
    ),
    parts=(Part("points", "rows", "float", atol=1e-4, unit="m"),),
    tolerance_reason=(
        "0.1 mm is a hundred times the rounding of float32 within 10 m; every mistake moves points "
        "by centimeters"
    ),
    misconceptions=(
        Misconception(
            "no-flip",
            "the points came in OpenCV's axes, but cam_xmat is for MuJoCo's: y up, looking along "
            "-z. Turn y and z around first.",
        ),
        Misconception(
            "z-not-flipped",
            "y is turned around, z is not. MuJoCo's camera looks along -z, so what lies before "
            "the camera has a negative z there.",
        ),
        Misconception(
            "flip-outside",
            "you turn the axes around in the world, after the rotation. It belongs into the camera "
            "frame: cam_xmat @ flip, not flip @ cam_xmat.",
        ),
        Misconception(
            "transposed",
            "the rotation is transposed, which turns the other way. Points are rows here: rows "
            "are multiplied by the transpose of the matrix, once.",
        ),
        Misconception(
            "no-position",
            "the directions are right, but the camera still sits at the origin. Add cam_xpos after "
            "the rotation.",
        ),
        Misconception(
            "position-first",
            "cam_xpos is added before the rotation. It is a place in the world: rotate into the "
            "world first, then add it.",
        ),
    ),
    hints=(
        (
            "Two things happen to a point, in this order: it is turned into the world's "
            "directions, then moved to where the camera stands."
        ),
        (
            "cam_xmat turns MuJoCo's camera axes into the world. Which axes of your points "
            "differ from those, and by what sign?"
        ),
        (
            "For a column p the answer is R p + t. Your points are rows: transpose both sides to "
            "see what stands where."
        ),
    ),
    example="""\
cloud = camera_to_world(points, camera.xpos, camera.xmat)
print(f"The table is {np.median(cloud[:, 2]):.3f} m above the floor.")
show((cloud, colors), frame="world")""",
    contract=(
        asked(
            "its-own-frame",
            "the rotation of *its own* camera frame",
            "mistake no-flip",
            "mistake z-not-flipped",
        ),
        given("opencv", "Your points are in the frame of OpenCV"),
        asked("move", "Move them into the world", "every case"),
        asked(
            "to-the-world",
            "Move points from the OpenCV camera frame",
            "mistake no-position",
            "mistake position-first",
        ),
        asked("rotation", "R_world_cv", "mistake flip-outside", "mistake transposed"),
        given("points", "OpenCV camera frame, meters"),
        given("place", "data.cam_xpos"),
        asked("axes", "data.cam_xmat", "case forty points", "case five points"),
        asked(
            "world",
            "World coordinates in meters",
            "value",
            "case no point at all",
            "case points in whole meters",
            "case a single point",
        ),
    ),
    visible=_visible,
    hidden=_hidden,
    asks={
        "points": "ndarray, int or float, shape (N, 3)\nOpenCV camera frame, meters.",
        "cam_xpos": "ndarray, float, shape (3,)\n``data.cam_xpos`` of the camera.",
        "cam_xmat": (
            "ndarray, float, shape (9,) or (3, 3)\n``data.cam_xmat`` of the camera, MuJoCo's axes."
        ),
        "Returns": "ndarray, float, shape (N, 3)\n    World coordinates in meters.",
        "Raises": "",
    },
    absorbed=(
        Absorbed("no-flip", "z-not-flipped", "without a flip no part of it can be forgotten"),
        Absorbed("no-flip", "flip-outside", "without a flip there is no side to put it on"),
        Absorbed("no-position", "position-first", "what is never added is not added too early"),
    ),
    completion=COMPLETION,
)
