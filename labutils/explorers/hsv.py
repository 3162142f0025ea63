"""Explore HSV limits: which pixels they select, and what opening and closing make of them.

Taught in: step 4.
"""

from __future__ import annotations

from typing import Any, ClassVar

import cv2
import numpy as np
import traitlets

from labutils._constants import MAX_HUE, HsvRange
from labutils._guards import check_hsv_range, check_rgb_image
from labutils.color_segmentation import find_object_centroid
from labutils.explorers._base import (
    PixelExplorer,
    PixelView,
    decode_mask,
    decode_rgb,
    encode_mask,
    encode_rgb,
    make_choice,
    make_range_slider,
    make_slider,
)
from labutils.explorers._goal import Goal, GoalPart
from labutils.explorers._modules import join_modules, join_styles

#: Every color there is.
FULL_RANGE: HsvRange = ((0, 0, 0), (MAX_HUE, 255, 255))
#: Largest radius of opening and closing: a square of 13 x 13 pixels.
MAX_RADIUS = 6
#: What of the picture is shown.
SHOWN = ("overlay", "mask", "picture")
#: How bright the picture is where nothing is selected.
DIM = 0.4
#: From this intersection over union on the limits are good.
GOOD_IOU = 0.9
_NAMES = ("hue", "saturation", "value")


class HsvView(PixelView):
    """The picture with what is not selected dimmed, and the hues as a ring."""

    _esm = join_modules("hsv")
    _css = join_styles("hsv")
    rgb_png = traitlets.Bytes().tag(sync=True)
    #: The pixels to select, as PNG; empty where nobody knows them.
    truth_png = traitlets.Bytes().tag(sync=True)
    hue_from = traitlets.Int(0).tag(sync=True)
    hue_to = traitlets.Int(MAX_HUE).tag(sync=True)
    saturation_limits = traitlets.List(traitlets.Int(), [0, 255]).tag(sync=True)
    value_limits = traitlets.List(traitlets.Int(), [0, 255]).tag(sync=True)
    open_radius = traitlets.Int(2).tag(sync=True)
    close_radius = traitlets.Int(2).tag(sync=True)
    #: What is drawn: place in overlay, mask, picture.
    shown = traitlets.Int(0).tag(sync=True)

    PICTURE: ClassVar = "rgb_png"
    PARAMETERS: ClassVar = (
        "hue_from",
        "hue_to",
        "saturation_limits",
        "value_limits",
        "open_radius",
        "close_radius",
        "shown",
        "pixel",
    )

    @property
    def rgb(self) -> np.ndarray:
        """The picture, uint8 (H, W, 3)."""
        return decode_rgb(self.rgb_png)

    @property
    def hsv_range(self) -> HsvRange:
        """The six limits."""
        (s_low, s_high), (v_low, v_high) = self.saturation_limits, self.value_limits
        return (self.hue_from, s_low, v_low), (self.hue_to, s_high, v_high)

    def make_mask(self) -> np.ndarray:
        """Select the pixels within the limits, open, close: uint8 (H, W), 0 or 255."""
        hsv = cv2.cvtColor(self.rgb, cv2.COLOR_RGB2HSV)
        inside = np.logical_and.reduce(list(_find_inside(hsv, self.hsv_range).values()))
        mask = inside.astype(np.uint8) * 255
        mask = cv2.morphologyEx(mask, cv2.MORPH_OPEN, _make_square(self.open_radius))
        return cv2.morphologyEx(mask, cv2.MORPH_CLOSE, _make_square(self.close_radius))

    def compute(self) -> dict[str, Any]:
        """Compute what is selected, its centroid, and what is known of the picked pixel."""
        mask = self.make_mask()
        centroid = find_object_centroid(mask)
        count = int(np.count_nonzero(mask))
        values: dict[str, Any] = {
            "share": count / mask.size,
            "count": count,
            "centroid": list(centroid) if centroid else None,
            "iou": self._find_iou(mask),
            "pixel_rgb": None,
            "pixel_hsv": None,
            "pixel_excluded_by": [],
            "pixel_inside": None,
            "pixel_selected": None,
        }
        if self.pixel:
            u, v = self.pixel
            color = self.rgb[v : v + 1, u : u + 1]
            hsv = cv2.cvtColor(color, cv2.COLOR_RGB2HSV)
            excluding = [n for n, ok in _find_inside(hsv, self.hsv_range).items() if not ok.all()]
            values |= {
                "pixel_rgb": color[0, 0].tolist(),
                "pixel_hsv": hsv[0, 0].tolist(),
                "pixel_excluded_by": excluding,
                "pixel_inside": not excluding,
                "pixel_selected": bool(mask[v, u]),
            }
        return values

    def _find_iou(self, mask: np.ndarray) -> float | None:
        if not self.truth_png:
            return None
        truth, selected = decode_mask(self.truth_png), mask > 0
        return float(np.count_nonzero(truth & selected) / np.count_nonzero(truth | selected))

    def describe(self) -> str:
        """Say the limits and what they select."""
        low, high = self.hsv_range
        values = self.compute()
        where = f"at {tuple(values['centroid'])}" if values["centroid"] else "none"
        return (
            f"HSV limits: {low} to {high}, {values['share']:.2%} of the pixels selected, "
            f"centroid {where}"
        )

    def draw_poster(self) -> np.ndarray:
        """Draw the picture, gray where nothing is selected, with a cross at the centroid."""
        rgb, mask = self.rgb, self.make_mask()
        gray = cv2.cvtColor(rgb, cv2.COLOR_RGB2GRAY)
        poster = np.where(mask[..., None] > 0, rgb, (gray * DIM).astype(np.uint8)[..., None])
        if centroid := find_object_centroid(mask):
            cv2.drawMarker(poster, centroid, (0, 0, 0), cv2.MARKER_CROSS, 31, 6)
            cv2.drawMarker(poster, centroid, (255, 255, 255), cv2.MARKER_CROSS, 29, 2)
        return poster


