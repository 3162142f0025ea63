"""What stands where in the two rooms: one to work in, one that is held out.

Lengths in meters, world x forward and z up, the table's foot at the origin.
"""

from __future__ import annotations

from dataclasses import dataclass

#: Half the sides of the floor along x and y, and the height of the walls.
HALF_X, HALF_Y, HEIGHT = 2.5, 2.0, 2.5


@dataclass(frozen=True)
class Thing:
    """A thing on the table.

    Parameters
    ----------
    name, shape : str
        Its name, and a type of geom as MuJoCo spells it in XML.
    size : tuple of float
        As MuJoCo wants it for the shape.
    pos : tuple of float
        Along x and y from the middle of the table, and its center above the top.
    color : tuple of float
        Red, green and blue, 0 to 1.
    euler : tuple of float
        Turned by so many radians about x, y and z.
    """

    name: str
    shape: str
    size: tuple[float, ...]
    pos: tuple[float, float, float]
    color: tuple[float, float, float]
    euler: tuple[float, float, float] = (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Lamp:
    """A light from far away: where its shadows are centered, where it shines, how bright."""

    pos: tuple[float, float, float]
    dir: tuple[float, float, float]
    color: tuple[float, float, float]


@dataclass(frozen=True)
class Panel:
    """A board just before a wall: the wall's number, its place along it, its half sides."""

    wall: int
    along: float
    height: float
    half_width: float
    half_height: float


@dataclass(frozen=True)
class Design:
    """All that makes one room different from another.

    Parameters
    ----------
    seed : int
        Of its textures.
    table : tuple of float
        Half the sides of the table's top, and the height of its upper face.
    table_color : tuple of float
        Mean red, green and blue of its top, 0 to 255.
    things : tuple of Thing
        What stands on it.
    lamps : tuple of Lamp
        The first casts the shadows.
    ambient : float
        Light that comes from everywhere, 0 to 1.
    plain : Panel
        A board without any texture.
    wallpaper : Panel
        A board with one ornament again and again.
    pole : tuple of float
        Where a thin pole stands, and its radius.
    """

    seed: int
    table: tuple[float, float, float]
    table_color: tuple[float, float, float]
    things: tuple[Thing, ...]
    lamps: tuple[Lamp, ...]
    ambient: float
    plain: Panel
    wallpaper: Panel
    pole: tuple[float, float, float]


_HALF_PI = 1.5707963

ROOM = Design(
    seed=0,
    table=(0.45, 0.32, 0.75),
    table_color=(158.0, 126.0, 92.0),
    things=(
        Thing(
            "red_box",
            "box",
            (0.05, 0.05, 0.05),
            (-0.25, 0.10, 0.05),
            (0.9, 0.15, 0.12),
            (0, 0, 0.6),
        ),
        Thing("green_ball", "sphere", (0.05,), (0.02, 0.18, 0.05), (0.15, 0.75, 0.2)),
        Thing("blue_can", "cylinder", (0.035, 0.06), (0.20, -0.08, 0.06), (0.15, 0.25, 0.9)),
        Thing(
            "yellow_block",
            "box",
            (0.09, 0.03, 0.04),
            (-0.05, -0.18, 0.04),
            (0.95, 0.8, 0.1),
            (0, 0, -0.5),
        ),
        Thing(
            "purple_capsule",
            "capsule",
            (0.03, 0.05),
            (-0.28, -0.15, 0.03),
            (0.6, 0.2, 0.7),
            (0, _HALF_PI, 0),
        ),
        Thing("orange_egg", "ellipsoid", (0.04, 0.04, 0.06), (0.28, 0.15, 0.06), (1.0, 0.5, 0.1)),
    ),
    lamps=(
        Lamp((-0.3, 0.3, 1.9), (0.3, -0.3, -1), (0.40, 0.40, 0.40)),
        Lamp((-1.5, -0.7, 2), (0.8, 0.4, -0.3), (0.35, 0.35, 0.35)),
        Lamp((1.5, 0.9, 2), (-0.8, -0.5, -0.2), (0.30, 0.30, 0.30)),
    ),
    ambient=0.40,
    plain=Panel(wall=0, along=0.9, height=1.3, half_width=0.45, half_height=0.35),
    wallpaper=Panel(wall=0, along=-1.15, height=1.35, half_width=0.35, half_height=0.3),
    pole=(0.56, -0.42, 0.015),
)

HELD_OUT = Design(
    seed=100,
    table=(0.40, 0.36, 0.72),
    table_color=(120.0, 132.0, 140.0),
    things=(
        Thing("white_tin", "cylinder", (0.055, 0.035), (-0.20, -0.05, 0.035), (0.9, 0.9, 0.85)),
        Thing(
            "brown_egg",
            "ellipsoid",
            (0.07, 0.045, 0.045),
            (0.05, 0.20, 0.045),
            (0.6, 0.4, 0.25),
            (0, 0, 0.8),
        ),
        Thing(
            "teal_brick",
            "box",
            (0.04, 0.08, 0.035),
            (0.22, 0.05, 0.035),
            (0.1, 0.6, 0.6),
            (0, 0, 0.3),
        ),
        Thing("pink_post", "capsule", (0.028, 0.06), (0.10, -0.20, 0.088), (0.95, 0.5, 0.65)),
        Thing(
            "gray_cube",
            "box",
            (0.045, 0.045, 0.045),
            (-0.22, 0.2, 0.045),
            (0.55, 0.55, 0.58),
            (0, 0, 0.2),
        ),
        Thing("lime_ball", "sphere", (0.04,), (-0.05, -0.08, 0.04), (0.65, 0.85, 0.2)),
    ),
    lamps=(
        Lamp((0.6, 0.5, 1.9), (-0.5, -0.4, -1), (0.42, 0.39, 0.33)),
        Lamp((-1.5, 0.6, 2), (0.8, -0.3, -0.2), (0.26, 0.28, 0.33)),
        Lamp((1.2, -1.2, 2), (-0.6, 0.7, -0.2), (0.26, 0.27, 0.30)),
    ),
    ambient=0.36,
    plain=Panel(wall=0, along=-0.6, height=1.2, half_width=0.35, half_height=0.45),
    wallpaper=Panel(wall=0, along=1.2, height=1.4, half_width=0.3, half_height=0.35),
    pole=(0.52, 0.46, 0.015),
)

DESIGNS = {"room": ROOM, "held_out": HELD_OUT}
