"""Build a textured room around the humanoid of the book.

The body, the neck and the eyes are those of the book's scene. Its pelvis can be moved here, its
eyes stand farther apart and see more: 58 degrees from top to bottom.
"""

from __future__ import annotations

from typing import Any

import mujoco
import numpy as np

from labutils.room import textures
from labutils.room.designs import DESIGNS, HALF_X, HALF_Y, HEIGHT, Design, Panel, Thing
from labutils.scene import SCENE_PATH

#: Distance of the eyes in meters, and their vertical field of view in degrees.
BASELINE, FOV_Y = 0.10, 58.0
LEFT, RIGHT, IMU = "left_eye", "right_eye", "imu"
#: What moves the robot, in the order of ``qpos``.
JOINTS = ("base_x", "base_y", "base_z", "base_yaw", "neck_pan", "neck_tilt")
#: Names of what is planted to make matching hard.
PLAIN, WALLPAPER, POLE = "plain_panel", "wallpaper", "pole"

#: What stays of the book's scene.
_ROBOT, _ROBOT_MATERIALS = "pelvis", ("shell", "joint", "accent", "visor", "eye")
_GEOM = mujoco.mjtGeom
_SHAPES = {
    "box": _GEOM.mjGEOM_BOX,
    "sphere": _GEOM.mjGEOM_SPHERE,
    "cylinder": _GEOM.mjGEOM_CYLINDER,
    "capsule": _GEOM.mjGEOM_CAPSULE,
    "ellipsoid": _GEOM.mjGEOM_ELLIPSOID,
}
#: Middle of every wall, and its axes: x along it, y up, so that z points into the room.
_WALLS = (
    ((HALF_X, 0.0), (0.0, -1.0, 0.0), HALF_Y),
    ((-HALF_X, 0.0), (0.0, 1.0, 0.0), HALF_Y),
    ((0.0, HALF_Y), (1.0, 0.0, 0.0), HALF_X),
    ((0.0, -HALF_Y), (-1.0, 0.0, 0.0), HALF_X),
)


def make_room(name: str = "room") -> tuple[mujoco.MjModel, mujoco.MjData]:
    """Build a room and put the robot into its middle.

    Convention
    ----------
    World x is forward of the robot at ``base_yaw`` 0, y to its left, z up. The right eye stands
    `BASELINE` to the right of the left one; `set_baseline` changes that.

    Parameters
    ----------
    name : str
        ``"room"``, or ``"held_out"``: other textures, other things, other light.

    Returns
    -------
    model, data : mujoco.MjModel, mujoco.MjData
        The compiled room and its state, after ``mj_forward``.

    Raises
    ------
    ValueError
        If there is no room of that name.
    """
    if name not in DESIGNS:
        raise ValueError(f"name: expected one of {', '.join(DESIGNS)}, got {name!r}")
    design = DESIGNS[name]
    spec = mujoco.MjSpec.from_file(str(SCENE_PATH))
    _empty(spec)
    _let_it_walk(spec)
    rng = np.random.default_rng(design.seed)
    _add_walls(spec, rng)
    _add_table(spec, design, rng)
    _add_planted(spec, design, rng)
    _add_light(spec, design)
    model = spec.compile()
    set_baseline(model, BASELINE)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    return model, data


def set_baseline(model: mujoco.MjModel, baseline: float) -> None:
    """Put the right eye so many meters to the right of the left one, which stays."""
    model.camera(RIGHT).pos[1] = model.camera(LEFT).pos[1] - baseline


def set_pose(model: mujoco.MjModel, data: mujoco.MjData, **angles: float) -> None:
    """Put the robot somewhere: every joint that is not named goes to 0.

    Raises
    ------
    ValueError
        If the robot has no joint of that name.
    """
    strangers = set(angles) - set(JOINTS)
    if strangers:
        raise ValueError(f"pose: expected joints of {', '.join(JOINTS)}, got {min(strangers)!r}")
    data.qpos[:] = [angles.get(name, 0.0) for name in JOINTS]
    mujoco.mj_forward(model, data)


