"""The objects that carry a finished figure: as PNG, or as SVG."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import cv2

if TYPE_CHECKING:
    import numpy as np

_WIDEST = 720  # page pixels: the text column
_DEVICE_PIXELS = 2  # per page pixel


class Picture:
    """A finished figure that a notebook, a page and a test can use.

    Parameters
    ----------
    png : bytes
        The picture, two device pixels per page pixel.
    summary : str
        What it shows, in words: shown where no picture can be.
    """

    def __init__(self, png: bytes, summary: str) -> None:
        self._png = png
        self.summary = summary

    @classmethod
    def from_rgb(cls, image: np.ndarray, summary: str) -> Picture:
        """Wrap a uint8 image (H, W, 3) or (H, W, 4)."""
        return Picture(encode_png(image), summary)

    @property
    def png(self) -> bytes:
        """The picture as the content of a PNG file."""
        return self._png

    @property
    def size(self) -> tuple[int, int]:
        """Width and height in device pixels, read from the PNG header."""
        return (int.from_bytes(self.png[16:20], "big"), int.from_bytes(self.png[20:24], "big"))

    def _repr_mimebundle_(self, **_: Any) -> tuple[dict[str, Any], dict[str, Any]]:
        width = min(self.size[0] // _DEVICE_PIXELS, _WIDEST)
        return {"image/png": self.png, "text/plain": repr(self)}, {"image/png": {"width": width}}

    def __repr__(self) -> str:
        return f"<Picture {self.size[0]}x{self.size[1]}: {self.summary}>"


class SvgPicture(Picture):
    """A finished figure where Matplotlib is not installed, as in the browser.

    Parameters
    ----------
    svg : str
        The picture; its lengths are page pixels.
    size : (width, height)
        In page pixels.
    summary : str
        What it shows, in words.
    """

    def __init__(self, svg: str, size: tuple[float, float], summary: str) -> None:
        super().__init__(b"", summary)
        self.svg = svg
        self._page_size = size

    @property
    def png(self) -> bytes:
        """There is none.

        Raises
        ------
        AttributeError
            Always: without Matplotlib nothing here turns a figure into pixels.
        """
        raise AttributeError(
            "png: expected a figure drawn with Matplotlib, got one in SVG (`svg`): "
            "Matplotlib is not installed"
        )

    @property
    def size(self) -> tuple[int, int]:
        """Width and height in device pixels, as a PNG of this figure has them."""
        width, height = (int(_DEVICE_PIXELS * length) for length in self._page_size)
        return width, height

    def _repr_mimebundle_(self, **_: Any) -> tuple[dict[str, Any], dict[str, Any]]:
        return {"image/svg+xml": self.svg, "text/plain": repr(self)}, {}


def encode_png(image: np.ndarray) -> bytes:
    """Compress a uint8 image (H, W, 3) or (H, W, 4), RGB or RGBA, as PNG.

    Raises
    ------
    ValueError
        If PNG cannot hold it.
    """
    code = cv2.COLOR_RGBA2BGRA if image.shape[2] == 4 else cv2.COLOR_RGB2BGR
    done, png = cv2.imencode(".png", cv2.cvtColor(image, code))
    if not done:
        raise ValueError(f"image: expected a picture that PNG can hold, got {image.shape}")
    return png.tobytes()
