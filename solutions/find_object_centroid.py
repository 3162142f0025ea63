"""Step 4: where the largest object is."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np

import labutils
from solutions._cases import make_mask
from solutions._model import Absorbed, Case, Exercise, Misconception, Part, asked, given, told
from solutions._simpler import Simplification
from solutions.completions.find_object_centroid import COMPLETION


def _answer_with(mistakes: frozenset[str], mask: np.ndarray) -> Any:
    mask = mask.astype(np.uint8)
    contours, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    choose = min if "not-the-largest" in mistakes else max
    guarded = "no-empty-case" not in mistakes
    if guarded and not contours:
        return None
    # The largest of nothing is a ValueError.
    region = mask if "all-regions" in mistakes else choose(contours, key=cv2.contourArea)
    moments = cv2.moments(region)
    if guarded and moments["m00"] == 0:
        return None
    x, y = moments["m10"] / moments["m00"], moments["m01"] / moments["m00"]  # ZeroDivisionError
    if "box-center" in mistakes:
        left, top, wide, high = cv2.boundingRect(region)
        x, y = left + (wide - 1) / 2, top + (high - 1) / 2
    if "fractions" not in mistakes:
        x, y = int(x), int(y)
    return (y, x) if "row-column" in mistakes else (x, y)


def _make_line(height: int, width: int) -> np.ndarray:
    mask = np.zeros((height, width), dtype=np.uint8)
    mask[height // 3, 4 : width // 2] = 255
    return mask


def _make_bar(rng: np.random.Generator) -> np.ndarray:
    """Make a compact region and a long thin one, whose outline is longer and whose area smaller."""
    mask = np.zeros((34, 50), dtype=np.uint8)
    side, length = int(rng.integers(11, 14)), int(rng.integers(38, 44))
    top, left = map(int, rng.integers((3, 4), (8, 30)))
    mask[top : top + side, left : left + side] = 255
    mask[28:30, 3 : 3 + length] = 255
    return mask if rng.random() < 0.5 else mask.T.copy()


def _make_small(rng: np.random.Generator) -> np.ndarray:
    """Make a region of a few pixels, and a dot before and behind it."""
    mask = np.zeros((18, 24), dtype=np.uint8)
    top, left = map(int, rng.integers((4, 3), (8, 16)))
    mask[top : top + 5, left : left + 6] = 255
    mask[[1, 15], [left + 4, left - 1]] = 255
    return mask


def _visible() -> tuple[Case, ...]:
    rng = np.random.default_rng(61)
    return (
        Case("a large region and two small ones", (make_mask(rng, 48, 70),)),
        Case("a picture that is higher than wide, 1 inside", (make_mask(rng, 78, 52) // 255,)),
        Case("an empty mask", (np.zeros((20, 30), dtype=np.uint8),)),
        Case("a line of one pixel's width, which has no area", (_make_line(20, 30),)),
        Case("a long thin region beside a compact one", (_make_bar(rng),)),
        Case("a small region and two specks of one pixel", (_make_small(rng),)),
    )


def _hidden(rng: np.random.Generator) -> tuple[Case, ...]:
    height, width = map(int, rng.integers(40, 90, size=2))
    return (
        Case("wide", (make_mask(rng, 50, 80),)),
        Case("high", (make_mask(rng, 84, 56),)),
        Case("1 inside", (make_mask(rng, 60, 90)[:, ::-1] // 255,)),
        Case("empty", (np.zeros((height, width), dtype=np.uint8),)),
        Case("a line", (_make_line(height, width),)),
        Case("long and thin", (_make_bar(rng),)),
        Case("small", (_make_small(rng),)),
    )


def _keep_largest(args: dict[str, Any]) -> dict[str, Any]:
    count, labels, stats, _ = cv2.connectedComponentsWithStats(args["mask"])
    largest = 1 + np.argmax(stats[1:, cv2.CC_STAT_AREA]) if count > 1 else 0
    return {"mask": np.where(labels == largest, args["mask"], 0).astype(np.uint8)}


def _fill_box(args: dict[str, Any]) -> dict[str, Any]:
    mask = _keep_largest(args)["mask"]
    left, top, wide, high = cv2.boundingRect(mask)
    filled = np.zeros_like(mask)
    if min(wide, high) > 1:
        filled[top : top + high, left : left + wide] = mask.max()
    return {"mask": filled}


EXERCISE = Exercise(
    name="find_object_centroid",
    title="find the center of the largest object",
    chapter="step4",
    place=2,
    points=8,
    section="step4-clean",
    objectives=("4d",),
    reference=labutils.find_object_centroid,
    answer_with=_answer_with,
    simpler=(
        Simplification("one-region", "there is one region only", _keep_largest),
        Simplification("rectangle", "the object is a rectangle", _fill_box),
    ),
    parts=(
        Part(
            "centroid",
            "pixel",
            "int",
            atol=1,
            unit="px",
            nullable=True,
            note="None stands for: no object, or one without area",
        ),
    ),
    tolerance_reason=(
        "one pixel: the mean of the pixels and the moments of the outline differ by less, and "
        "rounding down or to the nearest is free; every mistake is several pixels off"
    ),
    misconceptions=(
        Misconception(
            "row-column",
            "your answer is (row, column). cv2 draws at (x, y): the column comes first, although "
            "arrays are indexed [y, x].",
        ),
        Misconception(
            "all-regions",
            "you take the center of everything white, which lies between the objects. Keep the "
            "contour with the largest area only.",
        ),
        Misconception(
            "not-the-largest",
            "you take a small region, not the largest. The order of contours means nothing: "
            "choose by cv2.contourArea.",
        ),
        Misconception(
            "box-center",
            "this is the middle of the bounding box. The center of mass of a lopsided shape lies "
            "elsewhere: divide m10 and m01 by m00.",
        ),
        Misconception(
            "fractions",
            "the place is right, but it is given in fractions. cv2.circle takes whole pixels: "
            "return two ints.",
        ),
        Misconception(
            "no-empty-case",
            "a mask without an object stops your program. Ask for it first, and return None; also "
            "where the area m00 is zero.",
        ),
    ),
    hints=(
        (
            "cv2.findContours gives one outline per region. What does max need to know to find the "
            "largest of them?"
        ),
        "cv2.moments counts area (m00) and area times place (m10, m01). What is the mean place?",
        (
            "What should a robot hear when there is nothing to see? Think of an empty mask, and "
            "of a line without any area."
        ),
    ),
    example="""\
