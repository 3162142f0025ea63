"""What is hidden by its color: the list of what rays leave out, against what OpenGL draws."""

from __future__ import annotations

import mujoco
import numpy as np
import pytest

from labutils import is_gl_available
from labutils.renderers.omissions import list_omissions

GHOSTS = """
<mujoco>
  <worldbody>
    <camera name="eye" pos="0 0 2"/>
    <site pos="0.4 0 0" size="0.2" rgba="1 0 0 {alpha}"/>
    <site name="a" pos="-0.4 -0.4 0" size="0.01" rgba="0 0 0 0"/>
    <site name="b" pos="-0.4 0.4 0" size="0.01" rgba="0 0 0 0"/>
  </worldbody>
  <tendon>
    <spatial width="0.05" rgba="0 1 0 {alpha}"><site site="a"/><site site="b"/></spatial>
  </tendon>
</mujoco>
"""


# robosuite hides sites by a negative alpha: its color pictures do not show them, but depth does.
@pytest.mark.parametrize(
    ("alpha", "expected"),
    [(1, ["1 site", "1 tendon"]), (-0.3, ["1 site", "1 tendon"]), (0, ["1 tendon"])],
)
def test_only_a_site_without_alpha_is_left_out_of_labels_and_depth(
    alpha: float, expected: list[str]
) -> None:
    model = mujoco.MjModel.from_xml_string(GHOSTS.format(alpha=alpha))
    assert list_omissions(model) == expected
    if not is_gl_available():
        pytest.skip("no OpenGL here")
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    with mujoco.Renderer(model, 120, 160) as renderer:
        renderer.update_scene(data, "eye")
        renderer.enable_segmentation_rendering()
        kinds = set(np.unique(renderer.render()[..., 1])) - {-1}
    names = {mujoco.mjtObj.mjOBJ_SITE.value: "1 site", mujoco.mjtObj.mjOBJ_TENDON.value: "1 tendon"}
    assert sorted(names[kind] for kind in kinds) == expected
