"""Starter of the exercise get_camera_intrinsics.

Written by tools/derive/exercises.py from the cards in solutions/: run `make exercises`.
"""

import mujoco
import numpy as np


def get_camera_intrinsics(model, camera_name, width, height):
    """Compute the intrinsic matrix of a camera of the model for a
    picture size.

    Convention
    ----------
    A camera given by ``sensorsize`` is stretched to the picture: its
    own ``resolution`` plays no part, so fx and fy differ wherever the
    sensor and the picture differ in aspect.

    Parameters
    ----------
    model : mujoco.MjModel
        The compiled scene.
    camera_name : str
        Name of a camera of the model.
    width, height : int
        Picture size in pixels.

    The arguments stay as they are.

    Returns
    -------
    K : ndarray, float, shape (3, 3)
        Pixels.
    fov_y : float
        Vertical field of view in radians: the angle between the rays
        through the upper and the lower edge of the picture.

    Raises
    ------
    ValueError
        If the model has no such camera.

    References
    ----------
    .. [1] MuJoCo documentation, XML reference, element ``camera``:
    ``fovy``, ``sensorsize``,
       ``focal``, ``principal``.
    """
    raise NotImplementedError
