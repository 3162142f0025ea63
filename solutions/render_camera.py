"""Step 1: render color and depth from a named camera."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import mujoco
import numpy as np

import labutils
from solutions._cases import make_render_scene
from solutions._model import Absorbed, Case, Exercise, Misconception, Part, asked, given, told
from solutions.completions.render_camera import COMPLETION


def _answer_with(
    mistakes: frozenset[str], model: Any, data: Any, renderer: Any, camera_name: str
) -> Any:
    if "switch-with-argument" in mistakes:
        renderer.update_scene(data, camera=camera_name)
        renderer.render()
        renderer.enable_depth_rendering(True)  # noqa: FBT003 - the mistake itself
    if "one-camera" in mistakes:
        camera_name = "head_camera"
    if "stale-pose" not in mistakes:
        mujoco.mj_forward(model, data)
    renderer.update_scene(data, camera=camera_name)
    rgb = renderer.render()
    renderer.enable_depth_rendering()
    depth = renderer.render()
    if "depth-mode-left-on" not in mistakes:
        renderer.disable_depth_rendering()
    if "converted-again" in mistakes:
        depth = 0.01 + np.clip(depth, 0, 1) * np.float32(10.0 - 0.01)
    if "bgr" in mistakes:
        rgb = rgb[..., ::-1]
    if "upside-down" in mistakes:
        rgb, depth = rgb[::-1], depth[::-1]
    return rgb, depth


def _make_cases(rng: np.random.Generator) -> tuple[Case, ...]:
    def scene(width: int, height: int) -> Any:
        return make_render_scene(rng, width, height)

    following = scene(18, 12)
    # Who keeps pictures gives the first one again: only the joints differ.
    later = replace(following, qpos=(-following.qpos[0], following.qpos[1]))
    return (
        Case("a camera on the head, after its joint was moved", (scene(36, 26), "head_camera")),
        Case("a camera at the side", (scene(30, 38), "side_camera")),
        Case("a camera given by its sensor", (scene(32, 20), "sensor_camera")),
        Case("a camera that follows a center of mass", (following, "chase_camera")),
        Case("the same camera again, after the ball has moved on", (later, "chase_camera")),
        Case("a camera that the model does not have", (scene(8, 6), "tail_camera"), "ValueError"),
    )


EXERCISE = Exercise(
    name="render_camera",
    title="render color and depth from a named camera",
    chapter="step1",
    points=15,
    section="step1-render",
    objectives=("1a", "1c"),
    reference=labutils.render_camera,
    answer_with=_answer_with,
    parts=(
        # Two levels of 255: shading is computed in floating point and rounded once.
        Part("rgb", "rgb", "uint8", atol=2, share=0.002),
        Part("depth", "depth", "float", atol=1e-4, share=0.002, unit="m", low=0.0),
        Part(
            "renderer in color mode",
            "flag",
            "bool",
            note="After your call the renderer still draws depth: whoever uses it next expects "
            "color.",
        ),
    ),
    tolerance_reason=(
        "0.1 mm is a hundred times the rounding of float32 at 10 m and far below any known "
        "mistake; 0.2 % of the pixels may sit exactly on an outline"
    ),
    misconceptions=(
        Misconception(
            "stale-pose",
            "the picture shows where things were, not where qpos puts them now. A renderer reads "
            "positions that mj_forward computes: call it first.",
            section="step1-stale",
        ),
        Misconception(
            "one-camera",
            "every picture comes from head_camera, whatever camera_name says. Pass camera_name on "
            "to update_scene.",
            section="step1-cameras",
        ),
        Misconception(
            "converted-again",
            "the renderer's depth is in meters already. Clipping it to 0-1 and stretching it to "
            "near-far cuts off everything beyond 1 m.",
        ),
        Misconception(
            "depth-mode-left-on",
            "both pictures are right, but the renderer stays in depth mode. End with "
            "disable_depth_rendering().",
        ),
        Misconception(
            "switch-with-argument",
            "enable_depth_rendering takes no argument. It switches on; its partner "
            "disable_depth_rendering() switches off.",
        ),
        Misconception(
            "bgr",
            "red and blue are exchanged. MuJoCo renders RGB, and RGB it stays; only cv2.imwrite "
            "and cv2.imshow want BGR.",
        ),
        Misconception(
            "upside-down",
            "the picture stands on its head. OpenGL's own buffers start at the bottom row, but "
            "renderer.render() has turned the rows already.",
        ),
    ),
    hints=(
        (
            "Four calls of the renderer are enough: show it the scene, render, switch to depth, "
            "render again. What does it need to know about the scene before?"
        ),
        (
            "data.qpos is only numbers until MuJoCo computes positions from it. Which function "
            "does that without a step in time?"
        ),
        (
            "Whoever gets the renderer after you expects color: leave it as you found it, also for "
            "your own next call."
        ),
    ),
    example="""\
