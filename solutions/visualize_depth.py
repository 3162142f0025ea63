"""Step 3: a depth image for the eye."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np

import labutils
from solutions._cases import make_depth, spoil_depth
from solutions._model import Absorbed, Case, Exercise, Misconception, Part, asked, told
from solutions._simpler import Simplification
from solutions.completions.visualize_depth import COMPLETION


def _answer_with(
    mistakes: frozenset[str], depth_metric: np.ndarray, max_depth: float
) -> np.ndarray:
    finite = np.isfinite(depth_metric)
    top = depth_metric[finite].max() if "own-maximum" in mistakes else max_depth
    share = np.where(depth_metric > 0, depth_metric, 0).astype(np.float64) / top
    if "not-clipped" in mistakes:
        share[~finite] = 0
    else:
        share = np.clip(share, 0, 1)
    if "red-is-close" in mistakes:
        share = 1 - share
    scaled = share if "not-scaled" in mistakes else share * 255
    # Casting a number above 255 to uint8 keeps its last eight bits.
    levels = np.floor(scaled).astype(np.int64).astype(np.uint8)
    colored = cv2.applyColorMap(levels, cv2.COLORMAP_TURBO)
    black = np.isnan(depth_metric) | (depth_metric <= 0)
    if "infinity-is-far" not in mistakes:
        black |= np.isinf(depth_metric)
    if "invalid-colored" not in mistakes:
        colored[black] = 0
    return colored[..., ::-1].copy() if "rgb" in mistakes else colored


def _visible() -> tuple[Case, ...]:
    rng = np.random.default_rng(41)
    ramp = np.linspace(0.05, 8, 20 * 27).reshape(20, 27).astype(np.float32)
    depth = spoil_depth(rng, make_depth(rng, 24, 34))
    return (
        Case("an even ramp that goes on beyond max_depth", (ramp, 5.0)),
        Case("a room with pixels that see nothing", (depth, 5.0)),
        Case("the same room, max_depth smaller", (depth, 0.9)),
    )


def _hidden(rng: np.random.Generator) -> tuple[Case, ...]:
    rooms = tuple(
        Case(
            f"room {number + 1}",
            (
                spoil_depth(rng, make_depth(rng, *map(int, rng.integers(20, 45, size=2)))),
                round(float(rng.uniform(2.2, 6.0)), 2),
            ),
        )
        for number in range(4)
    )
    near = spoil_depth(rng, make_depth(rng, 20, 30))
    return (
        *rooms,
        Case("what is near", (near, round(float(rng.uniform(0.7, 0.95)), 2))),
        # Neither 0 m nor max_depth occurs: who stretches what does is found out.
        Case("nothing invalid, nothing beyond max_depth", (make_depth(rng, 16, 22), 7.0)),
    )


_ONE_BLUE = "every pixel is the first or second blue of the map, so the scale does not show"


def _make_positive(args: dict[str, Any]) -> dict[str, Any]:
    depth = args["depth_metric"]
    good = np.isfinite(depth) & (depth > 0)
    return {"depth_metric": np.where(good, depth, np.median(depth[good]))}


EXERCISE = Exercise(
    name="visualize_depth",
    title="color a depth image, blue close and red far",
    chapter="step3",
    place=2,
    points=8,
    section="step3-picture",
    objectives=("3d", "3e"),
    reference=labutils.visualize_depth,
    answer_with=_answer_with,
    simpler=(
        Simplification(
            "within",
            "no depth is beyond max_depth",
            lambda a: {
                "max_depth": 1.001
                * float(
                    np.max(a["depth_metric"], where=np.isfinite(a["depth_metric"]), initial=0.5)
                )
            },
        ),
        Simplification("all-positive", "every depth is finite and positive", _make_positive),
    ),
    parts=(Part("picture", "mapped", "uint8", atol=1.01, unit="levels of 255"),),
    tolerance_reason=(
        "one level of 255: rounding up or down is free. COLORMAP_TURBO, COLORMAP_JET and a "
        "straight blue-red ramp are read back to levels first, so the choice of map is free too"
    ),
    misconceptions=(
        Misconception(
            "red-is-close",
            "close is red and far is blue. Either the scale runs backwards, or the picture is RGB "
            "although cv2 draws and writes BGR.",
        ),
        Misconception(
            "not-clipped",
            "beyond max_depth the colors start over at blue: numbers above 255 wrap around in "
            "uint8. Clip the share to 0-1 before scaling.",
        ),
        Misconception(
            "own-maximum",
            "the scale ends at the largest depth of each picture, so the same color means another "
            "distance every time. Divide by max_depth.",
        ),
        Misconception(
            "not-scaled",
            "everything is the same blue. A share from 0 to 1 becomes 0 or 1 as uint8: multiply "
            "by 255 before you convert.",
        ),
        Misconception(
            "invalid-colored",
            "pixels without a depth get the color of a distance. Paint NaN, infinity and "
            "everything at or below zero black after coloring.",
            section="step3-invalid",
        ),
        Misconception(
            "infinity-is-far",
            "infinite depth is shown as the reddest red. It is no distance: np.isfinite is False "
            "for it as it is for NaN.",
            section="step3-invalid",
        ),
        Misconception(
            "rgb",
            "red and blue of the color map are exchanged. cv2.applyColorMap returns BGR, and BGR "
            "is what this function returns.",
        ),
    ),
    hints=(
        (
            "Three steps: meters to a share of max_depth, the share to a level from 0 to 255, the "
            "level to a color. What may a share not be?"
        ),
        "cv2.applyColorMap wants uint8. What does uint8 make of 0.7, and what of 300?",
        (
            "Black is in no color map, which makes it the honest color for pixels without a depth. "
            "Paint it last."
        ),
    ),
    example="""\
