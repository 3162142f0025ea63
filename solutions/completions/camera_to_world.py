"""Step 5: the way back, from the world to a body."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from solutions._completion import Case, Completion, Part, Slip

if TYPE_CHECKING:
    import numpy as np


def world_to_body(points: np.ndarray, position: np.ndarray, rotation: np.ndarray) -> np.ndarray:
    """Bring points of the world into the frame of a body.

    Parameters
    ----------
    points : ndarray, float64, shape (N, 3)
        Points in the world, one per row, meters.
    position : ndarray, float64, shape (3,)
        Where the body is in the world, meters.
    rotation : ndarray, float64, shape (3, 3)
        Its columns are the axes of the body, in the world.

    Returns
    -------
    ndarray, float, shape (N, 3)
        The same points, as the body sees them, meters.
    """
    moved = points - position  # open: as seen from the position of the body
    turned = moved @ rotation  # open: turned back into its axes; points are rows
    return turned


def _choose(cases: tuple[Case, ...]) -> tuple[Case, ...]:
    chosen = []
    for label, case in zip(("five points", "forty points"), cases[:2], strict=True):
        points, position, rotation = case.args
        args = (points, position, rotation.reshape(3, 3))
        chosen.append(replace(case, label=label, args=args))
    return tuple(chosen)


COMPLETION = Completion(
    title="from the world to a body",
    statement="The ball of the worked example lies somewhere in the world, and the robot asks "
    "where it is as seen from itself. That is the way back: first the position is taken away, "
    "then the rotation is undone.",
    section="step5-worked-turn",
    twin=world_to_body,
    parts=(Part("points", "rows", "float", atol=1e-4, unit="m"),),
    cases=_choose,
    slips=(
        Slip(
            "added",
            "the position was added, as on the way into the world. On the way back it is taken "
            "away: the body itself has to land at (0, 0, 0).",
            line="moved = points + position",
        ),
        Slip(
            "turned-on",
            "the points were turned on instead of back. For points in rows, @ rotation.T turns "
            "into the world; the other one of the two turns back.",
            line="turned = moved @ rotation.T",
        ),
    ),
    example="""\
eye, ball = data.camera("head_camera"), data.body("red_ball")
axes = eye.xmat.reshape(3, 3)  # MuJoCo's: y up, looking along -z
print(world_to_body(ball.xpos[None], eye.xpos, axes).round(2), "m")""",
)