outside, distance = render_camera(model, data, renderer, "overview")
show(outside, "the robot from outside")
show(distance, "how far away all of it is")""",
    contract=(
        told("question", "what do you see now"),
        asked("any-camera", "for any camera of the model", "every case", "mistake one-camera"),
        told("traps", "Three traps wait"),
        asked(
            "joints-moved",
            "The joints may have moved",
            "mistake stale-pose",
            "case a camera on the head",
            "case a camera that follows",
            "case the same camera again",
        ),
        asked(
            "renderer-shared",
            "whoever uses it next expects color",
            "value of renderer in color mode",
        ),
        asked(
            "no-such-camera",
            "a camera that does not exist is an error",
            "case a camera that the model does not have",
        ),
        asked(
            "both-pictures",
            "Render color and depth from a camera",
            "value of rgb",
            "mistake bgr",
            "mistake upside-down",
        ),
        asked("current-state", "The picture shows the *current*", "mistake stale-pose", "input"),
        asked("metric", "Depth is metric", "mistake converted-again", "value of depth"),
        asked("far-plane", "Pixels that see nothing read the far plane", "value of depth"),
        given("state", "The scene and its state"),
        asked("picture-size", "its size is the picture size", "shape of rgb", "shape of depth"),
        given("camera-name", "Name of a camera of the model"),
        asked(
            "color-picture", "The color picture.", "value of rgb", "mistake switch-with-argument"
        ),
        asked("color-mode", "The renderer is left in color mode", "mistake depth-mode-left-on"),
        asked("depth-unit", "Meters.", "value of depth", "range of depth"),
        asked("raises", "Raises: ValueError", "case a camera that the model does not have"),
        asked(
            "raises-when",
            "If the model has no such camera",
            "case a camera that the model does not have",
        ),
    ),
    visible=lambda: _make_cases(np.random.default_rng(11)),
    hidden=_make_cases,
    imports=("import mujoco",),
    asks={
        "renderer": "mujoco.Renderer\nFrom `make_renderer`; its size is the picture size.",
        "camera_name": "str\nName of a camera of the model.",
        "Convention": (
            "The picture shows the *current* ``data.qpos``: what follows from it is brought up to "
            "date first, which changes no state. Depth is metric: meters along the optical axis, "
            "not along the ray. Pixels that see nothing read the far plane."
        ),
        "Returns": (
            "rgb : ndarray, uint8, shape (H, W, 3)\n"
            "    The color picture. The renderer is left in color mode.\n"
            "depth : ndarray, float, shape (H, W)\n"
            "    Meters."
        ),
    },
    absorbed=tuple(
        Absorbed("switch-with-argument", other, "the program stops before the other mistake shows")
        for other in (
            "stale-pose",
            "one-camera",
            "converted-again",
            "depth-mode-left-on",
            "bgr",
            "upside-down",
        )
    ),
    completion=COMPLETION,
)
