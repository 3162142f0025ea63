"""Step 4: two ranges of color in one mask."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import cv2

from solutions._completion import Case, Completion, Part, Slip

if TYPE_CHECKING:
    import numpy as np


def find_either_color(rgb_image: np.ndarray, first: Any, second: Any) -> np.ndarray:
    """Mark the pixels whose color lies in one of two HSV ranges.

    Parameters
    ----------
    rgb_image : ndarray, uint8, shape (H, W, 3)
        The picture, RGB.
    first, second : ((h, s, v), (h, s, v))
        Low and high limits, which belong to the range. Neither
        range wraps through red.

    Returns
    -------
    ndarray, uint8, shape (H, W)
        255 where a pixel is in one of the ranges, else 0.
    """
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)  # open: the picture in HSV
    one = cv2.inRange(hsv, *first)
    other = cv2.inRange(hsv, *second)
    mask = cv2.bitwise_or(one, other)  # open: white where one of the two is white
    return mask


def _choose(cases: tuple[Case, ...]) -> tuple[Case, ...]:
    _, green, yellow, blue = cases[:4]
    return (
        Case("green or blue", (green.args[0], green.args[1], blue.args[1])),
        Case("yellow or green", (yellow.args[0], yellow.args[1], green.args[1])),
    )


COMPLETION = Completion(
    title="one of two colors",
    statement="A robot sorts green and blue things into the same box, so it looks for both "
    "ranges at once, as on the strip of the worked example. This time it is a whole "
    "picture, in RGB.",
    section="step4-worked-range",
    twin=find_either_color,
    parts=(Part("mask", "mask", "uint8", atol=0, share=0.001, values=(0, 255)),),
    cases=_choose,
    slips=(
        Slip(
            "read-as-bgr",
            "red and blue were exchanged before the hue was computed. The picture is RGB, so the "
            "conversion has to begin with RGB.",
            line="hsv = cv2.cvtColor(rgb_image, cv2.COLOR_BGR2HSV)",
        ),
        Slip(
            "both-at-once",
            "nothing is found: no pixel has both colors at once. Join the masks with the word "
            "that stands in the sentence, or.",
            line="mask = cv2.bitwise_and(one, other)",
        ),
    ),
    example="""\
green, blue = lab.HSV_RANGES["green"], lab.HSV_RANGES["blue"]
show(find_either_color(rgb, green, blue), "green or blue")""",
    imports=("import cv2",),
)
