"""Expected, yours and the difference side by side, with the worst place marked.

Drawn by OpenCV alone, so that it also works in the browser.
"""

from __future__ import annotations

import cv2
import numpy as np

from labutils.checks.verdict import PanelPicture

_PANEL = 220  # pixels, the longer side of one panel
_GAP = 8
_CAPTION = 22
_PAPER = (255, 255, 255)
_INK = (60, 55, 50)
_NO_VALUE = (150, 150, 150)  # gray is in no color map
_EXPECTED = (178, 114, 0)  # Okabe-Ito blue, BGR
_YOURS = (0, 94, 213)  # Okabe-Ito vermilion, BGR
_MARK = (200, 0, 200)
_MAX_DOTS = 5000  # more do not fit into a panel


def draw_pictures(
    name: str,
    expected_bgr: np.ndarray,
    yours_bgr: np.ndarray,
    gaps: np.ndarray,
    wrong: np.ndarray,
    difference_bgr: np.ndarray | None = None,
) -> PanelPicture | None:
    """Draw two pictures of one size and how far they are apart.

    Parameters
    ----------
    name : str
        What is drawn, for the summary.
    expected_bgr, yours_bgr : np.ndarray
        uint8, shape (H, W, 3).
    gaps, wrong : np.ndarray
        How far each value is off, and whether by too much: shape (H, W) or (H, W, 3).
    difference_bgr : np.ndarray or None
        The third panel, uint8, shape (H, W, 3); None draws the gaps.
    """
    if gaps.ndim == 3:
        gaps, wrong = gaps.max(axis=2), np.asarray(wrong.any(axis=2))
    v, u = (int(place) for place in np.unravel_index(int(np.argmax(gaps)), gaps.shape))
    third = _paint_difference(gaps, wrong) if difference_bgr is None else difference_bgr
    panels = [expected_bgr, yours_bgr, third]
    scale = max(1, _PANEL // max(gaps.shape))
    panels = [_fit(panel, scale) for panel in panels]
    for panel in panels:
        _mark(panel, (u, v), panel.shape[1] / gaps.shape[1])
    return _join(
        panels,
        ("expected", "yours", "difference"),
        f"{name}: expected, yours, difference; worst pixel (u, v) = {(u, v)}",
    )


def draw_clouds(
    name: str, expected: np.ndarray, yours: np.ndarray, gaps: np.ndarray | None
) -> PanelPicture | None:
    """Draw two clouds along the third axis, and one over the other; None where one is empty.

    Parameters
    ----------
    name : str
        What is drawn, for the summary.
    expected, yours : np.ndarray
        Shapes (N, 2) or (N, 3), (M, 2) or (M, 3); the first two columns are drawn.
    gaps : np.ndarray or None
        How far each row is off, shape (N,), where rows stand for each other.
    """
    some = [cloud[:: len(cloud) // _MAX_DOTS + 1] for cloud in (expected, yours)]
    finite = [cloud[np.isfinite(cloud).all(axis=1)] for cloud in some]
    if not all(len(cloud) for cloud in finite):
        return None
    both = np.concatenate(finite)[:, :2].astype(np.float64)
    low, high = both.min(axis=0), both.max(axis=0)
    scale = (_PANEL - 16) / max(float((high - low).max()), 1e-9)
    panels = []
    for chosen in ([0], [1], [0, 1]):
        panel = np.full((*(np.ceil((high - low) * scale) + 16).astype(int)[::-1], 3), 250, np.uint8)
        for number in chosen:
            places = np.round((finite[number][:, :2] - low) * scale + 8).astype(int)
            # Yours are smaller, so that both stay visible where they agree.
            for shift in np.ndindex(4 - 2 * number, 4 - 2 * number):
                u, v = (places + shift - 1 + number).T
                panel[v, u] = (_EXPECTED, _YOURS)[number]
        panels.append(panel)
    where = ""
    if gaps is not None:
        row = int(np.argmax(gaps))
        where = f"; worst row {row}"
        for panel, cloud in ((panels[0], expected), (panels[1], yours)):
            if np.isfinite(cloud[row]).all():
                # A row that is not among the drawn ones may lie outside the panel.
                u, v = np.clip((cloud[row, :2] - low) * scale + 8, 0, _PANEL)
                _mark(panel, (int(u), int(v)), 1.0)
    summary = f"{name}: expected, yours, both (x to the right, y down){where}"
    return _join(panels, ("expected", "yours", "both"), summary)


def paint_values(values: np.ndarray, low: float, high: float) -> np.ndarray:
    """Draw numbers in colors, BGR; what is no number is gray."""
    known = np.isfinite(values)
    share = (np.where(known, values, low).astype(np.float64) - low) / max(high - low, 1e-12)
    levels = (np.clip(share, 0.0, 1.0) * 255).astype(np.uint8)
    panel = cv2.applyColorMap(levels, cv2.COLORMAP_TURBO)
    panel[~known] = _NO_VALUE
    return panel


def paint_signs(differences: np.ndarray, wrong: np.ndarray) -> np.ndarray:
    """Draw differences as BGR: white where they agree, blue below zero, red above, gray for NaN."""
    panel = np.empty((*differences.shape, 3), np.uint8)
    finite = np.where(np.isfinite(differences), differences, 0.0)
    for color, side in ((_EXPECTED, finite < 0), (_YOURS, finite >= 0)):
        panel[side] = _paint_difference(np.abs(finite), wrong, color)[side]
    panel[wrong & ~np.isfinite(differences)] = _NO_VALUE
    return panel


def _fit(panel: np.ndarray, scale: int) -> np.ndarray:
    """Enlarge by a whole factor so that pixels stay sharp; shrink what is too large."""
    if scale > 1:
        return cv2.resize(panel, None, fx=scale, fy=scale, interpolation=cv2.INTER_NEAREST)
    share = min(1.0, _PANEL / max(panel.shape[:2]))
    return cv2.resize(panel, None, fx=share, fy=share, interpolation=cv2.INTER_AREA)


def _paint_difference(
    gaps: np.ndarray, wrong: np.ndarray, color: tuple[int, int, int] = _YOURS
) -> np.ndarray:
    """White where both agree, in a darker color the further they are apart."""
    finite = gaps[np.isfinite(gaps)]
    top = float(finite.max()) if finite.size and finite.max() > 0 else 1.0
    share = np.clip(np.where(np.isfinite(gaps), gaps, top) / top, 0.0, 1.0)
    strength = np.where(wrong, 0.35 + 0.65 * share, 0.0)[..., None]
    return np.round(np.array(_PAPER) * (1 - strength) + np.array(color) * strength).astype(np.uint8)


def _mark(panel: np.ndarray, pixel: tuple[int, int], scale: float) -> None:
    center = (int((pixel[0] + 0.5) * scale), int((pixel[1] + 0.5) * scale))
    radius = max(6, round(scale))
    cv2.circle(panel, center, radius, _PAPER, 4)
    cv2.circle(panel, center, radius, _MARK, 2)


def _join(
    panels: list[np.ndarray], names: tuple[str, str, str], summary: str
) -> PanelPicture | None:
    height = max(panel.shape[0] for panel in panels) + _CAPTION
    width = sum(panel.shape[1] for panel in panels) + _GAP * (len(panels) - 1)
    sheet = np.full((height, width, 3), 255, dtype=np.uint8)
    left = 0
    for name, panel in zip(names, panels, strict=True):
        right = left + panel.shape[1]
        sheet[_CAPTION : _CAPTION + panel.shape[0], left:right] = panel
        cv2.putText(
            sheet, name, (left + 2, 15), cv2.FONT_HERSHEY_SIMPLEX, 0.45, _INK, 1, cv2.LINE_AA
        )
        left = right + _GAP
    done, png = cv2.imencode(".png", sheet)
    return PanelPicture(png.tobytes(), summary) if done else None
