"""Arguments stay as they are: every statement says so, and every check looks."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import mujoco
import numpy as np
import pytest

from labutils.checks import judge
from labutils.checks.calls import prepare_arguments
from labutils.checks.inputs import Watch, collect_and_watch
from labutils.checks.table import Case, Scene, load_table, read_words
from solutions import load_exercises
from tools.derive.starters import INPUTS_STAY

STARTERS = Path(__file__).resolve().parents[2] / "exercises" / "_generated"


@pytest.mark.parametrize("name", read_words())
def test_every_starter_says_it(name: str) -> None:
    assert INPUTS_STAY in (STARTERS / f"{name}.py").read_text(encoding="utf-8")


@pytest.mark.parametrize("name", read_words())
def test_every_reference_keeps_it(name: str) -> None:
    answers, changed = collect_and_watch(load_table(name), load_exercises()[name].reference)
    assert changed == ()
    assert len(answers) == len(load_table(name).cases)


def test_a_right_answer_that_writes_into_its_input_is_told_which() -> None:
    def camera_to_world(points: Any, cam_xpos: Any, cam_xmat: Any) -> Any:
        points[:, 1:] *= -1
        return points @ cam_xmat.reshape(3, 3).T + cam_xpos

    verdict = judge(load_table("camera_to_world"), camera_to_world)
    assert (verdict.result, verdict.property) == ("failed", "input")
    assert "All values agree." in verdict.message
    assert "changes points, which belongs to whoever calls it: work on a copy." in verdict.message


def test_a_wrong_answer_that_nothing_else_explains_is_told_as_well() -> None:
    def process_depth(depth_raw: Any, near: float = 0.01, far: float = 10.0) -> Any:
        np.clip(depth_raw, 0, 0.9, out=depth_raw)
        return near + np.sin(depth_raw) * far

    verdict = judge(load_table("process_depth"), process_depth)
    assert verdict.probe == "input:depth_raw"
    assert "changes depth_raw" in verdict.message


def test_time_that_passes_is_a_changed_state() -> None:
    def render_camera(model: Any, data: Any, renderer: Any, camera_name: str) -> Any:
        before = data.qpos.copy()
        mujoco.mj_step(model, data)
        data.qpos[:] = before
        mujoco.mj_forward(model, data)
        renderer.update_scene(data, camera=camera_name)
        rgb = renderer.render()
        renderer.enable_depth_rendering()
        depth = renderer.render()
        renderer.disable_depth_rendering()
        return rgb, depth

    verdict = judge(load_table("render_camera"), render_camera)
    assert verdict.property == "input"
    assert "changes data" in verdict.message


def test_a_camera_of_the_model_that_was_turned_is_a_changed_model() -> None:
    def get_camera_intrinsics(model: Any, camera_name: str, width: int, height: int) -> Any:
        right: Any = load_exercises()["get_camera_intrinsics"].reference
        result = right(model, camera_name, width, height)
        model.cam_fovy[:] = 45
        return result

    verdict = judge(load_table("get_camera_intrinsics"), get_camera_intrinsics)
    assert verdict.property == "input"
    assert "changes model" in verdict.message


def test_bringing_positions_up_to_date_is_no_change() -> None:
    right = load_exercises()["render_camera"].reference
    assert judge(load_table("render_camera"), right).passed


def test_a_renderer_that_was_closed_draws_no_color() -> None:
    def render_camera(model: Any, data: Any, renderer: Any, camera_name: str) -> Any:
        with renderer:
            return load_exercises()["render_camera"].reference(model, data, renderer, camera_name)

    verdict = judge(load_table("render_camera"), render_camera)
    assert verdict.failed_gate == "value"
    assert "whoever uses it next expects color" in verdict.message


def test_velocities_that_a_step_leaves_are_a_changed_state() -> None:
    def rank_cameras(model: Any, data: Any, point_world: Any) -> Any:
        before = data.time, data.qpos.copy()
        mujoco.mj_step(model, data)
        data.time, data.qpos[:] = before
        return load_exercises()["rank_cameras"].reference(model, data, point_world)

    verdict = judge(load_table("rank_cameras"), rank_cameras)
    assert verdict.property == "input"
    assert "changes data" in verdict.message


@pytest.mark.parametrize("name", ["cam_xpos", "cam_xmat", "xpos", "xmat", "geom_xpos"])
def test_places_that_are_written_over_are_a_changed_state(name: str) -> None:
    def rank_cameras(model: Any, data: Any, point_world: Any) -> Any:
        answer = load_exercises()["rank_cameras"].reference(model, data, point_world)
        getattr(data, name)[-1] -= 0.001
        return answer

    verdict = judge(load_table("rank_cameras"), rank_cameras)
    assert verdict.property == "input"
    assert "changes data" in verdict.message


def test_sites_that_are_written_over_are_a_changed_state() -> None:
    xml = "<mujoco><worldbody><site pos='1 2 3'/></worldbody></mujoco>"
    watch, _, data = watch_scene(Case("a site", (Scene(xml, ("model", "data")),)))
    data.site_xpos *= 2
    assert watch.find_changed() == ("data",)


def watch_scene(case: Case) -> tuple[Watch, mujoco.MjModel, mujoco.MjData]:
    """Make the arguments of a case and begin to watch them."""
    args, _ = prepare_arguments(case.args)
    return Watch(case, args, ("model", "data")), args[0], args[1]


UPDATES = {
    "all": [mujoco.mj_forward],
    "all but sensors": [mujoco.mj_fwdPosition],
    "bodies": [mujoco.mj_kinematics],
    "cameras only": [mujoco.mj_camlight],
    "bodies, then cameras": [mujoco.mj_kinematics, mujoco.mj_camlight],
    "cameras, then bodies": [mujoco.mj_camlight, mujoco.mj_kinematics],
    "centers of mass, too": [mujoco.mj_kinematics, mujoco.mj_comPos, mujoco.mj_camlight],
    "centers of mass late": [mujoco.mj_kinematics, mujoco.mj_camlight, mujoco.mj_comPos],
    "before the step": [mujoco.mj_step1],
    "twice": [mujoco.mj_forward, mujoco.mj_forward],
}


@pytest.mark.parametrize("updates", UPDATES.values(), ids=UPDATES.keys())
def test_bringing_places_up_to_date_in_part_is_no_change(updates: list[Any]) -> None:
    for name in ("rank_cameras", "render_camera"):
        for case in load_table(name).cases:
            watch, model, data = watch_scene(case)
            for update in updates:
                update(model, data)
            assert watch.find_changed() == ()


def test_nan_in_an_argument_is_no_change() -> None:
    table = load_table("visualize_depth")
    assert any(np.isnan(case.args[0]).any() for case in table.cases)
    _, changed = collect_and_watch(table, load_exercises()["visualize_depth"].reference)
    assert changed == ()
