"""Challenge of step 4: the nearest object that fits into the hand."""

from __future__ import annotations

from typing import Any

import numpy as np

from solutions._model import Absorbed, Case, Exercise, Misconception, Part, asked, given
from solutions._object_cases import (
    fill_objects,
    flatten_objects,
    make_small_objects,
    make_table,
    move_background,
)
from solutions._simpler import Simplification, face_along, move_to_origin, put


def nearest_object(
    labels: np.ndarray,
    depth_metric: np.ndarray,
    K: np.ndarray,
    T_world_cam: np.ndarray,
    max_width: float,
) -> tuple[int | None, np.ndarray | None]:
    """Choose the nearest object that the hand can take, and say where it is.

    Only pixels with a valid depth count (above 0.01 m, below 10 m). The points behind the valid
    pixels of an object give its width (largest minus smallest x in the camera frame) and its
    position (median of x, median of y, median of z in the camera frame). The nearest object is
    the one whose position has the smallest distance from the camera, among those that are at most
    `max_width` wide. An object without a valid pixel does not fit.

    Parameters
    ----------
    labels : ndarray, int32, (H, W)
        0 for the background, 1, 2, 3 ... for the pixels of an object.
    depth_metric : ndarray, float32, (H, W)
        Meters along the optical axis; the pixels of an object may include invalid ones.
    K : ndarray, float64, (3, 3)
        Intrinsic matrix.
    T_world_cam : ndarray, float64, (4, 4)
        Pose of the camera (x right, y down, z forward): it maps camera points into the world.
    max_width : float
        How far the hand opens, meters.

    Returns
    -------
    label : int or None
        Which object; None where none fits.
    position_world : ndarray, float, (3,), or None
        Its position, moved into the world frame, meters; None where none fits.
    """
    best_label: int | None = None
    best_distance, best_position = np.inf, None
    valid = (depth_metric > 0.01) & (depth_metric < 10)
    for label in range(1, labels.max() + 1):
        v, u = np.nonzero(valid & (labels == label))
        if not v.size:
            continue
        z = depth_metric[v, u].astype(np.float64)
        x, y = (u - K[0, 2]) / K[0, 0] * z, (v - K[1, 2]) / K[1, 1] * z
        position = np.array([np.median(x), np.median(y), np.median(z)])
        distance = float(np.linalg.norm(position))
        if np.ptp(x) <= max_width and distance < best_distance:
            best_label, best_distance = label, distance
            best_position = T_world_cam[:3, :3] @ position + T_world_cam[:3, 3]
    return best_label, best_position


def _answer_with(
    mistakes: frozenset[str],
    labels: np.ndarray,
    depth_metric: np.ndarray,
    K: np.ndarray,
    T_world_cam: np.ndarray,
    max_width: float,
) -> Any:
    valid = (depth_metric > 0.01) & (depth_metric < 10)
    if "invalid-kept" in mistakes:
        valid[:] = True
    middle = np.mean if "mean-position" in mistakes else np.median
    candidates = []
    for label in np.unique(labels[labels > 0]):
        v, u = np.nonzero(valid & (labels == label))
        if not v.size:
            continue
        pixels = np.stack([u, v, np.ones_like(u)])
        points = (np.linalg.inv(K) @ pixels * depth_metric[v, u]).T
        position = middle(points, axis=0)
        if np.ptp(points[:, 0]) > max_width and "any-width" not in mistakes:
            continue
        distance = position[2] if "depth-only" in mistakes else np.sqrt((position**2).sum())
        candidates.append((distance, int(label), position))
    if not candidates:
        return None, None
    _, label, position = min(candidates, key=lambda candidate: candidate[0])
    if "camera-frame" in mistakes:
        return label, position
    pose = np.linalg.inv(T_world_cam) if "pose-inverted" in mistakes else T_world_cam
    return label, (pose @ [*position, 1])[:3]


def _visible() -> tuple[Case, ...]:
    rng = np.random.default_rng(107)
    table = make_table(rng, "five objects on a table")
    return (
        table,
        make_table(rng, "the same table, another camera"),
        Case("a hand that is too small for all of them", (*table.args[:-1], 0.03)),
        *make_small_objects(rng),
    )


def _hidden(rng: np.random.Generator) -> tuple[Case, ...]:
    tables = tuple(make_table(rng, f"table {number}") for number in range(3))
    small = Case("too small a hand", (*tables[0].args[:-1], 0.02))
    return (*tables, small, *make_small_objects(rng))


def _number_anew(args: dict[str, Any]) -> dict[str, Any]:
    nearest, _ = nearest_object(**args)
    labels = args["labels"]
    if nearest is None:
        return {}
    one, other = labels == nearest, labels == 1
    labels[one], labels[other] = 1, nearest
    return {"labels": labels}


