"""From a pixel to what the neck is told. Stands on NumPy alone."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from labutils._guards import check_intrinsics

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


def command_from_pixel(
    pixel: ArrayLike, K: ArrayLike, pan: float, tilt: float, limits: ArrayLike
) -> tuple[float, float]:
    """Compute the angles of the neck that bring a pixel to the middle of the picture.

    Convention
    ----------
    Pan turns to the left, tilt turns downward, both in radians: a pixel on the right needs a
    smaller pan, one below the middle a larger tilt. Each axis is treated by itself, by the angle
    between the viewing ray of the middle and that of the pixel's column or row.

    Parameters
    ----------
    pixel : array-like, shape (2,)
        (u, v): column and row.
    K : array-like, shape (3, 3)
        Intrinsic matrix of the camera.
    pan, tilt : float
        Angles of the neck in the moment the picture was taken, in radians.
    limits : array-like, shape (2, 2)
        ((low, high) of pan, (low, high) of tilt), in radians; what lies beyond is cut off.

    Returns
    -------
    pan, tilt : float
        The angles to command, in radians, within the limits.

    Raises
    ------
    TypeError, ValueError
        If the pixel is not two finite numbers, K is no intrinsic matrix, or a limit is missing.

    Examples
    --------
    >>> K = np.array([[500.0, 0, 319.5], [0, 500.0, 239.5], [0, 0, 1]])
    >>> command_from_pixel((319.5, 239.5), K, 0.1, 0.5, ((-1.4, 1.4), (-0.7, 1.0)))
    (0.1, 0.5)

    References
    ----------
    .. [1] Corke, Robotics, Vision and Control, 3rd edition, section 13.1 (central projection).
    """
    K = check_intrinsics(K)
    u, v = _check_numbers("pixel", pixel, (2,))
    (low_pan, high_pan), (low_tilt, high_tilt) = _check_numbers("limits", limits, (2, 2))
    right = np.arctan((u - K[0, 2]) / K[0, 0])
    down = np.arctan((v - K[1, 2]) / K[1, 1])
    return (
        float(np.clip(pan - right, low_pan, high_pan)),
        float(np.clip(tilt + down, low_tilt, high_tilt)),
    )


def _check_numbers(name: str, value: ArrayLike, shape: tuple[int, ...]) -> np.ndarray:
    array = np.asarray(value, dtype=np.float64)
    if array.shape != shape or not np.isfinite(array).all():
        raise ValueError(f"{name}: expected finite numbers of shape {shape}, got {value!r}")
    return array
