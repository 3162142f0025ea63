"""Calling a wrong function again tells what an answer alone does not, and never fails anybody."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np
import pytest

from labutils.checks import judge
from labutils.checks.calls import collect_answers
from labutils.checks.compare import is_same_outcome
from labutils.checks.explain import probes
from labutils.checks.explain.arguments import find_places
from labutils.checks.kinds import get_kind
from labutils.checks.table import load_table, read_words
from solutions import load_exercises

Array = np.ndarray[Any, Any]

#: What acts in a loop is asked by single pictures instead: no argument is changed there.
PROBED = [
    name
    for name in read_words()
    if all(get_kind(part).is_repeatable for part in load_table(name).parts)
]


def look(name: str, function: Any) -> tuple[str | None, str]:
    """Return the name of the probe and the whole message of a verdict."""
    verdict = judge(load_table(name), function)
    assert not verdict.passed
    assert verdict.misconception is None
    assert verdict.relation is None
    return verdict.probe, verdict.message


def test_an_argument_without_effect_is_named() -> None:
    def visualize_depth(depth_metric: Array, max_depth: float = 5.0) -> Array:
        del max_depth
        share = np.clip(np.nan_to_num(depth_metric, posinf=0, neginf=0) / 3.3, 0, 1)
        picture = cv2.applyColorMap((255 * share).astype(np.uint8), cv2.COLORMAP_TURBO)
        picture[~(np.isfinite(depth_metric) & (depth_metric > 0))] = 0
        return picture

    found, message = look("visualize_depth", visualize_depth)
    assert found == "no-effect:max_depth"
    assert "max_depth makes no difference" in message


def test_an_entry_without_effect_is_named() -> None:
    def depth_to_pointcloud(
        depth_metric: Array, K: Array, rgb_image: Array | None = None
    ) -> tuple[Array, Array | None]:
        rows, columns = np.indices((*depth_metric.shape,))[:]
        kept = np.isfinite(depth_metric) & (depth_metric > 0.01) & (depth_metric < 10)
        z = depth_metric[kept]
        x = (columns[kept] - depth_metric.shape[1] / 3) * z / K[0, 0]
        y = (rows[kept] - K[1, 2]) * z / K[1, 1]
        colors = None if rgb_image is None else rgb_image[kept] / 255.0
        return np.stack([x, y, z], axis=1), colors

    found, message = look("depth_to_pointcloud", depth_to_pointcloud)
    assert found == "no-effect:K[0, 2]"
    assert "K[0, 2] makes no difference" in message


def test_a_state_that_is_kept_between_calls_is_named() -> None:
    kept: list[float] = []

    def process_depth(depth_raw: Array, near: float = 0.01, far: float = 10.0) -> Array:
        kept.append(1.0)
        raw = np.clip(depth_raw, 0, 1)
        return near * far / (far - raw * (far - near)) + len(kept) * np.sin(depth_raw)

    found, message = look("process_depth", process_depth)
    assert found == "state"
    assert "answers something else" in message


def test_the_one_repair_of_an_argument_is_named() -> None:
    def project_visible_points(
        points_world: Array, T_world_cam: Array, K: Array, depth_metric: Array
    ) -> tuple[Array, Array]:
        right: Any = load_exercises()["project_visible_points"].reference
        swapped = K.copy()
        swapped[0, 0], swapped[1, 1] = K[1, 1], K[0, 0]
        return right(points_world, T_world_cam, swapped, depth_metric)

    found, message = look("project_visible_points", project_visible_points)
    assert found == "repair:K:focal"
    assert "With fx and fy exchanged in K, your answer would be right." in message


def test_width_taken_for_height_is_named() -> None:
    def choose_pan(u: float, pan: float, fov_y: float, width: int, height: int) -> float:
        right: Any = load_exercises()["choose_pan"].reference
        return float(right(u, pan, fov_y, height, width))

    found, message = look("choose_pan", choose_pan)
    assert found == "repair:swap:width:height"
    assert "With width and height exchanged" in message


def test_the_complication_without_which_it_is_right_is_named() -> None:
    def nearest_object(
        labels: Array, depth_metric: Array, K: Array, T_world_cam: Array, max_width: float
    ) -> Any:
        right: Any = load_exercises()["nearest_object"].reference
        label, place = right(labels, depth_metric, K, T_world_cam, max_width)
        # Turned the other way: wrong wherever the camera is turned.
        return label, None if place is None else place + T_world_cam[:3, :3].T[0] - np.eye(3)[0]

    found, message = look("nearest_object", nearest_object)
    assert found == "simpler:not-turned"
    assert "As soon as the camera is not turned, your answer is right." in message


def test_a_complication_is_not_blamed_where_a_case_without_it_is_wrong() -> None:
    def fill_invalid_depth(depth_metric: Array) -> Array:
        right: Any = load_exercises()["fill_invalid_depth"].reference
        return np.asarray(
            right(depth_metric)
            + 0.1 * np.sin(np.arange(depth_metric.size)).reshape(depth_metric.shape)
        )

    assert look("fill_invalid_depth", fill_invalid_depth)[0] is None


@pytest.mark.parametrize("name", list(read_words()))
def test_the_reference_answers_every_simpler_case_as_the_table_says(name: str) -> None:
    table = load_table(name)
    for simpler in table.simpler:
        plain = table.with_cases(simpler.cases, simpler.expected)
        answers = collect_answers(plain, load_exercises()[name].reference)
        for due, yours in zip(plain.expected, answers, strict=True):
            assert is_same_outcome(table.parts, due, yours), simpler.name
        assert len({*simpler.of}) == len(simpler.cases) > 0


def test_no_repair_is_told_where_nothing_was_answered() -> None:
    def nearest_object(
        labels: Array, depth_metric: Array, K: Array, T_world_cam: Array, max_width: float
    ) -> Any:
        right: Any = load_exercises()["nearest_object"].reference
        found = right(labels, depth_metric, K, T_world_cam, max_width)
        return None if found[0] is None else found

    verdict = judge(load_table("nearest_object"), nearest_object)
    assert verdict.failed_gate == "type"
    assert verdict.probe == "simpler:large-hand"


def test_nothing_and_an_array_are_two_answers() -> None:
    # None == array would be an array of truth values
    some = (np.zeros(3),)
    assert not probes.is_identical((None,), some)
    assert not probes.is_identical(some, (None,))
    assert probes.is_identical((None,), (None,))


def test_a_right_function_is_not_called_again() -> None:
    calls: list[int] = []
    table = load_table("intrinsics_matrix")
    right = load_exercises()["intrinsics_matrix"].reference

    def intrinsics_matrix(fov_y: float, width: int, height: int) -> Array:
        calls.append(1)
        return np.asarray(right(fov_y, width, height))

    assert judge(table, intrinsics_matrix).passed
    assert len(calls) == len(table.cases)


def test_a_slow_function_is_left_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    clock = iter(range(0, 10_000, 5))  # every look at the clock finds five seconds gone
    monkeypatch.setattr("time.monotonic", lambda: float(next(clock)))
    calls: list[int] = []

    def process_depth(depth_raw: Array, near: float = 0.01, far: float = 10.0) -> Array:
        calls.append(1)
        return depth_raw * 1.1 + near * np.cos(depth_raw) * far

    table = load_table("process_depth")
    assert not judge(table, process_depth).passed
    assert len(calls) == len(table.cases)


@pytest.mark.parametrize("name", PROBED)
def test_what_matters_are_arguments_of_the_exercise(name: str) -> None:
    table = load_table(name)
    assert table.matters, f"{name}: expected an argument that makes a difference"
    assert {one.partition("[")[0] for one in table.matters} <= set(find_places(table))


@pytest.mark.parametrize("name", PROBED)
def test_a_probe_of_the_reference_finds_nothing(name: str) -> None:
    """No argument of a right function is without effect, and it keeps no state."""
    exercise = load_exercises()[name]
    table = load_table(name)
    assert probes._find_state(table, table.expected, exercise.reference, 1e12) is None
    assert probes._find_no_effect(table, table.expected, exercise.reference, 1e12) is None


def test_a_repair_that_cannot_be_made_is_none() -> None:
    """The inverse of a rotation is its transpose, so it is not tried a second time."""

    def camera_to_world(points: Array, cam_xpos: Array, cam_xmat: Array) -> Array:
        return np.sin(points @ cam_xmat.reshape(3, 3)) + cam_xpos

    assert look("camera_to_world", camera_to_world)[0] is None
