"""The following explorer: what it records, what it answers, what it says of a bad controller."""

from __future__ import annotations

import json
import sys
from typing import Any

import mujoco
import numpy as np
import pytest

import labutils as lab
from labutils.explorers import FollowingExplorer, explore_following
from labutils.explorers import following as module
from labutils.explorers._following_recording import EYE, OUTSIDE, decode_picture, to_moments
from labutils.explorers.following import FollowingView
from labutils.following import FollowingLoop, FollowingState
from labutils.following.loop import DT
from labutils.renderers.rays import RaycastRenderer
from tests.helpers.node import evaluate
from tools.explorer_views import make_view

SIZE: dict[str, Any] = {"width": 40, "height": 30}
RED = ((0, 120, 50), (7, 255, 255))
NAMES = ("time", "error_px", "error_mm", "is_hidden", "mean_px", "mean_mm")


def follow(
    rgb: np.ndarray, depth: np.ndarray, K: np.ndarray, state: FollowingState
) -> tuple[float, float]:
    """Follow the middle of what is red, and tell the point of it that is seen."""
    pixel = lab.find_object_centroid(lab.segment_by_color(rgb, RED))
    state.memory["center"] = None
    if pixel is None:
        return state.pan, state.tilt
    u, v = pixel
    ray = np.linalg.inv(K) @ [u, v, 1]
    state.memory["center"] = (state.T_world_cam @ [*(depth[v, u] * ray), 1])[:3]
    return lab.command_from_pixel(pixel, K, state.seen_pan, state.seen_tilt, state.limits)


def stand(
    rgb: np.ndarray,  # noqa: ARG001 - a controller is given it
    depth: np.ndarray,  # noqa: ARG001 - likewise
    K: np.ndarray,  # noqa: ARG001 - likewise
    state: FollowingState,
) -> tuple[float, float]:
    """Stay as one is."""
    return state.pan, state.tilt


@pytest.fixture(scope="module")
def recorded() -> FollowingExplorer:
    return explore_following(follow, recorded_s=6)


@pytest.fixture
def explorer() -> FollowingExplorer:
    return explore_following(stand, recorded_s=0, **SIZE)


def ask(explorer: FollowingExplorer, monkeypatch: pytest.MonkeyPatch, **content: Any) -> list[Any]:
    """Let the page say something; return what Python answers."""
    sent: list[Any] = []
    monkeypatch.setattr(
        explorer.view, "send", lambda content, buffers: sent.append((content, buffers))
    )
    data = {"method": "custom", "content": {"id": 7, **content}}
    explorer.view._handle_msg({"content": {"data": data}, "buffers": []})
    return sent


def test_the_sliders_start_with_the_values_of_the_loop(explorer: FollowingExplorer) -> None:
    with FollowingLoop(**SIZE, renderer_maker=RaycastRenderer) as loop:
        expected = {name: getattr(loop, name) for name in ("gain", "delay", "noise", "speed")}
    assert explorer.view.start == {**expected, "moment": module.LAST}
    for name, (widget, attribute) in explorer.controls.items():
        assert getattr(widget, attribute) == expected[name]


def test_a_recording_is_a_run_of_the_library(recorded: FollowingExplorer) -> None:
    hidden = [(one["time"]) for one in recorded.view.shown if one["is_hidden"]]
    span = (hidden[0], hidden[-1] + DT)
    loop = FollowingLoop(160, 120, hidden=[span], renderer_maker=RaycastRenderer)
    record = loop.run(follow, 6)
    told = recorded.view.moments
    np.testing.assert_allclose(told["time"], record.time, rtol=0, atol=1e-6)
    np.testing.assert_array_equal(told["is_hidden"], record.is_hidden)
    np.testing.assert_array_equal(told["is_measured"], record.is_measured)
    # rounded for the page
    np.testing.assert_allclose(told["error_px"], record.error_px, rtol=0, atol=6e-4)
    mm = np.array([np.nan if one is None else one for one in told["error_mm"]])
    np.testing.assert_allclose(mm, record.center_error_mm, rtol=0, atol=6e-3)
    score, values = record.get_score(), recorded.values
    assert values["mean_px"] == pytest.approx(score.mean_px, abs=1e-3)
    assert values["mean_mm"] == pytest.approx(score.center_mm, abs=1e-2)
    # the surface is one radius nearer than the center
    assert 20 < values["mean_mm"] < 60


def test_a_moment_in_between_tells_of_what_came_before(recorded: FollowingExplorer) -> None:
    recorded.move(moment=30)
    values = recorded.values
    recorded.move(moment=module.LAST)
    assert values["time"] == pytest.approx(1.5)
    until = [one["error_px"] for one in recorded.view.shown[20:31]]
    assert values["mean_px"] == pytest.approx(np.mean(until))


def test_a_recording_says_whether_it_was_made_with_other_settings(
    recorded: FollowingExplorer,
) -> None:
    told = []
    for gain in (1.0, 0.5, 1.0):
        recorded.move(gain=gain)
        told.append(recorded.values["is_current"])
    assert told == [True, False, True]


