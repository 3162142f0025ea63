"""Read what was recorded in a room: stereo pairs, keyframes of a walk, an inertial sensor.

A recording needs no simulator and no OpenGL, so that a chapter shows the same pictures everywhere,
in the page too. The files hold what was rendered, bit by bit; the noise of a camera is added when
they are read, the same for the same seed. `labutils.room` makes recordings.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import cv2
import numpy as np

from labutils.cameras import intrinsics_matrix

#: Recordings that come with the book, beside the package in the repository.
CLIPS = Path(__file__).resolve().parents[1] / "assets" / "clip"
INDEX = "clip.json"
#: Depth is stored as its inverse, in 16 bits: on a plane that changes evenly from pixel to pixel.
#: A depth of so many meters is 1, one of 0.3 meters the largest number there is.
DEPTH_SCALE = 0.3 * (2**16 - 1)
#: Standard deviation of the noise of a camera, in gray levels.
NOISE = 2.0


@dataclass(frozen=True)
class StereoPair:
    """Two pictures of two cameras side by side, and the truth about them.

    Parameters
    ----------
    view : str
        Name of the place that it was taken from.
    left, right : ndarray, uint8, shape (H, W)
        Gray pictures with noise; rows of one are rows of the other.
    depth, depth_right : ndarray, float32, shape (H, W)
        True depth of either picture in meters, without noise; NaN where there is no surface.
    labels : ndarray, uint8, shape (H, W)
        What each pixel of the left picture shows; `Recording.label_names` says which is which.
    K : ndarray, float64, shape (3, 3)
        Intrinsic matrix of both cameras.
    baseline : float
        How many meters the right camera stands to the right.
    T_world_cam : ndarray, float64, shape (4, 4)
        Pose of the left camera: maps its points (OpenCV) into the world.
    color : ndarray, uint8, shape (H, W, 3), or None
        The left picture in RGB, with the same noise; not every pair has it.
    """

    view: str
    left: np.ndarray
    right: np.ndarray
    depth: np.ndarray
    depth_right: np.ndarray
    labels: np.ndarray
    K: np.ndarray
    baseline: float
    T_world_cam: np.ndarray
    color: np.ndarray | None


@dataclass(frozen=True)
class Keyframe:
    """A picture of the left camera on the walk.

    Parameters
    ----------
    time : float
        Seconds since the start.
    gray : ndarray, uint8, shape (H, W)
        The picture with noise.
    depth : ndarray, float32, shape (H, W)
        True depth in meters; NaN where there is no surface.
    K : ndarray, float64, shape (3, 3)
        Intrinsic matrix.
    T_world_cam : ndarray, float64, shape (4, 4)
        Pose of the camera: maps its points (OpenCV) into the world.
    """

    time: float
    gray: np.ndarray
    depth: np.ndarray
    K: np.ndarray
    T_world_cam: np.ndarray


@dataclass(frozen=True)
class ImuReadings:
    """What the inertial sensor of the head read, exactly: no noise, no bias.

    Parameters
    ----------
    time : ndarray, float64, shape (N,)
        Seconds since the start.
    gyro : ndarray, float64, shape (N, 3)
        Angular velocity in rad/s, in the sensor's frame.
    accel : ndarray, float64, shape (N, 3)
        Specific force in m/s2, in the sensor's frame: 9.81 upward at rest.
    T_world_imu : ndarray, float64, shape (4, 4)
        Pose of the sensor at the start, where it rests.
    """

    time: np.ndarray
    gyro: np.ndarray
    accel: np.ndarray
    T_world_imu: np.ndarray


class Recording:
    """A folder of pictures, read when they are asked for.

    Parameters
    ----------
    folder : Path
        With a file `INDEX`.
    noise : float
        Standard deviation of the noise in gray levels; 0 shows what was rendered.
    seed : int
        Another seed, another noise.
    """

    def __init__(self, folder: Path, noise: float = NOISE, seed: int = 0) -> None:
        self._folder, self._noise, self._seed = folder, noise, seed
        self._index: dict[str, Any] = json.loads((folder / INDEX).read_text(encoding="utf-8"))

    @property
    def label_names(self) -> dict[str, int]:
        """The number of every thing in `StereoPair.labels`."""
        return dict(self._index["labels"])

    def K(self, width: int) -> np.ndarray:  # noqa: N802 - the field's name
        """Return the intrinsic matrix for pictures of this width, with sides of 4 to 3."""
        return intrinsics_matrix(np.deg2rad(self._index["fov_y_deg"]), width, width * 3 // 4)

    @cached_property
    def pairs(self) -> list[StereoPair]:
        """The pair of each view, with a baseline of 0.10 m."""
        return [self._read_pair(one) for one in self._index["pairs"] if one["is_view"]]

    @cached_property
    def baseline_pairs(self) -> list[StereoPair]:
        """The first view again, with ever longer baselines; the left camera stays."""
        rows = sorted(self._index["pairs"], key=lambda one: float(one["baseline"]))
        first = self._index["pairs"][0]["view"]
        return [self._read_pair(one) for one in rows if one["view"] == first]

    @cached_property
    def keyframes(self) -> list[Keyframe]:
        """Pictures of the walk, in their order."""
        return [self._read_keyframe(one) for one in self._index["keyframes"]]

    @cached_property
    def imu(self) -> ImuReadings:
        """What the inertial sensor read on the walk."""
        path = self._find(self._index["imu"])
        with np.load(path) as file:
            arrays = {name: file[name].astype(np.float64) for name in file.files}
        return ImuReadings(**arrays)

    def _read_pair(self, row: dict[str, Any]) -> StereoPair:
        # Noise belongs to a picture: the left one is the same picture at every baseline.
        left = self._read(row["left"])
        color = self._read(row["color"]) if "color" in row else None
        return StereoPair(
            view=row["view"],
            left=self._add_noise(left, row["left"]),
            right=self._add_noise(self._read(row["right"]), row["right"]),
            depth=decode_depth(self._read(row["depth"])),
            depth_right=decode_depth(self._read(row["depth_right"])),
            labels=self._read(row["labels"]),
            K=self.K(left.shape[1]),
            baseline=float(row["baseline"]),
            T_world_cam=np.array(row["T_world_cam"]),
            color=None if color is None else self._add_noise(color, row["left"]),
        )

    def _read_keyframe(self, row: dict[str, Any]) -> Keyframe:
        gray = self._read(row["gray"])
        return Keyframe(
            time=float(row["time"]),
            gray=self._add_noise(gray, row["gray"]),
            depth=decode_depth(self._read(row["depth"])),
            K=self.K(gray.shape[1]),
            T_world_cam=np.array(row["T_world_cam"]),
        )

    def _add_noise(self, picture: np.ndarray, name: str) -> np.ndarray:
        """Add the noise of this file: gray and color of one picture get the same."""
        return add_noise(picture, self._noise, [self._seed, *name.encode()])

    def _read(self, name: str) -> np.ndarray:
        data = np.frombuffer(self._find(name).read_bytes(), np.uint8)
        picture = cv2.imdecode(data, cv2.IMREAD_UNCHANGED)
        if picture is None:
            raise ValueError(f"recording: expected a picture in {name}, got something else")
        return picture if picture.ndim == 2 else cv2.cvtColor(picture, cv2.COLOR_BGR2RGB)

    def _find(self, name: str) -> Path:
        path = self._folder / name
        if not path.is_file():
            raise FileNotFoundError(
                f"recording: expected {name} in {self._folder.name}/, got nothing there; "
                "the pages bring the stereo pairs alone, a checkout brings everything"
            )
        return path


def load_recording(name: str | Path = "room", *, noise: float = NOISE, seed: int = 0) -> Recording:
    """Open a recording.

    Parameters
    ----------
    name : str or Path
        One that comes with the book, ``"room"``, or a folder that `labutils.room` has recorded
        into.
    noise : float
        Standard deviation of the noise of the cameras in gray levels, >= 0.
    seed : int
        Of that noise, >= 0: another seed gives another spread of the same scene.

    Returns
    -------
    Recording
        Pictures are read when they are first asked for.

    Raises
    ------
    FileNotFoundError
        If there is no such recording.
    ValueError
        If the noise is negative.

    Examples
    --------
    >>> recording = load_recording("room")
    >>> pair = recording.pairs[0]
    >>> pair.left.shape, pair.baseline
    ((480, 640), 0.1)
    """
    if not noise >= 0:
        raise ValueError(f"noise: expected gray levels >= 0, got {noise}")
    folder = CLIPS / name if isinstance(name, str) else Path(name)
    if not (folder / INDEX).is_file():
        known = ", ".join(sorted(path.parent.name for path in CLIPS.glob(f"*/{INDEX}")))
        raise FileNotFoundError(f"recording: expected one of {known or 'none'}, got {str(name)!r}")
    return Recording(folder, noise, seed)


def add_noise(picture: np.ndarray, sigma: float, seed: int | list[int]) -> np.ndarray:
    """Add the noise of a camera: each pixel by itself, all channels of a pixel alike.

    Parameters
    ----------
    picture : ndarray, uint8, shape (H, W) or (H, W, 3)
        Gray or RGB.
    sigma : float
        Standard deviation in gray levels.
    seed : int or list of int
        The same seed adds the same noise.

    Returns
    -------
    ndarray, uint8, same shape
        Rounded, and cut off at 0 and 255.
    """
    if sigma == 0:
        return picture
    noise = np.random.default_rng(seed).normal(0, sigma, picture.shape[:2])
    noisy = picture + (noise if picture.ndim == 2 else noise[..., None])
    return np.clip(np.round(noisy), 0, 255).astype(np.uint8)


def encode_depth(depth_metric: np.ndarray) -> np.ndarray:
    """Turn meters into the 16 bits that a recording stores; 0 where there is no surface.

    Raises
    ------
    ValueError
        If something is nearer than 0.3 m.
    """
    inverse = DEPTH_SCALE / np.asarray(depth_metric, dtype=np.float64)
    whole = np.round(np.where(np.isfinite(inverse), inverse, 0))
    if whole.max(initial=0) >= 2**16:
        raise ValueError(f"depth: expected 0.3 m or more, got {np.nanmin(depth_metric):.3f} m")
    return whole.astype(np.uint16)


def decode_depth(stored: np.ndarray) -> np.ndarray:
    """Turn what a recording stores back into meters, float32; NaN where it is 0."""
    inverse = np.where(stored > 0, stored, np.nan)
    return (DEPTH_SCALE / inverse).astype(np.float32)
