"""Explore a point cloud: walk around it, pick a point, and bend it with a wrong field of view.

Taught in: step 5 (back-projection) and step 6 (viewing).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar

import cv2
import numpy as np
import traitlets

from labutils._constants import MAX_DEPTH, MIN_DEPTH
from labutils._guards import check_pixel
from labutils.depth_values import find_valid_depth
from labutils.explorers._base import (
    DEPTH_STEP,
    PixelExplorer,
    PixelView,
    decode_depth,
    decode_rgb,
    encode_depth,
    encode_rgb,
    make_choice,
    make_slider,
)
from labutils.explorers._cloud_poster import VIEW_FOV_DEG, draw_cloud
from labutils.explorers._cloud_start import (
    check_faces,
    check_fov,
    check_transform,
    find_limits,
    find_stretch,
    make_start_orbit,
)
from labutils.explorers._goal import Goal, GoalPart
from labutils.explorers._modules import join_modules, join_styles
from labutils.pointcloud import depth_to_pointcloud
from labutils.projection import pixels_to_points

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

_COLORS = ("RGB", "depth", "height")
#: The goal: half a degree on either side of it.
_RIGHT_ANGLE_DEG = (89.5, 90.5)


class CloudView(PixelView):
    """The cloud, the camera's picture beside it, and the point that was picked in either."""

    _esm = join_modules("cloud")
    _css = join_styles("cloud")
    rgb_png = traitlets.Bytes().tag(sync=True)
    depth_png = traitlets.Bytes().tag(sync=True)
    depth_step = traitlets.Float(DEPTH_STEP).tag(sync=True)
    min_depth = traitlets.Float(MIN_DEPTH).tag(sync=True)
    #: 256 colors from blue to red, three bytes each: OpenCV's turbo.
    palette = traitlets.Bytes().tag(sync=True)
    #: Intrinsic matrix of the camera as it is, rows of three; the angle that goes with it.
    true_K: Any = traitlets.List().tag(sync=True)  # noqa: N815 - the field's name
    true_fov_y_deg = traitlets.Float(45.0).tag(sync=True)
    #: Pose of the camera in the world, rows of four; [] where the cloud stays in its frame.
    T_world_cam: Any = traitlets.List().tag(sync=True)
    #: Two flat faces that meet at a right angle: [name, three pixels] each; [] for none.
    faces: Any = traitlets.List().tag(sync=True)
    #: Least and most of the colors' scales in meters, which no control moves.
    depth_limits = traitlets.List([0.0, 1.0]).tag(sync=True)
    height_limits = traitlets.List([0.0, 1.0]).tag(sync=True)
    view_fov_deg = traitlets.Float(VIEW_FOV_DEG).tag(sync=True)

    fov_y_deg = traitlets.Float(45.0).tag(sync=True)
    far = traitlets.Float(MAX_DEPTH).tag(sync=True)
    #: Place of the coloring: RGB, depth, height.
    color = traitlets.Int(0).tag(sync=True)
    #: Where the reader looks from: `azimuth_deg`, `elevation_deg`, `distance`, `target`.
    orbit = traitlets.Dict().tag(sync=True)

    PICTURE: ClassVar = "depth_png"
    PARAMETERS: ClassVar = ("fov_y_deg", "far", "color", "pixel", "orbit")

    @property
    def depth(self) -> np.ndarray:
        """The depth image as the page has it, float32 (H, W) in meters."""
        return decode_depth(self.depth_png)

    @property
    def assumed_K(self) -> np.ndarray:  # noqa: N802 - the field's name
        """Intrinsic matrix that belongs to the field of view of the slider."""
        return self._assume(self.fov_y_deg)

    @property
    def stretch(self) -> float:
        """Ratio by which the field of view of the slider makes the cloud too wide."""
        return find_stretch(self.fov_y_deg, self.true_fov_y_deg)

    def _assume(self, fov_y_deg: float) -> np.ndarray:
        K = np.array(self.true_K)
        K[[0, 1], [0, 1]] /= find_stretch(fov_y_deg, self.true_fov_y_deg)
        return K

    def compute(self) -> dict[str, Any]:
        """Compute what the read-out tells: points, f, how wrong it is, and the picked point."""
        depth = self.depth
        valid = find_valid_depth(depth, max_depth=self.far)
        K = self.assumed_K
        point, in_world = None, None
        if self.pixel and valid[self.pixel[1], self.pixel[0]]:
            u, v = self.pixel
            point = pixels_to_points(np.array([[u, v]]), depth[v : v + 1, u], K)[0]
            if self.T_world_cam:
                in_world = (np.array(self.T_world_cam) @ [*point, 1.0])[:3].tolist()
            point = point.tolist()
        return {
            "points": int(np.count_nonzero(valid)),
            "f": float(K[1, 1]),
            "stretch": self.stretch,
            "angle_deg": self._measure_angle(depth, K),
            "point_camera": point,
            "point_world": in_world,
        }

    def _measure_angle(self, depth: np.ndarray, K: np.ndarray) -> float | None:
        """Measure the angle in which the two faces meet, on the side that the camera sees."""
        if not self.faces:
            return None
        normals = []
        for _, pixels in self.faces:
            u, v = np.transpose(pixels)
            first, second, third = pixels_to_points(np.array(pixels), depth[v, u], K)
            normal = np.cross(second - first, third - first)
            normals.append(-np.sign(normal @ first) * normal / np.linalg.norm(normal))
        return float(180 - np.degrees(np.arccos(np.clip(normals[0] @ normals[1], -1, 1))))

    def describe(self) -> str:
        """Say the count, and what the field of view makes of it."""
        values = self.compute()
        angle = "" if values["angle_deg"] is None else f", faces meet at {values['angle_deg']:.1f}°"
        return (
            f"Point cloud: {values['points']} points, f = {values['f']:.1f} px, "
            f"{values['stretch']:.2f} times as wide as it should be{angle}"
        )

    def draw_poster(self) -> np.ndarray:
        """Draw the cloud from where the view starts, with the field of view it starts with."""
        K = self._assume(self.start["fov_y_deg"])
        points, colors = depth_to_pointcloud(self.depth, K, decode_rgb(self.rgb_png))
        T_world_cam = np.array(self.T_world_cam) if self.T_world_cam else None
        return draw_cloud(points, colors, T_world_cam, self.start["orbit"])


