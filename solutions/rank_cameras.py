"""Challenge of step 1: which camera of a model is nearest to a point."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

import mujoco
import numpy as np

from labutils.checks.table import Scene
from solutions._cases import make_scene_text
from solutions._model import Absorbed, Case, Exercise, Misconception, Part, asked, given, told

if TYPE_CHECKING:
    from mujoco import MjData, MjModel


def rank_cameras(
    model: MjModel, data: MjData, point_world: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Sort the cameras of a model by their distance from a point, nearest first.

    The joints may have moved since positions were last computed.

    Parameters
    ----------
    model : mujoco.MjModel
        A model with C cameras.
    data : mujoco.MjData
        Its state.
    point_world : ndarray, float64, (3,)
        A point in the world, meters.

    Returns
    -------
    ids : ndarray, int, (C,)
        Numbers of the cameras, nearest first.
    distances : ndarray, float, (C,)
        Their distances from the point, meters, in the same order.
    """
    mujoco.mj_forward(model, data)
    distances = np.linalg.norm(data.cam_xpos - point_world, axis=1)
    ids = np.argsort(distances)
    return ids, distances[ids]


def _answer_with(
    mistakes: frozenset[str], model: MjModel, data: MjData, point_world: np.ndarray
) -> Any:
    if "stale-pose" not in mistakes:
        mujoco.mj_forward(model, data)
    places = model.cam_pos if "mounting-place" in mistakes else data.cam_xpos
    gaps = point_world - places
    if "on-the-floor" in mistakes:
        gaps = gaps * [1, 1, 0]
    distances = np.linalg.norm(gaps, axis=1)
    if "along-the-axis" in mistakes:
        forward = -data.cam_xmat.reshape(-1, 3, 3)[:, :, 2]
        distances = (gaps * forward).sum(axis=1)
    ids = np.argsort(-distances if "farthest-first" in mistakes else distances)
    return ids, distances if "distances-not-sorted" in mistakes else distances[ids]


def _make_case(rng: np.random.Generator, label: str, *, nameless: bool = False) -> Case:
    """Make a point in a room with three cameras, or with a fourth that has no name."""
    while True:
        # The head camera sits before the axis of the neck, so that turning the head moves it.
        xml = make_scene_text(rng).replace('name="head_camera"', 'name="head_camera" pos=".4 .1 0"')
        xml = re.sub(r'<camera name="chase_camera"(.*?)/>', r"<camera\1/>" if nameless else "", xml)
        signs = rng.choice([-1, 1], size=2)
        qpos = tuple(np.round(rng.uniform([0.3, 0.5], [0.5, 0.9]) * signs, 3).tolist())
        point = np.round(rng.uniform([0.5, -2.0, 0.0], [2.0, 1.0, 0.9]), 3)
        model = mujoco.MjModel.from_xml_string(xml)
        data = mujoco.MjData(model)
        data.qpos[:] = qpos
        ids, distances = rank_cameras(model, data, point)
        # In the model's own order or the reverse a mistake would not show, nor in a near tie, nor
        # the place of each camera in the order where it is the order itself.
        if (ids[ids] != range(model.ncam)).any() and np.diff(distances).min() > 0.05:
            return Case(label, (Scene(xml, ("model", "data"), qpos), point))


def _visible() -> tuple[Case, ...]:
    rng = np.random.default_rng(103)
    return (
        _make_case(rng, "a point in the room"),
        _make_case(rng, "a camera without a name, which follows the ball", nameless=True),
    )


def _hidden(rng: np.random.Generator) -> tuple[Case, ...]:
    return tuple(_make_case(rng, f"point {n}", nameless=n > 0) for n in range(3))


EXERCISE = Exercise(
    name="rank_cameras",
    title="sort the cameras by distance",
    chapter="step1",
    place=13,
    points=0,
    section="step1-cameras",
    objectives=("1c", "1e"),
    reference=rank_cameras,
    answer_with=_answer_with,
    parts=(
        Part("ids", "list", "int"),
        Part("distances", "list", "float", atol=1e-4, unit="m"),
    ),
    tolerance_reason="0.1 mm is far above rounding, and every mistake is off by centimeters",
    misconceptions=(
        Misconception(
            "stale-pose",
            "the head has moved, but its camera stands where it was. Call mj_forward before you "
            "read a place.",
            section="step1-stale",
        ),
        Misconception(
            "mounting-place",
            "model.cam_pos is the place on the body that carries the camera. The place in the "
            "world is in data.cam_xpos.",
        ),
        Misconception(
            "farthest-first",
            "your order is farthest first. np.argsort sorts from small to large: leave its order "
            "as it is.",
        ),
        Misconception(
            "along-the-axis",
            "you measure along the optical axis: that is depth. The distance is the length of the "
            "straight line from the camera to the point.",
            section="step3-range",
        ),
        Misconception(
            "distances-not-sorted",
            "the numbers of the cameras are sorted, their distances are not. Index the distances "
            "with the same order.",
        ),
        Misconception(
            "on-the-floor",
            "you leave out the height: this is the distance on the floor. Use x, y and z.",
        ),
    ),
    hints=(
        "Where does MuJoCo keep the places of all cameras in the world, one row per camera?",
        "Are these places up to date? What does the chapter call before it reads them?",
        "np.argsort gives the order. How do the distances get into the same order?",
    ),
    example="""\
data.joint("neck_pan").qpos = 0.3  # nobody has told the cameras
ids, distances = rank_cameras(model, data, np.array([0.8, 0.0, 0.9]))
for number, distance in zip(ids, distances):
    print(f"{model.camera(int(number)).name:13} {distance:.3f} m")
data.joint("neck_pan").qpos = 0.0""",
    contract=(
        told("several", "The robot has several cameras"),
        asked("nearest-next", "which comes next", "every case", "mistake farthest-first"),
        asked("where-they-are", "Ask MuJoCo where the cameras", "mistake mounting-place"),
        asked("not-noticed", "where they are mounted", "mistake stale-pose"),
        asked("sorted", "Sort the cameras of a model", "value of ids", "mistake along-the-axis"),
        asked("joints-moved", "The joints may have moved", "mistake stale-pose"),
        asked("count", "A model with C cameras", "case a camera without a name"),
        given("state", "Its state"),
        asked("point", "A point in the world, meters", "mistake on-the-floor"),
        asked("numbers", "Numbers of the cameras, nearest first", "value of ids"),
        asked(
            "same-order", "in the same order", "mistake distances-not-sorted", "value of distances"
        ),
    ),
    visible=_visible,
    hidden=_hidden,
    imports=("import mujoco", "import numpy as np"),
    absorbed=(
        Absorbed(
            "stale-pose",
            "mounting-place",
            "the place on the body is a constant of the model, stale or not",
        ),
    ),
)
