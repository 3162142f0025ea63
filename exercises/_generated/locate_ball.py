"""Starter of the exercise locate_ball.

Written by tools/derive/exercises.py from the cards in solutions/: run `make exercises`.
"""

import numpy as np


def locate_ball(mask, depth, K, radius):
    """Locate the center of a ball of known size in the camera frame.

    The ball is wholly in the picture, more than 20 pixels wide, and
    nothing hides it. A center that is up to 1 cm off in each
    coordinate is right, so there are many ways.

    Parameters
    ----------
    mask : ndarray, uint8, (H, W)
        255 on the ball, 0 elsewhere. It may have a hole where the
        ball shines, and some pixels at its border that see the wall
        far behind.
    depth : ndarray, float32, (H, W)
        Meters along the optical axis. Not valid are depths up to 0.01
        m, from 10 m on, infinity and NaN; also pixels of the ball may
        be without a valid depth.
    K : ndarray, float64, (3, 3)
        Intrinsic matrix. Where the picture is a part of a larger one,
        the principal point may lie outside.
    radius : float
        Of the ball, meters, up to 0.065.

    The arguments stay as they are.

    Returns
    -------
    ndarray, float, (3,), or None
        The center (x, y, z) in the camera frame (x right, y down, z
        forward), meters. None where no pixel of the mask has a valid
        depth.
    """
    raise NotImplementedError
