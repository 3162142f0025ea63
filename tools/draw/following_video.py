"""Film the head that follows the ball: from outside, and through its own eye.

Two files in ``book/_static``: ``following.webm`` and its poster ``following.webp``, one frame that
stands for it on paper and in notebooks. The controller is that of the page. License: CC BY 4.0,
as all pictures of the book.

Run it as ``python -m tools.draw.following_video``.
"""

from __future__ import annotations

import cv2
import mujoco
import numpy as np
from PIL import Image

from labutils import make_renderer, render_camera
from labutils.following import FollowingLoop
from tools import ROOT
from tools.draw.following_runs import load_controllers

VIDEO = ROOT / "book" / "_static" / "following.webm"
POSTER = VIDEO.with_suffix(".webp")
#: Of each of the two pictures, which stand side by side. OpenCV takes no wish for the bits per
#: frame, so small pictures, and one for two commands, keep the file small.
WIDTH, HEIGHT = 240, 180
SECONDS, SEED = 8.0, 3
COMMANDS_PER_FRAME, FRAMES_PER_SECOND = 2, 10
#: VP8 plays in all browsers; other than H.264 it is free, and OpenCV can write it.
CODEC = "VP80"
#: The frame that is shown before it plays: the ball is in the middle, the board still away.
POSTER_FRAME = 30
_CROSS_PX, _CROSS_COLOR = 12, (255, 255, 255)


def film() -> list[np.ndarray]:
    """Return the frames: uint8 RGB, the robot from outside on the left, its view on the right."""
    control = load_controllers()["predicting"]
    cameras = (make_outside_camera(), "head_camera")
    frames = []
    with (
        FollowingLoop(320, 240, seed=SEED) as loop,
        make_renderer(loop.model, HEIGHT, WIDTH) as renderer,
    ):
        for _ in range(round(SECONDS * FRAMES_PER_SECOND)):
            left, right = (
                render_camera(loop.model, loop.data, renderer, camera)[0] for camera in cameras
            )
            frames.append(np.hstack([left, mark_middle(right)]))
            for _ in range(COMMANDS_PER_FRAME):
                loop.step(control)
    return frames


def make_outside_camera() -> mujoco.MjvCamera:
    """Return a camera that looks from the side at the head and at all places of the ball."""
    camera = mujoco.MjvCamera()
    camera.lookat = (0.5, 0.0, 1.25)
    camera.distance, camera.azimuth, camera.elevation = 1.5, 138.0, -12.0
    return camera


def mark_middle(picture: np.ndarray) -> np.ndarray:
    """Draw a cross into the middle of a copy."""
    middle = ((WIDTH - 1) // 2, (HEIGHT - 1) // 2)
    marked = picture.copy()
    for color, thickness in (((0, 0, 0), 3), (_CROSS_COLOR, 1)):  # it stands out on any ground
        cv2.drawMarker(marked, middle, color, cv2.MARKER_CROSS, _CROSS_PX, thickness)
    return marked


def write(frames: list[np.ndarray]) -> None:
    """Write the video and its poster."""
    height, width = frames[0].shape[:2]
    codec = cv2.VideoWriter_fourcc(*CODEC)  # type: ignore[attr-defined]  # the stubs lack it
    writer = cv2.VideoWriter(str(VIDEO), codec, FRAMES_PER_SECOND, (width, height))
    if not writer.isOpened():
        raise RuntimeError(f"expected an OpenCV that can write {CODEC}, got none")
    for frame in frames:
        writer.write(cv2.cvtColor(frame, cv2.COLOR_RGB2BGR))
    writer.release()
    Image.fromarray(frames[POSTER_FRAME]).save(POSTER, "WEBP", quality=85, method=6)


def main() -> None:
    """Film, and say how large the files are."""
    write(film())
    for path in (VIDEO, POSTER):
        print(f"{path.name}: {path.stat().st_size / 1000:.1f} kB")


if __name__ == "__main__":
    main()
