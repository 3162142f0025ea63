"""Wrong answers to choose_pan, as strangers wrote them."""
import numpy as np


def _right(u, pan, fov_y, width, height):
    f = height / 2 / np.tan(fov_y / 2)
    return float(pan - np.arctan((u - (width - 1) / 2) / f))


def w_sign(u, pan, fov_y, width, height):
    f = (height / 2) / np.tan(fov_y / 2)
    cx = (width - 1) / 2
    return pan + np.arctan((u - cx) / f)


def w_corner_center(u, pan, fov_y, width, height):
    f = (height / 2) / np.tan(fov_y / 2)
    return pan - np.arctan2(u - width / 2, f)


def w_integer_center(u, pan, fov_y, width, height):
    f = (height / 2) / np.tan(fov_y / 2)
    cx = (width - 1) // 2
    return float(pan - np.arctan((u - cx) / f))


def w_linear_angle(u, pan, fov_y, width, height):
    radians_per_pixel = fov_y / height
    return pan - (u - (width - 1) / 2) * radians_per_pixel


def w_width_for_focal(u, pan, fov_y, width, height):
    f = (width / 2) / np.tan(fov_y / 2)
    return pan - np.arctan((u - (width - 1) / 2) / f)


def w_height_minus_one(u, pan, fov_y, width, height):
    cx, cy = (width - 1) / 2, (height - 1) / 2
    f = cy / np.tan(fov_y / 2)
    return pan - np.arctan((u - cx) / f)


def w_degrees_out(u, pan, fov_y, width, height):
    f = (height / 2) / np.tan(fov_y / 2)
    angle = np.arctan((u - (width - 1) / 2) / f)
    return np.rad2deg(pan - angle)


def w_treats_fov_as_degrees(u, pan, fov_y, width, height):
    f = 0.5 * height / np.tan(np.deg2rad(fov_y) / 2)
    return pan - np.arctan((u - (width - 1) / 2) / f)


def w_ignores_pan(u, pan, fov_y, width, height):
    f = (height / 2) / np.tan(fov_y / 2)
    return -np.arctan((u - (width - 1) / 2) / f)


def w_hard_coded_size(u, pan, fov_y, width, height):
    f = 240 / np.tan(fov_y / 2)
    return pan - np.arctan((u - 319.5) / f)


def w_small_angle(u, pan, fov_y, width, height):
    f = height / 2 / np.tan(fov_y / 2)
    return pan - (u - (width - 1) / 2) / f


def w_fov_not_halved(u, pan, fov_y, width, height):
    f = height / (2 * np.tan(fov_y))
    return pan - np.arctan((u - (width - 1) / 2) / f)


def w_horizontal_fov_by_ratio(u, pan, fov_y, width, height):
    fov_x = fov_y * width / height
    f = (width / 2) / np.tan(fov_x / 2)
    return pan - np.arctan((u - (width - 1) / 2) / f)


def w_atan2_swapped(u, pan, fov_y, width, height):
    f = (height / 2) / np.tan(fov_y / 2)
    return pan - np.arctan2(f, u - (width - 1) / 2)


def w_rounds_column(u, pan, fov_y, width, height):
    f = (height / 2) / np.tan(fov_y / 2)
    u = int(u)
    return pan - np.arctan((u - (width - 1) / 2) / f)


def w_clips_to_neck(u, pan, fov_y, width, height):
    f = (height / 2) / np.tan(fov_y / 2)
    target = pan - np.arctan((u - (width - 1) / 2) / f)
    return float(np.clip(target, -0.5, 0.5))


def w_none_in_the_middle(u, pan, fov_y, width, height):
    f = (height / 2) / np.tan(fov_y / 2)
    off = u - (width - 1) / 2
    if off > 0:
        return pan - np.arctan(off / f)
    elif off < 0:
        return pan + np.arctan(-off / f)


def w_adds_up_turns(u, pan, fov_y, width, height, _head=[0.0]):
    f = (height / 2) / np.tan(fov_y / 2)
    _head[0] += pan - np.arctan((u - (width - 1) / 2) / f)
    return _head[0]


WRONG = [
    (w_sign, "turns to the wrong side (plus instead of minus); any u off the middle"),
    (w_corner_center, "middle at width/2, half a pixel off; every input"),
    (w_integer_center, "integer division for the middle, half a pixel off; even widths"),
    (w_linear_angle, "takes the angle as proportional to the pixels; any u off the middle, most at the edge"),
    (w_width_for_focal, "focal length from the width with the vertical field of view; pictures that are not square"),
    (w_height_minus_one, "focal length from (H-1)/2; any u off the middle, small pictures most"),
    (w_degrees_out, "answers degrees; every input but 0"),
    (w_treats_fov_as_degrees, "converts fov_y from degrees although it is in radians; any u off the middle"),
    (w_ignores_pan, "answers the change, not the angle to set; pan not 0"),
    (w_hard_coded_size, "640 x 480 written into the code; other sizes"),
    (w_small_angle, "tan(a) = a: forgets the arc tangent; any u off the middle, most at the edge"),
    (w_fov_not_halved, "tangent of the whole angle instead of half of it; any u off the middle"),
    (w_horizontal_fov_by_ratio, "horizontal angle as fov_y * W / H; pictures that are not square"),
    (w_atan2_swapped, "arguments of arctan2 swapped; every input"),
    (w_rounds_column, "cuts the column to a whole number; u with a fraction"),
    (w_clips_to_neck, "clips to a range that nobody gave; targets beyond 0.5 rad"),
    (w_none_in_the_middle, "answers None where u is the middle already; u = (width-1)/2"),
    (w_adds_up_turns, "keeps the angle in a default argument and adds to it; second call"),
]


def _cases():
    L = [(100.0, 0.2, 0.8, 640, 480), (500.5, -0.4, 1.0, 320, 240), (79.5, 0.3, 0.7, 160, 120),
         (0.0, 0.5, 1.2, 101, 77), (639.0, 0.0, 0.7853981633974483, 640, 480), (33.3, -1.0, 0.9, 64, 64)]
    return [lambda t=t: t for t in L]
