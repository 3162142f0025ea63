"""Errors have the types and words of the real package, and leave the page usable."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any

import mujoco
import numpy as np

import labutils as lab

if TYPE_CHECKING:
    from collections.abc import Callable


def _raises(kind: type[BaseException], words: str, function: Callable[[], Any]) -> BaseException:
    try:
        function()
    except kind as error:
        assert words in str(error), f"expected {words!r}, got {error}"
        _still_works()
        return error
    raise AssertionError(f"expected {kind.__name__} with {words!r}, got nothing")


def _still_works() -> None:
    model = mujoco.MjModel.from_xml_string(
        '<mujoco><worldbody><geom size=".5"/></worldbody></mujoco>'
    )
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data)
    assert mujoco.mj_ray(model, data, [0, 0, 2], [0, 0, -1], None, True, -1, None) == 1.5


def bad_scenes_say_what_is_wrong() -> None:
    read = mujoco.MjModel.from_xml_string
    _raises(ValueError, "XML parse error", lambda: read("<mujoco"))
    broken = "<mujoco><worldbody><geom sizze='1'/></worldbody></mujoco>"
    _raises(
        ValueError, "unrecognized attribute: 'sizze'\nElement 'geom', line 1", lambda: read(broken)
    )
    flat = "<mujoco><worldbody><geom size='0'/></worldbody></mujoco>"
    _raises(ValueError, "size 0 must be positive in geom", lambda: read(flat))
    missing = "ParseXML: Error opening file 'nothing.xml'"
    _raises(ValueError, missing, lambda: mujoco.MjModel.from_xml_path("nothing.xml"))
    _raises(ValueError, "Unrecognized XML model type", lambda: mujoco.MjSpec.from_string("<m/>"))
    _raises(TypeError, "No constructor defined", mujoco.MjModel)


def unknown_names_say_which_there_are() -> None:
    model, data = lab.make_scene()
    words = "Invalid name 'eye'. Valid names: ['head_camera', 'left_eye', 'overview', 'right_eye'"
    _raises(KeyError, words, lambda: model.camera("eye"))
    _raises(IndexError, "Invalid index 99. Valid indices from 0 to 4", lambda: model.camera(99))
    _raises(IndexError, "Invalid index -1. Valid indices from 0 to 1", lambda: data.joint(-1))
    _raises(TypeError, "camera(): incompatible", lambda: model.camera(1.5))


def unknown_attributes_name_the_object() -> None:
    model, data = lab.make_scene()
    words = "'mujoco._structs._MjModelCameraViews' object has no attribute 'xpos'"
    error = _raises(AttributeError, words, lambda: model.camera(0).xpos)
    assert isinstance(error, AttributeError)
    assert error.name == "xpos"
    assert type(error.obj).__name__ == "_MjModelCameraViews"
    _raises(AttributeError, "'mujoco._structs.MjData' object has no", lambda: data.nothing)
    _raises(AttributeError, "MjOption' object has no", lambda: model.opt.nothing)
    _raises(AttributeError, "has no setter", lambda: setattr(model, "nq", 1))
    _raises(AttributeError, "module 'mujoco' has no attribute", lambda: mujoco.nothing)


def what_the_page_lacks_says_where_it_is() -> None:
    model, _ = lab.make_scene()
    words = "is not in the page's MuJoCo; run the notebook"
    for name in ("GLContext", "MjrContext", "mjr_render", "mj_saveLastXML", "viewer", "rollout"):
        _raises(AttributeError, f"mujoco.{name} {words}", partial(getattr, mujoco, name))
    _raises(AttributeError, f"MjModel.geom_castshadow {words}", lambda: model.geom_castshadow)
    _raises(AttributeError, f"MjSpec.to_xml {words}", lambda: mujoco.MjSpec().to_xml())
    _raises(ImportError, f"mujoco.viewer {words}", lambda: __import__("mujoco.viewer"))


def wrong_arguments_say_what_is_expected() -> None:
    model, data = lab.make_scene()
    words = (
        "mj_forward(): incompatible function arguments. The following argument types are "
        "supported:\n    1. (m: mujoco._structs.MjModel, d: mujoco._structs.MjData) -> None"
    )
    _raises(TypeError, words, lambda: mujoco.mj_forward(data, model))
    _raises(TypeError, words, lambda: mujoco.mj_forward(model))
    _raises(TypeError, "mj_step(): incompatible", lambda: mujoco.mj_step(model, data, steps=3))
    _raises(TypeError, "incompatible constructor", lambda: mujoco.MjData(3))
    short, matrix = np.zeros(2), np.zeros((3, 3))
    _raises(TypeError, "size", lambda: mujoco.mju_mulMatVec(short, matrix, np.zeros(3)))
    floats = np.zeros(3, np.float32)
    _raises(
        TypeError, "mju_cross(): incompatible", lambda: mujoco.mju_cross(floats, floats, floats)
    )
    _raises(ValueError, "could not broadcast", lambda: setattr(data, "qpos", [1, 2, 3]))
    _raises(TypeError, "time: expected a number", lambda: setattr(data, "time", [1, 2]))
    _raises(ValueError, "Invalid int value for mjtObj: 99", lambda: mujoco.mjtObj(99))


def numbers_beyond_the_model_never_reach_the_engine() -> None:
    model, data = lab.make_scene()
    jacobian = np.zeros((3, model.nv))
    _raises(
        IndexError, "Invalid index 99", lambda: mujoco.mj_jacBody(model, data, jacobian, None, 99)
    )
    _raises(
        IndexError, "Invalid index 0", lambda: mujoco.mj_contactForce(model, data, 0, np.zeros(6))
    )
    state = mujoco.mjtState.mjSTATE_INTEGRATION
    _raises(TypeError, "mj_stateSize", lambda: mujoco.mj_getState(model, data, np.zeros(3), state))
    ids, distances = np.zeros(1, np.int32), np.zeros(2)
    _raises(
        TypeError,
        "geomid should have length 2",
        lambda: mujoco.mj_multiRay(
            model, data, [0, 0, 2], np.ones(6), None, True, -1, ids, distances, None, 2, 9.0
        ),
    )


def a_call_that_the_engine_gives_up_leaves_the_state_ready() -> None:
    model = mujoco.MjModel.from_xml_string(
        '<mujoco><size memory="1K"/><worldbody><geom type="plane" size="1 1 .1"/>'
        '<body pos="0 0 .05"><freejoint/><geom type="box" size=".1 .1 .1"/></body>'
        "</worldbody></mujoco>"
    )
    data = mujoco.MjData(model)
    for _ in range(50):
        _raises(mujoco.FatalError, "stack overflow", lambda: mujoco.mj_step(model, data))
    mujoco.mj_kinematics(model, data)
    assert data.xpos[1, 2] == 0.05
    none = [0.0, 0.0, 0.0]
    _raises(
        mujoco.FatalError,
        "mj_ray: vector length is too small",
        lambda: mujoco.mj_ray(model, data, none, none, None, True, -1, None),
    )


def an_error_costs_no_stack() -> None:
    """Each leaves the stack of the engine where it was, or some dozens would overrun it."""
    spec = mujoco.MjSpec.from_string("<mujoco><worldbody><geom size='0'/></worldbody></mujoco>")
    for _ in range(300):
        try:
            spec.compile()
        except ValueError as error:
            assert "size 0 must be positive" in str(error)
    _still_works()


def a_scene_too_large_for_the_engine_is_refused() -> None:
    huge = '<mujoco><size memory="3G"/></mujoco>'
    _raises(ValueError, "memory", lambda: mujoco.MjModel.from_xml_string(huge))
