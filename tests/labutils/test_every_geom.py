"""Rays hit what is there to be seen alone, wherever the geoms lie that collide."""

from __future__ import annotations

import mujoco
import numpy as np
import pytest

from labutils import _ray_casting, make_scene, raycast_depth
from labutils._ray_casting import cast_rays, get_pixel_rays
from labutils.cameras import get_camera_pose

SCENE = """
<mujoco>
 <asset><mesh name="hull" vertex="0 0 0  .3 0 0  0 .3 0  0 0 .3"/></asset>
 <worldbody>
  <camera name="eye" pos="0 0 1.5"/>
  <geom type="plane" size="3 3 .1" pos="0 0 -1"/>
  <body euler="20 30 40">
   <geom {seen} contype="0" conaffinity="0" mass="1"/>
   <geom type="sphere" group="3" size=".02" pos=".05 0 -.4" mass="5"/>
  </body>
 </worldbody>
</mujoco>
"""


@pytest.mark.parametrize(
    "seen", ['type="mesh" mesh="hull"', 'type="box" size=".2 .3 .1"', 'type="sphere" size=".2"']
)
def test_every_ray_hits_what_a_single_ray_hits(seen: str) -> None:
    model = mujoco.MjModel.from_xml_string(SCENE.format(seen=seen))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    before = model.body_bvhadr.copy()
    width, height = 61, 47
    rays = get_pixel_rays(model, data, "eye", width, height)
    depth, geom_ids, _ = cast_rays(model, data, data.cam_xpos[0], rays)
    groups = np.array([1, 1, 1, 0, 0, 0], dtype=np.uint8)
    one = np.full(1, -1, dtype=np.int32)
    standing = True  # geoms of the world are looked at too
    for v, u in np.ndindex(height, width):
        # a ray is one meter long along the axis, so that the factor is the depth
        length = mujoco.mj_ray(model, data, data.cam_xpos[0], rays[v, u], groups, standing, -1, one)
        assert geom_ids[v, u] == one[0]
        assert depth[v, u] == pytest.approx(length, rel=1e-12)
    assert (geom_ids == 1).sum() > 50
    assert (raycast_depth(model, data, "eye", width, height) == depth.astype(np.float32)).all()
    np.testing.assert_array_equal(model.body_bvhadr, before)


@pytest.mark.parametrize("size", [(1, 1), (2, 5), (37, 23), (160, 120)])
@pytest.mark.parametrize("camera", ["head_camera", "overview", "above"])
def test_what_is_not_tried_changes_no_bit_of_what_is_hit(
    camera: str, size: tuple[int, int], monkeypatch: pytest.MonkeyPatch
) -> None:
    model, data = make_scene()
    looked: str | mujoco.MjvCamera = camera
    if camera == "above":
        looked = mujoco.MjvCamera()  # in the head, which is around it
        looked.lookat[:], looked.distance = data.body("head").xpos, 0.01
        looked.elevation = -90
    colors, materials = model.geom_rgba.copy(), model.geom_matid.copy()
    for pan in (-1.0, 0.0, 0.7):
        data.joint("neck_pan").qpos = pan
        mujoco.mj_forward(model, data)
        rays = get_pixel_rays(model, data, looked, *size)
        origin = get_camera_pose(model, data, looked)[:3, 3]
        near = cast_rays(model, data, origin, rays)
        with monkeypatch.context() as patch:
            patch.setattr(_ray_casting, "_SLACK", np.pi)  # everything may be hit
            patch.setattr(_ray_casting, "_TILES", (1, 1))
            for found, expected in zip(near, cast_rays(model, data, origin, rays), strict=True):
                np.testing.assert_array_equal(found, expected)
    np.testing.assert_array_equal(model.geom_rgba, colors)
    np.testing.assert_array_equal(model.geom_matid, materials)
