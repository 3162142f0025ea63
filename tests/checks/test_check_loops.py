"""Controllers are judged by what happens in their loop, and named by what single pictures show."""

# ruff: noqa: ARG001 - a controller is handed more than each of them looks at

from __future__ import annotations

import base64
import json
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import cv2
import numpy as np
import pytest

from labutils import get_camera_pose, points_to_pixels, raycast_depth
from labutils.checks import judge
from labutils.checks.calls import call_once, collect_answers
from labutils.checks.gates import find_failure
from labutils.checks.judging import judge_answers
from labutils.checks.kinds import get_kind
from labutils.checks.loops.acting import act
from labutils.checks.loops.drawing import RADIUS, LoopRenderer
from labutils.checks.loops.scenario import FOLLOWS, RECOVERS, SETTLES, Loop
from labutils.checks.loops.trace import BOUND_PX, COLUMNS, PROPERTIES, Column, Looks
from labutils.checks.table import Case, CheckTable, Misfit, Part, Raised, load_table
from labutils.checks.verdict import MAX_LINES
from labutils.checks.writing import encode
from labutils.following import FollowingLoop
from tests.helpers.hidden_cases import make_hidden_table
from tests.solutions.variants.control import cut, find_ball, get_aim, proportional

PART = Part("pan, tilt", "closed-loop", "float")
KIND = get_kind(PART)
#: A short loop in which a ball stands a little to the right.
STANDING = Loop(1.2, ((SETTLES, 1.0, 1.2),), places=((0.0, -0.1, 0.4, 0.9),))


@pytest.fixture(scope="module")
def table() -> CheckTable:
    return load_table("control")


def make_trace(window: str, error: float, *, beyond: float = 0.0) -> np.ndarray:
    """Make the trace of a ball at one distance, measured for one property."""
    trace = np.full((20, COLUMNS), np.nan)
    trace[:, Column.TIME] = 0.05 * np.arange(20)
    trace[:, Column.ERROR_PX], trace[:, Column.BEYOND] = error, beyond
    trace[:, Column.IS_HIDDEN] = 0
    trace[:, Column.MEASURED] = np.where(np.arange(20) < 10, 0, PROPERTIES.index(window))
    return trace


def make_due(window: str) -> np.ndarray:
    return KIND.make_due(make_trace(window, 0.0))


# ---- The bounds, which take the place of a tolerance


@pytest.mark.parametrize("window", [SETTLES, FOLLOWS, RECOVERS])
@pytest.mark.parametrize(("factor", "passes"), [(1.1, False), (0.9, True)])
def test_a_bound_is_load_bearing(window: str, factor: float, passes: bool) -> None:
    trace = make_trace(window, factor * BOUND_PX)
    assert KIND.is_close(PART, make_due(window), trace) is passes


def test_a_ball_that_rests_may_never_be_far_and_one_that_moves_not_on_average() -> None:
    for window, passes in ((SETTLES, False), (FOLLOWS, True), (RECOVERS, True)):
        trace = make_trace(window, 5.0)
        trace[-1, Column.ERROR_PX] = 40.0
        assert KIND.is_close(PART, make_due(window), trace) is passes


@pytest.mark.parametrize(("beyond", "passes"), [(1e-9, True), (1e-3, False), (np.inf, False)])
def test_a_command_beyond_its_limit_fails_wherever_the_ball_is(beyond: float, passes: bool) -> None:
    trace = make_trace(FOLLOWS, 1.0, beyond=beyond)
    assert KIND.is_close(PART, make_due(FOLLOWS), trace) is passes


def test_what_happens_outside_of_the_windows_decides_nothing() -> None:
    trace = make_trace(FOLLOWS, 1.0)
    trace[:10, Column.ERROR_PX] = 500.0
    assert KIND.is_close(PART, make_due(FOLLOWS), trace)


def test_a_property_that_was_never_reached_does_not_hold() -> None:
    cut_short = make_trace(FOLLOWS, 1.0)[:5]
    assert not KIND.is_close(PART, make_due(FOLLOWS), cut_short)


