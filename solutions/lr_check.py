"""Stereo: keep the matches that the other picture confirms."""

from __future__ import annotations

from typing import Any

import numpy as np

import labutils
from solutions._model import Absorbed, Case, Exercise, Misconception, Part, asked, given, told
from solutions._simpler import Simplification
from solutions._stereo_cases import make_disparity


def _answer_with(
    mistakes: frozenset[str],
    disparity_left: np.ndarray,
    disparity_right: np.ndarray,
    tolerance: float = 1.0,
) -> np.ndarray:
    height, width = disparity_left.shape
    columns = np.arange(width)
    known = np.isfinite(disparity_left)
    step = np.where(known, disparity_left, 0)
    place = columns + step if "other-direction" in mistakes else columns - step
    if "same-column" in mistakes:
        place = np.broadcast_to(columns, (height, width)).astype(float)
    place = (np.trunc(place) if "cut-off" in mistakes else np.floor(place + 0.5)).astype(int)
    inside = (place >= 0) & (place < width)
    if "comes-round" in mistakes:  # what a negative index does
        inside[:] = True
        place = np.where(place >= width, width - 1, place)
    there = np.clip(place, -width, width - 1) % width
    back = np.take_along_axis(disparity_right, there, axis=1)
    difference = back - disparity_left
    if "one-side" not in mistakes:
        difference = np.abs(difference)
    limit = 1.0 if "fixed-tolerance" in mistakes else tolerance
    if "nan-kept" in mistakes:
        kept = inside & ~(difference > limit)
        equal = ~np.isnan(difference) & (difference == limit)
    else:
        kept = inside & (difference <= limit)
        equal = difference == limit
    if "limit-excluded" in mistakes:
        kept &= ~equal
    return ~kept if "rejected-marked" in mistakes else kept


#: What disparities are beside whole pixels: no two of them make half a pixel with a column.
_PARTS = (-0.25, 0.0, 0.0, 0.25, 0.375)


def _make_case(
    rng: np.random.Generator, label: str, size: tuple[int, int, int], tolerance: float
) -> Case:
    """Make the disparities of a box before a wall for both pictures, with what matching leaves.

    Some matches are missing, some wrong, and many lie exactly at the tolerance. No column falls
    halfway between two.
    """
    height, width, count = size
    left = make_disparity(rng, height, width, count).astype(float)
    right = np.full(left.shape, np.nan)
    rows, columns = np.nonzero(np.arange(width) - left >= 0)
    order = np.argsort(left[rows, columns])  # the nearest last: it hides the others
    rows, columns = rows[order], columns[order]
    found = left[rows, columns]
    right[rows, columns - found.astype(int)] = found
    left += rng.choice(_PARTS, size=left.shape)
    right += rng.choice(_PARTS, size=left.shape)
    some = rng.random(left.shape)
    steps = np.array([-1, 1, -tolerance, tolerance])
    moved = left + rng.choice(steps, size=left.shape)
    right = np.where(some < 0.25, np.roll(moved, -2, axis=1), right)
    exact = (some > 0.4) & (some < 0.75)
    place = np.clip(np.floor(np.arange(width) - left + 0.5).astype(int), 0, width - 1)
    rows, columns = np.nonzero(exact)
    right[rows, place[rows, columns]] = left[rows, columns] + rng.choice(steps, size=len(rows))
    left[rng.random(left.shape) < 0.06] = np.nan
    right[rng.random(left.shape) < 0.06] = np.nan
    return Case(label, (left.astype(np.float32), right.astype(np.float32), tolerance))


def _make_cases(rng: np.random.Generator) -> tuple[Case, ...]:
    return (
        _make_case(rng, "a box before a wall, within 1 px", (18, 30, 9), 1.0),
        _make_case(rng, "a wider picture, within 0.5 px", (14, 42, 12), 0.5),
        _make_case(rng, "within 2 px", (16, 26, 7), 2.0),
    )


def _fill(args: dict[str, Any]) -> dict[str, Any]:
    return {
        name: np.where(np.isnan(args[name]), np.float32(3.0), args[name])
        for name in ("disparity_left", "disparity_right")
    }


def _round(args: dict[str, Any]) -> dict[str, Any]:
    return {name: np.floor(args[name]) for name in ("disparity_left", "disparity_right")}


def _stay_inside(args: dict[str, Any]) -> dict[str, Any]:
    """Take away the matches that lead out of the picture."""
    left = args["disparity_left"]
    leads_out = np.floor(np.arange(left.shape[1]) - left + 0.5) < 0
    return {"disparity_left": np.where(leads_out, np.float32(np.nan), left)}


