"""Step 4: where several objects together would balance."""

from __future__ import annotations

import cv2
import numpy as np

from solutions._completion import Case, Completion, Part, Slip


def find_balance_point(mask: np.ndarray) -> tuple[float, float]:
    """Find where all regions of a mask together would balance.

    Parameters
    ----------
    mask : ndarray, uint8, shape (H, W)
        At least one region with an area; not zero inside.

    Returns
    -------
    x, y : float
        Column and row. A region weighs as much as the area inside of
        its contour; its holes are filled.
    """
    total = np.zeros(3)
    contours, _ = cv2.findContours(
        mask,
        cv2.RETR_EXTERNAL,
        cv2.CHAIN_APPROX_SIMPLE,
    )
    for contour in contours:
        m = cv2.moments(contour)  # open: the moments of this region
        total += m["m00"], m["m10"], m["m01"]
    x, y = total[1] / total[0], total[2] / total[0]  # open: balance point of the sums
    return x, y


def _choose(cases: tuple[Case, ...]) -> tuple[Case, ...]:
    return tuple(
        Case(case.label, (_punch(case.args[0]),)) for case in (cases[0], cases[1], cases[4])
    )


def _punch(mask: np.ndarray) -> np.ndarray:
    """Make a hole into the first region that is wide enough: pixels and area then differ."""
    mask = mask.copy()
    rows, columns = np.nonzero(cv2.erode(mask, np.ones((7, 7), np.uint8)))
    mask[rows[0] - 1 : rows[0] + 2, columns[0] - 1 : columns[0] + 2] = 0
    return mask


COMPLETION = Completion(
    title="where do they balance?",
    statement="A hand is to lift several things on one tray. It has to grip where they balance, "
    "each with its area as its weight: add up the moments of all regions, then divide as in the "
    "worked example.",
    section="step4-worked-moments",
    twin=find_balance_point,
    parts=(Part("point", "vector", "float", atol=1e-2, unit="px"),),
    cases=_choose,
    slips=(
        Slip(
            "whole-mask",
            "these are the moments of all white pixels, once for every region, and holes count as "
            "empty. Ask for the moments of the one contour.",
            line="m = cv2.moments(mask)",
        ),
        Slip(
            "row-first",
            "row and column are exchanged. m10 sums up x, the column, and m01 sums up y, the row; "
            "asked for is x before y.",
            line="x, y = total[2] / total[0], total[1] / total[0]",
        ),
    ),
    example="""\
reds = lab.segment_by_color(rgb, lab.HSV_RANGES["red"])
x, y = find_balance_point(reds)
show(lab.visualize_detection(rgb, (round(x), round(y)), reds), "the reds")""",
    imports=("import cv2", "import numpy as np"),
)
