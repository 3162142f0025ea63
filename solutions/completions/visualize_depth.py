"""Step 3: heights in the colors of another map."""

from __future__ import annotations

import cv2
import numpy as np

from solutions._completion import Case, Completion, Part, Slip


def color_heights(heights: np.ndarray, lowest: float, highest: float) -> np.ndarray:
    """Color a map of heights, dark violet low and yellow high.

    Parameters
    ----------
    heights : ndarray, float32, shape (H, W)
        Meters, all finite.
    lowest, highest : float
        What gets the first and the last color of the map, meters.
        Heights beyond them get these colors too.

    Returns
    -------
    ndarray, uint8, shape (H, W, 3)
        RGB, with the map viridis.
    """
    share = (heights - lowest) / (highest - lowest)  # open: 0 at lowest, 1 at highest
    levels = (255 * np.clip(share, 0, 1)).astype(np.uint8)
    colored_bgr = cv2.applyColorMap(levels, cv2.COLORMAP_VIRIDIS)
    colored = cv2.cvtColor(colored_bgr, cv2.COLOR_BGR2RGB)  # open: the same in RGB
    return colored


def _choose(cases: tuple[Case, ...]) -> tuple[Case, ...]:
    ramp, room = cases[0].args[0], cases[1].args[0]
    whole = np.where(np.isfinite(room) & (room > 0), room, np.float32(0.5))
    return (
        Case("an even ramp that goes on beyond both ends", (ramp, 1.0, 5.0)),
        Case("a room", (whole, 0.5, 3.0)),
    )


COMPLETION = Completion(
    title="color a map of heights",
    statement="A map of heights is drawn from `lowest` to `highest`, in the colors of the worked "
    "example. Scaling and color map are there; the share before them and the order of the "
    "channels after them are missing.",
    section="step3-worked-colors",
    twin=color_heights,
    parts=(Part("picture", "rgb", "uint8", atol=4, share=0.002),),
    cases=_choose,
    slips=(
        Slip(
            "starts-at-zero",
            "the first color belongs to a height of 0 m, not to the lowest. Subtract lowest, and "
            "divide by what is left of highest then.",
            line="share = heights / highest",
        ),
        Slip(
            "still-bgr",
            "red and blue are exchanged. cv2.applyColorMap gives BGR, and RGB is asked for: "
            "convert it, or reverse the last axis.",
            line="colored = colored_bgr",
        ),
    ),
    example="""\
heights = 2.2 - depth  # what is near counts as high here
picture = color_heights(heights, 0.0, 1.5)
show(picture, "near is yellow")""",
    imports=("import cv2", "import numpy as np"),
)