class CloudExplorer(PixelExplorer):
    """What `explore_cloud` returns: the values, as Python reads them."""

    view: CloudView

    @property
    def fov_y(self) -> float:
        """Assumed angle from top to bottom in radians."""
        return float(np.radians(self.view.fov_y_deg))

    @property
    def K(self) -> np.ndarray:  # noqa: N802 - the field's name
        """Intrinsic matrix of the assumed angle, float64 (3, 3)."""
        return self.view.assumed_K

    @property
    def far(self) -> float:
        """Points at or beyond this depth, in meters, are left out."""
        return float(self.view.far)

    @property
    def point(self) -> np.ndarray | None:
        """The point of that pixel, float64 (3,); None where there is none.

        In the world frame where the camera's pose was given, else in the camera frame.
        """
        values = self.view.compute()
        found = values["point_world"] or values["point_camera"]
        return None if found is None else np.array(found)


def explore_cloud(
    rgb: np.ndarray,
    depth: np.ndarray,
    K: np.ndarray,
    T_world_cam: np.ndarray | None = None,
    *,
    faces: Mapping[str, Sequence[Sequence[int]]] | None = None,
    pixel: Sequence[int] | None = None,
    fov_y: float | None = None,
) -> CloudExplorer:
    """Walk around the points of a color and a depth picture, and pick some.

    Parameters
    ----------
    rgb : ndarray, uint8, shape (H, W, 3)
        Colors.
    depth : ndarray, real, shape (H, W)
        Meters along the optical axis; kept in steps of 0.2 mm.
    K : array-like, shape (3, 3)
        Intrinsic matrix: the angle that goes with it is the first one shown.
    T_world_cam : array-like, shape (4, 4), optional
        Pose of the camera (see `get_camera_pose`). Without it the cloud is in the camera frame,
        and height is height above the camera.
    faces : mapping of str to three pixels, optional
        Two flat things that meet at a right angle, by name: three (u, v) on each. The view
        measures the angle between them, which a wrong field of view bends.
    pixel : (u, v), optional
        The pixel picked first.
    fov_y : float, optional
        The angle from top to bottom assumed first, in radians: half to twice the camera's own,
        which it is without this. With faces the goal is to find the camera's own.

    Returns
    -------
    CloudExplorer
        Shows itself as the last line of a cell; has `fov_y` in radians, `K`, `far`, `pixel` and
        `point`.

    Raises
    ------
    TypeError, ValueError
        If the pictures or K are not what `depth_to_pointcloud` takes, nothing lies within its
        limits, the pose is none, a pixel lies outside or on nothing, three lie on a line, or the
        angle is outside the limits of its slider.
    """
    depth = decode_depth(encode_depth(depth))  # what the page gets: every limit is derived from it
    points, _ = depth_to_pointcloud(depth, K, rgb)
    if len(points) == 0:
        raise ValueError(f"depth: expected a reading from {MIN_DEPTH} to {MAX_DEPTH} m, got none")
    K = np.array(K, np.float64)
    pose = None if T_world_cam is None else check_transform(T_world_cam)
    limits = find_limits(points, K, depth.shape[0], pose)
    # one row: of a flat array OpenCV 4 makes a column, and OpenCV 5 a row
    turbo = cv2.applyColorMap(np.arange(256, dtype=np.uint8)[None], cv2.COLORMAP_TURBO)
    first_fov_deg = limits.fov_y_deg if fov_y is None else check_fov(fov_y, limits.fov)
    stretch = find_stretch(first_fov_deg, limits.fov_y_deg)
    view = CloudView(
        label="Point cloud explorer",
        help=(
            "Drag to walk around, click to pick a point; after a click the wheel zooms. "
            "Keys: arrows, +, -, Home."
        ),
        rgb_png=encode_rgb(rgb),
        depth_png=encode_depth(depth),
        palette=turbo[0, :, ::-1].tobytes(),
        true_K=K.tolist(),
        true_fov_y_deg=limits.fov_y_deg,
        T_world_cam=[] if pose is None else pose.tolist(),
        faces=[] if faces is None else check_faces(faces, depth),
        depth_limits=limits.depth,
        height_limits=limits.height,
        fov_y_deg=first_fov_deg,
        far=limits.far[1],
        pixel=[] if pixel is None else list(check_pixel("pixel", pixel, *depth.shape[::-1])),
        orbit=make_start_orbit(points * [stretch, stretch, 1], pose),
    )
    explorer = CloudExplorer(
        view,
        {
            "fov_y_deg": make_slider("fov_y", limits.fov, 0.5, unit="°", digits=1),
            "far": make_slider("far", limits.far, 0.05, unit="m", digits=2),
            "color": make_choice("color", _COLORS),
        },
    )
    if faces is not None and fov_y is not None:
        explorer.goal = Goal(
            f"Make {' and '.join(faces)} meet at a right angle again.",
            GoalPart("angle_deg", "angle", *_RIGHT_ANGLE_DEG, unit="°", digits=1),
        )
    return explorer
