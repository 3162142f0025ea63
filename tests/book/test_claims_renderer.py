"""Sentences of the book about renderers and cameras that no cell of a page can show."""

from __future__ import annotations

import labutils as lab  # isort: skip - chooses the OpenGL backend, so before MuJoCo

import mujoco
import numpy as np
import pytest

EMPTY = """<mujoco>
  <statistic extent="{extent}" center="0 0 0"/>
  <visual><map znear="0.01" zfar="{zfar}"/></visual>
  <worldbody><camera name="up" pos="0 0 1" xyaxes="1 0 0 0 -1 0"/></worldbody>
</mujoco>"""


def get_sky_minus_far(zfar: float, extent: float) -> float:
    """Return by how many meters a pixel without a surface misses the far plane."""
    model = mujoco.MjModel.from_xml_string(EMPTY.format(zfar=zfar, extent=extent))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    with mujoco.Renderer(model, 8, 8) as renderer:
        renderer.enable_depth_rendering()
        renderer.update_scene(data, "up")
        depth = renderer.render()
    far = lab.get_clip_planes(model)[1]
    assert np.ptp(depth) == 0  # the camera sees nothing at all
    return float(depth.max()) - far


def test_sky_falls_on_either_side_of_the_far_plane() -> None:
    if lab.rendering.choose_gl_backend() == "disable":
        pytest.skip("the ray caster draws here; the claim is about OpenGL's depth buffer")
    off = [get_sky_minus_far(zfar, extent) for zfar in (6, 12, 50) for extent in (1, 1.3, 2, 3, 7)]
    assert min(off) < 0 < max(off)
    assert np.abs(off).max() < 0.1  # it is the far plane, but for rounding


def test_a_camera_that_tracks_a_center_of_mass_waits_for_it() -> None:
    """`mj_kinematics` and `mj_camlight` alone leave such a camera where it was."""
    model = mujoco.MjModel.from_xml_string("""<mujoco><worldbody><body name="arm">
      <joint name="turn" axis="0 0 1"/><geom size=".1" pos="1 0 0"/>
      <camera name="follow" mode="trackcom" pos="0 0 2"/></body></worldbody></mujoco>""")
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    before = data.camera("follow").xpos.copy()
    data.joint("turn").qpos = np.pi / 2
    mujoco.mj_kinematics(model, data)
    mujoco.mj_camlight(model, data)
    np.testing.assert_array_equal(data.camera("follow").xpos, before)
    mujoco.mj_comPos(model, data)
    mujoco.mj_camlight(model, data)
    assert np.linalg.norm(data.camera("follow").xpos - before) > 1  # it goes round with the arm
