"""Step 2: the intrinsic matrix of a camera of the model."""

from __future__ import annotations

from typing import Any

import mujoco
import numpy as np

import labutils
from labutils.checks.table import Scene
from solutions._cases import make_scene_text
from solutions._model import Absorbed, Case, Exercise, Misconception, Part, asked, given
from solutions.completions.get_camera_intrinsics import COMPLETION


def _answer_with(
    mistakes: frozenset[str], model: Any, camera_name: str, width: int, height: int
) -> tuple[np.ndarray, float]:
    camera = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA, camera_name)
    if camera < 0 and "unknown-camera" not in mistakes:
        raise ValueError(camera_name)
    edge = 0 if "half-pixel" in mistakes else 1
    cx, cy = (width - edge) / 2, (height - edge) / 2
    sensor_x, sensor_y = model.cam_sensorsize[camera]
    if sensor_x > 0 and "sensor-ignored" not in mistakes:
        focal_x, focal_y, shift_x, shift_y = model.cam_intrinsic[camera]
        fx, fy = focal_x / sensor_x * width, focal_y / sensor_y * height
        sign = 1 if "principal-sign" in mistakes else -1
        cx, cy = cx + sign * shift_x / sensor_x * width, cy + sign * shift_y / sensor_y * height
        half = sensor_y / 2
        fov_y = np.arctan((half - shift_y) / focal_y) + np.arctan((half + shift_y) / focal_y)
        if "square-pixels" in mistakes:
            fx = fy
    else:
        fov_y = np.deg2rad(model.cam_fovy[camera])
        in_tangent = np.rad2deg(fov_y) if "tangent-of-degrees" in mistakes else fov_y
        fx = fy = height / 2 / np.tan(in_tangent / 2)
    K = np.array([[fx, 0.0, cx], [0.0, fy, cy], [0.0, 0.0, 1.0]])
    return K, float(np.rad2deg(fov_y) if "degrees-returned" in mistakes else fov_y)


def _make_cases(rng: np.random.Generator) -> tuple[Case, ...]:
    def scene() -> Scene:
        return Scene(make_scene_text(rng))

    def size() -> tuple[int, int]:
        return int(rng.integers(300, 900)), int(rng.integers(60, 250))

    return (
        Case("a camera given by its field of view", (scene(), "head_camera", *size())),
        Case("another camera of the same kind", (scene(), "side_camera", *size())),
        Case("one column of it", (scene(), "side_camera", 1, int(rng.integers(60, 250)))),
        Case("a camera given by its sensor", (scene(), "sensor_camera", *size())),
        Case("a camera that does not exist", (scene(), "tail_camera", *size()), "ValueError"),
    )


EXERCISE = Exercise(
    name="get_camera_intrinsics",
    title="compute K of a camera of the model",
    chapter="step2",
    place=2,
    points=8,
    section="step2-sensor",
    objectives=("2c", "2d"),
    reference=labutils.get_camera_intrinsics,
    answer_with=_answer_with,
    parts=(
        Part("K", "matrix", "float", atol=1e-3, unit="px"),
        # A ten-thousandth of a radian moves the edge of a 900-pixel picture by less than 0.1 px.
        Part("fov_y", "number", "float", atol=1e-4, unit="rad"),
    ),
    tolerance_reason=(
        "as for intrinsics_matrix: ten times the rounding of float32, far below half a pixel; the "
        "angle likewise"
    ),
    misconceptions=(
        Misconception(
            "half-pixel",
            "your center is W/2 and H/2. Pixel centers are whole numbers, from 0 to W-1: their "
            "middle lies half a pixel before W/2.",
            section="step2-center",
        ),
        Misconception(
            "tangent-of-degrees",
            "model.cam_fovy is in degrees, and np.tan takes radians. Convert before you take the "
            "tangent.",
            section="step2-focal",
        ),
        Misconception(
            "degrees-returned",
            "K is right, but the angle you return is in degrees. fov_y is in radians everywhere "
            "in this book.",
        ),
        Misconception(
            "sensor-ignored",
            "a camera with a sensor size has focal lengths and a principal point of its own, in "
            "model.cam_intrinsic; cam_fovy alone does not tell them.",
        ),
        Misconception(
            "principal-sign",
            "the principal point of a sensor camera moves your center the wrong way. Subtract "
            "the shift: check with a render which way the picture moves.",
        ),
        Misconception(
            "square-pixels",
            "you use one focal length for both axes. A sensor camera is stretched to the picture, "
            "so fx = focal_x / sensor_x * W has its own value.",
        ),
        Misconception(
            "unknown-camera",
            "mj_name2id answers -1 for an unknown name, and index -1 is the last camera. Raise "
            "ValueError instead of answering for another camera.",
        ),
    ),
    hints=(
        (
            "Find the camera's number by its name first. What do you get for a name that does not "
            "exist, and what does an array do with such an index?"
        ),
        (
            "Two kinds of cameras exist. model.cam_sensorsize is zero for those that are given by "
            "cam_fovy, which is in degrees."
        ),
        (
            "For a sensor camera, a length on the sensor divided by the sensor's size is a share "
            "of the picture: times W or H it is in pixels."
        ),
    ),
    example="""\
K_sensor, angle = get_camera_intrinsics(model, "sensor_camera", 640, 480)
show(K_sensor, "K of the sensor camera, in pixels")
print(f"It sees {np.degrees(angle):.1f} degrees from top to bottom.")
show(lab.render_camera(model, data, renderer, "sensor_camera")[0])""",
    contract=(
        asked(
            "by-name", "comes from a MuJoCo model, by name", "case another camera of the same kind"
        ),
        asked(
            "degrees-inside",
            "which the model holds in degrees",
            "mistake tangent-of-degrees",
            "case a camera given by its field",
        ),
        asked(
            "data-sheet",
            "like a real camera on a data sheet",
            "mistake sensor-ignored",
            "mistake principal-sign",
        ),
        asked(
            "any-size",
            "The picture may have any size",
            "case one column of it",
            "mistake half-pixel",
        ),
        asked("compute", "Compute the intrinsic matrix", "every case"),
        asked(
            "stretched",
            "is stretched to the picture: its own",
            "mistake square-pixels",
            "case a camera given by its sensor",
        ),
        given("scene", "The compiled scene"),
        given("camera-name", "Name of a camera of the model"),
        given("size", "Picture size in pixels"),
        asked("pixels", "Pixels.", "value of K"),
        asked("angle", "the angle between the rays", "mistake degrees-returned", "value of fov_y"),
        asked("raises", "Raises: ValueError", "case a camera that does not exist"),
        asked(
            "raises-when",
            "If the model has no such camera",
            "case a camera that does not exist",
            "mistake unknown-camera",
        ),
    ),
    visible=lambda: _make_cases(np.random.default_rng(21)),
    hidden=_make_cases,
    imports=("import mujoco", "import numpy as np"),
    asks={
        "camera_name": "str\nName of a camera of the model.",
        "Returns": (
            "K : ndarray, float, shape (3, 3)\n"
            "    Pixels.\n"
            "fov_y : float\n"
            "    Vertical field of view in radians: the angle between the rays through the upper "
            "and the lower edge of the picture."
        ),
        "Raises": "ValueError\n    If the model has no such camera.",
    },
    absorbed=(
        Absorbed("sensor-ignored", "principal-sign", "without the sensor there is no shift"),
        Absorbed("sensor-ignored", "square-pixels", "cam_fovy gives square pixels anyway"),
    ),
    completion=COMPLETION,
)
