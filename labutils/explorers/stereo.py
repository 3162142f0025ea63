"""Explore a stereo pair: disparity, and how well it tells the depth.

Taught in: step 2, step 3.
"""

from __future__ import annotations

import numbers
from typing import TYPE_CHECKING, Any, ClassVar

import cv2
import numpy as np
import traitlets

from labutils._constants import MAX_DEPTH, MIN_DEPTH
from labutils._guards import check_intrinsics, check_pixel, check_rgb_image
from labutils.depth_values import find_valid_depth
from labutils.explorers._base import (
    DEPTH_STEP,
    PixelExplorer,
    PixelView,
    decode_rgb,
    encode_depth,
    encode_rgb,
    make_slider,
)
from labutils.explorers._depth_picture import check_has_surface, decode_steps, is_surface
from labutils.explorers._goal import Goal, GoalPart
from labutils.explorers._modules import join_modules, join_styles
from labutils.stereo import (
    OUTSIDE,
    SEEN,
    depth_to_disparity,
    find_depth_error,
    find_depth_interval,
    find_linear_depth_error,
    find_right_state,
)

if TYPE_CHECKING:
    from collections.abc import Sequence

_BASELINES_MM = (10.0, 300.0)
_ERRORS_PX = (0.1, 3.0)

_NOTHING = dict.fromkeys(
    (
        *("depth", "shared_depth", "disparity", "u_right", "right", "z_near", "z_far"),
        *("error_mm", "error_linear_mm"),
    )
)
#: The goal: a point at least this far away, in meters, known as well as this.
_FAR_AWAY, _WELL_MM = 1.5, 10.0


class StereoView(PixelView):
    """The left eye's picture with both marks, the rays from above, and error over depth."""

    _esm = join_modules("stereo")
    _css = join_styles("plot", "hover", "stereo")
    rgb_png = traitlets.Bytes().tag(sync=True)
    depth_png = traitlets.Bytes().tag(sync=True)
    depth_step = traitlets.Float(DEPTH_STEP).tag(sync=True)
    #: A surface lies between these, in meters.
    valid_m = traitlets.List([MIN_DEPTH, MAX_DEPTH]).tag(sync=True)
    K: traitlets.List[list[float]] = traitlets.List().tag(sync=True)
    baseline_mm = traitlets.Float(64.0).tag(sync=True)
    error_px = traitlets.Float(0.5).tag(sync=True)

    PICTURE: ClassVar = "rgb_png"
    PARAMETERS: ClassVar = ("baseline_mm", "error_px", "pixel")

    def compute(self) -> dict[str, Any]:
        """Compute the disparity, the depths it may stand for, and what the right eye sees.

        `shared_depth` is the depth of a point that both eyes see.
        """
        if not self.pixel:
            return dict(_NOTHING)
        u, v = self.pixel
        steps = decode_steps(self.depth_png)[v]
        row = np.where(is_surface(steps), steps * DEPTH_STEP, np.nan)
        depth = float(row[u])
        if np.isnan(depth):
            return dict(_NOTHING)
        K, baseline, error = np.array(self.K), self.baseline_mm / 1000, self.error_px
        disparities = depth_to_disparity(row, K, baseline)
        disparity = float(disparities[u])
        near, far = find_depth_interval(row[u], error, K, baseline)
        largest = find_depth_error(row[u], error, K, baseline)
        right = find_right_state(u, disparities)
        return {
            "depth": depth,
            "shared_depth": depth if right == SEEN else None,
            "disparity": disparity,
            "u_right": u - disparity,
            "right": right,
            "z_near": float(near),
            "z_far": _to_limit(far),
            "error_mm": _to_limit(1000 * largest),
            "error_linear_mm": float(1000 * find_linear_depth_error(row[u], error, K, baseline)),
        }

    def describe(self) -> str:
        """Say the disparity of the chosen point and the depths that it allows."""
        values = self.compute()
        if values["depth"] is None:
            return "Stereo: no surface chosen, so nothing to match"
        far = "or more" if values["z_far"] is None else f"to {values['z_far']:.3f} m"
        return (
            f"Stereo: {values['depth']:.3f} m away is {values['disparity']:.2f} px of disparity "
            f"over {self.baseline_mm:g} mm; a match {self.error_px:g} px off gives "
            f"{values['z_near']:.3f} m {far}"
        )

    def draw_poster(self) -> np.ndarray:
        """Draw the picture, the chosen point, and where the right eye sees it."""
        picture = np.ascontiguousarray(decode_rgb(self.rgb_png))
        values = self.compute()
        if values["depth"] is None:
            return picture
        u, v = self.pixel
        right = max(round(values["u_right"]), 0)
        for color, thickness in (((0, 0, 0), 4), ((255, 255, 255), 2)):
            cv2.line(picture, (right, v), (u, v), color, thickness)
            cv2.circle(picture, (u, v), 7, color, thickness)
            if values["right"] != OUTSIDE:
                cv2.rectangle(picture, (right - 6, v - 6), (right + 6, v + 6), color, thickness)
        return picture


