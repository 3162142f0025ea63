"""Step 3: what 16 bits a pixel keep of the depth, as whole numbers and as half floats."""

from __future__ import annotations

import numpy as np

import labutils as lab
from labutils.figures import plot_lines
from solutions._open_answers import Finding

CAMERA, WIDTH, HEIGHT = "head_camera", 320, 240
NEAR, FAR = 0.02, 12.0
LEVELS = 2**16 - 1
#: Name of a way to store: type, and whether the far plane is at 0.
WAYS = {
    "whole": (np.uint16, False),
    "whole, reversed": (np.uint16, True),
    "half float": (np.float16, False),
    "half float, reversed": (np.float16, True),
}


def measure_strong() -> Finding:
    """Store the true depths in four ways, read them back, and compare in millimeters."""
    z = _get_true_depths()
    errors_mm = {name: _store_and_read(z, NEAR, *how) for name, how in WAYS.items()}
    largest = {name: float(one.max()) for name, one in errors_mm.items()}
    farthest = float(z.max())
    slope = 1000 * farthest**2 * (FAR - NEAR) / (NEAR * FAR)  # mm per unit of the buffer
    shown = np.linspace(0.1, 11.9, 400)
    curves = {
        name: np.array([one.max() for one in np.split(_store_and_read(shown, NEAR, *how), 40)])
        for name, how in WAYS.items()
        if name != "whole, reversed"  # the same as in the usual order
    }
    return Finding(
        {
            "whole_mm": largest["whole"],
            "whole_reversed_mm": largest["whole, reversed"],
            "half_float_mm": largest["half float"],
            "half_float_reversed_mm": largest["half float, reversed"],
            "half_step_mm": slope / LEVELS / 2,
        },
        plot_lines(
            shown[::10], curves, x_label="depth (m)", y_label="largest error (mm)", log_y=True
        ),
    )


def measure_typical() -> Finding:
    """Move the near plane only."""
    z = _get_true_depths()
    planes = np.array([0.02, 0.05, 0.1, 0.2, 0.5])
    largest = np.array([_store_and_read(z, near, *WAYS["whole"]).max() for near in planes])
    return Finding(
        {"whole_mm": float(largest[0]), "half_meter_mm": float(largest[-1])},
        plot_lines(
            planes, {"whole": largest}, x_label="near plane (m)", y_label="largest error (mm)"
        ),
    )


def _get_true_depths() -> np.ndarray:
    model, data = lab.make_scene()
    truth = lab.raycast_depth(model, data, CAMERA, WIDTH, HEIGHT)
    return truth[np.isfinite(truth)].astype(float)


def _store_and_read(z: np.ndarray, near: float, kind: type, is_reversed: bool) -> np.ndarray:  # noqa: FBT001 - a row of WAYS
    """Return how far a depth is off after it was stored, millimeters."""
    d = FAR / (FAR - near) * (1 - near / z)
    stored = 1 - d if is_reversed else d
    if kind is np.uint16:
        back = np.round(stored * LEVELS) / LEVELS
    else:
        back = stored.astype(kind).astype(float)
    d = 1 - back if is_reversed else back
    return 1000 * np.abs(near * FAR / (FAR - d * (FAR - near)) - z)
