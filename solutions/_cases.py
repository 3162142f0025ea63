"""Pictures, depth images, masks and scenes to ask about: made from a seed, small, lopsided.

Height and width differ and nothing is centered, so that a swapped axis or a shifted center shows.
"""

from __future__ import annotations

import cv2
import numpy as np

from labutils.checks.table import Scene

#: Hues of the objects of a color scene, in OpenCV units. Red occurs on both sides of zero, and for
#: every hue h there is one near 120 - h, with which it changes places where red and blue do.
OBJECT_HUES = (0, 14, 28, 60, 88, 106, 119, 145, 177)


def make_depth(rng: np.random.Generator, height: int, width: int) -> np.ndarray:
    """Make a tilted wall with a box before it and pixels without a surface; float32 meters."""
    v, u = np.mgrid[:height, :width]
    tilt_u, tilt_v = rng.uniform(-0.03, 0.03, size=2)
    depth = rng.uniform(2.5, 4.0) + tilt_u * u + tilt_v * v
    top, left = rng.integers(1, height // 3), rng.integers(1, width // 3)
    box = np.s_[top : top + height // 2, left : left + width // 3]
    depth[box] = rng.uniform(0.6, 1.4) + 0.01 * u[box]
    depth += rng.uniform(-0.002, 0.002, size=depth.shape)
    return np.round(depth, 4).astype(np.float32)


def spoil_depth(rng: np.random.Generator, depth: np.ndarray) -> np.ndarray:
    """Put in what a sensor or a far plane leaves: NaN, infinity, zero, too near, too far.

    And what is a surface, but only just: 0.015 m and 9.6 m.
    """
    spoiled = depth.copy()
    bad = [np.nan, np.inf, 0.0, 0.004, 0.01, -1.0, 10.0, 12.0, -np.inf]
    odd = np.array([*bad, 0.015, 9.6], dtype=np.float32)
    # A patch of sky, as a window in the scene leaves it; each other kind occurs at least once.
    spoiled[: depth.shape[0] // 5, -depth.shape[1] // 4 :] = 12.0
    where = rng.choice(depth.size, size=2 * len(odd), replace=False)
    spoiled.ravel()[where] = np.tile(odd, 2)
    return spoiled


def make_rgb(rng: np.random.Generator, height: int, width: int) -> np.ndarray:
    """Make a colorful picture without any meaning; uint8."""
    coarse = rng.integers(0, 256, size=(height // 3 + 1, width // 3 + 1, 3), dtype=np.uint8)
    return np.repeat(np.repeat(coarse, 3, axis=0), 3, axis=1)[:height, :width].copy()


def make_color_scene(rng: np.random.Generator, height: int, width: int) -> np.ndarray:
    """Make discs of all hues on a dull ground, with specks on the ground and holes in the discs.

    Each disc has two hues, `OBJECT_HUES` and two more, one per half: a limit at one of them cuts
    the disc in two if limits do not belong to the range.
    """
    hsv = np.empty((height, width, 3), dtype=np.uint8)
    hsv[:] = (int(rng.integers(20, 40)), 40, 150)
    for number, hue in enumerate(rng.permutation(OBJECT_HUES)):
        row, column = divmod(number, 3)
        x = int((column + 0.5) * width / 3 + rng.integers(-2, 3))
        y = int((row + 0.5) * height / 3 + rng.integers(-2, 3))
        radius = int(rng.integers(min(height, width) // 8, min(height, width) // 6 + 1))
        first, second = _pick_color(rng, int(hue)), _pick_color(rng, int(hue) + 2)
        cv2.circle(hsv, (x, y), radius, first, -1)
        right = hsv[max(y - radius, 0) : y + radius + 1, x : x + radius + 1]
        right[(right == first).all(axis=2)] = second
        # Holes and specks of 2 to 4 pixels: some survive a kernel of 3, none one of 5.
        for left, top, color in (
            (x - 3, y - 1, (0, 0, 90)),
            (x + radius + 2, y - 2, first),
            (x - 2, y - radius - 5, second),
        ):
            size = int(rng.integers(2, 5))
            hsv[max(top, 0) : max(top + size, 0), max(left, 0) : max(left + size, 0)] = color
    return hsv_to_rgb(hsv)


def hsv_to_rgb(hsv: np.ndarray) -> np.ndarray:
    """Convert an HSV picture in OpenCV units, in whole numbers: every machine gets the same bytes.

    OpenCV converts most of a row with vectors and its end without, which rounds otherwise, and how
    wide its vectors are depends on its version and on the processor.
    """
    hue, saturation, value = np.moveaxis(hsv.astype(np.int64), -1, 0)
    sector, part = np.divmod(hue, 30)
    full = 255 * 30
    shares = (
        full,
        full - 30 * saturation,
        full - part * saturation,
        full - (30 - part) * saturation,
    )
    most, least, falling, rising = ((value * share + full // 2) // full for share in shares)
    red = np.choose(sector, [most, falling, least, least, rising, most])
    green = np.choose(sector, [rising, most, most, falling, least, least])
    blue = np.choose(sector, [least, least, rising, most, most, falling])
    return np.stack([red, green, blue], axis=-1).astype(np.uint8)


def _pick_color(rng: np.random.Generator, hue: int) -> tuple[int, int, int]:
    """Pick a saturation and value whose hue survives the way to RGB and back."""
    while True:
        color = (hue, int(rng.integers(150, 250)), int(rng.integers(130, 240)))
        pixel = hsv_to_rgb(np.array([[color]], dtype=np.uint8))
        if cv2.cvtColor(pixel, cv2.COLOR_RGB2HSV)[0, 0, 0] == hue:
            return color


def make_mask(rng: np.random.Generator, height: int, width: int) -> np.ndarray:
    """Make one large lopsided region and two small ones beside it; uint8 0 or 255."""
    mask = np.zeros((height, width), dtype=np.uint8)
    # A triangle: its center of mass is not the center of its box.
    left, top = (
        int(rng.integers(width // 4, width // 3)),
        int(rng.integers(height // 4, height // 3)),
    )
    tall, wide = (
        int(rng.integers(height // 2, 2 * height // 3)),
        int(rng.integers(width // 3, width // 2)),
    )
    corners = np.array([[left, top], [left, top + tall], [left + wide, top + tall]])
    cv2.fillPoly(mask, [corners], 255)
    side = int(rng.integers(height // 5, height // 4))
    for left, upper, small in ((width - 3 - side, 2, side), (1, height // 3, side - 2)):
        small_corners = [[left, upper], [left + small, upper], [left, upper + small]]
        cv2.fillPoly(mask, [np.array(small_corners)], 255)
    if rng.random() < 0.5:
        mask = mask[:, ::-1].copy()
    return mask


def make_blocks(
    blocks: tuple[tuple[int, int, int, tuple[float, ...]], ...],
) -> tuple[np.ndarray, np.ndarray]:
    """Make labels and depth of blocks before the sky, int32 and float32.

    Each has a label, its left column, its top row, and the depth of each column in six rows.
    """
    labels = np.zeros((20, 32), dtype=np.int32)
    depth = np.full(labels.shape, 12.0, dtype=np.float32)
    for label, left, top, columns in blocks:
        where = np.s_[top : top + 6, left : left + len(columns)]
        labels[where], depth[where] = label, columns
    return labels, depth


_SCENE = """<mujoco>
 <compiler angle="degree"/>
 <statistic extent="1" center="0 0 0"/>
 <visual><map znear="0.05" zfar="12"/></visual>
 <worldbody>
  <light pos="0 0 4"/>
  <geom name="floor" type="plane" size="6 2 .1" rgba=".5 .55 .6 1"/>
  <geom name="wall" type="box" pos="3.4 .9 1" size=".1 1.3 {wall}" rgba=".8 .7 .5 1"/>
  <body name="ball" pos="{ball_x} {ball_y} .5">
   <joint name="slide" type="slide" axis="0 1 .2"/>
   <geom type="sphere" size=".35" rgba=".85 .15 .1 1"/>
   <camera name="chase_camera" mode="trackcom" pos="-1.2 -.9 .6" xyaxes=".6 -.8 0 .2 .15 .97"/>
  </body>
  <body name="box" pos="{box_x} {box_y} .3">
   <geom type="box" size=".3 .2 .3" rgba=".1 .3 .85 1"/>
  </body>
  <body name="head" pos="0 .1 1.1">
   <joint name="pan" type="hinge" axis="0 0 1"/>
   <inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>
   <camera name="head_camera" xyaxes="0 -1 0 .25 0 .97" fovy="{fovy}"/>
  </body>
  <camera name="side_camera" pos="1.6 -2.9 1.3" xyaxes="1 .1 0 0 .3 .95" fovy="52"/>
  <camera name="sensor_camera" pos="-.3 .2 1.3" xyaxes="0 -1 0 .3 0 .95" resolution="640 480"
   sensorsize="{sensor_x} {sensor_y}" focal="{focal_x} {focal_y}" principal="{shift_x} {shift_y}"/>
 </worldbody>
</mujoco>"""


def make_scene_text(rng: np.random.Generator) -> str:
    """Make a ball, a box and four cameras.

    One is on a joint, one fixed, one given by its sensor, and one follows a center of mass. The
    ball slides down a slope if time passes: who steps moves it. The far plane is beyond 10 m, which
    some take for the end of the world.
    """
    signs = rng.choice([-1.0, 1.0], size=2)
    values = {
        "wall": rng.uniform(0.7, 1.0),
        "ball_x": rng.uniform(1.6, 2.1),
        "ball_y": rng.uniform(0.2, 0.5),
        "box_x": rng.uniform(1.5, 2.0),
        "box_y": rng.uniform(-0.9, -0.5),
        "fovy": rng.uniform(48, 70),
        "sensor_x": rng.uniform(0.0040, 0.0050),
        "sensor_y": rng.uniform(0.0028, 0.0036),
        "focal_x": rng.uniform(0.0036, 0.0041),
        "focal_y": rng.uniform(0.0042, 0.0048),
        "shift_x": signs[0] * rng.uniform(0.0002, 0.0005),
        "shift_y": signs[1] * rng.uniform(0.0002, 0.0005),
    }
    return _SCENE.format(**{name: f"{value:.6g}" for name, value in values.items()})


def make_render_scene(rng: np.random.Generator, width: int, height: int) -> Scene:
    """Make the arguments model, data and renderer, with joints moved since the last forward."""
    drawn = (float(rng.uniform(-0.5, -0.25)), float(rng.uniform(0.15, 0.3)))
    qpos = tuple(round(value, 4) for value in drawn)
    return Scene(make_scene_text(rng), ("model", "data", "renderer"), qpos, width, height)


def make_rotation(rng: np.random.Generator, low: float = 0.6, high: float = 2.2) -> np.ndarray:
    """Make a rotation matrix about a generic axis, float64; the limits are angles in radians."""
    axis = rng.uniform(0.3, 1.0, size=3) * rng.choice([-1.0, 1.0], size=3)
    angle = rng.uniform(low, high)
    x, y, z = axis / np.sqrt((axis**2).sum())
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * (cross @ cross)


def make_pose(rng: np.random.Generator, origin: np.ndarray) -> np.ndarray:
    """Make a pose that has the origin of the world within 10 cm of a point of the frame."""
    pose = np.eye(4)
    pose[:3, :3] = make_rotation(rng)
    pose[:3, 3] = rng.uniform(-0.05, 0.05, size=3) - pose[:3, :3] @ origin
    return np.round(pose, 6)