class StereoExplorer(PixelExplorer):
    """What `explore_stereo` returns: the values, as Python reads them."""

    view: StereoView

    @property
    def baseline(self) -> float:
        """Distance between the eyes in meters."""
        return float(self.view.baseline_mm) / 1000

    @property
    def match_error(self) -> float:
        """How far the disparity may be off, in pixels."""
        return float(self.view.error_px)

    @property
    def disparity(self) -> float | None:
        """Disparity of the chosen point in pixels; None where there is no surface."""
        value: float | None = self.values["disparity"]
        return value

    @property
    def depth_interval(self) -> tuple[float, float] | None:
        """Nearest and farthest depth it may have, in meters; infinity if nothing bounds it."""
        values = self.values
        if values["depth"] is None:
            return None
        return values["z_near"], np.inf if values["z_far"] is None else values["z_far"]


def explore_stereo(
    rgb_image: np.ndarray,
    depth_metric: np.ndarray,
    K: np.ndarray,
    baseline: float = 0.064,
    match_error: float = 0.5,
    pixel: Sequence[int] | None = None,
) -> StereoExplorer:
    """Choose a point and a baseline, and see how well two eyes can tell its depth.

    Convention
    ----------
    The picture is the left eye's. The right eye looks the same way with the same K, and stands
    `baseline` meters to the right, along x of the camera frame. It sees the point in the same row
    and `disparity` columns farther left: d = f b / Z.

    Parameters
    ----------
    rgb_image : ndarray, uint8, shape (H, W, 3)
        Picture of the left eye.
    depth_metric : array-like, real, shape (H, W)
        Its depth in meters, shown in steps of 0.2 mm.
    K : array-like, shape (3, 3)
        Intrinsics of both eyes.
    baseline : float
        Shown first, in meters: 0.01 to 0.3; the slider moves in steps of 1 mm.
    match_error : float
        How far a match may be off, in pixels: 0.1 to 3; the slider moves in steps of 0.1.
    pixel : (u, v), optional
        Chosen first; without it the surface next to the middle of the picture.

    Returns
    -------
    StereoExplorer
        Shows itself as the last line of a cell; has `baseline`, `match_error`, `pixel`,
        `disparity` and `depth_interval`. Its goal is a point at least 1.5 m away that is known
        to 10 mm.

    Raises
    ------
    TypeError, ValueError
        If the picture, depth or K is none, their sizes differ, or a number is outside the limits
        of its slider.

    Notes
    -----
    With a match error e the depth lies between f b / (d + e) and f b / (d - e). The far end is the
    farther off: by Z^2 e / (f b - Z e), which for small errors is close to Z^2 e / (f b). Where
    d <= e there is no far end: the point could be infinitely far. The diamond seen from above
    shares the error between both pictures, half each.

    A point counts as hidden when something nearer in the same row of the left picture covers it
    for the right eye. What the left eye does not see cannot be known to cover anything.
    """
    rgb, depth = check_rgb_image("rgb_image", rgb_image), check_has_surface(depth_metric)
    matrix = check_intrinsics(K)
    if rgb.shape[:2] != depth.shape:
        raise ValueError(
            f"depth_metric: expected the size of rgb_image, {rgb.shape[:2]}, got {depth.shape}"
        )
    baseline_mm = 1000 * _check_number("baseline", baseline, tuple(b / 1000 for b in _BASELINES_MM))
    error_px = _check_number("match_error", match_error, _ERRORS_PX)
    if pixel is None:
        start = _find_middle_surface(depth)
    else:
        start = check_pixel("pixel", pixel, *depth.shape[::-1])
    view = StereoView(
        label="Stereo explorer",
        help="Choose a point in the picture. Then move the eyes apart, or match less exactly.",
        rgb_png=encode_rgb(rgb),
        depth_png=encode_depth(depth),
        K=matrix.tolist(),
        baseline_mm=float(round(baseline_mm)),
        error_px=round(error_px, 1),
        pixel=list(start),
    )
    explorer = StereoExplorer(
        view,
        {
            "baseline_mm": make_slider("baseline", _BASELINES_MM, 1.0, unit="mm"),
            "error_px": make_slider("match error", _ERRORS_PX, 0.1, unit="px", digits=1),
        },
    )
    explorer.goal = Goal(
        f"Know a point beyond {_FAR_AWAY:g} m to {_WELL_MM:g} mm.",
        GoalPart("shared_depth", "seen by both at", low=_FAR_AWAY, unit=" m"),
        GoalPart("error_mm", "off by", high=_WELL_MM, unit=" mm", digits=1),
    )
    return explorer


def _find_middle_surface(depth: np.ndarray) -> tuple[int, int]:
    """Find the surface pixel next to the middle of the picture."""
    v, u = np.nonzero(find_valid_depth(depth))
    height, width = depth.shape
    first = np.argmin((v - height // 2) ** 2 + (u - width // 2) ** 2)
    return int(u[first]), int(v[first])


def _to_limit(meters: np.ndarray) -> float | None:
    """Return a limit as the page knows it: JSON has no infinity, so None stands for it."""
    return float(meters) if np.isfinite(meters) else None


def _check_number(name: str, value: Any, limits: tuple[float, ...]) -> float:
    low, high = limits
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        raise TypeError(f"{name}: expected a number, got {type(value).__name__} {value!r}")
    number = float(value)
    if not low <= number <= high:
        raise ValueError(f"{name}: expected {low:g} to {high:g}, got {value}")
    return number
