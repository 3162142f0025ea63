"""What a picture by rays leaves out of a model that OpenGL would draw."""

from __future__ import annotations

import warnings

import mujoco
import numpy as np


class NotDrawnWarning(UserWarning):
    """The ray caster leaves out parts of a model that OpenGL draws."""


#: Models that were spoken of, by what they are: their names and what is left out of them.
_told: set[tuple[bytes, str]] = set()


def list_omissions(
    model: mujoco.MjModel, scene_option: mujoco.MjvOption | None = None
) -> list[str]:
    """List what rays pass through and OpenGL draws, such as "2 tendons".

    Parameters
    ----------
    model : mujoco.MjModel
        The compiled scene.
    scene_option : mujoco.MjvOption, optional
        What is drawn; MuJoCo's default without it.

    Returns
    -------
    list of str
        Empty where rays see all that is drawn.
    """
    option = mujoco.MjvOption() if scene_option is None else scene_option
    flags, kinds = option.flags, mujoco.mjtVisFlag
    # MuJoCo leaves out a site whose alpha is 0, and no other: robosuite hides sites by a negative
    # alpha, which no color picture shows, but every depth image. A tendon's alpha is never asked.
    visible_sites = _is_shown(model.site_group, option.sitegroup) & (model.site_rgba[:, 3] != 0)
    visible_tendons = _is_shown(model.tendon_group, option.tendongroup) & (model.tendon_width > 0)
    finders = model.sensor_type == int(mujoco.mjtSensor.mjSENS_RANGEFINDER)
    counts = {
        "site": visible_sites,
        "tendon": visible_tendons & bool(flags[kinds.mjVIS_TENDON]),
        "skin": _is_shown(model.skin_group, option.skingroup) & bool(flags[kinds.mjVIS_SKIN]),
        "flex": _is_shown(model.flex_group, option.flexgroup),
        "range-finder line": finders & bool(flags[kinds.mjVIS_RANGEFINDER]),
    }
    plurals = {"flex": "flexes"}
    return [
        f"{count} {name if count == 1 else plurals.get(name, name + 's')}"
        for name, marked in counts.items()
        if (count := int(np.count_nonzero(marked)))
    ]


def warn_once(model: mujoco.MjModel, stacklevel: int) -> None:
    """Say what rays leave out of a model, the first time only."""
    left_out = ", ".join(list_omissions(model))
    key = (bytes(model.names), left_out)
    if not left_out or key in _told:
        return
    _told.add(key)
    warnings.warn(
        f"the ray caster draws geoms only. OpenGL would also draw, of this model: {left_out}",
        NotDrawnWarning,
        stacklevel=stacklevel + 1,
    )


def _is_shown(groups: np.ndarray, shown: np.ndarray) -> np.ndarray:
    """Tell of every object whether its group is drawn."""
    return np.asarray(shown, dtype=bool)[np.clip(groups, 0, len(shown) - 1)]
