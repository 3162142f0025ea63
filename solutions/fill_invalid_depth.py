"""Challenge of step 3: fill the holes of a depth image without inventing surfaces."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import cv2
import numpy as np

from labutils import find_valid_depth
from solutions._cases import make_depth, spoil_depth
from solutions._model import Absorbed, Case, Exercise, Misconception, Part, asked, given, told
from solutions._simpler import Simplification

if TYPE_CHECKING:
    from collections.abc import Callable


def fill_invalid_depth(depth_metric: np.ndarray) -> np.ndarray:
    """Fill the invalid pixels of a depth image and keep its edges sharp.

    Valid is a depth above 0.01 m and below 10 m. Fill in rounds: in each round, every invalid
    pixel that has valid pixels among its eight neighbors takes the *farthest* of them; the filled
    pixels are valid from the next round on. Repeat until no invalid pixel is left. A hole beside
    an object is mostly background that the object hides, hence the farthest.

    Parameters
    ----------
    depth_metric : ndarray, float32, (H, W)
        Meters. At least one pixel is valid.

    Returns
    -------
    ndarray, float, (H, W)
        Meters; valid pixels keep their depth.
    """
    valid = (depth_metric > 0.01) & (depth_metric < 10)
    filled = np.where(valid, depth_metric, np.float32(0))
    while (filled == 0).any():
        farthest = cv2.dilate(filled, np.ones((3, 3), np.uint8))
        filled = np.where(filled == 0, farthest, filled)
    return filled


def _answer_with(mistakes: frozenset[str], depth_metric: np.ndarray) -> Any:
    valid = (depth_metric > 0.01) & (depth_metric < 10)
    if "zeros-only" in mistakes:
        valid = ~np.isnan(depth_metric) & (depth_metric != 0)
    filled = np.where(valid, depth_metric, np.nan)
    pick: Callable[..., Any] = np.nanmin if "nearest-surface" in mistakes else np.nanmax
    if "average" in mistakes:
        pick = np.nanmean
    shifts = [(row, column) for row in range(3) for column in range(3)]
    if "four-neighbors" in mistakes:
        shifts = [shift for shift in shifts if 1 in shift]
    height, width = filled.shape
    for _ in range(1 if "one-round" in mistakes else height + width):
        if not np.isnan(filled).any():
            break
        padded = np.pad(filled, 1, constant_values=np.nan)
        around = np.stack([padded[r : r + height, c : c + width] for r, c in shifts])
        grown = pick(around, axis=0)
        filled = grown if "valid-changed" in mistakes else np.where(valid, filled, grown)
        valid = ~np.isnan(filled)
    return np.nan_to_num(filled, nan=0.0, posinf=np.inf, neginf=-np.inf).astype(np.float32)


def _make_case(rng: np.random.Generator, label: str, height: int, width: int) -> Case:
    depth = spoil_depth(rng, make_depth(rng, height, width))
    # A shadow along the box: wider than one round fills.
    top = int(rng.integers(2, height // 3))
    depth[top : top + height // 2, width // 2 : width // 2 + 4] = 0
    return Case(label, (depth,))


def _make_wide_hole(rng: np.random.Generator, label: str) -> Case:
    """Make a hole that takes more than ten rounds."""
    depth = np.round(rng.uniform(0.6, 4.0, size=(3, int(rng.integers(26, 32)))), 4)
    depth[:, 1:-1] = rng.choice([0.0, np.nan, 12.0])
    return Case(label, (depth.astype(np.float32),))


def _make_whole(rng: np.random.Generator, label: str) -> Case:
    return Case(label, (np.round(rng.uniform(0.6, 4.0, size=(3, 4)), 4).astype(np.float32),))


def _visible() -> tuple[Case, ...]:
    rng = np.random.default_rng(105)
    return (
        _make_case(rng, "a box before a wall, with holes", 18, 26),
        _make_case(rng, "a picture that is higher than wide", 25, 17),
        _make_wide_hole(rng, "a hole that is more than twenty pixels wide"),
        _make_whole(rng, "no pixel is invalid"),
    )


def _hidden(rng: np.random.Generator) -> tuple[Case, ...]:
    sizes = rng.integers(16, 34, size=(3, 2))
    return (
        *(_make_case(rng, f"view {h} x {w}", int(h), int(w)) for h, w in sizes),
        _make_wide_hole(rng, "a wide hole"),
        _make_whole(rng, "no hole"),
    )


def _shrink_holes(args: dict[str, Any]) -> dict[str, Any]:
    """Give what lies deep in a hole the median depth."""
    depth = args["depth_metric"]
    valid = find_valid_depth(depth)
    deep = cv2.distanceTransform((~valid).astype(np.uint8), cv2.DIST_C, 3) > 4
    depth[deep] = np.median(depth[valid])
    return {"depth_metric": depth}


def _close_border(args: dict[str, Any]) -> dict[str, Any]:
    depth = args["depth_metric"]
    rim = np.ones(depth.shape, dtype=bool)
    rim[2:-2, 2:-2] = False
    valid = find_valid_depth(depth)
    depth[rim & ~valid] = np.median(depth[valid])
    return {"depth_metric": depth}


def _put(args: dict[str, Any], value: float) -> dict[str, Any]:
    depth = args["depth_metric"]
    return {"depth_metric": np.where(find_valid_depth(depth), depth, np.float32(value))}


def _flatten(args: dict[str, Any]) -> dict[str, Any]:
    depth = args["depth_metric"]
    return {"depth_metric": np.where(find_valid_depth(depth), np.float32(1.5), depth)}


EXERCISE = Exercise(
    name="fill_invalid_depth",
    title="fill the holes of a depth image",
    chapter="step3",
    place=11,
    points=0,
    section="step3-invalid",
    objectives=("3d",),
    reference=fill_invalid_depth,
    answer_with=_answer_with,
    simpler=(
        Simplification("small-holes", "every hole is less than 9 pixels wide", _shrink_holes),
        Simplification("no-hole-at-border", "no hole touches the border", _close_border),
        Simplification("zeros", "every invalid pixel is 0", lambda a: _put(a, 0.0)),
        Simplification("nan", "every invalid pixel is NaN", lambda a: _put(a, np.nan)),
        Simplification(
            "millimeters",
            "all depths are whole millimeters",
            lambda a: {"depth_metric": np.round(a["depth_metric"], 3)},
        ),
        Simplification("even", "all valid depths are the same", _flatten),
    ),
    parts=(Part("depth", "depth", "float", atol=1e-5, unit="m"),),
    tolerance_reason=(
        "filled depths are copies, so only rounding may differ; neighboring depths of one surface "
        "differ by millimeters"
    ),
    misconceptions=(
        Misconception(
            "average",
            "you average the neighbors. At an edge this invents a surface halfway between object "
            "and background: copy one of them.",
            section="step3-reversed-z",
        ),
        Misconception(
            "nearest-surface",
            "you take the nearest neighbor in depth. A hole beside an object is background that "
            "it hides: take the farthest.",
        ),
        Misconception(
            "one-round",
            "holes wider than two pixels are still open. Repeat until no invalid pixel is left.",
        ),
        Misconception(
            "valid-changed",
            "you also change pixels that were measured. Replace the invalid ones only, as "
            "np.where does.",
        ),
        Misconception(
            "zeros-only",
            "you look for zeros and NaN only. Infinity, negative depths, depths up to 0.01 m and "
            "from 10 m on are invalid, too.",
        ),
        Misconception(
            "four-neighbors",
            "you look up, down, left and right. The diagonal neighbors count as well: there are "
            "eight.",
        ),
    ),
    hints=(
        "Begin with a mask of the valid pixels. Which comparison is False for NaN?",
        (
            "The largest of the nine values around a pixel: which step of morphology does that? It "
            "also works on float32."
        ),
        "Mark invalid pixels by 0, smaller than every depth. Repeat while there are any left.",
    ),
    example="""\
