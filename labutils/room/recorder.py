"""Render in a room and write it down, in the format that `labutils.recordings` reads."""

from __future__ import annotations

import hashlib
import json
from typing import TYPE_CHECKING, Any

import cv2
import mujoco
import numpy as np
from tqdm import tqdm

from labutils._files import write_in_one_step
from labutils.camera_utils import render_camera
from labutils.cameras import get_camera_pose
from labutils.recordings import INDEX, encode_depth
from labutils.rendering import make_renderer
from labutils.room.scene import BASELINE, FOV_Y, IMU, LEFT, RIGHT, set_baseline, set_pose
from labutils.room.walk import DURATION, Walk, measure_imu, put

if TYPE_CHECKING:
    from pathlib import Path

    from labutils.renderers.protocol import Renderer

#: Where pairs are taken from, by name: the first shows everything that is planted.
VIEWS: dict[str, dict[str, float]] = {
    "table": {"base_x": -1.1, "neck_tilt": 0.45},
    "pole": {"base_x": -0.2, "base_y": -0.75, "base_yaw": 0.4, "neck_tilt": 0.1},
    "corner": {"base_x": -0.9, "base_y": 0.5, "base_yaw": -0.5, "neck_tilt": 0.5},
    "room": {"base_x": -1.6, "base_y": -0.3, "base_yaw": 0.2, "neck_tilt": 0.2},
    "side": {"base_x": -0.3, "base_y": 1.1, "base_yaw": -1.4, "neck_tilt": 0.5},
    "back": {"base_x": 1.05, "base_y": -1.2, "base_yaw": 2.2, "neck_tilt": 0.4},
}
#: Distances of the eyes in meters that the first view is recorded with.
BASELINES = (0.02, 0.05, 0.10, 0.20, 0.30)


