"""The arithmetic of `depth_to_pointcloud`, arranged for speed.

What it computes is three products per pixel. What takes time is moving the results: so pixels are
handled in blocks of rows that stay in the processor's cache, where all pixels of a block are
surfaces nothing is selected, and the memory for the results is asked for once.
"""

from __future__ import annotations

from itertools import groupby

import cv2
import numpy as np

from labutils._constants import MAX_DEPTH, MIN_DEPTH

#: 40 rows of a 640-pixel picture: all temporaries of a block fit into the cache.
_BLOCK_ROWS = 40

#: 0-255 to 0-1, exactly the value of `k / 255`, by table: three times as fast as dividing.
_UNIT_RANGE = (np.arange(256) / 255).astype(np.float32)


def back_project(
    depth: np.ndarray, slope_x: np.ndarray, slope_y: np.ndarray, rgb: np.ndarray | None
) -> tuple[np.ndarray, np.ndarray | None]:
    """Compute points and colors of the pixels that see a surface, in the order of the pixels.

    Parameters
    ----------
    depth : ndarray, float32 or float64, shape (H, W), contiguous
        Meters.
    slope_x : ndarray, dtype of depth, shape (W,)
        x per meter of depth, for every column.
    slope_y : ndarray, dtype of depth, shape (H,)
        y per meter of depth, for every row.
    rgb : ndarray, uint8, shape (H, W, 3), contiguous, optional
        Colors.

    Returns
    -------
    points : ndarray, dtype of depth, shape (N, 3)
    colors : ndarray, float32, shape (N, 3), or None
    """
    height, width = depth.shape
    points, colors = _allocate(depth.size, depth.dtype)
    planes = np.empty((2, _BLOCK_ROWS, width), depth.dtype)  # x and y of a block, used again
    count = 0
    tops = range(0, height, _BLOCK_ROWS)
    for is_full, span in groupby(tops, lambda top: _is_full(depth[top : top + _BLOCK_ROWS])):
        start = count
        for top in (blocks := list(span)):
            rows = slice(top, min(top + _BLOCK_ROWS, height))
            kept = None if is_full else _find_kept(depth[rows])
            block = slice(count, count + (depth[rows].size if kept is None else len(kept)))
            _unproject(depth[rows], slope_x, slope_y[rows, None], planes, kept, points[block])
            if rgb is not None and kept is not None:
                _select(cv2.LUT(rgb[rows], _UNIT_RANGE), kept, colors[block])
            count = block.stop
        if rgb is not None and is_full:
            # A long run in one call: OpenCV splits it over the processor's cores.
            rows = slice(blocks[0], blocks[-1] + _BLOCK_ROWS)
            cv2.LUT(rgb[rows], _UNIT_RANGE, dst=colors[start:count].reshape(rgb[rows].shape))
    return points[:count], None if rgb is None else colors[:count]


def _is_full(depth: np.ndarray) -> bool:
    """Tell whether every pixel is a surface; NaN makes both comparisons false."""
    return bool(depth.min() > MIN_DEPTH and depth.max() < MAX_DEPTH)


def _find_kept(depth: np.ndarray) -> np.ndarray:
    """List the flat indices of the pixels that are surfaces."""
    return np.flatnonzero((depth > MIN_DEPTH) & (depth < MAX_DEPTH))


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
    slope_x: np.ndarray,
    slope_y: np.ndarray,
    planes: np.ndarray,
    kept: np.ndarray | None,
    out: np.ndarray,
) -> None:
    """Write (x, y, z) of the kept pixels of a block into `out`; None keeps all."""
    x, y = planes[:, : len(z)]
    np.multiply(z, slope_x, out=x)
    np.multiply(z, slope_y, out=y)
    # cv2.merge interleaves three planes several times as fast as NumPy's strided writes.
    if kept is None:
        cv2.merge((x, y, z), dst=out.reshape(*z.shape, 3))
    else:
        _select(cv2.merge((x, y, z)), kept, out)


def _select(image: np.ndarray, kept: np.ndarray, out: np.ndarray) -> None:
    """Write the kept pixels of an image (H, W, 3) into `out` (N, 3)."""
    # mode="clip" because the default one makes a second copy; `kept` is never out of range.
    np.take(image.reshape(-1, 3), kept, axis=0, out=out, mode="clip")