EXERCISE = Exercise(
    name="nearest_object",
    title="choose the nearest object that the hand can take",
    chapter="step4",
    place=12,
    points=0,
    section="step4-locate",
    objectives=("4e", "5c"),
    reference=nearest_object,
    answer_with=_answer_with,
    simpler=(
        Simplification(
            "not-turned",
            "the camera is not turned",
            lambda a: {"T_world_cam": face_along(a["T_world_cam"])},
        ),
        Simplification(
            "at-the-origin",
            "the camera is at the origin",
            lambda a: {"T_world_cam": move_to_origin(a["T_world_cam"])},
        ),
        Simplification("even-depth", "every object has the same depth everywhere", flatten_objects),
        Simplification("label-1", "the nearest object has the label 1", _number_anew),
        Simplification("far-background", "the background is far away", move_background),
        Simplification("all-valid", "no pixel of an object is invalid", fill_objects),
        Simplification("large-hand", "the hand is large enough for all", put(max_width=9.0)),
    ),
    parts=(
        Part("label", "choice", "int", nullable=True, note="None stands for: no object fits"),
        Part(
            "position_world",
            "vector",
            "float",
            atol=2e-4,
            unit="m",
            nullable=True,
            note="None exactly where no object fits",
        ),
    ),
    tolerance_reason=(
        "0.2 mm lies above the rounding of float32, and far below the half centimeter between "
        "median and mean"
    ),
    misconceptions=(
        Misconception(
            "any-width",
            "you choose an object that is too wide for the hand. Compare its width with max_width "
            "before you compare distances.",
        ),
        Misconception(
            "depth-only",
            "you compare depths. Depth is measured along the optical axis; an object at the side "
            "is farther away than its depth.",
            section="step3-range",
        ),
        Misconception(
            "invalid-kept",
            "pixels without a measurement take part: a depth of 12 m makes an object wide. Keep "
            "the valid ones only.",
            section="step3-invalid",
        ),
        Misconception(
            "camera-frame",
            "the position is in the camera frame. An arm works in the world: apply T_world_cam.",
            section="step5-world",
        ),
        Misconception(
            "mean-position",
            "you take the mean. Parts that stand back pull it away: the median does not move.",
        ),
        Misconception(
            "pose-inverted",
            "you apply the inverse pose. T_world_cam maps camera points into the world as it is.",
            section="step5-world",
        ),
    ),
    hints=(
        "For one object: a mask, the points behind it, a width and a position. Then a loop.",
        "x = (u - cx) z / fx, y likewise. Which pixels have a depth that you can trust?",
        "Compare distances in the camera frame, where the camera is at 0. Which step comes last?",
    ),
    example="""\
bodies = lab.render_segmentation(model, data, renderer, "head_camera")
ids = [model.body(name).id for name in ("red_box", "red_ball", "green_can")]
labels = np.select([bodies == one for one in ids], np.int32([1, 2, 3]))
pose = lab.get_camera_pose(model, data, "head_camera")
label, position_world = nearest_object(labels, depth, K, pose, 0.08)
show((lab.visualize_detection(rgb, None, labels == label), position_world))""",
    contract=(
        given("labels-number", "numbers their pixels"),
        asked(
            "only-so-far",
            "The hand opens only so far",
            "mistake any-width",
            "case a hand that is too small",
        ),
        asked("which", "Which object is the nearest", "every case"),
        asked(
            "suspects",
            "Take care of the three usual suspects",
            "mistake invalid-kept",
            "mistake depth-only",
            "mistake camera-frame",
        ),
        asked("choose", "Choose the nearest object", "value of label"),
        asked(
            "valid",
            "Only pixels with a valid depth count",
            "mistake invalid-kept",
            "case depths and a width",
        ),
        asked("width-position", "give its width", "mistake mean-position", "mistake any-width"),
        asked(
            "nearest",
            "has the smallest distance",
            "mistake depth-only",
            "case objects that are nearer",
        ),
        asked("empty", "An object without a valid pixel", "case something near"),
        asked("background", "0 for the background", "case something near"),
        asked("invalid-inside", "may include invalid ones", "mistake invalid-kept"),
        given("intrinsics", "Intrinsic matrix"),
        asked("pose", "Pose of the camera", "mistake pose-inverted"),
        asked("hand", "How far the hand opens", "mistake any-width"),
        asked(
            "which-one",
            "Which object; None where none fits",
            "value of label",
            "case a hand that is too small",
        ),
        asked(
            "in-the-world",
            "Its position, moved into the world frame",
            "mistake camera-frame",
            "value of position_world",
        ),
    ),
    visible=_visible,
    hidden=_hidden,
    absorbed=(Absorbed("camera-frame", "pose-inverted", "without a pose there is none to invert"),),
)
