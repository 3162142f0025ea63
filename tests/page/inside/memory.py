"""Memory: scenes that nobody needs are given back. The last function breaks the engine down."""

from __future__ import annotations

import copy
import gc

import mujoco
import numpy as np
from mujoco._engine import bridge, engine

import labutils as lab


def a_hundred_scenes_leave_the_memory_as_it_was() -> list[int]:
    for _ in range(20):  # until what is kept, such as compiled scenes, is there
        _use_a_scene()
    gc.collect()
    before = bridge.countBytes()
    for _ in range(100):
        _use_a_scene()
    after = bridge.countBytes()
    assert after == before, (before, after)
    return [before, after]


def _use_a_scene() -> None:
    model, data = lab.make_scene()
    twin, other = copy.copy(model), copy.copy(data)
    mujoco.mj_step(twin, other, 3)
    with mujoco.Renderer(model, 12, 16) as renderer:
        renderer.update_scene(data, camera="overview")
        renderer.render()
        assert renderer.scene.ngeom
    mujoco.mj_jacBody(model, data, np.zeros((3, model.nv)), None, 3)
    assert len(data.contact) == 0


def compiling_costs_little() -> list[int]:
    """The engine's binding frees no spec: some 20 kB of a small scene stay, each time."""
    text = '<mujoco><worldbody><geom size=".1"/></worldbody></mujoco>'
    before = bridge.countBytes()
    for _ in range(300):
        spec = mujoco.MjSpec.from_string(text)
        assert spec.compile().ngeom == len(spec.geoms) == 1
    after = bridge.countBytes()
    # memory grows by a fifth of itself at a time, so less cannot be told
    assert after - before < 300 * 20_000 + 0.25 * before
    return [before, after]


def lists_that_were_read_are_given_back() -> list[int]:
    model = mujoco.MjModel.from_xml_string(
        '<mujoco><worldbody><geom type="plane" size="1 1 .1"/><body pos="0 0 .1"><freejoint/>'
        '<geom type="box" size=".1 .1 .1"/></body></worldbody></mujoco>'
    )
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data, 20)
    before = bridge.countBytes()
    for _ in range(3000):
        assert data.contact.dist.size == 4
    assert bridge.countBytes() == before
    return [before, bridge.countBytes()]


def a_breakdown_says_how_to_go_on() -> None:
    from mujoco._engine import ask
    from pyodide.code import run_js

    model, data = lab.make_scene()
    crash = run_js("() => { throw new WebAssembly.RuntimeError('memory access out of bounds'); }")
    for function, *given in ((crash,), (engine.mj_step, model._handle, data._handle)):
        try:
            ask(function, *given)
        except mujoco.UnexpectedError as error:
            assert "Start Python again: press Stop" in str(error)
        else:
            raise AssertionError("expected the engine to be lost")
    try:
        mujoco.mj_step(model, data)
    except mujoco.UnexpectedError as error:
        assert "memory access out of bounds" in str(error)
    else:
        raise AssertionError("expected every call to say that the engine is lost")
