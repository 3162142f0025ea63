"""Numbers to compare: computed by the page's MuJoCo and by the real package, by the same lines."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

import mujoco
import numpy as np

import labutils as lab

if TYPE_CHECKING:
    from collections.abc import Iterator

#: One of everything that a scene may hold and a lab may meet.
ZOO = """<mujoco model="zoo">
  <compiler angle="radian"/>
  <option timestep="0.004" wind="0.1 0 0" density="1.2"/>
  <size nuserdata="3"/>
  <custom><numeric name="n" data="1 2 3"/><text name="t" data="words"/>
    <tuple name="u"><element objtype="body" objname="a" prm="0.5"/></tuple></custom>
  <asset>
    <texture name="tex" type="2d" builtin="checker" width="8" height="8" rgb1="1 0 0" rgb2="0 1 0"/>
    <material name="mat" texture="tex" rgba="0.2 0.4 0.6 1" emission="0.1"/>
    <mesh name="tetra" vertex="0 0 0  .3 0 0  0 .3 0  0 0 .3"/>
    <hfield name="hill" nrow="3" ncol="3" size="1 1 .3 .1" elevation="0 .2 0 .4 1 .3 0 .1 0"/>
  </asset>
  <worldbody>
    <light name="lamp" pos="0 0 3" dir="0.1 0 -1"/>
    <camera name="wide" pos="2 0 1" xyaxes="0 1 0 -0.4 0 1" fovy="70"/>
    <camera name="tracking" mode="trackcom" pos="0 -2 1" xyaxes="1 0 0 0 0.4 1"/>
    <geom name="hill" type="hfield" hfield="hill" pos="4 0 0"/>
    <geom name="floor" type="plane" size="3 3 .1" material="mat" friction="0.7"/>
    <body name="a" pos="0 0 1"><freejoint name="free"/>
      <geom name="tetra" type="mesh" mesh="tetra"/><site name="s" pos="0.1 0 0"/>
      <body name="a1" pos="0.4 0 0"><joint name="ball" type="ball" damping="0.1"/>
        <geom name="capsule" type="capsule" size=".05 .1" user="1 2"/></body></body>
    <body name="b" pos="1 0 0.5"><joint name="slide" type="slide" axis="0 0 1" range="-1 1"/>
      <geom name="box" type="box" size=".1 .2 .05"/>
      <body name="b1" pos="0.2 0 0.1">
        <joint name="hinge" axis="0 1 0" stiffness="3" armature=".01"/>
        <geom name="ellipsoid" type="ellipsoid" size=".05 .06 .2"/><site name="tip" pos="0 0 .2"/>
      </body></body>
    <body name="c" pos="1.5 .5 .5"><joint name="d1"/><geom type="cylinder" size=".05 .1"/></body>
    <body name="d" pos="1.5 -.5 .5"><joint name="d2"/><geom type="sphere" size=".08"/></body>
    <body name="m" mocap="true" pos="0 2 1"><geom type="sphere" size=".1" contype="0"/></body>
  </worldbody>
  <contact><pair name="p" geom1="floor" geom2="box"/>
    <exclude name="x" body1="c" body2="d"/></contact>
  <tendon><spatial name="rope" width=".01"><site site="s"/><site site="tip"/></spatial>
    <fixed name="pair"><joint joint="d1" coef="1"/><joint joint="d2" coef="-1"/></fixed></tendon>
  <equality><joint name="e" joint1="d1" joint2="d2"/></equality>
  <actuator><motor name="m1" joint="slide" gear="2"/><position name="m2" joint="hinge" kp="5"/>
    <general name="m3" joint="d1" dyntype="filter" dynprm="0.1" gainprm="2"/></actuator>
  <sensor><gyro name="g" site="s"/><jointpos name="q" joint="hinge"/><framepos name="f"
    objtype="body" objname="a1"/><tendonpos name="l" tendon="rope"/></sensor>
  <keyframe><key name="k1" time="1" ctrl="0.1 0.2 0.3"/></keyframe>
