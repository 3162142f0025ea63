"""Step 6: where a second camera helps, and a picture size that looks like occlusion."""

from __future__ import annotations

import mujoco
import numpy as np

import labutils as lab
from labutils.figures import plot_images
from solutions._open_answers import Finding

#: Squares of 1 cm of the table, from here on.
CORNER, COUNT = np.array([0.7, -0.4]), np.array([60, 80])

NAMES = ("head_camera", "overview")


def measure_strong() -> Finding:
    """Compare two second cameras, and part what is hidden from what is covered."""
    model, data = lab.make_scene()
    names = ("head_camera", "left_eye", "overview")
    head, eye, corner = (_get_world_cloud(model, data, name, 640, 480) for name in names)
    alone = _find_missed(model, data, head)
    with_eye = _find_missed(model, data, np.concatenate([head, eye]))
    with_corner = _find_missed(model, data, np.concatenate([head, corner]))
    covered = _find_covered(model, data)
    large = [_get_world_cloud(model, data, names[i], 1280, 960) for i in (0, 2)]
    return Finding(
        {
            "alone": 100 * float(alone.mean()),
            "with_eye": 100 * float(with_eye.mean()),
            "with_corner": 100 * float(with_corner.mean()),
            "large_with_corner": 100
            * float(_find_missed(model, data, np.concatenate(large)).mean()),
            "open_alone": 100 * float((alone & ~covered).mean()),
            "open_with_corner": 100 * float((with_corner & ~covered).mean()),
        },
        plot_images(
            {
                "head camera": _to_map(alone),
                "and left eye": _to_map(with_eye),
                "and overview": _to_map(with_corner),
            }
        ),
    )


def measure_typical() -> Finding:
    """Take small pictures, and call everything that is missing hidden."""
    model, data = lab.make_scene()
    clouds = [_get_world_cloud(model, data, name, 320, 240) for name in NAMES]
    alone = _find_missed(model, data, clouds[0])
    both = _find_missed(model, data, np.concatenate(clouds))
    larger = [_get_world_cloud(model, data, name, 640, 480) for name in NAMES]
    return Finding(
        {
            "alone": 100 * float(alone.mean()),
            "both": 100 * float(both.mean()),
            "both_larger": 100 * float(_find_missed(model, data, np.concatenate(larger)).mean()),
        },
        plot_images({"one camera": _to_map(alone), "two cameras": _to_map(both)}),
    )


def _get_world_cloud(
    model: mujoco.MjModel, data: mujoco.MjData, name: str, width: int, height: int
) -> np.ndarray:
    with lab.make_renderer(model, height, width) as renderer:
        rgb, depth = lab.render_camera(model, data, renderer, name)
    K, _ = lab.get_camera_intrinsics(model, name, width, height)
    points, _ = lab.depth_to_pointcloud(depth, K, rgb)
    camera = data.camera(name)
    return lab.camera_to_world(points, camera.xpos, camera.xmat)


def _find_missed(model: mujoco.MjModel, data: mujoco.MjData, world: np.ndarray) -> np.ndarray:
    """Mark the squares of the table that hold no point of its top."""
    top = data.geom("table_top").xpos[2] + model.geom("table_top").size[2]
    on_table = world[np.abs(world[:, 2] - top) < 0.002]
    squares = np.floor((on_table[:, :2] - CORNER) / 0.01).astype(int)
    inside = ((squares >= 0) & (squares < COUNT)).all(axis=1)
    missed = np.ones(COUNT, dtype=bool)
    missed[tuple(squares[inside].T)] = False
    return missed


def _find_covered(model: mujoco.MjModel, data: mujoco.MjData) -> np.ndarray:
    """Mark the squares on whose middle an object stands: a ray from above tells."""
    covered, hit = np.zeros(COUNT, dtype=bool), np.zeros(1, np.int32)
    for square in np.ndindex(*COUNT):
        above = np.append(CORNER + (np.array(square) + 0.5) * 0.01, 2.0)
        mujoco.mj_ray(model, data, above, np.array([0, 0, -1.0]), None, 1, -1, hit)
        covered[square] = model.geom_bodyid[hit[0]] != model.body("table").id
    return covered


def _to_map(missed: np.ndarray) -> np.ndarray:
    """Draw squares as seen by the robot: far ones on top, its left to the left."""
    return np.kron(missed[::-1, ::-1], np.ones((4, 4), dtype=bool))
