"""Right answers to rank_cameras, as strangers wrote them."""
import copy
import heapq
import math
from typing import NamedTuple

import mujoco
import numpy as np


# 1. copy, forward, argsort
def f1(model, data, point_world):
    own = copy.copy(data)
    mujoco.mj_forward(model, own)
    d = np.linalg.norm(own.cam_xpos - point_world, axis=1)
    ids = np.argsort(d, kind="stable")
    return ids, d[ids]


# 2. in place, mj_forward as in the chapter
def f2(model, data, point_world):
    mujoco.mj_forward(model, data)
    pairs = []
    for i in range(model.ncam):
        x, y, z = data.cam_xpos[i]
        dist = math.sqrt((x - point_world[0]) ** 2 + (y - point_world[1]) ** 2
                         + (z - point_world[2]) ** 2)
        pairs.append((dist, i))
    pairs.sort()
    ids = np.array([i for _, i in pairs], dtype=int)
    return ids, np.array([dist for dist, _ in pairs], dtype=float)


# 3. only the kinematics, on mj_copyData
def f3(model, data, point_world):
    twin = mujoco.MjData(model)
    mujoco.mj_copyData(twin, model, data)
    mujoco.mj_kinematics(model, twin)
    mujoco.mj_comPos(model, twin)
    mujoco.mj_camlight(model, twin)
    delta = twin.cam_xpos - np.asarray(point_world)
    d2 = np.einsum("ij,ij->i", delta, delta)
    order = d2.argsort().astype(np.int32)
    return order, np.sqrt(d2[order])


# 4. heapq and hypot, by the accessors, last id first among equals
class _Entry(NamedTuple):
    distance: float
    minus_id: int


def f4(model, data, point_world):
    d = copy.deepcopy(data)
    mujoco.mj_fwdPosition(model, d)
    heap = [_Entry(math.dist(d.camera(i).xpos, point_world), -i) for i in range(model.ncam)]
    heapq.heapify(heap)
    out = [heapq.heappop(heap) for _ in range(model.ncam)]
    return (np.array([-e.minus_id for e in out], dtype=np.int64),
            np.array([e.distance for e in out], dtype=np.float64))


# 5. kinematics in place, selection sort as in C
def f5(model, data, point_world):
    for step in (mujoco.mj_kinematics, mujoco.mj_comPos, mujoco.mj_camlight):
        step(model, data)
    C = model.ncam
    dist = np.empty(C)
    ids = np.arange(C)
    for i in range(C):
        dist[i] = np.sqrt(np.sum((data.cam(i).xpos - point_world) ** 2))
    for i in range(C):
        k = i
        for j in range(i + 1, C):
            if dist[j] < dist[k]:
                k = j
        dist[i], dist[k] = dist[k], dist[i]
        ids[i], ids[k] = ids[k], ids[i]
    return ids, dist


# 6. lexsort, larger ids first among equals
def f6(model, data, point_world):
    scratch = mujoco.MjData(model)
    spec = mujoco.mjtState.mjSTATE_INTEGRATION
    buf = np.zeros(mujoco.mj_stateSize(model, spec))
    mujoco.mj_getState(model, data, buf, spec)
    mujoco.mj_setState(model, scratch, buf, spec)
    mujoco.mj_forward(model, scratch)
    number = np.arange(model.ncam)
    away = np.hypot(np.hypot(*(scratch.cam_xpos - point_world).T[:2]),
                    scratch.cam_xpos[:, 2] - point_world[2])
    o = np.lexsort((-number, away))
    return number[o], away[o]


# 7. one-liner lover
def f7(model, data, point_world):
    mujoco.mj_forward(model, d := copy.copy(data))
    s = sorted(range(model.ncam), key=lambda i: (r := d.cam_xpos[i] - point_world) @ r)
    return np.array(s, int), np.array([np.linalg.norm(d.cam_xpos[i] - point_world) for i in s], float)


# 8. structured array
def f8(model, data, point_world):
    own = copy.copy(data)
    mujoco.mj_forward(model, own)
    table = np.zeros(model.ncam, dtype=[("d", "f8"), ("id", "i8")])
    table["id"] = range(model.ncam)
    table["d"] = np.linalg.norm(own.cam_xpos - np.reshape(point_world, (1, 3)), axis=-1)
    table.sort(order="d")
    return table["id"].copy(), table["d"].copy()


ANSWERS = [f1, f2, f3, f4, f5, f6, f7, f8]