@pytest.mark.parametrize(
    ("window", "error", "beyond", "words"),
    [
        (SETTLES, 40.0, 0.0, "The ball rests, and after the first second it is still 40 px"),
        (FOLLOWS, 20.0, 0.0, "The ball moves, and on average it is 20 px from the middle;"),
        (FOLLOWS, 900.0, 0.0, "The ball moves, and on average it is out of sight;"),
        (RECOVERS, 30.0, 0.0, "The ball is back, and a second later it is 30 px from the middle;"),
        (FOLLOWS, 1.0, 0.2, "20 of 20 commands lie beyond state.limits, the first in call 1;"),
        (FOLLOWS, 1.0, np.inf, "Call 20 of the loop answers with a number that is not finite."),
    ],
)
def test_the_first_property_that_does_not_hold_is_the_gate(
    table: CheckTable, window: str, error: float, beyond: float, words: str
) -> None:
    case = Case("a ball", (STANDING,))
    one = replace(table, cases=(case,), expected=((make_due(window),),), wrong={})
    assert judge_answers(one, ((make_trace(window, 1.0),),)).passed
    verdict = judge_answers(one, ((make_trace(window, error, beyond=beyond),),))
    assert verdict.property == ("limits" if beyond else window)
    assert verdict.paragraphs[0].startswith(words)
    assert verdict.picture is not None
    picture = cv2.imdecode(np.frombuffer(verdict.picture.png, np.uint8), cv2.IMREAD_COLOR)
    assert picture is not None
    assert "over time" in verdict.picture.summary
    assert base64.b64encode(verdict.picture.png).decode() in verdict._repr_html_()


def test_a_table_holds_no_trace_to_compare_with(table: CheckTable) -> None:
    frozen = [*table.expected, *(one for outcomes in table.wrong.values() for one in outcomes)]
    for outcome in frozen:
        assert isinstance(outcome, tuple)
        assert outcome[0] is not None
        assert outcome[0].shape == (len(PROPERTIES) + len(Looks._fields),)


def test_a_loop_survives_being_written() -> None:
    loop = Loop(2.0, ((FOLLOWS, 1.0, 2.0),), hidden=((0.5, 0.7),), places=((0, 0, 0.5, 1),))
    words = json.loads(json.dumps(encode((loop,), {})))
    assert words == {"tuple": [{"loop": json.loads(json.dumps(loop.to_words()))}]}
    assert Loop.from_words(words["tuple"][0]["loop"]) == loop


# ---- The pictures


def test_pictures_show_the_ball_where_rays_meet_it() -> None:
    with FollowingLoop(160, 120, seed=3, noise=0.0, renderer_maker=LoopRenderer) as loop:
        loop.run(proportional, 0.5)
        model, data, K = loop.model, loop.data, loop.K
        renderer = LoopRenderer(model, 120, 160)
        renderer.update_scene(data)
        rgb = renderer.render()
        renderer.enable_depth_rendering()
        depth = renderer.render()
        truth = raycast_depth(model, data, "head_camera", 160, 120)
        ball = np.linalg.inv(renderer_pose(loop)) @ [*data.body("red_ball").xpos, 1.0]
    pixel = find_ball(rgb)
    assert pixel is not None
    assert np.abs(np.array(pixel) - points_to_pixels(ball[None, :3], K)[0]).max() < 0.2
    hsv = cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV)
    is_ball = cv2.inRange(hsv, np.array((0, 120, 50)), np.array((7, 255, 255))) > 0
    assert np.count_nonzero(is_ball) > 50
    assert np.abs(depth - truth)[is_ball].max() < 1e-4
    assert ball[2] - RADIUS < truth[is_ball].min() < ball[2]


def renderer_pose(loop: FollowingLoop) -> np.ndarray:
    return get_camera_pose(loop.model, loop.data, "head_camera")


def test_depth_is_lost_where_the_ball_is_and_nowhere_else() -> None:
    with FollowingLoop(160, 120, noise=0.0, renderer_maker=LoopRenderer) as loop:
        loop.run(proportional, 0.3)
        renderer = LoopRenderer(loop.model, 120, 160, blind=((0.0, 9.0),))
        renderer.update_scene(loop.data)
        rgb = renderer.render()
        renderer.enable_depth_rendering()
        depth = renderer.render()
    hsv = cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV)
    is_ball = cv2.inRange(hsv, np.array((0, 120, 50)), np.array((7, 255, 255))) > 0
    assert not (depth[is_ball] > 0).any()
    assert {bool(one) for one in np.isnan(depth[is_ball])} == {True, False}
    assert (depth[~is_ball] > 0.3).all()


# ---- What comes back, and what is kept


@pytest.mark.parametrize(
    ("answer", "gate", "words"),
    [
        (lambda: (1, 2, 3), "type", "Expected 2 things (pan, tilt), yours is a tuple of 3."),
        (lambda: "left", "type", "Expected 2 things (pan, tilt), yours is a str."),
        (lambda: (None, 0.5), "type", "Expected pan as one number, yours is None."),
        (lambda: (0.1, np.ones(2)), "type", "Expected tilt as one number, yours is an array"),
        (lambda: (np.nan, 0.5), "limits", "Call 1 of the loop answers with a number that is not"),
        (lambda: 1 / 0, "runs", "It stops with ZeroDivisionError"),
    ],
)
def test_what_is_no_command_is_told_as_elsewhere(
    table: CheckTable, answer: Callable[[], object], gate: str, words: str
) -> None:
    verdict = judge(table, lambda *_: answer())
    assert verdict.property == gate
    assert verdict.paragraphs[0].startswith(words)