def _empty(spec: mujoco.MjSpec) -> None:
    """Take out everything but the robot."""
    for key in list(spec.keys):
        spec.delete(key)
    world = spec.worldbody
    for one in [*world.lights, *world.geoms, *world.cameras]:
        spec.delete(one)
    for body in list(world.bodies):
        if body.name != _ROBOT:
            spec.delete(body)
    for texture in list(spec.textures):
        spec.delete(texture)
    for material in list(spec.materials):
        if material.name not in _ROBOT_MATERIALS:
            spec.delete(material)


def _let_it_walk(spec: mujoco.MjSpec) -> None:
    """Give the pelvis a place and a direction, and the eyes their lenses."""
    pelvis = spec.body(_ROBOT)
    for name, axis in (("base_x", 0), ("base_y", 1), ("base_z", 2)):
        along = [float(axis == one) for one in range(3)]
        pelvis.add_joint(name=name, type=mujoco.mjtJoint.mjJNT_SLIDE, axis=along)
    pelvis.add_joint(name="base_yaw", type=mujoco.mjtJoint.mjJNT_HINGE, axis=[0, 0, 1])
    for camera in spec.cameras:
        if camera.name in (LEFT, RIGHT):
            camera.fovy = FOV_Y
            camera.pos = [camera.pos[0], BASELINE / 2, camera.pos[2]]


def _add_material(
    spec: mujoco.MjSpec, name: str, picture: np.ndarray, *, is_cube: bool = False
) -> str:
    """Add a texture and a material of that name, dull, and return the name."""
    kind = mujoco.mjtTexture
    height, width = picture.shape[:2]
    texture = spec.add_texture(
        name=name,
        type=kind.mjTEXTURE_CUBE if is_cube else kind.mjTEXTURE_2D,
        width=width,
        height=height,
        nchannel=3,
    )
    texture.data = np.ascontiguousarray(picture).tobytes()
    material = spec.add_material(name=name, specular=0, shininess=0, reflectance=0)
    material.textures[mujoco.mjtTextureRole.mjTEXROLE_RGB] = name
    return name


def _add_walls(spec: mujoco.MjSpec, rng: np.random.Generator) -> None:
    world = spec.worldbody
    floor = _add_material(spec, "floor", textures.make_poster(rng, shapes=700))
    size = [HALF_X, HALF_Y, 0.1]
    world.add_geom(
        name="floor", type=_GEOM.mjGEOM_PLANE, size=size, material=floor, castshadow=False
    )
    ceiling = _add_material(spec, "ceiling", textures.make_grain(rng, 512, (190, 188, 180), 16))
    over = [0.0, 1.0, 0.0, 0.0]  # turned over about x: it is seen from below
    world.add_geom(
        name="ceiling",
        type=_GEOM.mjGEOM_PLANE,
        size=size,
        pos=[0, 0, HEIGHT],
        quat=over,
        material=ceiling,
        castshadow=False,
    )
    for number, ((x, y), along, half) in enumerate(_WALLS):
        name = _add_material(spec, f"wall_{number}", textures.make_poster(rng))
        world.add_geom(
            name=name,
            type=_GEOM.mjGEOM_PLANE,
            size=[half, HEIGHT / 2, 0.1],
            pos=[x, y, HEIGHT / 2],
            quat=_make_upright(along),
            material=name,
            castshadow=False,
        )


def _add_table(spec: mujoco.MjSpec, design: Design, rng: np.random.Generator) -> None:
    half_x, half_y, top = design.table
    grain = textures.make_grain(rng, textures.OBJECT_SIZE * 2, design.table_color, 20)
    wood = _add_material(spec, "table", textures.make_cube(grain), is_cube=True)
    table = spec.worldbody.add_body(name="table")
    thick = 0.02
    _add_box(table, "table_top", [half_x, half_y, thick], [0, 0, top - thick], wood)
    leg, inset = (top - 2 * thick) / 2, 0.05
    for number in range(4):
        x = (half_x - inset) * (1 if number % 2 else -1)
        y = (half_y - inset) * (1 if number < 2 else -1)
        _add_box(table, f"leg_{number}", [0.025, 0.025, leg], [x, y, leg], wood)
    for thing in design.things:
        _add_thing(spec, thing, top, rng)


