"""Explore a depth image: which depths get the colors, and where they lie in the raw buffer.

Taught in: step 3.
"""

from __future__ import annotations

from typing import Any, ClassVar

import cv2
import numpy as np
import traitlets

from labutils._constants import MAX_DEPTH, MIN_DEPTH
from labutils._guards import check_depth_limits
from labutils.depth_values import find_valid_depth, metric_to_raw
from labutils.explorers._base import (
    DEPTH_STEP,
    PixelExplorer,
    PixelView,
    encode_depth,
    make_choice,
    make_range_slider,
)
from labutils.explorers._depth_picture import (
    COLOR_MAPS,
    FARTHER,
    INSIDE,
    NEARER,
    NO_SURFACE,
    Limits,
    check_has_surface,
    decode_steps,
    find_kinds,
    is_surface,
    make_color_tables,
    paint_depth,
    to_step,
)
from labutils.explorers._goal import Goal, GoalPart
from labutils.explorers._modules import join_modules, join_styles

BINS = 50
#: End of the slider in meters, unless something lies farther away.
_USUAL_END = 5.0
#: The goal: at most this wide, in percent of the tightest range that holds every surface.
_WIDE_ENOUGH = 105.0
#: Who leaves out this share of the surfaces is as far from the goal as can be.
_MANY = 0.05


class DepthRangeView(PixelView):
    """The colored depth image, its color bar, and the histograms of meters and of raw values."""

    _esm = join_modules("depth_range")
    _css = join_styles("plot", "hover", "depth_range")
    depth_png = traitlets.Bytes().tag(sync=True)
    depth_step = traitlets.Float(DEPTH_STEP).tag(sync=True)
    #: A surface lies between these, in meters.
    valid_m = traitlets.List([MIN_DEPTH, MAX_DEPTH]).tag(sync=True)
    clip_m: traitlets.List[float] = traitlets.List().tag(sync=True)
    upper_m = traitlets.Float(_USUAL_END).tag(sync=True)
    color_names = traitlets.List(list(COLOR_MAPS)).tag(sync=True)
    color_tables = traitlets.Bytes(make_color_tables()).tag(sync=True)
    range_m = traitlets.List([0.0, _USUAL_END]).tag(sync=True)
    #: Place of the color map in `color_names`.
    color_map = traitlets.Int(0).tag(sync=True)

    PICTURE: ClassVar = "depth_png"
    PARAMETERS: ClassVar = ("range_m", "color_map", "pixel")

    def compute(self) -> dict[str, Any]:
        """Compute the shares of the surface pixels, both histograms, and what one pixel reads.

        What is no surface, as the sky in a window, is counted apart. `width_percent` is how wide
        the range is: 100 is the tightest one that holds every surface.
        """
        steps = decode_steps(self.depth_png)
        limits = Limits(*(to_step(one) for one in self.range_m))
        kinds = np.bincount(find_kinds(steps, limits).ravel(), minlength=4)
        surface = steps[is_surface(steps)]
        end = to_step(self.upper_m)
        metric = surface[surface < end] * BINS // end
        raw = np.minimum((self._to_raw(surface * DEPTH_STEP) * BINS).astype(int), BINS - 1)
        tightest = max(int(surface.max() - surface.min()), 1) * DEPTH_STEP
        return {
            "surfaces": surface.size,
            "left_out": int(kinds[NEARER] + kinds[FARTHER]),
            "share_nearer": float(100 * kinds[NEARER] / surface.size),
            "share_inside": float(100 * kinds[INSIDE] / surface.size),
            "share_farther": float(100 * kinds[FARTHER] / surface.size),
            "no_surface": int(kinds[NO_SURFACE]),
            "width_percent": 100 * (self.range_m[1] - self.range_m[0]) / tightest,
            "raw_range": self._to_raw(np.array(self.range_m)).tolist(),
            "raw_closest": float(self._to_raw(surface.min() * DEPTH_STEP)),
            "metric_bins": np.bincount(metric, minlength=BINS).tolist(),
            "raw_bins": np.bincount(raw, minlength=BINS).tolist(),
            **self._read_pixel(steps, limits),
        }

    def _read_pixel(self, steps: np.ndarray, limits: Limits) -> dict[str, Any]:
        if not self.pixel:
            return {"pixel_depth": None, "pixel_raw": None, "pixel_kind": None}
        u, v = self.pixel
        depth = float(steps[v, u] * DEPTH_STEP) or None
        return {
            "pixel_depth": depth,
            "pixel_raw": None if depth is None else float(self._to_raw(np.float64(depth))),
            "pixel_kind": int(find_kinds(steps[v : v + 1, u], limits)[0]),
        }

    def _to_raw(self, depth: np.ndarray | np.float64) -> np.ndarray:
        return metric_to_raw(depth, *self.clip_m)

    def describe(self) -> str:
        """Say how much of the picture lies in the range, and where the raw buffer keeps it."""
        values = self.compute()
        near, far = self.range_m
        low, high = values["raw_range"]
        return (
            f"Depth range: {near:.2f} to {far:.2f} m holds {values['share_inside']:.1f} % of the "
            f"surface pixels; in the raw buffer that is {low:.4f} to {high:.4f}"
        )

    def draw_poster(self) -> np.ndarray:
        """Draw the depth image with its color bar below."""
        near, far = self.range_m
        picture = paint_depth(decode_steps(self.depth_png), near, far, self.color_map)
        bar_steps = np.linspace(near, far, picture.shape[1])
        share = (bar_steps - near) / max(far - near, DEPTH_STEP)
        table = np.frombuffer(self.color_tables, np.uint8).reshape(-1, 256, 3)[self.color_map]
        bar = np.repeat(table[(share * 255).astype(np.uint8)][None], 20, axis=0)
        scale = np.full((36, picture.shape[1], 3), 255, np.uint8)
        for meters, x in ((near, 4), (far, picture.shape[1] - 90)):
            where, ink = (x, 25), (36, 41, 47)
            cv2.putText(scale, f"{meters:.2f} m", where, cv2.FONT_HERSHEY_SIMPLEX, 0.6, ink, 1, 16)
        return np.vstack([picture, bar, scale])