def test_a_recording_does_not_depend_on_how_fast_the_machine_is(
    recorded: FollowingExplorer,
) -> None:
    assert set(recorded.view.moments["render_ms"]) == {None}
    assert set(recorded.view.moments["control_ms"]) == {None}


def test_a_recording_is_small_and_its_pictures_can_be_read(recorded: FollowingExplorer) -> None:
    view = recorded.view
    assert len(view.pictures) < 180e3  # a page carries it as text, a third longer
    assert len(json.dumps(view.moments)) < 25e3
    assert [one[0] for one in view.places if one[1] == EYE] == list(range(0, 120, 2))
    assert [one[0] for one in view.places if one[1] == OUTSIDE] == list(range(0, 120, 4))
    for _, _, start, length in view.places[:3]:
        assert decode_picture(view.pictures[start : start + length]).shape == (120, 160, 3)
    assert sum(one[3] for one in view.places) == len(view.pictures)


def test_no_run_is_recorded_where_python_answers_by_itself(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "platform", "emscripten")
    explorer = explore_following(stand, **SIZE)
    assert explorer.view.places == []
    assert explorer.values == {**dict.fromkeys(NAMES), "is_current": True}
    assert repr(explorer) == "Following: not begun"
    assert explorer.view.draw_poster().shape == (30, 80, 3)


def test_the_page_gets_pictures_and_numbers_step_by_step(
    explorer: FollowingExplorer, monkeypatch: pytest.MonkeyPatch
) -> None:
    ((told, pictures),) = ask(explorer, monkeypatch, kind="hello")
    assert (told, len(pictures)) == ({"kind": "ready", "id": 7}, 2)
    counts = []
    for step in range(4):
        ((told, pictures),) = ask(explorer, monkeypatch, kind="step")
        assert (told["kind"], told["id"]) == ("stepped", 7)
        assert told["moment"]["time"] == pytest.approx(DT * step)
        json.dumps(told, allow_nan=False)
        counts.append(len(pictures))
    assert counts == [2, 1, 1, 2]  # the one from outside comes with every third
    off = np.abs(decode_picture(pictures[0]).astype(int) - explorer._run.draw_eye())
    assert off.mean() < 10  # what JPEG loses of noise
    assert explorer.values["time"] == pytest.approx(3 * DT)
    assert len(explorer.record.time) == 4


def test_start_again_forgets_what_was(
    explorer: FollowingExplorer, monkeypatch: pytest.MonkeyPatch
) -> None:
    explorer.step(3)
    explorer._run.hide()
    ((told, pictures),) = ask(explorer, monkeypatch, kind="restart")
    assert (told["kind"], len(pictures)) == ("ready", 2)
    assert explorer.values == {**dict.fromkeys(NAMES), "is_current": True}
    explorer.step()
    assert explorer.values["time"] == 0
    assert not explorer.values["is_hidden"]


