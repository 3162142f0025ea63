"""Right answers to rank_cameras, as strangers wrote them."""
import copy
import math

import mujoco
import numpy as np


def f1(model, data, point_world):
    mujoco.mj_forward(model, data)
    distances = np.linalg.norm(data.cam_xpos - point_world, axis=1)
    ids = np.argsort(distances)
    return ids, distances[ids]


def f2(model, data, point_world):
    mujoco.mj_kinematics(model, data)
    mujoco.mj_comPos(model, data)
    mujoco.mj_camlight(model, data)
    pairs = []
    for i in range(model.ncam):
        x, y, z = data.cam_xpos[i]
        pairs.append((math.dist((x, y, z), point_world), i))
    pairs.sort()
    ids = np.array([i for _, i in pairs], dtype=int)
    distances = np.array([d for d, _ in pairs], dtype=float)
    return ids, distances


def f3(model, data, point_world):
    now = copy.copy(data)
    mujoco.mj_fwdPosition(model, now)
    off = now.cam_xpos - np.asarray(point_world)[None]
    squared = np.einsum("ij,ij->i", off, off)
    ids = squared.argsort(kind="stable").astype(np.int32)
    return ids, np.sqrt(squared[ids])


def f4(model, data, point_world):
    mujoco.mj_forward(model, data)
    table = {i: float(np.hypot(np.hypot(*(data.cam(i).xpos - point_world)[:2]), data.cam(i).xpos[2] - point_world[2]))
             for i in range(model.ncam)}
    order = sorted(table, key=table.get)
    return np.array(order, dtype=np.int64), np.array([table[i] for i in order])


class CameraRanking:
    def __init__(self, model, data):
        self.data = mujoco.MjData(model)
        spec = mujoco.mjtState.mjSTATE_INTEGRATION
        state = np.empty(mujoco.mj_stateSize(model, spec))
        mujoco.mj_getState(model, data, state, spec)
        mujoco.mj_setState(model, self.data, state, spec)
        mujoco.mj_forward(model, self.data)
        self.model = model

    def rank(self, point):
        point = np.asarray(point, dtype=float)
        if point.shape != (3,):
            raise ValueError("point must be (3,)")
        d = np.sqrt(((self.data.cam_xpos - point) ** 2).sum(axis=1))
        order = np.lexsort((np.arange(len(d)), d))
        return order, d[order]


def f5(model, data, point_world):
    return CameraRanking(model, data).rank(point_world)


def f6(model, data, point_world):
    mujoco.mj_forward(model, data)
    rows = np.zeros(model.ncam, dtype=[("d", "f8"), ("i", "i4")])
    for n in range(model.ncam):
        rows[n] = np.linalg.norm(point_world - data.camera(n).xpos), n
    rows.sort(order="d")
    return rows["i"], rows["d"]


# float32
def f7(model, data, point_world):
    mujoco.mj_forward(model, data)
    d = np.linalg.norm(data.cam_xpos.astype(np.float32) - point_world.astype(np.float32), axis=1)
    ids = np.argsort(d)
    return ids, d[ids]


ANSWERS = [f1, f2, f3, f4, f5, f6, f7]