mask = lab.segment_by_color(rgb, lab.HSV_RANGES["red"])
centroid = find_object_centroid(mask)
show(centroid, "center (x, y) of the largest red object")
show(lab.visualize_detection(rgb, centroid, mask))""",
    contract=(
        given("several", "A mask may show several regions"),
        asked(
            "largest",
            "Return the center of mass",
            "every case",
            "mistake not-the-largest",
            "mistake all-regions",
            "mistake box-center",
            "mistake fractions",
        ),
        asked(
            "nothing",
            "Where there is nothing to find",
            "mistake no-empty-case",
            "case an empty mask",
        ),
        asked("find", "Find the center of the largest object", "value"),
        asked("column-first", "column first", "mistake row-column"),
        told("index", "Index an array with"),
        asked(
            "not-zero",
            "Anything not zero is inside",
            "case a picture that is higher than wide, 1 inside",
        ),
        asked(
            "largest-area",
            "Center of mass of the external contour",
            "value",
            "mistake box-center",
            "case a long thin region",
        ),
        asked(
            "none-where",
            "None where there is no contour",
            "case a line",
            "case a small region",
            "mistake no-empty-case",
        ),
    ),
    visible=_visible,
    hidden=_hidden,
    imports=("import cv2", "import numpy as np"),
    asks={
        "mask": "ndarray, uint8, shape (H, W)\nAnything not zero is inside.",
        "Returns": (
            "tuple of int, or None\n"
            "    Center of mass of the external contour with the largest area, in whole pixels; "
            "one pixel off is right, so rounding is free. None where there is no contour, or the "
            "largest has no area (a line, a dot)."
        ),
        "Raises": "",
    },
    absorbed=(
        Absorbed(
            "all-regions",
            "not-the-largest",
            "the center of all regions does not depend on which of them is chosen",
        ),
    ),
    completion=COMPLETION,
)
