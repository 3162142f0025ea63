"""Right answers to visualize_depth, written in ways that the card does not contain."""

import cv2
import numpy as np


def _share(depth_metric: np.ndarray, max_depth: float) -> tuple[np.ndarray, np.ndarray]:
    good = np.isfinite(depth_metric) & (depth_metric > 0)
    return np.clip(np.where(good, depth_metric, 0) / max_depth, 0, 1), ~good


def picture_with_jet(depth_metric: np.ndarray, max_depth: float) -> np.ndarray:
    share, bad = _share(depth_metric, max_depth)
    picture = cv2.applyColorMap(np.rint(share * 255).astype(np.uint8), cv2.COLORMAP_JET)
    picture[bad] = (0, 0, 0)
    return picture


def picture_with_turbo_rounded(depth_metric: np.ndarray, max_depth: float) -> np.ndarray:
    share, bad = _share(depth_metric, max_depth)
    picture = cv2.applyColorMap(cv2.convertScaleAbs(share, alpha=255), cv2.COLORMAP_TURBO)
    return np.where(bad[..., None], np.uint8(0), picture)


def picture_by_hand(depth_metric: np.ndarray, max_depth: float) -> np.ndarray:
    share, bad = _share(depth_metric, max_depth)
    level = (share * 255).astype(np.uint8)
    picture = cv2.merge([255 - level, np.zeros_like(level), level])
    picture[bad] = 0
    return picture


VARIANTS = [picture_with_jet, picture_with_turbo_rounded, picture_by_hand]
