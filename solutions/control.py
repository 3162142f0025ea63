"""Challenge of Following: keep the ball in the middle of the picture, whatever happens to it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import cv2
import numpy as np

from solutions._loop_cases import make_loop_cases
from solutions._model import Absorbed, Exercise, Misconception, Part, asked, given, told

if TYPE_CHECKING:
    from labutils.following import FollowingState

#: The ball, in meters, and its color in HSV, which the red box does not have.
_RADIUS = 0.045
_LOW, _HIGH = (0, 120, 50), (7, 255, 255)
#: Fewer pixels than this may be noise.
_MIN_AREA = 12
#: The neck gets there so many seconds after a command; farther ahead than the second is a guess.
_LEAD_S, _LONGEST_S = 0.08, 0.3
#: A ball that looks this much farther away than it is, is hidden in part: its middle is elsewhere.
_HIDDEN_IN_PART = 1.25
#: How much of an error a new look corrects, in the place and in the velocity.
_TRUST_PLACE, _TRUST_VELOCITY = 0.7, 0.35
#: After this many seconds the velocity is forgotten.
_FORGOTTEN_S = 0.5


def control(
    rgb: np.ndarray, depth: np.ndarray, K: np.ndarray, state: FollowingState
) -> tuple[float, float]:
    """Turn the head so that the red ball stays in the middle of the picture.

    It is called every `state.dt` seconds with the newest picture that has arrived, and the neck
    turns to its answer until the next call.

    Many controllers are right. Yours is judged by what happens in its loop, in pixels of a picture
    640 wide:

    A ball that rests is within 15 px of the middle from one second after the start on. Where it
    moves at up to 0.12 m/s, its mean distance after the first second is at most 15 px. The same
    holds at up to 0.08 m/s where pictures arrive 0.1 s late. One second after a board has hidden
    the ball, the mean distance is at most 15 px again. The same holds one second after the ball has
    come back from beyond the limits.

    No command lies outside `state.limits`. Depth may be 0 or NaN all over the ball: its pixel has
    to be enough then. The ball has hues of 0 to 7 in OpenCV's units. A red box on the table has
    hues of 170 and more.

    Parameters
    ----------
    rgb : ndarray, uint8, shape (H, W, 3)
        The picture of the head camera.
    depth : ndarray, float32, shape (H, W)
        Meters along the optical axis.
    K : ndarray, float64, shape (3, 3)
        Intrinsic matrix of the camera.
    state : FollowingState
        Among others `pan` and `tilt` of the neck now, and `seen_pan` and `seen_tilt` when the
        picture was taken, in radians. Its `memory` is a dict of your own, empty at the start.

    Returns
    -------
    pan, tilt : float
        The angles the neck turns to, in radians. Pan turns to the left, tilt turns downward.
    """
    memory = state.memory
    memory["center"] = _locate_center(rgb, depth, K, state.T_world_cam)
    if memory["center"] is not None:
        _update_track(memory, memory["center"], state.seen_time)
    if "place" not in memory:
        return _cut(state.pan, state.tilt, state)
    ahead = min(state.time - memory["time"], _LONGEST_S) + _LEAD_S
    place = memory["place"] + ahead * memory["velocity"]
    x, y, z, _ = np.linalg.inv(state.T_world_cam) @ [*place, 1.0]
    return _cut(state.seen_pan - np.arctan2(x, z), state.seen_tilt + np.arctan2(y, z), state)


def _locate_center(
    rgb: np.ndarray, depth: np.ndarray, K: np.ndarray, T_world_cam: np.ndarray
) -> np.ndarray | None:
    """Return the center of the ball in the world; None where it is not seen whole."""
    mask = cv2.inRange(cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV), np.array(_LOW), np.array(_HIGH))
    _, labels, stats, middles = cv2.connectedComponentsWithStats(mask)
    areas = stats[:, cv2.CC_STAT_AREA].astype(float)
    areas[0] = 0.0  # the background
    ball = int(np.argmax(areas))
    if areas[ball] < _MIN_AREA:
        return None
    ray = np.linalg.inv(K) @ [*middles[ball], 1.0]
    looks_away = K[0, 0] * _RADIUS / np.sqrt(areas[ball] / np.pi)
    surface = depth[labels == ball]
    surface = surface[surface > 0]  # NaN is not
    if not surface.size:
        return np.asarray((T_world_cam @ [*(looks_away * ray), 1.0])[:3])
    away = float(np.percentile(surface, 5)) + _RADIUS / np.linalg.norm(ray)
    if looks_away > _HIDDEN_IN_PART * away:
        return None
    return np.asarray((T_world_cam @ [*(away * ray), 1.0])[:3])


def _update_track(memory: dict[str, Any], center: np.ndarray, now: float) -> None:
    """Correct place and velocity by a look; start anew where the last one is long ago."""
    gap = now - memory.get("time", -np.inf)
    if gap > _FORGOTTEN_S:
        memory.update(place=center, velocity=np.zeros(3), time=now)
    elif gap > 0:
        expected = memory["place"] + gap * memory["velocity"]
        error = center - expected
        memory.update(
            place=expected + _TRUST_PLACE * error,
            velocity=memory["velocity"] + _TRUST_VELOCITY * error / gap,
            time=now,
        )


def _cut(pan: float, tilt: float, state: FollowingState) -> tuple[float, float]:
    pan, tilt = (np.clip(one, *of_it) for one, of_it in zip((pan, tilt), state.limits, strict=True))
    return float(pan), float(tilt)


def _answer_with(
    mistakes: frozenset[str],
    rgb: np.ndarray,
    depth: np.ndarray,
    K: np.ndarray,
    state: FollowingState,
) -> Any:
    if not mistakes:
        return control(rgb, depth, K, state)
    memory = state.memory
    mask = cv2.inRange(cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV), _LOW, _HIGH)
    moments = cv2.moments(mask, binaryImage=True)
    if moments["m00"] < _MIN_AREA:
        return memory.get("last", (state.pan, state.tilt))
    u, v = moments["m10"] / moments["m00"], moments["m01"] / moments["m00"]
    if "needs-depth" in mistakes and not depth[int(v), int(u)] > 0:
        return memory.get("last", (state.pan, state.tilt))
    turn = np.array([(K[0, 2] - u) / K[0, 0], (v - K[1, 2]) / K[1, 1]])
    turn = np.arctan(turn) * np.where(
        [name in mistakes for name in ("sign-of-pan", "tilt-up")], -1, 1
    )
    if "degrees" in mistakes:
        turn = np.degrees(turn)
    is_stale = "stale-frame" in mistakes
    pose = (state.pan, state.tilt) if is_stale else (state.seen_pan, state.seen_tilt)
    target = np.array(pose) + turn
    if "wind-up" in mistakes:
        memory["sum"] = target = memory.get("sum", np.array(pose)) + 0.3 * turn
    pan, tilt = map(float, target)
    memory["last"] = (pan, tilt) if "no-limits" in mistakes else _cut(pan, tilt, state)
    return memory["last"]


EXERCISE = Exercise(
    name="control",
    title="keep a ball in the middle of the picture",
    chapter="following",
    place=3,
    points=0,
    section="following-loop",
    objectives=("7c",),
    reference=control,
    answer_with=_answer_with,
    imports=("import cv2", "import numpy as np"),
    parts=(Part("pan, tilt", "closed-loop", "float"),),
    tolerance_reason=(
        "none: what counts are the bounds of the statement. 15 of 640 px is a fifth of the ball; "
        "turning by the angle of each picture alone keeps 12, and with a prediction 5"
    ),
    misconceptions=(
        Misconception(
            "sign-of-pan",
            "the head turns away from the ball to the side. A ball on the right needs a smaller "
            "pan, for pan turns to the left.",
        ),
        Misconception(
            "tilt-up",
            "the head nods away from the ball. Rows grow downward, and so does tilt: a ball below "
            "the middle needs a larger tilt.",
        ),
        Misconception(
            "degrees",
            "the head turns by many times the angle. The neck takes radians: leave out every "
            "conversion to degrees.",
        ),
        Misconception(
            "no-limits",
            "commands go beyond what the neck can do. Cut pan and tilt off at state.limits before "
            "you return them.",
        ),
        Misconception(
            "wind-up",
            "what you add up goes on growing while the neck is at its limit, and has to shrink "
            "again first. Cut the sum off as well.",
        ),
        Misconception(
            "stale-frame",
            "you add the angle of an old picture to the pose of now. It belongs to seen_pan and "
            "seen_tilt, where the neck was when it was taken.",
        ),
        Misconception(
            "needs-depth",
            "you lose the ball where its depth is 0 or NaN. Its pixel alone says where to turn: "
            "use depth only where there is one.",
        ),
    ),
    absorbed=(
        Absorbed(
            "sign-of-pan",
            "wind-up",
            "a head that turns away never stays at the limit beside the ball",
        ),
        Absorbed(
            "degrees", "wind-up", "57 times the angle goes from one limit to the other in any case"
        ),
        Absorbed("degrees", "stale-frame", "57 times the angle hides which pose it was added to"),
    ),
    hints=(
        "Which pixel is the ball's? By which angle is that pixel off the middle of the picture?",
        (
            "That angle was right when the picture was taken. Where was the neck then, and how far "
            "has the ball gone since?"
        ),
        (
            "Per axis: the pose of the picture plus the angle, a lead of velocity times delay, and "
            "the limits. Keep the last place and time in state.memory, for when no ball is seen."
        ),
    ),
    example="""\
