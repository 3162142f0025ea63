"""Right answers to camera_to_world, written in ways that the card does not contain."""

import numpy as np


def world_by_homogeneous(
    points: np.ndarray, cam_xpos: np.ndarray, cam_xmat: np.ndarray
) -> np.ndarray:
    T = np.eye(4)
    T[:3, :3] = np.reshape(cam_xmat, (3, 3)) * [1, -1, -1]
    T[:3, 3] = cam_xpos
    return (np.c_[points, np.ones(len(points))] @ T.T)[:, :3]


def world_in_single_precision(
    points: np.ndarray, cam_xpos: np.ndarray, cam_xmat: np.ndarray
) -> np.ndarray:
    rotation = np.asarray(cam_xmat, np.float32).reshape(3, 3)
    turned = np.asarray(points, np.float32) * np.array([1, -1, -1], np.float32)
    return np.einsum("ij,nj->ni", rotation, turned) + cam_xpos.astype(np.float32)


def world_as_lists(points: np.ndarray, cam_xpos: np.ndarray, cam_xmat: np.ndarray) -> np.ndarray:
    return world_by_homogeneous(points, cam_xpos, cam_xmat).reshape(-1, 3)


VARIANTS = [world_by_homogeneous, world_in_single_precision, world_as_lists]
