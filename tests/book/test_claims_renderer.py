"""Sentences of the book about renderers and cameras that no cell of a page can show."""

from __future__ import annotations

import labutils as lab  # isort: skip - chooses the OpenGL backend, so before MuJoCo

from collections.abc import Iterator

import mujoco
import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

BALL = """<mujoco>
  <visual><map znear="0.01" zfar="50"/>
    <quality offsamples="0" numslices="{faces}" numstacks="{faces}"/></visual>
  <statistic extent="1" center="0 0 0"/>
  <worldbody>
    <light pos="0 -2 3"/>
    <camera name="eye" pos="0 -1 0" xyaxes="1 0 0 0 0 1" fovy="20"/>
    <camera name="within" pos="0 0 .02" xyaxes="1 0 0 0 0 1"/>
    <geom name="ball" size=".1"/>
    <geom name="wall" type="box" size="60 .1 60" pos="0 39.1 0"/>
  </worldbody>
</mujoco>"""
WALL = 39 + 1  # meters from the camera to the front of the wall

SKY = """<mujoco>
  <asset><texture type="skybox" builtin="gradient" rgb1="1 1 1" width="8" height="8"/></asset>
  <visual><map znear="0.01" zfar="10"/><quality offsamples="0"/></visual>
  <statistic extent="1" center="0 0 0"/>
  <worldbody><camera name="ahead" xyaxes="0 -1 0 0 0 1"/><camera name="up" euler="180 0 0"/>
  </worldbody>
</mujoco>"""

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


@pytest.fixture
def _opengl() -> None:
    if not lab.is_gl_available():
        pytest.skip("the ray caster draws here; the claim is about OpenGL")


class Hand:
    """Draw with MuJoCo's own functions, as a program without `mujoco.Renderer` does."""

    def __init__(self, model: mujoco.MjModel, camera: str) -> None:
        self.model, self.camera = model, camera
        self.gl = mujoco.GLContext(64, 48)
        self.gl.make_current()
        self.context = mujoco.MjrContext(model, mujoco.mjtFontScale.mjFONTSCALE_100)
        mujoco.mjr_setBuffer(mujoco.mjtFramebuffer.mjFB_OFFSCREEN, self.context)
        self.scene, self.rect = mujoco.MjvScene(model, 100), mujoco.MjrRect(0, 0, 64, 48)

    def draw(self) -> tuple[np.ndarray, np.ndarray]:
        """Return color and the depth buffer as `mjr_readPixels` hands them out."""
        data = mujoco.MjData(self.model)
        mujoco.mj_forward(self.model, data)
        seen, option = mujoco.MjvCamera(), mujoco.MjvOption()
        seen.type = mujoco.mjtCamera.mjCAMERA_FIXED
        seen.fixedcamid = self.model.camera(self.camera).id
        every = mujoco.mjtCatBit.mjCAT_ALL
        mujoco.mjv_updateScene(self.model, data, option, None, seen, every, self.scene)
        rgb, depth = np.zeros((48, 64, 3), np.uint8), np.zeros((48, 64), np.float32)
        mujoco.mjr_render(self.rect, self.scene, self.context)
        mujoco.mjr_readPixels(rgb, depth, self.rect, self.context)
        return rgb, depth


@pytest.fixture
def ball(_opengl: None) -> tuple[mujoco.MjModel, mujoco.MjData]:
    return make_ball(28)


@pytest.fixture
def hand(ball: tuple[mujoco.MjModel, mujoco.MjData]) -> Iterator[Hand]:
    drawing = Hand(ball[0], "eye")
    yield drawing
    drawing.gl.make_current()
    drawing.context.free()
    drawing.gl.free()


def make_ball(faces: int) -> tuple[mujoco.MjModel, mujoco.MjData]:
    """Make a ball of 10 cm before a wall that is far away."""
    model = mujoco.MjModel.from_xml_string(BALL.format(faces=faces))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    return model, data


def test_opengl_hands_out_the_bottom_row_first_and_the_renderer_turns_it_over(
    ball: tuple[mujoco.MjModel, mujoco.MjData], hand: Hand
) -> None:
    by_hand, _ = hand.draw()
    with mujoco.Renderer(ball[0], 48, 64) as renderer:
        renderer.update_scene(ball[1], "eye")
        assert_array_equal(renderer.render(), by_hand[::-1])
    assert not np.array_equal(by_hand, by_hand[::-1])  # lit from above