class DepthRangeExplorer(PixelExplorer):
    """What `explore_depth_range` returns: the range, as Python reads it."""

    view: DepthRangeView

    @property
    def depth_range(self) -> tuple[float, float]:
        """Nearest and farthest depth that gets a color, in meters."""
        near, far = self.view.range_m
        return float(near), float(far)


def explore_depth_range(
    depth_metric: np.ndarray,
    near: float = 0.0,
    far: float = _USUAL_END,
    *,
    clip: tuple[float, float],
) -> DepthRangeExplorer:
    """Choose which depths get the colors, and see where they lie in the raw buffer.

    Parameters
    ----------
    depth_metric : array-like, real, shape (H, W)
        Meters. It is shown in steps of 0.2 mm, so shares may differ from yours by the pixels
        within 0.1 mm of a limit.
    near, far : float
        The range shown first, in meters; the slider moves in steps of 0.01 m.
    clip : tuple of float
        Near and far clip plane of the camera in meters, see `labutils.get_clip_planes`.

    Returns
    -------
    DepthRangeExplorer
        Shows itself as the last line of a cell; has `depth_range` in meters and `pixel`. Its
        goal is a range that holds every surface and is at most 5 % wider than it has to be.

    Raises
    ------
    TypeError, ValueError
        If the depth is no image of real numbers, holds no surface (see
        `labutils.find_valid_depth`), or the limits are not numbers in order.
    """
    depth = check_has_surface(depth_metric)
    planes = check_depth_limits("clip[0]", clip[0], "clip[1]", clip[1])
    if not 0 <= near < far <= MAX_DEPTH:
        raise ValueError(f"expected 0 <= near < far <= {MAX_DEPTH:g}, got {near} and {far}")
    surface = depth[find_valid_depth(depth)]
    upper = max(_USUAL_END, float(np.ceil(2 * max(far, surface.max())) / 2))
    view = DepthRangeView(
        label="Depth range explorer",
        help="Move both ends of the range; touch the picture to read a pixel.",
        depth_png=encode_depth(depth),
        clip_m=list(planes),
        upper_m=upper,
        range_m=[round(float(near), 2), round(float(far), 2)],
    )
    slider = make_range_slider("range", (0.0, upper), 0.01, unit="m", digits=2)
    explorer = DepthRangeExplorer(
        view, {"range_m": slider, "color_map": make_choice("colors", list(COLOR_MAPS))}
    )
    explorer.goal = Goal(
        "Every surface, in a range at most 5 % too wide.",
        GoalPart("left_out", "left out", high=0, digits=0, scale=_MANY * surface.size),
        GoalPart("width_percent", "width", high=_WIDE_ENOUGH, unit=" %", digits=0),
    )
    return explorer
