"""The scene explorer: what Python draws, when it draws, and what it leaves alone."""

from __future__ import annotations

import json
from typing import Any

import mujoco
import numpy as np
import pytest

from labutils import make_renderer, make_scene, raycast_depth, render_segmentation
from labutils.explorers import SceneExplorer, explore_scene
from labutils.explorers._base import DEPTH_STEP
from labutils.explorers._scene_copy import BALL_X, BALL_Y
from labutils.explorers.scene import SceneView
from labutils.renderers.rays import RaycastRenderer
from tests.helpers.node import evaluate
from tools.explorer_views import make_view

SIZE = {"width": 40, "height": 30}
POSE = {"pan_deg": 12.0, "tilt_deg": 25.0, "ball_x": 0.8, "ball_y": 0.1}


@pytest.fixture
def scene() -> tuple[mujoco.MjModel, mujoco.MjData]:
    return make_scene()


@pytest.fixture
def explorer(scene: tuple[mujoco.MjModel, mujoco.MjData]) -> SceneExplorer:
    return explore_scene(*scene, **SIZE)


def ask(explorer: SceneExplorer, monkeypatch: pytest.MonkeyPatch, **content: Any) -> list[Any]:
    """Let the page say something; return what Python answers."""
    sent: list[Any] = []
    monkeypatch.setattr(
        explorer.view, "send", lambda content, buffers: sent.append((content, buffers))
    )
    data = {"method": "custom", "content": content}
    explorer.view._handle_msg({"content": {"data": data}, "buffers": []})
    return sent


def test_it_starts_with_the_pose_of_the_data_in_the_steps_of_its_sliders(
    explorer: SceneExplorer,
) -> None:
    # 0.52 rad are 29.79 degrees
    start = {"pan_deg": 0.0, "tilt_deg": 29.8, "ball_x": 1.14, "ball_y": 0.38, "pixel": []}
    assert explorer.view.start == start
    assert explorer.values["is_current"] is True
    for name, (widget, attribute) in explorer.controls.items():
        assert getattr(widget, attribute) == start[name]


def test_what_is_drawn_is_what_the_library_draws_in_that_pose(
    scene: tuple[mujoco.MjModel, mujoco.MjData], explorer: SceneExplorer
) -> None:
    explorer.move(**POSE)
    model, data = scene
    data.joint("neck_pan").qpos = np.radians(POSE["pan_deg"])
    data.joint("neck_tilt").qpos = np.radians(POSE["tilt_deg"])
    data.mocap_pos[0, :2] = POSE["ball_x"], POSE["ball_y"]
    mujoco.mj_forward(model, data)
    renderer = RaycastRenderer(model, SIZE["height"], SIZE["width"])
    renderer.update_scene(data, "head_camera")
    np.testing.assert_array_equal(explorer.rgb, renderer.render())
    truth = raycast_depth(model, data, "head_camera", SIZE["width"], SIZE["height"])
    sees = np.isfinite(truth) & (truth < 10)
    # both are the same rays, one rounded to float32
    np.testing.assert_allclose(explorer.depth[sees], truth[sees], rtol=1e-6)


def test_the_data_it_was_given_stay_as_they_were(
    scene: tuple[mujoco.MjModel, mujoco.MjData], explorer: SceneExplorer
) -> None:
    _, data = scene
    before = data.qpos.copy(), data.mocap_pos.copy(), data.cam_xpos.copy()
    explorer.move(**POSE)
    np.testing.assert_allclose(np.degrees(explorer.data.qpos), [12, 25])
    np.testing.assert_allclose(explorer.data.body("red_ball").xpos[:2], [0.8, 0.1])
    for array, was in zip((data.qpos, data.mocap_pos, data.cam_xpos), before, strict=True):
        np.testing.assert_array_equal(array, was)


def test_a_picked_pixel_reads_the_exact_depth(explorer: SceneExplorer) -> None:
    explorer.move(pixel=[20, 25], **POSE)
    # half a step
    assert explorer.values["pixel_depth"] == pytest.approx(
        float(explorer.depth[25, 20]), abs=DEPTH_STEP / 2 + 1e-6
    )
    assert explorer.pixel == (20, 25)


def find_ball_pixels(explorer: SceneExplorer, model: mujoco.MjModel) -> np.ndarray:
    """List (u, v) of the pixels that see the ball, as the library's own segmentation does."""
    height, width = explorer.depth.shape
    with make_renderer(model, height, width) as renderer:
        bodies = render_segmentation(model, explorer.data, renderer, "head_camera")
    return np.argwhere(bodies == model.body("red_ball").id)[:, ::-1]


