"""Rays hit what is there to be seen alone, wherever the geoms lie that collide."""

from __future__ import annotations

import mujoco
import numpy as np
import pytest

from labutils import raycast_depth
from labutils._ray_casting import cast_rays, get_pixel_rays

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
