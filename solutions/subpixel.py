"""Stereo: disparities below a pixel, by a parabola through three costs."""

from __future__ import annotations

from typing import Any

import numpy as np

import labutils
from solutions._model import Absorbed, Case, Exercise, Misconception, Part, asked, given, told
from solutions._simpler import Simplification


def _answer_with(mistakes: frozenset[str], cost: np.ndarray, disparity: np.ndarray) -> np.ndarray:
    known = np.isfinite(disparity)
    whole = np.where(known, disparity, 0).astype(int)
    last = len(cost) - 1
    before, lowest, after = _take_costs(mistakes, cost, whole)
    bend = before - 2 * lowest + after
    if "pyramid" in mistakes:
        bend = np.maximum(before, after) - lowest
    with np.errstate(all="ignore"):
        offset = (before - after) / (bend if "twice-as-far" in mistakes else 2 * bend)
    if "infinite-lost" not in mistakes:
        offset[np.isinf(before) | np.isinf(after)] = 0
    if "flat-lost" not in mistakes:
        offset[bend == 0] = 0
    if not mistakes & {"ends-moved", "ends-wrap", "along-the-row"}:
        offset[(whole == 0) | (whole == last)] = 0
    if "not-refined" in mistakes:
        offset[:] = 0
    refined = whole - offset if "other-side" in mistakes else whole + offset
    if "nan-lost" not in mistakes:
        refined[~known] = np.nan
    return refined.astype(np.float32)


