"""Challenge of step 6: draw a cloud as a map, seen from above."""

from __future__ import annotations

from typing import Any

import numpy as np

from solutions._model import Absorbed, Case, Exercise, Misconception, Part, asked, given, told
from solutions._simpler import Simplification


def draw_top_view(
    points_world: np.ndarray,
    colors: np.ndarray,
    low: np.ndarray,
    high: np.ndarray,
    pixels_per_meter: int,
) -> np.ndarray:
    """Draw a cloud as a map, seen from straight above.

    The robot looks along x, so x points up in the picture; y points to its left, so y points left.
    A point at (x, y) falls into row floor((high_x - x) * pixels_per_meter) and column
    floor((high_y - y) * pixels_per_meter). Of several points in one pixel the highest is seen.
    Points outside the map are left out; where no point is, the map is black.

    Parameters
    ----------
    points_world : ndarray, float64, (N, 3)
        Points in the world (x forward, y left, z up), meters.
    colors : ndarray, float64, (N, 3)
        RGB from 0 to 1 per point.
    low, high : ndarray, float64, (2,)
        Limits (x, y) of the map, meters.
    pixels_per_meter : int
        Scale; the map has (high - low) * pixels_per_meter rows and columns, rounded.

    Returns
    -------
    ndarray, uint8, (H, W, 3)
        RGB, 255 times the colors; rounding is free.
    """
    height, width = np.rint((high - low) * pixels_per_meter).astype(int)
    picture = np.zeros((height, width, 3), dtype=np.uint8)
    row, column = np.floor((high - points_world[:, :2]) * pixels_per_meter).astype(int).T
    inside = (row >= 0) & (row < height) & (column >= 0) & (column < width)
    for n in np.argsort(points_world[:, 2]):  # the highest last, so that it stays
        if inside[n]:
            picture[row[n], column[n]] = np.rint(255 * colors[n])
    return picture


def _answer_with(
    mistakes: frozenset[str],
    points_world: np.ndarray,
    colors: np.ndarray,
    low: np.ndarray,
    high: np.ndarray,
    pixels_per_meter: int,
) -> Any:
    height, width = (round(float(side) * pixels_per_meter) for side in high - low)
    picture = np.zeros((height, width, 3), dtype=np.uint8)
    order = np.arange(len(points_world))
    if "lowest-wins" in mistakes:
        order = np.argsort(-points_world[:, 2])
    elif "last-point-wins" not in mistakes:
        order = np.argsort(points_world[:, 2])
    for n in order:
        x, y, _ = points_world[n]
        row = int(np.floor((high[0] - x) * pixels_per_meter))
        column = int(np.floor((high[1] - y) * pixels_per_meter))
        if "clipped-to-the-border" in mistakes:
            row, column = min(max(row, 0), height - 1), min(max(column, 0), width - 1)
        if not (0 <= row < height and 0 <= column < width):
            continue
        scale = 1 if "colors-to-1" in mistakes else 255
        picture[row, column] = np.rint(scale * colors[n])
    if "y-to-the-right" in mistakes:
        picture = picture[:, ::-1]
    return picture[::-1] if "x-downward" in mistakes else picture


def _make_case(
    rng: np.random.Generator, label: str, size: tuple[int, int], missing: float, count: int = 300
) -> Case:
    """Make a map whose limits miss its last row and column by a part of a pixel, or go beyond."""
    scale = int(rng.integers(15, 30))
    high = np.round(rng.uniform([1.5, 0.2], [2.5, 0.8]), 2)
    low = high - (np.array(size) - missing) / scale
    # Away from the borders of pixels, so that no rounding decides; a margin lies outside the map.
    pixels = rng.integers(-3, np.array(size) + 3, (count, 2))
    places = high - (pixels + rng.uniform(0.2, 0.6, size=(count, 2))) / scale
    return Case(label, (*_add_heights(rng, places), np.round(low, 9), high, scale))


