"""A picture shows the current state, all of it, and leaves the rest of the state alone."""

from __future__ import annotations

import copy
from typing import Any

import mujoco
import numpy as np
import pytest
from numpy.testing import assert_array_equal

from labutils import is_gl_available, make_renderer, render_camera, render_segmentation

pytestmark = pytest.mark.filterwarnings("ignore::labutils.NoOpenGLWarning")

SIZE = (60, 80)

#: A body that moves, with everything on it that MuJoCo draws and computes elsewhere than in
#: mj_kinematics: cameras that follow a center of mass, a light on it, a tendon, a cloth, a range
#: finder; and sensors whose values belong to whoever stepped the simulation.
MODEL = """
<mujoco>
  <option><flag energy="enable"/></option>
  <visual><quality offsamples="0" shadowsize="256"/></visual>
  <worldbody>
    <light name="follows" pos="0 0 3" mode="targetbodycom" target="mover"/>
    <geom name="floor" type="plane" size="4 4 .1" rgba=".5 .6 .5 1"/>
    <site name="anchor" pos="0 .4 .8"/>
    <camera name="fixed" pos="0 -3 1" xyaxes="1 0 0 0 .2 1"/>
    <camera name="aims" pos="1 -3 1.5" mode="targetbodycom" target="mover"/>
    <body name="mover" pos="0 0 .5">
      <joint name="slide" type="slide" axis="1 0 0"/>
      <joint name="turn" type="hinge" axis="0 0 1"/>
      <geom name="heavy" type="box" size=".1 .1 .1" pos=".3 0 0" mass="5" rgba="1 0 0 1"/>
      <geom name="light" size=".08" pos="-.3 0 .1" mass=".1" rgba="0 0 1 1"/>
      <site name="hook" pos="0 0 .2"/>
      <site name="finder" pos="0 0 -.1" euler="180 0 0"/>
      <camera name="tracks" pos="0 -2 1" xyaxes="1 0 0 0 .4 1" mode="trackcom"/>
      <camera name="rides" pos="0 -1 .5" xyaxes="1 0 0 0 .4 1"/>
    </body>
    <flexcomp name="cloth" type="grid" count="4 4 1" spacing=".1 .1 .1" pos="-.6 0 .6" dim="2"
              radius=".01" rgba="0 1 0 1"><edge equality="true"/></flexcomp>
  </worldbody>
  <tendon><spatial name="rope" width=".02" rgba="1 1 0 1"><site site="anchor"/><site site="hook"/>
  </spatial></tendon>
  <sensor>
    <rangefinder name="down" site="finder"/>
    <framepos name="where" objtype="body" objname="mover"/>
    <jointpos name="angle" joint="turn"/>
    <e_potential name="height"/>
  </sensor>
</mujoco>
"""
CAMERAS = ("fixed", "aims", "tracks", "rides")


@pytest.fixture(scope="module")
def model() -> mujoco.MjModel:
    return mujoco.MjModel.from_xml_string(MODEL)


@pytest.fixture(scope="module")
def renderer(model: mujoco.MjModel) -> Any:
    if not is_gl_available():
        pytest.skip("no OpenGL here, and rays draw no tendon and no cloth")
    with make_renderer(model, *SIZE) as renderer:
        yield renderer


def move(model: mujoco.MjModel, seed: int) -> mujoco.MjData:
    """Return a state whose positions were set and never computed from."""
    rng = np.random.default_rng(seed)
    data = mujoco.MjData(model)
    data.qpos[:] = model.qpos0 + rng.uniform(-0.3, 0.3, model.nq)
    return data


def draw_by_hand(
    model: mujoco.MjModel, data: mujoco.MjData, renderer: mujoco.Renderer, camera: Any
) -> tuple[np.ndarray, np.ndarray]:
    """Draw as MuJoCo's manual does, after a full mj_forward on a copy of the state."""
    forwarded = copy.copy(data)
    mujoco.mj_forward(model, forwarded)
    renderer.update_scene(forwarded, camera)
    rgb = renderer.render()
    renderer.enable_depth_rendering()
    depth = renderer.render()
    renderer.disable_depth_rendering()
    return rgb, depth


def read_state(data: mujoco.MjData) -> dict[str, np.ndarray]:
    """Copy what a simulation goes on from, and what its owner reads from it."""
    names = [
        *("time", "qpos", "qvel", "act", "ctrl", "qacc", "qacc_warmstart", "qfrc_applied"),
        *("xfrc_applied", "mocap_pos", "mocap_quat", "eq_active", "userdata", "plugin_state"),
        *("sensordata", "energy", "history", "flg_energypos", "flg_energyvel", "ncon", "nefc"),
        *("qfrc_bias", "qfrc_passive", "qfrc_constraint", "actuator_force", "cacc", "cvel"),
    ]
    return {name: np.array(getattr(data, name)) for name in names}


@pytest.mark.parametrize("camera", CAMERAS)
@pytest.mark.parametrize("stepped", [False, True])
def test_every_pixel_is_what_mujoco_draws_after_mj_forward(
    model: mujoco.MjModel, renderer: mujoco.Renderer, camera: str, stepped: bool
) -> None:
    data = move(model, seed=3)
    if stepped:  # positions are then those of before the last step
        mujoco.mj_step(model, data, nstep=5)
    rgb, depth = render_camera(model, data, renderer, camera)
    due_rgb, due_depth = draw_by_hand(model, data, renderer, camera)
    assert_array_equal(rgb, due_rgb)
    assert_array_equal(depth, due_depth)


def test_the_free_camera_that_tracks_a_body_is_up_to_date(
    model: mujoco.MjModel, renderer: mujoco.Renderer
) -> None:
    data = move(model, seed=4)
    camera = mujoco.MjvCamera()
    camera.type = mujoco.mjtCamera.mjCAMERA_TRACKING
    camera.trackbodyid = model.body("mover").id
    rgb, depth = render_camera(model, data, renderer, camera)
    due_rgb, due_depth = draw_by_hand(model, data, renderer, camera)
    assert_array_equal(rgb, due_rgb)
    assert_array_equal(depth, due_depth)


@pytest.mark.parametrize("stepped", [False, True])
@pytest.mark.parametrize("render", [render_camera, render_segmentation])
def test_nothing_else_of_the_state_changes(
    model: mujoco.MjModel, renderer: mujoco.Renderer, stepped: bool, render: Any
) -> None:
    data = move(model, seed=5)
    if stepped:
        mujoco.mj_step(model, data, nstep=5)
    before = read_state(data)
    render(model, data, renderer, "tracks")
    for name, values in read_state(data).items():
        assert_array_equal(values, before[name], err_msg=name)


def test_a_simulation_goes_on_as_if_no_picture_had_been_taken(
    model: mujoco.MjModel, renderer: mujoco.Renderer
) -> None:
    watched, alone = move(model, seed=6), move(model, seed=6)
    for _ in range(10):
        for data in (watched, alone):
            mujoco.mj_step(model, data)
        render_camera(model, watched, renderer, "aims")
    assert_array_equal(watched.qpos, alone.qpos)
    assert_array_equal(watched.sensordata, alone.sensordata)


def test_sensors_get_their_values_back_when_drawing_fails(
    model: mujoco.MjModel, renderer: mujoco.Renderer, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*_: Any, **__: Any) -> None:
        raise OSError("no picture")

    data = move(model, seed=7)
    before = read_state(data)
    monkeypatch.setattr(renderer, "update_scene", fail)
    with pytest.raises(OSError, match="no picture"):
        render_camera(model, data, renderer, "fixed")
    assert_array_equal(data.sensordata, before["sensordata"])
