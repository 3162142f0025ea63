"""Step 2: how wide the view of a camera is, from its lengths."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from solutions._completion import Case, Completion, Part, Slip


def get_view_width(model: Any, camera_name: str, distance: float) -> float:
    """Tell how many meters wide the view of a camera is.

    Parameters
    ----------
    model : mujoco.MjModel
        A model that gives this camera by its sensor.
    camera_name : str
        Name of the camera.
    distance : float
        How far ahead, meters.

    Returns
    -------
    float
        From the left edge of the view to the right one, meters.
    """
    camera = model.camera(camera_name).id  # open: the number of this camera
    sensor_x = model.cam_sensorsize[camera, 0]  # meters
    focal_x = model.cam_intrinsic[camera, 0]  # meters
    view = sensor_x / focal_x * distance  # open: view : distance = sensor : focal length
    return view


def _choose(cases: tuple[Case, ...]) -> tuple[Case, ...]:
    return tuple(
        replace(
            case,
            label=f"{distance} m in front of a camera given by its sensor",
            args=(case.args[0], "sensor_camera", distance),
        )
        for distance, case in zip((0.5, 1.5, 3.0), cases[:3], strict=True)
    )


COMPLETION = Completion(
    title="how wide is the view?",
    statement="A data sheet gives lengths: the width of the sensor and the focal length. The "
    "sensor behind the lens and the view before it are two triangles with the same angle, so one "
    "ratio serves both.",
    section="step2-worked-sensor",
    twin=get_view_width,
    parts=(Part("view", "number", "float", atol=1e-4, unit="m"),),
    cases=_choose,
    slips=(
        Slip(
            "another-camera",
            "this is always the first camera of the model. Ask the model for the camera of this "
            "name; its id is the row in cam_sensorsize.",
            line="camera = 0",
        ),
        Slip(
            "turned-over",
            "the ratio stands on its head: with a longer lens your view gets wider. A longer lens "
            "sees less, so divide by the focal length.",
            line="view = focal_x / sensor_x * distance",
        ),
    ),
    example="""\
for distance in (0.5, 1.0, 2.0):
    width = get_view_width(model, "sensor_camera", distance)
    print(f"at {distance} m the view is {width:.2f} m wide")""",
    imports=(),
)
