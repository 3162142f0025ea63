"""The arithmetic of `depth_to_pointcloud`, arranged for speed.

What it computes is three products per pixel. What takes time is moving the results: so pixels are
handled in blocks of rows that stay in the processor's cache, where all pixels of a block are
surfaces nothing is selected, and the memory for the results is asked for once.
"""

from __future__ import annotations

from functools import lru_cache

import cv2
import numpy as np

from labutils.depth_values import find_valid_depth

#: 80 rows of a 640-pixel picture: all temporaries of a block fit into the cache.
_BLOCK_ROWS = 80


def back_project(
    depth: np.ndarray, K: np.ndarray, rgb: np.ndarray | None, limits: tuple[float, float]
) -> tuple[np.ndarray, np.ndarray | None]:
    """Compute points and colors of the pixels that see a surface, in the order of the pixels.

    Parameters
    ----------
    depth : ndarray, float32 or float64, shape (H, W), contiguous
        Meters.
    K : ndarray, float64, shape (3, 3)
        Intrinsic matrix.
    rgb : ndarray, uint8, shape (H, W, 3), contiguous, optional
        Colors.
    limits : tuple of float
        (min_depth, max_depth) in meters: what lies at or outside them is no surface.

    Returns
    -------
    points : ndarray, dtype of depth, shape (N, 3)
    colors : ndarray, float32, shape (N, 3), or None
    """
    height, width = depth.shape
    slopes = _make_slopes(K.tobytes(), height, width, depth.dtype.char)
    points, colors = _allocate(depth.size, depth.dtype)
    planes = np.empty((2, _BLOCK_ROWS, width), depth.dtype)  # x and y of a block, used again
    count = 0
    for top in range(0, height, _BLOCK_ROWS):
        rows = slice(top, top + _BLOCK_ROWS)
        z = depth[rows]
        kept = None if _is_full(z, limits) else find_valid_depth(z, *limits).reshape(-1)
        block = slice(count, count + (z.size if kept is None else int(np.count_nonzero(kept))))
        _unproject(z, (slopes[0][: len(z)], slopes[1][rows]), planes, kept, points[block])
        if rgb is not None:
            _scale_colors(rgb[rows], kept, colors[block])
        count = block.stop
    return points[:count], None if rgb is None else colors[:count]


@lru_cache(maxsize=4)
def _make_slopes(
    K_bytes: bytes, height: int, width: int, dtype: str
) -> tuple[np.ndarray, np.ndarray]:
    """Compute x and y per meter of depth: x for one block of rows, y for the whole picture.

    Full tables, because a product of two arrays of one shape runs twice as fast as one that
    repeats a row or a column; kept, because a camera delivers many frames with one K.
    """
    K = np.frombuffer(K_bytes).reshape(3, 3)
    x = ((np.arange(width) - K[0, 2]) / K[0, 0]).astype(dtype)
    y = ((np.arange(height) - K[1, 2]) / K[1, 1]).astype(dtype)
    tables = np.tile(x, (_BLOCK_ROWS, 1)), np.repeat(y[:, None], width, axis=1)
    for table in tables:
        table.setflags(write=False)
    return tables


def _is_full(depth: np.ndarray, limits: tuple[float, float]) -> bool:
    """Tell whether `find_valid_depth` would mark every pixel, in a quarter of the time.

    NaN makes both comparisons false.
    """
    min_depth, max_depth = limits
    return bool(depth.min() > min_depth and depth.max() < max_depth)


def _allocate(count: int, dtype: np.dtype) -> tuple[np.ndarray, np.ndarray]:
    """Make room for points and colors.

    One block for both: NumPy asks for huge memory pages only from 4 MiB on, and the points of a
    640x480 picture alone stay just below. Without huge pages the operating system spends longer
    on handing out memory than the arithmetic takes. Memory never written costs nothing.
    """
    if dtype == np.float32:
        points, colors = np.empty((2, count, 3), np.float32)
        return points, colors
    return np.empty((count, 3), dtype), np.empty((count, 3), np.float32)


def _unproject(
    z: np.ndarray,
    slopes: tuple[np.ndarray, np.ndarray],
    planes: np.ndarray,
    kept: np.ndarray | None,
    out: np.ndarray,
) -> None:
    """Write (x, y, z) of the kept pixels of a block into `out`; None keeps all."""
    x, y = planes[:, : len(z)]
    cv2.multiply(z, slopes[0], x)
    cv2.multiply(z, slopes[1], y)
    # cv2.merge interleaves three planes several times as fast as NumPy's strided writes.
    if kept is None:
        cv2.merge((x, y, z), dst=out.reshape(*z.shape, 3))
    else:
        _select(cv2.merge((x, y, z)), kept, out)


def _scale_colors(rgb: np.ndarray, kept: np.ndarray | None, out: np.ndarray) -> None:
    """Write the colors of the kept pixels of a block into `out`, as 0 to 1; None keeps all."""
    if kept is not None:
        selected = np.empty((1, len(out), 3), np.uint8)
        _select(rgb, kept, selected)
        rgb = selected
    if not rgb.size:
        return
    # What is wanted is rgb / 255. OpenCV converts and scales in one pass, twice as fast as a table
    # and three times as fast as a division, but in Python only inside `normalize`, which scales
    # the largest value to alpha.
    largest = int(rgb.max())
    cv2.normalize(rgb, out.reshape(rgb.shape), largest / 255, 0, cv2.NORM_INF, cv2.CV_32F)


def _select(image: np.ndarray, kept: np.ndarray, out: np.ndarray) -> None:
    """Write the kept pixels of an image (H, W, 3) into `out` (N, 3) or (1, N, 3)."""
    # As one opaque item per pixel: NumPy selects whole items several times as fast as rows of
    # three numbers.
    pixel = np.dtype((np.void, 3 * image.itemsize))
    out.reshape(-1, 3).view(pixel)[:, 0] = image.reshape(-1, 3).view(pixel)[:, 0][kept]
