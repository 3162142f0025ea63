"""Starter of the exercise find_stale_frames.

Written by tools/derive/exercises.py from the cards in solutions/: run `make exercises`.
"""

import numpy as np


def find_stale_frames(images, pans, noise):
    """Find the pictures of a log that still show the pose before.

    A picture is stale if the neck has moved since the picture before
    (by more than 0.001 rad), but no value of the picture has changed
    by more than the noise. The first picture is never stale.

    Parameters
    ----------
    images : ndarray, uint8, (T, H, W, 3)
        The pictures, oldest first.
    pans : ndarray, float64, (T,)
        Angle of the neck when each picture was taken, radians.
    noise : int
        Largest change of a value from 0 to 255 that is noise.

    The arguments stay as they are.

    Returns
    -------
    ndarray, bool, (T,)
        True where a picture is stale.
    """
    raise NotImplementedError
