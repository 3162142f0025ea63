"""Name the colored things in a picture, and find the one that is asked for."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import cv2
import numpy as np

from labutils._constants import HSV_RANGES, HsvRange
from labutils._guards import check_depth_image, check_intrinsics, check_rgb_image
from labutils.color_segmentation import segment_by_color
from labutils.depth_values import find_valid_depth

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator, Mapping

    from numpy.typing import ArrayLike

#: A region below this share of the picture is a reflection or an edge, not a thing.
MIN_SHARE = 0.0005


class Thing(NamedTuple):
    """A region of one color.

    Parameters
    ----------
    color : str
        Its name in `HSV_RANGES`.
    pixel : tuple of float
        (u, v), column and row, of its centroid.
    distance : float
        From the eye to its surface, in meters: the median along its viewing rays.
    area : int
        Its pixels.
    """

    color: str
    pixel: tuple[float, float]
    distance: float
    area: int


#: How one of several is chosen: the one with the smallest.
_ORDERS: dict[str, Callable[[Thing], float]] = {
    "nearest": lambda thing: thing.distance,
    "farthest": lambda thing: -thing.distance,
    "largest": lambda thing: -thing.area,
}


def find_things(
    rgb_image: ArrayLike,
    depth: ArrayLike,
    K: ArrayLike,
    hsv_ranges: Mapping[str, HsvRange] = HSV_RANGES,
) -> list[Thing]:
    """Find all regions of named colors and how far they are, the nearest first.

    Convention
    ----------
    Two things of one color that touch in the picture are one region, so one thing.

    Parameters
    ----------
    rgb_image : array-like, uint8, shape (H, W, 3)
        RGB.
    depth : array-like, real, shape (H, W)
        Meters along the optical axis; pixels without a surface do not count.
    K : array-like, shape (3, 3)
        Intrinsic matrix of the camera.
    hsv_ranges : mapping of str to HSV range
        Name to limits, as `segment_by_color` takes them.

    Returns
    -------
    list of Thing
        Empty where there is none. A region without one valid depth is left out.

    Raises
    ------
    TypeError, ValueError
        If picture, depth or K is none, or the two pictures differ in size.
    """
    rgb = check_rgb_image("rgb_image", rgb_image)
    depth = check_depth_image("depth", depth)
    K = check_intrinsics(K)
    if depth.shape != rgb.shape[:2]:
        raise ValueError(f"depth: expected the picture's size {rgb.shape[:2]}, got {depth.shape}")
    distances = _measure_distances(depth, K)
    found = [
        thing
        for color, limits in hsv_ranges.items()
        for thing in _find_regions(color, segment_by_color(rgb, limits), distances)
    ]
    return sorted(found, key=_ORDERS["nearest"])


def find_thing(request: str, things: Iterable[Thing]) -> Thing | None:
    """Find the thing that a request means, such as "nearest red thing".

    Parameters
    ----------
    request : str
        Holds one color of `HSV_RANGES`, and "nearest", "farthest" or "largest"; the nearest is
        meant where it says none. Other words are not read.
    things : iterable of Thing
        What there is.

    Returns
    -------
    Thing, or None
        None where no thing has this color.

    Raises
    ------
    ValueError
        If the request does not hold exactly one color, or more than one order.

    Examples
    --------
    >>> things = [Thing("red", (10.0, 20.0), 1.5, 90), Thing("red", (30.0, 20.0), 0.9, 40)]
    >>> find_thing("nearest red thing", things).distance
    0.9
    """
    words = request.lower().replace(",", " ").replace(".", " ").split()
    colors = [word for word in words if word in HSV_RANGES]
    if len(set(colors)) != 1:
        raise ValueError(f"request: expected one color of {', '.join(HSV_RANGES)}, got {request!r}")
    orders = [word for word in words if word in _ORDERS] or ["nearest"]
    if len(set(orders)) != 1:
        raise ValueError(f"request: expected one of {', '.join(_ORDERS)}, got {request!r}")
    fitting = (thing for thing in things if thing.color == colors[0])
    return min(fitting, key=_ORDERS[orders[0]], default=None)


def _find_regions(color: str, mask: np.ndarray, distances: np.ndarray) -> Iterator[Thing]:
    """Find the things of one mask."""
    count, labels, stats, centroids = cv2.connectedComponentsWithStats(mask)
    for label in range(1, count):  # 0 is all that is black
        area = int(stats[label, cv2.CC_STAT_AREA])
        seen = distances[(labels == label) & np.isfinite(distances)]
        if area >= MIN_SHARE * mask.size and seen.size:
            u, v = centroids[label]
            yield Thing(color, (float(u), float(v)), float(np.median(seen)), area)


def _measure_distances(depth: np.ndarray, K: np.ndarray) -> np.ndarray:
    """Return how far each pixel's surface is along its ray, NaN where there is none: (H, W)."""
    v, u = np.indices(depth.shape)
    lengths = np.hypot(np.hypot((u - K[0, 2]) / K[0, 0], (v - K[1, 2]) / K[1, 1]), 1.0)
    return np.where(find_valid_depth(depth), depth * lengths, np.nan)