def _add_heights(rng: np.random.Generator, places: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return points at these places, all of other heights, half of them below 0; and colors."""
    count = len(places)
    heights = (rng.permutation(count) - count / 2 - 0.2) / 200
    colors = rng.integers(40, 256, size=(count, 3))
    colors[::4, 0] = 255  # as many levels as there are
    return np.round(np.column_stack([places, heights]), 6), np.round(colors / 255, 6)


def _make_border_case(rng: np.random.Generator) -> Case:
    """Make points on the corners of pixels, in sixteenths of a meter: nothing is rounded."""
    high = rng.integers(8, 24, size=2) / 16
    size = rng.integers(4, 8, size=2)
    places = high - rng.permutation(list(np.ndindex(*(size + 3)))) / 16 + 1 / 16
    label = "points exactly on the borders of pixels, and of the map"
    return Case(label, (*_add_heights(rng, places), high - size / 16, high, 16))


def _make_cases(rng: np.random.Generator) -> tuple[Case, ...]:
    size = (int(rng.integers(8, 12)), int(rng.integers(13, 17)))
    return (
        _make_case(rng, "a map whose size is rounded up", size, 0.3),
        _make_case(rng, "a map of as many pixels, whose size is rounded down", size, -0.3),
        _make_border_case(rng),
        _make_case(rng, "no point at all", size, 0.3, count=0),
    )


def _visible() -> tuple[Case, ...]:
    return _make_cases(np.random.default_rng(112))


def _hidden(rng: np.random.Generator) -> tuple[Case, ...]:
    return (*_make_cases(rng), *_make_cases(rng)[:2])


def _place(args: dict[str, Any]) -> np.ndarray:
    """Return the row and column of every point."""
    return np.floor((args["high"] - args["points_world"][:, :2]) * args["pixels_per_meter"])


def _keep(args: dict[str, Any], kept: np.ndarray) -> dict[str, Any]:
    return {"points_world": args["points_world"][kept], "colors": args["colors"][kept]}


def _keep_one_each(args: dict[str, Any]) -> dict[str, Any]:
    _, first = np.unique(_place(args), axis=0, return_index=True)
    return _keep(args, np.sort(first))


def _keep_inside(args: dict[str, Any]) -> dict[str, Any]:
    place, size = _place(args), np.rint((args["high"] - args["low"]) * args["pixels_per_meter"])
    return _keep(args, ((place >= 0) & (place < size)).all(axis=1))


def _raise(args: dict[str, Any]) -> dict[str, Any]:
    points = args["points_world"]
    points[:, 2] += 1 - points[:, 2].min(initial=0)
    return {"points_world": points}


def _share_limits(args: dict[str, Any]) -> dict[str, Any]:
    high, points = args["high"], args["points_world"]
    shift = np.array([0, high[0] - high[1]])
    points[:, :2] += shift
    return {"points_world": points, "low": args["low"] + shift, "high": high + shift}


def _move_up(args: dict[str, Any]) -> dict[str, Any]:
    points = args["points_world"]
    points[:, :2] = args["high"] - (_place(args) + 0.3) / args["pixels_per_meter"]
    return {"points_world": points}


EXERCISE = Exercise(
    name="draw_top_view",
    title="draw the cloud as a map",
    chapter="step6",
    place=12,
    points=0,
    section="step6-side",
    objectives=("6b",),
    reference=draw_top_view,
    answer_with=_answer_with,
    simpler=(
        Simplification("one-each", "no two points share a pixel", _keep_one_each),
        Simplification("inside", "all points lie in the map", _keep_inside),
        Simplification("heights", "all heights are above 0", _raise),
        Simplification("same-limits", "the upper limits in x and y are the same", _share_limits),
        Simplification(
            "in-the-corner", "every point lies near its pixel's upper left corner", _move_up
        ),
        Simplification(
            "no-full-color", "no color is full (1)", lambda a: {"colors": 0.9 * a["colors"]}
        ),
    ),
    parts=(Part("picture", "rgb", "uint8", atol=1.0),),
    tolerance_reason="one level of 255: rounding to the nearest or down makes no difference",
    misconceptions=(
        Misconception(
            "y-to-the-right",
            "left and right are exchanged. y points to the robot's left, and the robot looks up in "
            "the picture: large y is at the left.",
        ),
        Misconception(
            "x-downward",
            "the map is upside down. Rows count downward, so the largest x, far ahead, belongs "
            "into row 0.",
        ),
        Misconception(
            "last-point-wins",
            "where several points fall into a pixel, you keep the last of the array. From above "
            "one sees the highest: sort by z.",
            section="step6-occlusion",
        ),
        Misconception(
            "lowest-wins",
            "you keep the lowest point of each pixel: this is the view from below. Draw the "
            "highest last.",
            section="step6-occlusion",
        ),
        Misconception(
            "clipped-to-the-border",
            "points outside the map pile up at its border. Leave them out instead of clipping "
            "their rows and columns.",
        ),
        Misconception(
            "colors-to-1",
            "the picture is nearly black: colors of a cloud go from 0 to 1, those of a picture to "
            "255.",
        ),
    ),
    hints=(
        "First a row and a column for every point. Which of x and y makes the rows?",
        "Negative indices count from the end in NumPy: which points have to be dropped before?",
        "If points are drawn in the order of their height, which one stays?",
    ),
    example="""\
low, high = np.array([0.5, -0.9]), np.array([1.5, 0.9])
picture = draw_top_view(points_world[::3], colors[::3], low, high, 200)
show(picture, "the table from above: 1 pixel is 5 mm")""",
    contract=(
        told("map", "Without a screen"),
        asked(
            "ahead-up", "Ahead of the robot is up", "mistake x-downward", "mistake y-to-the-right"
        ),
        asked(
            "highest",
            "from above you see the highest",
            "mistake last-point-wins",
            "mistake lowest-wins",
        ),
        asked("draw", "Draw a cloud as a map", "every case"),
        asked("axes", "The robot looks along x", "mistake y-to-the-right", "mistake x-downward"),
        asked("row-column", "falls into row", "value", "case points exactly on the borders"),
        asked("highest-seen", "the highest is seen", "mistake lowest-wins"),
        asked(
            "left-out",
            "Points outside the map are left out",
            "mistake clipped-to-the-border",
            "case no point at all",
        ),
        given("points", "Points in the world (x forward"),
        asked("colors", "RGB from 0 to 1 per point", "mistake colors-to-1"),
        given("limits", "Limits (x, y) of the map"),
        asked("size", "Scale; the map has", "shape", "case a map whose size", "case a map of as"),
        asked("levels", "RGB, 255 times the colors", "value"),
    ),
    visible=_visible,
    hidden=_hidden,
    absorbed=(
        Absorbed(
            "last-point-wins",
            "lowest-wins",
            "points are drawn in one order: as they come, or by falling height",
        ),
        *(
            Absorbed("colors-to-1", other, "zeros and ones are black within the tolerance")
            for other in (
                "y-to-the-right",
                "x-downward",
                "last-point-wins",
                "lowest-wins",
                "clipped-to-the-border",
            )
        ),
    ),
)
