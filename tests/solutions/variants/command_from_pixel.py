"""Right answers to command_from_pixel, written in ways that the card does not contain."""

import math
from typing import Any

import numpy as np


def command_by_two_arguments(pixel: Any, K: Any, pan: Any, tilt: Any, limits: Any) -> Any:
    (low_pan, high_pan), (low_tilt, high_tilt) = limits
    pan += math.atan2(K[0, 2] - pixel[0], K[0, 0])
    tilt += math.atan2(pixel[1] - K[1, 2], K[1, 1])
    return min(max(pan, low_pan), high_pan), min(max(tilt, low_tilt), high_tilt)


def command_by_ray(pixel: Any, K: Any, pan: Any, tilt: Any, limits: Any) -> Any:
    ray = np.linalg.inv(K) @ [*pixel, 1]
    angles = np.array([pan, tilt]) + np.arctan(ray[:2]) * [-1, 1]
    return np.clip(angles, *np.transpose(limits))


def command_by_complex_number(pixel: Any, K: Any, pan: Any, tilt: Any, limits: Any) -> Any:
    f, c, place = np.diag(K)[:2], K[:2, 2], np.asarray(pixel)
    change = np.angle(f + 1j * (place - c))
    angles = (pan - change[0], tilt + change[1])
    # The middle of three numbers is the one that lies between the others.
    return [sorted((angle, *ends))[1] for angle, ends in zip(angles, limits, strict=True)]


def command_in_single_precision(pixel: Any, K: Any, pan: Any, tilt: Any, limits: Any) -> Any:
    angles = command_by_ray(pixel, K.astype(np.float32), pan, tilt, limits)
    return tuple(np.float32(one) for one in angles)


VARIANTS = [
    command_by_two_arguments,
    command_by_ray,
    command_by_complex_number,
    command_in_single_precision,
]
