"""Draw what the stored runs of the chapter on following show: errors over time, and two knobs.

Three SVG of ``book/_static/figures``, drawn from ``book/_generated/following.json``, which
`tools/draw/following_runs.py` writes. Running the script again writes the same bytes.

Run it as ``python -m tools.draw.following_figures``.
"""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

from tools.draw.figures import FIGURES
from tools.draw.following_runs import DATA
from tools.draw.svg_ink import ACCENT, COOL, INK, STYLE, WASH, WIDTH, label, save

if TYPE_CHECKING:
    from pathlib import Path

    from matplotlib.axes import Axes

HEIGHT = 2.7  # inches
DT = 0.05  # seconds from one value of a curve to the next
NEAR_PX = 15.0
EDGE_PX = 320.0  # farther from the middle a ball is out of the picture, to the side
GREEN = "#2a8c4c"
#: What the runs are called in the figures, and their colors.
NAMES = {
    "proportional": ("proportional", COOL),
    "predicting": ("predicting", GREEN),
    "pose_of_now": ("pose of now", ACCENT),
}


def draw_still(done: dict[str, Any]) -> Axes:
    """Let a ball stand still while its pictures come late: one head settles, one swings."""
    (ax,) = make_plots("time (s)", columns=1)
    for one in done["still"]:
        draw_curve(ax, one, NAMES[one["controller"]][1])
    label(ax, (0.1, 240), "pose of now", ACCENT, "left")
    label(ax, (2.0, 22), "pose of the picture", COOL, "left")
    ax.set_xlim(0, 4)
    ax.set_ylim(0, EDGE_PX)
    return ax


def draw_runs(done: dict[str, Any]) -> Axes:
    """Follow the same ball with and without looking ahead, hidden once."""
    (ax,) = make_plots("time (s)", columns=1)
    seed = [one for one in done["table"] if one["settings"]["seed"] == 0]
    drawn = {one["controller"]: one for one in seed if one["controller"] in NAMES}
    hidden = drawn["predicting"]["hidden"]
    ax.axvspan(hidden[0], hidden[-1] + DT, color=INK, alpha=WASH, lw=0)
    ax.axhline(NEAR_PX, color=INK, lw=1, ls="--")
    places = {"proportional": (5.5, 31), "predicting": (5.5, 19)}
    for name, place in places.items():
        draw_curve(ax, drawn[name], NAMES[name][1])
        label(ax, place, NAMES[name][0], NAMES[name][1], "left")
    label(ax, (hidden[0] + 0.48, 4), "hidden", INK, fontsize=10)
    ax.set_xlim(0, 8)
    ax.set_ylim(0, 60)
    return ax


def draw_knobs(done: dict[str, Any]) -> Axes:
    """Turn the gain, and let pictures come later."""
    left, right = make_plots("gain", "delay of the picture (ms)", columns=2)
    points = [(one["settings"]["gain"], one["score"]["mean_px"]) for one in done["gains"]]
    draw_points(left, points, COOL)
    label(left, (0.55, 62), "proportional", COOL, "left")
    for name in ("pose_of_now", "proportional", "predicting"):
        some = [one for one in done["delays"] if one["controller"] == name]
        points = [(1000 * DT * one["settings"]["delay"], one["score"]["mean_px"]) for one in some]
        draw_points(right, points, NAMES[name][1])
    places = {"pose_of_now": (80, 115), "proportional": (150, 52), "predicting": (150, 9.5)}
    for name, place in places.items():
        label(right, place, NAMES[name][0], NAMES[name][1], "right")
    for ax in (left, right):
        ax.axhline(EDGE_PX, color=INK, lw=1, ls=":")
        ax.set_yscale("log")
        ax.set_ylim(4, 420)
        ax.set_yticks([5, 10, 20, 50, 100, 200], ["5", "10", "20", "50", "100", "200"])
        ax.minorticks_off()
    label(left, (0.25, 265), "out of the picture", INK, "left", fontsize=10)
    right.set_yticklabels([])
    return left


def make_plots(*names: str, columns: int) -> list[Axes]:
    """Return plots side by side, the first with the axis of distances."""
    figure = Figure(figsize=(WIDTH, HEIGHT), layout="constrained")
    plots = np.ravel(figure.subplots(1, columns)).tolist()
    for ax, name in zip(plots, names, strict=True):
        ax.set_xlabel(name, fontsize=11)
        ax.tick_params(colors=INK, labelsize=10, which="both")
        ax.grid(color=INK, alpha=WASH, lw=0.6)
        for side, spine in ax.spines.items():
            spine.set_visible(side in {"left", "bottom"})
            spine.set_color(INK)
    plots[0].set_ylabel("off the middle (px)", fontsize=11)
    for ax in plots:
        ax.xaxis.label.set_color(INK)
        ax.yaxis.label.set_color(INK)
    return plots


def draw_curve(ax: Axes, one: dict[str, Any], color: str) -> None:
    """Draw the distances of a run over time."""
    errors = one["error_px"]
    ax.plot(DT * np.arange(len(errors)), errors, color=color, lw=1.7)


def draw_points(ax: Axes, points: list[tuple[float, float]], color: str) -> None:
    """Draw one number per run; what is out of the picture is drawn at its edge."""
    points = [(x, min(y, EDGE_PX)) for x, y in points]
    ax.plot(*zip(*points, strict=True), "o-", color=color, lw=1.5, ms=4.5)


DRAWINGS = {
    "following_still": draw_still,
    "following_runs": draw_runs,
    "following_knobs": draw_knobs,
}


def main(folder: Path = FIGURES) -> None:
    """Draw them all."""
    done = json.loads(DATA.read_text(encoding="utf-8"))
    for name, draw in DRAWINGS.items():
        with mpl.rc_context(STYLE):  # type: ignore[arg-type]  # stubs want literal keys
            save(draw(done), folder / f"{name}.svg")
    print(f"{len(DRAWINGS)} drawings in {folder.name}")


if __name__ == "__main__":
    main()
