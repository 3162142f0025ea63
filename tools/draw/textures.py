"""Draw the textures of the scene: wood, plaster, floor tiles and the sky.

The pictures in ``assets/textures`` are drawn from seeded noise, so that running
this script again writes the same bytes. Wood, plaster and tiles hold *detail*
only (close to white): the color itself is the material's ``rgba`` in the scene
file. A renderer that ignores textures therefore still shows the right color.

Run it as ``python -m tools.draw.textures``.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import cv2
import numpy as np

from labutils.room.textures import make_noise
from tools import ROOT

if TYPE_CHECKING:
    from pathlib import Path

TEXTURES = ROOT / "assets" / "textures"


def make_wood(size: int = 512, planks: int = 6) -> np.ndarray:
    """Return planks with grain along the columns, as RGB floats in 0..1."""
    rng = np.random.default_rng(11)
    grain = 0.55 * make_noise(rng, size, 70.0, 1.1) + 0.45 * make_noise(rng, size, 120.0, 4.0)
    fibers = make_noise(rng, size, 14.0, 0.5)
    # Growth rings: a slow field read through a sine gives the long, closed arches.
    field = make_noise(rng, size, 150.0, 16.0)
    rings = np.sin(2.0 * np.pi * 1.6 * field)
    rows = np.arange(size)
    plank = rows * planks // size
    # Every plank is cut from another place of the trunk and has its own tone.
    shifts = rng.integers(0, size, planks)
    tones = rng.normal(0.0, 0.022, planks)
    light = np.empty((size, size))
    for index in range(planks):
        inside = plank == index
        pattern = 0.022 * grain + 0.007 * fibers + 0.014 * rings
        light[inside] = 0.915 + tones[index] + np.roll(pattern, shifts[index], axis=1)[inside]
    seam = (rows * planks) % size < planks * 1.2
    light[seam] *= 0.86
    light = np.clip(light, 0.0, 1.0)
    # Dark grain is a little warmer than light grain.
    return np.stack([light**0.85, light, light**1.18], axis=-1)


def make_plaster(size: int = 256) -> np.ndarray:
    """Return fine plaster as RGB floats in 0..1."""
    rng = np.random.default_rng(12)
    height = 0.6 * make_noise(rng, size, 5.0, 5.0) + 0.4 * make_noise(rng, size, 1.4, 1.4)
    # Plaster is seen by its relief: light falls from the upper left.
    relief = height - np.roll(height, (2, 2), axis=(0, 1))
    # No slow variation: it would show the seams between the parts of the wall.
    light = np.clip(0.965 + 0.007 * relief, 0.0, 1.0)
    return np.repeat(light[..., None], 3, axis=-1)


def make_tiles(size: int = 512, tiles: int = 4) -> np.ndarray:
    """Return square floor tiles with thin joints as RGB floats in 0..1."""
    rng = np.random.default_rng(13)
    cell = size // tiles
    tones = rng.normal(0.0, 0.012, (tiles, tiles))
    light = 0.94 + np.kron(tones, np.ones((cell, cell)))
    light += 0.010 * make_noise(rng, size, 12.0, 12.0) + 0.006 * make_noise(rng, size, 1.0, 1.0)
    joint = np.minimum(np.arange(size) % cell, cell - 1 - np.arange(size) % cell) < 2
    light[joint, :] = 0.80
    light[:, joint] = 0.80
    return np.repeat(np.clip(light, 0.0, 1.0)[..., None], 3, axis=-1)


def make_sky(size: int = 256) -> np.ndarray:
    """Return one side of the sky: pale at and below the horizon, blue above."""
    rng = np.random.default_rng(14)
    # Elevation of each row as seen from the middle of the cube.
    elevation = np.arctan(1.0 - (np.arange(size) + 0.5) * 2.0 / size)
    knots = np.radians([-45.0, -16.0, -2.0, 12.0, 45.0])
    colors = np.array(
        [[176, 203, 226], [190, 213, 232], [224, 232, 236], [190, 214, 235], [128, 175, 220]]
    )
    column = np.stack([np.interp(elevation, knots, colors[:, i]) for i in range(3)], axis=-1)
    sky = np.repeat(column[:, None, :], size, axis=1) / 255.0
    clouds = make_noise(rng, size, 26.0, 5.0) + 0.5 * make_noise(rng, size, 9.0, 3.0)
    cover = np.clip((clouds - 0.5) / 1.8, 0.0, 0.7)
    # Clouds fade out at the upper and lower edge, where the sides meet the caps.
    cover *= np.clip(np.cos(elevation * 2.0), 0.0, 1.0)[:, None]
    return sky + cover[..., None] * (np.array([1.0, 0.995, 0.985]) - sky)


def save_texture(rgb: np.ndarray, name: str) -> Path:
    """Write RGB floats in 0..1 as an 8-bit PNG and return its path."""
    path = TEXTURES / f"{name}.png"
    rgb_u8 = np.round(np.clip(rgb, 0.0, 1.0) * 255).astype(np.uint8)
    picture_bgr = cv2.cvtColor(rgb_u8, cv2.COLOR_RGB2BGR)
    if not cv2.imwrite(str(path), picture_bgr, [cv2.IMWRITE_PNG_COMPRESSION, 9]):
        raise OSError(f"cannot write {path}")
    return path


def main() -> None:
    """Write every texture of the scene."""
    TEXTURES.mkdir(parents=True, exist_ok=True)
    sky = make_sky()
    cap = np.ones_like(sky)
    textures = {
        "wood": make_wood(),
        "plaster": make_plaster(),
        "tiles": make_tiles(),
        "sky_side": sky,
        "sky_up": cap * sky[0].mean(axis=0),
        "sky_down": cap * sky[-1].mean(axis=0),
    }
    for name, rgb in textures.items():
        path = save_texture(rgb, name)
        print(f"{path.name}: {rgb.shape[1]} x {rgb.shape[0]}, {path.stat().st_size / 1024:.0f} KiB")


if __name__ == "__main__":
    main()
