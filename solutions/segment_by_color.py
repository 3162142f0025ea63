"""Step 4: a mask of one color."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np

import labutils
from solutions._cases import hsv_to_rgb, make_color_scene
from solutions._model import Absorbed, Case, Exercise, Misconception, Part, asked, given
from solutions._simpler import Simplification
from solutions.completions.segment_by_color import COMPLETION

Color = tuple[int, int, int]


def _answer_with(mistakes: frozenset[str], rgb_image: np.ndarray, target_hsv_range: Any) -> Any:
    code = cv2.COLOR_BGR2HSV if "bgr" in mistakes else cv2.COLOR_RGB2HSV
    hsv = cv2.cvtColor(rgb_image, code).astype(np.int64)
    if "hue-in-degrees" in mistakes:
        hsv[..., 0] *= 2
    low, high = np.array(target_hsv_range)
    if "limits-excluded" in mistakes:
        above, below = hsv > low, hsv < high
    else:
        above, below = hsv >= low, hsv <= high
    hue = above[..., 0] & below[..., 0]
    if low[0] > high[0] and "no-wrap" not in mistakes:
        hue = above[..., 0] | below[..., 0]
    inside = hue & (above & below)[..., 1:].all(axis=2)
    mask = inside.astype(np.uint8) * 255
    if "no-cleaning" in mistakes:
        return mask
    kernel = np.ones((3, 3) if "small-kernel" in mistakes else (5, 5), np.uint8)
    steps = [cv2.MORPH_OPEN, cv2.MORPH_CLOSE]
    if "close-first" in mistakes:
        steps.reverse()
    for step in steps:
        mask = cv2.morphologyEx(mask, step, kernel)
    return mask


def _make_cases(rng: np.random.Generator) -> tuple[Case, ...]:
    """Ask for colors of the picture whose limits are met exactly by some of its pixels."""
    cases = []
    for label, low, high in (
        ("red, which wraps around hue 0", 177, 2),
        ("green", 60, 90),
        ("yellow and orange", 14, 30),
        ("blue", 106, 121),
    ):
        height, width = map(int, rng.integers((48, 60), (58, 76)))
        limits = ((low, int(rng.integers(90, 120)), int(rng.integers(60, 110))), (high, 255, 255))
        cases.append(Case(label, (make_color_scene(rng, height, width), limits)))
    return (*cases, *(_make_patches(rng, *one) for one in _PATCHES))


#: What it shows, limits, and the colors of patches, each as far from every limit as it can be.
_PATCHES: tuple[tuple[str, tuple[Color, Color], tuple[Color, ...]], ...] = (
    (
        "pale and bright red: too strong, too pale, too dark or too bright is none",
        ((170, 40, 160), (8, 120, 235)),
        (
            (176, 80, 200),
            (0, 80, 200),
            *((hue, *rest) for hue in (176, 0) for rest in ((180, 200), (15, 200))),
            *((hue, *rest) for hue in (176, 0) for rest in ((80, 100), (80, 252))),
            (40, 80, 200),
        ),
    ),
    (
        "strong and dark blue, any value from 0 on",
        ((100, 180, 0), (130, 255, 140)),
        ((115, 220, 90), (115, 120, 90), (115, 220, 190), (85, 220, 90), (150, 220, 90)),
    ),
    (
        "one exact color",
        ((60, 255, 255), (60, 255, 255)),
        ((60, 255, 255), (120, 255, 255), (0, 255, 255), (30, 255, 255), (60, 200, 255)),
    ),
)


def _make_patches(
    rng: np.random.Generator, label: str, limits: tuple[Color, Color], colors: tuple[Color, ...]
) -> Case:
    """Make one square per color, in any order, on gray.

    Where hues wrap, the last square has one on either side of the seam: who cleans the halves apart
    loses it, for each is too narrow.
    """
    squares = [(color, color) for color in rng.permutation(np.array(colors))]
    if limits[0][0] > limits[1][0]:
        squares.append((np.array(colors[0]), np.array(colors[1])))
    rows = np.full((10 * ((len(squares) + 3) // 4), 40, 3), (0, 0, 128), dtype=np.uint8)
    for number, (left_half, right_half) in enumerate(squares):
        top, left = number // 4 * 10, number % 4 * 10
        side = int(rng.integers(6, 9))
        rows[top + 1 : top + side, left + 1 : left + 5] = left_half
        rows[top + 1 : top + side, left + 5 : left + 9] = right_half
    return Case(label, (hsv_to_rgb(rows), limits))


_NOT_CLEANED = "a mask that is not cleaned has no kernel and no order"


def _smooth(args: dict[str, Any]) -> dict[str, Any]:
    """Paint specks and holes over, with a color from outside or inside the range."""
    rgb = args["rgb_image"]
    raw = _answer_with(frozenset({"no-cleaning"}), rgb, args["target_hsv_range"])
    clean = _answer_with(frozenset(), rgb, args["target_hsv_range"])
    for wanted in (0, 255):
        known = (raw == wanted) & (clean == wanted)
        if known.any():
            rgb[(raw != wanted) & (clean == wanted)] = rgb[known][0]
    return {"rgb_image": rgb}


EXERCISE = Exercise(
    name="segment_by_color",
    title="mark the pixels of one color",
    chapter="step4",
    place=1,
    points=12,
    section="step4-hsv",
    objectives=("4a", "4b", "4c"),
    reference=labutils.segment_by_color,
    answer_with=_answer_with,
    simpler=(Simplification("no-specks", "there is no speck and no hole", _smooth),),
    parts=(Part("mask", "mask", "uint8", atol=0, share=0.001, values=(0, 255)),),
    tolerance_reason=(
        "one pixel in a thousand: conversions of one's own may round a hue differently at a limit; "
        "every mistake changes whole objects or their outlines"
    ),
    misconceptions=(
        Misconception(
            "bgr",
            "red and blue are exchanged before you look at the hue: the picture is RGB, so convert "
            "it with cv2.COLOR_RGB2HSV.",
        ),
        Misconception(
            "no-wrap",
            "red is missing. Its hues lie on both sides of 0: where the low hue is larger than the "
            "high one, take hues above low OR below high.",
            section="step4-red-wrap",
        ),
        Misconception(
            "hue-in-degrees",
            "your hues go up to 359. OpenCV's 8-bit hue is degrees halved, 0 to 179, and the "
            "limits are given in these units.",
        ),
        Misconception(
            "no-cleaning",
            "the specks and holes are still there. Open the mask, then close it, with a kernel of "
            "5x5 ones.",
            section="step4-clean",
        ),
        Misconception(
            "close-first",
            "you close before you open: closing joins specks to objects, and opening cannot part "
            "them again. Open first.",
            section="step4-clean",
        ),
        Misconception(
            "limits-excluded",
            "pixels exactly at a limit are left out. The limits belong to the range: use <= and "
            ">=, as cv2.inRange does.",
        ),
        Misconception(
            "small-kernel",
            "your kernel is 3x3: specks survive that 5x5 ones remove. Use np.ones((5, 5), "
            "np.uint8).",
            section="step4-clean",
        ),
    ),
    hints=(
        (
            "Convert, compare, clean: three lines of cv2. In which order do the channels of the "
            "picture come?"
        ),
        (
            "A low hue of 174 and a high hue of 3 is no mistake in the call: red lies on both "
            "sides of zero. Which two ranges does it consist of?"
        ),
        (
            "Opening removes what is smaller than the kernel, closing fills what is smaller. "
            "Which of the two has to come first if specks must not grow?"
        ),
    ),
    example="""\