def test_far_digits_are_kept_in_the_reversed_order_and_lost_when_turned_back(hand: Hand) -> None:
    """The same drawings, read in both orders: only what is drawn reversed can come out finer."""
    assert hand.context.readDepthMap == mujoco.mjtDepthMap.mjDEPTH_ZERONEAR  # the plain way
    usual, turned = mujoco.mjtDepthMap.mjDEPTH_ZERONEAR, mujoco.mjtDepthMap.mjDEPTH_ZEROFAR
    read: dict[str, set[float]] = {"usual": set(), "turned": set()}
    for _ in range(8):
        hand.model.geom("wall").pos[1] += 0.001
        for name, order in {"usual": usual, "turned": turned}.items():
            hand.context.readDepthMap = order
            read[name].add(float(hand.draw()[1][0, 0]))
    # A step of 6e-8 near 1 is 40^2 / 0.01 * 6e-8 = 10 mm there; near 0 a step is far finer.
    assert len(read["usual"]) <= 2
    assert len(read["turned"]) == 8


def test_the_renderer_reads_in_reversed_order_with_a_flag_for_depth_only(
    ball: tuple[mujoco.MjModel, mujoco.MjData], monkeypatch: pytest.MonkeyPatch
) -> None:
    drawn = []
    original = mujoco.mjr_render

    def spy(rect: mujoco.MjrRect, scene: mujoco.MjvScene, context: mujoco.MjrContext) -> None:
        drawn.append((scene.flags[mujoco.mjtRndFlag.mjRND_SEGMENT], context.readDepthMap))
        original(rect, scene, context)

    with mujoco.Renderer(ball[0], 48, 64) as renderer:
        renderer.update_scene(ball[1], "eye")
        monkeypatch.setattr(mujoco, "mjr_render", spy)
        renderer.render()
        renderer.enable_depth_rendering()
        renderer.render()
    assert [flag for flag, _ in drawn] == [0, 1]
    assert {order for _, order in drawn} == {mujoco.mjtDepthMap.mjDEPTH_ZEROFAR}


def test_closing_a_renderer_takes_the_context_of_its_thread_away(
    ball: tuple[mujoco.MjModel, mujoco.MjData], hand: Hand
) -> None:
    before, _ = hand.draw()
    with mujoco.Renderer(ball[0], 48, 64) as renderer:
        renderer.update_scene(ball[1], "eye")
        renderer.render()
    assert not np.array_equal(hand.draw()[0], before)  # and no error
    hand.gl.make_current()
    assert_array_equal(hand.draw()[0], before)


@pytest.mark.usefixtures("_opengl")
def test_round_shapes_are_drawn_with_flat_faces_and_boxes_are_not() -> None:
    errors_mm = []
    for faces in (28, 112):
        model, data = make_ball(faces)
        with lab.make_renderer(model, 120, 160) as renderer:
            _, depth = lab.render_camera(model, data, renderer, "eye")
        truth = lab.raycast_depth(model, data, "eye", 160, 120)
        on_ball = (truth < 1) & (depth < 1)
        on_wall = (truth > 2) & (depth > 2)
        errors_mm.append(1000 * np.median((depth - truth)[on_ball]))
        assert np.abs(depth - truth)[on_wall].max() < 1e-5 * WALL
    # Faces lie inside the ball, so they are behind its front; 4 times as many, 16 times less.
    assert 0 < errors_mm[1] < errors_mm[0] / 8 < 0.1


def test_a_camera_inside_a_shape_looks_out_and_a_ray_does_not(
    ball: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    with lab.make_renderer(ball[0], 24, 32) as renderer:
        _, depth = lab.render_camera(*ball, renderer, "within")
    assert depth.min() > 30
    assert np.nanmax(lab.raycast_depth(*ball, "within", 32, 24)) < 0.1


@pytest.mark.usefixtures("_opengl")
@pytest.mark.parametrize("camera", ["ahead", "up"])
def test_a_skybox_is_a_cylinder_of_seven_tenths_of_the_far_plane(camera: str) -> None:
    model = mujoco.MjModel.from_xml_string(SKY)
    data = mujoco.MjData(model)
    with lab.make_renderer(model, 48, 64) as renderer:
        raw = lab.render_raw_depth(model, data, renderer, camera)
    depth = lab.process_depth(raw, *lab.get_clip_planes(model)).astype(float)
    pixels = np.stack(np.meshgrid(np.arange(64), np.arange(48)), -1).reshape(-1, 2)
    K, _ = lab.get_camera_intrinsics(model, camera, 64, 48)
    seen = data.camera(camera)
    points = lab.pixels_to_points(pixels, depth.ravel(), K)
    x, y, z = lab.camera_to_world(points, seen.xpos, seen.xmat).T
    reach = np.hypot(x, y) if camera == "ahead" else np.abs(z)
    assert_allclose(reach, 7, atol=0.1)  # its wall has flat faces too


def test_three_groups_of_geoms_are_drawn_by_default() -> None:
    assert_array_equal(mujoco.MjvOption().geomgroup, [1, 1, 1, 0, 0, 0])


@pytest.mark.usefixtures("_opengl")
def test_sky_falls_on_either_side_of_the_far_plane() -> None:
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