def test_what_the_page_says_otherwise_gets_no_answer(
    explorer: FollowingExplorer, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert ask(explorer, monkeypatch, kind="anywidget-command") == []


def test_the_board_hides_the_ball_for_as_long_as_it_says(
    explorer: FollowingExplorer, monkeypatch: pytest.MonkeyPatch
) -> None:
    explorer.step(2)
    ask(explorer, monkeypatch, kind="step", hide=True)
    explorer.step(20)
    hidden = [one["is_hidden"] for one in explorer.view.shown]
    assert sum(hidden) == round(0.8 / DT)
    assert hidden.index(True) == 3  # the picture of the third command had been taken by then


def test_a_setting_acts_with_the_next_command(explorer: FollowingExplorer) -> None:
    gains = []

    def control(_rgb: Any, _depth: Any, _K: Any, state: FollowingState) -> tuple[float, float]:
        gains.append(state.gain)
        return state.pan, state.tilt

    explorer.control = control
    explorer.step(2)
    explorer.move(gain=0.25, delay=4)
    explorer.step(6)
    assert gains == [1.0] * 2 + [0.25] * 6
    # the oldest picture waits until it is late enough
    assert [one["delay_ms"] for one in explorer.view.shown] == [0, 50, 100, 150, 200, 200, 200, 200]


def fail(*_: Any) -> tuple[float, float]:
    """Do what cannot be done."""
    raise RuntimeError("no red to be seen")


def test_an_exception_is_told_in_words_and_loses_nothing(
    explorer: FollowingExplorer, monkeypatch: pytest.MonkeyPatch
) -> None:
    explorer.step(2)
    explorer.control = fail
    ((told, pictures),) = ask(explorer, monkeypatch, kind="step")
    problem = told["problem"]
    assert (problem["kind"], problem["message"]) == ("RuntimeError", "no red to be seen")
    assert problem["code"] == 'raise RuntimeError("no red to be seen")'
    assert problem["line"] == fail.__code__.co_firstlineno + 2
    assert problem["time"] == pytest.approx(2 * DT)
    assert pictures == []
    assert len(explorer.record.time) == 2
    explorer.control = stand
    ((told, _),) = ask(explorer, monkeypatch, kind="step")
    assert told["moment"]["time"] == pytest.approx(2 * DT)


def test_an_answer_that_is_no_command_is_told_without_a_line(
    explorer: FollowingExplorer, monkeypatch: pytest.MonkeyPatch
) -> None:
    explorer.control = lambda *_: (1.0, float("nan"))
    ((told, _),) = ask(explorer, monkeypatch, kind="step")
    assert told["problem"]["line"] is None
    assert told["problem"]["message"].startswith("control: expected (pan, tilt), two finite")


@pytest.mark.parametrize(
    ("center", "kind", "got"),
    [([1, 2], "ValueError", "got [1, 2]"), ("here", "TypeError", "got str 'here'")],
)
def test_a_center_that_is_none_is_refused(
    center: object,
    kind: str,
    got: str,
    explorer: FollowingExplorer,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def control(*arguments: Any) -> tuple[float, float]:
        arguments[-1].memory["center"] = center
        return 0.0, 0.5

    explorer.control = control
    ((told, _),) = ask(explorer, monkeypatch, kind="step")
    assert told["problem"]["kind"] == kind
    wanted = 'memory["center"]: expected (x, y, z) in meters of the world, or None'
    assert told["problem"]["message"] == f"{wanted}, {got}"


def test_a_recording_ends_where_its_controller_fails() -> None:
    explorer = explore_following(fail, recorded_s=1, **SIZE)
    assert explorer.view.problem["message"] == "no red to be seen"
    assert explorer.view.moments == {}
    assert explorer.values["time"] is None


def test_what_cannot_be_called_is_no_controller() -> None:
    with pytest.raises(TypeError, match=r"control: expected a function of \(rgb.*got tuple"):
        explore_following((0.0, 0.5), recorded_s=0, **SIZE)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="width: expected at least 1 pixel, got 0"):
        explore_following(stand, width=0)


def test_a_loop_shows_no_picture_before_it_has_taken_one() -> None:
    with FollowingLoop(**SIZE, renderer_maker=RaycastRenderer) as loop:
        with pytest.raises(RuntimeError, match="picture: expected a step before, got none"):
            _ = loop.picture
        loop.step(stand)
        assert loop.picture.shape == (30, 40, 3)


def test_the_neck_is_as_slow_as_the_budget_says() -> None:
    model, data = lab.make_scene()
    data.ctrl[:2] = data.qpos[:2]
    mujoco.mj_step(model, data, nstep=500)
    start, goal = float(data.qpos[0]), float(data.qpos[0]) + 0.2
    data.ctrl[0] = goal
    began = data.time
    while data.qpos[0] < goal - 0.2 * np.exp(-1):
        mujoco.mj_step(model, data)
    assert start < goal
    assert 1000 * (data.time - began) == pytest.approx(module.NECK_MS, abs=15)


def test_the_poster_shows_both_pictures_and_the_curve(recorded: FollowingExplorer) -> None:
    poster = recorded.view.draw_poster()
    height, width, _ = poster.shape
    assert width >= 600
    assert height > width * 3 // 8  # below the pair there is more
    assert repr(recorded).startswith("Following: after 5.95 s the ball is ")


def test_a_view_is_made_again_from_its_traits(recorded: FollowingExplorer) -> None:
    view = recorded.view
    state = {
        name: getattr(view, name)
        for name in view.trait_names(sync=True)
        if not name.startswith("_") and name not in ("layout", "tabbable", "tooltip", "comm")
    }
    assert make_view(FollowingView, {"state": state}).compute() == view.compute()


def test_both_languages_read_a_run_alike(recorded: FollowingExplorer) -> None:
    view = recorded.view
    given = {"moments": view.moments, "places": [[4, 0, 2, 3], [4, 1, 5, 2]]}
    reading = """(() => {
      const pictures = new DataView(Uint8Array.from([9, 0, 1, 2, 3, 4, 5, 6]).buffer, 1);
      const frames = m.readRecording({ ...given, pictures });
      const read = (one) => [...new Uint8Array(one.buffer, one.byteOffset, one.byteLength)];
      return {
        moments: frames.map(({ moment }) => moment),
        eye: read(frames[4].eye), outside: read(frames[4].outside), none: frames[3].eye,
        values: [-1, 0, 30, 119].map((place) => m.describeRun(frames, place)),
        hidden: m.findHidden(frames, 0.05),
      };
    })()"""
    told = evaluate("_following_tape", reading, given=given)
    assert told["moments"] == to_moments(view.moments)
    assert (told["eye"], told["outside"], told["none"]) == ([2, 3, 4], [5, 6], None)
    assert told["values"][0] == dict.fromkeys(NAMES)
    for place, values in zip((0, 30, 119), told["values"][1:], strict=True):
        view.moment = place
        assert {**values, "is_current": True} == pytest.approx(view.compute())
    view.moment = module.LAST
    hidden = [one["time"] for one in view.shown if one["is_hidden"]]
    assert told["hidden"] == [pytest.approx([hidden[0], hidden[-1] + DT])]
