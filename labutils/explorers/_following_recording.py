"""A run that is kept with its pictures: what stands where no Python runs."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import cv2
import numpy as np

from labutils._guards import check_rgb_image
from labutils.explorers._following_run import FollowingRun, describe_problem
from labutils.following.loop import DT

if TYPE_CHECKING:
    from labutils.explorers._following_run import FollowingSettings
    from labutils.following.loop import Control

EYE, OUTSIDE = 0, 1
#: A page carries it: every second picture of the eye, every fourth of the other, and pictures
#: that lose a little.
_EVERY = (2, 4)
_FORMAT, _QUALITY = ".webp", [cv2.IMWRITE_WEBP_QUALITY, 60]
#: When the ball is hidden, as a share of the recording.
_HIDDEN = (0.45, 0.45 + 0.8 / 6)


class FollowingRecording(NamedTuple):
    """Columns of what was true, pictures one behind the other, and what went wrong, if anything.

    `places` says of each picture to which moment it belongs, whether it is of the `EYE` or from
    `OUTSIDE`, at which byte it starts, and how many it has.
    """

    moments: dict[str, list[Any]]
    pictures: bytes
    places: list[list[int]]
    problem: dict[str, Any]


def record_following(
    control: Control, settings: FollowingSettings, seconds: float, **options: Any
) -> FollowingRecording:
    """Run a controller for so many seconds, and keep what it did.

    Parameters
    ----------
    control, settings, options
        As `FollowingRun` takes them.
    seconds : float
        How long; no longer where `control` raises an exception.
    """
    start, end = (seconds * share for share in _HIDDEN)
    run = FollowingRun(control, settings, hidden=[(start, end)], **options)
    pictures: list[bytes] = []
    places: list[list[int]] = []
    problem: dict[str, Any] = {}
    for step in range(round(seconds / DT)):
        outside = run.draw_outside() if step % _EVERY[OUTSIDE] == 0 else None
        try:
            run.step()
        except Exception as error:  # noqa: BLE001 - the reader's own code may raise anything
            problem = describe_problem(error, control, run.loop.time)
            break
        for which, picture in ((EYE, run.draw_eye()), (OUTSIDE, outside)):
            if picture is None or step % _EVERY[which]:
                continue
            content = encode_picture(picture, _FORMAT, _QUALITY)
            places.append([step, which, sum(map(len, pictures)), len(content)])
            pictures.append(content)
    return FollowingRecording(
        _forget_machine(to_columns(run.moments)), b"".join(pictures), places, problem
    )


def _forget_machine(columns: dict[str, list[Any]]) -> dict[str, list[Any]]:
    """Leave out how long this machine took: a recording is the same on all."""
    return {
        name: [None] * len(values) if name in ("render_ms", "control_ms") else values
        for name, values in columns.items()
    }


def to_columns(moments: list[dict[str, Any]]) -> dict[str, list[Any]]:
    """Turn a list of records into a record of lists."""
    return {name: [one[name] for one in moments] for name in (moments[0] if moments else ())}


def to_moments(columns: dict[str, list[Any]]) -> list[dict[str, Any]]:
    """Turn a record of lists into a list of records."""
    rows = zip(*columns.values(), strict=True)
    return [dict(zip(columns, row, strict=True)) for row in rows]


def encode_picture(rgb_image: np.ndarray, ending: str, quality: list[int]) -> bytes:
    """Compress a uint8 RGB picture into a few kilobytes."""
    bgr = cv2.cvtColor(check_rgb_image("rgb_image", rgb_image), cv2.COLOR_RGB2BGR)
    done, content = cv2.imencode(ending, bgr, quality)
    if not done:
        raise ValueError(f"rgb_image: expected a picture that {ending} can hold")
    return content.tobytes()


def decode_picture(content: bytes) -> np.ndarray:
    """Read back what `encode_picture` wrote: uint8 RGB (H, W, 3)."""
    bgr = cv2.imdecode(np.frombuffer(content, np.uint8), cv2.IMREAD_COLOR)
    if bgr is None:
        raise ValueError(f"picture: expected the bytes of one, got {len(content)} others")
    return cv2.cvtColor(bgr, cv2.COLOR_BGR2RGB)
