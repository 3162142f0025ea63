"""What a figure shows, before anything draws it: pictures side by side, or curves on axes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

if TYPE_CHECKING:
    import numpy as np

    from labutils._drawing.scales import Axis, Limits

ColorMap = Literal["gray", "turbo", "RdBu_r"]


@dataclass(frozen=True)
class Panel:
    """One picture of a sheet.

    Attributes
    ----------
    title : str
        Above the picture.
    pixels : ndarray
        RGB (H, W, 3) or RGBA (H, W, 4), or one channel (H, W) that the color map paints.
    color_map : str
        Of one channel.
    limits : (low, high), optional
        Of the color map; without it the range of the data.
    """

    title: str
    pixels: np.ndarray
    color_map: ColorMap = "gray"
    limits: Limits | None = None


@dataclass(frozen=True)
class ColorBar:
    """The scale of the panels it stands beside, which share their limits.

    Attributes
    ----------
    label : str
        With the unit.
    panels : tuple of int
        Places in the sheet.
    side : "right" or "bottom"
        Of the panels.
    aspect : int
        Length over thickness.
    """

    label: str
    panels: tuple[int, ...]
    side: Literal["right", "bottom"]
    aspect: int = 20


@dataclass(frozen=True)
class Sheet:
    """Pictures in rows; width and height are in inches."""

    summary: str
    width: float
    height: float
    columns: int
    panels: tuple[Panel, ...]
    bars: tuple[ColorBar, ...] = ()

    @property
    def rows(self) -> int:
        """Number of rows; the last may have room left."""
        return -(-len(self.panels) // self.columns)


@dataclass(frozen=True)
class Curve:
    """A named line through points; with `steps`, y holds heights between the N + 1 edges of x."""

    name: str
    x: np.ndarray
    y: np.ndarray
    steps: bool = False


@dataclass(frozen=True)
class Plot:
    """Curves on two axes, perhaps with one point; width and height are in inches.

    Attributes
    ----------
    line_width : float
        In points.
    naming : "none", "legend" or "ends"
        Where the names of the curves stand.
    """

    summary: str
    width: float
    height: float
    curves: tuple[Curve, ...]
    x: Axis
    y: Axis
    line_width: float
    naming: Literal["none", "legend", "ends"] = "none"
    title: str = ""
    point: tuple[float, float] | None = None
