"""Starter of the exercise choose_pan.

Written by tools/derive/exercises.py from the cards in solutions/: run `make exercises`.
"""

import numpy as np


def choose_pan(u, pan, fov_y, width, height):
    """Choose the angle of the neck that brings a pixel column to the
    middle of the picture.

    The head is level, and the camera sits on the axis of the neck.
    Positive angles turn the head to its left.

    Parameters
    ----------
    u : float
        Column of the thing to look at, pixels.
    pan : float
        Angle of the neck while the picture was taken, radians.
    fov_y : float
        Vertical field of view, radians; pixels are square.
    width, height : int
        Size of the picture, pixels.

    The arguments stay as they are.

    Returns
    -------
    float
        The angle to set, radians.
    """
    raise NotImplementedError
