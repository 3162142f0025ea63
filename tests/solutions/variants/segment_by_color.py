"""Right answers to segment_by_color, written in ways that the card does not contain."""

from typing import Any

import cv2
import numpy as np

from labutils._constants import HsvRange


def mask_by_numpy(rgb_image: np.ndarray, target_hsv_range: HsvRange) -> np.ndarray:
    hsv = cv2.cvtColor(cv2.cvtColor(rgb_image, cv2.COLOR_RGB2BGR), cv2.COLOR_BGR2HSV)
    (h0, s0, v0), (h1, s1, v1) = target_hsv_range
    hue, saturation, value = cv2.split(hsv)
    inside = (hue >= h0) & (hue <= h1) if h0 <= h1 else (hue >= h0) | (hue <= h1)
    inside &= (saturation >= s0) & (saturation <= s1) & (value >= v0) & (value <= v1)
    kernel = cv2.getStructuringElement(cv2.MORPH_RECT, (5, 5))
    mask = cv2.dilate(cv2.erode(inside.astype(np.uint8) * 255, kernel), kernel)
    return cv2.erode(cv2.dilate(mask, kernel), kernel)


def mask_by_turned_hue(rgb_image: np.ndarray, target_hsv_range: HsvRange) -> np.ndarray:
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV).astype(int)
    low, high = (np.array(limit) for limit in target_hsv_range)
    width = (high[0] - low[0]) % 180
    inside = (hsv[..., 0] - low[0]) % 180 <= width
    inside &= (hsv[..., 1:] >= low[1:]).all(-1) & (hsv[..., 1:] <= high[1:]).all(-1)
    mask = np.where(inside, np.uint8(255), np.uint8(0))
    for step in (cv2.MORPH_OPEN, cv2.MORPH_CLOSE):
        mask = cv2.morphologyEx(mask, step, np.ones((5, 5), np.uint8))
    return mask


def mask_as_lists(rgb_image: np.ndarray, target_hsv_range: HsvRange) -> list[Any]:
    return mask_by_turned_hue(rgb_image, target_hsv_range).tolist()


VARIANTS = [mask_by_numpy, mask_by_turned_hue, mask_as_lists]