@pytest.mark.parametrize("pose", [{}, POSE, {"pan_deg": 21.0, "tilt_deg": 30.0}])
def test_the_middle_of_the_ball_is_where_its_pixels_are(
    scene: tuple[mujoco.MjModel, mujoco.MjData], pose: dict[str, float]
) -> None:
    explorer = explore_scene(*scene, width=160, height=120)
    explorer.move(**pose)
    off = explorer.values["ball_off_px"]
    pixels = find_ball_pixels(explorer, scene[0])
    assert explorer.view.shown_ball == pytest.approx(pixels.mean(axis=0), abs=1.0)
    assert off == pytest.approx(np.linalg.norm(pixels.mean(axis=0) - [79.5, 59.5]), abs=1.5)


@pytest.mark.parametrize(
    "pose", [{"ball_x": 1.2, "ball_y": 0.1}, {"pan_deg": -40.0}, {"pan_deg": 80.0, "ball_y": -0.6}]
)
def test_a_ball_that_is_hidden_or_outside_the_picture_has_no_place_in_it(
    scene: tuple[mujoco.MjModel, mujoco.MjData], pose: dict[str, float]
) -> None:
    explorer = explore_scene(*scene, width=160, height=120)
    explorer.move(**pose)
    assert explorer.values["ball_off_px"] is None
    # some of its edge may look out from behind what hides it
    assert len(find_ball_pixels(explorer, scene[0])) < 20


def test_a_pixel_in_the_window_sees_no_surface(explorer: SceneExplorer) -> None:
    explorer.move(pan_deg=-9.0, tilt_deg=0.0)
    v, u = np.argwhere(explorer.depth > 10)[0].tolist()
    explorer.move(pixel=[u, v])
    assert explorer.values["pixel_depth"] is None
    assert repr(explorer).endswith(f"pixel ({u}, {v}): no surface")


def test_a_question_of_the_page_gets_one_answer_with_the_picture_of_its_pose(
    explorer: SceneExplorer, monkeypatch: pytest.MonkeyPatch
) -> None:
    ((told, (color, depth)),) = ask(explorer, monkeypatch, kind="draw", id=5, pose=POSE)
    ball = told.pop("ball_px")
    assert told == {"kind": "drawn", "id": 5, "pose": POSE, **SIZE}
    json.dumps(ball)
    explorer.move(**POSE)
    assert explorer.values["ball_off_px"] == pytest.approx(np.hypot(ball[0] - 19.5, ball[1] - 14.5))
    assert color == explorer.rgb.tobytes()
    steps = np.frombuffer(depth, "<u2").reshape(SIZE["height"], SIZE["width"])
    sees = explorer.depth < 10
    np.testing.assert_allclose(
        steps[sees] * DEPTH_STEP, explorer.depth[sees], rtol=0, atol=DEPTH_STEP / 2 + 1e-6
    )