def test_who_forgets_to_return_where_no_ball_is_seen_reads_so(table: CheckTable) -> None:
    def control(rgb: Any, depth: Any, K: Any, state: Any) -> Any:
        aim = get_aim(rgb, K, state)
        return None if aim is None else cut(aim, state)

    verdict = judge(table, control)
    assert verdict.property == "type"
    assert "yours is None" in verdict.paragraphs[0]
    assert "a board before the ball" in verdict.paragraphs[1]


def test_arrays_lists_and_whole_numbers_are_commands() -> None:
    for answer in (np.array([0, 0], np.float32), [0, 0], (np.float64(0.1), 0)):
        outcome = call_once((PART,), Case("", (STANDING,)), lambda *_, answer=answer: answer)
        assert isinstance(outcome, tuple)


def test_every_loop_starts_with_an_empty_memory(table: CheckTable) -> None:
    firsts = []

    def control(rgb: Any, depth: Any, K: Any, state: Any) -> Any:
        if state.time == 0:
            firsts.append(dict(state.memory))
        state.memory["calls"] = state.memory.get("calls", 0) + 1
        return cut((state.pan, state.tilt), state)

    collect_answers(table, control)
    assert firsts == [{}] * len(table.cases)


def test_who_writes_into_a_picture_is_told_so_after_all_else_holds(table: CheckTable) -> None:
    def control(rgb: Any, depth: Any, K: Any, state: Any) -> Any:
        command = proportional(rgb, depth, K, state)
        depth[:] = 0
        return command

    verdict = judge(table, control)
    assert verdict.property == "input"
    assert "changes depth" in verdict.paragraphs[1]


def test_a_wrong_controller_is_not_called_again(table: CheckTable) -> None:
    starts = []

    def control(rgb: Any, depth: Any, K: Any, state: Any) -> Any:
        starts.append(state.time == 0)
        return cut((0.3 * np.sin(state.time), 0.5), state)

    verdict = judge(table, control)
    assert (verdict.passed, verdict.misconception, verdict.probe) == (False, None, None)
    assert sum(starts) == len(table.cases)


def test_a_lost_ball_ends_a_loop_early() -> None:
    away = Loop(9.0, ((FOLLOWS, 0.2, 9.0),), places=((0.0, 0.0, 0.5, 1.0),))
    trace = act(away, lambda *_: np.array([-1.4, -0.7]))
    assert len(trace) < 9.0 / 0.05
    assert KIND.to_canonical(trace)[PROPERTIES.index(FOLLOWS)] == 0


# ---- The wrong controllers, in other words than the card's


def steer(
    pan: float = 1.0,
    tilt: float = 1.0,
    gain: float = 1.0,
    pose: str = "seen",
    *,
    limited: bool = True,
) -> Callable[..., Any]:
    """Make a controller that turns by the angle of each picture, with its faults."""

    def control(rgb: Any, depth: Any, K: Any, state: Any) -> Any:
        pixel = find_ball(rgb)
        if pixel is None:
            return state.memory.get("last", (state.pan, state.tilt))
        right = (pixel[0] - K[0, 2]) / K[0, 0]
        down = (pixel[1] - K[1, 2]) / K[1, 1]
        old = pose == "seen"
        here = (state.seen_pan, state.seen_tilt) if old else (state.pan, state.tilt)
        command = np.array(here) + gain * np.array([-pan * right, tilt * down])
        state.memory["last"] = cut(command, state) if limited else tuple(command)
        return state.memory["last"]

    return control


def summing(gain: float) -> Callable[..., Any]:
    """Add up, and cut off only what is handed out."""

    def control(rgb: Any, depth: Any, K: Any, state: Any) -> Any:
        aim = get_aim(rgb, K, state)
        total = state.memory.setdefault("total", np.array([state.seen_pan, state.seen_tilt]))
        if aim is not None:
            total += gain * (aim - (state.seen_pan, state.seen_tilt))
        return cut(total, state)

    return control


def proportional_with_windup(rgb: Any, depth: Any, K: Any, state: Any) -> Any:
    """A proportional part, and an integral that nothing limits."""
    aim = get_aim(rgb, K, state)
    total = state.memory.setdefault("total", np.zeros(2))
    if aim is None:
        return cut((state.pan, state.tilt), state)
    total += 3.0 * state.dt * (aim - (state.seen_pan, state.seen_tilt))
    return cut(aim + total, state)


