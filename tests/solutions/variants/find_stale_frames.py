"""Right answers to find_stale_frames, written in ways that the card does not contain."""

import cv2
import numpy as np


def stale_by_loop(images: np.ndarray, pans: np.ndarray, noise: int) -> list[bool]:
    stale = [False]
    for t in range(1, len(images)):
        moved = abs(pans[t] - pans[t - 1]) > 0.001
        stale.append(bool(moved and cv2.absdiff(images[t], images[t - 1]).max() <= noise))
    return stale


def stale_by_float(images: np.ndarray, pans: np.ndarray, noise: int) -> np.ndarray:
    same = (np.ptp([images[1:], images[:-1]], axis=0) <= noise).all(axis=(1, 2, 3))
    return np.concatenate([[False], same & (np.abs(pans[1:] - pans[:-1]) > 0.001)])


def stale_as_tuple(images: np.ndarray, pans: np.ndarray, noise: int) -> tuple[bool, ...]:
    return tuple(stale_by_loop(images.astype(np.float32), pans, noise))


VARIANTS = [stale_by_loop, stale_by_float, stale_as_tuple]
