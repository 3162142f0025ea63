"""Draw rays from the side: the horizon of a tilted camera, the way into an object.

`tools/draw/figures.py` saves what is drawn here.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.patches import Arc, Circle, Polygon

from tools.draw.svg_ink import ACCENT, COOL, INK, WASH, Z_BLUE, arrow, dot, label, line, make_axes

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def draw_horizon() -> Axes:
    """Side view of a tilted camera: the level ray meets the image plane above its center."""
    ax = make_axes((-0.9, 7.4), (-2.85, 1.15))
    tilt, focal = np.deg2rad(20), 3.0
    forward = np.array([np.cos(tilt), -np.sin(tilt)])
    up = np.array([np.sin(tilt), np.cos(tilt)])
    middle = focal * forward
    level = np.array([focal / np.cos(tilt), 0.0])
    line(ax, middle - 1.25 * up, middle + 1.75 * up, lw=3)
    line(ax, middle, level, ACCENT, lw=4.5)
    arrow(ax, (0, 0), 6.9 * forward, Z_BLUE)
    label(ax, 6.4 * forward + 0.42 * up, "optical axis", Z_BLUE, fontsize=11)
    arrow(ax, (0, 0), (7.2, 0), COOL, lw=2)
    label(ax, (7.2, 0.27), "level ray, to the horizon", COOL, "right", fontsize=11)
    ax.add_patch(Arc((0, 0), 2.6, 2.6, theta1=-20, theta2=0, color=INK, lw=1.2))
    label(ax, (1.55, -0.27), r"$\alpha$")
    label(ax, middle / 2 - 0.3 * up, "$f$", Z_BLUE)
    label(ax, (middle + level) / 2 + 0.18 * forward, r"$f\,\tan\alpha$", ACCENT, "left")
    dot(ax, middle)
    label(ax, middle - 0.35 * up + 0.15 * forward, "$c_y$", ha="left")
    dot(ax, level, ACCENT)
    label(ax, middle + 2.0 * up, "image plane", fontsize=11)
    dot(ax, (0, 0))
    label(ax, (0, 0.32), "pinhole", fontsize=11)
    return ax


def draw_thickness() -> Axes:
    """Along one ray: the camera sees the skin; a second ray, from the center, gives the rest."""
    ax = make_axes((-0.7, 7.5), (-1.65, 1.55))
    center, radius = (5.6, 0.0), 1.35
    ax.add_patch(Circle(center, radius, fc=COOL, alpha=WASH, ec="none"))
    ax.add_patch(Circle(center, radius, fc="none", ec=COOL, lw=1.5))
    ax.add_patch(Polygon([(-0.45, -0.3), (-0.45, 0.3), (0, 0)], fc=INK, ec="none"))
    label(ax, (-0.2, 0.6), "camera", fontsize=11)
    skin = (center[0] - radius, 0.0)
    arrow(ax, (0, 0), skin, ACCENT, lw=2.2)
    label(ax, (2.0, 0.32), "depth gives this part", ACCENT, fontsize=11)
    label(ax, (2.0, -0.36), r"along the ray $\mathbf{d}$", ACCENT, fontsize=11)
    arrow(ax, (center[0], -0.16), (skin[0], -0.16), COOL, lw=2.2)
    label(ax, (center[0] - radius / 2, -0.46), "$s$", COOL)
    dot(ax, skin, ACCENT, 7)
    label(ax, (skin[0] - 0.12, 0.72), r"$\mathbf{p}$, the skin", ACCENT, "right")
    dot(ax, center, COOL, 7)
    label(ax, (center[0], 0.4), r"$\hat{\mathbf{c}}$, the center", COOL, fontsize=11)
    label(ax, (4.1, -1.35), "a second ray, from inside", COOL, "right", fontsize=11)
    line(ax, (4.15, -1.3), (4.75, -0.25), COOL, lw=0.9)
    return ax
