"""Right answers to choose_pan, as strangers wrote them."""
import cmath
import math

import numpy as np


def by_formula(u, pan, fov_y, width, height):
    """Textbook: f from the vertical angle, minus the angle of the column."""
    f = (height / 2) / np.tan(fov_y / 2)
    cx = (width - 1) / 2
    return float(pan - np.arctan((u - cx) / f))


def by_math_module(u, pan, fov_y, width, height):
    """math only, atan2, no focal length: the half height is 1."""
    half = height / 2
    right = (u - 0.5 * (width - 1)) / half * math.tan(0.5 * fov_y)
    return pan - math.atan2(right, 1.0)


def by_inverse_of_K(u, pan, fov_y, width, height):
    """Ray through the pixel from K^-1; result is a NumPy float64 scalar."""
    f = height / (2.0 * np.tan(fov_y / 2.0))
    K = np.array([[f, 0, (width - 1) / 2], [0, f, (height - 1) / 2], [0, 0, 1.0]])
    ray = np.linalg.solve(K, np.array([u, (height - 1) / 2, 1.0]))
    return np.float64(pan) - np.arctan2(ray[0], ray[2])


def by_complex_numbers(u, pan, fov_y, width, height):
    """The floor plan as the complex plane: forward is 1, left is i."""
    f = height / 2 / math.tan(fov_y / 2)
    direction = complex(f, -(u - (width - 1) / 2))
    return float(pan) + cmath.phase(direction)


def by_horizontal_field(u, pan, fov_y, width, height):
    """Goes over the horizontal field of view, columns scaled to [-1, 1]."""
    fov_x = 2 * math.atan(math.tan(fov_y / 2) * width / height)
    place = (2 * u + 1) / width - 1
    to_the_right = math.atan(place * math.tan(fov_x / 2))
    return pan - to_the_right


def by_search(u, pan, fov_y, width, height, steps=200):
    """Bisection: the turn that brings the column to the middle, no arctan at all."""
    f = (height / 2) / math.tan(fov_y / 2)
    wanted = (width - 1) / 2 - u  # pixels to the left of the middle
    low, high = -math.pi / 2, math.pi / 2
    for _ in range(steps):
        middle = (low + high) / 2
        if f * math.tan(middle) < wanted:
            low = middle
        else:
            high = middle
    return float(pan + (low + high) / 2)


def by_world_vectors(u, pan, fov_y, width, height):
    """Turns the viewing direction in the world and measures the signed angle between both."""
    f = (height / 2) / np.tan(fov_y / 2)
    forward = np.array([np.cos(pan), np.sin(pan)])
    left = np.array([-np.sin(pan), np.cos(pan)])
    ray = f * forward - (u - (width - 1) / 2) * left
    signed = np.arctan2(forward[0] * ray[1] - forward[1] * ray[0], forward @ ray)
    return (pan + signed).item() if hasattr(pan + signed, "item") else pan + signed


def with_checks(u, pan, fov_y, width, height):
    """Over-engineered: validates what the statement takes for granted, atan by arcsin."""
    if not 0 < fov_y < math.pi:
        raise ValueError("fov_y must lie between 0 and pi")
    if width < 1 or height < 1:
        raise ValueError("empty picture")
    f = 0.5 * height * math.cos(fov_y / 2) / math.sin(fov_y / 2)
    off = float(u) - (width - 1) / 2
    turn = math.asin(off / math.hypot(off, f))
    return float(pan) - turn


ANSWERS = [by_formula, by_math_module, by_inverse_of_K, by_complex_numbers,
           by_horizontal_field, by_search, by_world_vectors, with_checks]