def _take_costs(
    mistakes: frozenset[str], cost: np.ndarray, whole: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the costs before, at and after the winner."""
    rows, columns = np.indices(whole.shape)
    if "along-the-row" in mistakes:
        width = cost.shape[2]
        sides = [np.clip(columns + step, 0, width - 1) for step in (-1, 1)]
        before, after = (cost[whole, rows, side] for side in sides)
    elif "ends-wrap" in mistakes:
        before, after = (cost[(whole + step) % len(cost), rows, columns] for step in (-1, 1))
    else:
        places = (np.clip(whole + step, 0, len(cost) - 1) for step in (-1, 1))
        before, after = (cost[place, rows, columns] for place in places)
    return before, cost[whole, rows, columns], after


def _make_case(
    rng: np.random.Generator, label: str, shape: tuple[int, int, int], *, window: int = 0
) -> Case:
    """Make costs whose smallest lies anywhere, at both ends too, with some flat pixels.

    With a window, what does not fit at the left is infinite, and some pixels have nothing that
    fits, as matching leaves them.
    """
    count, height, width = shape
    bowl = (np.arange(count)[:, None, None] - rng.uniform(-1, count, (height, width))) ** 2
    cost = 40 + 60 * bowl + rng.uniform(0, 150, shape)
    if window:
        cost[:, :, : window // 2] = np.inf
        for shift in range(count):
            cost[shift, :, : shift + window // 2] = np.inf
    winner = np.where(np.isfinite(cost.min(axis=0)), cost.argmin(axis=0), np.nan)
    for step in (-1, 1):  # two neighbors that cost the same: the minimum lies halfway
        v, u = np.nonzero((winner > 0) & (winner < count - 1) & (rng.random(winner.shape) < 0.1))
        d = winner[v, u].astype(int)
        cost[d + step, v, u] = cost[d, v, u]
    if not window:
        flat = rng.random((height, width)) < 0.08
        cost[:, flat] = 250.0
        winner[flat] = rng.integers(1, count - 1, np.count_nonzero(flat))
    return Case(label, (np.round(cost, 1).astype(np.float32), winner.astype(np.float32)))


def _make_cases(rng: np.random.Generator) -> tuple[Case, ...]:
    return (
        _make_case(rng, "8 candidates, in some pixels all equal", (8, 11, 14)),
        _make_case(rng, "12 candidates, of which not all fit at the left", (12, 9, 16), window=5),
        _make_case(rng, "a picture of one row", (6, 1, 24)),
    )


def _fill_finite(args: dict[str, Any]) -> dict[str, Any]:
    cost = args["cost"]
    disparity = args["disparity"]
    # More than any other cost, and never the same one twice.
    filler = 4000 + 100 * np.arange(len(cost))[::-1, None, None]
    cost = np.where(np.isinf(cost), filler, cost).astype(np.float32)
    return {"cost": cost, "disparity": np.where(np.isnan(disparity), cost.argmin(0), disparity)}


def _keep_middle(args: dict[str, Any]) -> dict[str, Any]:
    """Take away the winners at the ends: there, nothing matches any more."""
    disparity = args["disparity"]
    ends = (disparity == 0) | (disparity == len(args["cost"]) - 1)
    return {"disparity": np.where(ends, np.float32(np.nan), disparity)}


EXERCISE = Exercise(
    name="subpixel",
    title="refine disparities below a pixel",
    chapter="stereo",
    place=2,
    points=0,
    section="stereo-refine",
    objectives=("8b",),
    reference=labutils.subpixel,
    answer_with=_answer_with,
    parts=(Part("refined", "disparity", "float", atol=2e-3, unit="px"),),
    tolerance_reason=(
        "single precision loses up to a thousandth of a pixel where the parabola is nearly flat; "
        "a wrong formula is off by a tenth somewhere"
    ),
    misconceptions=(
        Misconception(
            "not-refined",
            "the disparities stay whole: the sub-pixel step is missing. Use the costs of the two "
            "neighbors as well.",
        ),
        Misconception(
            "other-side",
            "you move to the wrong side. The lowest point lies toward the neighbor with the "
            "smaller cost.",
        ),
        Misconception(
            "twice-as-far",
            "you move twice as far as you should. The slope of p x^2 + q x is 2 p x + q: do not "
            "lose its 2 when you look for where it is zero.",
        ),
        Misconception(
            "pyramid",
            "you put two straight lines through the costs. That suits sums of absolute "
            "differences; sums of squares follow a parabola.",
        ),
        Misconception(
            "ends-moved",
            "the first and the last candidate move, though a neighbor is missing. Where there are "
            "no three costs, leave the disparity as it is.",
        ),
        Misconception(
            "ends-wrap",
            "beside the first candidate you take the last one: in NumPy the index -1 is the end. "
            "Leave disparities at both ends as they are.",
        ),
        Misconception(
            "infinite-lost",
            "where a neighbor is infinite, you divide infinity by infinity and get NaN. Leave the "
            "disparity as it is there.",
        ),
        Misconception(
            "flat-lost",
            "where all three costs are equal, you divide 0 by 0 and get NaN. Leave the disparity "
            "as it is there.",
        ),
        Misconception(
            "nan-lost",
            "pixels without a match get a disparity. NaN says that there is none: let it stay NaN.",
        ),
        Misconception(
            "along-the-row",
            "you use the pixels at the left and at the right. The neighbors are those of the "
            "candidate: d - 1 and d + 1, in the same pixel.",
        ),
    ),
    hints=(
        (
            "Let x be 0 at the winner, -1 and 1 at its neighbors, with the costs a, b, c. Which "
            "p and q make p x^2 + q x + b go through all three?"
        ),
        (
            "q is half of c - a, p is half of a - 2 b + c, and the slope 2 p x + q is zero at "
            "x = -q / (2 p)."
        ),
        (
            "Get the costs of all winners at once with np.take_along_axis or with three index "
            "arrays. Decide with a mask where to move: both neighbors exist and are finite, and "
            "p is above 0."
        ),
    ),
    example="""\
from labutils.recordings import load_recording

pair = load_recording("room").pairs[0]
left, right = (one[120:300:2, 160:440:2] for one in (pair.left, pair.right))
found = lab.ssd_disparity(left, right, 48)
show(subpixel(lab.matching_cost(left, right, 48), found), "in pixels")""",
    contract=(
        told("whole-only", "Winner-takes-all knows whole pixels only"),
        told("between", "But the costs know more"),
        asked(
            "refine",
            "The place of its lowest point",
            "mistake not-refined",
            "mistake other-side",
            "mistake twice-as-far",
            "mistake pyramid",
        ),
        asked("three-costs", "Put a parabola through three", "every case", "mistake along-the-row"),
        asked("no-parabola", "no parabola to put", "case 8 candidates"),
        asked("summary", "Refine whole disparities", "value"),
        given("cost-of-each", "Cost of each of D candidates"),
        given("winners", "The candidates with the smallest cost"),
        asked(
            "stays",
            "A disparity stays as it is",
            "mistake ends-moved",
            "mistake ends-wrap",
            "mistake infinite-lost",
            "mistake flat-lost",
        ),
        asked("unit", "refined: Pixels.", "value"),
        asked("nan-stays", "NaN stays NaN", "mistake nan-lost"),
        asked("example", "[[1.75]]", "value"),
    ),
    asks={
        "Convention": "",
        "cost": (
            "ndarray, float32, shape (D, H, W)\n"
            "Cost of each of D candidates 0, 1, ..., D - 1; infinite where one does not fit."
        ),
        "disparity": (
            "ndarray, float32, shape (H, W)\n"
            "The candidates with the smallest cost, whole pixels; NaN where none fits."
        ),
        "Returns": (
            "refined : ndarray, float, shape (H, W)\n"
            "    Pixels. A disparity stays as it is where a neighbor is missing (at 0 and at "
            "D - 1)\n    or infinite, and where all three costs are equal. NaN stays NaN."
        ),
        "Raises": "",
        "References": "",
        "Examples": (
            ">>> cost = np.array([5.0, 2.0, 1.0, 4.0]).reshape(4, 1, 1)\n"
            ">>> subpixel(cost, np.array([[2.0]])).tolist()\n"
            "[[1.75]]"
        ),
    },
    simpler=(
        Simplification("all-fit", "every candidate fits everywhere", _fill_finite),
        Simplification("middle", "no winner is the first or the last candidate", _keep_middle),
    ),
    absorbed=(
        *(
            Absorbed("not-refined", other, "nothing moves, so it moves nowhere wrong")
            for other in (
                "other-side",
                "twice-as-far",
                "pyramid",
                "ends-moved",
                "ends-wrap",
                "infinite-lost",
                "flat-lost",
                "along-the-row",
            )
        ),
        Absorbed("ends-moved", "ends-wrap", "one cost stands for the missing one"),
        *(
            Absorbed(other, "along-the-row", "beside a pixel there is no end of the candidates")
            for other in ("ends-moved", "ends-wrap")
        ),
        Absorbed("flat-lost", "along-the-row", "the costs of three pixels are hardly ever equal"),
    ),
    visible=lambda: _make_cases(np.random.default_rng(82)),
    hidden=_make_cases,
)
