"""Load the scene of the book.

Taught in: step 1.
"""

from __future__ import annotations

from pathlib import Path

import mujoco

from labutils._versions import check_mujoco_version

check_mujoco_version(getattr(mujoco, "__version__", ""))

#: The scene of the book, beside the package in the repository.
SCENE_PATH = Path(__file__).resolve().parents[1] / "assets" / "humanoid-camera.xml"


def make_scene(keyframe: str = "home") -> tuple[mujoco.MjModel, mujoco.MjData]:
    """Load the humanoid at its table, posed and forwarded.

    Parameters
    ----------
    keyframe : str
        Name of the pose to start from.

    Returns
    -------
    model : mujoco.MjModel
        The compiled scene.
    data : mujoco.MjData
        Its state, after ``mj_forward``: every position is up to date.

    Raises
    ------
    FileNotFoundError
        If the scene file is not beside the package.
    ValueError
        If the scene has no keyframe of that name.
    """
    if not SCENE_PATH.is_file():
        raise FileNotFoundError(
            f"scene: expected {SCENE_PATH.name} in the folder assets/ beside labutils/, got "
            "nothing there; install labutils from a checkout (pip install -e .)"
        )
    model = mujoco.MjModel.from_xml_path(str(SCENE_PATH))
    data = mujoco.MjData(model)
    key_id = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_KEY, keyframe)
    if key_id < 0:
        known = ", ".join(model.key(i).name for i in range(model.nkey))
        raise ValueError(f"keyframe: expected one of {known}, got {keyframe!r}")
    mujoco.mj_resetDataKeyframe(model, data, key_id)
    mujoco.mj_forward(model, data)
    return model, data
