"""Render the first screen of the book: the head camera's photo, and what lifts it into 3-D.

Two files. ``hero.webp`` is the photo. ``hero_data.js`` is what ``book/_hero`` makes a cloud of: the
same picture smaller, its depth as the depth buffer gives it, and for every pixel how far that is
off the truth by ray casting. The browser shows both distances; nothing is computed from the truth.

Run it as ``python -m tools.draw.hero``.
"""

from __future__ import annotations

import io
import json
from base64 import b64encode
from typing import TYPE_CHECKING, Any

import cv2
import numpy as np
from PIL import Image

from labutils import (
    get_camera_intrinsics,
    get_camera_pose,
    make_renderer,
    make_scene,
    render_camera,
)
from labutils.raycast import RaycastRenderer
from tools import ROOT

if TYPE_CHECKING:
    import mujoco

PHOTO = ROOT / "book" / "_static" / "hero.webp"
DATA = ROOT / "book" / "_static" / "hero_data.js"
CAMERA_NAME = "head_camera"
#: Twice as wide as high: photo, title and buttons fit on a laptop's screen together.
PHOTO_SIZE = (1280, 640)
CLOUD_SIZE = (640, 320)
#: Meters per step. 16 bits of depth reach 3.2 m, beyond all that is in sight but the sky.
DEPTH_STEP = 5e-5
ERROR_STEP = 2e-5
ERROR_ZERO = 32768  # as this is stored "no error": errors have a sign
#: What readers call the parts of the room, by the beginning of their names.
ROOM = {"wall_frame": "window frame", "wall_sill": "window sill", "wall": "wall"}
NOTHING = "nothing"


def render_picture(size: tuple[int, int]) -> tuple[np.ndarray, np.ndarray]:
    """Render color, uint8 (H, W, 3), and depth in meters, (H, W)."""
    model, data = make_scene()
    width, height = size
    return render_camera(model, data, make_renderer(model, height, width), CAMERA_NAME)


def measure_errors(depth: np.ndarray) -> tuple[np.ndarray, np.ndarray, list[str]]:
    """Compare depth with the truth, pixel by pixel.

    Returns
    -------
    errors : ndarray, float64, shape (H, W)
        Meters along the ray by which the distance is too long; NaN where nothing is hit.
    things : ndarray, uint8, shape (H, W)
        What each pixel sees: its place in `names`.
    names : list of str
        What can be seen; the first is nothing.
    """
    height, width = depth.shape
    model, data = make_scene()
    rays = RaycastRenderer(model, height, width)
    rays.update_scene(data, CAMERA_NAME)
    rays.enable_depth_rendering()
    truth = rays.render().astype(np.float64)
    rays.disable_depth_rendering()
    rays.enable_segmentation_rendering()
    geoms = rays.render()[..., 0]
    errors = (depth - truth) * measure_ray_lengths(get_matrix(model, width, height), depth.shape)
    errors[geoms < 0] = np.nan
    named = {geom: name_geom(model, geom) for geom in np.unique(geoms[geoms >= 0]).tolist()}
    names = [NOTHING, *dict.fromkeys(named.values())]
    things = np.zeros(depth.shape, np.uint8)
    for geom, name in named.items():
        things[geoms == geom] = names.index(name)
    return errors, things, names


def name_geom(model: mujoco.MjModel, geom: int) -> str:
    """Name what a geom belongs to, as a reader would."""
    name = model.geom(geom).name
    for beginning, said in ROOM.items():
        if name.startswith(beginning):
            return said
    body = model.body(model.geom(geom).bodyid[0]).name
    return (name if body == "world" else body).replace("_", " ")


def get_matrix(model: mujoco.MjModel, width: int, height: int) -> np.ndarray:
    """Return the intrinsic matrix of the head camera."""
    K, _ = get_camera_intrinsics(model, CAMERA_NAME, width, height)
    return K


def measure_ray_lengths(K: np.ndarray, shape: tuple[int, ...]) -> np.ndarray:
    """Return how long the ray of each pixel is where its depth is 1: (H, W)."""
    v, u = np.indices(shape[:2])
    x, y = (u - K[0, 2]) / K[0, 0], (v - K[1, 2]) / K[1, 1]
    return np.sqrt(x**2 + y**2 + 1)


def make_data() -> dict[str, Any]:
    """Return what the page has to know, ready for JSON."""
    width, height = CLOUD_SIZE
    rgb, depth = render_picture(CLOUD_SIZE)
    errors, things, names = measure_errors(depth)
    steps = np.round(depth / DEPTH_STEP)
    steps[(steps > np.iinfo(np.uint16).max) | (things == 0)] = 0
    offset = np.round(np.nan_to_num(errors) / ERROR_STEP) + ERROR_ZERO
    model, data = make_scene()
    return {
        "K": get_matrix(model, width, height).round(6).tolist(),
        "T_world_cam": get_camera_pose(model, data, CAMERA_NAME).round(9).tolist(),
        "depth_step": DEPTH_STEP,
        "error_step": ERROR_STEP,
        "error_zero": ERROR_ZERO,
        "names": names,
        "rgb_webp": encode_webp(rgb, 88),
        "depth_png": encode_png(steps.astype(np.uint16)),
        "error_png": encode_png(np.clip(offset, 0, 65535).astype(np.uint16)),
        "thing_png": encode_png(things),
    }


def encode_webp(rgb: np.ndarray, quality: int) -> str:
    """Compress a picture; what is lost nobody sees."""
    return b64encode(make_webp(rgb, quality)).decode()


def make_webp(rgb: np.ndarray, quality: int) -> bytes:
    """Return the bytes of a WebP file."""
    file = io.BytesIO()
    Image.fromarray(rgb).save(file, "WEBP", quality=quality, method=6)
    return file.getvalue()


def encode_png(values: np.ndarray) -> str:
    """Compress numbers without loss."""
    done, png = cv2.imencode(".png", values, [cv2.IMWRITE_PNG_COMPRESSION, 9])
    if not done:
        raise ValueError(f"values: expected what PNG can hold, got {values.dtype} {values.shape}")
    return b64encode(png.tobytes()).decode()


def write_data(data: dict[str, Any]) -> None:
    """Write the data as a script: a page that was opened from a file may load nothing else."""
    lines = [f"{key}: {json.dumps(value)}," for key, value in data.items()]
    text = "\n    ".join(lines)
    DATA.write_text(
        "// biome-ignore-all format: written by a tool\n"
        "// What the head camera sees on the first screen: written by tools/draw/hero.py.\n"
        f"window.cameraLab = {{\n  ...window.cameraLab,\n  heroData: {{\n    {text}\n  }},\n}};\n",
        encoding="utf-8",
    )


def main() -> None:
    """Write both files."""
    rgb, _ = render_picture(PHOTO_SIZE)
    PHOTO.write_bytes(make_webp(rgb, 85))
    write_data(make_data())
    for path in (PHOTO, DATA):
        print(f"{path.name}: {path.stat().st_size / 1000:.1f} kB")


if __name__ == "__main__":
    main()