measured = depth[200:320, 240:400].copy()
measured[20:70, 60:90] = np.nan  # a hole, across the edge of the block
show(measured, "what a sensor measured")
show(fill_invalid_depth(measured), "filled")""",
    contract=(
        told("planning", "Planning needs a depth"),
        asked("no-average", "Fill them without inventing surfaces", "mistake average"),
        asked(
            "rule", "The rule: the farthest valid neighbor", "mistake nearest-surface", "every case"
        ),
        asked("measured-stay", "Measured pixels keep what was measured", "mistake valid-changed"),
        asked("fill", "Fill the invalid pixels", "value"),
        asked("valid", "Valid is a depth above", "mistake zeros-only"),
        asked("rounds", "Fill in rounds", "mistake four-neighbors"),
        asked(
            "repeat",
            "Repeat until no invalid pixel is left",
            "mistake one-round",
            "case a hole that is more",
        ),
        told("why-farthest", "hence the farthest"),
        given("meters", "depth_metric: Meters."),
        given("one-valid", "At least one pixel is valid"),
        asked(
            "keep",
            "valid pixels keep their depth",
            "mistake valid-changed",
            "case no pixel is invalid",
        ),
    ),
    visible=_visible,
    hidden=_hidden,
    imports=("import cv2", "import numpy as np"),
    absorbed=(
        Absorbed("average", "nearest-surface", "one value is taken: the mean or the smallest"),
    ),
)
