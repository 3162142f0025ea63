"""Find objects by their color.

Taught in: step 4.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import cv2
import numpy as np

from labutils._constants import MAX_HUE, HsvRange
from labutils._guards import check_hsv_range, check_mask, check_rgb_image

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

#: Opening with it removes specks up to 4 pixels wide; closing fills such holes.
_KERNEL = np.ones((5, 5), dtype=np.uint8)


def segment_by_color(rgb_image: ArrayLike, target_hsv_range: HsvRange) -> np.ndarray:
    """Mark the pixels whose color lies in an HSV range, cleaned of specks and holes.

    Convention
    ----------
    OpenCV's 8-bit HSV: hue 0-179 (degrees halved), saturation and value 0-255. Limits are
    inclusive. A range whose low hue is larger than its high hue wraps through red: it means
    ``hue >= low or hue <= high``.

    Parameters
    ----------
    rgb_image : array-like, uint8, shape (H, W, 3)
        The picture, RGB (not BGR).
    target_hsv_range : ((h, s, v), (h, s, v))
        Low and high limits.

    Returns
    -------
    ndarray, uint8, shape (H, W)
        255 inside, 0 outside, after opening and then closing with 5x5 ones, at the border as
        ``cv2.morphologyEx`` does it.

    Raises
    ------
    TypeError, ValueError
        If the picture is not uint8 RGB, or the range is not two triples within OpenCV's limits
        with low <= high for saturation and value.

    References
    ----------
    .. [1] OpenCV documentation, color conversions, RGB to HSV.
    """
    rgb = check_rgb_image("rgb_image", rgb_image)
    low, high = check_hsv_range("target_hsv_range", target_hsv_range)
    hsv = cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV)
    if low[0] <= high[0]:
        mask = cv2.inRange(hsv, low, high)
    else:
        up_to_the_seam = cv2.inRange(hsv, low, np.array([MAX_HUE, high[1], high[2]]))
        from_the_seam = cv2.inRange(hsv, np.array([0, low[1], low[2]]), high)
        mask = cv2.bitwise_or(up_to_the_seam, from_the_seam)
    mask = cv2.morphologyEx(mask, cv2.MORPH_OPEN, _KERNEL)
    return cv2.morphologyEx(mask, cv2.MORPH_CLOSE, _KERNEL)


def find_object_centroid(mask: ArrayLike) -> tuple[int, int] | None:
    """Find the center of the largest object in a mask.

    Convention
    ----------
    The answer is (x, y): column first, as OpenCV draws. Index an array with ``[y, x]``.

    Parameters
    ----------
    mask : array-like, uint8 or bool, shape (H, W)
        Anything not zero is inside.

    Returns
    -------
    tuple of int, or None
        Center of mass of the external contour with the largest area, rounded down to whole
        pixels. None where there is no contour, or the largest has no area (a line, a dot).

    Raises
    ------
    TypeError, ValueError
        If `mask` is not a uint8 or bool image of one channel.
    """
    mask = check_mask("mask", mask)
    contours, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    if not contours:
        return None
    moments = cv2.moments(max(contours, key=cv2.contourArea))
    if moments["m00"] == 0:
        return None
    return int(moments["m10"] / moments["m00"]), int(moments["m01"] / moments["m00"])


def visualize_detection(
    rgb_image: ArrayLike, centroid: tuple[int, int] | None, mask: ArrayLike | None = None
) -> np.ndarray:
    """Draw a detection on a copy of the picture.

    Parameters
    ----------
    rgb_image : array-like, uint8, shape (H, W, 3)
        RGB.
    centroid : tuple of int, or None
        (x, y) as from `find_object_centroid`; None draws no mark.
    mask : array-like, uint8 or bool, shape (H, W), optional
        The outline of its regions is drawn too.

    Returns
    -------
    ndarray, uint8, shape (H, W, 3)
        RGB. The input is left as it is.

    Raises
    ------
    TypeError, ValueError
        If a picture has the wrong type, or the mask another size than the picture.
    """
    result = check_rgb_image("rgb_image", rgb_image).copy()
    if mask is not None:
        mask = check_mask("mask", mask)
        if mask.shape != result.shape[:2]:
            raise ValueError(
                f"mask: expected the picture's size {result.shape[:2]}, got {mask.shape}"
            )
        contours, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
        cv2.drawContours(result, contours, -1, (255, 255, 255), 2)
    if centroid is not None:
        # White under green: one of the two stands out on any object.
        cv2.circle(result, centroid, 10, (255, 255, 255), 4)
        cv2.circle(result, centroid, 10, (0, 255, 0), 2)
    return result
