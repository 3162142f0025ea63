"""Stereo: the disparity of every pixel, by comparing windows."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np

import labutils
from solutions._model import Absorbed, Case, Exercise, Misconception, Part, asked, given, told
from solutions._simpler import Simplification
from solutions._stereo_cases import make_disparity, make_pair


def _answer_with(
    mistakes: frozenset[str],
    left: np.ndarray,
    right: np.ndarray,
    max_disparity: int,
    window: int = 9,
) -> np.ndarray:
    if "pictures-exchanged" in mistakes:
        left, right = right, left
    if "single-pixels" in mistakes:
        window = 1
    count = max_disparity // 2 if "few-candidates" in mistakes else max_disparity
    costs = np.stack(
        [_compare_shifted(mistakes, left, right, shift, window) for shift in range(count)]
    )
    # What was never compared must not win a search for the largest sum either.
    chosen = np.where(np.isinf(costs), -1, costs).argmax(axis=0)
    if "largest-wins" not in mistakes:
        chosen = costs.argmin(axis=0)
    compared = np.isfinite(costs)
    known = compared.all(axis=0) if "columns-lost" in mistakes else compared.any(axis=0)
    disparity = np.where(known, chosen, np.nan)
    if "sixteenths" in mistakes:
        disparity = disparity * 16
    return disparity.astype(np.float16)  # whole numbers of this size fit; tables stay small


def _compare_shifted(
    mistakes: frozenset[str], left: np.ndarray, right: np.ndarray, shift: int, window: int
) -> np.ndarray:
    """Return the costs of one candidate, infinite where it does not fit."""
    move = -shift if "searched-right" in mistakes else shift
    moved = np.roll(right, move, axis=1)
    first = left if "uint8-wraps" in mistakes else left.astype(np.int32)
    difference = first - moved  # of unsigned numbers, 3 - 5 is 254
    squares = difference.astype(np.float64) ** 2
    if "uint8-squares" in mistakes:
        squares %= 256
    cost = cv2.boxFilter(squares, -1, (window, window), normalize=False)
    if "comes-round" in mistakes:
        lost_left, lost_right = 0, 0
    elif "searched-right" in mistakes:
        lost_left, lost_right = 0, shift
    else:
        lost_left, lost_right = shift, 0
    half = 0 if "edges-guessed" in mistakes else window // 2
    height, width = cost.shape
    inside = np.zeros(cost.shape, dtype=bool)
    inside[half : height - half, half + lost_left : max(0, width - half - lost_right)] = True
    return np.where(inside, cost, np.inf)


#: Height, width, candidates and window of the visible cases.
_SIZES = (
    ("a box before a wall, 12 candidates, windows of 5 x 5", 28, 42, 12, 5),
    ("a higher picture, 16 candidates, windows of 7 x 7", 36, 34, 16, 7),
    ("8 candidates, windows of 3 x 3", 28, 36, 8, 3),
)


def _make_case(
    rng: np.random.Generator, label: str, height: int, width: int, count: int, window: int
) -> Case:
    return Case(label, (*make_pair(rng, make_disparity(rng, height, width, count)), count, window))


def _visible() -> tuple[Case, ...]:
    rng = np.random.default_rng(81)
    return tuple(_make_case(rng, *size) for size in _SIZES)


def _hidden(rng: np.random.Generator) -> tuple[Case, ...]:
    cases = []
    for number, window in enumerate((3, 5, 7, 9)):
        height, width = map(int, rng.integers((40, 52), (58, 70)))
        count = int(rng.integers(8, 17))
        cases.append(_make_case(rng, f"pair {number + 1}", height, width, count, window))
    return tuple(cases)


def _to_floats(args: dict[str, Any]) -> dict[str, Any]:
    return {name: args[name].astype(np.float64) for name in ("left", "right")}


def _put_at_one_depth(args: dict[str, Any]) -> dict[str, Any]:
    """Show one wall without noise, two columns farther left in the right picture."""
    return {"left": np.roll(args["right"], 2, axis=1)}


EXERCISE = Exercise(
    name="ssd_disparity",
    title="find the disparity of every pixel",
    chapter="stereo",
    place=1,
    points=0,
    section="stereo-match",
    objectives=("8a",),
    reference=labutils.ssd_disparity,
    answer_with=_answer_with,
    parts=(Part("disparity", "disparity", "float", atol=0.01, share=0.006, unit="px"),),
    tolerance_reason=(
        "disparities are whole pixels, so nothing is nearly right; in single precision a running "
        "sum may let the wrong one of two nearly equal candidates win, in fewer than 6 of 1000 "
        "pixels"
    ),
    misconceptions=(
        Misconception(
            "searched-right",
            "you look for the match farther right. The right camera sees every point farther left "
            "than the left one does: compare column u with column u - d.",
        ),
        Misconception(
            "pictures-exchanged",
            "left and right are exchanged: nearly nothing fits. The pixels to answer for are those "
            "of the left picture; their matches lie in the right one.",
        ),
        Misconception(
            "columns-lost",
            "the columns at the left get NaN wherever one candidate does not fit. Leave out that "
            "candidate only: the smaller ones may win there.",
            section="stereo-fails",
        ),
        Misconception(
            "few-candidates",
            "near things are wrong: the search ends at half of max_disparity. Try every candidate "
            "up to max_disparity - 1.",
            section="stereo-fails",
        ),
        Misconception(
            "sixteenths",
            "your disparities are 16 times too large, like the int16 numbers of OpenCV's matchers, "
            "which count sixteenths of a pixel: divide by 16.",
        ),
        Misconception(
            "largest-wins",
            "you take the candidate that fits worst. A sum of squared differences is a cost: the "
            "smallest one wins.",
        ),
        Misconception(
            "single-pixels",
            "you compare single pixels. One gray value fits in many places: add up the squares of "
            "the whole window.",
        ),
        Misconception(
            "uint8-wraps",
            "you subtract uint8 numbers, and 3 - 5 is 254 there. Convert the pictures to float "
            "before you subtract.",
        ),
        Misconception(
            "uint8-squares",
            "you square uint8 numbers, and 20 * 20 is 144 there. Convert the differences to float "
            "before you square them.",
        ),
        Misconception(
            "edges-guessed",
            "windows that reach beyond a picture give an answer, too. What is not there was never "
            "measured: answer NaN where the window is not complete.",
        ),
        Misconception(
            "comes-round",
            "np.roll brings the columns at one side back at the other. A window there is compared "
            "with the far end of the picture: leave such candidates out.",
        ),
    ),
    hints=(
        (
            "Take one candidate d. Which columns of the left picture have a partner d columns "
            "farther left, and how do you subtract the two pictures there at once?"
        ),
        (
            "Square the difference, then add up each window: cv2.boxFilter with normalize=False "
            "does it for all pixels. Mark with np.inf what has no complete window."
        ),
        (
            "Stack the sums of all candidates and take np.argmin along the candidates. Where every "
            "sum is infinite, the answer is NaN."
        ),
    ),
    example="""\