EXERCISE = Exercise(
    name="lr_check",
    title="keep the matches that the other picture confirms",
    chapter="stereo",
    place=3,
    points=0,
    section="stereo-refine",
    objectives=("8b",),
    reference=labutils.lr_check,
    answer_with=_answer_with,
    parts=(Part("kept", "mask", "bool"),),
    tolerance_reason="a match is kept or not: nothing is nearly right",
    misconceptions=(
        Misconception(
            "same-column",
            "you compare the two pictures in the same column. The match of column u lies in "
            "column u - d of the right picture: look there.",
        ),
        Misconception(
            "other-direction",
            "you look for the partner at u + d. The right camera sees the point farther left: at "
            "u - d.",
        ),
        Misconception(
            "comes-round",
            "some matches lead out of the picture, and you keep them: a negative index counts from "
            "the right end. Reject what leads out.",
        ),
        Misconception(
            "nan-kept",
            "where a disparity is missing, you keep the match. Every comparison with NaN is False: "
            "ask for what is kept, not for what is rejected.",
        ),
        Misconception(
            "one-side",
            "a partner that is too small passes, however small it is. Compare the size of the "
            "difference, whatever its sign.",
        ),
        Misconception(
            "limit-excluded",
            "you reject differences that are exactly the tolerance. With whole pixels that is the "
            "most frequent one: keep it.",
        ),
        Misconception(
            "fixed-tolerance",
            "your limit is always 1 pixel. Use the argument `tolerance`.",
        ),
        Misconception(
            "cut-off",
            "you cut off the decimals of u - d. The nearest column is due: round.",
        ),
        Misconception(
            "rejected-marked",
            "your mask marks what is rejected. True has to say that a match is kept.",
        ),
    ),
    hints=(
        (
            "Take one pixel in column u with disparity d. In which column of the right picture is "
            "its partner, and what has to be true of the number you find there?"
        ),
        (
            "np.arange(W) - disparity_left is the column of every partner at once. Before you use "
            "it as an index, find out where it is a number and lies inside the picture."
        ),
        (
            "np.take_along_axis(disparity_right, columns, axis=1) looks up all partners. Put 0 "
            "where there is no column, and combine three masks: inside, both known, and agreed."
        ),
    ),
    example="""\
from labutils.recordings import load_recording

pair = load_recording("room").pairs[0]
left, right = (one[120:300:2, 160:440:2] for one in (pair.left, pair.right))
found = lab.ssd_disparity(left, right, 48)
mirrored = lab.ssd_disparity(right[:, ::-1], left[:, ::-1], 48)
show(lr_check(found, mirrored[:, ::-1]), "white is kept")""",
    contract=(
        told("always-answers", "A search always finds something"),
        asked("partner", "leads to a partner", "mistake other-direction", "mistake same-column"),
        told("twice", "there and back again"),
        asked("compare", "Compare the disparities", "mistake one-side", "mistake rejected-marked"),
        asked(
            "rejected",
            "A match that leads out of the picture",
            "mistake comes-round",
            "mistake nan-kept",
        ),
        asked("keep", "Keep the matches that the other picture confirms", "value"),
        asked("nearest", "rounded to the nearest one", "mistake cut-off"),
        asked("limit", "it may differ by the tolerance", "every case", "mistake limit-excluded"),
        given("nan", "Pixels; NaN where there is no match"),
        given("right", "The same of the right picture"),
        given("no-half", "No column u - d lies halfway"),
        asked("how-far", "How far the two may differ", "mistake fixed-tolerance"),
        asked("kept", "True where the match is kept", "value"),
        asked("out", "False where the left one leads", "mistake comes-round"),
    ),
    asks={
        "disparity_left": (
            "ndarray, float32, shape (H, W)\n"
            "Pixels; NaN where there is no match. No column u - d lies halfway between two."
        ),
        "disparity_right": (
            "ndarray, float32, shape (H, W)\n"
            "The same of the right picture: its column u is found in column u + d of the left one."
        ),
        "Raises": "",
        "References": "",
    },
    simpler=(
        Simplification("all-known", "no disparity is missing", _fill),
        Simplification("whole", "all disparities are whole pixels", _round),
        Simplification("inside", "no match leads out of the picture", _stay_inside),
    ),
    absorbed=tuple(
        Absorbed("same-column", other, "the same column is found without any step")
        for other in ("other-direction", "comes-round", "cut-off")
    ),
    visible=lambda: _make_cases(np.random.default_rng(83)),
    hidden=_make_cases,
)
