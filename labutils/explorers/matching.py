"""Explore block matching: one window, the cost of every disparity, and what the minimum tells.

Taught in: stereo.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar

import cv2
import numpy as np
import traitlets

from labutils._guards import (
    check_intrinsics,
    check_odd,
    check_pixel,
    check_positive,
)
from labutils.explorers._base import (
    PixelExplorer,
    PixelView,
    decode_gray,
    encode_gray,
    make_slider,
)
from labutils.explorers._goal import Goal, GoalPart
from labutils.explorers._modules import join_modules, join_styles
from labutils.explorers._noise import add_noise
from labutils.explorers._stereo_pair import (
    check_whole,
    disparity_to_steps,
    draw_match,
    encode_noisy,
    make_gray_pair,
)
from labutils.explorers._window_match import (
    DISPARITY_STEP,
    WINDOWS,
    find_costs,
    find_error,
    find_runner_up,
    refine,
)
from labutils.stereo import disparity_to_depth, find_right_state

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

#: A match is right up to this error in pixels.
GOOD_PX = 1.0
#: The goal: a pixel that the small window gets wrong by at least so much, and the large one right.
SMALL_WINDOW, LARGE_WINDOW, _WRONG_PX = 3, 15, 2.0
MAX_NOISE = 20
_SEARCHED = (8, 256)

_OF_THE_MATCH = (
    *("disparity", "cost", "subpixel", "depth", "second", "ratio"),
    *("error_px", "depth_error_mm"),
)


class MatchingView(PixelView):
    """The left picture with a window, the strip searched in the right one, and the cost curve."""

    _esm = join_modules("matching")
    _css = join_styles("plot", "hover", "stereo", "matching")
    left_png = traitlets.Bytes().tag(sync=True)
    right_png = traitlets.Bytes().tag(sync=True)
    #: True disparities in steps of `disparity_step`; empty where nobody knows them.
    truth_png = traitlets.Bytes().tag(sync=True)
    disparity_step = traitlets.Float(DISPARITY_STEP).tag(sync=True)
    K: traitlets.List[list[float]] = traitlets.List().tag(sync=True)
    baseline = traitlets.Float(0.1).tag(sync=True)
    #: The longest search, in disparities.
    max_disparity = traitlets.Int(96).tag(sync=True)
    #: Names, and pixels [u, v] worth a look: a list, because JSON sorts by name.
    places: traitlets.List[list[Any]] = traitlets.List().tag(sync=True)
    window = traitlets.Int(9).tag(sync=True)
    search = traitlets.Int(96).tag(sync=True)
    noise = traitlets.Int(0).tag(sync=True)

    PICTURE: ClassVar = "left_png"
    PARAMETERS: ClassVar = ("window", "search", "noise", "pixel")

    def make_pictures(self) -> tuple[np.ndarray, np.ndarray]:
        """Return the left and the right picture with their noise, uint8 (H, W)."""
        pictures = (self.left_png, self.right_png)
        left, right = (add_noise(decode_gray(p), self.noise, i) for i, p in enumerate(pictures))
        return left, right

    def compute(self) -> dict[str, Any]:
        """Compute the cost curve, its minimum, and how far off it is, for every window size.

        `costs` are sums over the window; `cost` is the smallest of them per pixel, and `ratio` is
        that of the best to the second-best valley. Errors are those of the sub-pixel disparity.
        """
        row = self._read_truth_row()
        truth = float(row[self.pixel[0]]) if self.pixel else np.nan
        curves = self._find_curves()
        costs = curves[WINDOWS.index(self.window)]
        errors = [find_error(one, truth) for one in curves]
        is_known = not np.isnan(truth)
        return {
            "costs": costs.tolist(),
            **self._describe_minimum(costs, truth),
            "truth": truth if is_known else None,
            "true_depth": self._to_depth(truth) if is_known else None,
            "right": find_right_state(self.pixel[0], row) if is_known else None,
            "errors_px": errors,
            "small_window_px": errors[WINDOWS.index(SMALL_WINDOW)],
            "large_window_px": errors[WINDOWS.index(LARGE_WINDOW)],
            "right_windows": sum(one is not None and one <= GOOD_PX for one in errors)
            if is_known
            else None,
        }

    def _find_curves(self) -> list[np.ndarray]:
        if not self.pixel:
            return [np.zeros(0)] * len(WINDOWS)
        left, right = self.make_pictures()
        return [find_costs(left, right, self.pixel, one, self.search) for one in WINDOWS]

    def _read_truth_row(self) -> np.ndarray:
        """Return the true disparities of the chosen row, NaN where they are not known."""
        width, _ = self.picture_size
        if not self.pixel or not self.truth_png:
            return np.full(width, np.nan)
        steps = decode_gray(self.truth_png)[self.pixel[1]]
        return np.where(steps > 0, steps * DISPARITY_STEP, np.nan)

    def _describe_minimum(self, costs: np.ndarray, truth: float) -> dict[str, Any]:
        if not costs.size:
            return dict.fromkeys(_OF_THE_MATCH)
        best = int(costs.argmin())
        subpixel = refine(costs, best)
        depth = self._to_depth(subpixel)
        is_known = not np.isnan(truth)
        second = find_runner_up(costs, best)
        off = depth - disparity_to_depth(truth, self.K, self.baseline) if depth else np.nan
        return {
            "disparity": best,
            "cost": float(costs[best]) / self.window**2,
            "subpixel": subpixel,
            "depth": depth,
            "second": second,
            "ratio": None if second is None else float(costs[best] / max(costs[second], 1.0)),
            "error_px": subpixel - truth if is_known else None,
            "depth_error_mm": float(1000 * off) if is_known and depth else None,
        }

    def _to_depth(self, disparity: float) -> float | None:
        """Return meters; None for a disparity of 0, which is infinitely far."""
        return float(disparity_to_depth(disparity, self.K, self.baseline)) if disparity else None

    def describe(self) -> str:
        """Say which disparity the window finds, and how far off it is."""
        values = self.compute()
        if values["disparity"] is None:
            return "Matching: no window chosen that lies in the picture, so nothing to match"
        off = values["error_px"]
        truth = "" if off is None else f", {abs(off):.2f} px from the truth"
        return (
            f"Matching: at {tuple(self.pixel)} windows of {self.window} x {self.window} pixels "
            f"differ least at {values['subpixel']:.2f} px of disparity{truth}"
        )

    def draw_poster(self) -> np.ndarray:
        """Draw the window, and below it the strip of the right picture with the best match."""
        left, right = (cv2.cvtColor(one, cv2.COLOR_GRAY2RGB) for one in self.make_pictures())
        if not self.pixel:
            return left
        values = self.compute()
        true = None if values["truth"] is None else round(values["truth"])
        return draw_match((left, right), self.pixel, self.window, values["disparity"], true)


class MatchingExplorer(PixelExplorer):
    """What `explore_matching` returns: the match, as Python reads it."""

    view: MatchingView

    @property
    def window(self) -> int:
        """Side of the window in pixels."""
        return self.view.window

    @property
    def disparity(self) -> float | None:
        """Sub-pixel disparity that the window finds; None where there is nothing to match."""
        value: float | None = self.values["subpixel"]
        return value

    @property
    def costs(self) -> np.ndarray:
        """Sums of squared differences by disparity, float64."""
        return np.array(self.values["costs"])


def explore_matching(
    left: np.ndarray,
    right: np.ndarray,
    *,
    K: np.ndarray,
    baseline: float,
    truth: np.ndarray | None = None,
    window: int = 9,
    max_disparity: int = 96,
    noise: int = 0,
    pixel: Sequence[int] | None = None,
    places: Mapping[str, Sequence[int]] | None = None,
) -> MatchingExplorer:
    """Choose a pixel and a window, and see where the other picture fits it best.

    Convention
    ----------
    The pictures are a rectified pair: a point lies in the same row of both, `disparity` columns
    farther left in the right one. The cost of a disparity is the sum of squared differences (SSD)
    of two windows, over the gray levels of all their pixels.

    Parameters
    ----------
    left, right : array-like, uint8, shape (H, W) or (H, W, 3)
        Gray or RGB; matched in gray.
    K : array-like, shape (3, 3)
        Intrinsics of both cameras.
    baseline : float
        Distance between the cameras in meters, > 0.
    truth : array-like, real, shape (H, W), optional
        True disparities of the left picture in pixels, NaN where they are not known; shown in
        steps of 1/256 pixel. With it the explorer has a goal.
    window : int
        Side of the square window shown first in pixels: odd, 3 to 31.
    max_disparity : int
        How many disparities are searched at first, and at most: 8 to 256.
    noise : int
        Standard deviation of the noise that is added to both pictures at first, in gray levels:
        0 to 20.
    pixel : (u, v), optional
        Chosen first; without it the first of the places, else the middle of the picture.
    places : mapping of str to (u, v), optional
        Pixels worth a look. Each gets a button of that name.

    Returns
    -------
    MatchingExplorer
        Shows itself as the last line of a cell; has `window`, `pixel`, `disparity` and `costs`.
        Its goal is a pixel that 3 x 3 pixels get wrong by 2 px, and 15 x 15 right to 1 px.

    Raises
    ------
    TypeError, ValueError
        If the pictures are none or differ in size, the truth has another size, or a number lies
        outside its limits.
    """
    gray_left, gray_right = make_gray_pair(left, right)
    matrix, meters = check_intrinsics(K), check_positive("baseline", baseline, "meters")
    height, width = gray_left.shape
    longest = check_whole("max_disparity", max_disparity, _SEARCHED)
    named = [
        [name, list(check_pixel(f"places[{name!r}]", place, width, height))]
        for name, place in (places or {}).items()
    ]
    first = named[0][1] if named else (width // 2, height // 2)
    start = check_pixel("pixel", first if pixel is None else pixel, width, height)
    view = MatchingView(
        label="Matching explorer",
        help="Choose a pixel. Then change window, search and noise.",
        left_png=encode_noisy(gray_left),
        right_png=encode_noisy(gray_right),
        truth_png=b"" if truth is None else encode_gray(disparity_to_steps(truth, gray_left.shape)),
        K=matrix.tolist(),
        baseline=meters,
        max_disparity=longest,
        places=named,
        window=check_whole("window", check_odd("window", window), (WINDOWS[0], WINDOWS[-1])),
        search=longest,
        noise=check_whole("noise", noise, (0, MAX_NOISE)),
        pixel=list(start),
    )
    explorer = MatchingExplorer(
        view,
        {
            "window": make_slider("window", (WINDOWS[0], WINDOWS[-1]), 2, unit="px"),
            "search": make_slider("search", (_SEARCHED[0], longest), 1, unit="px"),
            "noise": make_slider("noise", (0, MAX_NOISE), 1, unit="levels"),
        },
    )
    if truth is not None:
        small, large = (f"{side} x {side}" for side in (SMALL_WINDOW, LARGE_WINDOW))
        explorer.goal = Goal(
            f"{small} is wrong here, {large} right.",
            GoalPart("small_window_px", f"{small} off by", low=_WRONG_PX, unit=" px"),
            GoalPart("large_window_px", f"{large} off by", high=GOOD_PX, unit=" px"),
        )
    return explorer
