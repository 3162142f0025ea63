"""Step 2: the intrinsic matrix of an ideal camera."""

from __future__ import annotations

import numpy as np

import labutils
from solutions._model import Case, Exercise, Misconception, Part, asked, given, told
from solutions.completions.intrinsics_matrix import COMPLETION


def _answer_with(mistakes: frozenset[str], fov_y: float, width: int, height: int) -> np.ndarray:
    angle = np.deg2rad(fov_y) if "radians-again" in mistakes else fov_y
    half = angle if "whole-angle" in mistakes else angle / 2
    side = width if "width-for-height" in mistakes else height
    focal = side / np.tan(half)
    if "twice-as-long" not in mistakes:
        focal /= 2
    edge = 0 if "half-pixel" in mistakes else 1
    center = ((width - edge) / 2, (height - edge) / 2)
    if "center-swapped" in mistakes:
        center = center[::-1]
    K = np.array([[focal, 0.0, center[0]], [0.0, focal, center[1]], [0.0, 0.0, 1.0]])
    return K.T if "transposed" in mistakes else K


def _visible() -> tuple[Case, ...]:
    return (
        Case("a picture that is wider than high", (0.9, 64, 48)),
        Case("a picture that is higher than wide, odd sizes", (1.3, 33, 57)),
        Case("the size of the lab, a narrow angle", (0.55, 640, 480)),
        Case("a line camera: one column", (0.7, 1, 40)),
        Case("an angle of more than 90 degrees", (1.9, 50, 38)),
    )


def _hidden(rng: np.random.Generator) -> tuple[Case, ...]:
    pictures = tuple(
        Case(
            f"picture {number + 1}",
            (
                round(float(rng.uniform(0.3, 1.45)), 6),
                int(rng.integers(200, 900)),
                int(rng.integers(30, 180)),
            ),
        )
        for number in range(5)
    )
    column = Case("one column", (0.9, 1, int(rng.integers(30, 180))))
    wide = Case("a wide angle", (round(float(rng.uniform(1.7, 2.4)), 6), 200, 150))
    return (*pictures, column, wide)


EXERCISE = Exercise(
    name="intrinsics_matrix",
    title="build K from a vertical field of view",
    chapter="step2",
    place=1,
    points=7,
    section="step2-focal",
    objectives=("2a", "2b", "2c"),
    reference=labutils.intrinsics_matrix,
    answer_with=_answer_with,
    parts=(Part("K", "matrix", "float", atol=1e-3, unit="px"),),
    tolerance_reason=(
        "a thousandth of a pixel is ten times the rounding of float32 for the longest focal "
        "length asked, and 500 times below the smallest mistake, half a pixel"
    ),
    misconceptions=(
        Misconception(
            "half-pixel",
            "your center is W/2 and H/2. Pixel centers are whole numbers, from 0 to W-1: their "
            "middle lies half a pixel before W/2.",
            section="step2-center",
        ),
        Misconception(
            "radians-again",
            "fov_y is in radians already. Converting it from degrees once more makes the angle "
            "tiny and the focal length huge.",
        ),
        Misconception(
            "whole-angle",
            "the tangent takes half the field of view: the right triangle reaches from the "
            "optical axis to one edge, not from edge to edge.",
        ),
        Misconception(
            "twice-as-long",
            "your focal length is twice what it has to be. Half of the angle faces half of the "
            "picture's height, not all of it.",
        ),
        Misconception(
            "width-for-height",
            "the angle is the vertical one, so the height belongs to it. With square pixels the "
            "same focal length then serves x.",
        ),
        Misconception(
            "center-swapped",
            "cx and cy are exchanged. The first row makes u, the column, so it holds the middle "
            "of the width.",
            section="step2-center",
        ),
        Misconception(
            "transposed",
            "your matrix is transposed. K multiplies a column (x, y, z): the center stands in the "
            "last column, not in the last row.",
        ),
    ),
    hints=(
        (
            "Draw the camera from the side: the optical axis, half the picture, half the angle. "
            "Which function of an angle joins the two legs of a right triangle?"
        ),
        (
            "Pixels are square, so one focal length serves both rows. It follows from the height, "
            "because the angle is the vertical one."
        ),
        (
            "Number the centers of four pixels in a row from 0. Where is their middle? That is the "
            "principal point of a picture four pixels wide."
        ),
    ),
    example="""\
K_mine = intrinsics_matrix(fov_y, 640, 480)
show(K_mine, "K, in pixels")
ball, eye = data.body("red_ball"), data.camera("head_camera")
point = lab.world_to_camera(ball.xpos[None], eye.xpos, eye.xmat)
u, v = np.rint(lab.points_to_pixels(point, K_mine)[0]).astype(int)
show(lab.visualize_detection(rgb, (u, v)), "K finds the ball")""",
    contract=(
        given("given-by", "The simplest camera is given by"),
        asked(
            "ideal",
            "Its pixels are square, and its optical axis",
            "mistake width-for-height",
            "mistake center-swapped",
        ),
        asked("projects", "Write the matrix K", "every case", "mistake twice-as-long"),
        told("middle-question", "Where is the middle?"),
        asked("pixel-centers", "Whole numbers are pixel centers", "mistake half-pixel"),
        asked("build", "Build the intrinsic matrix of an ideal camera", "mistake whole-angle"),
        asked(
            "middle", "so the middle of W pixels is at", "mistake half-pixel", "case a line camera"
        ),
        asked("square", "Pixels are square: fx = fy", "mistake width-for-height"),
        asked(
            "radians",
            "Vertical field of view in radians",
            "mistake radians-again",
            "case an angle of more than 90 degrees",
        ),
        given("size", "Picture size in pixels"),
        asked("layout", "[[f, 0, cx]", "mistake transposed"),
        asked("example", "240. ,   0. , 319.5", "value"),
    ),
    visible=_visible,
    hidden=_hidden,
    asks={
        "Returns": (
            "ndarray, float, shape (3, 3)\n    ``[[f, 0, cx], [0, f, cy], [0, 0, 1]]`` in pixels."
        ),
        "Raises": "",
    },
    completion=COMPLETION,
)
