"""Explore the depth convention: what a raw value means in meters, and what one step is worth.

Taught in: step 3.
"""

from __future__ import annotations

from typing import Any, ClassVar

import ipywidgets
import numpy as np
import traitlets

from labutils._guards import check_depth_limits
from labutils.depth_values import metric_to_raw, process_depth
from labutils.explorers._base import Control, Explorer, View, make_slider
from labutils.explorers._goal import Goal, GoalPart
from labutils.explorers._modules import join_modules, join_styles
from labutils.explorers._poster import draw_lines

#: Meters to choose from: a slider with even steps would spend them all on large values.
_NEARS = tuple(
    round(digits * 10.0**power, 4)
    for power in (-3, -2, -1, 0)
    for digits in (1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8)
    if 0.005 <= digits * 10.0**power <= 1
)
_FAR_LIMITS = (2.0, 100.0)


class DepthConventionView(View):
    """The hyperbola from raw values to meters, a point on it, and how fine each buffer is there."""

    _esm = join_modules("depth_convention")
    _css = join_styles("plot", "depth_convention")
    raw = traitlets.Float(0.5).tag(sync=True)
    #: Near planes to choose from, in meters, and the place of the chosen one.
    nears = traitlets.List(list(_NEARS)).tag(sync=True)
    near_place = traitlets.Int(0).tag(sync=True)
    far = traitlets.Float(10.0).tag(sync=True)

    PARAMETERS: ClassVar = ("raw", "near_place", "far")

    @property
    def near(self) -> float:
        """The chosen near plane in meters."""
        return float(self.nears[self.near_place])

    def compute(self) -> dict[str, Any]:
        """Compute the depth, what wrong formulas would make of it, and the steps of the buffers."""
        raw, near, far = self.raw, self.near, self.far
        depth = float(process_depth(np.float64(raw), near, far))
        reversed_depth = float(process_depth(np.float64(1 - raw), near, far))
        return {
            "depth": depth,
            "linear_error": near + raw * (far - near) - depth,
            "reversed_error": reversed_depth - depth,
            "step16_mm": _find_gap_mm(*_find_integer_levels(raw, 16), near, far),
            "step24_mm": _find_gap_mm(*_find_integer_levels(raw, 24), near, far),
            "step_float_mm": _find_gap_mm(*_find_float_levels(raw), near, far),
            "step_reversed_mm": _find_reversed_gap_mm(*_find_float_levels(1 - raw), near, far),
        }

    def describe(self) -> str:
        """Say the depth, and what a linear reading would make of it."""
        values = self.compute()
        return (
            f"Depth convention: raw {self.raw:.5f} between planes at {self.near:.3g} and "
            f"{self.far:.4g} m is {values['depth']:.4f} m; taken for linear it would be "
            f"{values['depth'] + values['linear_error']:.4f} m"
        )

    def draw_poster(self) -> np.ndarray:
        """Draw the curve, the point on it and the line that it is not."""
        z = np.linspace(self.near, self.far, 400)
        raw = metric_to_raw(z, self.near, self.far)
        curves = {
            "true": raw,
            "linear": (z - self.near) / (self.far - self.near),
            "reversed": 1 - raw,
        }
        point = (self.compute()["depth"], self.raw)
        return draw_lines(
            z, curves, point, labels=("depth (m)", "raw value"), title=self.describe()
        )


class DepthConventionExplorer(Explorer):
    """What `explore_depth_convention` returns: the values, as Python reads them."""

    view: DepthConventionView

    @property
    def raw(self) -> float:
        """Window depth, 0 at the near plane and 1 at the far plane."""
        return float(self.view.raw)

    @property
    def near(self) -> float:
        """Near clip plane in meters."""
        return self.view.near

    @property
    def far(self) -> float:
        """Far clip plane in meters."""
        return float(self.view.far)

    @property
    def depth(self) -> float:
        """What the raw value means in meters."""
        return float(self.values["depth"])