class HsvExplorer(PixelExplorer):
    """What `explore_hsv` returns: the limits, and what they select, as Python reads them."""

    view: HsvView

    @property
    def hsv_range(self) -> HsvRange:
        """Low and high limits, as `segment_by_color` takes them; low hue > high hue wraps."""
        return self.view.hsv_range

    @property
    def open_radius(self) -> int:
        """Radius of the opening in pixels: its square is 2 r + 1 wide."""
        return self.view.open_radius

    @property
    def close_radius(self) -> int:
        """Radius of the closing in pixels."""
        return self.view.close_radius

    @property
    def mask(self) -> np.ndarray:
        """The given picture's mask, uint8 (H, W), 0 or 255, as `segment_by_color` at radius 2.

        A picture that a reader opens in the browser stays there: Python never sees it.
        """
        return self.view.make_mask()

    @property
    def pixel_rgb(self) -> tuple[int, int, int] | None:
        """RGB of the picked pixel of the given picture, or None."""
        return self._read_color("pixel_rgb")

    @property
    def pixel_hsv(self) -> tuple[int, int, int] | None:
        """HSV of the picked pixel of the given picture, in OpenCV's units, or None."""
        return self._read_color("pixel_hsv")

    def _read_color(self, name: str) -> tuple[int, int, int] | None:
        color = self.values[name]
        return (color[0], color[1], color[2]) if color else None


