"""Arrays behave as in the real package: written, kept, grown past, read only where they are."""

from __future__ import annotations

import copy

import mujoco
import numpy as np

import labutils as lab

_BOX = """<mujoco><worldbody><geom type="plane" size="1 1 .1"/>
 <body name="box" pos="0 0 .12"><freejoint name="free"/><geom type="box" size=".1 .1 .1"/></body>
 </worldbody></mujoco>"""


def a_write_to_an_array_reaches_the_engine() -> None:
    model, data = lab.make_scene()
    before = data.cam_xpos.copy()
    data.qpos[0] = 0.4
    mujoco.mj_forward(model, data)
    assert np.abs(data.cam_xpos - before).max() > 0.01
    data.qpos = [0.0, 0.52]
    mujoco.mj_forward(model, data)
    assert np.allclose(data.cam_xpos, before, atol=1e-12)


def an_array_of_the_model_reaches_the_engine() -> None:
    model, data = lab.make_scene()
    model.body("red_box").pos[:] = [0.5, 0.1, 1.0]
    mujoco.mj_forward(model, data)
    assert np.allclose(data.body("red_box").xpos, [0.5, 0.1, 1.0])
    model.opt.gravity[:] = 0
    model.opt.timestep = 0.01
    mujoco.mj_step(model, data)
    assert data.time == 0.01
    assert np.array_equal(copy.copy(model).opt.gravity, [0, 0, 0])


def an_array_that_is_kept_shows_the_newest_numbers() -> None:
    model = mujoco.MjModel.from_xml_string(_BOX)
    data = mujoco.MjData(model)
    qpos, xpos, height = data.qpos, data.body("box").xpos, data.qpos[2:3]
    assert data.qpos is qpos
    mujoco.mj_step(model, data, 10)
    assert height[0] == data.qpos[2] != 0.12
    mujoco.mj_forward(model, data)
    assert xpos[2] == height[0]
    qpos[2] = 3.0
    mujoco.mj_forward(model, data)
    assert data.xpos[1, 2] == 3.0


def arrays_survive_growth_of_both_memories() -> list[int]:
    from mujoco._engine import bridge

    model, data = lab.make_scene()
    qpos, colors, gravity = data.qpos, model.geom_rgba, model.opt.gravity
    before, rgba = bridge.countBytes(), colors[3].copy()
    big = [mujoco.MjModel.from_xml_string(_BOX)]
    others = [mujoco.MjData(big[0]) for _ in range(4)]
    while bridge.countBytes() == before:  # models until the engine's memory has grown
        big.append(copy.copy(model))
    ballast = [np.ones((1 << 20,)) for _ in range(8)]  # 64 MB of Python's memory
    qpos[0], gravity[2], colors[3, 0] = 0.3, -1.5, 0.125
    mujoco.mj_forward(model, data)
    assert np.isclose(data.joint("neck_pan").qpos[0], 0.3)
    twin = copy.copy(model)
    assert twin.opt.gravity[2] == -1.5
    assert twin.geom_rgba[3, 0] == 0.125
    assert np.array_equal(twin.geom_rgba[3, 1:], rgba[1:])
    assert len(others) == 4
    assert len(ballast) == 8
    return [before, bridge.countBytes()]


def views_outlive_their_objects() -> None:
    import gc

    model, data = lab.make_scene()
    qpos, size = data.qpos, model.geom("red_ball").size
    del model, data
    gc.collect()
    assert len([mujoco.MjModel.from_xml_string(_BOX) for _ in range(20)]) == 20
    qpos[0] = 1.0
    assert size[0] == 0.045


def booleans_are_booleans() -> None:
    model, data = lab.make_scene()
    assert model.jnt_limited.dtype == model.light_active.dtype == bool
    assert model.light_active.all()
    model.light_active[1] = False
    mujoco.mj_forward(model, data)
    assert model.light_active.tolist() == [True, False, True]


def a_large_array_is_written_as_a_whole() -> None:
    model, _ = lab.make_scene()
    assert model.tex_data.size > 1_000_000
    try:
        model.tex_data[0] = 1
    except ValueError as error:
        assert "read-only" in str(error)
    else:
        raise AssertionError("a write was taken that the engine does not see")
    changed = model.tex_data.copy()
    changed[:3] = [7, 8, 9]
    model.tex_data = changed
    assert model.tex_data[:4].tolist()[:3] == [7, 8, 9]


def numbers_have_the_types_of_the_real_package() -> None:
    model, data = lab.make_scene()
    assert type(model.nq) is int
    assert type(model.stat.extent) is float
    assert type(model.vis.map.znear) is float
    assert type(model.vis.global_.offwidth) is int
    assert type(data.time) is float
    assert type(mujoco.mjMAXVAL) is float
    assert type(mujoco.mjNGROUP) is int
    assert data.flg_energypos is False
    assert isinstance(model.names, bytes)


def copies_stand_alone() -> None:
    model, data = lab.make_scene()
    for make in (copy.copy, copy.deepcopy):
        twin, other = make(model), make(data)
        twin.geom_rgba[:] = 0
        other.qpos[:] = 1
        other.time = 5.0
        assert model.geom_rgba.any()
        assert not np.allclose(data.qpos, 1)
        assert data.time == 0
        assert np.array_equal(other.xpos, data.xpos)


def a_state_takes_over_another_one() -> None:
    model = mujoco.MjModel.from_xml_string(_BOX)
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data, 300)
    later = copy.copy(data)
    mujoco.mj_step(model, later, 50)
    qpos, energy = data.qpos, data.energy
    mujoco.mj_copyData(data, model, later)
    assert qpos is data.qpos
    assert np.array_equal(qpos, later.qpos)
    assert data.time == later.time
    assert data.ncon == later.ncon == len(data.contact)
    energy[:] = [1, 2]
    mujoco.mj_step(model, data)
    mujoco.mj_step(model, later)
    assert np.array_equal(qpos, later.qpos)