</mujoco>"""

#: Called with random numbers, or with quaternions (q), matrices of rotations (r): what goes in.
FUNCTIONS: dict[str, tuple[Any, str]] = {
    "mju_mulQuat": (4, "qq"),
    "mju_negQuat": (4, "q"),
    "mju_quat2Mat": (9, "q"),
    "mju_mat2Quat": (4, "r"),
    "mju_rotVecQuat": (3, "vq"),
    "mju_quat2Vel": (3, "q1"),
    "mju_cross": (3, "vv"),
    "mju_add": (3, "vv"),
    "mju_sub3": (3, "vv"),
    "mju_scl": (3, "v1"),
    "mju_mulMatVec": (3, "Mv"),
    "mju_mulMatTVec": (3, "Mv"),
    "mju_mulMatMat": ((3, 3), "MM"),
    "mju_mulMatTMat": ((3, 3), "MM"),
    "mju_transpose": ((3, 3), "M"),
}


def collect(names: dict[str, list[str]], views: dict[str, dict[str, Any]]) -> dict[str, Any]:
    """Return all numbers, by what they are of."""
    found: dict[str, Any] = {}
    for scene, (model, data) in _make_scenes().items():
        for kind, owner in (("MjModel", model), ("MjData", data)):
            for name in names[kind]:
                found[f"{scene}.{kind}.{name}"] = getattr(owner, name)
        if scene == "zoo":
            found |= dict(_read_views(model, data, views))
    found |= _compute_camera_numbers()
    found |= _move_neck()
    found |= _drop_box()
    found |= _call_functions()
    return {name: np.asarray(value) for name, value in found.items()}


def _make_scenes() -> dict[str, tuple[Any, Any]]:
    zoo = mujoco.MjModel.from_xml_string(ZOO)
    data = mujoco.MjData(zoo)
    mujoco.mj_resetDataKeyframe(zoo, data, 0)
    mujoco.mj_step(zoo, data, 20)
    mujoco.mj_forward(zoo, data)
    return {"book": lab.make_scene(), "zoo": (zoo, data)}


def _read_views(
    model: Any, data: Any, views: dict[str, dict[str, Any]]
) -> Iterator[tuple[str, Any]]:
    """Read every attribute of every named view; an object without a name by its number."""
    counts = {
        "key": "nkey",
        "joint": "njnt",
        "texture": "ntex",
        "material": "nmat",
        "camera": "ncam",
    }
    counts |= {"equality": "neq", "body": "nbody", "numeric": "nnumeric", "actuator": "nu"}
    for owner, kinds in (("MjModel", views["MjModel"]), ("MjData", views["MjData"])):
        for kind, attributes in kinds.items():
            for number in range(getattr(model, counts.get(kind, f"n{kind}"))):
                view = getattr(model if owner == "MjModel" else data, kind)(number)
                for name in attributes:
                    yield f"view.{owner}.{kind}.{number}.{name}", getattr(view, name)


def _compute_camera_numbers() -> dict[str, Any]:
    model, data = lab.make_scene()
    found: dict[str, Any] = {}
    for number in range(model.ncam):
        name = model.camera(number).name
        found[f"pose.{name}"] = lab.get_camera_pose(model, data, name)
        found[f"K.{name}"], found[f"fov.{name}"] = lab.get_camera_intrinsics(model, name, 641, 479)
    return found


def _move_neck() -> dict[str, Any]:
    """Turn the head for one second; read positions and sensors after every step."""
    model, data = lab.make_scene()
    data.actuator("neck_pan").ctrl = 0.5
    track = []
    for _ in range(500):
        mujoco.mj_step(model, data)
        track.append(np.concatenate([data.qpos, data.qvel, data.sensordata]))
    return {"track": np.array(track), "time": data.time}


def _drop_box() -> dict[str, Any]:
    """Drop a box on a floor until it lies still; read its contacts."""
    model = mujoco.MjModel.from_xml_string(
        """<mujoco><worldbody><geom type="plane" size="2 2 .1"/><body pos="0 0 .3" euler="20 30 0">
        <freejoint/><geom type="box" size=".1 .08 .05"/></body></worldbody></mujoco>"""
    )
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data, 1000)
    forces = np.zeros((data.ncon, 6))
    for number in range(data.ncon):
        mujoco.mj_contactForce(model, data, number, forces[number])
    positional, angular = np.zeros((2, 3, model.nv))
    mujoco.mj_jac(model, data, positional, angular, [0.1, 0.2, 0.3], 1)
    mass = np.zeros((model.nv, model.nv))
    mujoco.mj_fullM(model, data, mass)
    state = np.zeros(mujoco.mj_stateSize(model, mujoco.mjtState.mjSTATE_PHYSICS))
    mujoco.mj_getState(model, data, state, mujoco.mjtState.mjSTATE_PHYSICS)
    contact = data.contact
    return {
        "box.qpos": data.qpos,
        "box.pos": contact.pos,
        "box.geom": contact.geom,
        "box.dist": contact.dist,
        "box.frame": contact.frame,
        "box.forces": forces,
        "box.jacobian": np.stack([positional, angular]),
        "box.mass": mass,
        "box.state": state,
    }


def _call_functions() -> dict[str, Any]:
    rng = np.random.default_rng(5)
    found: dict[str, Any] = {}
    for name, (shape, forms) in FUNCTIONS.items():
        result = np.zeros(shape)
        getattr(mujoco, name)(result, *(_make_argument(form, rng) for form in forms))
        found[name] = result
    quaternion, euler = np.zeros(4), rng.normal(size=3)
    mujoco.mju_euler2Quat(quaternion, euler, "xyz")
    vector = rng.normal(size=5)
    found["mju_euler2Quat"] = quaternion
    found["mju_norm"] = mujoco.mju_norm(vector)
    found["mju_normalize"] = [mujoco.mju_normalize(vector), *vector]
    found["mju_dot3"] = mujoco.mju_dot3(vector[:3], vector[2:])
    return found


def _make_argument(form: str, rng: np.random.Generator) -> Any:
    if form == "1":
        return float(rng.normal())
    if form == "v":
        return rng.normal(size=3)
    if form == "M":
        return rng.normal(size=(3, 3))
    quaternion = rng.normal(size=4)
    quaternion /= np.linalg.norm(quaternion)
    if form == "q":
        return quaternion
    w, x, y, z = quaternion
    return np.array(
        [
            [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
        ]
    ).ravel()


if sys.platform == "emscripten":

    def save_parity() -> int:
        """Write all numbers to the folder of the tests."""
        from mujoco._derived import FIELDS, VIEWS

        names = {
            kind: [name for name, field in FIELDS[kind].items() if field.sizes not in ((), ("*",))]
            for kind in ("MjModel", "MjData")
        }
        found = collect(names, {owner: VIEWS[owner] for owner in ("MjModel", "MjData")})
        np.savez("/out/parity.npz", **found)
        return len(found)