def in_degrees(rgb: Any, depth: Any, K: Any, state: Any) -> Any:
    """Answer in degrees altogether."""
    aim = get_aim(rgb, K, state)
    return cut(np.degrees((state.pan, state.tilt) if aim is None else aim), state)


def by_its_point(rgb: Any, depth: Any, K: Any, state: Any) -> Any:
    """Aim at the point in the world, and at the middle of nowhere without a depth."""
    pixel = find_ball(rgb)
    if pixel is not None:
        away = np.nan_to_num(depth[int(pixel[1]), int(pixel[0])])
        x, y, z = away * (np.linalg.inv(K) @ [*pixel, 1.0])
        turn = np.array([-np.arctan2(x, z), np.arctan2(y, z)])
        state.memory["last"] = cut(np.add(turn, (state.seen_pan, state.seen_tilt)), state)
    return state.memory.get("last", (state.pan, state.tilt))


def without_depth_no_ball(rgb: Any, depth: Any, K: Any, state: Any) -> Any:
    """Skip every picture in which the ball has no depth."""
    mask = cv2.inRange(cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV), (0, 120, 50), (7, 255, 255)) > 0
    if (depth[mask] > 0).any():
        state.memory["last"] = cut(get_aim(rgb, K, state), state)
    return state.memory.get("last", (state.pan, state.tilt))


WRONG = [
    ("sign-of-pan", "once more", steer(pan=-0.5)),
    ("sign-of-pan", "from the pose of now", steer(pan=-1, gain=0.8)),
    ("tilt-up", "with a low gain", steer(tilt=-1, gain=0.4)),
    ("degrees", "of the whole answer", in_degrees),
    ("degrees", "of the angle", steer(gain=180 / np.pi)),
    ("no-limits", "with a gain", steer(gain=0.8, limited=False)),
    ("wind-up", "slowly", summing(0.2)),
    ("wind-up", "fast", summing(0.4)),
    ("wind-up", "beside a proportional part", proportional_with_windup),
    ("stale-frame", "with a gain above one", steer(pose="now", gain=1.2)),
    ("needs-depth", "in a point", by_its_point),
    ("needs-depth", "anywhere", without_depth_no_ball),
    ("sign-of-pan + tilt-up", "turned round", steer(pan=-1, tilt=-1, gain=0.7)),
    ("tilt-up + no-limits", "turned and unlimited", steer(tilt=-1, limited=False)),
]
#: One of each, for a start.
FIRST = [WRONG[1], WRONG[2], WRONG[3], WRONG[5], WRONG[6], WRONG[9], WRONG[11]]


def make_parameters(rows: list[Any]) -> list[Any]:
    return [pytest.param(name, control, id=f"{name}, {how}") for name, how, control in rows]


def check_is_named(table: CheckTable, name: str, control: Callable[..., Any]) -> None:
    verdict = judge(table, control)
    assert not verdict.passed
    assert verdict.misconception == name, verdict.message
    assert len(verdict.message.splitlines()) <= MAX_LINES


@pytest.mark.parametrize(("name", "control"), make_parameters(FIRST))
def test_a_wrong_controller_is_named_by_what_it_does(
    table: CheckTable, name: str, control: Callable[..., Any]
) -> None:
    check_is_named(table, name, control)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "control"), make_parameters([one for one in WRONG if one not in FIRST])
)
def test_other_wrong_controllers_are_named_by_what_they_do(
    table: CheckTable, name: str, control: Callable[..., Any]
) -> None:
    check_is_named(table, name, control)


@pytest.mark.slow
@pytest.mark.parametrize(("name", "control"), make_parameters(WRONG))
def test_wrong_controllers_fail_hidden_cases_of_5_seeds(
    name: str, control: Callable[..., Any]
) -> None:
    for seed in range(5):
        hidden = make_hidden_table("control", seed)
        assert find_failure(hidden, collect_answers(hidden, control)), f"{name}: seed {seed}"


def test_who_keeps_the_properties_is_right_whatever_single_pictures_show(
    table: CheckTable,
) -> None:
    # The angle of an old picture, added to the pose of now: with half of it the loop stays calm.
    assert judge(table, steer(pose="now", gain=0.6)).passed


def test_outcomes_without_a_trace_are_outcomes_all_the_same(table: CheckTable) -> None:
    case = table.cases[0]
    assert isinstance(call_once((PART,), case, lambda *_: None), Misfit)
    assert isinstance(call_once((PART,), case, lambda: None), Raised)
