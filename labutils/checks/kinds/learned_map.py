"""Learn a color map nobody has listed from the pictures that were drawn with it.

Any map from blue to red is right. Which one was used shows in all pictures of an answer together:
if one color belongs to one depth in all of them, and the colors lead from blue to red, that is a
map, and the pictures can be read with it.
"""

from __future__ import annotations

import cv2
import numpy as np

from labutils.checks.kinds.color_levels import BLACK_LEVEL, get_color_maps, to_levels

#: How far a color may lie from the mean of its level: rounding and one level, since a level may be
#: rounded in one pixel and cut off in another. How steep a map is, so many levels tell.
_COLOR_ROUNDING = 4.0
_WINDOW = 2

#: How steep a part of a map may be taken for, in multiples of what is typical of it: levels that
#: were not drawn hide steps.
_LEAST_STEEP, _STEEPEST = 2.0, 3.0

#: Levels at either end of the range, and how much blue or red has to stand out there.
_END_LEVELS = 8
_STANDS_OUT = 40.0

#: How far the colors of a listed map move where it is interpolated between its levels.
_NEAR_LISTED = 8.0

#: With fewer levels than this, nothing of a map can be seen.
_MIN_LEVELS = 32

#: Levels that share a color: a map of hues has 120 colors for 256 levels.
_SAME_COLOR_LEVELS = 6


def read_with_learned_map(
    dues: list[np.ndarray], pictures: list[np.ndarray]
) -> list[np.ndarray] | None:
    """Draw pictures again in a map that is known, if they have been drawn in one map of their own.

    Parameters
    ----------
    dues : list of ndarray, uint8, shape (H, W, 3)
        What is due, in a known map, BGR.
    pictures : list of ndarray, uint8, shape (H, W, 3)
        What came for them.

    Returns
    -------
    list of ndarray or None
        The pictures in COLORMAP_TURBO; None where they were drawn in no single map from blue to
        red. A black pixel stays black.
    """
    if any(x.shape != y.shape or y.dtype != np.uint8 for x, y in zip(dues, pictures, strict=True)):
        return None
    levels = np.concatenate([to_levels(due).ravel() for due in dues])
    colors = np.concatenate([picture.reshape(-1, 3) for picture in pictures]).astype(np.float64)
    seen = (levels != BLACK_LEVEL) & colors.any(axis=1)
    present = np.unique(levels[seen])
    if len(present) < _MIN_LEVELS:
        return None
    # The middle one of a level's colors: a few that are wrong do not move it.
    table = np.stack([np.median(colors[seen & (levels == level)], axis=0) for level in present])
    leads = _leads_from_blue_to_red(present, table) or _is_near_listed_map(present, table)
    if not (leads and _tells_levels_apart(present, table)):
        return None
    if not _belong_to(present, table, levels[seen], colors[seen]):
        return None
    return [_draw_again(due, picture) for due, picture in zip(dues, pictures, strict=True)]


def _is_near_listed_map(present: np.ndarray, table: np.ndarray) -> bool:
    """Tell whether it is a listed map, interpolated: COLORMAP_TURBO begins nearly black."""
    return any(np.abs(table - one[present]).max() <= _NEAR_LISTED for one in get_color_maps())


def _leads_from_blue_to_red(present: np.ndarray, table: np.ndarray) -> bool:
    """Tell whether the ends of the range are there, one of them blue and the other red."""
    low, high = table[present <= _END_LEVELS], table[present >= 255 - _END_LEVELS]
    if not len(low) or not len(high):
        return False
    blue, red = low.mean(axis=0), high.mean(axis=0)
    return bool(
        blue[0] > blue[2] + _STANDS_OUT
        and red[2] > red[0] + _STANDS_OUT
        and red[2] > red[1] + _STANDS_OUT
    )


def _tells_levels_apart(present: np.ndarray, table: np.ndarray) -> bool:
    """Tell whether levels that are not neighbors have colors of their own."""
    gaps = np.abs(table[:, None] - table[None]).max(axis=2)
    apart = np.abs(present[:, None] - present[None]) > _SAME_COLOR_LEVELS
    return bool((gaps[apart] > 1).all())


def _belong_to(
    present: np.ndarray, table: np.ndarray, levels: np.ndarray, colors: np.ndarray
) -> bool:
    """Tell whether every pixel has the color of its level, or of one beside it."""
    places = np.searchsorted(present, levels)
    # How much the color changes from one level to the next, at most, near each level.
    steps = np.abs(np.diff(table, axis=0)).max(axis=1)
    slopes = steps / np.diff(present)
    padded = np.pad(slopes, (_WINDOW, _WINDOW + 1), mode="edge")
    steep = np.lib.stride_tricks.sliding_window_view(padded, 2 * _WINDOW + 1).max(axis=1)
    typical = steps.sum() / (present[-1] - present[0])
    limits = _LEAST_STEEP * typical, _STEEPEST * typical
    slack = _COLOR_ROUNDING + np.clip(steep[: len(table)], *limits)
    return bool((np.abs(colors - table[places]).max(axis=1) <= slack[places]).all())


def _draw_again(due: np.ndarray, picture: np.ndarray) -> np.ndarray:
    levels = to_levels(due)
    drawn = cv2.applyColorMap(np.clip(levels, 0, 255).astype(np.uint8), cv2.COLORMAP_TURBO)
    black = ~picture.any(axis=2)
    drawn[black] = 0
    # Where black is due and a color came, the color itself is what is wrong.
    colored = (levels == BLACK_LEVEL) & ~black
    drawn[colored] = picture[colored]
    return np.asarray(drawn)
