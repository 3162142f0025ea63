"""Draw the book's geometry: pinhole, frames, pixel grid, depth, stereo, the pipeline.

Every function draws one SVG of ``book/_static/figures``. The lengths in the drawings come from the
same formulas as the text; the ink is a mid gray that reads on light and on dark pages, and the
ground is transparent. Running the script again writes the same bytes.

Run it as ``python -m tools.draw.figures``.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.patches import Arc, FancyBboxPatch, Polygon, Rectangle

from tools import ROOT
from tools.draw.color_figures import draw_hsv_cylinder, draw_hue_wheel
from tools.draw.ray_figures import draw_horizon, draw_thickness
from tools.draw.svg_ink import (
    ACCENT,
    COOL,
    INK,
    STYLE,
    WASH,
    X_RED,
    Y_GREEN,
    Z_BLUE,
    arrow,
    dot,
    label,
    line,
    make_axes,
    measure,
    save,
)

if TYPE_CHECKING:
    from pathlib import Path

    from matplotlib.axes import Axes

FIGURES = ROOT / "book" / "_static" / "figures"


def draw_pinhole() -> Axes:
    """Rays through one hole: the picture behind it is upside down, the one in front is not."""
    ax = make_axes((-2.5, 7.2), (-2.1, 2.35))
    focal, depth, height = 1.6, 5.6, 1.5
    for y, color in ((height, ACCENT), (-height, COOL)):
        line(ax, (depth, y), (-focal, -y * focal / depth), color, lw=1.2)
    arrow(ax, (depth, -height), (depth, height), INK, lw=3)
    half = height * focal / depth
    arrow(ax, (focal, -half), (focal, half), INK, lw=2.4)
    arrow(ax, (-focal, half), (-focal, -half), INK, lw=2.4)
    arrow(ax, (-2.3, 0), (7.1, 0), INK, lw=0.9)
    for low, high in ((-1.5, -0.07), (0.07, 1.5)):  # the wall with the hole
        line(ax, (0, low), (0, high), lw=4)
    line(ax, (-focal, -1.1), (-focal, 1.1), style="--", lw=1)
    line(ax, (focal, -1.1), (focal, 1.1), style="--", lw=1)
    label(ax, (0, 1.78), "pinhole")
    label(ax, (-focal, 1.38), "sensor")
    label(ax, (focal + 0.35, 1.38), "image plane")
    label(ax, (depth, 1.78), "object")
    label(ax, (7.15, 0.25), "optical axis", ha="right", fontsize=10)
    measure(ax, (-focal, -1.35), (0, -1.35), "$f$", (0, -0.22))
    measure(ax, (0, -1.35), (focal, -1.35), "$f$", (0, -0.22))
    measure(ax, (0, -1.85), (depth, -1.85), "$Z$", (1.2, 0.22))
    return ax


def draw_similar_triangles() -> Axes:
    """Side view of the frustum: the small triangle at f and the large one at Z have one shape."""
    ax = make_axes((-0.75, 7.3), (-2.75, 2.75))
    focal, depth, half_angle, y = 2.1, 5.9, np.deg2rad(22.5), 1.55
    slope = np.tan(half_angle)
    for sign in (1, -1):
        line(ax, (0, 0), (6.6, sign * 6.6 * slope), lw=1)
    arrow(ax, (0, 0), (7.1, 0), Z_BLUE)
    arrow(ax, (0, 0), (0, -1.0), Y_GREEN)
    label(ax, (7.2, 0.22), "$z$", Z_BLUE)
    label(ax, (-0.22, -0.95), "$y$", Y_GREEN)
    ax.add_patch(Polygon([(0, 0), (depth, 0), (depth, -y)], fc=COOL, alpha=WASH, ec="none"))
    ax.add_patch(
        Polygon([(0, 0), (focal, 0), (focal, -y * focal / depth)], fc=ACCENT, alpha=0.3, ec="none")
    )
    line(ax, (0, 0), (depth, -y), COOL)
    line(ax, (depth, 0), (depth, -y), COOL)
    dot(ax, (depth, -y), COOL)
    label(ax, (depth + 0.18, -y), "point $(Y, Z)$", COOL, "left", va="top", fontsize=11)
    label(ax, (depth + 0.15, -y / 2), "$Y$", COOL, "left")
    half = focal * slope
    line(ax, (focal, -half), (focal, half), lw=3)
    line(ax, (focal, 0), (focal, -y * focal / depth), ACCENT, lw=4)
    dot(ax, (focal, -y * focal / depth), ACCENT)
    label(ax, (focal + 0.12, -0.27), r"$v - c_y$", ACCENT, "left", fontsize=11)
    label(
        ax,
        (focal + 0.3, half + 0.2),
        "image plane,\n$H$ pixels high",
        ha="right",
        va="bottom",
        fontsize=11,
    )
    measure(ax, (focal - 0.22, 0.03), (focal - 0.22, half), "$H/2$", (-0.36, 0.02))
    ax.add_patch(Arc((0, 0), 1.9, 1.9, theta1=-22.5, theta2=22.5, color=INK, lw=1.2))
    label(ax, (0.62, 0.12), r"$\theta$")
    measure(ax, (0, -1.55), (focal, -1.55), "$f$", (0, -0.25), color=ACCENT)
    measure(ax, (0, -2.3), (depth, -2.3), "$Z$", (0, -0.25), color=COOL)
    label(ax, (4.6, 2.5), r"$\tan\frac{\theta}{2} = \frac{H/2}{f}$", fontsize=16, ha="right")
    label(ax, (5.0, 0.7), r"$\frac{v - c_y}{f} = \frac{Y}{Z}$", fontsize=17)
    dot(ax, (0, 0))
    label(ax, (-0.1, 0.35), "pinhole", fontsize=11, ha="center")
    return ax


def project_oblique(points: Any) -> np.ndarray:
    """Draw 3-D as a cabinet projection: right and up stay, forward goes up to the right."""
    right, up, forward = np.asarray(points, float).T
    return np.stack([right + 0.62 * forward, up + 0.42 * forward], axis=-1)


def draw_one_camera(ax: Axes, x: float, title: str, axes: dict[str, Any], names: str) -> None:
    """Draw a camera seen from behind, with the pyramid it looks into and its axes."""
    offset = np.array([x, 0.0])
    corners = np.array([(-0.8, -0.6, 2), (0.8, -0.6, 2), (0.8, 0.6, 2), (-0.8, 0.6, 2)])
    flat = project_oblique(corners) + offset
    ax.add_patch(Polygon(flat, fc=INK, alpha=WASH, ec="none"))
    for k, corner in enumerate(flat):
        line(ax, offset, corner, lw=0.9)
        line(ax, corner, flat[(k + 1) % 4], lw=0.9)
    for letter, (direction, color) in axes.items():
        tip = project_oblique([direction])[0]
        arrow(ax, offset, offset + tip, color, lw=2.6)
        label(ax, offset + tip * (1 + 0.24 / np.linalg.norm(tip)), letter, color, weight="bold")
    dot(ax, offset, size=7)
    label(ax, (x + 0.25, 2.35), title, weight="bold", fontsize=13)
    label(ax, (x + 0.25, -1.95), names, fontsize=10.5)


def draw_camera_axes() -> Axes:
    """MuJoCo's camera looks along -z with y up; OpenCV's along +z with y down."""
    ax = make_axes((-1.75, 6.45), (-2.75, 2.7))
    right, up, forward = (1.25, 0, 0), (0, 1.2, 0), (0, 0, 1.5)
    down, backward = (0, -1.2, 0), (0, 0, -1.5)
    mujoco = {"x": (right, X_RED), "y": (up, Y_GREEN), "z": (backward, Z_BLUE)}
    opencv = {"x": (right, X_RED), "y": (down, Y_GREEN), "z": (forward, Z_BLUE)}
    draw_one_camera(ax, 0.0, "MuJoCo", mujoco, "x right, y up, z backward")
    draw_one_camera(ax, 4.2, "OpenCV", opencv, "x right, y down, z forward")
    label(ax, (2.35, -2.5), "turn by 180° about x:  diag$(1, -1, -1)$", ACCENT)
    return ax


def draw_pixel_centers() -> Axes:
    """On a grid of whole-number centers the middle is (W-1)/2, half a pixel from W/2."""
    width, height = 6, 4
    ax = make_axes((-1.5, 7.9), (5.15, -1.75))
    for u in range(width):
        for v in range(height):
            ax.add_patch(Rectangle((u - 0.5, v - 0.5), 1, 1, fc="none", ec=INK, lw=1.1))
            dot(ax, (u, v), size=4)
    for u in range(width):
        label(ax, (u, -0.78), str(u))
    for v in range(height):
        label(ax, (-0.78, v), str(v))
    arrow(ax, (-0.5, -1.2), (1.4, -1.2))
    label(ax, (1.6, -1.2), "$u$", ha="left")
    arrow(ax, (-1.2, -0.5), (-1.2, 1.2))
    label(ax, (-1.2, 1.45), "$v$")
    middle, rival = ((width - 1) / 2, (height - 1) / 2), (width / 2, height / 2)
    for at, color, mark in ((middle, ACCENT, "P"), (rival, COOL, "X")):
        ax.plot(*at, mark, color=color, ms=11)
    arrow(ax, (5.75, 0.55), (middle[0] + 0.2, middle[1] - 0.06), ACCENT, lw=1.1)
    arrow(ax, (5.75, 2.45), (rival[0] + 0.2, rival[1] + 0.03), COOL, lw=1.1)
    label(ax, (5.85, 0.5), "the middle:\n$(W-1)/2$,\n$(H-1)/2$", ACCENT, "left", fontsize=11)
    label(ax, (5.85, 2.45), "$W/2$, $H/2$:\n½ pixel off", COOL, "left", fontsize=11)
    measure(
        ax,
        (-0.5, 4.0),
        (width - 0.5, 4.0),
        "$W = 6$ pixels, from $u = -½$ to $u = W - ½$",
        (0, 0.5),
    )
    return ax


def draw_depth_vs_range() -> Axes:
    """Every pixel of a flat wall has one depth, but its own ray length."""
    ax = make_axes((-0.9, 6.6), (-2.55, 2.75))
    depth, top = 4.6, 2.1
    line(ax, (depth, -2.2), (depth, 2.2), lw=5)
    label(ax, (depth + 0.2, -1.9), "flat wall", ha="left")
    for y in np.linspace(-2.0, 2.0, 9):
        line(ax, (0, 0), (depth, y), lw=0.6, style=":")
    ax.add_patch(
        Arc((0, 0), 2 * depth, 2 * depth, theta1=-28, theta2=28, color=COOL, lw=1.3, ls="--")
    )
    line(ax, (0, 0), (depth, top), COOL, lw=2.2)
    dot(ax, (depth, top), COOL)
    label(ax, (2.0, 1.38), "ray length $r$", COOL, rotation=np.rad2deg(np.arctan2(top, depth)))
    arrow(ax, (0, 0), (depth, 0), ACCENT, lw=2.2)
    label(ax, (2.6, -0.28), "depth $z$", ACCENT)
    arrow(ax, (depth, 0), (6.3, 0), INK, lw=0.9)
    label(ax, (6.5, -0.3), "optical axis", ha="right", fontsize=10)
    line(ax, (0, 0), (0, top), style=":", lw=0.9)
    arrow(ax, (0, top), (depth, top), ACCENT, lw=1.4)
    label(ax, (2.0, top + 0.25), "depth $z$, the same", ACCENT)
    label(ax, (0.1, -2.05), "equal ray length:\nthe dashed arc", COOL, "left", fontsize=11)
    dot(ax, (0, 0))
    label(ax, (-0.15, -0.35), "camera", fontsize=11)
    return ax


def draw_stereo() -> Axes:
    """Top view of two cameras: the nearer the point, the larger the shift between the pictures."""
    ax = make_axes((-2.9, 4.5), (-1.1, 5.2))
    focal, half, x, depth = 1.2, 1.2, 0.35, 4.6
    for name, letter, center in (("left", "L", -half), ("right", "R", half)):
        hit = center + (x - center) * focal / depth
        line(ax, (center - 0.85, focal), (center + 0.85, focal), lw=3)
        line(ax, (center, 0), (center, focal + 0.35), style=":", lw=1)
        line(ax, (center, 0), (x, depth), COOL, lw=1.4)
        line(ax, (center, focal), (hit, focal), ACCENT, lw=4)
        dot(ax, (hit, focal), ACCENT)
        dot(ax, (center, 0))
        label(ax, (center, -0.3), name, fontsize=11)
        side, ha = (-0.1, "right") if name == "left" else (0.1, "left")
        label(ax, (center + side, focal + 0.3), f"$u_{letter} - c_x$", ACCENT, ha, fontsize=11)
    dot(ax, (x, depth), COOL, 8)
    label(ax, (x, depth + 0.32), "point", COOL)
    measure(ax, (-half, -0.62), (half, -0.62), "baseline $b$", (0, -0.26))
    measure(ax, (-2.45, 0), (-2.45, depth), "$Z$", (-0.25, 0))
    measure(ax, (2.35, 0), (2.35, focal), "$f$", (0.25, 0))
    label(ax, (1.75, 3.85), r"$d = u_L - u_R$", ACCENT, "left", fontsize=13)
    label(ax, (1.75, 3.05), r"$Z = \frac{f\,b}{d}$", COOL, "left", fontsize=16)
    return ax


def draw_pipeline() -> Axes:
    """Show what becomes of a scene: pictures, a matrix, a mask, points; each with its step."""
    ax = make_axes((-0.15, 10.15), (-0.25, 8.95))
    boxes = {  # name: (x, y, text, step)
        "scene": (5.0, 8.1, "scene", "start"),
        "rgb": (1.6, 6.0, "RGB picture", "step 1"),
        "depth": (5.0, 6.0, "depth, meters", "steps 1, 3"),
        "K": (8.4, 6.0, "matrix $K$", "step 2"),
        "mask": (1.6, 3.6, "mask", "step 4"),
        "points": (6.7, 3.6, "back-projection", "steps 4, 5"),
        "place": (1.6, 0.9, "object in 3-D", "step 4"),
        "cloud": (5.0, 0.9, "point cloud", "step 5"),
        "view": (8.4, 0.9, "view, PLY", "step 6"),
    }
    for x, y, text, step in boxes.values():
        ax.add_patch(
            FancyBboxPatch(
                (x - 1.4, y - 0.5), 2.8, 1.0, boxstyle="round,pad=0.1", fc="none", ec=INK
            )
        )
        label(ax, (x, y + 0.2), text, fontsize=11.5)
        label(ax, (x, y - 0.27), step, ACCENT, fontsize=10)
    downward = ("scene rgb", "scene depth", "scene K", "rgb mask", "depth points", "K points",
                "mask place", "points place", "points cloud")  # fmt: skip
    for pair in downward:
        start, end = (boxes[name] for name in pair.split())
        # Lines into one box end side by side, each on the side it comes from.
        nudge = np.clip(0.3 * (start[0] - end[0]), -0.7, 0.7)
        arrow(ax, (start[0] - nudge, start[1] - 0.62), (end[0] + nudge, end[1] + 0.62), lw=1.2)
    arrow(ax, (6.52, 0.9), (6.88, 0.9), lw=1.2)
    return ax


DRAWINGS = {
    "pinhole": draw_pinhole,
    "similar_triangles": draw_similar_triangles,
    "camera_axes": draw_camera_axes,
    "pixel_centers": draw_pixel_centers,
    "depth_vs_range": draw_depth_vs_range,
    "stereo": draw_stereo,
    "pipeline": draw_pipeline,
    "horizon": draw_horizon,
    "thickness": draw_thickness,
    "hue_wheel": draw_hue_wheel,
    "hsv_cylinder": draw_hsv_cylinder,
}


def main(folder: Path = FIGURES) -> None:
    """Draw them all."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, draw in DRAWINGS.items():
        with mpl.rc_context(STYLE):  # type: ignore[arg-type]  # stubs want literal keys
            save(draw(), folder / f"{name}.svg")
    print(f"{len(DRAWINGS)} drawings in {folder.name}")


if __name__ == "__main__":
    main()
