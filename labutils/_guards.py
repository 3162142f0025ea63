"""Argument checks: one message form, "name: expected this, got that".

A guard is exactly as strict as the code behind it, and returns the clean array that code uses.
"""

from __future__ import annotations

import numbers
from typing import TYPE_CHECKING, Any

import numpy as np

from labutils._constants import MAX_HUE

if TYPE_CHECKING:
    from numpy.typing import DTypeLike

_INTEGER_KINDS = "iu"
_REAL_KINDS = "iuf"


def _describe(value: Any) -> str:
    """Say what came in: shape and dtype for arrays, type and value for the rest."""
    if isinstance(value, np.ndarray):
        return f"an array of shape {value.shape} and dtype {value.dtype}"
    text = repr(value)
    if len(text) > 60:
        text = text[:57] + "..."
    return f"{type(value).__name__} {text}"


def check_real_array(name: str, value: Any) -> np.ndarray:
    """Return `value` as an array of real numbers, or raise TypeError."""
    array = np.asarray(value)
    if array.dtype.kind not in _REAL_KINDS:
        raise TypeError(f"{name}: expected real numbers, got {_describe(value)}")
    return array


def check_image_size(width: Any, height: Any) -> tuple[int, int]:
    """Return (width, height) as positive ints."""
    for name, value in (("width", width), ("height", height)):
        if isinstance(value, bool) or not isinstance(value, numbers.Integral):
            raise TypeError(f"{name}: expected a whole number of pixels, got {_describe(value)}")
        if value < 1:
            raise ValueError(f"{name}: expected at least 1 pixel, got {value}")
    return int(width), int(height)


def check_count(name: str, value: Any, thing: str) -> int:
    """Return a whole number of things, at least 1, as an int."""
    if isinstance(value, bool) or not isinstance(value, numbers.Integral):
        raise TypeError(f"{name}: expected a whole number, got {_describe(value)}")
    if value < 1:
        raise ValueError(f"{name}: expected at least 1 {thing}, got {value}")
    return int(value)


def check_odd(name: str, value: Any) -> int:
    """Return an odd number of pixels, at least 1, as an int."""
    count = check_count(name, value, "pixel")
    if count % 2 == 0:
        raise ValueError(f"{name}: expected an odd number, so that it has a middle, got {value}")
    return count


def check_depth_image(name: str, value: Any) -> np.ndarray:
    """Return a depth image: real numbers, shape (H, W)."""
    array = check_real_array(name, value)
    if array.ndim != 2:
        raise ValueError(f"{name}: expected a depth image of shape (H, W), got {_describe(array)}")
    return array


def check_gray_image(name: str, value: Any) -> np.ndarray:
    """Return a gray picture as float32: finite numbers, shape (H, W)."""
    array = check_real_array(name, value)
    if array.ndim != 2 or not array.size:
        raise ValueError(f"{name}: expected a gray picture (H, W), got {_describe(array)}")
    if not np.isfinite(array).all():
        raise ValueError(f"{name}: expected finite numbers, got NaN or infinity")
    return array.astype(np.float32)


def check_gray_pair(left: Any, right: Any) -> tuple[np.ndarray, np.ndarray]:
    """Return the two gray pictures of a pair, of one size (H, W), as float32."""
    pair = check_gray_image("left", left), check_gray_image("right", right)
    if pair[0].shape != pair[1].shape:
        raise ValueError(f"right: expected shape {pair[0].shape} as left, got {pair[1].shape}")
    return pair


def check_cost_volume(value: Any) -> np.ndarray:
    """Return matching costs of at least one candidate: real numbers, shape (D, H, W)."""
    costs = check_real_array("cost", value)
    if costs.ndim != 3 or not len(costs):
        raise ValueError(f"cost: expected shape (D, H, W) with D > 0, got shape {costs.shape}")
    return costs