from labutils.recordings import load_recording

pair = load_recording("room").pairs[0]
left, right = (one[120:300:2, 160:440:2] for one in (pair.left, pair.right))
show(left, "a part of the left picture, every second pixel")
show(ssd_disparity(left, right, max_disparity=48), "disparity in pixels")""",
    contract=(
        told("same-way", "Two cameras look the same way"),
        asked(
            "to-the-left",
            "is found in column u - d",
            "mistake searched-right",
            "mistake pictures-exchanged",
        ),
        told("find-it", "Find this d"),
        asked("sum-squares", "add up the squared differences", "mistake single-pixels"),
        asked("smallest", "The smallest sum says", "mistake largest-wins"),
        asked(
            "complete",
            "Only complete windows count",
            "mistake edges-guessed",
            "mistake comes-round",
        ),
        asked("fewer", "Near the left edge fewer candidates", "mistake columns-lost"),
        told("uint8", "The pictures may hold uint8"),
        asked(
            "negative-too", "so subtract and square", "mistake uint8-wraps", "mistake uint8-squares"
        ),
        asked("find", "Find the disparity of every pixel", "value"),
        asked("candidates", "For each candidate 0, 1", "every case", "mistake few-candidates"),
        told("wins", "The candidate with the smallest sum wins"),
        given("gray", "Gray pictures of a rectified pair"),
        given("how-many", "How many candidates are tried"),
        given("odd", "Height and width of the window"),
        asked("whole", "Whole pixels; NaN where", "mistake sixteenths"),
        asked("example", ".tolist()", "value"),
    ),
    asks={
        "max_disparity": "int\nHow many candidates are tried, at least 2.",
        "Returns": (
            "ndarray, float, shape (H, W)\n"
            "    Whole pixels; NaN where no candidate has both windows inside the pictures."
        ),
        "Raises": "",
        "References": "",
        "Examples": (
            ">>> right = np.tile(np.arange(12.0) ** 2, (3, 1))\n"
            ">>> left = np.roll(right, 2, axis=1)\n"
            ">>> ssd_disparity(left, right, max_disparity=4, window=3)[1, 3:8].tolist()\n"
            "[2.0, 2.0, 2.0, 2.0, 2.0]"
        ),
    },
    simpler=(
        Simplification("floats", "the pictures hold floats instead of uint8", _to_floats),
        Simplification("one-depth", "everything is equally far away", _put_at_one_depth),
    ),
    absorbed=(
        Absorbed(
            "columns-lost", "comes-round", "where the pictures come round, every candidate fits"
        ),
        Absorbed("single-pixels", "edges-guessed", "a single pixel never reaches beyond the edge"),
        Absorbed("uint8-wraps", "uint8-squares", "256 off before squaring is 0 off in uint8 after"),
    ),
    visible=_visible,
    hidden=_hidden,
)
