"""Starter of the exercise control.

Written by tools/derive/exercises.py from the cards in solutions/: run `make exercises`.
"""

import cv2
import numpy as np


def control(rgb, depth, K, state):
    """Turn the head so that the red ball stays in the middle of the
    picture.

    It is called every `state.dt` seconds with the newest picture that
    has arrived, and the neck turns to its answer until the next call.

    Many controllers are right. Yours is judged by what happens in its
    loop, in pixels of a picture 640 wide:

    A ball that rests is within 15 px of the middle from one second
    after the start on. Where it moves at up to 0.12 m/s, its mean
    distance after the first second is at most 15 px. The same holds
    at up to 0.08 m/s where pictures arrive 0.1 s late. One second
    after a board has hidden the ball, the mean distance is at most 15
    px again. The same holds one second after the ball has come back
    from beyond the limits.

    No command lies outside `state.limits`. Depth may be 0 or NaN all
    over the ball: its pixel has to be enough then. The ball has hues
    of 0 to 7 in OpenCV's units. A red box on the table has hues of
    170 and more.

    Parameters
    ----------
    rgb : ndarray, uint8, shape (H, W, 3)
        The picture of the head camera.
    depth : ndarray, float32, shape (H, W)
        Meters along the optical axis.
    K : ndarray, float64, shape (3, 3)
        Intrinsic matrix of the camera.
    state : FollowingState
        Among others `pan` and `tilt` of the neck now, and `seen_pan`
        and `seen_tilt` when the picture was taken, in radians. Its
        `memory` is a dict of your own, empty at the start.

    The arguments stay as they are.

    Returns
    -------
    pan, tilt : float
        The angles the neck turns to, in radians. Pan turns to the
        left, tilt turns downward.
    """
    raise NotImplementedError
