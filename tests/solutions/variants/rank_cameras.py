"""Right answers to rank_cameras, written in ways that the card does not contain."""

import cv2
import mujoco
import numpy as np


def rank_by_loop(
    model: mujoco.MjModel, data: mujoco.MjData, point_world: np.ndarray
) -> tuple[list[int], list[float]]:
    mujoco.mj_kinematics(model, data)
    mujoco.mj_comPos(model, data)
    mujoco.mj_camlight(model, data)
    pairs = [
        (sum((a - b) ** 2 for a, b in zip(place, point_world, strict=True)) ** 0.5, number)
        for number, place in enumerate(data.cam_xpos)
    ]
    return [number for _, number in sorted(pairs)], [distance for distance, _ in sorted(pairs)]


def rank_by_view(
    model: mujoco.MjModel, data: mujoco.MjData, point_world: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    mujoco.mj_forward(model, data)
    views = [data.camera(n) for n in range(model.ncam)]
    gaps = [cv2.norm(view.xpos - point_world) for view in views]
    views.sort(key=lambda view: gaps[view.id])
    ids = np.array([view.id for view in views], np.int32)
    return ids, np.array([gaps[n] for n in ids], np.float32)


def rank_as_tuples(
    model: mujoco.MjModel, data: mujoco.MjData, point_world: np.ndarray
) -> tuple[tuple[int, ...], tuple[float, ...]]:
    ids, distances = rank_by_loop(model, data, point_world)
    return tuple(ids), tuple(distances)


VARIANTS = [rank_by_loop, rank_by_view, rank_as_tuples]