mask = segment_by_color(rgb, lab.HSV_RANGES["red"])
show({"picture": rgb, "red": mask})""",
    contract=(
        asked(
            "mark",
            "Mark the pixels whose hue",
            "every case",
            "mistake no-cleaning",
            "mistake close-first",
            "mistake small-kernel",
            "mistake limits-excluded",
        ),
        asked("red", "Red is cut in two", "mistake no-wrap", "case red"),
        asked("clean", "cleaned of specks and holes", "value", "mistake no-cleaning"),
        asked(
            "units",
            "OpenCV's 8-bit HSV",
            "mistake hue-in-degrees",
            "case pale and bright red",
            "case strong and dark blue",
        ),
        asked(
            "inclusive", "Limits are inclusive", "mistake limits-excluded", "case one exact color"
        ),
        asked("wraps", "wraps through red", "mistake no-wrap"),
        asked("rgb", "RGB (not BGR)", "mistake bgr"),
        given("limits", "Low and high limits"),
        asked(
            "levels",
            "255 inside, 0 outside",
            "range",
            "mistake small-kernel",
            "mistake close-first",
        ),
    ),
    visible=lambda: _make_cases(np.random.default_rng(51)),
    hidden=_make_cases,
    imports=("import cv2", "import numpy as np"),
    asks={
        "rgb_image": "ndarray, uint8, shape (H, W, 3)\nThe picture, RGB (not BGR).",
        "Raises": "",
    },
    absorbed=(
        Absorbed("no-cleaning", "close-first", _NOT_CLEANED),
        Absorbed("no-cleaning", "small-kernel", _NOT_CLEANED),
    ),
    completion=COMPLETION,
)
