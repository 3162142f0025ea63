"""Following: from a pixel to the angles that the neck is told."""

from __future__ import annotations

from typing import Any

import numpy as np

import labutils
from solutions._model import Absorbed, Case, Exercise, Misconception, Part, asked, given
from solutions._simpler import Simplification, put

#: Low and high of pan and of tilt: wide enough for every mistake, and too narrow for every pixel.
_FAR_LIMITS = ((-150.0, 150.0), (-150.0, 150.0))
_NARROW_LIMITS = ((-0.32, 0.35), (-0.35, 0.31))

_Limits = tuple[tuple[float, float], tuple[float, float]]


def _answer_with(
    mistakes: frozenset[str],
    pixel: tuple[float, float],
    K: np.ndarray,
    pan: float,
    tilt: float,
    limits: _Limits,
) -> Any:
    place = np.array(pixel[::-1] if "row-column" in mistakes else pixel, dtype=float)
    center = K[:2, 2][::-1] if "wrong-center" in mistakes else K[:2, 2]
    if "from-the-corner" in mistakes:
        center = np.zeros(2)
    slope = (place - center) / np.diag(K)[:2]
    change = slope if "no-arctangent" in mistakes else np.arctan(slope)
    if "fov-share" in mistakes:  # K[:2, 2] is half the picture
        half = K[:2, 2]
        change = (place - center) / half * np.arctan(half / np.diag(K)[:2])
    if "degrees" in mistakes:
        change = np.degrees(change)
    sign = np.array([1 if "turns-away" in mistakes else -1, -1 if "looks-up" in mistakes else 1])
    start = np.zeros(2) if "change-only" in mistakes else np.array([pan, tilt])
    angles = start + sign * change
    return angles if "no-limits" in mistakes else np.clip(angles, *np.transpose(limits))


def _make_case(
    rng: np.random.Generator, label: str, sides: tuple[int, int], limits: _Limits | None = None
) -> Case:
    """Make a pixel to the right (1) or left (-1), below (1) or above (-1), far from the middle."""
    width, height = map(int, rng.integers((420, 300), (520, 360)))
    focal_px = float(rng.uniform(0.5, 0.6)) * width
    # The lens of no camera sits exactly before the middle.
    center = np.array([width, height]) / 2 + rng.uniform(8, 20, size=2) * rng.choice([-1, 1], 2)
    K = np.array([[focal_px, 0, center[0]], [0, 1.1 * focal_px, center[1]], [0, 0, 1]])
    pixel = center + np.array(sides) * rng.uniform(0.68, 0.9, size=2) * [width / 2, height / 2]
    pan, tilt = rng.uniform(0.15, 0.3, size=2) * rng.choice([-1, 1], size=2)
    return Case(
        label,
        (
            (round(float(pixel[0]), 1), round(float(pixel[1]), 1)),
            np.round(K, 3),
            round(float(pan), 3),
            round(float(tilt), 3),
            limits or _make_limits(rng),
        ),
    )


def _make_limits(rng: np.random.Generator) -> _Limits:
    low_pan, high_pan, low_tilt, high_tilt = np.round(
        rng.uniform([-1.9, 1.5, -1.4, 1.0], [-1.6, 1.8, -1.1, 1.3]), 2
    ).tolist()
    return (low_pan, high_pan), (low_tilt, high_tilt)


def _make_near(rng: np.random.Generator, label: str) -> Case:
    """Make a pixel so near the middle that even degrees stay within the limits."""
    pixel, K, pan, tilt, limits = _make_case(rng, label, (1, 1)).args
    off = rng.uniform(0.6, 1.8, size=2) * rng.choice([-1, 1], size=2)
    pixel = (round(float(K[0, 2] + off[0]), 2), round(float(K[1, 2] + off[1]), 2))
    return Case(label, (pixel, K, pan, tilt, limits))


def _make_beyond(rng: np.random.Generator, label: str, sides: tuple[int, int]) -> Case:
    """Make a neck that has turned to that side already: both joints come to their ends."""
    pixel, K, _, _, limits = _make_case(rng, label, sides).args
    (low_pan, high_pan), (low_tilt, high_tilt) = limits
    pan = (low_pan if sides[0] > 0 else high_pan) * float(rng.uniform(0.8, 0.9))
    tilt = (high_tilt if sides[1] > 0 else low_tilt) * float(rng.uniform(0.8, 0.9))
    return Case(label, (pixel, K, round(pan, 3), round(tilt, 3), limits))


def _make_part(rng: np.random.Generator, label: str) -> Case:
    """Make a picture that was cut out at the lower right: its principal point lies outside."""
    pixel, K, pan, tilt, _ = _make_case(rng, label, (1, 1)).args
    cut = np.floor(K[:2, 2] * rng.uniform(1.1, 1.3))
    K[:2, 2] -= cut
    u, v = np.round(np.array(pixel) - cut, 1).tolist()
    return Case(label, ((u, v), np.round(K, 3), pan, tilt, _FAR_LIMITS))


def _make_cases(rng: np.random.Generator) -> tuple[Case, ...]:
    return (
        _make_case(rng, "something on the right, below the middle", (1, 1)),
        _make_case(rng, "something on the left, above the middle", (-1, -1)),
        _make_near(rng, "something a little off the middle"),
        _make_beyond(rng, "on the left and low, with the neck near its limits", (-1, 1)),
        _make_beyond(rng, "on the right and high, with the neck near its limits", (1, -1)),
        _make_part(rng, "a neck that may turn round many times, a part of a picture"),
        _make_case(rng, "a neck that hardly turns", (1, 1), _NARROW_LIMITS),
    )


def _look_near(args: dict[str, Any]) -> dict[str, Any]:
    center = args["K"][:2, 2]
    near = center + (np.array(args["pixel"]) - center) / 60
    return {"pixel": tuple(near.tolist())}


