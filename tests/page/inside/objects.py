"""Named views, structs, enums, contacts and scenes before they are compiled."""

from __future__ import annotations

import copy

import mujoco
import numpy as np

import labutils as lab


def a_view_is_written_by_attribute() -> None:
    model, data = lab.make_scene()
    data.joint("neck_pan").qpos = 0.25
    assert data.qpos[0] == 0.25
    model.geom("yellow_block").group = 4
    assert model.geom_group[model.geom("yellow_block").id] == 4
    model.cam("head_camera").fovy[:] = 60
    assert model.camera("head_camera").fovy[0] == 60
    data.actuator("neck_pan").ctrl = 0.5
    assert data.ctrl[0] == 0.5


def a_view_says_what_it_shows() -> None:
    model, _ = lab.make_scene()
    text = repr(model.camera("head_camera"))
    assert text.startswith("<_MjModelCameraViews\n  bodyid: array([")
    assert "\n  fovy: array([45.])\n" in text
    assert text.endswith("\n>")
    assert {"fovy", "id", "name", "pos"} <= set(dir(model.camera(0)))


def a_struct_says_what_it_holds() -> None:
    text = repr(mujoco.MjvCamera())
    assert text.startswith("<MjvCamera\n  azimuth: 90.0\n  distance: 2.0")
    assert "lookat: array([0., 0., 0.])" in text
    assert "gravity: array([ 0.  ,  0.  , -9.81])" in repr(lab.make_scene()[0].opt)


def a_free_camera_is_placed() -> None:
    model, data = lab.make_scene()
    camera = mujoco.MjvCamera()
    mujoco.mjv_defaultFreeCamera(model, camera)
    assert camera.type == mujoco.mjtCamera.mjCAMERA_FREE
    camera.lookat[:] = [0.9, 0.0, 0.9]
    camera.distance, camera.azimuth, camera.elevation = 1.5, 90, -30
    twin = copy.copy(camera)
    twin.lookat[0] = 5
    assert camera.lookat[0] == 0.9
    position, forward, up, right = np.zeros((4, 3))
    mujoco.mjv_cameraFrame(position, forward, up, right, data, camera)
    expected = lab.get_camera_pose(model, data, camera)
    assert np.allclose(position, expected[:3, 3], atol=1e-6)
    assert np.allclose(forward, expected[:3, 2], atol=1e-6)


def enums_are_numbers_with_names() -> None:
    kind = mujoco.mjtObj.mjOBJ_CAMERA
    assert (int(kind), kind.value, str(kind)) == (7, 7, "mjtObj.mjOBJ_CAMERA")
    assert f"{kind}" == "mjtObj.mjOBJ_CAMERA"
    assert repr(kind) == "<mjtObj.mjOBJ_CAMERA: 7>"
    assert mujoco.mjtObj(7) is kind
    assert mujoco.MjvOption().flags[mujoco.mjtVisFlag.mjVIS_STATIC] == 1


def names_and_numbers_are_looked_up() -> None:
    model, _ = lab.make_scene()
    camera = mujoco.mjtObj.mjOBJ_CAMERA
    number = mujoco.mj_name2id(model, camera, "overview")
    assert mujoco.mj_id2name(model, camera, number) == "overview"
    assert mujoco.mj_name2id(model, camera, "nobody") == -1
    assert mujoco.mj_id2name(model, camera, 99) is None
    assert model.camera(np.int64(number)).name == "overview"


def a_learner_makes_a_renderer() -> None:
    import warnings

    model, data = lab.make_scene()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with mujoco.Renderer(model, 60, 80) as renderer:
            renderer.update_scene(data, camera="head_camera")
            assert renderer.render().shape == (60, 80, 3)
            renderer.enable_depth_rendering()
            assert renderer.render().dtype == np.float32
            assert isinstance(renderer, mujoco.Renderer)
            assert renderer.scene.ngeom > 50
            assert len(renderer.scene.geoms) == renderer.scene.ngeom
        made = lab.make_renderer(model, 60, 80)
        raw = lab.render_raw_depth(model, data, made, "head_camera")
        assert 0 < raw.min() < raw.max() <= 1
    assert not lab.is_gl_available()


