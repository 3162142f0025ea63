"""Explore the scene: turn the head, move the ball, and see color and depth as they change.

What is seen is computed by Python, picture for picture, as the reader moves. Where no Python runs
the first picture stands. Taught in: step 1.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar

import cv2
import numpy as np
import traitlets

from labutils._guards import check_image_size
from labutils.explorers._base import (
    DEPTH_STEP,
    PixelExplorer,
    PixelView,
    decode_rgb,
    depth_to_steps,
    encode_depth,
    encode_rgb,
    make_slider,
)
from labutils.explorers._depth_picture import (
    VALID_STEPS,
    decode_steps,
    is_surface,
    make_color_tables,
    paint_depth,
)
from labutils.explorers._goal import Goal, GoalPart
from labutils.explorers._modules import join_modules, join_styles
from labutils.explorers._scene_copy import BALL_X, BALL_Y, SceneCopy, ScenePose

if TYPE_CHECKING:
    import mujoco

    from labutils.cameras import Camera

#: Depths in meters that the colors spread over.
_COLORED_M = (0.5, 3.0)
#: Two poses are the same where a slider could not tell them apart.
_SAME = 1e-6
_POSTER_WIDTH = 640
#: The goal: the ball is in the middle when it is at most this far from it.
_NEAR_MIDDLE_PX = 5.0


class SceneView(PixelView):
    """Color and depth of a camera, drawn by Python or as they were at first."""

    _esm = join_modules("scene")
    _css = join_styles("scene")
    rgb_png = traitlets.Bytes().tag(sync=True)
    depth_png = traitlets.Bytes().tag(sync=True)
    depth_step = traitlets.Float(DEPTH_STEP).tag(sync=True)
    #: A surface lies between these, in steps.
    valid_steps = traitlets.List(list(VALID_STEPS)).tag(sync=True)
    colored_m = traitlets.List(list(_COLORED_M)).tag(sync=True)
    #: 256 colors of depths, RGB.
    color_table = traitlets.Bytes(make_color_tables()[:768]).tag(sync=True)
    #: Field of view from top to bottom, by which a pointer drags as far as the picture moves.
    fov_y_deg = traitlets.Float(45.0).tag(sync=True)
    #: Low and high of both angles.
    limits_deg: traitlets.List[list[float]] = traitlets.List().tag(sync=True)
    pan_deg = traitlets.Float().tag(sync=True)
    tilt_deg = traitlets.Float().tag(sync=True)
    ball_x = traitlets.Float().tag(sync=True)
    ball_y = traitlets.Float().tag(sync=True)
    #: Column and row of the ball's middle in the first picture; [] where it cannot be seen.
    ball_px: traitlets.List[float] = traitlets.List().tag(sync=True)

    PICTURE: ClassVar = "rgb_png"
    PARAMETERS: ClassVar = ("pan_deg", "tilt_deg", "ball_x", "ball_y", "pixel")

    def __init__(self, **traits: Any) -> None:
        super().__init__(**traits)
        #: What is shown: color, depth in steps, and the pose that both belong to.
        self.shown = decode_rgb(self.rgb_png), decode_steps(self.depth_png), self.pose
        #: Where the ball is in it.
        self.shown_ball: tuple[float, ...] | None = tuple(self.ball_px) or None

    @property
    def pose(self) -> ScenePose:
        """The pose that the reader has set."""
        return ScenePose(self.pan_deg, self.tilt_deg, self.ball_x, self.ball_y)

    def show(
        self,
        rgb: np.ndarray,
        depth_metric: np.ndarray,
        pose: ScenePose,
        ball: tuple[float, float] | None,
    ) -> None:
        """Take over another picture: what the values are read from."""
        self.shown = rgb, depth_to_steps(depth_metric).astype(np.int64), pose
        self.shown_ball = ball

    def compute(self) -> dict[str, Any]:
        """Compute which pose is shown, whether it is the one set, and the depth of the pixel.

        `ball_off_px` is how far the ball's middle is from the middle of the picture, in pixels;
        None where the ball cannot be seen.
        """
        _, steps, pose = self.shown
        height, width = steps.shape
        off = None
        if self.shown_ball:
            u, v = self.shown_ball
            off = float(np.hypot(u - (width - 1) / 2, v - (height - 1) / 2))
        depth = None
        if self.pixel:
            u, v = self.pixel
            depth = float(steps[v, u] * DEPTH_STEP) if is_surface(steps)[v, u] else None
        far = np.abs(np.subtract(pose, self.pose)) > _SAME
        is_current = not far.any()
        return {
            **pose._asdict(),
            "is_current": is_current,
            "pixel_depth": depth,
            "ball_off_px": off,
        }

    def describe(self) -> str:
        """Say the pose that is shown, and the depth of the pixel."""
        values = self.compute()
        told = (
            f"Scene: neck turned {values['pan_deg']:.1f}° and tilted {values['tilt_deg']:.1f}°, "
            f"ball at x {values['ball_x']:.2f} m, y {values['ball_y']:.2f} m"
        )
        if not self.pixel:
            return told
        depth = values["pixel_depth"]
        seen = "no surface" if depth is None else f"depth {depth:.3f} m"
        return f"{told}; pixel {tuple(self.pixel)}: {seen}"

    def draw_poster(self) -> np.ndarray:
        """Draw color and depth side by side, each pixel as a square."""
        rgb, steps, _ = self.shown
        pair = np.hstack([rgb, paint_depth(steps, *_COLORED_M, 0)])
        size = (_POSTER_WIDTH, round(_POSTER_WIDTH * pair.shape[0] / pair.shape[1]))
        return cv2.resize(pair, size, interpolation=cv2.INTER_NEAREST)


class SceneExplorer(PixelExplorer):
    """What `explore_scene` returns: the pose that was set, and what the camera sees in it."""

    view: SceneView

    def __init__(self, view: SceneView, scene: SceneCopy) -> None:
        self._scene = scene
        pan, tilt = view.limits_deg
        controls = {
            "pan_deg": make_slider("neck pan", (pan[0], pan[1]), 0.1, unit="°", digits=1),
            "tilt_deg": make_slider("neck tilt", (tilt[0], tilt[1]), 0.1, unit="°", digits=1),
            "ball_x": make_slider("ball x", BALL_X, 0.01, unit="m", digits=2),
            "ball_y": make_slider("ball y", BALL_Y, 0.01, unit="m", digits=2),
        }
        super().__init__(view, controls)
        view.on_msg(self._answer)

    @property
    def data(self) -> mujoco.MjData:
        """The state that is shown, brought up to date; the one given was left as it is."""
        self._scene.move(self.view.pose)
        return self._scene.data

    @property
    def rgb(self) -> np.ndarray:
        """What the camera sees, uint8 (H, W, 3)."""
        return self._draw(self.view.pose)[0]

    @property
    def depth(self) -> np.ndarray:
        """How far away it is in meters, float32 (H, W)."""
        return self._draw(self.view.pose)[1]

    @property
    def values(self) -> dict[str, Any]:
        """What the read-out tells, of the pose as it is now."""
        self._draw(self.view.pose)
        return super().values

    def __repr__(self) -> str:
        self._draw(self.view.pose)
        return super().__repr__()

    def _draw(self, pose: ScenePose) -> tuple[np.ndarray, np.ndarray]:
        self._scene.move(pose)
        rgb, depth = self._scene.draw()
        self.view.show(rgb, depth, self._scene.pose, self._scene.find_ball(depth))
        return rgb, depth

    def _answer(self, _view: SceneView, content: dict[str, Any], _buffers: list[bytes]) -> None:
        """Draw what the page asks for. It asks anew only when it has got an answer."""
        if content.get("kind") != "draw":
            return
        self._draw(ScenePose(*(float(content["pose"][name]) for name in ScenePose._fields)))
        rgb, steps, pose = self.view.shown
        height, width = steps.shape
        ball = list(self.view.shown_ball or ())
        told = {"kind": "drawn", "id": content["id"], "pose": pose._asdict(), "ball_px": ball}
        buffers = [np.ascontiguousarray(rgb).tobytes(), steps.astype("<u2").tobytes()]
        self.view.send({**told, "width": width, "height": height}, buffers)


def explore_scene(
    model: mujoco.MjModel,
    data: mujoco.MjData,
    camera_name: Camera = "head_camera",
    *,
    width: int = 160,
    height: int = 120,
) -> SceneExplorer:
    """Turn the head of the robot, move the ball, and see color and depth as they change.

    Every picture is computed by Python, by one ray per pixel: depth is exact, colors are plain.
    On a page without Python the first picture stands.

    Parameters
    ----------
    model, data : mujoco.MjModel, mujoco.MjData
        The scene of the book; both are left as they are. The explorer has a state of its own.
    camera_name : str, int or mujoco.MjvCamera
        Where to look from.
    width, height : int
        Picture size in pixels. The time of a picture grows with their product.

    Returns
    -------
    SceneExplorer
        Shows itself as the last line of a cell; has `data`, `rgb`, `depth` and `pixel`.

    Raises
    ------
    TypeError, ValueError
        If model and data do not belong together, the model has no neck or no ball to move, no such
        camera, or the size is no positive whole numbers.
    """
    width, height = check_image_size(width, height)
    scene = SceneCopy(model, data, camera_name, width, height)
    scene.move(ScenePose(*(round(value, digits) for value, digits in _round_to(scene.pose))))
    rgb, depth = scene.draw()
    inside = [[float(np.ceil(low)), float(np.floor(high))] for low, high in scene.limits_deg]
    view = SceneView(
        label="Scene explorer",
        help="Drag the color picture to turn the head; touch the depth picture to read a pixel.",
        rgb_png=encode_rgb(rgb),
        depth_png=encode_depth(depth),
        fov_y_deg=scene.fov_y_deg,
        limits_deg=inside,
        ball_px=list(scene.find_ball(depth) or ()),
        **scene.pose._asdict(),
    )
    explorer = SceneExplorer(view, scene)
    explorer.goal = Goal(
        "Bring the red ball to the middle of the picture.",
        GoalPart("ball_off_px", "off by", high=_NEAR_MIDDLE_PX, unit=" px", digits=0),
    )
    return explorer


def _round_to(pose: ScenePose) -> list[tuple[float, int]]:
    """Pair each value of a pose with the digits of its slider."""
    return list(zip(pose, (1, 1, 2, 2), strict=True))