def check_rgb_image(name: str, value: Any) -> np.ndarray:
    """Return a color image: uint8, shape (H, W, 3)."""
    array = np.asarray(value)
    if array.dtype != np.uint8:
        raise TypeError(f"{name}: expected a uint8 image with values 0-255, got {_describe(value)}")
    if array.ndim != 3 or array.shape[2] != 3:
        raise ValueError(
            f"{name}: expected a color image of shape (H, W, 3), got {_describe(value)}"
        )
    return array


def check_picture(name: str, value: np.ndarray) -> np.ndarray:
    """Return what a figure can show: one channel (H, W), RGB or RGBA."""
    if value.ndim == 2 or (value.ndim == 3 and value.shape[2] in {3, 4}):
        return value
    raise ValueError(
        f"{name}: expected shape (H, W), (H, W, 3) or (H, W, 4), got {_describe(value)}"
    )


def check_curve(name: str, value: Any) -> np.ndarray:
    """Return the heights of a curve, of which at least one is finite."""
    array = check_real_array(name, value)
    if np.isfinite(array).any():
        return array
    raise ValueError(f"{name}: expected at least one finite value, got none")


def check_mask(name: str, value: Any) -> np.ndarray:
    """Return a mask as uint8 of shape (H, W); bool is accepted, anything not zero is inside."""
    array = np.asarray(value)
    if array.dtype == np.bool_:
        array = array.astype(np.uint8) * 255
    if array.dtype != np.uint8:
        raise TypeError(f"{name}: expected a uint8 or bool mask, got {_describe(value)}")
    if array.ndim != 2:
        raise ValueError(f"{name}: expected a mask of shape (H, W), got {_describe(value)}")
    return array


def check_pixel(name: str, value: Any, width: int, height: int) -> tuple[int, int]:
    """Return a pixel (u, v) of a picture: column and row, two ints."""
    given = tuple(value) if np.iterable(value) else (value,)
    if any(isinstance(one, bool) or not isinstance(one, numbers.Integral) for one in given):
        raise TypeError(f"{name}: expected (u, v), two whole numbers, got {_describe(value)}")
    if len(given) != 2 or not (0 <= given[0] < width and 0 <= given[1] < height):
        raise ValueError(
            f"{name}: expected (u, v) within {width} x {height} pixels, got {_describe(value)}"
        )
    return int(given[0]), int(given[1])


def check_hsv_range(name: str, value: Any) -> tuple[np.ndarray, np.ndarray]:
    """Return an HSV range in OpenCV units as (low, high), two integer arrays of 3."""
    limits = np.asarray(value)
    if limits.shape != (2, 3):
        raise ValueError(f"{name}: expected ((h, s, v), (h, s, v)), got {value!r}")
    if limits.dtype.kind not in "iu":
        raise TypeError(f"{name}: expected whole numbers, got {value!r}")
    low, high = limits.astype(np.int64)
    top = np.array([MAX_HUE, 255, 255])
    if (limits < 0).any() or (limits > top).any():
        hint = " (hue is 0-179 in OpenCV: degrees halved)" if (limits[:, 0] > MAX_HUE).any() else ""
        raise ValueError(f"{name}: expected 0 to {tuple(top.tolist())}, got {value!r}{hint}")
    if low[1] > high[1] or low[2] > high[2]:
        raise ValueError(f"{name}: only hue wraps; expected low <= high for s and v, got {value!r}")
    return low, high


def check_intrinsics(value: Any) -> np.ndarray:
    """Return K as 3x3 float64 with fx, fy > 0, no skew and the last row 0, 0, 1."""
    matrix = check_real_array("K", value).astype(np.float64)
    if matrix.shape != (3, 3):
        raise ValueError(f"K: expected a 3x3 matrix, got {_describe(value)}")
    zeros = (matrix[0, 1], matrix[1, 0], matrix[2, 0], matrix[2, 1])
    if any(zeros) or matrix[2, 2] != 1.0 or not np.isfinite(matrix).all():
        raise ValueError(
            f"K: expected [[fx, 0, cx], [0, fy, cy], [0, 0, 1]], got {matrix.tolist()}"
        )
    if matrix[0, 0] <= 0 or matrix[1, 1] <= 0:
        raise ValueError(
            f"K: expected positive focal lengths, got fx = {matrix[0, 0]}, fy = {matrix[1, 1]}"
        )
    return matrix


