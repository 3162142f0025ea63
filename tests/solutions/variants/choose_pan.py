"""Right answers to choose_pan, written in ways that the card does not contain."""

import numpy as np


def pan_by_two_arguments(u: float, pan: float, fov_y: float, width: int, height: int) -> float:
    return pan + np.arctan2((width - 1) / 2 - u, height / 2 / np.tan(fov_y / 2))


def pan_by_complex_number(u: float, pan: float, fov_y: float, width: int, height: int) -> float:
    focal_px = height / 2 * np.cos(fov_y / 2) / np.sin(fov_y / 2)
    return np.angle(np.exp(1j * pan) * (focal_px + 1j * (width / 2 - 0.5 - u)))


def pan_in_single_precision(
    u: float, pan: float, fov_y: float, width: int, height: int
) -> np.float32:
    return np.float32(pan_by_two_arguments(u, pan, fov_y, width, height))


VARIANTS = [pan_by_two_arguments, pan_by_complex_number, pan_in_single_precision]