measured = depth.copy()
measured[200:260, 420:500] = np.nan  # nothing was measured here
picture_bgr = visualize_depth(measured, 2.2)
show(picture_bgr[..., ::-1], "up to 2.2 m")  # BGR becomes RGB""",
    contract=(
        asked(
            "blue-to-red",
            "blue is close, red is far",
            "every case",
            "mistake red-is-close",
            "mistake own-maximum",
        ),
        asked("any-map", "Any map from blue to red will do", "value"),
        asked("even-steps", "Equal steps in depth", "value", "mistake own-maximum"),
        told("measurements", "A reader takes colors for measurements"),
        asked(
            "black",
            "a pixel that measured nothing",
            "mistake invalid-colored",
            "case a room with pixels that see nothing",
        ),
        asked("bgr", "The picture is BGR", "mistake rgb"),
        asked("color", "Color a depth image", "value"),
        asked("meters", "Meters.", "mistake not-scaled"),
        asked(
            "at-or-beyond",
            "Everything at or beyond",
            "mistake not-clipped",
            "case an even ramp that goes on",
            "case the same room, max_depth smaller",
        ),
        asked("ready", "ready for", "mistake rgb"),
        asked(
            "black-where",
            "Black where the depth is NaN",
            "mistake infinity-is-far",
            "mistake invalid-colored",
        ),
    ),
    visible=_visible,
    hidden=_hidden,
    imports=("import cv2", "import numpy as np"),
    asks={
        "depth_metric": "ndarray, float32, shape (H, W)\nMeters.",
        "Raises": "",
    },
    absorbed=(
        Absorbed("not-clipped", "own-maximum", "no share exceeds 1 when divided by the maximum"),
        Absorbed("invalid-colored", "infinity-is-far", "nothing is black, infinity neither"),
        Absorbed("not-scaled", "red-is-close", _ONE_BLUE),
        Absorbed("not-scaled", "own-maximum", _ONE_BLUE),
    ),
    completion=COMPLETION,
)