class Recorder:
    """Renders in one room into one folder.

    Parameters
    ----------
    model, data : mujoco.MjModel, mujoco.MjData
        A room from `make_room`.
    folder : Path
        Where the files go; it is made if need be.
    progress : bool
        Show progress bars.
    """

    def __init__(
        self, model: mujoco.MjModel, data: mujoco.MjData, folder: Path, *, progress: bool = True
    ) -> None:
        self._model, self._data, self._folder = model, data, folder
        self._progress = progress
        self._index: dict[str, Any] = {
            "license": "CC BY 4.0, see LICENSE-TEXT",
            "versions": {"mujoco": mujoco.__version__, "numpy": np.__version__},
            "textures_sha256": hash_textures(model),
            "fov_y_deg": FOV_Y,
            "labels": list_labels(model),
            "pairs": [],
            "keyframes": [],
        }
        folder.mkdir(parents=True, exist_ok=True)

    def record_pairs(
        self, views: dict[str, dict[str, float]], baselines: tuple[float, ...] = (BASELINE,)
    ) -> None:
        """Record stereo pairs at 640x480: all views at `BASELINE`, the first at all baselines."""
        first = next(iter(views))
        with make_renderer(self._model, 480, 640) as renderer:
            for view in tqdm(views, desc="stereo pairs", disable=not self._progress):
                set_pose(self._model, self._data, **views[view])
                left = self._record_left(renderer, view, in_color=view == first)
                others = [one for one in baselines if one != BASELINE and view == first]
                for baseline in (BASELINE, *others):
                    row = left | {"baseline": baseline, "is_view": baseline == BASELINE}
                    right = self._record_right(renderer, view, baseline)
                    self._index["pairs"].append(row | right)

    def record_walk(self, *, frames_per_second: float, width: int = 320) -> None:
        """Record gray and depth of the left eye on the walk, and the inertial sensor."""
        walk = Walk()
        times = np.arange(0, DURATION, 1 / frames_per_second)
        with make_renderer(self._model, width * 3 // 4, width) as renderer:
            for number, time in enumerate(tqdm(times, "keyframes", disable=not self._progress)):
                put(self._model, self._data, walk, time)
                rgb, depth = render_camera(self._model, self._data, renderer, LEFT)
                stem = f"walk/{number:04d}"
                row = {
                    "time": float(time),
                    "gray": self._write(f"{stem}.png", cv2.cvtColor(rgb, cv2.COLOR_RGB2GRAY)),
                    "depth": self._write(f"{stem}_depth.png", encode_depth(depth)),
                    "T_world_cam": get_camera_pose(self._model, self._data, LEFT).tolist(),
                }
                self._index["keyframes"].append(row)
        self._record_imu(walk)

    def finish(self) -> None:
        """Write the index: only with it is the folder a recording."""
        text = json.dumps(self._index, indent=1) + "\n"
        write_in_one_step(self._folder / INDEX, text.encode())

    def _record_left(self, renderer: Renderer, view: str, *, in_color: bool) -> dict[str, Any]:
        rgb, depth = render_camera(self._model, self._data, renderer, LEFT)
        labels = render_labels(self._model, self._data, renderer)
        row = {
            "view": view,
            "left": self._write(f"{view}_left.png", cv2.cvtColor(rgb, cv2.COLOR_RGB2GRAY)),
            "depth": self._write(f"{view}_depth.png", encode_depth(depth)),
            "labels": self._write(f"{view}_labels.png", labels),
            "T_world_cam": get_camera_pose(self._model, self._data, LEFT).tolist(),
        }
        if in_color:
            row["color"] = self._write(f"{view}_color.png", rgb)
        return row

    def _record_right(self, renderer: Renderer, view: str, baseline: float) -> dict[str, str]:
        stem = f"{view}_right_{round(1000 * baseline):03d}mm"
        set_baseline(self._model, baseline)
        try:
            rgb, depth = render_camera(self._model, self._data, renderer, RIGHT)
        finally:
            set_baseline(self._model, BASELINE)
        return {
            "right": self._write(f"{stem}.png", cv2.cvtColor(rgb, cv2.COLOR_RGB2GRAY)),
            "depth_right": self._write(f"{stem}_depth.png", encode_depth(depth)),
        }

    def _record_imu(self, walk: Walk) -> None:
        found = measure_imu(self._model, self._data, walk, progress=self._progress)
        pose = np.eye(4)
        pose[:3, :3], pose[:3, 3] = found.rotation[0], found.position[0]
        with (self._folder / "imu.npz").open("wb") as file:
            np.savez(
                file,
                time=found.time,
                gyro=found.gyro.astype(np.float32),
                accel=found.accel.astype(np.float32),
                T_world_imu=pose,
            )
        self._index["imu"] = "imu.npz"

    def _write(self, name: str, picture: np.ndarray) -> str:
        """Write a picture without loss; return its name."""
        bgr = picture if picture.ndim == 2 else cv2.cvtColor(picture, cv2.COLOR_RGB2BGR)
        done, data = cv2.imencode(".png", bgr, [cv2.IMWRITE_PNG_COMPRESSION, 9])
        if not done:
            raise OSError(f"recording: {name} could not be encoded")
        path = self._folder / name
        path.parent.mkdir(exist_ok=True)
        write_in_one_step(path, data.tobytes())
        return name


def list_labels(model: mujoco.MjModel) -> dict[str, int]:
    """Give numbers to what pictures show: 0 is nothing, then things of the room, last the robot."""
    names = ["nothing"]
    names += [model.geom(geom).name for geom in range(model.ngeom) if not model.geom_bodyid[geom]]
    bodies = [one for one in range(1, model.nbody) if model.body_rootid[one] != _get_robot(model)]
    names += [model.body(one).name for one in bodies]
    return {name: number for number, name in enumerate([*names, "robot"])}


def render_labels(
    model: mujoco.MjModel, data: mujoco.MjData, renderer: Renderer, camera: str = LEFT
) -> np.ndarray:
    """Render what every pixel shows, numbered by `list_labels`, uint8."""
    numbers = list_labels(model)
    of_geom = np.zeros(model.ngeom + 1, dtype=np.uint8)
    for geom in range(model.ngeom):
        body = model.geom_bodyid[geom]
        name = model.body(body).name if body else model.geom(geom).name
        of_geom[geom] = numbers.get(name, numbers["robot"])
    renderer.update_scene(data, camera=camera)
    try:
        renderer.enable_segmentation_rendering()
        geoms = renderer.render()[..., 0]
    finally:
        renderer.disable_segmentation_rendering()
    return of_geom[geoms]  # -1, nothing, is the last entry


def hash_textures(model: mujoco.MjModel) -> str:
    """Name the textures of a room: the same bytes, the same name."""
    return hashlib.sha256(model.tex_data.tobytes()).hexdigest()


def _get_robot(model: mujoco.MjModel) -> int:
    return int(model.body_rootid[model.site_bodyid[model.site(IMU).id]])
