"""Explore the field of view: picture, focal length, K and frustum change together.

Taught in: step 2.
"""

from __future__ import annotations

import copy
from typing import TYPE_CHECKING, Any, ClassVar

import cv2
import numpy as np
import traitlets

from labutils.camera_utils import render_camera, render_segmentation
from labutils.cameras import get_camera_intrinsics, get_camera_pose, intrinsics_matrix
from labutils.explorers._base import (
    Explorer,
    View,
    decode_rgb,
    encode_rgb,
    make_choice,
    make_slider,
)
from labutils.explorers._goal import Goal, GoalPart
from labutils.explorers._modules import join_modules, join_styles
from labutils.rendering import make_renderer

if TYPE_CHECKING:
    from collections.abc import Sequence

    import mujoco

#: Widest view in degrees. One picture this wide holds every narrower one as its middle.
MAX_FOV_DEG = 100.0
_MIN_FOV_DEG = 10.0
#: Wider than any picture shown, so that a narrow view stays sharp.
_WIDE_SIZE = (1280, 960)
_SIZES = ((160, 120), (640, 480), (1280, 960))


class FovView(View):
    """The picture, the camera from above, and K."""

    _esm = join_modules("fov")
    _css = join_styles("fov")
    wide_png = traitlets.Bytes().tag(sync=True)
    max_fov_deg = traitlets.Float(MAX_FOV_DEG).tag(sync=True)
    fov_y_deg = traitlets.Float(45.0).tag(sync=True)
    #: Place of the picture's size in `sizes`.
    size = traitlets.Int(1).tag(sync=True)
    sizes = traitlets.List([list(size) for size in _SIZES]).tag(sync=True)
    #: Things on the table: name, x to the right and z forward in meters, color, and the tangent of
    #: half the angle from top to bottom at which it is just seen whole, None for never.
    landmarks: traitlets.List[dict[str, Any]] = traitlets.List().tag(sync=True)

    PARAMETERS: ClassVar = ("fov_y_deg", "size")

    def compute(self) -> dict[str, Any]:
        """Compute what the read-out tells: f, K, the other angle, and what lies inside."""
        width, height = self.sizes[self.size]
        K = intrinsics_matrix(np.radians(self.fov_y_deg), width, height)
        half_width = width / 2 / K[0, 0]  # at a depth of 1
        inside = [one for one in self.landmarks if abs(one["x"]) <= one["z"] * half_width]
        return {
            "f": float(K[0, 0]),
            "K": K.tolist(),
            "fov_x_deg": float(np.degrees(2 * np.arctan(half_width))),
            "mm_per_px": float(1000 / K[0, 0]),
            "spare_deg": self._find_spare(),
            "seen": [one["name"] for one in sorted(inside, key=lambda one: one["x"] / one["z"])],
        }

    def _find_spare(self) -> float | None:
        """Find how far the angle could close with all things whole; negative where one is cut."""
        tangents = [one["half_tan"] for one in self.landmarks]
        if not tangents or None in tangents:
            return None
        return self.fov_y_deg - float(np.degrees(2 * np.arctan(max(tangents))))

    def describe(self) -> str:
        """Say the angle and what it means in pixels."""
        values = self.compute()
        return (
            f"Field of view: {self.fov_y_deg:g} degrees from top to bottom, "
            f"f = {values['f']:.1f} px, {len(values['seen'])} objects inside"
        )

    def draw_poster(self) -> np.ndarray:
        """Draw the picture at this angle."""
        wide = decode_rgb(self.wide_png)
        share = np.tan(np.radians(self.fov_y_deg / 2)) / np.tan(np.radians(self.max_fov_deg / 2))
        size = (round(wide.shape[1] * share), round(wide.shape[0] * share))
        center = ((wide.shape[1] - 1) / 2, (wide.shape[0] - 1) / 2)
        crop = cv2.getRectSubPix(wide, size, center)
        return cv2.resize(crop, (640, 480), interpolation=cv2.INTER_AREA)


class FovExplorer(Explorer):
    """What `explore_fov` returns: the values, as Python reads them."""

    view: FovView

    @property
    def fov_y(self) -> float:
        """Angle from top to bottom in radians."""
        return float(np.radians(self.view.fov_y_deg))

    @property
    def picture_size(self) -> tuple[int, int]:
        """Width and height in pixels."""
        width, height = self.view.sizes[self.view.size]
        return width, height

    @property
    def K(self) -> np.ndarray:  # noqa: N802 - the field's name
        """Intrinsic matrix, float64 (3, 3)."""
        return intrinsics_matrix(self.fov_y, *self.picture_size)