def test_what_the_page_says_otherwise_gets_no_answer(
    explorer: SceneExplorer, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert ask(explorer, monkeypatch, kind="anywidget-command", id=5) == []


def test_a_pose_beyond_neck_and_table_is_drawn_at_their_ends(
    explorer: SceneExplorer, monkeypatch: pytest.MonkeyPatch
) -> None:
    far = {"pan_deg": 500, "tilt_deg": -500, "ball_x": 9, "ball_y": -9}
    ((told, _),) = ask(explorer, monkeypatch, kind="draw", id=1, pose=far)
    limits = np.degrees([1.4, -0.7])
    expected = [*limits, BALL_X[1], BALL_Y[0]]
    assert [told["pose"][name] for name in far] == pytest.approx(expected, abs=1e-6)


def test_the_sliders_end_where_neck_and_table_do(explorer: SceneExplorer) -> None:
    ends = {n: (one.widget.min, one.widget.max) for n, one in explorer.controls.items()}
    assert ends["pan_deg"] == (-80, 80)  # 1.4 rad are 80.2 degrees
    assert ends["tilt_deg"] == (-40, 57)
    assert (ends["ball_x"], ends["ball_y"]) == (BALL_X, BALL_Y)


def test_the_ball_stays_on_the_table_at_all_ends() -> None:
    model, data = make_scene()
    top, ball = model.geom("table_top"), model.geom("red_ball")
    half_y, half_x, _ = top.size  # turned by a right angle
    center = data.geom("table_top").xpos
    for limits, middle, half in ((BALL_X, center[0], half_x), (BALL_Y, center[1], half_y)):
        assert limits[0] - ball.size[0] >= middle - half
        assert limits[1] + ball.size[0] <= middle + half


def test_where_no_python_runs_the_first_picture_stands_and_is_called_old(
    explorer: SceneExplorer,
) -> None:
    view = explorer.view
    state = {
        name: getattr(view, name)
        for name in view.trait_names(sync=True)
        if not name.startswith("_") and name not in ("layout", "tabbable", "tooltip", "comm")
    }
    alone = make_view(SceneView, {"state": state})
    assert alone.compute() == view.compute()
    alone.pan_deg = 20.0
    values = alone.compute()
    assert (values["pan_deg"], values["is_current"]) == (0.0, False)


def test_the_sentence_and_the_poster_show_the_pose_of_now(explorer: SceneExplorer) -> None:
    explorer.move(pixel=[20, 25], **POSE)
    assert repr(explorer).startswith(
        "Scene: neck turned 12.0° and tilted 25.0°, ball at x 0.80 m, y 0.10 m; pixel (20, 25): "
        "depth "
    )
    poster = explorer.view.draw_poster()
    assert poster.shape == (240, 640, 3)  # two pictures of 4 by 3
    np.testing.assert_array_equal(poster[4::8, 4:320:8], explorer.rgb)


NECK = "".join(
    f"<body><joint name='{name}' range='-1 1'/><geom size='1'/></body>"
    for name in ("neck_pan", "neck_tilt")
)


@pytest.mark.parametrize(
    ("bodies", "message"),
    [
        ("", "model: expected a joint 'neck_pan' to move, got a model without it"),
        (NECK, "model: expected a body 'red_ball' to move, got a model without it"),
        (f"{NECK}<body name='red_ball'/>", "model: expected red_ball to be a mocap body"),
    ],
)
def test_a_model_without_what_moves_is_refused(bodies: str, message: str) -> None:
    xml = f"<mujoco><worldbody>{bodies}</worldbody></mujoco>"
    model = mujoco.MjModel.from_xml_string(xml)
    with pytest.raises(ValueError, match=message):
        explore_scene(model, mujoco.MjData(model))


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        ({"width": 0}, ValueError, "width: expected at least 1 pixel, got 0"),
        ({"height": 1.5}, TypeError, "height: expected a whole number of pixels"),
        ({"camera_name": "no_camera"}, ValueError, "no_camera"),
    ],
)
def test_wrong_arguments_are_named(
    arguments: dict[str, Any],
    error: type[Exception],
    message: str,
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    with pytest.raises(error, match=message):
        explore_scene(*scene, **{**SIZE, **arguments})


def test_a_state_of_another_model_is_refused(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    other = mujoco.MjData(mujoco.MjModel.from_xml_string("<mujoco/>"))
    with pytest.raises(ValueError, match="data: expected a state of this model"):
        explore_scene(scene[0], other)


def test_both_languages_agree_on_which_poses_are_the_same(explorer: SceneExplorer) -> None:
    view = explorer.view
    for change in (0.0, 1e-9, 5e-7, 2e-6, 0.1):
        view.pan_deg = view.start["pan_deg"] + change
        pair = [view.shown[2]._asdict(), view.pose._asdict()]
        same = evaluate("_scene_source", "m.isSamePose(...pair)", pair=pair)
        assert view.compute()["is_current"] is same


def test_the_page_reads_the_picture_as_it_was_drawn(explorer: SceneExplorer) -> None:
    rgb, steps, _ = explorer.view.shown
    buffers = [rgb.tobytes(), steps.astype("<u2").tobytes()]
    answer = {"kind": "drawn", "id": 1, "pose": POSE, "ball_px": [3.5, 4], **SIZE}
    # at an odd place of a larger buffer, as they may come
    reading = (
        "(() => { const views = buffers.map((bytes) => new DataView("
        "Uint8Array.from([0, ...bytes]).buffer, 1));"
        "const { rgb, steps } = m.readFrame(answer, views); return [[...rgb], [...steps]]; })()"
    )
    color, depth = evaluate(
        "_scene_source", reading, answer=answer, buffers=[list(one) for one in buffers]
    )
    np.testing.assert_array_equal(color, rgb.ravel())
    np.testing.assert_array_equal(depth, steps.ravel())


def test_the_goal_is_the_ball_in_the_middle_of_the_picture(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    explorer = explore_scene(*scene)
    reached = []
    for pan_deg in (0.0, 19.0, -40.0):
        explorer.move(pan_deg=pan_deg)
        reached.append(explorer.goal_is_reached)
    assert reached == [False, True, False]
    assert explorer.values["ball_off_px"] is None  # at last it is outside the picture