def check_columns(name: str, value: Any, columns: int) -> np.ndarray:
    """Return an array of real numbers of shape (N, columns)."""
    array = check_real_array(name, value)
    if array.ndim != 2 or array.shape[1] != columns:
        raise ValueError(f"{name}: expected shape (N, {columns}), got {_describe(value)}")
    return array


def check_colors(colors: Any, count: int) -> np.ndarray:
    """Return colors of shape (count, 3) with values from 0 to 1."""
    colors = check_columns("colors", colors, 3)
    if colors.dtype.kind == "u":  # 0 and 1 of a picture are nearly black, not 0 and full
        raise TypeError(
            f"colors: expected 0 to 1, got {_describe(colors)}: divide those of a picture by "
            f"{np.iinfo(colors.dtype).max}"
        )
    if len(colors) != count:
        raise ValueError(f"colors: expected one per point ({count}), got {len(colors)}")
    if colors.size and not (colors.min() >= 0 and colors.max() <= 1):
        raise ValueError(f"colors: expected 0 to 1, got {colors.min():g} to {colors.max():g}")
    return colors


def check_pose(cam_xpos: Any, cam_xmat: Any) -> tuple[np.ndarray, np.ndarray]:
    """Return a camera position (3,) and a rotation (3, 3), both float64."""
    position = check_real_array("cam_xpos", cam_xpos).astype(np.float64)
    rotation = check_real_array("cam_xmat", cam_xmat).astype(np.float64)
    if position.shape != (3,):
        raise ValueError(f"cam_xpos: expected 3 numbers, got {_describe(cam_xpos)}")
    if rotation.shape not in ((9,), (3, 3)):
        raise ValueError(f"cam_xmat: expected 9 numbers or a 3x3 matrix, got {_describe(cam_xmat)}")
    rotation = rotation.reshape(3, 3)
    # 1e-6 is far above the rounding of a rotation kept in double (or read from float32 text with
    # 7 digits) and far below any scale or shear that would move a point visibly.
    # (A comparison with NaN is False. np.allclose takes longer than moving a thousand points.)
    proper = bool((np.abs(rotation @ rotation.T - np.eye(3)) <= 1e-6).all())
    if not proper or np.linalg.det(rotation) < 0:
        raise ValueError("cam_xmat: expected a rotation matrix (orthonormal, determinant +1)")
    return position, rotation


def check_depth_limits(near_name: str, near: Any, far_name: str, far: Any) -> tuple[float, float]:
    """Return 0 < near < far as floats."""
    for name, value in ((near_name, near), (far_name, far)):
        if isinstance(value, bool) or not isinstance(value, numbers.Real):
            raise TypeError(f"{name}: expected meters as a number, got {_describe(value)}")
    if not 0 < near < far < float("inf"):
        raise ValueError(f"expected 0 < {near_name} < {far_name}, got {near} and {far}")
    return float(near), float(far)


def check_positive(name: str, value: Any, unit: str) -> float:
    """Return a finite number above 0 as a float."""
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        raise TypeError(f"{name}: expected {unit} as a number, got {_describe(value)}")
    number = float(value)
    if not 0 < number < float("inf"):
        raise ValueError(f"{name}: expected {unit} above 0, got {value}")
    return number


def check_finite_rows(name: str, rows: np.ndarray, dtype: DTypeLike) -> np.ndarray:
    """Return rows of numbers as `dtype`, float32 or float64; all are finite, before and after."""
    with np.errstate(over="ignore"):
        stored = rows.astype(dtype, copy=False)
    fits = np.isfinite(stored).all(axis=1)
    if not fits.all():
        first = int(fits.argmin())
        lost = np.isfinite(rows[first]).all()
        limit = f"at most {np.finfo(stored.dtype).max:.2g}, as {stored.dtype} holds"
        raise ValueError(
            f"{name}[{first}]: expected {limit if lost else 'finite numbers'}, "
            f"got {rows[first].tolist()}"
        )
    return stored