def explore_depth_convention(
    near: float = 0.01, far: float = 10.0, raw: float | None = None
) -> DepthConventionExplorer:
    """Turn raw values of the depth buffer into meters, for any pair of clip planes.

    Parameters
    ----------
    near, far : float
        Clip planes shown first, in meters: 0.005 to 1 (others can be chosen from a
        row of round values), and 2 to 100. The slider keeps far to 0.1 m.
    raw : float, optional
        Window depth shown first, 0 to 1; by default that of the middle between the planes. The
        slider keeps four digits, the curve all.

    Returns
    -------
    DepthConventionExplorer
        Shows itself as the last line of a cell; has `raw`, `near`, `far` and `depth`.

    Raises
    ------
    TypeError, ValueError
        If a number is none, or outside the limits of its slider.

    Notes
    -----
    One step of a buffer is the distance in meters between the two levels it can hold around the
    raw value. For integers of n bits the levels are multiples of 1 / (2^n - 1); float32 has
    neighbors that lie closer together toward 0. Reversed order keeps 1 - raw.
    """
    near, far = check_depth_limits("near", near, "far", far)
    if raw is None:
        raw = float(metric_to_raw(np.float64((near + far) / 2), near, far))
    for name, value, (low, high) in (
        ("near", near, (_NEARS[0], _NEARS[-1])),
        ("far", far, _FAR_LIMITS),
        ("raw", raw, (0.0, 1.0)),
    ):
        if not low <= value <= high:
            raise ValueError(f"{name}: expected {low:g} to {high:g}, got {value}")
    nears = sorted({*_NEARS, near})
    view = DepthConventionView(
        label="Depth convention explorer",
        help="Slide the raw value, or drag the point on the curve: its arrow keys move 1 cm.",
        raw=round(float(raw), 4),  # a slider moves a value between its steps when it is drawn
        nears=nears,
        near_place=nears.index(near),
        far=round(far, 1),
    )
    near_slider = ipywidgets.SelectionSlider(
        options=[f"{one:g}" for one in nears], description="near (m)"
    )
    near_slider.add_class("jupyter-widgets")  # which this one lacks, and styles ask for
    explorer = DepthConventionExplorer(
        view,
        {
            "raw": make_slider("raw", (0.0, 1.0), 0.0001, digits=5),
            "near_place": Control(near_slider, "index"),
            "far": make_slider("far", _FAR_LIMITS, 0.1, unit="m", digits=1),
        },
    )
    explorer.goal = Goal(
        "At 2 m, make one step of 16 bits 1 mm at most.",
        GoalPart("depth", "depth", low=1.95, high=2.05, unit=" m"),
        GoalPart("step16_mm", "step", high=1, unit=" mm"),
    )
    return explorer


def _find_integer_levels(value: float, bits: int) -> tuple[float, float]:
    """Return the two levels of an unsigned buffer that enclose a value from 0 to 1."""
    last = 2**bits - 1
    level = min(last - 1, int(np.floor(value * last)))
    return level / last, (level + 1) / last


def _find_float_levels(value: float) -> tuple[float, float]:
    """Return the two neighboring float32 numbers that enclose a value from 0 to 1."""
    zero, one, two = np.float32(0), np.float32(1), np.float32(2)
    low = np.float32(value)
    if float(low) > value:
        low = np.nextafter(low, zero)
    low = min(low, np.nextafter(one, zero))
    return float(low), float(np.nextafter(low, two))


def _find_gap_mm(low: float, high: float, near: float, far: float) -> float:
    """Return the millimeters between two raw values, without subtracting two equal depths."""
    span = far - near
    return 1000 * near * far * span * (high - low) / ((far - low * span) * (far - high * span))


def _find_reversed_gap_mm(low: float, high: float, near: float, far: float) -> float:
    """Return the same for a buffer that holds 1 at the near plane and 0 at the far plane."""
    span = far - near
    return 1000 * near * far * span * (high - low) / ((near + low * span) * (near + high * span))
