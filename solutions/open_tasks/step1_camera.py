"""Step 1: a picture that lies, and what a single number says of it."""

from __future__ import annotations

from typing import TYPE_CHECKING

import mujoco
import numpy as np

import labutils as lab
from labutils.figures import plot_images
from solutions._open_answers import Finding

if TYPE_CHECKING:
    from numpy.typing import NDArray

CAMERA, WIDTH, HEIGHT = "head_camera", 320, 240
OFF_MM = 10.0  # a hand that is off by more misses


def measure_strong() -> Finding:
    """Compare an old picture with the truth of now, body by body, for a pan and for a tilt."""
    error_mm, bodies, model = _turn_after_the_picture("neck_pan")
    tilted_mm, tilted_bodies, _ = _turn_after_the_picture("neck_tilt")
    wall, table = (model.body(name).id for name in ("wall", "table"))
    return Finding(
        {
            "off_share": _get_share_off(error_mm),
            "median_mm": float(np.nanmedian(error_mm)),
            "wall": _get_share_off(error_mm[bodies == wall]),
            "table": _get_share_off(error_mm[bodies == table]),
            "table_tilted": _get_share_off(tilted_mm[tilted_bodies == table]),
        },
        plot_images(
            {
                "pan: off by more than 1 cm": error_mm > OFF_MM,
                "tilt: off by more than 1 cm": tilted_mm > OFF_MM,
            }
        ),
    )


def measure_typical() -> Finding:
    """Sum the same error up in one number, and look at color only."""
    error_mm, _, _ = _turn_after_the_picture("neck_pan")
    model, data = lab.make_scene()
    with lab.make_renderer(model, HEIGHT, WIDTH) as renderer:
        before, _ = lab.render_camera(model, data, renderer, CAMERA)
        data.joint("neck_pan").qpos = 0.02
        after, _ = lab.render_camera(model, data, renderer, CAMERA)
    return Finding(
        {"median_mm": float(np.nanmedian(error_mm)), "off_share": _get_share_off(error_mm)},
        plot_images({"before": before, "after": after}),
    )


def _turn_after_the_picture(joint: str) -> tuple[NDArray[np.float64], np.ndarray, mujoco.MjModel]:
    """Return the error of an old depth image in mm, NaN where nothing is, and the bodies of now."""
    model, data = lab.make_scene()
    with lab.make_renderer(model, HEIGHT, WIDTH) as renderer:
        _, old = lab.render_camera(model, data, renderer, CAMERA)
        data.joint(joint).qpos = data.joint(joint).qpos + 0.02
        mujoco.mj_forward(model, data)
        bodies = lab.render_segmentation(model, data, renderer, CAMERA)
    truth = lab.raycast_depth(model, data, CAMERA, WIDTH, HEIGHT)
    known = lab.find_valid_depth(old) & lab.find_valid_depth(truth)
    return np.where(known, 1000 * np.abs(old - truth), np.nan), bodies, model


def _get_share_off(error_mm: np.ndarray) -> float:
    """Return the share of the known pixels that are off by more than a hand may be, percent."""
    known = error_mm[np.isfinite(error_mm)]
    return float(100 * np.mean(known > OFF_MM))
