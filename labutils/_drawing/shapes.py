"""What a drawing consists of: the layouts make it, `as_svg` and `as_pixels` draw it."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Literal, NamedTuple

from labutils._drawing.style import FONT_SIZE, INK, PIXELS_PER_POINT

if TYPE_CHECKING:
    import numpy as np

Anchor = Literal["start", "middle", "end"]

#: What a shape is for: tests, and whoever reads the file, find it by this.
Part = Literal["title", "label", "tick", "note", "name", "axis", "curve", "point", "picture", "bar"]


class Box(NamedTuple):
    """A rectangle; (x, y) is its upper left corner."""

    x: float
    y: float
    width: float
    height: float

    @property
    def right(self) -> float:
        """The right edge."""
        return self.x + self.width

    @property
    def bottom(self) -> float:
        """The lower edge."""
        return self.y + self.height


@dataclass(frozen=True)
class Text:
    """A line of text; (x, y) is on its baseline.

    Attributes
    ----------
    exponent : str
        Small and raised behind the text.
    is_turned : bool
        Read from below to above.
    """

    part: Part
    text: str
    x: float
    y: float
    anchor: Anchor = "middle"
    color: str = INK
    size: float = FONT_SIZE * PIXELS_PER_POINT
    exponent: str = ""
    is_turned: bool = False


@dataclass(frozen=True)
class Stroke:
    """Straight lines through points (N, 2); a point that is NaN interrupts them.

    What is outside of `inside` is not drawn.
    """

    part: Part
    points: np.ndarray
    width: float
    color: str = INK
    inside: Box | None = None


@dataclass(frozen=True)
class Dot:
    """A filled circle."""

    part: Part
    x: float
    y: float
    radius: float
    color: str


@dataclass(frozen=True)
class Bitmap:
    """Pixels, uint8 RGB or RGBA, stretched over a rectangle."""

    part: Part
    box: Box
    pixels: np.ndarray


Shape = Text | Stroke | Dot | Bitmap


@dataclass(frozen=True)
class Drawing:
    """Shapes, the first at the bottom; lengths are page pixels, from the upper left corner."""

    width: float
    height: float
    shapes: list[Shape] = field(default_factory=list)