EXERCISE = Exercise(
    name="command_from_pixel",
    title="turn a pixel into what the neck is told",
    chapter="following",
    place=1,
    points=0,
    section="following-look",
    objectives=("7a",),
    reference=labutils.command_from_pixel,
    answer_with=_answer_with,
    simpler=(
        Simplification("straight", "the neck is straight", put(pan=0.0, tilt=0.0)),
        Simplification("far-limits", "the limits are far away", put(limits=_FAR_LIMITS)),
        Simplification("near-the-middle", "the pixel is near the middle", _look_near),
    ),
    parts=(Part("command", "vector", "float", atol=2e-5, unit="rad"),),
    tolerance_reason=(
        "a hundredth of a pixel at these focal lengths; whoever leaves out the arctangent is off "
        "by more than a thousand times as much, where the pixel is far from the middle"
    ),
    misconceptions=(
        Misconception(
            "turns-away",
            "the head pans away from the pixel. Pan is positive to the left: what is right of the "
            "middle needs a smaller pan.",
        ),
        Misconception(
            "looks-up",
            "the head tilts away from the pixel. Rows count downward, and so does tilt: what is "
            "below the middle needs a larger tilt.",
        ),
        Misconception(
            "degrees",
            "you add degrees to radians. NumPy's arctan gives radians already, and the neck takes "
            "radians: leave the conversion out.",
        ),
        Misconception(
            "no-limits",
            "your target lies beyond the end of a joint. Cut it off there: np.clip(angle, low, "
            "high), each joint with its own limits.",
        ),
        Misconception(
            "change-only",
            "this is how far to turn. The servo takes the angle itself: begin with the angle that "
            "the neck had in the picture.",
        ),
        Misconception(
            "no-arctangent",
            "pixels over focal length is the tangent of the angle. They agree near the middle "
            "only: take the arctangent.",
            section="step2-focal",
        ),
        Misconception(
            "fov-share",
            "you give every pixel the same share of the field of view. Pixels far out span less: "
            "divide by the focal length, then take the arctangent.",
            section="step2-focal",
        ),
        Misconception(
            "wrong-center",
            "you mix up cx and cy. What belongs to the column stands in the first row of K, what "
            "belongs to the row in the second.",
            section="step2-center",
        ),
        Misconception(
            "from-the-corner",
            "you count pixels from the corner of the picture. The neck looks along the optical "
            "axis: count from the principal point of K.",
            section="step2-center",
        ),
        Misconception(
            "row-column",
            "you read the pixel as (row, column). It is (u, v): the column comes first, and it "
            "belongs to pan.",
        ),
    ),
    hints=(
        "How many columns and rows is the pixel away from the principal point?",
        "Pixels and focal length are the two short sides of a right triangle. Which angle is it?",
        "Start with the angle of the neck, add or subtract yours, and cut off what is too much.",
    ),
    example="""\
mask = lab.segment_by_color(rgb, ((0, 120, 50), (7, 255, 255)))  # the ball
pixel, limits = lab.find_object_centroid(mask), model.actuator_ctrlrange
_, turned = lab.make_scene()
turned.qpos[:] = command_from_pixel(pixel, K, *data.qpos, limits)
view, _ = lab.render_camera(model, turned, renderer, "head_camera")
show(view, f"pan, tilt {np.round(turned.qpos, 3)} rad")""",
    contract=(
        given("seen", "Something is seen at a pixel"),
        asked("to-the-middle", "Which angles does the neck take", "every case"),
        asked("target", "A servo takes target angles", "mistake change-only"),
        asked(
            "cut-off",
            "A joint has ends",
            "mistake no-limits",
            "case on the left and low",
            "case on the right and high",
            "case a neck that hardly turns",
        ),
        asked("compute", "Compute the angles of the neck", "value"),
        asked(
            "signs",
            "Positive pan turns the head",
            "mistake turns-away",
            "mistake looks-up",
            "mistake degrees",
        ),
        asked(
            "by-angle",
            "Each axis is treated by itself",
            "mistake no-arctangent",
            "mistake fov-share",
        ),
        asked("column-first", "Column and row", "mistake row-column"),
        asked(
            "intrinsics",
            "Intrinsic matrix of the camera",
            "mistake wrong-center",
            "mistake from-the-corner",
        ),
        asked("part", "a part of a larger one", "case a neck that may turn round"),
        given("angle-then", "in the moment the picture was taken"),
        asked("limits", "what lies beyond is cut off", "mistake no-limits"),
        asked("radians", "The angles to command", "mistake degrees", "mistake no-limits"),
    ),
    visible=lambda: _make_cases(np.random.default_rng(1907)),
    hidden=_make_cases,
    asks={
        "pixel": "tuple of (u, v)\nColumn and row.",
        "K": (
            "ndarray, float64, shape (3, 3)\n"
            "Intrinsic matrix of the camera. Where the picture is a part of a larger one, the "
            "principal point may lie outside."
        ),
        "limits": (
            "((low, high), (low, high))\n"
            "Of pan and of tilt, in radians; what lies beyond is cut off."
        ),
        "Convention": (
            "Positive pan turns the head to its left, positive tilt downward; both are in radians. "
            "Each axis is treated by itself: by the angle between the optical axis and the viewing "
            "ray of the pixel's column, or of its row."
        ),
        "Raises": "",
        "Examples": "",
    },
    absorbed=(
        Absorbed(
            "wrong-center",
            "from-the-corner",
            "who counts from the corner uses no center that could be the wrong one",
        ),
        Absorbed(
            "no-arctangent",
            "fov-share",
            "a share of the field of view is taken without the tangent anyway",
        ),
    ),
)
