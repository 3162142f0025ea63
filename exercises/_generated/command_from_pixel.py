"""Starter of the exercise command_from_pixel.

Written by tools/derive/exercises.py from the cards in solutions/: run `make exercises`.
"""

import numpy as np


def command_from_pixel(pixel, K, pan, tilt, limits):
    """Compute the angles of the neck that bring a pixel to the middle of
    the picture.

    Convention
    ----------
    Positive pan turns the head to its left, positive tilt downward;
    both are in radians. Each axis is treated by itself: by the angle
    between the optical axis and the viewing ray of the pixel's
    column, or of its row.

    Parameters
    ----------
    pixel : tuple of (u, v)
        Column and row.
    K : ndarray, float64, shape (3, 3)
        Intrinsic matrix of the camera. Where the picture is a part of
        a larger one, the principal point may lie outside.
    pan, tilt : float
        Angles of the neck in the moment the picture was taken, in
        radians.
    limits : ((low, high), (low, high))
        Of pan and of tilt, in radians; what lies beyond is cut off.

    The arguments stay as they are.

    Returns
    -------
    pan, tilt : float
        The angles to command, in radians, within the limits.

    References
    ----------
    .. [1] Corke, Robotics, Vision and Control, 3rd edition, section
    13.1 (central projection).
    """
    raise NotImplementedError
