"""Challenge of step 1: turn the head so that a pixel column comes to the middle."""

from __future__ import annotations

from typing import Any

import numpy as np

from solutions._model import Case, Exercise, Misconception, Part, asked, given, told
from solutions._simpler import Simplification, put


def choose_pan(u: float, pan: float, fov_y: float, width: int, height: int) -> float:
    """Choose the angle of the neck that brings a pixel column to the middle of the picture.

    The head is level, and the camera sits on the axis of the neck. Positive angles turn the head
    to its left.

    Parameters
    ----------
    u : float
        Column of the thing to look at, pixels.
    pan : float
        Angle of the neck while the picture was taken, radians.
    fov_y : float
        Vertical field of view, radians; pixels are square.
    width, height : int
        Size of the picture, pixels.

    Returns
    -------
    float
        The angle to set, radians.
    """
    focal_px = height / (2 * np.tan(fov_y / 2))
    return pan - float(np.arctan((u - (width - 1) / 2) / focal_px))


def _answer_with(
    mistakes: frozenset[str], u: float, pan: float, fov_y: float, width: int, height: int
) -> Any:
    side = width if "width-for-height" in mistakes else height
    focal_px = side / (2 * np.tan(fov_y / 2))
    center = width / 2 if "half-pixel" in mistakes else (width - 1) / 2
    slope = (u - center) / focal_px
    turn = slope if "no-arctangent" in mistakes else np.arctan(slope)
    if "degrees" in mistakes:
        turn = np.degrees(turn)
    if "wrong-way" in mistakes:
        turn = -turn
    return float((0 if "change-only" in mistakes else pan) - turn)


def _make_case(rng: np.random.Generator, label: str, share: float) -> Case:
    height, width = int(rng.integers(90, 240)), int(rng.integers(250, 400))
    u = round(share * width + float(rng.uniform(-5, 5)), 1)
    pan = round(float(rng.uniform(0.1, 0.5)) * rng.choice([-1, 1]), 3)
    return Case(label, (u, pan, round(float(rng.uniform(0.7, 1.1)), 3), width, height))


def _make_middle(rng: np.random.Generator, label: str) -> Case:
    """Make the view in which nothing is to be turned: half a pixel is exact in any formula."""
    _, pan, fov_y, width, height = _make_case(rng, label, 0.5).args
    return Case(label, ((width - 1) / 2, pan, fov_y, width, height))


def _visible() -> tuple[Case, ...]:
    rng = np.random.default_rng(102)
    return (
        _make_case(rng, "something in the left part of the picture", 0.1),
        _make_case(rng, "something in the right part", 0.85),
        _make_case(rng, "something a little to the right of the middle", 0.6),
        _make_middle(rng, "something in the very middle already"),
    )


def _hidden(rng: np.random.Generator) -> tuple[Case, ...]:
    views = tuple(_make_case(rng, f"view {share}", share) for share in (0.05, 0.2, 0.7, 0.95))
    return (*views, _make_middle(rng, "the middle"))


EXERCISE = Exercise(
    name="choose_pan",
    title="turn the head toward a pixel",
    chapter="step1",
    place=12,
    points=0,
    section="step1-pan",
    objectives=("1d",),
    reference=choose_pan,
    answer_with=_answer_with,
    simpler=(
        Simplification("straight", "the neck is straight", put(pan=0.0)),
        Simplification(
            "in-the-middle", "u is the middle column", lambda a: {"u": (a["width"] - 1) / 2}
        ),
    ),
    parts=(Part("pan", "number", "float", atol=2e-5, unit="rad"),),
    tolerance_reason=(
        "a hundredth of a pixel at these focal lengths; half a pixel, the smallest of the "
        "mistakes, is fifty times as much"
    ),
    misconceptions=(
        Misconception(
            "wrong-way",
            "the head turns away. Turning left moves the picture to the right: what is left of "
            "the middle needs a larger angle.",
        ),
        Misconception(
            "half-pixel",
            "your middle is width / 2. Whole numbers are pixel centers, so the middle of the "
            "columns is (width - 1) / 2.",
            section="step2-center",
        ),
        Misconception(
            "no-arctangent",
            "pixels over focal length is the tangent of the angle. They agree near the middle "
            "only: take the arctangent.",
            section="step2-focal",
        ),
        Misconception(
            "width-for-height",
            "you combine the vertical field of view with the width. fov_y belongs to the height, "
            "also when the angle is sought sideways.",
            section="step2-focal",
        ),
        Misconception(
            "change-only",
            "this is the change of the angle. The motor takes the angle itself: add what the neck "
            "had when the picture was taken.",
        ),
        Misconception(
            "degrees",
            "your change is in degrees, but the angle of the neck is in radians. NumPy's arctan "
            "gives radians already.",
        ),
    ),
    hints=(
        "How many pixels is the column away from the middle, and what is the middle?",
        "Pixels become an angle by the focal length in pixels: which triangle do they form?",
        "Something is left of the middle. Must the angle grow or shrink? Positive turns left.",
    ),
    example="""\
_, level = lab.make_scene()
for pan in (0.0, choose_pan(222.0, 0.0, fov_y, 640, 480)):  # to the window
    level.qpos[:] = pan, 0.0  # the head is level
    view, _ = lab.render_camera(model, level, renderer, "head_camera")
    show(view, f"pan {pan:.3f} rad")""",
    contract=(
        told("interesting", "Something interesting appears"),
        asked(
            "to-the-middle", "Which angle must the neck take", "every case", "mistake half-pixel"
        ),
        asked("target-angle", "A motor takes target angles", "mistake change-only"),
        given("level", "statement: The head is level"),
        asked("choose", "Choose the angle of the neck", "value"),
        asked("axis", "summary: The head is level", "mistake no-arctangent"),
        asked(
            "positive-left",
            "Positive angles turn the head to its left",
            "mistake wrong-way",
            "case something in the right part",
        ),
        given("column", "Column of the thing to look at"),
        given("angle-then", "while the picture was taken"),
        asked("vertical", "pixels are square", "mistake width-for-height"),
        given("size", "Size of the picture, pixels"),
        asked("radians", "The angle to set, radians", "mistake degrees"),
    ),
    visible=_visible,
    hidden=_hidden,
)
