"""Draw colors as HSV sees them: the wheel of hues and the cylinder.

`tools/draw/figures.py` saves what is drawn here.
"""

from __future__ import annotations

import colorsys
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.colors import hsv_to_rgb
from matplotlib.patches import Arc, Ellipse, Wedge

from tools.draw.svg_ink import ACCENT, INK, arrow, label, line, make_axes

if TYPE_CHECKING:
    from matplotlib.axes import Axes

NAMES = {0: "red", 30: "yellow", 60: "green", 90: "cyan", 120: "blue", 150: "magenta"}
STEP = 4  # degrees of the circle: 90 flat colors make a smooth wheel
SQUASH = 0.34  # a circle seen from the side


def turn(degrees: float, radius: float = 1.0) -> np.ndarray:
    """Return a point of the wheel, clockwise from the top as on the ring of the explorer."""
    angle = np.deg2rad(degrees)
    return radius * np.array([np.sin(angle), np.cos(angle)])


def draw_hue_wheel() -> Axes:
    """Hues stand around a circle, in OpenCV's half degrees, with the seam at red."""
    ax = make_axes((-2.5, 2.5), (-1.65, 1.95))
    for degrees in range(0, 360, STEP):
        color = colorsys.hsv_to_rgb((degrees + STEP / 2) / 360, 1, 1)
        start = 90 - degrees - STEP  # Matplotlib counts from the right, against the clock
        ax.add_patch(
            Wedge((0, 0), 1.2, start - 0.2, start + STEP + 0.2, width=0.42, fc=color, ec="none")
        )
    for hue, name in NAMES.items():
        at = turn(2 * hue, 1.3)
        ha = "center" if hue in {0, 90} else "left" if hue < 90 else "right"
        if hue:
            label(ax, at, f"{name} {hue}", ha=ha, va="top" if hue == 90 else "center", fontsize=11)
        line(ax, turn(2 * hue, 0.7), turn(2 * hue, 0.77), lw=1)
    line(ax, (0, 0.72), (0, 1.4), INK, lw=3)
    label(ax, (0, 1.58), "seam", ACCENT, weight="bold", fontsize=11)
    label(ax, (0.35, 1.5), "0, 1, 2 ...: red that\nleans to orange", ha="left", fontsize=10)
    label(ax, (-0.35, 1.5), "... 178, 179: red\nthat leans to pink", ha="right", fontsize=10)
    label(ax, (0, 0.12), "hue in OpenCV:", fontsize=11)
    label(ax, (0, -0.14), "angle / 2", ACCENT, fontsize=11)
    return ax


def paint_cylinder(x: np.ndarray, y: np.ndarray, radius: float, top: float) -> np.ndarray:
    """Color what is seen of a cylinder from the side and from above, RGBA; nothing beside it."""
    with np.errstate(invalid="ignore"):
        front = -SQUASH * np.sqrt(radius**2 - x**2)  # of the disk's edge, at every x
    lid_y = (y - top) / SQUASH
    is_lid = np.hypot(x, lid_y) <= radius
    is_wall = (np.abs(x) <= radius) & (y >= front) & (y <= top + front) & ~is_lid
    depth = np.where(is_lid, lid_y, front / SQUASH)  # seen from above, where the color sits
    hsv = np.stack(
        [
            -np.arctan2(depth, x) / (2 * np.pi) % 1,
            np.where(is_lid, np.minimum(np.hypot(x, lid_y) / radius, 1), 1),
            np.where(is_lid, 1, np.clip((y - front) / top, 0, 1)),
        ],
        axis=-1,
    )
    seen = is_lid | is_wall
    return np.dstack([hsv_to_rgb(np.where(seen[..., None], hsv, 0)), seen])


def draw_hsv_cylinder() -> Axes:
    """Hue goes around, saturation outward, value up; gray is the axis, black a whole disk."""
    ax = make_axes((-2.35, 2.75), (-0.95, 2.85))
    radius, top = 1.2, 1.9
    left, right, low, high = -1.25, 1.25, -0.5, 2.4
    x, y = np.meshgrid(np.linspace(left, right, 360), np.linspace(high, low, 418))
    painted = paint_cylinder(x, y, radius, top)
    ax.imshow(painted, extent=(left, right, low, high), interpolation="nearest")
    ax.set_xlim(-2.35, 2.75)  # the picture has moved them
    ax.set_ylim(-0.95, 2.85)
    for side in (-radius, radius):  # outlines: the black end would vanish on a dark page
        line(ax, (side, 0), (side, top), lw=0.8)
    ax.add_patch(
        Arc((0, 0), 2 * radius, 2 * radius * SQUASH, theta1=180, theta2=360, color=INK, lw=0.8)
    )
    ax.add_patch(Ellipse((0, top), 2.4, 2.4 * SQUASH, fc="none", ec=INK, lw=0.8))
    arrow(ax, (-1.5, 0), (-1.5, top), lw=1.4)
    label(ax, (-1.6, 1.0), "value", ha="right")
    label(ax, (-1.6, top), "255", ha="right", fontsize=10)
    label(ax, (-1.6, 0), "0, black", ha="right", fontsize=10)
    arrow(ax, (0, top), (1.2, top), "#333333", lw=1.4)
    arrow(ax, (1.3, top), (1.55, top), INK, style="-", lw=1)
    label(ax, (1.6, top), "saturation,\n0 on the axis", ha="left", fontsize=11)
    angles = np.deg2rad(np.linspace(145, 50, 40))
    ax.plot(1.42 * np.cos(angles), 1.42 * SQUASH * np.sin(angles) + top + 0.05, color=INK, lw=1.4)
    tip = (1.42 * np.cos(angles[-1]), 1.42 * SQUASH * np.sin(angles[-1]) + top + 0.05)
    arrow(ax, (tip[0] - 0.08, tip[1] + 0.022), tip, lw=1.4)
    label(ax, (0.2, top + 0.75), "hue", ha="center")
    label(
        ax,
        (0.2, -0.75),
        "black all over: hue says nothing there",
        fontsize=10.5,
    )
    return ax
