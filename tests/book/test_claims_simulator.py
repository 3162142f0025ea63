"""Sentences of the book about what MuJoCo computes that no cell of a page can show."""

from __future__ import annotations

import mujoco
import numpy as np

DROP = """<mujoco><worldbody>
  <geom type="plane" size="1 1 .1"/>
  <body name="ball" pos="0 0 1"><freejoint/><geom size=".1"/><site name="here"/></body>
</worldbody>
<sensor><framepos objtype="site" objname="here"/></sensor></mujoco>"""

# A light mesh beside a heavy ball: the center of mass of the body lies far from the mesh.
UNEVEN = """<mujoco>
  <asset><mesh name="hull" vertex="0 0 0  .3 0 0  0 .3 0  0 0 .3"/></asset>
  <worldbody><body euler="20 30 40">
    <geom type="mesh" mesh="hull" mass=".1"/><geom size=".02" pos=".5 0 0" mass="5"/>
  </body></worldbody>
</mujoco>"""


def test_forward_computes_what_follows_from_the_state_and_no_time_passes() -> None:
    model = mujoco.MjModel.from_xml_string(DROP)
    data = mujoco.MjData(model)
    data.qpos[2] = 0.09  # one centimeter into the floor
    mujoco.mj_forward(model, data)
    assert data.body("ball").xpos[2] == 0.09
    assert data.ncon == 1
    assert data.qfrc_constraint[2] > 0  # the floor pushes
    assert data.sensordata[2] == 0.09
    assert (data.time, data.qpos[2]) == (0, 0.09)


def test_many_rays_hit_what_a_single_ray_hits_beside_a_heavy_part() -> None:
    """3.9, 3.14 and 3.17 lose 47 of these 179 rays; they are not installed here."""
    model = mujoco.MjModel.from_xml_string(UNEVEN)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    eye = np.array([0, 0, 1.5])
    x, y = np.meshgrid(np.linspace(-0.6, 0.6, 61), np.linspace(-0.6, 0.6, 61))
    rays = np.stack([x, y, np.full(x.shape, -1.5)], axis=-1).reshape(-1, 3)
    rays /= np.linalg.norm(rays, axis=1, keepdims=True)
    one = np.full(1, -1, np.int32)
    singly = [mujoco.mj_ray(model, data, eye, ray, None, 1, -1, one) >= 0 for ray in rays]
    count = len(rays)
    geoms, lengths = np.full(count, -1, np.int32), np.zeros(count)
    mujoco.mj_multiRay(
        model, data, eye, rays.ravel(), None, 1, -1, geoms, lengths, None, count, 1e10
    )
    assert sum(singly) == 179
    np.testing.assert_array_equal(geoms >= 0, singly)