def explore_hsv(
    rgb: np.ndarray,
    hsv_range: HsvRange = FULL_RANGE,
    open_radius: int = 2,
    close_radius: int = 2,
    *,
    truth: np.ndarray | None = None,
    aim: str = "Select the true pixels and nothing else.",
) -> HsvExplorer:
    """Move the limits of a color range and see which pixels it selects.

    Convention
    ----------
    OpenCV's 8-bit HSV, as in `segment_by_color`: hue 0-179, and a low hue above the high hue wraps
    through red.

    Parameters
    ----------
    rgb : array-like, uint8, shape (H, W, 3)
        The picture. On the page a reader may open another one; it stays in the browser.
    hsv_range : ((h, s, v), (h, s, v))
        The limits shown first, inclusive; all colors by default.
    open_radius, close_radius : int
        0 to 6 pixels: the squares of ones are 2 r + 1 pixels wide, and 0 leaves the mask as it is.
    truth : array-like, bool, shape (H, W), optional
        The pixels to select. With it the explorer has a goal: an intersection over union of 0.9.
    aim : str
        The goal in words: say what the true pixels show.

    Returns
    -------
    HsvExplorer
        Shows itself as the last line of a cell; has `hsv_range`, `open_radius`, `close_radius`,
        `mask`, `pixel`, `pixel_rgb` and `pixel_hsv`.

    Raises
    ------
    TypeError, ValueError
        If the picture is not uint8 RGB, the range not two triples within OpenCV's limits, a
        radius not a whole number from 0 to 6, or the truth no mask of the picture.
    """
    picture = check_rgb_image("rgb", rgb)
    if not picture.size:
        raise ValueError(f"rgb: expected at least one pixel, got shape {picture.shape}")
    low, high = (limit.tolist() for limit in check_hsv_range("hsv_range", hsv_range))
    view = HsvView(
        label="HSV explorer",
        help="Drag both ends of the arc, then the sliders. The cross marks the middle of the "
        "largest region.",
        rgb_png=encode_rgb(picture),
        truth_png=b"" if truth is None else encode_mask(_check_truth(truth, picture)),
        hue_from=low[0],
        hue_to=high[0],
        saturation_limits=[low[1], high[1]],
        value_limits=[low[2], high[2]],
        open_radius=_check_radius("open_radius", open_radius),
        close_radius=_check_radius("close_radius", close_radius),
    )
    # hue has its ring: three pairs of limits, each of its own look, and not six sliders
    controls = {
        "saturation_limits": make_range_slider("saturation", (0, 255), 1),
        "value_limits": make_range_slider("value", (0, 255), 1),
        "open_radius": make_slider("open", (0, MAX_RADIUS), 1, unit="px"),
        "close_radius": make_slider("close", (0, MAX_RADIUS), 1, unit="px"),
        "shown": make_choice("show", SHOWN),
    }
    for name in ("saturation", "value"):
        controls[f"{name}_limits"].add_class(f"explorer-{name}")
    explorer = HsvExplorer(view, controls)
    if truth is not None:
        explorer.goal = Goal(aim, GoalPart("iou", "IoU", low=GOOD_IOU, scale=GOOD_IOU))
    return explorer


def _find_inside(hsv: np.ndarray, hsv_range: HsvRange) -> dict[str, np.ndarray]:
    """Find, per channel, where the limits let a color in."""
    inside = {}
    for channel, name in enumerate(_NAMES):
        low, high = (limit[channel] for limit in hsv_range)
        above, below = hsv[..., channel] >= low, hsv[..., channel] <= high
        wraps = name == "hue" and low > high
        inside[name] = above | below if wraps else above & below
    return inside


def _make_square(radius: int) -> np.ndarray:
    return np.ones((2 * radius + 1, 2 * radius + 1), np.uint8)


def _check_truth(truth: np.ndarray, picture: np.ndarray) -> np.ndarray:
    mask = np.asarray(truth)
    if mask.dtype != bool or mask.shape != picture.shape[:2]:
        raise ValueError(
            f"truth: expected bool of shape {picture.shape[:2]}, got {mask.dtype} of {mask.shape}"
        )
    if not mask.any():
        raise ValueError("truth: expected at least one pixel, got none")
    return mask


def _check_radius(name: str, value: Any) -> int:
    if isinstance(value, bool) or not isinstance(value, int | np.integer):
        raise TypeError(f"{name}: expected a whole number of pixels, got {value!r}")
    if not 0 <= value <= MAX_RADIUS:
        raise ValueError(f"{name}: expected 0 to {MAX_RADIUS} pixels, got {value}")
    return int(value)