def explore_fov(
    model: mujoco.MjModel,
    data: mujoco.MjData,
    camera_name: str = "head_camera",
    objects: Sequence[str] = (),
) -> FovExplorer:
    """Move the field of view of a camera and see what follows.

    Parameters
    ----------
    model, data : mujoco.MjModel, mujoco.MjData
        The scene; it is left as it is.
    camera_name : str
        Where to look from; its own angle is the first one shown.
    objects : sequence of str
        Bodies to draw from above. With them the explorer has a goal: the smallest angle that
        shows all of them whole.

    Returns
    -------
    FovExplorer
        Shows itself as the last line of a cell; has `fov_y` in radians, `picture_size` and `K`.

    Raises
    ------
    ValueError
        If the model has no such camera, or its field of view is not within the slider's limits.
    KeyError
        If the model has no such body.
    """
    _, fov_y = get_camera_intrinsics(model, camera_name, 640, 480)
    fov_y_deg = round(float(np.degrees(fov_y)), 9)  # 45, not 45.00000000000001
    if not _MIN_FOV_DEG <= fov_y_deg <= MAX_FOV_DEG:
        raise ValueError(
            f"camera_name: expected a field of view of {_MIN_FOV_DEG:g} to {MAX_FOV_DEG:g} "
            f"degrees, got {fov_y_deg:g}"
        )
    wide_rgb, wide_bodies = _render_wide(model, data, camera_name)
    view = FovView(
        label="Field of view explorer",
        help="Move the slider. Point at the picture or at the drawing: one ray, seen twice.",
        wide_png=encode_rgb(wide_rgb),
        fov_y_deg=fov_y_deg,
        landmarks=[
            _find_landmark(model, data, camera_name, name)
            | {"half_tan": _find_half_tan(wide_bodies == model.body(name).id)}
            for name in objects
        ],
    )
    slider = make_slider("fov_y", (_MIN_FOV_DEG, MAX_FOV_DEG), 0.5, unit="°", digits=1)
    sizes = [f"{width} x {height}" for width, height in _SIZES]
    explorer = FovExplorer(view, {"fov_y_deg": slider, "size": make_choice("picture", sizes)})
    if explorer.values["spare_deg"] is not None:
        explorer.goal = Goal(
            f"Zoom in until all {len(objects)} objects just fit, whole.",
            GoalPart("spare_deg", "angle to spare", low=0, high=1, unit="°", digits=1),
        )
    return explorer


def _render_wide(
    model: mujoco.MjModel, data: mujoco.MjData, camera_name: str
) -> tuple[np.ndarray, np.ndarray]:
    """Render the widest view there is, of a copy: the reader's camera keeps its angle.

    Returns
    -------
    rgb : uint8 array, shape (H, W, 3)
    bodies : int array, shape (H, W)
        The body that each pixel shows.
    """
    wide_model = copy.copy(model)
    wide_model.cam(camera_name).fovy[:] = MAX_FOV_DEG
    width, height = _WIDE_SIZE
    renderer = make_renderer(wide_model, height, width)
    try:
        rgb, _ = render_camera(wide_model, data, renderer, camera_name)
        bodies = render_segmentation(wide_model, data, renderer, camera_name)
    finally:
        renderer.close()
    return rgb, bodies


def _find_half_tan(mask: np.ndarray) -> float | None:
    """Find tan(fov_y / 2) of the smallest picture that holds what a wide mask shows, whole."""
    rows, columns = np.nonzero(mask)
    if not len(rows):
        return None
    # as shares of the half picture, which has the same shape at every angle
    shares = []
    for places, size in ((rows, mask.shape[0]), (columns, mask.shape[1])):
        edges = np.array([places.min(), places.max() + 1])
        shares.append(np.abs(2 * edges / size - 1).max())
    if max(shares) >= 1:
        return None  # cut off by the widest picture
    return round(float(max(shares) * np.tan(np.radians(MAX_FOV_DEG / 2))), 5)


def _find_landmark(
    model: mujoco.MjModel, data: mujoco.MjData, camera_name: str, body_name: str
) -> dict[str, Any]:
    """Find where a body is in the camera frame, and its color."""
    body = model.body(body_name)
    T_cam_world = np.linalg.inv(get_camera_pose(model, data, camera_name))
    x, _, z = (T_cam_world @ np.append(data.xpos[body.id], 1.0))[:3]
    geom = model.geom(body.geomadr[0])
    material = int(geom.matid[0])
    rgba = geom.rgba if material < 0 else model.mat_rgba[material]
    red, green, blue = (rgba[:3] * 255).round().astype(int)
    return {
        "name": body_name.replace("_", " "),
        "x": round(float(x), 4),
        "z": round(float(z), 4),
        "color": f"#{red:02x}{green:02x}{blue:02x}",
    }