def _add_box(body: Any, name: str, size: list[float], pos: list[float], material: str) -> None:
    body.add_geom(name=name, type=_GEOM.mjGEOM_BOX, size=size, pos=pos, material=material)


def _add_thing(spec: mujoco.MjSpec, thing: Thing, top: float, rng: np.random.Generator) -> None:
    base = tuple(215 * one for one in thing.color)
    grain = textures.make_grain(rng, textures.OBJECT_SIZE, (base[0], base[1], base[2]), 24)
    material = _add_material(spec, thing.name, textures.make_cube(grain), is_cube=True)
    x, y, z = thing.pos
    body = spec.worldbody.add_body(
        name=thing.name, pos=[x, y, top + z], quat=_make_turn(thing.euler)
    )
    body.add_geom(
        name=thing.name,
        type=_SHAPES[thing.shape],
        size=[*thing.size, 0, 0][:3],
        material=material,
    )


def _add_planted(spec: mujoco.MjSpec, design: Design, rng: np.random.Generator) -> None:
    """Add what makes matching hard: no texture, one that repeats, and something thin."""
    paint = np.full((8, 8, 3), (204, 204, 199), dtype=np.uint8)
    _add_panel(spec, PLAIN, design.plain, _add_material(spec, PLAIN, paint))
    print_ = textures.make_wallpaper(rng)
    _add_panel(spec, WALLPAPER, design.wallpaper, _add_material(spec, WALLPAPER, print_))
    x, y, radius = design.pole
    pole = spec.worldbody.add_body(name=POLE, pos=[x, y, HEIGHT / 2])
    pole.add_geom(
        name=POLE,
        type=_GEOM.mjGEOM_CYLINDER,
        size=[radius, HEIGHT / 2, 0],
        rgba=[0.3, 0.3, 0.32, 1],
    )


def _add_panel(spec: mujoco.MjSpec, name: str, panel: Panel, material: str) -> None:
    (x, y), along, _ = _WALLS[panel.wall]
    inward = -np.array([x, y]) / max(abs(x), abs(y))
    thick = 0.02
    place = np.array([x, y]) + panel.along * np.array(along[:2]) + thick * inward
    body = spec.worldbody.add_body(name=name, pos=[*place, panel.height], quat=_make_upright(along))
    size = [panel.half_width, panel.half_height, thick]
    body.add_geom(name=name, type=_GEOM.mjGEOM_BOX, size=size, material=material)


def _add_light(spec: mujoco.MjSpec, design: Design) -> None:
    for number, lamp in enumerate(design.lamps):
        spec.worldbody.add_light(
            name=f"lamp_{number}",
            pos=lamp.pos,
            dir=lamp.dir,
            diffuse=lamp.color,
            specular=[0, 0, 0],
            type=mujoco.mjtLightType.mjLIGHT_DIRECTIONAL,
            castshadow=number == 0,
        )
    # One light far away casts the shadows: its map covers the room, 1.7 mm per texel.
    spec.visual.quality.shadowsize = 4096
    spec.visual.map.shadowclip = 1.75
    head = spec.visual.headlight
    head.ambient, head.diffuse = [design.ambient] * 3, [0, 0, 0]


def _make_upright(along: tuple[float, float, float]) -> np.ndarray:
    """Turn a thing upright, its x along a wall: z then points into the room."""
    up = np.array([0.0, 0.0, 1.0])
    axes = np.stack([np.array(along), up, np.cross(along, up)], axis=1)
    quat = np.empty(4)
    mujoco.mju_mat2Quat(quat, axes.ravel())
    return quat


def _make_turn(euler: tuple[float, float, float]) -> np.ndarray:
    quat = np.empty(4)
    mujoco.mju_euler2Quat(quat, np.array(euler), "xyz")
    return quat