def a_scene_is_built_by_code() -> None:
    spec = mujoco.MjSpec()
    ball = mujoco.mjtGeom.mjGEOM_SPHERE
    body = spec.worldbody.add_body(name="ball", pos=[0, 0, 1], euler=[0, 0, 90])
    body.add_freejoint(name="free")
    geom = body.add_geom(name="skin", type=ball, size=[0.1], rgba=[1, 0, 0, 1])
    spec.worldbody.add_camera(name="eye", pos=[1, 0, 1], xyaxes=[0, 1, 0, 0, 0, 1], fovy=30)
    spec.worldbody.add_light(name="lamp", pos=[0, 0, 3])
    geom.size = geom.size * 2
    spec.option.timestep = 0.01
    model = spec.compile()
    assert (model.nbody, model.ngeom, model.ncam, model.nlight, model.njnt) == (2, 1, 1, 1, 1)
    assert model.geom("skin").size[0] == 0.2
    assert np.allclose(model.body("ball").quat, [2**-0.5, 0, 0, 2**-0.5])
    assert model.opt.timestep == 0.01
    spec.worldbody.add_geom(name="floor", type=mujoco.mjtGeom.mjGEOM_PLANE, size=[1, 1, 0.1])
    spec.delete(spec.geom("floor"))
    assert spec.compile().ngeom == 1
    assert spec.geom("floor") is None
    assert [one.name for one in spec.cameras] == ["eye"]


def what_is_written_into_a_scene_stays_though_nobody_keeps_the_element() -> None:
    spec = mujoco.MjSpec()
    box = mujoco.mjtGeom.mjGEOM_BOX
    body = spec.worldbody.add_body(name="board", mocap=True, pos=[0, 0, 1])
    body.add_geom(name="board", type=box, size=[0.1, 0.2, 0.3], rgba=[1, 0, 0, 1])
    del body
    assert spec.geom("board").size.tolist() == [0.1, 0.2, 0.3]
    spec.geom("board").size = [0.1, 0.4, 0.3]
    spec.body("board").pos = [0, 2, 0]
    model = spec.compile()
    assert model.geom("board").size.tolist() == [0.1, 0.4, 0.3]
    assert model.body("board").pos.tolist() == [0, 2, 0]
    assert model.body("board").mocapid == 0


def a_scene_finds_the_files_that_it_names() -> None:
    ball = "<mujoco><worldbody><geom name='ball' size='.1'/></worldbody></mujoco>"
    tetrahedron = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
    text = """<mujoco><include file="ball.xml"/><asset><mesh name="t" file="t.obj"/></asset>
      <worldbody><geom name="mesh" type="mesh" mesh="t"/></worldbody></mujoco>"""
    spec = mujoco.MjSpec.from_string(text, {"ball.xml": ball.encode()}, {"t.obj": tetrahedron})
    files = {"ball.xml": ball.encode(), "t.obj": tetrahedron}
    for model in (spec.compile(), mujoco.MjModel.from_xml_string(text, files)):
        assert (model.ngeom, model.nmeshvert) == (2, 4)


def contacts_are_listed() -> None:
    model = mujoco.MjModel.from_xml_string(
        '<mujoco><worldbody><geom type="plane" size="1 1 .1"/><body pos="0 0 .1"><freejoint/>'
        '<geom type="box" size=".1 .1 .1" mass="2"/></body></worldbody></mujoco>'
    )
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data, 500)
    assert data.ncon == len(data.contact) == 4
    assert data.contact.geom.tolist() == [[0, 1]] * 4
    assert (data.contact[0].geom1, data.contact[3].geom2) == (0, 1)
    force = np.zeros(6)
    total = 0.0
    for number in range(data.ncon):
        mujoco.mj_contactForce(model, data, number, force)
        total += force[0]
    assert abs(total - 2 * 9.81) < 1e-3
    assert data.efc_J.size == data.nefc * model.nv or data.efc_J.ndim == 1
