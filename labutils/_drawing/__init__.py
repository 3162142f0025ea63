"""Draw the book's figures: with Matplotlib where it is installed, else as SVG by NumPy and OpenCV.

`labutils.figures` says what a figure shows (`labutils._drawing.parts`); what is drawn is the same
either way. The browser has no Matplotlib, so its figures are SVG.
"""

from __future__ import annotations

import contextlib
import importlib.util
from contextvars import ContextVar
from typing import TYPE_CHECKING, Literal

if TYPE_CHECKING:
    from collections.abc import Iterator

    import numpy as np

    from labutils._drawing.parts import Plot, Sheet
    from labutils._picture import Picture

Backend = Literal["matplotlib", "svg"]

_asked: ContextVar[Backend | None] = ContextVar("backend", default=None)


@contextlib.contextmanager
def use_backend(name: Backend) -> Iterator[None]:
    """Draw with one of the two inside a ``with`` block, whatever is installed."""
    before = _asked.set(name)
    try:
        yield
    finally:
        _asked.reset(before)


def get_backend() -> Backend:
    """Tell what draws: as asked by `use_backend`, else Matplotlib if it is installed."""
    installed: Backend = "matplotlib" if importlib.util.find_spec("matplotlib") else "svg"
    return _asked.get() or installed


def draw(figure: Plot | Sheet) -> Picture:
    """Draw a figure."""
    if get_backend() == "matplotlib":
        from labutils._drawing import with_matplotlib  # noqa: PLC0415 - Matplotlib takes long to load

        return with_matplotlib.draw(figure)
    from labutils._drawing import as_svg  # noqa: PLC0415 - likewise

    return as_svg.draw(figure)


def draw_on_white(plot: Plot) -> np.ndarray:
    """Draw a plot: uint8 RGB (H, W, 3), one pixel per page pixel, for print."""
    if get_backend() == "matplotlib":
        from labutils._drawing import with_matplotlib  # noqa: PLC0415 - see draw

        return with_matplotlib.draw_on_white(plot)
    from labutils._drawing import as_pixels  # noqa: PLC0415 - see draw

    return as_pixels.draw_on_white(plot)
