"""What a controller did over time, drawn by OpenCV alone, so that it also works in the browser."""

from __future__ import annotations

import cv2
import numpy as np

from labutils.checks.loops.trace import BOUND_PX, Column
from labutils.checks.verdict import PanelPicture

_WIDTH, _HEIGHT = 460, 190
_LEFT, _TOP, _BOTTOM = 44, 26, 30
_PAPER, _INK = (255, 255, 255), (60, 55, 50)
_HIDDEN, _MEASURED = (215, 215, 215), (252, 244, 232)
_BOUND = (178, 114, 0)  # Okabe-Ito blue, BGR
_YOURS = (0, 94, 213)  # Okabe-Ito vermilion, BGR
#: Errors above this many pixels are cut off: what matters is beside the bound.
_HIGHEST_PX = 120.0


def draw_errors(name: str, trace: np.ndarray) -> PanelPicture | None:
    """Draw the distance of the ball from the middle over time, with the bound.

    Parameters
    ----------
    name : str
        What the answer is called, for the summary.
    trace : np.ndarray
        Shape (N, COLUMNS).
    """
    errors = trace[:, Column.ERROR_PX]
    top = float(np.clip(1.1 * errors.max(), 3 * BOUND_PX, _HIGHEST_PX))
    summary = (
        f"{name}: distance of the ball from the middle over time, in pixels of a picture 640 wide; "
        f"the line is the bound of {BOUND_PX:.0f}, gray is hidden, blue is measured"
    )
    return _draw(trace, errors, top, BOUND_PX, "ball to middle, px of 640", summary)


def draw_commands(name: str, trace: np.ndarray) -> PanelPicture | None:
    """Draw by how much commands lie beyond their limits."""
    beyond = trace[:, Column.BEYOND]
    finite = beyond[np.isfinite(beyond)]
    top = 1.1 * float(finite.max(initial=0.05))
    summary = f"{name}: radians by which commands lie beyond their limits, over time"
    return _draw(trace, beyond, top, 0.0, "command beyond its limit, rad", summary)


def _draw(
    trace: np.ndarray, values: np.ndarray, top: float, bound: float, title: str, summary: str
) -> PanelPicture | None:
    sheet = np.full((_HEIGHT, _WIDTH, 3), 255, np.uint8)
    times = trace[:, Column.TIME]
    end = float(times[-1]) + 0.05
    right, low = _WIDTH - 10, _HEIGHT - _BOTTOM

    def to_u(seconds: float) -> int:
        return round(_LEFT + (right - _LEFT) * seconds / end)

    def to_v(value: float) -> int:
        return round(low - (low - _TOP) * min(value, top) / top)

    for column, color in ((Column.MEASURED, _MEASURED), (Column.IS_HIDDEN, _HIDDEN)):
        for moment in times[trace[:, column] > 0]:
            cv2.rectangle(sheet, (to_u(moment), _TOP), (to_u(moment + 0.05), low), color, -1)
    cv2.rectangle(sheet, (_LEFT, _TOP), (right, low), _INK, 1)
    cv2.line(sheet, (_LEFT, to_v(bound)), (right, to_v(bound)), _BOUND, 2)
    places = [(to_u(moment), to_v(value)) for moment, value in zip(times, values, strict=True)]
    cv2.polylines(sheet, [np.array(places, np.int32)], isClosed=False, color=_YOURS, thickness=2)
    _write(sheet, title, (_LEFT, 17))
    for value in (bound, top):
        _write(sheet, f"{value:.3g}", (4, to_v(value) + 5))
    for second in range(int(end) + 1):
        _write(sheet, f"{second} s" if second else "0", (to_u(second) - 4, low + 18))
    done, png = cv2.imencode(".png", sheet)
    return PanelPicture(png.tobytes(), summary) if done else None


def _write(sheet: np.ndarray, text: str, place: tuple[int, int]) -> None:
    cv2.putText(sheet, text, place, cv2.FONT_HERSHEY_SIMPLEX, 0.42, _INK, 1, cv2.LINE_AA)
