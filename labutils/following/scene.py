"""The scene of the book with a board that can hide the ball."""

from __future__ import annotations

import mujoco
import numpy as np

from labutils.scene import SCENE_PATH

BALL, BOARD, CAMERA = "red_ball", "board", "head_camera"
#: Half the sides of the board, in meters: thin along the line of sight.
BOARD_HALF_SIZE = (0.005, 0.13, 0.13)
#: Where it is when it hides nothing: under the floor.
PARKED = (0.6, 0.0, -1.0)
#: How far from the eye to the ball it hangs, as a share of the way.
_SHARE = 0.55


def make_following_scene() -> tuple[mujoco.MjModel, mujoco.MjData]:
    """Load the humanoid at its table, and a board that `hide_ball` puts before the ball.

    Returns
    -------
    model, data : mujoco.MjModel, mujoco.MjData
        The scene in its pose "home", forwarded.
    """
    spec = mujoco.MjSpec.from_file(str(SCENE_PATH))
    board = spec.worldbody.add_body(name=BOARD, mocap=True, pos=list(PARKED))
    board.add_geom(
        name=BOARD,
        type=mujoco.mjtGeom.mjGEOM_BOX,
        size=list(BOARD_HALF_SIZE),
        rgba=[0.76, 0.66, 0.52, 1.0],
        contype=0,
        conaffinity=0,
    )
    model = spec.compile()
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, model.key("home").id)
    park_board(model, data)
    mujoco.mj_forward(model, data)
    return model, data


def get_mocap_id(model: mujoco.MjModel, name: str) -> int:
    """Return the row of a mocap body in ``data.mocap_pos``."""
    return int(model.body_mocapid[model.body(name).id])


def park_board(model: mujoco.MjModel, data: mujoco.MjData) -> None:
    """Take the board out of sight."""
    data.mocap_pos[get_mocap_id(model, BOARD)] = PARKED


def hide_ball(model: mujoco.MjModel, data: mujoco.MjData) -> None:
    """Hold the board between the eye and the ball, upright and facing the eye."""
    eye = data.cam_xpos[model.camera(CAMERA).id]
    to_ball = data.mocap_pos[get_mocap_id(model, BALL)] - eye
    half = np.arctan2(to_ball[1], to_ball[0]) / 2
    board = get_mocap_id(model, BOARD)
    data.mocap_pos[board] = eye + _SHARE * to_ball
    data.mocap_quat[board] = (np.cos(half), 0.0, 0.0, np.sin(half))
