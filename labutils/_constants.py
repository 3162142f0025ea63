"""Numbers and axes every room of the library agrees on."""

from __future__ import annotations

from types import MappingProxyType

import numpy as np

#: Turns MuJoCo's camera axes (x right, y up, looking along -z) into OpenCV's (x right, y down,
#: looking along +z), and back: the matrix is its own inverse.
FLIP_YZ = np.diag([1.0, -1.0, -1.0])
FLIP_YZ.setflags(write=False)

#: Turns the world's axes (x forward, y left, z up) into those of a view of it (x right, y down,
#: z forward).
TURN_WORLD = np.array([[0.0, -1, 0], [0, 0, -1], [1, 0, 0]])
TURN_WORLD.setflags(write=False)

#: A depth reading at or below this is no surface but a zero or a glitch, in meters.
MIN_DEPTH = 0.01

#: A depth reading at or beyond this is dropped from point clouds, in meters. The book's scene has
#: its far plane at 12 m, so pixels that see nothing fall out by the same rule.
MAX_DEPTH = 10.0

#: Seconds from one command of a following loop to the next.
COMMAND_S = 0.05

#: How near the middle a ball is to be followed, in pixels of a picture so many wide; a smaller
#: picture has as much less of them.
NEAR_PX, FULL_WIDTH = 15.0, 640

#: Largest hue of an 8-bit OpenCV HSV image: hues are degrees halved, so a full circle is 180.
MAX_HUE = 179

HsvRange = tuple[tuple[int, int, int], tuple[int, int, int]]

#: ((h, s, v) low, (h, s, v) high) per color of the book's scene, in OpenCV units.
#: "red" has low hue > high hue: it wraps around the hue circle.
HSV_RANGES: MappingProxyType[str, HsvRange] = MappingProxyType(
    {
        "red": ((170, 120, 50), (6, 255, 255)),
        "orange": ((8, 140, 60), (18, 255, 255)),
        "yellow": ((22, 120, 60), (34, 255, 255)),
        "green": ((45, 80, 40), (80, 255, 255)),
        "cyan": ((84, 80, 40), (98, 255, 255)),
        "blue": ((104, 100, 40), (124, 255, 255)),
        "purple": ((130, 60, 40), (160, 255, 255)),
    }
)