from labutils.following import FollowingLoop

with FollowingLoop(160, 120, seed=1, speed=0.15) as loop:
    followed = loop.run(control, 1.5)
show(followed.error_px[-5:], "the last errors in px")""",
    contract=(
        told("by-itself", "The head is to follow"),
        told("loops", "It is put into loops"),
        told("styles", "Nobody compares your commands"),
        told("how-long", "A check runs"),
        asked("middle", "Turn the head so that the red ball stays", "every case"),
        told("calls", "It is called every"),
        told("many", "Many controllers are right"),
        told("judged", "Yours is judged by"),
        asked("rests", "A ball that rests is within", "settles", "case a ball that rests"),
        asked("moves", "Where it moves at up to", "follows", "case a ball that moves"),
        asked("late", "where pictures arrive 0.1 s late", "case pictures", "mistake stale-frame"),
        asked("board", "One second after a board", "recovers", "case a board"),
        asked(
            "comes-back",
            "come back from beyond the limits",
            "case a ball beyond the limits",
            "mistake wind-up",
        ),
        asked("limits", "No command lies outside", "limits", "mistake no-limits"),
        asked("no-depth", "Depth may be 0 or NaN", "case no depth", "mistake needs-depth"),
        given("hues", "The ball has hues"),
        given("red-box", "A red box on the table"),
        given("head-camera", "The picture of the head camera"),
        given("meters", "Meters along the optical axis"),
        given("intrinsic", "Intrinsic matrix of the camera"),
        given("poses", "Among others `pan` and `tilt`"),
        told("memory", "Its `memory` is a dict of your own"),
        asked("radians", "The angles the neck turns to", "mistake degrees"),
        asked("signs", "Pan turns to the left", "mistake sign-of-pan", "mistake tilt-up"),
    ),
    visible=lambda: make_loop_cases(np.random.default_rng(769), has_looks=True),
    hidden=make_loop_cases,
)
